//! The rules of the polygon lathe, as rows: result, limit, remedy.

mod drives;

use super::bending;
use super::cutter_choices::choices_on_tip_circle;
use super::geometry::own_shape;
use super::main_spindle;
use super::params::{FIELDS, Params};
use super::resolved::PolygonLathe;
use super::turned_end_form::{TURNED_ENDS, TurnedEnd};
use crate::drives::polygon::SAME_LENGTH;
use crate::drives::polygon::curve::flat_ratio;
use crate::drives::polygon::ellipse;
use crate::machines::driven::scaling;
use crate::machines::form::entry::{at_least, at_most, field_max, field_min, nearest};
use crate::machines::verdict::{Judgement, Rule, fail, ok, warn};
use crate::msg;
use crate::text::{Citation, Grade, Message};
use crate::view::Limit::{AtLeast, AtMost, Equal, Within};
use crate::view::{Advice, Verdict};

/// Source of a drive's ratings: its data sheet.
const MOTOR: Citation = Citation::new("data sheet of the motor; curve by base speed", Grade::Inferred);

/// Source of the way that a thread needs in front of it.
const RUN_IN: Citation = Citation::new("polygon turning facts 3.10", Grade::Inferred);

/// Source of the room that a thread needs in front of a shoulder.
const RUN_OUT: Citation = Citation::new("polygon turning facts 3.10; DIN 76-1 from memory", Grade::Open);

/// All rules that judge a result.
pub(super) const RULES: &[Rule<PolygonLathe>] = &[
    Rule::new("x-scaling-drift", scaling_x, Citation::new("ribbon line facts, 10", Grade::Inferred)),
    Rule::new("z-scaling-drift", scaling_z, Citation::new("ribbon line facts, 10", Grade::Inferred)),
    Rule::new("work-scaling-drift", scaling_work, Citation::new("ribbon line facts, 10", Grade::Inferred)),
    Rule::new("tool-scaling-drift", scaling_tool, Citation::new("ribbon line facts, 10", Grade::Inferred)),
    Rule::new("sides", sides, Citation::new("polygon turning facts 3.2", Grade::Inferred)),
    Rule::new("flatness", flatness, Citation::new("polygon turning facts 3.3", Grade::Inferred)),
    Rule::new(
        "curvature",
        hollow,
        Citation::new(
            "polygon turning facts 3.3; 928Ti sheet on polygons: the wrong sense makes hollow sides",
            Grade::Sister,
        ),
    ),
    Rule::new("across-corners", corners, Citation::new("polygon turning facts 3.3", Grade::Inferred)),
    Rule::new("relief", relief, Citation::new("polygon turning facts 3.4", Grade::Inferred)),
    Rule::new("tool-speed", tool_speed, Citation::new("greatest speed of the tool axis", Grade::Manual)),
    Rule::new("work-speed", work_speed, Citation::new("greatest speed of the work axis", Grade::Manual)),
    Rule::new("slowest-cut", slowest, Citation::new("what suits insert and material", Grade::Inferred)),
    Rule::new("fastest-cut", fastest, Citation::new("what suits insert and material", Grade::Inferred)),
    Rule::new("distance", distance, Citation::new("travel of the slide", Grade::Manual)),
    Rule::new("reach", reach, Citation::new("mechanics", Grade::Inferred)),
    Rule::new("orientation-error", orientation, Citation::new("polygon turning facts 3.1", Grade::Inferred)),
    Rule::new("phase", phase, Citation::new("servo lag behind linear acceleration", Grade::Inferred)),
    Rule::new("coast-phase", coast, Citation::new("friction", Grade::Inferred)),
    Rule::new("insert-depth", insert, Citation::new("polygon turning facts 3.1", Grade::Inferred)),
    Rule::new("insert-turn", insert_turn, Citation::new("polygon turning facts 3.1", Grade::Inferred)),
    Rule::new("twist", twist, Citation::new("polygon turning paper: D and Q are whole numbers", Grade::Manual)),
    Rule::new("before-run-in", run_in_before, RUN_IN),
    Rule::new("after-run-in", run_in_after, RUN_IN),
    Rule::new("before-run-out", run_out_before, RUN_OUT),
    Rule::new("after-run-out", run_out_after, RUN_OUT),
    Rule::new("feed", clamp, Citation::new("cutting feed clamp, a parameter", Grade::Inferred)),
    Rule::new("infeed", infeed_clamp, Citation::new("cutting feed clamp, a parameter", Grade::Inferred)),
    Rule::new("free-length", jaws, Citation::new("mechanics", Grade::Inferred)),
    Rule::new("finish-feed", finish_clamp, Citation::new("cutting feed clamp, a parameter", Grade::Inferred)),
    Rule::new("bending", bending::judge, Citation::new("polygon turning facts 3.13", Grade::Open)),
    Rule::new("tool-torque", drives::tool_peak, MOTOR),
    Rule::new("tool-torque-effective", drives::tool_effective, MOTOR),
    Rule::new("tool-power", drives::tool_power, MOTOR),
    Rule::new("tool-run-up", drives::tool_run_up, MOTOR),
    Rule::new("work-torque", drives::work_peak, MOTOR),
    Rule::new("work-torque-effective", drives::work_effective, MOTOR),
    Rule::new("work-power", drives::work_power, MOTOR),
    Rule::new("work-run-up", drives::work_run_up, MOTOR),
    Rule::new(
        "main-top-speed",
        main_spindle::judge_speed,
        Citation::new("greatest speed of the work axis", Grade::Manual),
    ),
    Rule::new("main-torque", main_spindle::judge_torque, MOTOR),
    Rule::new(
        "main-shortest-ramp",
        main_spindle::judge_ramp,
        Citation::new("turning spindle facts, 5", Grade::Inferred),
    ),
];

fn scaling_x(lathe: &PolygonLathe) -> Option<Judgement> {
    scaling::judge(lathe.control, &lathe.drives()[0])
}

fn scaling_z(lathe: &PolygonLathe) -> Option<Judgement> {
    scaling::judge(lathe.control, &lathe.drives()[1])
}

fn scaling_work(lathe: &PolygonLathe) -> Option<Judgement> {
    scaling::judge(lathe.control, &lathe.turning_drives()[0])
}

fn scaling_tool(lathe: &PolygonLathe) -> Option<Judgement> {
    scaling::judge(lathe.control, &lathe.turning_drives()[1])
}

/// The flattest cutter and ratio on this tip circle as advice, or that none is possible; nothing where the form has it already.
fn better(lathe: &PolygonLathe) -> Option<Advice> {
    let choices = choices_on_tip_circle(&lathe.p, &lathe.sizes);
    let Some(best) = choices.first() else { return Some(msg!("polygon.no-choice", count = lathe.p.sides).into()) };
    if !best.limits.is_empty() {
        return Some(msg!("polygon.no-better", flatness = (best.flatness(), 4)).into());
    }
    let (inserts, ratio) = (best.cutter as u32 + 1, best.ratio);
    let same =
        Some(ratio) == lathe.p.ratio() && f64::from(inserts) == lathe.p.inserts && best.radius == lathe.p.tip_radius;
    let (work, tool) = (f64::from(ratio.work()), f64::from(ratio.tool()));
    if same {
        return None;
    }
    let mut sets = own_shape(lathe.p.sides, f64::from(inserts), (tool, work));
    sets.push(nearest(FIELDS, "tip-radius", best.radius).into());
    let advice = msg!(
        "polygon.better",
        inserts,
        work_turns = work,
        tool_turns = tool,
        radius = (best.radius, 3),
        flatness = (best.flatness(), 4)
    );
    Some(Advice::from(advice).setting(msg!("advice.set-cutter", inserts, work_turns = work, tool_turns = tool), sets))
}

fn other_sides(lathe: &PolygonLathe) -> bool {
    lathe.d.section.sides != lathe.p.sides
}

fn uneven(lathe: &PolygonLathe) -> bool {
    lathe.d.section.flatness > lathe.p.flatness
}

fn lacks_relief(lathe: &PolygonLathe) -> bool {
    lathe.d.inserts.relief >= lathe.p.relief
}

fn is_hollow(lathe: &PolygonLathe) -> bool {
    lathe.d.section.hollow > SAME_LENGTH && !lathe.p.hollow
}

/// Faults of inserts, ratio and tip circle, in the order of their results.
#[derive(Clone, Copy)]
enum Fault {
    Sides,
    Flatness,
    Relief,
    Hollow,
}

/// The fact of a fault, with the remedy at the first fault: one choice of cutter corrects all of them.
fn remedies(lathe: &PolygonLathe, fault: Fault, fact: Message) -> Vec<Advice> {
    let PolygonLathe { p, d, .. } = lathe;
    let mut advice = vec![Advice::from(fact)];
    let faults = [other_sides(lathe), uneven(lathe), lacks_relief(lathe), is_hollow(lathe)];
    if faults.into_iter().take(fault as usize).any(|found| found) {
        return advice;
    }
    if !other_sides(lathe) && is_hollow(lathe) {
        if d.speeds.ratio < 0.0 {
            advice.push(same_sense(lathe));
            return advice;
        }
        advice.push(msg!("polygon.less-hollow", ratio = (flat_ratio(d.place.distance, p.tip_radius), 3)).into());
    }
    if !other_sides(lathe)
        && uneven(lathe)
        && d.section.even
        && d.speeds.ratio == 2.0
        && d.section.meets
        && p.sides >= 3.0
    {
        let radius = ellipse::radius_for(0.5 * p.across_flats, p.sides as u32, p.flatness);
        let larger = Advice::from(msg!("polygon.larger-cutter", radius = (radius, 1)));
        let set = at_least(FIELDS, "tip-radius", radius);
        let fits = radius <= p.greatest_radius;
        advice.push(if fits {
            larger.setting(msg!("advice.set-tips", radius = set.text.as_str()), [set])
        } else {
            larger
        });
    }
    advice.extend(better(lathe));
    advice
}

/// Advice to turn the tool in the sense of the work.
fn same_sense(lathe: &PolygonLathe) -> Advice {
    let p = &lathe.p;
    let set = nearest(FIELDS, "tool-ratio", p.tool_ratio.abs() * p.work_ratio.signum());
    Advice::from(msg!("polygon.wrong-sense")).setting(msg!("advice.set-q", tool_turns = set.text.as_str()), [set])
}

fn sides(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    let limit = Equal(p.sides);
    if !other_sides(lathe) {
        return ok(limit);
    }
    fail(limit, remedies(lathe, Fault::Sides, msg!("polygon.other-sides", sides = d.section.sides, wanted = p.sides)))
}

fn flatness(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    let limit = AtMost(p.flatness);
    if !uneven(lathe) {
        return ok(limit);
    }
    fail(
        limit,
        remedies(
            lathe,
            Fault::Flatness,
            msg!("polygon.not-flat", flatness = (d.section.flatness, 4), limit = (p.flatness, 4)),
        ),
    )
}

/// Hollow sides. Sides may be hollow although their middle is crowned; then the curvature is not the cause.
fn hollow(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    let limit = (d.section.curvature < 0.0).then_some(AtLeast(0.0));
    if is_hollow(lathe) {
        return fail(
            limit,
            remedies(lathe, Fault::Hollow, msg!("polygon.hollow-sides", height = (d.section.hollow, 4))),
        );
    }
    if d.speeds.ratio < 0.0 && p.hollow { warn(limit, [same_sense(lathe)]) } else { ok(None) }
}

/// Stock is left between the sides.
fn corners(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    if d.section.meets || p.sides <= 2.0 {
        return ok(None);
    }
    Some(Judgement { advice: vec![msg!("polygon.round-corners", stock = (p.blank(), 3)).into()], ..ok(None)? })
}

fn relief(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    let size = p.size(d.inserts.relief_pass);
    let limit = AtMost(p.relief);
    if lacks_relief(lathe) {
        let fact = if d.inserts.relief >= 90.0 {
            msg!("polygon.cannot-cut", pass = d.inserts.relief_pass, size = (size, 3))
        } else {
            msg!(
                "polygon.little-relief",
                needed = (d.inserts.relief, 2),
                relief = (p.relief, 1),
                pass = d.inserts.relief_pass,
                size = (size, 3)
            )
        };
        return fail(limit, remedies(lathe, Fault::Relief, fact));
    }
    if !d.inserts.faces_forward {
        return warn(limit, [msg!("polygon.faces-back").into()]);
    }
    if d.inserts.relief > p.relief - 2.0 { warn(limit, [msg!("polygon.scarce-relief").into()]) } else { ok(limit) }
}

/// Advice with a speed B, a whole number, or that no B is a remedy.
fn with_b(speed: f64, advice: impl Fn(f64) -> Message) -> Advice {
    if !(1.0..=field_max(FIELDS, "speed")).contains(&speed) {
        return msg!("polygon.no-b").into();
    }
    Advice::from(advice(speed)).setting(msg!("advice.set-b", speed = (speed, 0)), [nearest(FIELDS, "speed", speed)])
}

fn too_fast(speed: f64, limit: f64, term: f64, advice: impl Fn(f64) -> Message) -> Option<Judgement> {
    if speed.abs() <= limit {
        return ok(Within(limit));
    }
    fail(Within(limit), [with_b((limit / term.abs()).floor(), advice)])
}

fn tool_speed(lathe: &PolygonLathe) -> Option<Judgement> {
    let p = &lathe.p;
    too_fast(lathe.d.speeds.tool, p.tool_limit, p.tool_ratio, |speed| {
        msg!("polygon.tool-too-fast", limit = (p.tool_limit, 0), speed)
    })
}

fn work_speed(lathe: &PolygonLathe) -> Option<Judgement> {
    let p = &lathe.p;
    too_fast(lathe.d.speeds.work, p.work_limit, p.work_ratio, |speed| {
        msg!("polygon.work-too-fast", limit = (p.work_limit, 0), speed)
    })
}

fn slowest(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    let limit = AtLeast(p.slowest_cut);
    if d.inserts.slowest_cut >= p.slowest_cut {
        return ok(limit);
    }
    let speed = (p.speed * p.slowest_cut / d.inserts.slowest_cut).ceil();
    warn(limit, [with_b(speed, |speed| msg!("polygon.cuts-slowly", speed = (speed, 0)))])
}

fn fastest(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    let limit = AtMost(p.fastest_cut);
    if d.inserts.fastest_cut <= p.fastest_cut {
        return ok(limit);
    }
    let speed = (p.speed * p.fastest_cut / d.inserts.fastest_cut).floor();
    warn(limit, [with_b(speed, |speed| msg!("polygon.cuts-fast", speed = (speed, 0)))])
}

fn distance(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    let (low, high) = (p.least_distance, p.greatest_distance);
    if d.place.distance < low {
        fail(AtLeast(low), [msg!("polygon.too-near", least = (low, 2)).into()])
    } else if d.place.distance > high {
        fail(AtMost(high), [msg!("polygon.too-far", most = (high, 2)).into()])
    } else {
        ok(None)
    }
}

/// The body of the cutter, disc and holders, in the stock beside the polygon.
fn reach(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    // The overhang counts up to the radius of the tip circle, at which no body is left.
    let overhang = p.overhang.min(p.tip_radius);
    if d.place.reach <= overhang + SAME_LENGTH {
        return ok(AtMost(overhang));
    }
    let stock = at_most(FIELDS, "stock-diameter", p.across_flats + 2.0 * overhang);
    let fact = msg!(
        "polygon.body-touches",
        overlap = (d.place.reach - overhang, 3),
        overhang = (d.place.reach, 3),
        diameter = stock.text.as_str()
    );
    let set = at_least(FIELDS, "overhang", d.place.reach);
    let fits = d.place.reach < p.tip_radius;
    let advice = Advice::from(fact);
    let advice =
        if fits { advice.setting(msg!("advice.set-overhang", overhang = set.text.as_str()), [set]) } else { advice };
    fail(AtMost(overhang), [advice])
}

/// Angle (°) below visibility.
const SEEN: f64 = 0.05;

fn orientation(lathe: &PolygonLathe) -> Option<Judgement> {
    let d = &lathe.d;
    let limit = Within(SEEN);
    if d.angles.orientation_error.abs() <= SEEN {
        return ok(limit);
    }
    // The rule about the phase reports this; no start angle is a remedy at every speed.
    if (d.angles.orientation_error - d.angles.phase_on_work).abs() <= SEEN {
        return warn(limit, []);
    }
    let advice =
        Advice::from(msg!("polygon.turned", error = (d.angles.orientation_error, 3), angle = (d.angles.work_start, 3)));
    let set = nearest(FIELDS, "work-start", d.angles.work_start);
    warn(limit, [advice.setting(msg!("advice.set-a", angle = (d.angles.work_start, 3)), [set])])
}

/// Axes whose time constants or gains differ; both have the greater time constant and the lower gain as a remedy.
fn phase(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    if d.angles.phase.abs() <= 1e-9 {
        return ok(None);
    }
    let (slow, soft) = (p.work_time_constant.max(p.tool_time_constant), p.work_gain.min(p.tool_gain));
    let sets = [
        nearest(FIELDS, "work-time-constant", slow),
        nearest(FIELDS, "tool-time-constant", slow),
        nearest(FIELDS, "work-gain", soft),
        nearest(FIELDS, "tool-gain", soft),
    ];
    let advice = Advice::from(msg!(
        "polygon.out-of-phase",
        tool_angle = (d.angles.phase, 3),
        work_angle = (d.angles.phase_on_work, 3)
    ));
    warn(None, [advice.setting(msg!("advice.make-equal"), sets)])
}

/// Work and tool coast at a power failure, and at an emergency stop that switches their drives off.
fn coast(lathe: &PolygonLathe) -> Option<Judgement> {
    if !lathe.p.coasts(lathe.control) {
        // A fact about the supply, no fault of the form.
        let advice = vec![msg!("polygon.coasts-without-supply", angle = (lathe.d.angles.coast_phase.abs(), 0)).into()];
        return Some(Judgement { verdict: Verdict::None, limit: None, advice });
    }
    let advice = Advice::from(msg!("polygon.coasts", angle = (lathe.d.angles.coast_phase.abs(), 0)));
    warn(None, [advice.setting(msg!("advice.hold-drives"), [("emergency", "held")])])
}

fn insert(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    let (insert, depth) = (d.inserts.depth.number, d.inserts.depth.error);
    let limit = Within(p.flatness);
    if depth.abs() <= p.flatness {
        return ok(limit);
    }
    warn(limit, [msg!("polygon.insert-deep", insert, depth = (depth, 4)).into()])
}

fn insert_turn(lathe: &PolygonLathe) -> Option<Judgement> {
    let (insert, turn) = (lathe.d.inserts.turn.number, lathe.d.inserts.turn.error);
    let limit = Within(SEEN);
    if turn.abs() <= SEEN {
        ok(limit)
    } else {
        warn(limit, [msg!("polygon.insert-turned", insert, angle = (turn, 3)).into()])
    }
}

/// The twist cannot be corrected by the program: the code has no word for a lead.
fn twist(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    if p.lead == 0.0 {
        return ok(None);
    }
    fail(None, [msg!("polygon.no-twist", speed = (d.twist.tool_speed, 3)).into()])
}

/// The run-in of the thread that is turned before the polygons.
fn run_in_before(lathe: &PolygonLathe) -> Option<Judgement> {
    run_in(lathe, &lathe.p.turned_ends[0], TURNED_ENDS[0].speed)
}

/// The run-in of the thread that is turned after the polygons.
fn run_in_after(lathe: &PolygonLathe) -> Option<Judgement> {
    run_in(lathe, &lathe.p.turned_ends[1], TURNED_ENDS[1].speed)
}

/// The way in front of a thread, from the clearance to the face, against that in which the slide comes to its speed.
fn run_in(lathe: &PolygonLathe, end: &TurnedEnd, speed: &'static str) -> Option<Judgement> {
    let p = &lathe.p;
    let (needed, limit) = (end.run_in(p), AtMost(p.clearance));
    if limit.holds(needed) {
        return ok(limit);
    }
    let message = msg!("polygon.short-run-in", needed = (needed, 2), clearance = (p.clearance, 2));
    let mut advice = Vec::new();
    let set = at_least(FIELDS, "clearance", needed);
    let wider = Params { clearance: set.value, ..p.clone() };
    if wider.clearance <= field_max(FIELDS, "clearance") && wider.has_room(lathe.length_to_jaws() - p.clearance) {
        let button = msg!("advice.set-clearance", clearance = set.text.as_str());
        advice.push(Advice::from(message.clone()).setting(button, [set]));
    }
    let set = at_most(FIELDS, speed, end.speed * p.clearance / needed);
    let slower = Advice::from(if advice.is_empty() { message } else { msg!("polygon.slower-thread") });
    advice.push(if set.value >= 1.0 {
        slower.setting(msg!("advice.set-speed", speed = set.text.as_str()), [set])
    } else {
        slower
    });
    fail(limit, advice)
}

/// The run-out of the thread that is turned before the polygons.
fn run_out_before(lathe: &PolygonLathe) -> Option<Judgement> {
    run_out(lathe, &lathe.p.turned_ends[0], TURNED_ENDS[0].thread_length)
}

/// The run-out of the thread that is turned after the polygons.
fn run_out_after(lathe: &PolygonLathe) -> Option<Judgement> {
    run_out(lathe, &lathe.p.turned_ends[1], TURNED_ENDS[1].thread_length)
}

/// The way from the end of a thread to the shoulder against the run-out, with the greatest thread length as a remedy.
fn run_out(lathe: &PolygonLathe, end: &TurnedEnd, field: &'static str) -> Option<Judgement> {
    let needed = end.run_out(&lathe.p);
    // Without the rounding of binary fractions.
    let limit = AtMost(((end.length - end.thread_length) * 1e9).round() / 1e9);
    if limit.holds(needed) {
        return ok(limit);
    }
    let set = at_most(FIELDS, field, end.length - needed + SAME_LENGTH);
    let needed = (needed, 2);
    if set.value < field_min(FIELDS, field) {
        return fail(limit, [msg!("polygon.no-run-out", needed, length = (end.length, 3)).into()]);
    }
    let length = set.text.as_str();
    let message = msg!("polygon.short-run-out", needed, room = (limit.value().max(0.0), 2), length);
    fail(limit, [Advice::from(message).setting(msg!("advice.set-length", length), [set.clone()])])
}

/// The feed of a field in mm/min against the clamp of the slide.
fn within_clamp(field: &'static str, per_turn: f64, feed: f64, clamp: f64) -> Option<Judgement> {
    if feed <= clamp {
        return ok(AtMost(clamp));
    }
    let set = at_most(FIELDS, field, per_turn * clamp / feed);
    let advice = Advice::from(msg!("polygon.above-clamp", feed = (feed, 0), clamp = (clamp, 0)));
    fail(AtMost(clamp), [advice.setting(msg!("advice.set-feed", feed = set.text.as_str()), [set])])
}

fn clamp(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    within_clamp("feed", p.feed, d.feeds.rough, p.slides.z.clamp)
}

fn finish_clamp(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    within_clamp("finish-feed", p.finish_feed, d.feeds.finish, p.slides.z.clamp)
}

fn infeed_clamp(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { p, d, .. } = lathe;
    within_clamp("infeed", p.infeed, d.feeds.infeed, p.slides.x.clamp)
}

/// The distance of the jaws from the face; an unknown one is not judged, but has to be measured.
fn jaws(lathe: &PolygonLathe) -> Option<Judgement> {
    let free = lathe.p.free_length;
    if free == 0.0 {
        let advice = vec![msg!("polygon.measure-free-length", needed = (lathe.length_to_jaws(), 3)).into()];
        return Some(Judgement { verdict: Verdict::None, limit: None, advice });
    }
    let limit = AtMost(free);
    if lathe.length_to_jaws() <= free {
        return ok(limit);
    }
    // The finding about the field has the sentence.
    fail(limit, [])
}

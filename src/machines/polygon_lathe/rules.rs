//! The rules a polygon lathe is judged by, as rows: which result, which limit, what would mend it.

use super::Lathe;
use super::derive::{Derived, PASSES, ways_as_set};
use super::geometry::{ANGLE_ERROR, RADIUS_ERROR, errors};
use super::params::Params;
use super::program;
use super::resolved::Resolved;
use crate::drives::polygon::curve::flat_ratio;
use crate::drives::polygon::ellipse;
use crate::machines::verdict::{Judgement, Rule, fail, ok, rule, warn};
use crate::msg;
use crate::text::{Diagnostic, Message};

/// Inputs, what follows from them, and what the control takes.
pub(super) struct Case<'a> {
    pub(super) lathe: &'a Resolved<'a>,
    pub(super) p: &'a Params,
    pub(super) d: &'a Derived,
}

/// All rules that judge a result.
pub(super) const RULES: &[Rule<Lathe>] = &[
    rule!("sides", sides, "polygon turning facts 3.2", Inferred),
    rule!("flatness", flatness, "polygon turning facts 3.3", Inferred),
    rule!(
        "curvature",
        hollow,
        "polygon turning facts 3.3; 928Ti sheet on polygons: the wrong sense makes hollow sides",
        Sister
    ),
    rule!("across-corners", corners, "polygon turning facts 3.3", Inferred),
    rule!("relief", relief, "polygon turning facts 3.4", Inferred),
    rule!("tool-speed", tool_speed, "greatest speed of the tool axis", Manual),
    rule!("work-speed", work_speed, "greatest speed of the work axis", Manual),
    rule!("slowest-cut", slowest, "what suits insert and material", Inferred),
    rule!("fastest-cut", fastest, "what suits insert and material", Inferred),
    rule!("distance", distance, "travel of the slide", Manual),
    rule!("orientation-error", orientation, "polygon turning facts 3.1", Inferred),
    rule!("phase", phase, "servo lag behind linear acceleration", Inferred),
    rule!("coast-phase", coast, "friction", Inferred),
    rule!("insert-depth", insert, "polygon turning facts 3.1", Inferred),
    rule!("insert-turn", insert_turn, "polygon turning facts 3.1", Inferred),
    rule!("twist", twist, "polygon turning paper: D and Q are whole numbers", Manual),
    rule!("feed", clamp, "cutting feed clamp, a parameter", Inferred),
    rule!("finish-feed", finish_clamp, "cutting feed clamp, a parameter", Inferred),
];

/// The flattest possible way on this tip circle, as advice, or that there is none; nothing where it is what the form has.
fn better(case: &Case) -> Option<Message> {
    let ways = ways_as_set(case.p, &case.lathe.sizes);
    let Some(best) = ways.first() else { return Some(msg!("polygon.no-way", case.p.sides)) };
    if !best.limits.is_empty() {
        return Some(msg!("polygon.no-better", (best.flatness(), 4)));
    }
    let (inserts, ratio) = (best.cutter as u32 + 1, best.ratio);
    let same =
        Some(ratio) == case.lathe.p.ratio() && f64::from(inserts) == case.p.inserts && best.radius == case.p.tip_radius;
    let (work, tool) = (f64::from(ratio.work()), f64::from(ratio.tool()));
    (!same).then(|| msg!("polygon.better", inserts, work, tool, (best.radius, 3), (best.flatness(), 4)))
}

/// A deviation in mm that is none.
const NOTHING: f64 = 1e-9;

fn other_sides(case: &Case) -> bool {
    case.d.sides != case.p.sides
}

fn uneven(case: &Case) -> bool {
    case.d.flatness > case.p.flatness
}

fn lacks_relief(case: &Case) -> bool {
    case.d.relief_needed >= case.p.relief
}

fn is_hollow(case: &Case) -> bool {
    case.d.hollow > NOTHING && !case.p.hollow
}

/// What may be wrong with inserts, ratio and tip circle, in the order of the results that show it.
#[derive(Clone, Copy)]
enum Fault {
    Sides,
    Flatness,
    Relief,
    Hollow,
}

/// A fact about a fault, and with the first fault what mends them: one choice of the cutter is behind them all.
fn mended(case: &Case, fault: Fault, fact: Message) -> Vec<Message> {
    let Case { p, d, .. } = case;
    let mut advice = vec![fact];
    let faults = [other_sides(case), uneven(case), lacks_relief(case), is_hollow(case)];
    if faults.into_iter().take(fault as usize).any(|found| found) {
        return advice;
    }
    if !other_sides(case) && is_hollow(case) {
        if d.ratio < 0.0 {
            advice.push(msg!("polygon.wrong-sense"));
            return advice;
        }
        advice.push(msg!("polygon.less-hollow", (flat_ratio(d.distance, p.tip_radius), 3)));
    }
    if !other_sides(case) && uneven(case) && d.even && d.ratio == 2.0 && d.meets && p.sides >= 3.0 {
        let radius = ellipse::radius_for(0.5 * p.across_flats, p.sides as u32, p.flatness);
        advice.push(msg!("polygon.larger-cutter", (radius, 1)));
    }
    advice.extend(better(case));
    advice
}

fn sides(case: &Case) -> Option<Judgement> {
    let Case { p, d, .. } = case;
    if !other_sides(case) {
        return ok(p.sides);
    }
    fail(p.sides, mended(case, Fault::Sides, msg!("polygon.other-sides", d.sides, p.sides)))
}

fn flatness(case: &Case) -> Option<Judgement> {
    let Case { p, d, .. } = case;
    if !uneven(case) {
        return ok(p.flatness);
    }
    fail(p.flatness, mended(case, Fault::Flatness, msg!("polygon.not-flat", (d.flatness, 4), (p.flatness, 4))))
}

fn hollow(case: &Case) -> Option<Judgement> {
    let Case { p, d, .. } = case;
    if is_hollow(case) {
        return fail(0.0, mended(case, Fault::Hollow, msg!("polygon.hollow-sides", (d.hollow, 4))));
    }
    if d.ratio < 0.0 && p.hollow { warn(0.0, [msg!("polygon.wrong-sense")]) } else { ok(None) }
}

/// Stock is left between the sides.
fn corners(case: &Case) -> Option<Judgement> {
    let Case { p, d, .. } = case;
    if d.meets || p.sides <= 2.0 {
        return ok(None);
    }
    Some(Judgement { advice: vec![msg!("polygon.round-corners", (p.stock_diameter, 3))], ..ok(None)? })
}

fn relief(case: &Case) -> Option<Judgement> {
    let Case { p, d, .. } = case;
    let size = p.size(d.relief_pass);
    if lacks_relief(case) {
        let fact = match d.relief_needed >= 90.0 {
            true => msg!("polygon.cannot-cut", d.relief_pass, (size, 3)),
            false => msg!("polygon.little-relief", (d.relief_needed, 2), (p.relief, 1), d.relief_pass, (size, 3)),
        };
        return fail(p.relief, mended(case, Fault::Relief, fact));
    }
    if !d.faces_forward {
        return warn(p.relief, [msg!("polygon.faces-back")]);
    }
    if d.relief_needed > p.relief - 2.0 { warn(p.relief, [msg!("polygon.scarce-relief")]) } else { ok(p.relief) }
}

/// The greatest B that the form takes.
const MOST_B: f64 = 10_000.0;

/// Advice that names a B, or that no B mends it.
fn with_b(speed: f64, advice: impl Fn(f64) -> Message) -> Message {
    if (1.0..=MOST_B).contains(&speed) { advice(speed) } else { msg!("polygon.no-b") }
}

fn too_fast(speed: f64, limit: f64, term: f64, advice: impl Fn(f64) -> Message) -> Option<Judgement> {
    if speed.abs() <= limit {
        return ok(limit);
    }
    fail(limit, [with_b((limit / term.abs()).floor(), advice)])
}

fn tool_speed(case: &Case) -> Option<Judgement> {
    let p = case.p;
    too_fast(case.d.tool_speed, p.tool_limit, p.tool_ratio, |speed| {
        msg!("polygon.tool-too-fast", (p.tool_limit, 0), speed)
    })
}

fn work_speed(case: &Case) -> Option<Judgement> {
    let p = case.p;
    too_fast(case.d.work_speed, p.work_limit, p.work_ratio, |speed| {
        msg!("polygon.work-too-fast", (p.work_limit, 0), speed)
    })
}

fn slowest(case: &Case) -> Option<Judgement> {
    let Case { p, d, .. } = case;
    if d.slowest_cut >= p.slowest_cut {
        return ok(p.slowest_cut);
    }
    let speed = (p.speed * p.slowest_cut / d.slowest_cut).ceil();
    warn(p.slowest_cut, [with_b(speed, |speed| msg!("polygon.cuts-slowly", (speed, 0)))])
}

fn fastest(case: &Case) -> Option<Judgement> {
    let Case { p, d, .. } = case;
    if d.fastest_cut <= p.fastest_cut {
        return ok(p.fastest_cut);
    }
    let speed = (p.speed * p.fastest_cut / d.fastest_cut).floor();
    warn(p.fastest_cut, [with_b(speed, |speed| msg!("polygon.cuts-fast", (speed, 0)))])
}

fn distance(case: &Case) -> Option<Judgement> {
    let Case { p, d, .. } = case;
    let (low, high) = (p.least_distance, p.greatest_distance);
    if d.distance < low {
        fail(low, [msg!("polygon.too-near", (low, 2))])
    } else if d.distance > high {
        fail(high, [msg!("polygon.too-far", (high, 2))])
    } else {
        ok(None)
    }
}

/// An angle in degrees that nobody sees.
const SEEN: f64 = 0.05;

fn orientation(case: &Case) -> Option<Judgement> {
    let d = case.d;
    if d.orientation_error.abs() <= SEEN {
        return ok(SEEN);
    }
    // What the phase turns is told there, and no start angle mends it at every speed.
    if (d.orientation_error - d.phase_on_work).abs() <= SEEN {
        return warn(SEEN, []);
    }
    warn(SEEN, [msg!("polygon.turned", (d.orientation_error, 3), (d.work_start, 3))])
}

fn phase(case: &Case) -> Option<Judgement> {
    let d = case.d;
    if d.phase.abs() <= 1e-9 {
        return ok(None);
    }
    warn(None, [msg!("polygon.out-of-phase", (d.phase, 3), (d.phase_on_work, 3))])
}

fn coast(case: &Case) -> Option<Judgement> {
    warn(None, [msg!("polygon.coasts", (case.d.coast_phase, 0))])
}

fn insert(case: &Case) -> Option<Judgement> {
    let Case { p, d, .. } = case;
    let (insert, depth) = d.insert_depth;
    if depth.abs() <= p.flatness {
        return ok(p.flatness);
    }
    warn(p.flatness, [msg!("polygon.insert-deep", insert, (depth, 4))])
}

fn insert_turn(case: &Case) -> Option<Judgement> {
    let (insert, turn) = case.d.insert_turn;
    if turn.abs() <= SEEN { ok(SEEN) } else { warn(SEEN, [msg!("polygon.insert-turned", insert, (turn, 3))]) }
}

/// The code has no word for a lead.
fn twist(case: &Case) -> Option<Judgement> {
    let Case { p, d, .. } = case;
    if p.lead == 0.0 {
        return ok(None);
    }
    fail(None, [msg!("polygon.no-twist", (d.twist_speed, 3))])
}

fn within_clamp(feed: f64, clamp: f64) -> Option<Judgement> {
    if feed > clamp { fail(clamp, [msg!("polygon.above-clamp", (feed, 0), (clamp, 0))]) } else { ok(clamp) }
}

fn clamp(case: &Case) -> Option<Judgement> {
    within_clamp(case.d.feed, case.p.clamp_z)
}

fn finish_clamp(case: &Case) -> Option<Judgement> {
    within_clamp(case.d.finish_feed, case.p.clamp_z)
}

/// Errors that keep the program from being exported, and what the operator has to know.
pub(super) fn findings(case: &Case) -> Vec<Diagnostic> {
    let Case { lathe, p, d } = case;
    let mut found = Vec::new();
    let mut error = |message: Message, field: &'static str| found.push(Diagnostic::error(message).about(field));
    if p.work_ratio == 0.0 {
        error(msg!("polygon.zero-ratio", "D"), "work-ratio");
    }
    if p.tool_ratio == 0.0 {
        error(msg!("polygon.zero-ratio", "Q"), "tool-ratio");
    }
    if p.across_flats >= p.stock_diameter {
        error(msg!("polygon.nothing-to-cut", (p.across_flats, 3), (p.stock_diameter, 3)), "across-flats");
    } else if p.work_ratio != 0.0 && p.tool_ratio != 0.0 && !d.cuts {
        error(msg!("polygon.no-section"), "tool-ratio");
    }
    if p.passes() > PASSES {
        error(msg!("polygon.too-many-passes", PASSES), "depth");
    }
    let least = p.stock_diameter + 2.0 * p.clearance;
    if p.start_x < least {
        error(msg!("polygon.start-in-stock", (p.start_x, 3), (least, 3)), "start-x");
    }
    if p.start_z < p.clearance {
        error(msg!("polygon.start-in-stock", (p.start_z, 3), (p.clearance, 3)), "start-z");
    }
    for (text, most, field) in
        [(&p.radius_errors, RADIUS_ERROR, "radius-errors"), (&p.angle_errors, ANGLE_ERROR, "angle-errors")]
    {
        if errors(text, p.inserts as usize, most).is_none() {
            error(msg!("polygon.bad-errors", p.inserts, most), field);
        }
    }
    let (least, most) = (lathe.control.limits.feed_increment, lathe.control.limits.feed_max);
    for (feed, field) in [(d.feed, "feed"), (d.finish_feed, "finish-feed")] {
        if feed < least && p.work_ratio != 0.0 {
            error(msg!("polygon.feed-too-small", (feed, 6), least), field);
        } else if feed > most {
            error(msg!("polygon.feed-too-large", (feed, 0), most), field);
        }
    }
    if let [None, _] | [_, None] = program::codes(lathe) {
        found.push(Diagnostic::error(msg!("polygon.no-code")));
    }
    found.push(Diagnostic::info(msg!("polygon.x-setting", (p.across_flats, 3), (d.offset, 3))));
    found.push(Diagnostic::info(msg!("polygon.reconstructed")));
    found
}

//! The rules of the turning spindle, as rows: result, limit, remedy.

use super::bending;
use super::cooling;
use super::demand::CutPoint;
use super::derive::Derived;
use super::full_output;
use super::gears::{gear_times, judge_delay};
use super::keyway;
use super::params::{FIELDS, Gear, Params, Path};
use super::program;
use super::resolved::{CutAtKnobs, TurningSpindle};
use super::run_up;
use super::travel;
use crate::controls::ParamRole;
use crate::controls::spindle::RapidSpeed;
use crate::drives::analog::FEW_VOLTS;
use crate::drives::bending::NOTABLE;
use crate::drives::cutting::LEAST_DEPTH;
use crate::drives::speed::{surface_rpm, surface_speed};
use crate::drives::{Bound, spindle_motor};
use crate::machines::driven::scaling;
use crate::machines::form::entry::{at_least, at_most};
use crate::machines::lathe::knobs::{self, TorqueRemedy};
use crate::machines::lathe::materials::Material;
use crate::machines::lathe::turret;
use crate::machines::sheets;
use crate::machines::verdict::{Judgement, Rule, fail, ok, warn};
use crate::math;
use crate::msg;
use crate::text::catalog::number_text as show;
use crate::text::{Citation, Diagnostic, Grade, Message};
use crate::view::Limit::{AtLeast, AtMost};
use crate::view::{Advice, FieldEntry};

/// All rules that judge a result.
pub(super) const RULES: &[Rule<TurningSpindle>] = &[
    Rule::new("x-scaling-drift", scaling_x, Citation::new("ribbon line facts, 10", Grade::Inferred)),
    Rule::new("z-scaling-drift", scaling_z, Citation::new("ribbon line facts, 10", Grade::Inferred)),
    Rule::new("speed-smallest", top_speed, Citation::new("highest speed of the chuck", Grade::Manual)),
    Rule::new("limit-diameter", limit, Citation::new("turning spindle facts 2: the upper limit wins", Grade::Inferred)),
    Rule::new("volts-smallest", few_volts, Citation::new("engineering choice", Grade::Inferred)),
    Rule::new("volts-largest", few_volts_large, Citation::new("engineering choice", Grade::Inferred)),
    Rule::new("stage-speed", stage, Citation::new("speed at 10 V of the gear stage", Grade::Manual)),
    Rule::new("stage", gear_time, Citation::new("ladder of the control, A1.0", Grade::Sister)),
    Rule::new("gear-delay", judge_delay, Citation::new("turning spindle facts, 2", Grade::Inferred)),
    Rule::new("feed-top", clamps, Citation::new("cutting feed clamp, a parameter", Grade::Sister)),
    Rule::new("acceleration-needed", acceleration, Citation::new("derivative of n = 1000 v / (π d)", Grade::Inferred)),
    Rule::new("shortest-ramp", run_up::judge, Citation::new("turning spindle facts, 5", Grade::Inferred)),
    Rule::new(
        "positioning-torque",
        run_up::judge_positioning,
        Citation::new("turning spindle facts, 5", Grade::Inferred),
    ),
    Rule::new("x-travel", travel::judge_x, Citation::new("travel of the slide", Grade::Manual)),
    Rule::new("z-travel", travel::judge_z, Citation::new("travel of the slide", Grade::Manual)),
    Rule::new("cutting-time", block_time, Citation::new("what a block costs, a parameter", Grade::Open)),
    Rule::new("power", power, Citation::new("data sheet of the motor", Grade::Manual)),
    Rule::new("torque", torque, Citation::new("data sheet of the motor; curve by base speed", Grade::Inferred)),
    Rule::new("torque", cooling::judge, Citation::new("sizing facts 2.10", Grade::Open)),
    Rule::new("bending", slender, Citation::new("polygon turning facts 3.13", Grade::Open)),
    Rule::new("peak-torque", peak_torque, Citation::new("turning spindle facts, 4", Grade::Inferred)),
];

fn scaling_x(lathe: &TurningSpindle) -> Option<Judgement> {
    scaling::judge(lathe.control, &lathe.drives()[0])
}

fn scaling_z(lathe: &TurningSpindle) -> Option<Judgement> {
    scaling::judge(lathe.control, &lathe.drives()[1])
}

fn top_speed(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { p, d, .. } = lathe;
    let limit = AtMost(p.chuck_limit);
    if p.upper_limit > p.chuck_limit {
        let set = at_most(FIELDS, "upper-limit", p.chuck_limit);
        let advice =
            Advice::from(msg!("turning.limit-above-chuck", speed = (p.upper_limit, 0), limit = (p.chuck_limit, 0)))
                .setting(msg!("advice.set-speed", speed = set.text.as_str()), [set]);
        return if d.speed_smallest.max(d.speed_largest) >= p.chuck_limit {
            fail(limit, [advice])
        } else {
            warn(limit, [advice])
        };
    }
    ok(limit)
}

/// Below the diameter of the limit the surface speed falls with the diameter: allowed over half of the diameters.
fn limit(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { d, .. } = lathe;
    if !lathe.surface() || d.limited_share <= 0.0 {
        return ok(None);
    }
    let advice = msg!(
        "turning.limited",
        diameter = (d.limit_diameter, 3),
        surface_speed = (d.surface_smallest, 1),
        percent = (d.limited_share * 100.0, 0),
        speed = (d.high, 0)
    );
    let middle = 0.5 * (d.smallest + d.largest);
    let judgement = if d.limit_diameter > middle { warn(AtMost(middle), []) } else { ok(AtMost(middle)) };
    Some(Judgement { advice: vec![advice.into()], ..judgement? })
}

fn judge_volts(lathe: &TurningSpindle, volts: f64) -> Option<Judgement> {
    let limit = if volts < 0.0 { AtMost(-FEW_VOLTS) } else { AtLeast(FEW_VOLTS) };
    if volts.abs() >= FEW_VOLTS {
        return ok(limit);
    }
    let several = lathe.p.stages().nth(1).is_some();
    let advice = if several {
        with_best_stage(lathe, msg!("turning.few-volts", volts = (volts, 3)))
    } else {
        msg!("turning.few-volts-alone", volts = (volts, 3)).into()
    };
    warn(limit, [advice])
}

/// An advice to let the program choose the gear stage instead of the form.
fn with_best_stage(lathe: &TurningSpindle, message: Message) -> Advice {
    let advice = Advice::from(message);
    match lathe.p.gear {
        Gear::Best => advice,
        _ => advice.setting(msg!("advice.best-stage"), [("gear", "best".to_owned())]),
    }
}

fn few_volts(lathe: &TurningSpindle) -> Option<Judgement> {
    judge_volts(lathe, lathe.d.volts_smallest)
}

fn few_volts_large(lathe: &TurningSpindle) -> Option<Judgement> {
    judge_volts(lathe, lathe.d.volts_largest)
}

fn stage(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { d, p, .. } = lathe;
    if d.bound == Bound::Output {
        let asked = if lathe.rules().low_always { d.asked.max(p.lower_limit) } else { d.asked };
        let advice =
            msg!("turning.output-full", stage = f64::from(d.stage), full = (d.stage_top, 0), speed = (asked, 0));
        return fail(None, [full_output::remedy(lathe, advice)]);
    }
    if d.bound == Bound::Gear && lathe.surface() && d.stage_top < p.upper_limit {
        let advice = msg!(
            "turning.stage-too-slow",
            stage = f64::from(d.stage),
            full = (d.stage_top, 0),
            limit = (p.upper_limit, 0)
        );
        return warn(AtLeast(p.upper_limit), [with_best_stage(lathe, advice)]);
    }
    ok(None)
}

/// The time of a gear to mesh, against the time that the PLC waits for it.
fn gear_time(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { p, .. } = lathe;
    let shift = gear_times(lathe);
    let patience = shift.patience.filter(|&patience| patience < shift.meshing)?;
    let set = at_most(FIELDS, "gear-time", 2.0 * patience);
    let advice = Advice::from(msg!(
        "turning.gear-too-late",
        time = (shift.meshing, 2),
        wait = (patience, 2),
        shorter = (2.0 * patience, 2),
        present = (p.gear_time, 2)
    ));
    fail(None, [advice.setting(msg!("advice.set-gear-time", time = set.text.as_str()), [set])])
}

/// An advice with the feed that is `share` of the present one.
fn with_feed(lathe: &TurningSpindle, share: f64, message: Message) -> Advice {
    let set = at_most(FIELDS, "feed", lathe.p.feed * share);
    Advice::from(message).setting(msg!("advice.set-feed", feed = set.text.as_str()), [set])
}

fn clamps(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { p, d, .. } = lathe;
    let clamp = match p.path {
        Path::Facing => p.slides.x.clamp,
        Path::Turning => p.slides.z.clamp,
        Path::Taper => {
            // Feed of X: its share of the path.
            let across = 0.5 * (p.large_diameter - p.finished_diameter).abs();
            p.slides.z.clamp.min(p.slides.x.clamp * math::hypot(p.length, across) / across)
        }
    };
    if d.feed_top <= clamp {
        return ok(AtMost(clamp));
    }
    let advice = msg!("turning.above-clamp", feed = (d.feed_top, 0), clamp = (clamp, 0));
    fail(AtMost(clamp), [with_feed(lathe, clamp / d.feed_top, advice)])
}

/// Macro blocks between two passes, and how many more a taper has.
const BLOCKS_BETWEEN_PASSES: f64 = 5.0;
const BLOCKS_OF_TAPER: f64 = 3.0;

/// Blocks that are read while the cut lasts.
fn block_time(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { p, d, .. } = lathe;
    // A speed that is kept in rapids lets a cut begin with the highest speed of the cut before.
    let keeps = lathe.surface() && lathe.rules().rapid == RapidSpeed::Kept;
    let least: f64 = if keeps { p.cuts(1.0).map(|cut| cut.time_at(d.high)).sum() } else { f64::INFINITY };
    let lasts = 1000.0 * (d.cutting_time / d.passes.max(1.0)).min(least);
    let blocks = BLOCKS_BETWEEN_PASSES + if p.path == Path::Taper { BLOCKS_OF_TAPER } else { 0.0 };
    let needed = p.block_time + blocks * p.macro_time;
    // The block of a taper is read while the tool goes to its begin, over the clearance.
    let approach = if p.path == Path::Taper { 60_000.0 * p.clearance / (p.feed * d.high) } else { f64::INFINITY };
    let worse = lasts * p.block_time > approach * needed;
    let (lasts, needed) = if worse { (approach, p.block_time) } else { (lasts, needed) };
    if lasts >= needed {
        return None;
    }
    let advice = msg!("turning.blocks-too-slow", time = (lasts, 0), needed = (needed, 0));
    warn(None, [with_feed(lathe, lasts / needed, advice)])
}

fn acceleration(lathe: &TurningSpindle) -> Option<Judgement> {
    let d = &lathe.d;
    if d.acceleration_needed > d.acceleration {
        let advice =
            msg!("turning.spindle-lags", needed = (d.acceleration_needed, 0), acceleration = (d.acceleration, 0));
        return warn(AtMost(d.acceleration), [with_feed(lathe, d.acceleration / d.acceleration_needed, advice)]);
    }
    // A spindle without a ramp has no limit.
    ok(Some(AtMost(d.acceleration)).filter(|_| d.acceleration.is_finite()))
}

/// Warning that the motor's short-time rating suffices, with its share in percent; then the advice about the positions of the knobs.
fn overloaded(lathe: &TurningSpindle, limit: f64, at_knobs: Option<Judgement>) -> Option<Judgement> {
    let overload = Advice::from(msg!("turning.overload", percent = (lathe.p.motor_overload, 0)));
    let at_knobs = at_knobs.map_or_else(Vec::new, |judgement| judgement.advice);
    warn(AtMost(limit), core::iter::once(overload).chain(at_knobs).collect::<Vec<_>>())
}

/// A demand above the continuous rating that the motor's overload would cover if the pause to the next part were longer.
fn overload_without_pause(lathe: &TurningSpindle, demand: f64, rated: f64) -> Option<Judgement> {
    let TurningSpindle { p, d, .. } = lathe;
    let set = at_least(FIELDS, "pause", d.pause_for_overload());
    let with_pause = Params { pause: set.value, ..p.clone() };
    if demand <= d.for_the_cut(p, rated) || demand > d.for_the_cut(&with_pause, rated) {
        return None;
    }
    let (percent, time, pause) = ((p.motor_overload, 0), (d.cutting_time, 1), (set.value, 1));
    let advice = Advice::from(msg!("turning.overload-without-pause", percent, time, pause))
        .setting(msg!("advice.set-pause", time = set.text.as_str()), [set]);
    fail(AtMost(rated), [advice])
}

/// Demand of the cut at positions of the knobs, and its limit.
type Demand = fn(&CutAtKnobs) -> (f64, f64);

/// A demand that holds at the form's positions of the knobs: a warning where it does not at another one, with the feed that holds at all of
/// them.
fn at_knobs(
    lathe: &TurningSpindle,
    limit: f64,
    demand: Demand,
    message: impl Fn(&CutAtKnobs, (f64, f64)) -> Message,
) -> Option<Judgement> {
    match knobs::worst(lathe.cuts_at_knobs(), demand) {
        Some((cut, numbers)) => warn(AtMost(limit), [with_slower_feed(lathe, demand, message(&cut, numbers))]),
        None => ok(AtMost(limit)),
    }
}

/// An advice with the greatest feed at which a demand holds at every position of the knobs, where less feed lowers it.
fn with_slower_feed(lathe: &TurningSpindle, demand: Demand, message: Message) -> Advice {
    match slower_feed(lathe, |slower| knobs::worst(slower.cuts_at_knobs(), demand).is_none()) {
        Some(share) => with_feed(lathe, share, message),
        None => message.into(),
    }
}

fn power_demand(cut: &CutAtKnobs) -> (f64, f64) {
    (cut.d.power, cut.d.for_the_cut(cut.p, cut.d.power_available))
}

fn torque_demand(cut: &CutAtKnobs) -> (f64, f64) {
    (cut.d.torque, cut.d.for_the_cut(cut.p, cut.d.torque_available))
}

fn peak_demand(cut: &CutAtKnobs) -> (f64, f64) {
    let CutPoint { torque, most, .. } = cut.d.worst_cut_point(cut.p);
    (torque, most)
}

fn bending_demand(cut: &CutAtKnobs) -> (f64, f64) {
    (bending::of(cut.p), NOTABLE)
}

fn power(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { p, d, .. } = lathe;
    if p.cutting_force <= 0.0 {
        return None;
    }
    let (rated, most) = (d.power_available, d.for_the_cut(p, d.power_available));
    if let Some(judgement) = overload_without_pause(lathe, d.power, rated) {
        return Some(judgement);
    }
    if d.power <= most {
        let at_knobs = at_knobs(lathe, rated, power_demand, |cut, (power, limit)| {
            let (feed, spindle) = ((cut.at.feed, 0), (cut.at.spindle, 0));
            msg!("turning.power-at-knobs", feed, spindle, power = (power, 2), limit = (limit, 2))
        });
        return if d.power <= rated { at_knobs } else { overloaded(lathe, rated, at_knobs) };
    }
    let at_share =
        |share: f64| lathe.with(Params { cutting_speed: lathe.form.cutting_speed * share, ..lathe.form.clone() });
    let suffices = |slower: &TurningSpindle| slower.d.power <= slower.d.power_available;
    // The speed limit may hold the work below the entered cutting speed: less of that changes nothing at first.
    let share = math::greatest_share((1.0 / p.cutting_speed).min(1.0), |share| suffices(&at_share(share)));
    let slower = share.map_or(0.0, |share| (p.cutting_speed * share).floor());
    // Friction keeps its power with less depth.
    let friction = spindle_motor::power(p.spindle.friction, d.speed_largest.max(d.speed_smallest));
    let part = (rated - friction) / (d.power - friction);
    // Below base speed a slower cut needs the same torque, and the motor has no more.
    let has_torque = |slower: &TurningSpindle| slower.d.torque <= slower.d.torque_available;
    let advice = match slower >= 1.0 && has_torque(&at_share(slower / p.cutting_speed)) {
        true => {
            let set = at_most(FIELDS, "cutting-speed", slower);
            Advice::from(msg!(
                "turning.too-little-power",
                power = (d.power, 2),
                limit = (rated, 2),
                speed = (slower, 0)
            ))
            .setting(msg!("advice.set-cutting-speed", speed = set.text.as_str()), [set])
        }
        false if slower >= 1.0 => {
            with_depth(lathe, part, msg!("turning.slower-lacks-torque", power = (d.power, 2), limit = (rated, 2)))
        }
        false => {
            with_depth(lathe, part, msg!("turning.far-too-little-power", power = (d.power, 2), limit = (rated, 2)))
        }
    };
    fail(AtMost(most), [advice])
}

/// An advice with the depth that is `share` of the present one, where the force follows from it and the passes stay within their number.
fn with_depth(lathe: &TurningSpindle, share: f64, message: Message) -> Advice {
    let advice = Advice::from(message);
    // The first of more passes is at a larger diameter, at most that of the stock.
    let grows = lathe.p.stock_diameter / lathe.p.middle_of_edge(lathe.d.largest_cut);
    let set = at_most(FIELDS, "depth", lathe.p.depth * share / grows);
    let depth = set.value;
    let passes = Params { depth, ..lathe.p.clone() };
    if lathe.p.material == Material::None || depth < LEAST_DEPTH || passes.passes() >= super::derive::PASSES {
        return advice;
    }
    advice.setting(msg!("advice.set-depth", depth = set.text.as_str()), [set])
}

/// Bending against the least that matters. A tailstock leaves a small part of it; less depth lessens the force. Work that bends more than the
/// cut along it is deep gives way before the tool: the force and with it the bending fall as the depth does, so that no smaller depth helps.
fn slender(lathe: &TurningSpindle) -> Option<Judgement> {
    let p = &lathe.p;
    let value = bending::of(p);
    if value <= NOTABLE {
        return at_knobs(lathe, NOTABLE, bending_demand, |cut, (bending, _)| {
            let (percent, bending) = ((cut.at.feed, 0), (bending, 2));
            if cut.p.tailstock {
                msg!("turning.held-work-bends-at-feed-knob", percent, bending)
            } else {
                msg!("turning.bends-at-feed-knob", percent, bending)
            }
        });
    }
    let (bending, depth, held) = ((value, 2), (p.depth, 3), (bending::held(p), 3));
    // A face has no place for the tailstock.
    let takes_tailstock = !p.tailstock && p.path != Path::Facing;
    if p.path != Path::Facing && value > p.depth {
        let advice = if takes_tailstock && bending::held(p) <= p.depth {
            fit_tailstock(p, msg!("turning.work-gives-way", bending, depth, held))
        } else {
            Advice::from(msg!("turning.held-work-gives-way", depth, held))
        };
        return fail(AtMost(p.depth), [advice]);
    }
    let greatest = lathe.at_highest_feed().map_or(value, |(_, fed)| bending::of(&fed.p));
    let shallower = |message: Message| with_depth(lathe, NOTABLE / greatest, message);
    match p.path {
        Path::Facing => warn(AtMost(NOTABLE), [shallower(msg!("turning.face-bends", bending))]),
        _ if takes_tailstock => {
            let tailstock = fit_tailstock(p, msg!("turning.work-bends", bending, held));
            warn(AtMost(NOTABLE), [tailstock, shallower(msg!("turning.less-depth"))])
        }
        _ => warn(AtMost(NOTABLE), [shallower(msg!("turning.held-work-bends", bending))]),
    }
}

/// An advice to hold the end of the work by the tailstock, and to start where the turret turns clear of it.
fn fit_tailstock(p: &Params, message: Message) -> Advice {
    let beside = at_least(FIELDS, "start-x", turret::beside(p.stock_diameter, p.turret_room));
    let start = (p.start_x < beside.value).then(|| FieldEntry::from(beside));
    let entries: Vec<_> = core::iter::once(FieldEntry::new("tailstock", "true")).chain(start).collect();
    Advice::from(message).setting(msg!("advice.tailstock"), entries)
}

/// Torque of cut and friction at the largest diameter of the cut, where it is greatest, against the motor's curve in the gear stage.
fn torque(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { p, d, .. } = lathe;
    if p.cutting_force <= 0.0 {
        return None;
    }
    let (rated, most) = (d.torque_available, d.for_the_cut(p, d.torque_available));
    if let Some(judgement) = overload_without_pause(lathe, d.torque, rated) {
        return Some(judgement);
    }
    let cooled = cooling::remedy(lathe);
    if d.torque <= most {
        let slower = |message| with_slower_feed(lathe, torque_demand, message);
        let at_knobs = match knobs::torque_remedy(&cooling::torques(lathe), cooling::FIELD, slower) {
            Some(TorqueRemedy::Feed(advice)) => warn(AtMost(rated), [advice]),
            // The rule of the cooling warns.
            Some(TorqueRemedy::Cooling(_)) | None => ok(AtMost(rated)),
        };
        if d.torque <= rated {
            return at_knobs;
        }
        let judgement = overloaded(lathe, rated, at_knobs)?;
        return Some(Judgement { advice: judgement.advice.into_iter().chain(cooled).collect(), ..judgement });
    }
    let message = match cooled {
        Some(_) => msg!("turning.shaft-fan-otherwise"),
        None => msg!(
            "turning.too-little-torque",
            torque = (d.torque, 1),
            speed = (d.speed_largest_cut, 0),
            limit = (rated, 1),
            stage = f64::from(d.stage)
        ),
    };
    let advice = match stronger_stage(lathe) {
        Some(stage) => {
            let gear = (1..).zip(Gear::OPTIONS.iter().skip(1)).find(|(number, _)| *number == stage);
            let sets = gear.map(|(_, (id, _))| ("gear", (*id).to_owned()));
            Advice::from(message).setting(msg!("advice.set-stage", stage = f64::from(stage)), Vec::from_iter(sets))
        }
        None => with_depth(lathe, (rated - p.spindle.friction) / (d.torque - p.spindle.friction), message),
    };
    fail(AtMost(most), Vec::from_iter(cooled.into_iter().chain([advice])))
}

/// Cut, friction and acceleration together against the short-time curve of the motor, at the diameter where they ask most of it.
fn peak_torque(lathe: &TurningSpindle) -> Option<Judgement> {
    if lathe.p.cutting_force <= 0.0 {
        return None;
    }
    let CutPoint { diameter, speed, torque, most } = lathe.d.worst_cut_point(&lathe.p);
    if torque <= most {
        return at_knobs(lathe, most, peak_demand, |cut, (torque, limit)| {
            let (feed, spindle) = ((cut.at.feed, 0), (cut.at.spindle, 0));
            let diameter = (cut.d.worst_cut_point(cut.p).diameter, 1);
            msg!("turning.stalls-at-knobs", feed, spindle, diameter, torque = (torque, 1), limit = (limit, 1))
        });
    }
    let message = msg!(
        "turning.cut-stalls",
        diameter = (diameter, 1),
        torque = (torque, 1),
        speed = (speed, 0),
        limit = (most, 1)
    );
    let holds = |slower: &TurningSpindle| {
        let point = slower.d.worst_cut_point(&slower.p);
        point.torque <= point.most
    };
    let everywhere =
        |slower: &TurningSpindle| holds(slower) && knobs::worst(slower.cuts_at_knobs(), peak_demand).is_none();
    let advice = match slower_feed(lathe, everywhere).or_else(|| slower_feed(lathe, holds)) {
        Some(share) => with_feed(lathe, share, message),
        None => message.into(),
    };
    fail(AtMost(most), [advice])
}

/// Least share of the present feed that an advice offers.
const LEAST_FEED: f64 = 0.1;

/// Greatest share of the present feed at which a condition holds; none where less feed does not help.
fn slower_feed(lathe: &TurningSpindle, holds: impl Fn(&TurningSpindle) -> bool) -> Option<f64> {
    let slower = |share: f64| lathe.with(Params { feed: lathe.form.feed * share, ..lathe.form.clone() });
    math::greatest_share(LEAST_FEED, |share| holds(&slower(share)))
}

/// A gear stage in which the torque suffices and the speed is the same.
fn stronger_stage(lathe: &TurningSpindle) -> Option<u8> {
    let output = &lathe.control.analog_output;
    let gears = [Gear::First, Gear::Second, Gear::Third, Gear::Fourth];
    let mut fitted = (1..).zip(lathe.p.stages()).zip(gears);
    let found = fitted.find(|(_, gear)| {
        let p = Params { gear: *gear, ..lathe.p.clone() };
        let d = Derived::new(&p, output, &lathe.dialect.spindle());
        let as_fast = |now: f64, before: f64| (now - before).abs() <= 1e-9 * before.abs();
        d.torque <= d.torque_available
            && as_fast(d.speed_largest_cut, lathe.d.speed_largest_cut)
            && as_fast(d.speed_smallest, lathe.d.speed_smallest)
    });
    found.map(|((number, _), _)| number)
}

/// Parameters out of the control's range: of the analog output, and those of its sheet.
fn ranges(lathe: &TurningSpindle, found: &mut Vec<Diagnostic>) {
    let TurningSpindle { p, .. } = lathe;
    let rules = &lathe.control.spindle;
    let mut check = |field, value, unit, range| found.extend(sheets::beyond_range(field, value, unit, range));
    let offsets = |at: usize| rules.offsets.and_then(|ranges| ranges.get(at).copied());
    check("offset-zero", p.offset_zero, "mV", offsets(0));
    check("offset-full", p.offset_full, "mV", offsets(1));
    for (field, speed) in ["stage-1", "stage-2", "stage-3", "stage-4"].into_iter().zip(p.stages()) {
        check(field, speed, "r/min", rules.stage_speeds);
    }
    let range = |role: ParamRole| lathe.control.param(role).and_then(|row| row.range);
    check("time-constant", p.slides.time_constant, "ms", range(ParamRole::AxisTimeConstant));
    check("encoder-lines", p.encoder.lines, "", range(ParamRole::SpindleEncoderLines));
}

/// Errors that refuse the export, and notes for the operator.
pub(super) fn findings(lathe: &TurningSpindle) -> Vec<Diagnostic> {
    let p = &lathe.p;
    let mut found = Vec::new();
    check_diameters(p, &mut found);
    travel::findings(lathe, &mut found);
    check_words(lathe, &mut found);
    ranges(lathe, &mut found);
    if lathe.form.speed_mode != p.speed_mode {
        found.push(Diagnostic::info(msg!("turning.no-surface-speed", control = lathe.control.name)));
    }
    found.extend(p.encoder.finding(lathe.control));
    keyway::findings(lathe, &mut found);
    if p.stages().count() < usize::from(p.gear as u8) {
        found.push(Diagnostic::warning(msg!("turning.no-such-stage", stage = f64::from(p.gear as u8))).about("gear"));
    }
    check_speed_limits(lathe, &mut found);
    if !lathe.control.macros.common_kept {
        found.push(Diagnostic::info(msg!("form.values-are-lost", program = program::SETUP)));
    }
    found
}

/// Finished diameters and start position against the stock, and the number of passes.
fn check_diameters(p: &Params, found: &mut Vec<Diagnostic>) {
    let largest = if p.path == Path::Taper { p.finished_diameter.max(p.large_diameter) } else { p.finished_diameter };
    let field = if p.path == Path::Taper && p.large_diameter > p.finished_diameter {
        "large-diameter"
    } else {
        "finished-diameter"
    };
    if largest >= p.stock_diameter {
        let message = msg!("turning.nothing-to-cut", diameter = (largest, 3), stock = (p.stock_diameter, 3));
        found.push(Diagnostic::error(message).about(field));
    }
    if p.path == Path::Turning && p.finished_diameter <= 0.0 || largest <= 0.0 && p.path == Path::Taper {
        found.push(Diagnostic::error(msg!("turning.nothing-left")).about("finished-diameter"));
    }
    if p.passes() >= super::derive::PASSES {
        found.push(Diagnostic::error(msg!("turning.too-many-passes", count = super::derive::PASSES)).about("depth"));
    }
    if p.cut_length() > p.reach() {
        let field = if p.path == Path::Facing { "allowance" } else { "length" };
        found.push(
            Diagnostic::error(msg!("turning.cut-in-chuck", end = (p.cut_length(), 3), reach = (p.reach(), 3)))
                .about(field),
        );
    }
    found.extend(falling_cone(p));
    let stock = (p.stock_diameter, if p.path == Path::Facing { p.allowance } else { 0.0 });
    found.extend(if p.tailstock {
        turret::hits_tailstock(p.start_x, p.stock_diameter, p.turret_room)
    } else {
        turret::hits_work((p.start_x, p.start_z), stock, p.turret_room)
    });
    if p.start_x <= p.stock_diameter + 2.0 * p.clearance {
        let least = p.stock_diameter + 2.0 * p.clearance;
        found.push(
            Diagnostic::error(msg!("turning.start-in-stock", start = (p.start_x, 3), least = (least, 3)))
                .about("start-x")
                .mended_by(least.floor() + 2.0),
        );
    }
}

/// Point angles (°) of inserts: the slimmest and the stoutest that turn outlines, V and C of ISO 1832. Source: memory.
const INSERTS: (f64, f64) = (35.0, 80.0);

/// A cone that falls towards the chuck, against the flank that trails behind the tip of the insert: it clears `180° - κ - ε`, with the edge
/// angle κ and the point angle ε of the insert. An error where no insert is slim enough, with the length at which one is.
fn falling_cone(p: &Params) -> Option<Diagnostic> {
    let depth = 0.5 * (p.finished_diameter - p.large_diameter);
    if p.path != Path::Taper || depth <= 0.0 {
        return None;
    }
    let (slim, stout) = INSERTS;
    let fall = math::atan2_degrees(depth, p.length);
    let clear = 180.0 - p.edge_angle;
    let angle = (fall, 1);
    let edge = (p.edge_angle, 1);
    if fall > clear - slim {
        let most = ((clear - slim).max(0.0), 1);
        let message = msg!("turning.cone-falls-too-steep", angle, edge, slim = (slim, 0), most);
        let found = Diagnostic::error(message).about("length");
        let slope = math::tan_degrees(clear - slim).filter(|slope| *slope > 0.0);
        let longer =
            slope.map(|slope| at_least(FIELDS, "length", depth / slope).value).filter(|length| *length <= p.reach());
        return Some(longer.into_iter().fold(found, Diagnostic::mended_by));
    }
    let message =
        msg!("turning.cone-needs-slim-insert", angle, edge, stout = (stout, 0), most = ((clear - fall).floor(), 0));
    (fall > clear - stout).then(|| Diagnostic::warning(message).about("length"))
}

/// Values of the form against the words of the control: range, whole numbers, positions of the override knob.
fn check_words(lathe: &TurningSpindle, found: &mut Vec<Diagnostic>) {
    let TurningSpindle { p, d, .. } = lathe;
    let limits = &lathe.control.limits;
    if p.upper_limit > limits.speed_max {
        let message = msg!("turning.speed-above-range", speed = (p.upper_limit, 0), most = limits.speed_max);
        found.push(Diagnostic::error(message).about("upper-limit"));
    }
    if p.feed > limits.revolution_feed_max {
        let message = msg!("turning.feed-above-range", feed = (p.feed, 3), most = limits.revolution_feed_max);
        found.push(Diagnostic::error(message).about("feed"));
    }
    if p.cutting_speed <= 0.0 {
        found.push(
            Diagnostic::error(msg!("turning.speed-is-zero", speed = lathe.form.cutting_speed)).about("cutting-speed"),
        );
    } else if p.cutting_speed != lathe.form.cutting_speed {
        found.push(Diagnostic::warning(msg!("turning.whole-speed", speed = p.cutting_speed)).about("cutting-speed"));
    }
    if !lathe.surface() && d.asked <= 0.0 && p.cutting_speed > 0.0 {
        let message = msg!("turning.fixed-is-zero", speed = (p.cutting_speed, 2), stock = (p.stock_diameter, 3));
        found.push(Diagnostic::error(message).about("cutting-speed"));
    }
    if p.override_percent != lathe.form.override_percent {
        found.push(Diagnostic::warning(msg!("turning.knob-steps", percent = p.override_percent)).about("override"));
    }
}

/// A gear stage behind one that is not fitted: the program would never engage it.
fn stage_behind_gap(p: &Params) -> Option<Diagnostic> {
    let stages = [("stage-2", p.stage_2), ("stage-3", p.stage_3), ("stage-4", p.stage_4)];
    let fitted = stages.iter().skip_while(|(_, speed)| *speed > 0.0).find(|(_, speed)| *speed > 0.0);
    fitted.map(|(field, _)| Diagnostic::error(msg!("turning.stage-behind-gap")).about(field))
}

/// A lower limit above the speed that the cut asks at its largest diameter, with the cutting speed that it makes.
fn lifted_speed(lathe: &TurningSpindle) -> Option<Diagnostic> {
    let TurningSpindle { p, d, .. } = lathe;
    let lowest = if lathe.surface() || lathe.rules().low_always { p.lower_limit.min(p.upper_limit) } else { 0.0 };
    let largest = d.largest.min(p.stock_diameter);
    let asked = surface_rpm(p.cutting_speed, largest);
    if lowest <= asked {
        return None;
    }
    let (diameter, surface_speed) = ((largest, 1), (surface_speed(lowest, largest), 0));
    let message = msg!("turning.lower-limit-lifts", limit = (lowest, 0), diameter, surface_speed);
    Some(Diagnostic::warning(message).about("lower-limit").mended_by(asked.floor()))
}

/// The limits of the speed against each other, and against the knob at a fixed speed.
fn check_speed_limits(lathe: &TurningSpindle, found: &mut Vec<Diagnostic>) {
    let p = &lathe.p;
    found.extend(stage_behind_gap(p));
    found.extend(lifted_speed(lathe));
    found.extend(passed_limit(lathe));
    let upper = if lathe.surface() { p.upper_limit.min(p.chuck_limit) } else { p.chuck_limit };
    if (lathe.surface() || lathe.rules().low_always) && p.lower_limit > upper {
        let message = msg!("turning.limits-crossed", lower = show(p.lower_limit, 0), upper = show(upper, 0));
        found.push(Diagnostic::warning(message).about("lower-limit"));
    }
}

/// The fixed speed at the position of the override knob where it is greatest, with that position in percent.
fn fastest_fixed(lathe: &TurningSpindle) -> (f64, f64) {
    let present = (lathe.p.override_percent, lathe.d.fixed_speed);
    lathe
        .at_highest_knob()
        .map(|(percent, d)| (percent, d.fixed_speed))
        .filter(|fast| fast.1 > present.1)
        .unwrap_or(present)
}

/// A fixed speed that the override knob lifts over the operator's limit, with the cutting speed that stays below it.
fn passed_limit(lathe: &TurningSpindle) -> Option<Diagnostic> {
    let p = &lathe.p;
    let (percent, speed) = fastest_fixed(lathe);
    if lathe.surface() || speed <= p.upper_limit {
        return None;
    }
    let message =
        msg!("turning.override-passes-limit", percent = (percent, 0), speed = (speed, 0), limit = (p.upper_limit, 0));
    let slower = surface_speed(p.upper_limit * 100.0 / percent, p.stock_diameter).floor();
    let held = slower >= 1.0
        && fastest_fixed(&lathe.with(Params { cutting_speed: slower, ..lathe.form.clone() })).1 <= p.upper_limit;
    let found = Diagnostic::warning(message).about("cutting-speed");
    Some(if held { found.mended_by(slower) } else { found })
}

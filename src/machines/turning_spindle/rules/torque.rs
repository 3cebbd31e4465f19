//! The rules of torque: cut, friction and acceleration against the motor's curves in the gear stage.

use super::knob_positions::{at_knobs, with_slower_feed};
use super::overload::{overload_without_pause, overloaded};
use super::remedies::{slower_cut, with_depth};
use super::stages::stronger_stage;
use crate::drives::spindle_motor::shortest_ramp;
use crate::machines::form::entry::{at_least, field_max};
use crate::machines::lathe::knobs::{self, TorqueRemedy};
use crate::machines::turning_spindle::cooling;
use crate::machines::turning_spindle::params::{FIELDS, Gear};
use crate::machines::turning_spindle::resolved::{CutAtKnobs, TurningSpindle};
use crate::machines::turning_spindle::worst_cut::{CutPoint, left_beside_the_cut, worst_cut_point, worst_ramp_point};
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::msg;
use crate::view::Advice;
use crate::view::Limit::AtMost;

fn torque_demand(cut: &CutAtKnobs) -> (f64, f64) {
    (cut.derived.load.torque, cut.derived.times.for_the_cut(cut.params, cut.derived.load.torque_available))
}

fn peak_demand(cut: &CutAtKnobs) -> (f64, f64) {
    let CutPoint { torque, most, .. } = worst_cut_point(cut.params, cut.derived);
    (torque, most)
}

/// Torque of cut and friction at the largest diameter of the cut, where it is greatest, against the motor's curve in the gear stage.
pub(super) fn torque(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { params: p, derived: d, .. } = lathe;
    if p.cutting_force <= 0.0 {
        return None;
    }
    let (rated, most) = (d.load.torque_available, d.times.for_the_cut(p, d.load.torque_available));
    if let Some(judgement) = overload_without_pause(lathe, d.load.torque, rated) {
        return Some(judgement);
    }
    let cooled = cooling::remedy(lathe);
    if d.load.torque <= most {
        let slower = |message| with_slower_feed(lathe, torque_demand, message);
        let at_knobs = match knobs::torque_remedy(&cooling::torques(lathe), cooling::FIELD, slower) {
            Some(TorqueRemedy::Feed(advice)) => warn(AtMost(rated), [advice]),
            // The rule of the cooling gives the warning.
            Some(TorqueRemedy::Cooling(_)) | None => ok(AtMost(rated)),
        };
        if d.load.torque <= rated {
            return at_knobs;
        }
        let judgement = overloaded(lathe, rated, at_knobs)?;
        return Some(Judgement { advice: judgement.advice.into_iter().chain(cooled).collect(), ..judgement });
    }
    let message = match cooled {
        Some(_) => msg!("turning.shaft-fan-otherwise"),
        None => msg!(
            "turning.too-little-torque",
            torque = (d.load.torque, 1),
            speed = (d.speeds.largest_whole, 0),
            limit = (rated, 1),
            stage = f64::from(d.stage.number)
        ),
    };
    let advice = match stronger_stage(lathe) {
        Some(stage) => {
            let gear = (1..).zip(Gear::OPTIONS.iter().skip(1)).find(|(number, _)| *number == stage);
            let sets = gear.map(|(_, (id, _))| ("gear", (*id).to_owned()));
            Advice::from(message).setting(msg!("advice.set-stage", stage = f64::from(stage)), Vec::from_iter(sets))
        }
        None => with_depth(lathe, (rated - p.spindle.friction) / (d.load.torque - p.spindle.friction), message),
    };
    fail(AtMost(most), Vec::from_iter(cooled.into_iter().chain([advice])))
}

/// Judges cut, friction and acceleration together against the short-time curve of the motor, at the diameter with the
/// greatest share of it.
pub(super) fn peak_torque(lathe: &TurningSpindle) -> Option<Judgement> {
    if lathe.params.cutting_force <= 0.0 {
        return None;
    }
    let CutPoint { diameter, speed, torque, most } = worst_cut_point(&lathe.params, &lathe.derived);
    if torque <= most {
        if let Some(turned) = turn_of_the_knob(lathe, most) {
            return Some(turned);
        }
        return at_knobs(lathe, most, peak_demand, |cut, (torque, limit)| {
            let (feed, spindle) = ((cut.at.feed, 0), (cut.at.spindle, 0));
            let diameter = (worst_cut_point(cut.params, cut.derived).diameter, 1);
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
        let point = worst_cut_point(&slower.params, &slower.derived);
        point.torque <= point.most
    };
    let everywhere =
        |slower: &TurningSpindle| holds(slower) && knobs::worst(slower.cuts_at_knobs(), peak_demand).is_none();
    // Where no slower cut holds at every position of the knobs, one that holds as they are.
    let wanted: [&dyn Fn(&TurningSpindle) -> bool; 2] = [&everywhere, &holds];
    let advice = Advice::from(message);
    let advice = match wanted.into_iter().find_map(|condition| slower_cut(lathe, condition)) {
        Some((button, set)) => advice.setting(button, [set]),
        None => advice,
    };
    fail(AtMost(most), [advice])
}

/// Position (%) of the spindle override at which operator's panels end, whatever a control takes beyond. Source: SINUMERIK 802D facts, 3.7.
const PANEL_END: f64 = 120.0;

/// Warns of a ramp that is too steep beside the cut: the inverter accelerates over it when the operator turns the knob in the cut, and at the
/// begin of a cut that waits only for a part of the speed. Judged where cut and ramp take most of the short-time torque; the longer ramp of
/// the advice suffices at every diameter and position of the knobs.
fn turn_of_the_knob(lathe: &TurningSpindle, limit: f64) -> Option<Judgement> {
    let at_ends = lathe.cuts_at_knobs().into_iter().filter(|cut| cut.at.spindle <= PANEL_END);
    let all = || core::iter::once(lathe.cut_at_present()).chain(at_ends.clone());
    let (cut, (torque, most)) = knobs::worst(all(), ramp_demand)?;
    let spindle = cut.params.main_spindle(cut.derived.stage.speed);
    let left = all().map(|cut| left_beside_the_cut(cut.params, cut.derived)).fold(f64::INFINITY, f64::min);
    let shortest = shortest_ramp(spindle.load_at_spindle.inertia, spindle.speed_at_10v, left);
    let (feed, percent) = ((cut.at.feed, 0), (cut.at.spindle, 0));
    let diameter = (worst_ramp_point(cut.params, cut.derived).diameter, 1);
    let message =
        msg!("turning.ramp-in-cut", feed, spindle = percent, diameter, torque = (torque, 1), limit = (most, 1));
    let advice = Advice::from(message);
    if shortest > field_max(FIELDS, "spindle-ramp") {
        return warn(AtMost(limit), [advice]);
    }
    let set = at_least(FIELDS, "spindle-ramp", shortest);
    warn(AtMost(limit), [advice.setting(msg!("advice.set-ramp", time = set.text.as_str()), [set])])
}

/// Torque (Nm) of cut, friction and the whole acceleration of the ramp where they take most of the short-time torque, and that torque.
fn ramp_demand(cut: &CutAtKnobs) -> (f64, f64) {
    let CutPoint { torque, most, .. } = worst_ramp_point(cut.params, cut.derived);
    (torque, most)
}

//! The rule of power: cut and friction against the motor.

use super::knob_positions::at_knobs;
use super::overload::{overload_without_pause, overloaded};
use super::remedies::with_depth;
use crate::drives::spindle_motor;
use crate::machines::form::entry::at_most;
use crate::machines::turning_spindle::params::{FIELDS, Params};
use crate::machines::turning_spindle::resolved::{CutAtKnobs, TurningSpindle};
use crate::machines::verdict::{Judgement, fail};
use crate::math;
use crate::msg;
use crate::view::Advice;
use crate::view::Limit::AtMost;

fn power_demand(cut: &CutAtKnobs) -> (f64, f64) {
    (cut.derived.load.power, cut.derived.times.for_the_cut(cut.params, cut.derived.load.power_available))
}

/// Judges the greatest power of cut and friction against the motor; the remedies are the cutting speed or the depth at
/// which it suffices.
pub(super) fn power(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { params: p, derived: d, .. } = lathe;
    if p.cutting_force <= 0.0 {
        return None;
    }
    let (rated, most) = (d.load.power_available, d.times.for_the_cut(p, d.load.power_available));
    if let Some(judgement) = overload_without_pause(lathe, d.load.power, rated) {
        return Some(judgement);
    }
    if d.load.power <= most {
        let at_knobs = at_knobs(lathe, rated, power_demand, |cut, (power, limit)| {
            let (feed, spindle) = ((cut.at.feed, 0), (cut.at.spindle, 0));
            msg!("turning.power-at-knobs", feed, spindle, power = (power, 2), limit = (limit, 2))
        });
        return if d.load.power <= rated { at_knobs } else { overloaded(lathe, rated, at_knobs) };
    }
    let at_share =
        |share: f64| lathe.with(Params { cutting_speed: lathe.form.cutting_speed * share, ..lathe.form.clone() });
    let suffices = |slower: &TurningSpindle| slower.derived.load.power <= slower.derived.load.power_available;
    // The speed limit may keep the surface speed below the entered one: a lower entry changes nothing at first.
    let share = math::greatest_share((1.0 / p.cutting_speed).min(1.0), |share| suffices(&at_share(share)));
    let slower = share.map_or(0.0, |share| (p.cutting_speed * share).floor());
    // Friction keeps its power with less depth.
    let friction = spindle_motor::power(p.spindle.friction, d.speeds.largest.max(d.speeds.smallest));
    let part = (rated - friction) / (d.load.power - friction);
    // Below base speed a slower cut needs the same torque, and the motor has no more.
    let has_torque = |slower: &TurningSpindle| slower.derived.load.torque <= slower.derived.load.torque_available;
    let advice = match slower >= 1.0 && has_torque(&at_share(slower / p.cutting_speed)) {
        true => {
            let set = at_most(FIELDS, "cutting-speed", slower);
            Advice::from(msg!(
                "turning.too-little-power",
                power = (d.load.power, 2),
                limit = (rated, 2),
                speed = (slower, 0)
            ))
            .setting(msg!("advice.set-cutting-speed", speed = set.text.as_str()), [set])
        }
        false if slower >= 1.0 => {
            with_depth(lathe, part, msg!("turning.slower-lacks-torque", power = (d.load.power, 2), limit = (rated, 2)))
        }
        false => {
            with_depth(lathe, part, msg!("turning.far-too-little-power", power = (d.load.power, 2), limit = (rated, 2)))
        }
    };
    fail(AtMost(most), [advice])
}

//! Cooling of the spindle's motor: by a fan on its shaft, which turns with the rotor, or forced.

use super::derive::Derived;
use super::driven::{self, motor_speed};
use super::resolved::TurningSpindle;
use crate::machines::devices::{AskedDevice, forced_cooling_advice};
use crate::machines::main_spindle;
use crate::machines::verdict::{Judgement, warn};
use crate::msg;
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// Field of the form with forced cooling.
const FIELD: &str = "motor-forced-cooling";

/// The fan of a motor with forced cooling.
pub(super) fn devices(lathe: &TurningSpindle) -> Vec<AskedDevice> {
    Vec::from_iter(main_spindle::fan(driven::NAME, lathe.p.spindle.forced_cooling))
}

/// Forced cooling, where the motor carries the cut with it and not with a fan on its shaft.
pub(super) fn remedy(lathe: &TurningSpindle) -> Option<Advice> {
    let (d, limit) = (&lathe.d, lathe.d.torque_available);
    let speed = motor_speed(lathe, d);
    let said = msg!("lathe.shaft-fan", speed = (speed, 0), torque = (d.torque, 1), limit = (limit, 1));
    carries_with_forced(lathe, d).then(|| forced_cooling_advice(FIELD, said))
}

/// Cut and friction with the knob at its lowest position, where they ask the same torque and the fan on the motor's shaft cools least.
pub(super) fn judge(lathe: &TurningSpindle) -> Option<Judgement> {
    let (p, d) = (&lathe.p, &lathe.d);
    if p.cutting_force <= 0.0 || p.spindle.forced_cooling || d.torque > d.torque_available {
        return None;
    }
    let (percent, slow) = lathe.at_lowest_knob()?;
    let limit = slow.for_the_cut(p, slow.torque_available);
    if slow.torque <= limit || !carries_with_forced(lathe, slow) {
        return None;
    }
    let speed = (motor_speed(lathe, slow), 0);
    let (percent, torque, shown) = ((percent, 0), (slow.torque, 1), (limit, 1));
    let said = msg!("lathe.shaft-fan-at-knob", percent, speed, torque, limit = shown);
    warn(AtMost(d.torque_available), [forced_cooling_advice(FIELD, said)])
}

fn carries_with_forced(lathe: &TurningSpindle, d: &Derived) -> bool {
    let forced = lathe.p.continuous(d.stage_speed).with_shaft_fan(false);
    !lathe.p.spindle.forced_cooling && d.torque <= d.for_the_cut(&lathe.p, forced.torque(d.speed_largest_cut))
}

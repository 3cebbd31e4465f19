//! Cooling of the spindle's motor: by a fan on its shaft, which turns with the rotor, or forced.

use super::derive::Derived;
use super::driven::{self, motor_speed};
use super::resolved::{CutAtKnobs, TurningSpindle};
use crate::drives::spindle_motor::MotorCurve;
use crate::machines::driven::devices::{AskedDevice, forced_cooling_advice};
use crate::machines::lathe::knobs::{self, TorqueAtKnobs, TorqueRemedy};
use crate::machines::lathe::main_spindle;
use crate::machines::verdict::{Judgement, warn};
use crate::msg;
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// Field of the form with forced cooling.
pub(super) const FIELD: &str = "motor-forced-cooling";

/// The fan of a motor with forced cooling.
pub(super) fn devices(lathe: &TurningSpindle) -> Vec<AskedDevice> {
    Vec::from_iter(main_spindle::fan(driven::NAME, lathe.params.spindle.forced_cooling))
}

/// Advice to fit forced cooling, if the motor carries the cut with it and not with a fan on its shaft.
pub(super) fn remedy(lathe: &TurningSpindle) -> Option<Advice> {
    let (d, limit) = (&lathe.derived, lathe.derived.load.torque_available);
    let speed = motor_speed(lathe, d);
    let said = msg!("lathe.shaft-fan", speed = (speed, 0), torque = (d.load.torque, 1), limit = (limit, 1));
    carries_with_forced(lathe, d).then(|| forced_cooling_advice(FIELD, said))
}

/// Cut and friction at the positions of the knobs.
pub(super) fn torques(lathe: &TurningSpindle) -> Vec<TorqueAtKnobs> {
    let all = lathe.cuts_at_knobs();
    let of = |CutAtKnobs { at, params: p, derived: d }: CutAtKnobs| {
        let most = |motor: MotorCurve| d.times.for_the_cut(p, motor.torque(d.speeds.largest_whole));
        let motor = p.continuous(d.stage.speed);
        let (limit, forced) = (most(motor), most(motor.with_shaft_fan(false)));
        TorqueAtKnobs { at, torque: d.load.torque, limit, forced, motor_speed: motor_speed(lathe, d) }
    };
    all.into_iter().map(of).collect()
}

/// Judges cut and friction at the positions of the knobs, if the fan on the motor's shaft cools too little there and
/// forced cooling would suffice.
pub(super) fn judge(lathe: &TurningSpindle) -> Option<Judgement> {
    let d = &lathe.derived;
    if lathe.params.cutting_force <= 0.0 || d.load.torque > d.load.torque_available {
        return None;
    }
    match knobs::torque_remedy(&torques(lathe), FIELD, Advice::from)? {
        TorqueRemedy::Cooling(advice) => warn(AtMost(d.load.torque_available), [advice]),
        TorqueRemedy::Feed(_) => None,
    }
}

fn carries_with_forced(lathe: &TurningSpindle, d: &Derived) -> bool {
    let forced = lathe.params.continuous(d.stage.speed).with_shaft_fan(false);
    !lathe.params.spindle.forced_cooling
        && d.load.torque <= d.times.for_the_cut(&lathe.params, forced.torque(d.speeds.largest_whole))
}

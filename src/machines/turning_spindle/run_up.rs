//! The spindle in the gear stage of the program, its highest speed, and verdicts about ramp and positioning.

use super::derive::Derived;
use super::keyway;
use super::params::FIELDS;
use super::resolved::TurningSpindle;
use crate::drives::MainSpindle;
use crate::machines::form::entry::at_most;
use crate::machines::lathe::main_spindle::{self, SpeedAtKnob};
use crate::machines::verdict::{Judgement, fail, ok};
use crate::math::RPM;
use crate::msg;
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// Highest speed of the program, r/min.
pub(super) fn programmed_speed(lathe: &TurningSpindle) -> f64 {
    programmed_speed_of(&lathe.derived)
}

pub(super) fn programmed_speed_of(d: &Derived) -> f64 {
    d.speeds.largest.max(d.speeds.smallest)
}

/// Greatest speed (r/min) of the program with the knob at its highest position.
pub(super) fn greatest_speed(lathe: &TurningSpindle) -> f64 {
    lathe.at_highest_knob().map_or(0.0, |(_, fast)| programmed_speed_of(fast)).max(programmed_speed(lathe))
}

/// Seconds in which the spindle coasts to rest from its greatest speed.
pub(super) fn coasting(lathe: &TurningSpindle) -> f64 {
    engaged(lathe).coasting(greatest_speed(lathe))
}

/// The spindle in the program's gear stage.
pub(super) fn engaged(lathe: &TurningSpindle) -> MainSpindle {
    lathe.params.main_spindle(lathe.derived.stage.speed)
}

/// Torque (Nm) at the spindle for its acceleration to the positioning speed: `J α + M_f`. Source: turning spindle facts, 5.
pub(super) fn positioning_torque(lathe: &TurningSpindle) -> f64 {
    let load = engaged(lathe).load_at_spindle;
    load.accelerating(0.0, lathe.params.positioning_acceleration * RPM, 1.0) + load.torque
}

/// Judges the torque of the positioning's acceleration against the short-time torque of the motor.
pub(super) fn judge_positioning(lathe: &TurningSpindle) -> Option<Judgement> {
    let spindle = engaged(lathe);
    let most = spindle.driving_motor().torque(lathe.params.positioning_speed);
    let torque = positioning_torque(lathe);
    let sign = keyway::sign_for_angle(lathe);
    if torque <= most {
        return sign.map_or_else(|| ok(AtMost(most)), |advice| fail(None, [advice]));
    }
    let friction = spindle.load_at_spindle.torque;
    let slower = lathe.params.positioning_acceleration * (most - friction) / (torque - friction);
    let advice = Advice::from(msg!("turning.positioning-too-hard", torque = (torque, 1), limit = (most, 1)));
    let set = at_most(FIELDS, "positioning-acceleration", slower);
    let button = msg!("advice.set-positioning-acceleration", acceleration = set.text.as_str());
    let advice = if slower >= 1.0 { advice.setting(button, [set]) } else { advice };
    fail(AtMost(most), core::iter::once(advice).chain(sign).collect::<Vec<_>>())
}

/// The form's ramp against the shortest one.
pub(super) fn judge(lathe: &TurningSpindle) -> Option<Judgement> {
    let at_knob =
        lathe.at_highest_knob().map(|(percent, fast)| SpeedAtKnob { percent, speed: programmed_speed_of(fast) });
    main_spindle::judge_ramp(&engaged(lathe), programmed_speed(lathe), at_knob, (FIELDS, "spindle-ramp"))
}

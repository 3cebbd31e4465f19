//! Demand of run-up and braking on the motor in the gear stage of the program, and coasting time without current.

use super::params::FIELDS;
use super::resolved::TurningSpindle;
use crate::drives::MainSpindle;
use crate::drives::load::Load;
use crate::machines::main_spindle;
use crate::machines::verdict::{Judgement, down, fail, ok};
use crate::math::RPM;
use crate::msg;
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// Highest speed of the program, r/min.
pub(super) fn highest(lathe: &TurningSpindle) -> f64 {
    lathe.d.speed_largest.max(lathe.d.speed_smallest)
}

/// The spindle in the program's gear stage.
fn engaged(lathe: &TurningSpindle) -> MainSpindle {
    lathe.p.main_spindle(lathe.d.stage_speed)
}

/// Chuck, work and rotor in the program's gear stage, at the spindle.
fn turned(lathe: &TurningSpindle) -> Load {
    engaged(lathe).turned
}

/// Moment of inertia (kg m²) of all that turns.
pub(super) fn inertia(lathe: &TurningSpindle) -> f64 {
    turned(lathe).inertia
}

/// Torque (Nm) at the spindle that the run-up asks at the form's ramp.
pub(super) fn torque(lathe: &TurningSpindle) -> f64 {
    engaged(lathe).ramp_torque()
}

/// The shortest ramp (s to the speed at 10 V) that the motor has the torque for at the highest speed of the program.
pub(super) fn shortest_ramp(lathe: &TurningSpindle) -> f64 {
    engaged(lathe).shortest_ramp(highest(lathe))
}

/// Torque (Nm) at the spindle for its acceleration to the positioning speed: `J α + M_f`. Source: turning spindle facts, 5.
pub(super) fn positioning_torque(lathe: &TurningSpindle) -> f64 {
    let turned = turned(lathe);
    turned.accelerating(0.0, lathe.p.positioning_acceleration * RPM, 1.0) + turned.torque
}

/// The acceleration of the positioning against the short-time torque of the motor.
pub(super) fn judge_positioning(lathe: &TurningSpindle) -> Option<Judgement> {
    let [motor, _] = lathe.p.for_moments(lathe.d.stage_speed);
    let (torque, most) = (positioning_torque(lathe), motor.torque(lathe.p.positioning_speed));
    if torque <= most {
        return ok(AtMost(most));
    }
    let turned = turned(lathe);
    let slower = lathe.p.positioning_acceleration * (most - turned.torque) / (torque - turned.torque);
    let advice = Advice::from(msg!("turning.positioning-too-hard", torque = (torque, 1), limit = (most, 1)));
    let set = down(FIELDS, "positioning-acceleration", slower);
    let button = msg!("advice.set-positioning-acceleration", acceleration = set.1.as_str());
    fail(AtMost(most), [if slower >= 1.0 { advice.setting(button, [set]) } else { advice }])
}

/// Seconds to the highest speed of the program with the short-time torque of the motor.
pub(super) fn run_up(lathe: &TurningSpindle) -> f64 {
    engaged(lathe).run_up(highest(lathe))
}

/// Braking time (s) from the highest speed to rest.
pub(super) fn braking(lathe: &TurningSpindle) -> f64 {
    engaged(lathe).braking(highest(lathe))
}

/// Coasting time (s) without current, from the highest speed to rest.
pub(super) fn coasting(lathe: &TurningSpindle) -> f64 {
    engaged(lathe).coasting(highest(lathe))
}

/// Energy (J) that a stop over the ramp from the highest speed gives back at the spindle.
pub(super) fn stop_energy(lathe: &TurningSpindle) -> f64 {
    engaged(lathe).stop_energy(highest(lathe))
}

/// The form's ramp against the shortest one.
pub(super) fn judge(lathe: &TurningSpindle) -> Option<Judgement> {
    main_spindle::judge_ramp(&engaged(lathe), highest(lathe), (FIELDS, "spindle-ramp"))
}

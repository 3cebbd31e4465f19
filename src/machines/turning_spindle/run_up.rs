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

/// Greatest speed (r/min) of the cut with the knob at its highest position.
pub(super) fn greatest_speed(lathe: &TurningSpindle) -> f64 {
    lathe.at_highest_knob().map_or(0.0, |(_, fast)| programmed_speed_of(fast)).max(programmed_speed(lathe))
}

/// Greatest speed (r/min) at all: of the cut or of the positioning.
pub(super) fn greatest_turned_speed(lathe: &TurningSpindle) -> f64 {
    let positioning = if lathe.positions() { lathe.params.positioning_speed } else { 0.0 };
    greatest_speed(lathe).max(positioning)
}

/// Seconds in which the spindle coasts to rest from its greatest speed.
pub(super) fn coasting(lathe: &TurningSpindle) -> f64 {
    engaged(lathe).coasting(greatest_turned_speed(lathe))
}

/// The spindle in the program's gear stage.
pub(super) fn engaged(lathe: &TurningSpindle) -> MainSpindle {
    lathe.params.main_spindle(lathe.derived.stage.speed)
}

/// Torque (Nm) at the spindle for its acceleration to the positioning speed: `J α + M_f`. Source: turning spindle facts, 5.
pub(super) fn positioning_torque(lathe: &TurningSpindle) -> f64 {
    torque_of(lathe, lathe.params.positioning_acceleration)
}

/// Torque (Nm) at the spindle for an acceleration in r/min per second.
fn torque_of(lathe: &TurningSpindle, acceleration: f64) -> f64 {
    let load = engaged(lathe).load_at_spindle;
    load.accelerating(0.0, acceleration * RPM, 1.0) + load.torque
}

/// Greatest acceleration (r/min per second) of the positioning by what limits it.
struct PositioningLimits {
    /// The motor's short-time torque in driving, against friction: `(M - M_f) / J`.
    driving: f64,
    /// Its short-time torque in braking, with friction: `(M_b + M_f) / J`.
    braking: f64,
    /// The ramp of the inverter: `n10 / t`.
    ramp: f64,
}

impl PositioningLimits {
    /// Source: turning spindle facts, 5.
    fn new(lathe: &TurningSpindle) -> PositioningLimits {
        let (spindle, speed) = (engaged(lathe), lathe.params.positioning_speed);
        let per_torque = 1.0 / (spindle.load_at_spindle.inertia * RPM);
        let friction = spindle.load_at_spindle.torque;
        PositioningLimits {
            driving: (spindle.driving_motor().torque(speed) - friction) * per_torque,
            braking: (spindle.braking_motor().torque(speed) + friction) * per_torque,
            ramp: if spindle.ramp > 0.0 { spindle.speed_at_10v / spindle.ramp } else { f64::INFINITY },
        }
    }

    fn least(&self) -> f64 {
        self.driving.min(self.braking).min(self.ramp)
    }
}

/// Judges the acceleration of the positioning: the motor drives and brakes with its short-time torque, and the inverter follows no steeper than
/// its ramp.
pub(super) fn judge_positioning(lathe: &TurningSpindle) -> Option<Judgement> {
    let (p, limits) = (&lathe.params, PositioningLimits::new(lathe));
    // The torque of the greatest acceleration.
    let limit = AtMost(torque_of(lathe, limits.least()));
    let sign = keyway::sign_for_angle(lathe);
    let asked = p.positioning_acceleration;
    if asked <= limits.least() {
        return sign.map_or_else(|| ok(limit), |advice| fail(None, [advice]));
    }
    let message = if asked > limits.driving {
        let gives = engaged(lathe).driving_motor().torque(p.positioning_speed);
        msg!("turning.positioning-too-hard", torque = (positioning_torque(lathe), 1), limit = (gives, 1))
    } else if asked > limits.braking {
        msg!("turning.positioning-brakes-too-hard", acceleration = (asked, 0), limit = (limits.braking, 0))
    } else {
        msg!("turning.positioning-beyond-ramp", acceleration = (asked, 0), limit = (limits.ramp, 0))
    };
    let set = at_most(FIELDS, "positioning-acceleration", limits.least());
    let advice = Advice::from(message);
    let button = msg!("advice.set-positioning-acceleration", acceleration = set.text.as_str());
    let advice = if limits.least() >= 1.0 { advice.setting(button, [set]) } else { advice };
    fail(limit, core::iter::once(advice).chain(sign).collect::<Vec<_>>())
}

/// The form's ramp against the shortest one.
pub(super) fn judge(lathe: &TurningSpindle) -> Option<Judgement> {
    let at_knob =
        lathe.at_highest_knob().map(|(percent, fast)| SpeedAtKnob { percent, speed: programmed_speed_of(fast) });
    main_spindle::judge_ramp(&engaged(lathe), programmed_speed(lathe), at_knob, (FIELDS, "spindle-ramp"))
}

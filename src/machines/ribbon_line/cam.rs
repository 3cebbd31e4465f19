//! The electronic cam of the print roller: it runs at the ribbon's speed in the contact, and corrects arc against pitch between two contacts.
//!
//! The cam only gives results: the written program has one constant ratio, and its verdicts do not depend on the cam.

use super::derive::Derived;
use super::mechanics::ServoAxis;
use super::params::{CamLaw, Params};
use super::resolved::RibbonLine;
use crate::drives::block;
use crate::drives::cam::{Coefficients, Correction, Law};
use crate::math::{self, RPM};

/// Halvings in the search for a speed: to the last digit of a double.
const HALVINGS: u32 = 60;

/// The cam at one position of the knob. Metres, seconds, Nm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cam {
    correction: Correction,
    law: Coefficients,
    axis: ServoAxis,
    /// Radians of the motor per metre of the roller's surface.
    turn: f64,
    /// Greatest error of the roller between the ends of short blocks, m.
    tolerance: f64,
    position_gain: f64,
    time_constant: f64,
    /// Smear with a constant ratio, mm.
    smear: f64,
}

impl CamLaw {
    fn law(self) -> Option<Law> {
        match self {
            CamLaw::Off => None,
            CamLaw::Polynomial => Some(Law::Polynomial345),
            CamLaw::ModifiedSine => Some(Law::ModifiedSine),
        }
    }
}

/// The cam by a law: with the knob as it is, and at its highest position. None if the contact is as long as the pitch,
/// which leaves no time for a correction.
pub(super) fn by(line: &RibbonLine, law: Law) -> Option<(Cam, Cam)> {
    let p = &line.params;
    let cam = |d: &Derived, axis: &ServoAxis| Cam::new(p, law.coefficients(), d, *axis);
    let pair = || (cam(&line.derived, &line.mechanics.axes.print), cam(&line.fast, &line.fast_mechanics.axes.print));
    (p.contact_length < p.pitch).then(pair)
}

/// The cam by the law of the form.
pub(super) fn chosen(line: &RibbonLine) -> Option<(Cam, Cam)> {
    by(line, line.params.cam_law.law()?)
}

/// Whether a law is chosen, but the contact leaves no time for it.
pub(super) fn has_no_time(line: &RibbonLine) -> bool {
    line.params.cam_law != CamLaw::Off && chosen(line).is_none()
}

/// A figure of the chosen cam with the knob as it is; 0 without a cam.
pub(super) fn now(line: &RibbonLine, figure: fn(&Cam) -> f64) -> f64 {
    chosen(line).map_or(0.0, |(now, _)| figure(&now))
}

impl Cam {
    fn new(p: &Params, law: Coefficients, d: &Derived, axis: ServoAxis) -> Cam {
        Cam {
            correction: Correction {
                pitch: p.pitch / 1e3,
                contact: p.contact_length / 1e3,
                // The arc between two heads is real: the exact π, not that of the program.
                arc: p.head_spacing() / 1e3,
                speed: d.feeds.line_speed / 60e3,
            },
            law,
            axis,
            turn: p.axes.print.gear / (p.print_roller_diameter / 2e3),
            tolerance: p.dot_tolerance / 1e3,
            position_gain: p.axes.print.position_gain,
            time_constant: p.axes.print.time_constant / 1e3,
            smear: d.surface.smear,
        }
    }

    /// Torque at the motor's shaft per acceleration of the roller's surface, Nm per m/s²: `(J_L / η + J_M) i / R`.
    fn inertia(&self) -> f64 {
        self.axis.load.accelerating(self.axis.fitted.motor.rotor, self.turn, 1.0)
    }

    /// Fastest surface speed, m/s: in the contact or in the correction, whichever is greater.
    fn fastest(&self) -> f64 {
        self.correction.speed.max(self.correction.peak_speed(self.law).abs())
    }

    /// Highest speed of the motor, r/min.
    pub(super) fn motor_speed(&self) -> f64 {
        self.fastest() * self.turn / RPM
    }

    /// Highest torque in steady running, Nm: `(J_L / η + J_M) a i / R + T_L`. Source: sizing facts 3.3.
    pub(super) fn peak_torque(&self) -> f64 {
        self.inertia() * self.correction.peak_acceleration(self.law) + self.axis.load.torque
    }

    /// Greatest torque of a start whose ramp ends in a correction, Nm: both accelerations add up, `a + v_max / τ`. Source: sizing facts
    /// 3.3.
    pub(super) fn start_torque(&self) -> f64 {
        self.peak_torque() + self.inertia() * self.fastest() / self.axis.ramp
    }

    /// Effective torque in steady running, Nm: `√(((J_L / η + J_M) a_rms i / R)² + T_L²)`. Source: sizing facts 3.3.
    pub(super) fn effective_torque(&self) -> f64 {
        math::hypot(self.inertia() * self.correction.effective_acceleration(self.law), self.axis.load.torque)
    }

    /// Greatest torque that the limits allow at the highest speed of the motor, Nm.
    pub(super) fn torque_limit(&self) -> f64 {
        self.axis.fitted.short_time_limit(self.motor_speed())
    }

    /// Greatest effective torque that the limits allow on this site at the mean speed of the motor, Nm.
    pub(super) fn effective_torque_limit(&self) -> f64 {
        let mean = self.correction.speed * self.correction.arc / self.correction.pitch * self.turn / RPM;
        self.axis.fitted.continuous_limit(mean)
    }

    /// The cam at another speed of the ribbon, m/s.
    fn at(&self, speed: f64) -> Cam {
        Cam { correction: Correction { speed, ..self.correction }, ..*self }
    }

    /// Highest ribbon speed, mm/min, at which `keeps` holds, up to `most` m/s. The torque grows with the speed and its
    /// limit falls, so that there is one such speed.
    fn speed_within(&self, most: f64, keeps: impl Fn(&Cam) -> bool) -> f64 {
        if !most.is_finite() || keeps(&self.at(most)) {
            return 60e3 * most;
        }
        60e3 * math::last_holding(0.0, most, HALVINGS, |speed| keeps(&self.at(speed)))
    }

    /// Greatest acceleration of the roller's surface up to rated speed, m/s²: the peak torque less the steady torque,
    /// over the inertia.
    fn left(&self) -> f64 {
        let most = self.axis.fitted.limits.peak * self.axis.fitted.motor.peak;
        (most - self.axis.load.torque).max(0.0) / self.inertia()
    }

    /// Highest ribbon speed by the peak torque in steady running, mm/min. Source: checked as E7.
    pub(super) fn speed_by_peak(&self) -> f64 {
        let most = self.correction.speed_at(self.law, self.left());
        self.speed_within(most, |cam| {
            cam.motor_speed() <= cam.axis.fitted.motor.rated_speed || cam.peak_torque() <= cam.torque_limit()
        })
    }

    /// Highest ribbon speed by the torque of a start, mm/min: the root of `a v² + b v = T / J`, because the
    /// acceleration of the correction grows with the square of the speed v, and that of the ramp with v.
    pub(super) fn speed_by_start(&self) -> f64 {
        let left = self.left();
        let per_speed = self.at(1.0).correction;
        let square = per_speed.peak_acceleration(self.law);
        let linear = per_speed.peak_speed(self.law).abs().max(1.0) / self.axis.ramp;
        let most = 2.0 * left / (linear + (linear * linear + 4.0 * square * left).sqrt());
        self.speed_within(most, |cam| {
            cam.motor_speed() <= cam.axis.fitted.motor.rated_speed || cam.start_torque() <= cam.torque_limit()
        })
    }

    /// Highest ribbon speed by the effective torque, mm/min. Source: checked as E8.
    pub(super) fn speed_by_heat(&self) -> f64 {
        let (most, steady) = (self.axis.fitted.stall_limit(), self.axis.load.torque);
        let left = (most * most - steady * steady).max(0.0).sqrt();
        let most = self.correction.speed_at_effective(self.law, left / self.inertia());
        let flat = self.axis.fitted.motor.rated >= self.axis.fitted.motor.stall;
        self.speed_within(most, |cam| {
            let below = flat && cam.motor_speed() <= cam.axis.fitted.motor.rated_speed;
            below || cam.effective_torque() <= cam.effective_torque_limit()
        })
    }

    /// Lead of the roller's surface over the ribbon per pitch, mm; negative for a lag.
    pub(super) fn travel(&self) -> f64 {
        1e3 * self.correction.travel()
    }

    /// Peak surface speed of the correction, mm/min.
    pub(super) fn peak_correction(&self) -> f64 {
        60e3 * self.correction.peak_speed(self.law)
    }

    /// Peak acceleration of the roller's surface, m/s².
    pub(super) fn peak_acceleration(&self) -> f64 {
        self.correction.peak_acceleration(self.law)
    }

    /// Most that the arc may be shorter than the pitch without the roller turning back, mm. Source: checked as E6.
    pub(super) fn longest_lag(&self) -> f64 {
        1e3 * self.correction.longest_lag(self.law)
    }

    /// Short blocks of one correction.
    pub(super) fn blocks(&self) -> f64 {
        self.correction.blocks(self.law, self.tolerance)
    }

    /// Time of a short block, ms.
    pub(super) fn block_time(&self) -> f64 {
        1e3 * self.correction.seconds() / self.blocks()
    }

    /// Highest ribbon speed at which a short block lasts at least `needed` ms, mm/min.
    pub(super) fn speed_by_blocks(&self, needed: f64) -> f64 {
        60.0 * (1e3 * (self.correction.pitch - self.correction.contact)) / (self.blocks() * needed / 1e3)
    }

    /// Share (0 to 1) of a correction by short blocks that the axis follows, after its time constant and servo lag.
    pub(super) fn followed(&self) -> f64 {
        let period = self.correction.pitch / self.correction.speed;
        block::response(period, self.time_constant, self.position_gain)
    }

    /// Remaining smear with short blocks, mm: the smear of the constant ratio, less the share of the correction that the axis follows.
    /// Source: sizing facts 3.5.
    pub(super) fn smear_of_blocks(&self) -> f64 {
        (1.0 - self.followed()) * self.smear
    }
}

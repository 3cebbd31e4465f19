//! A slide with its motor: loads, limits, and the drive of the sizing.

use super::form::SlideParams;
use crate::drives::duty::Strikes;
use crate::drives::inertia::{CM2, Cylinder, STEEL};
use crate::drives::servo::{Acceptance, Servo, WEIGHT_SHARE};
use crate::drives::slide::Slide;
use crate::machines::driven::{DrivenAxis, Fitted, MotorFields};
use crate::machines::machine::Machine;
use crate::machines::scaling::AxisDrive;
use crate::math::{PI, RPM};
use crate::motion::Mover;

/// A lathe with a slide across its work and one along it.
pub(in crate::machines) trait HasSlides: Machine {
    /// The slide of X, then the slide of Z.
    fn slides(&self) -> [ServoSlide; 2];
}

/// A slide with its motor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::machines) struct ServoSlide {
    /// Index of its axis on the control.
    pub at: usize,
    pub slide: Slide,
    pub motor: Servo,
    pub limits: Acceptance,
    /// Greatest ratio of inertias by the form, before that of many starts.
    pub form_inertia_limit: f64,
    /// Share of its continuous torque that the site leaves the motor, 0 to 1.
    pub site_share: f64,
    /// Rapid traverse, mm/min.
    pub rapid: f64,
    /// Time constant of its ramps, s.
    pub ramp: f64,
    /// Greatest force of the cut against the feed, N.
    pub feed_force: f64,
    /// Starts per minute of its passes.
    pub starts_per_minute: f64,
    /// Whether it cuts only on its way down.
    pub cuts_downhill: bool,
}

/// Data common to the slides of a machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::machines) struct SlideMachine {
    /// Efficiency of screw and gear, %.
    pub efficiency: f64,
    /// Time constant of the ramps, ms, and the position gain, 1/s.
    pub ramp: (f64, f64),
    /// Share of its ratings that the site leaves a motor, %.
    pub site_share: f64,
    /// Greatest force of the cut against the feed, N.
    pub feed_force: f64,
    /// Starts per minute of each slide while pass follows pass; see [`starts_per_minute`].
    pub starts_per_minute: f64,
}

/// Starts per minute: `n = 60 z / (Σ s/v + m τ)`, with z starts, m motions, ways s at speeds v without pauses (`seconds`), time constant τ
/// (`ramp`, ms) of linear acceleration after the interpolation. Source: sizing facts 2.3.
pub(in crate::machines) fn starts_per_minute(starts: f64, seconds: f64, (motions, ramp): (f64, f64)) -> f64 {
    let all = seconds + motions * ramp / 1e3;
    if starts > 0.0 && all > 0.0 { 60.0 * starts / all } else { 0.0 }
}

/// Data of a slide's axis that are neither in its form nor given by its screw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::machines) struct SlideAxis {
    /// Index of its axis on the control.
    pub at: usize,
    /// Rapid traverse, mm/min.
    pub rapid: f64,
    /// Angle of the positive direction above the horizontal, degrees.
    pub rise: f64,
    /// Whether it cuts only in its negative direction.
    pub cuts_downhill: bool,
}

impl ServoSlide {
    pub(in crate::machines) fn new(
        form: &SlideParams,
        drive: AxisDrive,
        axis: SlideAxis,
        of: SlideMachine,
    ) -> ServoSlide {
        let metres = |mm: f64| mm / 1e3;
        let screw = Cylinder {
            outer: metres(form.screw_diameter),
            inner: 0.0,
            length: metres(form.screw_length),
            density: STEEL,
        };
        let site_share = of.site_share / 100.0;
        let limits =
            Acceptance { effective: form.effective_limit / 100.0, ..Acceptance::mitsubishi(form.inertia_limit) };
        ServoSlide {
            at: axis.at,
            slide: Slide {
                mass: form.mass,
                friction: form.friction,
                rise: axis.rise * PI / 180.0,
                screw,
                lead: metres(drive.lead),
                gear: drive.gear.0 / drive.gear.1,
                efficiency: of.efficiency / 100.0,
            },
            motor: Servo {
                rated: form.rated,
                stall: form.stall,
                peak: form.peak,
                rated_speed: form.rated_speed,
                top_speed: form.top_speed,
                rotor: form.rotor * CM2,
            },
            form_inertia_limit: form.inertia_limit,
            limits: limits.at_starts(of.starts_per_minute).derated(site_share),
            site_share,
            rapid: axis.rapid,
            // Without a time constant the servo itself rounds the step off: a first-order lag of 1 / K.
            ramp: (of.ramp.0 / 1e3).max(1.0 / of.ramp.1),
            feed_force: of.feed_force,
            starts_per_minute: of.starts_per_minute,
            cuts_downhill: axis.cuts_downhill,
        }
    }

    /// Speed (r/min) of the screw at rapid traverse.
    pub(super) fn screw_speed(&self) -> f64 {
        self.rapid / 1e3 / self.slide.lead
    }

    /// Load inertia over rotor inertia.
    pub(super) fn inertia_ratio(&self) -> f64 {
        self.slide.load().inertia / self.motor.rotor
    }

    /// Speed of the motor at rapid traverse, r/min.
    pub(super) fn rapid_speed(&self) -> f64 {
        self.slide.motor_speed(self.rapid / 1e3)
    }

    /// Steady torque upwards, Nm: friction and weight.
    fn steady(&self) -> f64 {
        let load = self.slide.load();
        load.torque + self.slide.weight() / load.efficiency
    }

    /// Greatest torque of a rapid traverse, Nm: its start upwards.
    pub(super) fn rapid_torque(&self) -> f64 {
        let acceleration = self.slide.load().accelerating(self.motor.rotor, self.rapid_speed() * RPM, self.ramp);
        self.steady() + acceleration
    }

    /// Torque in the cut at its feed, Nm: force of the cut, friction and weight. The other force of the cut, on a slide that stands, counts
    /// like that against the feed.
    pub(super) fn cut_torque(&self) -> f64 {
        match self.cuts_downhill {
            true => self.slide.downhill(self.feed_force).abs(),
            false => self.steady() + self.slide.torque(self.feed_force),
        }
    }

    /// Torque (Nm) that the limits leave the motor for a short time at rapid traverse.
    pub(super) fn rapid_torque_limit(&self) -> f64 {
        self.limits.peak * self.motor.most(self.rapid_speed())
    }

    /// Torque (Nm) that the limits leave the motor continuously at the low speed of a feed.
    pub(super) fn cut_torque_limit(&self) -> f64 {
        self.limits.effective * self.motor.stall
    }

    /// Torque (Nm) that the limits leave the motor for holding a weight.
    pub(super) fn hold_torque_limit(&self) -> f64 {
        WEIGHT_SHARE * self.site_share * self.motor.stall
    }

    /// Seconds of the shortest ramp to rapid traverse; infinite where friction and weight take all torque.
    pub(super) fn shortest_ramp(&self) -> f64 {
        let left = self.rapid_torque_limit() - self.steady();
        match left > 0.0 {
            true => self.slide.load().accelerating(self.motor.rotor, self.rapid_speed() * RPM, 1.0) / left,
            false => f64::INFINITY,
        }
    }

    pub(super) fn driven(&self, id: &'static str, name: &'static str, fields: &'static MotorFields) -> DrivenAxis {
        DrivenAxis {
            id,
            name,
            mover: Mover::Axis(self.at),
            // Radians of the motor per millimetre.
            turn: self.slide.motor_speed(1e-3) * 2.0 * PI,
            load: self.slide.load(),
            hold: 0.0,
            weight: self.slide.weight(),
            strikes: Strikes::default(),
            taut: 0.0,
            cut: Some(self.slide.torque(self.feed_force)),
            lasting: Some(self.cut_torque()),
            starts_per_minute: self.starts_per_minute,
            // Wheels or a belt of the lathe itself.
            gear: None,
            fitted: Fitted { motor: self.motor, limits: self.limits },
            site_share: self.site_share,
            fields: Some(fields),
        }
    }
}

//! A slide with its motor: loads, limits, and the drive of the sizing.

use super::form::SlideParams;
use super::lathe::LatheSlides;
use crate::drives::inertia::{CM2, Cylinder, STEEL};
use crate::drives::servo::{Acceptance, FittedMotor, Servo, WEIGHT_SHARE};
use crate::drives::shaft_motion::Strikes;
use crate::drives::slide::Slide;
use crate::machines::driven::{DrivenAxis, MotorFields};
use crate::machines::machine::Machine;
use crate::math::{self, PI, RPM};
use crate::motion::Mover;
use crate::view::Advice;

/// A lathe with a slide across its work and one along it.
pub(in crate::machines) trait HasSlides: Machine {
    /// The slide of X, then the slide of Z.
    fn slides(&self) -> [ServoSlide; 2];

    /// Highest position (%) of the feed override, and the slides there; none where no knob acts above 100 %.
    fn slides_at_highest_feed(&self) -> Option<(f64, [ServoSlide; 2])>;

    /// Adds a button to an advice: feeds whose cutting force, with the feed override at its highest position, is at
    /// most `share` of the greatest force. No button if no such feed is known.
    fn with_feeds_of_force(&self, share: f64, advice: Advice) -> Advice;
}

/// A slide with its motor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::machines) struct ServoSlide {
    /// Index of its axis on the control.
    pub axis: usize,
    pub slide: Slide,
    pub fitted: FittedMotor,
    /// Greatest ratio of inertias by the form, before the reduction for many starts.
    pub form_inertia_limit: f64,
    /// Share of its continuous torque that the site leaves the motor, 0 to 1.
    pub site_share: f64,
    /// Rapid traverse, mm/min.
    pub rapid: f64,
    /// Greatest feed, mm/min.
    pub clamp: f64,
    /// Time constant of its ramps, s.
    pub ramp: f64,
    /// Greatest force of the cut against the feed, N.
    pub feed_force: f64,
    /// Starts per minute of its passes.
    pub starts_per_minute: f64,
    /// Whether it cuts only on its way down.
    pub cuts_downhill: bool,
}

/// Indices of the axes of the slides on the control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::machines) struct SlideAxes {
    pub x: usize,
    pub z: usize,
}

/// Passes of the slides that follow one another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::machines) struct SlidePasses {
    /// Starts from rest.
    pub starts: f64,
    /// Motions, each with its ramps.
    pub motions: f64,
    /// Time of all motions without their ramps, s.
    pub seconds: f64,
}

/// Duty of the slides by the work of their lathe.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::machines) struct SlideDuty {
    pub axes: SlideAxes,
    /// Share of its ratings that the site leaves a motor, %.
    pub site_share: f64,
    /// Greatest force of the cut, N.
    pub cutting_force: f64,
    /// Starts per minute of each slide while pass follows pass; see [`SlidePasses::starts_per_minute`].
    pub starts_per_minute: f64,
    /// Whether X cuts only in its negative direction, down its inclined way.
    pub x_cuts_downhill: bool,
}

impl SlidePasses {
    /// Starts per minute: `n = 60 z / (Σ s/v + m τ)`, with z starts, m motions, ways s at speeds v without pauses (`seconds`), time constant τ
    /// (`ramp`, ms) of linear acceleration after the interpolation. Source: sizing facts 2.3.
    pub(in crate::machines) fn starts_per_minute(&self, ramp: f64) -> f64 {
        let all = self.seconds + self.motions * ramp / 1e3;
        if self.starts > 0.0 && all > 0.0 { 60.0 * self.starts / all } else { 0.0 }
    }
}

/// A slide's place on its lathe.
struct SlidePlace {
    /// Index of its axis on the control.
    axis: usize,
    /// Angle of the positive direction above the horizontal, degrees.
    inclination_degrees: f64,
    /// Whether it cuts only in its negative direction.
    cuts_downhill: bool,
}

impl LatheSlides {
    /// X and Z with their motors under a duty.
    pub(in crate::machines) fn servos(&self, duty: SlideDuty) -> [ServoSlide; 2] {
        let x =
            SlidePlace { axis: duty.axes.x, inclination_degrees: self.bed_angle, cuts_downhill: duty.x_cuts_downhill };
        let z = SlidePlace { axis: duty.axes.z, inclination_degrees: 0.0, cuts_downhill: false };
        [self.servo(&self.x, x, duty), self.servo(&self.z, z, duty)]
    }

    fn servo(&self, form: &SlideParams, place: SlidePlace, duty: SlideDuty) -> ServoSlide {
        let metres = |mm: f64| mm / 1e3;
        let screw = Cylinder {
            outer: metres(form.screw_diameter),
            inner: 0.0,
            length: metres(form.screw_length),
            density: STEEL,
        };
        let site_share = duty.site_share / 100.0;
        let limits = Acceptance::of_form(form.inertia_limit, form.effective_limit);
        ServoSlide {
            axis: place.axis,
            slide: Slide {
                mass: form.mass,
                friction: form.friction,
                inclination: place.inclination_degrees * PI / 180.0,
                screw,
                lead: metres(form.lead),
                gear: form.screw_teeth / form.motor_teeth,
                efficiency: self.efficiency / 100.0,
            },
            fitted: FittedMotor {
                motor: Servo {
                    rated: form.rated,
                    stall: form.stall,
                    peak: form.peak,
                    rated_speed: form.rated_speed,
                    top_speed: form.top_speed,
                    rotor: form.rotor * CM2,
                },
                limits: limits.at_starts(duty.starts_per_minute).derated(site_share),
            },
            form_inertia_limit: form.inertia_limit,
            site_share,
            rapid: form.rapid,
            clamp: form.clamp,
            ramp: self.ramp(),
            feed_force: duty.cutting_force * self.feed_force / 100.0,
            starts_per_minute: duty.starts_per_minute,
            cuts_downhill: place.cuts_downhill,
        }
    }
}

impl ServoSlide {
    /// Speed (r/min) of the screw at rapid traverse.
    pub(super) fn screw_speed(&self) -> f64 {
        self.rapid / 1e3 / self.slide.lead
    }

    /// Load inertia over rotor inertia.
    pub(super) fn inertia_ratio(&self) -> f64 {
        self.slide.load().inertia / self.fitted.motor.rotor
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
        let acceleration = self.slide.load().accelerating(self.fitted.motor.rotor, self.rapid_speed() * RPM, self.ramp);
        self.steady() + acceleration
    }

    /// Torque in the cut at its feed, Nm: force of the cut, friction and weight. The cutting force across the feed, on
    /// the slide at standstill, counts like that against the feed.
    pub(super) fn cut_torque(&self) -> f64 {
        if self.cuts_downhill {
            self.slide.downhill(self.feed_force).abs()
        } else {
            self.steady() + self.slide.torque(self.feed_force)
        }
    }

    /// Greatest share of the cutting force at which the torque stays within the limit; none if friction and weight
    /// alone exceed it.
    pub(super) fn force_share(&self) -> Option<f64> {
        let with = |share: f64| ServoSlide { feed_force: share * self.feed_force, ..*self };
        math::greatest_share(0.0, |share| with(share).cut_torque() <= self.cut_torque_limit())
    }

    /// Torque (Nm) that the limits leave the motor for a short time at rapid traverse.
    pub(super) fn rapid_torque_limit(&self) -> f64 {
        self.fitted.short_time_limit(self.rapid_speed())
    }

    /// Torque (Nm) that the limits leave the motor continuously at the low speed of a feed.
    pub(super) fn cut_torque_limit(&self) -> f64 {
        self.fitted.stall_limit()
    }

    /// Torque (Nm) that the limits leave the motor for holding a weight.
    pub(super) fn hold_torque_limit(&self) -> f64 {
        WEIGHT_SHARE * self.site_share * self.fitted.motor.stall
    }

    /// Seconds of the shortest ramp to rapid traverse; infinite where friction and weight take all torque.
    pub(super) fn shortest_ramp(&self) -> f64 {
        let left = self.rapid_torque_limit() - self.steady();
        if left > 0.0 {
            self.slide.load().accelerating(self.fitted.motor.rotor, self.rapid_speed() * RPM, 1.0) / left
        } else {
            f64::INFINITY
        }
    }

    pub(super) fn driven(&self, id: &'static str, name: &'static str, fields: &'static MotorFields) -> DrivenAxis {
        DrivenAxis {
            id,
            name,
            mover: Mover::Axis(self.axis),
            // Radians of the motor per millimetre.
            radians_per_unit: self.slide.motor_speed(1e-3) * 2.0 * PI,
            load: self.slide.load(),
            standstill_torque: 0.0,
            weight: self.slide.weight(),
            strikes: Strikes::default(),
            taut_torque: 0.0,
            cut: Some(self.slide.torque(self.feed_force)),
            continuous_cut_torque: Some(self.cut_torque()),
            starts_per_minute: self.starts_per_minute,
            // Wheels or a belt of the lathe itself.
            gear: None,
            fitted: self.fitted,
            site_share: self.site_share,
            fields: Some(fields),
        }
    }
}

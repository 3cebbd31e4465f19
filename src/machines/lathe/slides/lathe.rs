//! The slides of a lathe, X across its work and Z along it: parameters, rows of the form, drives, axes of the plant.

use super::form::{self, SlideParams};
use crate::controls::Address;
use crate::drives::block;
use crate::machines::driven::scaling::{self, AxisDrive, GearTurns};
use crate::machines::form::Field;
use crate::machines::sheets::{self, ParamValues, ServoSettings};
use crate::motion::AxisPlant;

/// The slide across the work, and the one along it.
pub(in crate::machines) const CROSS: Address = Address::X;
pub(in crate::machines) const ALONG: Address = Address::Z;

/// In-position width of the slides, mm (assumed: the form does not ask for it).
pub(in crate::machines) const IN_POSITION: f64 = 0.02;

/// Inputs of both slides of a lathe. Units as in the form.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::machines) struct LatheSlides {
    pub x: SlideParams,
    pub z: SlideParams,
    pub time_constant: f64,
    pub position_gain: f64,
    pub bed_angle: f64,
    pub efficiency: f64,
    pub feed_force: f64,
}

/// Parameters of a machine with the slides of a lathe among them.
pub(in crate::machines) trait SlideForm: 'static {
    fn lathe_slides(&self) -> &LatheSlides;

    fn lathe_slides_mut(&mut self) -> &mut LatheSlides;
}

/// Defaults of the slide of X that depend on the machine: with the tool or cutter that it carries.
#[derive(Debug, Clone, Copy)]
pub(in crate::machines) struct XDefaults {
    /// Mass, kg.
    pub mass: f64,
    /// Friction along its way, N.
    pub friction: f64,
}

/// The member of the slides that a row fills; of a text with `&`.
macro_rules! member {
    ($($member:ident).+) => {
        (|p: &P| p.lathe_slides().$($member).+, |p: &mut P, value| p.lathe_slides_mut().$($member).+ = value)
    };
    (&$($member:ident).+) => {
        (|p: &P| p.lathe_slides().$($member).+.as_str(), |p: &mut P, text| p.lathe_slides_mut().$($member).+ = text)
    };
}

/// Screws, gears and encoders, in a group of the machine. Rapid traverse, clamps, time constant and gain are rows of the machine, which
/// explains them in its own words.
#[rustfmt::skip]
pub(in crate::machines) const fn scaling_rows<P: SlideForm>(group: &'static str) -> [Field<P>; 8] {
    [
        scaling::lead("lead-x", group, "scaling.lead-x", member!(x.lead)),
        scaling::lead("lead-z", group, "scaling.lead-z", member!(z.lead)),
        scaling::teeth("motor-teeth-x", group, "scaling.motor-teeth-x", member!(x.motor_teeth)),
        scaling::teeth("screw-teeth-x", group, "scaling.screw-teeth-x", member!(x.screw_teeth)),
        scaling::teeth("motor-teeth-z", group, "scaling.motor-teeth-z", member!(z.motor_teeth)),
        scaling::teeth("screw-teeth-z", group, "scaling.screw-teeth-z", member!(z.screw_teeth)),
        scaling::encoder("encoder-counts-x", group, "scaling.encoder-x", member!(x.encoder)),
        scaling::encoder("encoder-counts-z", group, "scaling.encoder-z", member!(z.encoder)),
    ]
}

/// Masses and ways, then the motors.
#[rustfmt::skip]
pub(in crate::machines) const fn rows<P: SlideForm>(x: XDefaults) -> [Field<P>; 29] {
    [
        form::mass("slide-mass-x", "slides.mass-x", x.mass, member!(x.mass)),
        form::friction("slide-friction-x", "slides.friction-x", x.friction, member!(x.friction)),
        form::screw_diameter("screw-diameter-x", "slides.screw-diameter-x", 32.0, member!(x.screw_diameter)),
        form::screw_length("screw-length-x", "slides.screw-length-x", 500.0, member!(x.screw_length)),
        form::mass("slide-mass-z", "slides.mass-z", 250.0, member!(z.mass)),
        form::friction("slide-friction-z", "slides.friction-z", 250.0, member!(z.friction)),
        form::screw_diameter("screw-diameter-z", "slides.screw-diameter-z", 40.0, member!(z.screw_diameter)),
        form::screw_length("screw-length-z", "slides.screw-length-z", 1000.0, member!(z.screw_length)),
        form::bed_angle(member!(bed_angle)),
        form::efficiency(member!(efficiency)),
        form::feed_force(member!(feed_force)),
        form::motor("motor-x", "slides.motor-x", member!(&x.motor)).group(form::MOTOR_GROUPS[0]),
        form::rated("motor-rated-torque-x", "slides.motor-rated-torque-x", 4.8, member!(x.rated)).group(form::MOTOR_GROUPS[0]),
        form::stall("motor-stall-x", "slides.motor-stall-x", 4.8, member!(x.stall)).group(form::MOTOR_GROUPS[0]),
        form::peak("motor-peak-x", "slides.motor-peak-x", 14.3, member!(x.peak)).group(form::MOTOR_GROUPS[0]),
        form::rotor("motor-rotor-x", "slides.motor-rotor-x", 11.6, member!(x.rotor)).group(form::MOTOR_GROUPS[0]),
        form::rated_speed("motor-rated-x", "slides.motor-rated-x", 2000.0, member!(x.rated_speed)).group(form::MOTOR_GROUPS[0]),
        form::top_speed("motor-max-x", "slides.motor-max-x", 3000.0, member!(x.top_speed)).group(form::MOTOR_GROUPS[0]),
        form::inertia_limit("inertia-limit-x", "slides.inertia-limit-x", member!(x.inertia_limit)).group(form::MOTOR_GROUPS[0]),
        form::effective_limit("effective-limit-x", "slides.effective-limit-x", member!(x.effective_limit)).group(form::MOTOR_GROUPS[0]),
        form::motor("motor-z", "slides.motor-z", member!(&z.motor)).group(form::MOTOR_GROUPS[1]),
        form::rated("motor-rated-torque-z", "slides.motor-rated-torque-z", 4.8, member!(z.rated)).group(form::MOTOR_GROUPS[1]),
        form::stall("motor-stall-z", "slides.motor-stall-z", 4.8, member!(z.stall)).group(form::MOTOR_GROUPS[1]),
        form::peak("motor-peak-z", "slides.motor-peak-z", 14.3, member!(z.peak)).group(form::MOTOR_GROUPS[1]),
        form::rotor("motor-rotor-z", "slides.motor-rotor-z", 11.6, member!(z.rotor)).group(form::MOTOR_GROUPS[1]),
        form::rated_speed("motor-rated-z", "slides.motor-rated-z", 2000.0, member!(z.rated_speed)).group(form::MOTOR_GROUPS[1]),
        form::top_speed("motor-max-z", "slides.motor-max-z", 3000.0, member!(z.top_speed)).group(form::MOTOR_GROUPS[1]),
        form::inertia_limit("inertia-limit-z", "slides.inertia-limit-z", member!(z.inertia_limit)).group(form::MOTOR_GROUPS[1]),
        form::effective_limit("effective-limit-z", "slides.effective-limit-z", member!(z.effective_limit)).group(form::MOTOR_GROUPS[1]),
    ]
}

impl LatheSlides {
    /// Duration (s) of a slide's ramp; the same to rapid traverse and to its greatest feed.
    pub(super) fn ramp(&self) -> f64 {
        block::ramp(self.time_constant / 1e3, self.position_gain)
    }

    /// Parameters of both slides. The greatest acceleration is the one for which the torque of the motors is sized.
    pub(in crate::machines) fn parameters(&self, x_counts_diameters: bool) -> ParamValues<'static> {
        let settings = |axis, slide: &SlideParams| ServoSettings {
            axis,
            rapid: slide.rapid,
            clamp: slide.clamp,
            time_constant: self.time_constant,
            position_gain: self.position_gain,
            acceleration: block::greatest_acceleration(slide.rapid, slide.clamp, self.ramp()),
        };
        sheets::servo_axes(&[settings("X", &self.x), settings("Z", &self.z)], x_counts_diameters, IN_POSITION)
    }

    /// Drives of X and Z. Words of X count `x_per_mm` units per millimetre of its slide: 2 for diameters.
    pub(in crate::machines) fn drives(&self, x_per_mm: f64) -> [AxisDrive; 2] {
        [self.x.drive("X", x_per_mm), self.z.drive("Z", 1.0)]
    }

    /// Axes of X and Z in the plant. `home`: positions (mm) of both at power-on.
    pub(in crate::machines) fn plants(&self, x_counts_diameters: bool, home: [f64; 2]) -> Vec<AxisPlant> {
        let plant = |letter, diameter, slide: &SlideParams, home| AxisPlant {
            letter: Some(letter),
            rotary: false,
            endless: false,
            diameter,
            rapid: slide.rapid,
            clamp: slide.clamp,
            time_constant: self.time_constant / 1000.0,
            position_gain: self.position_gain,
            home,
        };
        vec![plant(CROSS, x_counts_diameters, &self.x, home[0]), plant(ALONG, false, &self.z, home[1])]
    }
}

impl SlideParams {
    fn drive(&self, axis: &'static str, words: f64) -> AxisDrive {
        let gear = GearTurns { motor: self.screw_teeth, load: self.motor_teeth };
        AxisDrive { axis, lead: self.lead, gear, encoder: self.encoder, rotary: false, words }
    }
}

//! The slides of a lathe, on ball screws: their form, their motors, their loads, and the results that judge them.

mod form;
mod results;
mod servo;

pub(super) use form::{
    MOTORS, SlideParams, bed_angle, effective_limit, efficiency, feed_force, friction, inertia_limit, mass, motor,
    peak, rated, rated_speed, rotor, screw_diameter, screw_length, stall, top_speed,
};
pub(super) use results::results;
pub(super) use servo::{HasSlides, ServoSlide, SlideAxis, SlideMachine, starts_per_minute};

use super::driven::DrivenAxis;

/// The motors of the slides, for the sizing.
pub(super) fn axes(machine: &impl HasSlides) -> Vec<DrivenAxis> {
    let [x, z] = machine.slides();
    vec![x.driven("x", form::NAMES[0], &form::FIELDS[0]), z.driven("z", form::NAMES[1], &form::FIELDS[1])]
}

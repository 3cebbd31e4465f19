//! The slides of a lathe, on ball screws: their form, their motors, their loads, and the results that judge them.

mod form;
mod lathe;
mod results;
mod servo;

pub(super) use form::MOTORS;
pub(super) use lathe::{ALONG, CROSS, LatheSlides, SlideForm, XDefaults, rows, scaling_rows};
pub(super) use results::results;
pub(super) use servo::{HasSlides, ServoSlide, SlideDuty, starts_per_minute};

use super::driven::DrivenAxis;

/// The motors of the slides, for the sizing.
pub(super) fn axes(machine: &impl HasSlides) -> Vec<DrivenAxis> {
    let [x, z] = machine.slides();
    vec![x.driven("x", form::NAMES[0], &form::FIELDS[0]), z.driven("z", form::NAMES[1], &form::FIELDS[1])]
}

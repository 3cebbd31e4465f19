//! The slides of a lathe, on ball screws: their form, their motors, their loads, and the results that judge them.

mod form;
mod lathe;
mod results;
mod servo;

pub(in crate::machines) use form::MOTORS;
pub(in crate::machines) use lathe::{ALONG, CROSS, IN_POSITION, LatheSlides, SlideForm, XDefaults, rows, scaling_rows};
pub(in crate::machines) use results::results;
pub(in crate::machines) use servo::{HasSlides, ServoSlide, SlideAxes, SlideDuty, SlidePasses};

use crate::machines::driven::DrivenAxis;
use crate::machines::driven::devices::{AskedDevice, reference_switch};

/// The motors of the slides, for the sizing.
pub(in crate::machines) fn axes(machine: &impl HasSlides) -> Vec<DrivenAxis> {
    let [x, z] = machine.slides();
    vec![x.driven("x", form::NAMES[0], &form::FIELDS[0]), z.driven("z", form::NAMES[1], &form::FIELDS[1])]
}

/// The switches of their zero returns.
pub(in crate::machines) fn reference_switches() -> [AskedDevice; 2] {
    form::NAMES.map(reference_switch)
}

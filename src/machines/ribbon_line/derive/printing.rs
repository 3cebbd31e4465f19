//! The print roller on the ribbon: speed of its surface, smear, and the diameter, heads or pitch with which both speeds are equal.

use super::feeds::LineFeeds;
use crate::drives::web;
use crate::machines::ribbon_line::params::Params;
use crate::math::PI;

/// Surface of the print roller compared with the ribbon: its speed, the smear, and the rollers without smear.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::ribbon_line) struct PrintSurface {
    /// mm/min.
    pub speed: f64,
    /// Speed of the surface over the ribbon's.
    pub ratio: f64,
    /// mm.
    pub smear: f64,
    /// Diameter (mm), number of heads or pitch (mm) with which surface and ribbon have the same speed.
    pub matching_diameter: f64,
    pub matching_heads: f64,
    pub matching_pitch: f64,
}

impl PrintSurface {
    pub(super) fn new(p: &Params, feeds: &LineFeeds) -> PrintSurface {
        let ratio = p.printed_arc() / p.pitch;
        PrintSurface {
            speed: feeds.line_speed * p.printed_arc() / p.pitch,
            ratio,
            smear: web::smear(ratio, p.contact_length),
            matching_diameter: p.heads * p.pitch / PI,
            matching_heads: PI * p.print_roller_diameter / p.pitch,
            matching_pitch: p.head_spacing(),
        }
    }
}

impl Params {
    /// Room (mm) between two heads on the circumference of the print roller; negative where they overlap.
    pub(in crate::machines::ribbon_line) fn head_gap(&self) -> f64 {
        self.head_spacing() - self.head.length
    }
}

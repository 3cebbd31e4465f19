//! The product: its pitches, its length and its time.

use super::timing::LineTiming;
use crate::machines::ribbon_line::params::{Job, Params, Rest};
use crate::math;

/// Tolerance, in pitches, within which a length counts as a whole number of pitches.
pub(in crate::machines::ribbon_line) const PITCH_TOLERANCE: f64 = 0.0001;

/// Shortest last pitch, mm: half a command increment.
pub(in crate::machines::ribbon_line) const SHORTEST: f64 = 0.0005;

/// A product and its time.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::ribbon_line) struct Product {
    pub dots: f64,
    /// mm.
    pub length: f64,
    /// s.
    pub time: f64,
}

impl Product {
    pub(super) fn new(p: &Params, timing: &LineTiming) -> Product {
        Product { dots: p.count(), length: p.printed_length(), time: timing.product }
    }
}

impl Params {
    /// Whole pitches of a product: the count itself, or the length over the pitch, at least 1.
    pub(in crate::machines::ribbon_line) fn count(&self) -> f64 {
        match self.job {
            Job::Pitches => self.pitch_count,
            Job::Length => math::clamp(self.pitches_of_length(), 1.0, 1e7),
        }
    }

    /// Whole pitches of the wanted length by the rule for its rest, as the program counts them.
    pub(in crate::machines::ribbon_line) fn pitches_of_length(&self) -> f64 {
        let pitches = self.product_length / self.pitch;
        if self.rest == Rest::Shorten { (pitches + PITCH_TOLERANCE).floor() } else { pitches.round() }
    }

    /// Length of the shorter last pitch of a product, mm; 0 where there is none.
    pub(in crate::machines::ribbon_line) fn last_pitch(&self) -> f64 {
        if self.job == Job::Length && self.rest == Rest::Shorten {
            let left = self.product_length - self.count() * self.pitch;
            if left > SHORTEST { left } else { 0.0 }
        } else {
            0.0
        }
    }

    /// Length of a product, mm: its whole pitches, and a shorter last one.
    pub(super) fn printed_length(&self) -> f64 {
        self.count() * self.pitch + self.last_pitch()
    }

    /// Length of a product less the entered one, mm; 0 if the product is entered as a number of pitches.
    pub(in crate::machines::ribbon_line) fn length_error(&self) -> f64 {
        if self.job == Job::Length { self.printed_length() - self.product_length } else { 0.0 }
    }
}

//! Tension of the ribbon before X: by a draw, or after a start from an empty loop.

use super::slack::Slack;
use super::unwinder::UnwinderSpeed;
use crate::drives::web;
use crate::machines::ribbon_line::params::Params;

/// Tension (N) of a ribbon that is tight.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::ribbon_line) struct Tension {
    /// By a draw: X is faster than the unwinder.
    pub draw: f64,
    /// After a start that misses ribbon; 0 if none is missing.
    pub start: f64,
    /// Tension at which the ribbon tears.
    pub breaking: f64,
    /// Allowed tension: half of that.
    pub allowed: f64,
}

impl Tension {
    pub(super) fn new(p: &Params, unwinder: &UnwinderSpeed, slack: &Slack) -> Tension {
        // Under a feed per revolution X follows the measured speed of the unwinder: no draw but that of the thickness.
        let slip = if p.feeds_per_revolution() { 0.0 } else { -unwinder.error.min(unwinder.error_rated) };
        let draw = (slip - p.laid_by_thickness()).max(0.0);
        let breaking = p.tensile_strength * p.ribbon_area();
        Tension {
            draw: p.force_per_strain() * draw,
            start: if slack.missing > 0.0 { p.tension_with_missing(slack.missing) } else { 0.0 },
            breaking,
            allowed: 0.5 * breaking,
        }
    }

    /// Greatest tension of the ribbon before X: `T1`, with a draw, or after a start.
    pub(in crate::machines::ribbon_line) fn greatest(&self, p: &Params) -> f64 {
        self.with_draw(p).max(self.start)
    }

    /// Tension of the ribbon before X with a draw: `T1 + E · A · draw`.
    pub(in crate::machines::ribbon_line) fn with_draw(&self, p: &Params) -> f64 {
        p.web.tension_before + self.draw
    }
}

impl Params {
    /// Cross-section of the ribbon, mm².
    pub(in crate::machines::ribbon_line) fn ribbon_area(&self) -> f64 {
        self.ribbon_width * self.ribbon_thickness
    }

    /// Force (N) per unit of strain of the ribbon: `E · A`.
    pub(in crate::machines::ribbon_line) fn force_per_strain(&self) -> f64 {
        web::draw_tension(self.youngs_modulus, self.ribbon_area(), 1.0)
    }

    /// Tension (N) of the ribbon before X where some of it (mm) is missing: `T = T1 + E · A · s / L`, with the tension T1 that it has anyway,
    /// and its free length L before X. Source: ribbon line facts, 7.
    pub(in crate::machines::ribbon_line) fn tension_with_missing(&self, missing: f64) -> f64 {
        self.web.tension_before + self.force_per_strain() * missing / self.web.span
    }
}

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
    /// Limit: half of the tension at which the ribbon tears.
    pub limit: f64,
}

impl Tension {
    pub(super) fn new(p: &Params, unwinder: &UnwinderSpeed, slack: &Slack) -> Tension {
        let area = p.ribbon_width * p.ribbon_thickness;
        // Under a feed per revolution X follows the measured speed of the unwinder: no draw but that of the thickness.
        let slip = if p.feeds_per_revolution() { 0.0 } else { -unwinder.error.min(unwinder.error_rated) };
        let draw = (slip - p.laid_by_thickness()).max(0.0);
        Tension {
            draw: web::draw_tension(p.youngs_modulus, area, draw),
            start: start_tension(p, area, slack.missing),
            limit: 0.5 * p.tensile_strength * area,
        }
    }

    /// Greatest tension of a tight ribbon, by a draw or after a start.
    pub(in crate::machines::ribbon_line) fn excess(&self) -> f64 {
        self.draw.max(self.start)
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

/// Tension (N) of a ribbon of cross-section A (mm²) that has `missing` mm too little after a start: `T = E · A · |s| / L + T1`, with the
/// modulus E (N/mm²), the free length L (mm) before X and the tension T1 (N) that it has anyway. Source: ribbon line facts, 7.
fn start_tension(p: &Params, area: f64, missing: f64) -> f64 {
    let strain = missing / p.web.span;
    if missing > 0.0 { web::draw_tension(p.youngs_modulus, area, strain) + p.web.tension_before } else { 0.0 }
}

//! Errors of length and register, and the resolution of both axes.

use super::feeds::LineFeeds;
use super::timing::LineTiming;
use crate::machines::ribbon_line::params::Params;
use crate::math::PI;

/// Errors and resolutions. Lengths in mm unless noted.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::ribbon_line) struct Accuracy {
    /// Error of the ribbon's speed by the π of the program, mm/min.
    pub pi_drift: f64,
    /// Greater one of both rollers, %.
    pub thickness_error: f64,
    /// Lag of Y behind X at full speed.
    pub register_error: f64,
    /// µm.
    pub x_resolution: f64,
    /// µm.
    pub y_resolution: f64,
    /// mm or ° per shift.
    pub y_drift: f64,
}

impl Accuracy {
    pub(super) fn new(p: &Params, feeds: &LineFeeds, timing: &LineTiming) -> Accuracy {
        let (tau_x, tau_y) = (p.time_constant_x / 1000.0, p.time_constant_y / 1000.0);
        // e = v · ((τx - τy)/2 + 1/Kx - 1/Ky)  [mm]: difference of ramp and servo lag at full speed.
        let lag = (tau_x - tau_y) / 2.0 + 1.0 / p.position_gain_x - 1.0 / p.position_gain_y;
        Accuracy {
            pi_drift: (PI / p.program_pi() - 1.0) * feeds.line_speed,
            thickness_error: thickness_error(p),
            register_error: feeds.mm_per_second() * lag,
            x_resolution: PI * p.x_roller_diameter / p.gear_x / p.encoder_x * 1000.0,
            y_resolution: PI * p.print_roller_diameter / p.gear_y / p.encoder_y * 1000.0,
            y_drift: y_drift(feeds.y_stroke, timing.pitch),
        }
    }
}

/// Length error (%) of diameters entered without the ribbon's thickness, of the smaller roller: `t / D · 100`. Source: sizing facts D22.
fn thickness_error(p: &Params) -> f64 {
    let smaller = p.press_roller_diameter.min(p.x_roller_diameter);
    if p.effective_diameter { 0.0 } else { p.ribbon_thickness / smaller * 100.0 }
}

/// Drift of Y in mm (or °) per shift of eight hours if the control only rounded each stroke to 0.001. The programs
/// carry the remainder and avoid it. Source: ribbon line facts, 3.
fn y_drift(stroke: f64, pitch_time: f64) -> f64 {
    let rounded = (stroke * 1000.0).round() / 1000.0;
    (rounded - stroke) * 8.0 * 3600.0 / pitch_time
}

//! Errors of length and register, and the resolution of both axes.

use super::feeds::LineFeeds;
use super::timing::LineTiming;
use crate::machines::ribbon_line::axes::PerAxis;
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
    /// Travel per pulse of the encoder, µm.
    pub resolutions: PerAxis<f64>,
    /// mm or ° per shift.
    pub y_drift: f64,
}

impl Accuracy {
    pub(super) fn new(p: &Params, feeds: &LineFeeds, timing: &LineTiming) -> Accuracy {
        let PerAxis { pull, print } = &p.axes;
        let (tau_x, tau_y) = (pull.time_constant / 1000.0, print.time_constant / 1000.0);
        // e = v · ((τx - τy)/2 + 1/Kx - 1/Ky)  [mm]: difference of ramp and servo lag at full speed.
        let lag = (tau_x - tau_y) / 2.0 + 1.0 / pull.position_gain - 1.0 / print.position_gain;
        Accuracy {
            pi_drift: (PI / p.program_pi() - 1.0) * feeds.line_speed,
            thickness_error: thickness_error(p),
            register_error: feeds.mm_per_second() * lag,
            resolutions: PerAxis {
                pull: PI * p.x_roller_diameter / p.axes.pull.gear / p.axes.pull.encoder * 1000.0,
                print: PI * p.print_roller_diameter / p.axes.print.gear / p.axes.print.encoder * 1000.0,
            },
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

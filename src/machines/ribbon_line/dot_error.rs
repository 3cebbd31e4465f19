//! The error of a dot's place, in mm: lasting parts add up, parts that vary from dot to dot add as the root of the sum of their squares.

use super::mechanics::ServoAxis;
use super::resolved::RibbonLine;
use crate::math::{self, PI};

/// Parts of the error, each in mm and without sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DotError {
    /// Half a pulse of both encoders.
    pub encoders: f64,
    /// Run-out of both rollers.
    pub run_out: f64,
    /// Backlash of the gears whose torque changes its sign.
    pub backlash: f64,
    /// Lead or lag of X to the print roller.
    pub lag: f64,
    /// Shortening of a pitch that was printed under tension.
    pub strain: f64,
}

impl DotError {
    /// The parts with the line at the speed of its results.
    pub(super) fn of(line: &RibbonLine) -> DotError {
        let RibbonLine { params: p, derived: d, mechanics, .. } = line;
        let half_pulse = |micrometres: f64| micrometres / 2e3;
        // Minutes of arc at the roller.
        let play = |axis: &ServoAxis, diameter: f64| {
            if axis.reverses(p.path_mode) { p.gear_backlash / 60.0 * PI / 180.0 * diameter / 2.0 } else { 0.0 }
        };
        let pull = play(&mechanics.pull, p.x_roller_diameter);
        let print = play(&mechanics.print, p.print_roller_diameter);
        DotError {
            encoders: math::hypot(half_pulse(d.accuracy.x_resolution), half_pulse(d.accuracy.y_resolution)),
            run_out: math::hypot(p.roller_run_out / 2.0, p.roller_run_out / 2.0),
            backlash: math::hypot(pull, print),
            lag: d.accuracy.register_error.abs(),
            strain: p.pitch * strain(line),
        }
    }

    /// Parts that vary from dot to dot, together.
    pub(super) fn varying(&self) -> f64 {
        math::hypot(math::hypot(self.encoders, self.run_out), self.backlash)
    }

    /// Parts that last, together.
    pub(super) fn lasting(&self) -> f64 {
        self.lag + self.strain
    }

    /// All parts together.
    pub(super) fn total(&self) -> f64 {
        self.lasting() + self.varying()
    }

    /// The greatest part.
    pub(super) fn greatest(&self) -> (ErrorSource, f64) {
        let others = [
            (ErrorSource::Encoders, self.encoders),
            (ErrorSource::Backlash, self.backlash),
            (ErrorSource::Lag, self.lag),
            (ErrorSource::Strain, self.strain),
        ];
        others
            .into_iter()
            .fold((ErrorSource::RunOut, self.run_out), |most, part| if part.1 > most.1 { part } else { most })
    }
}

/// A source of the error of a dot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ErrorSource {
    /// Pulses of the encoders.
    Encoders,
    /// Run-out of the rollers.
    RunOut,
    /// Backlash of the gears.
    Backlash,
    /// Difference of the servo lags.
    Lag,
    /// Strain of the ribbon.
    Strain,
}

impl ErrorSource {
    /// Catalog id of its name.
    pub(super) fn name(self) -> &'static str {
        match self {
            ErrorSource::Encoders => "ribbon.readout.dot-encoders",
            ErrorSource::RunOut => "ribbon.readout.dot-run-out",
            ErrorSource::Backlash => "ribbon.readout.dot-backlash",
            ErrorSource::Lag => "ribbon.readout.register-error",
            ErrorSource::Strain => "ribbon.readout.dot-strain",
        }
    }
}

/// Strain with which the pull rollers draw the ribbon: that of the tension before them. A turn of theirs passes on as much of it, whatever
/// the tension behind, so that the dots stand closer by it when the ribbon is slack again. Source: sizing facts 2.6, `v₁T₁ - v₂T₂`.
pub(super) fn strain(line: &RibbonLine) -> f64 {
    let p = &line.params;
    p.web.tension_before / (p.youngs_modulus * p.ribbon_width * p.ribbon_thickness)
}

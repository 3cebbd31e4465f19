//! The position error of a dot, in mm: systematic parts are added, parts that vary from dot to dot as the root of the sum of their squares.

use super::derive::Derived;
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
    /// The parts at the speed of the line's results.
    pub(super) fn of(line: &RibbonLine) -> DotError {
        let RibbonLine { params: p, derived: d, mechanics, .. } = line;
        let half_pulse = |micrometres: f64| micrometres / 2e3;
        // Minutes of arc at the roller.
        let play = |axis: &ServoAxis, diameter: f64| {
            if axis.reverses(p.path_mode) { p.gear_backlash / 60.0 * PI / 180.0 * diameter / 2.0 } else { 0.0 }
        };
        let pull = play(&mechanics.axes.pull, p.x_roller_diameter);
        let print = play(&mechanics.axes.print, p.print_roller_diameter);
        DotError {
            encoders: math::hypot(half_pulse(d.accuracy.resolutions.pull), half_pulse(d.accuracy.resolutions.print)),
            run_out: math::hypot(p.roller_run_out / 2.0, p.roller_run_out / 2.0),
            backlash: math::hypot(pull, print),
            lag: d.accuracy.register_error.abs(),
            strain: p.pitch * strain(line),
        }
    }

    /// The parts after a start that misses ribbon, with the knob at its worst position: until the loop has that ribbon, the rollers pass on
    /// what the start has stretched.
    pub(super) fn after_start(line: &RibbonLine) -> DotError {
        let p = &line.params;
        let tension = worst_start(line).tension.start.max(p.web.tension_before);
        DotError { strain: p.pitch * tension / p.force_per_strain(), ..DotError::of(line) }
    }

    /// Root of the sum of squares of the parts that vary from dot to dot.
    pub(super) fn varying(&self) -> f64 {
        math::hypot(math::hypot(self.encoders, self.run_out), self.backlash)
    }

    /// Sum of the systematic parts.
    pub(super) fn lasting(&self) -> f64 {
        self.lag + self.strain
    }

    /// Total error.
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

/// The results at the position of the knob at which a start pulls the ribbon tightest.
pub(super) fn worst_start(line: &RibbonLine) -> &Derived {
    line.worst(|d| d.tension.start)
}

/// Whether a start stretches the ribbon beyond its tension before the rollers.
pub(super) fn start_stretches(line: &RibbonLine) -> bool {
    worst_start(line).tension.start > line.params.web.tension_before
}

/// Strain of the ribbon in the pull rollers, by the tension T1 before them: `ε = T1 / (E · A)`. The rollers pass the
/// strained ribbon on at any tension behind them, so the dots are closer by ε once the ribbon is slack again. Source:
/// sizing facts 2.6, `v₁T₁ - v₂T₂`.
pub(super) fn strain(line: &RibbonLine) -> f64 {
    let p = &line.params;
    p.web.tension_before / p.force_per_strain()
}

//! The unwinder: its speed by S and the override, the command at the analog output, and the speed error of motor and inverter.

use crate::controls::AnalogOutput;
use crate::drives::induction::Induction;
use crate::machines::ribbon_line::params::{KnobUse, OverrideForm, Params};

/// Speed of the unwinder's motor and its command. Speeds in r/min.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::ribbon_line) struct UnwinderSpeed {
    /// Speed by S and the override.
    pub commanded: f64,
    /// Highest speed.
    pub greatest: f64,
    /// Commanded speed, limited to the highest.
    pub actual: f64,
    /// Override (%) from which the highest speed binds.
    pub override_limit: f64,
    /// Override (%) of the motor's actual speed: limited by the speed clamp.
    pub effective_override: f64,
    /// Relative error of the speed (`n / n_commanded - 1`) at the running load and at rated load.
    pub error: f64,
    pub error_rated: f64,
    /// Analog command, V: by the value of S, as the converter puts it out, and at the highest speed.
    pub volts_command: f64,
    pub volts: f64,
    pub greatest_volts: f64,
    /// Speed of one step of the converter.
    pub analog_step: f64,
    /// Frequency of the inverter, Hz.
    pub frequency: f64,
}

impl UnwinderSpeed {
    /// By equation (1), with the clamps of control and program.
    pub(super) fn new(p: &Params, output: &AnalogOutput) -> UnwinderSpeed {
        let greatest = p.top_speed();
        let actual = p.speed_at(p.override_stepped());
        let (error, error_rated) = p.speed_errors(actual);
        let analog = output.with_speed(p.speed_at_10v);
        UnwinderSpeed {
            commanded: p.commanded_speed_at(p.override_stepped()),
            greatest,
            actual,
            override_limit: greatest / p.spindle_speed * 100.0,
            effective_override: 100.0 * actual / p.spindle_speed,
            error,
            error_rated,
            volts_command: analog.command(actual),
            volts: analog.output(actual),
            greatest_volts: analog.output(greatest),
            analog_step: p.speed_at_10v / f64::from(analog.steps()),
            frequency: p.frequency_at_10v * actual / p.speed_at_10v,
        }
    }
}

impl Params {
    /// Whether the PLC holds the spindle override at 100 % in automatic, and the program scales S by the typed
    /// override.
    pub(in crate::machines::ribbon_line) fn knob_is_locked(&self) -> bool {
        self.typed_override && self.knob_use == KnobUse::Locked
    }

    /// Whether the program reads the speed after override and clamp back from a register, which is 0 until the control
    /// puts out an S.
    pub(in crate::machines::ribbon_line) fn reads_final_speed(&self) -> bool {
        self.override_form == OverrideForm::FinalSpeed
    }

    /// Whether the knob changes the speed of the unwinder alone: the axes neither read the knob nor follow the measured
    /// speed.
    pub(in crate::machines::ribbon_line) fn knob_turns_alone(&self) -> bool {
        let follows = self.feeds_per_revolution() && self.spindle_encoder;
        self.typed_override && self.knob_use == KnobUse::Free && !follows
    }

    /// Override (%) that the PLC puts out: the knob rounded to its step, from the lowest position of the line on; a knob at 0 stops the line.
    pub(in crate::machines::ribbon_line) fn override_stepped(&self) -> f64 {
        let step = self.knob_step.percent();
        let stepped = (self.override_percent / step).round() * step;
        if stepped > 0.0 && !self.knob_is_locked() { stepped.max(self.knob_lowest) } else { stepped }
    }

    /// Highest speed in r/min that the analog output can give: the clamp, or 10 V.
    pub(in crate::machines::ribbon_line) fn top_speed(&self) -> f64 {
        self.speed_clamp.min(self.speed_at_10v)
    }

    /// Speed (r/min) that an override of `percent` commands of the unwinder's motor: `S · percent / 100`.
    pub(super) fn commanded_speed_at(&self, percent: f64) -> f64 {
        self.spindle_speed * percent / 100.0
    }

    /// Speed (r/min) of the unwinder's motor at an override of `percent`: the commanded one, at most the highest.
    pub(in crate::machines::ribbon_line) fn speed_at(&self, percent: f64) -> f64 {
        self.commanded_speed_at(percent).min(self.top_speed())
    }

    /// The unwinder's motor and inverter.
    pub(in crate::machines::ribbon_line) fn induction(&self) -> Induction {
        Induction {
            full_command: self.speed_at_10v,
            no_load: self.no_load_speed,
            rated: self.rated_load_speed,
            load: self.unwinder_load / 100.0,
        }
    }

    /// Relative errors of the unwinder's speed at its running load and at rated load; 0 with the regulator of a dancer, which trims
    /// them.
    pub(super) fn speed_errors(&self, speed: f64) -> (f64, f64) {
        let motor = self.induction();
        let loaded = Induction { load: 1.0, ..motor };
        if self.is_regulated() { (0.0, 0.0) } else { (motor.error(speed), loaded.error(speed)) }
    }

    /// Whether the regulator of a dancer keeps the loop. With a feed per revolution X follows every trim of the unwinder, which then changes
    /// nothing in the loop.
    pub(in crate::machines::ribbon_line) fn is_regulated(&self) -> bool {
        self.dancer && !self.feeds_per_revolution()
    }

    /// Ribbon that the press roller lays more than the pull roller takes up, as a share of the line speed; 0 with the regulator of a dancer,
    /// which trims it.
    pub(in crate::machines::ribbon_line) fn laid_by_thickness(&self) -> f64 {
        if self.is_regulated() { 0.0 } else { self.share_of_thickness() }
    }
}

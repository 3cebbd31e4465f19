//! The builder's PLC of the ribbon line: the paper's figure 1 (the knob to override and macro input), and FIN for S and M.

use super::derive::{AT_SPEED, FIN_DELAY};
use super::params::{OverrideForm, Wait};
use super::resolved::RibbonLine;
use crate::math;
use crate::motion::{Io, Plc, Strobes};

/// Scan time (s) while FIN waits for the spindle speed.
const SCAN: f64 = 0.01;

/// The ladder.
#[derive(Debug, Clone)]
pub(super) struct RibbonPlc {
    /// Percent per step of the knob.
    step: f64,
    form: OverrideForm,
    wait: Wait,
    /// The macro input, and its range.
    input: Option<u32>,
    range: (f64, f64),
    strobes: Strobes,
}

impl RibbonPlc {
    pub(super) fn new(line: &RibbonLine) -> RibbonPlc {
        let (p, input, range) = (&line.p, line.handed(), line.input_range());
        RibbonPlc {
            step: p.knob_step.percent(),
            form: p.override_form,
            wait: p.wait,
            input,
            range,
            strobes: Strobes::default(),
        }
    }

    /// The knob in whole steps, 0 to 200 %.
    fn override_percent(&self, io: &Io) -> f64 {
        math::clamp((io.spindle_override / self.step).round() * self.step, 0.0, 200.0)
    }

    /// M3 waits for the spindle's speed where the project says so; everything else is done after a few scans.
    fn done(&self, t: f64, since: f64, io: &Io) -> bool {
        let starts = matches!(io.m_strobe, Some(3 | 4));
        let waits = starts && self.wait == Wait::Fin;
        t >= since + FIN_DELAY && (!waits || io.spindle_actual.abs() >= AT_SPEED * io.spindle_command.abs())
    }
}

impl Plc for RibbonPlc {
    fn scan(&mut self, t: f64, io: &mut Io) -> Option<f64> {
        let percent = self.override_percent(io);
        io.spindle_override_out = percent;
        let word = match self.form {
            OverrideForm::Percent => percent,
            OverrideForm::FinalSpeed => io.spindle_command.abs().round(),
        };
        if let Some(input) = self.input {
            io.inputs.insert(input, math::clamp(word, self.range.0, self.range.1));
        }
        let since = self.strobes.since(t, io)?;
        io.fin = self.done(t, since, io);
        (!io.fin).then_some((since + FIN_DELAY).max(t + SCAN))
    }

    fn boxed(&self) -> Box<dyn Plc> {
        Box::new(self.clone())
    }
}

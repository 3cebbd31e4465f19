//! The builder's PLC of the ribbon line: the paper's figure 1 (the knob to override and macro input), FIN for S and M, and the stop of the
//! unwinder with the axes.

use super::derive::{AT_SPEED, FIN_DELAY};
use super::params::{OverrideForm, Wait};
use super::resolved::{GREATEST, RibbonLine};
use super::stops::unwinder;
use crate::machines::stops::{Interruption, SpindleReaction};
use crate::math;
use crate::motion::{Io, Plc, ProgramState, Strobes};
use crate::msg;

/// Scan time (s) while FIN waits for the spindle speed.
const SCAN: f64 = 0.01;

/// The ladder.
#[derive(Debug, Clone)]
pub(super) struct RibbonPlc {
    /// Percent per step of the knob.
    step: f64,
    /// The override stays at 100 % in automatic.
    locked: bool,
    /// The typed override (%), where the knob turns the unwinder and the axes stay.
    typed: Option<f64>,
    form: OverrideForm,
    wait: Wait,
    /// Seconds of the dwell behind M3.
    dwell: f64,
    /// F per revolution: the axes follow the unwinder and need not wait for it.
    in_step: bool,
    /// When the unwinder was let go after an interruption, while the axes wait for it.
    released: Option<f64>,
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
            locked: p.knob_is_locked(),
            typed: p.knob_turns_alone().then(|| p.override_stepped()),
            form: p.override_form,
            wait: p.wait,
            dwell: p.dwell,
            in_step: line.in_step(),
            released: None,
            input,
            range,
            strobes: Strobes::default(),
        }
    }

    /// The knob in whole steps; 100 % while a locked one is in automatic: from cycle start until the end or a reset.
    fn override_percent(&self, io: &Io) -> f64 {
        if self.locked && io.stops.program != ProgramState::Idle {
            return 100.0;
        }
        math::clamp((io.spindle_override / self.step).round() * self.step, 0.0, GREATEST)
    }

    /// M3 waits for the spindle's speed where the project says so; everything else is done after a few scans.
    fn done(&self, t: f64, since: f64, io: &Io) -> bool {
        let starts = matches!(io.m_strobe, Some(3 | 4));
        let waits = starts && self.wait == Wait::Fin;
        t >= since + FIN_DELAY && (!waits || at_speed(io))
    }

    /// Holds the unwinder while the program is interrupted. At cycle start the unwinder runs up first, and the axes wait for it as
    /// they do behind M3: for its speed, or for the dwell. Returns the time of the next look.
    fn interruption(&mut self, t: f64, io: &mut Io) -> Option<f64> {
        let waits = |at| unwinder(at) == SpindleReaction::Waits;
        if Interruption::lasting(io.stops.program).is_some_and(waits) {
            (io.stops.spindle, io.stops.axes, self.released) = (true, false, None);
            return None;
        }
        let goes_on = io.stops.program == ProgramState::Running && !self.in_step;
        if core::mem::take(&mut io.stops.spindle) {
            self.released = Some(t);
        }
        let released = self.released.take().filter(|_| goes_on);
        io.stops.axes = released.is_some_and(|since| !self.up_again(t, since, io));
        self.released = released.filter(|_| io.stops.axes);
        let due = self.released? + self.least_wait();
        Some(if t < due && io.spindle_command != 0.0 { due } else { t + SCAN })
    }

    /// Least time (s) from the restart of the unwinder to the motion of the axes.
    fn least_wait(&self) -> f64 {
        FIN_DELAY + if self.wait == Wait::Dwell { self.dwell } else { 0.0 }
    }

    /// Whether the axes may move again: an unwinder that M3 has not started yet keeps nothing waiting.
    fn up_again(&self, t: f64, released: f64, io: &Io) -> bool {
        let off = io.spindle_command == 0.0 && t > released;
        let waited = t >= released + self.least_wait() && (self.wait == Wait::Dwell || at_speed(io));
        off || waited
    }
}

/// The unwinder has the share of its commanded speed from which the inverter reports it.
fn at_speed(io: &Io) -> bool {
    io.spindle_actual.abs() >= AT_SPEED * io.spindle_command.abs()
}

impl Plc for RibbonPlc {
    fn scan(&mut self, t: f64, io: &mut Io) -> Option<f64> {
        let percent = self.override_percent(io);
        io.spindle_override_out = percent;
        if let Some(typed) = self.typed.filter(|typed| *typed != percent)
            && io.stops.program == ProgramState::Running
            && io.spindle_command != 0.0
        {
            io.notice = Some(msg!("ribbon.knob-left", (percent, 0), (typed, 0)));
        }
        let word = match self.form {
            OverrideForm::Percent => percent,
            OverrideForm::FinalSpeed => io.spindle_command.abs().round(),
        };
        if let Some(input) = self.input {
            io.inputs.insert(input, math::clamp(word, self.range.0, self.range.1));
        }
        let restart = self.interruption(t, io);
        let answer = self.strobes.since(t, io).and_then(|since| {
            io.fin = self.done(t, since, io);
            (!io.fin).then_some((since + FIN_DELAY).max(t + SCAN))
        });
        [restart, answer].into_iter().flatten().reduce(f64::min)
    }

    fn boxed(&self) -> Box<dyn Plc> {
        Box::new(self.clone())
    }
}

//! The next event of a simulation: operator, PLC, contacts, spindle, reader or executor, always the earliest first.

use super::exec::Exec;
use super::panel::Action;
use super::program::RunningProgram;
use super::setup::RunEnd;
use super::sim::Sim;
use super::snapshot::Mode;
use super::spindle::SpeedCommand;
use super::timeline::Activity;
use crate::msg;
use crate::text::Diagnostic;

/// Source of the next event; in this order at equal times.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum EventSource {
    PowerOn,
    Operator,
    Plc,
    Contacts,
    Spindle,
    Reader,
    Executor,
}

impl<P: RunningProgram> Sim<'_, P> {
    /// Time (s) and source of the earliest event; infinite if only the operator can cause one.
    pub(super) fn next(&self) -> (f64, EventSource) {
        if !self.state.started {
            return (0.0, EventSource::PowerOn);
        }
        let operator = self.panel.events().get(self.state.operator.events_done);
        let operator_at = operator.map_or(f64::INFINITY, |event| event.t);
        let mut next = (f64::INFINITY, EventSource::Operator);
        // Cycle start at the exact time of a stop answers that stop.
        let start = operator.is_some_and(|event| event.action == Action::Start);
        let first = if start { f64::INFINITY } else { operator_at };
        for (t, source) in [
            (first, EventSource::Operator),
            (self.state.plc.next_scan, EventSource::Plc),
            (self.state.plc.next_reading, EventSource::Contacts),
            (self.state.spindle.next(), EventSource::Spindle),
            (self.reader_time(), EventSource::Reader),
            (self.executor_time(), EventSource::Executor),
            (operator_at, EventSource::Operator),
        ] {
            if t < next.0 {
                next = (t, source);
            }
        }
        next
    }

    /// Carries out one event.
    pub(super) fn carry_out(&mut self, t: f64, source: EventSource) {
        self.state.now = t;
        match source {
            EventSource::PowerOn => self.power_on(),
            EventSource::Operator => self.operate(t),
            EventSource::Plc => self.scan(t),
            EventSource::Contacts => self.read_contacts(t),
            EventSource::Spindle => self.spindle(t),
            EventSource::Reader => self.read(t),
            EventSource::Executor => self.execute(t),
        }
        self.show_state(t);
        self.rest(t);
        self.mark(t);
        self.await_contacts(t);
        self.await_web(t);
    }

    /// The end of the run, if only the operator can continue it; `t` is the time of the next event.
    pub(super) fn end(&self, t: f64) -> Option<RunEnd> {
        if self.state.operator.events_done < self.panel.events().len() || !self.state.started {
            return None;
        }
        let nothing_follows = (t == f64::INFINITY).then_some(RunEnd::Stop);
        self.state.exec.end(self.holding()).or(nothing_follows)
    }

    /// The reason why a program waits for ever without ending, unless it is already reported.
    pub(super) fn stuck(&self) -> Option<Diagnostic> {
        let message = match &self.state.exec {
            exec if exec.end(self.holding()).is_some() => return None,
            Exec::Fin => msg!("motion.no-fin"),
            Exec::Counting(..) => msg!("motion.dwell-at-rest"),
            _ if self.waits_for_spindle() => return None,
            _ => msg!("motion.no-feed"),
        };
        Some(Diagnostic { place: self.state.place, ..Diagnostic::warning(message) })
    }

    fn power_on(&mut self) {
        self.state.started = true;
        self.put_ramp(0.0, SpeedCommand { stage: 1, ..SpeedCommand::default() });
        self.state.path.moving = true;
        self.rest(0.0);
        self.state.path.rest_since = f64::NEG_INFINITY;
        self.scan(0.0);
    }

    /// Records a change of the control's mode or of the executing block, and each start of a block.
    fn mark(&mut self, t: f64) {
        let mode = self.state.exec.mode(self.holding());
        let runs = self.state.exec.runs() && mode != Mode::Hold;
        if runs != self.state.clock.since.is_some() {
            self.state.clock.total = self.state.run_time_at(t);
            self.state.clock.since = runs.then_some(t);
        }
        self.state.mode = mode;
        let (place, begun) = (self.state.place.unwrap_or_default(), self.state.place.is_some());
        let begins = core::mem::take(&mut self.state.begins);
        let last = self.out.timeline.marks.last().filter(|last| last.begun == begun && last.place == place);
        if begins || last.is_none_or(|last| last.mode != mode) {
            // A mark of the same time is replaced; the start of the same block stays.
            let is_start = begins || last.is_some_and(|last| last.t == t && last.is_start);
            self.out.timeline.marks.set_from(Activity { t, mode, place, begun, is_start });
        }
    }
}

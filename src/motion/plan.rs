//! The planner: runs a program over time in slices, and again from a checkpoint when an operator event in the past changes.
//!
//! A discrete-event simulation: the earliest event happens first, in a fixed order at equal times, so a run is a pure function of program,
//! plant, PLC and panel. No event depends on a later one: the plan before a time stays valid when an event is added after it.

use std::collections::VecDeque;

use super::checked_plant::CheckedPlant;
use super::events::EventSource;
use super::exec::Exec;
use super::gate::{Gate, Gatekeeper};
use super::panel::{Action, Event, Panel};
use super::path::Segment;
use super::program::RunningProgram;
use super::records::{RecordLengths, Records};
use super::setup::{GatedProgress, PlanProgress, Retention, RunEnd, Setup};
use super::sim::Sim;
use super::state::SimState;
use super::timeline::Timeline;
use crate::interp::canon::AXES;
use crate::interp::{Canon, Counts};
use crate::msg;
use crate::text::{Diagnostic, Message, Place};

/// State before all events at or after a time.
#[derive(Debug, Clone)]
pub(super) struct Checkpoint<P> {
    pub(super) t: f64,
    pub(super) state: SimState<P>,
    pub(super) marks: RecordLengths,
}

/// A run planned slice by slice.
#[derive(Debug, Clone)]
pub struct Planner<P> {
    pub(super) plant: CheckedPlant,
    pub(super) panel: Panel,
    pub(super) state: SimState<P>,
    pub(super) records: Records,
    pub(super) checkpoints: Vec<Checkpoint<P>>,
    pub(super) keep: Retention,
    /// Time of the next checkpoint, whole seconds.
    pub(super) due: f64,
    pub(super) ended: Option<RunEnd>,
    /// True when the last diagnostic explains why planning stopped; removed on the next panel event.
    pub(super) has_last_word: bool,
}

impl<P: RunningProgram> Planner<P> {
    /// A run at time 0, with cycle start pressed.
    pub fn new(setup: Setup<'_, P>) -> Planner<P> {
        let plant = CheckedPlant::new(setup.control, setup.plant, setup.limits, setup.keep != Retention::Timeline);
        let mut timeline = Timeline::new(plant.axes, super::pmc::axes(&setup.plant.pmc), plant.spindle);
        let mut state = SimState::new(setup.program, setup.plc, plant.diameter_axis());
        let home = plant.axes.map(|axis| axis.home);
        if home != [0.0; AXES] {
            let increments = core::array::from_fn(|k| (home[k] / plant.scale[k]).round() as i64);
            state.program.set_start(increments);
            state.path.position = home;
            timeline.put_segment(Segment { t: 0.0, from: home, velocity: [0.0; AXES], circle: 0 }, None);
        }
        Planner {
            records: Records { timeline, log: VecDeque::new(), taken: 0, first_kept: 0, diagnostics: setup.findings },
            state,
            plant,
            panel: setup.panel,
            checkpoints: Vec::new(),
            keep: setup.keep,
            due: 0.0,
            ended: None,
            has_last_word: false,
        }
    }

    /// The same run, before its begin, with contacts of the machine that do not act: it shows how far their limits would be exceeded if nothing
    /// held the program.
    pub fn without_contacts(mut self) -> Planner<P> {
        self.state.plc.follows = false;
        self
    }

    /// Whether the PLC holds the program at the end of the planned part.
    pub fn is_held_by_plc(&self) -> bool {
        self.state.plc.orders.program_held
    }

    /// Whether the program waits at its start after a reset: cycle start begins it anew.
    pub fn is_reset(&self) -> bool {
        matches!(self.state.exec, Exec::Ready)
    }

    /// Message of the PLC about its hold of the program at the end of the planned part.
    pub fn plc_hold(&self) -> Option<&Message> {
        self.state.plc.hold.as_ref()
    }

    /// Plans on until machine time `until`, standstill after the end of the run, or `budget` events: whichever is first.
    pub fn advance(&mut self, until: f64, budget: usize) -> PlanProgress {
        self.plan(until, budget, None).progress
    }

    /// Plans like [`advance`](Planner::advance), with an optional gate before each step of the program.
    pub(super) fn plan(&mut self, until: f64, budget: usize, mut gate: Option<Gatekeeper<P>>) -> GatedProgress {
        let mut is_shut = false;
        let until = until.min(self.plant.limits.seconds);
        for _ in 0..budget {
            if self.ended.is_some() {
                break;
            }
            let mut sim = self.sim();
            let (t, source) = sim.next();
            match sim.end(t) {
                None => sim.state.ended_at = None,
                Some(end) => {
                    let still = sim.standstill().min(sim.plant.limits.seconds);
                    if t > still && still <= until {
                        self.finish(end, still);
                        break;
                    }
                }
            }
            if t > until || t == f64::INFINITY {
                if until >= self.plant.limits.seconds {
                    self.records.timeline.end = until;
                    self.last_word(Diagnostic::info(msg!("motion.out-of-seconds", time = self.plant.limits.seconds)));
                    self.ended = Some(RunEnd::Seconds);
                } else {
                    self.records.timeline.end = until.max(self.records.timeline.end);
                }
                break;
            }
            if let (EventSource::Reader, Some(gate)) = (source, &mut gate) {
                match self
                    .state
                    .look(t, &self.plant.axes, &self.records.timeline, |program, world| gate(t, program, world))
                {
                    Gate::Open => {}
                    Gate::OpenAsFirst => {
                        self.records.forget_log(0);
                        self.records.first_kept = self.records.taken;
                    }
                    Gate::Shut => {
                        self.records.timeline.end = t.max(self.records.timeline.end);
                        is_shut = true;
                        break;
                    }
                }
            }
            if t >= self.due {
                self.checkpoint(t);
            }
            self.sim().carry_out(t, source);
            // Other events may follow at the same time; the time counts as planned only after them.
            self.records.timeline.end = t.max(self.records.timeline.end);
        }
        let progress = PlanProgress { planned_to: self.records.timeline.end, ended: self.ended.clone() };
        GatedProgress { progress, is_shut }
    }

    /// The run with everything that its next event reads and writes.
    fn sim(&mut self) -> Sim<'_, P> {
        Sim { state: &mut self.state, plant: &self.plant, out: &mut self.records, panel: &self.panel }
    }

    /// Records a checkpoint before the first event at or after a whole second. All earlier events come before `due`.
    fn checkpoint(&mut self, t: f64) {
        match self.keep {
            Retention::Timeline | Retention::Both => {
                let marks = self.records.marks();
                self.checkpoints.push(Checkpoint { t: self.due, state: self.state.clone(), marks });
            }
            Retention::Log => self.records.timeline.forget(self.state.now),
        }
        self.due = t.floor() + 1.0;
    }

    fn last_word(&mut self, diagnostic: Diagnostic) {
        self.records.diagnostics.push(diagnostic);
        self.has_last_word = true;
    }

    /// Adds an operator event at any time, also in the planned part. The timeline before it stays; later calls of
    /// [`advance`](Planner::advance) plan the rest again, as if the event had been there from the beginning.
    pub fn event(&mut self, mut event: Event) {
        if self.keep == Retention::Log {
            event.t = event.t.max(self.state.now);
        }
        let t = if event.t > 0.0 { event.t } else { 0.0 };
        self.panel.act(event);
        self.forget_from(t);
    }

    /// Replaces the operator events. The timeline before the earliest difference stays; the rest is planned again, as if the events had
    /// been there from the beginning. Returns false and changes nothing if only the log is kept, because a log cannot be undone.
    pub fn replace_panel(&mut self, panel: Panel) -> bool {
        let Some(t) = self.panel.differs_from(&panel) else { return true };
        if self.keep == Retention::Log {
            return false;
        }
        self.panel = panel;
        self.forget_from(t);
        true
    }

    /// Returns to the last state before all events at or after `t` (s). If `t` is after the end of the run, it returns to a state before
    /// that end, because the changed events may postpone it.
    fn forget_from(&mut self, t: f64) {
        self.ended = None;
        if core::mem::take(&mut self.has_last_word) {
            self.records.diagnostics.pop();
        }
        if self.keep == Retention::Log || t > self.records.timeline.end && !self.is_over() {
            return;
        }
        while let Some(last) = self.checkpoints.pop() {
            if last.t > t {
                continue;
            }
            self.records.truncate(&last.marks);
            self.state = last.state;
            self.due = last.t;
            self.records.timeline.end = last.t.min(t);
            if !self.is_over() {
                break;
            }
        }
    }

    /// Whether only the operator can continue the run, and no operator event is left.
    fn is_over(&mut self) -> bool {
        let sim = self.sim();
        let (next, _) = sim.next();
        sim.end(next).is_some()
    }

    /// Power failure at `t` (s): like emergency stop, but the spindle coasts.
    pub fn lose_power(&mut self, t: f64) {
        self.plant.power_fails = t;
        self.event(Event { t, action: Action::EmergencyStop });
    }

    /// Ends the plan at `still`, the time when axes and spindle have settled after the end of the run.
    fn finish(&mut self, end: RunEnd, still: f64) {
        let sim = self.sim();
        if let Some(reason) = sim.stuck() {
            self.last_word(reason);
        }
        self.records.timeline.end = still.max(self.records.timeline.end);
        self.ended = Some(end);
    }

    /// Time (s) at which the program ended or stopped, after the run is planned to its end. Axes and spindle settle between that time and
    /// [`Timeline::end`].
    pub fn ended_at(&self) -> Option<f64> {
        match self.ended.as_ref()? {
            RunEnd::Seconds => Some(self.records.timeline.end),
            _ => self.state.ended_at,
        }
    }

    /// The program's reference point in the machine frame, in the unit of words: the position at the last preset of coordinates (G50, G92),
    /// or at the last speed limit (G50 S) that sets the reference point; `None` before the first.
    pub fn reference_point(&self) -> Option<[f64; AXES]> {
        let axes = &self.plant.axes;
        self.state.path.reference.map(|place| core::array::from_fn(|k| place[k] * axes[k].words_per_unit()))
    }

    /// The machine over time.
    pub fn timeline(&self) -> &Timeline {
        &self.records.timeline
    }

    /// Operator events, including all added ones.
    pub fn panel(&self) -> &Panel {
        &self.panel
    }

    /// Blocks read so far.
    pub fn blocks(&self) -> Counts {
        self.state.program.blocks()
    }

    /// Number of blocks read too late to follow the preceding one without a stop.
    pub fn starved(&self) -> u64 {
        self.state.starved
    }

    /// The program at the end of the planned part.
    pub fn program(&self) -> &P {
        &self.state.program
    }

    /// Alarms and warnings of the planned part.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.records.diagnostics
    }

    /// A common variable, macro input or macro output on the control's screen at time `t`, including changes by blocks read ahead; `None`
    /// is vacant.
    pub fn variable_at(&self, number: u32, t: f64) -> Option<f64> {
        let known = self.checkpoints.partition_point(|checkpoint| checkpoint.t <= t);
        let base = self.checkpoints[..known].last();
        let from = base.map_or(0, |checkpoint| checkpoint.marks.changes());
        let changes = &self.records.timeline.changes;
        let recent =
            changes.from(from).iter().take_while(|change| change.t <= t).filter(|change| change.number == number);
        match recent.last() {
            Some(change) => Some(change.value).filter(|value| !value.is_nan()),
            None => {
                let state = base.map_or(&self.state, |checkpoint| &checkpoint.state);
                let interface =
                    || state.plc.shown.get(&number).or_else(|| state.plc.signals.macro_outputs.get(&number)).copied();
                state.program.variable(number).or_else(interface)
            }
        }
    }

    /// Takes the log of commands begun since the last call, in program order, with their reading times (s).
    pub fn take_log(&mut self) -> Vec<(f64, Canon, Place)> {
        let begun = self.state.reader.queue.front().map_or(self.records.logged(), |next| next.logged);
        let count = begun.saturating_sub(self.records.taken).min(self.records.log.len());
        self.records.taken += count;
        self.records.log.drain(..count).collect()
    }
}

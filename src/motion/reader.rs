//! Pre-read: reads the program ahead of its execution; macro outputs and suppressions act when read.

use std::collections::BTreeMap;

use super::exec::Exec;
use super::plant::AxisPlant;
use super::program::RunningProgram;
use super::sim::Sim;
use super::state::{Over, Queued, SimState};
use super::timeline::{Timeline, VariableChange};
use crate::interp::canon::AXES;
use crate::interp::{Canon, MachineClock, Step, World};
use crate::text::Diagnostic;

/// The machine as read by a block of the program.
struct ReaderWorld<'a> {
    inputs: &'a BTreeMap<u32, f64>,
    position: Axes<'a>,
    axes: &'a [AxisPlant; AXES],
    power_on: f64,
    running: f64,
    block_skip: bool,
    waiting: Option<usize>,
    changes: Vec<(u32, Option<f64>)>,
    remarks: Vec<Diagnostic>,
}

/// Source of the axis positions.
enum Axes<'a> {
    /// At rest, at these positions.
    Rest(&'a [f64; AXES]),
    /// From the timeline.
    Path(&'a Timeline),
}

impl<P> SimState<P> {
    /// Calls `look` with the program and the machine as read by it at `t`, with the axes on their path.
    pub(super) fn look<R>(
        &self,
        t: f64,
        axes: &[AxisPlant; AXES],
        path: &Timeline,
        look: impl FnOnce(&P, &mut dyn World) -> R,
    ) -> R {
        let mut world = ReaderWorld {
            inputs: &self.plc.orders.macro_inputs,
            position: Axes::Path(path),
            axes,
            power_on: t,
            running: self.run_time_at(t),
            block_skip: self.operator.knobs.block_skip,
            waiting: self.waiting(),
            changes: Vec::new(),
            remarks: Vec::new(),
        };
        look(&self.program, &mut world)
    }
}

impl World for ReaderWorld<'_> {
    fn input(&mut self, variable: u32) -> f64 {
        self.inputs.get(&variable).copied().unwrap_or(0.0)
    }

    fn clock_ms(&mut self, clock: MachineClock) -> f64 {
        let seconds = match clock {
            MachineClock::PowerOn => self.power_on,
            MachineClock::AutomaticRun => self.running,
        };
        1000.0 * seconds
    }

    fn position(&mut self, axis: usize) -> f64 {
        match self.position {
            Axes::Rest(moved) => {
                moved.iter().zip(self.axes).nth(axis).map_or(0.0, |(moved, axis)| moved * axis.words_per_unit())
            }
            Axes::Path(path) => path.words_at(self.power_on).get(axis).copied().unwrap_or(0.0),
        }
    }

    fn block_skip(&mut self, _number: u8) -> bool {
        self.block_skip
    }

    fn waiting(&mut self) -> Option<usize> {
        self.waiting
    }

    fn is_endless(&self, axis: usize) -> bool {
        self.axes.get(axis).is_some_and(|axis| axis.endless)
    }

    fn changed(&mut self, variable: u32, value: Option<f64>) {
        self.changes.push((variable, value));
    }

    fn remark(&mut self, remark: Diagnostic) {
        self.remarks.push(remark);
    }
}

impl<P: RunningProgram> Sim<'_, P> {
    /// Reads one step of the program.
    pub(super) fn read(&mut self, t: f64) {
        let before = self.state.program.blocks();
        if before.nc + before.macros >= self.plant.limits.blocks {
            self.state.reader.over = Some(Over::Blocks);
            return;
        }
        if self.state.reader.drains {
            self.state.reader.drains = false;
            self.state.path.flow_end = None;
        }
        let (running, waiting) = (self.state.run_time_at(t), self.state.waiting());
        let s = &mut *self.state;
        let mut world = ReaderWorld {
            inputs: &s.plc.orders.macro_inputs,
            position: Axes::Rest(&s.path.position),
            axes: &self.plant.axes,
            power_on: t,
            running,
            block_skip: s.operator.knobs.block_skip,
            waiting,
            changes: Vec::new(),
            remarks: Vec::new(),
        };
        let step = s.program.step(&mut world);
        for (number, value) in world.changes {
            self.out.timeline.changes.append(VariableChange { t, number, value: value.unwrap_or(f64::NAN) });
        }
        for remark in world.remarks {
            self.out.report_in_block(remark);
        }
        let after = s.program.blocks();
        let (nc, macros) = (after.nc - before.nc.min(after.nc), after.macros - before.macros.min(after.macros));
        s.reader.next_step = t + nc as f64 * self.plant.block_time + macros as f64 * self.plant.macro_time;
        self.take(t, step, (after.nc + after.macros - after.empty, nc + macros > 0));
    }

    /// Queues the result of a step; `block` is the block's number without empty blocks, `first` marks its first step.
    fn take(&mut self, t: f64, step: Step, (block, first): (u64, bool)) {
        let (canon, place) = match step {
            Step::Command(canon, place) => (canon, place),
            Step::Logic(_) => return,
            Step::Sync(_) => {
                self.state.reader.drains = true;
                return;
            }
            Step::Ended(end) => {
                self.state.reader.over = Some(end.into());
                return;
            }
        };
        let logged = self.out.logged();
        if self.plant.log {
            self.out.log.push_back((t, canon.clone(), place));
        }
        match canon {
            // Macro statements act when they are read (docs/reference/mitsubishi-e60.md section 4).
            Canon::Output { variable, value } => {
                if self.state.plc.signals.macro_outputs.get(&variable) != Some(&value) {
                    self.out.timeline.changes.append(VariableChange { t, number: variable, value });
                }
                self.state.plc.signals.macro_outputs.insert(variable, value);
                self.scan(t);
            }
            Canon::Suppress { hold, feed_override, exact } => {
                self.state.suppressed.hold = hold;
                self.state.suppressed.feed_override = feed_override;
                self.state.suppressed.exact = exact;
                self.update_path_speed(t);
            }
            Canon::SuppressWaits { single_block, fin } => {
                self.state.suppressed.single_block = single_block;
                self.state.suppressed.fin = fin;
            }
            _ => {
                self.state.reader.drains =
                    matches!(canon, Canon::Stop | Canon::OptionalStop | Canon::Message { .. } | Canon::End);
                self.state.reader.ahead += usize::from(first);
                let ready = self.state.reader.next_step;
                self.state.reader.queue.push_back(Queued { canon, place, ready, first, block, logged });
                self.aim_ahead(t);
            }
        }
    }

    pub(super) fn reader_time(&self) -> f64 {
        let s = &*self.state;
        let reads = s.exec.runs() || matches!(s.exec, Exec::Stopped);
        if !reads || s.reader.over.is_some() || s.reader.ahead >= self.plant.preread {
            return f64::INFINITY;
        }
        if !s.reader.drains {
            return s.reader.next_step.max(s.now);
        }
        if s.reader.queue.is_empty() && matches!(s.exec, Exec::Idle) {
            s.reader.next_step.max(s.now).max(self.rest_time())
        } else {
            f64::INFINITY
        }
    }
}

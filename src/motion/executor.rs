//! Executes commands in order: moves the axes, waits for standstill, for the PLC, for the operator.

use super::exec::Exec;
use super::moves::{ActiveMove, Pace};
use super::once::Once;
use super::path::Segment;
use super::program::RunningProgram;
use super::sim::Sim;
use super::state::{Over, Queued};
use crate::drives::Rotation;
use crate::interp::Canon;
use crate::interp::canon::{AXES, Target};
use crate::math;
use crate::msg;
use crate::text::Diagnostic;

impl<P: RunningProgram> Sim<'_, P> {
    /// Feed hold, unless the program has switched it off or cuts a thread.
    #[inline]
    pub(super) fn holding(&self) -> bool {
        self.state.operator.held && !self.state.suppressed.hold && self.state.exec.runs() && !self.state.exec.threads()
    }

    /// Time (s) at which the axes are at rest.
    pub(super) fn rest_time(&self) -> f64 {
        self.state.path.rest_since + self.plant.standstill
    }

    pub(super) fn executor_time(&self) -> f64 {
        let s = &*self.state;
        match &s.exec {
            Exec::Idle if self.holding() => f64::INFINITY,
            Exec::Idle => match (s.reader.queue.front(), &s.reader.over) {
                (next, _) if self.orients() && next.is_none_or(|next| next.first || next.canon.is_cut().is_none()) => {
                    f64::INFINITY
                }
                (Some(queued), _) => queued.ready.max(s.now),
                (None, Some(_)) => s.reader.next_step.max(s.now).max(self.rest_time()),
                (None, None) => f64::INFINITY,
            },
            Exec::Spinning(_) if self.holding() => f64::INFINITY,
            Exec::Spinning(_) => self.speed_time().max(s.now),
            Exec::Counting(from, turns) => self.turns_time(*from, *turns),
            Exec::Moving(motion) => motion.end_time().min(motion.again),
            Exec::Settling(t) | Exec::Resting(t, _) | Exec::Dwelling(t) => *t,
            _ => f64::INFINITY,
        }
    }

    pub(super) fn execute(&mut self, t: f64) {
        match &mut self.state.exec {
            Exec::Idle => self.begin_next(t),
            Exec::Moving(motion) => {
                let (end, exact, pace) = (motion.end, motion.exact, motion.pace);
                if motion.end_time() <= t {
                    self.arrive(t, end, exact, pace);
                } else {
                    self.update_path_speed(t);
                }
            }
            Exec::Spinning(_) => {
                if let Exec::Spinning(motion) = core::mem::replace(&mut self.state.exec, Exec::Idle) {
                    self.begin(t, &motion);
                }
            }
            Exec::Resting(_, canon) => {
                let canon = core::mem::replace(&mut **canon, Canon::Stop);
                self.perform(t, canon);
            }
            Exec::Settling(_) | Exec::Dwelling(_) => self.state.exec = Exec::Idle,
            Exec::Counting(from, turns) => {
                let (from, turns) = (*from, *turns);
                if self.turns_left(t, from, turns) <= 0.0 {
                    self.state.exec = Exec::Idle;
                }
            }
            _ => {}
        }
    }

    fn begin_next(&mut self, t: f64) {
        let Some(next) = self.state.reader.queue.front() else { return self.end_of_queue() };
        if next.first
            && self.state.operator.stepped
            && self.state.operator.knobs.single_block
            && !self.state.suppressed.single_block
        {
            self.state.exec = Exec::Stopped;
            self.state.path.flow_end = None;
            return;
        }
        let Some(Queued { canon, place, first, block, .. }) = self.pop() else { return };
        self.state.reader.executed = block;
        self.state.operator.stepped |= first;
        self.state.place = Some(place);
        self.state.begins |= first;
        match canon {
            Canon::Rapid { to } => {
                let motion = self.line_to(&to, Pace::Rapid, true);
                self.begin(t, &motion);
            }
            Canon::Linear { to, feed, exact } => {
                let motion = self.line_to(&to, Pace::Feed(feed), exact);
                self.cut(t, &motion);
            }
            Canon::Thread { to, lead } => {
                let motion = self.line_to(&to, Pace::Thread(lead), false);
                self.cut(t, &motion);
            }
            Canon::Arc { to, plane, center, clockwise, feed, exact } => {
                let scale = |axis: u8| self.plant.scale.get(axis as usize).copied().unwrap_or(0.0);
                let center = (center.0 * scale(plane.0), center.1 * scale(plane.1));
                let chord = self.line_to(&to, Pace::Feed(feed), exact);
                self.cut(t, &chord.around(plane, center, clockwise, &self.plant.axes));
            }
            Canon::SurfaceSpeed { speed, axis, zero } => {
                self.begin_surface(t, speed, axis, zero);
            }
            Canon::ConstantSpeed => self.end_surface(t),
            Canon::SpeedLimit { limit, rpm } => {
                self.state.spindle.limit(limit, rpm);
                self.update_spindle_and_plc(t);
            }
            Canon::Orient { angle, approach } => self.orient(t, angle, approach),
            Canon::OtherSpindle { rotation, .. } => {
                self.state.spindle.driven_tool_turns = rotation != Rotation::Stopped
            }
            // No motion: a position or message is recorded, or the command has acted when it was read.
            Canon::Preset { .. } => self.state.path.reference = Some(self.state.path.position),
            Canon::PathMode { .. } => {}
            Canon::Show { text } => self.out.timeline.show_message(t, &text),
            Canon::Output { .. } | Canon::Suppress { .. } | Canon::SuppressWaits { .. } => {}
            Canon::OptionalStop if !self.state.operator.knobs.optional_stop => {}
            _ => {
                self.state.path.flow_end = None;
                let rest = self.rest_time();
                if rest > t {
                    self.state.exec = Exec::Resting(rest, Box::new(canon));
                } else {
                    self.perform(t, canon);
                }
            }
        }
    }

    /// Ends the run after the last command: at an alarm, at the budget of blocks, or at the program's end.
    fn end_of_queue(&mut self) {
        self.state.exec = match self.state.reader.over.clone() {
            Some(Over::Alarm(diagnostic)) => {
                self.out.report((*diagnostic).clone());
                Exec::Alarm(diagnostic)
            }
            Some(Over::Blocks) => {
                let count = self.plant.limits.blocks as f64;
                self.out.report(Diagnostic::warning(msg!("motion.out-of-blocks", count)));
                Exec::OutOfBlocks
            }
            Some(Over::Program) | None => Exec::Finished,
        };
    }

    /// A straight movement from the present position to a programmed end point.
    fn line_to(&mut self, to: &Target, pace: Pace, exact: bool) -> ActiveMove {
        let end = self.goal(to);
        ActiveMove::line(self.state.path.position, end, pace, exact, &self.plant.axes)
    }

    pub(super) fn pop(&mut self) -> Option<Queued> {
        let queued = self.state.reader.queue.pop_front()?;
        self.state.reader.ahead -= usize::from(queued.first);
        Some(queued)
    }

    /// End point of a movement, in mm.
    fn goal(&mut self, to: &Target) -> [f64; AXES] {
        let missing = to.mask & !self.plant.fitted;
        for k in (0..AXES).filter(|k| missing & (1 << k) != 0) {
            let letter = self.plant.axes[k].name();
            self.warn(Once::Missing(k), || msg!("motion.missing-axis", axis = letter));
        }
        let scale = &self.plant.scale;
        core::array::from_fn(|k| {
            if to.mask & (1 << k) != 0 { to.position[k] as f64 * scale[k] } else { self.state.path.position[k] }
        })
    }

    /// Executes a command that needs the axes at rest.
    fn perform(&mut self, t: f64, canon: Canon) {
        self.state.exec = Exec::Idle;
        match canon {
            Canon::Dwell { seconds } => self.state.exec = Exec::Dwelling(t + seconds.max(0.0)),
            Canon::DwellTurns { turns } => self.state.exec = Exec::Counting(self.turns(t), turns.max(0.0)),
            Canon::Stop | Canon::OptionalStop => self.state.exec = Exec::Stopped,
            Canon::Message { text } => {
                self.out.timeline.show_message_until_start(t, &text);
                self.state.exec = Exec::Stopped;
            }
            Canon::End => {
                self.out.timeline.clear_message(t);
                self.state.exec = Exec::Finished;
                if self.plant.spindle.rules.end_stops {
                    (self.state.spindle.speed, self.state.spindle.rotation) = (0.0, Rotation::Stopped);
                    self.update_spindle_and_plc(t);
                }
            }
            _ => self.put_out(t, canon),
        }
    }

    /// Ends a block on the unfiltered path.
    fn arrive(&mut self, t: f64, end: [f64; AXES], exact: bool, pace: Pace) {
        self.state.path.position = end;
        if let Pace::Return { ended } = pace {
            self.return_on(t, ended);
            return;
        }
        self.state.exec = Exec::Idle;
        self.state.path.flow_end = (!exact).then_some(t);
        if let Pace::Thread(_) = pace {
            self.update_spindle_and_plc(t);
        }
        if !exact || (self.state.suppressed.exact && pace != Pace::Rapid) {
            return;
        }
        self.rest(t);
        let mut until = self.rest_time();
        if pace != Pace::Rapid {
            for (k, axis) in self.plant.axes.iter().enumerate() {
                // After the command stops, the axis closes in exponentially.
                let still = t + axis.time_constant;
                let state = self.out.timeline.path.axis(k, axis, still);
                let left = (state.position - state.actual).abs();
                if left > self.plant.in_position {
                    until = until.max(still + math::ln(left / self.plant.in_position) / axis.position_gain);
                }
            }
        }
        self.state.exec = Exec::Settling(until);
    }

    /// Breaks off motion and waits; the path ends here.
    pub(super) fn break_off(&mut self, t: f64) {
        if let Exec::Moving(motion) = &mut self.state.exec {
            motion.set_speed(t, 0.0);
            self.state.path.position = motion.segment().0.from;
        }
        self.state.exec = Exec::Ready;
        self.rest(t);
    }

    /// Ends the path with a standstill if no movement continues it.
    pub(super) fn rest(&mut self, t: f64) {
        if self.state.path.moving && !matches!(self.state.exec, Exec::Moving(_)) {
            self.state.path.moving = false;
            self.state.path.rest_since = t;
            let segment = Segment { t, from: self.state.path.position, velocity: [0.0; AXES], circle: 0 };
            self.out.timeline.put_segment(segment, None);
            self.note_surface_cut_end(t);
        }
    }
}

//! Executes commands one after the other: moves, waits for standstill, for the PLC, for the operator.

use super::moves::{Move, Pace};
use super::path::Segment;
use super::program::Program;
use super::signals::percent;
use super::snapshot::Mode;
use super::state::{Once, Over, Queued, Sim};
use crate::drives::speed::stage_for;
use crate::interp::canon::{AXES, Target};
use crate::interp::{Canon, Feed};
use crate::math;
use crate::msg;
use crate::text::Diagnostic;

/// Seconds between two measurements while spindle and axes follow one another and change.
pub(super) const MEASURE: f64 = 0.01;

/// Turns that nobody misses.
const TURNED: f64 = 1e-9;

/// What the executor is at.
#[derive(Debug, Clone)]
pub(super) enum Exec {
    /// Takes the next command as soon as it is ready.
    Idle,
    /// Moves.
    Moving(Box<Move>),
    /// Waits for the spindle's speed, before this movement.
    Spinning(Box<Move>),
    /// Lets the axes settle until then.
    Settling(f64),
    /// Waits for standstill until then, before this command.
    Resting(f64, Canon),
    /// Dwells until then.
    Dwelling(f64),
    /// Dwells until the spindle has turned from there so far, in turns.
    Counting(f64, f64),
    /// Waits for the PLC.
    Fin,
    /// Waits for cycle start, then goes on.
    Stopped,
    /// After reset: cycle start begins at the head of the program.
    Ready,
    /// The program is over.
    Finished,
    /// Alarm of the program; needs reset.
    Alarm(Box<Diagnostic>),
    /// Emergency stop; needs reset.
    Emergency(Box<Diagnostic>),
    /// The budget is used up.
    OutOfBlocks,
}

impl Exec {
    /// Whether the program runs (it may be held).
    pub(super) fn runs(&self) -> bool {
        use Exec::{Alarm, Emergency, Finished, OutOfBlocks, Ready, Stopped};
        !matches!(self, Stopped | Ready | Finished | Alarm(_) | Emergency(_) | OutOfBlocks)
    }

    /// Whether a thread is being cut, which no hold interrupts.
    pub(super) fn threads(&self) -> bool {
        matches!(self, Exec::Moving(motion) if matches!(motion.pace, Pace::Thread(_)))
    }

    pub(super) fn mode(&self, holding: bool) -> Mode {
        match self {
            Exec::Stopped | Exec::Ready => Mode::Stopped,
            Exec::Finished | Exec::OutOfBlocks => Mode::Ended,
            Exec::Alarm(_) => Mode::Alarm,
            Exec::Emergency(_) => Mode::EmergencyStop,
            Exec::Fin => Mode::WaitFin,
            _ if holding => Mode::Hold,
            Exec::Dwelling(_) | Exec::Counting(..) => Mode::Dwell,
            _ => Mode::Running,
        }
    }
}

impl<P: Program> Sim<'_, P> {
    /// Feed hold, unless the program has switched it off or cuts a thread.
    pub(super) fn holding(&self) -> bool {
        self.s.held && !self.s.suppress_hold && self.s.exec.runs() && !self.s.exec.threads()
    }

    /// When the axes stand.
    pub(super) fn rest_time(&self) -> f64 {
        self.s.rest_since + self.machine.standstill
    }

    pub(super) fn executor_time(&self) -> f64 {
        let s = &*self.s;
        match &s.exec {
            Exec::Idle if self.holding() => f64::INFINITY,
            Exec::Idle => match (s.queue.front(), &s.over) {
                (next, _) if self.orients() && next.is_none_or(|next| next.first || next.canon.is_cut().is_none()) => {
                    f64::INFINITY
                }
                (Some(queued), _) => queued.ready.max(s.now),
                (None, Some(_)) => s.read_at.max(s.now).max(self.rest_time()),
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
        match &mut self.s.exec {
            Exec::Idle => self.begin_next(t),
            Exec::Moving(motion) => {
                let (end, exact, pace) = (motion.end, motion.exact, motion.pace);
                if motion.end_time() <= t {
                    self.arrive(t, end, exact, pace);
                } else {
                    self.pace(t);
                }
            }
            Exec::Spinning(_) => {
                if let Exec::Spinning(motion) = core::mem::replace(&mut self.s.exec, Exec::Idle) {
                    self.begin(t, *motion);
                }
            }
            Exec::Resting(_, canon) => {
                let canon = core::mem::replace(canon, Canon::Stop);
                self.perform(t, canon);
            }
            Exec::Settling(_) | Exec::Dwelling(_) => self.s.exec = Exec::Idle,
            Exec::Counting(from, turns) => {
                let (from, turns) = (*from, *turns);
                if self.turns_left(t, from, turns) <= 0.0 {
                    self.s.exec = Exec::Idle;
                }
            }
            _ => {}
        }
    }

    fn begin_next(&mut self, t: f64) {
        let Some(next) = self.s.queue.front() else {
            self.s.exec = match self.s.over.clone() {
                Some(Over::Alarm(diagnostic)) => {
                    self.out.diagnostics.push((*diagnostic).clone());
                    Exec::Alarm(diagnostic)
                }
                Some(Over::Blocks) => {
                    self.out
                        .diagnostics
                        .push(Diagnostic::warning(msg!("motion.out-of-blocks", self.machine.limits.blocks as f64)));
                    Exec::OutOfBlocks
                }
                Some(Over::Program) | None => Exec::Finished,
            };
            return;
        };
        if next.first && self.s.stepped && self.s.knobs.single_block && !self.s.suppress_single_block {
            self.s.exec = Exec::Stopped;
            self.s.flow_end = None;
            return;
        }
        let Some(Queued { canon, place, first, .. }) = self.pop() else { return };
        self.s.stepped |= first;
        self.s.place = Some(place);
        match canon {
            Canon::Rapid { to } => {
                let end = self.goal(&to);
                let motion = Move::line(self.s.position, end, Pace::Rapid, true, &self.machine.axes);
                self.begin(t, motion);
            }
            Canon::Linear { to, feed, exact } => {
                let end = self.goal(&to);
                let motion = Move::line(self.s.position, end, Pace::Feed(feed), exact, &self.machine.axes);
                self.cut(t, motion);
            }
            Canon::Thread { to, lead } => {
                let end = self.goal(&to);
                let motion = Move::line(self.s.position, end, Pace::Thread(lead), false, &self.machine.axes);
                self.cut(t, motion);
            }
            Canon::Arc { to, plane, center, clockwise, feed, exact } => {
                let end = self.goal(&to);
                let scale = |axis: u8| self.machine.scale.get(axis as usize).copied().unwrap_or(0.0);
                let center = (center.0 * scale(plane.0), center.1 * scale(plane.1));
                let axes = &self.machine.axes;
                let motion = Move::line(self.s.position, end, Pace::Feed(feed), exact, axes);
                self.cut(t, motion.around(plane, center, clockwise, axes));
            }
            Canon::SurfaceSpeed { speed, axis, zero } => {
                self.begin_surface(t, speed, axis, zero);
            }
            Canon::ConstantSpeed => self.end_surface(t),
            Canon::SpeedLimit { limit, rpm } => {
                self.s.turning.limit(limit, rpm);
                self.follow(t);
            }
            Canon::Orient { angle, approach } => self.orient(t, angle, approach),
            Canon::OtherSpindle { sign, .. } => self.s.turning.driven = sign != 0,
            // These only say that the interpreter has changed its mind, or have acted when they were read.
            Canon::Preset { .. } | Canon::PathMode { .. } | Canon::Show { .. } => {}
            Canon::Output { .. } | Canon::Suppress { .. } | Canon::SuppressWaits { .. } => {}
            Canon::OptionalStop if !self.s.knobs.optional_stop => {}
            _ => {
                self.s.flow_end = None;
                let rest = self.rest_time();
                if rest > t {
                    self.s.exec = Exec::Resting(rest, canon);
                } else {
                    self.perform(t, canon);
                }
            }
        }
    }

    fn pop(&mut self) -> Option<Queued> {
        let queued = self.s.queue.pop_front()?;
        self.s.ahead -= usize::from(queued.first);
        Some(queued)
    }

    /// Where a movement ends, in mm.
    fn goal(&mut self, to: &Target) -> [f64; AXES] {
        for k in 0..AXES {
            if to.mask & !self.machine.fitted & (1 << k) != 0 {
                let letter = self.machine.axes[k].letter as char;
                self.say(Once::Missing as u32 + k as u32, || msg!("motion.missing-axis", letter.to_string()));
            }
        }
        let scale = &self.machine.scale;
        core::array::from_fn(|k| {
            if to.mask & (1 << k) != 0 { to.position[k] as f64 * scale[k] } else { self.s.position[k] }
        })
    }

    /// Does a command that needs the axes at rest.
    fn perform(&mut self, t: f64, canon: Canon) {
        self.s.exec = Exec::Idle;
        match canon {
            Canon::Dwell { seconds } => self.s.exec = Exec::Dwelling(t + seconds.max(0.0)),
            Canon::DwellTurns { turns } => self.s.exec = Exec::Counting(self.turns(t), turns.max(0.0)),
            Canon::Stop | Canon::OptionalStop | Canon::Message { .. } => self.s.exec = Exec::Stopped,
            Canon::End => {
                self.s.exec = Exec::Finished;
                if self.machine.spindle.rules.end_stops {
                    (self.s.turning.speed, self.s.turning.direction) = (0.0, 0);
                    self.follow(t);
                }
            }
            _ => {
                self.strobe(canon);
                // S, M and T of one block are put out together (reference/mitsubishi-e60.md section 5).
                while self.s.queue.front().is_some_and(|next| !next.first && next.ready <= t && self.free(&next.canon))
                {
                    if let Some(next) = self.pop() {
                        self.strobe(next.canon);
                    }
                }
                self.s.io.fin = false;
                if !self.s.suppress_fin {
                    self.s.exec = Exec::Fin;
                }
                self.scan(t);
            }
        }
    }

    /// Whether a code can be put out beside those that wait.
    fn free(&self, canon: &Canon) -> bool {
        match canon {
            Canon::SpindleSpeed { .. } => self.s.io.s_strobe.is_none(),
            Canon::SpindleDirection { .. } | Canon::Auxiliary { .. } | Canon::Gear { .. } => {
                self.s.io.m_strobe.is_none()
            }
            Canon::Tool { .. } => self.s.io.t_strobe.is_none(),
            _ => false,
        }
    }

    fn strobe(&mut self, canon: Canon) {
        match canon {
            Canon::SpindleSpeed { rpm } => {
                let turning = &mut self.s.turning;
                turning.surface = None;
                turning.speed = rpm.max(0.0);
                self.s.io.s_strobe = Some(rpm);
                if turning.automatic
                    && let Some(stage) = stage_for(self.machine.spindle.stages(), self.s.io.gear, rpm)
                    && stage != self.s.io.gear
                {
                    self.s.io.gear_wanted = Some(stage);
                }
            }
            Canon::Gear { stage } => {
                self.s.turning.automatic = stage == 0;
                self.s.io.m_strobe = Some(40 + u32::from(stage));
                let count = self.machine.spindle.stage_count;
                if stage > count {
                    self.say(Once::NoStage as u32, || msg!("motion.no-stage", u32::from(stage), u32::from(count)));
                } else if stage > 0 {
                    self.s.io.gear_wanted = Some(stage);
                }
            }
            Canon::SpindleDirection { sign } => {
                self.s.turning.orienting = None;
                self.s.turning.direction = sign.signum();
                self.s.turning.locked = false;
                self.s.io.m_strobe = Some(match sign.signum() {
                    1 => 3,
                    -1 => 4,
                    _ => 5,
                });
            }
            Canon::Auxiliary { code } => {
                let rules = &self.machine.spindle.rules;
                let turning = &mut self.s.turning;
                // Tool changes and coolant lock nothing.
                turning.locked |= rules.lock.map_or(!matches!(code, 6..=9), |lock| lock == code);
                turning.driven |= rules.driven_tool == Some(code);
                self.s.io.m_strobe = Some(code);
            }
            Canon::Tool { code } => self.s.io.t_strobe = Some(code),
            _ => {}
        }
    }

    /// A cut begins, or waits for the spindle's speed, where the control does so.
    fn cut(&mut self, t: f64, motion: Move) {
        let turning = &self.s.turning;
        if turning.orienting.is_some() && motion.length > 0.0 {
            let (locked, driven) = (turning.locked, turning.driven || self.machine.spindle.driven_tool);
            if !locked {
                self.say(Once::NotLocked as u32, || msg!("motion.not-locked"));
            }
            if !driven {
                self.say(Once::NoDrivenTool as u32, || msg!("motion.no-driven-tool"));
            }
        }
        if self.feeds_into_standing_work(&motion) {
            self.say(Once::Standing as u32, || msg!("motion.standing-work"));
        }
        if self.machine.spindle.rules.reached.is_some() {
            self.aim_at_cut(t);
            if self.speed_time() > t {
                self.s.flow_end = None;
                self.s.exec = Exec::Spinning(Box::new(motion));
                return;
            }
        }
        self.begin(t, motion);
    }

    /// Whether a movement ends deeper in the work than it began while neither the spindle nor an axis of the PLC turns.
    fn feeds_into_standing_work(&self, motion: &Move) -> bool {
        let turns = self.s.turning.direction != 0 || self.s.io.pmc_speed.iter().any(|rpm| *rpm != 0.0);
        let along = |letter: u8| {
            let axis = self.machine.axes.iter().position(|axis| axis.letter == letter);
            axis.map_or((0.0, 0.0), |k| (motion.start[k], motion.end[k]))
        };
        let (x, z) = (along(b'X'), along(b'Z'));
        !turns && x.1.abs() < self.machine.stock && z.1 < 0.0 && (x.1.abs() < x.0.abs() || z.1 < z.0)
    }

    fn begin(&mut self, t: f64, motion: Move) {
        if motion.length <= 0.0 {
            self.s.position = motion.end;
            return;
        }
        if self.s.flow_end.take().is_some_and(|end| t > end) {
            self.s.starved += 1;
            let (block, logic) = (self.machine.block_time * 1e3, self.machine.macro_time * 1e3);
            self.say(Once::Starved as u32, || msg!("motion.starved", block, logic));
        }
        if let Pace::Feed(Feed::PerMinute(feed)) = motion.pace {
            self.say_clamped(&motion, feed);
        }
        self.s.exec = Exec::Moving(Box::new(motion));
        self.s.moving = true;
        self.put_segment(t);
        self.aim_at_motion(t);
        self.follow(t);
    }

    /// Says once an axis that it is too slow for a feed in mm/min.
    fn say_clamped(&mut self, motion: &Move, feed: f64) {
        let slowed = motion.limit * 60.0;
        if feed > slowed * (1.0 + 1e-9) {
            let axis = self.machine.axes[motion.limiting];
            let letter = axis.letter as char;
            self.say(Once::Clamp as u32 + motion.limiting as u32, || {
                msg!("motion.axis-clamp", letter.to_string(), axis.clamp, feed, slowed)
            });
        }
    }

    /// Gives a movement the speed that it may have now, where that has changed.
    pub(super) fn pace(&mut self, t: f64) {
        let asked = self.asked_speed(t);
        let Exec::Moving(motion) = &mut self.s.exec else { return };
        if asked.0.min(motion.limit) == motion.speed {
            motion.again = asked.1;
            self.say_standing();
        } else {
            self.put_segment(t);
        }
    }

    /// Starts a segment of the path at `t`.
    fn put_segment(&mut self, t: f64) {
        let (asked, again) = self.asked_speed(t);
        let Exec::Moving(motion) = &mut self.s.exec else { return };
        motion.set_speed(t, asked.min(motion.limit));
        motion.again = again;
        let (segment, circle) = motion.segment();
        let motion = **motion;
        self.out.timeline.put_segment(segment, circle);
        self.watch(t);
        if matches!(motion.pace, Pace::Thread(_) | Pace::Feed(Feed::PerRevolution(_))) {
            self.say_clamped(&motion, asked * 60.0);
            self.say_standing();
        }
    }

    /// Says once that a feed per revolution waits for a spindle that stands, or that nothing measures.
    fn say_standing(&mut self) {
        if self.waits_for_spindle() {
            let (once, message) = match self.machine.spindle.encoder {
                true => (Once::SpindleStands, msg!("motion.spindle-stands")),
                false => (Once::NoEncoder, msg!("motion.no-encoder")),
            };
            self.say(once as u32, || message);
        }
    }

    /// Whether a feed per revolution stands still because the spindle does.
    pub(super) fn waits_for_spindle(&self) -> bool {
        let Exec::Moving(motion) = &self.s.exec else { return false };
        let by_turns = matches!(motion.pace, Pace::Thread(_) | Pace::Feed(Feed::PerRevolution(_)));
        let stands = self.measured(self.s.now) == 0.0;
        by_turns && stands && motion.speed == 0.0 && !motion.again.is_finite() && !self.holding()
    }

    /// Path speed in mm/s that override, spindle and hold ask for at `t`, clamps apart, and when to ask again.
    fn asked_speed(&self, t: f64) -> (f64, f64) {
        let Exec::Moving(motion) = &self.s.exec else { return (0.0, f64::INFINITY) };
        if self.holding() {
            return (0.0, f64::INFINITY);
        }
        let cutting = if self.s.suppress_override { 1.0 } else { percent(self.s.knobs.feed) / 100.0 };
        match motion.pace {
            Pace::Rapid => (motion.limit * (percent(self.s.knobs.rapid) / 100.0).min(1.0), f64::INFINITY),
            Pace::Feed(Feed::PerMinute(feed)) => (feed.max(0.0) * cutting / 60.0, f64::INFINITY),
            Pace::Feed(Feed::PerRevolution(feed)) => self.in_step(t, feed.max(0.0) * cutting),
            Pace::Thread(lead) => self.in_step(t, lead.max(0.0)),
        }
    }

    /// Path speed of a feed in mm per revolution. While the spindle changes its speed the feed follows in steps, each with the mean speed
    /// of its span.
    fn in_step(&self, t: f64, feed: f64) -> (f64, f64) {
        let reached = self.s.turning.reached_at;
        let again = if reached.is_finite() { reached.min(t + MEASURE) } else { f64::INFINITY };
        let middle = if again.is_finite() { 0.5 * (t + again) } else { t };
        (feed * self.measured(middle) / 60.0, again)
    }

    /// Speed of the spindle in r/min as its encoder measures it, without sign; 0 without encoder.
    fn measured(&self, t: f64) -> f64 {
        let plant = &self.machine.spindle;
        let ramp = self.out.timeline.ramps.last().filter(|_| plant.encoder);
        ramp.map_or(0.0, |ramp| ramp.actual(plant, t).abs())
    }

    /// Turns of the spindle since the run began.
    fn turns(&self, t: f64) -> f64 {
        self.out.timeline.ramps.last().map_or(0.0, |ramp| ramp.turns(&self.machine.spindle, t))
    }

    /// Turns that a dwell still has to wait for.
    fn turns_left(&self, t: f64, from: f64, turns: f64) -> f64 {
        let left = turns - (self.turns(t) - from).abs();
        if left > TURNED { left } else { 0.0 }
    }

    /// When a dwell may have had its turns; looked at again while the spindle changes its speed.
    fn turns_time(&self, from: f64, turns: f64) -> f64 {
        let t = self.s.now;
        let (left, rpm) = (self.turns_left(t, from, turns), self.measured(t));
        let next = if rpm > 0.0 { t + (left * 60.0 / rpm).max(1e-6) } else { f64::INFINITY };
        let changes = self.s.turning.reached_at.is_finite();
        if left <= 0.0 {
            t
        } else if changes {
            next.min(t + MEASURE)
        } else {
            next
        }
    }

    /// When the spindle is fast enough for a cut.
    fn speed_time(&self) -> f64 {
        let plant = &self.machine.spindle;
        let (Some(part), Some(ramp)) = (plant.rules.reached, self.out.timeline.ramps.last()) else { return self.s.now };
        let looked = if ramp.told.span > 0.0 { ramp.t } else { ramp.t + plant.reached_delay };
        if self.s.turning.direction == 0 { self.s.now } else { ramp.within(part).max(looked) }
    }

    /// The unfiltered path has come to the end of a block.
    fn arrive(&mut self, t: f64, end: [f64; AXES], exact: bool, pace: Pace) {
        self.s.position = end;
        self.s.exec = Exec::Idle;
        self.s.flow_end = (!exact).then_some(t);
        if let Pace::Thread(_) = pace {
            self.follow(t);
        }
        if !exact || (self.s.suppress_exact && pace != Pace::Rapid) {
            return;
        }
        self.rest(t);
        let mut until = self.rest_time();
        if pace != Pace::Rapid {
            for (k, axis) in self.machine.axes.iter().enumerate() {
                // From standstill of the command on, the axis closes in exponentially.
                let still = t + axis.time_constant;
                let state = self.out.timeline.path.axis(k, axis, still);
                let left = (state.position - state.actual).abs();
                if left > self.machine.in_position {
                    until = until.max(still + math::ln(left / self.machine.in_position) / axis.position_gain);
                }
            }
        }
        self.s.exec = Exec::Settling(until);
    }

    /// Breaks off what the program does: the path ends here.
    pub(super) fn break_off(&mut self, t: f64) {
        if let Exec::Moving(motion) = &mut self.s.exec {
            motion.set_speed(t, 0.0);
            self.s.position = motion.segment().0.from;
        }
        self.s.exec = Exec::Ready;
        self.rest(t);
    }

    /// Ends the path with a standstill where nothing moves it on.
    pub(super) fn rest(&mut self, t: f64) {
        if self.s.moving && !matches!(self.s.exec, Exec::Moving(_)) {
            self.s.moving = false;
            self.s.rest_since = t;
            let segment = Segment { t, from: self.s.position, velocity: [0.0; AXES], circle: 0 };
            self.out.timeline.put_segment(segment, None);
            self.watch(t);
        }
    }
}

//! The simulation between two events: reader, executor, spindle, PLC and operator, always the earliest first.

use std::collections::{BTreeMap, VecDeque};

use super::executor::Exec;
use super::panel::{Action, Panel};
use super::plan::{Limits, RunEnd};
use super::plant::{AxisPlant, Plant, SpindlePlant};
use super::plc::{Io, Plc};
use super::program::Program;
use super::snapshot::Mode;
use super::timeline::{Lengths, Mark, Timeline};
use crate::controls::{Alarm, Control};
use crate::interp::canon::AXES;
use crate::interp::{Canon, End, World};
use crate::msg;
use crate::text::{Diagnostic, Message, Place};

/// Every block takes some time, so that time passes in a loop that waits.
const LEAST_BLOCK_TIME: f64 = 1e-4;

/// What stays the same during a run.
#[derive(Debug, Clone)]
pub(super) struct Machine {
    pub(super) axes: [AxisPlant; AXES],
    pub(super) spindle: SpindlePlant,
    /// Millimetres per command increment.
    pub(super) increment: f64,
    pub(super) block_time: f64,
    pub(super) macro_time: f64,
    pub(super) preread: usize,
    pub(super) in_position: f64,
    /// Seconds from the end of the unfiltered path to standstill of the slowest axis.
    pub(super) standstill: f64,
    pub(super) limits: Limits,
    pub(super) emergency: Option<&'static str>,
    /// Number of axes that the machine has.
    pub(super) fitted: usize,
    pub(super) log: bool,
}

impl Machine {
    /// Values that are no number or make no sense become harmless ones: no run ever fails over its plant.
    pub(super) fn new(control: &Control, plant: &Plant, limits: Limits, log: bool) -> Machine {
        let positive = |x: f64, otherwise: f64| if x > 0.0 && x.is_finite() { x } else { otherwise };
        let axes: [AxisPlant; AXES] = core::array::from_fn(|k| {
            let letter = control.axes.get(k).map_or(b'?', |axis| axis.letter);
            // An axis that the machine lacks moves without inertia, so that the program can be watched; a diagnostic says so.
            let missing =
                AxisPlant { letter, rotary: false, rapid: 1e6, clamp: 1e6, time_constant: 0.0, position_gain: 0.0 };
            let axis = plant.axes.get(k).copied().unwrap_or(missing);
            AxisPlant {
                rapid: positive(axis.rapid, missing.rapid),
                clamp: positive(axis.clamp, missing.clamp),
                time_constant: positive(axis.time_constant, 0.0),
                position_gain: positive(axis.position_gain, 0.0),
                ..axis
            }
        });
        let spindle = SpindlePlant {
            speed_at_full: positive(plant.spindle.speed_at_full, 1.0),
            speed_clamp: positive(plant.spindle.speed_clamp, 0.0),
            ramp: positive(plant.spindle.ramp, 0.0),
            gain: positive(plant.spindle.gain, 1.0),
            slip: if plant.spindle.slip.is_finite() { plant.spindle.slip } else { 0.0 },
            ..plant.spindle
        };
        Machine {
            standstill: axes.iter().map(|axis| axis.time_constant).fold(0.0, f64::max),
            axes,
            spindle,
            increment: control.limits.increment,
            block_time: positive(plant.block_time, 0.0).max(LEAST_BLOCK_TIME),
            macro_time: positive(plant.macro_time, 0.0).max(LEAST_BLOCK_TIME),
            preread: usize::from(plant.preread.max(1)),
            in_position: positive(plant.in_position, 1e-6),
            limits,
            emergency: control.alarm_number(Alarm::EmergencyStop),
            fitted: plant.axes.len(),
            log,
        }
    }
}

/// What a run leaves behind; cut to [`Marks`] when the past changes.
#[derive(Debug, Clone)]
pub(super) struct Records {
    pub(super) timeline: Timeline,
    pub(super) log: VecDeque<(f64, Canon, Place)>,
    /// Log entries that were taken away.
    pub(super) taken: usize,
    pub(super) diagnostics: Vec<Diagnostic>,
}

/// Lengths of the records at a checkpoint.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Marks {
    timeline: Lengths,
    log: usize,
    diagnostics: usize,
}

impl Marks {
    /// Number of changes of variables.
    pub(super) fn changes(&self) -> usize {
        self.timeline.changes
    }
}

impl Records {
    pub(super) fn logged(&self) -> usize {
        self.taken + self.log.len()
    }

    pub(super) fn marks(&self) -> Marks {
        Marks { timeline: self.timeline.lengths(), log: self.logged(), diagnostics: self.diagnostics.len() }
    }

    pub(super) fn truncate(&mut self, marks: &Marks) {
        self.timeline.truncate(&marks.timeline);
        self.log.truncate(marks.log.saturating_sub(self.taken));
        self.diagnostics.truncate(marks.diagnostics);
    }
}

/// The PLC with its state.
#[derive(Debug)]
pub(super) struct Logic(pub(super) Box<dyn Plc>);

impl Clone for Logic {
    fn clone(&self) -> Logic {
        Logic(self.0.boxed())
    }
}

impl core::fmt::Debug for dyn Plc {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("Plc")
    }
}

/// A command that was read and not yet begun.
#[derive(Debug, Clone)]
pub(super) struct Queued {
    pub(super) canon: Canon,
    pub(super) place: Place,
    /// When it is read to the end.
    pub(super) ready: f64,
    /// First command of its block.
    pub(super) first: bool,
    /// Its number in the log.
    pub(super) logged: usize,
}

/// Why nothing more is read.
#[derive(Debug, Clone)]
pub(super) enum Over {
    /// The program has ended.
    Program,
    /// An alarm of the program.
    Alarm(Box<Diagnostic>),
    /// The budget of blocks is used up.
    Blocks,
}

impl From<End> for Over {
    fn from(end: End) -> Over {
        match end {
            End::Program => Over::Program,
            End::Alarm(diagnostic) => Over::Alarm(diagnostic),
        }
    }
}

/// Positions of the operator's switches.
#[derive(Debug, Clone, Copy)]
pub(super) struct Knobs {
    pub(super) feed: f64,
    pub(super) rapid: f64,
    pub(super) single_block: bool,
    pub(super) optional_stop: bool,
    pub(super) block_skip: bool,
}

/// Diagnostics that are said once a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Once {
    Starved,
    SpindleClamp,
    Clamp = 8,
    Missing = 16,
}

/// All that changes; a clone goes on exactly as the original would.
#[derive(Debug, Clone)]
pub(super) struct State<P> {
    /// Time of the newest event.
    pub(super) now: f64,
    pub(super) started: bool,
    pub(super) program: P,
    /// When the reader takes the next step.
    pub(super) read_at: f64,
    /// The reader waits until all is executed and the axes stand.
    pub(super) drain: bool,
    pub(super) over: Option<Over>,
    pub(super) queue: VecDeque<Queued>,
    /// Blocks in the queue.
    pub(super) ahead: usize,
    pub(super) exec: Exec,
    pub(super) place: Option<Place>,
    /// Commanded position at the end of the last movement, mm; exactly where a movement was broken off.
    pub(super) position: [f64; AXES],
    /// When the unfiltered path came to rest.
    pub(super) rest_since: f64,
    pub(super) moving: bool,
    /// End of a movement that the next should follow at once.
    pub(super) flow_end: Option<f64>,
    pub(super) held: bool,
    /// A block was begun since cycle start.
    pub(super) stepped: bool,
    pub(super) suppress_hold: bool,
    pub(super) suppress_override: bool,
    pub(super) suppress_exact: bool,
    pub(super) knobs: Knobs,
    /// Events of the panel that have happened.
    pub(super) panel_done: usize,
    pub(super) plc: Logic,
    pub(super) plc_at: f64,
    pub(super) io: Io,
    /// S word in r/min and direction.
    pub(super) speed: f64,
    pub(super) direction: i8,
    /// End of the spindle's ramp.
    pub(super) reached_at: f64,
    pub(super) run_since: Option<f64>,
    pub(super) run_time: f64,
    pub(super) starved: u64,
    /// Bits of [`Once`].
    pub(super) said: u32,
    pub(super) mode: Mode,
}

impl<P> State<P> {
    pub(super) fn new(program: P, plc: Box<dyn Plc>) -> State<P> {
        State {
            now: 0.0,
            started: false,
            program,
            read_at: 0.0,
            drain: false,
            over: None,
            queue: VecDeque::new(),
            ahead: 0,
            exec: Exec::Idle,
            place: None,
            position: [0.0; AXES],
            rest_since: f64::NEG_INFINITY,
            moving: false,
            flow_end: None,
            held: false,
            stepped: false,
            suppress_hold: false,
            suppress_override: false,
            suppress_exact: false,
            knobs: Knobs { feed: 100.0, rapid: 100.0, single_block: false, optional_stop: false, block_skip: false },
            panel_done: 0,
            plc: Logic(plc),
            plc_at: f64::INFINITY,
            io: Io::default(),
            speed: 0.0,
            direction: 0,
            reached_at: f64::INFINITY,
            run_since: None,
            run_time: 0.0,
            starved: 0,
            said: 0,
            mode: Mode::Running,
        }
    }
}

/// Who acts next; in this order where times are equal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Who {
    PowerOn,
    Operator,
    Plc,
    Spindle,
    Reader,
    Executor,
}

/// A state with all that its events touch.
pub(super) struct Sim<'a, P> {
    pub(super) s: &'a mut State<P>,
    pub(super) machine: &'a Machine,
    pub(super) out: &'a mut Records,
    pub(super) panel: &'a Panel,
}

/// What a program sees of the machine when one of its blocks is read.
struct Eyes<'a> {
    inputs: &'a BTreeMap<u32, f64>,
    position: &'a [f64; AXES],
    power_on: f64,
    running: f64,
    block_skip: bool,
    changes: Vec<(u32, Option<f64>)>,
}

impl World for Eyes<'_> {
    fn input(&mut self, variable: u32) -> f64 {
        self.inputs.get(&variable).copied().unwrap_or(0.0)
    }

    fn clock_ms(&mut self, run: bool) -> f64 {
        1000.0 * if run { self.running } else { self.power_on }
    }

    fn position(&mut self, axis: usize) -> f64 {
        self.position.get(axis).copied().unwrap_or(0.0)
    }

    fn block_skip(&mut self, _number: u8) -> bool {
        self.block_skip
    }

    fn changed(&mut self, variable: u32, value: Option<f64>) {
        self.changes.push((variable, value));
    }
}

impl<P: Program> Sim<'_, P> {
    /// The earliest event: its time and whose it is; infinite where nothing will happen by itself.
    pub(super) fn next(&self) -> (f64, Who) {
        if !self.s.started {
            return (0.0, Who::PowerOn);
        }
        let operator = self.panel.events().get(self.s.panel_done);
        let operator_at = operator.map_or(f64::INFINITY, |event| event.t);
        let mut next = (f64::INFINITY, Who::Operator);
        // Cycle start finds what has happened until then: pressed at the very moment of a stop, it answers the stop.
        let start = operator.is_some_and(|event| event.action == Action::Start);
        let first = if start { f64::INFINITY } else { operator_at };
        for (t, who) in [
            (first, Who::Operator),
            (self.s.plc_at, Who::Plc),
            (self.s.reached_at, Who::Spindle),
            (self.reader_time(), Who::Reader),
            (self.executor_time(), Who::Executor),
            (operator_at, Who::Operator),
        ] {
            if t < next.0 {
                next = (t, who);
            }
        }
        next
    }

    /// Lets one event happen.
    pub(super) fn happen(&mut self, t: f64, who: Who) {
        self.s.now = t;
        match who {
            Who::PowerOn => self.power_on(),
            Who::Operator => self.operate(t),
            Who::Plc => self.scan(t),
            Who::Spindle => {
                self.s.reached_at = f64::INFINITY;
                self.scan(t);
                self.pace(t);
            }
            Who::Reader => self.read(t),
            Who::Executor => self.execute(t),
        }
        self.rest(t);
        self.mark(t);
    }

    /// Whether the run is over unless the operator does something: then how.
    pub(super) fn end(&self) -> Option<RunEnd> {
        if self.s.panel_done < self.panel.events().len() || !self.s.started {
            return None;
        }
        match &self.s.exec {
            Exec::Stopped | Exec::Ready => Some(RunEnd::Stop),
            Exec::Finished => Some(RunEnd::ProgramEnd),
            Exec::Alarm(diagnostic) | Exec::Emergency(diagnostic) => Some(RunEnd::Alarm(diagnostic.clone())),
            Exec::OutOfBlocks => Some(RunEnd::Blocks),
            Exec::Moving(_) | Exec::Idle if self.holding() => Some(RunEnd::Stop),
            _ => None,
        }
    }

    /// Why nothing will ever happen again although the program is not over.
    pub(super) fn stuck(&self) -> Diagnostic {
        let message = match self.s.exec {
            Exec::Fin => msg!("motion.no-fin"),
            _ => msg!("motion.no-feed"),
        };
        Diagnostic { place: self.s.place, ..Diagnostic::warning(message) }
    }

    fn power_on(&mut self) {
        self.s.started = true;
        self.put_ramp(0.0, 0.0, 0.0);
        self.s.moving = true;
        self.rest(0.0);
        self.s.rest_since = f64::NEG_INFINITY;
        self.scan(0.0);
    }

    /// Takes one step of the program.
    fn read(&mut self, t: f64) {
        let before = self.s.program.blocks();
        if before.nc + before.macros >= self.machine.limits.blocks {
            self.s.over = Some(Over::Blocks);
            return;
        }
        if self.s.drain {
            self.s.drain = false;
            self.s.flow_end = None;
        }
        let running = self.run_time(t);
        let s = &mut *self.s;
        let mut eyes = Eyes {
            inputs: &s.io.inputs,
            position: &s.position,
            power_on: t,
            running,
            block_skip: s.knobs.block_skip,
            changes: Vec::new(),
        };
        let step = s.program.step(&mut eyes);
        for (number, value) in eyes.changes {
            self.out.timeline.changes.push(super::timeline::Change { t, number, value: value.unwrap_or(f64::NAN) });
        }
        let after = s.program.blocks();
        let (nc, macros) = (after.nc - before.nc.min(after.nc), after.macros - before.macros.min(after.macros));
        s.read_at = t + nc as f64 * self.machine.block_time + macros as f64 * self.machine.macro_time;
        self.take(t, step, nc + macros > 0);
    }

    fn take(&mut self, t: f64, step: crate::interp::Step, first: bool) {
        use crate::interp::Step;
        let (canon, place) = match step {
            Step::Command(canon, place) => (canon, place),
            Step::Logic(_) => return,
            Step::Sync(_) => {
                self.s.drain = true;
                return;
            }
            Step::Ended(end) => {
                self.s.over = Some(end.into());
                return;
            }
        };
        let logged = self.out.logged();
        if self.machine.log {
            self.out.log.push_back((t, canon.clone(), place));
        }
        match canon {
            // Macro statements act when they are read (reference/mitsubishi-e60.md section 4).
            Canon::Output { variable, value } => {
                self.s.io.outputs.insert(variable, value);
                self.scan(t);
            }
            Canon::Suppress { hold, feed_override, exact } => {
                self.s.suppress_hold = hold;
                self.s.suppress_override = feed_override;
                self.s.suppress_exact = exact;
                self.pace(t);
            }
            _ => {
                self.s.drain = matches!(canon, Canon::Stop | Canon::OptionalStop | Canon::Message { .. } | Canon::End);
                self.s.ahead += usize::from(first);
                self.s.queue.push_back(Queued { canon, place, ready: self.s.read_at, first, logged });
            }
        }
    }

    fn reader_time(&self) -> f64 {
        let s = &*self.s;
        let reads = s.exec.runs() || matches!(s.exec, Exec::Stopped);
        if !reads || s.over.is_some() || s.ahead >= self.machine.preread {
            return f64::INFINITY;
        }
        if !s.drain {
            return s.read_at.max(s.now);
        }
        if s.queue.is_empty() && matches!(s.exec, Exec::Idle) {
            s.read_at.max(s.now).max(self.rest_time())
        } else {
            f64::INFINITY
        }
    }

    /// Lets the PLC act until it and the spindle agree.
    pub(super) fn scan(&mut self, t: f64) {
        self.turn(t);
        // A PLC and a control that never agree are left for the next scan.
        for _ in 0..4 {
            self.s.io.spindle_actual =
                self.out.timeline.ramps.last().map_or(0.0, |ramp| ramp.actual(&self.machine.spindle, t));
            let wish = self.s.plc.0.scan(t, &mut self.s.io);
            // A PLC that wants to be asked at once is asked in its next cycle.
            self.s.plc_at = wish.map_or(f64::INFINITY, |wish| if wish > t { wish } else { t + 0.001 });
            let Io { forced, inputs, .. } = &mut self.s.io;
            for (name, value) in forced.iter() {
                if let Some(number) = name.strip_prefix('#').and_then(|digits| digits.parse().ok()) {
                    inputs.insert(number, *value);
                }
            }
            let answered = matches!(self.s.exec, Exec::Fin) && self.s.io.fin;
            if answered {
                let io = &mut self.s.io;
                (io.m_strobe, io.s_strobe, io.t_strobe) = (None, None, None);
                self.s.exec = Exec::Idle;
            }
            if !self.turn(t) && !answered {
                break;
            }
        }
    }

    /// Brings the spindle's command up to date; whether it changed.
    fn turn(&mut self, t: f64) -> bool {
        let plant = &self.machine.spindle;
        let wanted = self.s.speed * percent(self.s.io.spindle_override_out) / 100.0;
        let sign = f64::from(self.s.direction);
        if wanted > plant.speed_clamp && sign != 0.0 {
            self.say(Once::SpindleClamp as u32, || msg!("motion.spindle-clamp", wanted, plant.speed_clamp));
        }
        let command = if sign == 0.0 { 0.0 } else { sign * wanted.min(plant.speed_clamp) };
        if command == self.s.io.spindle_command {
            return false;
        }
        let now =
            self.out.timeline.ramps.last().map_or((0.0, 0.0), |ramp| (ramp.speed(plant, t), ramp.turns(plant, t)));
        self.s.io.spindle_command = command;
        self.put_ramp(t, now.0, now.1);
        self.pace(t);
        true
    }

    fn put_ramp(&mut self, t: f64, start: f64, turns: f64) {
        let plant = &self.machine.spindle;
        let command = self.s.io.spindle_command;
        // The output ends at full voltage, whatever the clamp allows.
        let target = command.clamp(-plant.speed_at_full, plant.speed_at_full);
        let ramp = super::spindle::Ramp { t, start, target, command, turns };
        let reached = ramp.reached(plant);
        self.s.reached_at = if reached > t { reached } else { f64::INFINITY };
        self.out.timeline.ramps.put(ramp);
    }

    /// Seconds of automatic running.
    fn run_time(&self, t: f64) -> f64 {
        self.s.run_time + self.s.run_since.map_or(0.0, |since| t - since)
    }

    /// Notes what the control does and in which block, where that changed.
    fn mark(&mut self, t: f64) {
        let mode = self.s.exec.mode(self.holding());
        let runs = self.s.exec.runs() && mode != Mode::Hold;
        if runs != self.s.run_since.is_some() {
            self.s.run_time = self.run_time(t);
            self.s.run_since = runs.then_some(t);
        }
        self.s.mode = mode;
        let mark = Mark { t, mode, place: self.s.place.unwrap_or_default(), begun: self.s.place.is_some() };
        let same = |last: &Mark| last.mode == mark.mode && last.begun == mark.begun && last.place == mark.place;
        if !self.out.timeline.marks.last().is_some_and(same) {
            self.out.timeline.marks.put(mark);
        }
    }

    /// Says something once a run.
    pub(super) fn say(&mut self, bit: u32, message: impl FnOnce() -> Message) {
        if self.s.said & (1 << bit) == 0 {
            self.s.said |= 1 << bit;
            let mut diagnostic = Diagnostic::warning(message());
            diagnostic.place = self.s.place;
            self.out.diagnostics.push(diagnostic);
        }
    }
}

/// An override in percent: 0 to 1000, 0 where it is no number.
pub(super) fn percent(value: f64) -> f64 {
    if value > 0.0 { value.min(1000.0) } else { 0.0 }
}

//! The simulation between two events: reader, executor, spindle, PLC and operator, always the earliest first.

use std::collections::{BTreeMap, VecDeque};

use super::executor::Exec;
use super::machine::Machine;
use super::panel::{Action, Panel};
use super::plan::RunEnd;
use super::plc::{Io, Plc};
use super::program::Program;
use super::snapshot::Mode;
use super::spindle::Told;
use super::timeline::{Lengths, Mark, Timeline};
use super::turning::Turning;
use crate::interp::canon::AXES;
use crate::interp::{Canon, End};
use crate::msg;
use crate::text::{Diagnostic, Message, Place};

/// What a run leaves behind; cut to [`Marks`] when the past changes.
#[derive(Debug, Clone)]
pub(super) struct Records {
    pub(super) timeline: Timeline,
    pub(super) log: VecDeque<(f64, Canon, Place)>,
    /// Log entries that were taken away.
    pub(super) taken: usize,
    pub(super) diagnostics: Vec<Diagnostic>,
    /// Number of the first log entry that whoever looks on asks for.
    pub(super) anew: usize,
}

/// Lengths of the records at a checkpoint.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Marks {
    pub(super) timeline: Lengths,
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

    /// Forgets the log but for its newest entries.
    pub(super) fn forget_log(&mut self, keep: usize) {
        while self.log.len() > keep {
            self.log.pop_front();
            self.taken += 1;
        }
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
    SpindleStands,
    OffCentre,
    NoStage,
    NoEncoder,
    NotLocked,
    NoDrivenTool,
    Clamp = 8,
    Missing = 16,
    Standing = 24,
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
    pub(super) suppress_single_block: bool,
    pub(super) suppress_fin: bool,
    pub(super) knobs: Knobs,
    /// Events of the panel that have happened.
    pub(super) panel_done: usize,
    pub(super) plc: Logic,
    pub(super) plc_at: f64,
    pub(super) io: Io,
    /// Macro inputs as the screen showed them last.
    pub(super) shown: BTreeMap<u32, f64>,
    /// What is commanded of the spindle.
    pub(super) turning: Turning,
    pub(super) run_since: Option<f64>,
    pub(super) run_time: f64,
    pub(super) starved: u64,
    /// Bits of [`Once`].
    pub(super) said: u32,
    pub(super) mode: Mode,
}

impl<P> State<P> {
    pub(super) fn new(program: P, plc: Box<dyn Plc>, square: Option<u8>) -> State<P> {
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
            suppress_single_block: false,
            suppress_fin: false,
            knobs: Knobs { feed: 100.0, rapid: 100.0, single_block: false, optional_stop: false, block_skip: false },
            panel_done: 0,
            plc: Logic(plc),
            plc_at: f64::INFINITY,
            io: Io::default(),
            shown: BTreeMap::new(),
            turning: Turning::new(square),
            run_since: None,
            run_time: 0.0,
            starved: 0,
            said: 0,
            mode: Mode::Running,
        }
    }

    /// Seconds of automatic running.
    pub(super) fn run_time_at(&self, t: f64) -> f64 {
        self.run_time + self.run_since.map_or(0.0, |since| t - since)
    }
}

/// Who acts next; in this order where times are equal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum EventSource {
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

impl<P: Program> Sim<'_, P> {
    /// The earliest event: its time and whose it is; infinite where nothing will happen by itself.
    pub(super) fn next(&self) -> (f64, EventSource) {
        if !self.s.started {
            return (0.0, EventSource::PowerOn);
        }
        let operator = self.panel.events().get(self.s.panel_done);
        let operator_at = operator.map_or(f64::INFINITY, |event| event.t);
        let mut next = (f64::INFINITY, EventSource::Operator);
        // Cycle start finds what has happened until then: pressed at the very moment of a stop, it answers the stop.
        let start = operator.is_some_and(|event| event.action == Action::Start);
        let first = if start { f64::INFINITY } else { operator_at };
        for (t, who) in [
            (first, EventSource::Operator),
            (self.s.plc_at, EventSource::Plc),
            (self.s.turning.next(), EventSource::Spindle),
            (self.reader_time(), EventSource::Reader),
            (self.executor_time(), EventSource::Executor),
            (operator_at, EventSource::Operator),
        ] {
            if t < next.0 {
                next = (t, who);
            }
        }
        next
    }

    /// Lets one event happen.
    pub(super) fn happen(&mut self, t: f64, who: EventSource) {
        self.s.now = t;
        match who {
            EventSource::PowerOn => self.power_on(),
            EventSource::Operator => self.operate(t),
            EventSource::Plc => self.scan(t),
            EventSource::Spindle => self.spindle(t),
            EventSource::Reader => self.read(t),
            EventSource::Executor => self.execute(t),
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
            // What the PLC lets coast, it follows to its rest.
            Exec::Emergency(_) if self.s.plc_at.is_finite() && self.s.io.pmc_speed.iter().any(|rpm| *rpm != 0.0) => {
                None
            }
            Exec::Alarm(diagnostic) | Exec::Emergency(diagnostic) => Some(RunEnd::Alarm(diagnostic.clone())),
            Exec::OutOfBlocks => Some(RunEnd::Blocks),
            Exec::Moving(_) | Exec::Spinning(_) | Exec::Idle if self.holding() => Some(RunEnd::Stop),
            _ => None,
        }
    }

    /// Why nothing will ever happen again although the program is not over, where that has not been said.
    pub(super) fn stuck(&self) -> Option<Diagnostic> {
        let message = match &self.s.exec {
            Exec::Fin => msg!("motion.no-fin"),
            Exec::Counting(..) => msg!("motion.spindle-stands"),
            _ if self.waits_for_spindle() => return None,
            _ => msg!("motion.no-feed"),
        };
        Some(Diagnostic { place: self.s.place, ..Diagnostic::warning(message) })
    }

    fn power_on(&mut self) {
        self.s.started = true;
        self.put_ramp(0.0, Told { stage: 1, ..Told::default() });
        self.s.moving = true;
        self.rest(0.0);
        self.s.rest_since = f64::NEG_INFINITY;
        self.scan(0.0);
    }

    /// Notes what the control does and in which block, where that changed.
    fn mark(&mut self, t: f64) {
        let mode = self.s.exec.mode(self.holding());
        let runs = self.s.exec.runs() && mode != Mode::Hold;
        if runs != self.s.run_since.is_some() {
            self.s.run_time = self.s.run_time_at(t);
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

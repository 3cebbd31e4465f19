//! The state of a simulation between two events, in parts: reader, path, operator, PLC, spindle.

use std::collections::{BTreeMap, VecDeque};

use super::exec::Exec;
use super::plc::{Io, Plc};
use super::snapshot::Mode;
use super::spindle_control::SpindleControl;
use crate::interp::canon::AXES;
use crate::interp::{Canon, End};
use crate::text::{Diagnostic, Place};

/// A command that is read and not yet begun.
#[derive(Debug, Clone)]
pub(super) struct Queued {
    pub(super) canon: Canon,
    pub(super) place: Place,
    /// Time (s) at which its block is read.
    pub(super) ready: f64,
    /// First command of its block.
    pub(super) first: bool,
    /// Number of its block, counted as blocks are read.
    pub(super) block: u64,
    /// Its number in the log.
    pub(super) logged: usize,
}

/// Reason why reading has ended.
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

/// The reader: commands read and not yet begun, and its next step.
#[derive(Debug, Clone, Default)]
pub(super) struct ReaderState {
    /// When the reader takes the next step (s).
    pub(super) next_step: f64,
    /// The reader waits until all is executed and the axes are at rest.
    pub(super) drains: bool,
    pub(super) over: Option<Over>,
    pub(super) queue: VecDeque<Queued>,
    /// Number of the block that is executed, counted as blocks are read.
    pub(super) executed: u64,
    /// Blocks in the queue.
    pub(super) ahead: usize,
}

/// The commanded path before acceleration.
#[derive(Debug, Clone)]
pub(super) struct PathState {
    /// Position at the end of the last movement, mm or °; exact also where a movement was broken off.
    pub(super) position: [f64; AXES],
    /// When the path came to rest (s).
    pub(super) rest_since: f64,
    pub(super) moving: bool,
    /// End (s) of a movement that the next should follow without a stop.
    pub(super) flow_end: Option<f64>,
    /// Position at the last preset of coordinates or limit of the speed that takes it for a reference point, mm or °.
    pub(super) reference: Option<[f64; AXES]>,
}

/// Codes by which a program switches parts of the operator panel and of the PLC off (`#3003`, `#3004`).
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Suppressed {
    pub(super) hold: bool,
    pub(super) feed_override: bool,
    pub(super) exact: bool,
    pub(super) single_block: bool,
    pub(super) fin: bool,
}

/// Positions of the operator's switches; overrides in percent.
#[derive(Debug, Clone, Copy)]
pub(super) struct Knobs {
    pub(super) feed: f64,
    pub(super) rapid: f64,
    pub(super) single_block: bool,
    pub(super) optional_stop: bool,
    pub(super) block_skip: bool,
}

/// The operator panel.
#[derive(Debug, Clone)]
pub(super) struct OperatorState {
    pub(super) knobs: Knobs,
    /// Feed hold was pressed.
    pub(super) held: bool,
    /// A block was begun since cycle start, for single block.
    pub(super) stepped: bool,
    /// Events of the panel that have happened.
    pub(super) events_done: usize,
}

/// The PLC program and its interface.
#[derive(Debug)]
pub(super) struct PlcState {
    pub(super) program: Box<dyn Plc>,
    /// When it asked for its next scan (s).
    pub(super) next_scan: f64,
    pub(super) io: Io,
    /// Macro inputs as recorded last.
    pub(super) shown: BTreeMap<u32, f64>,
}

impl Clone for PlcState {
    fn clone(&self) -> PlcState {
        PlcState {
            program: self.program.boxed(),
            next_scan: self.next_scan,
            io: self.io.clone(),
            shown: self.shown.clone(),
        }
    }
}

impl core::fmt::Debug for dyn Plc {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("Plc")
    }
}

/// The clock of automatic running.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct RunClock {
    /// Since when the program runs (s).
    pub(super) since: Option<f64>,
    /// Seconds of earlier runs.
    pub(super) total: f64,
}

/// State of the simulation; a clone continues exactly like the original.
#[derive(Debug, Clone)]
pub(super) struct SimState<P> {
    /// Time of the newest event (s).
    pub(super) now: f64,
    pub(super) started: bool,
    /// Time (s) of the end of the run, if only the operator can continue it; axes and spindle settle after it.
    pub(super) ended_at: Option<f64>,
    pub(super) program: P,
    pub(super) reader: ReaderState,
    pub(super) exec: Exec,
    /// The block that is executed.
    pub(super) place: Option<Place>,
    pub(super) path: PathState,
    pub(super) operator: OperatorState,
    pub(super) suppressed: Suppressed,
    pub(super) plc: PlcState,
    pub(super) spindle: SpindleControl,
    pub(super) clock: RunClock,
    /// Blocks that were read too late to follow without a stop.
    pub(super) starved: u64,
    /// Bits of [`Once`](super::sim::Once).
    pub(super) said: u32,
    pub(super) mode: Mode,
}

impl<P> SimState<P> {
    pub(super) fn new(program: P, plc: Box<dyn Plc>, square: Option<u8>) -> SimState<P> {
        let knobs = Knobs { feed: 100.0, rapid: 100.0, single_block: false, optional_stop: false, block_skip: false };
        SimState {
            now: 0.0,
            started: false,
            ended_at: None,
            program,
            reader: ReaderState::default(),
            exec: Exec::Idle,
            place: None,
            path: PathState {
                position: [0.0; AXES],
                rest_since: f64::NEG_INFINITY,
                moving: false,
                flow_end: None,
                reference: None,
            },
            operator: OperatorState { knobs, held: false, stepped: false, events_done: 0 },
            suppressed: Suppressed::default(),
            plc: PlcState { program: plc, next_scan: f64::INFINITY, io: Io::default(), shown: BTreeMap::new() },
            spindle: SpindleControl::new(square),
            clock: RunClock::default(),
            starved: 0,
            said: 0,
            mode: Mode::Running,
        }
    }

    /// Seconds of automatic running until `t`.
    pub(super) fn run_time_at(&self, t: f64) -> f64 {
        self.clock.total + self.clock.since.map_or(0.0, |since| t - since)
    }

    /// Commands behind the one that is executed; `None` where all are done.
    pub(super) fn waiting(&self) -> Option<usize> {
        let idle = self.reader.queue.is_empty() && matches!(self.exec, Exec::Idle);
        (!idle).then_some(self.reader.queue.len())
    }
}

//! The state of a simulation between two events, in parts: reader, path, operator, PLC, spindle.

use std::collections::{BTreeMap, VecDeque};

use super::exec::Exec;
use super::once::Once;
use super::plc::{Plc, PlcOrders, PlcSignals, WordPart};
use super::snapshot::Mode;
use super::spindle_control::SpindleControl;
use crate::interp::canon::AXES;
use crate::interp::{Canon, End};
use crate::text::{Diagnostic, Message, Place};

/// A command read and not yet begun.
#[derive(Debug, Clone)]
pub(super) struct Queued {
    pub(super) canon: Canon,
    pub(super) place: Place,
    /// Time (s) at which its block was read.
    pub(super) ready: f64,
    /// First command of its block.
    pub(super) first: bool,
    /// Number of its block, in reading order.
    pub(super) block: u64,
    /// Its number in the log.
    pub(super) logged: usize,
}

/// Reason for the end of reading.
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
    /// Time (s) of the reader's next step.
    pub(super) next_step: f64,
    /// The reader waits until all commands are executed and the axes are at rest.
    pub(super) drains: bool,
    pub(super) over: Option<Over>,
    pub(super) queue: VecDeque<Queued>,
    /// Number of the executing block, in reading order.
    pub(super) executed: u64,
    /// Blocks in the queue.
    pub(super) ahead: usize,
}

/// The commanded path before acceleration.
#[derive(Debug, Clone)]
pub(super) struct PathState {
    /// Position at the end of the last movement, mm or °; exact also after a broken-off movement.
    pub(super) position: [f64; AXES],
    /// Start (s) of the path's standstill.
    pub(super) rest_since: f64,
    pub(super) moving: bool,
    /// End (s) of a movement that the next one should follow without a stop.
    pub(super) flow_end: Option<f64>,
    /// The program's reference point, mm or °: position at the last preset of coordinates, or at the last speed limit that sets it.
    pub(super) reference: Option<[f64; AXES]>,
}

/// Panel and PLC functions switched off by the program (`#3003`, `#3004`).
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
    /// Number of panel events carried out.
    pub(super) events_done: usize,
}

/// The PLC program and its interface.
#[derive(Debug)]
pub(super) struct PlcState {
    pub(super) logic: Box<dyn Plc>,
    /// Time (s) of the next scan requested by the PLC.
    pub(super) next_scan: f64,
    /// Whether contacts follow the movers, and the time (s) at which they are read next.
    pub(super) follows: bool,
    pub(super) next_reading: f64,
    /// Signals to the PLC, and its orders.
    pub(super) signals: PlcSignals,
    pub(super) orders: PlcOrders,
    /// Inputs forced by the operator; they replace the values of the PLC in its orders.
    pub(super) forced: BTreeMap<(u32, WordPart), f64>,
    /// Message of the PLC about its hold of the program, as long as the hold lasts.
    pub(super) hold: Option<Message>,
    /// Macro inputs as last recorded.
    pub(super) shown: BTreeMap<u32, f64>,
}

impl Clone for PlcState {
    fn clone(&self) -> PlcState {
        PlcState {
            logic: self.logic.boxed(),
            next_scan: self.next_scan,
            follows: self.follows,
            next_reading: self.next_reading,
            signals: self.signals.clone(),
            orders: self.orders.clone(),
            forced: self.forced.clone(),
            hold: self.hold.clone(),
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
    /// Start (s) of the present automatic operation; `None` while the program does not run.
    pub(super) since: Option<f64>,
    /// Seconds of earlier automatic operation.
    pub(super) total: f64,
}

/// State of the simulation; a clone continues exactly like the original.
#[derive(Debug, Clone)]
pub(super) struct SimState<P> {
    /// Time (s) of the newest event.
    pub(super) now: f64,
    pub(super) started: bool,
    /// Time (s) of the end of the run, if only the operator can continue it; axes and spindle settle after it.
    pub(super) ended_at: Option<f64>,
    pub(super) program: P,
    pub(super) reader: ReaderState,
    pub(super) exec: Exec,
    /// The executing block.
    pub(super) place: Option<Place>,
    /// Whether the executing block began with the present event.
    pub(super) begins: bool,
    pub(super) path: PathState,
    pub(super) operator: OperatorState,
    pub(super) suppressed: Suppressed,
    pub(super) plc: PlcState,
    pub(super) spindle: SpindleControl,
    pub(super) clock: RunClock,
    /// Number of blocks read too late to follow without a stop.
    pub(super) starved: u64,
    /// Diagnostics already reported.
    pub(super) reported: Vec<Once>,
    pub(super) mode: Mode,
}

impl<P> SimState<P> {
    pub(super) fn new(program: P, plc: Box<dyn Plc>, diameter_axis: Option<u8>) -> SimState<P> {
        let knobs = Knobs { feed: 100.0, rapid: 100.0, single_block: false, optional_stop: false, block_skip: false };
        SimState {
            now: 0.0,
            started: false,
            ended_at: None,
            program,
            reader: ReaderState::default(),
            exec: Exec::Idle,
            place: None,
            begins: false,
            path: PathState {
                position: [0.0; AXES],
                rest_since: f64::NEG_INFINITY,
                moving: false,
                flow_end: None,
                reference: None,
            },
            operator: OperatorState { knobs, held: false, stepped: false, events_done: 0 },
            suppressed: Suppressed::default(),
            plc: PlcState {
                follows: plc.follows_movers(),
                logic: plc,
                next_scan: f64::INFINITY,
                next_reading: f64::INFINITY,
                signals: PlcSignals::default(),
                orders: PlcOrders::default(),
                forced: BTreeMap::new(),
                hold: None,
                shown: BTreeMap::new(),
            },
            spindle: SpindleControl::new(diameter_axis),
            clock: RunClock::default(),
            starved: 0,
            reported: Vec::new(),
            mode: Mode::Running,
        }
    }

    /// Seconds of automatic running until `t`.
    pub(super) fn run_time_at(&self, t: f64) -> f64 {
        self.clock.total + self.clock.since.map_or(0.0, |since| t - since)
    }

    /// Number of commands waiting after the executing one; `None` if all are done.
    pub(super) fn waiting(&self) -> Option<usize> {
        let idle = self.reader.queue.is_empty() && matches!(self.exec, Exec::Idle);
        (!idle).then_some(self.reader.queue.len())
    }
}

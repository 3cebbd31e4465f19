//! Inputs of a run (program, plant, PLC, panel, budget), and its end.

use super::panel::Panel;
use super::plant::Plant;
use super::plc::Plc;
use crate::controls::Control;
use crate::text::Diagnostic;

/// Limits beyond which a run is not planned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Budget {
    /// Maximum blocks read.
    pub blocks: u64,
    /// Maximum machine time (s).
    pub seconds: f64,
}

/// Records that a run keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Retention {
    /// The whole timeline and a checkpoint for every second: any moment can be shown, any event added.
    Timeline,
    /// Timeline and checkpoints as [`Retention::Timeline`], and the commands as a log: for stepping on the command line.
    Both,
    /// Only the newest moments, and the commands as a log for [`Planner::take_log`]: for long runs on the command line. An event added to
    /// the past happens at the present time.
    Log,
}

/// All inputs of a run.
pub struct Setup<'a, P> {
    /// The program, at its start.
    pub program: P,
    /// The control.
    pub control: &'a Control,
    /// Axes, spindle and block times.
    pub plant: &'a Plant,
    /// The machine builder's PLC program.
    pub plc: Box<dyn Plc>,
    /// The operator's events.
    pub panel: Panel,
    /// Budget of the run.
    pub limits: Budget,
    /// Records to keep.
    pub keep: Retention,
    /// Findings about the run before it begins.
    pub findings: Vec<Diagnostic>,
}

/// Cause of the end of a run. A further operator event continues the run.
#[derive(Debug, Clone, PartialEq)]
pub enum RunEnd {
    /// M02, M30 or the end of the start program; the spindle is left as it is.
    ProgramEnd,
    /// A wait for the operator (M00, M01, message, single block, hold or reset) without a later panel event, or a wait for an event that
    /// never comes (FIN, a feed above 0); a diagnostic names it.
    Stop,
    /// An alarm, or emergency stop.
    Alarm(Box<Diagnostic>),
    /// The budget of blocks is used up.
    Blocks,
    /// The budget of time is used up.
    Seconds,
}

/// Progress of planning.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanProgress {
    /// Machine time (s) planned so far.
    pub planned_to: f64,
    /// Cause of the end; set after axes and spindle have settled.
    pub ended: Option<RunEnd>,
}

/// Progress of planning that a gate may stop.
#[derive(Debug, Clone, PartialEq)]
pub struct GatedProgress {
    /// As without a gate.
    pub progress: PlanProgress,
    /// Whether the gate shut.
    pub is_shut: bool,
}

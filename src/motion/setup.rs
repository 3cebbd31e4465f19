//! Inputs of a run (program, plant, PLC, panel, budgets), and how it ends.

use super::panel::Panel;
use super::plant::Plant;
use super::plc::Plc;
use crate::controls::Control;
use crate::text::Diagnostic;

/// Budgets of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Budget {
    /// Blocks read at most.
    pub blocks: u64,
    /// CheckedPlant seconds at most.
    pub seconds: f64,
}

/// Records that a run keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Retention {
    /// The whole timeline and a checkpoint for every second: any moment can be shown, any event added.
    Timeline,
    /// The same, and the commands as a log: for stepping on the command line.
    Both,
    /// Only the newest moments, and the commands as a log for [`Planner::take_log`]: for long runs on the command line. An event that
    /// is added to the past happens now.
    Log,
}

/// All that a run is a function of.
pub struct Setup<'a, P> {
    /// The program, at its head.
    pub program: P,
    /// The control that runs it.
    pub control: &'a Control,
    /// Axes, spindle, block times.
    pub plant: &'a Plant,
    /// The builder's logic.
    pub plc: Box<dyn Plc>,
    /// The operator's hand.
    pub panel: Panel,
    /// Budgets.
    pub limits: Budget,
    /// Records that are kept.
    pub keep: Retention,
}

/// Why a run is over. Where the operator does something further it goes on.
#[derive(Debug, Clone, PartialEq)]
pub enum RunEnd {
    /// M02, M30 or the end of the start program; the spindle is left as it is.
    ProgramEnd,
    /// It waits for the operator: M00, M01, a message, single block, hold or reset, and no event of the panel answers. Or it waits for
    /// something that never comes (FIN, a feed above 0); a diagnostic says which.
    Stop,
    /// An alarm, or emergency stop.
    Alarm(Box<Diagnostic>),
    /// The budget of blocks is used up.
    Blocks,
    /// The budget of time is used up.
    Seconds,
}

/// How far a run is planned.
#[derive(Debug, Clone, PartialEq)]
pub struct Progress {
    /// Machine time (s) up to which the run is planned.
    pub planned_to: f64,
    /// Set when the run is over, and axes and spindle have settled at that time.
    pub ended: Option<RunEnd>,
}

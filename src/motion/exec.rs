//! The states of the executor: idle, moving, waiting, stopped, ended.

use super::moves::{ActiveMove, Pace};
use super::setup::RunEnd;
use super::snapshot::Mode;
use crate::interp::Canon;
use crate::text::Diagnostic;

/// Interval (s) of speed measurements while spindle and axes follow one another and change.
pub(super) const MEASURE: f64 = 0.01;

/// The state of the executor.
#[derive(Debug, Clone)]
#[allow(
    clippy::large_enum_variant,
    reason = "a box for each movement would cost more than the room of the other states"
)]
pub(super) enum Exec {
    /// Takes the next command as soon as it is ready.
    Idle,
    /// Moves the axes.
    Moving(ActiveMove),
    /// Waits for the spindle speed before this movement.
    Spinning(Box<ActiveMove>),
    /// Waits until this time (s) for the axes to settle.
    Settling(f64),
    /// Waits until this time (s) for standstill, before this command.
    Resting(f64, Box<Canon>),
    /// Dwells until this time (s).
    Dwelling(f64),
    /// Dwells for spindle turns: turns at the start, and turns to wait.
    Counting(f64, f64),
    /// Waits for the PLC.
    Fin,
    /// Waits for cycle start.
    Stopped,
    /// After reset: cycle start begins at the start of the program.
    Ready,
    /// The program has ended.
    Finished,
    /// Alarm of the program, until reset.
    Alarm(Box<Diagnostic>),
    /// Emergency stop, until reset.
    Emergency(Box<Diagnostic>),
    /// The budget is used up.
    OutOfBlocks,
}

impl Exec {
    /// Whether the program runs, held or not.
    pub(super) fn runs(&self) -> bool {
        use Exec::{Alarm, Emergency, Finished, OutOfBlocks, Ready, Stopped};
        !matches!(self, Stopped | Ready | Finished | Alarm(_) | Emergency(_) | OutOfBlocks)
            && self.returning().is_none()
    }

    /// Whether the program had ended before the program zero return under way; `None` without a return.
    #[inline(always)]
    pub(super) fn returning(&self) -> Option<bool> {
        match self {
            Exec::Moving(ActiveMove { pace: Pace::Return { ended }, .. }) => Some(*ended),
            _ => None,
        }
    }

    /// The state after a program zero return.
    pub(super) fn after_return(ended: bool) -> Exec {
        if ended { Exec::Finished } else { Exec::Ready }
    }

    /// Whether a thread is being cut. No hold interrupts it.
    pub(super) fn threads(&self) -> bool {
        matches!(self, Exec::Moving(motion) if matches!(motion.pace, Pace::Thread(_)))
    }

    /// The end of the run, if only the operator can continue it.
    #[inline(always)]
    pub(super) fn end(&self, holding: bool) -> Option<RunEnd> {
        match self {
            Exec::Stopped | Exec::Ready => Some(RunEnd::Stop),
            Exec::Finished => Some(RunEnd::ProgramEnd),
            Exec::Alarm(diagnostic) | Exec::Emergency(diagnostic) => Some(RunEnd::Alarm(diagnostic.clone())),
            Exec::OutOfBlocks => Some(RunEnd::Blocks),
            Exec::Moving(_) | Exec::Spinning(_) | Exec::Idle if holding => Some(RunEnd::Stop),
            _ => None,
        }
    }

    pub(super) fn mode(&self, holding: bool) -> Mode {
        match self {
            Exec::Moving(ActiveMove { pace: Pace::Return { ended: true }, .. }) => Mode::Ended,
            Exec::Moving(ActiveMove { pace: Pace::Return { ended: false }, .. }) => Mode::Stopped,
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

//! A gate before each step of the program, for debuggers.

use crate::interp::World;

/// Answer of the gate before a step of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gate {
    /// The step is read.
    Open,
    /// The step is read and becomes the first of [`Planner::newest_commands`].
    OpenAsFirst,
    /// The run stops before the step.
    Shut,
}

/// Callback before each step of the program, with the time (s), the program, and the machine as read by the program.
pub type Gatekeeper<'a, P> = &'a mut dyn FnMut(f64, &P, &mut dyn World) -> Gate;

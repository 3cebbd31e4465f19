//! A gate before each step of the program, for debuggers.

use crate::interp::World;

/// Answer of the gate before a step of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gate {
    /// The step is read.
    Open,
    /// The step is read, and [`Planner::given`] starts with it.
    Anew,
    /// The run stops before the step.
    Shut,
}

/// Called before each step of the program, with its time (s), the program, and the machine as the program reads it.
pub type Gatekeeper<'a, P> = &'a mut dyn FnMut(f64, &P, &mut dyn World) -> Gate;

//! A gate before each step of the program, for debuggers.

use crate::interp::World;

/// What happens to a step of the program that is about to be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gate {
    /// It is read.
    Open,
    /// It is read, and [`Planner::given`] begins anew with it.
    Anew,
    /// The run stops before it.
    Shut,
}

/// Asked before each step of the program: at its time, with the program and the machine as the program would see it.
pub type Gatekeeper<'a, P> = &'a mut dyn FnMut(f64, &P, &mut dyn World) -> Gate;

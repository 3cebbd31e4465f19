//! [`RunningProgram`]: source of the planner's steps; the interpreter, or a script in a test.

use crate::interp::canon::AXES;
use crate::interp::{Counts, Interp, Step, World};
use crate::text::Place;

/// A running program without time; a clone continues exactly like the original.
pub trait RunningProgram: Clone {
    /// The next step. The first step of a block raises [`blocks`](RunningProgram::blocks), further steps of the same block do not.
    fn step(&mut self, world: &mut dyn World) -> Step;
    /// Number of blocks read so far; never decreases.
    fn blocks(&self) -> Counts;
    /// Restarts the start program with all modal states as after reset, at this axis position in command increments, machine frame. Common
    /// variables stay.
    fn restart(&mut self, position: [i64; AXES]);
    /// Sets the axis position at the start of the run, in command increments, machine frame.
    fn set_start(&mut self, _position: [i64; AXES]) {}
    /// Sets a variable as on the control's screen; returns whether it exists.
    fn set_variable(&mut self, number: u32, value: Option<f64>) -> bool;
    /// Value of a common variable; `None` is vacant.
    fn variable(&self, number: u32) -> Option<f64>;
    /// The block with a sequence number in the start program.
    fn numbered(&self, _sequence: u32) -> Option<Place> {
        None
    }
}

impl RunningProgram for Interp {
    fn step(&mut self, world: &mut dyn World) -> Step {
        Interp::step(self, world)
    }

    fn blocks(&self) -> Counts {
        Interp::blocks(self)
    }

    fn restart(&mut self, position: [i64; AXES]) {
        self.reset();
        self.set_position(position);
    }

    fn set_start(&mut self, position: [i64; AXES]) {
        self.set_position(position);
    }

    fn set_variable(&mut self, number: u32, value: Option<f64>) -> bool {
        Interp::set_variable(self, number, value)
    }

    fn variable(&self, number: u32) -> Option<f64> {
        Interp::variable(self, number)
    }

    fn numbered(&self, sequence: u32) -> Option<Place> {
        Interp::numbered(self, sequence)
    }
}

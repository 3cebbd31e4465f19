//! Running a program: timeless, pulled step by step, never longer than its caller's patience.
//!
//! The interpreter knows nothing of time, axes that move or operators; what it needs of them it asks the [`World`].

pub mod canon;

pub mod world;

pub use canon::{Canon, Feed, Target};
pub use world::World;

use crate::text::{Diagnostic, Place};

/// What one step of the interpreter came to.
#[derive(Debug, Clone, PartialEq)]
pub enum Step {
    /// A command for the machine, from the block at the place.
    Command(Canon, Place),
    /// A block that only computed or jumped.
    Logic(Place),
    /// The program needs the machine at rest before it goes on (positions, executing modal data). Step again when it is.
    Sync(Place),
    /// The program is over; further steps say the same.
    Ended(End),
}

/// Why a program is over.
#[derive(Debug, Clone, PartialEq)]
pub enum End {
    /// M02, M30, or the end of a start program that has nothing behind it.
    Program,
    /// An alarm of the control; the diagnostic carries number and place.
    Alarm(Box<Diagnostic>),
}

//! Program interpreter: without time, pulled step by step by its caller, at most one block per step.
//!
//! The interpreter has no clock, moving axes or operator; it reads them through the [`World`].
//!
//! # Order of a block
//!
//! Blocks are read in the order in which they run, each once, and everything in a block is evaluated when the block is read. This is the
//! control's read-ahead; the caller decides how far it runs ahead of the machine. In an NC block the S word, M and T codes come first, then
//! G61 or G64, then dwell or motion, then a stop or end, then calls and returns.
//!
//! # Order of the files
//!
//! Each group below imports only itself and the groups above it: inputs and outputs, tables and state, values, the parts of a block, a
//! step, and the users of steps.

pub mod canon;
mod step;
pub mod world;

pub(crate) mod arc;
mod context;
mod error;
mod frame;
mod index;
mod modal;
mod modal_history;
mod queue;
mod rules;
mod state;
mod vars;

mod eval;
mod operators;
mod system_variables;
mod value;

mod arc_motion;
mod block;
mod call;
mod codes;
mod coordinate_range;
mod coordinates;
mod feed;
mod function;
mod jump;
mod spindle;
mod statement;
mod thread;
mod travel;
mod words;
mod working_area;

mod run;

pub mod inspect;
mod interpreter;
mod precheck;

pub use canon::{Canon, Feed, Target};
pub use interpreter::{Interp, run};
pub use precheck::precheck;
pub use step::{Counts, End, StartProgram, Step};
pub use world::{MachineClock, World};

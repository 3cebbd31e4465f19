//! Running a program: timeless, pulled step by step, never longer than its caller's patience.
//!
//! The interpreter knows no time, moving axes or operators; it reads them through the [`World`].
//!
//! # Order of a block
//!
//! Blocks are read in the order in which they run, each once, and everything of a block is evaluated when it is read: that is the
//! control's pre-read, and the caller decides how far it runs ahead of the machine. Of an NC block the S word, M and T codes come
//! first, then G61 or G64, then dwell or motion, then a stop or end, then calls and returns.
//!
//! # Order of the files
//!
//! Each group below imports only itself and those above it: what goes in and out, tables and state, values, the parts of a block,
//! a step, and what is made of steps.

pub mod canon;
mod step;
pub mod world;

mod arc;
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
pub use world::World;

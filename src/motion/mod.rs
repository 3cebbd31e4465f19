//! From commands to time: the planner pulls the interpreter, the timeline answers any moment.

pub mod plant;

pub mod panel;

pub mod plc;

pub mod snapshot;

pub mod program;

pub mod timeline;

pub mod plan;

mod executor;

mod moves;

mod operator;

mod path;

mod spindle;

mod state;

mod track;

pub use panel::{Action, Event, Panel};
pub use plan::{Keep, Limits, Planner, Progress, RunEnd, Setup};
pub use plant::{AxisPlant, Plant, SpindlePlant};
pub use plc::{BenchPlc, Io, Plc};
pub use program::Program;
pub use snapshot::{AxisState, Mode, Snapshot, SpindleState};
pub use timeline::Timeline;

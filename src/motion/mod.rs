//! From commands to time: the planner pulls the interpreter, the timeline answers any moment.

pub mod plant;

pub mod panel;

pub mod plc;

pub mod snapshot;

pub use panel::{Action, Event, Panel};
pub use plant::{AxisPlant, Plant, SpindlePlant};
pub use plc::{BenchPlc, Io, Plc};
pub use snapshot::{AxisState, Mode, Snapshot, SpindleState};

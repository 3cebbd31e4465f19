//! A machine: what is written once for each, what it answers with its values on a control, and the list of machines without their types.

mod any;
mod defaults;
mod design;
mod drawn;
mod driven;
mod examples;
mod left_out;
mod prepared;
mod samples;

pub use any::{AnyMachine, Erased, Machine, MachineInfo, PreparedMachine};
pub use defaults::Defaults;
pub use design::{ControlContext, Design, MachineFile, MachineProgram, MachineVariable, PanelSetup};
pub use drawn::{DrawnMachine, Frame};
pub use driven::{DrivenMachine, LOWEST_KNOB};
pub use examples::{Example, KnownFault};
pub use left_out::LeftOut;
pub use prepared::Prepared;
pub use samples::{Executions, Samples};

//! A machine: its constants and form, the prepared machine with its values on a control, and the type-erased entry for the list of machines.

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

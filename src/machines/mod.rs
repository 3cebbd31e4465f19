//! The machines: each is a form, formulas, rules, a program, a PLC and a scene.

pub mod chart_rows;
pub mod driven;
pub mod form;
pub mod ladder;
mod lathe;
mod list;
pub mod machine;
mod open_points;
mod polygon_lathe;
pub mod program;
pub mod report;
mod ribbon_line;
pub mod sheets;
pub mod stops;
mod turning_spindle;
pub mod verdict;

pub use list::{ALL, find};
pub use machine::{
    AnyMachine, ControlContext, Defaults, Design, DrawnMachine, DrivenMachine, Erased, Executions, Frame, Machine,
    MachineFile, MachineInfo, MachineProgram, MachineVariable, PanelSetup, Prepared, PreparedMachine, Samples,
};

//! The machines: each is a form, formulas, rules, a program, a PLC and a scene.

pub mod form;

pub mod machine;

pub mod verdict;

pub mod chart_rows;

pub mod sheets;

pub mod stops;

pub mod ladder;

pub mod driven;

pub mod program;

mod lathe;

mod ribbon_line;

mod turning_spindle;

mod polygon_lathe;

mod list;

pub mod report;

pub use list::{ALL, find};
pub use machine::{
    AnyMachine, ControlContext, Defaults, Design, DrawnMachine, DrivenMachine, Erased, Executions, Frame, Machine,
    MachineFile, MachineInfo, MachineProgram, MachineVariable, PanelSetup, Prepared, PreparedMachine, Samples,
};

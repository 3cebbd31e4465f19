//! The machines: each is a form, formulas, rules, a program, a PLC and a scene.

pub mod form;

pub mod examples;

mod samples;

mod drawn_machine;

mod driven_machine;

pub mod machine;

pub mod driven;

pub mod devices;

pub mod verdict;

pub mod chart_rows;

pub mod sheets;

pub mod stops;

pub mod scaling;

pub mod site;

mod materials;

mod slides;

mod main_spindle;

mod knobs;

mod spindle_encoder;

mod turret;

pub mod ladder;

pub mod header;

pub mod left_out;

pub mod comments;

pub mod writing;

mod ribbon_line;

mod turning_spindle;

mod polygon_lathe;

mod list;

pub mod settings;

pub mod report;

pub use drawn_machine::{DrawnMachine, Frame};
pub use driven_machine::DrivenMachine;
pub use list::{ALL, find};
pub use machine::{
    AnyMachine, ControlContext, Defaults, Design, Erased, Machine, MachineFile, MachineInfo, MachineProgram,
    MachineVariable, PanelSetup, Prepared, PreparedMachine,
};
pub use samples::{Executions, Samples};

//! Controls as data: one [`Control`] value per control, made of rows with source and grade.
//!
//! A control is a value and not a trait: controls differ in facts. Code asks for abilities and rows, never for a control's name.

pub mod schema;

pub mod base;

pub mod mitsubishi_e60;

pub mod gsk_980tdc;

pub mod knd_k2000t;

pub mod fanuc_0i_tf;

pub mod fanuc_0i_mf;

pub mod sinumerik_802d;

pub mod sinumerik_808d;

pub use schema::address;
pub use schema::{
    Address, AddressSet, Alarm, AlarmDef, AnalogOutput, AxisDef, AxisScaling, Bench, Code, CodeDef, CodeId, CodeNumber,
    Control, Dialect, DriveRole, DriveSystem, FeedKnob, Group, Limits, Macros, ParamDef, ParamRole, ParamUnit, Point,
    ScalingKind, Signal, SpindleRules, Switch, Switches, Syntax, Timing, VarKind, VarRange,
};
pub use schema::{
    alarm, bench, code, dialect, drive, interface, limits, macros, options, params, spindle, switch, syntax, vars,
};

/// The list of the controls, one per folder.
macro_rules! controls {
    ($($control:ident),*) => {
        /// All controls, in the order of the list on the page.
        pub static ALL: &[&Control] = &[$(&$control::CONTROL),*];
    };
}

controls![mitsubishi_e60, gsk_980tdc, knd_k2000t, fanuc_0i_tf, fanuc_0i_mf, sinumerik_802d, sinumerik_808d];

/// The control with this id.
pub fn find(id: &str) -> Option<&'static Control> {
    ALL.iter().copied().find(|c| c.id == id)
}

//! What a control understands, as data: one [`Control`] value per control, rows with source and grade.
//!
//! A control is a value and not a trait: controls differ in facts. Code asks for abilities and rows, never for a name.

pub mod schema;

pub mod base;

pub mod mitsubishi_e60;

pub mod gsk_980tdc;

pub mod knd_k2000t;

pub mod sinumerik_802d;

pub use schema::{
    Alarm, AlarmDef, AxisDef, Bench, Code, CodeDef, CodeId, CodeNumber, Control, Group, Limits, Macros, ParamDef,
    ParamRole, Point, Signal, SpindleRules, Switch, Switches, Syntax, Timing, VarKind, VarRange,
};
pub use schema::{alarm, bench, code, interface, limits, macros, params, spindle, switch, syntax, vars};

/// Whether this is built with every control and machine. The page opens with a module that is not, the first one: it is smaller by what few
/// need, and of that it knows only that there is such ([`LISTED`], [`crate::machines::LISTED`]). Where somebody asks for it, the whole
/// module goes on with his project.
pub const WHOLE: bool = cfg!(feature = "whole");

/// What every module knows of a control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Listed {
    /// Its id.
    pub id: &'static str,
    /// Its name.
    pub name: &'static str,
    /// Whether the first module has it.
    pub first: bool,
}

/// Makes the lists out of the controls: of those that the first module has too, and of those that only the whole one has.
macro_rules! controls {
    (first: $($first:ident),*; whole: $($whole:ident),*) => {
        /// The controls of this module, in the order they are listed.
        pub static ALL: &[&Control] =
            if WHOLE { &[$(&$first::CONTROL,)* $(&$whole::CONTROL),*] } else { &[$(&$first::CONTROL),*] };

        /// All controls there are.
        pub static LISTED: &[Listed] = &[
            $(Listed { id: $first::CONTROL.id, name: $first::CONTROL.name, first: true },)*
            $(Listed { id: $whole::CONTROL.id, name: $whole::CONTROL.name, first: false },)*
        ];

        /// What a machine has to set on each control: apart from it, so that who asks for no parameter does without their rows.
        static PARAMS: &[(&Control, &[ParamDef])] =
            &[$((&$first::CONTROL, $first::PARAMS),)* $((&$whole::CONTROL, $whole::PARAMS)),*];
    };
}

controls![first: mitsubishi_e60, gsk_980tdc, knd_k2000t; whole: sinumerik_802d];

/// What is known of the control of an id, be it in this module or not.
pub fn listed(id: &str) -> Option<&'static Listed> {
    LISTED.iter().find(|row| row.id == id)
}

/// The control of an id, where this module has it.
pub fn find(id: &str) -> Option<&'static Control> {
    ALL.iter().copied().find(|c| c.id == id)
}

impl Control {
    /// Parameters that a machine has to set.
    pub fn params(&self) -> &'static [ParamDef] {
        PARAMS.iter().find(|row| row.0.id == self.id).map_or(&[], |row| row.1)
    }

    /// The parameter of a role.
    pub fn param(&self, role: ParamRole) -> Option<&'static ParamDef> {
        self.params().iter().find(|row| row.role == role)
    }
}

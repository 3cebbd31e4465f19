//! Rows of the 0i-MF: rows of FANUC mills. Rows known only from memory have a citation of their own.

use crate::controls::base::fanuc;
use crate::controls::options::*;
use crate::controls::schema::table::{cited, extended};
use crate::controls::switch::switch;
use crate::controls::{AlarmDef, CodeDef, ParamDef, Signal, Switch, VarRange};
use crate::text::{Citation, Grade};

/// FANUC mills from memory, without a document.
pub(super) const MEMORY: Citation = Citation::new("FANUC 0i-M usage, unverified", Grade::Open);

/// G and M codes. Codes bound to programs are parameters: see the switches.
pub(super) const CODES: &[CodeDef] = cited![CodeDef: fanuc::MILL_CODES, Open MEMORY];

/// Variables.
pub(super) const VARS: &[VarRange] = cited![VarRange: fanuc::MILL_VARS, Open MEMORY];

/// Parameters that a machine has to set.
pub(super) const PARAMS: &[ParamDef] = cited![ParamDef: fanuc::MILL_PARAMS, Open MEMORY];

/// Alarms.
pub(super) const ALARMS: &[AlarmDef] = cited![AlarmDef: fanuc::ALARMS, Open MEMORY];

/// Registers between PMC and control.
pub(super) const SIGNALS: &[Signal] = cited![Signal: fanuc::SIGNALS, Open MEMORY];

/// Switches: points that no manual at hand settles, and parameters that change the meaning of a program.
pub(super) const SWITCHES: &[Switch] = extended![
    Switch: cited![Switch: fanuc::series_0i_f::MILL_SWITCHES, Open MEMORY],
    &[
        switch(StartupFeed::of(&[StartupFeed::G94, StartupFeed::G95]), MEMORY).parameter("3402#4"),
        switch(StartupDistance::of(&[StartupDistance::G90, StartupDistance::G91]), MEMORY).parameter("3402#3"),
    ],
];

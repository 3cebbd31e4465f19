//! Rows of the K2000T: rows of FANUC lathes, unconfirmed on this control, and facts from the polygon turning paper.

use super::sources::PAPER;
use crate::controls::Code::*;
use crate::controls::ParamRole::EditLock;
use crate::controls::ParamUnit::Plain;
use crate::controls::VarKind::*;
use crate::controls::base::fanuc;
use crate::controls::base::fanuc::MEMORY;
use crate::controls::code::{Group, g, m};
use crate::controls::interface::SignalRole::*;
use crate::controls::interface::{from_plc, to_plc};
use crate::controls::options::*;
use crate::controls::params::param;
use crate::controls::schema::table::{cited, extended};
use crate::controls::switch::switch;
use crate::controls::vars::{Width, range};
use crate::controls::{CodeDef, ParamDef, Signal, Switch, VarRange};
use crate::text::{Citation, Grade};

/// Setting seen in the paper's samples; the parameter number is FANUC's.
const SAMPLE: Citation = Citation::new("sample of the polygon turning paper; parameter by FANUC 0i-T", Grade::Inferred);
/// The paper names items of 4 bytes and of 1 byte, and uses #1480, #1484, #1488.
const BYTES: Citation =
    Citation::new("polygon turning paper, K2000T; which are single bytes is inferred", Grade::Inferred);

/// G and M codes. Codes bound to programs are parameters: see the switches.
pub(super) const CODES: &[CodeDef] = extended![
    CodeDef: cited![CodeDef: fanuc::LATHE_CODES, MEMORY],
    &[
        g(0, Rapid, Group::Motion, "positioning", PAPER),
        g(1, Linear, Group::Motion, "linear interpolation", PAPER),
        m(5, SpindleStop, "spindle stop", PAPER),
        m(30, EndRewind, "program end and rewind", PAPER),
    ],
];

/// Variables.
pub(super) const VARS: &[VarRange] = extended![
    VarRange: cited![VarRange: fanuc::LATHE_VARS, MEMORY],
    &[
        range(1, 33, Local, "", "local, one set per macro level", PAPER),
        range(1000, 1015, InputBit, "G54", "inputs from the PMC, bit by bit", PAPER),
        range(1032, 1032, InputWord(Width::Word), "G54", "input from the PMC, 16 bits", PAPER),
        range(1100, 1115, OutputBit, "F54", "outputs to the PMC, bit by bit", PAPER),
        range(1132, 1132, OutputWord(Width::Word), "F54", "output to the PMC, 16 bits", PAPER),
        range(
            1480,
            1544,
            ExchangeWord,
            "G480",
            "read from G480 to G544, written to F480 to F544, 4 bytes and single bytes",
            BYTES,
        ),
    ],
];

/// Parameters that a machine has to set.
pub(super) const PARAMS: &[ParamDef] = extended![
    ParamDef: cited![ParamDef: fanuc::LATHE_PARAMS, MEMORY],
    &[param(EditLock, "3202#4", "NE9", Plain, "1: programs 9000 to 9999 cannot be edited; 0 to load O9120", MEMORY)],
];

/// Registers between PMC and control.
pub(super) const SIGNALS: &[Signal] = extended![
    Signal: cited![Signal: fanuc::SIGNALS, MEMORY],
    &[
        from_plc(MacroInputLow(1480), "G480", "4 bytes", "#1480, read", PAPER),
        from_plc(MacroInputLow(1484), "G484", "4 bytes", "#1484, read", PAPER),
        from_plc(MacroInputLow(1488), "G488", "4 bytes", "#1488, read", PAPER),
        to_plc(MacroOutput(1480), "F480", "4 bytes", "#1480, written; polygon turning: speed", PAPER),
        to_plc(MacroOutput(1484), "F484", "4 bytes", "#1484, written; polygon turning: ratio of the work piece", PAPER),
        to_plc(MacroOutput(1488), "F488", "4 bytes", "#1488, written; polygon turning: ratio of the tool", PAPER),
    ],
];

/// Switches: points that no manual at hand settles, and parameters that change the meaning of a program.
pub(super) const SWITCHES: &[Switch] = extended![
    Switch: fanuc::LATHE_SWITCHES,
    &[
        switch(DecimalPoint::of(&[DecimalPoint::Millimetres, DecimalPoint::Increments]), SAMPLE).parameter("3401#0"),
        switch(ArgumentPoint::of(&[ArgumentPoint::AsWritten, ArgumentPoint::Increments]), SAMPLE),
        switch(Diameter::of(&[Diameter::Diameter, Diameter::Radius]), SAMPLE).parameter("1006#3"),
        switch(StartupFeed::of(&[StartupFeed::G98, StartupFeed::G99]), SAMPLE).parameter("3402#4"),
        switch(CallParameters::of("4120=512 4121=502"), PAPER).label("switch.call-parameters-each"),
    ],
];

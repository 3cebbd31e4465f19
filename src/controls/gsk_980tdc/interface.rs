//! Registers between PLC and 980TDc.

use super::sources::{MACRO, OVERRIDE};
use crate::controls::Signal;
use crate::controls::base::fanuc;
use crate::controls::interface::SignalRole::*;
use crate::controls::interface::{from_plc, to_plc};
use crate::controls::schema::table::{cited, joined};
use crate::text::{Citation, Grade};

/// A signal of FANUC; no GSK page at hand has it.
const SHIFT: Citation = Citation::new("FANUC 0i-T usage, unverified", Grade::Open);

/// Manual of the sister's PLC.
pub(super) const PLC: Citation = Citation::new("GSK988TA lathe PLC manual, p.112-147", Grade::Sister);

/// Registers, followed by single signals.
pub(super) const SIGNALS: &[Signal] = joined![Signal: REGISTERS, cited![Signal: fanuc::BITS, PLC]];

/// Registers, by device number.
const REGISTERS: &[Signal] = &[
    from_plc(FeedOverrideOff, "G6.4", "", "OVC: 1 fixes the feed override at 100 %", PLC),
    from_plc(ShiftSpeed, "G29.5", "", "SOR: 1 turns the spindle at the speed of a gear change", SHIFT),
    from_plc(
        SpindleOverrideCode,
        "G30",
        "code",
        "spindle override, 50 to 120 % in steps of 10, by the code of the switch",
        OVERRIDE,
    ),
    from_plc(MacroInputLow(1032), "G54", "word", "#1032 (G54, G55); its bits are #1000 to #1015", MACRO),
    from_plc(MacroInputLow(1033), "G56", "word", "#1033 (G56, G57)", MACRO),
    from_plc(MacroInputLow(1034), "G58", "word", "#1034 (G58, G59)", MACRO),
    to_plc(MacroOutput(1132), "F54", "word", "#1132 (F54, F55); its bits are #1100 to #1115", MACRO),
    to_plc(MacroOutput(1133), "F56", "word", "#1133 (F56, F57)", MACRO),
    to_plc(MacroOutput(1134), "F58", "word", "#1134 (F58, F59)", MACRO),
];

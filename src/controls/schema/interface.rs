//! Registers and signals between the PLC and the control.

use super::table::{Key, text_key};
use crate::text::Citation;

/// What a register is for, independent of its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SignalRole {
    /// Spindle override in percent, PLC to control.
    SpindleOverride,
    /// Spindle override as a code for one of a few steps, PLC to control.
    SpindleOverrideCode,
    /// Cutting feed override in percent, PLC to control.
    FeedOverride,
    /// Low word of a macro input word, PLC to control; with the variable it appears as.
    MacroInputLow(u32),
    /// High word of a macro input word.
    MacroInputHigh(u32),
    /// Word of macro output, control to PLC.
    MacroOutput(u32),
    /// Spindle speed after override and clamp, control to PLC.
    SpindleFinal,
    /// Spindle speed as commanded, control to PLC.
    SpindleCommand,
    /// 12-bit output value of the spindle, control to PLC.
    SpindleOutput,
    /// Spindle speed as measured, control to PLC.
    SpindleActual,
}

/// A register.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Signal {
    /// What it is for.
    pub role: SignalRole,
    /// Device, for instance `R148`.
    pub device: &'static str,
    /// Whether the PLC writes it (and the control reads it).
    pub plc_writes: bool,
    /// Unit or range.
    pub unit: &'static str,
    /// What it carries.
    pub text: &'static str,
    /// Source and grade.
    pub cite: Citation,
}

/// A row of a register that the PLC writes.
pub(in crate::controls) const fn from_plc(
    role: SignalRole,
    device: &'static str,
    unit: &'static str,
    text: &'static str,
    cite: Citation,
) -> Signal {
    Signal { role, device, plc_writes: true, unit, text, cite }
}

/// A row of a register that the control writes.
pub(in crate::controls) const fn to_plc(
    role: SignalRole,
    device: &'static str,
    unit: &'static str,
    text: &'static str,
    cite: Citation,
) -> Signal {
    Signal { role, device, plc_writes: false, unit, text, cite }
}

impl Signal {
    /// Whether its table is sorted, for searches by halves.
    pub const SORTED: bool = false;

    /// The device, for tables that are made of a family's rows and a control's own.
    pub const fn key(&self) -> Key {
        text_key(self.device.as_bytes())
    }
}

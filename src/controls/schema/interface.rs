//! Registers and signals between the PLC and the control.

use super::{Control, Switches};
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

/// The switch that says at which register the macro inputs begin.
const INPUT_BASE: &str = "macro-input-base";

impl Control {
    /// The register of a role as the switches have it, with its source; `None` where the control has none.
    pub fn device(&self, role: SignalRole, switches: &Switches) -> Option<(String, Citation)> {
        let row = self.interface.iter().find(|row| row.role == role)?;
        Some((self.device_of(row, switches), row.cite))
    }

    /// The role of a register as the switches have it.
    pub fn role(&self, device: &str, switches: &Switches) -> Option<SignalRole> {
        let row = self.interface.iter().find(|row| self.device_of(row, switches).eq_ignore_ascii_case(device))?;
        Some(row.role)
    }

    /// The rows stand for the default of the switch; its other settings move all macro inputs alike.
    fn device_of(&self, row: &Signal, switches: &Switches) -> String {
        let number = |device: &str| device.get(1..).and_then(|digits| digits.parse::<u32>().ok());
        let moved = || {
            let (SignalRole::MacroInputLow(_) | SignalRole::MacroInputHigh(_)) = row.role else { return None };
            let base = switches.get(self.switches, INPUT_BASE)?;
            let default = Switches::default().get(self.switches, INPUT_BASE).and_then(number)?;
            let offset = number(row.device)?.checked_sub(default)?;
            Some(format!("{}{}", base.get(..1)?, number(base)? + offset))
        };
        moved().unwrap_or_else(|| row.device.to_owned())
    }
}

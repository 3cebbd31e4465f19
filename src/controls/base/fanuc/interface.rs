//! Registers between PMC and control in the FANUC family.

use super::sources::{INPUTS, MEMORY};
use crate::controls::Signal;
use crate::controls::interface::SignalRole::*;
use crate::controls::interface::{from_plc, to_plc};

/// By device number.
pub const SIGNALS: &[Signal] = &[
    from_plc(SpindleOverride, "G30", "%", "spindle override, 0 to 254", MEMORY),
    from_plc(MacroInputLow(1032), "G54", "word", "#1032 (G54, G55); its bits are #1000 to #1015", INPUTS),
    to_plc(SpindleCommand, "F22", "r/min", "S code (F22 to F25)", MEMORY),
    to_plc(SpindleOutput, "F36", "0 to 4095", "12-bit value of the analog output (F36, F37)", MEMORY),
    to_plc(SpindleActual, "F40", "r/min", "spindle speed by the encoder (F40, F41)", MEMORY),
    to_plc(MacroOutput(1132), "F54", "word", "#1132 (F54, F55); its bits are #1100 to #1115", INPUTS),
    to_plc(MacroOutput(1133), "F56", "4 bytes", "#1133 (F56 to F59)", MEMORY),
];

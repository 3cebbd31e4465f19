//! Registers between PMC and control in the FANUC family.

use super::sources::{INPUTS, MEMORY, PLC_SIGNALS};
use crate::controls::Signal;
use crate::controls::interface::SignalRole::*;
use crate::controls::interface::{from_plc, to_plc};
use crate::controls::schema::table::joined;

/// Registers, followed by single signals.
pub const SIGNALS: &[Signal] = joined![Signal: REGISTERS, BITS];

/// Single signals and the M code, by device number. A `*` in front of FANUC's name marks a signal that is active at 0.
pub const BITS: &[Signal] = &[
    from_plc(Finished, "G4.3", "", "FIN: M, S and T are done; held until their strobes fall", PLC_SIGNALS),
    from_plc(AxesEnable, "G8.0", "", "*IT: 0 holds all axes", PLC_SIGNALS),
    from_plc(EmergencyReleased, "G8.4", "", "*ESP: 0 is emergency stop", PLC_SIGNALS),
    from_plc(HoldReleased, "G8.5", "", "*SP: 0 is feed hold", PLC_SIGNALS),
    from_plc(GearIndex(0), "G28.1", "", "GR1: gear stage less one, bit 0", MEMORY),
    from_plc(GearIndex(1), "G28.2", "", "GR2: gear stage less one, bit 1", MEMORY),
    from_plc(SpeedArrived, "G29.4", "", "SAR: the spindle has its speed", PLC_SIGNALS),
    from_plc(SpindleEnable, "G29.6", "", "*SSTP: 0 puts out 0 V; S stays", PLC_SIGNALS),
    to_plc(Running, "F0.5", "", "STL: the program runs", PLC_SIGNALS),
    to_plc(Alarm, "F1.0", "", "AL: alarm of program, drives or travel, until reset", PLC_SIGNALS),
    to_plc(Reset, "F1.1", "", "RST: reset or emergency stop", PLC_SIGNALS),
    to_plc(MStrobe, "F7.0", "", "MF: strobe of M", PLC_SIGNALS),
    to_plc(SStrobe, "F7.2", "", "SF: strobe of S", PLC_SIGNALS),
    to_plc(TStrobe, "F7.3", "", "TF: strobe of T", PLC_SIGNALS),
    to_plc(ProgramEnd, "F9.4", "", "DM30: M30", PLC_SIGNALS),
    to_plc(MCode, "F10", "code", "M code (F10 to F13)", PLC_SIGNALS),
];

/// Registers, by device number.
const REGISTERS: &[Signal] = &[
    from_plc(ShiftSpeed, "G29.5", "", "SOR: 1 turns the spindle at the speed of a gear change", MEMORY),
    from_plc(SpindleOverride, "G30", "%", "spindle override, 0 to 254", MEMORY),
    from_plc(MacroInputLow(1032), "G54", "word", "#1032 (G54, G55); its bits are #1000 to #1015", INPUTS),
    to_plc(SpindleCommand, "F22", "r/min", "S code (F22 to F25)", MEMORY),
    to_plc(SpindleOutput, "F36", "0 to 4095", "12-bit value of the analog output (F36, F37)", MEMORY),
    to_plc(SpindleActual, "F40", "r/min", "spindle speed by the encoder (F40, F41)", MEMORY),
    to_plc(MacroOutput(1132), "F54", "word", "#1132 (F54, F55); its bits are #1100 to #1115", INPUTS),
    to_plc(MacroOutput(1133), "F56", "4 bytes", "#1133 (F56 to F59)", MEMORY),
];

//! Registers between PLC and E60.

use super::sources::MEMORY;
use crate::controls::Signal;
use crate::controls::interface::SignalRole::*;
use crate::controls::interface::{from_plc, to_plc};
use crate::controls::schema::table::joined;
use crate::text::{Citation, Grade};

const PAPER: Citation = Citation::new("ribbon dot-printing paper, E60: R148, percent by the M70 driver", Grade::Manual);
const M64: Citation = Citation::new("MELDAS 64 system variable list; the paper names R74", Grade::Sister);
const OUTPUT: Citation = Citation::new("MELDAS 64 system variable list", Grade::Sister);

/// Registers, followed by single signals by device number: signals of the M60S, from memory.
pub(super) const SIGNALS: &[Signal] = joined![Signal: REGISTERS, BITS];

/// Single signals. A `*` in front of the name marks a signal that is active at 0.
const BITS: &[Signal] = &[
    to_plc(MCode, "R20", "code", "M code (R20, R21)", MEMORY),
    to_plc(Running, "X1F3", "", "STL: the program runs", MEMORY),
    to_plc(Reset, "X1F5", "", "RST: reset or emergency stop", MEMORY),
    to_plc(ProgramEnd, "X22F", "", "DM30: M30", MEMORY),
    to_plc(MStrobe, "X230", "", "MF: strobe of M", MEMORY),
    to_plc(SStrobe, "X234", "", "SF: strobe of S", MEMORY),
    to_plc(TStrobe, "X238", "", "TF: strobe of T", MEMORY),
    from_plc(AxesEnable, "Y20F", "", "*AIT: 0 holds all axes", MEMORY),
    from_plc(HoldReleased, "Y211", "", "*SP: 0 is feed hold", MEMORY),
    from_plc(
        FeedOverrideByRegister,
        "Y21F",
        "",
        "FVS: 1 takes R132; at 0 the feed override is a code at Y218 to Y21C",
        MEMORY,
    ),
    from_plc(Finished, "Y226", "", "FIN: M, S and T are done; held until their strobes fall", MEMORY),
    // The M70 has it at Y188F, by as many places before GI1.
    from_plc(
        SpindleOverrideByRegister,
        "Y28F",
        "",
        "SPS: 1 takes R148; at 0 the override is a code at Y288 to Y28A, 100 % without it",
        MEMORY,
    ),
    from_plc(GearIndex(0), "Y290", "", "GI1: gear stage less one, bit 0", MEMORY),
    from_plc(GearIndex(1), "Y291", "", "GI2: gear stage less one, bit 1", MEMORY),
    from_plc(EmergencyRequest, "Y29F", "", "QEMG: 1 is emergency stop", MEMORY),
    from_plc(SpindleHold, "Y2D4", "", "SSTP: 1 puts out 0 V; S stays", MEMORY),
];

/// Registers, by device number.
const REGISTERS: &[Signal] = &[
    to_plc(SpindleCommand, "R8", "r/min", "spindle speed as commanded (R8, R9)", MEMORY),
    to_plc(SpindleFinal, "R10", "r/min", "spindle speed after override and clamp (R10, R11)", MEMORY),
    to_plc(SpindleOutput, "R12", "0 to 4095", "12-bit value of the analog output (R12, R13)", MEMORY),
    to_plc(SpindleActual, "R18", "r/min", "spindle speed by the encoder (R18, R19)", MEMORY),
    from_plc(MacroInputLow(1032), "R72", "word", "low word of #1032; its bits are #1000 to #1015", M64),
    from_plc(MacroInputHigh(1032), "R73", "word", "high word of #1032; its bits are #1016 to #1031", M64),
    from_plc(MacroInputLow(1033), "R74", "word", "low word of #1033", M64),
    from_plc(MacroInputHigh(1033), "R75", "word", "high word of #1033; 0 for a positive percentage", M64),
    from_plc(MacroInputLow(1034), "R76", "word", "low word of #1034", M64),
    from_plc(MacroInputHigh(1034), "R77", "word", "high word of #1034", M64),
    from_plc(MacroInputLow(1035), "R78", "word", "low word of #1035", M64),
    from_plc(MacroInputHigh(1035), "R79", "word", "high word of #1035", M64),
    from_plc(FeedOverride, "R132", "%", "cutting feed override, 0 to 300", MEMORY),
    from_plc(SpindleOverride, "R148", "%", "spindle override, 0 to 200", PAPER),
    to_plc(MacroOutput(1132), "R172", "word", "#1132 (R172, R173); its bits are #1100 to #1131", OUTPUT),
    to_plc(MacroOutput(1133), "R174", "word", "#1133 (R174, R175)", OUTPUT),
    to_plc(MacroOutput(1134), "R176", "word", "#1134 (R176, R177)", OUTPUT),
    to_plc(MacroOutput(1135), "R178", "word", "#1135 (R178, R179)", OUTPUT),
];

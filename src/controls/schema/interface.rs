//! Registers and signals between the PLC and the control.

use super::table::{Key, text_key};
use crate::text::{Citation, Phrase};

/// Instruction set of a control's PLC.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlcLanguage {
    /// FANUC PMC: RD, WRT, functional instructions by their SUB number.
    Pmc,
    /// GSK PLC: LD, OUT, functional instructions by name.
    Gsk,
    /// Mitsubishi: LD, OUT, timers of 10 ms.
    Melsec,
    /// SINUMERIK 802: the S7-200 subset LD, =, TON.
    Step7,
}

/// What a register or signal is for, independent of its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
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
    /// M code as a number, control to PLC.
    MCode,
    /// Dynamic signal of an M function, on for one cycle of the PLC.
    MFunction(u32),
    /// Strobe of M, control to PLC.
    MStrobe,
    /// Strobe of S.
    SStrobe,
    /// Strobe of T.
    TStrobe,
    /// The program runs: off at hold, between two blocks that wait for cycle start, and at an alarm.
    Running,
    /// No program is begun: on until cycle start, after the end and after reset.
    Idle,
    /// M30 is executed.
    ProgramEnd,
    /// Reset or emergency stop acts, control to PLC.
    Reset,
    /// Answer to M, S and T, PLC to control.
    Finished,
    /// Holds the reading of the next block, PLC to control.
    ReadInDisable,
    /// 1 lets the spindle turn, 0 holds it at speed 0; S and M3 stay.
    SpindleEnable,
    /// 1 holds the spindle at speed 0.
    SpindleHold,
    /// 1 lets the axes of the program move.
    AxesEnable,
    /// 1 holds the axes of the program.
    AxesStop,
    /// The spindle has its speed, PLC to control.
    SpeedArrived,
    /// 0 holds the program.
    HoldReleased,
    /// 1 holds the program.
    HoldRequest,
    /// 0 is emergency stop.
    EmergencyReleased,
    /// 1 is emergency stop.
    EmergencyRequest,
    /// 1 resets the control, PLC to control.
    ResetRequest,
    /// The control asks for the gear stage of [`SignalRole::GearAsked`].
    GearChange,
    /// A bit (from 0) of the number of the gear stage that the control asks for.
    GearAsked(u8),
    /// A bit (from 0) of the number of the gear stage that is engaged, PLC to control.
    GearNumber(u8),
    /// A bit (from 0) of that number less one.
    GearIndex(u8),
    /// The gear stage is engaged: answer to [`SignalRole::GearChange`].
    GearChanged,
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
    pub text: Phrase,
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
    Signal { role, device, plc_writes: true, unit, text: Phrase::new(text), cite }
}

/// A row of a register that the control writes.
pub(in crate::controls) const fn to_plc(
    role: SignalRole,
    device: &'static str,
    unit: &'static str,
    text: &'static str,
    cite: Citation,
) -> Signal {
    Signal { role, device, plc_writes: false, unit, text: Phrase::new(text), cite }
}

impl Signal {
    /// Whether its table is sorted, for searches by halves.
    pub const SORTED: bool = false;

    /// The device, for tables that are made of a family's rows and a control's own.
    pub const fn key(&self) -> Key {
        text_key(self.device.as_bytes())
    }
}

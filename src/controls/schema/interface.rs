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

impl PlcLanguage {
    /// Unit of timers in ms.
    pub fn timer_unit(self) -> u32 {
        match self {
            PlcLanguage::Pmc | PlcLanguage::Gsk => 1,
            PlcLanguage::Melsec | PlcLanguage::Step7 => 10,
        }
    }
}

/// Purpose of a register or signal, independent of its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SignalRole {
    /// Spindle override in percent, PLC to control.
    SpindleOverride,
    /// 1 makes the spindle override valid, PLC to control; without it the control takes 100 %.
    SpindleOverrideValid,
    /// 1 takes the register of the spindle override, PLC to control; without it the control takes a code.
    SpindleOverrideByRegister,
    /// Spindle override as the code of an override step, PLC to control.
    SpindleOverrideCode,
    /// Cutting feed override in percent, PLC to control.
    FeedOverride,
    /// 1 takes the register of the cutting feed override, PLC to control; without it the control takes a code.
    FeedOverrideByRegister,
    /// 1 fixes the cutting feed override at 100 %, PLC to control.
    FeedOverrideOff,
    /// 1 makes the cutting feed override valid, PLC to control; without it the control takes 100 %, except
    /// at the lowest position of the switch, which it takes.
    FeedOverrideValid,
    /// Low word of a macro input, PLC to control, with the number of its variable.
    MacroInputLow(u32),
    /// High word of a macro input, PLC to control, with the number of its variable.
    MacroInputHigh(u32),
    /// Word of macro output, control to PLC, with the number of its variable.
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
    /// Dynamic signal of an M function, on for one PLC cycle.
    MFunction(u32),
    /// Strobe of M, control to PLC.
    MStrobe,
    /// Strobe of S, control to PLC.
    SStrobe,
    /// Strobe of T, control to PLC.
    TStrobe,
    /// Dynamic signal of a T function, on for one PLC cycle.
    TFunction,
    /// The program runs: off at hold, between two blocks that wait for cycle start, and at an alarm.
    Running,
    /// No program is started: on until cycle start, after the program end and after reset.
    Idle,
    /// M30 is executed.
    ProgramEnd,
    /// An alarm of program, drives or travel acts, until reset, control to PLC.
    Alarm,
    /// Reset or emergency stop acts, control to PLC.
    Reset,
    /// Answer to M, S and T, PLC to control.
    Finished,
    /// Read-in disable: holds back the next block, PLC to control.
    ReadInDisable,
    /// 1 lets the spindle turn, 0 holds it at speed 0; S and M3 stay in force.
    SpindleEnable,
    /// 1 holds the spindle at speed 0.
    SpindleHold,
    /// 1 lets the axes of the program move.
    AxesEnable,
    /// 1 holds the axes of the program.
    AxesStop,
    /// The position loop of the spindle is on: it turns to an angle or holds it, control to PLC.
    SpindlePositions,
    /// 1 turns the spindle at the speed of a gear change, PLC to control.
    ShiftSpeed,
    /// The spindle has reached its speed, PLC to control.
    SpeedArrived,
    /// 0 holds the program.
    HoldReleased,
    /// 1 holds the program.
    HoldRequest,
    /// 0 is emergency stop.
    EmergencyReleased,
    /// 1 is emergency stop.
    EmergencyRequest,
    /// 1 acknowledges an emergency stop that is over, PLC to control.
    EmergencyAcknowledge,
    /// 1 resets the control, PLC to control.
    ResetRequest,
    /// The control requests the gear stage of [`SignalRole::GearAsked`].
    GearChange,
    /// A bit (from 0) of the number of the requested gear stage.
    GearAsked(u8),
    /// A bit (from 0) of the number of the engaged gear stage, PLC to control.
    GearNumber(u8),
    /// A bit (from 0) of the number of the engaged gear stage minus 1.
    GearIndex(u8),
    /// The gear stage is engaged: answer to [`SignalRole::GearChange`].
    GearChanged,
}

/// A register.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Signal {
    /// Purpose of the signal.
    pub role: SignalRole,
    /// Device, for instance `R148`.
    pub device: &'static str,
    /// Whether the PLC writes it (and the control reads it).
    pub plc_writes: bool,
    /// Unit or range.
    pub unit: &'static str,
    /// Description.
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
    /// Whether the table is sorted, for binary search.
    pub const SORTED: bool = false;

    /// Key for replacing a family's row by the control's own row of the same device.
    pub const fn key(&self) -> Key {
        text_key(self.device.as_bytes())
    }
}

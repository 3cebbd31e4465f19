//! Signals between PLC and control in the SINUMERIK 802 family; M functions are dynamic signals, there is no FIN.

use super::sources::{MEMORY, PLC_AXES, PLC_RULE, PLC_SIGNALS};
use crate::controls::Signal;
use crate::controls::interface::SignalRole::*;
use crate::controls::interface::{from_plc, to_plc};

/// Signals by address; the spindle is axis 3.
pub const SIGNALS: &[Signal] = &[
    to_plc(TFunction, "V25000008.0", "", "T function, for one cycle of the PLC; its number is VD25002000", MEMORY),
    to_plc(MFunction(3), "V25001000.3", "", "M3, for one cycle of the PLC", PLC_SIGNALS),
    to_plc(MFunction(4), "V25001000.4", "", "M4, for one cycle of the PLC", PLC_SIGNALS),
    to_plc(MFunction(5), "V25001000.5", "", "M5, for one cycle of the PLC", PLC_SIGNALS),
    from_plc(EmergencyRequest, "V26000000.1", "", "emergency stop", PLC_SIGNALS),
    from_plc(
        EmergencyAcknowledge,
        "V26000000.2",
        "",
        "emergency stop is over: acknowledged, with the reset after it",
        PLC_SIGNALS,
    ),
    from_plc(ResetRequest, "V30000000.7", "", "reset of the mode group", PLC_RULE),
    from_plc(AxesStop, "V32000006.0", "", "feed disable", PLC_RULE),
    from_plc(ReadInDisable, "V32000006.1", "", "read-in disable: the next block waits", PLC_RULE),
    from_plc(FeedOverrideValid, "V32000006.7", "", "feed override is valid; at 0 it is 100 %, but for 0 %", PLC_RULE),
    from_plc(HoldRequest, "V32000007.3", "", "NC stop", PLC_RULE),
    to_plc(Running, "V33000003.0", "", "the program runs", PLC_SIGNALS),
    to_plc(Idle, "V33000003.7", "", "channel in reset: no program is begun", PLC_SIGNALS),
    from_plc(GearNumber(0), "V38032000.0", "", "gear stage that is engaged, bit 0", PLC_AXES),
    from_plc(GearNumber(1), "V38032000.1", "", "gear stage that is engaged, bit 1", PLC_AXES),
    from_plc(GearNumber(2), "V38032000.2", "", "gear stage that is engaged, bit 2", PLC_AXES),
    from_plc(GearChanged, "V38032000.3", "", "gear stage is changed", PLC_AXES),
    from_plc(ShiftSpeed, "V38032002.5", "", "oscillation: the spindle turns at the speed of a gear change", PLC_AXES),
    from_plc(SpindleOverride, "VB38032003", "%", "spindle override; its code is a machine datum", MEMORY),
    from_plc(SpindleOverrideValid, "V38030001.7", "", "spindle override is valid; at 0 it is 100 %", PLC_AXES),
    from_plc(SpindleHold, "V38030004.3", "", "spindle stop", PLC_AXES),
    to_plc(SpindlePositions, "V39030001.5", "", "position loop of the spindle is on", PLC_AXES),
    to_plc(GearAsked(0), "V39032000.0", "", "gear stage that is asked for, bit 0", PLC_AXES),
    to_plc(GearAsked(1), "V39032000.1", "", "gear stage that is asked for, bit 1", PLC_AXES),
    to_plc(GearAsked(2), "V39032000.2", "", "gear stage that is asked for, bit 2", PLC_AXES),
    to_plc(GearChange, "V39032000.3", "", "change the gear stage", PLC_AXES),
];

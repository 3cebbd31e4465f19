//! Variables of the 980TDc, in rising order.

use super::sources::MACRO;
use crate::controls::VarKind::*;
use crate::controls::base::fanuc;
use crate::controls::schema::table::{extended, taken};
use crate::controls::vars::{Clock, Width, range};
use crate::controls::{Group, VarRange};

/// Every range; a number in none of them does not exist.
pub(super) const VARS: &[VarRange] = extended![
    VarRange: taken![
        VarRange: fanuc::LATHE_VARS,
        MACRO => "0-999 3000 3011-3012 3901-3902 4001 4002 4006 4007 4012 4014 4016 4109 4113-4115 4119-4120",
    ],
    &[
        range(1000, 1015, InputBit, "G54", "inputs from the PLC, bit by bit", MACRO),
        range(1032, 1032, InputWord(Width::Word), "G54", "input from the PLC, 16 bits", MACRO),
        range(1033, 1033, InputWord(Width::Word), "G56", "input from the PLC, 16 bits", MACRO),
        range(1034, 1034, InputWord(Width::Word), "G58", "input from the PLC, 16 bits", MACRO),
        range(1100, 1115, OutputBit, "F54", "outputs to the PLC, bit by bit", MACRO),
        range(1132, 1132, OutputWord(Width::Word), "F54", "output to the PLC, 16 bits", MACRO),
        range(1133, 1133, OutputWord(Width::Word), "F56", "output to the PLC, 16 bits", MACRO),
        range(1134, 1134, OutputWord(Width::Word), "F58", "output to the PLC, 16 bits", MACRO),
        range(2001, 2032, Kept, "", "tool wear X", MACRO),
        range(2101, 2132, Kept, "", "tool wear Z", MACRO),
        range(2201, 2232, Kept, "", "tool nose radius, wear", MACRO),
        range(2301, 2332, Kept, "", "tool nose position", MACRO),
        range(2401, 2432, Kept, "", "tool wear Y", MACRO),
        range(2451, 2482, Kept, "", "tool geometry Y", MACRO),
        range(2501, 2502, Kept, "", "shift of the work coordinate system, X and Z", MACRO),
        range(2701, 2732, Kept, "", "tool geometry X", MACRO),
        range(2801, 2832, Kept, "", "tool geometry Z", MACRO),
        range(2901, 2932, Kept, "", "tool nose radius, geometry", MACRO),
        range(3001, 3001, PartTime, "", "time of this part in s", MACRO),
        range(3002, 3002, RunTime(Clock::Seconds), "", "time of cutting in s", MACRO),
        range(4005, 4005, ModalCode(Group::FeedUnit), "", "G98 or G99, group 03", MACRO),
        range(5001, 5004, BlockEnd, "", "end point of the block before: X, Y, Z, 4th", MACRO),
        range(5005, 5005, NotSimulated, "", "end point of the block before, 5th axis", MACRO),
        range(5021, 5024, MachinePosition, "", "machine position: X, Y, Z, 4th", MACRO),
        range(5025, 5025, NotSimulated, "", "machine position, 5th axis", MACRO),
        range(5041, 5044, WorkPosition, "", "work position: X, Y, Z, 4th", MACRO),
        range(5045, 5045, NotSimulated, "", "work position, 5th axis", MACRO),
        range(5121, 5125, NotSimulated, "", "handwheel interrupt, axis by axis", MACRO),
        range(5201, 5204, WorkOffsetShown(0), "", "shift of all work coordinate systems: X, Y, Z, 4th", MACRO),
        range(5205, 5205, NotSimulated, "", "shift of all work coordinate systems, 5th axis", MACRO),
        range(5221, 5224, WorkOffsetShown(1), "", "zero of G54: X, Y, Z, 4th", MACRO),
        range(5225, 5225, NotSimulated, "", "zero of G54, 5th axis", MACRO),
        range(5241, 5244, WorkOffsetShown(2), "", "zero of G55: X, Y, Z, 4th", MACRO),
        range(5245, 5245, NotSimulated, "", "zero of G55, 5th axis", MACRO),
        range(5261, 5264, WorkOffsetShown(3), "", "zero of G56: X, Y, Z, 4th", MACRO),
        range(5265, 5265, NotSimulated, "", "zero of G56, 5th axis", MACRO),
        range(5281, 5284, WorkOffsetShown(4), "", "zero of G57: X, Y, Z, 4th", MACRO),
        range(5285, 5285, NotSimulated, "", "zero of G57, 5th axis", MACRO),
        range(5301, 5304, WorkOffsetShown(5), "", "zero of G58: X, Y, Z, 4th", MACRO),
        range(5305, 5305, NotSimulated, "", "zero of G58, 5th axis", MACRO),
        range(5321, 5324, WorkOffsetShown(6), "", "zero of G59: X, Y, Z, 4th", MACRO),
        range(5325, 5325, NotSimulated, "", "zero of G59, 5th axis", MACRO),
    ],
];

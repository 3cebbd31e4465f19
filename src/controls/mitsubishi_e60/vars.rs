//! Variables of the E60, in rising order.

use super::sources::MEMORY;
use crate::controls::Address;
use crate::controls::VarKind::*;
use crate::controls::base::fanuc;
use crate::controls::schema::table::{extended, taken};
use crate::controls::vars::{Clock, Width, range};
use crate::controls::{Group, VarRange};
use crate::text::{Citation, Grade};

const NULL: Citation = Citation::new("M700V/M70V programming manual, p.326", Grade::Sister);
const HEADER: Citation = Citation::new("Mitsubishi Custom-API header, macro variables", Grade::Sister);
const M64: Citation = Citation::new("MELDAS 64 system variable list; the paper names R74", Grade::Sister);
const MODAL: Citation = Citation::new("M700V/M70V programming manual, p.343", Grade::Sister);

/// Every range; a number in none of them is out of range.
pub(super) const VARS: &[VarRange] = extended![
    VarRange: taken![
        VarRange: fanuc::MILL_VARS,
        NULL => "0",
        HEADER => "1-33",
        MEMORY => "3000 3001 3003 3004 3006 5001-5004 5021-5024 5041-5044 5061-5064 5201-5324",
    ],
    &[
        range(100, 149, Common, "", "common, 50 sets as standard", MEMORY),
        range(150, 199, Common, "", "common, option: 200 sets and more", MEMORY),
        range(500, 549, Retained, "", "common, kept at power-off, 50 sets as standard", MEMORY),
        range(550, 599, Retained, "", "common, kept at power-off, option: 200 sets and more", MEMORY),
        range(600, 699, Retained, "", "common, kept at power-off, option: 300 sets and more", MEMORY),
        range(700, 999, Retained, "", "common, kept at power-off, option: 600 sets", MEMORY),
        range(1000, 1015, InputBit, "R72", "inputs from the PLC, bit by bit", M64),
        range(1016, 1031, InputBit, "R73", "inputs from the PLC, bit by bit", M64),
        range(1032, 1032, InputWord(Width::Long), "R72", "input from the PLC, 32 bits", M64),
        range(1033, 1033, InputWord(Width::Long), "R74", "input from the PLC, 32 bits", M64),
        range(1034, 1034, InputWord(Width::Long), "R76", "input from the PLC, 32 bits", M64),
        range(1035, 1035, InputWord(Width::Long), "R78", "input from the PLC, 32 bits", M64),
        range(1100, 1115, OutputBit, "R172", "outputs to the PLC, bit by bit", M64),
        range(1116, 1131, OutputBit, "R173", "outputs to the PLC, bit by bit", M64),
        range(1132, 1132, OutputWord(Width::Long), "R172", "output to the PLC, 32 bits", M64),
        range(1133, 1133, OutputWord(Width::Long), "R174", "output to the PLC, 32 bits", M64),
        range(1134, 1134, OutputWord(Width::Long), "R176", "output to the PLC, 32 bits", M64),
        range(1135, 1135, OutputWord(Width::Long), "R178", "output to the PLC, 32 bits", M64),
        range(1200, 1295, NotSimulated, "", "input words 33 to 35 bit by bit, later versions", MEMORY),
        range(1300, 1395, NotSimulated, "", "output words 33 to 35 bit by bit, later versions", MEMORY),
        range(2001, 2800, Kept, "", "tool offsets", Citation::new("MELDAS 64 system variable list", Grade::Sister)),
        range(3002, 3002, RunTime(Clock::Milliseconds), "", "time of automatic running in ms", MEMORY),
        range(4001, 4001, ModalCode(Group::Motion), "", "motion, as read ahead", MEMORY),
        range(4002, 4002, ModalCode(Group::Plane), "", "plane, as read ahead", MEMORY),
        range(4003, 4003, ModalCode(Group::Distance), "", "G90 or G91, as read ahead", MEMORY),
        range(4004, 4004, NotSimulated, "", "codes of further groups, as read ahead", MEMORY),
        range(4005, 4005, ModalCode(Group::FeedUnit), "", "G94 or G95, as read ahead", MEMORY),
        range(4006, 4006, ModalCode(Group::LengthUnit), "", "G20 or G21, as read ahead", MEMORY),
        range(4007, 4008, NotSimulated, "", "codes of further groups, as read ahead", MEMORY),
        range(4009, 4009, ModalCode(Group::Cycle), "", "fixed cycle, as read ahead", MEMORY),
        range(4010, 4011, NotSimulated, "", "codes of further groups, as read ahead", MEMORY),
        range(4012, 4012, ModalCode(Group::Coordinates), "", "G54 to G59, as read ahead", MEMORY),
        range(4013, 4013, ModalCode(Group::PathMode), "", "G61 or G64, as read ahead", MEMORY),
        range(4014, 4014, ModalCode(Group::MacroModal), "", "G66 or G67, as read ahead", MEMORY),
        range(4015, 4016, NotSimulated, "", "codes of further groups, as read ahead", MEMORY),
        range(4017, 4017, ModalCode(Group::SurfaceSpeed), "", "G96 or G97, as read ahead", MEMORY),
        range(4018, 4021, NotSimulated, "", "codes of further groups, as read ahead", MEMORY),
        range(4101, 4106, NotSimulated, "", "further words, as read ahead", MODAL),
        range(4107, 4107, ModalWord(Address::D), "", "D, as read ahead", MODAL),
        range(4108, 4108, NotSimulated, "", "further words, as read ahead", MODAL),
        range(4109, 4109, ModalWord(Address::F), "", "F, as read ahead", MODAL),
        range(4110, 4110, NotSimulated, "", "further words, as read ahead", MODAL),
        range(4111, 4111, ModalWord(Address::H), "", "H, as read ahead", MODAL),
        range(4112, 4112, NotSimulated, "", "further words, as read ahead", MODAL),
        range(4113, 4113, ModalWord(Address::M), "", "M, as read ahead", MODAL),
        range(4114, 4114, ModalWord(Address::N), "", "N, as read ahead", MODAL),
        range(4115, 4115, ModalWord(Address::O), "", "program number, as read ahead", MODAL),
        range(4116, 4118, NotSimulated, "", "further words, as read ahead", MODAL),
        range(4119, 4119, ModalWord(Address::S), "", "S, as read ahead", MODAL),
        range(4120, 4120, ModalWord(Address::T), "", "T, as read ahead", MODAL),
        range(4201, 4201, ExecutingCode(Group::Motion), "", "motion, executing block", MEMORY),
        range(4202, 4202, ExecutingCode(Group::Plane), "", "plane, executing block", MEMORY),
        range(4203, 4203, ExecutingCode(Group::Distance), "", "G90 or G91, executing block", MEMORY),
        range(4204, 4204, NotSimulated, "", "codes of further groups, executing block", MEMORY),
        range(4205, 4205, ExecutingCode(Group::FeedUnit), "", "G94 or G95, executing block", MEMORY),
        range(4206, 4206, ExecutingCode(Group::LengthUnit), "", "G20 or G21, executing block", MEMORY),
        range(4207, 4208, NotSimulated, "", "codes of further groups, executing block", MEMORY),
        range(4209, 4209, ExecutingCode(Group::Cycle), "", "fixed cycle, executing block", MEMORY),
        range(4210, 4211, NotSimulated, "", "codes of further groups, executing block", MEMORY),
        range(4212, 4212, ExecutingCode(Group::Coordinates), "", "G54 to G59, executing block", MEMORY),
        range(4213, 4213, ExecutingCode(Group::PathMode), "", "G61 or G64, executing block", MEMORY),
        range(4214, 4214, ExecutingCode(Group::MacroModal), "", "G66 or G67, executing block", MEMORY),
        range(4215, 4216, NotSimulated, "", "codes of further groups, executing block", MEMORY),
        range(4217, 4217, ExecutingCode(Group::SurfaceSpeed), "", "G96 or G97, executing block", MEMORY),
        range(4218, 4221, NotSimulated, "", "codes of further groups, executing block", MEMORY),
        range(4301, 4306, NotSimulated, "", "further words, executing block", MODAL),
        range(4307, 4307, ExecutingWord(Address::D), "", "D, executing block", MODAL),
        range(4308, 4308, NotSimulated, "", "further words, executing block", MODAL),
        range(4309, 4309, ExecutingWord(Address::F), "", "F, executing block", MODAL),
        range(4310, 4310, NotSimulated, "", "further words, executing block", MODAL),
        range(4311, 4311, ExecutingWord(Address::H), "", "H, executing block", MODAL),
        range(4312, 4312, NotSimulated, "", "further words, executing block", MODAL),
        range(4313, 4313, ExecutingWord(Address::M), "", "M, executing block", MODAL),
        range(4314, 4314, ExecutingWord(Address::N), "", "N, executing block", MODAL),
        range(4315, 4315, ExecutingWord(Address::O), "", "program number, executing block", MODAL),
        range(4316, 4318, NotSimulated, "", "further words, executing block", MODAL),
        range(4319, 4319, ExecutingWord(Address::S), "", "S, executing block", MODAL),
        range(4320, 4320, ExecutingWord(Address::T), "", "T, executing block", MODAL),
        range(5081, 5084, NotSimulated, "", "tool position offset, axis by axis", MEMORY),
        range(5101, 5104, NotSimulated, "", "servo deviation, axis by axis", MEMORY),
        range(10001, 10999, Kept, "", "tool offsets", Citation::new("MELDAS 64 system variable list", Grade::Sister)),
    ],
];

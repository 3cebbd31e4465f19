//! Variables of the E60, in rising order.

use super::MEMORY;
use crate::controls::VarKind::*;
use crate::controls::VarRange;
use crate::controls::vars::range;
use crate::text::{Citation, Grade};

const NULL: Citation = Citation::new("M700V/M70V programming manual, p.326", Grade::Sister);
const HEADER: Citation = Citation::new("Mitsubishi Custom-API header, macro variables", Grade::Sister);
const M64: Citation = Citation::new("MELDAS 64 system variable list; the paper names R74", Grade::Sister);
const MODAL: Citation = Citation::new("M700V/M70V programming manual, p.343", Grade::Sister);

/// Every range; a number in none of them is out of range.
pub(super) const VARS: &[VarRange] = &[
    range(0, 0, Vacant, "", "always vacant", NULL),
    range(1, 33, Local, "", "local, one set per macro level", HEADER),
    range(100, 149, Common, "", "common, 50 sets as standard", MEMORY),
    range(500, 549, Retained, "", "common, kept at power-off, 50 sets as standard", MEMORY),
    range(1000, 1015, InputBit, "R72", "inputs from the PLC, bit by bit", M64),
    range(1016, 1031, InputBit, "R73", "inputs from the PLC, bit by bit", M64),
    range(1032, 1032, InputWord, "R72", "input from the PLC, 32 bits", M64),
    range(1033, 1033, InputWord, "R74", "input from the PLC, 32 bits", M64),
    range(1034, 1034, InputWord, "R76", "input from the PLC, 32 bits", M64),
    range(1035, 1035, InputWord, "R78", "input from the PLC, 32 bits", M64),
    range(1100, 1115, OutputBit, "R172", "outputs to the PLC, bit by bit", M64),
    range(1116, 1131, OutputBit, "R173", "outputs to the PLC, bit by bit", M64),
    range(1132, 1132, OutputWord, "R172", "output to the PLC, 32 bits", M64),
    range(1133, 1133, OutputWord, "R174", "output to the PLC, 32 bits", M64),
    range(1134, 1134, OutputWord, "R176", "output to the PLC, 32 bits", M64),
    range(1135, 1135, OutputWord, "R178", "output to the PLC, 32 bits", M64),
    range(1200, 1295, NotSimulated, "", "input words 33 to 35 bit by bit, later versions", MEMORY),
    range(1300, 1395, NotSimulated, "", "output words 33 to 35 bit by bit, later versions", MEMORY),
    range(2001, 2800, ToolOffset, "", "tool offsets", Citation::new("MELDAS 64 system variable list", Grade::Sister)),
    range(3000, 3000, AlarmMessage, "", "alarm with message", MEMORY),
    range(3001, 3001, PowerOnTime, "", "time since power-on in ms", MEMORY),
    range(3002, 3002, RunTime, "", "time of automatic running in ms", MEMORY),
    range(3003, 3003, SuppressSingleBlock, "", "single block and FIN suppressed", MEMORY),
    range(3004, 3004, SuppressOverride, "", "feed hold, override, exact stop suppressed", MEMORY),
    range(3006, 3006, StopMessage, "", "stop with message", MEMORY),
    range(4001, 4021, Modal, "", "G codes by group, as read ahead", MEMORY),
    range(4101, 4120, Modal, "", "words, as read ahead", MODAL),
    range(4201, 4221, ModalExecuting, "", "G codes by group, executing block", MEMORY),
    range(4301, 4320, ModalExecuting, "", "words, executing block", MODAL),
    range(5001, 5004, BlockEnd, "", "end point of the block before, axis by axis", MEMORY),
    range(5021, 5024, MachinePosition, "", "machine position, axis by axis", MEMORY),
    range(5041, 5044, WorkPosition, "", "work position, axis by axis", MEMORY),
    range(5061, 5064, NotSimulated, "", "skip position, axis by axis", MEMORY),
    range(5081, 5084, NotSimulated, "", "tool position offset, axis by axis", MEMORY),
    range(5101, 5104, NotSimulated, "", "servo deviation, axis by axis", MEMORY),
    range(5201, 5324, NotSimulated, "", "work coordinate offsets", MEMORY),
    range(10001, 10999, ToolOffset, "", "tool offsets", Citation::new("MELDAS 64 system variable list", Grade::Sister)),
];

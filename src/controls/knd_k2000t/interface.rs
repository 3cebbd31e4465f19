//! Registers between PMC and K2000T.

use super::{MEMORY, PAPER};
use crate::controls::Signal;
use crate::controls::interface::SignalRole::*;
use crate::controls::interface::{from_plc, to_plc};

/// By device number.
pub(super) const SIGNALS: &[Signal] = &[
    from_plc(MacroInputLow(1032), "G54", "word", "#1032 (G54, G55); its bits are #1000 to #1015", MEMORY),
    to_plc(MacroOutput(1132), "F54", "word", "#1132 (F54, F55); its bits are #1100 to #1115", MEMORY),
    to_plc(MacroOutput(1480), "F480", "4 bytes", "#1480; polygon turning: speed", PAPER),
    to_plc(MacroOutput(1484), "F484", "4 bytes", "#1484; polygon turning: ratio of the work piece", PAPER),
    to_plc(MacroOutput(1488), "F488", "4 bytes", "#1488; polygon turning: ratio of the tool", PAPER),
];

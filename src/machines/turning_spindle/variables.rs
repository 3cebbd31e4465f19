//! Variables of the turning spindle's programs.

/// Variable to which the program copies an entry before it checks it: it cuts by the copy, so that an entry that changes meanwhile acts from
/// the next start. They are local variables 1 to 27, or R1 to R27.
pub(super) const fn copy(entry: u32) -> u32 {
    entry - 99
}

/// Surface speed of the cut, m/min.
pub(super) const CUTTING_SPEED: u32 = 100;

/// Feed, mm/rev.
pub(super) const FEED: u32 = 101;

/// Diameter of the stock, mm.
pub(super) const STOCK: u32 = 102;

/// Finished diameter, on a taper that at the face, mm.
pub(super) const FINISHED: u32 = 103;

/// Diameter at the end of a taper, mm.
pub(super) const TAPER_END: u32 = 104;

/// Length of the cut, mm.
pub(super) const LENGTH: u32 = 105;

/// Depth of a pass, mm.
pub(super) const DEPTH: u32 = 106;

/// Highest speed of the spindle in the cut, r/min.
pub(super) const SPEED_LIMIT: u32 = 107;

/// Distance of the tool from the stock before and behind a cut, mm.
pub(super) const CLEARANCE: u32 = 108;

/// X where the program begins and ends, as a diameter, mm.
pub(super) const START_X: u32 = 111;

/// Z where the program begins and ends, mm.
pub(super) const START_Z: u32 = 112;

/// Angle of the spindle for the keyway, °.
pub(super) const ANGLE: u32 = 113;

/// Allowance of a face, mm.
pub(super) const ALLOWANCE: u32 = 114;

/// Highest speed of the chuck, r/min.
pub(super) const CHUCK_LIMIT: u32 = 115;

/// Lowest speed of the spindle, r/min.
pub(super) const LOWEST_SPEED: u32 = 116;

/// Depth of the keyway, mm.
pub(super) const KEYWAY_DEPTH: u32 = 117;

/// Length of the keyway, mm.
pub(super) const KEYWAY_LENGTH: u32 = 118;

/// Distance of the keyway from the face, mm.
pub(super) const KEYWAY_START: u32 = 119;

/// Diameter of the driven tool, which is the width of the keyway, mm.
pub(super) const KEYWAY_WIDTH: u32 = 120;

/// Speed of the driven tool, r/min.
pub(super) const DRIVEN_SPEED: u32 = 121;

/// Feed along the keyway, mm/min.
pub(super) const KEYWAY_FEED: u32 = 122;

/// Feed into the work, mm/min.
pub(super) const KEYWAY_INFEED: u32 = 123;

/// 1 from the first cut of a part to its end: a start after a reset stops with a message until the operator has retracted the tool.
pub(super) const BEGUN: u32 = 124;

/// Greatest length behind the face that may be cut, mm: no cut goes further toward the chuck.
pub(super) const REACH: u32 = 125;

/// Room that the turret needs beside the work to turn, mm.
pub(super) const ROOM: u32 = 126;

/// Speed at the largest diameter, r/min: kept through the cut, or set after it. Local, as all of the program's own
/// below: they drive the tool, and neither the operator's entries nor another program may reach them while a part is
/// cut. Its number is that of a copy of 109, which is not an entry.
pub(super) const SPEED: u32 = copy(109);

/// Stock that remains after the pass, mm: in diameter, on a face along Z. Its number is that of a copy of 110, which is
/// not an entry.
pub(super) const LEFT: u32 = copy(110);

/// Length of a taper (mm) per mm of diameter; 0 for a cylinder.
pub(super) const SLOPE: u32 = 28;

/// Diameter at which a pass of a taper begins, mm.
pub(super) const BEGIN_X: u32 = 29;

/// Z at which a pass of a taper begins, mm.
pub(super) const BEGIN_Z: u32 = 30;

/// Diameter at which a pass of a taper ends, mm.
pub(super) const END_X: u32 = 31;

//! Ranges of words, nesting depths and what a block costs.

use super::code::CodeId;
use crate::text::Citation;

/// Ranges and depths; a program beyond them gets the control's alarm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Command unit in millimetres or degrees, for instance 0.001.
    pub increment: f64,
    /// Largest coordinate in millimetres or degrees.
    pub coordinate_max: f64,
    /// Largest feed in mm/min.
    pub feed_max: f64,
    /// Largest feed per revolution in mm/rev.
    pub revolution_feed_max: f64,
    /// The inch code that applies to feeds too, where the other inch codes do not; `None`: all inch codes do.
    pub inch_feeds: Option<CodeId>,
    /// Largest lead of a thread in mm/rev.
    pub lead_max: f64,
    /// Smallest feed step in mm/min.
    pub feed_increment: f64,
    /// Start and end of an arc may differ by this in their distance from the centre, in millimetres.
    pub arc_tolerance: f64,
    /// The centre of an arc by I, J, K is moved so that the arc ends where it should, however far it lies off; else the tolerance
    /// holds.
    pub arc_centre_moves: bool,
    /// The number of F stays in force when its unit changes; else F has to be given anew.
    pub feed_kept: bool,
    /// Largest S word in r/min.
    pub speed_max: f64,
    /// Least and largest limit of the spindle speed in r/min; `None` where it has the range of S.
    pub speed_limit: Option<(f64, f64)>,
    /// Largest T word.
    pub tool_max: u32,
    /// Largest D word; `None` where no row says.
    pub offset_max: Option<u32>,
    /// M codes of one block that act, 8 at most; of more, the last ones do.
    pub m_codes: u8,
    /// Subprograms nested at most.
    pub sub_depth: u8,
    /// Macro calls nested at most.
    pub macro_depth: u8,
    /// Largest repeat count of a call.
    pub repeat_max: u32,
    /// Source and grade of the ranges.
    pub cite: Citation,
}

/// What a block costs and how far the control reads ahead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Timing {
    /// Seconds per block with NC words.
    pub block: f64,
    /// Seconds per macro block.
    pub macro_block: f64,
    /// Blocks that the control reads ahead of the executing one.
    pub preread: u8,
    /// Source and grade.
    pub cite: Citation,
}

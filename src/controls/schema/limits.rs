//! Ranges of words, nesting depths, block times, and the knob of the feed override.

use super::code::CodeId;
use crate::drives::speed::KnobRange;
use crate::text::Citation;

/// Ranges and depths of a control. A program that exceeds them raises the control's alarm.
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
    /// The only inch code that converts feeds too; `None`: all inch codes do.
    pub inch_feeds: Option<CodeId>,
    /// Largest lead of a thread in mm/rev.
    pub lead_max: f64,
    /// Smallest feed step in mm/min.
    pub feed_increment: f64,
    /// Maximum difference (mm) between the distances of an arc's start and end from its centre.
    pub arc_tolerance: f64,
    /// The control moves an arc's centre given by I, J, K to fit the programmed end point, at any distance; otherwise `arc_tolerance`
    /// applies.
    pub arc_centre_moves: bool,
    /// An arc by its radius whose end is its start moves nothing; otherwise it is an alarm.
    pub point_arc_rests: bool,
    /// The number of F stays in force when its unit changes; otherwise F has to be programmed again.
    pub feed_kept: bool,
    /// Largest S word in r/min.
    pub speed_max: f64,
    /// Range of a spindle speed limit in r/min; `None`: the range of S.
    pub speed_limit: Option<(f64, f64)>,
    /// Largest T word.
    pub tool_max: u32,
    /// Largest D word; `None` if unknown.
    pub offset_max: Option<u32>,
    /// Maximum effective M codes of a block (at most 8). In a block with more, the last ones act.
    pub m_codes: u8,
    /// Maximum depth of nested subprograms.
    pub sub_depth: u8,
    /// Maximum depth of nested macro calls.
    pub macro_depth: u8,
    /// Largest repeat count of a call.
    pub repeat_max: u32,
    /// Source and grade of the ranges.
    pub cite: Citation,
}

/// Time per block and number of blocks read ahead.
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

/// Knob of the cutting feed override on the operator's panel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeedKnob {
    /// Positions, %.
    pub positions: KnobRange,
    /// Source and grade.
    pub cite: Citation,
}

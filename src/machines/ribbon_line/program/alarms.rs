//! Numbers of the alarms of the ribbon line's programs.

use crate::machines::ribbon_line::axes::PerAxis;

/// An F above the limit.
pub(super) const FEED: u32 = 20;

/// A length below a pitch.
pub(super) const SHORT_LENGTH: u32 = 21;

/// A length that is no whole number of pitches.
pub(super) const PART_OF_A_PITCH: u32 = 22;

/// A product after one that was broken off, where the program cannot find the heads.
pub(super) const BROKEN_OFF: u32 = 23;

/// An axis above its clamp: the pull axis, the print roller.
pub(super) const CLAMPS: PerAxis<u32> = PerAxis { pull: 24, print: 25 };

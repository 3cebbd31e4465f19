//! Variables of the ribbon line's programs: the numbers of the paper's listing where it has them, otherwise our own.

/// Programmed speed of the unwinder, r/min.
pub(super) const SPEED: u32 = 100;

/// Reduction ratio of the unwinder.
pub(super) const REDUCTION: u32 = 101;

/// Diameter of the press roller, mm.
pub(super) const PRESS_ROLLER: u32 = 102;

/// Override that the operator types in, where the control has no macro input for it, %.
pub(super) const TYPED_OVERRIDE: u32 = 103;

/// Actual speed of the unwinder, equation (1), r/min.
pub(super) const ACTUAL_SPEED: u32 = 104;

/// Speed of the ribbon, mm/min.
pub(super) const LINE_SPEED: u32 = 105;

/// Length of a product, mm, if the product is entered by its length.
pub(super) const LENGTH: u32 = 106;

/// Pitch of the dots, mm.
pub(super) const PITCH: u32 = 107;

/// Number of print heads.
pub(super) const HEADS: u32 = 109;

/// Travel of the print roller per pitch, one head further, mm or °.
pub(super) const STROKE: u32 = 110;

/// Diameter of the print roller, mm.
pub(super) const PRINT_ROLLER: u32 = 111;

/// F per minute that moves both axes, equation (4).
pub(super) const VECTOR_FEED: u32 = 115;

/// Highest speed of the unwinder, r/min.
pub(super) const SPEED_CLAMP: u32 = 116;

/// F per revolution of the unwinder's motor.
pub(super) const FEED_PER_TURN: u32 = 117;

/// Ribbon per revolution of the unwinder's motor, equation (2), mm.
pub(super) const RIBBON_PER_TURN: u32 = 118;

/// Greatest F.
pub(super) const FEED_LIMIT: u32 = 119;

/// Pitches of a product, if the product is entered by its pitches.
pub(super) const COUNT: u32 = 120;

/// Pitches of a block as the operator wants them.
pub(super) const BLOCK_SIZE: u32 = 121;

/// Remainder of the print roller's travel, which the next block makes up.
pub(super) const REMAINDER: u32 = 122;

/// Exact travel of the print roller in a block.
pub(super) const BLOCK_STROKE: u32 = 123;

/// Travel of the print roller in a block, in whole increments.
pub(super) const PRINT_TRAVEL: u32 = 124;

/// Pitches left.
pub(super) const LEFT: u32 = 125;

/// Length of a shorter last pitch, mm.
pub(super) const LAST: u32 = 126;

/// S of the running unwinder, r/min; 0 at rest.
pub(super) const RUNNING_SPEED: u32 = 127;

/// Pitches of the present block: the last one may be shorter.
pub(super) const BLOCK_PITCHES: u32 = 128;

/// Word of the pull axis in a block.
pub(super) const PULL_LENGTH: u32 = 129;

/// Copy of the override, to detect a turned knob in the running line.
pub(super) const KNOB: u32 = 130;

/// Copies of the entries with which the running line was computed.
pub(super) const SPEED_COPY: u32 = 131;
pub(super) const REDUCTION_COPY: u32 = 132;
pub(super) const PRESS_ROLLER_COPY: u32 = 133;
pub(super) const PITCH_COPY: u32 = 134;
pub(super) const HEADS_COPY: u32 = 135;
pub(super) const PRINT_ROLLER_COPY: u32 = 136;

/// Length left, mm.
pub(super) const LENGTH_LEFT: u32 = 137;

/// Distance of the nearest head from the ribbon, in heads; if the program cannot read positions, 1 from the start of a product to its end.
pub(super) const PHASE: u32 = 138;

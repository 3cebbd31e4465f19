//! Numbers of the groups and nodes that poses change.

/// Groups that poses move.
pub(in super::super) mod group {
    /// The turret; its origin is the tip of the tool.
    pub(in crate::machines::turning_spindle) const TURRET: u16 = 1;
    /// Needles of the speed and of the voltage.
    pub(in crate::machines::turning_spindle) const SPEED: u16 = 2;
    pub(in crate::machines::turning_spindle) const NEEDLE: u16 = 3;
    /// Jaws behind the part, before it, and the ring that they blur to.
    pub(in crate::machines::turning_spindle) const JAWS_FAR: u16 = 4;
    pub(in crate::machines::turning_spindle) const JAWS_NEAR: u16 = 5;
    pub(in crate::machines::turning_spindle) const BLUR: u16 = 6;
    /// Knob of the gear lever.
    pub(in crate::machines::turning_spindle) const KNOB: u16 = 7;
    /// The lens, and the chip in it.
    pub(in crate::machines::turning_spindle) const LENS: u16 = 8;
    pub(in crate::machines::turning_spindle) const LENS_CHIP: u16 = 9;
    /// The carriage, which goes along the bed, and the cross slide on it.
    pub(in crate::machines::turning_spindle) const CARRIAGE: u16 = 10;
    pub(in crate::machines::turning_spindle) const CROSS_SLIDE: u16 = 11;
    /// First of the chips.
    pub(in crate::machines::turning_spindle) const CHIPS: u16 = 12;
    /// The turning tool and the driven tool: one of them works.
    pub(in crate::machines::turning_spindle) const TURNING_TOOL: u16 = 20;
    pub(in crate::machines::turning_spindle) const DRIVEN_TOOL: u16 = 21;
    /// Insert and mill in the lens.
    pub(in crate::machines::turning_spindle) const LENS_INSERT: u16 = 22;
    pub(in crate::machines::turning_spindle) const LENS_MILL: u16 = 23;
}

/// Nodes that poses change.
pub(in super::super) mod node {
    pub(in crate::machines::turning_spindle) const PART: u16 = 0;
    pub(in crate::machines::turning_spindle) const MARKS: u16 = 1;
    pub(in crate::machines::turning_spindle) const SLOTS: u16 = 2;
    pub(in crate::machines::turning_spindle) const KEYS: u16 = 3;
    pub(in crate::machines::turning_spindle) const LEVER: u16 = 4;
    pub(in crate::machines::turning_spindle) const PILE: u16 = 5;
    pub(in crate::machines::turning_spindle) const LENS_PART: u16 = 6;
    pub(in crate::machines::turning_spindle) const LEADER: u16 = 7;
    pub(in crate::machines::turning_spindle) const TOOL_LEADER: u16 = 8;
    pub(in crate::machines::turning_spindle) const ORIENTATION: u16 = 9;
    pub(in crate::machines::turning_spindle) const SPEED: u16 = 10;
    pub(in crate::machines::turning_spindle) const SURFACE: u16 = 11;
    pub(in crate::machines::turning_spindle) const STAGE: u16 = 13;
    pub(in crate::machines::turning_spindle) const VOLTS: u16 = 14;
    pub(in crate::machines::turning_spindle) const BOUND: u16 = 16;
    pub(in crate::machines::turning_spindle) const LEFT: u16 = 17;
    pub(in crate::machines::turning_spindle) const X: u16 = 18;
    pub(in crate::machines::turning_spindle) const Z: u16 = 19;
    pub(in crate::machines::turning_spindle) const ANGLE: u16 = 20;
    /// Speed at 10 V of the gear stage.
    pub(in crate::machines::turning_spindle) const STAGE_SPEED: u16 = 22;
    /// The cut part of the keyway.
    pub(in crate::machines::turning_spindle) const GROOVE: u16 = 21;
    /// Edges of the driven tool's flutes.
    pub(in crate::machines::turning_spindle) const FLUTES: u16 = 23;
    /// The cut part of the keyway in the lens, the figures there: depth of cut, depth of the keyway, magnification.
    pub(in crate::machines::turning_spindle) const LENS_GROOVE: u16 = 24;
    pub(in crate::machines::turning_spindle) const LENS_DEPTH: u16 = 25;
    pub(in crate::machines::turning_spindle) const LENS_KEYWAY: u16 = 26;
    pub(in crate::machines::turning_spindle) const LENS_TIMES: u16 = 27;
    /// First paths of the sections of the part, and of the jaws.
    pub(in crate::machines::turning_spindle) const STRETCHES: u16 = 30;
    pub(in crate::machines::turning_spindle) const FAR: u16 = 50;
    pub(in crate::machines::turning_spindle) const NEAR: u16 = 70;
}

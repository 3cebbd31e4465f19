//! Numbers of the groups and nodes that poses change.

/// Groups that poses move.
pub(in super::super) mod group {
    /// Chuck and work; the origin is their axis.
    pub(in crate::machines::polygon_lathe) const WORK: u16 = 1;
    /// The cutter on its slide; the origin is its axis at the finished size.
    pub(in crate::machines::polygon_lathe) const DISC: u16 = 2;
    /// Its inserts, which also turn.
    pub(in crate::machines::polygon_lathe) const INSERTS: u16 = 3;
    /// The ring that replaces inserts at high speed.
    pub(in crate::machines::polygon_lathe) const BLUR: u16 = 4;
    /// The cutter from above; the origin is its place at the finished size.
    pub(in crate::machines::polygon_lathe) const SIDE: u16 = 5;
    /// The jaws of the chuck, and the ring that replaces them at high speed.
    pub(in crate::machines::polygon_lathe) const JAWS: u16 = 6;
    pub(in crate::machines::polygon_lathe) const JAWS_BLUR: u16 = 7;
    /// The edges of the polygon from above.
    pub(in crate::machines::polygon_lathe) const EDGES: u16 = 8;
    /// The figure at the distance of the axes, which keeps to its middle.
    pub(in crate::machines::polygon_lathe) const DISTANCE: u16 = 9;
    /// The section in the frame of the work.
    pub(in crate::machines::polygon_lathe) const CLOSE: u16 = 10;
    /// The lens.
    pub(in crate::machines::polygon_lathe) const LENS: u16 = 11;
    /// The window of the cutter, which a slide far from the work leaves.
    pub(in crate::machines::polygon_lathe) const WINDOW: u16 = 12;
    /// First of the tips in the frame of the work.
    pub(in crate::machines::polygon_lathe) const TIPS: u16 = 13;
    /// The traces of the inserts on the work.
    pub(in crate::machines::polygon_lathe) const TRACES: u16 = TIPS + super::TIPS;
    /// The ticks of the passes in the section, in the frame of the work.
    pub(in crate::machines::polygon_lathe) const PASSES: u16 = TRACES + 1;
    /// The ring at the contact of cutter and work, and its leader to the lens.
    pub(in crate::machines::polygon_lathe) const RING: u16 = PASSES + 1;
    /// The turning tool in the place of the cutter, and both from above: one of them works.
    pub(in crate::machines::polygon_lathe) const TURNING_TOOL: u16 = RING + 1;
    pub(in crate::machines::polygon_lathe) const SIDE_CUTTER: u16 = RING + 2;
    pub(in crate::machines::polygon_lathe) const SIDE_TURNING: u16 = RING + 3;
    /// Groups that each polygon has of its own, and the first group of the second polygon.
    const OWN: [u16; 7] = [DISC, INSERTS, BLUR, LENS, TRACES, PASSES, RING];
    const SECOND: u16 = SIDE_TURNING + 1;

    /// The group of a polygon, from 0, that is `first` for the first one.
    pub(in crate::machines::polygon_lathe) fn of(first: u16, polygon: usize) -> u16 {
        let own = OWN.iter().position(|own| *own == first).filter(|_| polygon > 0);
        own.map_or(first, |own| SECOND + (OWN.len() * (polygon - 1) + own) as u16)
    }
}

/// Tips that are shown to the work.
pub(in super::super) const TIPS: u16 = 12;

/// Nodes that poses change.
pub(in super::super) mod node {
    pub(in crate::machines::polygon_lathe) const SECTION: u16 = 0;
    pub(in crate::machines::polygon_lathe) const CLOSE: u16 = 1;
    pub(in crate::machines::polygon_lathe) const BAR: u16 = 2;
    pub(in crate::machines::polygon_lathe) const WORK_SPEED: u16 = 3;
    pub(in crate::machines::polygon_lathe) const TOOL_SPEED: u16 = 4;
    pub(in crate::machines::polygon_lathe) const SIZE: u16 = 5;
    pub(in crate::machines::polygon_lathe) const PASS: u16 = 6;
    pub(in crate::machines::polygon_lathe) const PHASE: u16 = 7;
    pub(in crate::machines::polygon_lathe) const STATE: u16 = 8;
    pub(in crate::machines::polygon_lathe) const APART: u16 = 9;
    pub(in crate::machines::polygon_lathe) const ALONG: u16 = 10;
    /// Leader of the cutter's label, line of the distance, edges of the polygon from above.
    pub(in crate::machines::polygon_lathe) const LEADER: u16 = 11;
    pub(in crate::machines::polygon_lathe) const DISTANCE: u16 = 12;
    pub(in crate::machines::polygon_lathe) const EDGES: u16 = 13;
    /// The wanted polygon, in the frame of the work.
    pub(in crate::machines::polygon_lathe) const IDEAL: u16 = 14;
    /// Form and flatness of the sides below the lens.
    pub(in crate::machines::polygon_lathe) const FORM: u16 = 15;
    pub(in crate::machines::polygon_lathe) const FLATNESS: u16 = 16;
    /// The scales of the lens.
    pub(in crate::machines::polygon_lathe) const SCALES: u16 = 19;
    /// Across flats, and the tip radius of the cutter.
    pub(in crate::machines::polygon_lathe) const ACROSS: u16 = 17;
    pub(in crate::machines::polygon_lathe) const RADIUS: u16 = 18;
}

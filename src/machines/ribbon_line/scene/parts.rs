//! Groups that poses move and nodes that poses change, by number.

/// Groups. Those without a pose only carry others.
pub(crate) mod group {
    /// Supply reel: at rest, its wound body (size), its wound face (turn, size), its hub (turn).
    pub(crate) const REEL: u16 = 1;
    pub(crate) const REEL_BODY: u16 = 2;
    pub(crate) const REEL_FACE: u16 = 3;
    pub(crate) const REEL_HUB: u16 = 4;
    /// Take-up reel: the same four.
    pub(crate) const TAKE_UP: u16 = 5;
    pub(crate) const TAKE_UP_BODY: u16 = 6;
    pub(crate) const TAKE_UP_FACE: u16 = 7;
    pub(crate) const TAKE_UP_HUB: u16 = 8;
    /// First of the groups of the unwinder, and of the pull rollers; see [`Station`].
    pub(crate) const UNWINDER: u16 = 10;
    pub(crate) const PULL: u16 = 20;
    /// Print roller: at rest, its back layers and its front (turn), the ring that replaces its heads at high speed.
    pub(crate) const PRINT_FRAME: u16 = 30;
    pub(crate) const PRINT_LAYERS: u16 = 31;
    pub(crate) const PRINT: u16 = 60;
    pub(crate) const PRINT_BLUR: u16 = 61;
    pub(crate) const PRINT_UNIT: u16 = 62;
    /// Deflection roller behind the print roller: at rest, and its marks.
    pub(crate) const DEFLECTOR: u16 = 63;
    pub(crate) const DEFLECTOR_MARKS: u16 = 64;
    /// Dots on the ribbon, and the streak that replaces them at high speed.
    pub(crate) const DOTS: u16 = 65;
    pub(crate) const DOTS_BLUR: u16 = 66;
    /// Pointer at the ruler of the loop.
    pub(crate) const POINTER: u16 = 67;
    /// Lens: at rest, the heads and the dots in it.
    pub(crate) const LENS: u16 = 68;
    pub(crate) const LENS_HEADS: u16 = 69;
    pub(crate) const LENS_DOTS: u16 = 70;
    /// Roller of the dancer in the loop.
    pub(crate) const DANCER: u16 = 71;

    /// Layers that give the heads of the print roller their width, the rearmost first.
    pub(crate) const LAYERS: u16 = 10;

    /// Groups of a station with a driven roller, a pinch roller, a motor and a cabinet, from the first group of the station on.
    #[derive(Debug, Clone, Copy)]
    pub(crate) enum Station {
        /// Plate behind the rollers.
        Plate,
        /// Cabinet below them.
        Cabinet,
        /// Driven roller at rest.
        Roller,
        /// Its holes and hub, which turn.
        Marks,
        /// The ring that replaces the holes at high speed.
        Blur,
        /// Pinch roller at rest.
        Pinch,
        /// Its marks, which turn.
        PinchMarks,
        /// Motor at rest.
        Motor,
        /// Its pulley, which turns.
        Pulley,
    }

    impl Station {
        /// The group of the station whose first group is `first`.
        pub(crate) fn of(self, first: u16) -> u16 {
            first + self as u16
        }
    }
}

/// Nodes whose path, text, dash or fill poses change.
pub(crate) mod node {
    /// Ribbon from reel to unwinder, in the loop, to the print roller, to the take-up reel: the band and its edge each.
    pub(crate) const SUPPLY: [u16; 2] = [1, 2];
    pub(crate) const LOOP: [u16; 2] = [3, 4];
    pub(crate) const TAKE_UP: [u16; 2] = [5, 6];
    /// Dots from the print roller to the take-up reel, and their streak.
    pub(crate) const DOTS: u16 = 7;
    pub(crate) const STREAK: u16 = 8;
    /// Dots and their smear in the lens.
    pub(crate) const LENS_DOTS: u16 = 9;
    pub(crate) const LENS_SMEAR: u16 = 10;
    /// Teeth of the belts.
    pub(crate) const BELTS: [u16; 2] = [11, 12];
    /// Lamps of the inverter and of the servo.
    pub(crate) const LAMPS: [u16; 2] = [13, 14];

    pub(crate) const UNWOUND: u16 = 20;
    pub(crate) const UNWINDER_SPEED: u16 = 21;
    pub(crate) const UNWINDER_VOLTS: u16 = 22;
    pub(crate) const SLACK: u16 = 23;
    pub(crate) const LOOP_STATE: u16 = 24;
    pub(crate) const PULL_FEED: u16 = 25;
    pub(crate) const PULL_POSITION: u16 = 26;
    pub(crate) const PRINT_SPEED: u16 = 27;
    pub(crate) const PRINT_HEAD: u16 = 28;
    pub(crate) const DOT_COUNT: u16 = 29;
}

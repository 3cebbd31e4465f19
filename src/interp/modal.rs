//! What stays in force from block to block: one code per modal group, feed, and the words that variables can show.

use super::canon::AXES;
use crate::controls::{Code, CodeDef, Control, Group};

/// How many modal groups there are.
const GROUPS: usize = Group::Other as usize + 1;

/// Modal state at pre-read. Lengths in command increments.
#[derive(Debug, Clone)]
pub(super) struct Modal {
    /// Rapid, linear, one of the arcs, or a motion that is not simulated.
    pub(super) motion: Code,
    /// A fixed cycle that is not simulated is on: axis words are holes, not ends of motions.
    pub(super) cycle: bool,
    /// The axes of the plane: first, second, and the third that is square to them.
    pub(super) plane: [u8; 3],
    /// Dimensions are absolute.
    pub(super) absolute: bool,
    /// Dimensions are in inches.
    pub(super) inch: bool,
    /// Feed is per spindle revolution.
    pub(super) per_revolution: bool,
    /// Exact stop mode.
    pub(super) exact: bool,
    /// Work coordinate system, 1 to 6. Their offsets are 0: a simulated machine has no work piece to be touched off.
    pub(super) coordinates: u8,
    /// Where work zero lies in the machine frame: set by G92.
    pub(super) origin: [i64; AXES],
    /// Where local zero lies in the work frame: set by G52.
    pub(super) local: [i64; AXES],
    /// Feed as programmed in mm/min or mm/rev; `None` before the first F.
    pub(super) feed: Option<f64>,
    /// The last value of each address letter that modal variables show, by letter from A.
    pub(super) words: [f64; 26],
    /// Ten times the number of the code in force, by group.
    pub(super) codes: [u16; GROUPS],
}

impl Modal {
    /// The state after power-on; `startup` are the codes in force.
    pub(super) fn new(control: &Control, startup: impl IntoIterator<Item = Code>) -> Modal {
        let mut modal = Modal {
            motion: Code::Linear,
            cycle: false,
            plane: [0, 1, 2],
            absolute: true,
            inch: false,
            per_revolution: false,
            exact: false,
            coordinates: 1,
            origin: [0; AXES],
            local: [0; AXES],
            feed: None,
            words: [f64::NAN; 26],
            codes: [0; GROUPS],
        };
        for code in startup {
            if let Some(row) = control.codes.iter().find(|row| row.code == code && row.letter == b'G') {
                modal.set(control, row);
            }
        }
        modal
    }

    /// Puts a code in force. Codes that act in their own block only change nothing.
    pub(super) fn set(&mut self, control: &Control, row: &CodeDef) {
        use Code::*;
        if row.group != Group::OneShot {
            self.codes[row.group as usize] = row.number;
        }
        let plane = |first: u8, second: u8, third: u8| {
            let axis = |letter| control.axis(letter).unwrap_or(0) as u8;
            [axis(first), axis(second), axis(third)]
        };
        match row.code {
            Rapid | Linear | ArcCw | ArcCcw => self.motion = row.code,
            NotSimulated if row.group == Group::Motion => self.motion = row.code,
            NotSimulated | Cancel if row.group == Group::Cycle => self.cycle = row.code == NotSimulated,
            PlaneXy => self.plane = plane(b'X', b'Y', b'Z'),
            PlaneZx => self.plane = plane(b'Z', b'X', b'Y'),
            PlaneYz => self.plane = plane(b'Y', b'Z', b'X'),
            Absolute => self.absolute = true,
            Incremental => self.absolute = false,
            Inch => self.inch = true,
            Metric => self.inch = false,
            // A feed per minute means nothing per revolution: F has to be given anew.
            FeedPerMinute | FeedPerRevolution => {
                let per_revolution = row.code == FeedPerRevolution;
                if per_revolution != self.per_revolution {
                    self.feed = None;
                }
                self.per_revolution = per_revolution;
            }
            _ if row.group == Group::PathMode => self.exact = row.code == ExactStop,
            WorkCoordinates(number) => self.coordinates = number,
            _ => {}
        }
    }

    /// Where the zero that dimensions count from lies in the machine frame.
    #[inline]
    pub(super) fn zero(&self, axis: usize) -> i64 {
        self.origin[axis].saturating_add(self.local[axis])
    }

    /// Remembers a word for the variables that show it.
    #[inline]
    pub(super) fn word(&mut self, letter: u8, value: f64) {
        if let Some(place) = self.words.get_mut(letter.wrapping_sub(b'A') as usize) {
            *place = value;
        }
    }
}

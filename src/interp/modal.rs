//! Modal state: one code per modal group, feed, work zeros, and the words shown by system variables.

use super::canon::AXES;
use crate::controls::Address;
use crate::controls::{Code, CodeDef, CodeId, Control, Group};

/// Number of modal groups.
const GROUPS: usize = Group::Other as usize + 1;

/// Work coordinate systems and their common shift.
const SYSTEMS: usize = 7;

/// Words of a transverse axis that count radii while its positions are diameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Radii {
    /// No words.
    No,
    /// Incremental words.
    Incremental,
    /// All words.
    All,
}

/// Commands to the second spindle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SecondSpindle {
    /// Commanded speed in r/min.
    pub(super) rpm: f64,
    pub(super) turns: bool,
}

/// Modal state of the spindle.
#[derive(Debug, Clone)]
pub(super) struct SpindleModal {
    /// Constant surface speed is on.
    pub(super) surface: bool,
    /// The last surface speed as programmed, in m/min; `None` before the first.
    pub(super) surface_speed: Option<f64>,
    /// A feed code has ended constant surface speed: the last S in r/min is in force again.
    pub(super) surface_undone: bool,
    /// The last S in r/min; `None` before the first.
    pub(super) last_speed: Option<f64>,
    /// The spindle addressed by S and M words without a number.
    pub(super) master: u8,
    pub(super) second: SecondSpindle,
}

/// Codes in force that are not simulated and whose axis words move nothing.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Unmoved {
    /// A fixed cycle: axis words are hole positions, not end points.
    pub(super) cycle: bool,
    /// Polar coordinates or the like: axis words are not axis positions.
    pub(super) replaced: bool,
    /// Input of data: blocks without a G or M code are data, not commands.
    pub(super) data: bool,
}

impl Unmoved {
    /// Whether any of these codes is in force.
    #[inline]
    pub(super) fn any(self) -> bool {
        self.cycle || self.replaced
    }
}

/// The limits of the working area.
#[derive(Debug, Clone, Default)]
pub(super) struct WorkingArea {
    /// Lower and upper limits in the machine frame; `None` until a program sets one.
    pub(super) limits: Option<[[i64; AXES]; 2]>,
    /// The limits are switched off.
    pub(super) off: bool,
}

/// Modal state at pre-read. Lengths in command increments.
#[derive(Debug, Clone)]
pub(super) struct Modal {
    /// Rapid, linear, one of the arcs, thread, or a motion that is not simulated.
    pub(super) motion: Code,
    /// Codes in force that are not simulated and whose axis words move nothing.
    pub(super) unmoved: Unmoved,
    /// The axes of the plane: first, second, and the third perpendicular to them.
    pub(super) plane: [u8; 3],
    /// Dimensions are absolute.
    pub(super) absolute: bool,
    /// Dimensions are in inches.
    pub(super) inch: bool,
    /// Feeds are in inches.
    pub(super) inch_feed: bool,
    /// Feed is per spindle revolution.
    pub(super) per_revolution: bool,
    /// Exact stop mode.
    pub(super) exact: bool,
    /// Work coordinate system, 1 to 6.
    coordinates: usize,
    /// Zeros of the work coordinate systems (index 0: their common shift), as set by system variables.
    offsets: [[i64; AXES]; SYSTEMS],
    /// Further common shift, as set by G50 or G92.
    origin: [i64; AXES],
    /// Local zero in the work frame, as set by G52.
    local: [i64; AXES],
    /// Program zero in the machine frame: sum of coordinate system, common shift, G50/G92 shift and local zero.
    pub(super) zero: [i64; AXES],
    /// Feed as programmed in mm/min or mm/rev; `None` before the first F.
    pub(super) feed: Option<f64>,
    /// Thread lead as programmed, in mm/rev; `None` before the first.
    pub(super) lead: Option<f64>,
    /// Words of the transverse axis that count radii.
    pub(super) radii: Radii,
    pub(super) spindle: SpindleModal,
    pub(super) area: WorkingArea,
    /// The last value of each address letter from A, for modal system variables.
    pub(super) words: [f64; 26],
    /// The code in force, by group.
    pub(super) codes: [CodeId; GROUPS],
}

impl Modal {
    /// The state after power-on, with the codes `startup` in force.
    pub(super) fn new(control: &Control, startup: impl IntoIterator<Item = CodeId>) -> Modal {
        let mut modal = Modal {
            motion: Code::Linear,
            unmoved: Unmoved::default(),
            plane: [0, 1, 2],
            absolute: true,
            inch: false,
            inch_feed: false,
            per_revolution: false,
            exact: false,
            coordinates: 1,
            offsets: [[0; AXES]; SYSTEMS],
            origin: [0; AXES],
            local: [0; AXES],
            zero: [0; AXES],
            feed: None,
            lead: None,
            radii: Radii::No,
            spindle: SpindleModal {
                surface: false,
                surface_speed: None,
                surface_undone: false,
                last_speed: None,
                master: 1,
                second: SecondSpindle::default(),
            },
            area: WorkingArea::default(),
            words: [f64::NAN; 26],
            codes: [CodeId::g(0); GROUPS],
        };
        for row in startup.into_iter().filter_map(|id| control.code(id)) {
            modal.set(control, row);
        }
        modal
    }

    /// Puts a code in force. One-shot codes change nothing.
    pub(super) fn set(&mut self, control: &Control, row: &CodeDef) {
        use Code::{
            Absolute, ArcCcw, ArcCw, ArcTangent, ArcThrough, Cancel, Diameters, DiametersAbsolute, ExactStop,
            FeedPerMinute, FeedPerRevolution, Inch, Incremental, Linear, Metric, NotSimulated, PlaneXy, PlaneYz,
            PlaneZx, Rapid, ReplacesPositions, SurfaceSpeed, SurfaceSpeedOff, Tapping, Thread, WorkCoordinates,
            WorkingArea,
        };
        if row.group != Group::OneShot {
            self.codes[row.group as usize] = row.id;
        }
        let plane = |first: Address, second: Address, third: Address| {
            let axis = |letter: Address| control.axis(letter).unwrap_or(0) as u8;
            [axis(first), axis(second), axis(third)]
        };
        match row.code {
            Rapid | Linear | ArcCw | ArcCcw | ArcThrough | ArcTangent | Thread => self.begin_motion(control, row.code),
            NotSimulated | Tapping if row.group == Group::Motion => self.begin_motion(control, row.code),
            NotSimulated | Cancel if row.group == Group::Cycle => self.unmoved.cycle = row.code == NotSimulated,
            _ if row.group == Group::Positions => self.unmoved.replaced = row.code == ReplacesPositions,
            WorkingArea(on) => self.area.off = !on,
            PlaneXy => self.plane = plane(Address::X, Address::Y, Address::Z),
            PlaneZx => self.plane = plane(Address::Z, Address::X, Address::Y),
            PlaneYz => self.plane = plane(Address::Y, Address::Z, Address::X),
            Absolute => self.absolute = true,
            Incremental => self.absolute = false,
            Inch | Metric => {
                self.inch = row.code == Inch;
                self.inch_feed = self.inch && control.limits.inch_feeds.is_none_or(|code| code == row.id);
            }
            FeedPerMinute | FeedPerRevolution => {
                self.count_feed(control, row.code == FeedPerRevolution);
                if control.spindle.feed_ends_surface && self.spindle.surface {
                    (self.spindle.surface, self.spindle.surface_undone) = (false, true);
                }
            }
            Diameters => self.radii = Radii::No,
            Code::Radii => self.radii = Radii::All,
            DiametersAbsolute => self.radii = Radii::Incremental,
            _ if row.group == Group::PathMode => self.exact = row.code == ExactStop,
            SurfaceSpeed | SurfaceSpeedOff => {
                (self.spindle.surface, self.spindle.surface_undone) = (row.code == SurfaceSpeed, false);
                if control.spindle.surface_per_revolution {
                    self.count_feed(control, true);
                }
            }
            WorkCoordinates(number) => {
                self.coordinates = usize::from(number);
                self.place_zero();
            }
            _ => {}
        }
    }

    /// Puts a motion in force. It ends a fixed cycle as its cancel code does (GSK 980TDi manual, 3.23.9, note 1; the same in RS274/NGC).
    fn begin_motion(&mut self, control: &Control, motion: Code) {
        self.motion = motion;
        if self.unmoved.cycle {
            self.unmoved.cycle = false;
            let cancel = control.codes.iter().find(|row| row.group == Group::Cycle && row.code == Code::Cancel);
            if let Some(row) = cancel {
                self.codes[Group::Cycle as usize] = row.id;
            }
        }
    }

    /// Sets the unit of F. On most controls a change of unit cancels the feed.
    fn count_feed(&mut self, control: &Control, per_revolution: bool) {
        if per_revolution != self.per_revolution && !control.limits.feed_kept {
            self.feed = None;
        }
        self.per_revolution = per_revolution;
    }

    /// G25 and G26: a limit of the working area of an axis in the machine frame.
    pub(super) fn limit_area(&mut self, upper: bool, axis: usize, at: i64) {
        let area = self.area.limits.get_or_insert([[i64::MIN; AXES], [i64::MAX; AXES]]);
        area[usize::from(upper)][axis] = at;
    }

    fn place_zero(&mut self) {
        let none = [0; AXES];
        let offsets = [0, self.coordinates].map(|system| self.offsets.get(system).unwrap_or(&none));
        self.zero = core::array::from_fn(|k| {
            let parts = [offsets[1][k], self.origin[k], self.local[k]];
            parts.into_iter().fold(offsets[0][k], i64::saturating_add)
        });
    }

    /// Local zero of an axis in the work frame.
    pub(super) fn local(&self, axis: usize) -> i64 {
        self.local[axis]
    }

    /// G52: local zero of an axis in the work frame.
    pub(super) fn set_local(&mut self, axis: usize, local: i64) {
        self.local[axis] = local;
        self.place_zero();
    }

    /// G50 or G92: sets the zero of an axis in the machine frame, for all work coordinate systems, and resets the local zero.
    pub(super) fn set_zero(&mut self, axis: usize, zero: i64) {
        self.local[axis] = 0;
        self.place_zero();
        self.origin[axis] = self.origin[axis].saturating_add(zero.saturating_sub(self.zero[axis]));
        self.place_zero();
    }

    /// Zero of a work coordinate system, or the common shift (0).
    pub(super) fn offset(&self, system: u8, axis: usize) -> i64 {
        self.offsets.get(usize::from(system)).and_then(|offsets| offsets.get(axis)).copied().unwrap_or(0)
    }

    /// Sets a zero that [`offset`](Modal::offset) reads.
    pub(super) fn set_offset(&mut self, system: u8, axis: usize, offset: i64) {
        if let Some(place) = self.offsets.get_mut(usize::from(system)).and_then(|offsets| offsets.get_mut(axis)) {
            *place = offset;
            self.place_zero();
        }
    }

    /// Keeps work zeros and working area limits at a reset; G52 is cancelled.
    pub(super) fn keep_zeros(&mut self, before: &Modal) {
        (self.offsets, self.origin, self.area.limits) = (before.offsets, before.origin, before.area.limits);
        self.place_zero();
    }

    /// The last word with a letter; vacant before the first.
    pub(super) fn shown(&self, letter: Address) -> f64 {
        self.words.get(letter as usize).copied().unwrap_or(f64::NAN)
    }

    /// Stores the last word with a letter, for system variables.
    #[inline]
    pub(super) fn set_shown(&mut self, letter: Address, value: f64) {
        if let Some(place) = self.words.get_mut(letter as usize) {
            *place = value;
        }
    }
}

//! [`Timeline`]: the machine at any time of a run, without running it again.

use core::cell::Cell;
use std::rc::Rc;

use super::path::{Circle, Path, Segment};
use super::plant::{AxisPlant, PMC_AXES, SpindlePlant};
use super::snapshot::{Mode, Snapshot};
use super::spindle::InverterRamp;
use super::time_series::{TimeSeries, Timed};
use crate::interp::canon::AXES;
use crate::text::Place;

/// Mode of the control and executing block from `t` on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Activity {
    pub(super) t: f64,
    pub(super) place: Place,
    pub(super) mode: Mode,
    /// Whether a block has begun since the start of the run.
    pub(super) begun: bool,
    /// Whether an execution of the block begins here; not so where its next step begins, or the mode changes.
    pub(super) is_start: bool,
}

/// A common variable has this value from `t` on; NaN is vacant.
#[derive(Debug, Clone, Copy)]
pub(super) struct VariableChange {
    pub(super) t: f64,
    pub(super) value: f64,
    pub(super) number: u32,
}

/// The screen of the control shows this message from `t` on.
#[derive(Debug, Clone)]
pub(super) struct MessageChange {
    pub(super) t: f64,
    /// The text; empty for none.
    pub(super) text: Rc<str>,
    /// Whether the next cycle start clears the message.
    pub(super) until_start: bool,
}

impl Timed for MessageChange {
    fn t(&self) -> f64 {
        self.t
    }
}

impl Timed for Activity {
    fn t(&self) -> f64 {
        self.t
    }
}

impl Timed for VariableChange {
    fn t(&self) -> f64 {
        self.t
    }
}

/// A visit of two axes to a region: its time (s) and its extreme positions (mm).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Visit {
    /// Time (s) from which both axes are in the region.
    pub begin: f64,
    /// Time (s) at which one axis left it, or the end of the search.
    pub end: f64,
    /// Least position of the first axis.
    pub across: f64,
    /// Least and greatest position of the second axis.
    pub along: (f64, f64),
}

/// Lengths of the series at a checkpoint.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct TimelineLengths {
    segments: usize,
    circles: usize,
    pmc: usize,
    ramps: usize,
    marks: usize,
    messages: usize,
    pub(super) changes: usize,
}

/// A run over time. A block of straight cutting feed uses [`Timeline::BLOCK_BYTES`] of memory.
#[derive(Debug, Clone)]
pub struct Timeline {
    pub(super) axes: [AxisPlant; AXES],
    pub(super) pmc_axes: [AxisPlant; PMC_AXES],
    pub(super) spindle: SpindlePlant,
    pub(super) path: Path,
    /// Commanded angles of the PMC axes, °.
    pub(super) pmc: Path,
    pub(super) ramps: TimeSeries<InverterRamp>,
    pub(super) marks: TimeSeries<Activity>,
    messages: TimeSeries<MessageChange>,
    pub(super) changes: TimeSeries<VariableChange>,
    pub(super) start: f64,
    pub(super) end: f64,
    counted: [Cell<Counted>; 2],
}

/// Cache: number of starts of the block at `place` in the first `marks` marks, so that repeated queries count only new marks.
#[derive(Debug, Clone, Copy, Default)]
struct Counted {
    place: Place,
    marks: usize,
    times: u32,
}

/// Whether the blocks chosen by `chosen` begin with this mark. A block may have several marks, for instance a wait and its motion.
fn is_first_mark(marks: &[Activity], at: usize, chosen: impl Fn(&Activity) -> bool) -> bool {
    let there = |mark: &Activity| mark.begun && chosen(mark);
    there(&marks[at]) && (at == 0 || !there(&marks[at - 1]))
}

impl Timeline {
    /// Bytes of memory per block with motion.
    pub const BLOCK_BYTES: usize = size_of::<Segment>() + size_of::<Activity>();

    pub(super) fn new(axes: [AxisPlant; AXES], pmc_axes: [AxisPlant; PMC_AXES], spindle: SpindlePlant) -> Timeline {
        Timeline {
            axes,
            pmc_axes,
            spindle,
            path: Path::default(),
            pmc: Path::default(),
            ramps: TimeSeries::default(),
            marks: TimeSeries::default(),
            messages: TimeSeries::default(),
            changes: TimeSeries::default(),
            start: 0.0,
            end: 0.0,
            counted: Default::default(),
        }
    }

    /// The machine at time `t`; after [`end`](Timeline::end), continued without further events.
    pub fn at(&self, t: f64) -> Snapshot {
        let t = if t > self.start { t } else { self.start };
        let mut now = Snapshot { t, ..Snapshot::default() };
        for (k, (axis, plant)) in now.axes.iter_mut().zip(&self.axes).enumerate() {
            *axis = self.path.axis(k, plant, t);
        }
        for (k, (axis, plant)) in now.pmc.iter_mut().zip(&self.pmc_axes).enumerate() {
            *axis = self.pmc.axis(k, plant, t);
        }
        if let Some(ramp) = self.ramps.at(t) {
            now.spindle = ramp.state(&self.spindle, t, |axis| now.axes.get(axis).map_or(0.0, |axis| axis.position));
        }
        if let Some(mark) = self.marks.at(t) {
            now.mode = mark.mode;
            now.block = mark.begun.then_some(mark.place);
        }
        now
    }

    /// Actual position (mm or °) of an axis at time `t`, by its index.
    pub fn actual(&self, axis: usize, t: f64) -> f64 {
        self.axes.get(axis).map_or(0.0, |plant| self.path.actual(axis, plant, t))
    }

    /// Turns of the spindle's motor at time `t` since the start of the run, signed.
    pub fn turns(&self, t: f64) -> f64 {
        self.ramps.at(t).map_or(0.0, |ramp| ramp.turns(&self.spindle, t))
    }

    /// Commanded positions at time `t` in the unit of words: diameters on a diameter axis.
    pub fn words_at(&self, t: f64) -> [f64; AXES] {
        let now = self.at(t).axes;
        core::array::from_fn(|k| now[k].position * self.axes[k].words_per_unit())
    }

    /// The message of the program on the control's screen at time `t`.
    pub fn message_at(&self, t: f64) -> Option<&str> {
        self.messages.at(t).map(|message| &*message.text).filter(|text| !text.is_empty())
    }

    /// Shows a message from `t` on, until another one.
    pub(super) fn show_message(&mut self, t: f64, text: &str) {
        self.change_message(t, text, false);
    }

    /// Shows a message from `t` on, until another one or cycle start.
    pub(super) fn show_message_until_start(&mut self, t: f64, text: &str) {
        self.change_message(t, text, true);
    }

    /// Clears the message at `t`.
    pub(super) fn clear_message(&mut self, t: f64) {
        self.change_message(t, "", false);
    }

    /// Repeating the shown message adds no entry.
    fn change_message(&mut self, t: f64, text: &str, until_start: bool) {
        if self.messages.last().map_or("", |last| &*last.text) != text {
            self.messages.set_from(MessageChange { t, text: text.into(), until_start });
        }
    }

    /// Clears a message that waits for cycle start.
    pub(super) fn started(&mut self, t: f64) {
        if self.messages.last().is_some_and(|last| last.until_start) {
            self.clear_message(t);
        }
    }

    /// The executing block at time `t`.
    pub fn block_at(&self, t: f64) -> Option<Place> {
        self.marks.at(t).and_then(|mark| mark.begun.then_some(mark.place))
    }

    /// Number of starts of the block at `place` until time `t`.
    pub fn times(&self, place: Place, t: f64) -> u32 {
        let marks = self.marks.until(t);
        let is_first = |at: usize| is_first_mark(marks, at, |mark| mark.place == place);
        let [kept, other] = &self.counted;
        let known = |cell: &Cell<Counted>| cell.get().place == place && cell.get().marks <= marks.len();
        if !known(kept) {
            kept.swap(other);
        }
        let from = if known(kept) { kept.get() } else { Counted { place, ..Counted::default() } };
        let count = |from: usize, to: usize| (from..to).filter(|&at| is_first(at)).count() as u32;
        // The newest mark may still be replaced.
        let sure = marks.len().saturating_sub(1).max(from.marks);
        let times = from.times + count(from.marks, sure);
        kept.set(Counted { place, marks: sure, times });
        times + count(sure, marks.len())
    }

    /// Times (s) at which a block within a place begins after another block, in the planned part.
    pub fn begins(&self, place: Place) -> impl Iterator<Item = f64> {
        let marks = self.marks.until(f64::INFINITY);
        let span = place.span.start..place.span.end;
        let within = move |mark: &Activity| mark.place.file == place.file && span.contains(&mark.place.span.start);
        (0..marks.len()).filter(move |&at| is_first_mark(marks, at, &within)).map(move |at| marks[at].t)
    }

    /// Times (s) at which executions of a block within a place begin, in the planned part; also those that follow one another directly.
    /// Executions without duration have none.
    pub fn starts(&self, place: Place) -> impl Iterator<Item = f64> {
        let span = place.span.start..place.span.end;
        let there = move |mark: &&Activity| {
            mark.is_start && mark.place.file == place.file && span.contains(&mark.place.span.start)
        };
        self.marks.until(f64::INFINITY).iter().filter(there).map(|mark| mark.t)
    }

    /// Visits of two axes, by their commands, to the region where both are below their limits, up to `t`. Deviations of arcs are ignored.
    pub fn visits(&self, [across, along]: [(usize, f64); 2], t: f64) -> Vec<Visit> {
        let segments = self.path.segments.until(t);
        let (mut visits, mut within): (Vec<Visit>, bool) = (Vec::new(), false);
        for (at, segment) in segments.iter().enumerate() {
            let ends_at = segments.get(at + 1).map_or(t, |next| next.t);
            let until = ends_at - segment.t;
            let line = |axis: usize| (segment.from[axis], segment.velocity[axis]);
            // The part of the segment in which both axes are below their limits.
            let (mut from, mut to) = (0.0_f64, until);
            for (axis, limit) in [across, along] {
                let (place, rate) = line(axis);
                if rate == 0.0 {
                    to = if place < limit { to } else { -1.0 };
                } else if rate < 0.0 {
                    from = from.max((limit - place) / rate);
                } else {
                    to = to.min((limit - place) / rate);
                }
            }
            // Touching the limit does not count.
            if to - from <= 0.0 {
                within = within && until <= 0.0;
                continue;
            }
            let [least, ends] = [across.0, along.0].map(|axis| {
                let (place, rate) = line(axis);
                let (one, other) = (place + rate * from, place + rate * to);
                (one.min(other), one.max(other))
            });
            // The end of a segment itself, free of rounding: a visit that goes on ends at `t`.
            let end = if to >= until { ends_at } else { segment.t + to };
            match visits.last_mut().filter(|_| within && from <= 0.0) {
                Some(last) => {
                    last.end = end;
                    last.across = last.across.min(least.0);
                    last.along = (last.along.0.min(ends.0), last.along.1.max(ends.1));
                }
                None => {
                    visits.push(Visit { begin: segment.t + from, end, across: least.0, along: ends });
                }
            }
            within = to >= until;
        }
        visits
    }

    /// Marks after `t`.
    fn later(&self, t: f64) -> &[Activity] {
        let marks = self.marks.until(f64::INFINITY);
        &marks[marks.partition_point(|mark| mark.t <= t)..]
    }

    /// Start (s) of the first execution of a block that begins after `t`, also of the same block once more; `None` if none is planned.
    pub fn next_block(&self, t: f64) -> Option<f64> {
        let here = self.block_at(t);
        let begins = |mark: &&Activity| mark.begun && (mark.is_start || Some(mark.place) != here);
        self.later(t).iter().find(begins).map(|mark| mark.t)
    }

    /// Start (s) of the first other block that begins after `t`; `None` if none is planned.
    pub fn next_other_block(&self, t: f64) -> Option<f64> {
        let here = self.block_at(t);
        self.later(t).iter().find(|mark| mark.begun && Some(mark.place) != here).map(|mark| mark.t)
    }

    /// Start (s) of the execution of a block at `t`, or of the preceding one if it starts at `t`; 0 before the first.
    pub fn block_before(&self, t: f64) -> f64 {
        let marks = self.marks.until(t);
        let earlier = &marks[..marks.partition_point(|mark| mark.t < t)];
        let Some(last) = earlier.last() else { return 0.0 };
        // An execution may have several marks, for instance a wait and its motion.
        let mut first = last.t;
        for mark in earlier.iter().rev().take_while(|mark| mark.begun && mark.place == last.place) {
            first = mark.t;
            if mark.is_start {
                break;
            }
        }
        first
    }

    /// Earliest time (s) kept: 0 unless old parts are dropped.
    pub fn start(&self) -> f64 {
        self.start
    }

    /// End (s) of the planned part.
    pub fn end(&self) -> f64 {
        self.end
    }

    #[inline(always)]
    pub(super) fn put_segment(&mut self, mut segment: Segment, circle: Option<Circle>) {
        if let Some(circle) = circle {
            self.path.circles.append(circle);
            segment.circle = self.path.circles.len() as u32;
        }
        self.path.segments.set_from(segment);
    }

    pub(super) fn lengths(&self) -> TimelineLengths {
        TimelineLengths {
            segments: self.path.segments.len(),
            circles: self.path.circles.len(),
            pmc: self.pmc.segments.len(),
            ramps: self.ramps.len(),
            marks: self.marks.len(),
            messages: self.messages.len(),
            changes: self.changes.len(),
        }
    }

    pub(super) fn truncate(&mut self, lengths: &TimelineLengths) {
        self.path.segments.truncate(lengths.segments);
        self.path.circles.truncate(lengths.circles);
        self.pmc.segments.truncate(lengths.pmc);
        self.ramps.truncate(lengths.ramps);
        self.marks.truncate(lengths.marks);
        self.messages.truncate(lengths.messages);
        self.counted = Default::default();
        self.changes.truncate(lengths.changes);
    }

    /// Time (s) for which a movement acts after its end.
    fn memory(&self) -> f64 {
        self.axes.iter().chain(&self.pmc_axes).map(Path::memory).fold(0.0, f64::max)
    }

    /// Copy for a second run: the entries that still act at `t`, up to a checkpoint.
    pub(super) fn up_to(&self, lengths: &TimelineLengths, t: f64) -> Timeline {
        let old = t - self.memory();
        Timeline {
            axes: self.axes,
            pmc_axes: self.pmc_axes,
            spindle: self.spindle,
            path: Path {
                segments: self.path.segments.part(old, lengths.segments),
                circles: self.path.circles.part(old, lengths.circles),
            },
            pmc: Path { segments: self.pmc.segments.part(old, lengths.pmc), ..Path::default() },
            ramps: self.ramps.part(t, lengths.ramps),
            marks: self.marks.part(t, lengths.marks),
            messages: self.messages.part(t, lengths.messages),
            changes: TimeSeries::default(),
            start: t,
            end: t,
            counted: Default::default(),
        }
    }

    /// Drops entries that no longer act at `t`.
    pub(super) fn forget(&mut self, t: f64) {
        let memory = self.memory();
        self.path.segments.forget(t - memory);
        self.path.circles.forget(t - memory);
        self.pmc.segments.forget(t - memory);
        self.ramps.forget(t);
        self.marks.forget(t);
        self.messages.forget(t);
        self.counted = Default::default();
        self.changes.forget(t);
        self.start = t;
    }
}

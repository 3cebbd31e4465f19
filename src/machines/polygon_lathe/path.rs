//! Path of the cutter through its passes as a list of motions, the source of both programs and times.
//!
//! No rapid is inside the stock. A polygon at the end of the bar is cut from in front of the face. For a polygon further along the bar the
//! insert goes down into the stock at feed, from its clearance over the stock, where all of it is beyond the near end of the polygon; from
//! the far end it comes out at feed.

use super::params::Params;
use crate::math;

/// Target of a motion of the slide, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum SlideTarget {
    /// To a distance across flats, or a diameter.
    Across(f64),
    /// To a place along the work; the face is at 0.
    Along(f64),
}

/// A motion or dwell of a pass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum PassStep {
    /// One axis at rapid traverse.
    Rapid(SlideTarget),
    /// One axis at a feed in mm/min.
    Feed(SlideTarget, f64),
    /// Both axes at once, straight: to a diameter and a place along the work (mm), at a feed in mm/min.
    Slope { across: f64, along: f64, feed: f64 },
    /// Thread of a pitch (mm) to a place along the work.
    Thread { along: f64, pitch: f64 },
    /// The slide waits, s.
    Dwell(f64),
}

impl PassStep {
    /// Diameter and place along the work (mm) at the end of the step, from those at its start.
    fn target(self, (across, along): (f64, f64)) -> (f64, f64) {
        match self {
            PassStep::Rapid(SlideTarget::Across(to)) | PassStep::Feed(SlideTarget::Across(to), _) => (to, along),
            PassStep::Rapid(SlideTarget::Along(to)) | PassStep::Feed(SlideTarget::Along(to), _) => (across, to),
            PassStep::Thread { along: to, .. } => (across, to),
            PassStep::Slope { across, along, .. } => (across, along),
            PassStep::Dwell(_) => (across, along),
        }
    }
}

/// Maximum dwell, s; also the dwell if the work does not turn.
const MAX_DWELL: f64 = 9_999.0;

impl Params {
    /// Diameter at which the cutter is clear of the stock, mm: also an insert that stands out of the tip circle.
    pub(super) fn clear_diameter(&self) -> f64 {
        let standing_out = self.insert_radius_errors().into_iter().fold(0.0, f64::max);
        self.stock_diameter + 2.0 * (self.clearance + standing_out)
    }

    /// Whether the tools have their clearance at the start point, and in front of the jaws after a last cut at the
    /// distance `far` (mm) from the face.
    pub(super) fn has_room(&self, far: f64) -> bool {
        let far = self.turned_ends.iter().filter(|end| end.on).map(|end| end.length).fold(far, f64::max);
        let jaws = self.free_length == 0.0 || far + self.clearance <= self.free_length;
        jaws && self.start_x >= self.clear_diameter() && self.start_z >= self.clearance
    }

    /// Z position (mm) at which a pass goes to its depth: in front of the face, or, for a polygon behind the face, one
    /// width of the insert beyond the near end.
    pub(super) fn approach(&self) -> f64 {
        if self.is_behind_face() { -self.from_face - self.insert_width } else { self.clearance }
    }

    /// Feed out of the stock, mm/min: that of the form, at most the clamp of X.
    pub(super) fn clamped_retract_feed(&self) -> f64 {
        self.retract_feed.min(self.slides.x.clamp)
    }

    /// Time in which every insert passes every side, s: `60 D / n_work`, with the ratio in lowest terms, rounded up to
    /// the resolution of a word.
    fn pattern_time(&self) -> f64 {
        let turns = self.ratio().map_or(1.0, |ratio| f64::from(ratio.work()));
        ((60_000.0 * turns / self.work_speed().abs()).ceil() / 1000.0).min(MAX_DWELL)
    }

    /// The steps of a pass, from 1. The last pass dwells at each end of the polygon that lies in the stock, until every
    /// insert has passed it.
    pub(super) fn steps(&self, pass: f64) -> Vec<PassStep> {
        let feed = self.per_minute(self.feed_of(pass));
        let (size, clear) = (SlideTarget::Across(self.size(pass)), SlideTarget::Across(self.clear_diameter()));
        let (begin, end) = (SlideTarget::Along(self.approach()), SlideTarget::Along(-self.far_end()));
        let wait = (pass >= self.passes()).then_some(PassStep::Dwell(self.pattern_time()));
        let out = PassStep::Feed(clear, self.clamped_retract_feed());
        let (along, beside) = ([PassStep::Feed(end, feed)], begin != end);
        if !self.is_behind_face() {
            let steps = [PassStep::Rapid(size)].into_iter().chain(along).chain(wait);
            return steps.chain([out, PassStep::Rapid(begin)]).collect();
        }
        let down = [PassStep::Rapid(begin), PassStep::Feed(size, self.per_minute(self.infeed))];
        // A polygon no longer than the insert is wide is cut by the infeed alone.
        let along = along.into_iter().chain(wait).filter(|_| beside);
        down.into_iter().chain(wait).chain(along).chain([out]).collect()
    }

    /// Time of all passes without rapid traverse, s.
    pub(super) fn cutting_time(&self) -> f64 {
        let begin = (self.clear_diameter(), self.clearance);
        time(begin, self.all_steps(), 0.0, NO_RAPIDS)
    }

    /// The steps of all passes.
    pub(super) fn all_steps(&self) -> impl Iterator<Item = PassStep> {
        (1..=self.passes() as u32).flat_map(|pass| self.steps(f64::from(pass)))
    }
}

/// Number of starts from standstill of the axis with more starts, over steps from `from` (diameter and position along
/// the work, mm): a motion starts an axis unless it continues in the direction of the previous step.
pub(super) fn starts(mut from: (f64, f64), steps: &[PassStep]) -> f64 {
    let (mut moving, mut count) = ([0.0_f64; 2], [0.0_f64; 2]);
    for step in steps {
        let to = step.target(from);
        let travels = [to.0 - from.0, to.1 - from.1];
        for ((travel, moving), count) in travels.into_iter().zip(&mut moving).zip(&mut count) {
            if travel * *moving <= 0.0 && travel != 0.0 {
                *count += 1.0;
            }
            *moving = travel;
        }
        from = to;
    }
    count[0].max(count[1])
}

/// Rapid traverse that takes no time.
pub(super) const NO_RAPIDS: [f64; 2] = [f64::INFINITY; 2];

/// Time (s) of steps from `from` (diameter and position along the work, mm): the sum of `60 s / F` with the distance s
/// of each step. `rpm`: spindle speed in threads, r/min; `rapids`: rapid traverse across and along the work, mm/min.
pub(super) fn time(mut from: (f64, f64), steps: impl Iterator<Item = PassStep>, rpm: f64, rapids: [f64; 2]) -> f64 {
    let mut total = 0.0;
    for step in steps {
        let to = step.target(from);
        let distance = math::hypot(0.5 * (to.0 - from.0), to.1 - from.1);
        total += match step {
            PassStep::Rapid(SlideTarget::Across(_)) => 60.0 * distance / rapids[0],
            PassStep::Rapid(SlideTarget::Along(_)) => 60.0 * distance / rapids[1],
            PassStep::Feed(_, feed) | PassStep::Slope { feed, .. } => 60.0 * distance / feed,
            PassStep::Thread { pitch, .. } => 60.0 * distance / (pitch * rpm),
            PassStep::Dwell(seconds) => seconds,
        };
        from = to;
    }
    total
}

//! Times of a block, a pass of the running loop and a product.

use super::feeds::LineFeeds;
use super::passes::{exact_stop, kept, pass};
use super::start::{first_wait, still_to_ramp};
use super::unwinder::UnwinderSpeed;
use crate::machines::ribbon_line::params::{Params, PathMode};

/// Times of the line. s unless noted otherwise.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::ribbon_line) struct LineTiming {
    /// A pitch at the programmed speed.
    pub pitch: f64,
    /// A block at the programmed speed.
    pub block: f64,
    /// From one block to the next.
    pub pass: f64,
    /// Time that the control needs for a pass.
    pub needed: f64,
    /// The same while the knob is turned; infinite if the control never completes a pass.
    pub needed_turned: f64,
    /// Time in which the blocks already read run on with the old override.
    pub override_delay: f64,
    /// Mean speed of X as a share (0 to 1) of its driven speed, at running and at rated load; exact stops and starved blocks take the rest.
    pub kept: f64,
    pub kept_rated: f64,
    /// A block with exact stop, also computed for a line without exact stops.
    pub exact_stop: f64,
    /// Speed (%) that X keeps with exact stops.
    pub exact_stop_speed: f64,
    pub stops_per_minute: f64,
    pub dots_per_second: f64,
    /// Time that a product loses in exact stops and between starved blocks.
    pub lost: f64,
    pub product: f64,
}

impl LineTiming {
    pub(super) fn new(p: &Params, unwinder: &UnwinderSpeed, feeds: &LineFeeds) -> LineTiming {
        let (pitches, count, y_stroke) = (p.block_pitches(), p.count(), feeds.y_stroke);
        let programmed = p.pitch / feeds.line_speed * 60.0;
        let driven = |error: f64| programmed / p.followed(error);
        let pitch_time = driven(unwinder.error);
        let wait = first_wait(p, pitch_time.is_finite());
        let exact_stop = exact_stop(p, pitches, pitch_time, y_stroke);
        let (needed, whole) = (p.pass_needed(), (count / pitches).floor());
        let rest = count - whole * pitches;
        let pass = |pitches: f64| pass(p, pitches, pitch_time, y_stroke);
        // Blocks already read when X starts: the first pull, and those read in the rest of the wait, one in each time
        // that a pass needs.
        let ahead = (1.0 + ((wait - p.first_reading()).max(0.0) / needed).floor()).min(p.preread);
        let passes = match p.path_mode {
            PathMode::ExactStop => whole * pass(pitches) + if rest > 0.0 { pass(rest) } else { 0.0 },
            PathMode::Continuous => {
                ((count / pitches).ceil() - ahead).max(0.0) * needed + pitches.min(count) * pitch_time
            }
        };
        let passes = passes.max(count * pitch_time);
        let last = if p.last_pitch() > 0.0 { p.last_pitch() / p.pitch * pitch_time } else { 0.0 };
        // An exact stop has the ramp at its end; else the last block alone.
        let end = if p.path_mode == PathMode::ExactStop { 0.0 } else { p.slowest() };
        LineTiming {
            pitch: programmed,
            block: pitches * programmed,
            pass: pass(pitches),
            needed,
            needed_turned: needed / p.share_while_turned(),
            override_delay: pass(pitches) * p.preread,
            kept: kept(p, pitch_time, y_stroke),
            kept_rated: kept(p, driven(unwinder.error_rated), y_stroke),
            exact_stop,
            exact_stop_speed: 100.0 * if pitch_time.is_finite() { pitches * pitch_time / exact_stop } else { 0.0 },
            stops_per_minute: 60.0 / exact_stop,
            dots_per_second: pitches / pass(pitches),
            lost: passes - count * pitch_time,
            product: wait + still_to_ramp(p, wait) + passes + last + end,
        }
    }
}

impl Params {
    /// The greater time constant of both axes, s.
    pub(in crate::machines::ribbon_line) fn slowest(&self) -> f64 {
        self.axes.pull.time_constant.max(self.axes.print.time_constant) / 1000.0
    }
}

//! Start and speed of movements: clamps, overrides, hold, and feeds that follow the spindle.

use super::exec::{Exec, MEASURE};
use super::moves::{ActiveMove, Pace};
use super::once::Once;
use super::plc::percent;
use super::program::RunningProgram;
use super::sim::Sim;
use crate::controls::Address;
use crate::drives::Rotation;
use crate::interp::Feed;
use crate::msg;
use crate::text::{Diagnostic, DiagnosticKind};

impl<P: RunningProgram> Sim<'_, P> {
    /// Begins a cut, or waits for the spindle speed on controls that do so.
    pub(super) fn cut(&mut self, t: f64, motion: &ActiveMove) {
        let turning = &self.state.spindle;
        if turning.orienting.is_some() && motion.length > 0.0 {
            let (locked, driven) = (turning.locked, turning.driven_tool_turns || self.plant.spindle.driven_tool);
            if !locked {
                self.warn(Once::NotLocked, || msg!("motion.not-locked"));
            }
            if !driven {
                self.warn(Once::NoDrivenTool, || msg!("motion.no-driven-tool"));
            }
        }
        if self.feeds_without_rotation(motion) {
            self.warn(Once::FeedWithoutRotation, || msg!("motion.feed-without-rotation"));
        }
        if self.plant.spindle.rules.reached.is_some() {
            self.aim_at_cut(t);
            if self.speed_time() > t {
                self.state.path.flow_end = None;
                self.state.exec = Exec::Spinning(Box::new(*motion));
                return;
            }
        }
        self.begin(t, motion);
    }

    /// Whether a movement ends deeper in the work than it began without rotation: the spindle is off, or at speed 0 under a feed per minute, the
    /// PMC axes are at rest, and the spindle is not positioned for a driven tool.
    fn feeds_without_rotation(&self, motion: &ActiveMove) -> bool {
        let turning = &self.state.spindle;
        let per_minute = matches!(motion.pace, Pace::Feed(Feed::PerMinute(_)));
        let turns = turning.rotation != Rotation::Stopped
            && !(per_minute && self.state.plc.signals.spindle_command == 0.0)
            || turning.orienting.is_some()
            || self.state.plc.orders.pmc_speed.iter().any(|rpm| *rpm != 0.0);
        let travel = |letter| self.plant.travel_of(letter, &motion.start, &motion.end);
        let (x, z) = (travel(Address::X), travel(Address::Z));
        !turns && x.1.abs() < self.plant.stock && z.1 < 0.0 && (x.1.abs() < x.0.abs() || z.1 < z.0)
    }

    pub(super) fn begin(&mut self, t: f64, motion: &ActiveMove) {
        if motion.length <= 0.0 {
            self.state.path.position = motion.end;
            return;
        }
        if self.state.path.flow_end.take().is_some_and(|end| t > end) {
            self.state.starved += 1;
            let (block_time, macro_time) = (self.plant.block_time * 1e3, self.plant.macro_time * 1e3);
            self.warn_kind(Once::Starved, DiagnosticKind::Starved, || msg!("motion.starved", block_time, macro_time));
        }
        if let Pace::Feed(Feed::PerMinute(feed)) = motion.pace {
            self.warn_axis_clamp(motion.limit, motion.limiting, feed);
        }
        if self.state.spindle.commanded {
            self.report_motion_on_ramp(t, motion.pace);
        }
        self.state.exec = Exec::Moving(*motion);
        self.state.path.moving = true;
        self.put_segment(t);
        self.aim_at_motion(t);
        self.update_spindle_and_plc(t);
        // The override ends with a thread's block: the spindle goes back to the commanded speed.
        if matches!(motion.pace, Pace::Thread(_)) {
            self.report_motion_on_ramp(t, motion.pace);
        }
    }

    /// Reports, once per block, axis motion while the spindle is still on its ramp to a commanded speed: a warning for a cut, a remark for
    /// a rapid.
    fn report_motion_on_ramp(&mut self, t: f64, pace: Pace) {
        let plant = &self.plant.spindle;
        let Some(ramp) = self.out.timeline.ramps.last().filter(|_| plant.drives_cut) else { return };
        let part = plant.rules.tolerance();
        let turns = self.state.spindle.rotation != Rotation::Stopped
            && self.state.spindle.orienting.is_none()
            && ramp.target != 0.0;
        let left = ramp.within(part) - t;
        if !turns || left <= 0.0 {
            self.state.spindle.commanded = false;
            return;
        }
        let (speed, commanded, time) = ((ramp.speed(t).abs(), 0), (ramp.target.abs(), 0), (left, 2));
        let finding = match pace {
            Pace::Rapid => Diagnostic::info(msg!("motion.rapid-while-ramping", speed, commanded, time)),
            _ => Diagnostic::warning(msg!("motion.cut-while-ramping", speed, commanded, time)),
        };
        self.report_in_block(finding);
    }

    /// Warns once that an axis is too slow for a feed (mm/min) and limits the path speed to `limit` (mm/s).
    fn warn_axis_clamp(&mut self, limit: f64, limiting: usize, feed: f64) {
        let slowed = limit * 60.0;
        if feed > slowed * (1.0 + 1e-9) {
            let axis = self.plant.axes[limiting];
            self.warn(Once::Clamp(limiting), || {
                msg!("motion.axis-clamp", axis = axis.name(), clamp = axis.clamp, feed, slowed)
            });
        }
    }

    /// Updates the path speed of the movement.
    pub(super) fn update_path_speed(&mut self, t: f64) {
        let asked = self.asked_speed(t);
        let Exec::Moving(motion) = &mut self.state.exec else { return };
        if asked.0.min(motion.limit) == motion.speed {
            motion.again = asked.1;
            self.warn_spindle_at_rest();
        } else {
            self.put_segment(t);
        }
    }

    /// Starts a segment of the path at `t`.
    pub(super) fn put_segment(&mut self, t: f64) {
        let (asked, again) = self.asked_speed(t);
        let Exec::Moving(motion) = &mut self.state.exec else { return };
        motion.set_speed(t, asked.min(motion.limit));
        motion.again = again;
        let (segment, circle) = motion.segment();
        let (pace, limit, limiting) = (motion.pace, motion.limit, motion.limiting);
        self.out.timeline.put_segment(segment, circle);
        self.note_surface_cut_end(t);
        if matches!(pace, Pace::Thread(_) | Pace::Feed(Feed::PerRevolution(_))) {
            self.warn_axis_clamp(limit, limiting, asked * 60.0);
            self.warn_spindle_at_rest();
        }
    }

    /// Warns once that a feed per revolution waits for a spindle at rest or without encoder.
    fn warn_spindle_at_rest(&mut self) {
        if self.waits_for_spindle() {
            let (once, message) = if self.plant.spindle.encoder {
                (Once::SpindleAtRest, msg!("motion.spindle-at-rest"))
            } else {
                (Once::NoEncoder, msg!("motion.no-encoder"))
            };
            self.warn(once, || message);
        }
    }

    /// Whether a feed per revolution waits because the spindle is at rest.
    pub(super) fn waits_for_spindle(&self) -> bool {
        let Exec::Moving(motion) = &self.state.exec else { return false };
        let by_turns = matches!(motion.pace, Pace::Thread(_) | Pace::Feed(Feed::PerRevolution(_)));
        let stands = self.measured(self.state.now) == 0.0;
        by_turns
            && stands
            && motion.speed == 0.0
            && !motion.again.is_finite()
            && !self.holding()
            && !self.state.plc.orders.axes_held
    }

    /// Path speed (mm/s) from override, spindle and hold at `t`, before clamps, and the time (s) of the next computation.
    fn asked_speed(&self, t: f64) -> (f64, f64) {
        let Exec::Moving(motion) = &self.state.exec else { return (0.0, f64::INFINITY) };
        if self.holding() || self.state.plc.orders.axes_held {
            return (0.0, f64::INFINITY);
        }
        let is_fixed = self.state.suppressed.feed_override || self.state.plc.orders.feed_override_off;
        let cutting = if is_fixed { 1.0 } else { percent(self.state.operator.knobs.feed) / 100.0 };
        match motion.pace {
            Pace::Rapid | Pace::Return { .. } => {
                (motion.limit * (percent(self.state.operator.knobs.rapid) / 100.0).min(1.0), f64::INFINITY)
            }
            Pace::Feed(Feed::PerMinute(feed)) => (feed.max(0.0) * cutting / 60.0, f64::INFINITY),
            Pace::Feed(Feed::PerRevolution(feed)) => self.in_step(t, feed.max(0.0) * cutting),
            Pace::Thread(lead) => self.in_step(t, lead.max(0.0)),
        }
    }

    /// Path speed of a feed in mm per revolution. While the spindle speed changes, the feed follows in steps, each with the mean speed of
    /// its span.
    fn in_step(&self, t: f64, feed: f64) -> (f64, f64) {
        let reached = self.state.spindle.reached_at;
        let again = if reached.is_finite() { reached.min(t + MEASURE) } else { f64::INFINITY };
        let middle = if again.is_finite() { 0.5 * (t + again) } else { t };
        (feed * self.measured(middle) / 60.0, again)
    }

    /// Spindle speed in r/min as measured by the encoder, without sign; 0 without encoder.
    pub(super) fn measured(&self, t: f64) -> f64 {
        let plant = &self.plant.spindle;
        let ramp = self.out.timeline.ramps.last().filter(|_| plant.encoder);
        ramp.map_or(0.0, |ramp| ramp.actual(plant, t).abs())
    }

    /// Time (s) at which the spindle is fast enough for a cut.
    pub(super) fn speed_time(&self) -> f64 {
        let plant = &self.plant.spindle;
        let (Some(part), Some(ramp)) = (plant.rules.reached, self.out.timeline.ramps.last()) else {
            return self.state.now;
        };
        if self.state.spindle.rotation == Rotation::Stopped { self.state.now } else { ramp.within(part).max(ramp.t) }
    }
}

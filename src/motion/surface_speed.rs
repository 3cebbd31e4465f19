//! Constant surface speed: the spindle follows the diameter of a cut.

use super::exec::{Exec, MEASURE};
use super::moves::Pace;
use super::once::Once;
use super::program::RunningProgram;
use super::sim::Sim;
use super::spindle_control::Surface;
use super::spindle_speed::FASTEST;
use crate::controls::schema::spindle::RapidSpeed;
use crate::drives::Bound;
use crate::drives::speed::{limit_diameter, surface_rpm};
use crate::msg;

/// Largest relative change of the diameter in a step of constant surface speed.
const PART: f64 = 0.05;

/// Shortest step in seconds.
const LEAST: f64 = 1e-4;

impl<P: RunningProgram> Sim<'_, P> {
    /// Speed (r/min) for a position of the axis, before override and limits.
    fn surface_rpm(&self, place: f64) -> Option<f64> {
        let surface = self.state.spindle.surface?;
        Some(surface_rpm(surface.speed, 2.0 * (place - surface.zero)).min(FASTEST))
    }

    /// Speed now, speed after a step, and the step (s), while a cut moves the axis of constant surface speed.
    pub(super) fn following(&mut self, t: f64) -> Option<(f64, f64, f64)> {
        let mut surface = self.state.spindle.surface.filter(|surface| t < surface.until)?;
        let plant = self.plant.axes.get(surface.axis)?;
        let end = match &self.state.exec {
            Exec::Moving(motion) => motion.end_time().min(surface.until),
            _ => surface.until,
        };
        let diameter = |t: f64| 2.0 * (self.out.timeline.path.commanded(surface.axis, plant, t) - surface.zero).abs();
        let rpm = |diameter: f64| surface_rpm(surface.speed, diameter).min(FASTEST);
        if surface.last_computed.0 != t {
            surface.last_computed = (t, diameter(t));
            self.state.spindle.surface = Some(surface);
        }
        let here = surface.last_computed.1;
        let whole = MEASURE.min(end - t);
        if whole < LEAST * 1e-3 {
            return Some((rpm(here), rpm(here), 0.0));
        }
        let (mut span, mut there) = (whole, diameter(t + whole));
        let rate = (there - here).abs() / span;
        let (bound, bound_later) = (self.limited_speed(rpm(here)).1, self.limited_speed(rpm(there)).1);
        if rate > 0.0 && (bound == Bound::None || bound != bound_later) {
            span = span.min((PART * here / rate).max(LEAST));
            // A step ends at the diameter where a limit begins or ends.
            if bound != bound_later {
                let share = self.override_share();
                let edge = self.limited_speed(rpm(if bound == Bound::None { there } else { here })).0 / share;
                let to_edge = (limit_diameter(surface.speed, edge) - here).abs() / rate;
                span = span.min(to_edge.max(LEAST));
            }
        }
        if span < whole {
            there = diameter(t + span);
        }
        Some((rpm(here), rpm(there), span))
    }

    /// Starts constant surface speed.
    pub(super) fn begin_surface(&mut self, t: f64, speed: f64, axis: u8, zero: i64) {
        let (Some(scale), at) = (self.plant.scale.get(usize::from(axis)), usize::from(axis)) else { return };
        let zero = zero as f64 * scale;
        let before = self.state.spindle.surface.filter(|before| before.axis == at);
        let until = before.map_or(f64::NEG_INFINITY, |before| before.until);
        self.state.spindle.surface = Some(Surface {
            speed,
            axis: at,
            zero,
            until,
            again: f64::INFINITY,
            last_computed: (f64::NEG_INFINITY, 0.0),
        });
        self.state.spindle.diameter_axis = Some((axis, zero));
        // If the turning centre is unknown, it is assumed to be at the first work zero.
        let centre = *self.state.spindle.centre.get_or_insert(self.plant.spindle.centre.unwrap_or(zero));
        let offset = (zero - centre).abs();
        if offset > 1e-9 {
            let letter = self.plant.axes[at].name();
            if offset <= self.plant.spindle.rules.small_offset + 1e-9 {
                self.note(Once::SmallOffset, || msg!("motion.small-offset", axis = letter, offset = (offset, 4)));
            } else {
                self.warn(Once::OffCentre, || msg!("motion.off-centre", axis = letter, offset = (offset, 4)));
            }
        }
        if self.plant.spindle.rules.surface_at_once || before.is_some_and(|before| before.until.is_finite()) {
            self.state.spindle.commanded |= before.is_none();
            self.aim(self.state.path.position[at]);
        }
        self.update_spindle_and_plc(t);
    }

    /// Ends constant surface speed; the spindle keeps its speed.
    pub(super) fn end_surface(&mut self, t: f64) {
        let (held, share) = (self.limited_speed(self.state.spindle.speed).0, self.override_share());
        if self.state.spindle.surface.take().is_some() && share > 0.0 {
            self.state.spindle.speed = held / share;
        }
        self.update_spindle_and_plc(t);
    }

    /// Sets the spindle speed for a position of the axis.
    fn aim(&mut self, place: f64) {
        self.state.spindle.speed = self.surface_rpm(place).unwrap_or(self.state.spindle.speed);
    }

    /// Before a cut: sets the speed for its start.
    pub(super) fn aim_at_cut(&mut self, t: f64) {
        if let Some(surface) = self.state.spindle.surface
            && t >= surface.until
        {
            self.aim(self.state.path.position[surface.axis]);
            self.update_spindle_and_plc(t);
        }
    }

    /// Sets the speed of the rapid's end, if a cutting block has been read during the rapid.
    pub(super) fn aim_ahead(&mut self, t: f64) {
        let rapid = || matches!(&self.state.exec, Exec::Moving(motion) if motion.pace == Pace::Rapid);
        if self.state.spindle.surface.is_some()
            && self.state.reader.queue.back().is_some_and(|queued| queued.canon.is_cut() == Some(true))
            && self.cut_follows()
            && rapid()
        {
            self.aim_at_motion(t);
            self.update_spindle_and_plc(t);
        }
    }

    /// Lets constant surface speed follow its axis in a new motion.
    pub(super) fn aim_at_motion(&mut self, t: f64) {
        let (Exec::Moving(motion), Some(surface)) = (&self.state.exec, self.state.spindle.surface) else { return };
        if motion.pace != Pace::Rapid {
            // A cut directly after a cut continues from the present position of the axis.
            let still = t >= surface.until;
            let place = self.state.path.position[surface.axis];
            self.note_surface_cut_end(t);
            if still {
                self.aim(place);
            }
        } else {
            let end = motion.end[surface.axis];
            self.note_surface_cut_end(t);
            if self.plant.spindle.rules.rapid == RapidSpeed::OfEnd || self.cut_follows() {
                self.aim(end);
            }
        }
    }

    /// Whether a cut that follows the executing block is read, within the control's look-ahead.
    fn cut_follows(&self) -> bool {
        let last = match self.plant.spindle.rules.rapid {
            RapidSpeed::BeforeCutBlock => self.state.reader.executed + 1,
            RapidSpeed::BeforeCut => u64::MAX,
            RapidSpeed::OfEnd | RapidSpeed::Kept => return false,
        };
        let near = self.state.reader.queue.iter().take_while(|queued| queued.block <= last);
        near.into_iter().find_map(|queued| queued.canon.is_cut()) == Some(true)
    }

    /// At a new segment of the path: stores the end of the cut's movement of the axis.
    pub(super) fn note_surface_cut_end(&mut self, t: f64) {
        let Some(surface) = &mut self.state.spindle.surface else { return };
        let settles = t + self.plant.axes.get(surface.axis).map_or(0.0, |axis| axis.time_constant);
        surface.until = match &self.state.exec {
            Exec::Moving(motion) if motion.pace.is_rapid() => f64::NEG_INFINITY,
            Exec::Moving(motion) if motion.moves(surface.axis) && motion.speed > 0.0 => f64::INFINITY,
            _ => surface.until.min(settles),
        };
        if surface.until <= t {
            surface.again = f64::INFINITY;
        } else if surface.again == f64::INFINITY {
            surface.again = t;
        }
    }
}

//! One movement: its geometry, its speed limit and its segment of the path.

use super::path::{Circle, Segment};
use super::plant::AxisPlant;
use crate::interp::Feed;
use crate::interp::arc::sweep;
use crate::interp::canon::AXES;
use crate::math;

/// Source of a movement's speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Pace {
    /// Rapid traverse.
    Rapid,
    /// Program zero return by the operator, at rapid traverse. `ended`: the program had ended before.
    Return { ended: bool },
    /// A programmed feed.
    Feed(Feed),
    /// A thread, by its lead in mm per spindle revolution; override and hold do not act on it.
    Thread(f64),
}

impl Pace {
    /// Whether the movement runs at rapid traverse.
    #[inline(always)]
    pub(super) fn is_rapid(self) -> bool {
        matches!(self, Pace::Rapid | Pace::Return { .. })
    }
}

/// An arc in a plane: all lengths in mm, angles in radians, counter-clockwise positive.
#[derive(Debug, Clone, Copy)]
struct ArcMove {
    plane: (u8, u8),
    radius: f64,
    phase: f64,
    sweep: f64,
}

/// The executing movement.
#[derive(Debug, Clone, Copy)]
pub(super) struct ActiveMove {
    /// Start point.
    pub(super) start: [f64; AXES],
    /// Travel in proportion to the path: all of a line; on an arc, the travel of other axes and the rounding error in the plane.
    line: [f64; AXES],
    bow: Option<ArcMove>,
    /// End point.
    pub(super) end: [f64; AXES],
    /// Length of the path; millimetres and degrees count alike (`docs/reference/mitsubishi-e60.md` section 5).
    pub(super) length: f64,
    pub(super) pace: Pace,
    /// Exact stop at the end.
    pub(super) exact: bool,
    /// Largest path speed within all axis clamps (for rapids, rapid rates), mm/s.
    pub(super) limit: f64,
    /// Axis that sets the limit.
    pub(super) limiting: usize,
    /// Present path speed in mm/s.
    pub(super) speed: f64,
    /// Path covered at `since`.
    done: f64,
    /// Start (s) of the present speed.
    pub(super) since: f64,
    /// Time (s) of the next computation of the path speed; infinite if it does not follow the spindle.
    pub(super) again: f64,
}

impl ActiveMove {
    /// A straight line.
    pub(super) fn line(
        start: [f64; AXES],
        end: [f64; AXES],
        pace: Pace,
        exact: bool,
        axes: &[AxisPlant; AXES],
    ) -> ActiveMove {
        let line: [f64; AXES] = core::array::from_fn(|k| end[k] - start[k]);
        let length = line.iter().map(|d| d * d).sum::<f64>().sqrt();
        let (limit, limiting, speed, done, since, again) = (0.0, 0, 0.0, 0.0, 0.0, f64::INFINITY);
        let mut motion =
            ActiveMove { start, line, bow: None, end, length, pace, exact, limit, limiting, speed, done, since, again };
        motion.set_limit(axes);
        motion
    }

    /// Turns the line into an arc; a full circle if it ends in the plane at its start point. The small rounding difference between the end
    /// point and the circle is spread over the arc.
    pub(super) fn around(
        mut self,
        plane: (u8, u8),
        center: (f64, f64),
        clockwise: bool,
        axes: &[AxisPlant; AXES],
    ) -> ActiveMove {
        let (a, b) = (plane.0 as usize, plane.1 as usize);
        if a >= AXES || b >= AXES || a == b {
            return self;
        }
        let (start, end) = (self.start, self.end);
        let (from, to) = ((start[a] - center.0, start[b] - center.1), (end[a] - center.0, end[b] - center.1));
        let radius = math::hypot(from.0, from.1);
        let phase = math::atan2(from.1, from.0);
        let sweep = sweep((from, to), start[a] == end[a] && start[b] == end[b], clockwise);
        let others: f64 = (0..AXES).filter(|&k| k != a && k != b).map(|k| self.line[k] * self.line[k]).sum();
        let (sin, cos) = math::sin_cos(phase + sweep);
        self.line[a] = to.0 - radius * cos;
        self.line[b] = to.1 - radius * sin;
        self.length = (radius * sweep * radius * sweep + others).sqrt();
        self.bow = Some(ArcMove { plane, radius, phase, sweep });
        self.set_limit(axes);
        self
    }

    /// Sets the limit of the path speed, so that no axis exceeds its rate.
    #[inline(always)]
    fn set_limit(&mut self, axes: &[AxisPlant; AXES]) {
        self.limit = f64::INFINITY;
        for (k, axis) in axes.iter().enumerate() {
            let in_plane = self.bow.filter(|bow| bow.plane.0 as usize == k || bow.plane.1 as usize == k);
            // An axis of the plane may reach the full speed in the plane somewhere on the arc.
            let way = in_plane.map_or(self.line[k].abs(), |bow| bow.radius * bow.sweep.abs());
            if way == 0.0 {
                continue;
            }
            let share = way / self.length;
            let rate = if self.pace.is_rapid() { axis.rapid } else { axis.clamp };
            let limit = rate / 60.0 / share;
            if share > 0.0 && limit < self.limit {
                (self.limit, self.limiting) = (limit, k);
            }
        }
    }

    /// Sets the path speed (mm/s) from time `t` (s) on.
    pub(super) fn set_speed(&mut self, t: f64, speed: f64) {
        self.done = (self.done + self.speed * (t - self.since)).min(self.length);
        self.since = t;
        self.speed = speed;
    }

    /// Time (s) of the end at the present speed.
    #[inline]
    pub(super) fn end_time(&self) -> f64 {
        let left = self.length - self.done;
        if left <= 0.0 {
            self.since
        } else if self.speed > 0.0 {
            self.since + left / self.speed
        } else {
            f64::INFINITY
        }
    }

    /// Positions of the axes at a fraction of the path.
    fn place(&self, part: f64) -> [f64; AXES] {
        let mut place = core::array::from_fn(|k| self.start[k] + self.line[k] * part);
        if let Some(bow) = self.bow {
            let (now, begin) = (math::sin_cos(bow.phase + bow.sweep * part), math::sin_cos(bow.phase));
            place[bow.plane.0 as usize] += bow.radius * (now.1 - begin.1);
            place[bow.plane.1 as usize] += bow.radius * (now.0 - begin.0);
        }
        place
    }

    /// Whether an axis moves.
    pub(super) fn moves(&self, k: usize) -> bool {
        self.line[k] != 0.0 || self.bow.is_some_and(|bow| bow.plane.0 as usize == k || bow.plane.1 as usize == k)
    }

    /// The segment from `since` on.
    #[inline(always)]
    pub(super) fn segment(&self) -> (Segment, Option<Circle>) {
        let (t, part, rate) = (self.since, self.done / self.length, self.speed / self.length);
        let velocity = self.line.map(|d| d * rate);
        let circle = self.bow.map(|bow| {
            let phase = bow.phase + bow.sweep * part;
            Circle { t, plane: bow.plane, radius: bow.radius, phase, omega: bow.sweep * rate }
        });
        (Segment { t, from: self.place(part), velocity, circle: 0 }, circle)
    }
}

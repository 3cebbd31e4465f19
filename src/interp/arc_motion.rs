//! The command for an arc: its centre by I J K, by its radius, by an intermediate point or by the tangent of the last motion.

use super::arc::{
    Chord, Impossible, center_by_point, center_by_radius, center_by_tangent, checked_center, moved_center, sweep,
};
use super::canon::{AXES, Canon, Feed, Target};
use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::state::{ArcGeometry, RunState};
use super::words::BlockWords;
use crate::controls::{Address, Alarm, Code};
use crate::math;
use crate::msg;

impl RunState {
    pub(super) fn arc(
        &self,
        cx: &BlockContext,
        values: &BlockWords,
        mut to: Target,
        feed: Feed,
        exact: bool,
    ) -> BlockResult<Canon> {
        let [first, second, _] = self.modal.plane;
        let scale = |axis: u8| cx.shared.rules.moved(axis);
        let delta = |axis: u8| {
            let travel = to.position[axis as usize].saturating_sub(self.position[axis as usize]);
            travel as f64 * scale(axis)
        };
        let motion = self.modal.motion;
        let clockwise = motion == Code::ArcCw;
        let chord = Chord { end: (delta(first), delta(second)), clockwise };
        let units = &cx.shared.units;
        let tolerance = cx.control.limits.arc_tolerance * units.per_unit;
        let center = match (values.radius, values.turn) {
            (Some(radius), _) => center_by_radius(chord, radius as f64, tolerance),
            (None, Some(turn)) if values.center == [None; 3] => center_by_radius(chord, chord.radius(turn), tolerance),
            (None, _) => {
                let offsets = self.center_of(cx, values, (first, second));
                if cx.control.limits.arc_centre_moves {
                    moved_center(chord, offsets, tolerance)
                } else {
                    checked_center(chord, offsets, tolerance)
                }
            }
        };
        let placed = match motion {
            Code::ArcThrough => {
                center_by_point(chord.end, (self.passed(cx, values, first), self.passed(cx, values, second)))
            }
            Code::ArcTangent => center_by_tangent(chord.end, self.heading(cx)),
            _ => center.map(|center| Some((center, clockwise))),
        };
        let millimetres = |increments: f64| (increments / units.per_unit, 4);
        let placed = placed.map_err(|why| match why {
            Impossible::NoCenter if motion == Code::ArcThrough => Trap::alarm(Alarm::Arc, msg!("interp.arc-through")),
            Impossible::NoCenter if motion == Code::ArcTangent => Trap::alarm(Alarm::Arc, msg!("interp.arc-tangent")),
            Impossible::NoCenter => Trap::alarm(Alarm::Arc, msg!("interp.arc-no-center")),
            Impossible::Deviation(start, end) => {
                let tolerance = cx.control.limits.arc_tolerance;
                let message =
                    msg!("interp.arc-deviation", start = millimetres(start), end = millimetres(end), tolerance);
                Trap::alarm(Alarm::Arc, message)
            }
            Impossible::Radius(radius, least) => {
                let message = msg!("interp.arc-radius", radius = millimetres(radius), least = millimetres(least));
                Trap::alarm(Alarm::ArcRadius, message)
            }
        })?;
        let Some(((x, y), clockwise)) = placed else { return Ok(Canon::Linear { to, feed, exact }) };
        let feed = if cx.shared.rules.running.helix_by_arc {
            self.helix_feed(
                cx,
                feed,
                &to,
                (first, second),
                sweep(((-x, -y), (chord.end.0 - x, chord.end.1 - y)), chord.end == (0.0, 0.0), clockwise)
                    * math::hypot(x, y),
            )
        } else {
            feed
        };
        to.mask |= 1 << first | 1 << second;
        let start = |axis: u8| self.position[axis as usize] as f64;
        let center = (start(first) + x / scale(first), start(second) + y / scale(second));
        Ok(Canon::Arc { to, plane: (first, second), center, clockwise, feed, exact })
    }

    /// Feed along the path of a helix from its feed along the arc, whose length is `arc`: `F · sqrt(arc² + others²) / arc`.
    fn helix_feed(&self, cx: &BlockContext, feed: Feed, to: &Target, plane: (u8, u8), arc: f64) -> Feed {
        let way = |k: usize| to.position[k].saturating_sub(self.position[k]) as f64 * cx.shared.rules.moved(k as u8);
        let others = (0..AXES).filter(|&k| k != usize::from(plane.0) && k != usize::from(plane.1));
        let others: f64 = others.map(|k| way(k) * way(k)).sum();
        if others == 0.0 || arc == 0.0 {
            return feed;
        }
        let ratio = (arc * arc + others).sqrt() / arc.abs();
        match feed {
            Feed::PerMinute(feed) => Feed::PerMinute(feed * ratio),
            Feed::PerRevolution(feed) => Feed::PerRevolution(feed * ratio),
        }
    }

    /// Sets the end of an arc from its centre and its swept angle in degrees.
    #[cold]
    pub(super) fn turn_to(&self, cx: &BlockContext, values: &BlockWords, turn: f64, to: &mut Target) {
        let [first, second, _] = self.modal.plane;
        let (x, y) = self.center_of(cx, values, (first, second));
        let (sin, cos) = math::sin_cos(if self.modal.motion == Code::ArcCw { -turn } else { turn }.to_radians());
        for (axis, by) in [(first, x - x * cos + y * sin), (second, y - x * sin - y * cos)] {
            let scale = cx.shared.rules.moved(axis);
            if let Some(place) = to.position.get_mut(usize::from(axis)) {
                *place = place.saturating_add((by / scale).round() as i64);
                to.mask |= 1 << axis;
            }
        }
    }

    /// Distance along an axis from the start of an arc to its intermediate point, as slide travel.
    fn passed(&self, cx: &BlockContext, values: &BlockWords, axis: u8) -> f64 {
        let at = usize::from(axis);
        let place = cx.control.axes.get(at).and_then(|axis| axis.letter.after(Address::X));
        let point = place.and_then(|place| values.through.get(place).copied().flatten());
        let (Some(value), Some(scale)) = (point, cx.shared.rules.moves.get(at)) else { return 0.0 };
        let from = if self.modal.absolute { self.modal.zero[at].saturating_sub(self.position[at]) } else { 0 };
        value.saturating_add(from) as f64 * scale
    }

    /// Direction in the plane at the end of the last motion.
    fn heading(&self, cx: &BlockContext) -> (f64, f64) {
        let [first, second, _] = self.modal.plane;
        let part = |axis: u8, from: f64| {
            let at = usize::from(axis).min(AXES - 1);
            (self.position[at] as f64 - from) * cx.shared.rules.moves[at]
        };
        match self.last_motion.arc {
            Some(ArcGeometry { plane, center, clockwise }) if plane == (first, second) => {
                let (x, y) = (part(first, center.0), part(second, center.1));
                if clockwise { (y, -x) } else { (-y, x) }
            }
            _ => {
                let from = |axis: u8| self.last_motion.from[usize::from(axis).min(AXES - 1)] as f64;
                (part(first, from(first)), part(second, from(second)))
            }
        }
    }

    /// I, J, K of the axes of a plane: distance from the start to the centre, as slide travel.
    fn center_of(&self, cx: &BlockContext, values: &BlockWords, (first, second): (u8, u8)) -> (f64, f64) {
        let offset = |axis: u8| {
            let row = usize::from(axis).min(AXES - 1);
            let place = cx.control.axes.get(row).and_then(|axis| axis.letter.after(Address::X));
            let programmed = place.and_then(|at| Some((at, values.center.get(at).copied().flatten()?)));
            match programmed {
                None => 0.0,
                Some((at, value)) if values.center_absolute >> at & 1 != 0 => {
                    // A position counts as the axis does: a diameter along X.
                    let from = self.modal.zero[row].saturating_sub(self.position[row]);
                    value.saturating_add(from) as f64 * cx.shared.rules.moved(axis)
                }
                Some((_, value)) => value as f64,
            }
        };
        (offset(first), offset(second))
    }
}

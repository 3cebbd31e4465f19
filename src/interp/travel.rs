//! The command for the axis words of a block: motion, dwell, coordinate systems. Radii of arcs and leads count what the slide moves.

use super::arc::{Chord, Impossible, by_center, by_moved_center, by_point, by_radius, by_tangent, passes};
use super::canon::{AXES, Canon, Feed, Target};
use super::codes::BlockCodes;
use super::context::BlockContext;
use super::error::{Run, Trap};
use super::state::{ArcGeometry, LastMotion, RunState};
use super::words::BlockWords;
use crate::controls::syntax::long;
use crate::controls::{Alarm, Code};
use crate::math;
use crate::msg;
use crate::nc::Dimensioning;

impl RunState {
    /// The command for the axis words of a block; whether axes move.
    #[inline]
    pub(super) fn motion(&mut self, cx: &BlockContext, codes: &BlockCodes, values: &BlockWords) -> Run<bool> {
        match codes.special {
            Some(Code::Dwell) if values.dwell_turns.is_some() => {
                self.queue.push(Canon::DwellTurns { turns: values.dwell_turns.unwrap_or(0.0) });
                return Ok(false);
            }
            Some(Code::Dwell) => {
                self.queue.push(Canon::Dwell { seconds: values.dwell.unwrap_or(0.0) });
                return Ok(false);
            }
            Some(Code::SetCoordinates) => {
                self.set_coordinates(cx, values);
                return Ok(false);
            }
            Some(code @ (Code::LowerLimits | Code::UpperLimits)) => {
                for k in (0..AXES).filter(|k| values.mask & 1 << k != 0) {
                    self.modal.limit_area(code == Code::UpperLimits, k, values.axes[k]);
                }
                return Ok(false);
            }
            Some(code @ (Code::Offset | Code::OffsetMore)) => {
                for k in 0..AXES {
                    let programmed = if values.mask & 1 << k != 0 { values.axes[k] } else { 0 };
                    let before = if code == Code::OffsetMore { self.modal.local(k) } else { 0 };
                    self.modal.set_local(k, before.saturating_add(programmed));
                }
                self.surface_speed(cx);
                return Ok(false);
            }
            Some(Code::LocalCoordinates) => {
                for k in (0..AXES).filter(|k| values.mask & 1 << k != 0) {
                    self.modal.set_local(k, values.axes[k]);
                }
                self.surface_speed(cx);
                return Ok(false);
            }
            Some(Code::GoTo(point)) => {
                let mut to = Target { position: self.position, mask: values.mask };
                let place = cx.shared.rules.point(point);
                (0..AXES).filter(|k| values.mask & 1 << k != 0).for_each(|k| to.position[k] = place[k]);
                self.came = LastMotion { from: self.position, arc: None };
                self.position = to.position;
                self.queue.push(Canon::Rapid { to });
                return Ok(true);
            }
            _ => {}
        }
        let code = match codes.special {
            Some(Code::MachineRapid) => Code::Rapid,
            Some(Code::Skip | Code::Tapping) => Code::Linear,
            _ if self.modal.cycle => return Ok(false),
            _ => self.modal.motion,
        };
        let full_circle = matches!(code, Code::ArcCw | Code::ArcCcw) && values.center != [None; 3];
        if values.mask == 0 && !full_circle || codes.unmoved {
            return Ok(false);
        }
        let machine = matches!(codes.special, Some(Code::MachineCoordinates | Code::MachineRapid));
        let incremental = if self.modal.absolute || machine { values.incremental } else { u8::MAX } & !values.absolute;
        let mut to = Target { position: self.position, mask: values.mask };
        for k in 0..AXES {
            if values.mask & 1 << k != 0 {
                let from = match (incremental & 1 << k != 0, machine) {
                    (true, _) => self.position[k],
                    (false, true) => 0,
                    (false, false) => self.modal.zero[k],
                };
                to.position[k] = from.saturating_add(values.axes[k]);
                if cx.shared.rules.modulo[k] && incremental & 1 << k == 0 {
                    to.position[k] = self.turned(cx, k, to.position[k], values.axes[k], values.ways[k])?;
                }
            }
        }
        if let (Some(turn), true, 0) = (values.turn, full_circle, values.mask) {
            self.turn_to(cx, values, turn, &mut to);
        }
        if codes.special == Some(Code::ReferenceReturn) {
            if to.position != self.position {
                self.queue.push(Canon::Rapid { to });
            }
            for k in (0..AXES).filter(|k| values.mask & 1 << k != 0) {
                to.position[k] = 0;
            }
            self.position = to.position;
            self.queue.push(Canon::Rapid { to });
            return Ok(cx.control.macros.call_after_return);
        }
        if let Some(area) = self.area(cx) {
            self.within(cx, to, area)?;
        }
        let motion = match code {
            Code::Rapid => Canon::Rapid { to },
            Code::Linear | Code::ArcCw | Code::ArcCcw | Code::ArcThrough | Code::ArcTangent => {
                let skip = codes.special == Some(Code::Skip);
                let exact = codes.exact || self.modal.exact || skip;
                if skip {
                    self.skip = to.position;
                }
                match self.modal.feed {
                    Some(0.0) if cx.shared.rules.running.feed_zero_rapid => Canon::Rapid { to },
                    None | Some(0.0) => return Err(no_feed(cx, self.modal.feed)),
                    Some(feed) => {
                        let per_revolution = self.modal.per_revolution;
                        let feed = match per_revolution {
                            true if self.modal.master > 1 => Feed::PerMinute(feed * self.other_speed()?),
                            true => Feed::PerRevolution(feed),
                            false => Feed::PerMinute(feed),
                        };
                        if code == Code::Linear {
                            Canon::Linear { to, feed, exact }
                        } else {
                            self.arc(cx, values, to, feed, exact)
                                .map_err(|trap| trap.behind(&[b'I', b'J', b'K', b'R', long::CR]))?
                        }
                    }
                }
            }
            Code::Thread if self.modal.master > 1 => return Err(self.other_spindle_asked()),
            Code::Thread => Canon::Thread { to, lead: self.lead(cx, values, to)? },
            Code::Tapping => {
                let rpm = if self.modal.master > 1 { Some(self.modal.other.0) } else { self.modal.last_speed };
                let Some(rpm) = rpm.filter(|rpm| *rpm > 0.0) else {
                    return Err(Trap::alarm(Alarm::SpeedRange, msg!("interp.tapping-speed")));
                };
                let lead = self.lead(cx, values, to)?;
                if self.modal.master <= 1 {
                    // It leaves its angle, where it is held at one: the tap turns with it.
                    self.queue.push(Canon::SpindleDirection { sign: 0 });
                }
                Canon::Linear { to, feed: Feed::PerMinute(lead * rpm), exact: true }
            }
            _ => return Ok(false),
        };
        if let (Canon::Arc { plane, center, clockwise, .. }, Some(area)) = (&motion, self.area(cx)) {
            self.arc_within(cx, to, ArcGeometry { plane: *plane, center: *center, clockwise: *clockwise }, area)?;
        }
        if cx.shared.rules.tangents && to.position != self.position {
            let arc = match motion {
                Canon::Arc { plane, center, clockwise, .. } => Some(ArcGeometry { plane, center, clockwise }),
                _ => None,
            };
            self.came = LastMotion { from: self.position, arc };
        }
        self.position = to.position;
        self.queue.push(motion);
        Ok(true)
    }

    /// The working area, where its limits are on.
    #[inline]
    fn area(&self, cx: &BlockContext) -> Option<&[[i64; AXES]; 2]> {
        self.modal.area.as_ref().filter(|_| cx.shared.rules.running.area && !self.modal.area_off)
    }

    /// Refuses a place beyond the working area.
    #[cold]
    fn within(&self, cx: &BlockContext, to: Target, [low, high]: &[[i64; AXES]; 2]) -> Run<()> {
        for (k, axis) in cx.control.axes.iter().enumerate().take(AXES).filter(|(k, _)| to.mask & 1 << k != 0) {
            let at = to.position[k];
            if !(low[k]..=high[k]).contains(&at) {
                let limit = if at < low[k] { low[k] } else { high[k] };
                let [at, limit] = [at, limit].map(|place| place as f64 / cx.shared.units.per_unit);
                let letter = char::from(axis.letter).to_string();
                let trap = Trap::alarm(Alarm::WorkingArea, msg!("interp.working-area", letter, (at, 4), (limit, 4)));
                return Err(
                    trap.behind(b"XYZ".chunks(1).nth(usize::from(axis.letter.wrapping_sub(b'X'))).unwrap_or(b"XYZ"))
                );
            }
        }
        Ok(())
    }

    /// Refuses an arc that leaves the working area between its ends.
    #[cold]
    fn arc_within(&self, cx: &BlockContext, to: Target, round: ArcGeometry, area: &[[i64; AXES]; 2]) -> Run<()> {
        let ArcGeometry { plane: (first, second), center, clockwise } = round;
        let scale = |axis: u8| cx.shared.rules.moved(axis);
        let from_center = |place: &[i64; AXES]| {
            let part = |axis: u8, center: f64| {
                (place.get(usize::from(axis)).map_or(0.0, |at| *at as f64) - center) * scale(axis)
            };
            (part(first, center.0), part(second, center.1))
        };
        let (start, end) = (from_center(&self.position), from_center(&to.position));
        let radius = math::hypot(start.0, start.1);
        let sides = [(first, center.0, (1.0, 0.0)), (second, center.1, (0.0, 1.0))];
        for ((axis, center, (x, y)), sign) in sides.into_iter().flat_map(|side| [(side, 1.0), (side, -1.0)]) {
            let mut far = Target { position: to.position, mask: 1 << axis };
            if let (true, Some(at)) =
                (passes((start, end), clockwise, (sign * x, sign * y)), far.position.get_mut(usize::from(axis)))
            {
                *at = (center + sign * radius / scale(axis)).round() as i64;
                self.within(cx, far, area)?;
            }
        }
        Ok(())
    }

    /// Speed in r/min of the spindle, not the machine's own, that the master spindle is.
    #[cold]
    fn other_speed(&self) -> Run<f64> {
        match self.modal.other {
            (rpm, true) if rpm > 0.0 => Ok(rpm),
            _ => Err(Trap::alarm(Alarm::Budget, msg!("interp.other-spindle-stands", u32::from(self.modal.master)))),
        }
    }

    /// The master spindle is not the machine's own, and is asked for more than is simulated of it.
    #[cold]
    pub(super) fn other_spindle_asked(&self) -> Trap {
        Trap::alarm(Alarm::Budget, msg!("interp.other-spindle", u32::from(self.modal.master)))
    }

    /// Where a rotary axis ends that goes to an angle, by a way of its own or without passing 0: less than a turn from where it is.
    #[cold]
    fn turned(&self, cx: &BlockContext, axis: usize, to: i64, angle: i64, way: Dimensioning) -> Run<i64> {
        let turn = (360.0 * cx.shared.units.per_unit) as i64;
        if !(0..turn).contains(&angle) && !cx.shared.rules.spindle.angle_wraps {
            let angle = angle as f64 / cx.shared.units.per_unit;
            return Err(Trap::alarm(Alarm::SpindleAngle, msg!("interp.spindle-angle", (angle, 9))));
        }
        let from = self.position[axis];
        if matches!(way, Dimensioning::Plain | Dimensioning::Absolute) {
            let present = from.saturating_sub(to.saturating_sub(angle)).rem_euclid(turn.max(1));
            return Ok(from.saturating_add(angle).saturating_sub(present));
        }
        let positive = to.saturating_sub(from).rem_euclid(turn.max(1));
        let negative = if positive > 0 { positive - turn } else { 0 };
        let by = match way {
            Dimensioning::Positive => positive,
            Dimensioning::Negative => negative,
            _ if 2 * positive <= turn => positive,
            _ => negative,
        };
        Ok(from.saturating_add(by))
    }

    /// The lead in force, along the path.
    fn lead(&self, cx: &BlockContext, values: &BlockWords, to: Target) -> Run<f64> {
        let Some(lead) = self.modal.lead.filter(|lead| *lead != 0.0) else {
            if cx.control.raises(Alarm::NoLead) {
                return Err(Trap::alarm(Alarm::NoLead, msg!("interp.no-lead")));
            }
            return Err(no_feed(cx, self.modal.lead));
        };
        let (stretch, longest) = self.stretch(cx, to);
        let letters =
            || cx.control.axes.iter().zip(longest).filter(|row| row.1).map(|row| row.0.letter.wrapping_sub(b'X'));
        // On a taper of 45° both ways are the longest.
        let counting = letters().fold(0_u8, |bits, own| bits | 1 << (own & 7));
        let own = letters().next().unwrap_or(2);
        if values.leads & !counting != 0 && to.position != self.position {
            let address = char::from(b'I'.wrapping_add(own)).to_string();
            let trap = Trap::alarm(Alarm::LeadAxis, msg!("interp.lead-axis", address));
            return Err(trap.behind(b"IJK"));
        }
        Ok(lead * stretch)
    }

    /// Length of a path per travel of the axis that goes farthest, along which a lead counts, and which axes go so far.
    fn stretch(&self, cx: &BlockContext, to: Target) -> (f64, [bool; AXES]) {
        let travel = |k: usize| to.position[k].saturating_sub(self.position[k]) as f64 * cx.shared.rules.moves[k];
        let squares = (0..AXES).map(|k| travel(k) * travel(k));
        let longest = squares.clone().fold(0.0, f64::max);
        let far = core::array::from_fn(|k| travel(k) * travel(k) >= longest);
        (if longest > 0.0 { (squares.sum::<f64>() / longest).sqrt() } else { 1.0 }, far)
    }

    /// G50 or G92: the present position is the one that is told, or differs from what it was by what is told.
    fn set_coordinates(&mut self, cx: &BlockContext, values: &BlockWords) {
        if values.mask == 0 {
            return;
        }
        let mut to = Target { position: [0; AXES], mask: values.mask };
        for k in (0..AXES).filter(|k| values.mask & 1 << k != 0) {
            let work = self.position[k].saturating_sub(self.modal.zero[k]);
            let was = if values.incremental & 1 << k != 0 { work } else { 0 };
            to.position[k] = was.saturating_add(values.axes[k]);
            self.modal.set_zero(k, self.position[k].saturating_sub(to.position[k]));
        }
        self.queue.push(Canon::Preset { to });
        self.surface_speed(cx);
    }

    fn arc(&self, cx: &BlockContext, values: &BlockWords, mut to: Target, feed: Feed, exact: bool) -> Run<Canon> {
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
            (Some(radius), _) => by_radius(chord, radius as f64, tolerance),
            (None, Some(turn)) if values.center == [None; 3] => by_radius(chord, chord.radius(turn), tolerance),
            (None, _) => {
                let offsets = center_of(cx, values, (first, second));
                if cx.control.limits.arc_centre_moves {
                    by_moved_center(chord, offsets, tolerance)
                } else {
                    by_center(chord, offsets, tolerance)
                }
            }
        };
        let placed = match motion {
            Code::ArcThrough => by_point(chord.end, (self.passed(cx, values, first), self.passed(cx, values, second))),
            Code::ArcTangent => by_tangent(chord.end, self.heading(cx)),
            _ => center.map(|center| Some((center, clockwise))),
        };
        let millimetres = |increments: f64| (increments / units.per_unit, 4);
        let placed = placed.map_err(|why| match why {
            Impossible::NoCenter if motion == Code::ArcThrough => Trap::alarm(Alarm::Arc, msg!("interp.arc-through")),
            Impossible::NoCenter if motion == Code::ArcTangent => Trap::alarm(Alarm::Arc, msg!("interp.arc-tangent")),
            Impossible::NoCenter => Trap::alarm(Alarm::Arc, msg!("interp.arc-no-center")),
            Impossible::Deviation(start, end) => {
                let tolerance = cx.control.limits.arc_tolerance;
                let message = msg!("interp.arc-deviation", millimetres(start), millimetres(end), tolerance);
                Trap::alarm(Alarm::Arc, message)
            }
            Impossible::Radius(radius, least) => {
                let message = msg!("interp.arc-radius", millimetres(radius), millimetres(least));
                Trap::alarm(Alarm::ArcRadius, message)
            }
        })?;
        let Some(((x, y), clockwise)) = placed else { return Ok(Canon::Linear { to, feed, exact }) };
        to.mask |= 1 << first | 1 << second;
        let start = |axis: u8| self.position[axis as usize] as f64;
        let center = (start(first) + x / scale(first), start(second) + y / scale(second));
        Ok(Canon::Arc { to, plane: (first, second), center, clockwise, feed, exact })
    }

    /// The end of an arc by its centre and the degrees that it goes round.
    #[cold]
    fn turn_to(&self, cx: &BlockContext, values: &BlockWords, turn: f64, to: &mut Target) {
        let [first, second, _] = self.modal.plane;
        let (x, y) = center_of(cx, values, (first, second));
        let (sin, cos) = math::sin_cos(if self.modal.motion == Code::ArcCw { -turn } else { turn }.to_radians());
        for (axis, by) in [(first, x - x * cos + y * sin), (second, y - x * sin - y * cos)] {
            let scale = cx.shared.rules.moved(axis);
            if let Some(place) = to.position.get_mut(usize::from(axis)) {
                *place = place.saturating_add((by / scale).round() as i64);
                to.mask |= 1 << axis;
            }
        }
    }

    /// How far the point that an arc passes lies from its start along an axis, in what the slide moves.
    fn passed(&self, cx: &BlockContext, values: &BlockWords, axis: u8) -> f64 {
        let at = usize::from(axis);
        let letter = cx.control.axes.get(at).map_or(0, |axis| axis.letter);
        let point = values.through.get(usize::from(letter.wrapping_sub(b'X'))).copied().flatten();
        let (Some(value), Some(scale)) = (point, cx.shared.rules.moves.get(at)) else { return 0.0 };
        let from = if self.modal.absolute { self.modal.zero[at].saturating_sub(self.position[at]) } else { 0 };
        value.saturating_add(from) as f64 * scale
    }

    /// Direction in the plane in which the last motion came to its end.
    fn heading(&self, cx: &BlockContext) -> (f64, f64) {
        let [first, second, _] = self.modal.plane;
        let part = |axis: u8, from: f64| {
            let at = usize::from(axis).min(AXES - 1);
            (self.position[at] as f64 - from) * cx.shared.rules.moves[at]
        };
        match self.came.arc {
            Some(ArcGeometry { plane, center, clockwise }) if plane == (first, second) => {
                let (x, y) = (part(first, center.0), part(second, center.1));
                if clockwise { (y, -x) } else { (-y, x) }
            }
            _ => {
                let from = |axis: u8| self.came.from[usize::from(axis).min(AXES - 1)] as f64;
                (part(first, from(first)), part(second, from(second)))
            }
        }
    }
}

#[cold]
fn no_feed(cx: &BlockContext, feed: Option<f64>) -> Trap {
    match feed {
        None => Trap::alarm(Alarm::NoFeed, msg!("interp.no-feed")).hint(msg!("interp.hint-feed")),
        Some(_) => Trap::alarm(Alarm::FeedZero, msg!("interp.feed-zero"))
            .hint(msg!("interp.hint-feed-zero", cx.control.guard(&format!("{}…", cx.control.syntax.variable))))
            .behind(b"F"),
    }
}

/// I, J, K of the axes of a plane: how far the centre lies from the start, in what the slide moves.
fn center_of(cx: &BlockContext, values: &BlockWords, (first, second): (u8, u8)) -> (f64, f64) {
    let offset = |axis: u8| {
        let letter = cx.control.axes.get(axis as usize).map_or(0, |axis| axis.letter);
        let at = letter.wrapping_sub(b'X') as usize;
        values.center.get(at).copied().flatten().unwrap_or(0) as f64
    };
    (offset(first), offset(second))
}

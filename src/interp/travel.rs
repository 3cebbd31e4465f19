//! Commands for the axis words of a block: dwell, work zeros, rapid, cut, arc, thread.

use super::canon::{AXES, Canon, Feed, Target};
use super::codes::BlockCodes;
use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::state::{ArcGeometry, LastMotion, RunState};
use super::words::BlockWords;
use crate::controls::{Address, Alarm, Code, Point};
use crate::drives::Rotation;
use crate::msg;
use crate::nc::Dimensioning;

impl RunState {
    /// Queues the command for the axis words of a block; returns whether axes move.
    #[inline]
    pub(super) fn queue_motion(
        &mut self,
        cx: &BlockContext,
        codes: &BlockCodes,
        values: &BlockWords,
    ) -> BlockResult<bool> {
        match codes.special {
            None => {}
            Some(Code::Dwell) => {
                let dwell = values.dwell.unwrap_or(0.0);
                let counts_turns = self.modal.per_revolution && cx.shared.rules.running.dwell_counts_turns;
                self.queue.push(match values.dwell_turns {
                    Some(turns) => Canon::DwellTurns { turns },
                    None if counts_turns => Canon::DwellTurns { turns: dwell },
                    None => Canon::Dwell { seconds: dwell },
                });
                return Ok(false);
            }
            Some(Code::GoTo(point)) => {
                self.go_to_point(cx, values, point);
                return Ok(true);
            }
            Some(code) if self.coordinates(cx, code, values) => return Ok(false),
            Some(_) => {}
        }
        let code = match codes.special {
            Some(Code::MachineRapid) => Code::Rapid,
            Some(Code::Skip | Code::Tapping) => Code::Linear,
            _ if self.modal.unmoved.cycle || self.modal.unmoved.replaced && codes.special.is_none() => {
                return Ok(false);
            }
            _ => self.modal.motion,
        };
        let by_center = matches!(code, Code::ArcCw | Code::ArcCcw) && values.center != [None; 3];
        if values.mask == 0 && !by_center || codes.unmoved {
            return Ok(false);
        }
        let mut to = self.end_point(cx, codes, values)?;
        if let (Some(turn), true, 0) = (values.turn, by_center, values.mask) {
            self.turn_to(cx, values, turn, &mut to);
        }
        if codes.special == Some(Code::ReferenceReturn) {
            self.return_to_reference(values, to);
            return Ok(cx.control.macros.call_after_return);
        }
        self.refuse_outside_coordinates(cx, &to)?;
        if let Some(area) = self.area(cx) {
            self.refuse_outside_area(cx, to, area)?;
        }
        let Some(motion) = self.motion_command(cx, codes, values, code, to)? else { return Ok(false) };
        let arc = match motion {
            Canon::Arc { plane, center, clockwise, .. } => Some(ArcGeometry { plane, center, clockwise }),
            _ => None,
        };
        if let (Some(arc), Some(area)) = (arc, self.area(cx)) {
            self.arc_within(cx, to, arc, area)?;
        }
        if cx.shared.rules.tangents && to.position != self.position {
            self.last_motion = LastMotion { from: self.position, arc };
        }
        self.position = to.position;
        self.queue.push(motion);
        Ok(true)
    }

    /// Rapid to a reference point or the fixed point, without an intermediate point (G74, G75).
    fn go_to_point(&mut self, cx: &BlockContext, values: &BlockWords, point: Point) {
        let mut to = Target { position: self.position, mask: values.mask };
        let place = cx.shared.rules.point(point);
        (0..AXES).filter(|k| values.mask & 1 << k != 0).for_each(|k| to.position[k] = place[k]);
        self.last_motion = LastMotion { from: self.position, arc: None };
        self.position = to.position;
        self.queue.push(Canon::Rapid { to });
    }

    /// G28: rapid to the intermediate point, then to machine zero.
    fn return_to_reference(&mut self, values: &BlockWords, mut to: Target) {
        if to.position != self.position {
            self.queue.push(Canon::Rapid { to });
        }
        for k in (0..AXES).filter(|k| values.mask & 1 << k != 0) {
            to.position[k] = 0;
        }
        self.position = to.position;
        self.queue.push(Canon::Rapid { to });
    }

    /// End point of the axis words: absolute, incremental or in the machine frame.
    #[inline]
    fn end_point(&self, cx: &BlockContext, codes: &BlockCodes, values: &BlockWords) -> BlockResult<Target> {
        let rapid = codes.special == Some(Code::MachineRapid);
        let machine = rapid || codes.special == Some(Code::MachineCoordinates);
        let incremental = if self.modal.absolute || rapid { values.incremental } else { u8::MAX } & !values.absolute;
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
        Ok(to)
    }

    /// The command of a motion code; `None` for codes that move no axis.
    #[inline]
    fn motion_command(
        &mut self,
        cx: &BlockContext,
        codes: &BlockCodes,
        values: &BlockWords,
        code: Code,
        to: Target,
    ) -> BlockResult<Option<Canon>> {
        Ok(Some(match code {
            Code::Rapid => Canon::Rapid { to },
            Code::Linear | Code::ArcCw | Code::ArcCcw | Code::ArcThrough | Code::ArcTangent => {
                let skip = codes.special == Some(Code::Skip);
                let exact = codes.exact || self.modal.exact || skip;
                if skip {
                    self.skip = to.position;
                }
                match self.feed_in_force(cx)? {
                    None => Canon::Rapid { to },
                    Some(feed) if code == Code::Linear => Canon::Linear { to, feed, exact },
                    Some(_) if self.rests(cx, values, to) => return Ok(None),
                    Some(feed) => self
                        .arc(cx, values, to, feed, exact)
                        .map_err(|trap| trap.at_word(&[Address::I, Address::J, Address::K, Address::R, Address::Cr]))?,
                }
            }
            Code::Thread if self.modal.spindle.master > 1 => return Err(self.other_spindle_asked()),
            Code::Thread => Canon::Thread { to, lead: self.lead(cx, values, to)? },
            Code::Tapping => self.tapping(cx, values, to)?,
            _ => return Ok(None),
        }))
    }

    /// Whether an arc by its radius moves nothing because it ends where it starts, on a control without an alarm for it.
    fn rests(&self, cx: &BlockContext, values: &BlockWords, to: Target) -> bool {
        let arc = matches!(self.modal.motion, Code::ArcCw | Code::ArcCcw);
        arc && cx.control.limits.point_arc_rests && values.radius.unwrap_or(0) != 0 && to.position == self.position
    }

    /// Tapping: a feed of lead times spindle speed.
    fn tapping(&mut self, cx: &BlockContext, values: &BlockWords, to: Target) -> BlockResult<Canon> {
        let rpm = if self.modal.spindle.master > 1 {
            Some(self.modal.spindle.second.rpm)
        } else {
            self.modal.spindle.last_speed
        };
        let Some(rpm) = rpm.filter(|rpm| *rpm > 0.0) else {
            return Err(Trap::alarm(Alarm::SpeedRange, msg!("interp.tapping-speed")));
        };
        let lead = self.lead(cx, values, to)?;
        if self.modal.spindle.master <= 1 {
            // A spindle held at an angle is released: the tap turns with it.
            self.queue.push(Canon::SpindleDirection { rotation: Rotation::Stopped });
        }
        Ok(Canon::Linear { to, feed: Feed::PerMinute(lead * rpm), exact: true })
    }

    /// End point of a rotary axis for an absolute angle, by the shortest, positive or negative way or without passing 0: less than a turn
    /// away.
    #[cold]
    fn turned(&self, cx: &BlockContext, axis: usize, to: i64, angle: i64, way: Dimensioning) -> BlockResult<i64> {
        let turn = (360.0 * cx.shared.units.per_unit) as i64;
        if !(0..turn).contains(&angle) && !cx.shared.rules.spindle.angle_wraps {
            let angle = angle as f64 / cx.shared.units.per_unit;
            return Err(Trap::alarm(Alarm::SpindleAngle, msg!("interp.spindle-angle", angle = (angle, 9))));
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
}

//! Spindle commands of a block: S, constant surface speed, speed limits, orientation.

use super::canon::{AXES, Canon, Target};
use super::codes::BlockCodes;
use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::state::RunState;
use super::words::BlockWords;
use crate::controls::Address;
use crate::controls::spindle::LimitPlace;
use crate::controls::{Alarm, Code};
use crate::drives::Approach;
use crate::drives::orient::turn;
use crate::drives::speed::SpeedLimit;
use crate::msg;
use crate::text::units::FOOT;

impl RunState {
    /// S, and constant surface speed on and off. `surface` is its work zero before the block; `None` if it was off.
    #[inline]
    pub(super) fn queue_speed(
        &mut self,
        cx: &BlockContext,
        codes: &BlockCodes,
        values: &BlockWords,
        surface: Option<i64>,
    ) -> BlockResult<()> {
        let speed = values.speed;
        if speed.is_none() && surface.is_none() && !self.modal.spindle.surface {
            return Ok(());
        }
        match (codes.special, speed) {
            (Some(Code::SetCoordinates), Some(rpm)) => {
                self.limit_speed(SpeedLimit::Surface, rpm);
                if values.mask == 0 {
                    self.limit_place(cx);
                }
            }
            (Some(Code::LowerLimits), Some(rpm)) => self.limit_speed(SpeedLimit::Lower, rpm),
            (Some(Code::UpperLimits), Some(rpm)) => self.limit_speed(SpeedLimit::Upper, rpm),
            _ if self.modal.spindle.surface => return self.switch_surface_on(cx, speed, surface),
            _ => {
                if surface.is_some() {
                    self.queue.push(Canon::ConstantSpeed);
                }
                // If a feed code has ended constant surface speed, the last S in r/min is in force again.
                let undone =
                    surface.is_some() && self.modal.spindle.surface_undone && cx.shared.rules.spindle.last_speed_back;
                let back = self.modal.spindle.last_speed.filter(|_| undone);
                if let Some(rpm) = speed {
                    self.modal.set_shown(Address::S, rpm);
                    self.modal.spindle.last_speed = Some(rpm);
                }
                if let Some(rpm) = speed.or(back) {
                    self.queue.push(Canon::SpindleSpeed { rpm });
                }
            }
        }
        Ok(())
    }

    /// Switches constant surface speed on.
    fn switch_surface_on(&mut self, cx: &BlockContext, speed: Option<f64>, before: Option<i64>) -> BlockResult<()> {
        if self.modal.spindle.master > 1 && before.is_none() {
            return Err(self.other_spindle_asked());
        }
        if let Some(speed) = speed {
            self.modal.set_shown(Address::S, speed);
            let feet = self.modal.inch && cx.shared.rules.numbers.surface_feet;
            self.modal.spindle.surface_speed = Some(if feet { speed * FOOT } else { speed });
        } else if self.modal.spindle.surface_speed.is_none() && cx.control.raises(Alarm::NoSurfaceSpeed) {
            return Err(Trap::alarm(Alarm::NoSurfaceSpeed, msg!("interp.no-surface-speed")).at_word(&[Address::G]));
        }
        if speed.is_some() || before != Some(self.surface_zero(cx)) {
            self.surface_speed(cx);
        }
        Ok(())
    }

    /// Queues a speed limit in r/min.
    pub(super) fn limit_speed(&mut self, limit: SpeedLimit, rpm: f64) {
        self.queue.push(Canon::SpeedLimit { limit, rpm });
    }

    /// Effect of a speed limit on the present position.
    fn limit_place(&mut self, cx: &BlockContext) {
        let place = cx.shared.rules.spindle.limit_place;
        if place == LimitPlace::Nothing {
            return;
        }
        let mut to = Target::default();
        for (k, _) in cx.control.axes.iter().enumerate().take(AXES).filter(|(_, axis)| !axis.rotary) {
            if place == LimitPlace::WorkZero {
                self.modal.set_zero(k, self.position[k]);
            }
            to.mask |= 1 << k;
            to.position[k] = self.position[k].saturating_sub(self.modal.zero[k]);
        }
        self.queue.push(Canon::Preset { to });
        if place == LimitPlace::WorkZero {
            self.surface_speed(cx);
        }
    }

    pub(super) fn surface_zero(&self, cx: &BlockContext) -> i64 {
        self.modal.zero.get(cx.shared.rules.surface_axis).copied().unwrap_or(0)
    }

    /// Queues the surface speed if it is on: because it is new, or because its work zero has moved.
    pub(super) fn surface_speed(&mut self, cx: &BlockContext) {
        if self.modal.spindle.surface {
            let (axis, zero) = (cx.shared.rules.surface_axis as u8, self.surface_zero(cx));
            let speed = self.modal.spindle.surface_speed.unwrap_or(0.0);
            self.queue.push(Canon::SurfaceSpeed { speed, axis, zero });
        }
    }

    /// Queues spindle positioning to an angle in degrees, during the motion of the block.
    pub(super) fn orient(&mut self, cx: &BlockContext, angle: f64, approach: Approach) -> BlockResult<()> {
        let within = approach == Approach::Incremental || (0.0..360.0).contains(&angle);
        if !within && !cx.shared.rules.spindle.angle_wraps {
            return Err(Trap::alarm(Alarm::SpindleAngle, msg!("interp.spindle-angle", angle = (angle, 9))));
        }
        self.queue.push(Canon::Orient { angle: if within { angle } else { turn(angle) }, approach });
        Ok(())
    }

    /// The alarm for a command that is not simulated with the second spindle as master spindle.
    #[cold]
    pub(super) fn other_spindle_asked(&self) -> Trap {
        Trap::alarm(Alarm::NotSimulated, msg!("interp.other-spindle", spindle = u32::from(self.modal.spindle.master)))
    }
}

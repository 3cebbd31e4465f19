//! Refusals of motors: the reason with its numbers, and the order of the list by reason.

use crate::drives::servo::{Acceptance, MotorDemand, Servo, ServoRefusal, Shares, WEIGHT_SHARE};
use crate::drives::shaft_motion::OperatingPoint;
use crate::machines::driven::DrivenAxis;
use crate::msg;
use crate::text::Message;

/// Refusal of a motor.
#[derive(Debug, Clone, PartialEq)]
pub struct Refusal {
    pub(super) rank: Rank,
    /// The reason with its numbers.
    pub message: Message,
}

impl Refusal {
    pub(super) fn new(rank: Rank, message: Message) -> Refusal {
        Refusal { rank, message }
    }
}

/// Reasons in the order of the list: the smallest shortage first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rank {
    Inertia,
    Amplifier,
    Regeneration,
    Effective,
    Peak,
    Speed,
    Role,
    Unknown,
}

/// A servo motor with its demand and its limits.
pub(super) struct JudgedMotor<'a> {
    pub motor: &'a Servo,
    pub limits: &'a Acceptance,
    pub demand: &'a MotorDemand,
    pub shares: &'a Shares,
    pub worst_point: &'a OperatingPoint,
}

impl JudgedMotor<'_> {
    /// The refusal of the motor beyond a limit, the first in the order of the checks; none if the demand is within all.
    pub(super) fn beyond_limit(&self) -> Option<Refusal> {
        let JudgedMotor { motor, limits, demand, shares, worst_point } = self;
        let refusal = match shares.fails(limits)? {
            ServoRefusal::Speed => {
                let message = msg!("size.refused-speed", speed = (demand.speed, 0), limit = (motor.top_speed, 0));
                Refusal::new(Rank::Speed, message)
            }
            ServoRefusal::Peak => {
                let gives = motor.short_time_torque(worst_point.speed);
                let message = msg!(
                    "size.refused-peak",
                    torque = (worst_point.torque, 3),
                    speed = (worst_point.speed, 0),
                    limit = (limits.peak * gives, 3),
                    percent = (100.0 * limits.peak, 0)
                );
                Refusal::new(Rank::Peak, message)
            }
            ServoRefusal::Effective => {
                let message = msg!(
                    "size.refused-effective",
                    torque = (demand.effective, 3),
                    limit = (limits.effective * motor.stall, 3),
                    percent = (100.0 * limits.effective, 1)
                );
                Refusal::new(Rank::Effective, message)
            }
            ServoRefusal::Inertia => {
                let (ratio, limit) = ((shares.inertia_ratio, 1), (limits.inertia_ratio, 1));
                Refusal::new(Rank::Inertia, msg!("size.refused-inertia", ratio = ratio, limit = limit))
            }
        };
        Some(refusal)
    }

    /// The refusal of a motor that gives less torque continuously than a long cut or a weight asks; none if it suffices.
    pub(super) fn too_weak_for_long(&self, axis: &DrivenAxis) -> Option<Refusal> {
        let most = self.limits.effective * self.motor.stall;
        if let Some(torque) = axis.continuous_cut_torque.filter(|torque| *torque > most) {
            let message = msg!("size.refused-long-cut", torque = (torque, 3), limit = (most, 3));
            return Some(Refusal::new(Rank::Effective, message));
        }
        let most = WEIGHT_SHARE * axis.site_share * self.motor.stall;
        let too_heavy = || msg!("size.refused-weight", torque = (axis.weight, 3), limit = (most, 3));
        (axis.weight > most).then(|| Refusal::new(Rank::Effective, too_heavy()))
    }

    /// The refusal of a motor whose continuous torque at the mean speed (r/min), a point of the data sheet's chart, is below the effective
    /// torque; none if it suffices.
    pub(super) fn too_warm(&self, mean_speed: f64) -> Option<Refusal> {
        let most = self.limits.effective * self.motor.continuous(mean_speed);
        let message = || {
            msg!(
                "size.refused-warm-at-speed",
                torque = (self.demand.effective, 3),
                speed = (mean_speed, 0),
                limit = (most, 3),
                percent = (100.0 * self.limits.effective, 1)
            )
        };
        (self.demand.effective > most).then(|| Refusal::new(Rank::Effective, message()))
    }
}

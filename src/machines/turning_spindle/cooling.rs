//! Cooling of the spindle's motor: by the fan on its shaft, which turns with the rotor, or by a fan with a motor of its own.

use super::derive::Derived;
use super::driven::{self, motor_speed};
use super::params::Params;
use super::resolved::TurningSpindle;
use crate::machines::devices::{AskedDevice, BillItem};
use crate::machines::verdict::{Judgement, warn};
use crate::msg;
use crate::text::Message;
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// The fan of a motor with forced cooling.
pub(super) fn devices(lathe: &TurningSpindle) -> Vec<AskedDevice> {
    let fan = || AskedDevice { item: BillItem::Fan, drive: Some(driven::NAME), asked: msg!("lathe.device.fan") };
    Vec::from_iter(lathe.p.forced_cooling.then(fan))
}

/// Forced cooling, where the motor carries the cut with it and not with its own fan.
pub(super) fn remedy(lathe: &TurningSpindle) -> Option<Advice> {
    let (d, limit) = (&lathe.d, lathe.d.torque_available);
    let speed = motor_speed(lathe, d);
    let said = msg!("lathe.own-fan", speed = (speed, 0), torque = (d.torque, 1), limit = (limit, 1));
    carries_with_forced(lathe, d).then(|| advice(said))
}

/// Cut and friction with the knob at its slow end, where they ask the same torque and the motor's own fan cools least.
pub(super) fn judge(lathe: &TurningSpindle) -> Option<Judgement> {
    let (p, d) = (&lathe.p, &lathe.d);
    if p.cutting_force <= 0.0 || p.forced_cooling || d.torque > d.torque_available {
        return None;
    }
    let (percent, slow) = lathe.at_lowest_knob()?;
    let limit = slow.for_the_cut(p, slow.torque_available);
    if slow.torque <= limit || !carries_with_forced(lathe, &slow) {
        return None;
    }
    let speed = (motor_speed(lathe, &slow), 0);
    let (percent, torque, shown) = ((percent, 0), (slow.torque, 1), (limit, 1));
    let said = msg!("turning.own-fan-at-knob", percent, speed, torque, limit = shown);
    warn(AtMost(d.torque_available), [advice(said)])
}

fn carries_with_forced(lathe: &TurningSpindle, d: &Derived) -> bool {
    let forced = Params { forced_cooling: true, ..lathe.p.clone() }.continuous(d.stage_speed);
    !lathe.p.forced_cooling && d.torque <= d.for_the_cut(&lathe.p, forced.torque(d.speed_largest))
}

fn advice(said: Message) -> Advice {
    Advice::from(said).setting(msg!("advice.forced-cooling"), [("motor-forced-cooling", "true".to_owned())])
}

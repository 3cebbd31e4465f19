//! The remedy of an analog output at its full voltage: the gear stage, or the greatest speed with which the output is not full.

use super::params::{FIELDS, Gear, Params};
use super::resolved::TurningSpindle;
use crate::drives::Bound;
use crate::machines::form::entry::at_most;
use crate::math;
use crate::msg;
use crate::text::Message;
use crate::view::Advice;

/// An entry of a speed: its field, its present value, how a form gets another one, and the catalog id of the button.
type SpeedEntry = (&'static str, f64, fn(&mut Params, f64), fn(&str) -> Message);

/// The entries of speeds in the order in which they are tried: under constant surface speed its limit, else the cutting speed; the lower limit
/// lifts the speed whatever both are.
fn speeds(lathe: &TurningSpindle) -> [SpeedEntry; 3] {
    let form = &lathe.form;
    let turns = |speed: &str| msg!("advice.set-speed", speed);
    let upper: SpeedEntry = ("upper-limit", form.upper_limit, |form, speed| form.upper_limit = speed, turns);
    let cutting: SpeedEntry = (
        "cutting-speed",
        form.cutting_speed,
        |form, speed| form.cutting_speed = speed,
        |speed| msg!("advice.set-cutting-speed", speed),
    );
    let lower: SpeedEntry = ("lower-limit", form.lower_limit, |form, speed| form.lower_limit = speed, turns);
    if lathe.surface() { [upper, cutting, lower] } else { [cutting, upper, lower] }
}

/// The advice about a full output, with the button of the first entry that alone brings the speed within it.
pub(super) fn remedy(lathe: &TurningSpindle, message: Message) -> Advice {
    let (form, advice) = (&lathe.form, Advice::from(message));
    let holds = |form: Params| lathe.with(form).derived.speeds.bound != Bound::Output;
    if form.gear != Gear::Best && holds(Params { gear: Gear::Best, ..form.clone() }) {
        return advice.setting(msg!("advice.best-stage"), [("gear", "best".to_owned())]);
    }
    for (field, present, set, button) in speeds(lathe) {
        let holds_at = |speed: f64| {
            let mut slower = form.clone();
            set(&mut slower, speed);
            holds(slower)
        };
        let share = math::greatest_share((1.0 / present).min(1.0), |share| holds_at(present * share));
        let entry = at_most(FIELDS, field, (present * share.unwrap_or(0.0)).floor());
        if share.is_some() && entry.value < present && holds_at(entry.value) {
            return advice.setting(button(&entry.text), [entry]);
        }
    }
    advice
}

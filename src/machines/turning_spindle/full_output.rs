//! The remedy for an analog output at its full voltage: another gear stage, or the greatest speed below the full voltage.

use super::params::{FIELDS, Gear, Params};
use super::resolved::TurningSpindle;
use crate::drives::Bound;
use crate::machines::form::entry::at_most;
use crate::math;
use crate::msg;
use crate::text::Message;
use crate::view::Advice;

/// A field of a speed: id, present value, setter of the parameter, and the message of its button.
type SpeedEntry = (&'static str, f64, fn(&mut Params, f64), fn(&str) -> Message);

/// The fields of speeds in the order of trial: under constant surface speed its limit first, otherwise the cutting
/// speed first; the lower limit last, because it can raise the speed above both.
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

/// The advice about a full output, with a button for the first field that alone brings the speed below it.
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

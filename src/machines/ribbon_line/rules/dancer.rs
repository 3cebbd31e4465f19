//! Rules about the regulator of a dancer: the error of the unwound ribbon's speed that it has to trim away.

use super::product::with_effective_diameters;
use crate::machines::form::entry::{NumberEntry, at_least, field_max, field_min, nearest};
use crate::machines::ribbon_line::derive::TRIM;
use crate::machines::ribbon_line::params::{FIELDS, Params};
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::verdict::{Judgement, fail, ok};
use crate::msg;
use crate::view::Advice;
use crate::view::Limit::Within;

/// Greatest error (%) of the unwound ribbon's speed, which the regulator of a dancer has to make up for.
pub(in crate::machines::ribbon_line) fn dancer_trim(line: &RibbonLine) -> f64 {
    100.0 * line.params.greatest_trimmed().1
}

/// Judges whether the regulator of the dancer can make up for the unwinder's error. The remedies are the frequency of the inverter at 10 V, at
/// which the error is the same at 10 V and at the lowest position of the knob with opposite signs, a higher lowest position, and
/// the diameters with the ribbon's thickness.
pub(in crate::machines::ribbon_line) fn trim(line: &RibbonLine) -> Option<Judgement> {
    let (error, limit) = (dancer_trim(line), Within(100.0 * TRIM));
    if limit.holds(error) {
        return ok(limit);
    }
    let p = &line.params;
    let speed = (p.greatest_trimmed().0, 0);
    let holds = |form: &Params| limit.holds(100.0 * form.greatest_trimmed().1);
    let [no_load, rated, frequency] = balanced_motor(p);
    let balanced = Params { no_load_speed: no_load.value, rated_load_speed: rated.value, ..p.clone() };
    let fits = [&no_load, &rated, &frequency].into_iter().all(is_in_range);
    let first = if fits && holds(&balanced) {
        let button = msg!("advice.set-frequency", frequency = frequency.text.as_str());
        let message = msg!("ribbon.dancer-cannot-trim", error = (error, 1), speed);
        Advice::from(message).setting(button, [no_load, rated, frequency])
    } else {
        msg!("ribbon.slip-beyond-trim", error = (error, 1), speed).into()
    };
    let others = [higher_lowest_to_trim(p, holds), effective_to_trim(p, holds)];
    fail(limit, [first].into_iter().chain(others.into_iter().flatten()).collect::<Vec<_>>())
}

/// Speeds of the motor at 10 V without load and at rated torque, and the frequency there, with which the error of the unwound ribbon's speed
/// at 10 V and at the lowest speed n_low differs by its sign alone: `n0 / n10 = 1 / f + slip · (1 / n10 + 1 / n_low) / 2`, with the ribbon
/// laid over that counted, f.
fn balanced_motor(p: &Params) -> [NumberEntry; 3] {
    let lowest = p.lowest_speed();
    let low = if lowest > 0.0 { lowest } else { p.speed_at_10v };
    let slip = p.induction().slip();
    let gain = 1.0 / p.laid_over_counted() + slip * (1.0 / p.speed_at_10v + 1.0 / low) / 2.0;
    let no_load = p.speed_at_10v * gain;
    [
        nearest(FIELDS, "no-load-speed", no_load),
        nearest(FIELDS, "rated-load-speed", no_load - (p.no_load_speed - p.rated_load_speed)),
        nearest(FIELDS, "frequency-at-10v", p.frequency_at_10v * no_load / p.no_load_speed),
    ]
}

/// The lowest position of the knob from which the slip of the motor is within the trim of a dancer: the speed
/// `slip / (n0 / n10 - (1 - trim) / f)`, with the ribbon laid over that counted, f.
fn higher_lowest_to_trim(p: &Params, holds: impl Fn(&Params) -> bool) -> Option<Advice> {
    let motor = p.induction();
    let speed = motor.slip() / (motor.gain() - (1.0 - TRIM) / p.laid_over_counted());
    let set = at_least(FIELDS, "knob-lowest", 100.0 * speed / p.spindle_speed);
    let is_higher = set.value > p.knob_lowest && set.value <= p.override_stepped() && !p.knob_is_locked();
    let message = msg!("ribbon.higher-lowest-to-trim", percent = (set.value, 0));
    let button = msg!("advice.set-lowest-knob", percent = set.text.as_str());
    (is_higher && holds(&Params { knob_lowest: set.value, ..p.clone() }))
        .then(|| Advice::from(message).setting(button, [set]))
}

/// Diameters that count the ribbon's thickness, where they bring the error of the unwound ribbon's speed within the trim of a dancer.
fn effective_to_trim(p: &Params, holds: impl Fn(&Params) -> bool) -> Option<Advice> {
    let form = Params { effective_diameter: true, ..p.clone() };
    (!p.effective_diameter && holds(&form))
        .then(|| with_effective_diameters(p, msg!("ribbon.thickness-beyond-trim").into()))
}

/// Whether the form takes the entry.
fn is_in_range(entry: &NumberEntry) -> bool {
    (field_min(FIELDS, entry.field)..=field_max(FIELDS, entry.field)).contains(&entry.value)
}

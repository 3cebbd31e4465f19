//! The rules of the ribbon line, as rows: result, limit, remedy.
//!
//! Numbers are those of section 7 of `docs/reference/sizing.md`. Rule 1 is the ranges of the form, rule 18 the list of assumed facts; both are
//! kept for every machine. Of rule 4 a clamp is an error (the control slows the vector); an F beyond the control's range is a verdict,
//! as the text is read all the same and stops by itself before anything moves. All others are verdicts.

use super::calculated_once::calculated_once;
use super::derive::{Derived, FIN_DELAY, wait};
use super::params::{Endless, FIELDS, Params, PathMode, PiForm, PrintAxis, Rest, Variant, Wait};
use super::program;
use super::resolved::{GREATEST, RibbonLine};
use crate::controls::dialect::CoordinateFrame;
use crate::controls::{Code, ParamRole};
use crate::drives::web;
use crate::machines::scaling::AxisDrive;
use crate::machines::verdict::{Judgement, Rule, down, fail, near, ok, up, warn};
use crate::math::PI;
use crate::msg;
use crate::text::{Citation, Diagnostic, Grade, Message};
use crate::view::Limit::{AtLeast, AtMost, Equal, Within};
use crate::view::{Advice, Verdict};

/// All rules that judge a result.
pub(super) const RULES: &[Rule<RibbonLine>] = &[
    Rule::new(
        "surface-ratio",
        ratio,
        Citation::new("sizing facts 3.2 and 3.4, engineering choice; rule 2", Grade::Inferred),
    ),
    Rule::new("smear", smear, Citation::new("sizing facts 3.2 and 3.4, engineering choice; rule 2", Grade::Inferred)),
    Rule::new("x-motor-speed", motor_x, Citation::new("data sheet of the motor; rule 3", Grade::Manual)),
    Rule::new("y-motor-speed", motor_y, Citation::new("data sheet of the motor; rule 3", Grade::Manual)),
    Rule::new("line-speed", clamp_x, Citation::new("cutting feed clamp, a parameter; rule 4", Grade::Sister)),
    Rule::new("x-feed", clamp_x, Citation::new("cutting feed clamp, a parameter; rule 4", Grade::Sister)),
    Rule::new("y-feed", clamp_y, Citation::new("cutting feed clamp, a parameter; rule 4", Grade::Sister)),
    Rule::new("vector-feed", feed_limit, Citation::new("ranges of the control; rule 4", Grade::Open)),
    Rule::new("feed-per-revolution", revolution_feed, Citation::new("ranges of the control; rule 4", Grade::Open)),
    Rule::new(
        "block-time",
        block_time,
        Citation::new("sizing facts, section 4, times from memory; rule 5", Grade::Open),
    ),
    Rule::new("volts", saturation, Citation::new("ribbon line facts, 4; rule 6", Grade::Inferred)),
    Rule::new("frequency", slow_motor, Citation::new("trade source; rule 7", Grade::Inferred)),
    Rule::new("register-error", equal_axes, Citation::new("sizing facts 0.6; rule 9", Grade::Inferred)),
    Rule::new("loop-needed", loop_needed, Citation::new("ribbon line facts, 7; rule 10", Grade::Inferred)),
    Rule::new(
        "slack-rate",
        slack_rate,
        Citation::new("sizing facts 2.6, engineering choice; rule 11", Grade::Inferred),
    ),
    Rule::new(
        "slack-rate-rated",
        slack_rate_rated,
        Citation::new("sizing facts 2.6, engineering choice; rule 11", Grade::Inferred),
    ),
    Rule::new(
        "slack-rate-knob",
        slack_rate_knob,
        Citation::new("ribbon line facts, 8, engineering choice; rule 11", Grade::Inferred),
    ),
    Rule::new("tension", stiff_web, Citation::new("sizing facts 2.6, engineering choice; rule 12", Grade::Inferred)),
    Rule::new("pi-drift", pi, Citation::new("sizing facts D21; rule 14", Grade::Inferred)),
    Rule::new("thickness-error", thickness, Citation::new("sizing facts D22; rule 14", Grade::Inferred)),
    Rule::new("start-stop-speed", start_stop, Citation::new("sizing facts, section 4; rule 15", Grade::Inferred)),
    Rule::new("x-resolution", resolution_x, Citation::new("sizing facts 2.5, from memory; rule 17", Grade::Open)),
    Rule::new("y-resolution", resolution_y, Citation::new("sizing facts 2.5, from memory; rule 17", Grade::Open)),
    Rule::new("range-time", range, Citation::new("ribbon line facts, 9; ranges of the control", Grade::Inferred)),
    Rule::new("x-scaling-drift", scaling_x, Citation::new("ribbon line facts, 10", Grade::Inferred)),
    Rule::new("y-scaling-drift", scaling_y, Citation::new("ribbon line facts, 10", Grade::Inferred)),
    Rule::new("length-error", length, Citation::new("ribbon line facts, 6", Grade::Inferred)),
    Rule::new("y-drift", y_drift, Citation::new("sizing facts G1; rule 17", Grade::Inferred)),
];

/// Errors that refuse the export, feeds out of the control's range, and notes for the operator.
pub(super) fn findings(line: &RibbonLine) -> Vec<Diagnostic> {
    let RibbonLine { p, d, .. } = line;
    let limits = &line.control.limits;
    let mut found = Vec::new();
    let print = letter(line);
    for (axis, feed, clamp, field) in
        [("X", d.x_feed, p.clamp_x, "clamp-x"), (print.as_str(), d.y_feed, p.clamp_y, "clamp-y")]
    {
        let feed = followed(line, feed);
        if feed > clamp {
            let message = msg!("ribbon.above-clamp", axis, feed, clamp);
            found.push(Diagnostic::error(message).about(field).hint(slower_advice(line).message));
        }
    }
    if let Some((message, advice)) = too_fast(line) {
        let hints = advice.into_iter().map(|advice| advice.message);
        found.push(hints.fold(Diagnostic::warning(message).about("feed-limit"), Diagnostic::hint));
    }
    if line.in_step() && !p.spindle_encoder {
        found.push(Diagnostic::error(msg!("ribbon.no-encoder")).about("spindle-encoder"));
    }
    if p.spindle_speed > limits.speed_max {
        found.push(
            Diagnostic::error(msg!("ribbon.speed-above-range", (p.spindle_speed, 0), limits.speed_max))
                .about("spindle-speed"),
        );
    }
    if d.vector_feed > 0.0 && d.vector_feed < limits.feed_increment {
        let message = msg!("ribbon.feed-below-increment", (d.vector_feed, 6), limits.feed_increment);
        found.push(Diagnostic::error(message).about("spindle-speed"));
    }
    found.extend(long_blocks(line));
    if !program::overrides_can_be_off(line) {
        found.push(Diagnostic::info(msg!("ribbon.override-acts")));
    }
    if !line.control.macros.common_kept {
        found.push(Diagnostic::info(msg!("form.values-are-lost", program::SETUP)));
    }
    found
}

fn letter(line: &RibbonLine) -> String {
    line.p.print_axis.address().to_string()
}

/// F in mm/min beyond the control's range: the finding, and the remedies.
fn too_fast(line: &RibbonLine) -> Option<(Message, Vec<Advice>)> {
    let RibbonLine { p, d, .. } = line;
    let limits = &line.control.limits;
    let max = line.feed_max();
    if line.in_step() || d.vector_feed <= max {
        return None;
    }
    let mut advice = vec![slower_advice(line)];
    if line.control.can(Code::FeedPerRevolution) && d.feed_per_revolution <= limits.revolution_feed_max {
        let instead = Advice::from(msg!("ribbon.per-revolution-instead", (d.feed_per_revolution, 3)));
        let set = [("feed-form", "per-revolution".to_owned())];
        advice.push(if p.spindle_encoder { instead.setting(msg!("advice.per-revolution"), set) } else { instead });
    }
    Some((msg!("ribbon.feed-above-limit", d.vector_feed, max), advice))
}

/// A block with a word beyond the coordinate range of the control.
fn long_blocks(line: &RibbonLine) -> Option<Diagnostic> {
    let RibbonLine { p, d, .. } = line;
    let limits = &line.control.limits;
    let pitches = p.block_pitches().min(p.count());
    let pull = p.pitch * f64::from(line.pull_words());
    let (axis, pitch) = if d.y_stroke > pull { (letter(line), d.y_stroke) } else { ("X".to_owned(), pull) };
    let max = limits.coordinate_max;
    (pitches * pitch > max).then(|| {
        Diagnostic::error(msg!("ribbon.block-too-long", axis, (pitches * pitch, 3), max))
            .about("pitches-per-block")
            .hint(msg!("ribbon.fewer-pitches", ((max / pitch).floor(), 0)))
    })
}

/// Driven speed over commanded speed, now or at the knob's end: a feed per revolution follows the measured speed of the unwinder.
fn following(line: &RibbonLine, at: &Derived) -> f64 {
    if line.in_step() { 1.0 + at.speed_error } else { 1.0 }
}

/// A feed as it is driven, mm/min.
fn followed(line: &RibbonLine, feed: f64) -> f64 {
    feed * following(line, &line.d)
}

/// The highest whole speed of the unwinder within all limits of rule 4.
fn fastest(line: &RibbonLine) -> f64 {
    (line.fast.actual_speed * share_of_feeds(line)).floor()
}

/// The least limit of axes and F over its feed with the knob at its end: below 1, the line must run slower by as much.
fn share_of_feeds(line: &RibbonLine) -> f64 {
    let RibbonLine { p, fast, .. } = line;
    let driven = following(line, fast);
    let clamps = (p.clamp_x / (fast.x_feed * driven)).min(p.clamp_y / (fast.y_feed * driven));
    if line.in_step() { clamps } else { clamps.min(line.feed_max() / fast.vector_feed) }
}

/// Override (%) up to which the line keeps its speed: until the speed saturates, an axis or F is at its limit, or blocks are over before the
/// control has read the next ones. Feeds per revolution are taken with the motor's error at the knob's end.
pub(super) fn knob_holds(line: &RibbonLine) -> f64 {
    let RibbonLine { p, d, fast, .. } = line;
    if fast.actual_speed <= 0.0 {
        return 0.0;
    }
    if worst_knob(line).is_some() {
        return p.override_stepped();
    }
    let share = share_of_feeds(line).min(fast.block_time / following(line, fast) / d.block_needed);
    (100.0 * fast.actual_speed * share / p.spindle_speed).min(d.override_limit)
}

/// An advice with the S that turns the unwinder at most at `speed` r/min, and the clamp beyond which the knob cannot go.
fn with_speed(line: &RibbonLine, speed: f64, advice: Message) -> Advice {
    let RibbonLine { p, d, fast, .. } = line;
    let mut sets = Vec::new();
    if d.asked_speed > speed {
        sets.push(down(FIELDS, "spindle-speed", 100.0 * speed / p.override_stepped()));
    }
    if fast.actual_speed > speed {
        sets.push(down(FIELDS, "speed-clamp", speed));
    }
    let button = match sets.first() {
        Some((id, typed)) if *id == "spindle-speed" => msg!("advice.set-speed", typed.as_str()),
        Some((_, typed)) => msg!("advice.clamp-speed", typed.as_str()),
        None => return advice.into(),
    };
    Advice::from(advice).setting(button, sets)
}

fn slower_advice(line: &RibbonLine) -> Advice {
    match fastest(line) {
        speed if speed < 1.0 => msg!("ribbon.no-speed").into(),
        speed if line.d.actual_speed > speed => with_speed(line, speed, msg!("ribbon.run-slower", (speed, 0))),
        speed => with_speed(line, speed, msg!("ribbon.knob-too-far", (line.knob_end(), 1), (speed, 0))),
    }
}

/// A feed against the clamp of its axis, over the whole range of the knob: the limit of the feed now is lower by what the knob may add. The
/// driven feed is compared, so the limit of the commanded feed is also lower where the unwinder is fast.
fn within_or_error(feed: f64, clamp: f64, line: &RibbonLine) -> Option<Judgement> {
    let limit = clamp / following(line, &line.fast) * line.knob_share();
    if limit <= 0.0 || limit.is_infinite() {
        return ok(None);
    }
    if feed > limit { fail(AtMost(limit), [slower_advice(line)]) } else { ok(AtMost(limit)) }
}

fn clamp_x(line: &RibbonLine) -> Option<Judgement> {
    within_or_error(line.d.x_feed, line.p.clamp_x, line)
}

fn clamp_y(line: &RibbonLine) -> Option<Judgement> {
    within_or_error(line.d.y_feed, line.p.clamp_y, line)
}

fn feed_limit(line: &RibbonLine) -> Option<Judgement> {
    if line.in_step() {
        return None;
    }
    let limit = AtMost(line.feed_max() * line.knob_share());
    let Some((message, mut advice)) = too_fast(line) else {
        if limit.holds(line.d.vector_feed) {
            return ok(limit);
        }
        let feed = msg!("ribbon.knob-stops", (line.knob_end(), 1), (line.fast.vector_feed, 0), line.feed_max());
        return fail(limit, [feed.into(), slower_advice(line)]);
    };
    let speed = fastest(line);
    let short = with_speed(line, speed, msg!("ribbon.feed-above-range", line.feed_max(), (speed, 0)));
    advice.splice(0..0, (speed >= 1.0).then_some(short).into_iter().chain([message.into()]));
    fail(limit, advice)
}

/// The control reads F per revolution in steps, which makes X run a little faster or slower than the unwinder, and up to a limit.
fn revolution_feed(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { d, .. } = line;
    let limits = &line.control.limits;
    if !line.in_step() {
        return None;
    }
    let (feed, limit, step) = (d.feed_per_revolution, line.feed_max(), limits.feed_increment);
    if feed > limit {
        return fail(AtMost(limit), [msg!("ribbon.revolution-feed-above-limit", (feed, 3), limit).into()]);
    }
    let drift = (1.0 - (feed / step).round() * step / feed) * d.line_speed;
    if drift.abs() > 1.0 {
        return warn(AtMost(limit), [msg!("ribbon.feed-in-steps", step, (drift.abs(), 1)).into()]);
    }
    ok(AtMost(limit))
}

/// Green to the allowed smear, amber to four times it, red beyond.
fn slip(line: &RibbonLine) -> Verdict {
    let RibbonLine { p, d, .. } = line;
    if d.smear <= p.smear_limit {
        Verdict::Ok
    } else if d.smear <= 4.0 * p.smear_limit {
        Verdict::Warn
    } else {
        Verdict::Fail
    }
}

fn ratio(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { p, d, .. } = line;
    let verdict = slip(line);
    let advice = if verdict == Verdict::Ok {
        Vec::new()
    } else {
        let heads = d.matching_heads.round().max(1.0);
        let with_heads = d.matching_heads / heads;
        let smear = web::smear(with_heads, p.contact_length);
        let diameter = |advice: Message| {
            let set = near(FIELDS, "print-roller-diameter", d.matching_diameter);
            Advice::from(advice).setting(msg!("advice.set-diameter", (d.matching_diameter, 2)), [set])
        };
        let count = near(FIELDS, "heads", heads);
        let pitch = near(FIELDS, "pitch", d.matching_pitch);
        vec![
            diameter(msg!("ribbon.slips-short", (d.matching_diameter, 2), (heads, 0))),
            msg!("ribbon.slips", (d.surface_ratio, 3), (d.smear, 3), (p.smear_limit, 3)).into(),
            diameter(msg!("ribbon.match-diameter", (d.matching_diameter, 2), (p.heads, 0))),
            Advice::from(msg!("ribbon.match-heads", (heads, 0), (with_heads, 5), (smear, 3)))
                .setting(msg!("advice.set-heads", heads), [count]),
            Advice::from(msg!("ribbon.match-pitch", (d.matching_pitch, 3)))
                .setting(msg!("advice.set-pitch", pitch.1.as_str()), [pitch]),
            msg!("ribbon.match-cam").into(),
        ]
    };
    Some(Judgement { verdict, limit: Some(Equal(1.0)), advice })
}

fn smear(line: &RibbonLine) -> Option<Judgement> {
    Some(Judgement { verdict: slip(line), limit: Some(AtMost(line.p.smear_limit)), advice: Vec::new() })
}

/// The greatest speed counts over the whole range of the knob, the rated one where the knob is.
fn motor(line: &RibbonLine, speed: f64, rated: f64, max: f64) -> Option<Judgement> {
    let limit = AtMost(max * line.knob_share());
    if !limit.holds(speed) {
        let slower = line.d.actual_speed * rated.min(max) / speed;
        let advice = msg!("ribbon.motor-too-fast", (speed / line.knob_share(), 0), (max, 0));
        fail(limit, [with_speed(line, slower, advice)])
    } else if speed > rated {
        warn(AtMost(rated), [msg!("ribbon.motor-above-rated", (speed, 0), (rated, 0)).into()])
    } else {
        ok(AtMost(rated.min(limit.value())))
    }
}

fn motor_x(line: &RibbonLine) -> Option<Judgement> {
    motor(line, line.d.x_motor_speed, line.p.motor_rated_x, line.p.motor_max_x)
}

fn motor_y(line: &RibbonLine) -> Option<Judgement> {
    motor(line, line.d.y_motor_speed, line.p.motor_rated_y, line.p.motor_max_y)
}

/// Time of a block against the time that the control needs for it, over the whole range of the knob: the limit of a block now is longer by
/// what the knob may take from it. The driven block is compared, so the limit of the commanded one is also longer where the unwinder is fast.
fn block_time(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { p, d, fast, .. } = line;
    let (needed, turned) = (d.block_needed * 1000.0, d.block_needed_turned * 1000.0);
    if d.block_time.is_infinite() {
        return warn(AtLeast(needed), [msg!("ribbon.stands").into()]);
    }
    if line.in_step() && d.speed_error <= -1.0 {
        return fail(None, [msg!("ribbon.stalls").into()]);
    }
    // Exact stops leave the control their time.
    if p.path_mode == PathMode::ExactStop && fast.stop_time * 1000.0 >= needed {
        return ok(None);
    }
    let driven = following(line, fast);
    let lasts = fast.block_time * 1000.0 / driven;
    let here = |needed: f64| AtLeast(needed * driven * d.block_time / fast.block_time);
    let block = d.block_time * 1000.0;
    let steady = here(needed).holds(block);
    if steady && (here(turned).holds(block) || turned.is_infinite()) {
        return ok(here(if turned.is_infinite() { needed } else { turned }));
    }
    let knob = (line.knob_end(), 1);
    let advice = match p.variant {
        Variant::ReadyMade => {
            let wanted = if turned.is_infinite() { needed } else { turned };
            let set = up(FIELDS, "pitches-per-block", p.block_pitches() * wanted / lasts);
            let count = set.1.parse().unwrap_or(p.block_pitches());
            let sentence = match steady {
                true => msg!("ribbon.more-pitches-to-turn", (turned, 1), (lasts, 1), knob, (count, 0)),
                false => msg!("ribbon.more-pitches", (needed, 1), (lasts, 1), knob, (count, 0)),
            };
            Advice::from(sentence).setting(msg!("advice.set-pitches", set.1.as_str()), [set])
        }
        Variant::Published | Variant::Precomputed => {
            let sentence = match steady {
                true => msg!("ribbon.published-to-turn", (turned, 1), (lasts, 1)),
                false => msg!("ribbon.published-too-slow", (needed, 1), (lasts, 1)),
            };
            Advice::from(sentence).setting(msg!("advice.ready-made"), [("variant", "ready-made".to_owned())])
        }
    };
    let mut advice = vec![advice];
    advice.extend(calculated_once(p, |needed| here(needed).holds(block)));
    if steady { warn(here(turned), advice) } else { fail(here(needed), advice) }
}

fn saturation(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { p, d, .. } = line;
    let limit = AtMost(d.top_volts);
    if d.asked_speed > d.top_speed {
        let advice = msg!("ribbon.saturates", (d.asked_speed, 1), (d.top_speed, 1), (d.override_limit, 1));
        return fail(limit, [with_speed(line, d.top_speed, advice)]);
    }
    if p.speed_clamp > p.speed_at_10v {
        return warn(limit, [msg!("ribbon.clamp-above-output", (p.speed_clamp, 1), (p.speed_at_10v, 1)).into()]);
    }
    if d.volts_command < FEW_VOLTS && d.actual_speed > 0.0 {
        return warn(AtLeast(FEW_VOLTS), [msg!("ribbon.few-volts", (d.volts_command, 3)).into()]);
    }
    ok(limit)
}

/// Least voltage (V) at which an inverter's analog input is accurate.
const FEW_VOLTS: f64 = 0.5;

fn slow_motor(line: &RibbonLine) -> Option<Judgement> {
    let d = &line.d;
    if d.frequency < 5.0 && d.actual_speed > 0.0 {
        warn(AtLeast(5.0), [msg!("ribbon.low-frequency", (d.frequency, 2)).into()])
    } else {
        ok(None)
    }
}

/// Both axes with the greater time constant and the lower gain.
fn equal_axes(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { p, d, .. } = line;
    let (slow, soft) = (p.time_constant_x.max(p.time_constant_y), p.position_gain_x.min(p.position_gain_y));
    let mut sets = Vec::new();
    for (id, value, same) in [
        ("time-constant-x", p.time_constant_x, slow),
        ("time-constant-y", p.time_constant_y, slow),
        ("position-gain-x", p.position_gain_x, soft),
        ("position-gain-y", p.position_gain_y, soft),
    ] {
        if value != same {
            sets.push(near(FIELDS, id, same));
        }
    }
    let mut advice = Vec::new();
    let mut say =
        |message: Message| advice.push(Advice::from(message).setting(msg!("advice.make-equal"), sets.clone()));
    if p.time_constant_x != p.time_constant_y {
        say(msg!("ribbon.unequal-time-constants", (p.time_constant_x, 1), letter(line), (p.time_constant_y, 1)));
    }
    if p.position_gain_x != p.position_gain_y {
        say(msg!(
            "ribbon.unequal-gains",
            (p.position_gain_x, 2),
            letter(line),
            (p.position_gain_y, 2),
            (d.register_error, 3)
        ));
    }
    if advice.is_empty() {
        return ok(Equal(0.0));
    }
    // At standstill, and where the differences cancel, there is no error yet.
    fail((d.register_error != 0.0).then_some(Equal(0.0)), advice)
}

/// The dwell that leaves no slack after a start: a longer one lays `v` mm more for each second.
fn matching_dwell(line: &RibbonLine) -> f64 {
    let (d, speed) = (&line.d, line.d.line_speed / 60.0);
    (wait(&line.p, true) - FIN_DELAY - d.slack_start / speed).max(0.0)
}

/// An advice with the entry of a loop that holds `needed` mm, where the form takes one so large.
fn with_loop(advice: Advice, needed: f64, more: Vec<(&'static str, String)>) -> Advice {
    let set = up(FIELDS, "loop-capacity", needed);
    let button = msg!("advice.set-loop", set.1.as_str());
    advice.setting(button, more.into_iter().chain([set]).collect::<Vec<_>>())
}

/// All that a product lays into the loop, with one interruption in it, against what the loop holds.
fn loop_needed(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { p, d, .. } = line;
    let limit = AtMost(p.loop_capacity);
    if d.loop_needed <= p.loop_capacity {
        return ok(limit);
    }
    let sum = msg!(
        "ribbon.loop-too-small",
        (d.loop_needed.ceil(), 0),
        (p.loop_capacity, 0),
        (d.slack_start.abs(), 0),
        (d.slack_run.abs(), 0),
        (d.slack_stop.abs(), 0),
        (d.slack_interruption, 0)
    );
    let mut advice = vec![with_loop(sum.into(), d.loop_needed, Vec::new())];
    // A feed per revolution follows the unwinder from standstill: the best wait is none.
    let dwell = up(FIELDS, "dwell", if line.in_step() { 0.0 } else { matching_dwell(line) });
    let wait = [("wait", "dwell".to_owned()), dwell.clone()];
    let dwelt = Params { wait: Wait::Dwell, dwell: dwell.1.parse().unwrap_or(p.dwell), ..p.clone() };
    let left = Derived::new(&dwelt, line.control.bench.output_bits).loop_needed;
    if left < d.loop_needed {
        let message = msg!("ribbon.matching-dwell", dwell.1.as_str(), (left.ceil(), 0));
        let button = msg!("advice.set-dwell", dwell.1.as_str());
        advice.push(if left <= p.loop_capacity {
            Advice::from(message).setting(button, wait)
        } else {
            with_loop(message.into(), left, wait.into())
        });
    }
    if d.slack_run != 0.0 && !p.dancer {
        advice.push(with_dancer(msg!("ribbon.run-fills", (d.slack_run.abs(), 0))));
    }
    fail(limit, advice)
}

/// Slack rate (mm/min) that an operator can watch and correct by hand: 50. Engineering choice.
const DRIFT: f64 = 50.0;

fn drift(rate: f64, line: &RibbonLine) -> Option<Judgement> {
    let limit = Within(DRIFT);
    if rate.abs() <= DRIFT {
        return ok(limit);
    }
    let RibbonLine { p, d, .. } = line;
    let lasts = p.loop_capacity / rate.abs() * 60.0;
    let fills = if rate > 0.0 {
        msg!("ribbon.loop-fills", (rate, 0), (line.p.loop_capacity, 0), (lasts, 0))
    } else {
        msg!("ribbon.loop-empties", (-rate, 0), (line.p.loop_capacity, 0), (lasts, 0))
    };
    let mut advice = vec![Advice::from(fills)];
    // What exact stops and starved blocks take from X; no dancer brings it back.
    let lost = d.line_speed * (1.0 - d.speed_kept);
    if lost > DRIFT {
        let kept = (d.speed_kept * 100.0, 1);
        advice.push(match p.path_mode {
            PathMode::ExactStop => Advice::from(msg!("ribbon.stops-lose", kept))
                .setting(msg!("advice.continuous"), [("path-mode", "continuous".to_owned())]),
            PathMode::Continuous => starved(line, kept),
        });
    }
    if !p.dancer && (rate - lost).abs() > DRIFT {
        advice.push(with_dancer(msg!("ribbon.trim")));
    }
    fail(limit, advice)
}

/// Advice for blocks that the control reads slower than the axes carry them out; `kept` is the share of the speed that is left, %.
fn starved(line: &RibbonLine, kept: (f64, u8)) -> Advice {
    let RibbonLine { p, d, .. } = line;
    let message = msg!("ribbon.starved", kept);
    let ready = Params { variant: Variant::ReadyMade, ..p.clone() };
    let pitches = ready.pass_needed() * following(line, d) / d.pitch_time;
    let set = up(FIELDS, "pitches-per-block", pitches.max(p.pitches_per_block));
    match p.variant {
        Variant::ReadyMade => Advice::from(message).setting(msg!("advice.set-pitches", set.1.as_str()), [set]),
        Variant::Published | Variant::Precomputed => {
            Advice::from(message).setting(msg!("advice.ready-made"), [("variant", "ready-made".to_owned()), set])
        }
    }
}

fn with_dancer(advice: Message) -> Advice {
    Advice::from(advice).setting(msg!("advice.add-dancer"), [("dancer", "true".to_owned())])
}

fn slack_rate(line: &RibbonLine) -> Option<Judgement> {
    drift(line.d.slack_rate, line)
}

fn slack_rate_rated(line: &RibbonLine) -> Option<Judgement> {
    drift(line.d.slack_rate_rated, line)
}

/// Slack rate (mm/min) with the knob at that end of its range that is worse, where the knob turns the unwinder and the axes stay; else 0:
/// `K · (n_knob - n)`.
pub(super) fn knob_slack(line: &RibbonLine) -> f64 {
    worst_knob(line).map_or(0.0, |(_, _, rate)| rate)
}

/// The worse end of such a knob (%), the speed there (r/min), and the slack rate (mm/min).
fn worst_knob(line: &RibbonLine) -> Option<(f64, f64, f64)> {
    let RibbonLine { p, d, .. } = line;
    if !p.knob_turns_alone() || d.actual_speed <= 0.0 {
        return None;
    }
    let knob = line.dialect.spindle().knob;
    let at = |percent: f64| {
        let rpm = (p.spindle_speed * percent / 100.0).min(d.top_speed);
        (percent, rpm, d.k * (rpm - d.actual_speed))
    };
    let (high, low) = (at(knob.high.min(GREATEST)), at(knob.low));
    Some(if low.2.abs() > high.2.abs() { low } else { high })
}

/// A knob that the axes do not follow fails: lock it, or let the axes follow the measured speed.
fn slack_rate_knob(line: &RibbonLine) -> Option<Judgement> {
    let limit = Within(DRIFT);
    let Some((percent, rpm, rate)) = worst_knob(line).filter(|(_, _, rate)| rate.abs() > DRIFT) else {
        return ok(limit);
    };
    let turns = msg!("ribbon.knob-alone", (percent, 0), (rpm, 1), (rate, 0));
    let lock = [("knob-use", "locked".to_owned())];
    let mut advice = vec![Advice::from(turns).setting(msg!("advice.lock-knob"), lock)];
    if line.control.can(Code::FeedPerRevolution) {
        let follow = msg!("ribbon.follow-measured", (line.d.feed_per_revolution, 3));
        let set = [("feed-form", "per-revolution".to_owned())];
        advice.push(if line.p.spindle_encoder {
            Advice::from(follow).setting(msg!("advice.per-revolution"), set)
        } else {
            follow.into()
        });
    }
    fail(limit, advice)
}

fn stiff_web(line: &RibbonLine) -> Option<Judgement> {
    let d = &line.d;
    let limit = AtMost(d.tension_limit);
    if d.tension > d.tension_limit {
        fail(limit, [with_dancer(msg!("ribbon.stiff-web", (d.tension, 0), (d.tension_limit, 0)))])
    } else {
        ok(limit)
    }
}

fn pi(line: &RibbonLine) -> Option<Judgement> {
    match line.p.pi {
        PiForm::Exact => ok(None),
        PiForm::Short => {
            let advice = msg!("ribbon.pi-short", (line.d.pi_drift, 2), (line.d.pi_drift * 60.0, 0));
            let set = [("pi", "exact".to_owned())];
            warn(Equal(0.0), [Advice::from(advice).setting(msg!("advice.exact-pi"), set)])
        }
    }
}

/// Error of the ribbon's speed (%) that counts as none.
const THICKNESS: f64 = 0.05;

fn thickness(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { p, d, .. } = line;
    let limit = AtMost(THICKNESS);
    if d.thickness_error <= THICKNESS {
        return ok(limit);
    }
    let effective = p.press_roller_diameter + p.ribbon_thickness;
    let set = near(FIELDS, "press-roller-diameter", effective);
    let advice = Advice::from(msg!("ribbon.thickness", (d.thickness_error, 2), (effective, 3)));
    let button = msg!("advice.set-diameter", (effective, 2));
    warn(limit, [advice.setting(button, [set, ("effective-diameter", "true".to_owned())])])
}

/// More than 100 stops per minute; the result itself, the share of the speed that is left, has no limit.
fn start_stop(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { p, d, .. } = line;
    if p.path_mode != PathMode::ExactStop || d.cycles_per_minute <= 100.0 {
        return None;
    }
    let advice = Advice::from(msg!("ribbon.start-stop", (d.cycles_per_minute, 0), (d.start_stop_speed, 0)));
    warn(None, [advice.setting(msg!("advice.continuous"), [("path-mode", "continuous".to_owned())])])
}

fn resolution(micrometres: f64, line: &RibbonLine) -> Option<Judgement> {
    let p = &line.p;
    let limit = p.dot_tolerance * 1000.0 / 10.0;
    if micrometres <= limit {
        return ok(AtMost(limit));
    }
    let set = up(FIELDS, "encoder-resolution", p.encoder_resolution * micrometres / limit);
    let advice = Advice::from(msg!("ribbon.coarse-encoder", (limit, 3)));
    warn(AtMost(limit), [advice.setting(msg!("advice.set-encoder", set.1.as_str()), [set])])
}

fn resolution_x(line: &RibbonLine) -> Option<Judgement> {
    resolution(line.d.x_resolution, line)
}

fn resolution_y(line: &RibbonLine) -> Option<Judgement> {
    resolution(line.d.y_resolution, line)
}

/// The axis whose words leave the control's range first, and its travel per pitch in words; none where the coordinates of both roll over.
fn farthest(line: &RibbonLine) -> Option<(String, f64)> {
    let [pull_rolls, print_rolls] = line.rolls_over();
    let pull = ("X".to_owned(), line.p.pitch * f64::from(line.pull_words()));
    let print = (letter(line), line.d.y_stroke);
    match (pull_rolls, print_rolls) {
        (true, true) => None,
        (true, false) => Some(print),
        (false, true) => Some(pull),
        (false, false) => Some(if print.1 < pull.1 { pull } else { print }),
    }
}

/// Seconds of running from zero to the end of the control's range: `range / (travel per pitch · pitches per second)`; 0 at standstill.
pub(super) fn range_time(line: &RibbonLine) -> f64 {
    let speed = farthest(line).map_or(0.0, |(_, travel)| travel * line.d.dots_per_second);
    match speed > 0.0 {
        true => line.control.limits.coordinate_max / speed,
        false if line.d.dots_per_second > 0.0 => f64::INFINITY,
        false => 0.0,
    }
}

/// Numbers of the parameters that let the coordinates of an axis roll over.
fn roll_parameters(line: &RibbonLine) -> String {
    let roles = [ParamRole::AxisRotary, ParamRole::AxisRollOver, ParamRole::AxisTurn];
    roles.into_iter().filter_map(|role| line.control.param(role)).map(|row| row.number).collect::<Vec<_>>().join(", ")
}

/// Remedies of a line whose axes leave the range: parameters, or the program where the control has no such parameters.
fn endless_axes(line: &RibbonLine, product_fits: bool) -> Vec<Advice> {
    let set = |id: &str| [("endless", id.to_owned())];
    if line.control.param(ParamRole::AxisRollOver).is_some() {
        let advice = Advice::from(msg!("ribbon.range-roll-over", roll_parameters(line)));
        return vec![advice.setting(msg!("advice.roll-over"), set("roll-over"))];
    }
    if product_fits && line.p.endless != Endless::Shift && line.control.can(Code::SetCoordinates) {
        return vec![Advice::from(msg!("ribbon.range-shift")).setting(msg!("advice.shift"), set("shift"))];
    }
    Vec::new()
}

/// Both axes run one way for ever: the control stops with an alarm where one leaves its range. A product beyond it fails; else the coordinates
/// have to be taken back in time.
fn range(line: &RibbonLine) -> Option<Judgement> {
    let max = line.control.limits.coordinate_max;
    let Some((axis, travel)) = farthest(line) else {
        let advice = msg!("ribbon.range-endless", roll_parameters(line), max);
        return Some(Judgement { verdict: Verdict::Ok, limit: None, advice: vec![advice.into()] });
    };
    let with = |advice: Message, fits: bool| [vec![advice.into()], endless_axes(line, fits)].concat();
    let products = (max / (travel * line.p.count())).floor();
    if products < 1.0 {
        let advice = msg!("ribbon.range-product", axis, max, ((max / travel).floor(), 0));
        return fail(None, with(advice, false));
    }
    let seconds = (range_time(line), 0);
    if line.p.endless == Endless::Shift && line.dialect.running.range != Some(CoordinateFrame::Machine) {
        let advice = msg!("ribbon.range-shifted", axis, max, seconds, (products, 0));
        return Some(Judgement { verdict: Verdict::None, limit: None, advice: vec![advice.into()] });
    }
    warn(None, with(msg!("ribbon.range-open", axis, max, seconds, (products, 0)), true))
}

/// Drift (mm/h or °/h) of the pull axis and of the print roller against their motors: what is left of the ratio when parameters have taken it as
/// whole numbers; none where the control has no such numbers.
pub(super) fn scaling_drifts(line: &RibbonLine) -> [Option<f64>; 2] {
    let feeds = [line.d.x_feed, line.d.y_feed];
    let drives = line.drives("");
    [0, 1].map(|at| Some(drives[at].error(line.control)? * feeds[at] * 60.0))
}

/// The dots of a product may drift by the tolerance of a dot.
fn scaling(line: &RibbonLine, at: usize) -> Option<Judgement> {
    let RibbonLine { p, d, .. } = line;
    if !AxisDrive::is_scaled(line.control) {
        return None;
    }
    let axis = if at == 0 { "X".to_owned() } else { letter(line) };
    let Some(drift) = scaling_drifts(line)[at] else {
        return fail(None, [msg!("scaling.no-ratio", axis).into()]);
    };
    let per_turn = if at == 1 && line.degrees() { 360.0 / (PI * p.print_roller_diameter) } else { 1.0 };
    let limit = p.dot_tolerance * per_turn * 3600.0 / d.product_time;
    if drift.abs() <= limit {
        return ok(AtMost(limit));
    }
    let mut advice = Advice::from(msg!("ribbon.scaling-drifts", axis, (drift, 4), (limit, 4)));
    if at == 1 && !line.degrees() && p.print_axis == PrintAxis::Y {
        advice = advice.setting(msg!("advice.degrees"), [("y-unit", "degrees".to_owned())]);
    }
    warn(AtMost(limit), [advice])
}

fn scaling_x(line: &RibbonLine) -> Option<Judgement> {
    scaling(line, 0)
}

fn scaling_y(line: &RibbonLine) -> Option<Judgement> {
    scaling(line, 1)
}

/// A wanted length against what the program makes of it by the rule for its rest.
fn length(line: &RibbonLine) -> Option<Judgement> {
    let p = &line.p;
    if !p.is_length(line.control) {
        return None;
    }
    let tolerance = if p.rest == Rest::Alarm { 0.001 } else { p.dot_tolerance };
    let limit = Within(tolerance);
    let whole = near(FIELDS, "product-length", p.count() * p.pitch);
    let whole_length =
        |advice: Message| Advice::from(advice).setting(msg!("advice.set-length", whole.1.as_str()), [whole.clone()]);
    if p.pitches_of_length() < 1.0 {
        return fail(None, [whole_length(msg!("ribbon.length-below-pitch"))]);
    }
    if p.length_error().abs() <= tolerance {
        return ok(limit);
    }
    let advice = whole_length(msg!("ribbon.length-rest", (p.length_error(), 3), (p.count(), 0)));
    let shorter =
        Advice::from(msg!("ribbon.length-shorten")).setting(msg!("advice.shorten"), [("rest", "shorten".to_owned())]);
    match p.rest {
        Rest::Alarm => fail(limit, [advice, shorter]),
        Rest::Round | Rest::Shorten => warn(limit, [advice, shorter]),
    }
}

fn y_drift(line: &RibbonLine) -> Option<Judgement> {
    let unit = if line.degrees() { "°" } else { "mm" };
    let advice = msg!("ribbon.y-carried", letter(line), (line.d.y_drift, 3), unit);
    Some(Judgement { verdict: Verdict::None, limit: None, advice: vec![advice.into()] })
}

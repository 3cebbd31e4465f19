//! The rules of the ribbon line, as rows: result, limit, remedy.
//!
//! Numbers are those of section 7 of `docs/reference/sizing.md`. Rule 1 is the ranges of the form, rule 18 the list of assumed facts; both are
//! kept for every machine. Of rule 4 a clamp is an error (the control slows the vector); an F beyond the control's range is a verdict,
//! as the text is read all the same and stops by itself before anything moves. All others are verdicts.

use super::params::{PathMode, PiForm, Variant, Wait};
use super::program;
use super::resolved::RibbonLine;
use crate::controls::Code;
use crate::drives::web;
use crate::machines::verdict::{Judgement, Rule, fail, ok, warn};
use crate::msg;
use crate::text::{Citation, Diagnostic, Grade, Message};
use crate::view::Verdict;

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
    Rule::new("slack-start", slack_start, Citation::new("sizing facts 2.6; rule 10", Grade::Inferred)),
    Rule::new("slack-stop", slack_stop, Citation::new("sizing facts 2.6; rule 10", Grade::Inferred)),
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
    Rule::new("tension", stiff_web, Citation::new("sizing facts 2.6, engineering choice; rule 12", Grade::Inferred)),
    Rule::new("pi-drift", pi, Citation::new("sizing facts D21; rule 14", Grade::Inferred)),
    Rule::new("thickness-error", thickness, Citation::new("sizing facts D22; rule 14", Grade::Inferred)),
    Rule::new("start-stop-speed", start_stop, Citation::new("sizing facts, section 4; rule 15", Grade::Inferred)),
    Rule::new("x-resolution", resolution_x, Citation::new("sizing facts 2.5, from memory; rule 17", Grade::Open)),
    Rule::new("y-resolution", resolution_y, Citation::new("sizing facts 2.5, from memory; rule 17", Grade::Open)),
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
            found.push(Diagnostic::error(message).about(field).hint(slower_advice(line)));
        }
    }
    if let Some((message, advice)) = too_fast(line) {
        found.push(advice.into_iter().fold(Diagnostic::warning(message).about("feed-limit"), Diagnostic::hint));
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
fn too_fast(line: &RibbonLine) -> Option<(Message, Vec<Message>)> {
    let RibbonLine { d, .. } = line;
    let limits = &line.control.limits;
    let max = line.feed_max();
    if line.in_step() || d.vector_feed <= max {
        return None;
    }
    let mut advice = vec![slower_advice(line)];
    if line.control.can(Code::FeedPerRevolution) && d.feed_per_revolution <= limits.revolution_feed_max {
        advice.push(msg!("ribbon.per-revolution-instead", (d.feed_per_revolution, 3)));
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

/// A feed as it is driven, mm/min: a feed per revolution follows the measured speed of the unwinder.
fn followed(line: &RibbonLine, feed: f64) -> f64 {
    if line.in_step() { feed * (1.0 + line.d.speed_error) } else { feed }
}

/// The highest whole S within all limits of rule 4.
fn fastest(line: &RibbonLine) -> f64 {
    let RibbonLine { p, d, .. } = line;
    let clamps = (p.clamp_x / followed(line, d.x_feed)).min(p.clamp_y / followed(line, d.y_feed));
    let share = if line.in_step() { clamps } else { clamps.min(line.feed_max() / d.vector_feed) };
    (d.actual_speed * share).floor()
}

fn slower_advice(line: &RibbonLine) -> Message {
    match fastest(line) {
        speed if speed >= 1.0 => msg!("ribbon.run-slower", (speed, 0)),
        _ => msg!("ribbon.no-speed"),
    }
}

fn within_or_error(value: f64, limit: f64, line: &RibbonLine) -> Option<Judgement> {
    if value > limit { fail(limit, [slower_advice(line)]) } else { ok(limit) }
}

fn clamp_x(line: &RibbonLine) -> Option<Judgement> {
    within_or_error(followed(line, line.d.x_feed), line.p.clamp_x, line)
}

fn clamp_y(line: &RibbonLine) -> Option<Judgement> {
    within_or_error(followed(line, line.d.y_feed), line.p.clamp_y, line)
}

fn feed_limit(line: &RibbonLine) -> Option<Judgement> {
    let limit = (!line.in_step()).then(|| line.feed_max());
    match too_fast(line) {
        Some((message, mut advice)) => {
            let short = msg!("ribbon.feed-above-range", line.feed_max(), (fastest(line), 0));
            advice.splice(0..0, (fastest(line) >= 1.0).then_some(short).into_iter().chain([message]));
            fail(limit, advice)
        }
        None => limit.and_then(ok),
    }
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
        return fail(limit, [msg!("ribbon.revolution-feed-above-limit", (feed, 3), limit)]);
    }
    let drift = (1.0 - (feed / step).round() * step / feed) * d.line_speed;
    if drift.abs() > 1.0 {
        return warn(limit, [msg!("ribbon.feed-in-steps", step, (drift.abs(), 1))]);
    }
    ok(limit)
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
        vec![
            msg!("ribbon.slips-short", (d.matching_diameter, 2), (heads, 0)),
            msg!("ribbon.slips", (d.surface_ratio, 3), (d.smear, 3), (p.smear_limit, 3)),
            msg!("ribbon.match-diameter", (d.matching_diameter, 2), (p.heads, 0)),
            msg!("ribbon.match-heads", (heads, 0), (with_heads, 5), (web::smear(with_heads, p.contact_length), 3)),
            msg!("ribbon.match-pitch", (d.matching_pitch, 3)),
            msg!("ribbon.match-cam"),
        ]
    };
    Some(Judgement { verdict, limit: Some(1.0), advice })
}

fn smear(line: &RibbonLine) -> Option<Judgement> {
    Some(Judgement { verdict: slip(line), limit: Some(line.p.smear_limit), advice: Vec::new() })
}

fn motor(speed: f64, rated: f64, max: f64) -> Option<Judgement> {
    if speed > max {
        fail(max, [msg!("ribbon.motor-too-fast", (speed, 0), (max, 0))])
    } else if speed > rated {
        warn(rated, [msg!("ribbon.motor-above-rated", (speed, 0), (rated, 0))])
    } else {
        ok(rated.min(max))
    }
}

fn motor_x(line: &RibbonLine) -> Option<Judgement> {
    motor(line.d.x_motor_speed, line.p.motor_rated_x, line.p.motor_max_x)
}

fn motor_y(line: &RibbonLine) -> Option<Judgement> {
    motor(line.d.y_motor_speed, line.p.motor_rated_y, line.p.motor_max_y)
}

fn block_time(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { p, d, .. } = line;
    let needed = d.block_needed * 1000.0;
    if d.block_time.is_infinite() {
        return warn(needed, [msg!("ribbon.stands")]);
    }
    if line.in_step() && d.speed_error <= -1.0 {
        return fail(needed, [msg!("ribbon.stalls")]);
    }
    let lasts = d.block_time * d.line_speed / followed(line, d.line_speed);
    if lasts >= d.block_needed {
        return ok(needed);
    }
    let advice = match p.variant {
        Variant::ReadyMade => {
            msg!("ribbon.more-pitches", (needed, 1), (lasts * 1000.0, 1), (d.blocks_for_control, 0))
        }
        Variant::Published => msg!("ribbon.published-too-slow", (needed, 1), (lasts * 1000.0, 1)),
    };
    fail(needed, [advice])
}

fn saturation(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { p, d, .. } = line;
    let limit = 10.0 * d.top_speed / p.speed_at_10v;
    if d.asked_speed > d.top_speed {
        return fail(limit, [msg!("ribbon.saturates", (d.asked_speed, 1), (d.top_speed, 1), (d.override_limit, 1))]);
    }
    if p.speed_clamp > p.speed_at_10v {
        return warn(limit, [msg!("ribbon.clamp-above-output", (p.speed_clamp, 1), (p.speed_at_10v, 1))]);
    }
    if d.volts_command < 0.5 && d.actual_speed > 0.0 {
        return warn(limit, [msg!("ribbon.few-volts", (d.volts_command, 3))]);
    }
    ok(limit)
}

fn slow_motor(line: &RibbonLine) -> Option<Judgement> {
    let d = &line.d;
    if d.frequency < 5.0 && d.actual_speed > 0.0 {
        warn(5.0, [msg!("ribbon.low-frequency", (d.frequency, 2))])
    } else {
        ok(None)
    }
}

fn equal_axes(line: &RibbonLine) -> Option<Judgement> {
    let p = &line.p;
    let mut advice = Vec::new();
    if p.time_constant_x != p.time_constant_y {
        advice.push(msg!(
            "ribbon.unequal-time-constants",
            (p.time_constant_x, 1),
            letter(line),
            (p.time_constant_y, 1)
        ));
    }
    if p.position_gain_x != p.position_gain_y {
        advice.push(msg!(
            "ribbon.unequal-gains",
            (p.position_gain_x, 2),
            letter(line),
            (p.position_gain_y, 2),
            (line.d.register_error, 3)
        ));
    }
    if advice.is_empty() { ok(0.0) } else { fail(0.0, advice) }
}

/// Slack of a start or stop against the capacity of the loop.
fn loop_length(slack: f64, line: &RibbonLine, advice: Message) -> Option<Judgement> {
    let capacity = line.p.loop_capacity;
    if slack.abs() > capacity {
        fail(capacity, [advice])
    } else if slack.abs() > 0.1 * capacity {
        warn(capacity, [advice])
    } else {
        ok(capacity)
    }
}

fn slack_start(line: &RibbonLine) -> Option<Judgement> {
    let slack = line.d.slack_start;
    let advice = if slack < 0.0 {
        msg!("ribbon.tight-at-start", (-slack, 0), (line.p.loop_capacity, 0))
    } else if line.in_step() && (line.p.wait == Wait::Fin || line.p.dwell > 0.0) {
        msg!("ribbon.slack-of-the-wait", (slack, 0), (line.p.loop_capacity, 0))
    } else {
        msg!("ribbon.slack-at-start", (slack, 0), (line.p.loop_capacity, 0))
    };
    loop_length(slack, line, advice)
}

fn slack_stop(line: &RibbonLine) -> Option<Judgement> {
    let slack = line.d.slack_stop;
    loop_length(slack, line, msg!("ribbon.slack-at-stop", (slack, 0), (line.p.loop_capacity, 0)))
}

/// Slack rate (mm/min) that an operator can watch and correct by hand: 50. Engineering choice.
const DRIFT: f64 = 50.0;

fn drift(rate: f64, line: &RibbonLine) -> Option<Judgement> {
    if rate.abs() <= DRIFT {
        return ok(DRIFT);
    }
    let lasts = line.p.loop_capacity / rate.abs() * 60.0;
    let advice = if rate > 0.0 {
        msg!("ribbon.loop-fills", (rate, 0), (line.p.loop_capacity, 0), (lasts, 0))
    } else {
        msg!("ribbon.loop-empties", (-rate, 0), (line.p.loop_capacity, 0), (lasts, 0))
    };
    fail(DRIFT, [advice, msg!("ribbon.trim")])
}

fn slack_rate(line: &RibbonLine) -> Option<Judgement> {
    drift(line.d.slack_rate, line)
}

fn slack_rate_rated(line: &RibbonLine) -> Option<Judgement> {
    drift(line.d.slack_rate_rated, line)
}

fn stiff_web(line: &RibbonLine) -> Option<Judgement> {
    let d = &line.d;
    if d.tension > d.tension_limit {
        fail(d.tension_limit, [msg!("ribbon.stiff-web", (d.tension, 0), (d.tension_limit, 0))])
    } else {
        ok(d.tension_limit)
    }
}

fn pi(line: &RibbonLine) -> Option<Judgement> {
    match line.p.pi {
        PiForm::Exact => ok(None),
        PiForm::Short => warn(0.0, [msg!("ribbon.pi-short", (line.d.pi_drift, 2), (line.d.pi_drift * 60.0, 0))]),
    }
}

fn thickness(line: &RibbonLine) -> Option<Judgement> {
    if line.d.thickness_error > 0.05 {
        let p = &line.p;
        warn(
            0.05,
            [msg!("ribbon.thickness", (line.d.thickness_error, 2), (p.press_roller_diameter + p.ribbon_thickness, 3))],
        )
    } else {
        ok(0.05)
    }
}

fn start_stop(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { p, d, .. } = line;
    (p.path_mode == PathMode::ExactStop && d.cycles_per_minute > 100.0)
        .then(|| warn(100.0, [msg!("ribbon.start-stop", (d.cycles_per_minute, 0), (d.start_stop_speed, 0))]))
        .flatten()
}

fn resolution(micrometres: f64, line: &RibbonLine) -> Option<Judgement> {
    let limit = line.p.dot_tolerance * 1000.0 / 10.0;
    if micrometres > limit { warn(limit, [msg!("ribbon.coarse-encoder", (limit, 3))]) } else { ok(limit) }
}

fn resolution_x(line: &RibbonLine) -> Option<Judgement> {
    resolution(line.d.x_resolution, line)
}

fn resolution_y(line: &RibbonLine) -> Option<Judgement> {
    resolution(line.d.y_resolution, line)
}

fn y_drift(line: &RibbonLine) -> Option<Judgement> {
    let unit = if line.degrees() { "°" } else { "mm" };
    let advice = msg!("ribbon.y-carried", letter(line), (line.d.y_drift, 3), unit);
    Some(Judgement { verdict: Verdict::None, limit: None, advice: vec![advice] })
}

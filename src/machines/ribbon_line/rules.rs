//! The rules a ribbon line is judged by, as rows: which result, which limit, what would mend it.
//!
//! Numbers are those of section 7 of `docs/reference/sizing.md`. Rule 1 is the ranges of the form, rule 18 the list of assumed facts; both are
//! kept for every machine. Of rule 4 a clamp is an error (the control slows the vector); an F beyond the control's range is a verdict,
//! as the text is read all the same and stops by itself before anything moves. All others are verdicts.

use super::Line;
use super::derive::Derived;
use super::params::{Params, PathMode, PiForm, Variant, Wait};
use super::program;
use super::resolved::Resolved;
use crate::controls::{Code, Limits};
use crate::drives::web;
use crate::machines::verdict::{Judgement, Rule, fail, ok, rule, warn};
use crate::msg;
use crate::text::{Diagnostic, Message};
use crate::view::Verdict;

/// Inputs, what follows from them, and what the control takes.
pub(super) struct Case<'a> {
    pub(super) line: &'a Resolved<'a>,
    pub(super) p: &'a Params,
    pub(super) d: &'a Derived,
    pub(super) limits: &'a Limits,
}

/// All rules that judge a result.
pub(super) const RULES: &[Rule<Line>] = &[
    rule!("surface-ratio", ratio, "sizing facts 3.2 and 3.4, engineering choice; rule 2", Inferred),
    rule!("smear", smear, "sizing facts 3.2 and 3.4, engineering choice; rule 2", Inferred),
    rule!("x-motor-speed", motor_x, "data sheet of the motor; rule 3", Manual),
    rule!("y-motor-speed", motor_y, "data sheet of the motor; rule 3", Manual),
    rule!("line-speed", clamp_x, "cutting feed clamp, a parameter; rule 4", Sister),
    rule!("x-feed", clamp_x, "cutting feed clamp, a parameter; rule 4", Sister),
    rule!("y-feed", clamp_y, "cutting feed clamp, a parameter; rule 4", Sister),
    rule!("vector-feed", feed_limit, "ranges of the control; rule 4", Open),
    rule!("feed-per-revolution", revolution_feed, "ranges of the control; rule 4", Open),
    rule!("block-time", block_time, "sizing facts, section 4, times from memory; rule 5", Open),
    rule!("volts", saturation, "ribbon line facts, 4; rule 6", Inferred),
    rule!("frequency", slow_motor, "trade source; rule 7", Inferred),
    rule!("register-error", equal_axes, "sizing facts 0.6; rule 9", Inferred),
    rule!("slack-start", slack_start, "sizing facts 2.6; rule 10", Inferred),
    rule!("slack-stop", slack_stop, "sizing facts 2.6; rule 10", Inferred),
    rule!("slack-rate", slack_rate, "sizing facts 2.6, engineering choice; rule 11", Inferred),
    rule!("slack-rate-rated", slack_rate_rated, "sizing facts 2.6, engineering choice; rule 11", Inferred),
    rule!("tension", stiff_web, "sizing facts 2.6, engineering choice; rule 12", Inferred),
    rule!("pi-drift", pi, "sizing facts D21; rule 14", Inferred),
    rule!("thickness-error", thickness, "sizing facts D22; rule 14", Inferred),
    rule!("start-stop-speed", start_stop, "sizing facts, section 4; rule 15", Inferred),
    rule!("x-resolution", resolution_x, "sizing facts 2.5, from memory; rule 17", Open),
    rule!("y-resolution", resolution_y, "sizing facts 2.5, from memory; rule 17", Open),
    rule!("y-drift", y_drift, "sizing facts G1; rule 17", Inferred),
];

/// Errors that keep the program from being exported, a feed that the control does not take, and what the operator has to know.
pub(super) fn findings(case: &Case) -> Vec<Diagnostic> {
    let Case { line, p, d, limits } = case;
    let mut found = Vec::new();
    let print = letter(case);
    for (axis, feed, clamp, field) in
        [("X", d.x_feed, p.clamp_x, "clamp-x"), (print.as_str(), d.y_feed, p.clamp_y, "clamp-y")]
    {
        let feed = followed(case, feed);
        if feed > clamp {
            let message = msg!("ribbon.above-clamp", axis, feed, clamp);
            found.push(Diagnostic::error(message).about(field).hint(slower_advice(case)));
        }
    }
    if let Some((message, advice)) = too_fast(case) {
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
    found.extend(long_blocks(case));
    if !program::overrides_can_be_off(line) {
        found.push(Diagnostic::info(msg!("ribbon.override-acts")));
    }
    if !line.control.macros.common_kept {
        found.push(Diagnostic::info(msg!("form.values-are-lost", program::SETUP)));
    }
    found
}

fn letter(case: &Case) -> String {
    (case.p.print_axis.letter() as char).to_string()
}

/// F in mm/min beyond the control's range: what is too fast, and the ways out.
fn too_fast(case: &Case) -> Option<(Message, Vec<Message>)> {
    let Case { line, d, limits, .. } = case;
    let max = line.feed_max();
    if line.in_step() || d.vector_feed <= max {
        return None;
    }
    let mut advice = vec![slower_advice(case)];
    if line.control.can(Code::FeedPerRevolution) && d.feed_per_revolution <= limits.revolution_feed_max {
        advice.push(msg!("ribbon.per-revolution-instead", (d.feed_per_revolution, 3)));
    }
    Some((msg!("ribbon.feed-above-limit", d.vector_feed, max), advice))
}

/// A block whose longest word is beyond what the control reads.
fn long_blocks(case: &Case) -> Option<Diagnostic> {
    let Case { line, p, d, limits } = case;
    let pitches = p.block_pitches().min(p.count());
    let pull = p.pitch * f64::from(line.pull_words());
    let (axis, pitch) = if d.y_stroke > pull { (letter(case), d.y_stroke) } else { ("X".to_owned(), pull) };
    let max = limits.coordinate_max;
    (pitches * pitch > max).then(|| {
        Diagnostic::error(msg!("ribbon.block-too-long", axis, (pitches * pitch, 3), max))
            .about("pitches-per-block")
            .hint(msg!("ribbon.fewer-pitches", ((max / pitch).floor(), 0)))
    })
}

/// A feed as it is driven: in step with the unwinder it follows what that truly turns.
fn followed(case: &Case, feed: f64) -> f64 {
    if case.line.in_step() { feed * (1.0 + case.d.speed_error) } else { feed }
}

/// The highest whole S that keeps all of rule 4.
fn fastest(case: &Case) -> f64 {
    let Case { line, p, d, .. } = case;
    let clamps = (p.clamp_x / followed(case, d.x_feed)).min(p.clamp_y / followed(case, d.y_feed));
    let share = if line.in_step() { clamps } else { clamps.min(line.feed_max() / d.vector_feed) };
    (d.actual_speed * share).floor()
}

fn slower_advice(case: &Case) -> Message {
    match fastest(case) {
        speed if speed >= 1.0 => msg!("ribbon.run-slower", (speed, 0)),
        _ => msg!("ribbon.no-speed"),
    }
}

fn within_or_error(value: f64, limit: f64, case: &Case) -> Option<Judgement> {
    if value > limit { fail(limit, [slower_advice(case)]) } else { ok(limit) }
}

fn clamp_x(case: &Case) -> Option<Judgement> {
    within_or_error(followed(case, case.d.x_feed), case.p.clamp_x, case)
}

fn clamp_y(case: &Case) -> Option<Judgement> {
    within_or_error(followed(case, case.d.y_feed), case.p.clamp_y, case)
}

fn feed_limit(case: &Case) -> Option<Judgement> {
    let limit = (!case.line.in_step()).then(|| case.line.feed_max());
    match too_fast(case) {
        Some((message, mut advice)) => {
            let short = msg!("ribbon.feed-above-range", case.line.feed_max(), (fastest(case), 0));
            advice.splice(0..0, (fastest(case) >= 1.0).then_some(short).into_iter().chain([message]));
            fail(limit, advice)
        }
        None => limit.and_then(ok),
    }
}

/// The control reads F per revolution in steps, which makes X run a little faster or slower than the unwinder, and up to a limit.
fn revolution_feed(case: &Case) -> Option<Judgement> {
    let Case { line, d, limits, .. } = case;
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
fn slip(case: &Case) -> Verdict {
    let Case { p, d, .. } = case;
    if d.smear <= p.smear_limit {
        Verdict::Ok
    } else if d.smear <= 4.0 * p.smear_limit {
        Verdict::Warn
    } else {
        Verdict::Fail
    }
}

fn ratio(case: &Case) -> Option<Judgement> {
    let Case { p, d, .. } = case;
    let verdict = slip(case);
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

fn smear(case: &Case) -> Option<Judgement> {
    Some(Judgement { verdict: slip(case), limit: Some(case.p.smear_limit), advice: Vec::new() })
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

fn motor_x(case: &Case) -> Option<Judgement> {
    motor(case.d.x_motor_speed, case.p.motor_rated_x, case.p.motor_max_x)
}

fn motor_y(case: &Case) -> Option<Judgement> {
    motor(case.d.y_motor_speed, case.p.motor_rated_y, case.p.motor_max_y)
}

fn block_time(case: &Case) -> Option<Judgement> {
    let Case { p, d, .. } = case;
    let needed = d.block_needed * 1000.0;
    if d.block_time.is_infinite() {
        return warn(needed, [msg!("ribbon.stands")]);
    }
    if case.line.in_step() && d.speed_error <= -1.0 {
        return fail(needed, [msg!("ribbon.stalls")]);
    }
    let lasts = d.block_time * d.line_speed / followed(case, d.line_speed);
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

fn saturation(case: &Case) -> Option<Judgement> {
    let Case { p, d, .. } = case;
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

fn slow_motor(case: &Case) -> Option<Judgement> {
    let d = case.d;
    if d.frequency < 5.0 && d.actual_speed > 0.0 {
        warn(5.0, [msg!("ribbon.low-frequency", (d.frequency, 2))])
    } else {
        ok(None)
    }
}

fn equal_axes(case: &Case) -> Option<Judgement> {
    let p = case.p;
    let mut advice = Vec::new();
    if p.time_constant_x != p.time_constant_y {
        advice.push(msg!(
            "ribbon.unequal-time-constants",
            (p.time_constant_x, 1),
            letter(case),
            (p.time_constant_y, 1)
        ));
    }
    if p.position_gain_x != p.position_gain_y {
        advice.push(msg!(
            "ribbon.unequal-gains",
            (p.position_gain_x, 2),
            letter(case),
            (p.position_gain_y, 2),
            (case.d.register_error, 3)
        ));
    }
    if advice.is_empty() { ok(0.0) } else { fail(0.0, advice) }
}

/// Length that a start or stop lays down or takes, against the loop.
fn loop_length(slack: f64, case: &Case, advice: Message) -> Option<Judgement> {
    let capacity = case.p.loop_capacity;
    if slack.abs() > capacity {
        fail(capacity, [advice])
    } else if slack.abs() > 0.1 * capacity {
        warn(capacity, [advice])
    } else {
        ok(capacity)
    }
}

fn slack_start(case: &Case) -> Option<Judgement> {
    let slack = case.d.slack_start;
    let advice = if slack < 0.0 {
        msg!("ribbon.tight-at-start", (-slack, 0), (case.p.loop_capacity, 0))
    } else if case.line.in_step() && (case.p.wait == Wait::Fin || case.p.dwell > 0.0) {
        msg!("ribbon.slack-of-the-wait", (slack, 0), (case.p.loop_capacity, 0))
    } else {
        msg!("ribbon.slack-at-start", (slack, 0), (case.p.loop_capacity, 0))
    };
    loop_length(slack, case, advice)
}

fn slack_stop(case: &Case) -> Option<Judgement> {
    let slack = case.d.slack_stop;
    loop_length(slack, case, msg!("ribbon.slack-at-stop", (slack, 0), (case.p.loop_capacity, 0)))
}

/// 50 mm/min is what somebody can watch and correct by hand.
const DRIFT: f64 = 50.0;

fn drift(rate: f64, case: &Case) -> Option<Judgement> {
    if rate.abs() <= DRIFT {
        return ok(DRIFT);
    }
    let lasts = case.p.loop_capacity / rate.abs() * 60.0;
    let advice = if rate > 0.0 {
        msg!("ribbon.loop-fills", (rate, 0), (case.p.loop_capacity, 0), (lasts, 0))
    } else {
        msg!("ribbon.loop-empties", (-rate, 0), (case.p.loop_capacity, 0), (lasts, 0))
    };
    fail(DRIFT, [advice, msg!("ribbon.trim")])
}

fn slack_rate(case: &Case) -> Option<Judgement> {
    drift(case.d.slack_rate, case)
}

fn slack_rate_rated(case: &Case) -> Option<Judgement> {
    drift(case.d.slack_rate_rated, case)
}

fn stiff_web(case: &Case) -> Option<Judgement> {
    let d = case.d;
    if d.tension > d.tension_limit {
        fail(d.tension_limit, [msg!("ribbon.stiff-web", (d.tension, 0), (d.tension_limit, 0))])
    } else {
        ok(d.tension_limit)
    }
}

fn pi(case: &Case) -> Option<Judgement> {
    match case.p.pi {
        PiForm::Exact => ok(None),
        PiForm::Short => warn(0.0, [msg!("ribbon.pi-short", (case.d.pi_drift, 2), (case.d.pi_drift * 60.0, 0))]),
    }
}

fn thickness(case: &Case) -> Option<Judgement> {
    if case.d.thickness_error > 0.05 {
        let p = case.p;
        warn(
            0.05,
            [msg!("ribbon.thickness", (case.d.thickness_error, 2), (p.press_roller_diameter + p.ribbon_thickness, 3))],
        )
    } else {
        ok(0.05)
    }
}

fn start_stop(case: &Case) -> Option<Judgement> {
    let Case { p, d, .. } = case;
    (p.path_mode == PathMode::ExactStop && d.cycles_per_minute > 100.0)
        .then(|| warn(100.0, [msg!("ribbon.start-stop", (d.cycles_per_minute, 0), (d.start_stop_speed, 0))]))
        .flatten()
}

fn resolution(micrometres: f64, case: &Case) -> Option<Judgement> {
    let limit = case.p.dot_tolerance * 1000.0 / 10.0;
    if micrometres > limit { warn(limit, [msg!("ribbon.coarse-encoder", (limit, 3))]) } else { ok(limit) }
}

fn resolution_x(case: &Case) -> Option<Judgement> {
    resolution(case.d.x_resolution, case)
}

fn resolution_y(case: &Case) -> Option<Judgement> {
    resolution(case.d.y_resolution, case)
}

fn y_drift(case: &Case) -> Option<Judgement> {
    let unit = if case.line.degrees() { "°" } else { "mm" };
    let advice = msg!("ribbon.y-carried", letter(case), (case.d.y_drift, 3), unit);
    Some(Judgement { verdict: Verdict::None, limit: None, advice: vec![advice] })
}

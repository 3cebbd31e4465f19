//! Rules about speeds: clamps of the axes, the range of F, motors, the time of a block, the analog output.

use super::drives::here;
use super::slack::{with_dancer, worst_knob};
use crate::controls::Code;
use crate::drives::analog::FEW_VOLTS;
use crate::drives::induction::Induction;
use crate::machines::form::entry::{at_least, at_most};
use crate::machines::ribbon_line::axes::LineAxis;
use crate::machines::ribbon_line::params::{AXIS_FIELDS, FIELDS, Params, PathMode, ServoParams, Variant};
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::msg;
use crate::text::Message;
use crate::view::Advice;
use crate::view::Limit::{AtLeast, AtMost};

/// F in mm/min beyond the control's range: the finding, and the remedies.
pub(in crate::machines::ribbon_line) fn too_fast(line: &RibbonLine) -> Option<(Message, Vec<Advice>)> {
    let RibbonLine { params: p, derived: d, .. } = line;
    let limits = &line.control.limits;
    let max = line.feed_max();
    if line.feeds_per_revolution() || d.feeds.vector_feed <= max {
        return None;
    }
    let mut advice = vec![slower_advice(line)];
    if line.control.can(Code::FeedPerRevolution) && d.feeds.per_revolution <= limits.revolution_feed_max {
        let instead = Advice::from(msg!("ribbon.per-revolution-instead", feed = (d.feeds.per_revolution, 3)));
        let set = [("feed-form", "per-revolution")];
        advice.push(if p.spindle_encoder { instead.setting(msg!("advice.per-revolution"), set) } else { instead });
    }
    Some((msg!("ribbon.feed-above-limit", feed = d.feeds.vector_feed, most = max), advice))
}

/// Driven feed of a commanded one, mm/min.
pub(in crate::machines::ribbon_line) fn followed(line: &RibbonLine, feed: f64) -> f64 {
    feed * line.driven_share(&line.derived)
}

/// The highest whole speed of the unwinder within all limits of rule 4.
fn fastest(line: &RibbonLine) -> f64 {
    (line.fast.unwinder.actual * share_of_feeds(line)).floor()
}

/// The least limit of axes and F over its feed with the knob at its highest position: below 1, the line must run slower by as much.
fn share_of_feeds(line: &RibbonLine) -> f64 {
    let RibbonLine { params: p, fast, .. } = line;
    let driven = line.driven_share(fast);
    let feeds = fast.feeds.of_axes();
    let [pull, print] = LineAxis::BOTH.map(|axis| p.axes[axis].clamp / (feeds[axis] * driven));
    let clamps = pull.min(print);
    if line.feeds_per_revolution() { clamps } else { clamps.min(line.feed_max() / fast.feeds.vector_feed) }
}

/// Override (%) up to which the speed of the line follows the knob: until the speed saturates, an axis or F is at its
/// limit, or blocks end before the control has read the next ones. Feeds per revolution are taken with the motor's
/// error at the knob's highest position.
pub(in crate::machines::ribbon_line) fn knob_holds(line: &RibbonLine) -> f64 {
    let RibbonLine { params: p, derived: d, fast, .. } = line;
    if fast.unwinder.actual <= 0.0 {
        return 0.0;
    }
    if worst_knob(line).is_some() {
        return p.override_stepped();
    }
    let share = share_of_feeds(line).min(fast.timing.block / line.driven_share(fast) / d.timing.needed);
    (100.0 * fast.unwinder.actual * share / p.spindle_speed).min(d.unwinder.override_limit).min(line.highest_position())
}

/// An advice with a button for S and the speed clamp with which the unwinder turns at most at `speed` r/min, at the
/// present and at any position of the knob.
pub(in crate::machines::ribbon_line) fn with_speed(line: &RibbonLine, speed: f64, advice: Message) -> Advice {
    let RibbonLine { params: p, derived: d, fast, .. } = line;
    let mut sets = Vec::new();
    if d.unwinder.commanded > speed {
        sets.push(at_most(FIELDS, "spindle-speed", 100.0 * speed / p.override_stepped()));
    }
    if fast.unwinder.actual > speed {
        sets.push(at_most(FIELDS, "speed-clamp", speed));
    }
    let button = match sets.first() {
        Some(set) if set.field == "spindle-speed" => msg!("advice.set-speed", speed = set.text.as_str()),
        Some(set) => msg!("advice.clamp-speed", speed = set.text.as_str()),
        None => return advice.into(),
    };
    Advice::from(advice).setting(button, sets)
}

pub(in crate::machines::ribbon_line) fn slower_advice(line: &RibbonLine) -> Advice {
    match fastest(line) {
        speed if speed < 1.0 => msg!("ribbon.no-speed").into(),
        speed if line.derived.unwinder.actual > speed => {
            with_speed(line, speed, msg!("ribbon.run-slower", speed = (speed, 0)))
        }
        speed => with_speed(
            line,
            speed,
            msg!("ribbon.knob-too-far", percent = (line.fast.unwinder.effective_override, 1), speed = (speed, 0)),
        ),
    }
}

/// Judges a feed against the clamp of its axis over the whole range of the knob: the limit of the present feed is lower by the share that
/// the knob may add. The driven feed is compared, so the limit of the commanded feed is also lower if the unwinder is fast.
fn within_or_error(feed: f64, clamp: f64, line: &RibbonLine) -> Option<Judgement> {
    let limit = clamp / line.driven_share(&line.fast) * line.knob_share();
    if limit <= 0.0 || limit.is_infinite() {
        return ok(None);
    }
    if feed > limit { fail(AtMost(limit), [slower_advice(line)]) } else { ok(AtMost(limit)) }
}

/// Judges the feed of an axis by its clamp.
pub(in crate::machines::ribbon_line) fn clamp(line: &RibbonLine, axis: LineAxis) -> Option<Judgement> {
    within_or_error(line.derived.feeds.of_axes()[axis], line.params.axes[axis].clamp, line)
}

/// Judges the speed of the line by the axis that reaches its clamp first: beyond it the control slows both.
pub(in crate::machines::ribbon_line) fn clamped_line_speed(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { params: p, derived: d, .. } = line;
    if d.feeds.line_speed == 0.0 {
        return ok(None);
    }
    let feeds = d.feeds.of_axes();
    let [pull, print] = LineAxis::BOTH.map(|axis| p.axes[axis].clamp / feeds[axis]);
    let clamped = d.feeds.line_speed * pull.min(print);
    // The speed of the line is the driven one.
    let driven = line.driven_share(d);
    within_or_error(driven * d.feeds.line_speed, driven * clamped, line)
}

pub(in crate::machines::ribbon_line) fn feed_limit(line: &RibbonLine) -> Option<Judgement> {
    if line.feeds_per_revolution() {
        return None;
    }
    let limit = AtMost(line.feed_max() * line.knob_share());
    let Some((message, mut advice)) = too_fast(line) else {
        if limit.holds(line.derived.feeds.vector_feed) {
            return ok(limit);
        }
        let feed = msg!(
            "ribbon.knob-stops",
            percent = (line.fast.unwinder.effective_override, 1),
            feed = (line.fast.feeds.vector_feed, 0),
            most = line.feed_max()
        );
        return fail(limit, [feed.into(), slower_advice(line)]);
    };
    let speed = fastest(line);
    let short = with_speed(line, speed, msg!("ribbon.feed-above-range", most = line.feed_max(), speed = (speed, 0)));
    advice.splice(0..0, (speed >= 1.0).then_some(short).into_iter().chain([message.into()]));
    fail(limit, advice)
}

/// The control reads F per revolution in steps, which makes X run a little faster or slower than the unwinder, and up to a limit.
pub(in crate::machines::ribbon_line) fn revolution_feed(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { derived: d, .. } = line;
    let limits = &line.control.limits;
    if !line.feeds_per_revolution() {
        return None;
    }
    let (feed, limit, step) = (d.feeds.per_revolution, line.feed_max(), limits.feed_increment);
    if feed > limit {
        return fail(
            AtMost(limit),
            [msg!("ribbon.revolution-feed-above-limit", feed = (feed, 3), most = limit).into()],
        );
    }
    let drift = (1.0 - (feed / step).round() * step / feed) * d.feeds.line_speed;
    if drift.abs() > 1.0 {
        return warn(AtMost(limit), [with_dancer(line, msg!("ribbon.feed-in-steps", step, rate = (drift.abs(), 1)))]);
    }
    ok(AtMost(limit))
}

/// The highest speed of the motor is judged over the whole range of the knob, its rated speed at the present position.
pub(in crate::machines::ribbon_line) fn motor(line: &RibbonLine, speed: f64, motor: &ServoParams) -> Option<Judgement> {
    let (rated, max) = (motor.rated_speed, motor.top_speed);
    let limit = AtMost(max * line.knob_share());
    if !limit.holds(speed) {
        let slower = line.derived.unwinder.actual * rated.min(max) / speed;
        let advice = msg!("ribbon.motor-too-fast", speed = (speed / line.knob_share(), 0), limit = (max, 0));
        fail(limit, [with_speed(line, slower, advice)])
    } else if speed > rated {
        warn(AtMost(rated), [msg!("ribbon.motor-above-rated", speed = (speed, 0), rated = (rated, 0)).into()])
    } else {
        ok(AtMost(rated.min(limit.value())))
    }
}

/// Judges the speed of an axis's motor while the line runs.
pub(in crate::machines::ribbon_line) fn axis_motor(line: &RibbonLine, axis: LineAxis) -> Option<Judgement> {
    motor(line, line.derived.feeds.motor_speeds[axis], &line.params.axes[axis].motor)
}

/// Rapid traverse turns the print roller to its next head after a break, and both rollers by hand.
pub(in crate::machines::ribbon_line) fn rapid(line: &RibbonLine, axis: LineAxis) -> Option<Judgement> {
    let (entered, speed) = (&line.params.axes[axis], line.rapid_speeds()[axis]);
    let most = entered.motor.top_speed;
    let limit = AtMost(most);
    if limit.holds(speed) {
        return ok(limit);
    }
    let set = at_most(FIELDS, AXIS_FIELDS[axis].rapid, entered.rapid * most / speed);
    let advice = Advice::from(msg!("ribbon.rapid-too-fast", speed = (speed, 0), limit = (most, 0)));
    fail(limit, [advice.setting(msg!("advice.set-rapid", speed = set.text.as_str()), [set])])
}

/// Slip of the motor at a load (fraction of the rated torque), and its speed, r/min, each with its decimals for a
/// message.
fn slip(line: &RibbonLine, load: f64) -> [(f64, u8); 2] {
    [(Induction { load, ..line.params.induction() }.slip(), 1), (line.derived.unwinder.actual, 1)]
}

/// Fails a motor that stalls: its slip at the load of the form is as great as its speed.
pub(in crate::machines::ribbon_line) fn stalls_at_load(line: &RibbonLine) -> Option<Judgement> {
    if line.derived.unwinder.error > -1.0 {
        return None;
    }
    let [slip, speed] = slip(line, line.params.induction().load);
    fail(AtLeast(-100.0), [msg!("ribbon.slips-to-rest", slip, speed).into()])
}

/// The same at rated torque, as a warning: the load of the form is lower.
pub(in crate::machines::ribbon_line) fn stalls_when_rated(line: &RibbonLine) -> Option<Judgement> {
    if line.derived.unwinder.error_rated > -1.0 {
        return None;
    }
    let [slip, speed] = slip(line, 1.0);
    warn(AtLeast(-100.0), [msg!("ribbon.slips-when-rated", slip, speed).into()])
}

/// Judges the time of a block against the time that the control needs for it, over the whole range of the knob: the limit of the present
/// block is longer by the share that the knob may take from it. The driven block is compared, so the limit of the commanded one is also
/// longer if the unwinder is fast.
pub(in crate::machines::ribbon_line) fn block_time(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { params: p, derived: d, fast, .. } = line;
    let (needed, turned) = (d.timing.needed * 1000.0, d.timing.needed_turned * 1000.0);
    if d.timing.block.is_infinite() {
        return warn(AtLeast(needed), [msg!("ribbon.stands").into()]);
    }
    if line.feeds_per_revolution() && d.unwinder.error <= -1.0 {
        return fail(None, [msg!("ribbon.stalls").into()]);
    }
    // Exact stops leave the control their time.
    if p.path_mode == PathMode::ExactStop && fast.timing.exact_stop * 1000.0 >= needed {
        return ok(None);
    }
    let driven = line.driven_share(fast);
    let lasts = fast.timing.block * 1000.0 / driven;
    let here = |needed: f64| AtLeast(needed * driven * d.timing.block / fast.timing.block);
    let block = d.timing.block * 1000.0;
    let steady = here(needed).holds(block);
    if steady && (here(turned).holds(block) || turned.is_infinite()) {
        return ok(here(if turned.is_infinite() { needed } else { turned }));
    }
    let knob = (line.fast.unwinder.effective_override, 1);
    let advice = match p.variant {
        Variant::ReadyMade => {
            let wanted = if turned.is_infinite() { needed } else { turned };
            let set = at_least(FIELDS, "pitches-per-block", p.block_pitches() * wanted / lasts);
            let (lacks, time, count) = (if steady { turned } else { needed }, (lasts, 1), (set.value, 0));
            let sentence = if steady {
                msg!("ribbon.more-pitches-to-turn", needed = (lacks, 1), time, percent = knob, count)
            } else {
                msg!("ribbon.more-pitches", needed = (lacks, 1), time, percent = knob, count)
            };
            Advice::from(sentence).setting(msg!("advice.set-pitches", count = set.text.as_str()), [set])
        }
        Variant::Published | Variant::Precomputed => {
            let sentence = if steady {
                msg!("ribbon.published-to-turn", needed = (turned, 1), time = (lasts, 1))
            } else {
                msg!("ribbon.published-too-slow", needed = (needed, 1), time = (lasts, 1))
            };
            Advice::from(sentence).setting(msg!("advice.ready-made"), [("variant", "ready-made")])
        }
    };
    let mut advice = vec![advice];
    advice.extend(precomputed_in_time(p, |needed| here(needed).holds(block)));
    if steady { warn(here(turned), advice) } else { fail(here(needed), advice) }
}

/// An advice to calculate the published listing before its loop, if its passes then take no longer than the control has time for.
fn precomputed_in_time(p: &Params, in_time: impl Fn(f64) -> bool) -> Option<Advice> {
    let needed = Params { variant: Variant::Precomputed, ..p.clone() }.pass_needed() * 1000.0;
    let advice = Advice::from(msg!("ribbon.precomputed-in-time", needed = (needed, 1)));
    (p.variant == Variant::Published && in_time(needed))
        .then(|| advice.setting(msg!("advice.precomputed"), [("variant", "precomputed")]))
}

/// Volts of the analog output. Beyond the clamp or the output: the volts that the speed would need, `10 n / n10`.
pub(in crate::machines::ribbon_line) fn volts(line: &RibbonLine) -> f64 {
    let RibbonLine { params: p, derived: d, .. } = line;
    if d.unwinder.commanded > d.unwinder.greatest {
        10.0 * d.unwinder.commanded / p.speed_at_10v
    } else {
        d.unwinder.volts
    }
}

pub(in crate::machines::ribbon_line) fn saturation(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { params: p, derived: d, .. } = line;
    let limit = AtMost(d.unwinder.greatest_volts);
    if d.unwinder.commanded > d.unwinder.greatest {
        let advice = msg!(
            "ribbon.saturates",
            asked = (d.unwinder.commanded, 1),
            speed = (d.unwinder.greatest, 1),
            percent = (d.unwinder.override_limit, 1)
        );
        return fail(limit, [with_speed(line, d.unwinder.greatest, advice)]);
    }
    if p.speed_clamp > p.speed_at_10v {
        let advice =
            Advice::from(msg!("ribbon.clamp-above-output", clamp = (p.speed_clamp, 1), speed = (p.speed_at_10v, 1)));
        let set = at_most(FIELDS, "speed-clamp", p.speed_at_10v);
        return warn(limit, [advice.setting(msg!("advice.clamp-speed", speed = set.text.as_str()), [set])]);
    }
    let (now, slow) = (d.unwinder.volts_command, &line.slow.unwinder);
    if slow.volts_command < FEW_VOLTS && slow.actual > 0.0 {
        let least = AtLeast(here(FEW_VOLTS, now, slow.volts_command));
        let (percent, volts) = ((slow.effective_override, 0), (slow.volts_command, 3));
        return warn(least, [msg!("ribbon.few-volts", percent, volts).into()]);
    }
    ok(limit)
}

/// Frequency (Hz) below which a motor on V/f loses torque and accuracy. Source: from memory.
const LEAST_FREQUENCY: f64 = 5.0;

pub(in crate::machines::ribbon_line) fn slow_motor(line: &RibbonLine) -> Option<Judgement> {
    let (now, slow) = (&line.derived.unwinder, &line.slow.unwinder);
    if now.actual <= 0.0 {
        return ok(None);
    }
    // The knob turns the motor as slowly as its lowest position.
    let limit = AtLeast(here(LEAST_FREQUENCY, now.frequency, slow.frequency));
    if limit.holds(now.frequency) {
        return ok(limit);
    }
    let (percent, frequency) = ((slow.effective_override, 0), (slow.frequency, 2));
    warn(limit, [msg!("ribbon.low-frequency", percent, frequency).into()])
}

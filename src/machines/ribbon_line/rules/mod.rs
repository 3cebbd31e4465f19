//! The rules of the ribbon line, as rows: result, limit, remedy.
//!
//! Numbers are those of section 7 of `docs/reference/sizing.md`. Rule 1 (ranges of the form) and rule 18 (list of
//! assumed facts) are implemented for every machine. Rule 4: a feed above a clamp is an error, because the control
//! slows the vector; an F beyond the control's range is a verdict, because the program stops by itself before anything
//! moves. All others are verdicts.

pub(super) mod cam;
pub(super) mod coordinates;
pub(super) mod dancer;
pub(super) mod dots;
pub(super) mod drives;
pub(super) mod feeds;
mod product;
pub(super) mod reel;
pub(super) mod slack;

use super::axes::LineAxis;
use super::cam::has_no_time;
use super::coasting;
use super::contacts::CONTACTS;
use super::params::AXIS_FIELDS;
use super::program;
use super::resolved::RibbonLine;
use super::tension_switch;
use crate::controls::ParamRole;
use crate::machines::sheets;
use crate::machines::verdict::Rule;
use crate::msg;
use crate::text::{Citation, Diagnostic, Grade};

/// All rules that judge a result.
pub(super) const RULES: &[Rule<RibbonLine>] = &[
    Rule::new(
        "surface-ratio",
        product::ratio,
        Citation::new("sizing facts 3.2 and 3.4, engineering choice; rule 2", Grade::Inferred),
    ),
    Rule::new(
        "smear",
        product::smear,
        Citation::new("sizing facts 3.2 and 3.4, engineering choice; rule 2", Grade::Inferred),
    ),
    Rule::new(
        "x-motor-speed",
        |line| feeds::axis_motor(line, LineAxis::Pull),
        Citation::new("data sheet of the motor; rule 3", Grade::Manual),
    ),
    Rule::new(
        "y-motor-speed",
        |line| feeds::axis_motor(line, LineAxis::Print),
        Citation::new("data sheet of the motor; rule 3", Grade::Manual),
    ),
    Rule::new(
        "x-rapid-speed",
        |line| feeds::rapid(line, LineAxis::Pull),
        Citation::new("data sheet of the motor; rule 3", Grade::Manual),
    ),
    Rule::new(
        "y-rapid-speed",
        |line| feeds::rapid(line, LineAxis::Print),
        Citation::new("data sheet of the motor; rule 3", Grade::Manual),
    ),
    Rule::new(
        "line-speed",
        feeds::clamped_line_speed,
        Citation::new("cutting feed clamp, a parameter; rule 4", Grade::Sister),
    ),
    Rule::new(
        "x-feed",
        |line| feeds::clamp(line, LineAxis::Pull),
        Citation::new("cutting feed clamp, a parameter; rule 4", Grade::Sister),
    ),
    Rule::new(
        "y-feed",
        |line| feeds::clamp(line, LineAxis::Print),
        Citation::new("cutting feed clamp, a parameter; rule 4", Grade::Sister),
    ),
    Rule::new("vector-feed", feeds::feed_limit, Citation::new("ranges of the control; rule 4", Grade::Open)),
    Rule::new(
        "feed-per-revolution",
        feeds::revolution_feed,
        Citation::new("ranges of the control; rule 4", Grade::Open),
    ),
    Rule::new(
        "block-time",
        feeds::block_time,
        Citation::new("sizing facts, section 4, times from memory; rule 5", Grade::Open),
    ),
    Rule::new("volts", feeds::saturation, Citation::new("ribbon line facts, 4; rule 6", Grade::Inferred)),
    Rule::new("frequency", feeds::slow_motor, Citation::new("trade source; rule 7", Grade::Inferred)),
    Rule::new("register-error", slack::equal_axes, Citation::new("sizing facts 0.6; rule 9", Grade::Inferred)),
    Rule::new("loop-needed", slack::loop_needed, Citation::new("ribbon line facts, 7; rule 10", Grade::Inferred)),
    Rule::new("loop-coasting", coasting::holds, Citation::new("ribbon line facts, 7", Grade::Inferred)),
    Rule::new(
        "slack-rate",
        slack::slack_rate,
        Citation::new("sizing facts 2.6, engineering choice; rule 11", Grade::Inferred),
    ),
    Rule::new(
        "slack-rate-rated",
        slack::slack_rate_rated,
        Citation::new("sizing facts 2.6, engineering choice; rule 11", Grade::Inferred),
    ),
    Rule::new(
        "slack-rate-knob",
        slack::slack_rate_knob,
        Citation::new("ribbon line facts, 8, engineering choice; rule 11", Grade::Inferred),
    ),
    Rule::new(
        "tension",
        slack::stiff_web,
        Citation::new("sizing facts 2.6, engineering choice; rule 12", Grade::Inferred),
    ),
    Rule::new(
        "dancer-trim",
        dancer::trim,
        Citation::new("sizing facts 2.6, engineering choice; rule 11", Grade::Inferred),
    ),
    Rule::new("speed-error", feeds::stalls_at_load, Citation::new("sizing facts D6", Grade::Inferred)),
    Rule::new("speed-error-rated", feeds::stalls_when_rated, Citation::new("sizing facts D8", Grade::Inferred)),
    Rule::new("pi-drift", product::pi, Citation::new("sizing facts D21; rule 14", Grade::Inferred)),
    Rule::new("thickness-error", product::thickness, Citation::new("sizing facts D22; rule 14", Grade::Inferred)),
    Rule::new(
        "start-stop-speed",
        slack::start_stop,
        Citation::new("sizing facts, section 4; rule 15", Grade::Inferred),
    ),
    Rule::new(
        "x-resolution",
        |line| product::resolution(line, LineAxis::Pull),
        Citation::new("sizing facts 2.5, from memory; rule 17", Grade::Open),
    ),
    Rule::new(
        "y-resolution",
        |line| product::resolution(line, LineAxis::Print),
        Citation::new("sizing facts 2.5, from memory; rule 17", Grade::Open),
    ),
    Rule::new(
        "range-time",
        coordinates::range,
        Citation::new("ribbon line facts, 9; ranges of the control", Grade::Inferred),
    ),
    Rule::new(
        "x-scaling-drift",
        |line| coordinates::scaling(line, LineAxis::Pull),
        Citation::new("ribbon line facts, 10", Grade::Inferred),
    ),
    Rule::new(
        "y-scaling-drift",
        |line| coordinates::scaling(line, LineAxis::Print),
        Citation::new("ribbon line facts, 10", Grade::Inferred),
    ),
    Rule::new("length-error", product::length, Citation::new("ribbon line facts, 6", Grade::Inferred)),
    Rule::new("missing-turned", slack::turn_starves, Citation::new("ribbon line facts, 5", Grade::Inferred)),
    Rule::new("loop-turned", slack::turn_up, Citation::new("ribbon line facts, 5", Grade::Inferred)),
    Rule::new("loop-growth", slack::grows, Citation::new("ribbon line facts, 7", Grade::Inferred)),
    Rule::new("missing-low-knob", slack::low_knob_starves, Citation::new("ribbon line facts, 7", Grade::Inferred)),
    Rule::new("stop-room", tension_switch::stops_in_time, CONTACTS),
    Rule::new("y-drift", product::y_drift, Citation::new("sizing facts G1; rule 17", Grade::Inferred)),
];

/// Errors that refuse the export, feeds out of the control's range, and notes for the operator.
pub(super) fn findings(line: &RibbonLine) -> Vec<Diagnostic> {
    let RibbonLine { params: p, derived: d, .. } = line;
    let limits = &line.control.limits;
    let mut found = Vec::new();
    for axis in LineAxis::BOTH {
        let (feed, clamp) = (feeds::followed(line, d.feeds.of_axes()[axis]), p.axes[axis].clamp);
        if feed > clamp {
            let unit = if axis == LineAxis::Print && line.degrees() { "°/min" } else { "mm/min" };
            let message = msg!("ribbon.above-clamp", axis = line.letter(axis), feed, clamp, unit);
            found.push(
                Diagnostic::error(message).about(AXIS_FIELDS[axis].clamp).hint(feeds::slower_advice(line).message),
            );
        }
    }
    if let Some((message, advice)) = feeds::too_fast(line) {
        let hints = advice.into_iter().map(|advice| advice.message);
        found.push(hints.fold(Diagnostic::warning(message).about("feed-limit"), Diagnostic::hint));
    }
    if line.feeds_per_revolution() && !p.spindle_encoder {
        found.push(Diagnostic::error(msg!("ribbon.no-encoder")).about("spindle-encoder"));
    }
    found.extend(p.encoder.finding(line.control).filter(|_| p.spindle_encoder));
    if p.dancer && !p.is_regulated() {
        found.push(Diagnostic::warning(msg!("ribbon.dancer-idle")).about("dancer"));
    }
    if line.form.path_mode != p.path_mode {
        found.push(Diagnostic::info(msg!("ribbon.no-exact-stop", control = line.control.name)).about("path-mode"));
    }
    if line.rolls_in_diameters() {
        found.push(Diagnostic::error(msg!("ribbon.rolls-in-diameters")).about("endless"));
    }
    let constant = line.control.param(ParamRole::AxisTimeConstant).and_then(|row| row.range);
    for axis in LineAxis::BOTH {
        let field = AXIS_FIELDS[axis].time_constant;
        found.extend(sheets::beyond_range(field, p.axes[axis].time_constant, "ms", constant));
    }
    if p.no_load_speed < p.rated_load_speed {
        let (no_load, rated) = ((p.no_load_speed, 1), (p.rated_load_speed, 1));
        found.push(Diagnostic::error(msg!("ribbon.no-load-below-rated", no_load, rated)).about("no-load-speed"));
    }
    if p.spindle_speed > limits.speed_max {
        found.push(
            Diagnostic::error(msg!("ribbon.speed-above-range", speed = (p.spindle_speed, 0), most = limits.speed_max))
                .about("spindle-speed"),
        );
    }
    if d.feeds.vector_feed > 0.0 && d.feeds.vector_feed < limits.feed_increment {
        let message =
            msg!("ribbon.feed-below-increment", feed = (d.feeds.vector_feed, 6), step = limits.feed_increment);
        found.push(Diagnostic::error(message).about("spindle-speed"));
    }
    if (1.0..p.knob_lowest).contains(&line.form.override_percent) && !p.knob_is_locked() {
        let message = msg!("ribbon.knob-raised", percent = line.form.override_percent, lowest = p.knob_lowest);
        found.push(Diagnostic::info(message).about("override"));
    }
    found.extend(coordinates::long_blocks(line));
    found.extend(coordinates::counted_axis(line));
    if has_no_time(line) {
        let message = msg!("ribbon.cam-no-time", length = (p.contact_length, 3), pitch = (p.pitch, 3));
        found.push(Diagnostic::warning(message).about("contact-length"));
    }
    let speed = line.fast.feeds.mm_per_second();
    if speed > 0.0 {
        let (speed, capacity, time) = ((speed, 0), (p.loop_capacity, 0), (p.loop_capacity / speed, 1));
        let acts = program::feed_override_acts(line).then(|| msg!("ribbon.override-acts", speed, capacity, time));
        let stops = program::feed_override_stops(line).then(|| msg!("ribbon.override-stops", speed, capacity, time));
        found.extend(acts.or(stops).map(Diagnostic::info));
    }
    if !line.control.macros.common_kept {
        found.push(Diagnostic::info(msg!("form.values-are-lost", program = program::SETUP)));
    }
    found
}

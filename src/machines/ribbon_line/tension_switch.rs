//! The switch that holds the program before a taut ribbon tears or slips: its place, its tension, and whether it opens in time.

use super::mechanics::GRIP;
use super::params::FIELDS;
use super::resolved::RibbonLine;
use crate::machines::form::entry::at_least;
use crate::machines::verdict::{Judgement, fail, ok};
use crate::msg;
use crate::text::Message;
use crate::view::Advice;
use crate::view::Limit::AtLeast;

/// Least missing ribbon (mm) that the switch detects. Source: ribbon line facts, 11.
pub(super) const LEAST_DETECTED: f64 = 0.5;

/// Operating point of the tension switch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TensionSwitch {
    /// Ribbon (mm) that is missing in the loop.
    pub missing: f64,
    /// Tension (N) of the ribbon before X.
    pub tension: f64,
}

impl TensionSwitch {
    /// The switch opens at the allowed tension, or earlier, so that X has stopped before the ribbon tears or slips; the
    /// unwinder is taken as stopped at once. Source: ribbon line facts, 11.
    pub(super) fn new(line: &RibbonLine) -> TensionSwitch {
        let allowed = stretch(line, line.mechanics.allowed_tension);
        let missing = allowed.min(room_for_the_stop(line)).max(LEAST_DETECTED);
        TensionSwitch { missing, tension: line.params.tension_with_missing(missing) }
    }
}

/// Stretch (mm) of the ribbon before X at a tension (N): `s = (T - T1) · L / (E · A)`, and none where T1 is above that. Source: ribbon line
/// facts, 7 and 11.
fn stretch(line: &RibbonLine, tension: f64) -> f64 {
    (tension - line.params.web.tension_before).max(0.0) * line.params.web.span / line.params.force_per_strain()
}

/// Distance (mm) that X travels from a hold to its stop, with the knob at its highest position: `v · (τ / 2 + 1 / K)`.
/// Source: ribbon line facts, 11.
fn way_to_the_stop(line: &RibbonLine) -> f64 {
    line.fast.feeds.mm_per_second() * line.params.x_stop_time()
}

/// Stretch (mm) of the ribbon up to tearing or slipping, less the distance of X to its stop: the latest point for the
/// switch to open. Negative if the ribbon tears or slips before X has stopped.
pub(super) fn room_for_the_stop(line: &RibbonLine) -> f64 {
    stretch(line, line.mechanics.slip_or_break_tension) - way_to_the_stop(line)
}

/// Fails a ribbon that tears or slips while X stops, against which no switch protects. The remedy is a greater pinch
/// force, up to the strength of the ribbon.
pub(super) fn stops_in_time(line: &RibbonLine) -> Option<Judgement> {
    let (room, way) = (room_for_the_stop(line), way_to_the_stop(line));
    let limit = AtLeast(LEAST_DETECTED);
    if limit.holds(room) {
        return ok(limit);
    }
    let message = msg!(
        "ribbon.stop-slips",
        way = (way, 1),
        stretch = (way + room, 1),
        tension = (line.mechanics.slip_or_break_tension, 0)
    );
    fail(limit, [with_pinch(line, message, LEAST_DETECTED)])
}

/// Adds a button to an advice: the pinch force with which the switch opens at `missing` mm of missing ribbon or more.
/// No button if the ribbon would break.
pub(super) fn with_pinch(line: &RibbonLine, message: Message, missing: f64) -> Advice {
    let (p, ribbon) = (&line.params, &line.derived.tension);
    let (allowed, holds) = (p.tension_with_missing(missing), p.tension_with_missing(missing + way_to_the_stop(line)));
    if allowed > ribbon.allowed || holds > ribbon.breaking {
        return message.into();
    }
    let grip = ((allowed - p.web.tension_behind) / (GRIP / 100.0)).max(holds - p.web.tension_behind);
    let set = at_least(FIELDS, "pinch-force", grip / p.pinch.friction);
    Advice::from(message).setting(msg!("advice.set-pinch", force = (set.value, 1)), [set])
}

//! The rules of threads on turned ends: the run-in in front, and the run-out at the end.

use crate::drives::polygon::SAME_LENGTH;
use crate::machines::form::entry::{at_least, at_most, field_max, field_min};
use crate::machines::polygon_lathe::params::{FIELDS, Params};
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::machines::polygon_lathe::turned_end_form::{TURNED_ENDS, TurnedEnd};
use crate::machines::verdict::{Judgement, fail, ok};
use crate::msg;
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// The run-in of the thread that is turned before the polygons.
pub(super) fn run_in_before(lathe: &PolygonLathe) -> Option<Judgement> {
    run_in(lathe, &lathe.params.turned_ends[0], TURNED_ENDS[0].speed)
}

/// The run-in of the thread that is turned after the polygons.
pub(super) fn run_in_after(lathe: &PolygonLathe) -> Option<Judgement> {
    run_in(lathe, &lathe.params.turned_ends[1], TURNED_ENDS[1].speed)
}

/// Judges the distance from the clearance to the face against the run-in in which the slide reaches its speed.
fn run_in(lathe: &PolygonLathe, end: &TurnedEnd, speed: &'static str) -> Option<Judgement> {
    let p = &lathe.params;
    let (needed, limit) = (end.run_in(p), AtMost(p.clearance));
    if limit.holds(needed) {
        return ok(limit);
    }
    let message = msg!("polygon.short-run-in", needed = (needed, 2), clearance = (p.clearance, 2));
    let mut advice = Vec::new();
    let set = at_least(FIELDS, "clearance", needed);
    let wider = Params { clearance: set.value, ..p.clone() };
    if wider.clearance <= field_max(FIELDS, "clearance") && wider.has_room(lathe.length_to_jaws() - p.clearance) {
        let button = msg!("advice.set-clearance", clearance = set.text.as_str());
        advice.push(Advice::from(message.clone()).setting(button, [set]));
    }
    let set = at_most(FIELDS, speed, end.speed * p.clearance / needed);
    let slower = Advice::from(if advice.is_empty() { message } else { msg!("polygon.slower-thread") });
    advice.push(if set.value >= 1.0 {
        slower.setting(msg!("advice.set-speed", speed = set.text.as_str()), [set])
    } else {
        slower
    });
    fail(limit, advice)
}

/// The run-out of the thread that is turned before the polygons.
pub(super) fn run_out_before(lathe: &PolygonLathe) -> Option<Judgement> {
    run_out(lathe, &lathe.params.turned_ends[0], TURNED_ENDS[0].thread_length)
}

/// The run-out of the thread that is turned after the polygons.
pub(super) fn run_out_after(lathe: &PolygonLathe) -> Option<Judgement> {
    run_out(lathe, &lathe.params.turned_ends[1], TURNED_ENDS[1].thread_length)
}

/// Judges the distance from the end of a thread to the shoulder against the run-out; the remedy is the greatest thread
/// length.
fn run_out(lathe: &PolygonLathe, end: &TurnedEnd, field: &'static str) -> Option<Judgement> {
    let needed = end.run_out(&lathe.params);
    // Without the rounding of binary fractions.
    let limit = AtMost(((end.length - end.thread_length) * 1e9).round() / 1e9);
    if limit.holds(needed) {
        return ok(limit);
    }
    let set = at_most(FIELDS, field, end.length - needed + SAME_LENGTH);
    let needed = (needed, 2);
    if set.value < field_min(FIELDS, field) {
        return fail(limit, [msg!("polygon.no-run-out", needed, length = (end.length, 3)).into()]);
    }
    let length = set.text.as_str();
    let message = msg!("polygon.short-run-out", needed, room = (limit.value().max(0.0), 2), length);
    fail(limit, [Advice::from(message).setting(msg!("advice.set-length", length), [set.clone()])])
}

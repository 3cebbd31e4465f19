//! The rules of speeds: of the axes, and of the cut, each with the B that is a remedy.

use crate::machines::form::entry::{field_max, nearest};
use crate::machines::polygon_lathe::params::FIELDS;
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::msg;
use crate::text::Message;
use crate::view::Advice;
use crate::view::Limit::{AtLeast, AtMost, Within};

pub(super) fn tool_speed(lathe: &PolygonLathe) -> Option<Judgement> {
    let p = &lathe.params;
    too_fast(lathe, lathe.derived.speeds.tool, p.tool_limit, p.tool_ratio, |speed| {
        msg!("polygon.tool-too-fast", limit = (p.tool_limit, 0), speed)
    })
}

pub(super) fn work_speed(lathe: &PolygonLathe) -> Option<Judgement> {
    let p = &lathe.params;
    too_fast(lathe, lathe.derived.speeds.work, p.work_limit, p.work_ratio, |speed| {
        msg!("polygon.work-too-fast", limit = (p.work_limit, 0), speed)
    })
}

pub(super) fn slowest(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    let limit = AtLeast(p.slowest_cut);
    if d.inserts.slowest_cut >= p.slowest_cut {
        return ok(limit);
    }
    let speed = (p.speed * p.slowest_cut / d.inserts.slowest_cut).ceil();
    warn(limit, [with_b(speed, |speed| msg!("polygon.cuts-slowly", speed = (speed, 0)))])
}

pub(super) fn fastest(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    let limit = AtMost(p.fastest_cut);
    if d.inserts.fastest_cut <= p.fastest_cut {
        return ok(limit);
    }
    let speed = (p.speed * p.fastest_cut / d.inserts.fastest_cut).floor();
    warn(limit, [with_b(speed, |speed| msg!("polygon.cuts-fast", speed = (speed, 0)))])
}

/// Judges a speed (r/min) of an axis against its limit, `term` its ratio to B. Where the feed override acts on work and tool, the limit is that
/// at 100 % with which the axis keeps its own at the highest position.
fn too_fast(
    lathe: &PolygonLathe,
    speed: f64,
    limit: f64,
    term: f64,
    advice: impl Fn(f64) -> Message,
) -> Option<Judgement> {
    let limit = lathe.limit_at_full_feed(limit);
    if speed.abs() <= limit {
        return ok(Within(limit));
    }
    fail(Within(limit), [with_b((limit / term.abs()).floor(), advice)])
}

/// Advice with a speed B, a whole number, or without a button if no B is a remedy.
fn with_b(speed: f64, advice: impl Fn(f64) -> Message) -> Advice {
    if !(1.0..=field_max(FIELDS, "speed")).contains(&speed) {
        return msg!("polygon.no-b").into();
    }
    Advice::from(advice(speed)).setting(msg!("advice.set-b", speed = (speed, 0)), [nearest(FIELDS, "speed", speed)])
}

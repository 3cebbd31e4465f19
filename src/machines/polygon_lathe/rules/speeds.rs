//! The rules of speeds: of the axes, and of the cut, each with the B that is a remedy.

use crate::machines::form::entry::{at_most, field_max, nearest};
use crate::machines::polygon_lathe::params::FIELDS;
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::machines::polygon_lathe::turned_end_form::TURNED_ENDS;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::msg;
use crate::text::Message;
use crate::view::Advice;
use crate::view::Limit::{AtLeast, AtMost, Within};

pub(super) fn tool_speed(lathe: &PolygonLathe) -> Option<Judgement> {
    let p = &lathe.params;
    too_fast(lathe, lathe.derived.speeds.tool, p.axes.tool.limit, p.tool_ratio, |speed| {
        msg!("polygon.tool-too-fast", limit = (p.axes.tool.limit, 0), speed)
    })
}

pub(super) fn work_speed(lathe: &PolygonLathe) -> Option<Judgement> {
    let p = &lathe.params;
    too_fast(lathe, lathe.derived.speeds.work, p.axes.work.limit, p.work_ratio, |speed| {
        msg!("polygon.work-too-fast", limit = (p.axes.work.limit, 0), speed)
    })
}

pub(super) fn slowest(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    let limit = AtLeast(p.slowest_cut);
    if d.inserts.slowest_cut >= p.slowest_cut {
        return ok(limit);
    }
    warn(limit, [within(lathe, suiting(lathe)[0], |speed| msg!("polygon.cuts-slowly", speed = (speed, 0)))])
}

/// Judges the greatest cutting speed, also with a feed override that turns work and tool faster.
pub(super) fn fastest(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    let limit = AtMost(p.fastest_cut);
    let speed = suiting(lathe)[1];
    if d.inserts.fastest_cut > p.fastest_cut {
        return warn(limit, [within(lathe, speed, |speed| msg!("polygon.cuts-fast", speed = (speed, 0)))]);
    }
    let at_limit = lathe.limit_at_full_feed(p.fastest_cut);
    if d.inserts.fastest_cut > at_limit {
        let fast = (d.inserts.fastest_cut * p.fastest_cut / at_limit, 1);
        return warn(
            limit,
            [within(lathe, speed, |speed| msg!("polygon.cuts-fast-at-knob", fast, speed = (speed, 0)))],
        );
    }
    ok(limit)
}

/// The lowest and the highest B, whole numbers, with which every cut of a polygon has a speed that suits insert and material.
fn suiting(lathe: &PolygonLathe) -> [f64; 2] {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    let lowest = (p.speed * p.slowest_cut / d.inserts.slowest_cut).ceil();
    [lowest, (p.speed * lathe.limit_at_full_feed(p.fastest_cut) / d.inserts.fastest_cut).floor()]
}

/// Advice with a speed B that suits the cuts; where the slowest and the fastest cut of a turn are too far apart, none does.
fn within(lathe: &PolygonLathe, speed: f64, advice: impl Fn(f64) -> Message) -> Advice {
    let [lowest, highest] = suiting(lathe);
    if lowest <= highest { with_b(speed, advice) } else { msg!("polygon.no-b").into() }
}

/// Judges the greatest cutting speed of the turned ends, that of their stock.
pub(super) fn fastest_end(lathe: &PolygonLathe) -> Option<Judgement> {
    let p = &lathe.params;
    let limit = AtMost(p.fastest_cut);
    let ends = TURNED_ENDS.map(|fields| fields.speed).into_iter().zip(p.turned_ends.iter()).filter(|(_, end)| end.on);
    let fast = ends.filter(|(_, end)| end.cutting_speed(p) > p.fastest_cut);
    let sets: Vec<_> =
        fast.map(|(field, end)| at_most(FIELDS, field, end.speed * p.fastest_cut / end.cutting_speed(p))).collect();
    let Some(speed) = sets.first().map(|set| set.text.clone()) else { return ok(limit) };
    let fact = Advice::from(msg!("polygon.end-cuts-fast", speed = speed.as_str()));
    warn(limit, [fact.setting(msg!("advice.set-speed", speed = speed.as_str()), sets)])
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

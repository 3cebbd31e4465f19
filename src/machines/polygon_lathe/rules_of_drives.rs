//! Rules about the drives of work and tool: torque and power of the cut, torque of the run-up, each with its remedy.

use super::demand::DemandKind;
use super::load::{FEEDS, PolygonAxis};
use super::params::FIELDS;
use super::resolved::PolygonLathe;
use crate::machines::verdict::{FieldEntry, Judgement, down, fail, maximum, ok, up, warn};
use crate::math;
use crate::msg;
use crate::text::Message;
use crate::view::Limit::AtMost;
use crate::view::{Advice, Verdict};

/// Least feed (mm for each turn of the work) that an advice names: below it an edge rubs.
const LEAST_FEED: f64 = 0.01;

/// An advice that lowers every feed whose cuts exceed a limit of the drive: the force grows with `f^(1 - mc)`.
fn with_feeds(lathe: &PolygonLathe, axis: PolygonAxis, kind: DemandKind, fact: Message) -> Advice {
    let p = &lathe.p;
    let power = 1.0 / (1.0 - p.specific().exponent);
    let feeds = FEEDS.into_iter().zip([p.feed, p.finish_feed, p.infeed]).enumerate();
    let sets: Vec<FieldEntry> = feeds
        .filter_map(|(at, (field, feed))| {
            let excess = lathe.excess(axis, kind, at);
            (excess > 1.0).then(|| down(FIELDS, field, feed * math::pow(excess, -power)))
        })
        .collect();
    let values: Vec<&str> = sets.iter().map(|set| set.text.as_str()).collect();
    let least = sets.iter().map(|set| set.value).fold(f64::INFINITY, f64::min);
    let button = match values.as_slice() {
        [one] => msg!("advice.set-feed", feed = *one),
        several => msg!("advice.set-feeds", feeds = several.join(" / ").as_str()),
    };
    let advice = Advice::from(fact);
    if least < LEAST_FEED { advice } else { advice.setting(button, sets) }
}

/// The cut against the drive.
fn cut(
    lathe: &PolygonLathe,
    axis: PolygonAxis,
    kind: DemandKind,
    told: impl Fn(f64, f64) -> Message,
) -> Option<Judgement> {
    let (asked, limit) = lathe.demand(axis, kind);
    if asked <= limit {
        return ok(AtMost(limit));
    }
    fail(AtMost(limit), [with_feeds(lathe, axis, kind, told(asked, limit))])
}

/// The heat of the cut against the drive: a warning where only the strikes exceed its continuous torque, for a short cut may do that.
fn heat(lathe: &PolygonLathe, axis: PolygonAxis, told: impl Fn(f64, f64) -> Message) -> Option<Judgement> {
    let judged = cut(lathe, axis, DemandKind::Effective, told)?;
    let (mean, limit) = lathe.demand(axis, DemandKind::Mean);
    if judged.verdict == Verdict::Fail && mean <= limit { warn(judged.limit, judged.advice) } else { Some(judged) }
}

pub(super) fn tool_peak(lathe: &PolygonLathe) -> Option<Judgement> {
    cut(lathe, PolygonAxis::Tool, DemandKind::Peak, |asked, limit| {
        msg!("polygon.tool-stalls", torque = (asked, 1), limit = (limit, 1))
    })
}

pub(super) fn work_peak(lathe: &PolygonLathe) -> Option<Judgement> {
    cut(lathe, PolygonAxis::Work, DemandKind::Peak, |asked, limit| {
        msg!("polygon.work-stalls", torque = (asked, 1), limit = (limit, 1))
    })
}

pub(super) fn tool_effective(lathe: &PolygonLathe) -> Option<Judgement> {
    heat(lathe, PolygonAxis::Tool, |asked, limit| {
        msg!("polygon.tool-overheats", torque = (asked, 2), limit = (limit, 2))
    })
}

pub(super) fn work_effective(lathe: &PolygonLathe) -> Option<Judgement> {
    heat(lathe, PolygonAxis::Work, |asked, limit| {
        msg!("polygon.work-overheats", torque = (asked, 2), limit = (limit, 2))
    })
}

pub(super) fn tool_power(lathe: &PolygonLathe) -> Option<Judgement> {
    cut(lathe, PolygonAxis::Tool, DemandKind::Power, |asked, limit| {
        msg!("polygon.tool-lacks-power", power = (asked, 3), limit = (limit, 3))
    })
}

pub(super) fn work_power(lathe: &PolygonLathe) -> Option<Judgement> {
    cut(lathe, PolygonAxis::Work, DemandKind::Power, |asked, limit| {
        msg!("polygon.work-lacks-power", power = (asked, 3), limit = (limit, 3))
    })
}

/// The run-up against the drive. Both axes get the same ramp, so that they keep their ratio on it.
fn run_up(lathe: &PolygonLathe, axis: PolygonAxis, told: impl Fn(f64, f64) -> Message) -> Option<Judgement> {
    let p = &lathe.p;
    let (asked, limit) = lathe.demand(axis, DemandKind::RunUp);
    if asked <= limit {
        return ok(AtMost(limit));
    }
    if limit <= 0.0 {
        let (drive, rated) = (p.drive(axis), p.drive(axis).motor);
        let torque = (rated.torque(drive.speed) * p.drive_peak / 100.0, 1);
        return fail(AtMost(limit), [msg!("lathe.friction-stalls", friction = (drive.friction, 1), torque).into()]);
    }
    let ramp = (1000.0 * lathe.ramp()).max(p.work_time_constant).max(p.tool_time_constant);
    let advice = Advice::from(told(asked, limit));
    let sets = ["work-time-constant", "tool-time-constant"].map(|field| up(FIELDS, field, ramp));
    let button = msg!("advice.set-ramps", time = sets[0].text.as_str());
    fail(
        AtMost(limit),
        [if ramp <= maximum(FIELDS, "work-time-constant") { advice.setting(button, sets) } else { advice }],
    )
}

pub(super) fn tool_run_up(lathe: &PolygonLathe) -> Option<Judgement> {
    run_up(lathe, PolygonAxis::Tool, |asked, limit| {
        msg!("polygon.tool-ramp-short", torque = (asked, 1), limit = (limit, 1))
    })
}

pub(super) fn work_run_up(lathe: &PolygonLathe) -> Option<Judgement> {
    run_up(lathe, PolygonAxis::Work, |asked, limit| {
        msg!("polygon.work-ramp-short", torque = (asked, 1), limit = (limit, 1))
    })
}

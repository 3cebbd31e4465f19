//! Rules about the drives of work and tool: torque and power of the cut, torque of the run-up, each with its remedy.

use super::demand::{DemandKind, HIGHEST_FEED};
use super::load::{FEEDS, PolygonAxis};
use super::params::FIELDS;
use super::resolved::PolygonLathe;
use crate::machines::verdict::{FieldEntry, Judgement, down, fail, maximum, ok, up, warn};
use crate::math;
use crate::msg;
use crate::text::Message;
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// Least feed (mm for each turn of the work) that an advice names: below it an edge rubs.
pub(super) const LEAST_FEED: f64 = 0.01;

/// An advice that lowers every feed whose cuts exceed a limit of the drive at a feed override (%): the force grows with `f^(1 - mc)`.
fn with_feeds(lathe: &PolygonLathe, axis: PolygonAxis, kind: DemandKind, percent: f64, fact: Message) -> Advice {
    let p = &lathe.p;
    let power = 1.0 / (1.0 - p.specific().exponent);
    let feeds = FEEDS.into_iter().zip([p.feed, p.finish_feed, p.infeed]).enumerate();
    let sets: Vec<FieldEntry> = feeds
        .filter_map(|(at, (field, feed))| {
            let excess = lathe.excess(axis, kind, at, percent);
            (excess > 1.0).then(|| down(FIELDS, field, feed * math::pow(excess, -power)))
        })
        .collect();
    setting_feeds(Advice::from(fact), sets)
}

/// An advice with a button for lower feeds; without it where an edge would rub.
pub(super) fn setting_feeds(advice: Advice, sets: Vec<FieldEntry>) -> Advice {
    let values: Vec<&str> = sets.iter().map(|set| set.text.as_str()).collect();
    let least = sets.iter().map(|set| set.value).fold(f64::INFINITY, f64::min);
    let button = match values.as_slice() {
        [one] => msg!("advice.set-feed", feed = *one),
        several => msg!("advice.set-feeds", feeds = several.join(" / ").as_str()),
    };
    if least < LEAST_FEED { advice } else { advice.setting(button, sets) }
}

/// The sentence about a cut that the drive carries at the feed of the form alone.
fn at_knob(kind: DemandKind, asked: f64, limit: f64) -> Message {
    let percent = (HIGHEST_FEED, 0);
    match kind {
        DemandKind::Power => {
            msg!("polygon.power-at-feed-knob", percent, power = (asked, 3), limit = (limit, 3))
        }
        DemandKind::Mean | DemandKind::Effective => {
            msg!("polygon.heat-at-feed-knob", percent, torque = (asked, 2), limit = (limit, 2))
        }
        DemandKind::Peak | DemandKind::RunUp => {
            msg!("polygon.torque-at-feed-knob", percent, torque = (asked, 1), limit = (limit, 1))
        }
    }
}

/// The cut against the drive: a warning where the drive does not carry it with the feed override at its highest position.
fn cut(
    lathe: &PolygonLathe,
    axis: PolygonAxis,
    kind: DemandKind,
    told: impl Fn(f64, f64) -> Message,
) -> Option<Judgement> {
    let (asked, limit) = lathe.demand(axis, kind);
    if asked > limit {
        return fail(AtMost(limit), [with_feeds(lathe, axis, kind, 100.0, told(asked, limit))]);
    }
    let (at_highest, limit_there) = lathe.demand_at_override(axis, kind, HIGHEST_FEED);
    if at_highest <= limit_there {
        return ok(AtMost(limit));
    }
    let said = at_knob(kind, at_highest, limit_there);
    warn(AtMost(limit), [with_feeds(lathe, axis, kind, HIGHEST_FEED, said)])
}

/// The heat of the cut against the drive: a warning where only the strikes exceed its continuous torque, for a short cut may do that.
fn heat(lathe: &PolygonLathe, axis: PolygonAxis, told: impl Fn(f64, f64) -> Message) -> Option<Judgement> {
    let kind = DemandKind::Effective;
    let ((asked, limit), (mean, continuous)) = (lathe.demand(axis, kind), lathe.demand(axis, DemandKind::Mean));
    if asked > limit && mean <= continuous {
        return warn(AtMost(limit), [with_feeds(lathe, axis, kind, HIGHEST_FEED, told(asked, limit))]);
    }
    cut(lathe, axis, kind, told)
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

//! Rules about the drives of work and tool: torque and power of the cut, torque of the run-up, each with its remedy.

use crate::drives::cutting;
use crate::machines::form::entry::{NumberEntry, at_least, at_most, field_max};
use crate::machines::lathe::knobs;
use crate::machines::polygon_lathe::axes::PolygonAxis;
use crate::machines::polygon_lathe::demand::DemandKind;
use crate::machines::polygon_lathe::load::{ForceLimits, PolygonFeed};
use crate::machines::polygon_lathe::params::FIELDS;
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::machines::polygon_lathe::turned_end_form::TURNED_ENDS;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::msg;
use crate::text::Message;
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// An advice with lower values for every feed whose cuts exceed a limit of the drive on the lathe `at` a position of
/// the feed override.
fn with_feeds(lathe: &PolygonLathe, at: &PolygonLathe, axis: PolygonAxis, kind: DemandKind, fact: Message) -> Advice {
    let p = &lathe.params;
    let sets = PolygonFeed::ALL.into_iter().filter_map(|feed| {
        let excess = at.excess(axis, kind, feed);
        let share = || cutting::feed_share(1.0 / excess, p.specific().exponent);
        (excess > 1.0).then(|| at_most(FIELDS, feed.field(), feed.entry(p) * share()))
    });
    knobs::setting_feeds(Advice::from(fact), sets.collect())
}

impl PolygonLathe {
    /// Lower entries for the feeds whose cutting force on the lathe `at` a position of the feed override exceeds its limit: of the flats, then
    /// of the turned ends.
    pub(in super::super) fn feeds_below(&self, at: &PolygonLathe, limits: ForceLimits) -> Vec<NumberEntry> {
        let p = &self.params;
        let flats = PolygonFeed::ALL.into_iter().zip(limits.flats);
        let flats = flats.map(|(feed, most)| (feed.field(), feed.entry(p), at.force_at(feed), most));
        let ends = TURNED_ENDS
            .map(|fields| fields.feed)
            .into_iter()
            .zip(p.turned_ends.iter().zip(at.params.turned_ends.iter()))
            .filter(|(_, (end, _))| end.on);
        let ends = ends.map(|(field, (end, fed))| (field, end.feed, at.end_force(fed), limits.ends));
        let lower = |(field, feed, force, most): (&'static str, f64, f64, f64)| {
            let entry = || at_most(FIELDS, field, feed * cutting::feed_share(most / force, p.specific().exponent));
            (force > most).then(entry)
        };
        flats.chain(ends).filter_map(lower).collect()
    }
}

/// Message about a cut that exceeds the drive only with the feed override at its highest position.
fn at_knob(kind: DemandKind, percent: f64, asked: f64, limit: f64) -> Message {
    let percent = (percent, 0);
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

/// Judges the cut against the drive: a warning if it exceeds the drive only with the feed override at its highest
/// position.
fn cut(
    lathe: &PolygonLathe,
    axis: PolygonAxis,
    kind: DemandKind,
    message: impl Fn(f64, f64) -> Message,
) -> Option<Judgement> {
    let (asked, limit) = lathe.demand(axis, kind);
    if asked > limit {
        return fail(AtMost(limit), [with_feeds(lathe, lathe, axis, kind, message(asked, limit))]);
    }
    let fed = lathe.at_highest_feed().map(|(percent, fed)| (percent, fed, fed.demand(axis, kind)));
    match fed.filter(|(_, _, (asked, limit))| asked > limit) {
        Some((percent, fed, (asked, limit_there))) => {
            let warning = at_knob(kind, percent, asked, limit_there);
            warn(AtMost(limit), [with_feeds(lathe, fed, axis, kind, warning)])
        }
        None => ok(AtMost(limit)),
    }
}

/// Judges the effective torque of the cut against the continuous torque of the drive: only a warning if the mean torque
/// is within it, because a short cut may exceed it.
fn heat(lathe: &PolygonLathe, axis: PolygonAxis, message: impl Fn(f64, f64) -> Message) -> Option<Judgement> {
    let kind = DemandKind::Effective;
    let ((asked, limit), (mean, continuous)) = (lathe.demand(axis, kind), lathe.demand(axis, DemandKind::Mean));
    if asked > limit && mean <= continuous {
        let fed = lathe.with_most_feed();
        return warn(AtMost(limit), [with_feeds(lathe, fed, axis, kind, message(asked, limit))]);
    }
    cut(lathe, axis, kind, message)
}

pub(in super::super) fn tool_peak(lathe: &PolygonLathe) -> Option<Judgement> {
    cut(lathe, PolygonAxis::Tool, DemandKind::Peak, |asked, limit| {
        msg!("polygon.tool-stalls", torque = (asked, 1), limit = (limit, 1))
    })
}

pub(in super::super) fn work_peak(lathe: &PolygonLathe) -> Option<Judgement> {
    cut(lathe, PolygonAxis::Work, DemandKind::Peak, |asked, limit| {
        msg!("polygon.work-stalls", torque = (asked, 1), limit = (limit, 1))
    })
}

pub(in super::super) fn tool_effective(lathe: &PolygonLathe) -> Option<Judgement> {
    heat(lathe, PolygonAxis::Tool, |asked, limit| {
        msg!("polygon.tool-overheats", torque = (asked, 2), limit = (limit, 2))
    })
}

pub(in super::super) fn work_effective(lathe: &PolygonLathe) -> Option<Judgement> {
    heat(lathe, PolygonAxis::Work, |asked, limit| {
        msg!("polygon.work-overheats", torque = (asked, 2), limit = (limit, 2))
    })
}

pub(in super::super) fn tool_power(lathe: &PolygonLathe) -> Option<Judgement> {
    cut(lathe, PolygonAxis::Tool, DemandKind::Power, |asked, limit| {
        msg!("polygon.tool-lacks-power", power = (asked, 3), limit = (limit, 3))
    })
}

pub(in super::super) fn work_power(lathe: &PolygonLathe) -> Option<Judgement> {
    cut(lathe, PolygonAxis::Work, DemandKind::Power, |asked, limit| {
        msg!("polygon.work-lacks-power", power = (asked, 3), limit = (limit, 3))
    })
}

/// Ramp (ms) beyond which an emergency stop in ratio takes noticeably long. Source: engineering choice.
const LONG_RAMP: f64 = 1000.0;

/// Judges the run-up against the drive, also with a feed override that turns work and tool faster. The remedy is one ramp for both axes, so
/// that they keep their ratio on it; it lengthens an emergency stop.
fn run_up(lathe: &PolygonLathe, axis: PolygonAxis, message: impl Fn(f64, f64) -> Message) -> Option<Judgement> {
    let p = &lathe.params;
    let kind = DemandKind::RunUp;
    let (asked, limit) = lathe.demand(axis, kind);
    if limit <= 0.0 {
        let drive = p.fastest_drive(axis);
        let torque = (drive.motor.torque(drive.speed) * p.drive_peak / 100.0, 1);
        return fail(AtMost(limit), [msg!("lathe.friction-stalls", friction = (drive.friction, 1), torque).into()]);
    }
    let ramp = (1000.0 * lathe.with_most_feed().ramp()).max(p.axes.work.time_constant).max(p.axes.tool.time_constant);
    let with_ramp = |fact: Message| {
        let advice = Advice::from(fact);
        if ramp > field_max(FIELDS, "work-time-constant") {
            return vec![advice];
        }
        let sets = ["work-time-constant", "tool-time-constant"].map(|field| at_least(FIELDS, field, ramp));
        let slow = (ramp > LONG_RAMP).then(|| msg!("polygon.long-ramp", seconds = (ramp / 1000.0, 1)).into());
        let button = msg!("advice.set-ramps", time = sets[0].text.as_str());
        [advice.setting(button, sets)].into_iter().chain(slow).collect()
    };
    if asked > limit {
        return fail(AtMost(limit), with_ramp(message(asked, limit)));
    }
    let fed = lathe.at_highest_feed().map(|(percent, fed)| (percent, fed.demand(axis, kind)));
    match fed.filter(|(_, (asked, limit))| asked > limit) {
        Some((percent, (asked, limit_there))) => {
            let (percent, torque) = ((percent, 0), (asked, 1));
            let fact = msg!("polygon.run-up-at-feed-knob", percent, torque, limit = (limit_there, 1));
            warn(AtMost(limit), with_ramp(fact))
        }
        None => ok(AtMost(limit)),
    }
}

pub(in super::super) fn tool_run_up(lathe: &PolygonLathe) -> Option<Judgement> {
    run_up(lathe, PolygonAxis::Tool, |asked, limit| {
        msg!("polygon.tool-ramp-short", torque = (asked, 1), limit = (limit, 1))
    })
}

pub(in super::super) fn work_run_up(lathe: &PolygonLathe) -> Option<Judgement> {
    run_up(lathe, PolygonAxis::Work, |asked, limit| {
        msg!("polygon.work-ramp-short", torque = (asked, 1), limit = (limit, 1))
    })
}

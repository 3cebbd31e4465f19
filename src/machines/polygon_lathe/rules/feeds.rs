//! The rules of the feeds: against the clamps of the slides, and their marks against the width of the insert.

use crate::machines::form::entry::at_most;
use crate::machines::polygon_lathe::params::FIELDS;
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::msg;
use crate::text::Message;
use crate::view::Advice;
use crate::view::Limit::AtMost;

pub(super) fn clamp(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    within_clamp("feed", p.feed, d.feeds.rough, p.slides.z.clamp)
}

pub(super) fn finish_clamp(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    within_clamp("finish-feed", p.finish_feed, d.feeds.finish, p.slides.z.clamp)
}

pub(super) fn infeed_clamp(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    within_clamp("infeed", p.infeed, d.feeds.infeed, p.slides.x.clamp)
}

/// The marks of the last pass against the width of the insert.
pub(super) fn finish_marks(lathe: &PolygonLathe) -> Option<Judgement> {
    within_insert(lathe, 1, ("finish-feed", lathe.params.finish_feed))
}

/// The marks of roughing against the width of the insert.
pub(super) fn rough_marks(lathe: &PolygonLathe) -> Option<Judgement> {
    within_insert(lathe, 0, ("feed", lathe.params.feed))
}

/// Judges the distance of the marks (roughing 0, last pass 1) of a feed: an insert narrower than it leaves ridges of the stock between its
/// cuts. With a feed override that does not act on the work the marks grow with the knob.
fn within_insert(lathe: &PolygonLathe, pass: usize, (field, feed): (&'static str, f64)) -> Option<Judgement> {
    let width = lathe.params.insert_width;
    let (pitch, limit) = (lathe.mark_pitches()[pass], AtMost(width));
    let setting = |message: Message, pitch: f64| {
        let set = at_most(FIELDS, field, feed * width / pitch);
        let advice = Advice::from(message);
        if set.value > 0.0 { advice.setting(msg!("advice.set-feed", feed = set.text.as_str()), [set]) } else { advice }
    };
    if pitch > width {
        let message = msg!("polygon.ridges", pitch = (pitch, 3), width = (width, 3));
        return fail(limit, [setting(message, pitch)]);
    }
    let fed = lathe.at_highest_feed().map(|(percent, fed)| (percent, fed.mark_pitches()[pass]));
    match fed.filter(|(_, pitch)| *pitch > width) {
        Some((percent, pitch)) => {
            let message =
                msg!("polygon.ridges-at-knob", percent = (percent, 0), pitch = (pitch, 3), width = (width, 3));
            warn(limit, [setting(message, pitch)])
        }
        None => ok(limit),
    }
}

/// Judges the feed of a field (mm/min) against the clamp of the slide.
fn within_clamp(field: &'static str, per_turn: f64, feed: f64, clamp: f64) -> Option<Judgement> {
    if feed <= clamp {
        return ok(AtMost(clamp));
    }
    let set = at_most(FIELDS, field, per_turn * clamp / feed);
    let advice = Advice::from(msg!("polygon.above-clamp", feed = (feed, 0), clamp = (clamp, 0)));
    fail(AtMost(clamp), [advice.setting(msg!("advice.set-feed", feed = set.text.as_str()), [set])])
}

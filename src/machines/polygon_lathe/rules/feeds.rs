//! The rules of the feeds against the clamps of the slides.

use crate::machines::form::entry::at_most;
use crate::machines::polygon_lathe::params::FIELDS;
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::machines::verdict::{Judgement, fail, ok};
use crate::msg;
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

/// Judges the feed of a field (mm/min) against the clamp of the slide.
fn within_clamp(field: &'static str, per_turn: f64, feed: f64, clamp: f64) -> Option<Judgement> {
    if feed <= clamp {
        return ok(AtMost(clamp));
    }
    let set = at_most(FIELDS, field, per_turn * clamp / feed);
    let advice = Advice::from(msg!("polygon.above-clamp", feed = (feed, 0), clamp = (clamp, 0)));
    fail(AtMost(clamp), [advice.setting(msg!("advice.set-feed", feed = set.text.as_str()), [set])])
}

//! Demands of the cut at all positions of the knobs of feed and spindle.

use super::remedies::{slower_feed, with_feed};
use crate::machines::lathe::knobs;
use crate::machines::turning_spindle::resolved::{CutAtKnobs, TurningSpindle};
use crate::machines::verdict::{Judgement, ok, warn};
use crate::text::Message;
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// Demand of the cut at positions of the knobs, and its limit.
pub(super) type Demand = fn(&CutAtKnobs) -> (f64, f64);

/// Judges a demand that is within its limit at the form's positions of the knobs: a warning if it is beyond the limit
/// at another position, with a feed that keeps the limit at all positions.
pub(super) fn at_knobs(
    lathe: &TurningSpindle,
    limit: f64,
    demand: Demand,
    message: impl Fn(&CutAtKnobs, (f64, f64)) -> Message,
) -> Option<Judgement> {
    match knobs::worst(lathe.cuts_at_knobs(), demand) {
        Some((cut, numbers)) => warn(AtMost(limit), [with_slower_feed(lathe, demand, message(&cut, numbers))]),
        None => ok(AtMost(limit)),
    }
}

/// An advice with a button for the greatest feed that keeps a demand within its limit at every position of the knobs,
/// if less feed lowers the demand.
pub(super) fn with_slower_feed(lathe: &TurningSpindle, demand: Demand, message: Message) -> Advice {
    match slower_feed(lathe, |slower| knobs::worst(slower.cuts_at_knobs(), demand).is_none()) {
        Some(share) => with_feed(lathe, share, message),
        None => message.into(),
    }
}

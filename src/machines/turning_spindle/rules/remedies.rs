//! Advice with less feed or less depth, and the greatest feed at which a condition holds.

use crate::drives::cutting::LEAST_DEPTH;
use crate::machines::form::entry::at_most;
use crate::machines::lathe::materials::Material;
use crate::machines::turning_spindle::derive::PASSES;
use crate::machines::turning_spindle::params::{FIELDS, Params};
use crate::machines::turning_spindle::resolved::TurningSpindle;
use crate::math;
use crate::msg;
use crate::text::Message;
use crate::view::Advice;

/// Advice with a button for `share` of the present feed.
pub(super) fn with_feed(lathe: &TurningSpindle, share: f64, message: Message) -> Advice {
    let set = at_most(FIELDS, "feed", lathe.params.feed * share);
    Advice::from(message).setting(msg!("advice.set-feed", feed = set.text.as_str()), [set])
}

/// Advice with a button for `share` of the present depth, if the force follows from the depth and the number of passes
/// stays within its limit.
pub(super) fn with_depth(lathe: &TurningSpindle, share: f64, message: Message) -> Advice {
    let advice = Advice::from(message);
    // With more passes the first one is at a larger diameter, up to that of the stock.
    let grows = lathe.params.stock_diameter / lathe.params.middle_of_edge(lathe.derived.cut.largest_whole);
    let set = at_most(FIELDS, "depth", lathe.params.depth * share / grows);
    let depth = set.value;
    let passes = Params { depth, ..lathe.params.clone() };
    if lathe.params.material == Material::None || depth < LEAST_DEPTH || passes.passes() >= PASSES {
        return advice;
    }
    advice.setting(msg!("advice.set-depth", depth = set.text.as_str()), [set])
}

/// Least share of the present feed that an advice offers.
const LEAST_FEED: f64 = 0.1;

/// Greatest share of the present feed at which a condition holds; none where less feed does not help.
pub(super) fn slower_feed(lathe: &TurningSpindle, holds: impl Fn(&TurningSpindle) -> bool) -> Option<f64> {
    let slower = |share: f64| lathe.with(Params { feed: lathe.form.feed * share, ..lathe.form.clone() });
    math::greatest_share(LEAST_FEED, |share| holds(&slower(share)))
}

//! Advice with less feed or less depth, and the greatest feed at which a condition holds.

use crate::drives::cutting::LEAST_DEPTH;
use crate::machines::form::entry::{NumberEntry, at_most};
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

/// Button and entry of the change with which a condition holds and the cut is the shorter one: a lower limit of constant surface speed, or less
/// feed. None where neither helps.
pub(super) fn slower_cut(
    lathe: &TurningSpindle,
    holds: &dyn Fn(&TurningSpindle) -> bool,
) -> Option<(Message, NumberEntry)> {
    let seconds = |form: Params| lathe.with(form).derived.times.cutting;
    let feed = slower_feed(lathe, holds).map(|share| {
        let set = at_most(FIELDS, "feed", lathe.params.feed * share);
        let after = seconds(Params { feed: set.value, ..lathe.form.clone() });
        (after, msg!("advice.set-feed", feed = set.text.as_str()), set)
    });
    let limit = slower_limit(lathe, holds).map(|limit| {
        let set = at_most(FIELDS, "upper-limit", limit);
        let after = seconds(Params { upper_limit: set.value, ..lathe.form.clone() });
        (after, msg!("advice.limit-speed", speed = set.text.as_str()), set)
    });
    let shorter = [limit, feed].into_iter().flatten().reduce(|best, next| if next.0 < best.0 { next } else { best });
    shorter.map(|(_, button, set)| (button, set))
}

/// Least share of the present speed limit that an advice offers.
const LEAST_LIMIT: f64 = 0.05;

/// Greatest whole limit (r/min) of constant surface speed at which a condition holds; none where a lower limit does not help.
fn slower_limit(lathe: &TurningSpindle, holds: impl Fn(&TurningSpindle) -> bool) -> Option<f64> {
    let present = lathe.form.upper_limit;
    let with = |upper_limit: f64| lathe.with(Params { upper_limit, ..lathe.form.clone() });
    let share = math::greatest_share(LEAST_LIMIT, |share| holds(&with((present * share).floor())));
    share.filter(|_| lathe.surface()).map(|share| (present * share).floor())
}

/// Least share of the present feed that an advice offers.
const LEAST_FEED: f64 = 0.1;

/// Greatest share of the present feed at which a condition holds; none where less feed does not help.
pub(super) fn slower_feed(lathe: &TurningSpindle, holds: impl Fn(&TurningSpindle) -> bool) -> Option<f64> {
    let slower = |share: f64| lathe.with(Params { feed: lathe.form.feed * share, ..lathe.form.clone() });
    math::greatest_share(LEAST_FEED, |share| holds(&slower(share)))
}

//! The advice to calculate the published listing before its loop, for lines on which blocks starve in it.

use super::params::{Params, Variant};
use crate::msg;
use crate::view::Advice;

/// An advice to calculate the published listing before its loop, if its passes then take no longer than the control has time for.
pub(super) fn calculated_once(p: &Params, in_time: impl Fn(f64) -> bool) -> Option<Advice> {
    let needed = Params { variant: Variant::Precomputed, ..p.clone() }.pass_needed() * 1000.0;
    let advice = Advice::from(msg!("ribbon.precomputed-in-time", needed = (needed, 1)));
    (p.variant == Variant::Published && in_time(needed))
        .then(|| advice.setting(msg!("advice.precomputed"), [("variant", "precomputed")]))
}

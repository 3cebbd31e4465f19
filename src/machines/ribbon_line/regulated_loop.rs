//! The loop that the regulator of a dancer keeps from product to product: its set point, and the ribbon that earlier products leave.

use super::derive::{Derived, greatest};
use super::knob_turn::KnobTurn;
use super::params::Params;
use crate::drives::speed::KnobRange;
use crate::math;

/// Halvings of the interval in which the loop of many products is sought: to less than a micrometre.
const HALVINGS: u32 = 40;

/// Enters the loop that a regulator keeps into the results with the knob as it is, at its highest and at its lowest position; nothing without
/// regulator.
pub(super) fn keep(p: &Params, knob: KnobRange, over_knob: &mut [Derived; 3]) {
    if p.loop_trim() <= 0.0 {
        return;
    }
    let [_, fast, slow] = &*over_knob;
    let set_point = set_point(p, &KnobTurn::new(p, knob.low <= 0.0, slow, fast), over_knob);
    let before = greatest(&*over_knob, |d| set_point + left_by_products(p, d));
    let standing = if p.knob_turns_alone() { standing(p, &over_knob[0], fast).max(0.0) } else { 0.0 };
    for d in over_knob {
        d.slack.keep(set_point, before, standing);
    }
}

/// Ribbon (mm) beyond the set point that stands in the loop while a knob turns the unwinder alone from n to n_k r/min and a regulator trims the
/// difference away: `-s_r · (n / n_k - 1) / λ`, at most the range s_r of the trim λ. Source: ribbon line facts, 7.
pub(super) fn standing(p: &Params, now: &Derived, turned: &Derived) -> f64 {
    if turned.unwinder.actual <= 0.0 || p.loop_trim() <= 0.0 {
        return 0.0;
    }
    let trim = now.unwinder.actual / turned.unwinder.actual - 1.0;
    -p.loop_trim_range() * math::clamp(trim / p.loop_trim(), -1.0, 1.0)
}

/// Slack (mm) that the regulator keeps: the loop that a start leaves at any position of the knob, and at least the ribbon that a start or one
/// turn of the knob misses, this at most the band in which the trim grows. Source: ribbon line facts, 7.
fn set_point(p: &Params, turn: &KnobTurn, over_knob: &[Derived; 3]) -> f64 {
    let least = over_knob.iter().map(|d| d.slack.start).fold(f64::INFINITY, f64::min);
    let by_turn = if turn.acts() { turn.missing() } else { 0.0 };
    let missing = greatest(over_knob, |d| d.slack.missing).max(by_turn);
    least.max(missing.min(p.loop_trim_range())).max(0.0)
}

/// Ribbon (mm) beyond the set point that many products leave in the loop before the next one; infinite where the loop grows with each product.
/// A product adds start and stop, a, and takes ribbon away while it runs: `x = D(x) + a` after the start, and `x - start` before it. Source:
/// ribbon line facts, 7.
fn left_by_products(p: &Params, d: &Derived) -> f64 {
    if d.unwinder.actual <= 0.0 {
        return 0.0;
    }
    let added = d.slack.start + d.slack.stop;
    let (range, most) = (p.loop_trim_range(), p.loop_trim() * d.product.length);
    let left = |beyond: f64| left_after_run(beyond, range, most);
    let linear = added / (1.0 - math::exp(-most / range));
    let beyond = if added >= most {
        f64::INFINITY
    } else if linear <= range {
        linear
    } else {
        math::bisect(range, range + most, HALVINGS, |middle| middle - left(middle) < added).1
    };
    beyond - d.slack.start
}

/// Ribbon (mm) left of that beyond the set point, x, after the run of a product: `D(x) = x · e^(-λ l / s_r)`; beyond the range s_r the trim λ
/// takes `λ · l` of the length l. `most` is `λ · l`.
fn left_after_run(beyond: f64, range: f64, most: f64) -> f64 {
    let at_limit = math::clamp(beyond - range, 0.0, most);
    (beyond - at_limit) * math::exp(-(most - at_limit) / range)
}

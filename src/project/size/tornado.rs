//! Tornado: assumed facts that move the results nearest to their limits, and how far.
//! A fact may move the result or its limit: the measure is the share of the limit that the result uses.

use crate::project::sensitivity::Sensitivity;
use crate::view::{Limit, Readout};

/// Number of results with a tornado.
const RESULTS: usize = 3;

/// Greatest number of facts shown for a result.
const FACTS: usize = 8;

/// Least change of a share that shows in its rounded text.
const LEAST: f64 = 5e-4;

/// The share of its limit that a result uses when an assumed fact changes by a tenth; 1 is at the limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swing {
    /// Id of the fact's field.
    pub field: &'static str,
    /// Catalog id of its label.
    pub label: &'static str,
    /// The share with nine tenths of the fact.
    pub low: f64,
    /// The share with eleven tenths of it.
    pub high: f64,
}

/// A result and the facts that move it, the strongest first.
#[derive(Debug, Clone, PartialEq)]
pub struct Tornado {
    /// The result.
    pub readout: Readout,
    /// The share of its limit that it uses.
    pub share: f64,
    /// At least one.
    pub swings: Vec<Swing>,
}

/// The tornadoes of the results nearest to their limits or farthest beyond, the worst first.
pub(super) fn tornadoes(of: &Sensitivity) -> Vec<Tornado> {
    let mut judged: Vec<(f64, &Readout)> =
        of.before.iter().filter_map(|readout| Some((share(readout)?, readout))).collect();
    judged.sort_by(|a, b| b.0.total_cmp(&a.0));
    let tornado = |(share, readout): (f64, &Readout)| {
        let swings = swings(of, readout, share);
        (!swings.is_empty()).then(|| Tornado { readout: readout.clone(), share, swings })
    };
    judged.into_iter().filter_map(tornado).take(RESULTS).collect()
}

/// Share of its limit that a result uses, 1 at the limit; none without a limit, or with one that cannot be used up.
fn share(readout: &Readout) -> Option<f64> {
    let share = match readout.limit? {
        Limit::AtMost(most) | Limit::Within(most) => readout.value / most,
        Limit::AtLeast(least) => least / readout.value,
        Limit::Equal(_) => return None,
    };
    share.is_finite().then(|| share.abs())
}

/// The facts that move a result from this share, the strongest first.
fn swings(of: &Sensitivity, readout: &Readout, now: f64) -> Vec<Swing> {
    let mut found: Vec<Swing> = of
        .facts
        .iter()
        .map(|fact| {
            let at = |factor: f64| {
                let after = fact.after.iter().find(|after| after.0 == factor);
                after.and_then(|after| after.1.iter().find(|row| row.id == readout.id)).and_then(share).unwrap_or(now)
            };
            Swing { field: fact.field, label: fact.label, low: at(0.9), high: at(1.1) }
        })
        .filter(|swing| swing.reach(now) > LEAST)
        .collect();
    found.sort_by(|a, b| b.reach(now).total_cmp(&a.reach(now)));
    found.truncate(FACTS);
    found
}

impl Swing {
    /// Greatest change of the share from `now`.
    fn reach(&self, now: f64) -> f64 {
        (self.low - now).abs().max((self.high - now).abs())
    }
}

//! Results and rules of the cut-to-length feeder.

use macroline::machines::verdict::{Judgement, ReadoutRow, Rule, fail, ok};
use macroline::msg;
use macroline::text::{Citation, Diagnostic, Grade};
use macroline::view::Limit;

use super::params::Feed;
use super::resolved::CutToLength;

const MECHANICS: Citation = Citation::new("mechanics", Grade::Inferred);

/// Results in the order they are shown; the headline ones first.
#[rustfmt::skip]
pub(super) const READOUTS: &[ReadoutRow<CutToLength>] = &[
    ReadoutRow {
        id: "piece-time", label: "toy.readout.piece-time", unit: "s", decimals: 3, headline: true,
        formula: "60 L / v + τ + t cut", cite: MECHANICS, value: |feeder| feeder.derived.piece_time, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "output", label: "toy.readout.output", unit: "1/h", decimals: 0, headline: true,
        formula: "3600 / t", cite: MECHANICS, value: |feeder| feeder.derived.output, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "speed", label: "toy.readout.speed", unit: "mm/min", decimals: 0,
        formula: "v", cite: MECHANICS, value: |feeder| feeder.derived.speed, ..ReadoutRow::BASE
    },
];

/// All rules.
pub(super) const RULES: &[Rule<CutToLength>] =
    &[Rule::new("speed", within_clamp, Citation::new("cutting feed clamp, a parameter", Grade::Inferred))];

/// The axis reaches the feed.
fn within_clamp(feeder: &CutToLength) -> Option<Judgement> {
    let clamp = feeder.params.clamp;
    let limit = Limit::AtMost(clamp);
    if feeder.derived.speed > clamp { fail(limit, [msg!("toy.above-clamp", clamp).into()]) } else { ok(limit) }
}

/// Errors that keep the program from being exported.
pub(super) fn findings(feeder: &CutToLength) -> Vec<Diagnostic> {
    let most = feeder.control.limits.feed_max;
    if feeder.params.feed == Feed::Cutting && feeder.params.speed > most {
        return vec![Diagnostic::error(msg!("toy.feed-above-range", feed = feeder.params.speed, most)).about("speed")];
    }
    Vec::new()
}

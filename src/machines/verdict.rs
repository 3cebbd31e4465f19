//! Results as rows, and the rules that judge them.

use crate::text::{Citation, Grade, Phrase};
use crate::view::{Advice, Limit, Readout, Verdict};

/// Whether a machine `M` has the other unit of a result, and that unit.
pub type OtherUnit<M> = (fn(&M) -> bool, &'static str);

/// A result of a machine `M` before it is judged.
pub struct ReadoutRow<M> {
    /// Id, for instance `line-speed`.
    pub id: &'static str,
    /// Catalog id of the label.
    pub label: &'static str,
    /// Unit, or empty.
    pub unit: &'static str,
    /// Decimals shown.
    pub decimals: u8,
    /// The formula as text.
    pub formula: &'static str,
    /// Source of the formula.
    pub cite: Citation,
    /// Whether the result is one of the headline results above the drawing.
    pub headline: bool,
    /// The value.
    pub value: fn(&M) -> f64,
    /// Whether the result applies to the form.
    pub shown: fn(&M) -> bool,
    /// Another unit: degrees of a rotary axis in place of mm.
    pub other_unit: Option<OtherUnit<M>>,
}

impl<M> ReadoutRow<M> {
    /// A row whose id, label, unit, formula, source and value are to be filled in: `ReadoutRow { id: "feed", …, ..ReadoutRow::BASE }`.
    pub const BASE: ReadoutRow<M> = ReadoutRow {
        id: "",
        label: "",
        unit: "",
        decimals: 0,
        formula: "",
        cite: Citation { source: Phrase::NONE, grade: Grade::Open },
        headline: false,
        value: |_| 0.0,
        shown: |_| true,
        other_unit: None,
    };

    /// Its unit for this form.
    fn unit(&self, machine: &M) -> &'static str {
        self.other_unit.filter(|(has_it, _)| has_it(machine)).map_or(self.unit, |(_, unit)| unit)
    }
}

/// The judgement of one rule.
pub struct Judgement {
    /// Whether the result holds.
    pub verdict: Verdict,
    /// The limit that it was compared with.
    pub limit: Option<Limit>,
    /// Remedies, and facts to know.
    pub advice: Vec<Advice>,
}

/// A rule about a result of a machine `M`.
pub struct Rule<M> {
    /// Id of the result.
    on: &'static str,
    /// Source of the limit.
    cite: Citation,
    /// Judges the result; `None` where the rule does not apply.
    judge: fn(&M) -> Option<Judgement>,
}

impl<M> Rule<M> {
    /// A row of the rules: the result, its judgement, the source of the limit.
    pub const fn new(on: &'static str, judge: fn(&M) -> Option<Judgement>, cite: Citation) -> Rule<M> {
        Rule { on, cite, judge }
    }
}

/// The result holds.
pub fn ok(limit: impl Into<Option<Limit>>) -> Option<Judgement> {
    judgement(Verdict::Ok, limit, [])
}

/// The result deserves attention.
pub fn warn(limit: impl Into<Option<Limit>>, advice: impl Into<Vec<Advice>>) -> Option<Judgement> {
    judgement(Verdict::Warn, limit, advice)
}

/// The result fails.
pub fn fail(limit: impl Into<Option<Limit>>, advice: impl Into<Vec<Advice>>) -> Option<Judgement> {
    judgement(Verdict::Fail, limit, advice)
}

fn judgement(verdict: Verdict, limit: impl Into<Option<Limit>>, advice: impl Into<Vec<Advice>>) -> Option<Judgement> {
    Some(Judgement { verdict, limit: limit.into(), advice: advice.into() })
}

/// The results that apply to the form, each with the judgement of every rule about it.
pub fn results<M>(rows: &[ReadoutRow<M>], machine: &M, rules: &[Rule<M>]) -> impl Iterator<Item = Readout> {
    rows.iter().filter(|row| (row.shown)(machine)).map(|row| judge(row, machine, rules))
}

/// A result with the judgement of every rule about it: the worst verdict, all advice.
pub fn judge<M>(row: &ReadoutRow<M>, machine: &M, rules: &[Rule<M>]) -> Readout {
    let mut readout = Readout {
        id: row.id,
        label: row.label,
        value: (row.value)(machine),
        unit: row.unit(machine),
        decimals: row.decimals,
        limit: None,
        verdict: Verdict::None,
        advice: Vec::new(),
        formula: Phrase::new(row.formula),
        cite: row.cite,
        headline: row.headline,
    };
    for rule in rules.iter().filter(|rule| rule.on == row.id) {
        let Some(judgement) = (rule.judge)(machine) else { continue };
        if judgement.verdict >= readout.verdict {
            readout.cite = rule.cite;
        }
        readout.verdict = readout.verdict.max(judgement.verdict);
        readout.limit = readout.limit.or(judgement.limit);
        readout.advice.extend(judgement.advice);
    }
    readout.advice = each_button_once(readout.advice);
    readout
}

/// Keeps the button of a remedy at the first advice that has it, and removes it from later ones: a short sentence may
/// come before the full one.
fn each_button_once(mut advice: Vec<Advice>) -> Vec<Advice> {
    for at in 1..advice.len() {
        let (before, rest) = advice.split_at_mut(at);
        if let Some(next) = rest.first_mut()
            && before.iter().any(|of| of.entries == next.entries)
        {
            (next.button, next.entries) = (None, Vec::new());
        }
    }
    advice
}

//! Results of a machine as rows, and the rules that judge them: for every machine.

use crate::text::{Citation, Message};
use crate::view::{Readout, Verdict};

/// What the rows of a machine are about.
pub(super) trait Rows: 'static {
    /// The machine on its control.
    type Resolved<'a>;
    /// What follows from its inputs.
    type Derived;
    /// What its rules judge.
    type Case<'a>;
}

/// A result before it is judged.
pub(super) struct Row<M: Rows> {
    pub(super) id: &'static str,
    pub(super) label: &'static str,
    pub(super) unit: &'static str,
    pub(super) decimals: u8,
    pub(super) formula: &'static str,
    pub(super) cite: Citation,
    pub(super) headline: bool,
    pub(super) value: fn(&M::Derived) -> f64,
}

/// The judgement of one rule.
pub(super) struct Judgement {
    pub(super) verdict: Verdict,
    pub(super) limit: Option<f64>,
    pub(super) advice: Vec<Message>,
}

/// A rule about a result.
pub(super) struct Rule<M: Rows> {
    /// Id of the result that it judges.
    pub(super) on: &'static str,
    /// Where its limit comes from.
    pub(super) cite: Citation,
    /// The judgement; `None` where the rule has nothing to say.
    pub(super) judge: fn(&M::Case<'_>) -> Option<Judgement>,
}

/// A row of the rules: the result that it judges, the judgement, where its limit comes from.
macro_rules! rule {
    ($on:literal, $judge:expr, $source:literal, $grade:ident) => {
        $crate::machines::verdict::Rule {
            on: $on,
            cite: $crate::text::Citation::new($source, $crate::text::Grade::$grade),
            judge: $judge,
        }
    };
}

pub(super) use rule;

/// It holds.
pub(super) fn ok(limit: impl Into<Option<f64>>) -> Option<Judgement> {
    Some(Judgement { verdict: Verdict::Ok, limit: limit.into(), advice: Vec::new() })
}

/// To be thought about.
pub(super) fn warn(limit: impl Into<Option<f64>>, advice: impl Into<Vec<Message>>) -> Option<Judgement> {
    Some(Judgement { verdict: Verdict::Warn, limit: limit.into(), advice: advice.into() })
}

/// It fails.
pub(super) fn fail(limit: impl Into<Option<f64>>, advice: impl Into<Vec<Message>>) -> Option<Judgement> {
    Some(Judgement { verdict: Verdict::Fail, limit: limit.into(), advice: advice.into() })
}

/// A result with the judgement of every rule about it: the worst verdict, all advice.
pub(super) fn judge<M: Rows>(
    row: &Row<M>,
    derived: &M::Derived,
    unit: &'static str,
    rules: &[Rule<M>],
    case: &M::Case<'_>,
) -> Readout {
    let mut readout = Readout {
        id: row.id,
        label: row.label,
        value: (row.value)(derived),
        unit,
        decimals: row.decimals,
        limit: None,
        verdict: Verdict::None,
        advice: Vec::new(),
        formula: row.formula,
        cite: row.cite,
        headline: row.headline,
    };
    for rule in rules.iter().filter(|rule| rule.on == row.id) {
        let Some(judgement) = (rule.judge)(case) else { continue };
        if judgement.verdict >= readout.verdict {
            readout.cite = rule.cite;
        }
        readout.verdict = readout.verdict.max(judgement.verdict);
        readout.limit = readout.limit.or(judgement.limit);
        readout.advice.extend(judgement.advice);
    }
    readout
}

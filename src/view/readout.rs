//! A result with its unit, limit, verdict, advice and formula.

use serde::Serialize;

use super::field_entry::FieldEntry;
use crate::msg;
use crate::text::catalog::{sentence, words};
use crate::text::number::{decimals_of_four, figure, four_digits};
use crate::text::{Citation, Message, MessageValue, Phrase, clauses, units};

/// Greatest number of decimals that tell a value from the limit that it exceeds.
const MOST_DECIMALS: u8 = 6;

/// Engineering verdict of a result. It never prevents the export of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Without a verdict.
    None,
    /// Within its limit.
    Ok,
    /// Questionable.
    Warn,
    /// Not feasible as entered.
    Fail,
}

impl Verdict {
    /// Sign, so that colour is not the only mark; empty without a verdict.
    pub fn sign(self) -> &'static str {
        match self {
            Verdict::None => "",
            Verdict::Ok => "✓",
            Verdict::Warn => "▲",
            Verdict::Fail => "✕",
        }
    }
}

/// The limit of a result, in its unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Limit {
    /// Greatest value.
    AtMost(f64),
    /// Least value.
    AtLeast(f64),
    /// Greatest magnitude of a value of either sign.
    Within(f64),
    /// The required value, within the tolerance of the rule.
    Equal(f64),
}

impl Limit {
    /// The number of the limit.
    pub fn value(self) -> f64 {
        match self {
            Limit::AtMost(value) | Limit::AtLeast(value) | Limit::Within(value) | Limit::Equal(value) => value,
        }
    }

    /// The limit with a converted number.
    fn map(self, number: impl FnOnce(f64) -> f64) -> Limit {
        match self {
            Limit::AtMost(value) => Limit::AtMost(number(value)),
            Limit::AtLeast(value) => Limit::AtLeast(number(value)),
            Limit::Within(value) => Limit::Within(number(value)),
            Limit::Equal(value) => Limit::Equal(number(value)),
        }
    }

    /// Whether a value is within the limit.
    pub fn holds(self, value: f64) -> bool {
        match self {
            Limit::AtMost(most) => value <= most,
            Limit::AtLeast(least) => value >= least,
            Limit::Within(most) => value.abs() <= most,
            Limit::Equal(wanted) => value == wanted,
        }
    }

    /// Load of a value on a limit: of two values the one with the greater load is worse. Without a limit the greater value is worse.
    pub fn load(limit: Option<Limit>, value: f64) -> f64 {
        match limit {
            Some(Limit::AtLeast(_)) => -value,
            Some(Limit::Within(_)) => value.abs(),
            Some(Limit::AtMost(_) | Limit::Equal(_)) | None => value,
        }
    }

    /// Id of the direction for programs: `most`, `least`, `within` or `equal`.
    pub fn bound(self) -> &'static str {
        match self {
            Limit::AtMost(_) => "most",
            Limit::AtLeast(_) => "least",
            Limit::Within(_) => "within",
            Limit::Equal(_) => "equal",
        }
    }

    /// Sign before the number of the limit: `≤`.
    pub fn sign(self) -> &'static str {
        match self {
            Limit::AtMost(_) => "≤",
            Limit::AtLeast(_) => "≥",
            Limit::Within(_) => "±",
            Limit::Equal(_) => "=",
        }
    }

    /// The limit as a phrase, `at most 20000`; `shown` is its number as text.
    pub fn message(self, shown: String) -> Message {
        match self {
            Limit::AtMost(_) => msg!("readout.at-most", limit = shown),
            Limit::AtLeast(_) => msg!("readout.at-least", limit = shown),
            Limit::Within(_) => msg!("readout.within", limit = shown),
            Limit::Equal(_) => msg!("readout.exactly", limit = shown),
        }
    }
}

/// A remedy or a fact about a result, and the form entries that carry out the remedy.
#[derive(Debug, Clone, PartialEq)]
pub struct Advice {
    /// The sentence.
    pub message: Message,
    /// Short text of the remedy for a button; `None` if `entries` is empty.
    pub button: Option<Message>,
    /// Entries of the form; empty if the form cannot carry out the remedy.
    pub entries: Vec<FieldEntry>,
}

impl Advice {
    /// Adds a remedy: text of the button, and the form entries.
    pub fn setting<E: Into<FieldEntry>>(self, button: Message, entries: impl IntoIterator<Item = E>) -> Advice {
        Advice { button: Some(button), entries: entries.into_iter().map(E::into).collect(), ..self }
    }
}

impl Advice {
    /// The note that the preceding remedy makes another result fail; `label` is that result's.
    pub fn turns_red(label: &'static str) -> Advice {
        Advice::from(msg!("advice.turns-red", result = MessageValue::Label(label)))
    }
}

/// A change of the form.
#[derive(Debug, Clone, PartialEq)]
pub struct Repair {
    /// The change in words: a number with its field, else those of the remedy’s button.
    pub text: Message,
    /// Entries of the form.
    pub entries: Vec<FieldEntry>,
}

/// Changes of the form with which the failing results of a design hold.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Repairs {
    /// The changes, in the order in which they were found.
    pub changes: Vec<Repair>,
    /// Number of results that still fail with all of them.
    pub still_failing: usize,
    /// Number of errors that stay with all of them: the export is refused.
    pub errors: usize,
    /// Results that are to be checked with all of them, and were not before: id, and catalog id of the label.
    pub new_warnings: Vec<(&'static str, &'static str)>,
}

impl Repairs {
    /// The changes in words.
    pub fn texts(&self) -> Vec<String> {
        self.changes.iter().map(|change| sentence(&change.text)).collect()
    }

    /// The changes, and the results that they leave to be checked; empty where no change helps.
    pub fn messages(&self) -> Vec<Message> {
        self.message().into_iter().chain(self.warning()).collect()
    }

    /// The changes with which every result holds, or all but some, and the errors that stay; none where no change helps.
    fn message(&self) -> Option<Message> {
        let texts = self.texts();
        let (count, changes) = (texts.len() as u32, clauses(&texts));
        match (count, self.still_failing as u32, self.errors as u32) {
            (0, ..) => None,
            (_, 0, 0) => Some(msg!("form.report.changes", count, changes)),
            (_, 0, errors) => Some(msg!("form.report.changes-errors", count, changes, errors)),
            (_, left, _) => Some(msg!("form.report.changes-left", count, changes, left)),
        }
    }

    /// The results that the changes leave to be checked; none without any.
    pub fn warning(&self) -> Option<Message> {
        let results = clauses(self.new_warnings.iter().map(|(_, label)| words(label)));
        let count = self.new_warnings.len() as u32;
        (count > 0).then(|| msg!("form.report.changes-warn", count, results))
    }
}

impl From<Message> for Advice {
    fn from(message: Message) -> Advice {
        Advice { message, button: None, entries: Vec::new() }
    }
}

impl Readout {
    /// The result with lengths in the shown unit.
    pub fn shown(self) -> Readout {
        let in_unit = |number| units::value(number, self.unit);
        Readout {
            value: in_unit(self.value),
            limit: self.limit.map(|limit| limit.map(in_unit)),
            decimals: units::decimals(self.decimals, self.unit),
            unit: units::unit(self.unit),
            ..self
        }
    }

    /// Its decimals, and those that a value beyond its limit needs to read differently from the limit.
    pub fn decimals_apart(&self) -> u8 {
        self.apart_from(self.decimals)
    }

    /// The value with four significant digits, and those that a value beyond its limit needs to read differently from the limit.
    pub fn value_text(&self) -> String {
        let fewest = decimals_of_four(self.value, self.decimals);
        let decimals = self.apart_from(fewest);
        if decimals > fewest { figure(self.value, decimals) } else { four_digits(self.value, self.decimals) }
    }

    /// `fewest` decimals, or the first number of them with which a value beyond its limit reads differently from the limit.
    fn apart_from(&self, fewest: u8) -> u8 {
        let exceeded = self.limit.filter(|limit| self.verdict >= Verdict::Warn && !limit.holds(self.value));
        let Some(limit) = exceeded.filter(|_| self.value.is_finite()) else { return fewest };
        // A limit of the magnitude is written without a sign.
        let value = if matches!(limit, Limit::Within(_)) { self.value.abs() } else { self.value };
        let reads_as = |decimals: &u8| figure(value, *decimals) == figure(limit.value(), *decimals);
        (fewest..MOST_DECIMALS).find(|decimals| !reads_as(decimals)).unwrap_or(fewest)
    }

    /// The bar to the limit: its filled part and the position of the limit, both in percent of its length; `None` without a limit.
    pub fn bar(&self) -> Option<(f64, f64)> {
        let (value, limit) = (self.value.abs(), self.limit?.value().abs());
        let most = 1.15 * value.max(limit);
        (most.is_finite() && most > 0.0).then(|| (100.0 * value / most, 100.0 * limit / most))
    }
}

/// One result.
#[derive(Debug, Clone, PartialEq)]
pub struct Readout {
    /// Id, stable, for instance `line-speed`. The label is the catalog row `<machine>.readout.<id>`.
    pub id: &'static str,
    /// Catalog id of the label.
    pub label: &'static str,
    /// Value in `unit`.
    pub value: f64,
    /// Unit as shown.
    pub unit: &'static str,
    /// Decimals shown.
    pub decimals: u8,
    /// Limit, in `unit`.
    pub limit: Option<Limit>,
    /// Verdict.
    pub verdict: Verdict,
    /// Faults and remedies, the best first.
    pub advice: Vec<Advice>,
    /// Formula with the form's symbols.
    pub formula: Phrase,
    /// Source of formula and limit.
    pub cite: Citation,
    /// Whether the result is a headline result, shown above the drawing.
    pub headline: bool,
}

//! A result with its unit, limit, verdict, advice and formula.

use serde::Serialize;

use crate::msg;
use crate::text::{Citation, Message, MessageValue, Phrase, units};

/// Engineering judgement of a result. It never keeps a program from being exported.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Nothing to judge.
    None,
    /// Within its limit.
    Ok,
    /// To be thought about.
    Warn,
    /// Does not work as asked.
    Fail,
}

/// The limit that a result is judged by, in the unit of the result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Limit {
    /// Greatest value.
    AtMost(f64),
    /// Least value.
    AtLeast(f64),
    /// Greatest size of a value of either sign.
    Within(f64),
    /// The value to be met, within the tolerance of the rule.
    Equal(f64),
}

impl Limit {
    /// The number alone.
    pub fn value(self) -> f64 {
        match self {
            Limit::AtMost(value) | Limit::AtLeast(value) | Limit::Within(value) | Limit::Equal(value) => value,
        }
    }

    /// The limit with another number.
    fn map(self, number: impl FnOnce(f64) -> f64) -> Limit {
        match self {
            Limit::AtMost(value) => Limit::AtMost(number(value)),
            Limit::AtLeast(value) => Limit::AtLeast(number(value)),
            Limit::Within(value) => Limit::Within(number(value)),
            Limit::Equal(value) => Limit::Equal(number(value)),
        }
    }

    /// Whether a value keeps the limit.
    pub fn holds(self, value: f64) -> bool {
        match self {
            Limit::AtMost(most) => value <= most,
            Limit::AtLeast(least) => value >= least,
            Limit::Within(most) => value.abs() <= most,
            Limit::Equal(wanted) => value == wanted,
        }
    }

    /// How much a value asks of a limit: of two values the greater load is the worse one. Without a limit the greater value counts.
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

/// A remedy or a fact about a result, and the entries of the form that carry the remedy out.
#[derive(Debug, Clone, PartialEq)]
pub struct Advice {
    /// The sentence.
    pub message: Message,
    /// The remedy in a few words for a button; `None` where `sets` is empty.
    pub button: Option<Message>,
    /// Id of each field that the remedy changes, and the text to be typed there; empty where the form cannot carry it out.
    pub sets: Vec<(&'static str, String)>,
}

impl Advice {
    /// The advice with a remedy: words for a button, and the entries of the form.
    pub fn setting(self, button: Message, sets: impl Into<Vec<(&'static str, String)>>) -> Advice {
        Advice { button: Some(button), sets: sets.into(), ..self }
    }
}

impl Advice {
    /// The note that the remedy before it makes another result fail; `label` is that result's.
    pub fn turns_red(label: &'static str) -> Advice {
        Advice::from(msg!("advice.turns-red", result = MessageValue::Label(label)))
    }
}

impl From<Message> for Advice {
    fn from(message: Message) -> Advice {
        Advice { message, button: None, sets: Vec::new() }
    }
}

impl Readout {
    /// The result as people read it: a length in the unit that is shown.
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

    /// The bar to the limit: its filled part and the place of the limit, both in percent of its length; `None` without a limit.
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
    /// The limit it is judged by, in `unit`.
    pub limit: Option<Limit>,
    /// The judgement.
    pub verdict: Verdict,
    /// Faults and remedies, the best first.
    pub advice: Vec<Advice>,
    /// The formula with the form's symbols.
    pub formula: Phrase,
    /// Where formula and limit come from.
    pub cite: Citation,
    /// Whether it belongs to the few that stand above the drawing.
    pub headline: bool,
}

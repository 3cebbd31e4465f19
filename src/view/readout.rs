//! A result with its unit, limit, verdict and formula.

use serde::Serialize;

use crate::text::{Citation, Message};

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
    pub limit: Option<f64>,
    /// The judgement.
    pub verdict: Verdict,
    /// What is wrong and what would mend it, in order of what is best.
    pub advice: Vec<Message>,
    /// The formula with the form's symbols.
    pub formula: &'static str,
    /// Where formula and limit come from.
    pub cite: Citation,
    /// Whether it belongs to the few that stand above the drawing.
    pub headline: bool,
}

//! Monte Carlo: how often every verdict holds while the assumed facts lie anywhere within a tenth of their values.

use std::collections::BTreeMap;

use serde_json::{Value as Json, json};

use super::Project;
use super::sensitivity::{assumed_numbers, changed};
use crate::machines::form::{FieldInfo, FieldKindInfo, Value};
use crate::machines::sheets::{row, say};
use crate::msg;
use crate::text::catalog::sentence;
use crate::text::{Citation, Grade};
use crate::view::{Column, Readout, Sheet, SheetKind, Verdict};

/// Greatest relative error of a fact.
const OFF: f64 = 0.1;

/// Number of draws on the page, few enough for the user to wait for.
pub const DRAWS: u32 = 10_000;

/// Default seed.
pub const SEED: u64 = 1;

/// Result of drawing many machines with random values of the assumed facts.
#[derive(Debug, Clone, PartialEq)]
pub struct Chance {
    /// Number of machines drawn.
    pub draws: u32,
    /// Seed of the draws.
    pub seed: u64,
    /// Number of assumed facts drawn for each machine.
    pub facts: u32,
    /// Number of machines in which no verdict fails.
    pub hold: u32,
    /// Results that fail in some machines: id, catalog id of the label, and number of machines; the most frequent first.
    pub failing: Vec<(&'static str, &'static str, u32)>,
}

/// Draws machines, each with every assumed fact that is measured evenly between 0.9 and 1.1 of its value: within the range of its field, rounded to its decimals.
/// The same seed draws the same machines everywhere.
pub fn chance(project: &Project, draws: u32, seed: u64) -> Chance {
    chance_with_progress(project, draws, seed, &mut |_| ())
}

/// Whether a fact is measured. A number of pieces is counted: it is never a tenth off.
fn is_measured(field: &FieldInfo) -> bool {
    match field.kind {
        FieldKindInfo::Number { unit, decimals, .. } => decimals > 0 || !unit.is_empty(),
        _ => false,
    }
}

/// Number of draws between two reports of progress.
const DRAWS_PER_REPORT: u32 = 500;

/// Draws machines and reports the share done, 0 to 1.
pub fn chance_with_progress(project: &Project, draws: u32, seed: u64, tell: &mut dyn FnMut(f64)) -> Chance {
    let facts: Vec<FieldInfo> = assumed_numbers(project).into_iter().filter(is_measured).collect();
    let mut random = fastrand::Rng::with_seed(seed);
    let mut values = project.values.clone();
    let mut hold = 0;
    let mut failing: BTreeMap<&'static str, (&'static str, u32)> = BTreeMap::new();
    for draw in 0..draws {
        if draw % DRAWS_PER_REPORT == 0 {
            tell(f64::from(draw) / f64::from(draws));
        }
        for field in &facts {
            let factor = 1.0 + OFF * (2.0 * random.f64() - 1.0);
            let drawn = changed(project, field, factor).map(Value::Number);
            if let Some(value) = drawn.or_else(|| project.values.get(field.id).cloned()) {
                values.insert(field.id.to_owned(), value);
            }
        }
        let readouts = project.machine.prepare(&values, project.control_context()).results().readouts;
        let fails = |row: &&Readout| row.verdict == Verdict::Fail;
        hold += u32::from(!readouts.iter().any(|row| fails(&row)));
        for row in readouts.iter().filter(fails) {
            failing.entry(row.id).or_insert((row.label, 0)).1 += 1;
        }
    }
    let mut failing: Vec<_> = failing.into_iter().map(|(id, (label, count))| (id, label, count)).collect();
    failing.sort_by_key(|row| core::cmp::Reverse(row.2));
    Chance { draws, seed, facts: facts.len() as u32, hold, failing }
}

impl Chance {
    /// Share of the machines, %.
    fn share(&self, count: u32) -> f64 {
        if self.draws > 0 { 100.0 * f64::from(count) / f64::from(self.draws) } else { 0.0 }
    }

    /// Share (0 to 1) of the machines in which every verdict holds.
    pub fn probability(&self) -> f64 {
        self.share(self.hold) / 100.0
    }

    /// Good if every machine holds, a failure if none does.
    pub fn verdict(&self) -> Verdict {
        match self.hold {
            hold if hold == self.draws => Verdict::Ok,
            0 => Verdict::Fail,
            _ => Verdict::Warn,
        }
    }

    /// The share of the machines that hold, in a line.
    pub fn answer(&self) -> String {
        sentence(&msg!("chance.answer", percent = (self.share(self.hold), 1)))
    }

    /// The chance as an object.
    pub fn json(&self) -> Json {
        let fails = |row: &(&str, &str, u32)| json!({ "result": row.0, "draws": row.2 });
        json!({
            "draws": self.draws, "seed": self.seed, "facts": self.facts, "probability": self.probability(),
            "fails": self.failing.iter().map(fails).collect::<Vec<_>>(),
        })
    }

    /// The chance as a table: the sentence, then the results that fail.
    pub fn sheet(&self) -> Sheet {
        let cite = Citation::new("assumed facts drawn evenly within a tenth", Grade::Inferred);
        let message =
            msg!("chance.hold", percent = (self.share(self.hold), 1), machines = self.draws, facts = self.facts);
        let first = row([sentence(&message), String::new()], cite);
        let fails = self.failing.iter().map(|(_, label, count)| {
            row([say(label), sentence(&msg!("chance.share", percent = (self.share(*count), 1)))], cite)
        });
        Sheet {
            id: "chance",
            kind: SheetKind::Plain,
            title: "sheet.chance",
            columns: vec![Column::Plain("sheet.failing"), Column::Plain("sheet.share")],
            rows: [first].into_iter().chain(fails).collect(),
            drawing: String::new(),
        }
    }
}

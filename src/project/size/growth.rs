//! Limits of growth: how far speed, mass or pitch grow until a verdict fails, and the fastest operation of this hardware.

use crate::machines::form::{FieldInfo, FieldKindInfo, Value};
use crate::machines::sheets::say;
use crate::math;
use crate::msg;
use crate::project::Project;
use crate::text::catalog::number_text;
use crate::text::{Message, units};
use crate::view::{FieldEntry, Readout, Verdict};

/// Factor between two trials.
const STEP: f64 = 1.25;

/// Trials in either direction: up to 14 times the entry, down to a fourteenth.
const TRIALS: u32 = 12;

/// Halvings of the last step: the edge to a ten-thousandth.
const HALVINGS: u32 = 12;

/// The reason why no fastest operation is known; none if it is.
pub(super) fn no_fastest(limits: &[Growth], fastest: Option<&Fastest>) -> Option<Message> {
    let Some(speed) = limits.first().filter(|_| fastest.is_none()) else {
        return fastest.is_none().then(|| msg!("size.at-rest"));
    };
    let (quantity, value) = (say(speed.label), units::text(speed.value, 3, speed.unit));
    Some(match speed.binding {
        Some(binding) if !speed.holds => msg!("size.no-speed-holds", quantity, value, result = say(binding.label)),
        Some(_) => msg!("size.no-speed"),
        None => msg!("size.no-speed-limit", quantity, value),
    })
}

/// The name of a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ResultName {
    /// Id.
    pub id: &'static str,
    /// Catalog id of its label.
    pub label: &'static str,
}

impl From<&Readout> for ResultName {
    fn from(readout: &Readout) -> ResultName {
        ResultName { id: readout.id, label: readout.label }
    }
}

/// How far a field grows until a verdict fails.
#[derive(Debug, Clone, PartialEq)]
pub struct Growth {
    /// Id of the field.
    pub field: &'static str,
    /// Catalog id of its name.
    pub label: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Its greatest entry without a new failure: results that also fail with less are ignored. If none holds, the least entry tried.
    pub value: f64,
    /// Whether a tried entry is without a new failure. Results may fail one after the other as the entry falls.
    pub holds: bool,
    /// `value / present entry - 1`; below 0 if a verdict fails now.
    pub margin: f64,
    /// The result that fails beyond it, or at it if none holds; none if the form's range ends first.
    pub binding: Option<ResultName>,
    /// Whether a greater entry changes no result: the machine does not use it, such as a depth of cut above the whole stock.
    pub more_is_unused: bool,
    /// The results that fail now and with less: the field does not repair them.
    pub failing_anyway: Vec<ResultName>,
}

/// The fastest operation of this hardware.
#[derive(Debug, Clone, PartialEq)]
pub struct Fastest {
    /// The result that is the speed.
    pub result: ResultName,
    /// Its value.
    pub value: f64,
    /// Its unit.
    pub unit: &'static str,
    /// Decimals shown.
    pub decimals: u8,
    /// The result that fails beyond.
    pub binding: ResultName,
    /// The results that fail at this speed and at lower ones.
    pub failing_anyway: Vec<ResultName>,
    /// The entry of the form with that speed.
    pub entry: FieldEntry,
}

/// Whether the machine is at rest with its entries, for instance with the knob at 0.
fn is_at_rest(project: &Project) -> bool {
    let speed = project.machine.info().speed_result;
    speed.is_some_and(|id| project.prepared().results().readouts.iter().any(|row| row.id == id && row.value == 0.0))
}

/// The growth of each field that the machine names, and the fastest operation by the first of them; none if no tried speed holds. No growth of a
/// machine at rest: whatever grows, no verdict fails.
pub(super) fn growth(project: &Project) -> (Vec<Growth>, Option<Fastest>) {
    if is_at_rest(project) {
        return (Vec::new(), None);
    }
    let fields = project.machine.fields();
    let hidden = project.prepared();
    let named = project.machine.info().growth.iter().filter(|id| !hidden.hidden().contains(id));
    let grown: Vec<Growth> =
        named.filter_map(|id| edge(project, fields.iter().find(|field| field.id == *id)?)).collect();
    let fastest = grown.first().and_then(|first| fastest(project, first));
    (grown, fastest)
}

/// A machine with another entry in one field.
struct Trial<'a> {
    project: &'a Project,
    field: &'a FieldInfo,
    min: f64,
    max: f64,
    decimals: u8,
    now: f64,
    /// Results that also fail with less: they do not depend on this field.
    ignored: Vec<ResultName>,
}

impl Trial<'_> {
    /// The entry nearest below a factor of the present one, within the range of the field.
    fn entry(&self, factor: f64) -> f64 {
        let unit = math::pow(10.0, f64::from(self.decimals));
        math::clamp((self.now * factor * unit).floor() / unit, self.min, self.max)
    }

    fn results(&self, entry: f64) -> Vec<Readout> {
        let mut values = self.project.values.clone();
        values.insert(self.field.id.to_owned(), Value::Number(entry));
        self.project.machine.prepare(&values, self.project.control_context()).results().readouts
    }

    /// The first result that fails with an entry, without the ignored ones.
    fn fails(&self, entry: f64) -> Option<ResultName> {
        let readouts = self.results(entry);
        let fails = |row: &&Readout| row.verdict == Verdict::Fail && !self.ignored.contains(&ResultName::from(*row));
        readouts.iter().find(fails).map(ResultName::from)
    }

    /// Whether two entries have the same results.
    fn is_alike(&self, a: f64, b: f64) -> bool {
        let values =
            |entry: f64| self.results(entry).iter().map(|row| (row.id, row.value.to_bits())).collect::<Vec<_>>();
        values(a) == values(b)
    }

    /// The least entry, up to a factor of the present one, beyond which no result changes to the end of the range; none if there are changes.
    fn used_up(&self, greatest: f64) -> Option<f64> {
        let last = self.entry(greatest);
        if !self.is_alike(last, self.max) {
            return None;
        }
        let is_used = |factor: f64| self.is_alike(self.entry(factor), last);
        let (mut used, mut less) = (greatest, greatest / STEP);
        while less > 1.0 && is_used(less) {
            (used, less) = (less, less / STEP);
        }
        let least = math::last_holding(used, less.max(1.0), HALVINGS, is_used);
        let entry = self.entry(least);
        (entry < last).then_some(entry)
    }

    /// The results that fail now and with the least tried entry.
    fn persistent(&self) -> Vec<ResultName> {
        let failing = |entry: f64| {
            let readouts = self.results(entry);
            let fails = readouts.iter().filter(|row| row.verdict == Verdict::Fail);
            fails.map(ResultName::from).collect::<Vec<_>>()
        };
        let now = failing(self.now);
        if now.is_empty() {
            return now;
        }
        let least = failing(self.entry(math::pow(STEP, -f64::from(TRIALS))));
        now.into_iter().filter(|row| least.contains(row)).collect()
    }
}

fn edge(project: &Project, field: &FieldInfo) -> Option<Growth> {
    let FieldKindInfo::Number { min, max, default, decimals, unit, .. } = field.kind else { return None };
    let now = match project.values.get(field.id) {
        Some(value @ Value::Number(number)) if field.check(value).is_ok() => *number,
        _ => default,
    };
    let mut trial = Trial { project, field, min, max, decimals, now, ignored: Vec::new() };
    trial.ignored = trial.persistent();
    let mut binding = trial.fails(now);
    let upward = binding.is_none();
    // The last factor without a failure, and the first with one.
    let (mut holds, mut fails) = (1.0, 1.0);
    let mut is_found = upward;
    for _ in 0..TRIALS {
        let (from, factor) = if upward { (fails, fails * STEP) } else { (holds, holds / STEP) };
        let (before, entry) = (trial.entry(from), trial.entry(factor));
        if entry == before {
            break;
        }
        let found = trial.fails(entry);
        if upward {
            (holds, fails) = (from, factor);
            if found.is_some() {
                binding = found;
                break;
            }
        } else {
            (holds, fails) = (factor, from);
            if found.is_none() {
                is_found = true;
                break;
            }
            binding = found;
        }
    }
    let growth = |value: f64, holds: bool, binding| Growth {
        field: field.id,
        label: field.label,
        unit,
        value,
        holds,
        margin: if now > 0.0 { value / now - 1.0 } else { 0.0 },
        binding,
        more_is_unused: false,
        failing_anyway: trial.ignored.clone(),
    };
    if upward && binding.is_none() {
        let used = trial.used_up(fails);
        let value = used.unwrap_or_else(|| trial.entry(fails));
        return Some(Growth { more_is_unused: used.is_some(), ..growth(value, true, None) });
    }
    if !is_found {
        return Some(growth(trial.entry(holds), false, binding));
    }
    let last = math::last_holding(holds, fails, HALVINGS, |value| {
        let found = trial.fails(trial.entry(value));
        let holds = found.is_none();
        binding = found.or(binding);
        holds
    });
    Some(growth(trial.entry(last), true, binding))
}

fn fastest(project: &Project, speed: &Growth) -> Option<Fastest> {
    let binding = speed.binding.filter(|_| speed.holds)?;
    let field = project.machine.fields().into_iter().find(|field| field.id == speed.field)?;
    let FieldKindInfo::Number { decimals, .. } = field.kind else { return None };
    let entry = FieldEntry::new(speed.field, number_text(speed.value, decimals));
    let results = project.with_entries(core::slice::from_ref(&entry))?.prepared().results().readouts;
    let result = project.machine.info().speed_result?;
    let readout = results.iter().find(|row| row.id == result)?;
    Some(Fastest {
        result: ResultName::from(readout),
        // A speed in the other direction is as fast.
        value: readout.value.abs(),
        unit: readout.unit,
        decimals: readout.decimals,
        binding,
        failing_anyway: speed.failing_anyway.clone(),
        entry,
    })
}

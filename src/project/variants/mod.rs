//! Variants of a project: kept, taken and dropped; and projects side by side, the entries in which they differ and their results with verdicts.

pub mod variant;

use serde_json::{Value as Json, json};

use self::variant::{MAX_VARIANTS, Variant, variant_name};
use super::Project;
use super::list::verdict_word;
use super::origins::values;
use crate::controls::Switch;
use crate::text::catalog::words;
use crate::text::columns::{left, right};
use crate::text::number::Fixed;
use crate::view::{ComparedRow, Comparison, Readout, VariantCell, Verdict};

impl Project {
    /// The first capital letter that is not the name of a variant.
    pub fn free_variant_name(&self) -> String {
        let free = |name: &String| self.variants.iter().all(|variant| variant.name != *name);
        ('A'..='Z').map(String::from).find(free).unwrap_or_default()
    }

    /// Keeps the present settings as a variant, in place of one with this name where there is one. Without a name it gets the next free letter.
    /// Returns its index; `None` where there are [`MAX_VARIANTS`] already.
    pub fn keep_variant(&mut self, name: &str) -> Option<usize> {
        let name = variant_name(name).unwrap_or_else(|| self.free_variant_name());
        let at = self.variants.iter().position(|variant| variant.name == name).unwrap_or(self.variants.len());
        let (values, switches) = (self.values.clone(), self.switches.clone());
        let variant = Variant { name, control: self.control, values, switches };
        match self.variants.get_mut(at) {
            Some(known) => *known = variant,
            None if at < MAX_VARIANTS => self.variants.push(variant),
            None => return None,
        }
        Some(at)
    }

    /// Takes the settings of a variant, which stays; another control as [`move_to`](Project::move_to) does. Does nothing where there is no
    /// such variant.
    pub fn take_variant(&mut self, at: usize) {
        let Some(Variant { control, values, switches, .. }) = self.variants.get(at).cloned() else { return };
        if control.id != self.control.id {
            self.move_to(control);
        }
        (self.values, self.switches) = (values, switches);
    }

    /// Drops a variant. Does nothing where there is no such one.
    pub fn drop_variant(&mut self, at: usize) {
        if at < self.variants.len() {
            self.variants.remove(at);
        }
    }

    /// Comparison of the present settings, under a name, with all variants; `None` without a variant.
    pub fn compared_variants(&self, present: &str) -> Option<Comparison> {
        if self.variants.is_empty() {
            return None;
        }
        let all: Vec<(String, Project)> =
            [(present.to_owned(), self.clone())].into_iter().chain(self.each_variant()).collect();
        Some(compare(&all))
    }

    /// Each variant's name, and the project with its settings. An edited program belongs to the present settings alone: each variant has
    /// the program that its form writes.
    pub fn each_variant(&self) -> impl Iterator<Item = (String, Project)> {
        self.variants.iter().enumerate().map(|(at, kept)| {
            let mut project = self.clone();
            project.take_variant(at);
            project.edited = None;
            (kept.name.clone(), project)
        })
    }
}

/// Id, name, unit and cell of a row.
pub(super) type Listed = (&'static str, String, &'static str, VariantCell);

/// Compares projects, each with its name. Machines may differ: a row that a project does not have leaves its cell empty.
pub fn compare(variants: &[(String, Project)]) -> Comparison {
    let each =
        |list: fn(&Project) -> Vec<Listed>| variants.iter().map(|(_, project)| list(project)).collect::<Vec<_>>();
    let mut entries = side_by_side(&each(entries));
    let mut switches = side_by_side(&each(switches));
    entries.retain(|row| row.differs);
    // Only chosen settings are listed: not switches that only one control has, nor switches at their default.
    switches.retain(|row| row.differs && variants.iter().any(|(_, project)| is_chosen(project, row.id)));
    let cells: Vec<_> =
        variants.iter().map(|(_, project)| Some((project.control.name.to_owned(), Verdict::None))).collect();
    let label = words("variants.control").to_owned();
    let differs = differ(&cells);
    Comparison {
        names: variants.iter().map(|(name, _)| name.clone()).collect(),
        entries,
        results: side_by_side(&each(results)),
        control: ComparedRow { id: "control", label, unit: "", cells, differs },
        switches,
    }
}

fn named(id: &'static str) -> String {
    words(id).to_owned()
}

pub(super) fn entries(project: &Project) -> Vec<Listed> {
    let inputs = values(project).into_iter().map(|(input, _)| input);
    inputs.map(|input| (input.id, named(input.label), input.unit, (input.value, Verdict::None))).collect()
}

fn results(project: &Project) -> Vec<Listed> {
    let row =
        |row: Readout| (row.id, named(row.label), row.unit, (Fixed(row.value, row.decimals).to_string(), row.verdict));
    project.design().readouts.into_iter().map(Readout::shown).map(row).collect()
}

/// The open points of the control, each with its setting in words.
pub(super) fn switches(project: &Project) -> Vec<Listed> {
    let row = |switch: &Switch| {
        let setting = project.switches.setting(switch);
        let option = switch.options().into_iter().find(|option| option.id == setting);
        let words = option.map_or_else(|| setting.to_owned(), |option| named(option.label));
        (switch.id(), switch.text(), "", (words, Verdict::None))
    };
    project.control.switches.iter().map(row).collect()
}

/// Whether the setting of an open point is not the default of the project's control.
fn is_chosen(project: &Project, switch: &str) -> bool {
    project.control.switch(switch).is_some_and(|row| project.switches.setting(row) != row.default())
}

/// Rows by their ids, in the order of the first variant that has them.
pub(super) fn side_by_side(lists: &[Vec<Listed>]) -> Vec<ComparedRow> {
    let mut rows: Vec<ComparedRow> = Vec::new();
    for (at, list) in lists.iter().enumerate() {
        for (id, label, unit, cell) in list {
            let known = rows.iter().position(|row| row.id == *id && row.unit == *unit);
            let place = known.unwrap_or_else(|| {
                let cells = vec![None; lists.len()];
                rows.push(ComparedRow { id, label: label.clone(), unit, cells, differs: false });
                rows.len() - 1
            });
            if let Some(slot) = rows.get_mut(place).and_then(|row| row.cells.get_mut(at)) {
                *slot = Some(cell.clone());
            }
        }
    }
    for row in &mut rows {
        row.differs = differ(&row.cells);
    }
    rows
}

fn differ<C: PartialEq>(cells: &[C]) -> bool {
    cells.windows(2).any(|pair| pair[0] != pair[1])
}

/// A comparison as an object.
pub fn comparison_json(comparison: &Comparison) -> Json {
    let row = |row: &ComparedRow| {
        let cell = |cell: &Option<VariantCell>| {
            cell.as_ref().map(|(text, verdict)| json!({ "value": text, "verdict": verdict_word(*verdict) }))
        };
        json!({ "id": row.id, "unit": row.unit, "differs": row.differs, "variants": row.cells.iter().map(cell).collect::<Vec<_>>() })
    };
    let rows = |rows: &[ComparedRow]| rows.iter().map(row).collect::<Vec<_>>();
    json!({
        "variants": comparison.names,
        "controls": comparison.control.cells.iter().flatten().map(|(name, _)| name).collect::<Vec<_>>(),
        "switches": rows(&comparison.switches),
        "entries": rows(&comparison.entries),
        "results": rows(&comparison.results),
    })
}

/// A comparison as lines: the entries, results and controls that differ; results that fail have a cross.
pub fn comparison_text(comparison: &Comparison) -> String {
    let mut out = line("", "", comparison.names.iter().map(String::as_str));
    let groups = comparison.differences();
    if groups.is_empty() {
        out += &format!("\n{}\n", words("variants.same"));
    }
    for (title, rows) in groups {
        out += &format!("\n{}\n", words(title));
        for row in rows {
            out += &line(&row.label, row.unit, row.marked().iter().map(String::as_str));
        }
    }
    out
}

/// Columns of a terminal for the first column, and of each further one.
const WIDTHS: (usize, usize) = (44, 18);

/// A line of the comparison.
fn line<'c>(label: &str, unit: &str, cells: impl Iterator<Item = &'c str>) -> String {
    let name = [label, unit].join(" ");
    let mut out = format!("  {}", left(name.trim_end(), WIDTHS.0));
    cells.for_each(|cell| out += &format!(" {}", right(cell, WIDTHS.1)));
    out.truncate(out.trim_end().len());
    out.push('\n');
    out
}

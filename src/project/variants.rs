//! Variants side by side: the entries in which they differ, and their results with verdicts.

use serde_json::{Value as Json, json};

use super::Project;
use super::list::verdict_word;
use super::origins::values;
use crate::text::catalog::{Language, words};
use crate::text::number::Fixed;
use crate::view::{Readout, Verdict};

/// What one variant has in a row: the text, and the judgement of a result.
pub type VariantCell = (String, Verdict);

/// A row of a comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct ComparedRow {
    /// Id of the field or of the result.
    pub id: &'static str,
    /// Its name.
    pub label: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// A cell for each variant; none where it has no such entry or result.
    pub cells: Vec<Option<VariantCell>>,
    /// Whether the variants differ in it.
    pub differs: bool,
}

/// Variants side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// Their names.
    pub names: Vec<String>,
    /// Their controls.
    pub controls: Vec<&'static str>,
    /// The entries in which they differ, in the order of the form.
    pub entries: Vec<ComparedRow>,
    /// All results, in the order in which they are shown.
    pub results: Vec<ComparedRow>,
}

/// Compares variants, each with its name. Machines may differ: what only some have stands where the others have nothing.
pub fn compare(variants: &[(String, Project)]) -> Comparison {
    let entries: Vec<Vec<_>> = variants
        .iter()
        .map(|(_, project)| {
            let entry = |(input, _): (crate::view::report::Input, _)| {
                (input.id, input.label, input.unit, (input.value, Verdict::None))
            };
            values(project).into_iter().map(entry).collect()
        })
        .collect();
    let results: Vec<Vec<_>> = variants
        .iter()
        .map(|(_, project)| {
            let cell =
                |row: Readout| (row.id, row.label, row.unit, (Fixed(row.value, row.decimals).to_string(), row.verdict));
            project.design().readouts.into_iter().map(cell).collect()
        })
        .collect();
    let mut entries = side_by_side(&entries);
    entries.retain(|row| row.differs);
    Comparison {
        names: variants.iter().map(|(name, _)| name.clone()).collect(),
        controls: variants.iter().map(|(_, project)| project.control.name).collect(),
        entries,
        results: side_by_side(&results),
    }
}

/// Rows by their ids, in the order of the first variant that has them.
fn side_by_side(lists: &[Vec<(&'static str, &'static str, &'static str, VariantCell)>]) -> Vec<ComparedRow> {
    let mut rows: Vec<ComparedRow> = Vec::new();
    for (at, list) in lists.iter().enumerate() {
        for (id, label, unit, cell) in list {
            let known = rows.iter().position(|row| row.id == *id && row.unit == *unit);
            let place = known.unwrap_or_else(|| {
                let cells = vec![None; lists.len()];
                rows.push(ComparedRow { id, label: words(Language::English, label), unit, cells, differs: false });
                rows.len() - 1
            });
            if let Some(slot) = rows.get_mut(place).and_then(|row| row.cells.get_mut(at)) {
                *slot = Some(cell.clone());
            }
        }
    }
    for row in &mut rows {
        row.differs = row.cells.windows(2).any(|pair| pair[0] != pair[1]);
    }
    rows
}

impl Comparison {
    /// The comparison as an object.
    pub fn json(&self) -> Json {
        let row = |row: &ComparedRow| {
            let cell = |cell: &Option<VariantCell>| {
                cell.as_ref().map(|(text, verdict)| json!({ "value": text, "verdict": verdict_word(*verdict) }))
            };
            json!({ "id": row.id, "unit": row.unit, "differs": row.differs, "variants": row.cells.iter().map(cell).collect::<Vec<_>>() })
        };
        json!({
            "variants": self.names,
            "controls": self.controls,
            "entries": self.entries.iter().map(row).collect::<Vec<_>>(),
            "results": self.results.iter().map(row).collect::<Vec<_>>(),
        })
    }

    /// The comparison as lines: the entries that differ, then the results that differ, those that fail with a cross.
    pub fn text(&self) -> String {
        let mut out = line("", "", self.names.iter().map(String::as_str));
        out += &line("control", "", self.controls.iter().copied());
        let cell = |cell: &Option<VariantCell>| match cell {
            None => "-".to_owned(),
            Some((text, Verdict::Fail)) => format!("✕ {text}"),
            Some((text, Verdict::Warn)) => format!("△ {text}"),
            Some((text, _)) => text.clone(),
        };
        let mut told = |title: &str, rows: &[ComparedRow]| {
            out += &format!("\n{title}\n");
            for row in rows.iter().filter(|row| row.differs) {
                let cells: Vec<String> = row.cells.iter().map(cell).collect();
                out += &line(row.label, row.unit, cells.iter().map(String::as_str));
            }
        };
        told("entries", &self.entries);
        told("results", &self.results);
        out
    }
}

/// Characters of the first column, and of each further one.
const WIDTHS: (usize, usize) = (44, 18);

/// A line of the comparison.
fn line<'c>(label: &str, unit: &str, cells: impl Iterator<Item = &'c str>) -> String {
    let name = [label, unit].join(" ");
    let mut out = format!("  {:<1$}", name.trim_end(), WIDTHS.0);
    cells.for_each(|cell| out += &format!(" {cell:>0$}", WIDTHS.1));
    out.truncate(out.trim_end().len());
    out.push('\n');
    out
}

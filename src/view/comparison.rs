//! Variants side by side as a table: their entries, their results with verdicts, their controls.

use super::readout::Verdict;

/// Content of a row for one variant: the text, and the verdict of a result.
pub type VariantCell = (String, Verdict);

/// A row of a comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct ComparedRow {
    /// Id of the field, of the result or of the switch.
    pub id: &'static str,
    /// Name of the row.
    pub label: String,
    /// Unit.
    pub unit: &'static str,
    /// A cell for each variant; `None` if it lacks the entry or result.
    pub cells: Vec<Option<VariantCell>>,
    /// Whether the variants differ in this row.
    pub differs: bool,
}

impl ComparedRow {
    /// The cells as texts: the sign of a failed verdict before its value, and a dash for a missing cell.
    pub fn marked(&self) -> Vec<String> {
        let mark = |cell: &Option<VariantCell>| match cell {
            None => "-".to_owned(),
            Some((text, verdict @ (Verdict::Fail | Verdict::Warn))) => format!("{} {text}", verdict.sign()),
            Some((text, _)) => text.clone(),
        };
        self.cells.iter().map(mark).collect()
    }

    /// Whether the cell of a variant differs from that of the first one.
    pub fn differs_at(&self, variant: usize) -> bool {
        self.cells.get(variant) != self.cells.first()
    }
}

/// Variants side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// Names of the variants.
    pub names: Vec<String>,
    /// Entries with differences, in the order of the form.
    pub entries: Vec<ComparedRow>,
    /// All results, in the order of display.
    pub results: Vec<ComparedRow>,
    /// Names of their controls.
    pub control: ComparedRow,
    /// Open points of the controls with different settings, at least one of them not the default.
    pub switches: Vec<ComparedRow>,
}

impl Comparison {
    /// Rows with differences, in groups with the catalog ids of their titles: entries, results, controls. Rows common to all variants come
    /// first, because two machines have little in common. Empty groups are omitted.
    pub fn differences(&self) -> Vec<(&'static str, Vec<&ComparedRow>)> {
        let control = std::iter::once(&self.control).chain(&self.switches);
        let groups: [(&'static str, Vec<&ComparedRow>); 3] = [
            ("variants.entries", self.entries.iter().collect()),
            ("variants.results", self.results.iter().collect()),
            ("variants.controls", control.collect()),
        ];
        let mut groups = Vec::from(groups);
        for (_, rows) in &mut groups {
            rows.retain(|row| row.differs);
            rows.sort_by_key(|row| row.cells.contains(&None));
        }
        groups.retain(|(_, rows)| !rows.is_empty());
        groups
    }
}

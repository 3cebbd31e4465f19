//! Variants side by side as a table: their entries, their results with verdicts, their controls.

use super::readout::Verdict;

/// Content of a row for one variant: the text, and the verdict of a result.
pub type VariantCell = (String, Verdict);

/// A row of a comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct ComparedRow {
    /// Id of the field, of the result or of the switch.
    pub id: &'static str,
    /// Its name.
    pub label: String,
    /// Unit.
    pub unit: &'static str,
    /// A cell for each variant; none where it has no such entry or result.
    pub cells: Vec<Option<VariantCell>>,
    /// Whether the variants differ in it.
    pub differs: bool,
}

impl ComparedRow {
    /// The cells as texts: the sign of a verdict that does not hold before its value, and a dash where there is nothing.
    pub fn marked(&self) -> Vec<String> {
        let mark = |cell: &Option<VariantCell>| match cell {
            None => "-".to_owned(),
            Some((text, Verdict::Fail)) => format!("✕ {text}"),
            Some((text, Verdict::Warn)) => format!("△ {text}"),
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
    /// Their names.
    pub names: Vec<String>,
    /// Entries in which they differ, in the order of the form.
    pub entries: Vec<ComparedRow>,
    /// All results, in the order in which they are shown.
    pub results: Vec<ComparedRow>,
    /// Names of their controls.
    pub control: ComparedRow,
    /// Open points of the controls in whose settings they differ, and one of them from the default of its control.
    pub switches: Vec<ComparedRow>,
}

impl Comparison {
    /// The rows that differ, in groups with the catalog ids of their titles: entries, results, controls. What all have comes first, for two
    /// machines have little in common. A group without rows is left out.
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

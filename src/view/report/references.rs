//! Sources of a report by number: tables name the number, the list at the end the source.

use std::collections::BTreeMap;

/// Sources in the order in which a report first names them.
#[derive(Debug, Clone, Default)]
pub(super) struct References(BTreeMap<String, usize>);

impl References {
    /// Number of a source, from 1.
    pub(super) fn number(&mut self, source: &str) -> usize {
        let next = self.0.len() + 1;
        *self.0.entry(source.to_owned()).or_insert(next)
    }

    /// The sources in the order of their numbers.
    pub(super) fn sources(self) -> Vec<String> {
        let mut numbered: Vec<(String, usize)> = self.0.into_iter().collect();
        numbered.sort_by_key(|(_, number)| *number);
        numbered.into_iter().map(|(source, _)| source).collect()
    }
}

//! The results of the ribbon line: rows with label, unit, formula and source, one file for each subject, and the rules that judge them.

mod cam;
mod dots;
mod drives;
mod line;
mod reel;

use super::cam::chosen;
use super::resolved::RibbonLine;
use super::rules;
use crate::machines::verdict::{ReadoutRow, Rule, results};
use crate::view::Readout;

/// Rows of a subject, and the rules that judge them.
type Subject = (&'static [ReadoutRow<RibbonLine>], &'static [Rule<RibbonLine>]);

/// The results with their verdicts, in the order they are shown; those of a cam only if a law is chosen.
pub(super) fn readouts(line: &RibbonLine) -> Vec<Readout> {
    let subjects: [Subject; 5] = [
        (line::ROWS, rules::RULES),
        (drives::ROWS, rules::drives::RULES),
        (reel::ROWS, rules::reel::RULES),
        (dots::ROWS, rules::dots::RULES),
        (cam::ROWS, rules::cam::RULES),
    ];
    let shown = subjects.len() - usize::from(chosen(line).is_none());
    subjects[..shown].iter().flat_map(|(rows, rules)| results(rows, line, rules)).collect()
}

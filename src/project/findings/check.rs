//! Findings about a program: from the parser, the pre-check, the warnings and a run.

use std::rc::Rc;

use crate::interp;
use crate::msg;
use crate::nc::{self, Block, Files, Parsed, Program};
use crate::project::program::Written;
use crate::project::{Project, run};
use crate::text::{Diagnostic, DiagnosticKind, Fix, Place, Severity};

/// All findings before a run, in the order of the text. `start` is the number of the started program, if known; `set` are variables that
/// the operator sets.
pub fn review(parsed: &Rc<Parsed>, start: Option<u32>, set: &[u32]) -> Vec<Diagnostic> {
    let mut found = parsed.diagnostics().to_vec();
    found.extend(beyond(parsed, start, set));
    Diagnostic::in_order(&mut found);
    found
}

/// Certain alarms and warnings, beyond the findings of the reader.
fn beyond(parsed: &Rc<Parsed>, start: Option<u32>, set: &[u32]) -> Vec<Diagnostic> {
    let mut found = interp::precheck(parsed);
    let mut warnings = nc::warnings(parsed, start, set);
    // One mistake, one finding.
    let has_alarm = |warning: &Diagnostic| {
        found.iter().any(|alarm| warning.place.zip(alarm.place).is_some_and(|(a, b)| a.meets(b)))
    };
    warnings.retain(|warning| warning.severity == Severity::Info || !has_alarm(warning));
    found.append(&mut warnings);
    found
}

/// The findings of reading a program and of its run as one list. A finding of the run is left out if reading has reported the same fact. An
/// alarm of the run replaces a warning about its block.
pub fn with_run(mut read: Vec<Diagnostic>, run: &[Diagnostic]) -> Vec<Diagnostic> {
    let new: Vec<&Diagnostic> = run.iter().filter(|found| reported(&read, found).is_none()).collect();
    let alarms = run.iter().filter(|found| found.is_error()).filter_map(|found| found.place);
    let alarms: Vec<Place> = alarms.collect();
    let foreseen = |warning: &Diagnostic| warning.place.is_some_and(|at| alarms.iter().any(|alarm| at.covers(*alarm)));
    read.retain(|found| found.severity != Severity::Warning || !foreseen(found));
    read.extend(new.into_iter().cloned());
    read
}

/// Turns errors in blocks that a run did not reach into warnings: the control has not read them. Errors that the run has raised, and errors
/// about a whole file, stay errors.
pub fn not_reached(found: &mut [Diagnostic], parsed: &Parsed, run: &[Diagnostic]) {
    let deck = parsed.deck();
    for finding in found.iter_mut().filter(|finding| finding.is_error()) {
        let Some(place) = finding.place.filter(|_| reported(run, finding).is_none()) else { continue };
        let within = |blocks: &[Block]| {
            let behind = blocks.partition_point(|block| block.span.start <= place.span.start);
            let block = behind.checked_sub(1).and_then(|at| blocks.get(at));
            block.is_some_and(|block| place.span.end <= block.span.end)
        };
        let start = |program: &Program| {
            let first = deck.blocks_of(program).first().map_or(0, |block| block.span.start);
            (program.file, first)
        };
        let behind = deck.programs.partition_point(|program| start(program) <= (place.file, place.span.start));
        let program = behind.checked_sub(1).and_then(|at| deck.programs.get(at));
        if program.is_some_and(|program| program.file == place.file && within(deck.blocks_of(program))) {
            finding.severity = Severity::Warning;
            finding.hints.push(msg!("project.not-reached"));
        }
    }
}

/// The finding of reading that states the same fact as a finding of a run: the same alarm or remark at the same place, or short blocks where
/// the run starves. Reader, static check and run raise an alarm by the same code, so its place is the same.
pub fn reported<'a>(read: &'a [Diagnostic], run: &Diagnostic) -> Option<&'a Diagnostic> {
    let file = |finding: &Diagnostic| finding.place.map(|place| place.file);
    read.iter().find(|known| match (known.kind, run.kind) {
        (DiagnosticKind::ShortBlocks, DiagnosticKind::Starved) => file(known) == file(run),
        _ if run.place.is_none() || known.place != run.place || !known.shows_alarm_of(run) => false,
        // Values in the message may differ, because the run reports the values of one pass of a loop.
        _ => run.is_error() && run.alarm.is_some() || known.message.is_same_sentence(&run.message),
    })
}

/// Choice of fixes that are applied together. A fix of a warning changes the effect of a program, so each has to be decided separately.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FixChoice {
    /// Fixes of errors that have one fix, which is no guess, so that there is no choice.
    Certain,
    /// The first fix of each error: the most likely one.
    First,
}

/// The fixes of a choice, one per error.
pub fn fixes(found: &[Diagnostic], choice: FixChoice) -> impl Iterator<Item = &Fix> {
    let errors = found.iter().filter(|finding| finding.is_error());
    errors.filter_map(move |finding| match choice {
        FixChoice::Certain => finding.certain_fix(),
        FixChoice::First => finding.fixes.first(),
    })
}

/// Maximum number of times that a program is parsed to apply fixes. A fix that touches another one waits for the next time.
const READINGS: usize = 8;

impl Project {
    /// Applies the fixes of these findings to the program's files, then the fixes of findings from parsing the result. Returns the files
    /// and the number of fixes.
    pub fn with_fixes(&self, files: &Files, found: &[Diagnostic], choice: FixChoice) -> (Files, usize) {
        let (mut files, mut count) = nc::fix_all(files, fixes(found, choice));
        for _ in 1..READINGS {
            let parsed = nc::parse_with(&files, self.control, &self.switches);
            let (next, made) = nc::fix_all(&files, fixes(parsed.diagnostics(), choice));
            if made == 0 {
                break;
            }
            (files, count) = (next, count + made);
        }
        let parsed = nc::parse_with(&files, self.control, &self.switches);
        let left_out = self.left_out(&parsed);
        let (files, made) = nc::fix_all(&files, left_out.iter().flat_map(|finding| &finding.fixes));
        (files, count + made)
    }

    /// Blocks that the machine's published listing leaves out and that this program lacks, each with its fix.
    fn left_out(&self, parsed: &Parsed) -> Vec<Diagnostic> {
        self.machine.info().left_out.iter().filter_map(|block| block.find(parsed)).collect()
    }

    /// Certain alarms and warnings of the project's program, beyond the findings of its reader; silenced ones too.
    pub fn advice(&self, written: &Written) -> Vec<Diagnostic> {
        let mut found =
            beyond(&written.parsed, Some(written.main), &run::set_by_operator(&[], &self.panel, self.control));
        found.extend(self.left_out(&written.parsed));
        found
    }
}

//! Whether the run of a project moves anything, and the remedy if it does not.

use super::Project;
use super::run::{Run, RunOptions, of_project};
use crate::machines::form::{FieldInfo, FieldKindInfo};
use crate::machines::sheets::say;
use crate::motion::{Action, Budget, Event, Panel, Retention, RunEnd};
use crate::msg;
use crate::text::catalog::number_text;
use crate::text::{Diagnostic, Message, units};
use crate::view::{Advice, Verdict};

/// Budget of a trial run. A program that calculates or waits longer before anything moves counts as working.
const TRIAL: Budget = Budget { blocks: 100_000, seconds: 60.0 };

/// Steps of the planner between two looks at the log.
const STEPS: usize = 64;

/// Whether the run ends before anything moves: at an alarm, or where the program stops. Actions of the operator are left out.
pub fn stops_at_once(project: &Project) -> bool {
    let mut project = project.clone();
    project.panel = Panel::default();
    let begin = RunOptions { start: None, settings: &[], limits: TRIAL, keep: Retention::Log };
    let mut run = of_project(&project, &project.written(), &begin);
    loop {
        let progress = run.advance(f64::INFINITY, STEPS);
        if run.take_log().iter().any(|(_, canon, _)| canon.moves()) {
            return false;
        }
        if let Some(end) = progress.ended {
            return matches!(end, RunEnd::Alarm(_) | RunEnd::Stop);
        }
    }
}

/// The remedy of an error of the form or of a failed result with which a run moves that now [stops at once](stops_at_once): tried by a run
/// before it is offered.
pub fn remedy(project: &Project) -> Option<Advice> {
    let design = project.design();
    let failed = design.readouts.into_iter().filter(|readout| readout.verdict == Verdict::Fail);
    let of_results = failed.flat_map(|readout| readout.advice).filter(|advice| !advice.entries.is_empty());
    let of_errors = design.diagnostics.iter().filter_map(|found| of_error(project, found));
    let moves = |advice: &Advice| project.with_entries(&advice.entries).is_some_and(|after| !stops_at_once(&after));
    of_errors.chain(of_results).find(moves)
}

/// The advice to enter what mends an error of a field.
fn of_error(project: &Project, found: &Diagnostic) -> Option<Advice> {
    let (id, entry) = found.field.zip(found.entry)?;
    let button = set_field(&project.machine.fields(), id, entry)?;
    Some(Advice::from(found.message.clone()).setting(button, [(id, number_text(entry, 3))]))
}

/// The change of a number field in words: its label, value and unit; `None` for other fields.
pub(super) fn set_field(fields: &[FieldInfo], id: &str, value: f64) -> Option<Message> {
    let field = fields.iter().find(|field| field.id == id)?;
    let FieldKindInfo::Number { unit, .. } = field.kind else { return None };
    Some(msg!("advice.set-field", field = say(field.label), value = units::text(value, 3, unit)))
}

/// Whether cycle start after a stopped run leads to the same stop again without any motion.
pub fn comes_back(run: &Run) -> bool {
    let end = run.timeline().end();
    let stop = run.timeline().at(end);
    let mut again = run.clone();
    again.event(Event { t: end, action: Action::Start });
    loop {
        let progress = again.advance(end + TRIAL.seconds, STEPS);
        let now = again.timeline().at(progress.planned_to);
        let moved = now.axes.map(|axis| axis.position) != stop.axes.map(|axis| axis.position)
            || now.spindle.command != stop.spindle.command;
        if progress.planned_to > end && moved {
            return false;
        }
        match progress.ended {
            Some(RunEnd::Stop) => return now.block == stop.block,
            None if progress.planned_to < end + TRIAL.seconds => {}
            _ => return false,
        }
    }
}

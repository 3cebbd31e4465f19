//! Sizing: which motors carry the machine, what happens to it in operation, what limits it, and what there is to buy.
//!
//! Torque and energy are those of runs of the very program, over stretches of constant acceleration; see [`Motion`](crate::drives::duty::Motion).

mod bill;

mod choice;

mod envelope;

mod growth;

mod runs;

pub mod sheets;

pub mod tell;

mod tornado;

pub use bill::BillRow;
pub use choice::{Candidate, Refusal, SizedAxis};
pub use envelope::{EnvelopeRow, OperatingEvent};
pub use growth::{Fastest, Growth};
pub use runs::SizingRuns;
pub use tornado::{Swing, Tornado};

use super::Project;
use super::program::Written;
use super::sensitivity::{Flip, Sensitivity};
use crate::machines::PreparedMachine;

/// Time and energy of a part, from the run of its program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycle {
    /// Seconds from cycle start to the end of the program.
    pub seconds: f64,
    /// Energy that the servo motors give at their shafts, J.
    pub given: f64,
    /// Energy that comes back to them, J.
    pub returned: f64,
}

/// The sizing of a project.
#[derive(Debug, Clone, PartialEq)]
pub struct Sizing {
    /// Axes and drives with their motors.
    pub axes: Vec<SizedAxis>,
    /// Time and energy of a part; none where the program does not come to its end.
    pub cycle: Option<Cycle>,
    /// What happens at every event of operation.
    pub envelope: Vec<EnvelopeRow>,
    /// Limits that bind next when more is asked.
    pub limits: Vec<Growth>,
    /// The fastest operation of this hardware, where a limit binds within the range of the form.
    pub fastest: Option<Fastest>,
    /// Assumed facts that flip a verdict.
    pub sensitivities: Vec<Flip>,
    /// What moves the results that are nearest to their limits.
    pub tornadoes: Vec<Tornado>,
    /// What there is to buy.
    pub bill: Vec<BillRow>,
}

/// Sizes a project with these programs. Total: a run that stops early is sized as far as it came.
pub fn size(project: &Project, written: &Written) -> Sizing {
    let runs = SizingRuns::new(project, written);
    Sizing { envelope: envelope::envelope(&project.prepared(), &runs), ..answers(project, &runs) }
}

/// The sizing of a project by runs that are there, without the envelope, which needs runs of its own.
pub fn answers(project: &Project, runs: &SizingRuns) -> Sizing {
    let prepared = project.prepared();
    let axes = choice::axes(project, &prepared, runs);
    let bill = bill::bill(project, &axes);
    let (limits, fastest) = growth::growth(project);
    let sensitivity = Sensitivity::new(project);
    Sizing {
        axes,
        cycle: cycle(&prepared, runs),
        envelope: Vec::new(),
        limits,
        fastest,
        sensitivities: sensitivity.flips(),
        tornadoes: tornado::tornadoes(&sensitivity),
        bill,
    }
}

/// Time and energy of the run that comes to the end of its program.
fn cycle(prepared: &PreparedMachine, runs: &SizingRuns) -> Option<Cycle> {
    let seconds = runs.seconds_of_a_part()?;
    let timeline = runs.run.timeline();
    let works = prepared
        .driven_axes()
        .into_iter()
        .map(|axis| axis.motion(&timeline.stretches(axis.mover, 0.0, timeline.end())).work(axis.fitted.motor.rotor));
    let (given, returned) =
        works.fold((0.0, 0.0), |(given, returned), work| (given + work.given, returned + work.returned));
    Some(Cycle { seconds, given, returned })
}

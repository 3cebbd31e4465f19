//! Sizing: which motors carry the machine, what happens to it in operation, what limits it, and what there is to buy.
//!
//! Torque and energy are those of runs of the very program, over stretches of constant acceleration; see [`Motion`](crate::drives::duty::Motion).

mod bill;

mod choice;

mod envelope;

mod gears;

mod growth;

mod runs;

pub mod sheets;

pub mod tell;

mod terminals;

mod tornado;

pub use bill::BillRow;
pub use choice::{Candidate, Refusal, Resistor, SizedAxis};
pub use envelope::{EnvelopeRow, Offer, OperatingEvent};
pub use gears::{GearCandidate, SizedGear};
pub use growth::{Fastest, Growth};
pub use runs::{CutRun, SizingRuns};
pub use terminals::TerminalRow;
pub use tornado::{Swing, Tornado};

use super::Project;
use super::program::Written;
use super::sensitivity::{Flip, Sensitivity};
use crate::drives::duty::{Motion, Work, on_one_bus};
use crate::machines::PreparedMachine;
use crate::motion::Mover;

/// Time and energy of a part, from the run of its program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycle {
    /// Seconds from cycle start to the end of the program.
    pub seconds: f64,
    /// Seconds from there to the next start.
    pub pause: f64,
    /// Energy of its motors; none where nothing is known of them.
    pub energy: Option<PartEnergy>,
}

impl Cycle {
    /// Seconds from one start to the next.
    pub fn between_starts(&self) -> f64 {
        self.seconds + self.pause
    }

    /// Parts in an hour of the shift.
    pub fn parts_per_hour(&self) -> f64 {
        3600.0 / self.between_starts()
    }
}

/// Energy of all motors over a part, that behind the inverter among them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartEnergy {
    /// Energy that they give at their shafts, J.
    pub given: f64,
    /// Energy that comes back to them, J.
    pub returned: f64,
    /// Energy that comes back from all of them where the servo motors share a DC bus, J; an inverter has a bus of its own.
    pub returned_on_one_bus: f64,
}

/// The sizing of a project.
#[derive(Debug, Clone, PartialEq)]
pub struct Sizing {
    /// Axes and drives with their motors.
    pub axes: Vec<SizedAxis>,
    /// Time and energy of a part; none where the program does not come to its end.
    pub cycle: Option<Cycle>,
    /// Where and why the run ended before the end of the program; none where it came there.
    pub cut: Option<CutRun>,
    /// What happens at every event of operation.
    pub envelope: Vec<EnvelopeRow>,
    /// Limits of the form that would hold in operation, where one does not.
    pub offers: Vec<Offer>,
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
    /// What is wired to which terminal.
    pub terminals: Vec<TerminalRow>,
}

/// Sizes a project with these programs. Total: a run that stops early is sized as far as it came.
pub fn size(project: &Project, written: &Written) -> Sizing {
    size_telling(project, written, &mut |_| ())
}

/// The same, and tells the share that is done, 0 to 1, on the way.
pub fn size_telling(project: &Project, written: &Written, tell: &mut dyn FnMut(f64)) -> Sizing {
    tell(0.0);
    let runs = SizingRuns::new(project, written);
    // The runs are one part, each event another, the answers the last.
    let parts = OperatingEvent::IDS.len() + 2;
    let mut done = 0;
    let mut part = || {
        done += 1;
        tell(f64::from(done) / parts as f64);
    };
    part();
    let envelope = envelope::envelope(project, &runs, &mut part);
    let offers = envelope::offers(project, &envelope);
    let sizing = Sizing { envelope, offers, ..answers(project, &runs) };
    part();
    sizing
}

/// The sizing of a project by runs that are there, without the envelope, which needs runs of its own.
pub fn answers(project: &Project, runs: &SizingRuns) -> Sizing {
    let prepared = project.prepared();
    let axes = choice::axes(project, &prepared, runs);
    let bill = bill::bill(project, &prepared, &axes);
    let terminals = terminals::terminals(&prepared, &axes);
    let (limits, fastest) = growth::growth(project);
    let sensitivity = Sensitivity::new(project);
    Sizing {
        axes,
        cycle: cycle(&prepared, runs),
        cut: runs.cut(),
        envelope: Vec::new(),
        offers: Vec::new(),
        limits,
        fastest,
        sensitivities: sensitivity.flips(),
        tornadoes: tornado::tornadoes(&sensitivity),
        bill,
        terminals,
    }
}

/// Time and energy of the run that comes to the end of its program.
fn cycle(prepared: &PreparedMachine, runs: &SizingRuns) -> Option<Cycle> {
    let seconds = runs.seconds_of_a_part()?;
    let timeline = runs.present.run.timeline();
    let motors: Vec<(Motion, f64)> = prepared
        .driven_axes()
        .into_iter()
        .map(|axis| {
            let motion = axis.motion(&timeline.stretches(axis.mover, 0.0, timeline.end()));
            let works = runs.present.works.clone();
            (works.map_or_else(|| motion.clone(), |works| motion.clone().with_work(works)), axis.fitted.motor.rotor)
        })
        .collect();
    let inverter = prepared.inverter_drive().map(|drive| {
        let motion = drive.motion(&timeline.stretches(Mover::Spindle, 0.0, timeline.end()));
        let work = motion.work(drive.rotor);
        Work { given: work.given + drive.work, ..work }
    });
    let works = motors.iter().map(|(motion, rotor)| motion.work(*rotor)).chain(inverter);
    let (given, returned) =
        works.fold((0.0, 0.0), |(given, returned), work| (given + work.given, returned + work.returned));
    let together: Vec<(&Motion, f64)> = motors.iter().map(|(motion, rotor)| (motion, *rotor)).collect();
    let returned_on_one_bus = on_one_bus(&together).1 + inverter.map_or(0.0, |work| work.returned);
    let is_known = !together.is_empty() || inverter.is_some();
    let energy = PartEnergy { given, returned, returned_on_one_bus };
    Some(Cycle { seconds, pause: prepared.pause(), energy: is_known.then_some(energy) })
}

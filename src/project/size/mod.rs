//! Sizing: motors that carry the machine, envelope of operation, limits of growth, bill of materials.
//!
//! Torque and energy come from runs of the program itself, over segments of constant acceleration; see
//! [`Motion`](crate::drives::shaft_motion::Motion).

mod amplifier;
mod bill;
mod choice;
mod demand;
mod envelope;
mod gears;
mod growth;
mod inverter_motor;
mod refusal;
mod runs;
pub mod sections;
pub mod sheets;
mod terminals;
mod tornado;
pub mod words;

pub use amplifier::Resistor;
pub use bill::BillRow;
pub use choice::{Candidate, SizedAxis};
pub use envelope::{DriveName, EnvelopeRow, HoldingLimit, OperatingEvent, Quantity};
pub use gears::{GearCandidate, SizedGear};
pub use growth::{Fastest, Growth, ResultName};
pub use refusal::Refusal;
pub(in crate::project) use runs::seconds_of_a_further_part;
pub use runs::{SizingRuns, TruncatedRun};
pub use terminals::{TerminalRow, WireEnd};
pub use tornado::{Swing, Tornado};

use super::Project;
use super::program::Written;
use super::sensitivity::{Flip, Sensitivity};
use crate::drives::shaft_motion::{Motion, on_one_bus};
use crate::machines::PreparedMachine;
use crate::machines::driven::FormMotor;
use crate::motion::Mover;

/// Time and energy of a part, from the run of its program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycle {
    /// Time (s) from cycle start to the end of the program.
    pub seconds: f64,
    /// The same time of each further part, whose gear is engaged already.
    pub further: f64,
    /// Pause (s) from the end of the program to the next start.
    pub pause: f64,
    /// Mean time (s) between two parts beside the pause: changes of material, ways to where the run begins.
    pub between_parts: f64,
    /// Energy of its motors; none if nothing is known of them.
    pub energy: Option<PartEnergy>,
}

impl Cycle {
    /// Time (s) from one start to the next in a series.
    pub fn between_starts(&self) -> f64 {
        self.further + self.pause
    }

    /// Mean time (s) of a part, with the pause and what else lies between two parts.
    pub fn mean(&self) -> f64 {
        self.between_starts() + self.between_parts
    }

    /// Parts in an hour of the shift.
    pub fn parts_per_hour(&self) -> f64 {
        3600.0 / self.mean()
    }
}

/// Energy of all motors over a part, including the one on the inverter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartEnergy {
    /// Energy that the motors deliver at their shafts, J.
    pub given: f64,
    /// Energy that they regenerate, J.
    pub returned: f64,
    /// Energy (J) that all of them regenerate if the servo motors share a DC bus; an inverter has a bus of its own.
    pub returned_on_one_bus: f64,
}

/// The sizing of a project.
#[derive(Debug, Clone, PartialEq)]
pub struct Sizing {
    /// Axes and drives with their motors.
    pub axes: Vec<SizedAxis>,
    /// Time and energy of a part; none if the run does not reach the end of the program.
    pub cycle: Option<Cycle>,
    /// Time and reason of a run that ended before the end of the program; none if it reached the end.
    pub truncated: Option<TruncatedRun>,
    /// Worst values at every event of operation.
    pub envelope: Vec<EnvelopeRow>,
    /// Limits of the form that would hold in operation, for those that fail.
    pub holding_limits: Vec<HoldingLimit>,
    /// Limits that bind next when speed, mass or pitch grow.
    pub limits: Vec<Growth>,
    /// The fastest operation of this hardware, if a limit binds within the range of the form.
    pub fastest: Option<Fastest>,
    /// Assumed facts that flip a verdict.
    pub sensitivities: Vec<Flip>,
    /// Facts that move the results nearest to their limits.
    pub tornadoes: Vec<Tornado>,
    /// Bill of materials.
    pub bill: Vec<BillRow>,
    /// Terminal list.
    pub terminals: Vec<TerminalRow>,
}

/// Sizes a project with these programs. Total: a run that stops early is sized as far as it came.
pub fn size(project: &Project, written: &Written) -> Sizing {
    size_with_progress(project, written, &mut |_| ())
}

/// Sizes a project with these programs and reports the share done, 0 to 1.
pub fn size_with_progress(project: &Project, written: &Written, progress: &mut dyn FnMut(f64)) -> Sizing {
    progress(0.0);
    let runs = SizingRuns::new(project, written);
    // Progress counts the runs, each event, and the rest.
    let parts = OperatingEvent::IDS.len() + 2;
    let mut done = 0;
    let mut part = || {
        done += 1;
        progress(f64::from(done) / parts as f64);
    };
    part();
    let envelope = envelope::envelope(project, &runs, &mut part);
    let holding_limits = if envelope.iter().any(EnvelopeRow::is_hold) {
        // A hold stops the loop from growing, so the limit that would suffice is taken from runs without contacts.
        let free = SizingRuns::without_contacts(project, written);
        envelope::holding_limits(project, &envelope::envelope(project, &free, &mut || ()))
    } else {
        envelope::holding_limits(project, &envelope)
    };
    let sizing = Sizing { envelope, holding_limits, ..size_without_envelope(project, &runs) };
    part();
    sizing
}

/// Sizes a project by finished runs, without the envelope, which needs runs of its own.
pub fn size_without_envelope(project: &Project, runs: &SizingRuns) -> Sizing {
    let prepared = project.prepared();
    let mut axes = choice::axes(project, &prepared, runs);
    axes.extend(inverter_motor::axis(project, &prepared, runs));
    let bill = bill::bill(project, &prepared, runs, &axes);
    let terminals = terminals::terminals(&prepared, &bill);
    let (limits, fastest) = growth::growth(project);
    let sensitivity = Sensitivity::new(project);
    Sizing {
        axes,
        cycle: cycle(project, &prepared, runs),
        truncated: runs.truncated(),
        envelope: Vec::new(),
        holding_limits: Vec::new(),
        limits,
        fastest,
        sensitivities: sensitivity.flips(),
        tornadoes: tornado::tornadoes(&sensitivity),
        bill,
        terminals,
    }
}

/// Time and energy of the run; none if it does not reach the end of the program. The energy is that of all motors, or none.
fn cycle(project: &Project, prepared: &PreparedMachine, runs: &SizingRuns) -> Option<Cycle> {
    let seconds = runs.seconds_of_a_part()?;
    let axes = prepared.driven_axes();
    let motors: Vec<(Motion, f64)> =
        axes.iter().map(|axis| (runs.present.motion(axis), axis.fitted.motor.rotor)).collect();
    let inverter = prepared.inverter_drive().map(|drive| {
        let spindle = runs.present.spindle(&**prepared).map(|spindle| spindle.motion);
        let motion = spindle.unwrap_or_else(|| drive.motion(&runs.present.run_segments(Mover::Spindle)));
        motion.motor_load(drive.rotor)
    });
    let loads = motors.iter().map(|(motion, rotor)| motion.motor_load(*rotor)).chain(inverter);
    let (given, returned) =
        loads.fold((0.0, 0.0), |(given, returned), load| (given + load.given, returned + load.returned));
    let together: Vec<(&Motion, f64)> = motors.iter().map(|(motion, rotor)| (motion, *rotor)).collect();
    let returned_on_one_bus = on_one_bus(&together).1 + inverter.map_or(0.0, |load| load.returned);
    let drives = axes.iter().map(|axis| axis.id).chain(prepared.inverter_drive().map(|drive| drive.id));
    let drives: Vec<&str> = drives.collect();
    // The form may leave a motor out.
    let hidden = prepared.hidden();
    let has = |motor: &&FormMotor| motor.figures.iter().any(|(_, field)| !hidden.contains(field));
    let mut motors = project.machine.info().motors.iter().filter(has);
    let is_known = !drives.is_empty() && motors.all(|motor| drives.contains(&motor.drive));
    let energy = PartEnergy { given, returned, returned_on_one_bus };
    let (pause, between_parts) = (prepared.pause(), prepared.time_between_parts());
    let further = seconds_of_a_further_part(prepared, &runs.present.run).unwrap_or(seconds);
    Some(Cycle { seconds, further, pause, between_parts, energy: is_known.then_some(energy) })
}

//! Reactions of a machine to interruptions of its run, as one table: its PLC acts by it, and its sheets show it.

use super::sheets::{row, say};
use crate::drives::holding_brake::CLOSING_TIME;
use crate::motion::ProgramState;
use crate::msg;
use crate::text::catalog::sentence;
use crate::text::{Citation, Message};
use crate::view::{Column, Sheet, SheetKind};

/// An interruption of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interruption {
    /// Feed hold.
    Hold,
    /// A stop between two blocks: M00, M01, a message, single block.
    BlockStop,
    /// An alarm.
    Alarm,
    /// Reset.
    Reset,
    /// Emergency stop.
    EmergencyStop,
    /// The spindle's inverter reports a fault.
    InverterFault,
    /// The supply fails.
    PowerFailure,
}

impl Interruption {
    /// Interruptions that last until cycle start or reset.
    pub const LASTING: [Interruption; 3] = [Interruption::Hold, Interruption::BlockStop, Interruption::Alarm];

    /// The interruption that lasts while the control reports this state. Reset and emergency stop are moments, and leave no program to go
    /// on with.
    pub fn lasting(program: ProgramState) -> Option<Interruption> {
        match program {
            ProgramState::Held => Some(Interruption::Hold),
            ProgramState::Stopped => Some(Interruption::BlockStop),
            ProgramState::Alarm => Some(Interruption::Alarm),
            ProgramState::Idle | ProgramState::Running => None,
        }
    }

    /// Catalog id of its name.
    fn name(self) -> &'static str {
        match self {
            Interruption::Hold => "stops.hold",
            Interruption::BlockStop => "stops.block-stop",
            Interruption::Alarm => "stops.alarm",
            Interruption::Reset => "stops.reset",
            Interruption::EmergencyStop => "stops.emergency",
            Interruption::InverterFault => "stops.inverter-fault",
            Interruption::PowerFailure => "stops.power-failure",
        }
    }
}

/// Reaction of the spindle to an interruption.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpindleReaction {
    /// The spindle keeps turning.
    Turns,
    /// The PLC holds it at speed 0; at cycle start it runs up again.
    Waits,
    /// M3 and M4 are dropped.
    Off,
    /// The inverter's output is off, M3 and M4 are dropped.
    OutputOff,
    /// It stays locked at its angle.
    StaysLocked,
    /// Its lock opens.
    Unlocks,
    /// Work and tool turn on in their ratio.
    TurnsInRatio,
    /// Work and tool slow down in their ratio to standstill.
    StopsInRatio,
    /// One drive has failed and its motor coasts: the PLC stops the other, and their ratio is lost.
    StopsBeside,
    /// The drives of work and tool are off: both coast, and their angle to each other is lost.
    Coasts,
}

impl SpindleReaction {
    /// Catalog id of the sentence.
    fn text(self) -> &'static str {
        match self {
            SpindleReaction::Turns => "stops.spindle-turns",
            SpindleReaction::Waits => "stops.spindle-waits",
            SpindleReaction::Off => "stops.spindle-off",
            SpindleReaction::OutputOff => "stops.spindle-output-off",
            SpindleReaction::StaysLocked => "stops.spindle-stays-locked",
            SpindleReaction::Unlocks => "stops.spindle-unlocks",
            SpindleReaction::TurnsInRatio => "stops.spindle-turns-in-ratio",
            SpindleReaction::StopsInRatio => "stops.spindle-stops-in-ratio",
            SpindleReaction::StopsBeside => "stops.spindle-stops-beside",
            SpindleReaction::Coasts => "stops.spindle-coasts",
        }
    }
}

/// A row of the table.
#[derive(Debug, Clone)]
pub struct Reaction {
    /// The interruption.
    pub at: Interruption,
    /// Catalog id of its cause, if the PLC itself interrupts or the row is about one part of the program; `None`: the
    /// name of `at`.
    pub cause: Option<&'static str>,
    /// Reaction of the spindle.
    pub spindle: SpindleReaction,
    /// Reaction of the axes.
    pub axes: Message,
    /// Consequence for the material: the web, the work.
    pub material: Message,
    /// Next step of the operator.
    pub operator: Message,
    /// Source and grade.
    pub cite: Citation,
}

/// Reaction of the slides of a lathe to an emergency stop. `way`: distance (mm) that a slide with a weight sinks until
/// its brake has closed; `None` without such a slide.
pub fn slides_at_emergency_stop(way: Option<f64>) -> Message {
    match way {
        Some(_) => msg!("lathe.stops.axes-emergency-brake", time = (CLOSING_TIME, 1)),
        None => msg!("lathe.stops.axes-emergency"),
    }
}

/// Reaction of the slides of a lathe to a power failure; `way` as in [`slides_at_emergency_stop`].
pub fn slides_without_supply(way: Option<f64>) -> Message {
    match way {
        Some(way) => msg!("lathe.stops.axes-unpowered-brake", way = (way, 2), time = (CLOSING_TIME, 1)),
        None => msg!("lathe.stops.axes-unpowered"),
    }
}

/// The table as a sheet.
pub fn sheet(reactions: &[Reaction]) -> Sheet {
    let line = |reaction: &Reaction| {
        let cells = [
            say(reaction.cause.unwrap_or(reaction.at.name())),
            say(reaction.spindle.text()),
            sentence(&reaction.axes),
            sentence(&reaction.material),
            sentence(&reaction.operator),
        ];
        row(cells, reaction.cite)
    };
    let has_inverter = reactions.iter().any(|reaction| reaction.at == Interruption::InverterFault);
    Sheet {
        id: "stops",
        kind: SheetKind::Plain,
        title: if has_inverter { "sheet.stops-and-fault" } else { "sheet.stops" },
        columns: ["sheet.interruption", "sheet.spindle", "sheet.axes", "sheet.material", "sheet.operator"]
            .map(Column::Plain)
            .to_vec(),
        rows: reactions.iter().map(line).collect(),
        drawing: String::new(),
    }
}

//! The terminal list: wires of motors and amplifiers, contacts and outputs of the machine's PLC, set speed of the inverter.
//! The supply, and the plugs of encoders and of servo amplifiers, are those of their makers.

use super::SizedAxis;
use crate::machines::PreparedMachine;
use crate::machines::ladder::{Bit, MachineOutput};
use crate::machines::sheets::say;
use crate::text::{Citation, Grade, headed};

/// A wire at a terminal.
#[derive(Debug, Clone, PartialEq)]
pub struct TerminalRow {
    /// The terminal: its strip and its number, for instance `X2:4`.
    pub terminal: String,
    /// Signal of the wire.
    pub signal: String,
    /// Start of the wire.
    pub from: String,
    /// End of the wire.
    pub to: String,
    /// Source and grade.
    pub cite: Citation,
}

/// Source of the strips: power, contacts and analog voltages are kept apart.
const STRIPS: Citation = Citation::new("engineering choice", Grade::Inferred);

/// Wires of a motor from its amplifier or inverter.
const PHASES: [&str; 4] = ["U", "V", "W", "PE"];

/// The rows: strip X1 for the motors and their brakes, X2 for the contacts and outputs of the PLC, X3 for the set speed.
pub(super) fn terminals(prepared: &PreparedMachine, axes: &[SizedAxis]) -> Vec<TerminalRow> {
    let power = axes.iter().flat_map(motor_wires);
    let ladder = prepared.ladder();
    let bits = ladder.iter().flat_map(|ladder| ladder.bits.iter());
    let contacts = bits.filter_map(|(bit, device)| {
        let plc = format!("{} {}", say("plc.side.plc"), device.name);
        let (from, to) = match bit {
            Bit::Input(_) => (say("plc.side.machine"), plc),
            // Alarms are texts of the control.
            Bit::Output(MachineOutput::Forward | MachineOutput::Reverse | MachineOutput::Gear(_)) => {
                (plc, say("plc.side.machine"))
            }
            _ => return None,
        };
        Some((say(device.meaning), from, to, device.cite))
    });
    let drive = prepared.inverter_drive();
    let analog = drive.iter().flat_map(|drive| {
        let inverter = headed(say(drive.name), say("size.item.inverter"));
        ["size.terminal.set-speed", "size.terminal.common", "size.terminal.screen"]
            .map(|signal| (say(signal), say("size.terminal.analog-output"), inverter.clone(), STRIPS))
    });
    numbered("X1", power).chain(numbered("X2", contacts)).chain(numbered("X3", analog)).collect()
}

/// Signal, both ends, source.
type Wire = (String, String, String, Citation);

/// The wires of a motor and its brake.
fn motor_wires(axis: &SizedAxis) -> Vec<Wire> {
    let end = |item| headed(say(axis.name), say(item));
    let amplifier = end(if axis.work.is_some() { "size.item.amplifier" } else { "size.item.inverter" });
    let phase = |phase: &str| (phase.to_owned(), amplifier.clone(), end("size.item.motor"), STRIPS);
    let brake = ["size.terminal.brake-plus", "size.terminal.brake-minus"]
        .map(|signal| (say(signal), say("size.terminal.brake-contactor"), end("size.item.brake"), STRIPS));
    PHASES.into_iter().map(phase).chain(brake.into_iter().filter(|_| axis.brake > 0.0)).collect()
}

/// The wires at the terminals of a strip, numbered from 1.
fn numbered(strip: &'static str, wires: impl Iterator<Item = Wire>) -> impl Iterator<Item = TerminalRow> {
    (1..).zip(wires).map(move |(number, (signal, from, to, cite))| TerminalRow {
        terminal: format!("{strip}:{number}"),
        signal,
        from,
        to,
        cite,
    })
}

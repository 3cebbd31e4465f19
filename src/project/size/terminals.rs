//! The terminal list: wires at the terminals of the cabinet, and ready-made cables, between items of the bill.
//!
//! Each end is an item of the bill, and each item of the bill that wires lead to has its wires here. Plugs and pins of control, amplifiers
//! and encoders are those of their makers.

use std::collections::{BTreeMap, BTreeSet};

use super::bill::BillRow;
use crate::machines::PreparedMachine;
use crate::machines::driven::devices::{BillItem, wired};
use crate::machines::ladder::{ContactKind, Device, Ladder, PlcSide};
use crate::machines::sheets::say;
use crate::motion::Mover;
use crate::msg;
use crate::text::catalog::sentence;
use crate::text::{Citation, Grade, headed};

/// A wire at a terminal, or a cable.
#[derive(Debug, Clone, PartialEq)]
pub struct TerminalRow {
    /// The terminal, its strip and its number, for instance `X2:4`; of a ready-made cable its number, `W3`.
    pub terminal: String,
    /// Signal of the wire.
    pub signal: String,
    /// Start of the wire.
    pub from: WireEnd,
    /// End of the wire.
    pub to: WireEnd,
    /// Source and grade.
    pub cite: Citation,
}

/// End of a wire.
#[derive(Debug, Clone, PartialEq)]
pub struct WireEnd {
    /// Item of the bill.
    pub item: BillItem,
    /// Catalog id of its axis, as in the bill.
    pub axis: Option<&'static str>,
    /// Its place at the item, in full; empty where the item is enough.
    pub place: String,
}

impl WireEnd {
    fn of(item: BillItem, axis: Option<&'static str>) -> WireEnd {
        WireEnd { item, axis, place: String::new() }
    }

    /// Its name: the place, else the item with its axis.
    pub fn text(&self) -> String {
        match self.axis {
            _ if !self.place.is_empty() => self.place.clone(),
            Some(axis) => headed(say(axis), say(self.item.name())),
            None => say(self.item.name()),
        }
    }
}

/// Source of the strips: power, contacts and analog voltages are kept apart.
const STRIPS: Citation = Citation::new("engineering choice", Grade::Inferred);

/// Wires of a motor from its amplifier or inverter.
const PHASES: [&str; 4] = ["U", "V", "W", "PE"];

/// Strips in their order, and the ready-made cables: supply, motors with their brakes, contacts and outputs of the PLC, analog voltages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Strip {
    Supply,
    Motors,
    Contacts,
    Analog,
    Cables,
}

impl Strip {
    /// Name of a terminal, counted from 1.
    fn terminal(self, number: u32) -> String {
        match self {
            Strip::Supply => format!("X0:{number}"),
            Strip::Motors => format!("X1:{number}"),
            Strip::Contacts => format!("X2:{number}"),
            Strip::Analog => format!("X3:{number}"),
            Strip::Cables => format!("W{number}"),
        }
    }
}

/// A wire before it has its terminal.
#[derive(Clone)]
struct Wire {
    strip: Strip,
    signal: String,
    from: WireEnd,
    to: WireEnd,
    cite: Citation,
}

/// The rows, by strip.
pub(super) fn terminals(prepared: &PreparedMachine, bill: &[BillRow]) -> Vec<TerminalRow> {
    let ladder = prepared.ladder();
    let coasting: Vec<&'static str> = coasting_axes(prepared).collect();
    let of_items = bill.iter().flat_map(|row| wires(row.item, row.axis, bill, &coasting));
    let mut wires: Vec<Wire> = of_items.chain(contacts(ladder.as_ref(), bill)).collect();
    wires.sort_by_key(|wire| wire.strip);
    let mut numbers: BTreeMap<Strip, u32> = BTreeMap::new();
    let numbered = |Wire { strip, signal, from, to, cite }: Wire| {
        let number = numbers.entry(strip).and_modify(|number| *number += 1).or_insert(1);
        TerminalRow { terminal: strip.terminal(*number), signal, from, to, cite }
    };
    wires.into_iter().map(numbered).collect()
}

/// Names of the axes whose drives lose their enable at once at an emergency stop; others keep it until they are at
/// rest.
fn coasting_axes(prepared: &PreparedMachine) -> impl Iterator<Item = &'static str> {
    let axes = if prepared.coasts_at_emergency_stop() { prepared.driven_axes() } else { Vec::new() };
    axes.into_iter().filter(|axis| matches!(axis.mover, Mover::Turned(_))).map(|axis| axis.name)
}

/// The wires of an item but for those of the PLC's contacts and outputs; the drives of the `coasting` axes lose their enable at once.
fn wires(item: BillItem, axis: Option<&'static str>, bill: &[BillRow], coasting: &[&'static str]) -> Vec<Wire> {
    let own = WireEnd::of(item, axis);
    let of = |item: BillItem| WireEnd::of(item, axis);
    let of_machine = |item: BillItem| WireEnd::of(item, None);
    let billed = |item: BillItem| bill.iter().any(|row| row.item == item && row.axis == axis);
    let drive = if billed(BillItem::Inverter) { BillItem::Inverter } else { BillItem::Amplifier };
    let fed = || {
        let end = || of_machine(BillItem::MainSwitch);
        ["size.terminal.mains", "size.terminal.earth"]
            .map(|signal| wire(Strip::Supply, signal, end(), own.clone()))
            .to_vec()
    };
    let is_safe = bill.iter().any(|row| row.item == BillItem::SafetyRelay);
    let at_once = axis.is_some_and(|axis| coasting.contains(&axis));
    let signal = if at_once { "size.terminal.enable-at-once" } else { "size.terminal.enable-delayed" };
    let enable = is_safe.then(|| wire(Strip::Contacts, signal, of_machine(BillItem::SafetyRelay), own.clone()));
    let analog = |signals: [&'static str; 3], from: WireEnd, to: WireEnd| {
        signals.map(|signal| wire(Strip::Analog, signal, from.clone(), to.clone())).to_vec()
    };
    match item {
        BillItem::Motor => {
            let phase = |phase: &str| Wire {
                strip: Strip::Motors,
                signal: phase.to_owned(),
                from: of(drive),
                to: own.clone(),
                cite: STRIPS,
            };
            let encoder = wire(Strip::Cables, "size.terminal.motor-encoder", own.clone(), of(drive));
            PHASES.into_iter().map(phase).chain((drive == BillItem::Amplifier).then_some(encoder)).collect()
        }
        BillItem::Amplifier => {
            let command = wire(Strip::Cables, "size.terminal.command", of_machine(BillItem::Control), own.clone());
            fed().into_iter().chain([command]).chain(enable).collect()
        }
        BillItem::Inverter => {
            let output = WireEnd { place: say("size.terminal.analog-output"), ..of_machine(BillItem::Control) };
            let signals = ["size.terminal.set-speed", "size.terminal.common", "size.terminal.screen"];
            fed().into_iter().chain(analog(signals, output, own.clone())).chain(enable).collect()
        }
        BillItem::Fan | BillItem::ControlSupply | BillItem::BrakeSupply => fed(),
        BillItem::BrakeContactor => of_brake_contactor(drive, axis),
        BillItem::Brake => ["size.terminal.brake-plus", "size.terminal.brake-minus"]
            .map(|signal| wire(Strip::Motors, signal, of(BillItem::BrakeContactor), own.clone()))
            .into(),
        BillItem::Resistor => ["size.terminal.resistor-first", "size.terminal.resistor-second"]
            .map(|signal| wire(Strip::Motors, signal, of(drive), own.clone()))
            .into(),
        BillItem::Encoder => {
            vec![wire(Strip::Cables, "size.terminal.spindle-encoder", own, of_machine(BillItem::Control))]
        }
        BillItem::ReferenceSwitch => {
            let input = of_machine(BillItem::Control);
            let place = headed(input.text(), say("size.terminal.reference-input"));
            let supply = of_machine(BillItem::ControlSupply);
            vec![
                wire(Strip::Contacts, "size.terminal.contact-common", supply, own.clone()),
                wire(Strip::Contacts, "size.terminal.reference-switch", own, WireEnd { place, ..input }),
            ]
        }
        BillItem::DrivenTool => {
            let command = wire(Strip::Cables, "size.terminal.driven-tool", of_machine(BillItem::Control), own.clone());
            fed().into_iter().chain([command]).chain(enable).collect()
        }
        BillItem::Turret => {
            let command = wire(Strip::Cables, "size.terminal.tool-number", of_machine(BillItem::Control), own.clone());
            fed().into_iter().chain(of_electronics(own)).chain([command]).chain(enable).collect()
        }
        BillItem::Dancer => {
            let inverter = of(BillItem::Inverter);
            let input = WireEnd { place: headed(inverter.text(), say("size.terminal.trim-input")), ..inverter };
            let signals = ["size.terminal.dancer", "size.terminal.dancer-common", "size.terminal.screen"];
            analog(signals, own.clone(), input).into_iter().chain(of_electronics(own)).collect()
        }
        BillItem::StandstillMonitor | BillItem::LoopSensor | BillItem::ReelSensor => of_electronics(own).into(),
        BillItem::Control => ["size.terminal.control-plus", "size.terminal.control-zero"]
            .map(|signal| wire(Strip::Supply, signal, of_machine(BillItem::ControlSupply), own.clone()))
            .into(),
        BillItem::SafetyRelay => {
            let button = || of_machine(BillItem::EmergencyStop);
            let channels = ["size.terminal.first-channel", "size.terminal.second-channel"]
                .map(|signal| wire(Strip::Contacts, signal, button(), own.clone()));
            let supply = ["size.terminal.relay-plus", "size.terminal.relay-zero"]
                .map(|signal| wire(Strip::Supply, signal, of_machine(BillItem::ControlSupply), own.clone()));
            channels.into_iter().chain(supply).collect()
        }
        BillItem::Gear
        | BillItem::EmergencyStop
        | BillItem::OverrideSwitch
        | BillItem::Key
        | BillItem::GearSwitch
        | BillItem::GearValve
        | BillItem::ClampSwitch
        | BillItem::ClampValve
        | BillItem::TailstockSwitch
        | BillItem::TensionSwitch
        | BillItem::MainSwitch => Vec::new(),
    }
}

/// The wires of the contactor of a brake at the motor of an axis.
fn of_brake_contactor(drive: BillItem, axis: Option<&'static str>) -> Vec<Wire> {
    let of = |item: BillItem| WireEnd::of(item, axis);
    let own = of(BillItem::BrakeContactor);
    // It closes the brake whenever the drive is off: its coil hangs on the output of the drive, not on the mains.
    let output = WireEnd { place: headed(of(drive).text(), say("size.terminal.brake-output")), ..of(drive) };
    let power = ["size.terminal.brake-supply-plus", "size.terminal.brake-supply-minus"]
        .map(|signal| wire(Strip::Motors, signal, of(BillItem::BrakeSupply), own.clone()));
    let supply = WireEnd::of(BillItem::ControlSupply, None);
    let coil = [
        wire(Strip::Contacts, "size.terminal.brake-coil-plus", supply, own.clone()),
        wire(Strip::Contacts, "size.terminal.brake-coil", output, own.clone()),
    ];
    power.into_iter().chain(coil).collect()
}

/// The supply of a device with electronics of its own: sensors, monitors, controllers.
fn of_electronics(own: WireEnd) -> [Wire; 2] {
    ["size.terminal.device-plus", "size.terminal.device-zero"]
        .map(|signal| wire(Strip::Supply, signal, WireEnd::of(BillItem::ControlSupply, None), own.clone()))
}

/// A wire with its signal (catalog id).
fn wire(strip: Strip, signal: &'static str, from: WireEnd, to: WireEnd) -> Wire {
    Wire { strip, signal: say(signal), from, to, cite: STRIPS }
}

/// Meaning of the signal of a wire, with the kind of the contact that switches it.
fn signal_of(device: &Device) -> String {
    let meaning = say(device.meaning);
    match device.contact {
        Some(ContactKind::Make) => sentence(&msg!("size.terminal.make-contact", meaning)),
        Some(ContactKind::Held) => sentence(&msg!("size.terminal.held-contact", meaning)),
        Some(ContactKind::Break) => sentence(&msg!("size.terminal.break-contact", meaning)),
        None => meaning,
    }
}

/// The wires of the PLC's contacts and outputs, and after them the common wire of each item at their other end.
fn contacts(ladder: Option<&Ladder>, bill: &[BillRow]) -> Vec<Wire> {
    let end = |item: BillItem| WireEnd::of(item, bill.iter().find(|row| row.item == item).and_then(|row| row.axis));
    let is_output = |device: &Device| device.sides.0 == PlcSide::Plc;
    let wired = wired(ladder);
    let wire = |(item, device): &(BillItem, Device)| {
        let plc = say("plc.side.plc");
        let place = match item {
            // Contacts of a code, which rungs of their own read into the register.
            BillItem::OverrideSwitch => sentence(&msg!("size.terminal.decoded", plc, register = device.name.as_str())),
            _ => format!("{plc} {}", device.name),
        };
        let plc = WireEnd { place, ..WireEnd::of(BillItem::Control, None) };
        let (from, to) = if is_output(device) { (plc, end(*item)) } else { (end(*item), plc) };
        Wire { strip: Strip::Contacts, signal: signal_of(device), from, to, cite: device.cite }
    };
    // An inverter has a common of its own for its inputs.
    let signal = |item: BillItem, is_output: bool| match (item, is_output) {
        (BillItem::Inverter, true) => "size.terminal.inverter-common",
        (_, true) => "size.terminal.output-common",
        (_, false) => "size.terminal.contact-common",
    };
    let commons: BTreeSet<(BillItem, bool)> = wired.iter().map(|(item, device)| (*item, is_output(device))).collect();
    let common = |(item, is_output): (BillItem, bool)| Wire {
        strip: Strip::Contacts,
        signal: say(signal(item, is_output)),
        from: WireEnd::of(BillItem::ControlSupply, None),
        to: end(item),
        cite: STRIPS,
    };
    wired.iter().map(wire).chain(commons.into_iter().map(common)).collect()
}

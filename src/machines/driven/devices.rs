//! Items of the bill of materials, and the devices that the ladder and the form of a machine require.

use crate::machines::ladder::{Bit, Device, Ladder, MachineContact, MachineOutput, PlcNumber};
use crate::msg;
use crate::text::Message;
use crate::view::Advice;

/// An item of the bill, in its order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum BillItem {
    /// The control with its PLC.
    Control,
    /// A motor; a servo motor with its encoder.
    Motor,
    /// Amplifier of a servo motor.
    Amplifier,
    /// Inverter of an induction motor.
    Inverter,
    /// Gear unit.
    Gear,
    /// Brake at a motor that closes without current.
    Brake,
    /// Contactor of such a brake.
    BrakeContactor,
    /// Supply of such a brake.
    BrakeSupply,
    /// Brake resistor.
    Resistor,
    /// Encoder of a spindle.
    Encoder,
    /// Switch of the zero return of an axis.
    ReferenceSwitch,
    /// Fan of forced cooling, with a supply of its own.
    Fan,
    /// Dancer with the sensor of its position.
    Dancer,
    /// Button for the emergency stop.
    EmergencyStop,
    /// Relay of the emergency stop, which takes the enable from the drives.
    SafetyRelay,
    /// Switch of an override.
    OverrideSwitch,
    /// Key that the PLC reads.
    Key,
    /// Monitor of the standstill of a spindle, with its proximity switch.
    StandstillMonitor,
    /// Position switch of a gear stage.
    GearSwitch,
    /// Valve of a gear stage.
    GearValve,
    /// Switch at the clamp of a spindle.
    ClampSwitch,
    /// Valve of the clamp of a spindle.
    ClampValve,
    /// Switch of the pressure that a tailstock holds the work with.
    TailstockSwitch,
    /// Driven tool with its motor and drive.
    DrivenTool,
    /// Turret with its controller.
    Turret,
    /// Sensor of the longest loop.
    LoopSensor,
    /// Switch of the tight web.
    TensionSwitch,
    /// Sensor of the end of the reel.
    ReelSensor,
    /// Main switch with the protection of the lines.
    MainSwitch,
    /// Supply of control, contacts and valves.
    ControlSupply,
}

impl BillItem {
    /// Catalog id of its name.
    pub fn name(self) -> &'static str {
        match self {
            BillItem::Control => "size.item.control",
            BillItem::Motor => "size.item.motor",
            BillItem::Amplifier => "size.item.amplifier",
            BillItem::Inverter => "size.item.inverter",
            BillItem::Gear => "size.item.gear",
            BillItem::Brake => "size.item.brake",
            BillItem::BrakeContactor => "size.item.brake-contactor",
            BillItem::BrakeSupply => "size.item.brake-supply",
            BillItem::Resistor => "size.item.resistor",
            BillItem::Encoder => "size.item.encoder",
            BillItem::ReferenceSwitch => "size.item.reference-switch",
            BillItem::Fan => "size.item.fan",
            BillItem::Dancer => "size.item.dancer",
            BillItem::EmergencyStop => "size.item.emergency-stop",
            BillItem::SafetyRelay => "size.item.safety-relay",
            BillItem::OverrideSwitch => "size.item.override-switch",
            BillItem::Key => "size.item.key",
            BillItem::StandstillMonitor => "size.item.standstill-monitor",
            BillItem::GearSwitch => "size.item.gear-switch",
            BillItem::GearValve => "size.item.gear-valve",
            BillItem::ClampSwitch => "size.item.clamp-switch",
            BillItem::ClampValve => "size.item.clamp-valve",
            BillItem::TailstockSwitch => "size.item.tailstock-switch",
            BillItem::DrivenTool => "size.item.driven-tool",
            BillItem::Turret => "size.item.turret",
            BillItem::LoopSensor => "size.item.loop-sensor",
            BillItem::TensionSwitch => "size.item.tension-switch",
            BillItem::ReelSensor => "size.item.reel-sensor",
            BillItem::MainSwitch => "size.item.main-switch",
            BillItem::ControlSupply => "size.item.control-supply",
        }
    }
}

/// A device that a machine needs, with its requirements.
#[derive(Debug, Clone, PartialEq)]
pub struct AskedDevice {
    /// Its item.
    pub item: BillItem,
    /// Catalog id of the name of its drive; none for a device of the whole machine.
    pub drive: Option<&'static str>,
    /// Range and kind of signal.
    pub asked: Message,
}

/// The switch of the zero return of a servo axis, by the name of its drive. Motors of the catalogue are not said to have absolute encoders.
pub fn reference_switch(drive: &'static str) -> AskedDevice {
    AskedDevice { item: BillItem::ReferenceSwitch, drive: Some(drive), asked: msg!("size.device.reference-switch") }
}

/// An advice to fit forced cooling (IC 416), with the field of the form that has it.
pub fn forced_cooling_advice(field: &'static str, message: Message) -> Advice {
    Advice::from(message).setting(msg!("advice.forced-cooling"), [(field, "true".to_owned())])
}

/// The item that carries the contact.
pub fn item_of_contact(contact: MachineContact) -> BillItem {
    match contact {
        MachineContact::Emergency => BillItem::EmergencyStop,
        MachineContact::EmergencyDelayed => BillItem::SafetyRelay,
        MachineContact::ResetKey
        | MachineContact::ForwardKey
        | MachineContact::ReverseKey
        | MachineContact::StopKey
        | MachineContact::HoldKey => BillItem::Key,
        MachineContact::InverterReady
        | MachineContact::InverterEnabled
        | MachineContact::AtSpeed
        | MachineContact::AtShiftSpeed => BillItem::Inverter,
        MachineContact::AtStandstill => BillItem::StandstillMonitor,
        MachineContact::InGear(_) => BillItem::GearSwitch,
        MachineContact::SpindleClamped => BillItem::ClampSwitch,
        MachineContact::WorkHeld => BillItem::TailstockSwitch,
        MachineContact::LoopNotFull => BillItem::LoopSensor,
        MachineContact::WebNotTight => BillItem::TensionSwitch,
        MachineContact::ReelNotEmpty => BillItem::ReelSensor,
        MachineContact::TurretInPosition => BillItem::Turret,
    }
}

/// The item at the other end of an output's wire; none for message texts, which have no wire.
pub fn item_of_output(output: MachineOutput) -> Option<BillItem> {
    match output {
        MachineOutput::Forward | MachineOutput::Reverse | MachineOutput::Run => Some(BillItem::Inverter),
        MachineOutput::Gear(_) => Some(BillItem::GearValve),
        MachineOutput::SpindleClamp | MachineOutput::SpindleUnclamp => Some(BillItem::ClampValve),
        MachineOutput::DrivenTool => Some(BillItem::DrivenTool),
        MachineOutput::TurretStart => Some(BillItem::Turret),
        MachineOutput::InverterAlarm
        | MachineOutput::ReversalAlarm
        | MachineOutput::GearAlarm
        | MachineOutput::Message(_) => None,
    }
}

/// Inputs and outputs of the PLC that a wire leads to, with the item at its other end.
pub fn wired(ladder: Option<&Ladder>) -> Vec<(BillItem, Device)> {
    let knobs = ladder.into_iter().flat_map(|ladder| ladder.words.iter()).filter_map(|(word, device)| {
        let is_knob = matches!(word, PlcNumber::Knob | PlcNumber::FeedKnob);
        is_knob.then(|| (BillItem::OverrideSwitch, device.clone()))
    });
    let bits = ladder.into_iter().flat_map(|ladder| ladder.bits.iter());
    let device = |(bit, device): &(Bit, Device)| {
        let item = match bit {
            Bit::Input(contact) => Some(item_of_contact(*contact)),
            Bit::Output(output) => item_of_output(*output),
            _ => None,
        };
        Some((item?, device.clone()))
    };
    bits.filter_map(device).chain(knobs).collect()
}

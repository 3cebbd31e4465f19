//! Bill of materials and terminal list agree: each end of a wire is an item of the bill, and each item that wires lead to has its wires.

use std::collections::BTreeSet;

use macroline::drives::parts::PartGrade;
use macroline::machines::ALL;
use macroline::machines::driven::devices::{BillItem, item_of_contact, item_of_output};
use macroline::machines::form::Value;
use macroline::machines::ladder::{Bit, MachineContact, MachineOutput};
use macroline::project::Project;
use macroline::project::size::{Sizing, SizingRuns, size_without_envelope};

fn answered(project: &Project) -> Sizing {
    size_without_envelope(project, &SizingRuns::new(project, &project.written()))
}

/// An item of the bill with its axis.
type Entry = (BillItem, Option<&'static str>);

fn billed(sizing: &Sizing) -> BTreeSet<Entry> {
    sizing.bill.iter().map(|row| (row.item, row.axis)).collect()
}

/// The ends of all wires.
fn wired(sizing: &Sizing) -> BTreeSet<Entry> {
    sizing.terminals.iter().flat_map(|row| [&row.from, &row.to]).map(|end| (end.item, end.axis)).collect()
}

fn agree(name: &str, project: &Project) -> Sizing {
    let sizing = answered(project);
    let (billed, wired) = (billed(&sizing), wired(&sizing));
    let wanted: BTreeSet<Entry> = billed.iter().copied().filter(|(item, _)| *item != BillItem::Gear).collect();
    assert_eq!(wired, wanted, "{name}");
    // Each item once: quantities can be ordered as they are.
    assert_eq!(billed.len(), sizing.bill.len(), "{name}: {:?}", sizing.bill);
    // Each contact and each output of the PLC is a wire, and its device is ordered as often as wires lead to it.
    let ladder = project.prepared().ladder().expect("a ladder");
    let devices: Vec<(BillItem, &str)> = ladder
        .bits
        .iter()
        .filter_map(|(bit, device)| match bit {
            Bit::Input(contact) => Some((item_of_contact(*contact), device.name.as_str())),
            Bit::Output(output) => Some((item_of_output(*output)?, device.name.as_str())),
            _ => None,
        })
        .collect();
    for (item, device) in &devices {
        let place = format!("PLC {device}");
        let ends = |row: &macroline::project::size::TerminalRow| {
            let (plc, other) = if row.to.place == place { (&row.to, &row.from) } else { (&row.from, &row.to) };
            plc.place == place && plc.item == BillItem::Control && other.item == *item
        };
        assert_eq!(sizing.terminals.iter().filter(|row| ends(row)).count(), 1, "{name}: {place}");
        let wires = devices.iter().filter(|(other, _)| other == item).count();
        let ordered: u32 = sizing.bill.iter().filter(|row| row.item == *item).map(|row| row.quantity).sum();
        // Inverter and turret are one device each, with several wires.
        let devices = if *item == BillItem::Turret { 1 } else { wires };
        assert!(*item == BillItem::Inverter || ordered as usize == devices, "{name}: {item:?}");
    }
    let names: BTreeSet<&str> = sizing.terminals.iter().map(|row| row.terminal.as_str()).collect();
    assert_eq!(names.len(), sizing.terminals.len(), "{name}");
    sizing
}

/// Items with electronics of their own, which the contacts and signals of the PLC do not supply.
pub(crate) const ELECTRONICS: [BillItem; 5] =
    [BillItem::Dancer, BillItem::StandstillMonitor, BillItem::Turret, BillItem::LoopSensor, BillItem::ReelSensor];

#[test]
fn each_device_with_electronics_has_its_supply() {
    let mut found = BTreeSet::new();
    for machine in ALL {
        for example in machine.examples() {
            let project = Project::named(machine.id(), None, Some(example.id)).unwrap();
            let sizing = answered(&project.with_entries(&[("dancer", "true")]).unwrap_or(project));
            for item in ELECTRONICS.into_iter().filter(|item| sizing.bill.iter().any(|row| row.item == *item)) {
                let of_device = sizing.terminals.iter().filter(|row| row.to.item == item);
                let supply = of_device
                    .filter(|row| row.from.item == BillItem::ControlSupply && row.terminal.starts_with("X0:"))
                    .map(|row| row.signal.as_str());
                let wanted = ["Supply of the device, 24 V", "Supply of the device, 0 V"];
                assert_eq!(Vec::from_iter(supply), wanted, "{item:?}");
                found.insert(item);
            }
        }
    }
    assert_eq!(found, BTreeSet::from(ELECTRONICS));
}

#[test]
fn each_wire_ends_at_items_of_the_bill_and_each_item_has_wires() {
    for machine in ALL {
        for control in machine.controls() {
            agree(
                &format!("{} on {control}", machine.id()),
                &Project::named(machine.id(), Some(control), None).unwrap(),
            );
            for example in machine.examples() {
                let project = Project::named(machine.id(), Some(control), Some(example.id)).unwrap();
                agree(&format!("{} {} on {control}", machine.id(), example.id), &project);
            }
        }
    }
}

#[test]
fn options_of_the_form_change_bill_and_terminals_together() {
    let (on, off) = (Value::Flag(true), Value::Flag(false));
    let unwinder = |item| (item, Some("ribbon.drive.unwinder"));
    // 20 % is what an inverter takes back without a resistor.
    let (brakes, bare) = (Value::Number(150.0), Value::Number(20.0));
    let spindle = |item| (item, Some("turning.drive.spindle"));
    let rows: [(&str, &str, [Value; 2], Entry); 6] = [
        ("ribbon-line", "dancer", [on.clone(), off.clone()], unwinder(BillItem::Dancer)),
        ("ribbon-line", "spindle-encoder", [on.clone(), off.clone()], unwinder(BillItem::Encoder)),
        ("ribbon-line", "unwinder-forced-cooling", [on.clone(), off.clone()], unwinder(BillItem::Fan)),
        ("turning-spindle", "motor-forced-cooling", [on, off], spindle(BillItem::Fan)),
        ("ribbon-line", "unwinder-motor-brake", [5.0, 0.0].map(Value::Number), unwinder(BillItem::Brake)),
        ("turning-spindle", "motor-braking", [brakes, bare], spindle(BillItem::Resistor)),
    ];
    for (machine, field, [with, without], entry) in rows {
        for (value, has) in [(with, true), (without, false)] {
            let mut project = Project::named(machine, None, None).unwrap();
            assert!(project.machine.fields().iter().any(|row| row.id == field), "{field}");
            project.values.insert(field.to_owned(), value);
            let sizing = agree(field, &project);
            assert_eq!((billed(&sizing).contains(&entry), wired(&sizing).contains(&entry)), (has, has), "{field}");
        }
    }
}

#[test]
fn lathe_without_a_known_cut_has_its_motor_on_the_terminals() {
    let lathe = Project::named("turning-spindle", None, None).unwrap();
    let lathe = lathe.with_entries(&[("material", "none")]).unwrap();
    assert!(lathe.prepared().inverter_drive().is_none());
    let sizing = agree("no cut", &lathe);
    let motor = |row: &&macroline::project::size::TerminalRow| row.to.item == BillItem::Motor;
    // Of the spindle and of two slides.
    assert_eq!(sizing.terminals.iter().filter(motor).count(), 3 * 4);
}

#[test]
fn dancer_asks_the_inverter_for_a_trim_input() {
    for dancer in [true, false] {
        let mut line = Project::named("ribbon-line", None, None).unwrap();
        line.values.insert("dancer".to_owned(), Value::Flag(dancer));
        line.values.insert("loop-capacity".to_owned(), Value::Number(432.0));
        let sizing = answered(&line);
        let inverter = sizing.bill.iter().find(|row| row.item == BillItem::Inverter).unwrap();
        assert_eq!(inverter.open.iter().filter(|open| open.id == "size.bill.trim-input").count(), usize::from(dancer));
        let row = sizing.bill.iter().find(|row| row.item == BillItem::Dancer);
        assert_eq!(row.map(|row| row.grade), dancer.then_some(PartGrade::Open));
        // The sensor is where the loop is as long as its capacity. What a hold lays with the knob at its end is below it:
        // v (ramp / 2 - τ / 2 - 1 / K), at the clamp of 1480 r/min.
        let requirement = |item: BillItem| sizing.bill.iter().find(|row| row.item == item).unwrap().asked.clone();
        let speed = 1480.0 / 60.0 * std::f64::consts::PI * 100.5 / 50.0;
        let takes = format!("takes up {:.0} mm", 432.0 + speed * (2.0 / 2.0 - 0.1 / 2.0 - 1.0 / 33.0));
        assert!(row.is_none_or(|row| row.asked.starts_with(&takes)), "{takes}: {row:?}");
        assert!(requirement(BillItem::LoopSensor).contains("432 mm"), "{}", requirement(BillItem::LoopSensor));
    }
}

#[test]
fn texts_of_the_ladder_have_no_wire() {
    for output in [MachineOutput::InverterAlarm, MachineOutput::Message(MachineContact::LoopNotFull)] {
        assert_eq!(item_of_output(output), None);
    }
}

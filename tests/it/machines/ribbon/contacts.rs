//! Contacts of the ribbon line that hold the program: loop at its limits, reel at its end, inverter not ready. Ladder and documents.

use macroline::controls::interface::SignalRole;
use macroline::machines::ladder::scan::Image;
use macroline::machines::ladder::{Bit, MachineContact, MachineOutput};
use macroline::project::Project;
use macroline::text::catalog::words;
use macroline::view::Sheet;

use super::controls;
use super::each_control::project;

/// Contacts of the line that are closed while nothing is wrong.
const HOLDING: [MachineContact; 4] = [
    MachineContact::InverterEnabled,
    MachineContact::LoopNotFull,
    MachineContact::WebNotTight,
    MachineContact::ReelNotEmpty,
];

fn sheet(project: &Project, id: &str) -> Sheet {
    project.prepared().sheets().into_iter().find(|sheet| sheet.id == id).expect("the sheet")
}

#[test]
fn open_contact_takes_the_feed_hold_of_every_control_away() {
    for control in controls() {
        let ladder = project(control.id, &[]).prepared().ladder().expect("a ladder");
        let mut image = Image::default();
        let closed = [
            MachineContact::HoldKey,
            MachineContact::Emergency,
            MachineContact::InverterReady,
            MachineContact::AtSpeed,
        ];
        for contact in closed.into_iter().chain(HOLDING) {
            image.set(Bit::Input(contact), true);
        }
        let settle = |image: &mut Image| (0..12).for_each(|_| ladder.scan(0.0, image));
        let held = |image: &Image| {
            if ladder.drives(Bit::Signal(SignalRole::HoldReleased)) {
                !image.is_on(Bit::Signal(SignalRole::HoldReleased))
            } else {
                image.is_on(Bit::Signal(SignalRole::HoldRequest))
            }
        };
        for contact in HOLDING {
            let message = Bit::Output(MachineOutput::Message(contact));
            settle(&mut image);
            assert!(!held(&image), "{}: {contact:?} is closed", control.id);
            image.set(Bit::Input(contact), false);
            settle(&mut image);
            assert!(held(&image) && image.is_on(message), "{}: {contact:?} is open", control.id);
            // The text stays until the program runs again.
            image.set(Bit::Input(contact), true);
            settle(&mut image);
            assert!(!held(&image) && image.is_on(message), "{}: {contact:?} is closed again", control.id);
            image.set(Bit::Signal(SignalRole::Running), true);
            settle(&mut image);
            assert!(!image.is_on(message), "{}: the program runs", control.id);
            image.set(Bit::Signal(SignalRole::Running), false);
            image.set(Bit::Signal(SignalRole::Idle), true);
            settle(&mut image);
            image.set(Bit::Signal(SignalRole::Idle), false);
        }
    }
}

#[test]
fn inverter_not_ready_is_an_alarm_only_in_a_begun_program() {
    let ladder = project("mitsubishi-e60", &[]).prepared().ladder().expect("a ladder");
    let alarm = Bit::Output(MachineOutput::InverterAlarm);
    for running in [false, true] {
        let mut image = Image::default();
        for contact in [MachineContact::Emergency, MachineContact::InverterReady] {
            image.set(Bit::Input(contact), true);
        }
        image.set(Bit::Signal(SignalRole::Running), running);
        (0..12).for_each(|_| ladder.scan(0.0, &mut image));
        assert_eq!(image.is_on(alarm), running);
    }
}

#[test]
fn documents_name_the_contacts_and_their_stops() {
    for control in controls() {
        let project = project(control.id, &[]);
        let has = |sheet: &Sheet, column: usize, id: &'static str| {
            let name = words(id);
            assert!(
                sheet.rows.iter().any(|row| row.cells[column] == name),
                "{}: {} lacks {name}",
                control.id,
                sheet.id
            );
        };
        let (interface, stops) = (sheet(&project, "interface"), sheet(&project, "stops"));
        for (contact, stop) in [
            ("plc.input.inverter-enabled", "ribbon.stops.not-ready"),
            ("plc.input.loop-not-full", "ribbon.stops.loop-full"),
            ("plc.input.web-not-tight", "ribbon.stops.web-tight"),
            ("plc.input.reel-not-empty", "ribbon.stops.reel-empty"),
        ] {
            has(&interface, 5, contact);
            has(&stops, 0, stop);
        }
        // Every contact of the ladder has its terminal.
        let ladder = project.prepared().ladder().expect("a ladder");
        assert!(HOLDING.into_iter().all(|contact| !ladder.bit(Bit::Input(contact)).is_empty()), "{}", control.id);
    }
}

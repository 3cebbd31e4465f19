//! Ladders on a wired machine: codes of the override, gears at standstill, broken wires, and contacts beside a program.

use macroline::controls::interface::SignalRole;
use macroline::machines::ladder::scan::Image;
use macroline::machines::ladder::{Bit, ContactKind, Ladder, MachineContact, MachineOutput, PlcNumber};
use macroline::motion::Action;
use macroline::project::Project;

use super::{RUNS, at_rest, forms_and_examples, is_held, ladder, put_out, reset, settle, sheet};
use crate::machines::every_machine::restart::within;

/// Codes of 50 to 120 % in steps of 10, by the setting of the switch. Source: docs/reference/gsk-980tdc.md, section 6.
const CODES: [(&str, [f64; 8]); 2] =
    [("980mdi", [7.0, 6.0, 2.0, 3.0, 1.0, 0.0, 4.0, 5.0]), ("988ta", [5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0])];

/// Projects of a machine on the control with codes of the override, by the setting of the switch.
fn coded(machine: &str) -> impl Iterator<Item = (Project, [f64; 8])> {
    CODES.into_iter().map(move |(setting, codes)| {
        let mut project = Project::of(machine, Some("gsk-980tdc")).unwrap();
        let row = project.control.switches.iter().find(|row| row.id() == "override-code").expect("a switch");
        project.switches.set(row, setting);
        (project, codes)
    })
}

#[test]
fn override_has_the_code_of_its_nearest_position() {
    for machine in ["turning-spindle", "ribbon-line"] {
        for (project, codes) in coded(machine) {
            let (ladder, mut image) = (ladder(&project), Image::default());
            let input =
                ladder.words.iter().find(|row| matches!(row.0, PlcNumber::Signal(SignalRole::MacroInputLow(_))));
            assert_eq!(input.is_some(), machine == "ribbon-line");
            for knob in 0..=255 {
                image.put(PlcNumber::Knob, f64::from(knob));
                settle(&ladder, &mut image, 0.0);
                let position = (knob + 5) / 10;
                let position = position.clamp(5, 12);
                let code = image.number(PlcNumber::Signal(SignalRole::SpindleOverrideCode));
                assert_eq!(code, codes[position as usize - 5], "{machine}: {knob} %");
                if let Some((input, _)) = input {
                    assert_eq!(image.number(*input), f64::from(10 * position), "{machine}: {knob} %");
                }
            }
        }
    }
}

#[test]
fn control_turns_at_the_percentage_of_the_code() {
    for (knob, percent) in [(100.0, 100.0), (20.0, 50.0), (74.0, 70.0), (137.0, 120.0)] {
        for (project, _) in coded("ribbon-line") {
            let run = within(30.0, &project, &[(0.0, Action::SpindleOverride(knob))]);
            let speed = run.planner.timeline().at(20.0).spindle.command.abs();
            assert_eq!(speed, 1200.0 * percent / 100.0, "knob at {knob} %");
        }
    }
}

/// Requests gear stage 2 as this control does.
fn ask_for_stage_2(ladder: &Ladder, image: &mut Image) {
    let change = Bit::Signal(SignalRole::GearChange);
    if ladder.bits.iter().any(|row| row.0 == change) {
        image.set(change, true);
        (0..3).for_each(|bit| image.set(Bit::Signal(SignalRole::GearAsked(bit)), bit == 1));
    } else {
        put_out(ladder, image, 42, true);
    }
}

/// Takes the request for stage 2 back, as every control does at a reset.
fn forget_stage_2(ladder: &Ladder, image: &mut Image) {
    image.set(Bit::Signal(SignalRole::GearChange), false);
    put_out(ladder, image, 42, false);
}

#[test]
fn gears_mesh_from_standstill_with_a_run_command() {
    let (shift, emergency) = (Bit::Signal(SignalRole::ShiftSpeed), Bit::Input(MachineContact::Emergency));
    let in_gear = |stage| Bit::Input(MachineContact::InGear(stage));
    let mut found = 0;
    for (name, project) in forms_and_examples() {
        let ladder = ladder(&project);
        if !ladder.drives(shift) {
            continue;
        }
        found += 1;
        let all = [RUNS[0], RUNS[1], Bit::Output(MachineOutput::Run)];
        let runs = |image: &Image| all.map(|run| image.is_on(run));
        let alone = if ladder.drives(RUNS[0]) { [true, false, false] } else { [false, false, true] };
        let mut image = at_rest(&ladder);
        image.set(Bit::Input(MachineContact::SpindleClamped), false);
        image.set(in_gear(2), false);
        image.set(Bit::Signal(SignalRole::Running), true);
        settle(&ladder, &mut image, 0.0);
        ask_for_stage_2(&ladder, &mut image);
        for t in [0.1, 0.6] {
            settle(&ladder, &mut image, t);
        }
        image.set(in_gear(1), false);
        settle(&ladder, &mut image, 0.7);
        assert!(image.is_on(shift) && image.is_on(Bit::Output(MachineOutput::Gear(2))), "{name}");
        assert_eq!(runs(&image), alone, "{name}: the gears mesh");
        // Nothing turns by itself behind an interruption: only a new request in a begun program does.
        let ready = Bit::Input(MachineContact::InverterReady);
        for contact in [Some(emergency), Some(ready), None] {
            let mut stopped = image.clone();
            for closed in [false, true].into_iter().filter(|_| contact.is_some()) {
                stopped.set(contact.unwrap(), closed);
                settle(&ladder, &mut stopped, 0.8);
                assert_eq!(runs(&stopped), [false; 3], "{name}: {contact:?}");
            }
            stopped.set(Bit::Signal(SignalRole::Running), false);
            forget_stage_2(&ladder, &mut stopped);
            for pressed in [true, false] {
                stopped.set(Bit::Signal(SignalRole::Reset), pressed);
                stopped.set(Bit::Input(MachineContact::ResetKey), pressed);
                settle(&ladder, &mut stopped, 0.9);
                assert_eq!(runs(&stopped), [false; 3], "{name}: reset after {contact:?}");
            }
            settle(&ladder, &mut stopped, 30.0);
            assert_eq!(runs(&stopped), [false; 3], "{name}: long after {contact:?}");
            stopped.set(Bit::Signal(SignalRole::Running), true);
            ask_for_stage_2(&ladder, &mut stopped);
            for t in [31.0, 32.0] {
                settle(&ladder, &mut stopped, t);
            }
            assert_eq!(runs(&stopped), alone, "{name}: again after {contact:?}");
        }
        image.set(in_gear(2), true);
        for t in [0.9, 9.0] {
            settle(&ladder, &mut image, t);
        }
        assert_eq!(runs(&image), [false; 3], "{name}: in gear, without M3");
    }
    assert!(found > 10);
}

#[test]
fn shift_never_turns_against_m4() {
    let shift = Bit::Signal(SignalRole::ShiftSpeed);
    let mut with_gears = 0;
    for (name, project) in forms_and_examples() {
        let ladder = ladder(&project);
        if !ladder.drives(shift) || !ladder.drives(RUNS[0]) {
            continue;
        }
        with_gears += 1;
        let mut image = at_rest(&ladder);
        image.set(Bit::Input(MachineContact::SpindleClamped), false);
        image.set(Bit::Signal(SignalRole::Running), true);
        for on in [true, false] {
            put_out(&ladder, &mut image, 4, on);
            settle(&ladder, &mut image, 0.0);
        }
        // Above the shift speed and slowing down: no other run command, and none while it coasts.
        image.set(Bit::Input(MachineContact::AtShiftSpeed), false);
        ask_for_stage_2(&ladder, &mut image);
        for t in [0.1, 4.0] {
            settle(&ladder, &mut image, t);
            assert_eq!(RUNS.map(|run| image.is_on(run)), [false, true], "{name}");
        }
        image.set(Bit::Input(MachineContact::AtShiftSpeed), true);
        settle(&ladder, &mut image, 4.1);
        assert_eq!(RUNS.map(|run| image.is_on(run)), [false, true], "{name}: slow");
    }
    assert!(with_gears > 3, "{with_gears} ladders");
}

#[test]
fn broken_wire_of_stop_or_hold_key_stops() {
    let mut with_keys = 0;
    for (name, project) in forms_and_examples() {
        let ladder = ladder(&project);
        let mut image = at_rest(&ladder);
        image.set(Bit::Input(MachineContact::SpindleClamped), false);
        settle(&ladder, &mut image, 0.0);
        assert!(!is_held(&ladder, &image), "{name}");
        image.set(Bit::Input(MachineContact::HoldKey), false);
        settle(&ladder, &mut image, 0.0);
        assert!(is_held(&ladder, &image), "{name}: hold");
        image.set(Bit::Input(MachineContact::HoldKey), true);
        let key = Bit::Input(MachineContact::ForwardKey);
        if !ladder.drives(RUNS[0]) || !ladder.bits.iter().any(|row| row.0 == key) {
            continue;
        }
        with_keys += 1;
        for pressed in [true, false] {
            image.set(key, pressed);
            settle(&ladder, &mut image, 0.0);
        }
        assert!(image.is_on(RUNS[0]), "{name}");
        image.set(Bit::Input(MachineContact::StopKey), false);
        settle(&ladder, &mut image, 0.0);
        assert!(!image.is_on(RUNS[0]), "{name}: stop");
    }
    assert!(with_keys > 10, "{with_keys} ladders");
}

#[test]
fn each_contact_has_its_kind_in_the_ladder() {
    use MachineContact::{ForwardKey, HoldKey, ResetKey, StopKey};
    for (name, project) in forms_and_examples() {
        for (bit, device) in ladder(&project).bits.iter() {
            let kind = match bit {
                Bit::Input(ForwardKey | ResetKey) => Some(ContactKind::Make),
                Bit::Input(StopKey | HoldKey) => Some(ContactKind::Break),
                Bit::Input(other) => Some(other.kind()),
                _ => None,
            };
            assert_eq!(device.contact, kind, "{name}: {bit:?}");
        }
    }
}

#[test]
fn contacts_of_the_ribbon_stop_the_key_that_leads_to_them() {
    use MachineContact::{ForwardKey, LoopNotFull, ReelNotEmpty, ReverseKey, WebNotTight};
    // The key that leads to each contact: forward unwinds, reverse winds.
    let keys = [(LoopNotFull, 0), (ReelNotEmpty, 0), (WebNotTight, 1)];
    let mut fitted = 0;
    for (name, project) in forms_and_examples().filter(|(_, project)| project.machine.id() == "ribbon-line") {
        let ladder = ladder(&project);
        for (contact, to) in keys.map(|(contact, to)| (Bit::Input(contact), to)) {
            if !ladder.bits.iter().any(|row| row.0 == contact) {
                continue;
            }
            fitted += 1;
            let mut image = at_rest(&ladder);
            let press = |image: &mut Image, key: usize| {
                for on in [true, false] {
                    image.set(Bit::Input([ForwardKey, ReverseKey][key]), on);
                    settle(&ladder, image, 0.0);
                }
                image.is_on(RUNS[key])
            };
            assert!(press(&mut image, to), "{name}");
            image.set(contact, false);
            settle(&ladder, &mut image, 0.0);
            assert!(!image.is_on(RUNS[to]), "{name}: {contact:?} opens");
            assert!(!press(&mut image, to), "{name}: {contact:?} is open");
            assert!(press(&mut image, 1 - to), "{name}: the other direction leads out of {contact:?}");
            image.set(contact, true);
            settle(&ladder, &mut image, 0.0);
            assert!(!image.is_on(RUNS[to]), "{name}: nothing restarts by itself");
        }
    }
    assert!(fitted > 3, "{fitted} contacts");
}

#[test]
fn gsk_starts_each_program_at_its_first_block() {
    for machine in ["turning-spindle", "ribbon-line"] {
        let project = Project::of(machine, Some("gsk-980tdc")).unwrap();
        let rows = sheet(&project, "parameters").rows;
        for number in ["No.005#4", "K10 RESB"] {
            let row = rows.iter().find(|row| row.cells[0] == number).unwrap_or_else(|| panic!("no {number}"));
            assert!(row.cells.iter().any(|cell| cell == "1"), "{machine}: {:?}", row.cells);
        }
    }
}

#[test]
fn feed_override_of_the_ribbon_on_siemens_is_fixed() {
    let valid = Bit::Signal(SignalRole::FeedOverrideValid);
    for control in ["sinumerik-802d", "sinumerik-808d"] {
        let project = Project::of("ribbon-line", Some(control)).unwrap();
        let (ladder, mut image) = (ladder(&project), Image::default());
        settle(&ladder, &mut image, 0.0);
        assert_eq!((ladder.bit(valid), image.is_on(valid)), ("V32000006.7", false), "{control}");
        let speed = |knob: f64| {
            let run = within(30.0, &project, &[(0.0, Action::FeedOverride(knob))]);
            run.planner.timeline().at(20.0).axes.iter().map(|axis| axis.feed.abs()).fold(0.0, f64::max)
        };
        assert!(speed(100.0) > 1.0 && speed(50.0) == speed(100.0), "{control}");
        assert_eq!(speed(0.0), 0.0, "{control}: the lowest position acts all the same");
    }
}

#[test]
fn valves_of_gears_and_clamp_are_ordered_for_a_power_failure() {
    use macroline::machines::driven::devices::BillItem;
    use macroline::project::size::{SizingRuns, size_without_envelope};
    let project = Project::named("turning-spindle", Some("sinumerik-802d"), Some("keyway")).unwrap();
    let bill = size_without_envelope(&project, &SizingRuns::new(&project, &project.written())).bill;
    for (item, words) in
        [(BillItem::GearValve, "without power"), (BillItem::ClampValve, "without power it keeps its position")]
    {
        let row = bill.iter().find(|row| row.item == item).unwrap_or_else(|| panic!("no {item:?}"));
        assert!(row.asked.contains(words), "{row:?}");
    }
    let ladder = ladder(&project);
    let [first, second] = [1, 2].map(|stage| Bit::Output(MachineOutput::Gear(stage)));
    let mut image = at_rest(&ladder);
    // An inverter that has just come on reports a slow spindle even if the work turns.
    for slow in [false, true] {
        image.set(Bit::Input(MachineContact::AtShiftSpeed), slow);
        settle(&ladder, &mut image, 0.0);
        assert!(!image.is_on(first) && !image.is_on(second), "no coil shifts without a change");
    }
    // The gears of stage 1 are out: the next change to it switches its coil.
    image.set(Bit::Input(MachineContact::InGear(1)), false);
    image.set(Bit::Signal(SignalRole::Running), true);
    let change = Bit::Signal(SignalRole::GearChange);
    image.set(change, true);
    (0..3).for_each(|bit| image.set(Bit::Signal(SignalRole::GearAsked(bit)), bit == 0));
    for t in [0.1, 5.0] {
        settle(&ladder, &mut image, t);
    }
    assert!(image.is_on(first) && !image.is_on(second), "one coil for each stage");
}

#[test]
fn gear_change_that_never_ends_is_an_alarm() {
    let (shift, alarm) = (Bit::Signal(SignalRole::ShiftSpeed), Bit::Output(MachineOutput::GearAlarm));
    let (slow, gear) = (Bit::Input(MachineContact::AtShiftSpeed), Bit::Input(MachineContact::InGear(2)));
    let mut found = 0;
    for (name, project) in forms_and_examples().filter(|(_, project)| ladder(project).drives(shift)) {
        found += 1;
        let ladder = ladder(&project);
        // The contact of a slow spindle is broken, or that of the new stage.
        for missing in [slow, gear] {
            let mut image = at_rest(&ladder);
            image.set(Bit::Input(MachineContact::SpindleClamped), false);
            image.set(Bit::Signal(SignalRole::Running), true);
            image.set(slow, missing != slow);
            image.set(gear, false);
            settle(&ladder, &mut image, 0.0);
            ask_for_stage_2(&ladder, &mut image);
            for t in [0.1, 1.0, 1.4] {
                settle(&ladder, &mut image, t);
                assert!(image.is_on(shift) && !image.is_on(alarm), "{name}: {missing:?} at {t} s");
            }
            for t in [60.0, 120.0] {
                settle(&ladder, &mut image, t);
            }
            let runs = [RUNS[0], RUNS[1], Bit::Output(MachineOutput::Run)].map(|run| image.is_on(run));
            assert!(image.is_on(alarm) && !image.is_on(shift), "{name}: {missing:?} long after");
            assert_eq!(runs, [false; 3], "{name}: {missing:?}");
            image.set(Bit::Signal(SignalRole::Running), false);
            forget_stage_2(&ladder, &mut image);
            reset(&ladder, &mut image);
            settle(&ladder, &mut image, 121.0);
            assert!(!image.is_on(alarm), "{name}: {missing:?} after reset");
        }
    }
    assert!(found > 10);
}

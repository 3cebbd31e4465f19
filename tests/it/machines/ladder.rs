//! Ladders: the exported text equals the simulated ladder, each signal has one coil, and every signal of the interface has its rung.

mod listing;
mod wired;

use std::collections::{BTreeMap, BTreeSet};

use macroline::controls::interface::{PlcLanguage, SignalRole};
use macroline::machines;
use macroline::machines::ladder::scan::Image;
use macroline::machines::ladder::{
    Bit, ContactKind, Ladder, MachineContact, MachineOutput, PlcNumber, PlcSide, RungAction,
};
use macroline::project::Project;
use macroline::text::catalog::words;
use macroline::view::Sheet;
use proptest::prelude::*;

use listing::Listing;

/// Values of a form, by field id.
type Entries = &'static [(&'static str, &'static str)];

/// Forms that change the ladder, by machine.
const FORMS: &[(&str, &[Entries])] = &[
    (
        "ribbon-line",
        &[
            &[],
            &[("wait", "fin"), ("knob-step", "5")],
            &[("override-form", "final-speed"), ("knob-step", "10"), ("knob-use", "free")],
            &[("feed-form", "per-revolution"), ("spindle-encoder", "true"), ("dwell", "0.123")],
        ],
    ),
    (
        "turning-spindle",
        &[
            &[],
            &[("stage-2", "0")],
            &[("stage-3", "4000"), ("gear-time", "0"), ("gear-patience", "1.5")],
            &[("stage-3", "4000"), ("stage-4", "5000"), ("gear-time", "3.3")],
            &[
                ("path", "turning"),
                ("keyway", "true"),
                ("lock-code", "81"),
                ("release-code", "82"),
                ("driven-tool", "true"),
                ("driven-code", "93"),
                ("driven-stop", "95"),
                ("keyway-depth", "5.5"),
                ("keyway-length", "50"),
            ],
        ],
    ),
    ("polygon-lathe", &[&[], &[("work-time-constant", "33")]]),
];

/// The forms and the examples of every machine on each of its controls, with a name for messages.
fn forms_and_examples() -> impl Iterator<Item = (String, Project)> {
    let examples = machines::ALL.iter().flat_map(|machine| {
        machine.controls().iter().flat_map(move |control| {
            machine.examples().iter().map(move |example| {
                let project = Project::named(machine.id(), Some(control), Some(example.id)).unwrap();
                (format!("{} on {control} {}", machine.id(), example.id), project)
            })
        })
    });
    let forms = FORMS.iter().flat_map(|(id, forms)| {
        let machine = machines::find(id).unwrap();
        machine.controls().iter().flat_map(move |control| {
            forms.iter().map(move |form| {
                let mut project = Project::of_form(machine, macroline::controls::find(control).unwrap());
                let fields = machine.fields();
                let field = |id: &str| fields.iter().find(|field| field.id == id).unwrap();
                let typed = form.iter().map(|(id, typed)| ((*id).to_owned(), field(id).read_metric(typed).unwrap()));
                project.values.extend(typed);
                (format!("{id} on {control} {form:?}"), project)
            })
        })
    });
    forms.chain(examples)
}

fn sheet(project: &Project, id: &str) -> Sheet {
    project.prepared().sheets().into_iter().find(|sheet| sheet.id == id).unwrap_or_else(|| panic!("no sheet {id}"))
}

pub(super) fn ladder(project: &Project) -> Ladder {
    project.prepared().ladder().expect("a ladder")
}

/// The exported instruction list.
fn listing(project: &Project) -> Listing {
    let mut rows = sheet(project, "ladder").rows;
    // A remark without step and instruction ends the sheet.
    let remark = rows.pop().expect("a remark").cells;
    assert_eq!((remark[0].as_str(), remark[1].as_str(), remark[2].as_str()), ("", "", words("sheet.no-safety")));
    Listing::new(ladder(project).language, rows.into_iter().map(|row| row.cells[1].clone()))
}

/// Signals or numbers with the names of their devices.
type Devices<T> = Vec<(T, String)>;

/// Signals and numbers that come from outside.
fn sources(ladder: &Ladder) -> (Devices<Bit>, Devices<PlcNumber>) {
    let outside = |sides: (PlcSide, PlcSide)| sides.0 != PlcSide::Plc;
    let bits = ladder.bits.iter().filter(|row| outside(row.1.sides)).map(|row| (row.0, row.1.name.clone()));
    let words = ladder.words.iter().filter(|row| outside(row.1.sides)).map(|row| (row.0, row.1.name.clone()));
    (bits.collect(), words.collect())
}

#[test]
fn every_signal_has_one_coil() {
    for (name, project) in forms_and_examples() {
        let mut written: BTreeMap<String, Vec<String>> = BTreeMap::new();
        let list = listing(&project);
        for (target, condition) in list.targets() {
            written.entry(target).or_default().push(condition);
        }
        for (target, conditions) in written {
            // A number may have two sources, where one contact chooses between them.
            let chosen = matches!(conditions.as_slice(), [a, b] if list.inverse(a, b));
            assert!(conditions.len() == 1 || chosen, "{name}: {target} under {conditions:?}");
        }
        let ladder = ladder(&project);
        let mut devices = BTreeSet::new();
        let names = ladder.bits.iter().map(|row| &row.1.name).chain(ladder.words.iter().map(|row| &row.1.name));
        for device in names {
            assert!(!device.is_empty() && devices.insert(device), "{name}: device {device:?} twice or empty");
        }
    }
}

#[test]
fn every_signal_of_the_interface_has_its_rung() {
    for (name, project) in forms_and_examples() {
        let (list, interface) = (listing(&project), sheet(&project, "interface"));
        let (targets, used): (BTreeSet<_>, _) = (list.targets().map(|(target, _)| target).collect(), list.operands());
        let mut known = BTreeSet::new();
        for row in &interface.rows {
            let (device, writer, reader) = (&row.cells[0], &row.cells[2], &row.cells[3]);
            assert!(row.cells[5].chars().count() > 3 && !row.cells[5].contains('.'), "{name}: {:?}", row.cells);
            assert_eq!(targets.contains(device), writer == "PLC", "{name}: {device} is written by {writer}");
            assert!(reader != "PLC" || used.contains(device), "{name}: nothing reads {device}");
            known.insert(device.clone());
        }
        // Devices of the list that are not in the interface are internal to the PLC: some rung has to write them.
        for device in used.iter().chain(&targets).filter(|device| !known.contains(*device)) {
            assert!(targets.contains(device), "{name}: nobody writes {device}");
        }
        // Each register of overrides that the control has is in use.
        for row in project.control.interface.iter().filter(|row| {
            matches!(row.role, SignalRole::SpindleOverride | SignalRole::SpindleOverrideCode | SignalRole::Finished)
        }) {
            let turns = project.machine.id() == "polygon-lathe" && row.role != SignalRole::Finished;
            assert!(turns || known.contains(row.device), "{name}: {} has no rung", row.device);
        }
    }
}

#[test]
fn every_instruction_is_one_of_the_plc() {
    for (name, project) in forms_and_examples() {
        let unknown = listing(&project).unknown();
        assert!(unknown.is_empty(), "{name}: {unknown:?}");
    }
}

/// Scans a ladder until it settles.
pub(super) fn settle(ladder: &Ladder, image: &mut Image, t: f64) {
    (0..12).for_each(|_| ladder.scan(t, image));
}

/// Switches a code of M on, as this control shows it.
pub(super) fn put_out(ladder: &Ladder, image: &mut Image, code: u32, on: bool) {
    let own = Bit::Signal(SignalRole::MFunction(code));
    if ladder.bits.iter().any(|row| row.0 == own) {
        image.set(own, on);
    } else {
        image.set(Bit::Signal(SignalRole::MStrobe), on);
        image.put(PlcNumber::Signal(SignalRole::MCode), if on { f64::from(code) } else { 0.0 });
    }
}

/// Presses reset for a moment.
pub(super) fn reset(ladder: &Ladder, image: &mut Image) {
    for on in [true, false] {
        image.set(Bit::Signal(SignalRole::Reset), on);
        image.set(Bit::Input(MachineContact::ResetKey), on);
        settle(ladder, image, 0.0);
    }
}

/// Whether a key closes its contact, pressed or not.
fn is_closed(key: MachineContact, pressed: bool) -> bool {
    pressed == (key.kind() == ContactKind::Make)
}

/// The ladder with its contacts closed, but for keys that make.
pub(super) fn at_rest(ladder: &Ladder) -> Image {
    let mut image = Image::default();
    let is_key = |contact: MachineContact| {
        use MachineContact::{ForwardKey, ResetKey, ReverseKey};
        [ForwardKey, ReverseKey, ResetKey].contains(&contact)
    };
    for (contact, _) in ladder.bits.iter().filter(|row| matches!(row.0, Bit::Input(input) if !is_key(input))) {
        image.set(*contact, true);
    }
    image
}

#[test]
fn spindle_keys_act_without_a_program_and_stop_wins() {
    use MachineContact::{ForwardKey, ReverseKey, StopKey};
    let mut with_keys = 0;
    for (name, project) in forms_and_examples().filter(|(_, project)| project.machine.id() != "polygon-lathe") {
        let ladder = ladder(&project);
        let [forward, reverse] = RUNS;
        if !ladder.drives(forward) {
            continue;
        }
        with_keys += 1;
        let press = |image: &mut Image, keys: &[MachineContact]| {
            for on in [true, false] {
                keys.iter().for_each(|key| image.set(Bit::Input(*key), is_closed(*key, on)));
                settle(&ladder, image, 0.0);
            }
            (image.is_on(forward), image.is_on(reverse))
        };
        let cases: [(&[MachineContact], (bool, bool)); 6] = [
            (&[ForwardKey, ReverseKey], (false, false)),
            (&[ForwardKey, StopKey], (false, false)),
            (&[ForwardKey], (true, false)),
            (&[ReverseKey, StopKey], (false, false)),
            (&[ReverseKey], (false, true)),
            (&[StopKey], (false, false)),
        ];
        let mut image = at_rest(&ladder);
        image.set(Bit::Input(MachineContact::SpindleClamped), false);
        for (keys, runs) in cases {
            assert_eq!(press(&mut image, keys), runs, "{name}: {keys:?}");
        }
        image.set(Bit::Signal(SignalRole::Running), true);
        assert_eq!(press(&mut image, &[ForwardKey]), (false, false), "{name}: a program runs");
    }
    assert!(with_keys > 10, "{with_keys} ladders");
}

/// Outputs of the run commands.
const RUNS: [Bit; 2] = [Bit::Output(MachineOutput::Forward), Bit::Output(MachineOutput::Reverse)];

/// Presses a key for longer than the ladder needs; returns the run commands while it is pressed, and after it.
fn press(ladder: &Ladder, image: &mut Image, key: MachineContact) -> [[bool; 2]; 2] {
    [true, false].map(|on| {
        image.set(Bit::Input(key), is_closed(key, on));
        settle(ladder, image, 0.0);
        RUNS.map(|run| image.is_on(run))
    })
}

/// Whether the PLC holds the program: cycle start is refused.
fn is_held(ladder: &Ladder, image: &Image) -> bool {
    if ladder.drives(Bit::Signal(SignalRole::HoldRequest)) {
        image.is_on(Bit::Signal(SignalRole::HoldRequest))
    } else {
        !image.is_on(Bit::Signal(SignalRole::HoldReleased))
    }
}

/// Each ladder with run commands, in a program that has commanded M3 or M4, with keys of this direction and of the other.
fn turning() -> impl Iterator<Item = (String, Ladder, Image, [bool; 2], [MachineContact; 2])> {
    use MachineContact::{ForwardKey, ReverseKey};
    // Also where the spindle turns through a reset.
    let with_runs = forms_and_examples().flat_map(|(name, project)| {
        let mut other = project.clone();
        other.switches.0.push(("spindle-at-reset".to_owned(), "turns".to_owned()));
        [(name.clone(), ladder(&project)), (format!("{name}, turns through reset"), ladder(&other))]
    });
    let with_runs = with_runs.filter(|(_, ladder)| ladder.drives(RUNS[0]));
    with_runs.flat_map(|(name, ladder)| {
        [(3, [true, false], [ForwardKey, ReverseKey]), (4, [false, true], [ReverseKey, ForwardKey])].map(
            |(code, runs, keys)| {
                let mut image = at_rest(&ladder);
                image.set(Bit::Input(MachineContact::SpindleClamped), false);
                image.set(Bit::Signal(SignalRole::Running), true);
                for on in [true, false] {
                    put_out(&ladder, &mut image, code, on);
                    settle(&ladder, &mut image, 0.0);
                }
                let name = format!("{name} M{code}");
                assert_eq!(RUNS.map(|run| image.is_on(run)), runs, "{name}");
                (name, ladder.clone(), image, runs, keys)
            },
        )
    })
}

#[test]
fn keys_have_no_effect_while_a_program_runs() {
    for (name, ladder, mut image, runs, [own, other]) in turning() {
        for key in [own, other, MachineContact::StopKey] {
            assert_eq!(press(&ladder, &mut image, key), [runs; 2], "{name}: {key:?}");
            assert!(!is_held(&ladder, &image), "{name}: {key:?}");
        }
    }
}

#[test]
fn no_key_reverses_the_spindle_of_a_begun_program() {
    for (name, ladder, mut image, runs, [own, other]) in turning() {
        image.set(Bit::Signal(SignalRole::Running), false);
        assert_eq!(press(&ladder, &mut image, other), [runs; 2], "{name}: it turns");
        press(&ladder, &mut image, MachineContact::StopKey);
        assert_eq!(press(&ladder, &mut image, other), [[false; 2]; 2], "{name}: it is stopped");
        assert_eq!(press(&ladder, &mut image, own), [runs; 2], "{name}: it goes on");
    }
}

#[test]
fn stop_key_in_a_hold_refuses_cycle_start() {
    let message = Bit::Output(MachineOutput::Message(MachineContact::StopKey));
    for (name, ladder, mut image, runs, [own, _]) in turning() {
        image.set(Bit::Signal(SignalRole::Running), false);
        settle(&ladder, &mut image, 0.0);
        assert!(!is_held(&ladder, &image), "{name}");
        assert_eq!(press(&ladder, &mut image, MachineContact::StopKey), [[false; 2]; 2], "{name}");
        assert!(is_held(&ladder, &image) && image.is_on(message), "{name}");
        let mut started = image.clone();
        assert_eq!(press(&ladder, &mut started, own), [runs; 2], "{name}");
        assert!(!is_held(&ladder, &started) && !started.is_on(message), "{name}");
        // Reset ends the program, and starts nothing.
        image.set(Bit::Signal(SignalRole::Idle), true);
        reset(&ladder, &mut image);
        assert_eq!(RUNS.map(|run| image.is_on(run)), [false; 2], "{name}");
        assert!(!is_held(&ladder, &image) && !image.is_on(message), "{name}");
    }
}

/// Builders move and acknowledge messages: none is an interlock.
#[test]
fn no_rung_reads_the_message_of_another() {
    for (name, project) in forms_and_examples() {
        let ladder = ladder(&project);
        for rung in ladder.rungs.iter() {
            let messages = rung.when.iter().flatten().map(|contact| contact.bit);
            let mut messages = messages.filter(|bit| matches!(bit, Bit::Output(output) if output.is_message()));
            let other = messages.find(|message| rung.coil() != Some(*message));
            assert_eq!(other, None, "{name}: {:?} reads a message", rung.action);
        }
    }
}

#[test]
fn sign_of_the_voltage_needs_one_run_contact() {
    for control in ["sinumerik-802d", "sinumerik-808d"] {
        let project = super::turning::project(control, &[("output", "+-10")]);
        let ladder = ladder(&project);
        let outputs = [MachineOutput::Forward, MachineOutput::Reverse, MachineOutput::Run];
        assert_eq!(outputs.map(|output| ladder.drives(Bit::Output(output))), [false, false, true], "{control}");
        let mut image = at_rest(&ladder);
        image.set(Bit::Signal(SignalRole::Running), true);
        let mut run = |code: u32| {
            for on in [true, false] {
                put_out(&ladder, &mut image, code, on);
                settle(&ladder, &mut image, 0.0);
            }
            image.is_on(Bit::Output(MachineOutput::Run))
        };
        assert_eq!([3, 5, 4, 5].map(&mut run), [true, false, true, false], "{control}");
    }
}

#[test]
fn inverter_runs_while_the_spindle_goes_to_its_angle() {
    for control in ["sinumerik-802d", "sinumerik-808d"] {
        let project = Project::named("turning-spindle", Some(control), Some("keyway")).unwrap();
        let ladder = ladder(&project);
        let run = Bit::Output(MachineOutput::Run);
        let mut image = at_rest(&ladder);
        image.set(Bit::Input(MachineContact::SpindleClamped), false);
        image.set(Bit::Signal(SignalRole::Running), true);
        let mut state = |bit: Bit, on: bool| {
            image.set(bit, on);
            settle(&ladder, &mut image, 0.0);
            image.is_on(run)
        };
        let angle = Bit::Signal(SignalRole::SpindlePositions);
        assert!(state(angle, true), "{control}: SPOS behind M5");
        assert!(!state(Bit::Input(MachineContact::Emergency), false), "{control}");
        assert!(state(Bit::Input(MachineContact::Emergency), true), "{control}");
        assert!(!state(angle, false), "{control}");
        // With two run contacts the direction comes from M3 and M4 alone.
        let project = project.with_entries(&[("output", "0-10")]).unwrap();
        let rows = project.design().readouts;
        let row = rows.iter().find(|row| row.id == "positioning-torque").expect("a row");
        assert_eq!(row.verdict, macroline::view::Verdict::Fail, "{control}");
    }
}

#[test]
fn spindle_is_locked_by_its_clamp_for_the_keyway() {
    let project = Project::named("turning-spindle", Some("sinumerik-802d"), Some("keyway")).unwrap();
    let ladder = ladder(&project);
    let bits = [81, 82].map(|code| ladder.bit(Bit::Signal(SignalRole::MFunction(code))).to_owned());
    assert_eq!(bits, ["V25001010.1", "V25001010.2"]);
    let mut image = at_rest(&ladder);
    let clamped = Bit::Input(MachineContact::SpindleClamped);
    image.set(clamped, false);
    image.set(Bit::Signal(SignalRole::Running), true);
    let pulse = |image: &mut Image, code: u32| {
        for on in [true, false] {
            put_out(&ladder, image, code, on);
            settle(&ladder, image, 0.0);
        }
        let waits = image.is_on(Bit::Signal(SignalRole::ReadInDisable));
        (image.is_on(Bit::Output(MachineOutput::SpindleClamp)), waits)
    };
    assert_eq!(pulse(&mut image, 81), (true, true), "the valve is on, and the next block waits for the contact");
    image.set(clamped, true);
    assert_eq!(pulse(&mut image, 3), (true, false));
    assert!(!image.is_on(Bit::Output(MachineOutput::Run)), "a clamped spindle gets no run command");
    reset(&ladder, &mut image);
    assert!(image.is_on(Bit::Output(MachineOutput::SpindleClamp)), "a reset with the mill in the keyway opens nothing");
    let opens = Bit::Output(MachineOutput::SpindleUnclamp);
    assert_eq!((pulse(&mut image, 82), image.is_on(opens)), ((false, true), true));
    image.set(clamped, false);
    assert_eq!(pulse(&mut image, 3), (false, false));
    assert!(image.is_on(Bit::Output(MachineOutput::Run)) && !image.is_on(opens));
    // After a power failure the valve has kept the clamp closed: nothing turns before the release code, which is read.
    let mut image = at_rest(&ladder);
    image.set(Bit::Signal(SignalRole::Running), true);
    settle(&ladder, &mut image, 0.0);
    assert!(!image.is_on(Bit::Signal(SignalRole::ReadInDisable)) && !image.is_on(opens));
    assert_eq!(pulse(&mut image, 3), (false, false));
    assert!(!image.is_on(Bit::Output(MachineOutput::Run)), "the clamp is closed");
    assert_eq!((pulse(&mut image, 82), image.is_on(opens)), ((false, true), true));
    image.set(clamped, false);
    assert_eq!(pulse(&mut image, 3), (false, false));
    assert!(image.is_on(Bit::Output(MachineOutput::Run)));
}

#[test]
fn m3_m5_fault_hold_and_emergency_reach_the_inverter() {
    let mut with_runs = 0;
    for (name, project) in forms_and_examples().filter(|(_, project)| project.machine.id() != "polygon-lathe") {
        let ladder = ladder(&project);
        if !ladder.drives(RUNS[0]) {
            continue;
        }
        with_runs += 1;
        let mut image = Image::default();
        let keys = [MachineContact::ForwardKey, MachineContact::ReverseKey];
        let keys = [&keys[..], &[MachineContact::ResetKey]].concat();
        for (contact, _) in
            ladder.bits.iter().filter(|row| matches!(row.0, Bit::Input(input) if !keys.contains(&input)))
        {
            image.set(*contact, true);
        }
        image.set(Bit::Input(MachineContact::SpindleClamped), false);
        image.set(Bit::Signal(SignalRole::Running), true);
        let [forward, reverse] = [MachineOutput::Forward, MachineOutput::Reverse].map(Bit::Output);
        let run = |image: &mut Image, code: u32| {
            put_out(&ladder, image, code, true);
            settle(&ladder, image, 0.0);
            put_out(&ladder, image, code, false);
            settle(&ladder, image, 0.0);
            (image.is_on(forward), image.is_on(reverse))
        };
        assert_eq!(run(&mut image, 3), (true, false), "{name}: M3");
        assert_eq!(run(&mut image, 5), (false, false), "{name}: M5");
        assert_eq!(run(&mut image, 4), (false, true), "{name}: M4");
        assert_eq!(run(&mut image, 5), (false, false), "{name}: M5");
        for opens in [MachineContact::InverterReady, MachineContact::Emergency] {
            assert_eq!(run(&mut image, 3), (true, false), "{name}: M3");
            image.set(Bit::Input(opens), false);
            settle(&ladder, &mut image, 0.0);
            assert!(!image.is_on(forward), "{name}: {opens:?}");
            image.set(Bit::Input(opens), true);
            settle(&ladder, &mut image, 0.0);
            assert!(!image.is_on(forward), "{name}: {opens:?} is over, and nothing restarts");
            let alarm = Bit::Output(MachineOutput::InverterAlarm);
            assert_eq!(image.is_on(alarm), opens == MachineContact::InverterReady, "{name}: alarm until reset");
            let held = |image: &Image| {
                if ladder.drives(Bit::Signal(SignalRole::HoldRequest)) {
                    image.is_on(Bit::Signal(SignalRole::HoldRequest))
                } else {
                    !image.is_on(Bit::Signal(SignalRole::HoldReleased))
                }
            };
            assert_eq!(held(&image), image.is_on(alarm), "{name}: no cycle start goes on after a fault");
            reset(&ladder, &mut image);
            assert!(!image.is_on(alarm) && !held(&image), "{name}: {opens:?}");
        }
        // Hold: the unwinder of the ribbon line stops with the axes, the work of a lathe turns on.
        let held = |image: &mut Image, running: bool| {
            image.set(Bit::Signal(SignalRole::Running), running);
            settle(&ladder, image, 0.0);
            let stop = image.is_on(Bit::Signal(SignalRole::SpindleHold));
            let free = image.is_on(Bit::Signal(SignalRole::SpindleEnable));
            if ladder.drives(Bit::Signal(SignalRole::SpindleHold)) { stop } else { !free }
        };
        assert_eq!(run(&mut image, 3), (true, false), "{name}: M3");
        assert!(!held(&mut image, true), "{name}");
        assert_eq!(held(&mut image, false), project.machine.id() == "ribbon-line", "{name}: hold");
        assert!(!held(&mut image, true), "{name}: goes on");
    }
    assert!(with_runs > 10, "{with_runs} ladders");
}

#[test]
fn reset_acknowledges_an_emergency_stop_that_is_over() {
    let mut acknowledged = 0;
    for (name, project) in forms_and_examples() {
        let ladder = ladder(&project);
        let acknowledge = Bit::Signal(SignalRole::EmergencyAcknowledge);
        let needed = project.control.interface.iter().any(|row| row.role == SignalRole::EmergencyAcknowledge);
        assert_eq!((ladder.drives(acknowledge), needed), (needed, project.control.plc == PlcLanguage::Step7), "{name}");
        if !needed {
            continue;
        }
        acknowledged += 1;
        let mut image = at_rest(&ladder);
        for (pressed, key) in [(true, true), (false, false), (false, true)] {
            image.set(Bit::Input(MachineContact::Emergency), !pressed);
            image.set(Bit::Input(MachineContact::ResetKey), key);
            settle(&ladder, &mut image, 0.0);
            assert_eq!(image.is_on(acknowledge), key && !pressed, "{name}: pressed {pressed}, reset {key}");
        }
    }
    assert!(acknowledged > 10, "{acknowledged} ladders");
}

#[test]
fn spindle_override_is_always_valid() {
    for (name, project) in forms_and_examples() {
        let ladder = ladder(&project);
        let mut image = Image::default();
        settle(&ladder, &mut image, 0.0);
        for (role, language) in [
            (SignalRole::SpindleOverrideValid, PlcLanguage::Step7),
            (SignalRole::SpindleOverrideByRegister, PlcLanguage::Melsec),
        ] {
            assert_eq!(image.is_on(Bit::Signal(role)), project.control.plc == language, "{name}: {role:?}");
        }
        let register = Bit::Signal(SignalRole::FeedOverrideByRegister);
        let is_line = project.machine.info().id == "ribbon-line";
        assert_eq!(image.is_on(register), is_line && project.control.plc == PlcLanguage::Melsec, "{name}");
    }
}

/// Tools that a program calls.
fn tools(project: &Project) -> BTreeSet<String> {
    let texts = project.written().files.0.into_iter().map(|file| file.text);
    let words: Vec<String> = texts.flat_map(|text| text.lines().map(str::to_owned).collect::<Vec<_>>()).collect();
    let numbers = words.iter().flat_map(|line| line.split_whitespace()).filter_map(|word| word.strip_prefix('T'));
    numbers.filter(|number| number.chars().all(|digit| digit.is_ascii_digit())).map(str::to_owned).collect()
}

#[test]
fn tool_changes_wait_for_the_turret() {
    let (start, there) = (Bit::Output(MachineOutput::TurretStart), Bit::Input(MachineContact::TurretInPosition));
    let late = Bit::Output(MachineOutput::Message(MachineContact::TurretInPosition));
    let mut turrets = 0;
    for (name, project) in forms_and_examples() {
        let ladder = ladder(&project);
        // A single cutter of the polygon lathe is on a spindle of its own: nothing turns for its T.
        let least = if project.machine.id() == "polygon-lathe" { 2 } else { 1 };
        assert_eq!(ladder.drives(start), tools(&project).len() >= least, "{name}: {:?}", tools(&project));
        if !ladder.drives(start) {
            continue;
        }
        turrets += 1;
        let fin = ladder.drives(Bit::Signal(SignalRole::Finished));
        let tool_signal = Bit::Signal(if fin { SignalRole::TStrobe } else { SignalRole::TFunction });
        let mut image = at_rest(&ladder);
        image.set(Bit::Input(MachineContact::SpindleClamped), false);
        settle(&ladder, &mut image, 0.0);
        let mut seconds = 0.0;
        let mut step = |strobe: bool, contact: bool| {
            image.set(tool_signal, strobe);
            image.set(there, contact);
            seconds += 6.0;
            settle(&ladder, &mut image, seconds);
            let waits = if fin {
                !image.is_on(Bit::Signal(SignalRole::Finished))
            } else {
                image.is_on(Bit::Signal(SignalRole::ReadInDisable))
            };
            (image.is_on(start), waits, image.is_on(late))
        };
        // The answer of the previous tool is still on: it is no answer to this one.
        assert_eq!(step(true, true), (false, true, false), "{name}");
        assert_eq!(step(fin, false), (true, true, false), "{name}: the turret turns");
        assert_eq!(step(fin, false), (true, true, true), "{name}: a message says why the program waits");
        assert_eq!(step(fin, true), (fin, false, false), "{name}: the tool is in position");
        let (started, ..) = step(false, true);
        assert!(!started, "{name}: the start signal falls with the strobe");
    }
    assert!(turrets > 2);
}

/// Requests of the program, run commands and stops of work and tool of the polygon lathe.
const INDEX: Bit = Bit::Macro(1100);
const INDEXES: [Bit; 2] = [Bit::Block("AXIS6.INDEX"), Bit::Block("AXIS7.INDEX")];
const STOPS: [Bit; 2] = [Bit::Device("G360.3"), Bit::Device("G400.3")];

#[test]
fn alarm_and_emergency_stop_end_both_axes_in_ratio() {
    let (button, delayed) = (Bit::Input(MachineContact::Emergency), Bit::Input(MachineContact::EmergencyDelayed));
    let mut lathes = 0;
    for (name, project) in forms_and_examples().filter(|(_, project)| project.machine.id() == "polygon-lathe") {
        lathes += 1;
        let held = ladder(&project);
        let off = ladder(&project.with_entries(&[("emergency", "off")]).unwrap());
        assert_eq!(
            (held.bit(delayed), held.drives(STOPS[0])),
            ("X8.4", true),
            "{name}: the control reads the delayed one"
        );
        assert_eq!((off.bit(button), off.bit(delayed)), ("X8.4", ""), "{name}");
        let alarm = Bit::Signal(SignalRole::Alarm);
        for (at, on) in [(alarm, true), (button, false)] {
            let mut image = at_rest(&held);
            image.set(INDEX, true);
            settle(&held, &mut image, 0.0);
            assert_eq!(INDEXES.map(|bit| image.is_on(bit)), [true; 2], "{name}");
            image.set(at, on);
            settle(&held, &mut image, 0.0);
            assert_eq!(INDEXES.map(|bit| image.is_on(bit)), [false; 2], "{name}: {at:?}");
            assert_eq!(STOPS.map(|bit| image.is_on(bit)), [true; 2], "{name}: {at:?}");
            let released = Bit::Signal(SignalRole::EmergencyReleased);
            assert_eq!((image.is_on(released), is_held(&held, &image)), (true, at == button), "{name}: {at:?}");
            image.set(delayed, false);
            settle(&held, &mut image, 0.0);
            assert!(!image.is_on(released), "{name}: the relay's time is over");
        }
    }
    assert!(lathes > 1, "{lathes} polygon lathes");
}

#[test]
fn every_output_to_the_machine_has_its_wire() {
    let mut count = 0;
    for (name, project) in forms_and_examples() {
        let ladder = ladder(&project);
        let outputs = ladder.bits.iter().filter(|row| matches!(row.0, Bit::Output(output) if !output.is_message()));
        let wired = macroline::machines::driven::devices::wired(Some(&ladder));
        for (bit, device) in outputs {
            assert!(wired.iter().any(|(_, of)| of.name == device.name), "{name}: nothing at {bit:?}");
            count += 1;
        }
    }
    assert!(count > 0);
}

/// Whether the PLC has answered the codes of the block.
fn is_answered(image: &Image) -> bool {
    image.is_on(Bit::Signal(SignalRole::Finished)) && !image.is_on(Bit::Signal(SignalRole::ReadInDisable))
}

#[test]
fn m3_and_keys_wait_for_the_contact_of_the_gear() {
    let mut with_gears = 0;
    for (name, project) in forms_and_examples().filter(|(_, project)| project.machine.id() == "turning-spindle") {
        let ladder = ladder(&project);
        let in_gear = |stage| Bit::Input(MachineContact::InGear(stage));
        if !ladder.bits.iter().any(|row| row.0 == in_gear(2)) || !ladder.drives(RUNS[0]) {
            continue;
        }
        with_gears += 1;
        let fin = ladder.drives(Bit::Signal(SignalRole::Finished));
        let answered =
            |image: &Image| if fin { is_answered(image) } else { !image.is_on(Bit::Signal(SignalRole::ReadInDisable)) };
        let mut image = at_rest(&ladder);
        image.set(Bit::Input(MachineContact::SpindleClamped), false);
        image.set(in_gear(1), false);
        settle(&ladder, &mut image, 0.0);
        let keyed = press(&ladder, &mut image, MachineContact::ForwardKey);
        assert_eq!(keyed, [[false; 2]; 2], "{name}: key between two gears");
        image.set(Bit::Signal(SignalRole::Running), true);
        put_out(&ladder, &mut image, 3, true);
        for t in [0.0, 5.0, 10.0] {
            settle(&ladder, &mut image, t);
            if !fin {
                put_out(&ladder, &mut image, 3, false);
            }
            let runs = image.is_on(RUNS[0]);
            let slow = image.is_on(Bit::Signal(SignalRole::ShiftSpeed));
            assert!(!answered(&image) && (slow || !runs), "{name}: runs {runs}, shift voltage {slow} at {t}");
        }
        reset(&ladder, &mut image);
        image.set(in_gear(1), true);
        for t in [20.0, 30.0, 40.0] {
            settle(&ladder, &mut image, t);
        }
        put_out(&ladder, &mut image, 3, true);
        settle(&ladder, &mut image, 40.0);
        assert!(answered(&image) && image.is_on(RUNS[0]), "{name}: the gear is in position");
        // The gear leaves its position in the cut.
        put_out(&ladder, &mut image, 3, false);
        image.set(in_gear(1), false);
        settle(&ladder, &mut image, 41.0);
        image.set(in_gear(1), true);
        settle(&ladder, &mut image, 42.0);
        let alarm = image.is_on(Bit::Output(MachineOutput::GearAlarm));
        assert!(!image.is_on(RUNS[0]) && alarm && is_held(&ladder, &image), "{name}: nothing restarts by itself");
    }
    assert!(with_gears > 3, "{with_gears} ladders");
}

#[test]
fn controls_without_fin_hold_the_next_block() {
    for (name, project) in forms_and_examples() {
        let ladder = ladder(&project);
        let fin = ladder.drives(Bit::Signal(SignalRole::Finished));
        assert_eq!(fin, project.control.plc != PlcLanguage::Step7, "{name}");
        let waits = ladder.bits.iter().any(|row| [Bit::Relay("busy"), Bit::Relay("tool-waits")].contains(&row.0));
        assert_eq!(ladder.drives(Bit::Signal(SignalRole::ReadInDisable)), !fin && waits, "{name}");
        // One coil answers all codes.
        let coils =
            ladder.rungs.iter().filter(|rung| rung.action == RungAction::Coil(Bit::Signal(SignalRole::Finished)));
        assert_eq!(coils.count(), usize::from(fin), "{name}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// The simulated ladder equals the exported one: random inputs, scan by scan.
    #[test]
    fn exported_list_acts_like_the_simulated_ladder(
        steps in prop::collection::vec((any::<u64>(), prop::sample::select(&[0u32, 4, 8, 10, 50, 120, 900][..])), 40..80),
    ) {
        for (name, project) in forms_and_examples() {
            let (ladder, mut list) = (ladder(&project), listing(&project));
            let (bits, words) = sources(&ladder);
            let (mut image, mut ms) = (Image::default(), 0u32);
            for (random, pause) in &steps {
                ms += pause;
                let t = f64::from(ms) / 1000.0;
                // Most inputs stay unchanged from scan to scan, so that latches and timers have time to act.
                for (at, (bit, device)) in (0u32..).zip(&bits) {
                    if random.rotate_left(3 * at) % 4 == 0 {
                        let on = random.rotate_left(5 * at + 1) % 2 == 0;
                        image.set(*bit, on);
                        list.set(device, on);
                    }
                }
                for (at, (word, device)) in (0u32..).zip(&words) {
                    let drawn = random.rotate_left(7 * at);
                    let value = match word {
                        PlcNumber::Signal(SignalRole::MCode) => [0, 3, 4, 5, 8, 30, 41, 42, 43, 44, 81, 82, 93, 95][(drawn % 14) as usize],
                        _ => drawn % 250,
                    };
                    image.put(*word, value as f64);
                    list.put(device, value as f64);
                }
                ladder.scan(t, &mut image);
                list.scan(t);
                for (bit, device) in ladder.bits.iter() {
                    prop_assert_eq!(list.is_on(&device.name), image.is_on(*bit), "{} {:?} {} at {}", name, bit, device.name, t);
                }
                for (word, device) in ladder.words.iter() {
                    prop_assert_eq!(list.number(&device.name), image.number(*word), "{} {:?} {}", name, word, device.name);
                }
            }
        }
    }
}

//! Laws on generated programs: macros run like the equal plain blocks; parse, emit and run are total.

pub(crate) mod deck_eq;
mod dice;
mod flat;
mod laws;
mod named;
mod parts;
mod program;

use std::collections::BTreeMap;
use std::path::Path;
use std::rc::Rc;

use macroline::controls::{self, Code, Control, Dialect, Switches};
use macroline::interp::world::MachineAtRest;
use macroline::interp::{End, Interp, StartProgram};
use macroline::motion::{
    Action, AxisPlant, BenchPlc, Budget, Event, Panel, Planner, Plant, Retention, RunEnd, RunningProgram, Setup,
    SpindlePlant,
};
use macroline::nc::{self, Files};
use proptest::prelude::*;

use flat::Recorder;

/// Surface speeds count m/min in inches too: as ft/min the plain block would need decimals, which S does not take.
fn interp(control: &'static Control, text: &str) -> Interp {
    let switches = Switches([("surface-speed-in-inch".to_owned(), "metres-per-minute".to_owned())].into());
    Interp::new(Rc::new(nc::parse_with(&Files::one("O1.nc", text), control, &switches)), StartProgram::First)
}

/// The bench of the control.
fn plant(control: &Control) -> Plant {
    let bench = &control.bench;
    let axes = bench.axes.iter().map(|axis| AxisPlant {
        letter: Some(axis.letter),
        rotary: false,
        endless: false,
        diameter: control.axis(axis.letter).is_some_and(|k| control.axes[k].diameter),
        rapid: axis.rapid,
        clamp: axis.clamp,
        time_constant: axis.time_constant,
        position_gain: axis.position_gain,
        home: 0.0,
    });
    Plant {
        axes: axes.collect(),
        pmc: Vec::new(),
        spindle: SpindlePlant::bench(control, Dialect::resolve(control, &Switches::default()).spindle()),
        block_time: control.timing.block,
        macro_time: control.timing.macro_block,
        preread: control.timing.preread,
        in_position: bench.in_position,
        stock: 0.0,
    }
}

/// Plans a run to its end or for ten minutes, with an operator who continues after stops and turns the knob.
fn planned<P: RunningProgram>(control: &Control, program: P) -> Planner<P> {
    let knob = Event { t: 2.3, action: Action::FeedOverride(80.0) };
    let mut planner = Planner::new(Setup {
        program,
        control,
        plant: &plant(control),
        plc: Box::new(BenchPlc::new(&control.bench, &plant(control).spindle.rules)),
        panel: Panel::new([knob]),
        limits: Budget { blocks: 5000, seconds: 600.0 },
        keep: Retention::Timeline,
        findings: Vec::new(),
    });
    for _ in 0..40 {
        if planner.advance(f64::INFINITY, 100_000).ended != Some(RunEnd::Stop) {
            break;
        }
        planner.event(Event { t: planner.timeline().end() + 0.1, action: Action::Start });
    }
    planner
}

fn written_out_it_moves_the_same(control: &'static Control, bytes: &[u8]) -> Result<(), TestCaseError> {
    let text = program::program(control, bytes);
    let recorder = Recorder::new(interp(control, &text));
    let ran = Rc::clone(&recorder.ran);
    let first = planned(control, recorder);
    let plain = flat::flat(control, &ran.borrow());
    let recorder = Recorder::new(interp(control, &plain));
    let ran_plain = Rc::clone(&recorder.ran);
    let second = planned(control, recorder);
    let names = interp(control, &text).names();
    let log = |ran: &[flat::Ran]| -> Vec<String> {
        ran.iter().flat_map(|ran| &ran.commands).map(|canon| canon.line(names).to_string()).collect()
    };
    let (ran, ran_plain) = (ran.borrow(), ran_plain.borrow());
    prop_assert_eq!(log(&ran), log(&ran_plain), "{} {}\n{}", control.id, text, plain);
    prop_assert_eq!(first.timeline().end(), second.timeline().end(), "{} {}\n{}", control.id, text, plain);
    for k in 0..=200 {
        let t = first.timeline().end() * f64::from(k) / 200.0;
        let (a, b) = (first.timeline().at(t), second.timeline().at(t));
        prop_assert_eq!(&a.axes, &b.axes, "at {} of {} {}\n{}", t, control.id, text, plain);
        prop_assert_eq!((a.spindle, a.mode), (b.spindle, b.mode), "at {} of {} {}\n{}", t, control.id, text, plain);
    }
    Ok(())
}

fn bytes() -> impl Strategy<Value = Vec<u8>> {
    proptest::collection::vec(any::<u8>(), 0..400)
}

proptest! {
    #[test]
    fn macro_program_moves_like_its_plain_blocks(bytes in bytes()) {
        for control in controls::ALL {
            written_out_it_moves_the_same(control, &bytes)?;
        }
    }

    #[test]
    fn generated_programs_survive_parse_and_emit(bytes in bytes()) {
        controls::ALL.iter().for_each(|control| laws::reading(control, &program::program(control, &bytes)));
    }

    #[test]
    fn broken_programs_survive_parse_and_emit(bytes in bytes()) {
        controls::ALL.iter().for_each(|control| laws::reading(control, &program::broken(control, &bytes)));
    }

    #[test]
    fn random_words_survive_parse_and_emit(bytes in bytes()) {
        controls::ALL.iter().for_each(|control| laws::reading(control, &program::soup(control, &bytes)));
    }

    #[test]
    fn any_text_survives_parse_and_emit(text in "\\PC{0,80}") {
        controls::ALL.iter().for_each(|control| laws::reading(control, &text));
    }

    #[test]
    fn any_bytes_survive_parse_and_emit(bytes in bytes()) {
        controls::ALL.iter().for_each(|control| laws::reading(control, &String::from_utf8_lossy(&bytes)));
    }

    #[test]
    fn generated_runs_end_within_their_budget(bytes in bytes(), world in bytes()) {
        for control in controls::ALL {
            laws::running(control, &program::program(control, &bytes), &world);
            laws::running(control, &program::broken(control, &bytes), &world);
            laws::running(control, &program::soup(control, &bytes), &world);
            laws::running(control, &String::from_utf8_lossy(&bytes), &world);
        }
    }
}

/// Number of commands of each kind in generated programs of this control, and number of programs that end normally.
fn kinds(control: &'static Control, programs: u32) -> (BTreeMap<String, u32>, u32) {
    let (mut kinds, mut ended, mut state) = (BTreeMap::new(), 0, 1_u64);
    let mut byte = || {
        // A linear congruential generator (Knuth, MMIX).
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as u8
    };
    for _ in 0..programs {
        let bytes: Vec<u8> = (0..400).map(|_| byte()).collect();
        let mut interp = interp(control, &program::program(control, &bytes));
        let end = macroline::interp::run(&mut interp, &mut MachineAtRest::default(), 5000, |canon, _| {
            let name = format!("{canon:?}");
            *kinds.entry(name.split([' ', '(']).next().unwrap().to_owned()).or_default() += 1;
        });
        ended += u32::from(end == Some(End::Program));
    }
    (kinds, ended)
}

#[test]
fn generated_programs_reach_every_command_kind() {
    let every = ["Rapid", "Linear", "Arc", "Dwell", "SpindleSpeed", "SpindleDirection", "Auxiliary", "Tool"];
    for control in controls::ALL {
        let (kinds, ended) = kinds(control, 300);
        let mut wanted = every.to_vec();
        wanted.extend(["Stop", "OptionalStop", "End"]);
        match control.syntax.names {
            Some(_) => wanted.push("Show"),
            None => wanted.extend(["Output", "Preset"]),
        }
        if control.can(Code::SurfaceSpeed) {
            wanted.extend(["SurfaceSpeed", "ConstantSpeed", "SpeedLimit"]);
        }
        if control.can(Code::GearStage(1)) {
            wanted.push("Gear");
        }
        if control.can(Code::Thread) {
            wanted.push("Thread");
        }
        let rare: Vec<_> = wanted.iter().filter(|kind| !kinds.contains_key(**kind)).collect();
        assert!(rare.is_empty(), "{}: {rare:?} in {kinds:?}", control.id);
        assert!(ended > 150, "{}: only {ended} of 300 programs come to their end", control.id);
    }
}

#[test]
fn fixture_programs_hold_the_generated_laws() {
    for control in controls::ALL {
        for folder in ["ok", "bad"] {
            let folder =
                Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/programs").join(control.id).join(folder);
            for entry in std::fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.extension().is_some_and(|ending| ending == "nc") {
                    let text = std::fs::read_to_string(&path).unwrap();
                    laws::reading(control, &text);
                    laws::running(control, &text, &[]);
                }
            }
        }
    }
}

#[test]
fn comment_before_a_cut_is_no_block_in_plain_blocks_either() {
    // G96, a rapid, a comment and a cut: the rapid ends with the speed of the cut.
    let bytes = [
        155, 0, 0, 0, 0, 0, 127, 0, 0, 0, 0, 103, 127, 0, 0, 0, 0, 41, 143, 100, 0, 167, 41, 44, 0, 0, 0, 0, 0, 112,
        88, 6, 0, 23, 184, 0, 44, 183, 17, 76, 0, 0, 0, 0, 127, 121, 0, 0, 0, 0, 0, 0, 0, 56, 0, 209, 0, 0, 195, 0,
        125, 209, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0, 0, 81, 0, 0, 0, 0, 0, 11, 0, 0, 0, 0, 0, 0, 0, 252, 0, 11, 0, 0, 0, 0,
        0, 0, 0, 172, 72, 225, 0, 129, 0, 0, 0, 0, 0, 0, 0, 0, 0, 172, 126, 0, 202, 213, 0, 0, 86, 11, 0, 0, 8, 0, 0,
        0, 0, 0, 0, 0, 0, 88, 6, 0, 36, 8, 0, 11, 0, 0, 0, 0, 0, 0, 220, 68, 0, 0, 0, 0, 178, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0,
    ];
    for control in controls::ALL {
        written_out_it_moves_the_same(control, &bytes).unwrap();
    }
}

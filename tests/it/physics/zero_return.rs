//! Program zero return: effect of the operator's key, and states in which it has none.

use std::rc::Rc;

use macroline::interp::{Interp, StartProgram};
use macroline::nc::{Files, parse};
use macroline::text::Severity;

use super::*;

/// The reference point at X60 Z40, the tool's end at X20 Z5.
const PART: &str = "G00 X60. Z40.\nG50 S2000\nG00 X20. Z5.";

/// When the programs here are over.
const LATER: f64 = 20.0;

/// A program on a lathe with stock of 50 mm; X moves 100 mm/s at most, Z 200 mm/s.
fn lathe(control: &str, lines: &str, events: &[(f64, Action)]) -> Planner<Interp> {
    let control = controls::find(control).unwrap();
    let mut plant = plant();
    let slide = |letter, diameter, rapid| AxisPlant { diameter, rapid, ..axis(letter) };
    plant.axes = vec![slide(Address::X, true, 6000.0), slide(Address::Z, false, 12_000.0)];
    plant.spindle = SpindlePlant::bench(control, Dialect::resolve(control, &Switches::default()).spindle());
    plant.stock = 25.0;
    let parsed = parse(&Files::one("O1.nc", format!("O0001\n{lines}\nM30\n%\n")), control);
    let mut planner = Planner::new(Setup {
        program: Interp::new(Rc::new(parsed), StartProgram::First),
        control,
        plant: &plant,
        plc: Box::new(bench_plc(0.05, None)),
        panel: Panel::new(events.iter().map(|(t, action)| at(*t, action.clone()))),
        limits: Budget { blocks: 1000, seconds: 600.0 },
        keep: Retention::Timeline,
        findings: Vec::new(),
    });
    planner.advance(f64::INFINITY, usize::MAX);
    planner
}

fn gsk(lines: &str, events: &[(f64, Action)]) -> Planner<Interp> {
    lathe("gsk-980tdc", lines, events)
}

/// X and Z as words count them.
fn place_at(planner: &Planner<Interp>, t: f64) -> (f64, f64) {
    let words = planner.timeline().words_at(t);
    let axes = controls::find("gsk-980tdc").unwrap().axes;
    let of = |letter| words[axes.iter().position(|axis| axis.letter == letter).unwrap()];
    (of(Address::X), of(Address::Z))
}

fn last_place(planner: &Planner<Interp>) -> (f64, f64) {
    place_at(planner, planner.timeline().end())
}

fn ended(planner: &mut Planner<Interp>) -> RunEnd {
    planner.advance(f64::INFINITY, usize::MAX).ended.unwrap()
}

fn finding_ids(planner: &Planner<Interp>) -> Vec<&'static str> {
    planner.diagnostics().iter().map(|found| found.message.id).collect()
}

#[test]
fn each_axis_returns_at_its_own_rapid_rate() {
    for (percent, stretch) in [(100.0, 1.0), (50.0, 2.0)] {
        let events = [(LATER, Action::RapidOverride(percent)), (LATER, Action::ProgramZeroReturn)];
        let planner = gsk(PART, &events);
        assert_eq!(last_place(&planner), (60.0, 40.0));
        let now = |t: f64| planner.timeline().at(LATER + t);
        let feeds = |t: f64| [now(t).axes[0].feed, now(t).axes[2].feed];
        // Z has 35 mm to go: 0.175 s; X 20 mm: 0.2 s. Both slow down over their time constant.
        assert_eq!(feeds(0.14 * stretch).map(f64::round), [6000.0 / stretch, 12_000.0 / stretch]);
        assert!(feeds(0.174 * stretch + TAU)[1] > 1.0 && feeds(0.176 * stretch + TAU)[1].abs() < 1e-6);
        assert!(feeds(0.199 * stretch + TAU)[0] > 1.0 && feeds(0.201 * stretch + TAU)[0].abs() < 1e-6);
    }
}

#[test]
fn return_leaves_program_and_spindle_as_they_were() {
    let lines = format!("G97 S500 M03\n{PART}\nG96 S60\nG01 X10. F300");
    let events = [(LATER, Action::ProgramZeroReturn)];
    let (mut plain, mut planner) = (gsk(&lines, &[]), gsk(&lines, &events));
    assert_eq!((ended(&mut planner), last_place(&planner)), (ended(&mut plain), (60.0, 40.0)));
    assert_eq!(finding_ids(&planner), finding_ids(&plain));
    // The key, pressed later in a run that is planned to its end, gives an equal run.
    let [(t, key)] = events;
    plain.event(at(t, key));
    assert_eq!((ended(&mut plain), last_place(&plain)), (RunEnd::ProgramEnd, (60.0, 40.0)));
    let moving = |planner: &Planner<Interp>| planner.timeline().at(LATER + 0.13);
    assert_eq!(moving(&plain), moving(&planner));
    let [before, behind] = [LATER - 1.0, planner.timeline().end()].map(|t| planner.timeline().at(t));
    assert!(before.spindle.command > 100.0, "it turns on behind M30");
    assert_eq!(
        (before.spindle.command, before.mode, before.block),
        (behind.spindle.command, behind.mode, behind.block)
    );
}

#[test]
fn start_after_the_return_begins_at_the_head() {
    let events = [(LATER, Action::ProgramZeroReturn), (LATER + 5.0, Action::Start)];
    let mut planner = gsk("G00 X60. Z40.\nG50 S2000\nG00 U-40. W-35.", &events);
    assert_eq!((ended(&mut planner), last_place(&planner)), (RunEnd::ProgramEnd, (20.0, 5.0)));
    assert_eq!(place_at(&planner, LATER + 5.0), (60.0, 40.0));
}

#[test]
fn hold_ends_the_return_and_the_key_begins_anew() {
    let press = (LATER, Action::ProgramZeroReturn);
    for stop in [Action::Hold, Action::Reset] {
        let halfway = (LATER + 0.1, stop);
        let planner = gsk(PART, &[press.clone(), halfway.clone()]);
        // 0.1 s at 100 mm/s and 200 mm/s.
        let (x, z) = last_place(&planner);
        assert!((x - 40.0).abs() < 1e-6 && (z - 25.0).abs() < 1e-6, "{x} {z}");
        assert_eq!(planner.timeline().at(planner.timeline().end()).axes[0].feed, 0.0);
        let again = (LATER + 5.0, Action::ProgramZeroReturn);
        assert_eq!(last_place(&gsk(PART, &[press.clone(), halfway, again])), (60.0, 40.0));
    }
}

#[test]
fn emergency_stop_ends_the_return_until_reset() {
    let broken = [(LATER, Action::ProgramZeroReturn), (LATER + 0.1, Action::EmergencyStop)];
    let again = (LATER + 5.0, Action::ProgramZeroReturn);
    let mut planner = gsk(PART, &[broken.to_vec(), vec![again.clone()]].concat());
    assert!(matches!(ended(&mut planner), RunEnd::Alarm(_)));
    assert!((last_place(&planner).0 - 40.0).abs() < 1e-6);
    assert_eq!(finding_ids(&planner), ["motion.emergency-stop", "motion.zero-return-refused"]);
    let planner = gsk(PART, &[broken.to_vec(), vec![(LATER + 4.0, Action::Reset), again]].concat());
    assert_eq!(last_place(&planner), (60.0, 40.0));
}

#[test]
fn key_does_nothing_while_the_program_is_not_over() {
    for (lines, t) in [(format!("{PART}\nG04 X30."), 15.0), (format!("{PART}\nM00\nG00 X30."), LATER)] {
        let press = [(t, Action::ProgramZeroReturn)];
        let (mut plain, mut planner) = (gsk(&lines, &[]), gsk(&lines, &press));
        assert_eq!((ended(&mut planner), last_place(&planner)), (ended(&mut plain), last_place(&plain)));
        assert_eq!(finding_ids(&planner).first(), Some(&"motion.zero-return-refused"), "{lines}");
    }
}

#[test]
fn return_needs_the_mode_and_a_reference_point() {
    let press = [(LATER, Action::ProgramZeroReturn)];
    for (control, lines, wanted) in [
        ("fanuc-0i-tf", "G50 X60. Z40.\nG00 X20. Z5.", "motion.no-zero-return"),
        ("mitsubishi-e60", "G92 X60. Y40.\nG00 X20. Y5.", "motion.no-zero-return"),
        ("sinumerik-802d", "G0 X60 Z40\nG0 X20 Z5", "motion.no-zero-return"),
        ("gsk-980tdc", "G00 X60. Z40.\nG00 X20. Z5.", "motion.no-reference-point"),
        ("knd-k2000t", "G00 X60. Z40.\nG50 S2000\nG00 X20. Z5.", "motion.no-reference-point"),
    ] {
        let (plain, planner) = (lathe(control, lines, &[]), lathe(control, lines, &press));
        let words = |planner: &Planner<Interp>| planner.timeline().words_at(planner.timeline().end());
        assert_eq!(words(&planner), words(&plain), "{control}");
        assert_eq!(finding_ids(&planner).last(), Some(&wanted), "{control}");
    }
    // A preset of coordinates sets the point where the axes are.
    let planner = lathe("knd-k2000t", "G00 X60. Z40.\nG50 X0 Z0\nG00 U-40. W-35.", &press);
    assert_eq!(&planner.timeline().words_at(planner.timeline().end())[..2], [60.0, 40.0]);
}

#[test]
fn return_through_the_work_is_refused() {
    let ways = [
        // Down from in front of the face, and down into the work from beside it.
        ("G00 X60. Z-50.\nG50 S2000\nG00 Z5.\nG00 X20.", true),
        ("G00 X20. Z5.\nG00 Z-10.\nG50 S2000\nG00 Z5.\nG00 X60.\nG00 Z-30.", true),
        // Through the centre, inside the work.
        ("G00 X-60. Z-10.\nG50 S2000\nG00 Z5.\nG00 X60.\nG00 Z-10.", true),
        // Beside the work, and out of a cut.
        ("G00 X60. Z-50.\nG50 S2000\nG00 Z5.", false),
        ("G00 X60. Z40.\nG50 S2000\nG00 X20. Z5.\nG00 Z-10.", false),
    ];
    for (lines, hits) in ways {
        let (plain, planner) = (gsk(lines, &[]), gsk(lines, &[(LATER, Action::ProgramZeroReturn)]));
        let refused = planner.diagnostics().iter().find(|found| found.message.id == "motion.zero-return-through-work");
        assert_eq!(refused.map(|found| found.severity), hits.then_some(Severity::Error), "{lines}");
        assert_eq!(last_place(&planner) == last_place(&plain), hits, "{lines}");
    }
}

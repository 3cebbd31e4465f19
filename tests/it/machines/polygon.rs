//! The polygon lathe: its programs run, both axes keep their ratio, mistakes are alarms, the run cuts the shape of the formulas.

mod drawing;
mod edges;
mod knobs;
mod main_spindle;
mod paper;
mod several;
mod shaft;
mod sheets;
mod torque;

use std::path::PathBuf;
use std::rc::Rc;

use expect_test::{expect, expect_file};
use macroline::controls::Switches;
use macroline::interp::Interp;
use macroline::machines::form::{FieldKindInfo, Origins, Values};
use macroline::machines::{self, AnyMachine, Frame, Samples};
use macroline::motion::{Action, Budget, Event, Mode, Panel, Planner, Retention, RunEnd, Timeline};
use macroline::nc::{self, File, Files};
use macroline::project::run::{self, RunOptions};
use macroline::project::{Project, import};
use macroline::text::Severity;
use macroline::text::catalog::{number_text, sentence};
use macroline::view::{Theme, Verdict, svg};

use super::every_machine::drawn::area;
use crate::queries;
use crate::queries::value;

const WORK: usize = 0;
const TOOL: usize = 1;

pub(super) fn machine() -> &'static dyn AnyMachine {
    machines::find("polygon-lathe").unwrap()
}

fn values(changes: &[(&str, &str)]) -> Values {
    queries::values(machine(), changes)
}

pub(super) fn project(changes: &[(&str, &str)]) -> Project {
    let mut project = Project::of("polygon-lathe", None).unwrap();
    project.values.extend(values(changes));
    project
}

fn begin() -> RunOptions<'static> {
    let limits = Budget { blocks: 1_000_000, seconds: 600.0 };
    RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline }
}

fn planned(project: &Project) -> Planner<Interp> {
    let mut planner = run::of_project(project, &project.written(), &begin());
    planner.advance(f64::INFINITY, usize::MAX);
    planner
}

fn whole(project: &Project) -> Planner<Interp> {
    let mut planner = planned(project);
    assert_eq!(
        planner.advance(f64::INFINITY, usize::MAX).ended,
        Some(RunEnd::ProgramEnd),
        "{:?}",
        planner.diagnostics()
    );
    planner
}

/// A text in place of O3000, beside the macro programs, on the machine.
fn edited(changes: &[(&str, &str)], text: &str) -> Project {
    let mut project = project(changes);
    let mut files = project.written().files;
    let part = files.0.iter_mut().find(|file| file.name.starts_with("O3000")).unwrap();
    text.clone_into(&mut part.text);
    project.edited = Some(files);
    project
}

/// Twelve sides in five turns of the work, both turning backward.
const STAR: [(&str, &str); 6] =
    [("shape", "own"), ("inserts", "5"), ("work-ratio", "-5"), ("tool-ratio", "-12"), ("speed", "40"), ("sides", "12")];

/// The paper's example.
const PAPER: &str = include_str!("../../../src/machines/polygon_lathe/listing.nc");

#[test]
fn exported_programs_match_their_goldens() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/machines/polygon-lathe/knd-k2000t");
    type Case = (&'static str, &'static [(&'static str, &'static str)]);
    let cases: [Case; 3] = [
        ("square", &[]),
        ("hexagon", &[("shape", "hexagon"), ("across-flats", "17"), ("work-start", "-7.5"), ("customer", "ACME")]),
        ("star", &STAR),
    ];
    for (name, changes) in cases {
        let (project, folder) = (project(changes), folder.join(name));
        for file in project.written().files.0 {
            expect_file![folder.join(&file.name)].assert_eq(&file.text);
        }
        expect_file![folder.join("project.json")].assert_eq(&project.to_json());
    }
}

#[test]
fn paper_example_turns_work_at_200_and_tool_at_400() {
    let planner = whole(&edited(&[], PAPER));
    // Its retract stays at F200.
    let paper = edited(&[], PAPER);
    let ids: Vec<_> = paper.advice(&paper.written()).iter().map(|d| d.message.id).collect();
    assert_eq!(ids, ["lint.slow-retract"]);
    let timeline = planner.timeline();
    // While Z cuts at X20.
    let cutting = (0..6000).map(|i| timeline.at(f64::from(i) * 0.01)).filter(|now| {
        let (x, z) = (now.axes[0], now.axes[1]);
        now.mode == Mode::Running && (2.0 * x.actual - 20.0).abs() < 1e-6 && z.actual < -1.0 && z.actual > -14.0
    });
    let cutting: Vec<_> = cutting.collect();
    assert!(cutting.len() > 300, "{}", cutting.len());
    for now in &cutting {
        assert!((now.pmc[WORK].feed / 360.0 - 200.0).abs() < 1e-9 && (now.pmc[TOOL].feed / 360.0 - 400.0).abs() < 1e-9);
    }
    let end = timeline.at(timeline.end());
    assert_eq!((end.pmc[WORK].feed, end.pmc[TOOL].feed), (0.0, 0.0));
    let square = project(&[("stock-diameter", "29")]);
    assert_eq!(value(&square, "sides"), 4.0);
    assert!((value(&square, "across-flats") - 20.0).abs() < 1e-9);
    assert_eq!(value(&project(&[("shape", "own"), ("inserts", "3"), ("sides", "6")]), "sides"), 6.0);
}

#[test]
fn program_outputs_to_the_pmc_show_on_the_screen() {
    let project = project(&[]);
    let planner = whole(&project);
    let shown = |t| [1480, 1484, 1488, 1101].map(|number| run::shown(&planner, project.control, number, t));
    assert_eq!(shown(0.0), [Some(0.0); 4]);
    assert_eq!(shown(3.0), [Some(200.0), Some(1.0), Some(2.0), Some(1.0)]);
}

#[test]
fn pmc_word_to_the_program_shows_bit_by_bit_on_the_screen() {
    let project = project(&[]);
    let planner = whole(&project);
    let bits = |t| [1000, 1001, 1002, 1003].map(|number| run::shown(&planner, project.control, number, t));
    // At rest; turning at speed; at rest again.
    assert_eq!(bits(0.0), [0.0, 0.0, 0.0, 1.0].map(Some));
    assert_eq!(bits(3.0), [1.0, 1.0, 1.0, 0.0].map(Some));
    assert_eq!(bits(1e9), [0.0, 0.0, 0.0, 1.0].map(Some));
    // Own variables are vacant until a program writes them.
    assert_eq!(run::shown(&planner, project.control, 100, 3.0), None);
}

#[test]
fn tool_keeps_its_ratio_through_every_speed_change() {
    let ways = [("1", "2"), ("5", "12"), ("-1", "2"), ("3", "-7"), ("-2", "-3")];
    for ((work, tool), override_acts) in ways.into_iter().flat_map(|way| [(way, true), (way, false)]) {
        let changes = [
            ("shape", "own"),
            ("work-ratio", work),
            ("tool-ratio", tool),
            ("speed", "60"),
            ("work-start", "33.3"),
            ("tool-start", "-71.125"),
        ];
        let mut project = project(&changes);
        if override_acts {
            project.switches.0.push(("pmc-override".to_owned(), "acts".to_owned()));
        }
        let at = |t: f64, action: Action| Event { t, action };
        for event in [
            at(2.0, Action::FeedOverride(50.0)),
            at(2.33, Action::FeedOverride(120.0)),
            at(3.1, Action::Hold),
            at(3.7, Action::Start),
            at(6.0, Action::FeedOverride(90.0)),
        ] {
            project.panel.add(event);
        }
        let planner = planned(&project);
        let timeline = planner.timeline();
        let (d, q): (f64, f64) = (work.parse().unwrap(), tool.parse().unwrap());
        let stands = |t: &f64| timeline.at(*t).pmc.map(|axis| axis.feed) == [0.0; 2];
        let begun = (0..2000).map(|i| f64::from(i) * 0.001).rfind(stands).unwrap();
        let mut turned = 0;
        for i in 0..10_000 {
            let now = timeline.at(f64::from(i) * 0.001);
            let [w, t] = now.pmc;
            // From the last standstill at the start angles on.
            if now.t < begun {
                continue;
            }
            turned += 1;
            let off = (t.position + 71.125) - q / d * (w.position - 33.3);
            assert!(off.abs() / 360.0 < 1e-9, "{work}:{tool} at {}: {off}", now.t);
            // The actual angles have this lag only after the motion to the start angles has settled.
            if now.t < begun + 1.0 {
                continue;
            }
            let off = (t.actual + 71.125) - q / d * (w.actual - 33.3);
            assert!(off.abs() / 360.0 < 1e-9, "{work}:{tool} at {}: {off}", now.t);
        }
        assert!(turned > 8000);
        let speed = timeline.at(2.9).pmc[WORK].feed / 360.0;
        assert!((speed - 60.0 * d * if override_acts { 1.2 } else { 1.0 }).abs() < 1e-9, "{speed}");
        // Feed hold does not stop axes that the PMC turns.
        let held = timeline.at(3.65);
        assert!(held.mode == Mode::Hold && held.axes[1].feed == 0.0 && held.pmc[WORK].feed != 0.0);
    }
}

#[test]
fn both_axes_reach_start_angles_in_the_sense_of_the_sign() {
    for (a, e) in [("90", "-45"), ("-200", "359"), ("0", "0"), ("0.001", "-0.001")] {
        let planner = planned(&project(&[("work-start", a), ("tool-start", e)]));
        let timeline = planner.timeline();
        let moving = |t: f64| timeline.at(t).pmc.map(|axis| axis.feed);
        let index =
            |axis: usize| (0..40_000).map(|i| moving(f64::from(i) * 0.0005)[axis]).find(|feed| *feed != 0.0).unwrap();
        for (axis, angle) in [(WORK, a), (TOOL, e)] {
            let angle: f64 = angle.parse().unwrap();
            if angle != 0.0 {
                assert_eq!(index(axis) > 0.0, angle > 0.0, "{a} {e}");
            }
        }
    }
}

#[test]
fn wrong_g512_arguments_raise_alarms() {
    let outcome = |block: &str| {
        let text = format!("O3000\nT0101\nG0X40.Z5.\n{block}\nG502\nM30\n");
        let project = edited(&[], &text);
        let mut planner = planned(&project);
        match planner.advance(f64::INFINITY, usize::MAX).ended {
            Some(RunEnd::Alarm(alarm)) => {
                format!("{}: {}", alarm.alarm.as_ref().map_or("", |number| number), sentence(&alarm.message))
            }
            other => format!("{other:?}"),
        }
    };
    expect!["Some(ProgramEnd)"].assert_eq(&outcome("G512 B200 D1 Q2 A0. E0."));
    for (block, number) in [
        ("G512 D1 Q2", "3001"),
        ("G512 B0 D1 Q2", "3001"),
        ("G512 B200 Q2", "3002"),
        ("G512 B200 D1", "3003"),
        ("G512 B200 D1.5 Q2", "3004"),
        ("G512 B200 D1 Q2.5", "3005"),
        ("G512 B200 D1 Q0", "3006"),
        ("G512 B200 D0 Q2", "3006"),
        ("G512 B200 D1 Q2 X20.", "3007"),
        ("G512 B200 D1 Q2 C90.", "3007"),
        ("G512 B200 D1 Q2 M8", "3007"),
        ("G512 B200 D1 Q2 F100.", "3007"),
        ("G512 B200 D1 Q2 G502", "129"),
        ("G502 G512 B200 D1 Q2", "129"),
        ("G0 G512 B200 D1 Q2", "129"),
        ("G512 B200 D1 Q2\nG512 B200 D1 Q2", "3008"),
        ("G512 B2000 D1 Q2", "3009"),
        ("G512 B200 D1 Q-12", "3010"),
        ("G502 Z0", "3007"),
    ] {
        let found = outcome(block);
        assert!(found.starts_with(number), "{block}: {found}");
    }
}

/// After seven seconds both turn in ratio from the same start angles: a whole turn of each is the same place.
#[track_caller]
/// The part program without its checks of the place, which would stop a restart in the cut.
fn unchecked(changes: &[(&str, &str)]) -> Project {
    let text = project(changes).written().files.0[0].text.clone();
    let lines: Vec<&str> = text.lines().filter(|line| !line.contains("GOTO911")).collect();
    edited(changes, &lines.join("\n"))
}

fn turns_in_ratio_again(timeline: &Timeline) {
    let again = (7000..20_000).map(|i| timeline.at(0.001 * f64::from(i))).find(|now| now.pmc[WORK].feed > 71_999.0);
    let now = again.unwrap().pmc;
    let off = (now[TOOL].position - 2.0 * now[WORK].position) / 360.0;
    assert!((off - off.round()).abs() < 1e-9, "{off}");
}

#[test]
fn reset_or_emergency_stop_needs_a_new_g512() {
    for action in [Action::Reset, Action::EmergencyStop] {
        let mut project = unchecked(&[]);
        project.panel.add(Event { t: 5.0, action });
        let mut planner = planned(&project);
        let timeline = planner.timeline();
        assert!(timeline.at(4.9).axes[1].position < 0.0 && timeline.at(4.9).pmc[WORK].feed > 0.0, "in the cut");
        // Both stop over their time constant, in ratio; the slide stays in the cut.
        for i in 0..100 {
            let now = timeline.at(5.0 + 0.01 * f64::from(i));
            assert!((now.pmc[TOOL].position - 2.0 * now.pmc[WORK].position).abs() < 1e-7);
        }
        assert_eq!(timeline.at(5.4).pmc.map(|axis| axis.feed), [0.0; 2]);
        assert!(timeline.at(5.4).axes[1].position < 0.0);
        planner.event(Event { t: 6.0, action: Action::Reset });
        planner.event(Event { t: 7.0, action: Action::Start });
        let ended = planner.advance(f64::INFINITY, usize::MAX).ended;
        assert_eq!(ended, Some(RunEnd::ProgramEnd), "{:?}", planner.diagnostics());
        let timeline = planner.timeline();
        assert_eq!(timeline.at(6.5).pmc[WORK].feed, 0.0);
        turns_in_ratio_again(timeline);
    }
}

#[test]
fn power_failure_loses_the_ratio_with_held_drives_too() {
    let cases = [("held", Verdict::None, "polygon.coasts-without-supply"), ("off", Verdict::Warn, "polygon.coasts")];
    for (emergency, verdict, advice) in cases {
        let lathe = project(&[("emergency", emergency), ("work-coast", "6"), ("tool-coast", "2.5")]);
        let row = lathe.design().readouts.into_iter().find(|row| row.id == "coast-phase").expect("a row");
        // 400 r/min of 2000 in 2.5 s are 800 r/min/s, 200 of 1000 in 6 s are 166.7: 3 (400²/800 - 2 · 200²/166.7).
        assert!((row.value - 3.0 * (200.0 - 480.0)).abs() < 1e-9, "{}", row.value);
        assert_eq!((row.verdict, row.advice[0].message.id), (verdict, advice), "{emergency}");
        let sheets = lathe.prepared().sheets();
        let stops = sheets.iter().find(|sheet| sheet.id == "stops").expect("a table");
        let cells = stops.rows.iter().find(|row| row.cells[0] == "Power failure").expect("a row").cells.join(" ");
        assert!(cells.contains(" 840° off its angle") && cells.contains("discard the part"), "{cells}");
        assert!(cells.contains("coast"), "{cells}");
    }
}

#[test]
fn drives_off_at_emergency_stop_lose_the_ratio() {
    let changes = [("emergency", "off"), ("work-coast", "6"), ("tool-coast", "2.5")];
    let mut project = unchecked(&changes);
    project.panel.add(Event { t: 5.0, action: Action::EmergencyStop });
    let planner = planned(&project);
    let timeline = planner.timeline();
    // 200 of 1000 r/min in 6 s, 400 of 2000 r/min in 2.5 s; half a time constant and the servo later.
    for (axis, rest) in [(WORK, 6.0 * 0.2), (TOOL, 2.5 * 0.2)] {
        let rpm = |t: f64| timeline.at(t).pmc[axis].feed / 360.0;
        let half = rpm(5.0 + 0.5 * rest + 0.15) / rpm(4.9);
        assert!((half - 0.5).abs() < 0.07, "{axis}: {half}");
        assert!(rpm(5.0 + 0.9 * rest) > 0.0 && rpm(5.0 + rest + 0.35) == 0.0, "{axis}");
    }
    let stands = timeline.at(9.0).pmc;
    let lost = stands[TOOL].actual - 2.0 * stands[WORK].actual;
    let calculated = value(&project, "coast-phase");
    // Coasting is given in steps of 10 ms.
    assert!(calculated < -300.0 && (lost - calculated).abs() < 1.0, "{lost} for {calculated}");
    // Reset while they coast brakes nothing, and the next start finds the start angles again.
    let mut planner = planner;
    planner.event(Event { t: 5.2, action: Action::Reset });
    planner.event(Event { t: 7.0, action: Action::Start });
    let ended = planner.advance(f64::INFINITY, usize::MAX).ended;
    assert_eq!(ended, Some(RunEnd::ProgramEnd), "{:?}", planner.diagnostics());
    let timeline = planner.timeline();
    assert!(timeline.at(6.0).pmc[WORK].feed > 0.0 && timeline.at(6.0).pmc[TOOL].feed == 0.0);
    turns_in_ratio_again(timeline);
}

#[test]
fn feed_into_work_at_rest_is_one_finding_at_its_block() {
    let places = |text: &str| {
        let planner = planned(&edited(&[], &format!("O3000\nT0101\nG98G0X29.Z2.\n{text}M30\n")));
        let standing = planner.diagnostics().iter().filter(|d| d.message.id == "motion.feed-without-rotation");
        standing.map(|d| d.place.unwrap().span.start).collect::<Vec<_>>()
    };
    let begin = "O3000\nT0101\nG98G0X29.Z2.\n".len() as u32;
    let on = "G512B200D1Q2\n";
    let cut = "G0X22.\nG1Z-10.F200.\n";
    let out = "G0X29.\nZ2.\n";
    // Before G512, and after G502.
    assert_eq!(places(&format!("{cut}{out}{on}{cut}{out}G502\n")), [begin + 7]);
    let behind = format!("{on}{cut}{out}G502\n");
    assert_eq!(places(&format!("{behind}{cut}{out}")), [begin + behind.len() as u32 + 7]);
    // Across the face, and an arc.
    assert_eq!(places("G0Z-1.\nG1X-1.F100.\n").len(), 1);
    assert_eq!(places("G0Z0.\nG2X20.Z-5.R20.F100.\n").len(), 1);
    // While work or tool turns, beside the work, and away from it.
    for text in [
        format!("{on}{cut}{out}G502\n"),
        format!("M3S300\n{cut}{out}M5\n"),
        "G1X25.Z-20.F200.\nX40.\n".to_owned(),
        "G1X0.F200.\nZ0.\n".to_owned(),
        format!("{on}{cut}G502\nG1X30.F200.\n"),
        format!("{on}{cut}G502\nG1Z2.F200.\n"),
    ] {
        assert!(places(&text).is_empty(), "{text}");
    }
    // Generated programs, and the paper's.
    for project in [project(&[]), project(&STAR), edited(&[], PAPER)] {
        assert!(whole(&project).diagnostics().iter().all(|d| d.message.id != "motion.feed-without-rotation"));
    }
}

#[test]
fn g502_in_the_cut_waits_for_the_slide_and_stops_in_ratio() {
    let text = "O3000\nT0101\nG0X29.Z2.\nG512B200D1Q2\nG0X22.\nG98G1Z-10.F200.\nG502\nG0X40.\nM30\n";
    let planner = whole(&edited(&[], text));
    let timeline = planner.timeline();
    let moments: Vec<_> = (0..20_000).map(|i| timeline.at(0.001 * f64::from(i))).collect();
    let last = moments.iter().rposition(|now| now.pmc[WORK].feed == 72_000.0).unwrap();
    // Both turn at speed until the slide is at rest in the cut, and nothing moves away before both are at rest.
    assert!((moments[last].axes[1].actual + 10.0).abs() < 0.03, "{:?}", moments[last].axes);
    let stands = (last..moments.len()).find(|at| moments[*at].pmc[WORK].feed == 0.0).unwrap();
    for now in &moments[last..=stands] {
        assert!((now.axes[0].position - 11.0).abs() < 1e-9 && (now.axes[1].position + 10.0).abs() < 1e-9);
        let off = now.pmc[TOOL].position - 2.0 * now.pmc[WORK].position;
        assert!(off.abs() < 1e-6, "{off}");
    }
    assert!(moments[stands..].iter().any(|now| now.axes[0].position > 19.0));
}

/// Processor time of this thread in s, in steps of 0.01; 0 if the system does not report it.
fn processor_seconds() -> f64 {
    let Ok(stat) = std::fs::read_to_string("/proc/thread-self/stat") else { return 0.0 };
    // Fields 14 and 15, user and system time in ticks, counted after the name in brackets, which is field 2.
    let behind = stat.rsplit(')').next().unwrap_or_default();
    behind.split_whitespace().skip(11).take(2).filter_map(|ticks| ticks.parse::<f64>().ok()).sum::<f64>() / 100.0
}

#[test]
fn any_form_values_design_within_the_processor_time() {
    let fields = machine().fields();
    let mut seed = 5_u64;
    let mut dice = |sides: usize| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as usize % sides
    };
    let mut slowest = (0.0_f64, Vec::new());
    for _ in 0..150 {
        let mut project = project(&[("shape", "own")]);
        let mut all = Vec::new();
        for field in &fields {
            let ends = match &field.kind {
                // Both ends of the range, and two within.
                FieldKindInfo::Number { min, max, .. } => {
                    [min.to_string(), max.to_string(), "0".to_owned(), "7".to_owned()]
                }
                FieldKindInfo::Text(_) => ["1 2 3", "-0.3 0.3", "0,5", "nonsense"].map(str::to_owned),
                _ => continue,
            };
            let typed = if dice(3) == 0 { field.read_metric(&ends[dice(4)]).ok() } else { None };
            all.extend(typed.map(|value| (field.id.to_owned(), value)));
        }
        project.values.extend(all.iter().cloned());
        let begun = processor_seconds();
        let _ = (project.design(), project.export());
        let seconds = processor_seconds() - begun;
        if seconds > slowest.0 {
            slowest = (seconds, all);
        }
    }
    // Without optimisation.
    let (seconds, values) = slowest;
    assert!(seconds < 3.0, "{seconds} s of processor time for {values:?}");
}

#[test]
fn unequal_time_constants_fail_the_phase_verdict() {
    let project = project(&[("tool-time-constant", "500"), ("work-gain", "40")]);
    let design = project.design();
    let advice = design.readouts.iter().flat_map(|row| &row.advice);
    assert_eq!(advice.filter(|found| found.message.id == "polygon.out-of-phase").count(), 1);
    // Once: it is no finding too.
    assert!(design.diagnostics.iter().all(|found| found.message.id != "polygon.out-of-phase"));
    let planner = whole(&project);
    let now = planner.timeline().at(8.0);
    let ahead = now.pmc[TOOL].actual - 2.0 * now.pmc[WORK].actual;
    let calculated = value(&project, "phase");
    assert!((ahead - calculated).abs() < 1e-3, "{ahead} for {calculated}");
    // (0.25 + 1/30 - 0.15 - 1/40) s at 400 r/min.
    assert!((calculated + 6.0 * 400.0 * (0.1 + 1.0 / 30.0 - 1.0 / 40.0)).abs() < 1e-9);
}

#[test]
fn dropped_program_restores_the_form() {
    let saved = project(&[("shape", "triangle"), ("across-flats", "8"), ("stock-diameter", "11"), ("product", "LOCK")]);
    let present = Project::of("ribbon-line", None).unwrap();
    for file in saved.written().files.0.into_iter().take(1) {
        let opened = import::open(&present, std::slice::from_ref(&file)).project.unwrap();
        let written =
            |project: &Project| project.written().files.0.into_iter().map(|file| file.text).collect::<Vec<_>>();
        assert_eq!((opened.machine.id(), opened.control.id), ("polygon-lathe", "knd-k2000t"));
        assert_eq!(written(&opened), written(&saved));
    }
}

#[test]
fn design_readouts_match_their_golden() {
    let verdicts = |changes: &[(&str, &str)]| {
        let design = machine().prepare(&values(changes), project(&[]).control_context()).design(&Origins::default());
        let verdicts = design.readouts.iter().filter(|row| row.verdict > Verdict::Ok).map(|row| {
            let advice: Vec<_> = row.advice.iter().map(|advice| sentence(&advice.message)).collect();
            format!("{:?} {}: {}\n", row.verdict, row.id, advice.join(" "))
        });
        let errors = design.diagnostics.iter().filter(|d| d.severity != Severity::Info);
        let errors = errors.map(|d| format!("{:?} {}: {}\n", d.severity, d.field.unwrap_or(""), sentence(&d.message)));
        verdicts.chain(errors).collect::<String>()
    };
    expect![""].assert_eq(&verdicts(&[]));
    expect![[r#"
        Fail flatness: The sides are uneven by 0.0496 mm; 0.01 mm are allowed. Tips at a radius of 106.7 mm are flat enough at this ratio; enter the inertia of the larger disc too. No choice on this tip circle keeps within every limit: the flattest has 0.0496 mm of flatness error. The list of choices says which limit excludes each.
    "#]].assert_eq(&verdicts(&[("flatness", "0.01"), ("stock-diameter", "29")]));
    expect![[r#"
        Fail flatness: The sides are uneven by 0.9914 mm; 0.1 mm are allowed. Tool and work turn against each other: sides come out hollow. Give D and Q the same sign.
        Warn relief: The tips move over the work against the turning of the cutter: inserts have to face the other way.
        Fail curvature: The sides are hollow: 0.9914 mm higher toward the corners than in the middle.
    "#]].assert_eq(&verdicts(&[("shape", "own"), ("tool-ratio", "-2")]));
    expect![[r#"
        Fail flatness: The sides are uneven by 0.1012 mm; 0.1 mm are allowed. A lower ratio (flat in the middle at 2.106), a smaller cutter or other inserts make them less hollow. The flattest choice here: 3 inserts, D1 Q2, tips at a radius of 45 mm, 0.0166 mm of flatness error.
        Fail curvature: The sides are hollow: 0.1012 mm higher toward the corners than in the middle.
    "#]].assert_eq(&verdicts(&[("shape", "own"), ("inserts", "2"), ("tool-ratio", "3"), ("sides", "6")]));
    expect![[r#"
        Fail sides: This cutter turns 6 sides, not 4. The flattest choice here: 2 inserts, D1 Q2, tips at a radius of 45 mm, 0.0284 mm of flatness error.
        Fail flatness: The sides are uneven by 0.239 mm; 0.1 mm are allowed.
        Fail tool-speed: The tool axis turns 2000 r/min at most: B may be 333 at most.
        Fail curvature: The sides are hollow: 0.239 mm higher toward the corners than in the middle.
        Warn fastest-cut: The inserts cut faster than they may: 141 r/min for B is as fast as suits.
        Warn tool-torque: With the feed override at 150 %, the cut asks 59.1 Nm, and the drive gives 49.2 Nm at this speed: reduce the feed, or keep the override lower.
    "#]].assert_eq(&verdicts(&[
        ("shape", "own"),
        ("inserts", "1"),
        ("tool-ratio", "6"),
        ("sides", "4"),
        ("speed", "400"),
    ]));
    expect![[r#"
        Fail relief: The inserts need more than 4.76° of relief in pass 4, to 20 mm; they have 3°. Take less depth of cut, smaller stock, a larger cutter or more relief. No choice on this tip circle keeps within every limit: the flattest has 0.0284 mm of flatness error. The list of choices says which limit excludes each.
        Warn orientation-error: A side is 15° off the orientation that is asked for: A15 corrects it.
    "#]].assert_eq(&verdicts(&[("tool-start", "30"), ("relief", "3")]));
    expect![[r#"
        Fail flatness: The sides are uneven by 0.1338 mm; 0.1 mm are allowed.
        Warn insert-depth: Insert 2 is 0.1 mm off the tip circle: sides that it cuts alone are deeper by as much, or higher where that is negative. Reset it, or set all inserts to one radius.
        Warn insert-turn: Insert 2 turns its sides by 0.5° against where they belong.
    "#]].assert_eq(&verdicts(&[
        ("radius-errors", "0 0.1"),
        ("angle-errors", "0 1"),
    ]));
    // An insert that is short leaves its sides high, not hollow.
    assert_eq!(verdicts(&[("radius-errors", "0.01 -0.01")]), "");
    expect![[r#"
        Fail twist: G512 has whole D and Q only: the program turns the sides straight. While Z feeds, the twist needs the tool at 399.5 r/min in the passes before the last and at 399.75 r/min in the last one, because their feeds differ, and from the same angle in every pass; own-code.nc has it for a control with G51.2.
    "#]].assert_eq(&verdicts(&[("lead", "400")]));
    expect![[r#"
        Error across-flats: The finished part is 25 mm across flats; the stock has 24 mm: there is nothing to cut.
        Error start-x: The slide would start at 20 mm, inside the stock or its clearance: start at 28 mm or more.
    "#]]
    .assert_eq(&verdicts(&[("across-flats", "25"), ("start-x", "20"), ("depth", "0.01"), ("stock-diameter", "24")]));
    expect![[r#"
        Error tool-ratio: Q is 0: give a whole number other than 0.
        Error radius-errors: Give numbers from -1 to 1 with spaces between them, one for each of the 2 inserts at most.
        Error angle-errors: Give numbers from -10 to 10 with spaces between them, one for each of the 2 inserts at most.
    "#]]
    .assert_eq(&verdicts(&[("shape", "own"), ("tool-ratio", "0"), ("radius-errors", "0 0 9"), ("angle-errors", "x")]));
    // A preset whose sides are beyond their tolerance: no choice of cutter and ratio is within it.
    expect![[r#"
        Fail flatness: The sides are uneven by 0.2212 mm; 0.1 mm are allowed. No choice on this tip circle keeps within every limit: the flattest has 0.158 mm of flatness error. The list of choices says which limit excludes each.
    "#]].assert_eq(&verdicts(&[("shape", "triangle")]));
    // The relief is too small, so the insert would have to cut with its back.
    expect![[r#"
        Fail flatness: The sides are uneven by 1.8627 mm; 0.1 mm are allowed. Tips at a radius of 30.1 mm are flat enough at this ratio; enter the inertia of the larger disc too. No choice on this tip circle keeps within every limit: the flattest has 0.4928 mm of flatness error. The list of choices says which limit excludes each.
        Fail relief: In pass 3, to 54 mm, an insert would move back into its flank where it meets the work: no relief is enough. Take less depth of cut or a larger cutter.
        Warn slowest-cut: The inserts cut more slowly than they should: from 523 r/min for B on they do not.
        Fail distance: The axes would be nearer to each other than 20 mm.
        Fail reach: The body of the cutter touches the stock beside the polygon and overlaps it by 18 mm: the tips need an overhang of at least 20 mm, or the stock a diameter of at most 24 mm.
        Warn work-torque-effective: The strikes of the cut heat the drive of the work’s axis like 33.36 Nm without a pause, and its drive gives 31.51 Nm continuously at this speed: reduce feed or depth.
    "#]].assert_eq(&verdicts(&[("tip-radius", "2"), ("stock-diameter", "60"), ("start-x", "70")]));
    expect![[r#"
        Warn relief: Less than 2° of relief are left.
    "#]]
    .assert_eq(&verdicts(&[("relief", "5.5")]));
    expect![[r#"
        Warn slowest-cut: The inserts cut more slowly than they should: from 96 r/min for B on they do not.
    "#]]
    .assert_eq(&verdicts(&[("work-limit", "150"), ("speed", "40"), ("slowest-cut", "60")]));
    expect![[r#"
        Fail work-speed: The work axis turns 150 r/min at most: B may be 150 at most.
    "#]]
    .assert_eq(&verdicts(&[("work-limit", "150")]));
    expect![[r#"
        Fail distance: The axes would be nearer to each other than 70 mm.
        Fail feed: 100 mm/min is more than the 50 mm/min that the slide may feed: lower the feed or the speed.
    "#]]
    .assert_eq(&verdicts(&[("least-distance", "70"), ("clamp-z", "50")]));
    expect![[r#"
        Fail distance: The axes would be further apart than 50 mm.
        Error start-x: At the start the axes of work and cutter would be 75 mm apart, and the slide reaches 50 mm: start nearer.
    "#]]
    .assert_eq(&verdicts(&[("greatest-distance", "50"), ("across-flats", "24"), ("stock-diameter", "24.5")]));
    expect![[r#"
        Warn slowest-cut: The inserts cut more slowly than they should: from 64 r/min for B on they do not.
        Error depth: More than 60 passes: take more depth.
    "#]]
    .assert_eq(&verdicts(&[("depth", "0.01"), ("feed", "0.001"), ("speed", "1"), ("finish-feed", "0.001")]));
    expect![[r#"
        Fail tool-speed: The tool axis turns 2000 r/min at most: B may be 20 at most.
        Fail tool-run-up: The run-up asks 138.2 Nm of the tool, and its drive gives 6 Nm: the tool falls behind its ratio to the work. A longer ramp on both axes keeps them together, or a lower B. With such a ramp an emergency stop in ratio takes 6.9 s from full speed: the cutter turns as long, and so long the drives need their power. A lower B stops sooner.
        Error tool-ratio: This cutter leaves no section: it reaches the centre of the work, or there would be more than 1000 sides.
    "#]].assert_eq(&verdicts(&[("shape", "own"), ("inserts", "50"), ("tool-ratio", "99")]));
    expect![[r#"
        Fail flatness: The sides are uneven by 2.195 mm; 0.1 mm are allowed. Tool and work turn against each other: sides come out hollow. Give D and Q the same sign.
        Warn relief: The tips move over the work against the turning of the cutter: inserts have to face the other way.
        Fail curvature: The sides are hollow: 2.195 mm higher toward the corners than in the middle.
    "#]].assert_eq(&verdicts(&[("shape", "own"), ("inserts", "2"), ("tool-ratio", "-2"), ("stock-diameter", "30")]));
}

#[test]
fn cut_section_never_grows_and_ends_exact() {
    let shapes: [&[(&str, &str)]; 5] = [
        &[],
        &[("shape", "knob")],
        &[("shape", "triangle"), ("across-flats", "8"), ("stock-diameter", "11"), ("work-start", "20")],
        &[("shape", "hexagon"), ("stock-diameter", "24"), ("tool-start", "-40")],
        &STAR,
    ];
    for changes in shapes {
        let project = project(&[changes, &[("depth", "3"), ("preread", "3")]].concat());
        let planner = whole(&project);
        let end = planner.timeline().end();
        let frame = Frame { step: 0.001, drawing_option: false };
        let scene = project.prepared().scene();
        let mut left = f64::INFINITY;
        for at in 0..=400 {
            let now = Samples::at(&planner, end * f64::from(at) / 400.0);
            let pose = project.prepared().pose(&planner, &now, frame);
            let picture = svg::picture(&scene, &pose, Theme::Light);
            assert!(!picture.contains("NaN") && !picture.contains("inf") && !picture.contains('∞'), "{changes:?}");
            let now = area(&pose.paths[1].1);
            assert!(now < left * 1.002, "{changes:?}: {left} to {now} at {at}");
            left = now;
        }
        // The drawing has 74 units for the radius of the stock.
        let stock = !values(&[]).contains_key("stock-diameter");
        let radius: f64 = changes
            .iter()
            .find(|(id, _)| *id == "stock-diameter")
            .map_or(12.5, |(_, d)| d.parse::<f64>().unwrap() / 2.0);
        let scale = (74.0 / radius) * (74.0 / radius);
        let exact = value(&project, "area");
        assert!(stock && (left / scale / exact - 1.0).abs() < 2e-3, "{changes:?}: {} for {exact}", left / scale);
    }
}

#[test]
fn paper_program_cuts_and_coasting_behind_the_face_does_not() {
    let look = |project: &Project, t: f64| {
        let planner = planned(project);
        let frame = Frame { step: 0.001, drawing_option: false };
        let now = Samples::at(&planner, t);
        let pose = project.prepared().pose(&planner, &now, frame);
        (area(&pose.paths[1].1) * (12.5 / 74.0) * (12.5 / 74.0), pose.texts[3].1.clone())
    };
    let paper = edited(&[], PAPER);
    assert_eq!(look(&paper, 0.5).0.round(), 491.0, "the stock");
    let (left, pass) = look(&paper, 100.0);
    assert!((left / value(&paper, "area") - 1.0).abs() < 2e-3, "{left}");
    assert_eq!(pass, "1");
    // Stopped in the second pass: 21 mm across flats are left, and stay while the axes coast out of ratio.
    let mut stopped = project(&[("emergency", "off")]);
    stopped.panel.add(Event { t: 20.0, action: Action::EmergencyStop });
    let (before, pass) = look(&stopped, 19.9);
    assert_eq!(pass, "2 / 4");
    for t in [20.1, 20.7, 25.0] {
        assert!((look(&stopped, t).0 / before - 1.0).abs() < 1e-6, "{t}");
    }
}

#[test]
fn charts_and_drawings_show_the_check_table_values() {
    let project = project(&[("stock-diameter", "29")]);
    let planner = whole(&project);
    let charts = project.prepared().charts(&planner, 0.0, 10.0, 721);
    let ids: Vec<_> = charts.iter().map(|chart| chart.id).collect();
    assert_eq!(ids, ["size", "speeds", "phase", "along", "deviation", "radius"]);
    let deviation = &charts[4].series[0].points;
    let least = deviation.iter().map(|point| point.1).fold(f64::INFINITY, f64::min);
    // -0.049628 mm of the check table, at the corner.
    assert!((least + 49.628).abs() < 0.05 && deviation[0].1.abs() < 1e-6, "{least}");
    // The larger the tip circle, the flatter at ratio 2; twice 45 mm is beyond the table's 80 mm.
    let lowest = &charts[5].series[0].points;
    assert!(lowest.windows(2).all(|pair| pair[0].1 < pair[1].1) && lowest.last().unwrap().1 > -17.26);
    let files = project.export().into_files();
    let text = |name: &str| &files.iter().find(|file| file.name == name).unwrap_or_else(|| panic!("no {name}")).text;
    assert!(text("sequence.svg").contains("Reconstructed"));
    // Black without its colours.
    assert!(text("ladder.svg").contains("<style>"));
    assert!(text("report.md").contains("X20 is 20 mm across flats"));
}

#[test]
fn pasted_programs_run_on_the_polygon_lathe() {
    // The paper's listing as a bare file beside the macro programs, on the plant of the project.
    let plant = project(&[]);
    let mut files: Vec<File> = vec![File { name: "O3000.nc".to_owned(), text: PAPER.to_owned() }];
    files.extend(plant.written().files.0.into_iter().skip(1));
    let parsed = Rc::new(nc::parse_with(&Files(files), plant.control, &Switches::default()));
    let mut planner = run::of_programs(parsed, Some(&plant), Panel::default(), &begin());
    assert_eq!(planner.advance(f64::INFINITY, usize::MAX).ended, Some(RunEnd::ProgramEnd));
}

#[test]
fn taken_way_gives_the_figures_of_its_row() {
    let fixed = [("least-radius", "45"), ("greatest-radius", "45")];
    let wide = [("least-radius", "30"), ("greatest-radius", "60")];
    let cases: [&[(&str, &str)]; 8] = [
        // Six inserts at -1:5 break off a side just beside the radius that is found.
        &[("shape", "hexagon"), wide[0], wide[1], ("flatness", "0.5")],
        &[fixed[0], fixed[1]],
        &[("shape", "knob"), wide[0], wide[1], ("against", "true"), ("stock-diameter", "40"), ("overhang", "12")],
        &[("shape", "triangle"), ("across-flats", "8"), ("stock-diameter", "11"), wide[0], wide[1]],
        &[("shape", "own"), ("sides", "5"), wide[0], wide[1], ("hollow", "true"), ("stock-diameter", "35")],
        &[("shape", "own"), ("sides", "8"), ("across-flats", "33.3"), ("stock-diameter", "41"), ("relief", "5")],
        &[("shape", "own"), ("sides", "12"), ("least-radius", "3"), ("greatest-radius", "200"), ("speed", "3")],
        &[("tool-start", "37"), ("work-limit", "3"), ("tool-limit", "3"), ("depth", "0.2"), ("allowance", "0.7")],
    ];
    let mut rows = 0;
    for changes in cases {
        let first = project(changes);
        let sheets = first.prepared().sheets();
        let ways = &sheets.iter().find(|sheet| sheet.id == "choices").unwrap().rows;
        assert!(!ways.is_empty());
        for way in ways {
            let sets: Vec<(&str, &str)> = way.entries.iter().map(|entry| (entry.field, entry.text.as_str())).collect();
            let taken = project(&[changes, &sets[..]].concat()).design();
            let shown = |id: &str, decimals: u8| {
                let readout = taken.readouts.iter().find(|row| row.id == id).unwrap();
                number_text(readout.value, decimals)
            };
            let [slowest, fastest] = ["slowest-cut", "fastest-cut"].map(|id| shown(id, 0));
            let expected = [
                shown("flatness", 4),
                shown("deviation-low", 4),
                shown("deviation-high", 4),
                shown("relief", 2),
                shown("work-speed", 0),
                shown("tool-speed", 0),
                format!("{slowest}–{fastest}"),
            ];
            let row: Vec<&String> = [4].into_iter().chain(6..12).map(|at| &way.cells[at]).collect();
            assert_eq!(row, expected.iter().collect::<Vec<_>>(), "{changes:?} {sets:?}");
            // A choice that is shown as possible stays within all of its limits, except the torque of the cut, which follows from the feed.
            let failed = taken
                .readouts
                .iter()
                .find(|row| row.verdict == Verdict::Fail && !row.id.contains("torque") && !row.id.contains("power"));
            assert_eq!(failed.map(|row| row.id).filter(|_| way.cells[5] == "nothing"), None, "{changes:?} {sets:?}");
            rows += 1;
        }
    }
    assert!(rows > 100, "{rows}");
}

#[test]
fn explorer_has_fixed_sliders_and_a_section_where_one_exists() {
    let look = |changes: &[(&str, &str)]| {
        let project = project(changes);
        project.prepared().explorer(0).unwrap()
    };
    let square = look(&[]);
    let fields: Vec<&str> = square.sliders.iter().map(|knob| knob.field).collect();
    assert_eq!(fields, ["sides", "inserts", "work-ratio", "tool-ratio", "tip-radius"]);
    for knob in &square.sliders {
        assert!(knob.range.0 <= knob.value && knob.value <= knob.range.1, "{knob:?}");
        // Each slider alone, with its dependent entries, at both of its ends.
        for end in [knob.range.0, knob.range.1] {
            let text = end.to_string();
            let along = knob.along.iter().map(|entry| (entry.field, entry.text.as_str()));
            let changed = look(&along.chain([(knob.field, text.as_str())]).collect::<Vec<_>>());
            assert!(changed.sliders.iter().map(|knob| knob.field).eq(fields.iter().copied()));
            assert_eq!(changed.sliders.iter().find(|other| other.field == knob.field).unwrap().value, end);
            assert_eq!(changed.charts.len(), 1, "{}", knob.field);
            assert_eq!(changed.scene == square.scene, end == knob.value, "{} {end}", knob.field);
        }
    }
    // Nothing turns: the stock is left, and nothing is counted.
    let none = look(&[("shape", "own"), ("tool-ratio", "0")]);
    assert!(none.charts.is_empty() && !none.scene.nodes.is_empty());
    let ribbon = Project::of("ribbon-line", None).unwrap();
    assert!(ribbon.prepared().explorer(0).is_none());
}

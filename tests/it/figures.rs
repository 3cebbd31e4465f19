//! The figures of the ribbon line, by running the program that the project exports, on every control.

use macroline::controls::Dialect;
use macroline::controls::interface::SignalRole;
use macroline::controls::syntax::Percent;
use macroline::machines::form::Value;
use macroline::motion::{Budget, Retention, RunEnd};
use macroline::nc::{self, File, Files};
use macroline::project::Project;
use macroline::project::export::{ExportFile, ExportOptions, FileRole};
use macroline::project::run::{self, RunOptions, RunSummary};
use proptest::prelude::*;

use crate::queries::near_share;

fn controls() -> &'static [&'static str] {
    macroline::machines::find("ribbon-line").unwrap().controls()
}

/// The paper's example with the exact π.
fn ribbon(values: &[(&str, f64)]) -> Project {
    ribbon_on(controls()[0], values)
}

fn ribbon_on(control: &str, values: &[(&str, f64)]) -> Project {
    let mut project = Project::named("ribbon-line", Some(control), Some("paper")).unwrap();
    choose(&mut project, "pi", "exact");
    for (id, value) in values {
        project.values.insert((*id).to_owned(), Value::Number(*value));
    }
    project
}

fn choose(project: &mut Project, id: &str, option: &str) {
    project.values.insert(id.to_owned(), Value::Text(option.to_owned()));
}

/// Runs the exported files of a project to their end.
#[track_caller]
fn run(project: &Project) -> RunSummary {
    let written = project.written();
    let errors: Vec<_> =
        written.diagnostics.iter().filter(|d| d.severity == macroline::text::Severity::Error).collect();
    assert!(errors.is_empty(), "{errors:?}");
    let limits = Budget { blocks: 100_000_000, seconds: 1e9 };
    let mut planner =
        run::of_project(project, &written, &RunOptions { start: None, settings: &[], limits, keep: Retention::Log });
    run::to_end(&mut planner, run::AtStop::End, |_| Ok::<(), ()>(())).unwrap()
}

fn variable(outcome: &RunSummary, name: &str) -> f64 {
    outcome.variables.iter().find(|(key, _)| key[1..] == name[1..]).unwrap_or_else(|| panic!("no {name}")).1
}

/// The position of the override switch that is nearest to a percentage, where the control takes it as a code.
fn switched(project: &Project, percent: f64) -> f64 {
    let coded = project.control.interface.iter().any(|row| row.role == SignalRole::SpindleOverrideCode);
    if coded { project.control.spindle.knob.nearest(percent) } else { percent }
}

#[test]
fn exported_text_reproduces_the_override_table() {
    // Override %, r/min, then with 3.14 and with exact π: line speed, vector feed in mm/min, block time in ms; volts.
    let table = [
        (10.0, 120.0, 1507.200, 11927.134, 318.471, 1507.964, 11939.139, 318.310, 0.811),
        (50.0, 600.0, 7536.000, 59635.668, 63.694, 7539.822, 59695.697, 63.662, 4.054),
        (80.0, 960.0, 12057.600, 95417.069, 39.809, 12063.716, 95513.115, 39.789, 6.486),
        (100.0, 1200.0, 15072.000, 119271.337, 31.847, 15079.645, 119391.393, 31.831, 8.108),
        (110.0, 1320.0, 16579.200, 131198.470, 28.952, 16587.609, 131330.533, 28.937, 8.919),
        (120.0, 1440.0, 18086.400, 143125.604, 26.539, 18095.574, 143269.672, 26.526, 9.730),
        (123.0, 1476.0, 18538.560, 146703.744, 25.892, 18547.963, 146851.414, 25.879, 9.973),
        // Above 123.3 % spindle and program are at the clamp.
        (124.0, 1480.0, 18588.800, 147101.315, 25.822, 18598.229, 147249.385, 25.809, 10.0),
        (200.0, 1480.0, 18588.800, 147101.315, 25.822, 18598.229, 147249.385, 25.809, 10.0),
    ];
    for (percent, rpm, v314, f314, t314, v, f, t, volts) in table {
        let forms = [("3.14", v314, f314, t314), ("exact", v, f, t)];
        for (control, (pi, speed, feed, time)) in controls().iter().flat_map(|id| forms.map(|form| (id, form))) {
            let mut project = ribbon_on(control, &[("pitch-count", 3.0), ("override", percent), ("knob-lowest", 10.0)]);
            if switched(&project, percent) != percent {
                continue;
            }
            choose(&mut project, "pi", pi);
            if project.control.limits.feed_max < feed {
                choose(&mut project, "feed-form", "per-revolution");
                project.values.insert("spindle-encoder".to_owned(), Value::Flag(true));
            }
            let out = run(&project);
            near_share(variable(&out, "#104"), rpm, 1e-12);
            assert!((variable(&out, "#105") - speed).abs() < 6e-4, "{control} {percent} {pi} #105");
            assert!((variable(&out, "#115") - feed).abs() < 6e-4, "{control} {percent} {pi} #115");
            let design = project.design();
            let value = |id| design.readouts.iter().find(|r| r.id == id).unwrap().value;
            assert!((value("block-time") - time).abs() < 6e-4, "{percent} {pi} block time");
            assert!((value("volts-command") - volts).abs() < 6e-4, "{percent} {pi} volts");
        }
    }
}

#[test]
fn analog_volts_while_printing_match_the_design() {
    let project = ribbon(&[("pitch-count", 100.0)]);
    let written = project.written();
    let limits = Budget { blocks: 1_000_000, seconds: 100.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut planner = run::of_project(&project, &written, &begin);
    planner.advance(4.5, usize::MAX);
    let now = planner.timeline().at(4.0);
    near_share(now.spindle.volts_command, 8.108108, 1e-6);
    assert_eq!((now.spindle.volts * 1000.0).round(), 8107.0);
    // Y is rounded to 62.832 in this block, which takes 2.3e-6 of the vector.
    near_share(now.axes[0].feed, 15079.644737, 3e-6);
}

#[test]
fn exported_programs_follow_the_control_syntax() {
    for (control, crlf) in controls().iter().flat_map(|id| [(id, false), (id, true)]) {
        let mut project = ribbon_on(control, &[]);
        choose(&mut project, "newline", if crlf { "crlf" } else { "lf" });
        project.values.insert("customer".to_owned(), Value::Text("Müller & Söhne (№ 1) %".to_owned()));
        let export = project.export();
        let named = project.control.syntax.names.is_some();
        let wanted =
            if named { ["L9100.SPF", "MPF9101.MPF", "MPF9102.MPF"] } else { ["O9100.nc", "O9101.nc", "O9102.nc"] };
        let programs: Vec<_> =
            export.files.iter().map(|exported| &exported.file).filter(|f| wanted.contains(&f.name.as_str())).collect();
        assert_eq!(programs.iter().map(|f| f.name.as_str()).collect::<Vec<_>>(), wanted);
        for file in programs {
            let read = nc::parse(&Files::one(&file.name, file.text.as_str()), project.control);
            assert!(read.diagnostics().is_empty(), "{:?}", read.diagnostics());
            let end = if crlf { "\r\n" } else { "\n" };
            let (begin, last) = match project.control.syntax.percent {
                Percent::Both => (format!("%{end}O9"), format!("{end}%{end}")),
                Percent::End => ("O9".to_owned(), format!("{end}%{end}")),
                Percent::Head => (format!("%_N_{}_", file.name.split('.').next().unwrap()), end.to_owned()),
            };
            assert!(file.text.starts_with(&begin) && file.text.ends_with(&last), "{}", file.name);
            assert!(file.text.is_ascii() && file.text == file.text.to_uppercase());
            assert_eq!(file.text.matches('\r').count(), if crlf { file.text.lines().count() } else { 0 });
            for line in file.text.lines() {
                assert!(line.len() < 80, "{}: {line}", file.name);
                let comment = line.split_once('(').map_or(0, |(_, tail)| tail.len() - 1);
                assert!(named || comment <= 31, "{}: {line}", file.name);
            }
        }
    }
}

#[test]
fn dropped_program_restores_the_whole_project() {
    let values = [("pitch", 12.5), ("heads", 47.0), ("clamp-x", 25_000.0), ("pitches-per-block", 4.0)];
    let present = ribbon(&[]);
    for control in controls() {
        let mut project = ribbon_on(control, &values);
        choose(&mut project, "y-unit", "degrees");
        for file in project.written().files.0 {
            let opened = macroline::project::import::open(&present, std::slice::from_ref(&file));
            let restored = opened.project.unwrap();
            assert!(restored.control.id == *control && restored.values == project.values, "{}", file.name);
            assert!(restored.edited.is_none());
        }
    }
}

#[test]
fn dropped_edited_program_keeps_its_edit() {
    let project = ribbon(&[("pitch", 12.5)]);
    let file = project.written().files.0.into_iter().find(|f| f.name == "O9101.nc").unwrap();
    let text = file.text.replace("G04 X2.", "G04 X3.");
    assert_ne!(text, file.text);
    let opened =
        macroline::project::import::open(&ribbon(&[]), &[File { name: "dropped.nc".to_owned(), text: text.clone() }])
            .project
            .unwrap();
    assert!(opened.values == project.values);
    let written = opened.written();
    assert!(written.edited && written.files.0.len() == 3);
    assert!(written.files.0.iter().any(|f| f.name == "O9101.nc" && f.text == text));
}

#[test]
fn the_written_programs_are_exported() {
    let project = ribbon(&[]);
    let mut written = project.written();
    written.files.0[0].text.push_str("(THIS VERY TEXT)\n");
    let export = project.export_with(&written, &ExportOptions::default());
    let is_program = |exported: &&ExportFile| matches!(exported.role, FileRole::Program(_));
    let programs: Vec<_> = export.files.iter().take_while(is_program).map(|exported| exported.file.clone()).collect();
    assert_eq!(programs, written.files.0);
    assert_eq!(programs.len() + export.documents().count(), export.files.len());
}

#[test]
fn errors_refuse_export_and_failed_verdicts_allow_it() {
    assert!(!ribbon(&[]).export().files.is_empty(), "the paper's own example fails the slip rule and is exported");
    for (field, value) in
        [("pitch", 0.0), ("pitch", -8.0), ("heads", 0.0), ("reduction-ratio", f64::INFINITY), ("clamp-y", 1000.0)]
    {
        let export = ribbon(&[(field, value)]).export();
        assert!(export.files.is_empty(), "{field} {value}");
        assert!(export.diagnostics.iter().any(|d| d.severity == macroline::text::Severity::Error), "{field} {value}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn run_of_exported_program_equals_closed_form(
        speed in 100u32..1480, ratio in 5.0..60.0f64, press in 40.0..200.0f64, pitch in 2.0..60.0f64, heads in 1u32..60,
        roller in 20.0..300.0f64, count in 1u32..60, per_block in 1u32..9, percent in 10u32..120, degrees: bool,
        control in proptest::sample::select(controls()),
    ) {
        let round = |x: f64| (x * 1000.0).round() / 1000.0;
        let (press, pitch, roller) = (round(press), round(pitch), round(roller));
        let mut project = ribbon_on(control, &[
            ("spindle-speed", f64::from(speed)), ("reduction-ratio", round(ratio)), ("press-roller-diameter", press), ("pitch", pitch),
            ("heads", f64::from(heads)), ("print-roller-diameter", roller), ("pitch-count", f64::from(count)),
            ("pitches-per-block", f64::from(per_block)), ("override", f64::from(percent)), ("knob-lowest", 10.0),
            ("clamp-x", 1e6), ("clamp-y", 1e6), ("rapid-x", 1e6), ("rapid-y", 1e6), ("loop-capacity", 1e5), ("pinch-force", 2000.0),
        ]);
        choose(&mut project, "y-unit", if degrees { "degrees" } else { "mm" });
        // A reduction ratio that keeps F within the range of the control.
        let feed = project.design().readouts.iter().find(|row| row.id == "vector-feed").unwrap().value;
        let ratio = round(ratio * (feed / project.control.limits.feed_max * 1.01).max(1.0));
        project.values.insert("reduction-ratio".to_owned(), Value::Number(ratio));
        let diagnostics = project.design().diagnostics;
        prop_assert!(diagnostics.iter().all(|d| d.severity == macroline::text::Severity::Info), "{:?}", diagnostics);
        let out = run(&project);
        prop_assert!(matches!(out.ended, RunEnd::ProgramEnd), "{:?}", out.ended);
        let n = (f64::from(speed) * switched(&project, f64::from(percent)) / 100.0).min(1480.0);
        let v = core::f64::consts::PI * press / ratio * n;
        let y = if degrees { 360.0 } else { core::f64::consts::PI * roller } / f64::from(heads);
        let close = |got: f64, want: f64| (got - want).abs() <= 2e-9 * want;
        prop_assert!(close(variable(&out, "#104"), n));
        prop_assert!(close(variable(&out, "#105"), v));
        prop_assert!(close(variable(&out, "#110"), y));
        prop_assert!(close(variable(&out, "#115"), v * (pitch * pitch + y * y).sqrt() / pitch));
        let count = f64::from(count);
        let at = |letter: char| out.axes.iter().find(|axis| axis.0 == letter).unwrap().1;
        let words = if Dialect::resolve(project.control, &project.switches).counts_diameters(0) { 2.0 } else { 1.0 };
        prop_assert!((at('X') - words * pitch * count).abs() < 1e-6, "X {}", at('X'));
        prop_assert!((at('Y') - y * count).abs() <= 0.001 + 1e-6, "Y {} of {}", at('Y'), y * count);
    }
}

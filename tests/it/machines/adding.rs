//! `docs/adding-a-machine.md`, followed once: functions that a new machine gets without further work.

use std::sync::Mutex;
use std::sync::atomic::Ordering;

use macroline::controls;
use macroline::machines::form::Value;
use macroline::machines::program::settings;
use macroline::machines::{AnyMachine, Erased, Frame, Samples};
use macroline::motion::{Budget, Retention, RunEnd};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};
use macroline::text::Severity;
use macroline::view::Verdict;

use super::toy::{CutToLength, PREPARED};

static FEEDER: Erased<CutToLength> = Erased::new();

const OPTIONS: RunOptions = RunOptions {
    start: None,
    settings: &[],
    limits: Budget { blocks: 10_000, seconds: 60.0 },
    keep: Retention::Timeline,
};

/// The counter of preparations is shared: tests that prepare the toy run one after the other.
static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());

fn project(control: &str) -> Project {
    Project::new(&FEEDER, controls::find(control).unwrap())
}

#[test]
fn a_change_of_a_value_prepares_the_machine_once() {
    let _alone = ONE_AT_A_TIME.lock().unwrap();
    let mut project = project("mitsubishi-e60");
    let count = || PREPARED.load(Ordering::Relaxed);
    for length in [50.0, 60.0, 70.0] {
        project.values.insert("length".to_owned(), Value::Number(length));
        let before = count();
        let (design, written) = (project.design(), project.written());
        let mut run = run::of_project(&project, &written, &OPTIONS);
        run::to_end(&mut run, run::AtStop::End, |_| Ok::<(), ()>(())).unwrap();
        let machine = project.prepared();
        let end = run.timeline().end();
        for at in 0..20 {
            let now = Samples::at(&run, end * f64::from(at) / 20.0);
            machine.pose(&run, &now, Frame { step: 0.01, drawing_option: false });
        }
        assert!(!machine.charts(&run, 0.0, end, 50).is_empty() && !design.readouts.is_empty());
        assert!(!project.export().files.is_empty());
        assert!(project.clone().prepared().hidden().is_empty());
        assert_eq!(count() - before, 1, "length {length}");
    }
    // Another name changes no result.
    let before = count();
    project.name = "renamed".to_owned();
    project.design();
    assert_eq!(count(), before);
}

#[test]
fn the_program_runs_on_every_control_of_the_list() {
    let _alone = ONE_AT_A_TIME.lock().unwrap();
    for control in FEEDER.controls() {
        let project = project(control);
        let written = project.written();
        let found: Vec<_> = written.diagnostics.iter().cloned().chain(project.advice(&written)).collect();
        assert!(found.is_empty(), "{control}: {found:#?}");
        let mut run = run::of_project(&project, &written, &OPTIONS);
        let outcome = run::to_end(&mut run, run::AtStop::End, |_| Ok::<(), ()>(())).unwrap();
        assert!(matches!(outcome.ended, RunEnd::ProgramEnd), "{control}: {:?}", outcome.diagnostics);
        // Four pieces of 50 mm.
        let (_, z) = outcome.axes.iter().find(|(axis, _)| *axis == 'Z').unwrap();
        assert!((z - 200.0).abs() < 1e-9, "{control}: {z}");
        // `4 t`, and a little for the blocks.
        let piece = project.design().readouts.iter().find(|row| row.id == "piece-time").unwrap().value;
        assert!((outcome.time - 4.0 * piece).abs() < 0.5, "{control}: {} s, {} s", outcome.time, 4.0 * piece);
    }
}

#[test]
fn form_checks_report_export_and_charts_appear() {
    let _alone = ONE_AT_A_TIME.lock().unwrap();
    let mut project = project("gsk-980tdc");
    // The form, with checks of its ranges.
    let fields = FEEDER.fields();
    let length = fields.iter().find(|field| field.id == "length").unwrap();
    assert!(
        length.essential && length.read_metric("0").is_err() && length.read_metric("12,5") == Ok(Value::Number(12.5))
    );
    // A rule of its own is a verdict; a value out of range is an error, and refuses the export.
    project.values.insert("speed".to_owned(), Value::Number(12_000.0));
    assert_eq!(project.design().readouts.iter().map(|row| row.verdict).max(), Some(Verdict::Fail));
    let export = project.export();
    let names: Vec<&str> = export.files.iter().map(|exported| &exported.file).map(|file| file.name.as_str()).collect();
    for name in ["report.md", "parameters.csv", "project.json"] {
        assert!(names.contains(&name), "{names:?}");
    }
    let programs: Vec<&str> = export
        .files
        .iter()
        .map(|exported| &exported.file)
        .map(|file| &file.text[..])
        .filter(|text| text.contains("M30"))
        .collect();
    assert!(programs.iter().all(|text| text.contains("MACROLINE CUT-TO-LENGTH 1")) && programs.len() >= 2, "{names:?}");
    let report = export.files.iter().map(|exported| &exported.file).find(|file| file.name == "report.md").unwrap();
    assert!(report.text.contains("mm/min") && report.text.contains("60 L / v + τ + t cut"), "{}", report.text);
    project.values.insert("length".to_owned(), Value::Number(-1.0));
    assert!(project.export().files.is_empty());
    assert!(project.design().diagnostics.iter().any(|d| d.severity == Severity::Error));
}

#[test]
fn a_project_is_saved_and_a_program_restores_its_form() {
    let _alone = ONE_AT_A_TIME.lock().unwrap();
    let mut project = project("knd-k2000t");
    project.name = "strips".to_owned();
    for (id, value) in [("length", Value::Number(12.5)), ("feed", Value::Text("rapid".to_owned()))] {
        project.values.insert(id.to_owned(), value);
    }
    let loaded = Project::from_json_among(&[&FEEDER], &project.to_json());
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    assert!(loaded.project == Some(project.clone()));
    assert!(Project::from_json(&project.to_json()).project.is_none(), "the toy is no machine of the list");
    for file in project.written().files.0 {
        let found = settings::read_among(&[&FEEDER], &file.text).unwrap();
        assert_eq!((found.machine, found.control), ("cut-to-length", "knd-k2000t"));
        assert_eq!(found.values.get("length"), Some(&Value::Number(12.5)));
        assert_eq!(found.values.get("feed"), Some(&Value::Text("rapid".to_owned())));
    }
}

//! Programs run: canonical logs of the fixtures of every control, and alarms at their places.

mod axis_words;
mod coverage;
mod data_input;
mod fixing;
mod hole_cycles;
mod options_act;
mod parameters;
mod precheck;
mod running;
mod spindle;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use expect_test::{Expect, expect_file};
use macroline::controls::{self, Control, Switches};
use macroline::interp::world::MachineAtRest;
use macroline::interp::{self, End, Interp, StartProgram};
use macroline::nc::{self, Files};
use macroline::text::catalog::sentence;
use macroline::text::{Diagnostic, LineIndex, Severity};

/// Blocks after which a test program counts as endless.
const BUDGET: u64 = 100_000;

fn start_on(control: &'static Control, source: &str, switches: &[(&str, &str)]) -> Interp {
    let switches = Switches(switches.iter().map(|(id, value)| (id.to_string(), value.to_string())).collect());
    let parsed = nc::parse_with(&Files::one("test.nc", source), control, &switches);
    Interp::new(Rc::new(parsed), StartProgram::First)
}

/// On the control that most of these programs are written for.
fn start(source: &str, switches: &[(&str, &str)]) -> Interp {
    start_on(controls::find("mitsubishi-e60").unwrap(), source, switches)
}

/// A text as a comment of the control.
fn comment(control: &Control, text: &str) -> String {
    if control.syntax.names.is_some() { format!(";{text}") } else { format!("({text})") }
}

/// The switches that comments `SET id value` of a fixture name.
fn settings(source: &str) -> Vec<(&str, &str)> {
    let settings = source.lines().filter_map(|line| {
        let text = line.strip_prefix(';').or_else(|| line.strip_prefix('(')?.strip_suffix(')'))?;
        text.strip_prefix("SET ")?.split_once(' ')
    });
    settings.collect()
}

/// Interpreter of a fixture, with the switches that the fixture sets.
fn start_fixture(control: &'static Control, source: &str) -> Interp {
    let settings = settings(source);
    for (id, value) in &settings {
        let row = control.switch(id);
        assert!(row.is_some_and(|row| row.takes(value)), "{} has no switch {id} with {value}", control.id);
    }
    start_on(control, source, &settings)
}

/// The override knob at 100 %, X at 12.5 mm where a program reads them.
fn world() -> MachineAtRest {
    MachineAtRest {
        inputs: vec![(1033, 100.0)],
        positions: [12.5, 2.0, 0.0, 0.0, 0.0, 0.0],
        block_skip: false,
        ..MachineAtRest::default()
    }
}

/// `P283 3:5`
fn alarm_and_place(source: &str, diagnostic: &Diagnostic) -> String {
    let at = diagnostic.place.map_or(0, |place| place.span.start);
    let position = LineIndex::new(source).position(source, at);
    format!("{} {}:{}", diagnostic.alarm.as_deref().unwrap_or("none"), position.line, position.column)
}

/// The canonical log of a program, and how it ended.
fn log_of(source: &str, interp: &mut Interp) -> String {
    let mut log = String::new();
    for finding in interp.parsed().diagnostics().iter().filter(|finding| finding.severity == Severity::Error) {
        writeln!(log, "({} {})", alarm_and_place(source, finding), sentence(&finding.message)).unwrap();
    }
    let names = interp.names();
    let mut world = world();
    let end = interp::run(interp, &mut world, BUDGET, |canon, _| writeln!(log, "{}", canon.line(names)).unwrap());
    world.remarks.dedup();
    for remark in &world.remarks {
        writeln!(log, "({} {})", alarm_and_place(source, remark), sentence(&remark.message)).unwrap();
    }
    match end {
        None => log.push_str("= budget\n"),
        Some(End::Program) => {}
        Some(End::Alarm(diagnostic)) => {
            writeln!(log, "= {} {}", alarm_and_place(source, &diagnostic), sentence(&diagnostic.message)).unwrap();
            for hint in &diagnostic.hints {
                writeln!(log, "  {}", sentence(hint)).unwrap();
            }
        }
    }
    log
}

#[track_caller]
fn check(source: &str, expected: Expect) {
    expected.assert_eq(&log_of(source, &mut start(source, &[])));
}

#[track_caller]
fn check_switched(source: &str, switch: (&str, &str), expected: Expect) {
    expected.assert_eq(&log_of(source, &mut start(source, &[switch])));
}

/// The fixtures of a control, with their sources.
pub(crate) fn fixtures(control: &Control, folder: &str) -> Vec<(PathBuf, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/programs").join(control.id).join(folder);
    let files = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<PathBuf> = files.filter(|path| path.extension().is_some_and(|ext| ext == "nc")).collect();
    files.sort();
    assert!(!files.is_empty(), "no fixtures in {}", folder.display());
    files.into_iter().map(|path| (path.clone(), std::fs::read_to_string(path).unwrap())).collect()
}

#[test]
fn good_programs_give_their_canonical_log() {
    for control in controls::ALL {
        for (path, source) in fixtures(control, "ok") {
            let log = log_of(&source, &mut start_fixture(control, &source));
            expect_file![path.with_extension("canon")].assert_eq(&log);
        }
    }
}

/// A log that ends in an alarm checks none of the blocks behind it, although its test passes.
#[test]
fn good_programs_end_without_an_alarm_of_the_control() {
    let mut wrong = Vec::new();
    for control in controls::ALL {
        for (path, source) in fixtures(control, "ok") {
            let raises_its_own = source.contains("#3000=");
            let log = log_of(&source, &mut start_fixture(control, &source));
            if let Some(line) = log.lines().find(|line| line.starts_with("= ")).filter(|_| !raises_its_own) {
                wrong.push(format!("{}: {line}", path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn bad_programs_raise_the_alarm_of_their_first_line() {
    let mut wrong = Vec::new();
    for control in controls::ALL {
        for (path, source) in fixtures(control, "bad") {
            let mut interp = start_fixture(control, &source);
            let parsed = Rc::clone(interp.parsed());
            let raised = match parsed.diagnostics().iter().find(|finding| finding.severity == Severity::Error) {
                Some(finding) => alarm_and_place(&source, finding),
                None => match interp::run(&mut interp, &mut world(), BUDGET, |_, _| {}) {
                    Some(End::Alarm(diagnostic)) => alarm_and_place(&source, &diagnostic),
                    end => format!("{end:?}"),
                },
            };
            let first = source.lines().next().unwrap_or("");
            let raised = comment(control, &raised);
            if first != raised {
                let name = path.file_name().unwrap().display();
                wrong.push(format!("{} {name}: expected {first}, got {raised}", control.id));
            }
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

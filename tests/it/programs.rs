//! Programs run: canonical logs of the fixtures of every control, and alarms at their places.

mod random;
mod running;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use expect_test::{Expect, expect, expect_file};
use macroline::controls::{self, Alarm, Code, CodeDef, Control, Switches};
use macroline::interp::world::Still;
use macroline::interp::{self, End, Interp, Start};
use macroline::nc::{self, Files};
use macroline::text::catalog::{Language, sentence};
use macroline::text::{Diagnostic, LineIndex, Severity};

/// Blocks after which a test program counts as endless.
const BUDGET: u64 = 100_000;

fn start_on(control: &'static Control, source: &str, switches: &[(&str, &str)]) -> Interp {
    let parsed = nc::parse(&Files::one("test.nc", source), control);
    let switches = Switches(switches.iter().map(|(id, value)| (id.to_string(), value.to_string())).collect());
    Interp::new(Rc::new(parsed), Start::First, &switches)
}

/// On the control that most of these programs are written for.
fn start(source: &str, switches: &[(&str, &str)]) -> Interp {
    start_on(controls::find("mitsubishi-e60").unwrap(), source, switches)
}

/// A fixture, with the switches that its lines `(SET id value)` name.
fn start_fixture(control: &'static Control, source: &str) -> Interp {
    let settings = source.lines().filter_map(|line| line.strip_prefix("(SET ")?.strip_suffix(')')?.split_once(' '));
    let settings: Vec<(&str, &str)> = settings.collect();
    for (id, value) in &settings {
        let row = control.switches.iter().find(|row| row.id == *id);
        assert!(row.is_some_and(|row| row.takes(value)), "{} has no switch {id} with {value}", control.id);
    }
    start_on(control, source, &settings)
}

/// The override knob at 100 %, X at 12.5 mm when the machine is asked.
fn world() -> Still {
    Still { inputs: vec![(1033, 100.0)], positions: [12.5, 2.0, 0.0, 0.0, 0.0, 0.0], block_skip: false }
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
        writeln!(log, "({} {})", alarm_and_place(source, finding), sentence(Language::English, &finding.message))
            .unwrap();
    }
    let names = interp.names();
    let end = interp::run(interp, &mut world(), BUDGET, |canon, _| writeln!(log, "{}", canon.line(names)).unwrap());
    match end {
        None => log.push_str("= budget\n"),
        Some(End::Program) => {}
        Some(End::Alarm(diagnostic)) => {
            writeln!(
                log,
                "= {} {}",
                alarm_and_place(source, &diagnostic),
                sentence(Language::English, &diagnostic.message)
            )
            .unwrap();
            for hint in &diagnostic.hints {
                writeln!(log, "  {}", sentence(Language::English, hint)).unwrap();
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
fn fixtures(control: &Control, folder: &str) -> Vec<(PathBuf, String)> {
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

#[test]
fn bad_programs_stop_with_the_alarm_at_the_place_of_their_first_line() {
    let mut wrong = Vec::new();
    for control in controls::ALL {
        for (path, source) in fixtures(control, "bad") {
            let mut interp = start_fixture(control, &source);
            let parsed = Rc::clone(interp.parsed());
            let told = match parsed.diagnostics().iter().find(|finding| finding.severity == Severity::Error) {
                Some(finding) => alarm_and_place(&source, finding),
                None => match interp::run(&mut interp, &mut world(), BUDGET, |_, _| {}) {
                    Some(End::Alarm(diagnostic)) => alarm_and_place(&source, &diagnostic),
                    end => format!("{end:?}"),
                },
            };
            let first = source.lines().next().unwrap_or("");
            if first != format!("({told})") {
                let name = path.file_name().unwrap().display();
                wrong.push(format!("{} {name}: expected {first}, got ({told})", control.id));
            }
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

/// What no text can bring about.
const NOT_FROM_TEXT: [Alarm; 3] = [Alarm::Budget, Alarm::SoftLimit, Alarm::EmergencyStop];

#[test]
fn each_alarm_has_a_program_that_raises_it() {
    let mut missing = Vec::new();
    for control in controls::ALL {
        let bad = fixtures(control, "bad");
        let rows = control.alarms.iter().filter(|row| !NOT_FROM_TEXT.contains(&row.kind));
        for number in rows.map(|row| row.number) {
            if !bad.iter().any(|(_, source)| source.starts_with(&format!("({number} "))) {
                missing.push(format!("{} {number}", control.id));
            }
        }
    }
    missing.dedup();
    // The lathe controls are not covered in full yet: this list is to become empty.
    expect![[r#"
        gsk-980tdc 0001
        gsk-980tdc 0002
        gsk-980tdc 0003
        gsk-980tdc 0006
        gsk-980tdc 0010
        gsk-980tdc 0012
        gsk-980tdc 0018
        gsk-980tdc 0023
        gsk-980tdc 0037
        gsk-980tdc 0041
        gsk-980tdc 0043
        gsk-980tdc 0096
        gsk-980tdc 0097
        gsk-980tdc 0101
        gsk-980tdc 0102
        gsk-980tdc 0103
        gsk-980tdc 0104
        gsk-980tdc 0106
        gsk-980tdc 0107
        gsk-980tdc 0108
        gsk-980tdc 0109
        gsk-980tdc 0110
        gsk-980tdc 0111
        gsk-980tdc 0112
        gsk-980tdc 0113
        gsk-980tdc 0114
        gsk-980tdc 0116
        gsk-980tdc 0117
        gsk-980tdc 0118
        gsk-980tdc 0120
        gsk-980tdc 0122
        gsk-980tdc 0124
        gsk-980tdc 0125
        gsk-980tdc 0126
        gsk-980tdc 0127
        gsk-980tdc 5900
        gsk-980tdc END
        knd-k2000t 003
        knd-k2000t 004
        knd-k2000t 005
        knd-k2000t 007
        knd-k2000t 009
        knd-k2000t 010
        knd-k2000t 011
        knd-k2000t 020
        knd-k2000t 023
        knd-k2000t 076
        knd-k2000t 077
        knd-k2000t 078
        knd-k2000t 110
        knd-k2000t 111
        knd-k2000t 114
        knd-k2000t 115
        knd-k2000t 116
        knd-k2000t 118
        knd-k2000t 119
        knd-k2000t 124
        knd-k2000t 126
        knd-k2000t 127
        knd-k2000t 128
        knd-k2000t 129
        knd-k2000t 3000
        knd-k2000t 5010"#]]
    .assert_eq(&missing.join("\n"));
}

#[test]
fn each_code_that_is_acted_on_stands_in_a_good_program() {
    let acted = |row: &&CodeDef| !matches!(row.code, Code::NotSimulated | Code::Cancel);
    let mut missing = Vec::new();
    for control in controls::ALL {
        let good = fixtures(control, "ok");
        for row in control.codes.iter().filter(acted) {
            let number = f64::from(row.number) / 10.0;
            let spelled = [format!("{}{number}", row.letter as char), format!("{}{number:02}", row.letter as char)];
            let stands = |source: &String| {
                spelled.iter().any(|code| {
                    let behind =
                        source.match_indices(code.as_str()).map(|(at, _)| source[at + code.len()..].chars().next());
                    behind.into_iter().any(|c| !c.is_some_and(|c| c.is_ascii_digit() || c == '.'))
                })
            };
            if !good.iter().any(|(_, source)| stands(source)) {
                missing.push(format!("{} {}", control.id, spelled[0]));
            }
        }
    }
    // The lathe controls are not covered in full yet: this list is to become empty.
    expect![[r#"
        gsk-980tdc G2
        gsk-980tdc G3
        gsk-980tdc G4
        gsk-980tdc G17
        gsk-980tdc G18
        gsk-980tdc G19
        gsk-980tdc G20
        gsk-980tdc G21
        gsk-980tdc G28
        gsk-980tdc G32
        gsk-980tdc G50
        gsk-980tdc G52
        gsk-980tdc G53
        gsk-980tdc G54
        gsk-980tdc G55
        gsk-980tdc G56
        gsk-980tdc G57
        gsk-980tdc G58
        gsk-980tdc G59
        gsk-980tdc G65
        gsk-980tdc G66
        gsk-980tdc G67
        gsk-980tdc G96
        gsk-980tdc G97
        gsk-980tdc G99
        gsk-980tdc M0
        gsk-980tdc M1
        gsk-980tdc M2
        gsk-980tdc M3
        gsk-980tdc M4
        gsk-980tdc M5
        gsk-980tdc M98
        gsk-980tdc M99
        knd-k2000t G2
        knd-k2000t G3
        knd-k2000t G4
        knd-k2000t G9
        knd-k2000t G17
        knd-k2000t G18
        knd-k2000t G19
        knd-k2000t G20
        knd-k2000t G21
        knd-k2000t G28
        knd-k2000t G32
        knd-k2000t G50
        knd-k2000t G52
        knd-k2000t G53
        knd-k2000t G54
        knd-k2000t G55
        knd-k2000t G56
        knd-k2000t G57
        knd-k2000t G58
        knd-k2000t G59
        knd-k2000t G65
        knd-k2000t G66
        knd-k2000t G67
        knd-k2000t G96
        knd-k2000t G97
        knd-k2000t G99
        knd-k2000t M0
        knd-k2000t M1
        knd-k2000t M2
        knd-k2000t M3
        knd-k2000t M4
        knd-k2000t M5
        knd-k2000t M19
        knd-k2000t M98
        knd-k2000t M99"#]]
    .assert_eq(&missing.join("\n"));
}

//! One part on every control: the same motion where their rules agree, and a table of where they do not.

use std::fmt::Write as _;

use expect_test::expect;
use macroline::controls::{Address, Code, Control};
use macroline::interp::Interp;
use macroline::motion::{Action, Event, Planner, RunEnd};

use super::{cuts, ideal, machine, over_time, project, run_of, sheet};
use crate::queries::value;
use macroline::project::Project;

/// The times of blocks are the control's and not the machine's.
const TIMES: [(&str, &str); 3] = [("block-time", "5"), ("macro-time", "1"), ("preread", "5")];

fn controls() -> impl Iterator<Item = &'static Control> {
    machine().controls().iter().map(|id| macroline::controls::find(id).unwrap())
}

/// Slides and spindle over a cut: radius, Z, speed.
fn moved(project: &Project, planner: &Planner<Interp>, from: f64, to: f64) -> Vec<[f64; 3]> {
    let [x, z] = [Address::X, Address::Z].map(|letter| project.control.axis(letter).unwrap());
    let moments = (0..=200).map(|at| from + (to - from) * f64::from(at) / 200.0);
    let look = |t: f64| {
        let now = planner.timeline().at(t);
        [now.axes[x].position, now.axes[z].position, now.spindle.actual]
    };
    moments.map(look).collect()
}

#[test]
fn controls_with_equal_rules_move_alike() {
    let surface: Vec<&Control> = controls().filter(|control| control.can(Code::SurfaceSpeed)).collect();
    assert!(surface.len() > 1);
    for path in ["facing", "turning", "taper"] {
        for (mode, on) in [("surface", surface.clone()), ("fixed", controls().collect())] {
            for knob in ["100", "80"] {
                let changes = [
                    &TIMES[..],
                    &[
                        ("path", path),
                        ("speed-mode", mode),
                        ("depth", "8"),
                        ("override", knob),
                        ("gear", "2"),
                        ("stage-1", "3000"),
                    ],
                ]
                .concat();
                let runs: Vec<_> = on
                    .iter()
                    .map(|control| {
                        let project = ideal(control.id, &changes);
                        let planner = over_time(&project);
                        let cuts = cuts(&project, &planner);
                        // The first point of a cut is left out, because the speed at the end of a rapid follows a separate rule.
                        let all: Vec<_> =
                            cuts.iter().map(|(from, to)| moved(&project, &planner, from + 1e-6, to - 1e-6)).collect();
                        (control.id, cuts.len(), all)
                    })
                    .collect();
                let first = &runs[0];
                for other in &runs[1..] {
                    assert_eq!(first.1, other.1);
                    for (a, b) in first.2.iter().flatten().zip(other.2.iter().flatten()) {
                        for (a, b) in a.iter().zip(b) {
                            let close = (a - b).abs() <= 1e-4 * a.abs().max(1.0);
                            assert!(close, "{path} {mode} {knob}: {} {a}, {} {b}", first.0, other.0);
                        }
                    }
                }
            }
        }
    }
}

/// Name of a question about a lathe, and the answer on a control.
type Question = (&'static str, fn(&Control) -> String);

fn rounded(value: f64) -> String {
    format!("{}", (value * 100.0).round() / 100.0 + 0.0)
}

/// The words of the run program's block that has a text.
fn block(control: &Control, changes: &[(&str, &str)], holds: &str) -> String {
    let text = &project(control.id, changes).written().files.0[0].text.clone();
    text.lines().find(|line| line.contains(holds)).map_or("-".to_owned(), |line| line.replace("  ", " "))
}

/// The speed at a number of seconds after the start of a cut, or before it if negative.
fn speed(control: &Control, changes: &[(&str, &str)], cut: usize, seconds: f64) -> String {
    let project = ideal(control.id, &[&TIMES[..], changes].concat());
    let planner = over_time(&project);
    let all = cuts(&project, &planner);
    let t = if seconds < 0.0 { all[cut].0 + seconds } else { all[cut].1 + seconds };
    rounded(planner.timeline().at(t).spindle.command)
}

/// Volts of the analog output after the run has ended, by its program or by this action of the operator.
fn volts(control: &Control, changes: &[(&str, &str)], event: Option<Action>) -> String {
    let project = ideal(control.id, changes);
    let mut planner = run_of(&project, event.map(|action| Event { t: 3.2, action }));
    planner.advance(f64::INFINITY, usize::MAX);
    rounded(planner.timeline().at(planner.timeline().end() + 9.0).spindle.volts_command)
}

/// Seconds from the start of the run to the first cut, with a ramp of three seconds.
fn waits(control: &Control) -> String {
    let project = project(control.id, &[&TIMES[..], &[("stage-2", "0"), ("stage-1", "3000")]].concat());
    let planner = over_time(&project);
    let begin = cuts(&project, &planner)[0].0;
    let x = project.control.axis(Address::X).unwrap();
    let mut t = begin;
    while planner.timeline().at(t).axes[x].feed == 0.0 {
        t += 1e-3;
    }
    if t - begin > 0.1 { "waits for the speed".to_owned() } else { "begins at once".to_owned() }
}

/// How the program stops where an entry cannot be.
fn entry(control: &Control) -> String {
    let project = project(control.id, &[]);
    let written = project.written();
    let mut planner = super::run_set(&project, 101, 0.0);
    match planner.advance(f64::INFINITY, usize::MAX).ended {
        Some(RunEnd::Alarm(alarm)) => format!("alarm {}", alarm.alarm.unwrap_or_default()),
        Some(RunEnd::Stop) => {
            let shown = written.files.0[0].text.lines().any(|line| line.contains("MSG("));
            if shown { "message, stop".to_owned() } else { "stop".to_owned() }
        }
        end => format!("{end:?}"),
    }
}

const QUESTIONS: &[Question] = &[
    ("surface speed", |c| block(c, &[], "N27 ")),
    ("fixed speed", |c| block(c, &[("speed-mode", "fixed")], "N27 ")),
    ("limit", |c| block(c, &[], "N20 ")),
    ("feed and path", |c| block(c, &[], "N21 ")),
    ("gear", |c| block(c, &[], "N22 ")),
    ("angle", |c| block(c, &[("keyway", "true"), ("lock-code", "81")], "N53 ")),
    ("X of a face", |c| block(c, &[], "N36 ")),
    ("jump of the loop", |c| block(c, &[], "N31 ")),
    ("entry of 0", entry),
    ("cutting speed 95.5", |c| rounded(machine_speed(c, "95.5"))),
    ("knob at 133 %", |c| {
        rounded(value(&ideal(c.id, &[("override", "133"), ("cutting-speed", "60")]), "speed-largest"))
    }),
    ("rpm before cut 1", |c| speed(c, &[], 0, -1e-4)),
    ("rpm behind cut 1", |c| speed(c, &[], 0, 0.05)),
    ("rpm before cut 2", |c| speed(c, &[], 1, -0.001)),
    ("fixed, low 900", |c| speed(c, &[("speed-mode", "fixed"), ("lower-limit", "900")], 0, -1e-4)),
    ("speed reached", waits),
    ("volts at the end", |c| volts(c, &[], None)),
    ("volts at reset", |c| volts(c, &[], Some(Action::Reset))),
    ("volts at stop", |c| volts(c, &[], Some(Action::EmergencyStop))),
    ("M04, -10 to 10 V", |c| {
        let project = ideal(c.id, &[("direction", "ccw"), ("output", "+-10"), ("speed-mode", "fixed")]);
        let planner = over_time(&project);
        rounded(planner.timeline().at(cuts(&project, &planner)[0].0 + 0.1).spindle.volts_command)
    }),
];

/// The surface speed that is commanded where one is typed.
fn machine_speed(control: &Control, typed: &str) -> f64 {
    let project = ideal(control.id, &[("cutting-speed", typed)]);
    value(&project, "surface-time").recip()
        * value(&ideal(control.id, &[("cutting-speed", "100")]), "surface-time")
        * 100.0
}

#[test]
fn differences_between_controls_match_the_table() {
    let mut table = String::new();
    for (what, answer) in QUESTIONS {
        let _ = writeln!(table, "{what}");
        for control in controls() {
            let _ = writeln!(table, "    {:<15} {}", control.id, answer(control));
        }
    }
    expect![[r#"
        surface speed
            gsk-980tdc      N27 G96 S#1 M3
            sinumerik-802d  N27 LB27: G96 S=R1 LIMS=R8 M3
            sinumerik-808d  N27 LB27: G96 S=R1 LIMS=R8 M3
            knd-k2000t      N27 G96 S#1 M3
            fanuc-0i-tf     N27 G96 S#1 M3
            mitsubishi-e60  N27 G97 S#10 M3
        fixed speed
            gsk-980tdc      N27 G97 S#10 M3
            sinumerik-802d  N27 LB27: G97 S=R10 M3
            sinumerik-808d  N27 LB27: G97 S=R10 M3
            knd-k2000t      N27 G97 S#10 M3
            fanuc-0i-tf     N27 G97 S#10 M3
            mitsubishi-e60  N27 G97 S#10 M3
        limit
            gsk-980tdc      N20 G50 S#8
            sinumerik-802d  N20 G25 S=R17
            sinumerik-808d  N20 G25 S=R17
            knd-k2000t      N20 G50 S#8
            fanuc-0i-tf     N20 G50 S#8
            mitsubishi-e60  -
        feed and path
            gsk-980tdc      N21 G99
            sinumerik-802d  N21 G90 G95 G64
            sinumerik-808d  N21 G90 G95 G64
            knd-k2000t      N21 G99
            fanuc-0i-tf     N21 G99
            mitsubishi-e60  N21 G90 G95 G64
        gear
            gsk-980tdc      N22 M42
            sinumerik-802d  N22 M42
            sinumerik-808d  N22 M42
            knd-k2000t      N22 M42
            fanuc-0i-tf     N22 M42
            mitsubishi-e60  -
        angle
            gsk-980tdc      -
            sinumerik-802d  N53 SPOS=R14 ;FOR THE KEYWAY
            sinumerik-808d  N53 SPOS=R14 ;FOR THE KEYWAY
            knd-k2000t      -
            fanuc-0i-tf     -
            mitsubishi-e60  -
        X of a face
            gsk-980tdc      N36 G01 X#4 F#2
            sinumerik-802d  N36 G1 X=R4 F=R2
            sinumerik-808d  N36 G1 X=R4 F=R2
            knd-k2000t      N36 G01 X#4 F#2
            fanuc-0i-tf     N36 G01 X#4 F#2
            mitsubishi-e60  N36 G01 X[#4/2] F#2
        jump of the loop
            gsk-980tdc      N31 IF[#7 LE #11]GOTO32
            sinumerik-802d  N31 IF R7<=R11 GOTOF LB32
            sinumerik-808d  N31 IF R7<=R11 GOTOF LB32
            knd-k2000t      N31 IF[#7 LE #11]GOTO32
            fanuc-0i-tf     N31 IF[#7 LE #11]GOTO32
            mitsubishi-e60  N31 IF[#7 LE #11]GOTO32
        entry of 0
            gsk-980tdc      alarm 5902
            sinumerik-802d  message, stop
            sinumerik-808d  message, stop
            knd-k2000t      alarm 3002
            fanuc-0i-tf     alarm MC3002
            mitsubishi-e60  alarm P277
        cutting speed 95.5
            gsk-980tdc      96
            sinumerik-802d  95.5
            sinumerik-808d  95.5
            knd-k2000t      96
            fanuc-0i-tf     96
            mitsubishi-e60  95.49
        knob at 133 %
            gsk-980tdc      272.84
            sinumerik-802d  302.39
            sinumerik-808d  302.39
            knd-k2000t      302.39
            fanuc-0i-tf     302.39
            mitsubishi-e60  316.54
        rpm before cut 1
            gsk-980tdc      682.09
            sinumerik-802d  682.09
            sinumerik-808d  682.09
            knd-k2000t      682.09
            fanuc-0i-tf     682.09
            mitsubishi-e60  716
        rpm behind cut 1
            gsk-980tdc      2500
            sinumerik-802d  2500
            sinumerik-808d  2500
            knd-k2000t      682.09
            fanuc-0i-tf     682.09
            mitsubishi-e60  716
        rpm before cut 2
            gsk-980tdc      2500
            sinumerik-802d  682.09
            sinumerik-808d  682.09
            knd-k2000t      682.09
            fanuc-0i-tf     682.09
            mitsubishi-e60  716
        fixed, low 900
            gsk-980tdc      716
            sinumerik-802d  900
            sinumerik-808d  900
            knd-k2000t      716
            fanuc-0i-tf     716
            mitsubishi-e60  716
        speed reached
            gsk-980tdc      begins at once
            sinumerik-802d  waits for the speed
            sinumerik-808d  waits for the speed
            knd-k2000t      begins at once
            fanuc-0i-tf     begins at once
            mitsubishi-e60  begins at once
        volts at the end
            gsk-980tdc      2.39
            sinumerik-802d  0
            sinumerik-808d  0
            knd-k2000t      0
            fanuc-0i-tf     0
            mitsubishi-e60  0
        volts at reset
            gsk-980tdc      2.28
            sinumerik-802d  0
            sinumerik-808d  0
            knd-k2000t      0
            fanuc-0i-tf     0
            mitsubishi-e60  0
        volts at stop
            gsk-980tdc      2.28
            sinumerik-802d  0
            sinumerik-808d  0
            knd-k2000t      0
            fanuc-0i-tf     0
            mitsubishi-e60  0
        M04, -10 to 10 V
            gsk-980tdc      7.16
            sinumerik-802d  -7.16
            sinumerik-808d  -7.16
            knd-k2000t      -7.16
            fanuc-0i-tf     -7.16
            mitsubishi-e60  7.16
    "#]]
    .assert_eq(&table);
}

/// An encoder at another ratio than the parameters have makes feed per revolution, pitch and angle wrong.
#[test]
fn spindle_encoder_is_on_the_sheet_with_its_ratio() {
    let half = [("encoder-lines", "2500"), ("encoder-turns", "1"), ("spindle-turns", "2")];
    let third = [("spindle-turns", "3")];
    let rows: [(&str, &[&str]); 3] = [
        (
            "sinumerik-802d",
            &[
                "MD31020 ENC_RESOL 2500 Sister",
                "MD31040 ENC_IS_DIRECT 1 Sister",
                "MD31070 DRIVE_ENC_RATIO_DENOM 1 Sister",
                "MD31080 DRIVE_ENC_RATIO_NUMERA 2 Sister",
            ],
        ),
        ("gsk-980tdc", &["No.069 1 Sister", "No.070 2500 Sister"]),
        ("fanuc-0i-tf", &["3706#0 PG1 1 Sister", "3706#1 PG2 0 Sister"]),
    ];
    for (control, wanted) in rows {
        let sheet = sheet(control, &half);
        assert!(wanted.iter().all(|row| sheet.lines().any(|line| line == *row)), "{control}: {sheet}");
    }
    let warns = |control: &str, changes: &[(&'static str, &str)]| {
        let found = project(control, changes).design().diagnostics;
        found.iter().any(|found| found.field == Some("encoder-turns"))
    };
    let of = |changes: &[(&'static str, &str)]| rows.map(|(control, _)| warns(control, changes));
    assert_eq!([of(&[]), of(&half), of(&third)], [[false; 3], [false, true, false], [false, true, true]]);
}

/// A keyway needs a spindle that a word positions; on other controls the program omits it, and a finding names it.
#[test]
fn keyway_that_a_control_cannot_cut_is_named() {
    let keyway = machine().examples().iter().find(|example| example.id == "keyway").unwrap();
    for control in controls() {
        let project = Project::example(machine(), control, keyway);
        let named = project.design().diagnostics.iter().any(|found| found.message.id == "turning.no-keyway");
        let cut = project.written().files.0.iter().any(|file| file.text.contains("SPOS"));
        assert_ne!(named, cut, "{}", control.id);
    }
}

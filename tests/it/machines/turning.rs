//! The turning spindle: its closed forms against the run, its programs, its drawing, its verdicts.

mod clauses;
mod cooling;
mod demand;
mod drawing;
mod each_control;
mod edges;
mod entries;
mod gears;
mod guards;
mod knobs;
mod restart;
mod run_up;
mod torque;

use std::path::PathBuf;

use expect_test::{expect, expect_file};
use macroline::controls::Address;
use macroline::drives::speed::surface_speed;
use macroline::interp::Interp;
use macroline::machines::form::{Origins, Value, Values};
use macroline::machines::{self, AnyMachine, Frame, Samples};
use macroline::motion::{Action, Budget, Event, Planner, Retention};
use macroline::project::run::{self, RunOptions};
use macroline::project::{Project, import};
use macroline::text::Severity;
use macroline::text::catalog::sentence;
use macroline::view::Verdict;

use super::every_machine::drawn::area;
use crate::queries;
use crate::queries::{near, value};

const PATHS: [&str; 3] = ["facing", "turning", "taper"];

pub(super) fn machine() -> &'static dyn AnyMachine {
    machines::find("turning-spindle").unwrap()
}

fn values(changes: &[(&str, &str)]) -> Values {
    queries::values(machine(), changes)
}

pub(super) fn project(control: &str, changes: &[(&str, &str)]) -> Project {
    let mut project = Project::of_form(machine(), macroline::controls::find(control).unwrap());
    project.values.extend(values(changes));
    project
}

/// A lathe whose spindle and slides follow at once.
const IDEAL: [(&str, &str); 6] = [
    ("spindle-ramp", "0"),
    ("time-constant", "0"),
    ("position-gain", "1000"),
    ("clamp-x", "100000"),
    ("clamp-z", "100000"),
    ("chuck-limit", "6000"),
];

pub(super) fn ideal(control: &str, changes: &[(&str, &str)]) -> Project {
    project(control, &[&IDEAL, changes].concat())
}

pub(super) fn over_time(project: &Project) -> Planner<Interp> {
    let mut planner = run_of(project, None);
    assert_eq!(planner.advance(f64::INFINITY, usize::MAX).ended, Some(macroline::motion::RunEnd::ProgramEnd));
    planner
}

/// A run that has not begun, in which the operator does something.
pub(super) fn run_of(project: &Project, event: Option<Event>) -> Planner<Interp> {
    let mut project = project.clone();
    if let Some(event) = event {
        project.panel.add(event);
    }
    begun(&project, &[])
}

/// A run that has not begun, with a variable set before the start.
pub(super) fn run_set(project: &Project, number: u32, value: f64) -> Planner<Interp> {
    begun(project, &[run::Setting { name: project.control.variable(number), value }])
}

fn begun(project: &Project, settings: &[run::Setting]) -> Planner<Interp> {
    let limits = Budget { blocks: 1_000_000, seconds: 3600.0 };
    let begin = RunOptions { start: None, settings, limits, keep: Retention::Timeline };
    run::of_project(project, &project.written(), &begin)
}

/// An entry of the form.
fn number(project: &Project, id: &str) -> f64 {
    match project.values[id] {
        Value::Number(value) => value,
        _ => panic!("{id} is no number"),
    }
}

/// From when to when blocks cut.
pub(super) fn cuts(project: &Project, planner: &Planner<Interp>) -> Vec<(f64, f64)> {
    let (files, timeline) = (project.written().files, planner.timeline());
    let taper = values(&[("path", "taper")]).get("path") == project.values.get("path");
    let (mut t, mut found) = (0.0, Vec::new());
    while let Some(from) = timeline.next_block(t) {
        t = from;
        let place = timeline.block_at(from).unwrap();
        let text = &files.0[place.file.0 as usize].text[place.span.start as usize..place.span.end as usize];
        if text.starts_with("N36 ") || taper && text.starts_with("N37 ") {
            found.push((from, timeline.next_block(from).unwrap_or(timeline.end())));
        }
    }
    found
}

#[test]
fn cutting_time_of_the_run_equals_closed_form() {
    let limits = [("2500", "0"), ("60000", "0"), ("900", "700"), ("1200", "0")];
    for control in ["gsk-980tdc", "sinumerik-802d", "knd-k2000t"] {
        for path in PATHS {
            for (upper, lower) in limits {
                for mode in ["surface", "fixed"] {
                    let upper = if upper == "60000" && control == "gsk-980tdc" { "9999" } else { upper };
                    let changes = [
                        ("path", path),
                        ("upper-limit", upper),
                        ("lower-limit", lower),
                        ("speed-mode", mode),
                        ("depth", "7"),
                    ];
                    let project = ideal(control, &changes);
                    let planner = over_time(&project);
                    let took: f64 = cuts(&project, &planner).iter().map(|(from, to)| to - from).sum();
                    let calculated = value(&project, "cutting-time");
                    assert!((took / calculated - 1.0).abs() < 1e-4, "{control} {changes:?}: {took} for {calculated}");
                }
            }
        }
    }
}

#[test]
fn surface_speed_is_constant_where_no_limit_binds() {
    for path in PATHS {
        let project = ideal("gsk-980tdc", &[("path", path), ("depth", "7")]);
        let planner = over_time(&project);
        let limit = value(&project, "limit-diameter");
        let x = project.control.axis(Address::X).unwrap();
        let mut seen = 0;
        for (from, to) in cuts(&project, &planner) {
            for at in 1..200 {
                let now = planner.timeline().at(from + (to - from) * f64::from(at) / 200.0);
                let diameter = 2.0 * now.axes[x].position;
                if diameter > limit + 0.1 {
                    let speed = surface_speed(now.spindle.actual, diameter);
                    assert!((speed / 180.0 - 1.0).abs() < 1e-3, "{path} at {diameter}: {speed}");
                    seen += 1;
                }
            }
        }
        assert!(seen > 100, "{path}: {seen}");
    }
}

#[test]
fn exported_programs_match_their_goldens() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/machines/turning-spindle");
    type Case = (&'static str, &'static str, &'static [(&'static str, &'static str)]);
    let cases: [Case; 7] = [
        ("sinumerik-802d", "facing", &[("keyway", "true"), ("keyway-angle", "90")]),
        ("sinumerik-802d", "taper", &[("path", "taper"), ("speed-mode", "fixed")]),
        ("gsk-980tdc", "facing", &[]),
        (
            "gsk-980tdc",
            "fixed",
            &[("path", "turning"), ("speed-mode", "fixed"), ("direction", "ccw"), ("customer", "ACME")],
        ),
        ("knd-k2000t", "taper", &[("path", "taper"), ("gear", "1")]),
        ("knd-k2000t", "one-stage", &[("path", "turning"), ("stage-2", "0")]),
        ("mitsubishi-e60", "turning", &[("path", "turning")]),
    ];
    for (control, name, changes) in cases {
        let (project, folder) = (project(control, changes), folder.join(control).join(name));
        for file in project.written().files.0 {
            expect_file![folder.join(&file.name)].assert_eq(&file.text);
        }
        expect_file![folder.join("project.json")].assert_eq(&project.to_json());
    }
}

#[test]
fn dropped_program_restores_the_form() {
    let changes = [("path", "taper"), ("cutting-speed", "95.5"), ("gear", "2"), ("output", "+-10"), ("product", "PIN")];
    for control in machine().controls() {
        let saved = project(control, &changes);
        let present = Project::of("ribbon-line", None).unwrap();
        for file in saved.written().files.0 {
            let opened = import::open(&present, std::slice::from_ref(&file)).project.unwrap();
            let written =
                |project: &Project| project.written().files.0.into_iter().map(|file| file.text).collect::<Vec<_>>();
            assert_eq!((opened.machine.id(), opened.control.id), ("turning-spindle", *control));
            assert_eq!(written(&opened), written(&saved));
            assert!(opened.edited.is_none());
        }
    }
}

#[test]
fn cut_part_never_grows() {
    for (path, finished) in [("facing", "0"), ("facing", "20"), ("turning", "20"), ("taper", "20"), ("taper", "70")] {
        for depth in ["0.7", "3", "40"] {
            let project = ideal(
                "gsk-980tdc",
                &[("path", path), ("finished-diameter", finished), ("depth", depth), ("preread", "3")],
            );
            let planner = over_time(&project);
            let end = planner.timeline().end();
            let frame = Frame { step: 0.01, drawing_option: false };
            let outline = |t: f64| {
                let now = Samples::at(&planner, t);
                area(&project.prepared().pose(&planner, &now, frame).paths[0].1)
            };
            let whole = outline(0.0);
            let mut left = whole;
            for at in 0..=2000 {
                let now = outline(end * f64::from(at) / 2000.0);
                assert!(now < left + 0.5, "{path} {finished} {depth}: {left} to {now} at {at}");
                left = now;
            }
            assert!(left < whole - 1.0, "{path}");
        }
    }
}

#[test]
fn design_readouts_match_their_golden() {
    let verdicts = |changes: &[(&str, &str)]| {
        let design = machine()
            .prepare(&values(changes), project("gsk-980tdc", &[]).control_context())
            .design(&Origins::default());
        let verdicts = design.readouts.iter().filter(|row| row.verdict > Verdict::Ok).map(|row| {
            let advice: Vec<_> = row.advice.iter().map(|advice| sentence(&advice.message)).collect();
            format!("{:?} {}: {}\n", row.verdict, row.id, advice.join(" "))
        });
        let errors = design.diagnostics.iter().filter(|d| d.severity != Severity::Info);
        let errors = errors.map(|d| format!("{:?} {}: {}\n", d.severity, d.field.unwrap_or(""), sentence(&d.message)));
        verdicts.chain(errors).collect::<String>()
    };
    expect![[""]].assert_eq(&verdicts(&[("spindle-ramp", "1"), ("motor-power", "22")]));
    expect![[r#"
        Warn speed-smallest: The speed limit of 3500 r/min lies above the 3000 r/min of chuck and spindle: set it to 3000 or less.
        Warn acceleration-needed: The spindle would have to gain 3142 r/min each second; it can gain only 1000: the surface speed lags behind near the limit. Lower the cutting speed, the feed or the speed limit.
    "#]].assert_eq(&verdicts(&[("upper-limit", "3500"), ("finished-diameter", "0")]));
    expect![[r#"
        Error finished-diameter: The finished part reaches 80 mm; the stock has 80 mm: there is nothing to cut.
        Error start-x: The tool would start at 80 mm, inside the stock or its clearance: start at more than 84 mm.
    "#]]
    .assert_eq(&verdicts(&[("finished-diameter", "80"), ("start-x", "80")]));
    expect![[r#"
        Warn limit-diameter: Below 57.296 mm the spindle is held at 1000 r/min: the surface speed falls to 62.8 m/min, over 58 % of the diameter.
        Warn stage-speed: Stage 1 ends at 1000 r/min, below the speed limit of 2500 r/min: the surface speed falls from there on. Take a faster stage. That makes another result fail: Highest feed.
        Warn acceleration-needed: The spindle would have to gain 1164 r/min each second; it can gain only 333: the surface speed lags behind near the limit. Lower the cutting speed, the feed or the speed limit.
        Fail power: Cut and friction need 12.21 kW, 6 kW are available at the spindle, and at a lower cutting speed the torque is too small. Cut with less depth.
        Fail torque: Cut and friction take 162 Nm at 716 r/min, and the motor gives 49.2 Nm in stage 1: the spindle stalls. Take a stage with more torque, or cut with less depth.
        Fail peak-torque: At Ø 80 mm cut, friction and the acceleration of the constant surface speed together take 171.4 Nm at 716 r/min; the motor gives 85.9 Nm there for a short time: the spindle lags or stalls. Feed more slowly, or limit the speed to less.
    "#]].assert_eq(&verdicts(&[("cutting-force", "4000"), ("gear", "1"), ("feed", "2")]));
    expect![[r#"
        Warning lower-limit: At Ø 80 mm the lower limit of 2500 r/min lifts the cutting speed to 628 m/min.
        Warning lower-limit: The lower limit of 3000 r/min lies above the upper one of 2500 r/min: the upper one holds.
    "#]]
    .assert_eq(&verdicts(&[("cutting-speed", "20"), ("lower-limit", "3000")]));
}

/// The parameter sheet: number, name, index, value, unit.
pub(super) fn sheet(control: &str, changes: &[(&str, &str)]) -> String {
    let project = project(control, changes);
    let sheets = project.prepared().sheets();
    let rows = sheets.iter().filter(|sheet| sheet.id == "parameters").flat_map(|sheet| &sheet.rows);
    let lines = rows.map(|row| format!("{} {:?}", row.cells[..5].join(" ").trim_end(), row.grade));
    lines.map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ") + "\n").collect()
}

#[test]
fn parameter_sheets_match_their_goldens() {
    let changes =
        [("stage-3", "1500"), ("offset-zero", "-12"), ("offset-full", "35"), ("lower-limit", "40"), ("keyway", "true")];
    expect![[r#"
        MD12060 OVR_SPIND_IS_GRAY_CODE 0 Sister
        MD20100 DIAMETER_AX_DEF X X Sister
        MD30130 CTRLOUT_TYPE 1 Open
        MD30200 NUM_ENCS 1 Sister
        MD30134 IS_UNIPOLAR_OUTPUT 1 Open
        MD31020 ENC_RESOL X 10000 p/rev Sister
        MD31020 ENC_RESOL Z 10000 p/rev Sister
        MD31020 ENC_RESOL 1024 Sister
        MD31030 LEADSCREW_PITCH X 5 mm Sister
        MD31030 LEADSCREW_PITCH Z 5 mm Sister
        MD31040 ENC_IS_DIRECT 1 Sister
        MD31050 DRIVE_AX_RATIO_DENOM X 1 Sister
        MD31050 DRIVE_AX_RATIO_DENOM Z 1 Sister
        MD31050 DRIVE_AX_RATIO_DENOM 1 1000 Sister
        MD31050 DRIVE_AX_RATIO_DENOM 2 3000 Sister
        MD31050 DRIVE_AX_RATIO_DENOM 3 1500 Sister
        MD31060 DRIVE_AX_RATIO_NUMERA X 1 Sister
        MD31060 DRIVE_AX_RATIO_NUMERA Z 1 Sister
        MD31060 DRIVE_AX_RATIO_NUMERA 1 1500 Sister
        MD31060 DRIVE_AX_RATIO_NUMERA 2 1500 Sister
        MD31060 DRIVE_AX_RATIO_NUMERA 3 1500 Sister
        MD31070 DRIVE_ENC_RATIO_DENOM 1 Sister
        MD31080 DRIVE_ENC_RATIO_NUMERA 1 Sister
        MD32000 MAX_AX_VELO X 8000 mm/min Sister
        MD32000 MAX_AX_VELO Z 10000 mm/min Sister
        MD32200 POSCTRL_GAIN X 1.98 1000/min Open
        MD32200 POSCTRL_GAIN Z 1.98 1000/min Open
        MD32250 RATED_OUTVAL 100 % Open
        MD32260 RATED_VELO 1500 r/min Open
        MD32300 MAX_AX_ACCEL X 1.333 m/s² Open
        MD32300 MAX_AX_ACCEL Z 1.667 m/s² Open
        MD35010 GEAR_STEP_CHANGE_ENABLE 1 Open
        MD35100 SPIND_VELO_LIMIT 3000 r/min Sister
        MD35130 GEAR_STEP_MAX_VELO_LIMIT 1 1000 r/min Sister
        MD35130 GEAR_STEP_MAX_VELO_LIMIT 2 3000 r/min Sister
        MD35130 GEAR_STEP_MAX_VELO_LIMIT 3 1500 r/min Sister
        MD35140 GEAR_STEP_MIN_VELO_LIMIT 1 0 r/min Sister
        MD35140 GEAR_STEP_MIN_VELO_LIMIT 2 0 r/min Sister
        MD35140 GEAR_STEP_MIN_VELO_LIMIT 3 0 r/min Sister
        MD35150 SPIND_DES_VELO_TOL 0.1 Sister
        MD35210 GEAR_STEP_POSCTRL_ACCEL 8.333 rev/s² Sister
        MD35300 SPIND_POSCTRL_VELO 100 r/min Sister
        MD35350 SPIND_POSITIONING_DIR 3 Open
        MD35400 SPIND_OSCILL_DES_VELO 15 r/min Open
        MD35500 SPIND_ON_SPEED_AT_IPO_START 1 Sister
        SD43210 SPIND_MIN_VELO_G25 40 r/min Open
        SD43220 SPIND_MAX_VELO_G26 3000 r/min Open
        SD43230 SPIND_MAX_VELO_LIMS 2500 r/min Open
    "#]]
    .assert_eq(&sheet("sinumerik-802d", &changes));
    expect![[r#"
        No.001#1 0 Sister
        No.001#2 X 0 Sister
        No.001#4 1 Sister
        No.005#4 1 Sister
        No.015 CMR X 1 Sister
        No.015 CMR Z 2 Sister
        No.016 CMD X 1 Sister
        No.016 CMD Z 1 Sister
        No.021 35 mV Sister
        No.022 X 8000 mm/min Sister
        No.022 Z 10000 mm/min Sister
        No.027 X 8000 mm/min Sister
        No.027 Z 8000 mm/min Sister
        No.029 X 100 ms Sister
        No.029 Z 100 ms Sister
        No.036 -12 mV Sister
        No.037 1000 r/min Manual
        No.038 3000 r/min Manual
        No.039 1500 r/min Manual
        No.043 40 r/min Sister
        No.067 88.47 mV Sister
        No.069 1 Sister
        No.070 1024 Sister
        No.072 0 ms Sister
        No.075 3000 r/min Sister
        No.175#6 0 Sister
        No.196#4 0 Sister
        No.252 X 0 Sister
        No.252 Z 0 Sister
        K10.1 0 Sister
        K10 RESB 1 Sister
        K15.0 1 Sister
        K16.5 0 Sister
        K17.3 0 Sister
        DT000 3000 ms Sister
        DT001 750 ms Sister
    "#]]
    .assert_eq(&sheet("gsk-980tdc", &changes));
    expect![[r#"
        1006#3 DIA X 1 Open
        1420 X 8000 mm/min Open
        1420 Z 10000 mm/min Open
        1422 8945 mm/min Open
        1430 X 4000 mm/min Open
        1430 Z 8000 mm/min Open
        1610#0 CTL X 1 Open
        1610#0 CTL Z 1 Open
        1620 X 100 ms Open
        1620 Z 100 ms Open
        1622 X 100 ms Open
        1622 Z 100 ms Open
        1820 CMR X 102 Open
        1820 CMR Z 2 Open
        1821 X 5000 Open
        1821 Z 5000 Open
        1825 X 3300 0.01/s Open
        1825 Z 3300 0.01/s Open
        1826 X 20 0.001 mm Open
        1826 Z 20 0.001 mm Open
        2084 N X 1 Open
        2084 N Z 1 Open
        2085 M X 200 Open
        2085 M Z 200 Open
        3202#4 NE9 0 Open
        3701#1 ISI 1 Open
        3705#1 GST 1 Open
        3706#0 PG1 0 Open
        3706#1 PG2 0 Open
        3708#0 SAR 0 Open
        3732 41 Open
        3740 0 ms Open
        3741 1000 r/min Open
        3742 3000 r/min Open
        3743 1500 r/min Open
        3771 40 r/min Open
        3772 3000 r/min Open
        4002#1 1 Open
        6000#5 SBM 0 Open
        6001#6 CCV 1 Open
    "#]]
    .assert_eq(&sheet("knd-k2000t", &changes));
    expect![[r#"
        #1015 cunit 10 0.1 µm Sister
        #1039 spinno 1 Manual
        #1121 edlk_c 0 Sister
        #1128 RstVC1 0 Sister
        #1129 PwrVC1 0 Sister
        #2001 rapid X 8000 mm/min Sister
        #2001 rapid Z 10000 mm/min Sister
        #2002 clamp X 4000 mm/min Sister
        #2002 clamp Z 8000 mm/min Sister
        #2003 smgst X 11 hex Open
        #2003 smgst Z 11 hex Open
        #2004 G0tL X 100 ms Sister
        #2004 G0tL Z 100 ms Sister
        #2007 G1tL X 100 ms Sister
        #2007 G1tL Z 100 ms Sister
        #2078 G1inps X 0.02 mm Sister
        #2078 G1inps Z 0.02 mm Sister
        #2201 PC1 X 1 Inferred
        #2201 PC1 Z 1 Inferred
        #2202 PC2 X 1 Inferred
        #2202 PC2 Z 1 Inferred
        #2203 PGN1 X 33 1/s Open
        #2203 PGN1 Z 33 1/s Open
        #2218 PIT X 5 mm Inferred
        #2218 PIT Z 5 mm Inferred
        #2219 RNG1 X 10 kp/rev Open
        #2219 RNG1 Z 10 kp/rev Open
        #2220 RNG2 X 10 kp/rev Open
        #2220 RNG2 Z 10 kp/rev Open
        #3001 slimt1 1000 r/min Sister
        #3005 smax1 1000 r/min Open
        #3023 smini 0 r/min Open
        #3024 sout 2 Open
        #3025 enc-on 1 Open
        #8101 MACRO SINGLE 0 Open
        #8105 EDIT LOCK B 0 Sister
    "#]]
    .assert_eq(&sheet("mitsubishi-e60", &changes));
}

/// Errors and warnings of a form.
fn findings(control: &str, changes: &[(&str, &str)]) -> String {
    let project = project(control, changes);
    let design = project.prepared().design(&Origins::default());
    let all = design
        .diagnostics
        .iter()
        .filter(|d| d.message.id == "form.parameter-range" || !d.message.id.starts_with("form."));
    all.map(|d| format!("{:?} {}: {}\n", d.severity, d.field.unwrap_or(""), sentence(&d.message))).collect()
}

#[test]
fn values_that_a_control_refuses_are_findings() {
    expect![[r#"
        Error offset-zero: 1001 mV is beyond what the parameter of this control takes: -1000 to 1000 mV.
        Error stage-1: 9 r/min is beyond what the parameter of this control takes: 10 to 9999 r/min.
        Error stage-3: 10000 r/min is beyond what the parameter of this control takes: 10 to 9999 r/min.
    "#]]
    .assert_eq(&findings(
        "gsk-980tdc",
        &[
            ("offset-zero", "1001"),
            ("offset-full", "1999"),
            ("stage-1", "9"),
            ("stage-2", "9999"),
            ("stage-3", "10000"),
        ],
    ));
    expect![[""]]
        .assert_eq(&findings("knd-k2000t", &[("offset-zero", "1001"), ("stage-1", "9"), ("stage-3", "10000")]));
    expect![[r#"
        Info : Constant surface speed of the Mitsubishi E60 is not simulated, and the program goes without it: the spindle keeps the speed of the stock’s diameter.
    "#]].assert_eq(&findings("mitsubishi-e60", &[]));
    expect![[r#"
        Warning lock-code: Position control alone holds the spindle at its angle: before a keyway is cut it has to be locked. Say which M code of the machine does that, and the program locks it.
        Warning driven-tool: A keyway is cut by a driven tool while the spindle stands still, and this machine has none: the program stops at the angle with M0. Say that it has one, and the program cuts the keyway.
    "#]].assert_eq(&findings("sinumerik-802d", &[("keyway", "true")]));
    expect![[r#"
        Warning release-code: The spindle stays locked at the end of the program, and the next start turns against the lock: say which M code releases it.
        Warning keyway-depth: The machine has a driven tool, and the keyway no depth: the program stops at the angle with M0. Give a depth, and it cuts the keyway.
    "#]]
        .assert_eq(&findings("sinumerik-802d", &[("keyway", "true"), ("lock-code", "81"), ("driven-tool", "true")]));
    expect![[r#"
        Error finished-diameter: Turned down to 0 mm nothing is left of the part: take a larger diameter.
    "#]]
    .assert_eq(&findings("sinumerik-802d", &[("path", "turning"), ("finished-diameter", "0")]));
    // A speed below 1 r/min, too low for S in whole numbers, with one speed for the whole cut.
    expect![[r#"
        Error cutting-speed: 0.2 m/min at the 80 mm of the stock is less than 1 r/min, which S in whole numbers makes S0: the spindle would stand. Take a higher cutting speed.
    "#]]
        .assert_eq(&findings("sinumerik-802d", &[("speed-mode", "fixed"), ("cutting-speed", "0.2")]));
    expect![[""]].assert_eq(&findings("sinumerik-802d", &[("cutting-speed", "0.2")]));
}

#[test]
fn signed_output_exists_where_the_control_has_one() {
    for (control, signed) in
        [("gsk-980tdc", false), ("sinumerik-802d", true), ("knd-k2000t", true), ("mitsubishi-e60", false)]
    {
        let project = ideal(control, &[("output", "+-10"), ("direction", "ccw")]);
        assert_eq!(project.prepared().hidden().contains(&"output"), !signed, "{control}");
        let planner = over_time(&project);
        let (from, _) = cuts(&project, &planner)[0];
        let volts = planner.timeline().at(from + 0.1).spindle.volts;
        assert_eq!(volts < 0.0, signed, "{control}: {volts}");
        assert!(volts.abs() > 1.0);
    }
}

#[test]
fn charts_over_the_speed_have_every_gear_stage() {
    for control in machine().controls() {
        for changes in [&[("stage-2", "1200"), ("stage-3", "0")][..], &[("stage-2", "0")], &[("site-share", "80")]] {
            let changes = &[changes, &[("material", "none"), ("cutting-force", "800")]].concat();
            let project = ideal(control, changes);
            let planner = over_time(&project);
            let charts = project.prepared().charts(&planner, 0.0, planner.timeline().end(), 200);
            let chart = |id: &str| charts.iter().find(|chart| chart.id == id).unwrap();
            let (torque, power) = (chart("torque-speed"), chart("power-speed"));
            let stages = |labels: &[&str]| labels.iter().filter(|label| label.contains("stage-")).count();
            let labels: Vec<&str> = torque.series.iter().map(|line| line.label).collect();
            let prepared = project.prepared();
            let fitted = ["stage-2", "stage-3", "stage-4"].into_iter();
            let fitted = fitted.take_while(|id| !prepared.hidden().contains(id) && number(&project, id) > 0.0);
            assert_eq!(stages(&labels), 1 + fitted.count(), "{control} {changes:?}");
            for (of_torque, of_power) in torque.series.iter().zip(&power.series) {
                assert_eq!(of_torque.label, of_power.label);
                for ((speed, torque), (other, power)) in of_torque.points.iter().zip(&of_power.points) {
                    assert_eq!(speed, other);
                    assert!((power - torque * speed / 9_549.296_585_513_72).abs() <= 1e-9 * power.abs(), "{control}");
                }
            }
            // A stage ends at the end of its analog output, and the torque of the cut at the stock's diameter is the result.
            let first = torque.series[0].points.last().unwrap();
            assert_eq!(first.0, number(&project, "stage-1"));
            let cut = torque.series.iter().find(|line| line.label == "lathe.chart.cut").unwrap();
            assert!((cut.points.last().unwrap().1 - value(&project, "torque")).abs() < 1e-9, "{control} {changes:?}");
            // The infeed from the clearance begins at Ø 84.
            let slower = if prepared.hidden().contains(&"lower-limit") { 1.0 } else { 80.0 / 84.0 };
            let (speed, way_in) = (cut.points.last().unwrap().0, value(&project, "speed-largest"));
            assert!((speed * slower - way_in).abs() < 1e-9, "{control} {changes:?}: {speed}, {way_in}");
        }
    }
}

#[test]
fn charts_and_results_show_the_same_speed() {
    for control in machine().controls() {
        for changes in [
            &[("override", "120"), ("upper-limit", "900")][..],
            &[("offset-full", "500"), ("stage-2", "1200"), ("stage-3", "0")],
            &[("lower-limit", "800"), ("override", "80")],
        ] {
            let project = ideal(control, changes);
            let planner = over_time(&project);
            let charts = project.prepared().charts(&planner, 0.0, planner.timeline().end(), 50);
            let chart = charts.iter().find(|chart| chart.id == "speed-diameter").unwrap();
            let surface = project.control.can(macroline::controls::Code::SurfaceSpeed);
            let line = &chart.series[usize::from(!surface)].points;
            let (small, large) = (line.first().unwrap().1, line.last().unwrap().1);
            let wanted = ["speed-smallest", "speed-largest"].map(|id| value(&project, id));
            assert!((small - wanted[0]).abs() < 1e-9 && (large - wanted[1]).abs() < 1e-9, "{control} {changes:?}");
            // And so does the run, where the tool cuts.
            let (from, to) = cuts(&project, &planner)[0];
            for t in [from + 1e-4, to - 1e-4] {
                let now = planner.timeline().at(t);
                let x = project.control.axis(Address::X).unwrap();
                let diameter = 2.0 * now.axes[x].position;
                let at = line.windows(2).find(|pair| (pair[0].0..=pair[1].0 + 1e-6).contains(&diameter)).unwrap();
                let (low, high) = (at[0].1.min(at[1].1), at[0].1.max(at[1].1));
                assert!(
                    (low * 0.999..=high * 1.001).contains(&now.spindle.command.abs()),
                    "{control} {changes:?} {diameter}: {} in {low}..{high}",
                    now.spindle.command
                );
            }
        }
    }
}

#[test]
fn pass_count_is_independent_of_query_order() {
    let project = ideal("gsk-980tdc", &[("path", "taper"), ("depth", "1")]);
    let planner = over_time(&project);
    let end = planner.timeline().end();
    let begun = |fresh: &Planner<Interp>, t: f64| [36, 37, 50].map(|block| fresh.executions(block, t).begun);
    let moments: Vec<f64> = (0..400).map(|at| end * f64::from(at) / 399.0).collect();
    // Forward, as in play; and back and forth, as in scrubbing.
    let forward: Vec<_> = moments.iter().map(|&t| begun(&planner, t)).collect();
    let looked = over_time(&project);
    for at in (0..400).map(|at| at * 157 % 400) {
        assert_eq!(begun(&looked, moments[at]), forward[at]);
    }
    assert_eq!(forward[399], [30, 30, 1]);
    // A change of an earlier event restarts the count.
    let mut changed = planner.clone();
    changed.event(Event { t: end / 2.0, action: Action::Reset });
    changed.advance(f64::INFINITY, usize::MAX);
    let half = begun(&changed, f64::INFINITY);
    assert!(half[0] < 30 && half == begun(&planner, end / 2.0), "{half:?}");
}

#[test]
fn part_beyond_the_travels_is_an_error() {
    expect![[r#"
        Error length: The cut ends 1000 mm behind the face; the chuck, with the clearance, leaves 83 mm. A longer stock or less of it in the chuck help.
        Error travel-x: From its start the tool has to move 65 mm, the slide has 60 mm: start nearer to the part, or take a shorter one.
        Error travel-z: From its start the tool has to move 1100 mm, the slide has 1000 mm: start nearer to the part, or take a shorter one.
    "#]].assert_eq(&findings(
        "gsk-980tdc",
        &[("path", "turning"), ("length", "1000"), ("travel-x", "60"), ("travel-z", "1000")],
    ));
    // Unknown, or far enough: from the start at 150 mm to a diameter of 20 mm, 100 mm and the length along the part.
    expect![[""]].assert_eq(&findings("gsk-980tdc", &[("path", "turning"), ("travel-x", "65"), ("travel-z", "160")]));
    // A face begins in front of its allowance, which may be farther out than the start.
    near(value(&project("gsk-980tdc", &[("allowance", "70"), ("start-z", "10")]), "z-travel"), 70.0, 1e-9);
}

#[test]
fn feed_into_work_at_standstill_is_reported() {
    let is_reported = |project: &Project| {
        let planner = over_time(project);
        planner.diagnostics().iter().any(|found| found.message.id == "motion.feed-without-rotation")
    };
    for (spindle, wanted) in [("M03 S300", false), ("M05", true)] {
        let mut project = project("gsk-980tdc", &[("stock-diameter", "80")]);
        let mut files = project.written().files;
        files.0[0].text = format!("O9201\nG98 {spindle}\nG00 X70. Z2.\nG01 Z-10. F200\nG00 X90.\nM30\n%\n");
        project.edited = Some(files);
        assert_eq!(is_reported(&project), wanted, "{spindle}");
    }
    // A driven tool cuts the keyway while the spindle holds its angle.
    let keyway = Project::named("turning-spindle", Some("sinumerik-802d"), Some("keyway")).unwrap();
    assert!(PATHS.iter().all(|path| !is_reported(&project("gsk-980tdc", &[("path", path)]))) && !is_reported(&keyway));
}

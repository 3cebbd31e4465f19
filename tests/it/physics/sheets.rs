//! Programs of the fact sheets on their plants: speeds, angles, volts and findings of the text.

use std::rc::Rc;

use macroline::controls::bench::BenchShift;
use macroline::drives::{Bound, Positioning, SpeedRange, Stage};
use macroline::interp::{Interp, StartProgram};
use macroline::motion::SpindleState;
use macroline::nc::{Files, parse_with};
use macroline::text::Severity;

use super::*;
use crate::queries::first_at;

/// A program on a control: switches, operator, plant (changed from a lathe without inertia) and the builder's PLC.
struct Lathe {
    control: &'static Control,
    switches: Switches,
    events: Vec<Event>,
    plant: Plant,
    plc: BenchPlc,
}

impl Lathe {
    fn new(control: &str, switches: &[(&str, &str)]) -> Lathe {
        let control = controls::find(control).unwrap();
        let switches = Switches(switches.iter().map(|(id, value)| (id.to_string(), value.to_string())).collect());
        let slide = |letter, diameter| AxisPlant { diameter, time_constant: 0.0, position_gain: 1e4, ..axis(letter) };
        let rules = Dialect::resolve(control, &switches).spindle();
        let spindle = SpindlePlant::new(Analog::unipolar(3500.0, 10.0), 3500.0, 0.0, rules);
        let positioning = Some(Positioning { speed: 100.0, acceleration: 500.0, clockwise: true });
        let plant = Plant {
            axes: vec![
                slide(Address::X, Dialect::resolve(control, &switches).counts_diameters(0)),
                slide(Address::Z, false),
            ],
            spindle: SpindlePlant { positioning, centre: Some(0.0), ..spindle },
            ..plant()
        };
        let shift = BenchShift { volts: 0.0, before: 0.0, meshing: 0.0, after: 0.0 };
        let bench = Bench { fin_delay: 0.01, override_echo: None, shift, ..control.bench };
        let plc = BenchPlc::new(&bench, &rules);
        Lathe { control, switches, events: Vec::new(), plant, plc }
    }

    /// The machine of `sinumerik-802d.md` section 7: MD35100 = 3500, MD35130 = 2800, MD35140 = 30.
    fn of_the_sheet(switches: &[(&str, &str)]) -> Lathe {
        let mut lathe = Lathe::new("sinumerik-802d", switches);
        lathe.plant.spindle =
            lathe.plant.spindle.with_stages([Stage { range: SpeedRange::new(30.0, 2800.0), ..Stage::new(3500.0) }]);
        lathe
    }

    fn run(self, lines: &str) -> Planner<Interp> {
        let source = match self.control.syntax.names {
            Some(_) => format!("%_N_SHEET_MPF\n{lines}\n"),
            None => format!("O1\n{lines}\n%\n"),
        };
        let parsed = parse_with(&Files::one("SHEET.nc", source), self.control, &self.switches);
        let mut planner = Planner::new(Setup {
            program: Interp::new(Rc::new(parsed), StartProgram::First),
            control: self.control,
            plant: &self.plant,
            plc: Box::new(self.plc),
            panel: Panel::new(self.events),
            limits: Budget { blocks: 10_000, seconds: 3600.0 },
            keep: Retention::Timeline,
            findings: Vec::new(),
        });
        planner.advance(f64::INFINITY, usize::MAX);
        planner
    }
}

fn last(planner: &Planner<Interp>) -> SpindleState {
    planner.timeline().at(planner.timeline().end()).spindle
}

fn finding_ids(planner: &Planner<Interp>) -> Vec<&'static str> {
    planner.diagnostics().iter().map(|found| found.message.id).collect()
}

/// Time (s) at which the block with a sequence number begins.
fn begins(planner: &Planner<Interp>, number: &str) -> f64 {
    let source = &planner.program().parsed().files().0[0].text;
    let at = source.find(&format!("\n{number} ")).unwrap() as u32 + 1;
    let mut t = 0.0;
    while planner.timeline().block_at(t).is_none_or(|place| place.span.start != at) {
        t = planner.timeline().next_block(t).unwrap();
    }
    t
}

#[test]
fn speed_limits_match_the_fact_sheet_cases() {
    // sinumerik-802d.md section 7: G25 = 50, G26 = 3000, LIMS = 2500; programmed speed, override, actual speed, limit that acts.
    let (six, five) = (682.092_613, 545.674_091);
    for (lines, percent, wanted, bound) in [
        ("G97 S3200 M3", 100.0, 2800.0, Bound::Gear),
        ("G97 S2700 M3", 100.0, 2700.0, Bound::None),
        ("G97 S2600 M3", 120.0, 2800.0, Bound::Gear),
        ("G97 S20 M3", 100.0, 50.0, Bound::Lower),
        ("G97 S0 M3", 100.0, 0.0, Bound::None),
        ("G0 X84\nG96 S180 F.2 M3", 100.0, six, Bound::None),
        ("G0 X84\nG96 S180 F.2 M3", 80.0, five, Bound::None),
        ("G0 X10\nG96 S180 F.2 M3", 100.0, 2500.0, Bound::Surface),
        ("G0 X0\nG96 S180 F.2 M3", 100.0, 2500.0, Bound::Surface),
    ] {
        let mut lathe = Lathe::of_the_sheet(&[]);
        lathe.events = vec![at(0.0, Action::SpindleOverride(percent))];
        let planner = lathe.run(&format!("G25 S50\nG26 S3000\nLIMS=2500\n{lines}\nG4 F1\nM0"));
        let now = last(&planner);
        assert!((now.command - wanted).abs() < 1e-5, "{lines}: {}", now.command);
        assert_eq!(now.bound, bound, "{lines}");
    }
    // Override 0 stops; a panel may not go so far.
    for (knob, rpm) in [("0-to-200", 0.0), ("50-to-120", 500.0)] {
        let mut lathe = Lathe::new("sinumerik-802d", &[("spindle-knob", knob)]);
        lathe.events = vec![at(0.0, Action::SpindleOverride(0.0))];
        assert_eq!(last(&lathe.run("G25 S50\nS1000 M3\nG4 F1\nM0")).command, rpm);
    }
    // LIMS in G97 too, as on the 840D.
    let planner = Lathe::of_the_sheet(&[("lims-in-g97", "yes")]).run("G26 S3000\nLIMS=2500\nG97 S2700 M3\nG4 F1\nM0");
    assert_eq!(last(&planner).command, 2500.0);
    // Without G25 the gear's own lowest speed holds; where both cannot be, the upper limit does.
    let planner = Lathe::of_the_sheet(&[]).run("G97 S20 M3\nG4 F1\nM0");
    assert_eq!((last(&planner).command, last(&planner).bound), (30.0, Bound::GearLow));
    for (crossed, rpm) in [("upper-holds", 60.0), ("lower-holds", 900.0)] {
        let lathe = Lathe::of_the_sheet(&[("crossed-limits", crossed)]);
        assert_eq!(last(&lathe.run("G25 S900\nG26 S60\nS100 M3\nG4 F1\nM0")).command, rpm);
    }
    for (lines, alarm) in [("G25 S50 X10", "12120"), ("G96", "10900"), ("SPOS=360", "16830"), ("G96 S10000", "14840")] {
        let mut planner = Lathe::of_the_sheet(&[]).run(lines);
        let found = planner.program().parsed().diagnostics().iter().chain(planner.diagnostics());
        let alarms: Vec<_> = found.filter_map(|found| found.alarm.clone()).collect();
        assert!(alarms.iter().any(|shown| shown == alarm), "{lines}: {alarms:?}");
        assert!(matches!(planner.advance(f64::INFINITY, usize::MAX).ended, Some(RunEnd::Alarm(_))));
    }
}

/// The worked program A, without the cuts of the keyway's own tool.
const FACE: &str = "G18 G71 G90 G40 G54 G64 DIAMON
N20 G25 S50
N30 G26 S3000
N40 T1 D1
N50 G95 S800 M3 F0.2
N60 G0 X92 Z5
N70 G96 S180 LIMS=2500 F0.2
N80 G0 Z0
N90 G0 X84
N95 G4 F1
N100 G1 X-1.6
N110 G0 Z5
N120 G0 X120 Z150
N130 G97 S300
N140 M5
N150 SPOS=0
N160 M81
N170 T5 D1
N180 G94 F120
N190 SETMS(2)
N200 S1500 M3
N210 G0 X42 Z-10
N220 G1 X34 F40
N230 G1 Z-30 F120
N240 G0 X60
N250 M5
N260 SETMS(1)
N270 M80
N280 SPOS=IC(180)
N290 M0";

#[test]
fn worked_802d_program_faces_and_stops_at_keyways() {
    for (at_once, first) in [("yes", 622.780_212), ("no", 800.0)] {
        let planner = Lathe::of_the_sheet(&[("g96-apply-at-activation", at_once)]).run(FACE);
        let command = |number: &str| planner.timeline().at(begins(&planner, number) + 1e-6).spindle.command;
        close(command("N60"), 800.0, 1e-12);
        close(command("N80"), first, 1e-7);
        close(command("N100"), 682.092_613, 1e-6);
        let (from, to) = (begins(&planner, "N100"), begins(&planner, "N110"));
        close(to - from, 10.019_832, 1e-5);
        for (diameter, rpm) in [(60.0, 954.930), (40.0, 1432.394), (30.0, 1909.859), (22.0, 2500.0), (10.0, 2500.0)] {
            let passed = first_at(&planner, from, |now| 2.0 * now.axes[0].position <= diameter);
            close(planner.timeline().at(passed).spindle.command, rpm, 2e-4);
        }
        close(command("N120"), 2500.0, 1e-12);
        close(planner.timeline().at(begins(&planner, "N140") - 1e-6).spindle.command, 300.0, 1e-12);
        let held = planner.timeline().at(begins(&planner, "N160") + 1e-6).spindle;
        assert!(held.held && held.angle == 0.0, "{held:?}");
        // A command of the second spindle leaves the first at its angle.
        let held = planner.timeline().at(begins(&planner, "N230") + 0.1).spindle;
        assert!(held.held && held.angle == 0.0, "{held:?}");
        let end = last(&planner);
        assert!(end.held && (end.angle - 180.0).abs() < 1e-9, "{end:?}");
        assert_eq!(finding_ids(&planner), [""; 0]);
    }
}

#[test]
fn spos_words_choose_their_direction() {
    // sinumerik-802d.md section 3.6: from, target, state before, form, angle to go, end.
    for (from, state, form, way, end) in [
        (10.0, "S1 M3", "90", 80.0, 90.0),
        (10.0, "S1 M4", "90", -280.0, 90.0),
        (350.0, "", "20", 30.0, 20.0),
        (20.0, "", "350", -30.0, 350.0),
        (20.0, "S1 M3", "350", 330.0, 350.0),
        (20.0, "S1 M4", "350", -30.0, 350.0),
        (0.0, "", "180", 180.0, 180.0),
        (100.0, "", "ACP(50)", 310.0, 50.0),
        (100.0, "", "ACN(50)", -50.0, 50.0),
        (100.0, "", "DC(50)", -50.0, 50.0),
        (100.0, "", "IC(-450)", -450.0, 10.0),
        (100.0, "", "AC(50)", -50.0, 50.0),
    ] {
        let mut lathe = Lathe::new("sinumerik-802d", &[]);
        // A spindle that turns slowly and stops at once needs no more than the angle to go.
        lathe.plant.spindle.positioning = Some(Positioning { speed: 100.0, acceleration: 1e9, clockwise: true });
        let planner = lathe.run(&format!("SPOS=0\nSPOS={from}\n{state}\nN9 SPOS={form}\nM0"));
        let begin = begins(&planner, "N9");
        let before = planner.timeline().at(begin).spindle;
        // While it waits for the block it turns on, by less than a degree.
        let turned = (last(&planner).turns - before.turns) * 360.0;
        let late = if state.is_empty() { 0.0 } else { before.turns * 360.0 - from };
        let late = (late + 180.0).rem_euclid(360.0) - 180.0;
        assert!((turned + late - way).abs() < 1e-6, "{from} {state} {form}: {turned} {late}");
        assert!((last(&planner).angle - end).abs() < 1e-6 && last(&planner).held);
    }
}

#[test]
fn shifted_work_zero_under_surface_speed_is_a_finding() {
    let shifted = |lines: &str| {
        let planner = Lathe::new("sinumerik-802d", &[]).run(&format!("S100 M3\n{lines}\nM0"));
        (finding_ids(&planner), last(&planner).command)
    };
    assert_eq!(shifted("G0 X50\nG96 S100 F.1\nG1 X40").0, [""; 0]);
    let (ids, rpm) = shifted("TRANS X10\nG96 S100 F.1\nG0 X40\nG1 X30");
    assert_eq!(ids, ["motion.off-centre"]);
    // The control takes 30 mm for the diameter where the tool is at 40 mm.
    close(rpm, 1000.0 * 100.0 / (math::PI * 30.0), 1e-6);
    // A small offset is a remark; a setting of the control defines small.
    assert_eq!(shifted("G96 S100 F.1\nATRANS X.02 Z5\nG1 X30").0, ["motion.small-offset"]);
    assert_eq!(
        shifted("G96 S100 F.1\nATRANS X.2\nATRANS X.02\nG1 X30").0,
        ["motion.small-offset", "motion.off-centre"]
    );
    let exact =
        Lathe::new("sinumerik-802d", &[("small-offset", "nothing")]).run("S100 M3\nTRANS X.02\nG96 S100 F.1\nM0");
    assert_eq!(finding_ids(&exact), ["motion.off-centre"]);
    assert_eq!(shifted("TRANS Z5\nG96 S100 F.1\nG1 X30").0, [""; 0]);
    assert_eq!(shifted("TRANS X10\nG1 X30 F.1").0, [""; 0]);
    // Other controls shift by G50 and by offsets.
    let planner = Lathe::new("gsk-980tdc", &[]).run("G50 X80. Z0.\nG96 S100 M03\nG01 X70. F100\nM00");
    assert_eq!(finding_ids(&planner), ["motion.off-centre"]);
}

#[test]
fn rapid_looks_ahead_to_next_block_or_next_motion() {
    // 100 m/min: 318.31 r/min at X100, 1591.549 at X20.
    let during = |switches: &[(&str, &str)], between: &str| {
        let lines = format!("G0 X100\nG96 S100 M3 F.1\nG4 F1\nN8 G0 X20\n{between}N9 G1 Z-5\nM0");
        let planner = Lathe::new("sinumerik-802d", switches).run(&lines);
        planner.timeline().at(begins(&planner, "N8") + 0.05).spindle.command.round()
    };
    // A remark is no block; an assignment, a modal code and an M code are.
    for (between, block) in [("", 1592.0), ("; HERE\n", 1592.0), ("R1=5\n", 318.0), ("G64\n", 318.0), ("M8\n", 318.0)] {
        assert_eq!(during(&[], between), block, "{between}");
        assert_eq!(during(&[("rapid-look-ahead", "next-motion")], between), 1592.0, "{between}");
    }
    assert_eq!(during(&[("rapid-look-ahead", "next-motion")], "G0 Z1\n"), 318.0);
}

#[test]
fn gsk_output_is_zero_at_power_on_and_s0_unless_set() {
    // No.036 = 20 mV; the converter's nearest step is 19.5 mV.
    let volts = |switches: &[(&str, &str)]| {
        let mut lathe = Lathe::new("gsk-980tdc", switches);
        lathe.plant.spindle.analog.offset_zero = 0.02;
        let planner = lathe.run("G04 X1.\nN7 S350 M03\nG04 X1.\nN8 S0\nG04 X1.\nM00");
        let at = |t: f64| (planner.timeline().at(t).spindle.volts * 1e4).round() / 1e4;
        [at(0.5), at(begins(&planner, "N7") + 0.9), at(begins(&planner, "N8") + 0.9)]
    };
    assert_eq!(volts(&[]), [0.0, 1.0183, 0.0]);
    assert_eq!(volts(&[("offset-at-rest", "put-out")]), [0.0195, 1.0183, 0.0195]);
}

#[test]
fn gsk_voltage_follows_x_in_cuts_alone_unless_set() {
    // 100 m/min: 353.68 r/min at X90, 1061.03 at X30, 1591.55 at X20.
    let speeds = |switches: &[(&str, &str)]| {
        let lines = "G00 X90.\nG96 S100 M03\nG04 X1.\nN7 G00 X30.\nG04 X1.\nN8 G01 X20. F100\nN9 G04 X1.\nM00";
        let planner = Lathe::new("gsk-980tdc", switches).run(lines);
        let at = |t: f64| planner.timeline().at(t).spindle.command.round();
        let [n7, n8, n9] = ["N7", "N8", "N9"].map(|number| begins(&planner, number));
        [at(n7 - 0.1), at(n7 + 0.01), at(n8 - 0.1), at(n8 + 0.001), at(n9 + 0.5)]
    };
    assert_eq!(speeds(&[]), [354.0, 354.0, 354.0, 1061.0, 1592.0]);
    assert_eq!(speeds(&[("speed-in-rapid", "of-end")]), [354.0, 1061.0, 1061.0, 1061.0, 1592.0]);
}

#[test]
fn motion_on_the_spindle_ramp_is_reported_once_a_block() {
    let found = |switches: &[(&str, &str)], lines: &str| {
        let mut lathe = Lathe::new("sinumerik-802d", switches);
        lathe.plant.spindle.ramp = 3.5;
        finding_ids(&lathe.run(&format!("G94 F100\n{lines}\nM0")))
    };
    let free = [("speed-reached", "no-wait")];
    let (rapid, cut) = ("motion.rapid-while-ramping", "motion.cut-while-ramping");
    assert_eq!(found(&[], "S1000 M3 G0 X50"), [rapid]);
    assert_eq!(found(&[], "S1000 M3\nG4 F5\nG0 X50"), [""; 0]);
    assert_eq!(found(&[], "S1000 M3\nG1 X50"), [""; 0]);
    assert_eq!(found(&free, "S1000 M3\nG1 X50"), [cut]);
    assert_eq!(found(&free, "S1000 M3\nG4 F5\nG1 X5\nS2000\nG1 X9"), [cut]);
    assert_eq!(found(&[], "S1000 M3\nG4 F5\nS2000\nG0 X9"), [rapid]);
    assert_eq!(found(&free, "S1000 M3 G0 X1\nG1 X2\nX2.1"), [rapid, cut, cut]);
    assert_eq!(found(&[], "S1000 M3\nG4 F5\nM5\nG0 X9"), [""; 0]);
    // Every pass of a loop meets the ramp; the block is reported once.
    let passes = "R1=0\nAB: S=500+R1*500 M3\nG0 X=R1+1\nR1=R1+1\nIF R1<5 GOTOB AB";
    assert_eq!(found(&[], passes), [rapid]);
    // Under constant surface speed the speed follows the axes; its start is a ramp like any other.
    assert_eq!(found(&[], "G0 X20\nG96 S100 F.1 M3\nG0 X50\nG1 X40"), [rapid]);
    assert_eq!(found(&[], "G0 X20\nG96 S100 F.1 M3\nG4 F5\nG0 X50\nG1 X10\nG0 X50\nG1 Z5"), [""; 0]);
}

/// The spindle override does not act in a thread: with the knob elsewhere the spindle goes back to S as the thread begins.
#[test]
fn thread_on_the_ramp_from_the_knob_is_a_finding() {
    let found = |control: &str, percent: f64, lines: &str| {
        let mut lathe = Lathe::new(control, &[]);
        lathe.plant.spindle.ramp = 3.5;
        lathe.events = vec![at(0.0, Action::SpindleOverride(percent))];
        finding_ids(&lathe.run(lines))
    };
    let thread = "G97 S1000 M03\nG04 X5.\nG00 Z5.\nG32 Z-20. F1.\nM00";
    let cut = "motion.cut-while-ramping";
    assert_eq!(found("fanuc-0i-tf", 120.0, thread), [cut]);
    assert_eq!(found("fanuc-0i-tf", 50.0, thread), [cut]);
    assert_eq!(found("fanuc-0i-tf", 100.0, thread), [""; 0]);
    assert_eq!(found("fanuc-0i-tf", 120.0, "G98 S1000 M03\nG04 X5.\nG01 Z-20. F100.\nM00"), [""; 0]);
}

#[test]
fn cutting_at_an_angle_without_lock_is_a_finding() {
    let found = |switches: &[(&str, &str)], lines: &str| {
        let planner = Lathe::new("sinumerik-802d", switches).run(&format!("G94 S300 M3\n{lines}\nM0"));
        finding_ids(&planner)
    };
    let both = ["motion.not-locked", "motion.no-driven-tool"];
    assert_eq!(found(&[], "SPOS=0\nG1 X10 F100\nX20"), both);
    assert_eq!(found(&[], "SPOS=0\nM8\nG1 X10 F100"), both);
    assert_eq!(found(&[], "SPOS=0\nG0 X10"), [""; 0]);
    assert_eq!(found(&[], "SPOS=0\nM3\nG1 X10 F100"), [""; 0]);
    assert_eq!(found(&[], "SPOS=0\nM81\nG1 X10 F100"), ["motion.no-driven-tool"]);
    assert_eq!(found(&[], "SPOS=0\nM2=3\nG1 X10 F100"), ["motion.not-locked"]);
    assert_eq!(found(&[], "SPOS=0\nM81\nSETMS(2)\nS900 M4\nG1 X10 F100"), [""; 0]);
    assert_eq!(found(&[], "M2=3\nSPOS=0\nM81\nM2=5\nG1 X10 F100"), ["motion.no-driven-tool"]);
    // A tap in the work's own centre turns the spindle from its angle.
    assert_eq!(found(&[], "SPOS=0\nG331 Z-5 K1 S100\nG332 Z5 K1"), [""; 0]);
    // The next angle needs the lock again.
    assert_eq!(found(&[], "M2=3\nSPOS=0\nM81\nG1 X10 F100\nSPOS=90\nG1 X20"), ["motion.not-locked"]);
    let known = [("spindle-lock", "M81"), ("driven-tool", "M24")];
    assert_eq!(found(&known, "SPOS=0\nM80\nM24\nG1 X10 F100"), ["motion.not-locked"]);
    assert_eq!(found(&known, "SPOS=0\nM81\nM24\nG1 X10 F100"), [""; 0]);
}

#[test]
fn m03_after_m04_raises_the_gsk_ladder_alarm() {
    let run = |switches: &[(&str, &str)], lines: &str| Lathe::new("gsk-980tdc", switches).run(lines);
    for (lines, rpm) in [("S500 M03\nG04 X1.\nM04\nG04 X1.\nM00", 500.0), ("S500 M04\nG04 X1.\nM03\nM00", -500.0)] {
        let planner = run(&[], lines);
        let alarms: Vec<_> = planner.diagnostics().iter().map(|found| found.alarm.as_deref()).collect();
        assert_eq!((finding_ids(&planner), alarms), (vec!["motion.spindle-reversal"], vec![Some("A0.3")]));
        // The first speed command stays out.
        assert_eq!(last(&planner).command, rpm);
    }
    for lines in ["S500 M03\nM05\nM04\nG04 X1.\nM00", "S500 M03\nM03\nM05\nM04\nM00", "S500 M04\nS300\nM04\nM00"] {
        let planner = run(&[], lines);
        assert_eq!(finding_ids(&planner), [""; 0], "{lines}");
        assert!(last(&planner).command < 0.0);
    }
    let planner = run(&[("m03-m04", "turns-back")], "S500 M03\nM04\nG04 X1.\nM00");
    assert_eq!((finding_ids(&planner), last(&planner).command), (vec![], -500.0));
    // Reset takes both away.
    let mut lathe = Lathe::new("gsk-980tdc", &[]);
    lathe.events = vec![at(0.5, Action::Reset), at(1.0, Action::Start)];
    let planner = lathe.run("#101=#101+1\nIF[#101 EQ 2]GOTO9\nS500 M03\nG04 X9.\nN9 S400 M04\nG04 X1.\nM00");
    assert_eq!((finding_ids(&planner), last(&planner).command), (vec![], -400.0));
}

#[test]
fn late_gear_raises_the_gsk_ladder_alarm() {
    for (patience, alarm) in [(None, None), (Some(2.0), None), (Some(0.4), Some("A1.0"))] {
        let mut lathe = Lathe::new("gsk-980tdc", &[]);
        lathe.plant.spindle = lathe.plant.spindle.with_stages([1000.0, 3000.0].map(Stage::new));
        lathe.plc.shift = GearShift { volts: 0.1, before: 1.0, meshing: 0.5, after: 1.0, patience };
        let planner = lathe.run("S500 M03\nN2 M42\nN3 G04 X1.\nM00");
        assert_eq!(planner.diagnostics().iter().find_map(|found| found.alarm.as_deref()), alarm);
        let (begin, end) = (begins(&planner, "N2"), planner.timeline().end());
        match alarm {
            None => assert_eq!(last(&planner).stage, 2),
            // The old gear is out, the new one not in: nothing else happens.
            Some(_) => {
                close(end - begin, 1.4, 1e-6);
                assert_eq!(planner.timeline().at(end).mode, Mode::Alarm);
                let late = planner.timeline().at(begin + 1.2).spindle;
                assert_eq!((late.volts_command, late.stage), (0.1, 1));
            }
        }
    }
}

#[test]
fn m05_beside_motion_acts_by_the_control() {
    // The page on the 802D puts M5 after the motion, the other manuals before it; on the TDc a bit of the PLC decides.
    for (control, setting, stands) in [
        ("sinumerik-802d", "before", true),
        ("sinumerik-802d", "end", false),
        ("gsk-980tdc", "end", false),
        ("gsk-980tdc", "before", true),
    ] {
        let per_minute = if control == "gsk-980tdc" { "G98 F60" } else { "G94 F60" };
        let lathe = Lathe::new(control, &[("m5-timing", setting)]);
        let planner = lathe.run(
            &format!("{per_minute} S500 M3\nN2 G1 X4. M5\nN3 G4 X1.\nM0")
                .replace("G4 X1.", if control == "gsk-980tdc" { "G4 X1." } else { "G4 F1" }),
        );
        let now = planner.timeline().at(begins(&planner, "N2") + 1.0);
        assert!(now.axes[0].feed > 0.0);
        assert_eq!(now.spindle.command == 0.0, stands, "{control} {setting}");
        assert_eq!(last(&planner).command, 0.0);
    }
}

#[test]
fn gsk_output_keeps_its_volts_unless_a_parameter_clears_them() {
    let volts = |switches: &[(&str, &str)], action: Option<Action>, lines: &str| {
        let mut lathe = Lathe::new("gsk-980tdc", switches);
        lathe.events = action.into_iter().map(|action| at(2.0, action)).collect();
        last(&lathe.run(lines)).volts_command
    };
    let (run, stop) = ("S700 M03\nG04 X9.\nM00", "S700 M03\nG04 X1.\nM05\nG04 X1.\nM00");
    // 2.2.2: kept after S, at M05, reset and emergency stop; 0 V after S0.
    for (action, lines) in [(None, stop), (Some(Action::Reset), run), (Some(Action::EmergencyStop), run)] {
        close(volts(&[], action, lines), 2.0, 1e-12);
    }
    assert_eq!(volts(&[], None, "S700 M03\nG04 X1.\nS0\nG04 X1.\nM00"), 0.0);
    assert_eq!(volts(&[("volts-at-stop", "off")], None, stop), 0.0);
    assert_eq!(volts(&[("volts-at-emergency-stop", "off")], Some(Action::EmergencyStop), run), 0.0);
    close(volts(&[("volts-at-emergency-stop", "off")], Some(Action::Reset), run), 2.0, 1e-12);
}

#[test]
fn gsk_manual_sample_gives_its_printed_speeds() {
    // gsk-980tdc.md section 1.3: S300 at 100, 50 and 80 mm; and note 1, G96 with the S that it had.
    for (diameter, rpm) in [(100.0, 955.0), (50.0, 1910.0), (80.0, 1194.0)] {
        for (switches, word) in [(&[][..], diameter), (&[("diameter", "radius")], diameter / 2.0)] {
            let planner =
                Lathe::new("gsk-980tdc", switches).run(&format!("G00 X{word:?}\nM03 G96 S0300\nG04 X1.\nM00"));
            assert_eq!(last(&planner).command.round(), rpm);
        }
    }
    let planner =
        Lathe::new("gsk-980tdc", &[]).run("G00 X60.\nG96 S50 M03\nG97 S1000\nG04 X1.\nG96 X60.\nG04 X1.\nM00");
    close(last(&planner).command, 1000.0 * 50.0 / (math::PI * 60.0), 1e-12);
    // Note 4: without S the last speed is kept. Repeated codes are no alarm.
    let planner = Lathe::new("gsk-980tdc", &[]).run("G00 X60.\nG96 S50 M03\nG96\nG97\nG97\nG00 X90.\nM00");
    close(last(&planner).command, 1000.0 * 50.0 / (math::PI * 60.0), 1e-12);
    // G50 S0 without No.043: the spindle does not turn. No limit at power-on, and none at constant speed.
    let planner = Lathe::new("gsk-980tdc", &[]).run("G00 X60.\nG50 S0\nG96 S50 M03\nG04 X1.\nM00");
    assert_eq!(last(&planner).command, 0.0);
    let planner = Lathe::new("gsk-980tdc", &[]).run("G50 S700\nG97 S900 M03\nG04 X1.\nM00");
    assert_eq!(last(&planner).command, 900.0);
}

#[test]
fn gsk_volts_follow_gears_and_offsets() {
    // gsk-980tdc.md section 6: gears 1000, 2000, 4000, 5000, S800 is 8, 4, 2, 1.6 V.
    for (gear, volts) in [(1, 8.0), (2, 4.0), (3, 2.0), (4, 1.6)] {
        let mut lathe = Lathe::new("gsk-980tdc", &[]);
        lathe.plant.spindle = lathe.plant.spindle.with_stages([1000.0, 2000.0, 4000.0, 5000.0].map(Stage::new));
        let planner = lathe.run(&format!("M4{gear}\nS0800 M03\nG04 X1.\nM00"));
        close(last(&planner).volts_command, volts, 1e-12);
        assert!((last(&planner).volts - volts).abs() <= 10.0 / 4095.0 / 2.0 + 1e-12);
    }
    // No.021 = 100, No.036 = 20, half speed: 5.060 V. The printed formula counts to 9999, ours to 10000: 0.1 mV.
    let analog = Analog { offset_zero: 0.02, offset_rated: 0.1, ..Analog::unipolar(2000.0, 10.0) };
    let printed = |code: f64| ((9999.0 + 100.0 - 20.0) / 9999.0 * code + 20.0 * 4095.0 / 9999.0) / 4095.0 * 10.0;
    for rpm in [0.0, 500.0, 1000.0, 1500.0] {
        assert!((analog.command(rpm) - printed(4095.0 * rpm / 2000.0)).abs() < 1.1e-3, "{rpm}");
    }
    assert!((analog.command(1000.0) - 5.06).abs() < 1e-12);
}

#[test]
fn p9100_in_r_parameters_gives_the_fact_sheet_cases() {
    // sinumerik-802d.md section 8.1: S, override, line speed, feed, status.
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/programs/sinumerik-802d/ok/ribbon.nc");
    let source = std::fs::read_to_string(folder).unwrap();
    for (rpm, percent, line, feed, status) in [
        (1200.0, 80.0, 12_063.716, 95_513.115, 0.0),
        (1200.0, 100.0, 15_079.645, 119_391.393, 2.0),
        (1200.0, 120.0, 18_095.574, 143_269.672, 2.0),
        (600.0, 100.0, 7_539.822, 59_695.697, 0.0),
        (1000.0, 100.0, 12_566.371, 99_492.828, 0.0),
        (1005.097, 100.0, 12_630.421, 99_999.95, 0.0),
        (1005.2, 100.0, 12_631.716, 100_010.19, 2.0),
        (1200.0, 0.0, f64::NAN, f64::NAN, 1.0),
    ] {
        let source =
            source.replace("R100=1200", &format!("R100={rpm}")).replace("R103=100", &format!("R103={percent}"));
        let control = controls::find("sinumerik-802d").unwrap();
        let parsed = parse_with(&Files::one("RIBBON.MPF", source), control, &Switches::default());
        let mut interp = Interp::new(Rc::new(parsed), StartProgram::First);
        macroline::interp::run(&mut interp, &mut macroline::interp::world::MachineAtRest::default(), 10_000, |_, _| {});
        let r = |number: u32| interp.variable(number).unwrap_or(0.0);
        assert_eq!(r(98), status, "{rpm} {percent}");
        if status != 1.0 {
            assert!((r(105) - line).abs() < 0.02 && (r(115) - feed).abs() < 0.05, "{} {}", r(105), r(115));
            close(r(116), 99.492_828, 1e-8);
            close(r(110), 62.831_853, 1e-8);
        }
    }
}

#[test]
fn fact_sheet_programs_have_no_findings() {
    let parsed = parse_with(
        &Files::one("A.MPF", format!("%_N_FACEKEY_MPF\n{FACE}\n")),
        Lathe::new("sinumerik-802d", &[]).control,
        &Switches::default(),
    );
    let bad: Vec<_> = parsed.diagnostics().iter().filter(|found| found.severity > Severity::Info).collect();
    assert!(bad.is_empty(), "{bad:?}");
}

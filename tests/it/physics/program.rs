//! Programs as text, through parser and interpreter, over time.

use std::rc::Rc;

use macroline::controls::{Address, Dialect, Switches};
use macroline::interp::{Interp, StartProgram};
use macroline::motion::PlanProgress;
use macroline::nc::{Files, parse, parse_with};
use macroline::text::{FileId, Place, Span};

use super::*;
use crate::queries::first_at;

/// The ribbon line's loop on the sheet (ribbon-line.md section 6), recomputed only when the override has changed.
const RIBBON: &str = "%
O9101(RIBBON)
N1 #100=1200
N2 #126=-1
N10 #3004=2
N12 S#100M3
N13 G04X2.
N20 G91G94G64
N30 DO1
N31 IF[#1033EQ#126]GOTO33
N32 M98P9100
N33 G01X8.Y62.832F#115
N34 #120=#120+1
N39 END1
M30
%
";
const COMPUTE: &str = "%
O9100(COMPUTE)
#126=#1033
#104=#100*#126/100
#105=[3.14159265*100]/25*#104
#110=[3.14159265*120]/6
#115=#105*SQRT[8*8+#110*#110]/8
M99
%
";

fn ribbon(seconds: f64, events: Vec<Event>) -> Planner<Interp> {
    let mut files = Files::one("O9101.nc", RIBBON);
    files.0.extend(Files::one("O9100.nc", COMPUTE).0);
    let parsed = parse(&files, control());
    assert!(parsed.diagnostics().is_empty(), "{:?}", parsed.diagnostics());
    let mut plant = plant();
    plant.block_time = 0.0071;
    Planner::new(Setup {
        program: Interp::new(Rc::new(parsed), StartProgram::First),
        control: control(),
        plant: &plant,
        plc: Box::new(bench_plc(0.05, Some(1033))),
        panel: Panel::new(events),
        limits: Budget { blocks: u64::MAX, seconds },
        keep: Retention::Timeline,
        findings: Vec::new(),
    })
}

/// A short program, planned to its end.
fn whole(text: &str) -> (Planner<Interp>, PlanProgress) {
    let mut planner = Planner::new(Setup {
        program: Interp::new(Rc::new(parse(&Files::one("O1.nc", text), control())), StartProgram::First),
        control: control(),
        plant: &plant(),
        plc: Box::new(bench_plc(0.05, None)),
        panel: Panel::default(),
        limits: Budget { blocks: 100, seconds: 10.0 },
        keep: Retention::Timeline,
        findings: Vec::new(),
    });
    let progress = planner.advance(f64::INFINITY, usize::MAX);
    (planner, progress)
}

#[test]
fn ribbon_line_runs_at_the_fact_sheet_speed() {
    let mut planner = ribbon(60.0, vec![at(10.0, Action::SpindleOverride(50.0))]);
    let progress = planner.advance(f64::INFINITY, usize::MAX);
    assert_eq!(progress.ended, Some(RunEnd::Seconds), "{:?}", planner.diagnostics());
    assert_eq!(planner.starved(), 0);
    let timeline = planner.timeline();
    close(timeline.at(9.0).axes[0].feed, 15079.645, 3e-6);
    close(timeline.at(9.0).spindle.volts_command, 8.108, 1e-4);
    close(timeline.at(30.0).axes[0].feed, 7539.822, 3e-6);
    close(timeline.at(30.0).spindle.volts_command, 4.054, 1e-4);
    // A block each 31.831 ms, to within the rounding of Y.
    let (from, to) = (planner.variable_at(120, 5.0).unwrap(), planner.variable_at(120, 9.0).unwrap());
    close(4.0 / (to - from), 0.031_831, 0.01);
    // The knob acts after the blocks read ahead: five to six blocks, less the macro blocks between #1033 and the end of the G01 before.
    let change = first_at(&planner, 10.0, |now| now.axes[0].acceleration < -1.0);
    assert!((10.0 + 5.0 * 0.0318 - 0.0191..10.0 + 6.0 * 0.0319).contains(&change), "{change}");
    assert_eq!(planner.variable_at(115, 9.0).map(f64::round), Some(119_391.0));
    assert_eq!(planner.variable_at(115, 12.0).map(f64::round), Some(59_696.0));
}

#[test]
fn program_alarm_waits_for_the_blocks_before_it() {
    let (planner, progress) = whole("%\nO1\nG91G01X10.F6000.\nX10.\n#100=1/0\nM30\n%\n");
    assert!(matches!(progress.ended, Some(RunEnd::Alarm(_))));
    assert_eq!(planner.diagnostics()[0].alarm.as_deref(), Some("P283"));
    let end = planner.timeline().at(progress.planned_to);
    assert_eq!((end.mode, end.axes[0].position), (Mode::Alarm, 20.0));
}

#[test]
fn hour_of_blocks_stays_small_and_replans_from_a_checkpoint() {
    let mut planner = ribbon(3600.0, vec![]);
    planner.advance(f64::INFINITY, usize::MAX);
    assert!(planner.blocks().nc > 113_000, "{:?}", planner.blocks());
    const { assert!(macroline::motion::Timeline::BLOCK_BYTES <= 150) };
    let before = planner.blocks();
    let (old, t) = (planner.timeline().at(3590.0), 3590.5);
    planner.event(at(t, Action::SpindleOverride(80.0)));
    // Planned again: less than a second before the event, and the requested time.
    assert!(before.nc - planner.blocks().nc < 10 * 34 + 40);
    let mut steps = 0;
    while planner.advance(t + 2.0, 100).planned_to < t + 2.0 {
        steps += 100;
    }
    assert!(steps < 2000, "{steps}");
    assert_eq!(planner.timeline().at(3590.0), old);
    close(planner.timeline().at(t + 1.0).axes[0].feed, 0.8 * 15079.645, 3e-6);
}

#[test]
fn executions_in_direct_succession_have_their_own_starts() {
    let text = "O1\n#1=0\nWHILE [#1 LT 5] DO1\n#1=#1+1\nN9 G01 X#1 F6000\nEND1\nM30\n%\n";
    let (planner, _) = whole(text);
    let start = text.find("N9").unwrap() as u32;
    let place = Place { file: FileId(0), span: Span::new(start, start + 2) };
    let (timeline, starts) = (planner.timeline(), planner.timeline().starts(place).collect::<Vec<_>>());
    // Between the executions there are calculations alone: no other block begins.
    assert_eq!((starts.len(), timeline.begins(place).count()), (5, 1));
    assert!(starts.windows(2).all(|pair| pair[0] < pair[1]), "{starts:?}");
    assert_eq!(timeline.begins(place).next(), starts.first().copied());
    // A step goes from one to the next, and back the same way.
    for pair in starts.windows(2) {
        assert_eq!((timeline.next_block(pair[0]), timeline.block_before(pair[1])), (Some(pair[1]), pair[0]));
        assert_eq!(timeline.block_before(pair[0] + 1e-6), pair[0]);
        assert!(timeline.next_other_block(pair[0]) > Some(starts[4]), "{pair:?}");
    }
}

/// The sample of the GSK manual (gsk-980tdc.md section 1.3), on the bench of its control.
fn sample(switches: &[(&str, &str)], lines: &str) -> Planner<Interp> {
    let control = controls::find("gsk-980tdc").unwrap();
    let switches = Switches(switches.iter().map(|(id, set)| (id.to_string(), set.to_string())).collect());
    let parsed = parse_with(&Files::one("O1.nc", format!("O0001\n{lines}\nM30\n%\n")), control, &switches);
    let mut plant = plant();
    plant.axes = vec![AxisPlant { diameter: true, ..axis(Address::X) }, axis(Address::Z)];
    plant.spindle = SpindlePlant::bench(control, Dialect::resolve(control, &switches).spindle());
    let mut planner = Planner::new(Setup {
        program: Interp::new(Rc::new(parsed), StartProgram::First),
        control,
        plant: &plant,
        plc: Box::new(bench_plc(0.05, None)),
        panel: Panel::default(),
        limits: Budget { blocks: 1000, seconds: 600.0 },
        keep: Retention::Timeline,
        findings: Vec::new(),
    });
    planner.advance(f64::INFINITY, usize::MAX);
    planner
}

/// When the n-th block begins.
fn begins_at(planner: &Planner<Interp>, n: usize) -> f64 {
    (0..=n).fold(0.0, |t, _| planner.timeline().next_block(t).expect("so many blocks"))
}

#[test]
fn manual_sample_runs_at_its_printed_speeds() {
    let lines = "N10 M3 G96 S300\nN20 G0 X100 Z50\nN30 G0 X50 Z0\nN40 G1 W-30 F200\nN50 X80 W-20 F150\nN60 G0 X100 Z50";
    // The sample is of the 980TDi, where a rapid has the speed of its end point.
    let planner = sample(&[("speed-in-rapid", "of-end")], lines);
    let mut speeds = Vec::new();
    let mut t = 0.0;
    while let Some(next) = planner.timeline().next_block(t) {
        t = next;
        speeds.push(planner.timeline().at(t + 1e-4).spindle.command.round());
    }
    // At N10 the tool is at the centre: the gear limits. After N50 the rapid back has the speed of X100 again.
    assert_eq!(speeds, [3000.0, 955.0, 1910.0, 1910.0, 1910.0, 955.0, 955.0]);
    // N50 has reached X80 except for the end of its deceleration when the rapid begins.
    let rapid = first_at(&planner, begins_at(&planner, 5) - 1e-3, |now| now.spindle.command < 1000.0);
    close(planner.timeline().at(rapid - 2e-4).spindle.command, 1194.0, 2e-3);
    // The voltage stays after the program's end.
    close(planner.timeline().at(t).spindle.volts_command, 10.0 * 954.9297 / 3000.0, 1e-6);
}

#[test]
fn g50_s_sets_the_work_zero_by_its_switch() {
    let lines = "S100 M3\nG0 X60 Z5\nG50 S800\nG96 S300\nG1 X30 F300\nG97 M5";
    for (setting, at_begin, at_end, x) in
        [("reference-point", 60.0, 30.0, 30.0), ("nothing", 60.0, 30.0, 30.0), ("work-zero", 0.0, 30.0, 90.0)]
    {
        let planner = sample(&[("speed-limit-sets-zero", setting)], lines);
        let end = planner.timeline().end();
        assert_eq!(planner.timeline().words_at(end)[0], x, "{setting}");
        let expected = |diameter: f64| (300e3 / (math::PI * diameter)).min(800.0);
        let begin = first_at(&planner, 0.0, |now| now.spindle.command > 101.0);
        close(planner.timeline().at(begin).spindle.command, expected(at_begin), 1e-9);
        close(planner.timeline().at(end).spindle.volts_command, 10.0 * expected(at_end) / 3000.0, 1e-12);
    }
}

#[test]
fn modal_variables_show_the_executing_block() {
    // The first cut takes ten seconds; the next blocks are read during it.
    let text = "%
O1
N5 G91 G94 G01 X100. F600
N6 G04 X1.
N7 G95 S300
N8 #100=#4309
#101=#4109
#102=#4314
#103=#4114
#104=#4205
#105=#4319
N9 G94 G01 X1. F1200
#110=#5041
#111=#4309
#112=#4205
#113=#4319
M30
%
";
    let parsed = parse(&Files::one("O1.nc", text), control());
    assert!(parsed.diagnostics().is_empty(), "{:?}", parsed.diagnostics());
    let mut plant = plant();
    plant.block_time = 0.007;
    let mut planner = Planner::new(Setup {
        program: Interp::new(Rc::new(parsed), StartProgram::First),
        control: control(),
        plant: &plant,
        plc: Box::new(bench_plc(0.05, Some(1033))),
        panel: Panel::default(),
        limits: Budget { blocks: u64::MAX, seconds: 60.0 },
        keep: Retention::Timeline,
        findings: Vec::new(),
    });
    planner.advance(1.0, 1_000_000);
    let seen = |planner: &Planner<Interp>, numbers: &[u32]| -> Vec<Option<f64>> {
        numbers.iter().map(|number| planner.program().variable(*number)).collect()
    };
    let vacant = None;
    // F and N executed and read; G94 executed; no S was executed.
    let first = [Some(600.0), Some(600.0), Some(5.0), Some(8.0), Some(94.0), vacant];
    assert_eq!(seen(&planner, &[100, 101, 102, 103, 104, 105]), first);
    planner.advance(60.0, 1_000_000);
    // A position waits for the machine at rest, where all is executed that was read.
    assert_eq!(seen(&planner, &[110, 111, 112, 113]), [Some(101.0), Some(1200.0), Some(94.0), Some(300.0)]);
}

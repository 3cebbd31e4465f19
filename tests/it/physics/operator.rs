//! Actions of the operator, budgets, the log.

use super::*;

#[test]
fn unanswered_stop_ends_the_run_with_spindle_unchanged() {
    let lines =
        vec![m3(1200.0), linear(10.0, 0.0, 6000.0), one(Canon::Stop), linear(20.0, 0.0, 6000.0), one(Canon::End)];
    let mut planner = planner(&plant(), vec![], lines);
    let (t, end) = finish(&mut planner);
    assert_eq!(end, RunEnd::Stop);
    assert_eq!(planner.timeline().at(t).mode, Mode::Stopped);
    assert!((planner.timeline().at(t).spindle.volts - 8.107).abs() < 0.0005);
    // Cycle start at that very moment continues the run.
    planner.event(at(t, Action::Start));
    assert_eq!(finish(&mut planner).1, RunEnd::ProgramEnd);
    assert_eq!(planner.timeline().at(ended_at(&planner)).axes[0].position, 20.0);
}

#[test]
fn m01_stops_only_with_optional_stop_on() {
    let lines = vec![linear(10.0, 0.0, 6000.0), one(Canon::OptionalStop), one(Canon::End)];
    assert_eq!(finish(&mut planner(&plant(), vec![], lines.clone())).1, RunEnd::ProgramEnd);
    assert_eq!(finish(&mut planner(&plant(), vec![at(0.0, Action::OptionalStop(true))], lines)).1, RunEnd::Stop);
}

#[test]
fn single_block_stops_after_nc_blocks_only() {
    let lines = vec![
        linear(10.0, 0.0, 6000.0),
        Line::Add(1, 1.0),
        Line::Add(1, 1.0),
        linear(20.0, 0.0, 6000.0),
        one(Canon::End),
    ];
    let mut planner = planner(&plant(), vec![at(0.0, Action::SingleBlock(true))], lines);
    let (t, end) = finish(&mut planner);
    assert_eq!(end, RunEnd::Stop);
    assert_eq!(planner.timeline().at(t + 1.0).axes[0].position, 10.0);
    planner.event(at(5.0, Action::Start));
    finish(&mut planner);
    assert_eq!(planner.timeline().at(8.0).axes[0].position, 20.0);
    planner.event(at(9.0, Action::Start));
    assert_eq!(finish(&mut planner).1, RunEnd::ProgramEnd);
}

#[test]
fn reset_stops_everything_and_start_begins_at_the_head() {
    let lines = vec![m3(1200.0), linear(100.0, 0.0, 6000.0), linear(200.0, 0.0, 6000.0), one(Canon::End)];
    let mut planner = planner(&plant(), vec![at(0.557_1, Action::Reset)], lines);
    let (t, end) = finish(&mut planner);
    assert_eq!((t, end), (0.557_1, RunEnd::Stop));
    let now = planner.timeline().at(t);
    assert_eq!((now.spindle.command, now.spindle.volts), (0.0, 0.0));
    let rest = planner.timeline().at(t + 10.0);
    assert_eq!((rest.mode, rest.axes[0].feed, rest.spindle.actual), (Mode::Stopped, 0.0, 0.0));
    // 50 mm of the block were commanded.
    let begin = first(&planner, 0.0, |now| now.block == Some(place(1)));
    close(rest.axes[0].position, (t - begin) * 100.0, 1e-6);
    planner.event(at(20.0, Action::Start));
    let (t, end) = finish(&mut planner);
    assert_eq!(end, RunEnd::ProgramEnd);
    assert_eq!(planner.timeline().at(t).axes[0].position, 200.0);
    assert_eq!(planner.timeline().at(t).spindle.command, 1200.0);
}

#[test]
fn emergency_stop_needs_reset_before_start() {
    let lines = vec![m3(1200.0), linear(100.0, 0.0, 6000.0), one(Canon::End)];
    let mut planner = planner(&plant(), vec![at(0.5, Action::EmergencyStop), at(2.0, Action::Start)], lines);
    let (t, end) = finish(&mut planner);
    assert!(matches!(end, RunEnd::Alarm(_)), "{end:?}");
    assert_eq!(planner.timeline().at(t).mode, Mode::EmergencyStop);
    assert_eq!(planner.timeline().at(0.5).spindle.volts, 0.0);
    assert!(planner.timeline().at(0.6).spindle.actual > 100.0, "it coasts");
    assert!(planner.timeline().at(0.6 + 1e-9).axes[0].feed == 0.0, "the axes stop over their time constant");
    planner.event(at(4.0, Action::Reset));
    planner.event(at(5.0, Action::Start));
    assert_eq!(finish(&mut planner).1, RunEnd::ProgramEnd);
}

#[test]
fn forced_inputs_stay_forced() {
    let lines = vec![one(Canon::Dwell { seconds: 1.0 }), Line::Position(1), Line::Input(100, 1033), one(Canon::End)];
    let events = vec![at(0.5, Action::Input("#1033".into(), 77.0)), at(0.6, Action::SpindleOverride(90.0))];
    let planner = run_on(&plant(), events, lines);
    assert_eq!(planner.program().variable(100), Some(77.0));
}

#[test]
fn budget_ends_an_endless_program() {
    let plant = plant();
    let setup = |limits| Setup {
        program: Script::new([Line::Add(1, 1.0), Line::Goto(0)]),
        control: control(),
        plant: &plant,
        plc: Box::new(bench_plc(0.0, None)) as Box<dyn Plc>,
        panel: Panel::default(),
        limits,
        keep: Retention::Log,
        findings: Vec::new(),
    };
    let mut blocks = Planner::new(setup(Budget { blocks: 10_000, seconds: 3600.0 }));
    let (_, end) = finish(&mut blocks);
    assert_eq!((end, blocks.blocks().macros), (RunEnd::Blocks, 10_000));
    let mut seconds = Planner::new(setup(Budget { blocks: u64::MAX, seconds: 30.0 }));
    assert_eq!(finish(&mut seconds), (30.0, RunEnd::Seconds));
    // A block each 3 ms.
    assert!(seconds.blocks().macros.abs_diff(10_000) <= 1);
}

#[test]
fn log_holds_begun_commands_in_program_order() {
    let output = Canon::Output { variable: 1132, value: 5.0 };
    let lines = vec![linear(10.0, 0.0, 6000.0), one(output.clone()), linear(20.0, 0.0, 6000.0), one(Canon::End)];
    let run = |events| {
        let mut planner = Planner::new(Setup {
            program: Script::new(lines.clone()),
            control: control(),
            plant: &plant(),
            plc: Box::new(bench_plc(0.0, None)),
            panel: Panel::new(events),
            limits: Budget { blocks: 100, seconds: 10.0 },
            keep: Retention::Log,
            findings: Vec::new(),
        });
        let (mut log, mut t) = (vec![], 0.0);
        while planner.advance(t, 100).ended.is_none() {
            log.extend(planner.take_log());
            t += 0.01;
        }
        log.extend(planner.take_log());
        log.into_iter().map(|(_, canon, _)| canon).collect::<Vec<_>>()
    };
    let whole = run(vec![]);
    assert_eq!(whole.len(), 4);
    assert_eq!(whole[1], output);
    // The output has acted although the block after it never began.
    assert_eq!(run(vec![at(0.05, Action::Reset)]), whole[..2]);
}

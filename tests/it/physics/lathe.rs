//! Functions of lathe controls: diameters, feed in step with the spindle, threads, constant surface speed, switched waits.

use macroline::drives::speed::SpeedLimit;

use super::*;

/// X counts diameters and the axes follow without delay, so that the commanded path itself is seen.
fn lathe() -> Plant {
    let mut plant = plant();
    plant.axes = vec![
        AxisPlant { diameter: true, time_constant: 0.0, ..axis(Address::X) },
        AxisPlant { time_constant: 0.0, ..axis(Address::Y) },
    ];
    // Cuts here begin on the ramp on purpose.
    plant.spindle.drives_cut = false;
    plant
}

fn on_lathe(events: Vec<Event>, lines: Vec<Line>) -> Planner<Script> {
    run_on(&lathe(), events, lines)
}

/// When a line begins.
pub(super) fn begins(planner: &Planner<Script>, line: usize) -> f64 {
    let (timeline, mut t) = (planner.timeline(), 0.0);
    while timeline.block_at(t) != Some(place(line)) {
        t = timeline.next_block(t).expect("the line is run");
    }
    t
}

#[test]
fn diameter_words_move_half_and_feed_is_the_true_path() {
    // 60 of diameter are 30 mm; with 40 mm that is a path of 50 mm.
    let planner = on_lathe(vec![], vec![linear(60.0, 40.0, 6000.0)]);
    let (begin, end) = (begins(&planner, 0), ended_at(&planner));
    close(end - begin, 0.5, 1e-9);
    let half = planner.timeline().at(begin + 0.25).axes;
    close(half[0].position, 15.0, 1e-6);
    close(half[0].feed, 3600.0, 1e-9);
    close(half[1].feed, 4800.0, 1e-9);
    assert_eq!(planner.timeline().at(end).axes[0].position, 30.0);
    assert_eq!(planner.timeline().words_at(end)[..2], [60.0, 40.0]);
}

#[test]
fn clamps_and_rapids_limit_the_slide_not_the_diameter() {
    let mut plant = lathe();
    plant.axes[0].clamp = 1000.0;
    let planner = run_on(&plant, vec![], vec![linear(60.0, 0.0, 2000.0), rapid(0.0, 0.0)]);
    assert_eq!(planner.diagnostics()[0].message.id, "motion.axis-clamp");
    let cut = begins(&planner, 1) - begins(&planner, 0);
    close(cut, 30.0 / 1000.0 * 60.0, 1e-6);
    close(ended_at(&planner) - begins(&planner, 1), 30.0 / 30e3 * 60.0, 1e-6);
}

#[test]
fn arc_in_diameter_words_is_a_circle_of_the_slide() {
    // From (0, 0) about X20 (10 mm) to X20 Y-10.
    let arc = Canon::Arc {
        to: target(20.0, -10.0),
        plane: (0, 1),
        center: (20e3, 0.0),
        clockwise: false,
        feed: Feed::PerMinute(600.0),
        exact: false,
    };
    let planner = on_lathe(vec![], vec![one(arc)]);
    let (begin, end) = (begins(&planner, 0), ended_at(&planner));
    close(end - begin, 0.5 * math::PI, 1e-9);
    for i in 0..=100 {
        let [x, y, ..] = planner.timeline().at(begin + (end - begin) * f64::from(i) / 100.0).axes.map(|a| a.position);
        close(math::hypot(x - 10.0, y), 10.0, 1e-12);
    }
}

#[test]
fn positions_and_restart_use_diameter_words() {
    let steps = vec![Line::Add(1, 600.0), Line::Step([7_500, 0], 1), Line::Position(100)];
    let mut planner = on_lathe(vec![], steps);
    assert_eq!(planner.program().variable(100), Some(7.5));
    assert_eq!(planner.timeline().at(60.0).axes[0].position, 3.75);
    planner.event(at(60.0, Action::Start));
    finish(&mut planner);
    assert_eq!(planner.program().variable(100), Some(15.0));
    assert_eq!(planner.timeline().at(120.0).axes[0].position, 7.5);
}

#[test]
fn thread_is_lead_times_turns_at_any_override() {
    let lead = 1.5;
    let thread = Canon::Thread { to: target(0.0, 90.0), lead };
    let events = vec![
        at(1.0, Action::FeedOverride(10.0)),
        at(1.2, Action::SpindleOverride(60.0)),
        at(1.5, Action::Hold),
        at(1.9, Action::SpindleOverride(110.0)),
        at(10.0, Action::Start),
    ];
    let planner = on_lathe(events, vec![m4(1200.0), one(thread), linear(0.0, 0.0, 6000.0)]);
    let (begin, timeline) = (begins(&planner, 1), planner.timeline());
    let end = first(&planner, begin, |now| now.axes[1].position >= 90.0 - 1e-9);
    let turns = |t: f64| (timeline.at(t).spindle.turns - timeline.at(begin).spindle.turns).abs();
    // Between two measurements a step is straight where the turns are bent, a t²/8; a knob that breaks a step off leaves that much.
    let bend = lead * 740.0 / 60.0 * 0.01 * 0.01 / 8.0;
    for i in 0..=200 {
        let t = begin + (end - begin) * f64::from(i) / 200.0;
        assert!((timeline.at(t).axes[1].position - lead * turns(t)).abs() <= 3.0 * bend, "{t}");
    }
    // The hold acts after the thread, and the following motion has the override.
    assert_eq!(timeline.at(end + 0.1).mode, Mode::Hold);
    assert_eq!(timeline.at(9.9).axes[1].position, 90.0);
    close(timeline.at(10.5).axes[1].feed, -600.0, 1e-9);
    assert!(planner.diagnostics().is_empty(), "{:?}", planner.diagnostics());
}

#[test]
fn feed_per_revolution_without_spindle_waits_with_one_finding() {
    let per_turn = |y: f64| one(Canon::Linear { to: target(0.0, y), feed: Feed::PerRevolution(0.2), exact: false });
    let mut plant = lathe();
    plant.spindle.rules.manual_in_automatic = true;
    let mut planner = run_on(&plant, vec![], vec![per_turn(10.0), per_turn(20.0)]);
    let found: Vec<_> = planner.diagnostics().iter().map(|found| (found.message.id, found.place)).collect();
    assert_eq!(found, [("motion.spindle-at-rest", Some(place(0)))]);
    assert_eq!(finish(&mut planner).1, RunEnd::Stop);
    // The axes go on as soon as the spindle turns: 100 turns.
    planner.event(at(5.0, Action::ManualSpeed(600.0)));
    assert_eq!(finish(&mut planner).1, RunEnd::ProgramEnd);
    close(planner.timeline().at(ended_at(&planner)).spindle.turns, 100.0, 1e-9);
    assert_eq!(planner.diagnostics().len(), 1);
}

#[test]
fn feed_per_revolution_above_clamp_is_a_finding() {
    let mut plant = lathe();
    plant.axes[1].clamp = 100.0;
    let feed = Feed::PerRevolution(0.2);
    let travel = one(Canon::Linear { to: target(0.0, 5.0), feed, exact: false });
    let planner = run_on(&plant, vec![], vec![m3(1200.0), one(Canon::Dwell { seconds: 2.0 }), travel]);
    let clamped = planner.diagnostics().iter().find(|found| found.message.id == "motion.axis-clamp");
    assert_eq!(clamped.map(|found| found.place), Some(Some(place(2))));
}

pub(super) fn surface(speed: f64, zero: f64) -> Line {
    one(Canon::SurfaceSpeed { speed, axis: 0, zero: (zero * 1000.0) as i64 })
}

#[test]
fn surface_speed_is_constant_within_one_step() {
    // Work zero lies at X10; from a diameter of 100 down to 30 and back up a taper.
    let lines = vec![
        m3(100.0),
        surface(120.0, 10.0),
        rapid(110.0, 0.0),
        one(Canon::Dwell { seconds: 2.0 }),
        linear(40.0, 0.0, 300.0),
        linear(90.0, 30.0, 200.0),
        one(Canon::End),
    ];
    let planner = on_lathe(vec![], lines);
    let (begin, end, timeline) = (begins(&planner, 4), begins(&planner, 6), planner.timeline());
    for i in 0..=500 {
        let now = timeline.at(begin + (end - begin) * f64::from(i) / 500.0);
        let diameter = 2.0 * (now.axes[0].position - 5.0);
        let speed = now.spindle.command * math::PI * diameter / 1000.0;
        // The command is right in the middle of its step of 10 ms.
        let step = 2.0 * now.axes[0].feed.abs() / 60.0 * 0.005;
        close(speed, 120.0, step / diameter * 1.01 + 1e-9);
        // The inverter is faster than the change, so the spindle is at most a step behind.
        close(now.spindle.actual, now.spindle.command, 0.006);
    }
    // At the end of the block the command is exact.
    close(timeline.at(end).spindle.command, 120e3 / (math::PI * 80.0), 1e-9);
}

#[test]
fn surface_speed_300_gives_the_manuals_values() {
    for (diameter, rpm) in [(100.0, 955.0), (80.0, 1194.0)] {
        let lines = vec![m3(100.0), rapid(diameter, 0.0), surface(300.0, 0.0), one(Canon::Dwell { seconds: 2.0 })];
        let planner = on_lathe(vec![], lines);
        let command = planner.timeline().at(ended_at(&planner)).spindle.command;
        assert_eq!(command.round(), rpm);
    }
}

#[test]
fn rapid_starts_with_the_spindle_speed_of_its_end() {
    let lines = vec![m3(100.0), rapid(100.0, 0.0), surface(120.0, 0.0)];
    let rest = [one(Canon::Dwell { seconds: 1.0 }), rapid(50.0, 0.0), one(Canon::End)];
    let planner = on_lathe(vec![], lines.into_iter().chain(rest).collect());
    let begin = begins(&planner, 4);
    let command = |t: f64| planner.timeline().at(t).spindle.command;
    close(command(begin - 1e-6), 120e3 / (math::PI * 100.0), 1e-12);
    close(command(begin + 1e-6), 120e3 / (math::PI * 50.0), 1e-12);
}

#[test]
fn limit_holds_at_centre_and_g97_keeps_the_last_speed() {
    let lines = |limit: Option<f64>| {
        let mut lines = vec![m3(100.0), rapid(100.0, 0.0), surface(120.0, 0.0), linear(0.0, 0.0, 3000.0)];
        lines.extend([one(Canon::ConstantSpeed), linear(100.0, 0.0, 3000.0), one(Canon::End)]);
        if let Some(rpm) = limit {
            lines.insert(0, one(Canon::SpeedLimit { limit: SpeedLimit::Surface, rpm }));
        }
        lines
    };
    // Without a limit the clamp of the spindle limits, and there is no finding.
    for (limit, wanted) in [(Some(900.0), 900.0), (None, 1480.0), (Some(0.0), 0.0)] {
        let planner = on_lathe(vec![], lines(limit));
        let end = ended_at(&planner);
        assert_eq!(planner.timeline().at(end).spindle.command, wanted, "{limit:?}");
        assert!(planner.diagnostics().is_empty());
    }
    // The override acts before the limit, or after it.
    for (override_last, wanted) in [(false, 900.0), (true, 450.0)] {
        let mut plant = lathe();
        plant.spindle.rules.override_last = override_last;
        let planner = run_on(&plant, vec![at(0.0, Action::SpindleOverride(50.0))], lines(Some(900.0)));
        assert_eq!(planner.timeline().at(ended_at(&planner)).spindle.command, wanted);
    }
}

#[test]
fn constant_diameter_commands_the_spindle_once() {
    let feed = Feed::PerRevolution(0.1);
    let along = one(Canon::Linear { to: target(100.0, 50.0), feed, exact: false });
    let lines = vec![m3(100.0), rapid(100.0, 0.0), surface(120.0, 0.0), one(Canon::Dwell { seconds: 2.0 }), along];
    let planner = on_lathe(vec![], lines);
    let begin = begins(&planner, 4);
    let rpm = 120e3 / (math::PI * 100.0);
    close(ended_at(&planner) - begin, 50.0 / (0.1 * rpm) * 60.0, 1e-7);
}

#[test]
fn chip_thickness_is_constant_under_surface_speed() {
    let feed = Feed::PerRevolution(0.1);
    let face = one(Canon::Linear { to: target(20.0, 0.0), feed, exact: false });
    let lines = vec![m3(100.0), rapid(100.0, 0.0), surface(60.0, 0.0), one(Canon::Dwell { seconds: 2.0 }), face];
    let planner = on_lathe(vec![], lines);
    let (begin, end, timeline) = (begins(&planner, 4), ended_at(&planner), planner.timeline());
    close(0.1 * (timeline.at(end).spindle.turns - timeline.at(begin).spindle.turns), 40.0, 1e-6);
    // dr/dturns = f and n = v/(2πr): the time is π (r₁² - r₂²)/(f v).
    close(end - begin, math::PI * (50.0 * 50.0 - 10.0 * 10.0) / (0.1 * 60e3) * 60.0, 2e-4);
}

#[test]
fn waits_switched_off_by_the_program_do_not_happen() {
    let off = |single_block, fin| one(Canon::SuppressWaits { single_block, fin });
    let auxiliary = || one(Canon::Auxiliary { code: 10 });
    // FIN takes 50 ms each time it is waited for.
    let waits = run(vec![auxiliary(), auxiliary()]);
    let first_fin = begins(&waits, 1);
    close(first_fin, plant().block_time + 0.05, 1e-6);
    let goes_on = run(vec![off(false, true), auxiliary(), linear(10.0, 0.0, 6000.0), off(false, false), auxiliary()]);
    close(begins(&goes_on, 2), 3.0 * plant().block_time, 1e-6);
    // The last FIN is waited for; that takes longer than the block before it takes to come to rest.
    let end = begins(&goes_on, 4);
    close(ended_at(&goes_on) - end, 0.05 + TAU, 1e-6);
    // Single block: three blocks without a stop between them, then one.
    let lines = vec![
        off(true, false),
        linear(10.0, 0.0, 6000.0),
        linear(20.0, 0.0, 6000.0),
        Line::Position(100),
        off(false, false),
        linear(30.0, 0.0, 6000.0),
        linear(40.0, 0.0, 6000.0),
    ];
    let mut planner = planner(&plant(), vec![at(0.0, Action::SingleBlock(true))], lines);
    let (t, end) = finish(&mut planner);
    assert_eq!(end, RunEnd::Stop);
    assert_eq!(planner.timeline().at(t + 1.0).axes[0].position, 20.0);
}

//! A lathe's spindle over time: surface speed, limits, gears, volts without M03, waits for the speed.

use macroline::controls::spindle::RapidSpeed;
use macroline::drives::speed::{SpeedLimit, surface_rpm};
use macroline::drives::{Bound, SpeedRange, Stage};
use macroline::motion::GearShift;

use super::lathe::{begins, surface};
use super::*;

/// A lathe whose spindle has no inertia, up to 3500 r/min.
fn quick(tau: f64) -> Plant {
    let mut plant = plant();
    plant.axes = vec![AxisPlant { diameter: true, time_constant: tau, ..axis(Address::X) }, axis(Address::Y)];
    let analog = Analog::unipolar(3500.0, 10.0);
    plant.spindle = SpindlePlant::new(analog, 3500.0, 0.0, plant.spindle.rules);
    plant
}

fn per_turn(x: f64, y: f64, feed: f64) -> Line {
    one(Canon::Linear { to: target(x, y), feed: Feed::PerRevolution(feed), exact: false })
}

fn limit(limit: SpeedLimit, rpm: f64) -> Line {
    one(Canon::SpeedLimit { limit, rpm })
}

fn dwell(seconds: f64) -> Line {
    one(Canon::Dwell { seconds })
}

fn spindle(planner: &Planner<Script>, t: f64) -> macroline::motion::SpindleState {
    planner.timeline().at(t).spindle
}

#[test]
fn facing_time_matches_the_fact_sheet() {
    // sinumerik-802d.md section 7: 682.093 r/min at X84, 2500 from X22.918, 10.019832 s.
    let lines = vec![
        m3(800.0),
        limit(SpeedLimit::Surface, 2500.0),
        rapid(84.0, 0.0),
        surface(180.0, 0.0),
        dwell(1.0),
        per_turn(-1.6, 0.0, 0.2),
        one(Canon::End),
    ];
    let planner = run_on(&quick(0.0), vec![], lines);
    let (begin, end) = (begins(&planner, 5), begins(&planner, 6));
    close(end - begin, 10.019832, 1e-5);
    close(spindle(&planner, begin).command, 682.093, 1e-6);
    let cut = Cut { diameters: (84.0, -1.6), length: 42.8, feed: 0.2 };
    for i in 1..2000 {
        let t = begin + (end - begin) * f64::from(i) / 2000.0;
        let now = planner.timeline().at(t);
        let diameter = 2.0 * now.axes[0].position;
        if diameter > 22.918312 * 1.0001 {
            // Required: 0.1 %.
            close(now.spindle.surface_speed.unwrap(), 180.0, 2e-4);
            close(diameter, surface_diameter(&cut, 180.0, t - begin), 2e-5);
            assert_eq!(now.spindle.bound, Bound::None);
        } else if diameter.abs() < 22.918312 * 0.9999 {
            assert_eq!((now.spindle.command, now.spindle.bound), (2500.0, Bound::Surface));
        }
    }
}

#[test]
fn any_straight_cut_matches_closed_forms() {
    for (from, to, along, speed, limits) in [
        (60.0, 60.0, 80.0, 120.0, (0.0, 3500.0)),
        (30.0, 90.0, 50.0, 150.0, (0.0, 3500.0)),
        (90.0, 20.0, 0.0, 200.0, (0.0, 2000.0)),
        (90.0, 20.0, 5.0, 100.0, (500.0, 900.0)),
        (8.0, 50.0, 0.0, 60.0, (0.0, 3500.0)),
        (30.0, -60.0, 20.0, 90.0, (0.0, 1500.0)),
    ] {
        let mut plant = quick(0.0);
        plant.spindle.surface_low = limits.0;
        let lines = vec![
            m3(800.0),
            limit(SpeedLimit::Surface, limits.1),
            rapid(from, 0.0),
            surface(speed, 0.0),
            dwell(1.0),
            per_turn(to, along, 0.3),
            one(Canon::End),
        ];
        let planner = run_on(&plant, vec![], lines);
        let cut = Cut { diameters: (from, to), length: math::hypot((to - from) / 2.0, along), feed: 0.3 };
        let time = begins(&planner, 6) - begins(&planner, 5);
        // Required: 0.01 %.
        close(time, cut.surface_time(speed, limits), 5e-5);
    }
}

#[test]
fn surface_speed_holds_despite_servo_lag() {
    // With acceleration the axis lags the path; the spindle follows the commanded position.
    let lines = vec![
        m3(800.0),
        rapid(90.0, 0.0),
        surface(180.0, 0.0),
        dwell(1.0),
        linear(30.0, 0.0, 600.0),
        linear(60.0, 20.0, 400.0),
        dwell(0.5),
        one(Canon::End),
    ];
    let planner = run_on(&quick(0.1), vec![], lines);
    let (begin, end) = (begins(&planner, 4), ended_at(&planner));
    for i in 0..=2000 {
        let now = planner.timeline().at(begin + (end - begin) * f64::from(i) / 2000.0);
        close(surface_rpm(180.0, 2.0 * now.axes[0].position), now.spindle.actual, 1e-3);
    }
}

#[test]
fn rapid_before_a_cut_sets_the_spindle_speed() {
    // sinumerik-802d.md section 7, N50 to N130; 802D rules.
    let mut plant = quick(0.1);
    plant.spindle.rules.rapid = RapidSpeed::BeforeCut;
    for at_once in [false, true] {
        plant.spindle.rules.surface_at_once = at_once;
        let lines = vec![
            m3(800.0),
            rapid(92.0, 5.0),
            limit(SpeedLimit::Surface, 2500.0),
            surface(180.0, 0.0),
            rapid(92.0, 0.0),
            rapid(84.0, 0.0),
            per_turn(-1.6, 0.0, 0.2),
            rapid(-1.6, 5.0),
            rapid(120.0, 150.0),
            one(Canon::ConstantSpeed),
            dwell(0.1),
            m3(300.0),
            dwell(0.1),
        ];
        let planner = run_on(&plant, vec![], lines);
        let at = |line: usize| spindle(&planner, begins(&planner, line) + 1e-6).command;
        let first = if at_once { 622.780 } else { 800.0 };
        close(at(1), 800.0, 1e-9);
        close(at(4), first, 1e-6);
        // The next block is read before the rapid ends.
        let late = begins(&planner, 6) - 1e-6;
        close(spindle(&planner, late).command, 682.093, 1e-6);
        for line in [7, 8, 10] {
            close(at(line), 2500.0, 1e-9);
        }
        close(spindle(&planner, ended_at(&planner)).command, 300.0, 1e-9);
    }
}

#[test]
fn late_read_cut_sets_the_speed_during_the_rapid() {
    let mut plant = quick(0.0);
    plant.spindle.rules.rapid = RapidSpeed::BeforeCut;
    plant.macro_time = 0.05;
    let lines = vec![m3(800.0), surface(180.0, 0.0), rapid(84.0, 0.0), Line::Add(1, 1.0), linear(20.0, 0.0, 300.0)];
    let planner = run_on(&plant, vec![], lines);
    let begin = begins(&planner, 2);
    assert_ne!(spindle(&planner, begin + 0.001).command, spindle(&planner, begin + 0.06).command);
    close(spindle(&planner, begin + 0.06).command, 682.093, 1e-6);
}

#[test]
fn volts_of_s_exist_without_m03_and_survive_reset() {
    let lines = || vec![m5(1000.0), dwell(1.0), m3(1000.0), dwell(3.0), m3(0.0), dwell(1.0)];
    for (stay, event) in [(true, Action::Reset), (true, Action::EmergencyStop), (false, Action::Reset)] {
        let mut plant = plant();
        plant.spindle.rules.volts_stay = stay;
        let events = vec![at(3.0, event)];
        let planner = run_on(&plant, events, lines());
        let volts = |t: f64| spindle(&planner, t).volts_command;
        let kept = if stay { 10.0 * 1000.0 / 1480.0 } else { 0.0 };
        // 0 V at power-on.
        assert_eq!(volts(0.0), 0.0);
        assert_eq!(spindle(&planner, 0.9).actual, 0.0);
        close(volts(0.9), kept, 1e-12);
        close(volts(2.5), 10.0 * 1000.0 / 1480.0, 1e-12);
        close(volts(3.0), kept, 1e-12);
        close(volts(9.0), kept, 1e-12);
        assert_eq!(spindle(&planner, 9.0).actual, 0.0);
        // S0.
        let planner = run_on(&plant, vec![], lines());
        assert_eq!(spindle(&planner, ended_at(&planner)).volts_command, 0.0);
    }
}

#[test]
fn spindle_survives_reset_but_not_emergency_stop() {
    let mut plant = plant();
    plant.spindle.rules.turns_through_reset = true;
    for (event, rpm) in [(Action::Reset, 1000.0), (Action::EmergencyStop, 0.0)] {
        let planner = run_on(&plant, vec![at(3.0, event)], vec![m3(1000.0), dwell(9.0)]);
        assert_eq!(spindle(&planner, 9.0).actual, rpm);
    }
    plant.spindle.rules.end_stops = true;
    let planner = run_on(&plant, vec![], vec![m3(1000.0), dwell(3.0), one(Canon::End)]);
    assert_eq!(spindle(&planner, ended_at(&planner) + 5.0).actual, 0.0);
}

#[test]
fn signed_output_carries_the_direction() {
    let mut plant = plant();
    plant.spindle.analog = Analog { rated_volts: 8.0, bipolar: true, ..Analog::unipolar(3000.0, 10.0) };
    plant.spindle = plant.spindle.with_stages([Stage::new(3000.0)]);
    let planner = run_on(&plant, vec![], vec![m3(1200.0), dwell(3.0), m4(1200.0), dwell(5.0)]);
    close(spindle(&planner, 3.0).volts_command, 3.2, 1e-12);
    close(spindle(&planner, 8.0).volts_command, -3.2, 1e-12);
    close(spindle(&planner, 8.0).actual, -1200.0, 1e-12);
}

#[test]
fn setting_data_limits_speed_and_survives_reset() {
    let lines = vec![
        m3(1200.0),
        dwell(1.0),
        limit(SpeedLimit::Upper, 900.0),
        dwell(1.0),
        m3(20.0),
        limit(SpeedLimit::Lower, 50.0),
        dwell(1.0),
        m3(1200.0),
        dwell(1.0),
    ];
    let events = vec![
        at(4.8, Action::SpeedLimit(SpeedLimit::Upper, 5000.0)),
        at(10.0, Action::Reset),
        at(10.0, Action::ManualSpeed(10.0)),
    ];
    let planner = run_on(&plant(), events, lines);
    let held = |line: usize| {
        let now = spindle(&planner, begins(&planner, line) + 0.01);
        (now.command, now.bound)
    };
    assert_eq!(held(1), (1200.0, Bound::None));
    assert_eq!(held(3), (900.0, Bound::Upper));
    assert_eq!(held(6), (50.0, Bound::Lower));
    assert_eq!(held(8), (900.0, Bound::Upper));
    // The operator opens the upper limit: the S that was programmed is still there. The lower one outlives the reset.
    assert_eq!(spindle(&planner, 4.9).command, 1200.0);
    let now = spindle(&planner, 11.0);
    assert_eq!((now.command, now.bound), (50.0, Bound::Lower));
}

#[test]
fn surface_speed_limit_binds_g97_by_the_control() {
    for (stays, wanted) in [(false, 1200.0), (true, 700.0)] {
        let mut plant = plant();
        plant.spindle.rules.surface_limit_stays = stays;
        let planner = run_on(&plant, vec![], vec![limit(SpeedLimit::Surface, 700.0), m3(1200.0), dwell(1.0)]);
        assert_eq!(spindle(&planner, 1.0).command, wanted);
    }
}

#[test]
fn g97_keeps_the_speed_reached_under_g96() {
    let lines = vec![m3(100.0), rapid(60.0, 0.0), surface(100.0, 0.0), one(Canon::ConstantSpeed), dwell(1.0)];
    let planner = run_on(&quick(0.0), vec![at(0.0, Action::SpindleOverride(70.0))], lines);
    close(spindle(&planner, ended_at(&planner)).command, 0.7 * surface_rpm(100.0, 60.0), 1e-12);
}

#[test]
fn knob_is_ignored_in_threads_by_the_control() {
    let thread = || one(Canon::Thread { to: target(0.0, 20.0), lead: 1.0 });
    for (reaches, rpm) in [(false, 600.0), (true, 300.0)] {
        let mut plant = quick(0.0);
        plant.spindle.rules.thread_override = reaches;
        let events = vec![at(0.0, Action::SpindleOverride(50.0))];
        let planner = run_on(&plant, events, vec![m3(600.0), thread(), dwell(1.0)]);
        close(spindle(&planner, begins(&planner, 1) + 0.5).command, rpm, 1e-12);
        close(spindle(&planner, ended_at(&planner)).command, 300.0, 1e-12);
    }
}

#[test]
fn gear_shift_follows_the_ladder_sequence() {
    // gsk-980tdc.md section 1.2.
    let stages = [750.0, 1500.0, 3000.0].map(Stage::new);
    let mut plant = plant();
    plant.spindle.speed_clamp = 9999.0;
    plant.spindle = plant.spindle.with_stages(stages);
    let mut plc = bench_plc(0.05, None);
    plc.shift = GearShift { volts: 0.2, before: 1.0, meshing: 0.3, after: 2.0, patience: None };
    let gear = |stage| one(Canon::Gear { stage });
    let lines = vec![m3(600.0), dwell(4.0), gear(3), dwell(4.0), gear(3), gear(2), gear(9)];
    let mut planner = planner_with(Box::new(plc), &plant, vec![], lines);
    finish(&mut planner);
    let begin = begins(&planner, 2);
    let look = |t: f64| {
        let now = spindle(&planner, t);
        (now.stage, (now.volts_command * 1e9).round() / 1e9)
    };
    assert_eq!(look(begin - 1e-3), (1, 8.0));
    assert_eq!(look(begin + 1e-3), (1, 0.2));
    assert_eq!(look(begin + 0.999), (1, 0.2));
    assert_eq!(look(begin + 1.001), (3, 0.2));
    assert_eq!(look(begin + 3.299), (3, 0.2));
    assert_eq!(look(begin + 3.301), (3, 2.0));
    close(begins(&planner, 3) - begin, 3.3, 1e-3);
    close(spindle(&planner, begins(&planner, 4) - 0.01).actual, 600.0, 1e-9);
    // A shift to the present stage is answered at once; a stage that the machine lacks is a finding.
    close(begins(&planner, 5) - begins(&planner, 4), 0.05, 1e-6);
    assert_eq!(spindle(&planner, ended_at(&planner)).stage, 2);
    let ids: Vec<_> = planner.diagnostics().iter().map(|found| found.message.id).collect();
    assert_eq!(ids, ["motion.no-stage"]);
}

#[test]
fn automatic_gear_follows_s() {
    let stage = |low: f64, high: f64| Stage { automatic: SpeedRange::new(low, high), ..Stage::new(high) };
    let mut plant = plant();
    plant.spindle.speed_clamp = 9999.0;
    plant.spindle = plant.spindle.with_stages([stage(0.0, 700.0), stage(600.0, 1500.0)]);
    let speed = |rpm| one(Canon::SpindleSpeed { rpm });
    let lines = vec![
        one(Canon::Gear { stage: 0 }),
        speed(650.0),
        speed(800.0),
        speed(650.0),
        speed(500.0),
        speed(5000.0),
        dwell(0.1),
    ];
    let planner = run_on(&plant, vec![], lines);
    let stages: Vec<u8> = (2..=6).map(|line| spindle(&planner, begins(&planner, line) - 1e-6).stage).collect();
    assert_eq!(stages, [1, 2, 2, 1, 1]);
}

#[test]
fn output_saturates_in_its_gear_and_gear_limits_g96() {
    let mut plant = quick(0.0);
    plant.spindle = plant.spindle.with_stages([Stage::new(1000.0)]);
    let planner = run_on(&plant, vec![], vec![m3(1500.0), dwell(1.0)]);
    let now = spindle(&planner, 1.0);
    assert_eq!((now.command, now.actual, now.volts, now.bound), (1000.0, 1000.0, 10.0, Bound::Output));
    let ids: Vec<_> = planner.diagnostics().iter().map(|found| found.message.id).collect();
    assert_eq!(ids, ["motion.output-full"]);
    let planner = run_on(&plant, vec![], vec![m3(100.0), rapid(10.0, 0.0), surface(100.0, 0.0), dwell(1.0)]);
    let now = spindle(&planner, ended_at(&planner));
    assert_eq!((now.command, now.actual, now.bound), (1000.0, 1000.0, Bound::Gear));
}

#[test]
fn cut_waits_for_speed_reached_by_the_control() {
    for part in [0.1, 0.01] {
        let mut plant = plant();
        plant.spindle.rules.reached = Some(part);
        let lines = vec![m3(1200.0), rapid(0.0, 5.0), linear(10.0, 5.0, 600.0), linear(20.0, 5.0, 600.0)];
        let planner = run_on(&plant, vec![], lines);
        let spun = 2.0 * 1200.0 * (1.0 - part) / 1480.0;
        let moves = first(&planner, begins(&planner, 2), |now| now.axes[0].feed > 0.0);
        close(moves - plant.block_time, spun, 1e-3);
        // The second cut follows the first.
        close(ended_at(&planner) - moves, 2.0 + TAU, 1e-2);
    }
    // A knob that makes it slower is waited for no longer than that.
    let mut plant = plant();
    plant.spindle.rules.reached = Some(0.1);
    let lines = vec![m3(1200.0), linear(10.0, 5.0, 600.0)];
    let planner = run_on(&plant, vec![at(0.5, Action::SpindleOverride(20.0))], lines);
    close(first(&planner, 0.0, |now| now.axes[0].feed > 0.0), 0.5, 0.5);
}

#[test]
fn dwell_counts_spindle_turns() {
    let turns = |turns| one(Canon::DwellTurns { turns });
    for begin in [m3, m4] {
        let planner = run(vec![begin(600.0), turns(7.5), turns(20.0), turns(0.0), one(Canon::End)]);
        // From standstill it takes the ramp along.
        for (from, to, counted) in [(1, 2, 7.5), (2, 4, 20.0)] {
            let turned = |line| spindle(&planner, begins(&planner, line)).turns.abs();
            assert!((turned(to) - turned(from) - counted).abs() < 1e-6);
        }
    }
    // The dwell waits for a spindle at rest.
    let mut plant = plant();
    plant.spindle.rules.manual_in_automatic = true;
    let mut planner = planner(&plant, vec![], vec![turns(5.0)]);
    assert_eq!(finish(&mut planner).1, RunEnd::Stop);
    assert_eq!(planner.diagnostics()[0].message.id, "motion.dwell-at-rest");
    planner.event(at(5.0, Action::ManualSpeed(600.0)));
    assert_eq!(finish(&mut planner).1, RunEnd::ProgramEnd);
    close(planner.timeline().at(ended_at(&planner)).spindle.turns, 5.0, 1e-9);
}

#[test]
fn feed_per_revolution_after_early_stop_rests_with_a_finding() {
    // The ramp down ends at a moment that rounding would leave beside it: the speed is 0 there, not nearly.
    for ms in 1..40 {
        let lines = vec![
            m3(500.0),
            one(Canon::Dwell { seconds: f64::from(ms) * 0.001 }),
            one(Canon::SpindleDirection { rotation: Rotation::Stopped }),
            per_turn(20.0, 0.0, 0.1),
        ];
        let planner = run(lines);
        let ids: Vec<&str> = planner.diagnostics().iter().map(|found| found.message.id).collect();
        assert_eq!(ids, ["motion.spindle-at-rest"], "{ms} ms");
        assert_eq!(planner.timeline().at(ended_at(&planner)).spindle.actual, 0.0);
    }
}

#[test]
fn feed_per_revolution_without_encoder_never_moves() {
    let mut plant = plant();
    (plant.spindle.encoder, plant.spindle.drives_cut) = (false, false);
    let mut planner = planner(&plant, vec![], vec![m3(1200.0), per_turn(10.0, 0.0, 0.2)]);
    assert_eq!(finish(&mut planner).1, RunEnd::Stop);
    assert_eq!(planner.diagnostics()[0].message.id, "motion.no-encoder");
}

#[test]
fn work_zero_off_centre_is_a_finding() {
    let ids_with = |centre, zeros: &[f64]| {
        let mut plant = quick(0.0);
        plant.spindle.centre = centre;
        let mut lines = vec![m3(100.0), rapid(50.0, 0.0)];
        lines.extend(zeros.iter().map(|&zero| surface(100.0, zero)));
        run_on(&plant, vec![], lines).diagnostics().iter().map(|found| found.message.id).collect::<Vec<_>>()
    };
    assert_eq!(ids_with(Some(0.0), &[4.0]), ["motion.off-centre"]);
    assert!(ids_with(Some(2.0), &[4.0]).is_empty() && ids_with(None, &[4.0, 4.0]).is_empty());
    // A zero that moves while the speed counts from it: G52, TRANS.
    assert_eq!(ids_with(None, &[4.0, 5.0]), ["motion.off-centre"]);
}

#[test]
fn bench_knob_snaps_to_its_steps() {
    let bench = Bench { override_echo: Some(1033), ..control().bench };
    let knob = KnobRange { low: 50.0, high: 120.0, step: 10.0 };
    let plc = BenchPlc::new(&bench, &SpindleRules { knob, ..plant().spindle.rules });
    let events = vec![at(1.0, Action::SpindleOverride(47.0)), at(2.0, Action::SpindleOverride(300.0))];
    let mut planner = planner_with(Box::new(plc), &plant(), events, vec![m3(1000.0), dwell(5.0)]);
    finish(&mut planner);
    assert_eq!([1.5, 2.5].map(|t| spindle(&planner, t).command), [500.0, 1200.0]);
    assert_eq!(planner.variable_at(1033, 1.5), Some(50.0));
}

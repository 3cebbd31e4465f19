//! The spindle goes to an angle: the ways of the sheet run by the planner, where it ends, when the block does.

use macroline::drives::{Approach, Positioning};
use macroline::interp::Canon::Orient;

use super::lathe::begins;
use super::*;

/// A spindle that is positioned with 100 r/min, and 200 r/min per second.
fn orientable() -> Plant {
    let mut plant = plant();
    plant.spindle.positioning = Some(Positioning { speed: 100.0, acceleration: 200.0, clockwise: true });
    plant
}

fn orient(angle: f64, approach: Approach) -> Line {
    one(Orient { angle, approach })
}

fn dwell(seconds: f64) -> Line {
    one(Canon::Dwell { seconds })
}

/// The zero mark was found, and the spindle is held at an angle.
fn at_angle(angle: f64) -> Vec<Line> {
    vec![orient(0.0, Approach::Direct), orient(angle, Approach::Direct)]
}

/// Turns between two lines.
fn turned(planner: &Planner<Script>, from: usize, to: usize) -> f64 {
    let turns = |line| planner.timeline().at(begins(planner, line)).spindle.turns;
    turns(to) - turns(from)
}

#[test]
fn positioning_from_standstill_matches_the_table() {
    use Approach::{Clockwise, CounterClockwise, Direct, Incremental};
    for (from, target, approach, way) in [
        (350.0, 20.0, Direct, 30.0),
        (20.0, 350.0, Direct, -30.0),
        (0.0, 180.0, Direct, 180.0),
        (100.0, 50.0, Clockwise, 310.0),
        (100.0, 50.0, CounterClockwise, -50.0),
        (100.0, 50.0, Direct, -50.0),
        (100.0, -450.0, Incremental, -450.0),
    ] {
        let mut lines = at_angle(from);
        lines.extend([orient(target, approach), dwell(0.1)]);
        let planner = run_on(&orientable(), vec![], lines);
        close(turned(&planner, 2, 3) * 360.0, way, 1e-9);
        let end = planner.timeline().at(planner.timeline().end()).spindle;
        let wanted = if approach == Incremental { 10.0 } else { target };
        assert!(end.held && (end.angle - wanted).abs() < 1e-9 && end.actual == 0.0, "{end:?}");
    }
}

#[test]
fn positioning_while_turning_keeps_direction_and_turns() {
    for rpm in [600.0, -600.0, 30.0, -100.0_f64] {
        let (rotation, rpm) = (Rotation::of(rpm), rpm.abs());
        let mut lines = at_angle(0.0);
        lines.extend([turn(rpm, rotation), dwell(3.21), orient(90.0, Approach::Direct), dwell(0.1)]);
        let planner = run_on(&orientable(), vec![], lines);
        let turns = turned(&planner, 4, 5) * rotation.sign();
        // Turns of the deceleration: by the inverter to 100 r/min (a ramp of 2 s over 1480 r/min), in position control to 0.
        let inverter = 1480.0 / 2.0;
        let rate = if rpm > 100.0 { inverter } else { 200.0 };
        let least = (rpm + 100.0) / 2.0 / 60.0 * ((rpm - 100.0).abs() / rate) + 50.0 / 60.0 * 0.5;
        assert!(turns >= least - 1e-9 && turns < least + 1.0, "{turns} {least}");
        let end = planner.timeline().at(planner.timeline().end()).spindle;
        assert!((end.angle - 90.0).abs() < 1e-9, "{end:?}");
        // The speed never turns back.
        let (from, to) = (begins(&planner, 4), begins(&planner, 5));
        for i in 0..1000 {
            let t = from + (to - from) * f64::from(i) / 1000.0;
            assert!(planner.timeline().at(t).spindle.actual * rotation.sign() >= 0.0);
        }
    }
}

#[test]
fn positioning_against_rotation_stops_first() {
    use Approach::{Clockwise, CounterClockwise, Incremental};
    let cases = [
        (Rotation::Clockwise, CounterClockwise, 40.0, 40.0),
        (Rotation::CounterClockwise, Clockwise, 40.0, 40.0),
        (Rotation::Clockwise, Incremental, -30.0, f64::NAN),
    ];
    for (rotation, approach, angle, wanted) in cases {
        let mut lines = at_angle(0.0);
        lines.extend([turn(300.0, rotation), dwell(2.0), orient(angle, approach), dwell(0.1)]);
        let planner = run_on(&orientable(), vec![], lines);
        let end = planner.timeline().at(planner.timeline().end()).spindle;
        assert!(end.held);
        if wanted.is_nan() {
            close(turned(&planner, 4, 5) * 360.0, angle, 1e-9);
        } else {
            assert!((end.angle - wanted).abs() < 1e-9, "{end:?}");
            let last = planner.timeline().at(planner.timeline().end() - 0.2).spindle.actual;
            assert!(last * rotation.sign() < 0.0);
        }
    }
}

#[test]
fn first_positioning_seeks_the_zero_mark() {
    for (clockwise, way) in [(true, 360.0 + 90.0), (false, -360.0 - 270.0)] {
        let mut plant = orientable();
        plant.spindle.positioning = plant.spindle.positioning.map(|with| Positioning { clockwise, ..with });
        let planner = run_on(&plant, vec![], vec![orient(90.0, Approach::Direct), dwell(0.1)]);
        close(turned(&planner, 0, 1) * 360.0, way, 1e-9);
    }
    // A spindle that has turned knows its zero mark.
    let lines = vec![m3(60.0), dwell(3.0), m5(60.0), dwell(1.0), orient(0.0, Approach::Direct), dwell(0.1)];
    let planner = run_on(&orientable(), vec![], lines);
    assert!(turned(&planner, 4, 5).abs() <= 0.5);
}

#[test]
fn block_ends_when_axes_and_spindle_arrive() {
    // 180° at 100 r/min with 0.5 s up and down: 0.5 turns are short of the 0.833 of both ramps.
    let peak = (120.0_f64 * 0.5 / (2.0 / 200.0)).sqrt();
    let spun = 2.0 * peak / 200.0;
    for (length, moved) in [(1.0, 0.1), (100.0, 10.0)] {
        let motion = Canon::Linear { to: target(length, 0.0), feed: Feed::PerMinute(600.0), exact: false };
        let mut lines = at_angle(0.0);
        lines.extend([Line::Nc(vec![Orient { angle: 180.0, approach: Approach::Direct }, motion]), dwell(0.1)]);
        let planner = run_on(&orientable(), vec![], lines);
        let [begin, end] = [2, 3].map(|line| begins(&planner, line));
        let wanted = f64::max(moved, spun);
        close(end - begin, wanted, 1e-6);
        // They go at the same time.
        let early = planner.timeline().at(begin + 0.05);
        assert!(early.spindle.actual > 0.0 && early.axes[0].feed > 0.0);
    }
}

#[test]
fn angle_is_held_until_m3_m4_or_m5() {
    let mut lines = vec![m3(300.0), dwell(1.0), orient(45.0, Approach::Direct), dwell(1.0)];
    lines.extend([one(Canon::SpindleSpeed { rpm: 240.0 }), dwell(1.0)]);
    lines.extend([one(Canon::SpindleDirection { rotation: Rotation::Clockwise }), dwell(2.0)]);
    let planner = run_on(&orientable(), vec![], lines);
    let moment = |line| planner.timeline().at(begins(&planner, line) + 0.5).spindle;
    assert!(moment(3).held && moment(5).held && (moment(5).angle - 45.0).abs() < 1e-9);
    let last = planner.timeline().at(planner.timeline().end()).spindle;
    assert_eq!((last.held, last.actual), (false, 240.0));
    // Reset leaves it held, emergency stop does not; during the orientation both stop it.
    let lines = || vec![m3(300.0), dwell(1.0), orient(45.0, Approach::Direct), dwell(9.0)];
    let there = begins(&planner, 3);
    for (t, action, held) in [
        (there + 1.0, Action::Reset, true),
        (there + 1.0, Action::EmergencyStop, false),
        (there - 0.2, Action::Reset, false),
    ] {
        let planner = run_on(&orientable(), vec![at(t, action)], lines());
        let last = planner.timeline().at(t + 5.0).spindle;
        assert_eq!((last.held, last.actual), (held, 0.0));
    }
}

#[test]
fn spindle_without_positioning_stops_the_program() {
    let mut without = orientable();
    without.spindle.encoder = false;
    for plant in [plant(), without] {
        let mut planner = planner(&plant, vec![], vec![orient(45.0, Approach::Direct), dwell(9.0)]);
        let (_, end) = finish(&mut planner);
        assert!(matches!(end, RunEnd::Alarm(alarm) if alarm.message.id == "motion.no-positioning"));
    }
}

//! Paths, blocks, joints, clamps, holds.

use super::*;

/// Arcs, lines, joints, overrides and a hold in one run.
fn mixed() -> Planner<Script> {
    let arc = |x: f64, y: f64, cx: f64, cy: f64, clockwise: bool| {
        let feed = Feed::PerMinute(9000.0);
        one(Canon::Arc { to: target(x, y), plane: (0, 1), center: (cx * 1e3, cy * 1e3), clockwise, feed, exact: false })
    };
    let lines = vec![
        linear(30.0, 0.0, 12000.0),
        arc(50.0, 20.0, 30.0, 20.0, false),
        arc(50.0, 20.0, 60.0, 20.0, true),
        linear(50.0, 60.0, 6000.0),
        rapid(0.0, 0.0),
        linear(-20.0, 7.0, 15000.0),
        one(Canon::End),
    ];
    let events = vec![
        at(0.15, Action::FeedOverride(80.0)),
        at(0.3, Action::FeedOverride(120.0)),
        at(0.5, Action::Hold),
        at(0.9, Action::Start),
        at(1.3, Action::RapidOverride(50.0)),
    ];
    run_on(&plant(), events, lines)
}

#[test]
fn speed_and_acceleration_are_derivatives_of_position() {
    let planner = mixed();
    let timeline = planner.timeline();
    let h = 1e-5;
    let (mut fastest, mut t) = (0.0f64, 0.0);
    while t < ended_at(&planner) {
        let (low, here, high) = (timeline.at(t - h), timeline.at(t), timeline.at(t + h));
        for k in 0..2 {
            let speed = (high.axes[k].position - low.axes[k].position) / (2.0 * h);
            assert!((speed - here.axes[k].feed / 60.0).abs() < 0.05, "axis {k} at {t}: {speed} {:?}", here.axes[k]);
            // Servo: dy/dt = K (P - y).
            let actual = (high.axes[k].actual - low.axes[k].actual) / (2.0 * h);
            let wanted = GAIN * (here.axes[k].position - here.axes[k].actual);
            assert!((actual - wanted).abs() < 0.05, "axis {k} at {t}: {actual} {wanted}");
            fastest = fastest.max(speed.abs());
        }
        t += 0.00371;
    }
    assert!(fastest > 150.0, "{fastest}");
}

#[test]
fn path_ends_at_its_target() {
    let planner = mixed();
    let end = planner.timeline().at(ended_at(&planner) + 2.0);
    assert_eq!((end.axes[0].position, end.axes[1].position), (-20.0, 7.0));
    assert_eq!((end.axes[0].actual, end.axes[1].actual), (-20.0, 7.0));
    assert_eq!((end.axes[0].feed, end.axes[0].acceleration), (0.0, 0.0));
    close(travelled(&planner, 0, 0.0, ended_at(&planner)), -20.0, 1e-5);
}

#[test]
fn arc_stays_on_its_circle() {
    // Without time constants the commanded path is the circle itself, at constant speed.
    let mut plant = plant();
    for axis in &mut plant.axes {
        axis.time_constant = 0.0;
    }
    let feed = Feed::PerMinute(6000.0);
    let turn =
        Canon::Arc { to: target(0.0, 0.0), plane: (0, 1), center: (20e3, 0.0), clockwise: true, feed, exact: false };
    let planner = run_on(&plant, vec![], vec![one(turn)]);
    let begin = plant.block_time;
    let whole = 2.0 * math::PI * 20.0 / 100.0;
    for i in 0..=100 {
        let t = begin + whole * f64::from(i) / 100.0;
        let now = planner.timeline().at(t.min(begin + whole - 1e-9));
        let (x, y) = (now.axes[0].position - 20.0, now.axes[1].position);
        close(math::hypot(x, y), 20.0, 1e-9);
        close(math::hypot(now.axes[0].feed, now.axes[1].feed), 6000.0, 1e-9);
    }
    // Clockwise from the left: up first.
    assert!(planner.timeline().at(begin + whole / 4.0).axes[1].position > 19.99);
    close(ended_at(&planner), begin + whole, 1e-9);
}

#[test]
fn arc_acceleration_and_radius_error_match_the_formula() {
    // Fanuc: linear acceleration after the interpolator loses T²/24 v²/r, the servo 1/2 (v/K)²/r (sizing.md section 4).
    let feed = Feed::PerMinute(6000.0);
    let turns = |n: usize| {
        let arc = Canon::Arc {
            to: target(0.0, 0.0),
            plane: (0, 1),
            center: (50e3, 0.0),
            clockwise: false,
            feed,
            exact: false,
        };
        vec![one(arc); n]
    };
    let planner = run(turns(3));
    let now = planner.timeline().at(5.0);
    let radius = |x: f64, y: f64| math::hypot(x - 50.0, y);
    let v: f64 = 100.0;
    close(50.0 - radius(now.axes[0].position, now.axes[1].position), TAU * TAU / 24.0 * v * v / 50.0, 0.01);
    let servo = radius(now.axes[0].position, now.axes[1].position) - radius(now.axes[0].actual, now.axes[1].actual);
    close(servo, 0.5 * v * v / (GAIN * GAIN) / 50.0, 0.02);
}

#[test]
fn isolated_block_takes_its_time_plus_time_constant() {
    for (length, feed) in [(50.0, 6000.0), (8.0, 15079.645), (1.0, 3000.0)] {
        let planner = run(vec![linear(length, 0.0, feed)]);
        let begin = plant().block_time;
        let whole = length / feed * 60.0;
        let (mut peak, mut steepest) = (0.0f64, 0.0f64);
        for i in 0..=20_000 {
            let now = planner.timeline().at(begin + (whole + TAU) * f64::from(i) / 20_000.0);
            peak = peak.max(now.axes[0].feed);
            steepest = steepest.max(now.axes[0].acceleration.abs());
        }
        close(peak, feed * (whole / TAU).min(1.0), 1e-4);
        close(steepest, feed / 60.0 / TAU, 1e-9);
        close(ended_at(&planner), begin + whole + TAU, 1e-9);
        assert_eq!(planner.timeline().at(begin - 1e-9).axes[0].feed, 0.0);
        let end = ended_at(&planner);
        assert!(planner.timeline().at(end - 1e-4).axes[0].position < length);
        close(planner.timeline().at(end).axes[0].position, length, 1e-12);
    }
}

#[test]
fn cutting_mode_keeps_speed_through_block_joints() {
    let lines = (1..=100).map(|i| linear(8.0 * f64::from(i), 60.0 * f64::from(i), 114_098.2)).collect();
    let planner = run(lines);
    assert_eq!(planner.starved(), 0);
    let (full, half) = (planner.timeline().at(1.0), planner.timeline().at(2.0));
    close(full.axes[0].feed, half.axes[0].feed, 1e-12);
    let mut t = 0.2;
    while t < 3.0 {
        let now = planner.timeline().at(t);
        close(now.axes[0].feed, full.axes[0].feed, 1e-12);
        if t > 0.8 {
            close(now.axes[0].position - now.axes[0].actual, full.axes[0].feed / 60.0 / GAIN, 1e-7);
        }
        t += 0.0013;
    }
}

#[test]
fn exact_stop_time_matches_the_fact_sheet() {
    // sizing.md section 6, F1 to F8: 8 mm at 251.327 mm/s, gain 33, in position 20 µm.
    let v: f64 = 1200.0 / 60.0 * math::PI * 100.0 / 25.0;
    for (tau, cycle, share) in [(0.1, 0.261_537, 0.121_707), (0.03, 0.215_083, 0.147_994)] {
        let mut plant = plant();
        plant.axes[0].time_constant = tau;
        plant.axes[1].time_constant = tau;
        let lines = (1..=20).map(|i| exact(8.0 * f64::from(i), 0.0, v * 60.0)).collect();
        let planner = run_on(&plant, vec![], lines);
        let starts: Vec<f64> = (0..3).map(|i| first(&planner, 0.0, |now| now.block == Some(place(i)))).collect();
        close(starts[1] - starts[0], cycle, 3e-6);
        // The next begins with the tolerance that the one before has left.
        close(starts[2] - starts[1], cycle, 2e-4);
        close(8.0 / cycle / v, share, 1e-5);
        // Lag when the command ends (F3), and the tolerance when the next block begins.
        let end = starts[0] + 8.0 / v + tau;
        let left = |t: f64| planner.timeline().at(t).axes[0].position - planner.timeline().at(t).axes[0].actual;
        close(left(starts[1] - 1e-6), 0.02, 1e-3);
        if tau == 0.1 {
            close(left(end), 1.44526, 1e-3);
        }
    }
}

#[test]
fn program_switches_exact_stop_off() {
    let suppress = Canon::Suppress { hold: false, feed_override: false, exact: true };
    let lines = vec![one(suppress), exact(8.0, 0.0, 15000.0), exact(16.0, 0.0, 15000.0)];
    let planner = run(lines);
    let starts: Vec<f64> = (1..3).map(|i| first(&planner, 0.0, |now| now.block == Some(place(i)))).collect();
    close(starts[1] - starts[0], 0.032, 1e-4);
}

#[test]
fn clamp_slows_the_vector_and_keeps_the_ratio() {
    let mut plant = plant();
    plant.axes[1].clamp = 60e3;
    // The paper's block needs 118 m/min of Y.
    let planner = run_on(&plant, vec![], vec![linear(80.0, 628.319, 119_391.393)]);
    let now = planner.timeline().at(0.4);
    close(now.axes[1].feed, 60e3, 1e-9);
    close(now.axes[0].feed, 60e3 * 80.0 / 628.319, 1e-9);
    assert_eq!(planner.diagnostics()[0].message.id, "motion.axis-clamp");
}

#[test]
fn rapid_is_straight_within_every_axis_rate() {
    let mut plant = plant();
    plant.axes[1].rapid = 12e3;
    let planner = run_on(
        &plant,
        vec![at(0.0, Action::RapidOverride(50.0))],
        vec![rapid(300.0, 100.0), linear(310.0, 100.0, 6000.0)],
    );
    let now = planner.timeline().at(0.5);
    close(now.axes[0].feed, 15e3, 1e-9);
    close(now.axes[1].feed, 5e3, 1e-9);
    // After a rapid the control waits until the command is at rest.
    let next = first(&planner, 0.0, |now| now.block == Some(place(1)));
    close(next, plant.block_time + 300.0 / 250.0 + TAU, 1e-6);
}

#[test]
fn hold_and_start_keep_the_path() {
    let events = vec![at(0.5, Action::Hold), at(1.5, Action::Start)];
    let planner = run_on(&plant(), events, vec![linear(100.0, 40.0, 6000.0), linear(200.0, 80.0, 6000.0)]);
    let held = planner.timeline().at(1.2);
    assert_eq!(held.mode, Mode::Hold);
    assert_eq!((held.axes[0].feed, held.axes[1].feed), (0.0, 0.0));
    assert_eq!(planner.timeline().at(0.4).mode, Mode::Running);
    close(held.axes[1].position / held.axes[0].position, 0.4, 1e-12);
    let length = math::hypot(200.0, 80.0);
    close(ended_at(&planner), plant().block_time + length / 100.0 + 1.0 + TAU, 1e-9);
    assert_eq!(planner.timeline().at(ended_at(&planner)).axes[0].position, 200.0);
}

#[test]
fn program_switches_hold_and_feed_override_off() {
    let suppress = Canon::Suppress { hold: true, feed_override: true, exact: false };
    let events = vec![at(0.2, Action::Hold), at(0.3, Action::FeedOverride(10.0))];
    let planner = run_on(&plant(), events, vec![one(suppress), linear(100.0, 0.0, 6000.0)]);
    close(ended_at(&planner), 2.0 * plant().block_time + 1.0 + TAU, 1e-9);
}

#[test]
fn feed_override_acts_at_once_and_0_waits() {
    let events = vec![at(0.5, Action::FeedOverride(0.0)), at(1.0, Action::FeedOverride(50.0))];
    let planner = run_on(&plant(), events, vec![linear(100.0, 0.0, 6000.0)]);
    let begin = plant().block_time;
    close(ended_at(&planner), 1.0 + (100.0 - (0.5 - begin) * 100.0) / 50.0 + TAU, 1e-9);
    let mut stuck = planner_for_ever();
    assert_eq!(finish(&mut stuck).1, RunEnd::Stop);
    assert_eq!(stuck.diagnostics()[0].message.id, "motion.no-feed");
}

fn planner_for_ever() -> Planner<Script> {
    planner(&plant(), vec![at(0.5, Action::FeedOverride(0.0))], vec![linear(100.0, 0.0, 6000.0)])
}

#[test]
fn feed_per_revolution_follows_the_spindle() {
    let feed = Feed::PerRevolution(0.25);
    let travel = Canon::Linear { to: target(60.0, 0.0), feed, exact: false };
    let planner = run(vec![m3(1200.0), one(travel)]);
    // The path is the turns times the feed, through the ramp and after it.
    let begin = first(&planner, 0.0, |now| now.block == Some(place(1)));
    let turns = |t: f64| planner.timeline().at(t).spindle.turns;
    for t in [0.5, 1.0, 3.0, 5.0] {
        // The acceleration delays the path by half its time constant, and rounds a ramp a by a τ²/24.
        let wanted = 0.25 * (turns(t - 0.5 * TAU) - turns(begin));
        let round = 0.25 * 740.0 / 60.0 * TAU * TAU / 24.0;
        let off = planner.timeline().at(t).axes[0].position - wanted;
        assert!((-1e-5..round + 1e-4).contains(&off), "{t}: {off}");
    }
    let whole = 60.0 / 0.25;
    let reached = first(&planner, 0.0, |now| now.spindle.actual >= 1200.0 - 1e-6);
    let end = reached + (whole - (turns(reached) - turns(begin))) / 20.0;
    close(ended_at(&planner), end + TAU, 1e-5);
}

//! The timeline after the end of a run goes on until axes and spindle have settled, and not much longer.

use super::*;
use macroline::motion::{PlcAlarm, PlcOrders, PlcSignals};

/// Everything has settled at the end of the timeline, and 20 ms before something had not.
#[track_caller]
fn settles_at_the_end(planner: &Planner<Script>) {
    let (end, over) = (planner.timeline().end(), ended_at(planner));
    let settled = |t: f64| {
        let (now, later) = (planner.timeline().at(t), planner.timeline().at(t + 60.0));
        let still =
            |k: usize| now.axes[k].feed.abs() < 1e-6 && (now.axes[k].position - now.axes[k].actual).abs() < 1.001e-5;
        (0..2).all(still) && (now.spindle.actual - later.spindle.actual).abs() < 0.5
    };
    assert!(settled(end), "{:?}", planner.timeline().at(end));
    assert!(over < end && !settled(end - 0.02), "too long: {over} to {end}");
}

fn cutting(events: Vec<Event>) -> Planner<Script> {
    let lines = vec![m3(1200.0), linear(100.0, 30.0, 6000.0), linear(200.0, 0.0, 6000.0), one(Canon::End)];
    run_on(&plant(), events, lines)
}

#[test]
fn program_end_goes_on_until_the_lag_is_gone() {
    let planner = cutting(Vec::new());
    settles_at_the_end(&planner);
    let end = planner.timeline().at(planner.timeline().end());
    assert_eq!(end.mode, Mode::Ended);
    assert!((end.axes[0].actual - 200.0).abs() < 1.001e-5 && end.spindle.actual > 1000.0, "{end:?}");
    // 100 mm/s lag 3 mm: e to the K t of 33/s leaves 10 nm of it after half a second.
    assert!(planner.timeline().end() - ended_at(&planner) < 0.5);
}

#[test]
fn hold_lasts_until_the_axes_rest_and_the_spindle_turns() {
    let planner = cutting(vec![at(0.8, Action::Hold)]);
    assert_eq!(ended_at(&planner), 0.8);
    settles_at_the_end(&planner);
    let end = planner.timeline().at(planner.timeline().end());
    assert_eq!(end.mode, Mode::Hold);
    assert!(end.spindle.actual > 1000.0);
}

#[test]
fn emergency_stop_goes_on_until_the_spindle_has_coasted() {
    let planner = cutting(vec![at(0.8, Action::EmergencyStop)]);
    assert_eq!(ended_at(&planner), 0.8);
    settles_at_the_end(&planner);
    assert_eq!(planner.timeline().at(planner.timeline().end()).spindle.actual, 0.0);
    // In the middle of the ramp up, 0.8 s less the wait for FIN.
    assert!(planner.timeline().end() > 1.3, "{}", planner.timeline().end());
}

#[test]
fn reset_and_stop_go_on_to_standstill() {
    settles_at_the_end(&cutting(vec![at(0.8, Action::Reset)]));
    let lines = vec![m3(1200.0), linear(100.0, 0.0, 6000.0), one(Canon::Stop), one(Canon::End)];
    settles_at_the_end(&run_on(&plant(), Vec::new(), lines));
    settles_at_the_end(&run(vec![linear(10.0, 0.0, 6000.0), one(Canon::Stop)]));
}

#[test]
fn run_without_motion_ends_at_once() {
    let planner = run(vec![one(Canon::End)]);
    assert_eq!(planner.timeline().end(), ended_at(&planner));
}

/// Raises an alarm at 0.8 s.
#[derive(Debug, Clone)]
struct Alarming(BenchPlc);

impl Plc for Alarming {
    fn scan(&mut self, t: f64, signals: &PlcSignals, orders: &mut PlcOrders) -> Option<f64> {
        let next = self.0.scan(t, signals, orders);
        orders.alarm = (t == 0.8).then_some(PlcAlarm::GearTimeout);
        [next, (t < 0.8).then_some(0.8)].into_iter().flatten().reduce(f64::min)
    }

    fn boxed(&self) -> Box<dyn Plc> {
        Box::new(self.clone())
    }
}

#[test]
fn plc_alarm_mid_cut_stops_where_the_axes_are() {
    let lines = vec![m3(1200.0), linear(100.0, 30.0, 6000.0), one(Canon::End)];
    let plc = Alarming(bench_plc(0.05, None));
    let mut planner = planner_with(Box::new(plc), &plant(), Vec::new(), lines);
    let (t, end) = finish(&mut planner);
    assert_eq!(t, 0.8);
    assert!(matches!(end, RunEnd::Alarm(_)));
    settles_at_the_end(&planner);
    let (before, after) = (planner.timeline().at(t), planner.timeline().at(planner.timeline().end()));
    // Half of 100 mm/s for the time constant.
    let left = after.axes[0].position - before.axes[0].position;
    assert!((0.0..=100.0 * TAU / 2.0 + 1e-6).contains(&left), "{left}");
}

/// Has the key "feed hold" at an input, and holds the program by it, or not.
#[derive(Debug, Clone)]
struct WithKey(BenchPlc, bool);

impl Plc for WithKey {
    fn scan(&mut self, t: f64, signals: &PlcSignals, orders: &mut PlcOrders) -> Option<f64> {
        orders.program_held = self.1 && signals.hold_key;
        self.0.scan(t, signals, orders)
    }

    fn reads_hold_key(&self) -> bool {
        true
    }

    fn boxed(&self) -> Box<dyn Plc> {
        Box::new(self.clone())
    }
}

#[test]
fn hold_key_at_the_plc_acts_through_it_alone() {
    for (holds, wanted) in [(true, RunEnd::Stop), (false, RunEnd::ProgramEnd)] {
        let lines = vec![m3(1200.0), linear(100.0, 30.0, 6000.0), one(Canon::End)];
        let plc = WithKey(bench_plc(0.05, None), holds);
        let mut planner = planner_with(Box::new(plc), &plant(), vec![at(0.8, Action::Hold)], lines);
        assert_eq!(finish(&mut planner).1, wanted);
        assert!(!planner.is_held_by_plc(), "the key is released");
    }
}

#[test]
fn an_event_before_standstill_changes_nothing_before_it() {
    for first in [Action::Hold, Action::Reset, Action::EmergencyStop] {
        for then in [0.8, 0.801, 0.9, 1.3, 9.0] {
            let events = vec![at(0.8, first.clone()), at(then, Action::Reset), at(then + 0.1, Action::Start)];
            let known = cutting(events.clone());
            let mut added = cutting(events[..1].to_vec());
            for event in &events[1..] {
                added.event(event.clone());
                finish(&mut added);
            }
            assert_eq!(known.timeline().end(), added.timeline().end());
            for i in 0..300 {
                let t = known.timeline().end() * f64::from(i) / 299.0;
                assert_eq!(known.timeline().at(t), added.timeline().at(t), "{first:?} {then} at {t}");
            }
        }
    }
}

#[test]
fn planning_in_slices_ends_at_the_same_standstill() {
    let whole = cutting(vec![at(0.8, Action::EmergencyStop)]);
    let lines = vec![m3(1200.0), linear(100.0, 30.0, 6000.0), linear(200.0, 0.0, 6000.0), one(Canon::End)];
    let mut sliced = planner(&plant(), vec![at(0.8, Action::EmergencyStop)], lines);
    let mut until = 0.0;
    while sliced.advance(until, 3).ended.is_none() {
        until += 0.01;
        assert!(until < 60.0);
    }
    assert_eq!((sliced.ended_at(), sliced.timeline().end()), (whole.ended_at(), whole.timeline().end()));
}

#[test]
fn time_budget_also_limits_the_time_to_standstill() {
    let lines = vec![m3(1200.0), linear(100.0, 30.0, 6000.0), one(Canon::End)];
    let mut planner = Planner::new(Setup {
        program: Script::new(lines),
        control: control(),
        plant: &plant(),
        plc: Box::new(bench_plc(0.05, None)),
        panel: Panel::new([at(0.8, Action::EmergencyStop)]),
        limits: Budget { blocks: 1000, seconds: 0.9 },
        keep: Retention::Timeline,
        findings: Vec::new(),
    });
    let (t, end) = finish(&mut planner);
    assert!(matches!(end, RunEnd::Alarm(_)));
    assert_eq!((t, planner.timeline().end()), (0.8, 0.9));
}

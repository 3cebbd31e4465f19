//! Axes that the PLC turns: their ratio holds through every change of speed, and their lag is that of any axis.

use super::*;
use macroline::motion::{PlcOrders, PlcSignals};

/// Turns both axes at speeds of its own, the second `k` times as fast: one entry (s, r/min) after the other, and 0 at reset. The feed
/// override acts on both.
#[derive(Debug, Clone)]
struct Turner {
    k: f64,
    speeds: Vec<(f64, f64)>,
    stopped: bool,
}

impl Plc for Turner {
    fn scan(&mut self, t: f64, signals: &PlcSignals, orders: &mut PlcOrders) -> Option<f64> {
        self.stopped |= signals.reset;
        let now = self.speeds.iter().rfind(|(from, _)| *from <= t).map_or(0.0, |(_, rpm)| *rpm);
        let now = if self.stopped { 0.0 } else { now * signals.knobs.feed / 100.0 };
        orders.pmc_speed = [now, self.k * now];
        self.speeds.iter().map(|(from, _)| *from).find(|from| *from > t)
    }

    fn boxed(&self) -> Box<dyn Plc> {
        Box::new(self.clone())
    }
}

const SPEEDS: [(f64, f64); 6] = [(0.1, 200.0), (0.73, 317.0), (0.75, -60.0), (1.2, 0.0), (2.0, 1000.0), (2.9, 10.0)];

fn turning(k: f64, tau: [f64; 2], gain: f64, events: Vec<Event>) -> Planner<Script> {
    let pmc = |time_constant| AxisPlant { time_constant, position_gain: gain, ..AxisPlant::PMC };
    let plant = Plant { pmc: tau.map(pmc).to_vec(), ..plant() };
    let plc = Turner { k, speeds: SPEEDS.to_vec(), stopped: false };
    let mut planner = planner_with(Box::new(plc), &plant, events, vec![one(Canon::Dwell { seconds: 4.0 })]);
    planner.advance(5.0, usize::MAX);
    planner
}

#[test]
fn pmc_ratio_holds_with_equal_time_constants() {
    let events = || vec![at(0.9, Action::FeedOverride(37.0)), at(2.2, Action::FeedOverride(120.0))];
    for (k, tau, gain) in [(2.0, 0.2, 33.0), (-12.0 / 5.0, 0.05, 0.0), (1.5, 0.0, 20.0), (3.0, 0.0, 0.0)] {
        for end in [Vec::new(), vec![at(2.51, Action::Reset)], vec![at(0.74, Action::EmergencyStop)]] {
            let planner = turning(k, [tau, tau], gain, [events(), end].concat());
            for i in 0..4000 {
                let [work, tool] = planner.timeline().at(f64::from(i) * 0.001).pmc;
                for (tool, work) in [(tool.position, work.position), (tool.actual, work.actual), (tool.feed, work.feed)]
                {
                    assert!((tool - k * work).abs() < 360.0 * 1e-9, "{k} at {i} ms: {tool} for {work}");
                }
            }
        }
    }
}

#[test]
fn unequal_time_constants_leave_the_faster_axis_ahead() {
    let planner = turning(2.0, [0.1, 0.3], 0.0, Vec::new());
    let [work, tool] = planner.timeline().at(0.7).pmc;
    let turns = 400.0 / 60.0 * (0.3 - 0.1) / 2.0;
    assert!((tool.position - 2.0 * work.position + 360.0 * turns).abs() < 1e-9);
    assert!((work.feed - 200.0 * 360.0).abs() < 1e-9 && (tool.feed - 400.0 * 360.0).abs() < 1e-9);
}

#[test]
fn pmc_angle_is_the_integral_of_speed() {
    let planner = turning(2.0, [0.1, 0.15], 33.0, Vec::new());
    let h = 1e-5;
    for t in [0.15, 0.21, 0.5, 0.745, 0.8, 1.25, 2.05, 2.95] {
        let [before, now, after] = [t - h, t, t + h].map(|t| planner.timeline().at(t).pmc);
        for axis in 0..2 {
            let speed = (after[axis].position - before[axis].position) / (2.0 * h) * 60.0;
            assert!((speed - now[axis].feed).abs() < 1.0, "{t}: {speed} for {}", now[axis].feed);
        }
    }
}

#[test]
fn late_override_gives_the_run_that_knew_it() {
    let event = || at(1.1, Action::FeedOverride(50.0));
    let whole = turning(2.0, [0.2, 0.2], 33.0, vec![event()]);
    let mut later = turning(2.0, [0.2, 0.2], 33.0, Vec::new());
    later.event(event());
    later.advance(5.0, usize::MAX);
    for i in 0..400 {
        let t = f64::from(i) * 0.01;
        assert_eq!(whole.timeline().at(t).pmc, later.timeline().at(t).pmc);
    }
}

//! Ramps, turns, slip, volts, and a PLC that waits for the speed.

use macroline::motion::{PlcOrders, PlcSignals};

use super::*;

#[test]
fn spindle_ramps_linearly_and_counts_turns_exactly() {
    let planner =
        run(vec![m3(1200.0), one(Canon::Dwell { seconds: 4.0 }), m4(600.0), one(Canon::Dwell { seconds: 4.0 })]);
    let timeline = planner.timeline();
    let begin = plant().block_time;
    let ramp = 2.0 * 1200.0 / 1480.0;
    close(timeline.at(begin + ramp / 2.0).spindle.actual, 600.0, 1e-9);
    close(first(&planner, 0.0, |now| now.spindle.actual >= 1200.0 - 1e-6) - begin, ramp, 1e-5);
    close(timeline.at(begin + ramp).spindle.turns, 10.0 * ramp, 1e-9);
    close(timeline.at(4.0).spindle.turns, 10.0 * ramp + 20.0 * (4.0 - begin - ramp), 1e-9);
    // Reversal: straight through 0, commanded at once.
    let reverse = first(&planner, 3.0, |now| now.spindle.command < 0.0);
    let back = 2.0 * 1800.0 / 1480.0;
    assert!(timeline.at(reverse + back / 3.0 * 2.0).spindle.actual.abs() < 1e-3);
    close(timeline.at(reverse + back + 0.1).spindle.actual, -600.0, 1e-9);
    let turned = timeline.at(reverse + back).spindle.turns - timeline.at(reverse).spindle.turns;
    close(turned, (1200.0 - 600.0) / 2.0 / 60.0 * back, 1e-5);
}

#[test]
fn volts_match_the_fact_sheet() {
    // ribbon-line.md section 4, 8.108 V at 100 %: override, volts.
    let analog = Analog::unipolar(1480.0, 10.0);
    let table = [
        (10.0, 0.811),
        (50.0, 4.054),
        (80.0, 6.486),
        (100.0, 8.108),
        (110.0, 8.919),
        (120.0, 9.730),
        (123.0, 9.973),
        (124.0, 10.0),
    ];
    for (percent, volts) in table {
        let lines = vec![m3(1200.0), one(Canon::Dwell { seconds: 3.0 })];
        let planner = run_on(&plant(), vec![at(0.0, Action::SpindleOverride(percent))], lines);
        let now = planner.timeline().at(3.0).spindle;
        assert!((now.volts_command - volts).abs() < 0.0005, "{percent} %: {}", now.volts_command);
        assert!((now.volts - now.volts_command).abs() <= 10.0 / 4095.0 / 2.0 + 1e-12);
        close(now.command, (12.0 * percent).min(1480.0), 1e-12);
    }
    assert_eq!(analog.code(1200.0), 3320);
    assert!((analog.output(1200.0) - 8.107).abs() < 0.0005);
    assert_eq!((analog.code(-1200.0), analog.code(9e9), analog.code(0.0)), (3320, 4095, 0));
}

#[test]
fn spindle_override_acts_at_once_and_reports_saturation() {
    let lines = vec![m3(1200.0), one(Canon::Dwell { seconds: 6.0 })];
    let planner = run_on(&plant(), vec![at(3.0, Action::SpindleOverride(150.0))], lines);
    assert_eq!(planner.timeline().at(2.999).spindle.command, 1200.0);
    assert_eq!(planner.timeline().at(3.0).spindle.command, 1480.0);
    assert_eq!(planner.diagnostics()[0].message.id, "motion.spindle-clamp");
}

#[test]
fn slip_reduces_speed_without_jumps() {
    for slip in [0.02, -0.0135] {
        let mut plant = plant();
        plant.spindle.slip = slip;
        plant.spindle.gain = 1500.0 / 1480.0;
        let lines = vec![
            m3(1200.0),
            one(Canon::Dwell { seconds: 4.0 }),
            one(Canon::SpindleDirection { rotation: Rotation::Stopped }),
        ];
        let planner = run_on(&plant, vec![], lines);
        let now = planner.timeline().at(3.0).spindle;
        close(now.actual, 1200.0 * 1500.0 / 1480.0 - slip * 1480.0, 1e-12);
        // Turns are the integral of the speed.
        let (mut sum, h) = (0.0, 1e-4);
        for i in 0..60_000 {
            sum += planner.timeline().at((f64::from(i) + 0.5) * h).spindle.actual / 60.0 * h;
        }
        close(planner.timeline().at(6.0).spindle.turns, sum, 1e-6);
    }
}

/// A builder's PLC that holds FIN back until the spindle is at speed.
#[derive(Debug, Clone)]
struct AtSpeed;

impl Plc for AtSpeed {
    fn scan(&mut self, t: f64, signals: &PlcSignals, orders: &mut PlcOrders) -> Option<f64> {
        orders.spindle.percent = signals.knobs.spindle;
        let waits = signals.m_strobe.is_some() || signals.s_strobe.is_some();
        orders.fin = waits && (signals.spindle_actual - signals.spindle_command).abs() < 1.0;
        (waits && !orders.fin).then_some(t + 10.0)
    }

    fn boxed(&self) -> Box<dyn Plc> {
        Box::new(self.clone())
    }
}

#[test]
fn plc_waits_for_the_spindle() {
    let lines = vec![m3(1200.0), linear(10.0, 0.0, 6000.0)];
    let mut planner = planner_with(Box::new(AtSpeed), &plant(), vec![], lines);
    finish(&mut planner);
    let moves = first(&planner, 0.0, |now| now.axes[0].feed > 0.0);
    close(moves, plant().block_time + 2.0 * 1200.0 / 1480.0, 1e-4);
}

//! A main spindle on its inverter, for every lathe that has one: verdict of its ramp, fan, charts of torque and power over the speed.

use super::devices::{AskedDevice, BillItem};
use super::form::Field;
use super::verdict::{Judgement, fail, maximum, ok, up, warn};
use crate::drives::MainSpindle;
use crate::drives::spindle_motor::{self, MotorCurve};
use crate::msg;
use crate::view::Limit::AtMost;
use crate::view::{Advice, Chart, Series};

/// The ramp of the form, its field `id`, against the shortest one to a highest speed of the program in r/min: a warning where it is long enough
/// for that speed and not for the one at the highest position of the override knob, given with its percentage.
pub(super) fn judge_ramp<P>(
    spindle: &MainSpindle,
    highest: f64,
    at_knob: Option<(f64, f64)>,
    (fields, id): (&[Field<P>], &'static str),
) -> Option<Judgement> {
    let (ramp, shortest) = (spindle.ramp, spindle.shortest_ramp(highest));
    let limit = AtMost(ramp);
    if limit.holds(shortest) {
        let at_knob = at_knob.map(|(percent, speed)| (percent, spindle.shortest_ramp(speed)));
        let Some((percent, shortest)) = at_knob.filter(|(_, shortest)| !limit.holds(*shortest)) else {
            return ok(limit);
        };
        let set = up(fields, id, shortest);
        let said =
            Advice::from(msg!("lathe.ramp-at-knob", percent = (percent, 0), needed = (shortest, 2), ramp = (ramp, 2)));
        let button = msg!("advice.set-ramp", time = set.text.as_str());
        return warn(limit, [if shortest <= maximum(fields, id) { said.setting(button, [set]) } else { said }]);
    }
    if shortest == f64::INFINITY {
        let [motor, _] = spindle.short_time();
        let gives = motor.torque(highest);
        let friction = (spindle.load_at_spindle.torque, 1);
        return fail(limit, [msg!("lathe.friction-stalls", friction, torque = (gives, 1)).into()]);
    }
    let set = up(fields, id, shortest);
    let advice = Advice::from(msg!("lathe.ramp-too-short", needed = (shortest, 2), ramp = (ramp, 2)));
    let button = msg!("advice.set-ramp", time = set.text.as_str());
    fail(limit, [if shortest <= maximum(fields, id) { advice.setting(button, [set]) } else { advice }])
}

/// The fan with a supply of its own, where a drive has forced cooling (IC 416).
pub(super) fn fan(drive: &'static str, is_forced: bool) -> Option<AskedDevice> {
    is_forced.then(|| AskedDevice { item: BillItem::Fan, drive: Some(drive), asked: msg!("lathe.device.fan") })
}

/// Colours of the cut, and of the short-time rating in the engaged stage.
const CUT: u8 = 4;
const SHORT: u8 = 5;

/// Curves of the motor over the speed of the spindle, each up to the speed (r/min) at 10 V, and the demand of the cut.
pub(super) struct SpeedCurves {
    /// Continuous curve of each gear stage, with label and colour.
    pub stages: Vec<(&'static str, u8, MotorCurve, f64)>,
    /// Short-time curve in the engaged stage.
    pub short_time: Option<(MotorCurve, f64)>,
    /// Speeds (r/min) with the torque (Nm) of cut and friction; empty where none is known.
    pub cut: Vec<(f64, f64)>,
}

/// Charts over the speed of the spindle: torque and power of the motor, and the demand of the cut.
pub(super) fn charts_by_speed(curves: SpeedCurves, points: usize) -> Vec<Chart> {
    let points = points.max(2);
    // P = M ω: it grows with the speed below base speed.
    let lines = |of: fn(f64, f64) -> f64| -> Vec<Series> {
        let line = |label, tone, points| Series { label, tone, address: None, points };
        let curve = |motor: &MotorCurve, top: f64| {
            let speeds = (0..points).map(|at| top * (at as f64 / (points - 1) as f64));
            speeds.map(|speed| (speed, of(motor.torque(speed), speed))).collect::<Vec<_>>()
        };
        let stages = curves.stages.iter().map(|(label, tone, motor, top)| line(label, *tone, curve(motor, *top)));
        let short = curves.short_time.as_ref();
        let short = short.map(|(motor, top)| line("lathe.chart.short-time", SHORT, curve(motor, *top)));
        let cut = curves.cut.iter().map(|(speed, torque)| (*speed, of(*torque, *speed))).collect::<Vec<_>>();
        let cut = (!cut.is_empty()).then(|| line("lathe.chart.cut", CUT, cut));
        stages.chain(short).chain(cut).collect()
    };
    let chart = |id, title, unit, series| Chart {
        id,
        title,
        unit,
        least_span: 0.0,
        x_unit: "r/min",
        series,
        limits: Vec::new(),
    };
    vec![
        chart("torque-speed", "lathe.chart.torque-speed", "Nm", lines(|torque, _| torque)),
        chart("power-speed", "lathe.chart.power-speed", "kW", lines(spindle_motor::power)),
    ]
}

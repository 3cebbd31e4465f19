//! The charts of the turning spindle: over time from the run, over diameter and speed from the formulas.

use super::resolved::TurningSpindle;
use crate::controls::Address;
use crate::drives::speed::surface_speed;
use crate::machines::chart_rows::{ChartLine, ChartRow, unlimited};
use crate::machines::lathe::main_spindle::{self, SpeedCurves};
use crate::view::{Chart, ChartAxis, ChartLimit, Series};

/// Charts over time, from top to bottom.
#[rustfmt::skip]
pub(super) const ROWS: &[ChartRow<TurningSpindle>] = &[
    ChartRow { id: "speed", title: "turning.chart.speed", unit: "r/min", least_span: 1.0, lines: &[
        ChartLine { label: |_| "turning.chart.command", tone: 0, address: |_| Some(Address::S), value: |_, now| now.spindle.command },
        ChartLine { label: |_| "turning.chart.actual", tone: 1, address: |_| Some(Address::S), value: |_, now| now.spindle.actual },
    ], limits: upper_limit },
    ChartRow { id: "surface", title: "turning.chart.surface", unit: "m/min", least_span: 0.1, lines: &[
        ChartLine { label: |_| "turning.chart.at-tool", tone: 2, address: |_| None, value: |lathe, now| surface_speed(now.spindle.actual, lathe.diameter(now)) },
    ], limits: unlimited },
    ChartRow { id: "volts", title: "turning.chart.volts", unit: "V", least_span: 0.01, lines: &[
        ChartLine { label: |_| "turning.chart.output", tone: 3, address: |_| Some(Address::S), value: |_, now| now.spindle.volts },
    ], limits: unlimited },
    ChartRow { id: "stage", title: "turning.chart.stage", unit: "", least_span: 1.0, lines: &[
        ChartLine { label: |_| "turning.chart.engaged", tone: 4, address: |_| None, value: |_, now| f64::from(now.spindle.stage) },
    ], limits: unlimited },
    ChartRow { id: "diameter", title: "turning.chart.diameter", unit: "mm", least_span: 0.01, lines: &[
        ChartLine { label: |_| "turning.chart.tool", tone: 0, address: |_| None, value: |lathe, now| lathe.diameter(now) },
    ], limits: unlimited },
];

/// The upper limit of the speed, where the program commands a constant surface speed.
fn upper_limit(lathe: &TurningSpindle) -> Vec<ChartLimit> {
    let limit = ChartLimit { label: "turning.upper-limit", value: lathe.params.upper_limit };
    if lathe.surface() { vec![limit] } else { Vec::new() }
}

/// Charts over the diameter: constant surface speed beside the fixed speed.
pub(super) fn over_diameter(lathe: &TurningSpindle, points: usize) -> Vec<Chart> {
    let d = &lathe.derived;
    let points = points.max(2);
    let step = (d.cut.largest - d.cut.smallest) / (points - 1) as f64;
    let held = |diameter: f64| d.speeds.held.at(diameter).0;
    let line = |label: &'static str, tone: u8, value: &dyn Fn(f64) -> f64| Series {
        label,
        tone,
        address: None,
        points: (0..points).map(|at| d.cut.smallest + step * at as f64).map(|x| (x, value(x))).collect(),
    };
    let chart = |id: &'static str, title: &'static str, unit: &'static str, series: Vec<Series>| Chart {
        id,
        title,
        unit,
        least_span: 0.0,
        x: ChartAxis::Diameter,
        series,
        limits: Vec::new(),
    };
    vec![
        chart(
            "speed-diameter",
            "turning.chart.speed-diameter",
            "r/min",
            vec![line("turning.chart.constant-surface", 0, &held), line("turning.chart.fixed", 1, &|_| d.speeds.fixed)],
        ),
        chart(
            "surface-diameter",
            "turning.chart.surface-diameter",
            "m/min",
            vec![
                line("turning.chart.constant-surface", 2, &|x| surface_speed(held(x), x)),
                line("turning.chart.fixed", 1, &|x| surface_speed(d.speeds.fixed, x)),
            ],
        ),
    ]
}

/// Names and colours of the gear stages.
const STAGES: [(&str, u8); 4] = [
    ("turning.chart.stage-1", 0),
    ("turning.chart.stage-2", 1),
    ("turning.chart.stage-3", 2),
    ("turning.chart.stage-4", 3),
];

/// Charts over the speed of the spindle: torque and power of the motor in each gear stage, and the demand of the cut.
pub(super) fn charts_by_speed(lathe: &TurningSpindle, points: usize) -> Vec<Chart> {
    let (p, d) = (&lathe.params, &lathe.derived);
    let points = points.max(2);
    let stages = STAGES.into_iter().zip(p.stages());
    let stages =
        stages.map(|((label, tone), stage_speed)| (label, tone, p.continuous(stage_speed), stage_speed)).collect();
    let short = p.motor(d.stage.speed).share(p.spindle.peak / 100.0);
    let cut = |at: usize| {
        let diameter = d.cut.smallest + (d.cut.largest_whole - d.cut.smallest) * at as f64 / (points - 1) as f64;
        (d.speeds.at(p, diameter), p.steady_torque(diameter))
    };
    main_spindle::charts_by_speed(
        SpeedCurves {
            stages,
            short_time: (d.stage.speed > 0.0).then_some((short, d.stage.speed)),
            cut: if p.cutting_force > 0.0 { (0..points).map(cut).collect() } else { Vec::new() },
        },
        points,
    )
}

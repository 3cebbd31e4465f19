//! The charts of the ribbon line: speeds, analog output, slack and register error over time.

use super::params::Params;
use super::pose::{State, X, Y};
use crate::machines::Samples;
use crate::motion::Snapshot;
use crate::view::{Chart, Series};

/// A line: name, tone, and its value at a moment.
type Line = (&'static str, u8, fn(&Params, &Snapshot) -> f64);

/// A chart: id, title, unit, lines.
type Row = (&'static str, &'static str, &'static str, &'static [Line]);

/// All charts, from top to bottom.
const ROWS: &[Row] = &[
    (
        "feeds",
        "ribbon.chart.feeds",
        "mm/min",
        &[("ribbon.chart.x", 0, |_, now| now.axes[X].feed), ("ribbon.chart.y", 1, |_, now| now.axes[Y].feed)],
    ),
    (
        "spindle",
        "ribbon.chart.spindle",
        "r/min",
        &[
            ("ribbon.chart.command", 0, |_, now| now.spindle.command),
            ("ribbon.chart.actual", 1, |_, now| now.spindle.actual),
        ],
    ),
    ("volts", "ribbon.chart.volts", "V", &[("ribbon.chart.output", 2, |_, now| now.spindle.volts)]),
    ("slack", "ribbon.chart.slack", "mm", &[("ribbon.chart.loop", 3, |p, now| State::new(p, now).slack)]),
    ("register", "ribbon.chart.register", "mm", &[("ribbon.chart.dot", 4, |p, now| State::new(p, now).register(p))]),
];

/// The charts from `from` to `to` seconds with `points` points (2 at least) each.
pub(super) fn charts(p: &Params, run: &dyn Samples, from: f64, to: f64, points: usize) -> Vec<Chart> {
    let points = points.max(2);
    let step = (to - from) / (points - 1) as f64;
    let moments: Vec<(f64, Snapshot)> = (0..points).map(|at| from + step * at as f64).map(|t| (t, run.at(t))).collect();
    let line = |(label, tone, value): &Line| Series {
        label,
        tone: *tone,
        points: moments.iter().map(|(t, now)| (*t, value(p, now))).collect(),
    };
    let chart = |(id, title, unit, lines): &Row| Chart {
        id,
        title,
        unit,
        x_unit: "s",
        series: lines.iter().map(line).collect(),
    };
    ROWS.iter().map(chart).collect()
}

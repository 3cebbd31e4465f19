//! The charts of the ribbon line: speeds, analog output, slack and register error over time.

use super::fitted::Fitted;
use super::pose::State;
use crate::machines::Samples;
use crate::motion::Snapshot;
use crate::view::{Chart, Series};

/// A line: name (empty: that of the print roller's axis), tone, and its value at a moment.
type Line = (&'static str, u8, fn(&Fitted, &Snapshot) -> f64);

/// A chart: id, title, unit, lines.
type Row = (&'static str, &'static str, &'static str, &'static [Line]);

/// All charts, from top to bottom.
const ROWS: &[Row] = &[
    (
        "feeds",
        "ribbon.chart.feeds",
        "mm/min",
        &[
            ("ribbon.chart.x", 0, |line, now| now.axes[line.pull()].feed),
            ("", 1, |line, now| now.axes[line.print()].feed),
        ],
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
    ("slack", "ribbon.chart.slack", "mm", &[("ribbon.chart.loop", 3, |line, now| State::new(line, now).slack)]),
    (
        "register",
        "ribbon.chart.register",
        "mm",
        &[("ribbon.chart.dot", 4, |line, now| State::new(line, now).register(&line.p))],
    ),
];

/// The charts from `from` to `to` seconds with `points` points (2 at least) each.
pub(super) fn charts(line: &Fitted, run: &dyn Samples, from: f64, to: f64, points: usize) -> Vec<Chart> {
    let points = points.max(2);
    let step = (to - from) / (points - 1) as f64;
    let moments: Vec<(f64, Snapshot)> = (0..points).map(|at| from + step * at as f64).map(|t| (t, run.at(t))).collect();
    let drawn = |(label, tone, value): &Line| Series {
        label: if label.is_empty() { line.p.print_axis.name() } else { label },
        tone: *tone,
        points: moments.iter().map(|(t, now)| (*t, value(line, now))).collect(),
    };
    let chart = |(id, title, unit, lines): &Row| Chart {
        id,
        title,
        unit,
        x_unit: "s",
        series: lines.iter().map(drawn).collect(),
    };
    ROWS.iter().map(chart).collect()
}

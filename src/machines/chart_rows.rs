//! Charts of a run as rows: for every machine.

use super::Samples;
use super::verdict::Rows;
use crate::motion::Snapshot;
use crate::view::{Chart, Series};

/// A line of a chart.
pub(super) struct Line<M: Rows> {
    /// Catalog id of its name.
    pub(super) label: fn(&M::Resolved<'_>) -> &'static str,
    pub(super) tone: u8,
    pub(super) value: fn(&M::Resolved<'_>, &Snapshot) -> f64,
}

/// A chart over time.
pub(super) struct Row<M: Rows> {
    pub(super) id: &'static str,
    pub(super) title: &'static str,
    pub(super) unit: &'static str,
    pub(super) lines: &'static [Line<M>],
}

/// The charts from `from` to `to` seconds with `points` points (2 at least) each.
pub(super) fn charts<M: Rows>(
    rows: &[Row<M>],
    on: &M::Resolved<'_>,
    run: &dyn Samples,
    from: f64,
    to: f64,
    points: usize,
) -> Vec<Chart> {
    let points = points.max(2);
    let step = (to - from) / (points - 1) as f64;
    let moments: Vec<(f64, Snapshot)> = (0..points).map(|at| from + step * at as f64).map(|t| (t, run.at(t))).collect();
    let drawn = |line: &Line<M>| Series {
        label: (line.label)(on),
        tone: line.tone,
        points: moments.iter().map(|(t, now)| (*t, (line.value)(on, now))).collect(),
    };
    let chart = |row: &Row<M>| Chart {
        id: row.id,
        title: row.title,
        unit: row.unit,
        x_unit: "s",
        series: row.lines.iter().map(drawn).collect(),
    };
    rows.iter().map(chart).collect()
}

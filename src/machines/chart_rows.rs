//! Charts over time as rows.

use super::machine::Samples;
use crate::controls::Address;
use crate::motion::Snapshot;
use crate::view::{Chart, ChartAxis, ChartLimit, Series};

/// A line of a chart of a machine `M`.
pub struct ChartLine<M: 'static> {
    /// Catalog id of its name.
    pub label: fn(&M) -> &'static str,
    /// Number of its colour.
    pub tone: u8,
    /// Address of its axis or spindle; none for another quantity.
    pub address: fn(&M) -> Option<Address>,
    /// Its value at a moment of the run.
    pub value: fn(&M, &Snapshot) -> f64,
}

/// A chart over time of a machine `M`.
pub struct ChartRow<M: 'static> {
    /// Id, for instance `speed`.
    pub id: &'static str,
    /// Catalog id of the title.
    pub title: &'static str,
    /// Unit of its values.
    pub unit: &'static str,
    /// Least span of its axis: a signal that changes by less is drawn flat.
    pub least_span: f64,
    /// Its lines.
    pub lines: &'static [ChartLine<M>],
    /// Its limits.
    pub limits: fn(&M) -> Vec<ChartLimit>,
}

/// A chart without limits.
pub fn unlimited<M>(_: &M) -> Vec<ChartLimit> {
    Vec::new()
}

/// The charts from `from` to `to` seconds with `points` points (2 at least) each.
pub fn charts<M>(
    rows: &[ChartRow<M>],
    machine: &M,
    run: &dyn Samples,
    from: f64,
    to: f64,
    points: usize,
) -> Vec<Chart> {
    let points = points.max(2);
    let step = (to - from) / (points - 1) as f64;
    let moments: Vec<(f64, Snapshot)> = (0..points).map(|at| from + step * at as f64).map(|t| (t, run.at(t))).collect();
    let drawn = |line: &ChartLine<M>| Series {
        label: (line.label)(machine),
        tone: line.tone,
        address: (line.address)(machine),
        points: moments.iter().map(|(t, now)| (*t, (line.value)(machine, now))).collect(),
    };
    let chart = |row: &ChartRow<M>| Chart {
        id: row.id,
        title: row.title,
        unit: row.unit,
        least_span: row.least_span,
        x: ChartAxis::Time,
        series: row.lines.iter().map(drawn).collect(),
        limits: (row.limits)(machine),
    };
    rows.iter().map(chart).collect()
}

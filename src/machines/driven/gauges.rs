//! Quantities of a machine that are checked during operation.

use crate::motion::Snapshot;
use crate::view::Limit;

/// A quantity of a machine `M` that is checked during operation.
pub struct GaugeRow<M: 'static> {
    /// Id, for instance `loop`.
    pub id: &'static str,
    /// Catalog id of its name.
    pub label: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Decimals shown.
    pub decimals: u8,
    /// Its limit.
    pub limit: fn(&M) -> Option<Limit>,
    /// Field of the form with the limit, if there is one.
    pub field: Option<&'static str>,
    /// Its value at a moment of the run.
    pub value: fn(&M, &Snapshot) -> f64,
}

/// The worst value of a gauge in a part of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gauge {
    /// Id, for instance `loop`.
    pub id: &'static str,
    /// Catalog id of its name.
    pub label: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Decimals shown.
    pub decimals: u8,
    /// Its limit, in `unit`.
    pub limit: Option<Limit>,
    /// Field of the form with the limit, if there is one.
    pub field: Option<&'static str>,
    /// The worst value: the smallest for a lower limit, otherwise the largest; by magnitude if the limit applies to both signs.
    pub value: f64,
}

impl<M> GaugeRow<M> {
    /// The quantity with this value on a machine.
    pub fn gauge(&self, machine: &M, value: f64) -> Gauge {
        let GaugeRow { id, label, unit, decimals, field, .. } = *self;
        Gauge { id, label, unit, decimals, limit: (self.limit)(machine), field, value }
    }
}

/// Reads the gauges from `from` to `to` seconds at `points` moments, at least 2; `at` gives the machine at a time (s).
pub fn read<M>(
    rows: &[GaugeRow<M>],
    machine: &M,
    at: impl Fn(f64) -> Snapshot,
    (from, to): (f64, f64),
    points: usize,
) -> Vec<Gauge> {
    let points = points.max(2);
    let step = (to - from) / (points - 1) as f64;
    let moments: Vec<Snapshot> = (0..points).map(|point| at(from + step * point as f64)).collect();
    let gauge = |row: &GaugeRow<M>| {
        let limit = (row.limit)(machine);
        let values = moments.iter().map(|now| (row.value)(machine, now));
        let worse = |worst: f64, next: f64| {
            if Limit::load(limit, next) > Limit::load(limit, worst) { next } else { worst }
        };
        row.gauge(machine, values.reduce(worse).unwrap_or(0.0))
    };
    rows.iter().map(gauge).collect()
}

/// The size of a product that the operator types while the machine runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProductSize {
    /// Number of its variable.
    pub variable: u32,
    /// The present size, in the variable's unit.
    pub size: f64,
}

/// Axes of work and tool that coast to rest at a power failure, each at its own rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoastedAxes {
    /// Time (s) until both are at rest.
    pub seconds: f64,
    /// The quantity that they lose, at rest.
    pub gauge: Gauge,
}

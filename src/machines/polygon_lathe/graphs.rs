//! The charts of the polygon lathe: speeds, phase and slide over time, the deviation of the finished section over the angle.

use super::Lathe;
use super::fitted::{Fitted, TOOL, WORK};
use super::scene::deviations;
use crate::machines::charts::{Line, Row};
use crate::math::PI;
use crate::view::{Chart, Series};

/// Charts over time, from top to bottom.
#[rustfmt::skip]
pub(super) const ROWS: &[Row<Lathe>] = &[
    Row { id: "speeds", title: "polygon.chart.speeds", unit: "r/min", lines: &[
        Line { label: |_| "polygon.chart.work", tone: 0, value: |_, now| now.pmc[WORK].feed / 360.0 },
        Line { label: |_| "polygon.chart.tool", tone: 1, value: |_, now| now.pmc[TOOL].feed / 360.0 },
    ] },
    Row { id: "phase", title: "polygon.chart.phase", unit: "°", lines: &[
        Line { label: |_| "polygon.chart.ahead", tone: 3, value: |lathe, now| lathe.phase(now) },
    ] },
    Row { id: "size", title: "polygon.chart.size", unit: "mm", lines: &[
        Line { label: |_| "polygon.chart.across", tone: 2, value: |lathe, now| lathe.slide(now).0 },
    ] },
    Row { id: "along", title: "polygon.chart.along", unit: "mm", lines: &[
        Line { label: |_| "polygon.chart.z", tone: 4, value: |lathe, now| lathe.slide(now).1 },
    ] },
];

/// The deviation of the finished section from its sides, over the angle.
pub(super) fn deviation(lathe: &Fitted, points: usize) -> Option<Chart> {
    let section = lathe.section()?;
    let sides = lathe.ratio()?.sides(lathe.p.inserts as u32);
    // Every corner is met.
    let each = (points / (2 * sides as usize)).clamp(1, 3600) + 1;
    let all = deviations(&section, 0.5 * lathe.p.across_flats, sides, 2 * sides as usize * each);
    let begin = section.begin();
    let points = all.into_iter().map(|(angle, off)| ((angle - begin) * 180.0 / PI, 1000.0 * off)).collect();
    Some(Chart {
        id: "deviation",
        title: "polygon.chart.deviation",
        unit: "µm",
        x_unit: "°",
        series: vec![Series { label: "polygon.chart.off", tone: 1, points }],
    })
}

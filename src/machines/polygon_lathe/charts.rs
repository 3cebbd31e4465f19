//! The charts of the polygon lathe: speeds, phase and slide over time, the deviation of the sides over angle and tip radius.

use super::outlines::deviations;
use super::resolved::{PolygonLathe, TOOL, WORK};
use crate::controls::Address;
use crate::drives::polygon::{CutterSetup, Section};
use crate::machines::chart_rows::{ChartLine, ChartRow, unlimited};
use crate::math::PI;
use crate::view::{Chart, ChartAxis, ChartLimit, Series};

/// Charts over time, from top to bottom.
#[rustfmt::skip]
pub(super) const ROWS: &[ChartRow<PolygonLathe>] = &[
    ChartRow { id: "size", title: "polygon.chart.size", unit: "mm", least_span: 0.01, lines: &[
        ChartLine { label: |_| "polygon.chart.across", tone: 2, address: |_| None, value: |lathe, now| lathe.slide(now).0 },
    ], limits: unlimited },
    ChartRow { id: "speeds", title: "polygon.chart.speeds", unit: "r/min", least_span: 1.0, lines: &[
        ChartLine { label: |_| "polygon.chart.work", tone: 0, address: |_| None, value: |_, now| now.pmc[WORK].feed / 360.0 },
        ChartLine { label: |_| "polygon.chart.tool", tone: 1, address: |_| None, value: |_, now| now.pmc[TOOL].feed / 360.0 },
    ], limits: |lathe| vec![ChartLimit { label: "polygon.tool-limit", value: lathe.params.axes.tool.limit }] },
    ChartRow { id: "phase", title: "polygon.chart.phase", unit: "°", least_span: 0.01, lines: &[
        ChartLine { label: |_| "polygon.chart.ahead", tone: 3, address: |_| None, value: |lathe, now| lathe.phase(now) },
    ], limits: unlimited },
    ChartRow { id: "along", title: "polygon.chart.along", unit: "mm", least_span: 0.01, lines: &[
        ChartLine { label: |_| "polygon.chart.z", tone: 0, address: |_| Some(Address::Z), value: |lathe, now| lathe.slide(now).1 },
    ], limits: unlimited },
];

/// The deviation of the finished sections from their sides, over the angle: a line for each polygon.
pub(super) fn deviation(lathe: &PolygonLathe, points: usize) -> Option<Chart> {
    let names = ["polygon.chart.off", "polygon.chart.second-off", "polygon.chart.third-off"];
    let lines = (1..).zip(lathe.polygons()).zip(names);
    let series: Vec<Series> =
        lines.filter_map(|((tone, lathe), label)| deviation_of(lathe, points, (label, tone))).collect();
    (!series.is_empty()).then(|| over_angle(series))
}

/// Chart of one polygon's deviation alone.
pub(super) fn deviation_alone(lathe: &PolygonLathe, points: usize) -> Option<Chart> {
    deviation_of(lathe, points, ("polygon.chart.off", 1)).map(|line| over_angle(vec![line]))
}

fn over_angle(series: Vec<Series>) -> Chart {
    Chart {
        id: "deviation",
        title: "polygon.chart.deviation",
        unit: "µm",
        least_span: 0.0,
        x: ChartAxis::Angle,
        series,
        limits: Vec::new(),
    }
}

/// The deviation of one section (µm) over the angle from its first side (°).
fn deviation_of(lathe: &PolygonLathe, points: usize, (label, tone): (&'static str, u8)) -> Option<Series> {
    let section = lathe.params.section()?;
    let sides = lathe.params.ratio()?.sides(lathe.params.inserts as u32);
    // The points include every corner.
    let each = (points / (2 * sides as usize)).clamp(1, 3600) + 1;
    let all = deviations(&section, 0.5 * lathe.params.across_flats, sides, 2 * sides as usize * each);
    let begin = section.begin();
    let points = all.into_iter().map(|(angle, off)| ((angle - begin) * 180.0 / PI, 1000.0 * off)).collect();
    Some(Series { label, tone, address: None, points })
}

/// Number of tip circles on the chart.
const CIRCLES: usize = 60;

/// Least and greatest deviation of the sides over the radius of the tip circle, with the ratio and the inserts of the
/// form.
pub(super) fn over_radius(lathe: &PolygonLathe, points: usize) -> Option<Chart> {
    let (p, ratio) = (&lathe.params, lathe.params.ratio()?);
    let count = points.clamp(2, CIRCLES);
    let (from, to) = (0.25 * p.tip_radius, 2.0 * p.tip_radius);
    let radius = |at: usize| from + (to - from) * at as f64 / (count - 1) as f64;
    let side = |radius: f64| {
        let setup = CutterSetup::even(p.across_flats, radius, ratio, p.inserts as u32);
        let side = Section::new(&setup, 0.5 * p.blank())?.side(0)?;
        Some((radius, 1000.0 * side.low, 1000.0 * side.high))
    };
    let sides: Vec<(f64, f64, f64)> = (0..count).map(radius).filter_map(side).collect();
    let line = |label: &'static str, tone: u8, value: fn(&(f64, f64, f64)) -> f64| Series {
        label,
        tone,
        address: None,
        points: sides.iter().map(|side| (side.0, value(side))).collect(),
    };
    Some(Chart {
        id: "radius",
        title: "polygon.chart.radius",
        unit: "µm",
        least_span: 0.0,
        x: ChartAxis::TipRadius,
        series: vec![line("polygon.chart.lowest", 0, |side| side.1), line("polygon.chart.highest", 1, |side| side.2)],
        limits: Vec::new(),
    })
}

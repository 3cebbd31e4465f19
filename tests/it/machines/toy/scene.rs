//! Drawing and charts of the cut-to-length feeder.

use macroline::machines::chart_rows::{ChartLine, ChartRow, unlimited};
use macroline::motion::Snapshot;
use macroline::view::{Drawing, DrawnPart, Look, Paint, Placement, Pose, Scene};

use super::resolved::CutToLength;

/// Group of the strip.
const STRIP: u16 = 1;

/// Drawing units per millimetre.
const SCALE: f64 = 0.5;

/// The drawing at rest.
pub(super) fn scene() -> Scene {
    let mut drawing = Drawing::new(0.5);
    drawing.within(STRIP, |drawing| {
        drawing.path("M-400 60h400v8h-400z", Look::fill(Paint::SteelBar).thin(Paint::Edge, 1.0));
    });
    drawing.rect([0.0, 20.0, 6.0, 36.0, 0.0], Look::fill(Paint::DarkFront));
    drawing.scene([-100.0, 0.0, 400.0, 120.0], "toy.scene.alt")
}

/// The parts list: the knife, and the strip.
pub(super) fn parts() -> Vec<DrawnPart> {
    let part = |name, group, at| DrawnPart { name, quantity: 1, data: vec![("", "length")], group, at };
    vec![part("toy.part.knife", 0, (3.0, 30.0)), part("toy.part.strip", STRIP, (-40.0, 64.0))]
}

/// The drawing at a moment: the strip since its last cut.
pub(super) fn pose(feeder: &CutToLength, now: &Snapshot) -> Pose {
    let dx = position(feeder, now) % feeder.params.length * SCALE;
    let placements = vec![Placement { dx, ..Placement::of(STRIP) }];
    Pose { placements, ..Pose::default() }
}

fn position(feeder: &CutToLength, now: &Snapshot) -> f64 {
    now.axes.get(feeder.axis()).map_or(0.0, |axis| axis.actual)
}

/// Charts over time, from top to bottom.
pub(super) const CHARTS: &[ChartRow<CutToLength>] = &[
    ChartRow {
        id: "position",
        title: "toy.chart.position",
        unit: "mm",
        least_span: 0.01,
        lines: &[ChartLine { label: |_| "toy.chart.strip", tone: 0, address: |_| None, value: position }],
        limits: unlimited,
    },
    ChartRow {
        id: "feed",
        title: "toy.chart.feed",
        unit: "mm/min",
        least_span: 1.0,
        lines: &[ChartLine {
            label: |_| "toy.chart.strip",
            tone: 1,
            address: |_| None,
            value: |feeder, now| now.axes.get(feeder.axis()).map_or(0.0, |axis| axis.feed),
        }],
        limits: unlimited,
    },
];

//! The explorer of the polygon lathe: inserts, ratio and tip radius are dragged, the section and its deviation follow.

use super::geometry::own_shape;
use super::outlines::{closed, ideal};
use super::resolved::PolygonLathe;
use super::scene::traces;
use super::{charts, further, results};
use crate::machines::sheets::say;
use crate::view::drawing::{Drawing, polyline};
use crate::view::letters::Anchor;
use crate::view::look::{Look, Paint};
use crate::view::scene::Font;
use crate::view::{Explorer, FieldEntry, Scene, Slider};

/// Width and height of the drawing, and the radius of the stock in it.
const ROOM: (f64, f64, f64) = (360.0, 240.0, 94.0);

/// Drawing units per pixel.
const UNIT: f64 = 0.9;

/// Steps along an arc of the section, too small to be visible at this size.
const STEPS: u32 = 16;

/// Points of the deviation.
const POINTS: usize = 360;

/// Greatest number of drawn paths; more would merge into a grey area.
const PATHS: usize = 60;

/// Sliders and section of a polygon, from 0.
pub(super) fn explorer(lathe: &PolygonLathe, polygon: usize) -> Explorer {
    Explorer {
        sliders: sliders(lathe, polygon),
        scene: scene(lathe),
        charts: charts::deviation_alone(lathe, POINTS).into_iter().collect(),
        results: polygon.checked_sub(1).map(results::ids).unwrap_or_default(),
    }
}

fn sliders(lathe: &PolygonLathe, polygon: usize) -> Vec<Slider> {
    let field = |first: &'static str| match polygon.checked_sub(1) {
        Some(other) => further::field(first, other).unwrap_or(first),
        None => first,
    };
    let p = &lathe.params;
    let own = own_shape(p.sides, p.inserts, (p.tool_ratio, p.work_ratio));
    let along: Vec<_> = own.into_iter().map(|entry| FieldEntry { field: field(entry.field), ..entry }).collect();
    let count = |first: &'static str, range: (f64, f64), value: f64| Slider {
        field: field(first),
        range,
        step: 1.0,
        value,
        along: along.clone(),
    };
    let least = if p.against { -p.most_tool_turns } else { 1.0 };
    // Cutters of other sizes can be tried.
    let radius = ((0.25 * p.least_radius).ceil(), (2.0 * p.greatest_radius).ceil());
    vec![
        count("sides", (1.0, 12.0), p.sides),
        count("inserts", (1.0, p.most_inserts), p.inserts),
        count("work-ratio", (1.0, p.most_work_turns), p.work_ratio),
        count("tool-ratio", (least, p.most_tool_turns), p.tool_ratio),
        Slider { field: field("tip-radius"), range: radius, step: 0.5, value: p.tip_radius, along: Vec::new() },
    ]
}

/// The finished section, the stock, the polygon that is wanted, and the paths of the inserts as the work sees them.
fn scene(lathe: &PolygonLathe) -> Scene {
    let p = &lathe.params;
    let mut d = Drawing::new(UNIT);
    let (width, height, r) = ROOM;
    let at = (0.5 * width, 0.5 * height);
    let scale = 2.0 * r / p.stock_diameter;
    if let Some(section) = lathe.params.section() {
        d.path(closed(section.points(STEPS), at, scale), Look::fill(Paint::Steel).thin(Paint::Edge, 1.2));
        // A little further than the stock.
        for trace in traces(lathe, 1.3).into_iter().take(PATHS) {
            let points: Vec<(f64, f64)> = trace.iter().map(|(x, y)| (at.0 + x * scale, at.1 - y * scale)).collect();
            d.path(polyline(&points), Look::hair(Paint::Accent, 0.7));
        }
        if p.sides > 2.0 {
            let wanted = ideal(p.sides as u32, 0.5 * p.across_flats, section.begin());
            d.path(closed(wanted, at, scale), Look::hair(Paint::Good, 1.4).dashed(4.0, 4.0));
        }
    }
    d.circle((at.0, at.1, r), Look::LEAD.dashed(4.0, 4.0));
    d.text((at.0, height + 12.0), Anchor::Middle, &say("polygon.explore.legend"), Font::Label, Paint::Dim);
    d.scene([0.0, 0.0, width, height + 18.0], "polygon.explore.alt")
}

//! The explorer of the polygon lathe: inserts, ratio and tip radius are dragged, the section and its deviation follow.

use super::charts;
use super::resolved::PolygonLathe;
use super::scene::{closed, ideal};
use crate::machines::sheets::say;
use crate::math;
use crate::text::catalog::number_text as show;
use crate::view::pen::Pen;
use crate::view::{Explorer, Knob, Scene};

/// Width and height of the drawing, and the radius that the stock takes in it.
const ROOM: (f64, f64, f64) = (360.0, 240.0, 94.0);

/// Steps along an arc of the section and along a path: no step is seen at this size.
const STEPS: u32 = 16;

/// Points of the deviation.
const POINTS: usize = 360;

/// Greatest number of paths; more merge into one grey.
const PATHS: usize = 60;

/// Sliders and section.
pub(super) fn explorer(lathe: &PolygonLathe) -> Explorer {
    Explorer {
        knobs: knobs(lathe),
        scene: scene(lathe),
        charts: charts::deviation(lathe, POINTS).into_iter().collect(),
    }
}

/// Fields and values of a cutter and a ratio, with the shape set to the form's own.
pub(super) fn own(sides: f64, inserts: f64, (tool, work): (f64, f64)) -> Vec<(&'static str, String)> {
    let number = |id: &'static str, value: f64| (id, show(value, 0));
    let shape = ("shape", "own".to_owned());
    vec![
        shape,
        number("sides", sides),
        number("inserts", inserts),
        number("work-ratio", work),
        number("tool-ratio", tool),
    ]
}

fn knobs(lathe: &PolygonLathe) -> Vec<Knob> {
    let p = &lathe.p;
    let along = own(p.sides, p.inserts, (p.tool_ratio, p.work_ratio));
    let count = |field: &'static str, range: (f64, f64), value: f64| Knob {
        field,
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
        Knob { field: "tip-radius", range: radius, step: 0.5, value: p.tip_radius, along: Vec::new() },
    ]
}

/// The finished section, the stock, the polygon that is wanted, and the paths of the inserts as the work sees them.
fn scene(lathe: &PolygonLathe) -> Scene {
    let p = &lathe.p;
    let mut pen = Pen::default();
    let (width, height, r) = ROOM;
    let at = (0.5 * width, 0.5 * height);
    let scale = 2.0 * r / p.stock_diameter;
    if let Some((section, setup)) = lathe.p.section().zip(lathe.p.setup(p.across_flats)) {
        pen.path(0, closed(section.points(STEPS), at, scale), "steel", "ink", 1.2, "part");
        // A little further than the stock.
        let beyond = 1.3 * section.stock();
        for pass in setup.passes().take(PATHS) {
            let Some(curve) = setup.curve(pass.insert) else { continue };
            let edge = curve.sigma_at(beyond);
            let points = (0..=2 * STEPS).map(|i| {
                let sigma = edge * (f64::from(i) / f64::from(STEPS) - 1.0);
                let (s, c) = math::sin_cos(pass.normal + curve.turn(sigma));
                (curve.reach(sigma) * c, curve.reach(sigma) * s)
            });
            let line = closed(points, at, scale);
            pen.path(0, line.trim_end_matches('Z').to_owned(), "", "accent", 0.5, "");
        }
        if p.sides > 2.0 {
            pen.path(
                0,
                closed(ideal(p.sides as u32, 0.5 * p.across_flats, section.begin()), at, scale),
                "",
                "ok",
                1.2,
                "dash",
            );
        }
    }
    pen.ring(0, (at.0, at.1, r), "dim", 0.8, "dash");
    pen.text(at.0, height + 12.0, "middle", say("polygon.explore.legend"), "dim", "label");
    Scene {
        view: [0.0, 0.0, width, height + 18.0],
        nodes: pen.nodes,
        groups: Pen::groups(0),
        unit: 0.0,
        gradients: Vec::new(),
        alt: "polygon.explore.alt",
        option: None,
    }
}

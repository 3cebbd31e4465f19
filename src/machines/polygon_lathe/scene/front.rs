//! The machine from the front: floor, headstock, chuck and work, and the directions in which all turn.

use super::ids::{group, node};
use super::layout::{AXIS, FLOOR, Layout, MAIN_MOTOR};
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::machines::sheets::say;
use crate::math::{self, PI};
use crate::text::number::{fill, filled};
use crate::view::drawing::{Drawing, barrel, polar, polygon, polyline, spoke};
use crate::view::letters::Anchor;
use crate::view::look::{Look, Paint};
use crate::view::scene::{Font, SceneGroup};

/// Direction of depth in the drawing: to the right and up.
pub(super) const AWAY: (f64, f64) = (22.0, -13.0);
/// Traces of inserts over the work at most, points of each, and how far they are drawn over the stock.
const TRACES: usize = 24;
const POINTS: u32 = 24;
const BEYOND: f64 = 1.6;

/// Floor, main motor and headstock.
pub(super) fn draw_back(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    drawing.rect([-3000.0, 512.0, 7000.0, 900.0, 0.0], Look::fill(Paint::Floor));
    drawing.ellipse((290.0, FLOOR), (340.0, 20.0), Look::fill(Paint::GroundShade));
    if lathe.has_main_spindle() {
        drawing.showing("main-power", |drawing| draw_main_motor(drawing, layout));
    }
    let [left, right, top] = layout.headstock();
    drawing.path(
        filled("M# #l# #H#l# #Z", &[left + 6.0, top, AWAY.0, AWAY.1, right + AWAY.0, -AWAY.0, -AWAY.1]),
        Look::fill(Paint::DarkLight),
    );
    drawing.path(
        filled("M# #l# #V#l# #Z", &[right, top, AWAY.0, AWAY.1, FLOOR + AWAY.1, -AWAY.0, -AWAY.1]),
        Look::fill(Paint::DarkShade),
    );
    drawing.path(
        filled("M# #V#q0 -8 8 -8H#V#Z", &[left, FLOOR, top + 8.0, right, FLOOR]),
        Look::fill(Paint::DarkFront).thin(Paint::Edge, 1.0),
    );
    drawing
        .path(filled("M# #V#q0 -7 7 -7H#", &[left + 1.5, FLOOR - 14.0, top + 9.0, right - 8.0]), Look::RIM.faint(0.6));
    // Door with a handle and the name plate.
    let low = AXIS + layout.chuck + 10.0;
    drawing.rect(
        [left + 10.0, low, right - left - 20.0, FLOOR - 8.0 - low, 4.0],
        Look::fill(Paint::Clear).thin(Paint::DarkShade, 1.2),
    );
    drawing.rect([left + 20.0, FLOOR - 44.0, 8.0, 26.0, 4.0], Look::fill(Paint::SteelBar).thin(Paint::Edge, 0.8));
    drawing.rect([left + 36.0, FLOOR - 42.0, 96.0, 22.0, 2.0], Look::fill(Paint::Steel).thin(Paint::Edge, 0.8));
    drawing.text((left + 84.0, FLOOR - 27.0), Anchor::Middle, &say("polygon.name"), Font::Engraved(11.0), Paint::Black);
}

/// The motor of the main spindle on top of the headstock, with its fan's guard; its belt is inside.
fn draw_main_motor(drawing: &mut Drawing, layout: &Layout) {
    let (at, r) = (layout.main_motor(), MAIN_MOTOR);
    drawing.path(barrel(at, r, AWAY), Look::fill(Paint::DarkShade));
    drawing.circle((at.0, at.1, r), Look::DARK_FACE);
    for share in [0.72, 0.54, 0.36] {
        drawing.circle((at.0, at.1, share * r), Look::HAIR.faint(0.5));
    }
    for turn in 0..12 {
        drawing.path(spoke(at, 30.0 * f64::from(turn), 0.2 * r, 0.84 * r), Look::HAIR.faint(0.5));
    }
    drawing.circle((at.0, at.1, 0.16 * r), Look::HOLE);
    let (from, to) = (polar(at, 200.0, 0.96 * r), polar(at, 268.0, 0.96 * r));
    drawing.path(filled("M# #A# # 0 0 1 # #", &[from.0, from.1, 0.96 * r, 0.96 * r, to.0, to.1]), Look::RIM.faint(0.6));
}

/// The chuck with its jaws, which turn with the work.
pub(super) fn draw_chuck(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    let r = layout.chuck;
    let grip = 0.5 * lathe.params.stock_diameter * layout.scale;
    drawing.place(group::WORK, SceneGroup { at: layout.work, ..SceneGroup::default() });
    for (group, parent) in [(group::JAWS, group::WORK), (group::JAWS_BLUR, group::WORK)] {
        drawing.place(group, SceneGroup { parent, ..SceneGroup::default() });
    }
    drawing.path(barrel(layout.work, r, AWAY), Look::fill(Paint::DarkShade));
    drawing.circle((layout.work.0, layout.work.1, r), Look::DARK_FACE);
    drawing.circle((layout.work.0, layout.work.1, 0.96 * r), Look::HAIR.faint(0.5));
    let (from, to) = (polar(layout.work, 200.0, 0.98 * r), polar(layout.work, 268.0, 0.98 * r));
    drawing.path(filled("M# #A# # 0 0 1 # #", &[from.0, from.1, 0.98 * r, 0.98 * r, to.0, to.1]), Look::RIM.faint(0.6));
    let half = 0.15 * r;
    let thin = half.min(0.8 * grip).max(1.0);
    let neck = -(grip + 0.35 * (0.93 * r - grip));
    for (at, turn) in [0.0, 120.0, 240.0].into_iter().enumerate() {
        let place = |points: &[(f64, f64)]| {
            let (s, c) = math::sin_cos(turn / 180.0 * PI);
            points.iter().map(|(x, y)| (x * c - y * s, x * s + y * c)).collect::<Vec<_>>()
        };
        drawing.within(group::JAWS, |drawing| {
            let slot = [(-0.6 * half, -0.96 * r), (0.6 * half, -0.96 * r), (0.6 * half, -grip), (-0.6 * half, -grip)];
            drawing.path(polygon(&place(&slot)), Look::fill(Paint::DarkShade));
            let jaw =
                [(-half, -0.92 * r), (half, -0.92 * r), (half, neck), (thin, -grip), (-thin, -grip), (-half, neck)];
            drawing.path(polygon(&place(&jaw)), Look::fill(Paint::SteelFace).thin(Paint::Edge, 0.8));
            let steps = [(-half, 0.5 * (neck - 0.92 * r)), (half, 0.5 * (neck - 0.92 * r))];
            drawing.path(polyline(&place(&steps)), Look::HAIR.faint(0.6));
            // One jaw has a mark, so that a turn is seen.
            if at == 0 {
                drawing.circle((0.0, -0.84 * r, 0.03 * r), Look::HOLE);
            }
        });
    }
    drawing.within_hidden(group::JAWS_BLUR, |drawing| {
        let ring = 0.5 * (0.92 * r + grip);
        drawing.circle((0.0, 0.0, ring), Look::line(Paint::Steel, 0.92 * r - grip));
    });
}

/// The work: its section at the cutting plane, the traces of the inserts, the ideal polygon.
pub(super) fn draw_work(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    let p = &lathe.params;
    let stock = 0.5 * p.stock_diameter * layout.scale;
    drawing.showing("stock-diameter", |drawing| {
        drawing.path(barrel(layout.work, stock, (8.0, -4.8)), Look::fill(Paint::SteelShade));
    });
    drawing.within(group::WORK, |drawing| {
        drawing.showing("across-flats", |drawing| {
            drawing.path(String::new(), Look::fill(Paint::SteelFace).thin(Paint::Edge, 1.2)).id = Some(node::SECTION);
        });
        let least = lathe.polygons().map(|lathe| lathe.params.across_flats).fold(p.stock_diameter, f64::min);
        drawing.path(hatch(0.44 * least * layout.scale), Look::HAIR.faint(0.3));
        for (at, polygon) in lathe.polygons().enumerate() {
            let own = group::of(group::TRACES, at);
            drawing.place(own, SceneGroup { parent: group::WORK, hidden: at > 0, ..SceneGroup::default() });
            for trace in traces(polygon, BEYOND).into_iter().take(TRACES) {
                let points: Vec<(f64, f64)> =
                    trace.iter().map(|(x, y)| (x * layout.scale, -y * layout.scale)).collect();
                drawing.within(own, |drawing| {
                    drawing.path(polyline(&points), Look::POINTER.edge(Paint::Accent, 1.0).faint(0.75));
                });
            }
        }
        drawing.circle((0.0, 0.0, stock), Look::LEAD.dashed(4.0, 3.0));
    });
    let (x, y) = layout.work;
    let cross = stock + 10.0;
    drawing.path(
        filled("M# #h#M# #v#", &[x - cross, y, 2.0 * cross, x, y - cross, 2.0 * cross]),
        Look::LEAD.dashed(10.0, 3.0).faint(0.7),
    );
}

/// The curves of all inserts over the work, as far as `beyond` times the radius of the stock, mm.
pub(in super::super) fn traces(lathe: &PolygonLathe, beyond: f64) -> Vec<Vec<(f64, f64)>> {
    let Some((section, setup)) = lathe.params.section().zip(lathe.params.setup(lathe.params.across_flats)) else {
        return Vec::new();
    };
    let beyond = beyond * section.stock();
    let curves = setup.passes().filter_map(|pass| Some((pass.normal, setup.curve(pass.insert)?)));
    let trace = |(normal, curve): (f64, crate::drives::polygon::Curve)| {
        let edge = curve.sigma_at(beyond);
        let point = |i: u32| {
            let sigma = edge * (f64::from(i) / f64::from(POINTS) - 1.0);
            let (s, c) = math::sin_cos(normal + curve.turn(sigma));
            (curve.reach(sigma) * c, curve.reach(sigma) * s)
        };
        (0..=2 * POINTS).map(point).collect()
    };
    curves.map(trace).collect()
}

/// Sine of 45 degrees.
const DIAGONAL: f64 = core::f64::consts::FRAC_1_SQRT_2;

/// Hatching of a section within a radius.
fn hatch(radius: f64) -> String {
    let mut path = String::new();
    if radius < 4.0 {
        return path;
    }
    let step = (radius / 5.0).max(6.0);
    let count = (radius / step).floor() as i32;
    for line in -count..=count {
        let off = f64::from(line) * step;
        let half = (radius * radius - off * off).max(0.0).sqrt();
        let (low, high) = (DIAGONAL * (off - half), DIAGONAL * (off + half));
        fill(&mut path, "M# #L# #", &[low, -high, high, -low]);
    }
    path
}

/// Arrows in the directions of rotation: over the work, and on the cutter.
pub(super) fn draw_arrows(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    let p = &lathe.params;
    let arrow = |(x, y): (f64, f64), r: f64, speed: f64| {
        // Positive turns are counter-clockwise.
        let (from, to) = if speed > 0.0 { (-66.0, -114.0) } else { (-114.0, -66.0) };
        let (a, b) = (polar((x, y), from, r), polar((x, y), to, r));
        let back = if speed > 0.0 { 1.0 } else { -1.0 };
        let sweep = if speed > 0.0 { 0.0 } else { 1.0 };
        let barb = |off: (f64, f64)| (b.0 + off.0 - x, b.1 + off.1 - y);
        let (one, other) = (barb(polar((x, y), to + back * 65.0, 10.0)), barb(polar((x, y), to + back * 125.0, 10.0)));
        filled(
            "M# #A# # 0 0 # # #M# #L# #L# #",
            &[a.0, a.1, r, r, sweep, b.0, b.1, one.0, one.1, b.0, b.1, other.0, other.1],
        )
    };
    let work = 0.5 * p.stock_diameter * layout.scale + 20.0;
    if p.work_speed() != 0.0 {
        drawing.path(arrow(layout.work, work, p.work_speed()), Look::POINTER.edge(Paint::Accent, 2.0));
    }
    for (at, PolygonLathe { params: p, .. }) in lathe.polygons().enumerate() {
        let cutter = 0.84 * p.tip_radius * layout.scale;
        if p.tool_speed() != 0.0 && cutter > 24.0 {
            drawing.within(group::of(group::DISC, at), |drawing| {
                drawing.path(arrow((0.0, 0.0), cutter, p.tool_speed()), Look::POINTER.edge(Paint::Accent, 2.0));
            });
        }
    }
}

//! The cutter disc with its holders and inserts, on column and slide, and the distance of the axes.

use super::front::AWAY;
use super::ids::group;
use super::layout::{AXIS, FLOOR, Layout, RIGHT};
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::math::{self, PI};
use crate::text::number::{fill, filled};
use crate::view::drawing::{Drawing, barrel, circle, polar};
use crate::view::look::{Look, Paint};
use crate::view::scene::{SceneGroup, Shape};

/// Radius of the disc over that of the tip circle, at most.
const DISC: f64 = 0.69;
/// Least radius of the holders over that of the tip circle.
const HOLDER: f64 = 0.2;

/// Radii of the disc and of the outer ends of its holders over that of the tip circle.
fn body(lathe: &PolygonLathe) -> (f64, f64) {
    let outer = (1.0 - lathe.params.overhang / lathe.params.tip_radius).max(HOLDER);
    (DISC.min(0.9 * outer), outer)
}

/// The ways of the slide on their base.
pub(super) fn draw_base(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    let reach = column(lathe, layout);
    let end = layout.cutter.0 + (0.5 * (lathe.params.start_x - lathe.params.across_flats)).max(0.0) * layout.scale;
    let (from, to) = (layout.cutter.0 - reach - 34.0, (end + reach + 26.0).min(RIGHT - 16.0));
    let to = to.max(from + 60.0);
    let top = FLOOR - 38.0;
    drawing.path(
        filled("M# #l# #H#l# #Z", &[from, top, AWAY.0, AWAY.1, to + AWAY.0, -AWAY.0, -AWAY.1]),
        Look::fill(Paint::SteelLight),
    );
    drawing.path(
        filled("M# #l# #V#L# #Z", &[to, top, AWAY.0, AWAY.1, FLOOR + AWAY.1, to, FLOOR]),
        Look::fill(Paint::SteelShade),
    );
    drawing.rect([from, top, to - from, FLOOR - top, 0.0], Look::fill(Paint::CabinetFront).thin(Paint::Edge, 0.8));
    drawing.path(filled("M# #H#", &[from, top + 19.0, to]), Look::HAIR.faint(0.4));
}

/// Half the width of the column of the cutter.
pub(super) fn column(lathe: &PolygonLathe, layout: &Layout) -> f64 {
    math::clamp(0.34 * lathe.params.tip_radius * layout.scale, 12.0, 54.0)
}

/// The cutters of all polygons: poses show that of the present one.
pub(super) fn draw(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    let window = Shape::Rect { x: -3000.0, y: 0.0, w: 3000.0 + RIGHT + 10.0, h: 630.0, r: 0.0 };
    drawing.place(group::WINDOW, SceneGroup { clip: Some(window), ..SceneGroup::default() });
    for (at, polygon) in lathe.polygons().enumerate() {
        draw_cutter(drawing, at, polygon, &layout.of(polygon));
    }
}

/// The cutter disc of a polygon, with column, holders and inserts.
fn draw_cutter(drawing: &mut Drawing, at: usize, lathe: &PolygonLathe, layout: &Layout) {
    let p = &lathe.params;
    let (r, reach) = (p.tip_radius * layout.scale, column(lathe, layout));
    let disc = body(lathe).0 * r;
    let [disc_group, inserts, blur] = [group::DISC, group::INSERTS, group::BLUR].map(|own| group::of(own, at));
    let hidden = at > 0;
    drawing.place(disc_group, SceneGroup { parent: group::WINDOW, at: layout.cutter, hidden, ..SceneGroup::default() });
    for group in [inserts, blur] {
        drawing.place(group, SceneGroup { parent: disc_group, ..SceneGroup::default() });
    }
    drawing.within(disc_group, |drawing| {
        draw_column(drawing, reach);
        drawing.showing("tip-radius", |drawing| {
            drawing.circle((0.0, 0.0, r), Look::LEAD.dashed(5.0, 4.0));
        });
        drawing.path(barrel((0.0, 0.0), disc, (0.10 * r, -0.06 * r)), Look::fill(Paint::Dark));
    });
    drawing.within(inserts, |drawing| holders(drawing, lathe, layout));
    drawing.within(disc_group, |drawing| {
        drawing.circle((0.0, 0.0, disc), Look::FACE);
        drawing.circle((0.0, 0.0, 0.93 * disc), Look::HAIR.faint(0.35));
    });
    drawing.within_hidden(blur, |drawing| {
        drawing.circle((0.0, 0.0, 0.5 * (disc + r)), Look::line(Paint::SteelShade, r - disc));
        drawing.circle((0.0, 0.0, 0.985 * r), Look::line(Paint::Accent, 0.03 * r).faint(0.6));
    });
    drawing.within(inserts, |drawing| face(drawing, lathe, disc));
    drawing.within(disc_group, |drawing| {
        drawing.circle((0.0, 0.0, 0.36 * disc), Look::DARK_FACE);
        drawing.circle((0.0, 0.0, 0.16 * disc), Look::FACE);
    });
    drawing.within(inserts, |drawing| {
        for at in 0..4 {
            let (x, y) = polar((0.0, 0.0), 90.0 * f64::from(at), 0.29 * disc);
            drawing.circle((x, y, 0.035 * disc), Look::HOLE);
        }
        let key = 0.05 * disc;
        drawing.rect([-key, -0.18 * disc, 2.0 * key, 0.08 * disc, 0.0], Look::fill(Paint::DarkShade));
    });
    drawing.within(disc_group, |drawing| {
        let (from, to) = (polar((0.0, 0.0), 205.0, 0.975 * disc), polar((0.0, 0.0), 265.0, 0.975 * disc));
        drawing
            .path(filled("M# #A# # 0 0 1 # #", &[from.0, from.1, 0.975 * disc, 0.975 * disc, to.0, to.1]), Look::RIM);
        let cross = 1.1 * r;
        drawing.path(
            filled("M# 0h#M0 #v#", &[-cross, 2.0 * cross, -cross, 2.0 * cross]),
            Look::LEAD.dashed(14.0, 5.0).faint(0.6),
        );
    });
}

/// Carriage and column of the slide, which carry cutter or turning tool; the origin is the height of the axes.
pub(super) fn draw_column(drawing: &mut Drawing, reach: f64) {
    let low = FLOOR - 38.0 - AXIS;
    drawing.path(
        filled("M# #l# #H#l# #Z", &[-reach - 24.0, low - 20.0, 14.0, -8.0, reach + 38.0, -14.0, 8.0]),
        Look::fill(Paint::DarkLight),
    );
    drawing.path(filled("M# #l14 -8v20l-14 8Z", &[reach + 24.0, low - 20.0]), Look::fill(Paint::DarkShade));
    drawing.rect(
        [-reach - 24.0, low - 20.0, 2.0 * reach + 48.0, 20.0, 0.0],
        Look::fill(Paint::DarkFront).thin(Paint::Edge, 0.8),
    );
    drawing.path(filled("M# 0l12 -7V#l-12 7Z", &[reach, low - 27.0]), Look::fill(Paint::DarkShade));
    drawing.path(
        filled("M# #V0A# # 0 0 1 # 0V#Z", &[-reach, low - 20.0, reach, reach, reach, low - 20.0]),
        Look::fill(Paint::DarkFront).thin(Paint::Edge, 0.8),
    );
    drawing.path(filled("M# #V20", &[-reach + 3.0, low - 26.0]), Look::RIM.faint(0.4));
}

/// Places of the inserts on the disc in degrees, clockwise from the right as the drawing turns, and their tip radius in units.
fn tips(lathe: &PolygonLathe, layout: &Layout) -> Vec<(f64, f64)> {
    let setup = lathe.params.setup(lathe.params.across_flats);
    let tips = setup.map(|setup| setup.tips).unwrap_or_default();
    // At 0 an insert points at the work, to the left.
    tips.iter().map(|tip| (180.0 - tip.angle * 180.0 / PI, tip.radius * layout.scale)).collect()
}

/// Half the width of a holder over the radius of the tip circle: it fits between its neighbours.
fn width(lathe: &PolygonLathe, count: usize) -> f64 {
    (0.75 * PI * body(lathe).0 / count.max(1) as f64).min(0.115)
}

/// Holders with their inserts.
fn holders(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    let r = lathe.params.tip_radius * layout.scale;
    let tips = tips(lathe, layout);
    let half = r * width(lathe, tips.len());
    // Inserts face in the direction of a cutter that turns in the sense of the work, or against it. Positive turns are counter-clockwise.
    let hand = if lathe.derived.inserts.faces_forward == (lathe.params.work_speed() > 0.0) { 1.0 } else { -1.0 };
    let (disc, outer) = (body(lathe).0 * r, body(lathe).1 * r);
    let inner = 0.87 * disc;
    // The insert reaches into its holder.
    let long = (0.15 * r).max(1.2 * (r - outer));
    let (mut holders, mut rims, mut inserts, mut screws): (String, String, String, String) = Default::default();
    for (degrees, tip) in tips {
        let (s, c) = math::sin_cos(degrees * PI / 180.0);
        let place = |out: &mut String, points: &[(f64, f64)]| {
            for (at, (x, y)) in points.iter().enumerate() {
                let at = if at == 0 { "M# #" } else { "L# #" };
                fill(out, at, &[x * c - y * hand * s, x * s + y * hand * c]);
            }
        };
        let (tail, seat) = ((outer - 0.06 * r).max(inner), tip - 0.57 * long);
        let holder = [
            (inner, -half),
            (tail, -half),
            (outer, -0.5 * half),
            (outer, 0.35 * half),
            (tail, 0.75 * half),
            (inner, 0.75 * half),
        ];
        place(&mut holders, &holder);
        holders.push('Z');
        place(&mut rims, &[(inner, -0.8 * half), (tail, -0.8 * half)]);
        place(
            &mut inserts,
            &[(tip, 0.0), (tip - 0.47 * long, 0.62 * half), (tip - long, 0.1 * half), (tip - 0.67 * long, -0.5 * half)],
        );
        inserts.push('Z');
        screws += &circle(seat * c, seat * s, (0.014 * r).min(0.2 * half));
    }
    drawing.path(holders, Look::fill(Paint::DarkFace).thin(Paint::Edge, 0.8));
    drawing.path(rims, Look::RIM.faint(0.5));
    drawing.path(inserts, Look::fill(Paint::Accent).thin(Paint::Edge, 0.8));
    drawing.path(screws, Look::fill(Paint::Black));
}

/// Marks of the turn on the face of the disc: clamps of the holders and holes.
fn face(drawing: &mut Drawing, lathe: &PolygonLathe, disc: f64) {
    let count = lathe.params.inserts.max(1.0);
    let half = disc * width(lathe, count as usize) / body(lathe).0;
    let tips = (0..count as u32).map(|at| 180.0 - 360.0 * f64::from(at) / count);
    let (mut clamps, mut holes) = (String::new(), String::new());
    for degrees in tips {
        let (s, c) = math::sin_cos(degrees * PI / 180.0);
        let place = |x: f64, y: f64| (x * c - y * s, x * s + y * c);
        let (a, b, e, f) = (
            place(0.985 * disc, -half),
            place(0.66 * disc, -half),
            place(0.66 * disc, half),
            place(0.985 * disc, half),
        );
        fill(&mut clamps, "M# #L# #L# #L# #", &[a.0, a.1, b.0, b.1, e.0, e.1, f.0, f.1]);
        if count < 25.0 {
            for y in [-0.5 * half, 0.5 * half] {
                let (x, y) = place(0.8 * disc, y);
                holes += &circle(x, y, (0.07 * disc).min(0.36 * half));
            }
        }
        if count < 9.0 {
            let (x, y) = polar((0.0, 0.0), degrees + 180.0 / count, 0.62 * disc);
            holes += &circle(x, y, 0.1 * disc);
        }
    }
    drawing.path(clamps, Look::HAIR.faint(0.7));
    drawing.path(holes, Look::HOLE);
}

/// Line of the distance between the axes, with the cutter `away` units from its last place.
pub(in super::super) fn distance(lathe: &PolygonLathe, layout: &Layout, away: f64) -> String {
    let (left, right, y) = (layout.work.0, layout.cutter.0 + away, DISTANCE);
    let disc = body(lathe).0 * lathe.params.tip_radius * layout.scale;
    let work = 0.5 * lathe.params.stock_diameter * layout.scale;
    if right > RIGHT {
        return filled("M# #V#M# #H#", &[left, AXIS + work + 12.0, y + 6.0, left, y, RIGHT]);
    }
    let mut path = filled(
        "M# #V#M# #V#M# #H#",
        &[left, AXIS + work + 12.0, y + 6.0, right, AXIS + disc + 4.0, y + 6.0, left, y, right],
    );
    if right - left > 24.0 {
        fill(&mut path, "M# #l-8 4l8 4M# #l8 4l-8 4", &[left + 8.0, y - 4.0, right - 8.0, y - 4.0]);
    }
    path
}

/// Offset, in units, of the figure of the distance from its place at rest: it stays in the middle between the axes, and
/// within the drawing.
pub(in super::super) fn figure_at(layout: &Layout, away: f64) -> f64 {
    let middle = 0.5 * (layout.work.0 + layout.cutter.0);
    math::clamp(middle + 0.5 * away, FIGURE, RIGHT - FIGURE) - middle
}

/// Half the width of the figure.
pub(super) const FIGURE: f64 = 58.0;
/// Height of the line of the distance.
pub(super) const DISTANCE: f64 = 506.0;

//! The lens: every side of the finished section against its plane, with the deviation magnified; and the section as the work sees it.

use super::ids::{TIPS, group, node};
use super::layout::{CLOSE, GLASS, Layout};
use crate::drives::polygon::SAME_LENGTH;
use crate::machines::polygon_lathe::outlines::{closed, ideal};
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::machines::sheets::say;
use crate::math::{self, PI};
use crate::text::catalog::number_text as show;
use crate::text::number::{fill, filled};
use crate::text::units;
use crate::view::drawing::{Drawing, polyline};
use crate::view::letters::Anchor;
use crate::view::look::{Look, Paint};
use crate::view::scene::{Font, SceneGroup, Shape};

/// Centre and radius of the lens.
const LENS: (f64, f64, f64) = (726.0, 118.0, 96.0);
/// Height of the plane in it, half the length of a side, and the greatest height of a deviation.
const PLANE: f64 = 8.0;
const HALF: f64 = 76.0;
const HIGH: f64 = 30.0;
/// Sides that are shown at most, and points of each.
const SIDES: u32 = 24;
const POINTS: u32 = 48;
/// Halvings of the distance between two points, by which the begin of the stock is found.
const STOCK_HALVINGS: u32 = 30;
/// Height of the leader over the cutter.
const OVER: f64 = 46.0;

/// The lens with all sides over one plane.
pub(super) fn draw(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    let (x, y, r) = LENS;
    let edge = x - (r * r - (y - OVER) * (y - OVER)).max(0.0).sqrt();
    for (at, polygon) in lathe.polygons().enumerate() {
        let ring = group::of(group::RING, at);
        drawing.place(ring, SceneGroup { hidden: at > 0, ..SceneGroup::default() });
        drawing.within(ring, |drawing| {
            // The leader goes up from the contact and over the cutter, without crossing it.
            let (cut, level) = layout.contact(polygon);
            drawing.circle((cut, level, 10.0), Look::POINTER);
            drawing.path(filled("M# #V#H#", &[cut, level - 10.0, OVER, edge]), Look::POINTER.edge(Paint::Accent, 1.0));
        });
        let clip = Some(Shape::Circle { x: 0.0, y: 0.0, r });
        let own = group::of(group::LENS, at);
        drawing.place(own, SceneGroup { at: (x, y), clip, hidden: at > 0, ..SceneGroup::default() });
        drawing.within(own, |drawing| {
            drawing.circle((0.0, 0.0, r), Look::fill(Paint::Glass));
            sides(drawing, polygon, layout);
        });
    }
    drawing.circle((x, y, r), Look::line(Paint::Page, 5.0));
    let [form, flatness, scales] = form(lathe, layout);
    drawing.lens((x, y, r), |drawing| {
        drawing.text((x, y - 46.0), Anchor::Middle, &scales, Font::Label, Paint::Dim).id = Some(node::SCALES);
        drawing.text((x, y + 46.0), Anchor::Middle, &form, Font::Label, Paint::Dim).id = Some(node::FORM);
        drawing.text((x, y + 70.0), Anchor::Middle, &flatness, Font::Value, Paint::Ink).id = Some(node::FLATNESS);
    });
}

/// Form and flatness of the sides, and the scales of the lens; empty where nothing is cut.
pub(in super::super) fn form(lathe: &PolygonLathe, layout: &Layout) -> [String; 3] {
    if !lathe.derived.cuts {
        return Default::default();
    }
    let name = if lathe.derived.section.curvature >= 0.0 { "polygon.scene.crowned" } else { "polygon.scene.hollow" };
    let scales = lathe.lens_scales.get_or_init(|| scales_text(lathe, layout));
    [say(name), units::text(lathe.derived.section.flatness, 4, "mm"), scales.clone()]
}

/// Deviation of the sides from their planes along them, mm; none for a side with stock left.
fn curves(lathe: &PolygonLathe) -> Vec<Vec<(f64, f64)>> {
    let Some(section) = lathe.params.section().filter(|_| lathe.derived.cuts) else { return Vec::new() };
    let count = (lathe.derived.section.sides as u32).max(1);
    let (pitch, apothem) = (2.0 * PI / f64::from(count), 0.5 * lathe.params.across_flats);
    let most = (0.5 * pitch).min(1.2);
    let side = |at: u32| {
        let normal = section.begin() + pitch * f64::from(at);
        let cut = |off: f64| section.radius(normal + off) < section.stock() - SAME_LENGTH;
        let sample = |i: u32| most * (2.0 * f64::from(i) / f64::from(POINTS) - 1.0);
        let mut offs: Vec<f64> = (0..=POINTS).map(sample).filter(|off| cut(*off)).collect();
        // Up to the point between two samples at which stock begins.
        for end in [offs.first().copied(), offs.last().copied()].into_iter().flatten() {
            let next = end + (2.0 * most / f64::from(POINTS)).copysign(end);
            offs.push(math::last_holding(end, next, STOCK_HALVINGS, |off| off.abs() <= most && cut(off)));
        }
        offs.sort_by(f64::total_cmp);
        let point = |off: f64| {
            let (radius, (s, c)) = (section.radius(normal + off), math::sin_cos(off));
            (radius * s, radius * c - apothem)
        };
        offs.into_iter().map(point).collect::<Vec<_>>()
    };
    (0..count.min(SIDES)).map(side).filter(|side| side.len() > 1).collect()
}

/// Magnification of the deviations, and units per mm along the sides; none without sides.
fn scales(curves: &[Vec<(f64, f64)>], layout: &Layout) -> Option<(f64, f64)> {
    let all = curves.iter().flatten();
    let (length, high) = all.fold((0.0_f64, 0.0_f64), |(l, h), (x, y)| (l.max(x.abs()), h.max(y.abs())));
    let times = math::step_at_most((HIGH / high.max(1e-9) / layout.scale).min(1e6));
    (length > 0.0).then(|| (times, HALF / length))
}

/// The scales of the lens in words; empty without sides.
fn scales_text(lathe: &PolygonLathe, layout: &Layout) -> String {
    let scales = scales(&curves(lathe), layout);
    scales.map_or(String::new(), |(times, along)| format!("↕{}× ↔{}×", show(times, 0), show(along / layout.scale, 1)))
}

fn sides(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    let curves = curves(lathe);
    if let Some((times, along)) = scales(&curves, layout) {
        let up = times * layout.scale;
        let points = |side: &[(f64, f64)]| side.iter().map(|(x, y)| (x * along, PLANE - y * up)).collect::<Vec<_>>();
        if let Some(first) = curves.first() {
            let points = points(first);
            let (left, right) = (points.first().map_or(0.0, |p| p.0), points.last().map_or(0.0, |p| p.0));
            let mut ground = polyline(&points);
            fill(&mut ground, "L# #L# #Z", &[right, LENS.2, left, LENS.2]);
            drawing.path(ground, Look::fill(Paint::GlassDeep));
        }
        for (at, side) in curves.iter().enumerate().rev() {
            let look = if at == 0 { Look::hair(Paint::Ink, 2.0) } else { Look::hair(Paint::Dim, 1.0) };
            drawing.path(polyline(&points(side)), look);
        }
        // From the plane to the greatest deviation of the first side.
        let farthest = curves.first().and_then(|side| side.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())));
        if let Some((x, y)) = farthest.filter(|(_, y)| (y * up).abs() > 5.0) {
            let (x, from, to) = (x * along, PLANE, PLANE - y * up);
            let barb = 4.0_f64.copysign(from - to);
            drawing.path(filled("M# #V#M# #l-4 #M# #l4 #", &[x, from, to, x, to, barb, x, to, barb]), Look::POINTER);
        }
    }
    drawing.showing("flatness", |drawing| {
        drawing.path(filled("M# #H#", &[-LENS.2, PLANE, LENS.2]), Look::LEAD.dashed(6.0, 4.0));
    });
}

/// Ticks along the normal of the first side: how far every pass cuts.
fn passes(lathe: &PolygonLathe, layout: &Layout) -> String {
    let normal = lathe.params.section().map_or(0.0, |section| section.begin());
    let (s, c) = math::sin_cos(normal);
    let mut path = String::new();
    for size in &lathe.sizes {
        let (out, half) = (0.5 * size * layout.close, if *size > lathe.params.across_flats { 5.0 } else { 9.0 });
        let point = |aside: f64| (out * c - aside * s, -out * s - aside * c);
        let (from, to) = (point(-half), point(half));
        fill(&mut path, "M# #L# #", &[from.0, from.1, to.0, to.1]);
    }
    path
}

/// The ideal form of the polygon being turned, in the frame of the work.
pub(in super::super) fn wanted(lathe: &PolygonLathe, layout: &Layout) -> String {
    let p = &lathe.params;
    let Some(section) = p.section().filter(|_| p.sides > 2.0) else { return String::new() };
    closed(ideal(p.sides as u32, 0.5 * p.across_flats, section.begin()), (0.0, 0.0), layout.close)
}

/// The section in the frame of the work: stock, ideal polygon, tips.
pub(super) fn draw_close(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    let (x, y, r) = CLOSE;
    let clip = Some(Shape::Circle { x: 0.0, y: 0.0, r: GLASS });
    drawing.place(group::CLOSE, SceneGroup { at: (x, y), clip, ..SceneGroup::default() });
    drawing.within(group::CLOSE, |drawing| {
        drawing.circle((0.0, 0.0, GLASS), Look::fill(Paint::Glass));
        drawing.path(String::new(), Look::fill(Paint::Steel).thin(Paint::Edge, 1.2)).id = Some(node::CLOSE);
        drawing.circle((0.0, 0.0, r), Look::LEAD.dashed(4.0, 3.0));
        drawing.path(String::new(), Look::hair(Paint::Accent, 1.0).dashed(6.0, 4.0)).id = Some(node::IDEAL);
        for (at, polygon) in lathe.polygons().enumerate() {
            let own = group::of(group::PASSES, at);
            drawing.place(own, SceneGroup { parent: group::CLOSE, hidden: at > 0, ..SceneGroup::default() });
            drawing.within(own, |drawing| {
                drawing.showing("depth", |drawing| {
                    drawing.path(passes(polygon, layout), Look::hair(Paint::Ink, 1.0));
                });
            });
        }
    });
    let most = lathe.polygons().map(|lathe| lathe.params.inserts).fold(0.0, f64::max);
    for tip in 0..(most as u16).min(TIPS) {
        drawing.place(group::TIPS + tip, SceneGroup { parent: group::CLOSE, ..SceneGroup::default() });
        drawing.within_hidden(group::TIPS + tip, |drawing| {
            drawing.circle((0.0, 0.0, 4.0), Look::fill(Paint::Accent).thin(Paint::Page, 1.0));
        });
    }
    drawing.circle((x, y, GLASS), Look::line(Paint::Page, 4.0));
    drawing.circle((x, y, GLASS), Look::hair(Paint::Dim, 1.0));
}

//! The machine from above: chuck, bar with the polygon, cutter edge-on, its slide.

use super::ids::{group, node};
use super::layout::{Layout, SIDE, UNIT};
use super::turning_tool;
use crate::machines::polygon_lathe::outlines::closed;
use crate::machines::polygon_lathe::progress::{BarSection, Progress};
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::machines::sheets::say;
use crate::math::{self, PI};
use crate::text::number::{fill, filled};
use crate::text::{columns, units};
use crate::view::drawing::Drawing;
use crate::view::letters::Anchor;
use crate::view::look::{Look, Paint};
use crate::view::scene::{Font, LETTER, SceneGroup};

/// Left end of the chuck.
const LEFT: f64 = 636.0;
/// Drawn length of the cutter; the rest is broken off.
const CUTTER: f64 = 74.0;
/// Turns of a twist that are drawn, and the steps along it.
const MOST_TURNS: f64 = 8.0;
const TWIST: u32 = 64;

/// Everything from above.
pub(super) fn draw(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    let p = &lathe.params;
    let (front, axis) = SIDE;
    let (scale, face) = (layout.side, layout.face);
    let half = 0.5 * p.stock_diameter * scale;
    // Chuck with its jaws.
    let chuck = (1.5 * half).max(38.0);
    drawing.rect([LEFT, axis - chuck, 30.0, 2.0 * chuck, 2.0], Look::fill(Paint::DarkBar).thin(Paint::Edge, 0.8));
    drawing.rect(
        [LEFT + 30.0, axis - 0.86 * chuck, 8.0, 1.72 * chuck, 0.0],
        Look::fill(Paint::DarkBar).thin(Paint::Edge, 0.8),
    );
    for side in [-1.0, 1.0] {
        let (near, far) = (axis + side * half, axis + side * (half + 0.32 * chuck).min(0.84 * chuck).max(half + 6.0));
        let left = LEFT + 38.0;
        drawing.path(
            filled("M# #H#V#H#Z", &[left, near, front, far, left]),
            Look::fill(Paint::Steel).thin(Paint::Edge, 0.8),
        );
    }
    drawing.showing("length", |drawing| {
        drawing.path(String::new(), Look::fill(Paint::SteelBar).thin(Paint::Edge, 1.0)).id = Some(node::BAR);
    });
    drawing.within(group::EDGES, |drawing| {
        drawing.path(String::new(), Look::fill(Paint::SteelBar).thin(Paint::Edge, 1.0)).id = Some(node::EDGES);
    });
    twist(drawing, lathe, layout);
    drawing.path(filled("M# #H#", &[LEFT - 10.0, axis, 1016.0]), Look::LEAD.dashed(14.0, 5.0).faint(0.6));
    dimension(drawing, lathe, layout, half);
    approach(drawing, lathe, layout);
    let top = axis + 0.5 * p.across_flats * scale;
    drawing.place(group::SIDE, SceneGroup { at: (face, top), ..SceneGroup::default() });
    drawing.within(group::SIDE, |drawing| {
        drawing.path(filled("M-34 #l12 -7h66l-12 7Z", &[CUTTER + 6.0]), Look::fill(Paint::DarkLight));
        drawing.path(filled("M32 #l12 -7v18l-12 7Z", &[CUTTER + 6.0]), Look::fill(Paint::DarkShade));
        drawing.rect([-34.0, CUTTER + 6.0, 66.0, 18.0, 0.0], Look::fill(Paint::DarkFront).thin(Paint::Edge, 0.8));
    });
    for tool in [group::SIDE_CUTTER, group::SIDE_TURNING] {
        drawing.place(tool, SceneGroup { parent: group::SIDE, ..SceneGroup::default() });
    }
    drawing.within(group::SIDE_CUTTER, |drawing| {
        // A line of fracture: the disc is longer than drawn.
        drawing.path(
            filled("M-1 16h14V#l-5 4l-5 -7l-4 5Z", &[CUTTER]),
            Look::fill(Paint::SteelBody).thin(Paint::Edge, 0.8),
        );
        drawing.rect([-9.0, 40.0, 30.0, 17.0, 2.0], Look::FACE);
        drawing.path("M0 0h7l5 17h-12Z", Look::fill(Paint::Accent).thin(Paint::Edge, 0.8));
    });
    if lathe.has_main_spindle() {
        drawing.within_hidden(group::SIDE_TURNING, turning_tool::draw_from_above);
    }
}

/// Approach of the slide from its start to the clearance.
fn approach(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    let p = &lathe.params;
    let at = |across: f64, z: f64| (layout.face + z * layout.side, SIDE.1 + 0.5 * across * layout.side);
    let (start, near) = (at(p.start_x, p.start_z), at(p.clear_diameter(), p.clearance));
    let mut path = filled("M# #L# #", &[start.0, start.1, near.0, near.1]);
    if p.is_behind_face() {
        let (over, down) = (at(p.clear_diameter(), p.approach()), at(p.across_flats, p.approach()));
        fill(&mut path, "L# #L# #", &[over.0, over.1, down.0, down.1]);
    }
    drawing.showing("clearance", |drawing| {
        drawing.path(path, Look::LEAD.dashed(7.0, 4.0).faint(0.7));
    });
    drawing.showing("start-x", |drawing| {
        drawing.path(filled("M# #h14M# #v14", &[start.0 - 7.0, start.1, start.0, start.1 - 7.0]), Look::LEAD);
    });
}

/// The length of the polygon over the bar.
fn dimension(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout, half: f64) {
    let p = &lathe.params;
    let [left, right] = [p.far_end(), p.from_face].map(|at| layout.face - at * layout.side);
    let y = SIDE.1 - 46.0;
    drawing.showing("length", |drawing| {
        let ends = filled("M# #V#M# #V#", &[left, SIDE.1 - half - 3.0, y - 4.0, right, SIDE.1 - half - 3.0, y - 4.0]);
        let arrows = if right - left > 26.0 {
            filled("M# #H#M# #l-8 4l8 4M# #l8 4l-8 4", &[left, y, right, left + 8.0, y - 4.0, right - 8.0, y - 4.0])
        } else {
            filled(
                "M# #H#M# #H#M# #l8 4l-8 4M# #l-8 4l8 4",
                &[left - 22.0, y, left, right, y, right + 22.0, left - 8.0, y - 4.0, right + 8.0, y - 4.0],
            )
        };
        drawing.path([ends, arrows].concat(), Look::LEAD);
        for other in &lathe.further {
            let ends = [other.params.far_end(), other.params.from_face].map(|at| layout.face - at * layout.side);
            for end in ends {
                drawing.path(filled("M# #V#", &[end, SIDE.1 - half - 3.0, y - 4.0]), Look::LEAD);
            }
            drawing.path(filled("M# #H#", &[ends[0], y, ends[1]]), Look::LEAD);
        }
        let text = format!("{} {}", say("polygon.scene.length"), units::text(lathe.params.length, 3, "mm"));
        let half = 0.3 * LETTER * UNIT * columns(&text) as f64;
        let middle = math::clamp(0.5 * (left + right), LEFT + half, 1008.0 - half);
        drawing.text((middle, y - 12.0), Anchor::Middle, &text, Font::Label, Paint::Ink);
    });
}

/// The corners of a twisted polygon along the bar, on the near side of the part.
fn twist(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    let (p, derived) = (&lathe.params, &lathe.derived);
    let (scale, face) = (layout.side, layout.face);
    let turns = p.length / p.lead;
    if turns.abs() > MOST_TURNS || !derived.cuts || derived.section.sides <= 1.0 {
        return;
    }
    let begin = p.section().map_or(0.0, |section| section.begin());
    for corner in 0..derived.section.sides as u32 {
        let angle = |part: f64| begin + 2.0 * PI * ((f64::from(corner) + 0.5) / derived.section.sides - turns * part);
        let mut line = String::new();
        let mut seen = false;
        for i in 0..=TWIST {
            let part = f64::from(i) / f64::from(TWIST);
            let (sin, cos) = math::sin_cos(angle(part));
            let at = [face - (p.from_face + part * p.length) * scale, SIDE.1 - derived.section.corner * scale * cos];
            if sin >= 0.0 {
                fill(&mut line, if seen { "L# #" } else { "M# #" }, &at);
            }
            seen = sin >= 0.0;
        }
        drawing.showing("lead", |drawing| {
            drawing.path(line, Look::hair(Paint::Accent, 1.0).dashed(6.0, 4.0));
        });
    }
}

/// Stretches of the bar that have become polygons, from the face to the jaws.
pub(in super::super) fn profile(lathe: &PolygonLathe, progress: &Progress) -> Vec<BarSection> {
    let passes: Vec<_> = progress.pass_sections().collect();
    sections(lathe, &passes)
}

/// Stretches of the bar that are cut, each with the least of its sizes.
fn sections(lathe: &PolygonLathe, passes: &[BarSection]) -> Vec<BarSection> {
    let mut ends: Vec<f64> = passes.iter().flat_map(|pass| [pass.near, pass.far]).collect();
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    let mut all: Vec<BarSection> = Vec::new();
    for (near, far) in ends.iter().zip(ends.iter().skip(1)) {
        let over = passes.iter().filter(|pass| pass.near <= *near && pass.far >= *far);
        let size = over.map(|pass| pass.size).fold(lathe.params.stock_diameter, f64::min);
        match all.last_mut().filter(|last| last.far == *near && last.size == size) {
            Some(last) => last.far = *far,
            None if size < lathe.params.stock_diameter => all.push(BarSection { near: *near, far: *far, size }),
            None => {}
        }
    }
    all
}

/// The bar from above, as cut so far.
pub(in super::super) fn bar(lathe: &PolygonLathe, layout: &Layout, progress: &Progress) -> String {
    let (scale, face) = (layout.side, layout.face);
    let stock = 0.5 * lathe.params.stock_diameter;
    // From the face to the jaws.
    let mut upper = Vec::new();
    let cut: Vec<_> = progress.pass_sections().chain(progress.turned_sections.iter().copied()).collect();
    let cut = sections(lathe, &cut);
    if cut.first().is_none_or(|first| first.near > 0.0) {
        upper.push((face, stock));
    }
    for BarSection { near, far, size } in cut {
        let edge = (near > 0.0).then_some(stock);
        let [near, far] = [near, far].map(|at| (face - at * scale).max(LEFT + 38.0));
        let half = 0.5 * size;
        upper.extend(edge.map(|stock| (near, stock)));
        upper.extend([(near, half), (far, half), (far, stock)]);
    }
    upper.push((LEFT + 38.0, stock));
    let lower = upper.iter().rev().map(|(x, half)| (*x, -half)).collect::<Vec<_>>();
    let points = upper.into_iter().chain(lower).map(|(x, half)| (x, half * scale));
    closed(points, (0.0, SIDE.1), 1.0)
}

/// Outline and edges of a polygon from above, with the work turned by `angle` radians: of `size` across flats, between two distances from
/// the face in mm.
pub(in super::super) fn edges(
    lathe: &PolygonLathe,
    layout: &Layout,
    size: f64,
    (from, to): (f64, f64),
    angle: f64,
) -> String {
    let (p, derived) = (&lathe.params, &lathe.derived);
    let mut path = String::new();
    if p.lead != 0.0
        || !derived.cuts
        || derived.section.sides < 2.0
        || derived.section.sides > 24.0
        || size >= p.stock_diameter
    {
        return path;
    }
    let pitch = 2.0 * PI / derived.section.sides;
    // Corner of two planes, or the stock that is left between them.
    let corner = (0.5 * size / math::cos(0.5 * pitch).max(1e-6)).min(0.5 * p.stock_diameter);
    let wide =
        if corner < 0.5 * p.stock_diameter { 0.0 } else { 0.5 * pitch - math::acos((0.5 * size / corner).min(1.0)) };
    let begin = p.section().map_or(0.0, |section| section.begin()) + angle;
    let at = |behind: f64| (layout.face - behind * layout.side).max(LEFT + 38.0);
    let (left, right) = (at(to), at(from));
    let (mut top, mut bottom) = (SIDE.1, SIDE.1);
    for at in 0..derived.section.sides as u32 {
        for off in [-wide, wide] {
            let (sin, cos) = math::sin_cos(begin + pitch * (f64::from(at) + 0.5) + off);
            let y = SIDE.1 + corner * layout.side * cos;
            (top, bottom) = (top.min(y), bottom.max(y));
            // From above, with the cutter towards the operator.
            if sin > 0.0 {
                fill(&mut path, "M# #H#", &[left, y, right]);
            }
        }
    }
    fill(&mut path, "M# #H#V#H#Z", &[left, top, right, bottom, left]);
    path
}

/// Arrows at the figures of the slides.
pub(super) fn draw_arrows(drawing: &mut Drawing, (x, y): (f64, f64)) {
    drawing
        .path(filled("M# #v-16m-4 6l4 -6l4 6M# #h-16m6 -4l-6 4l6 4", &[x, y + 2.0, x + 8.0, y + 18.0]), Look::POINTER);
}

//! The lens at the edge of the tool: depth of cut and chip, magnified.

use super::ids::{group, node};
use super::layout::{Layout, UNIT, VIEW};
use super::work::PartSection;
use crate::machines::turning_spindle::params::{Params, Path};
use crate::machines::turning_spindle::resolved::TurningSpindle;
use crate::math;
use crate::text::catalog::number_text as show;
use crate::text::number::filled;
use crate::text::{columns, units};
use crate::view::drawing::{Drawing, polygon};
use crate::view::letters::Anchor;
use crate::view::look::{Look, Paint};
use crate::view::scene::{Font, LETTER, Placement, SceneGroup, Shape};

/// Approximate length of the depth of cut in the lens.
const DEPTH: f64 = 24.0;

/// Approximate size of the keyway in the lens, the greater of its width and depth.
const KEYWAY: f64 = 64.0;

/// Magnification of the lens: 1, 2, 5, 10 …, so that the depth of cut is visible, or the keyway while it is milled.
fn magnification(p: &Params, layout: &Layout, mills: bool) -> f64 {
    let wanted = if mills {
        KEYWAY / (p.keyway_width.max(p.keyway_depth) * layout.scale)
    } else {
        DEPTH / (p.depth * layout.scale)
    };
    math::step_at_most((1.4 * wanted).max(1.0))
}

/// The lens with nodes for its contents.
pub(super) fn draw(drawing: &mut Drawing, lathe: &TurningSpindle, layout: &Layout) {
    let (x, y, r) = layout.lens;
    drawing.path(String::new(), Look::POINTER.edge(Paint::Accent, 1.0)).id = Some(node::LEADER);
    drawing.within(group::TURRET, |drawing| {
        drawing.circle((0.0, 0.0, 10.0), Look::POINTER);
    });
    let clip = Some(Shape::Circle { x: 0.0, y: 0.0, r });
    drawing.place(group::LENS, SceneGroup { at: (x, y), clip, ..SceneGroup::default() });
    for within in [group::LENS_CHIP, group::LENS_INSERT, group::LENS_MILL] {
        drawing.place(within, SceneGroup { parent: group::LENS, ..SceneGroup::default() });
    }
    drawing.within(group::LENS, |drawing| {
        drawing.circle((0.0, 0.0, r), Look::fill(Paint::Glass));
        drawing.path(String::new(), Look::fill(Paint::SteelShade).thin(Paint::Edge, 1.2)).id = Some(node::LENS_PART);
    });
    draw_insert(drawing, &lathe.params, layout);
    if lathe.keyway().is_some() {
        draw_mill(drawing, &lathe.params, layout);
    }
    drawing.circle((x, y, r), Look::line(Paint::Page, 5.0));
    draw_figures(drawing, &lathe.params, layout);
}

/// The insert with its chip and the depth of cut.
fn draw_insert(drawing: &mut Drawing, p: &Params, layout: &Layout) {
    drawing.within(group::LENS_INSERT, |drawing| {
        drawing.path("M0 0L34 -84H150V-10L78 -6Z", Look::fill(Paint::Accent).faint(0.9));
    });
    drawing.within_hidden(group::LENS_CHIP, |drawing| {
        let curl = "M3 -9c-14 -20 -2 -42 -14 -52s-26 4 -18 14";
        drawing.path(curl, Look::line(Paint::DarkLight, 9.0).round());
        drawing.path(curl, Look::line(Paint::Rim, 1.2).round().faint(0.7));
    });
    let depth = p.depth * layout.scale * magnification(p, layout, false);
    drawing.within(group::LENS_INSERT, |drawing| {
        drawing.showing("depth", |drawing| {
            let line = if p.path == Path::Facing {
                filled("M0 10v12M# 10v12M0 16h#", &[depth, depth])
            } else {
                filled("M-56 0h12M-56 #h12M-50 0v#", &[-depth, -depth])
            };
            drawing.path(line, Look::hair(Paint::Ink, 1.0));
        });
    });
}

/// The mill in the groove with the depth of the keyway.
fn draw_mill(drawing: &mut Drawing, p: &Params, layout: &Layout) {
    let scale = layout.scale * magnification(p, layout, true);
    let (half, depth) = (0.5 * p.keyway_width * scale, p.keyway_depth * scale);
    drawing.within_hidden(group::LENS_MILL, |drawing| {
        drawing.path(String::new(), Look::fill(Paint::Glass)).id = Some(node::LENS_GROOVE);
        drawing.rect([-half, -120.0, 2.0 * half, 120.0, 0.0], Look::fill(Paint::Accent).faint(0.9));
        drawing.showing("keyway-depth", |drawing| {
            let at = half + 8.0;
            drawing
                .path(filled("M# 0h12M# #h12M# 0v#", &[at, at, -depth, at + 6.0, -depth]), Look::hair(Paint::Ink, 1.0));
        });
    });
}

/// The figures: the depth below its dimension line, the magnification in the middle below.
fn draw_figures(drawing: &mut Drawing, p: &Params, layout: &Layout) {
    let (x, y, r) = layout.lens;
    let depth = p.depth * layout.scale * magnification(p, layout, false);
    let value = units::text(p.depth, 3, "mm");
    let room = r - 18.0 - 0.3 * LETTER * UNIT * columns(&value) as f64;
    let below = ((0.5 * depth).min(room).max(0.0), 40.0);
    let (at, anchor) = if p.path == Path::Facing { (below, Anchor::Middle) } else { ((20.0 - r, 24.0), Anchor::Start) };
    drawing.lens((x, y, r), |drawing| {
        drawing.showing("depth", |drawing| {
            drawing.text((x + at.0, y + at.1), anchor, "", Font::Value, Paint::Ink).id = Some(node::LENS_DEPTH);
        });
        drawing.showing("keyway-depth", |drawing| {
            drawing.text((x, y + 28.0), Anchor::Middle, "", Font::Value, Paint::Ink).id = Some(node::LENS_KEYWAY);
        });
        drawing.text((x, y + r - 14.0), Anchor::Middle, "", Font::Label, Paint::Ink).id = Some(node::LENS_TIMES);
    });
}

/// Figures in the lens while the insert or the mill is at the work.
pub(in super::super) fn texts(p: &Params, layout: &Layout, mills: bool) -> [(u16, String); 3] {
    let mm = |value: f64, is_shown: bool| if is_shown { units::text(value, 3, "mm") } else { String::new() };
    [
        (node::LENS_DEPTH, mm(p.depth, !mills)),
        (node::LENS_KEYWAY, mm(p.keyway_depth, mills)),
        (node::LENS_TIMES, format!("{} ×", show(magnification(p, layout, mills), 0))),
    ]
}

/// What is at the tip of the tool.
pub(in super::super) struct AtTip<'a> {
    /// Sections of the part.
    pub(in super::super) sections: &'a [PartSection],
    /// Place of the tip, mm from the axis and from the finished face.
    pub(in super::super) tool: (f64, f64),
    /// The insert cuts.
    pub(in super::super) cuts: bool,
    /// The mill of the driven tool is there.
    pub(in super::super) mills: bool,
    /// The cut part of the keyway: its depth and ends.
    pub(in super::super) groove: Option<(f64, [f64; 2])>,
}

/// Contents of the lens, and its leader.
pub(in super::super) fn pose(
    lathe: &TurningSpindle,
    layout: &Layout,
    at: &AtTip,
    placements: &mut Vec<Placement>,
    paths: &mut Vec<(u16, String)>,
) {
    let ((radius, z), p) = (at.tool, &lathe.params);
    let scale = layout.scale * magnification(p, layout, at.mills);
    let profile = at.sections.iter().flat_map(|section| &section.profile);
    let place = |(at, diameter): &(f64, f64)| ((at - z) * scale, (radius - 0.5 * diameter) * scale);
    let upper: Vec<(f64, f64)> = profile.map(place).collect();
    let lower = radius * scale;
    let ends = [upper.last(), upper.first()].map(|end| end.map_or((0.0, lower), |(x, _)| (*x, lower)));
    let part: Vec<(f64, f64)> = upper.into_iter().chain(ends).collect();
    let half = layout.lens.2 + 4.0;
    paths.push((node::LENS_PART, polygon(&clipped(part, half))));
    placements.extend([
        Placement::shown(group::LENS_CHIP, at.cuts && !at.mills),
        Placement::shown(group::LENS_INSERT, !at.mills),
    ]);
    if let Some(diameter) = lathe.keyway() {
        placements.push(Placement::shown(group::LENS_MILL, at.mills));
        let corners = at.groove.filter(|_| at.mills).map(|(depth, [end, begin])| {
            let [top, bottom] = [diameter, diameter - 2.0 * depth];
            [(end, top), (begin, top), (begin, bottom), (end, bottom)].map(|corner| place(&corner)).to_vec()
        });
        paths.push((node::LENS_GROOVE, corners.map_or_else(String::new, |corners| polygon(&clipped(corners, half)))));
    }
    // From the ring at the tip, where the drawing has it, to the edge of the lens.
    let (tip, (x, y, r)) = (layout.tip(radius, z), layout.lens);
    let (dx, dy) = (x - tip.0, y - tip.1);
    let length = math::hypot(dx, dy);
    let is_seen = tip.0 < VIEW[0] + VIEW[2] && tip.1 > VIEW[1];
    let line = (is_seen && length > r + 14.0).then(|| {
        let at = |from: f64| (tip.0 + dx * from / length, tip.1 + dy * from / length);
        let (from, to) = (at(10.0), at(length - r));
        filled("M# #L# #", &[from.0, from.1, to.0, to.1])
    });
    paths.push((node::LEADER, line.unwrap_or_default()));
}

/// The part of a polygon inside the square from `-half` to `half`: one edge of the square after the other.
fn clipped(points: Vec<(f64, f64)>, half: f64) -> Vec<(f64, f64)> {
    type Point = (f64, f64);
    let inside: [fn(Point) -> f64; 4] = [|p| -p.0, |p| p.0, |p| -p.1, |p| p.1];
    inside.into_iter().fold(points, |points, beyond| {
        let next = points.iter().cycle().skip(1);
        let mut kept = Vec::new();
        for (&one, &other) in points.iter().zip(next) {
            let (a, b) = (beyond(one) - half, beyond(other) - half);
            if a <= 0.0 {
                kept.push(one);
            }
            if (a <= 0.0) != (b <= 0.0) {
                let part = a / (a - b);
                kept.push((one.0 + part * (other.0 - one.0), one.1 + part * (other.1 - one.1)));
            }
        }
        kept
    })
}

//! The drawing of the polygon lathe: the section on the machine and as the work sees it, the side, the finished polygon against the ideal one.
//!
//! Section and cutter are to one scale; the view from the work and the deviation are magnified, with their scales as text.

use super::resolved::PolygonLathe;
use crate::drives::polygon::Section;
use crate::math::{self, PI};
use crate::text::catalog::{Language, words};
use crate::text::number::filled;
use crate::view::Scene;
use crate::view::pen::Pen;

/// Groups that poses move.
pub(super) mod group {
    /// The section on the machine.
    pub(in super::super) const WORK: u16 = 1;
    /// The cutter disc, which slides.
    pub(in super::super) const DISC: u16 = 2;
    /// Its inserts, which also turn.
    pub(in super::super) const INSERTS: u16 = 3;
    /// The ring that replaces inserts at high speed.
    pub(in super::super) const BLUR: u16 = 4;
    /// The cutter from the side.
    pub(in super::super) const SIDE: u16 = 5;
    /// First of the tips as the work sees them.
    pub(in super::super) const TIPS: u16 = 6;
}

/// Tips that are shown to the work.
pub(super) const TIPS: u16 = 12;

/// Nodes whose path or text poses change; they stand first.
pub(super) mod node {
    pub(in super::super) const SECTION: u16 = 0;
    pub(in super::super) const CLOSE: u16 = 1;
    pub(in super::super) const BAR: u16 = 2;
    pub(in super::super) const WORK_SPEED: u16 = 3;
    pub(in super::super) const TOOL_SPEED: u16 = 4;
    pub(in super::super) const SIZE: u16 = 5;
    pub(in super::super) const PASS: u16 = 6;
    pub(in super::super) const PHASE: u16 = 7;
    pub(in super::super) const STATE: u16 = 8;
}

/// Centre and radius that the section takes as the work sees it.
pub(super) const CLOSE: (f64, f64, f64) = (462.0, 96.0, 74.0);
/// The same of the finished polygon.
const FINISHED: (f64, f64, f64) = (662.0, 96.0, 74.0);
/// Left end, centre line and room of the side view.
const SIDE: (f64, f64, f64, f64) = (400.0, 232.0, 300.0, 36.0);
/// Height of the axes on the machine.
const CENTRE: f64 = 150.0;
/// Room for the machine.
const ROOM: (f64, f64) = (350.0, 270.0);

/// How the parts lie in the drawing.
pub(super) struct View {
    /// Units per mm on the machine.
    pub(super) scale: f64,
    /// Centre of the work on the machine.
    pub(super) work: (f64, f64),
    /// Centre of the cutter on the machine where it has finished.
    pub(super) cutter: (f64, f64),
    /// Units per mm as the work sees it.
    pub(super) close: f64,
    /// Units per mm of the side view, and where the face is.
    pub(super) side: (f64, f64),
}

impl View {
    pub(super) fn new(lathe: &PolygonLathe) -> View {
        let p = &lathe.p;
        let stock = 0.5 * p.stock_diameter;
        // Room for the whole cutter where the slide begins.
        let width = stock + (stock + p.clearance).max(0.5 * p.start_x) + 2.0 * p.tip_radius;
        let scale = (ROOM.0 / width).min(ROOM.1 / (2.0 * p.tip_radius.max(stock)));
        let work = (16.0 + stock * scale, CENTRE);
        let cutter = (work.0 + (0.5 * p.across_flats + p.tip_radius) * scale, CENTRE);
        let side = (SIDE.2 / (1.6 * p.length + 2.0 * p.clearance)).min(SIDE.3 / stock);
        View { scale, work, cutter, close: CLOSE.2 / stock, side: (side, SIDE.0 + 1.6 * p.length * side) }
    }
}

/// A closed line through points about a centre; y goes up in millimetres and down in the drawing.
pub(super) fn closed(points: impl IntoIterator<Item = (f64, f64)>, (x, y): (f64, f64), scale: f64) -> String {
    let mut d = String::new();
    for (at, point) in points.into_iter().enumerate() {
        d += &filled(if at == 0 { "M# #" } else { "L# #" }, &[x + scale * point.0, y - scale * point.1]);
    }
    d.push('Z');
    d
}

/// The ideal polygon: corner after corner.
pub(super) fn ideal(sides: u32, apothem: f64, normal: f64) -> Vec<(f64, f64)> {
    let pitch = 2.0 * PI / f64::from(sides.max(1));
    let radius = apothem / math::cos(0.5 * pitch);
    let corner = |at: u32| {
        let (s, c) = math::sin_cos(normal + pitch * (f64::from(at) + 0.5));
        (radius * c, radius * s)
    };
    (0..sides).map(corner).collect()
}

/// Angle from the nearest normal.
fn from_normal(section: &Section, angle: f64, pitch: f64) -> f64 {
    let off = (angle - section.begin()) / pitch;
    pitch * (off - off.round())
}

/// Deviation of the finished section from the plane of the nearest side, at evenly spaced angles: angle and mm, none where stock is left.
pub(super) fn deviations(section: &Section, apothem: f64, sides: u32, count: usize) -> Vec<(f64, f64)> {
    let pitch = 2.0 * PI / f64::from(sides.max(1));
    let at = |(i, radius): (usize, f64)| {
        let angle = section.begin() + 2.0 * PI * i as f64 / count as f64;
        let off = from_normal(section, angle, pitch);
        (angle, if radius >= section.stock() - 1e-9 { f64::NAN } else { radius * math::cos(off) - apothem })
    };
    section.radii(count).into_iter().enumerate().map(at).collect()
}

/// The drawing at rest.
pub(super) fn scene(lathe: &PolygonLathe) -> Scene {
    let p = &lathe.p;
    let view = View::new(lathe);
    let mut pen = Pen::default();
    let name = |id: &'static str| words(Language::English, id).to_owned();
    // Nodes that change, in the order of `node`.
    pen.path(group::WORK, String::new(), "steel", "dim", 1.0, "part");
    pen.path(0, String::new(), "steel", "dim", 1.0, "part");
    pen.path(0, String::new(), "steel", "dim", 1.0, "part");
    for (x, y) in [(82.0, 305.0), (230.0, 305.0), (372.0, 305.0), (470.0, 305.0), (570.0, 305.0), (700.0, 305.0)] {
        pen.text(x, y, "middle", String::new(), "ink", "value");
    }
    machine(&mut pen, lathe, &view);
    close(&mut pen, lathe, &view);
    finished(&mut pen, lathe);
    side(&mut pen, lathe, &view);
    for (x, y, id) in [
        (82.0, 287.0, "polygon.scene.work"),
        (230.0, 287.0, "polygon.scene.tool"),
        (372.0, 287.0, "polygon.scene.size"),
        (470.0, 287.0, "polygon.scene.pass"),
        (570.0, 287.0, "polygon.scene.phase"),
        (CLOSE.0, 14.0, "polygon.scene.close"),
        (FINISHED.0, 14.0, "polygon.scene.finished"),
        (182.0, 14.0, "polygon.scene.machine"),
    ] {
        pen.text(x, y, "middle", name(id), "dim", "label");
    }
    let tips = (p.inserts as u16).min(TIPS);
    Scene {
        view: [0.0, 0.0, 760.0, 316.0],
        nodes: pen.nodes,
        groups: Pen::groups(group::TIPS + tips),
        unit: 0.0,
        gradients: Vec::new(),
        alt: "polygon.scene.alt",
        option: None,
    }
}

/// Cutter and centre lines on the machine.
fn machine(pen: &mut Pen, lathe: &PolygonLathe, view: &View) {
    let p = &lathe.p;
    let ((wx, wy), (cx, cy), r) = (view.work, view.cutter, p.tip_radius * view.scale);
    pen.ring(0, (wx, wy, 0.5 * p.stock_diameter * view.scale), "dim", 0.8, "dash");
    pen.path(0, filled("M# #h#M# #v#", &[wx - 8.0, wy, 16.0, wx, wy - 8.0, 16.0]), "", "dim", 0.8, "");
    pen.ring(group::DISC, (cx, cy, 0.86 * r), "dim", 1.4, "");
    pen.disc(group::DISC, cx, cy, 4.0, "dim", "");
    pen.ring(group::BLUR, (cx, cy, 0.93 * r), "accent", 0.14 * r, "blur");
    let Some(setup) = lathe.p.setup(p.across_flats) else { return };
    for tip in &setup.tips {
        // As at the start: at 0 a tip points at the work, to the left.
        let (s, c) = math::sin_cos(tip.angle);
        let at = |radius: f64, aside: f64| {
            let (x, y) = (-radius * c + aside * s, -radius * s - aside * c);
            (cx + x * view.scale, cy - y * view.scale)
        };
        let (end, left, right) =
            (at(tip.radius, 0.0), at(0.82 * p.tip_radius, 0.06 * r / view.scale), at(0.82 * p.tip_radius, 0.0));
        let d = filled("M# #L# #L# #Z", &[end.0, end.1, left.0, left.1, right.0, right.1]);
        pen.path(group::INSERTS, d, "accent", "pane", 0.6, "insert");
    }
}

/// What stays of the section as the work sees it: stock, ideal polygon, tips.
fn close(pen: &mut Pen, lathe: &PolygonLathe, view: &View) {
    let p = &lathe.p;
    let (x, y, r) = CLOSE;
    pen.ring(0, (x, y, r), "dim", 0.8, "dash");
    if let Some(section) = lathe.p.section().filter(|_| p.sides > 2.0) {
        let d = closed(ideal(p.sides as u32, 0.5 * p.across_flats, section.begin()), (x, y), view.close);
        pen.path(0, d, "", "accent", 0.8, "dash");
    }
    for tip in 0..(p.inserts as u16).min(TIPS) {
        pen.disc(group::TIPS + tip, x, y, 3.0, "bad", "");
    }
}

/// The finished polygon against the ideal one, its deviation magnified.
fn finished(pen: &mut Pen, lathe: &PolygonLathe) {
    let (p, d) = (&lathe.p, &lathe.d);
    let (x, y, r) = FINISHED;
    let Some(section) = lathe.p.section() else { return };
    let (apothem, sides) = (0.5 * p.across_flats, d.sides as u32);
    let scale = r / (0.5 * p.stock_diameter).max(d.corner);
    let largest = d.deviation.0.abs().max(d.deviation.1.abs());
    let magnified = if largest > 1e-6 { math::clamp((0.06 * apothem / largest).floor(), 1.0, 10_000.0) } else { 1.0 };
    let pitch = 2.0 * PI / f64::from(sides.max(1));
    let edge = if -d.deviation.0 > d.deviation.1 { d.deviation.0 } else { d.deviation.1 };
    let point = |(angle, off): (f64, f64)| {
        let from = from_normal(&section, angle, pitch);
        // Along the normal of its side; stock goes outwards with the ends of the sides.
        let stock = off.is_nan();
        let radius = if stock { section.stock() } else { (apothem + off) / math::cos(from) };
        let further = if stock { edge } else { off } * (magnified - 1.0);
        let ((s, c), (ns, nc)) = (math::sin_cos(angle), math::sin_cos(if stock { angle } else { angle - from }));
        (radius * c + further * nc, radius * s + further * ns)
    };
    let points = deviations(&section, apothem, sides, 720).into_iter().map(point);
    pen.path(0, closed(points, (x, y), scale), "steel", "ink", 1.0, "part");
    if sides > 2 {
        pen.path(0, closed(ideal(sides, apothem, section.begin()), (x, y), scale), "", "accent", 1.0, "dash");
    }
    let text = filled("# ×", &[magnified]);
    pen.text(x, y + 4.0, "middle", text, "dim", "small");
}

/// Turns of a twist that are drawn, and the steps along it.
const MOST_TURNS: f64 = 8.0;
const TWIST: u32 = 64;

/// The cutter from the side, the corners of a twisted polygon, over the bar that poses draw.
fn side(pen: &mut Pen, lathe: &PolygonLathe, view: &View) {
    let p = &lathe.p;
    let (scale, face) = view.side;
    let top = SIDE.1 - 0.5 * p.across_flats * scale;
    pen.path(0, filled("M# #H#", &[SIDE.0 - 10.0, SIDE.1, SIDE.0 + SIDE.2 + 40.0]), "", "dim", 0.8, "dash");
    let (turns, d) = (p.length / p.lead, &lathe.d);
    if turns.abs() <= MOST_TURNS && d.cuts && d.sides > 1.0 {
        // The corners as they would run; those on the near side of the part.
        for corner in 0..d.sides as u32 {
            let begin = lathe.p.section().map_or(0.0, |section| section.begin());
            let angle = |part: f64| begin + 2.0 * PI * ((f64::from(corner) + 0.5) / d.sides - turns * part);
            let mut d_path = String::new();
            let mut seen = false;
            for i in 0..=TWIST {
                let part = f64::from(i) / f64::from(TWIST);
                let (sin, cos) = math::sin_cos(angle(part));
                let at = [face - part * p.length * scale, SIDE.1 - d.corner * scale * cos];
                if sin >= 0.0 {
                    d_path += &filled(if seen { "L# #" } else { "M# #" }, &at);
                }
                seen = sin >= 0.0;
            }
            pen.path(0, d_path, "", "accent", 0.8, "dash");
        }
    }
    pen.path(group::SIDE, filled("M# #l7 -12v-18h-14v18z", &[face, top]), "accent", "pane", 0.6, "insert");
}

/// The bar from the side: cut to half widths `done` as far as the length, and `deeper` as far as `behind`, in mm.
pub(super) fn bar(lathe: &PolygonLathe, view: &View, done: f64, deeper: Option<(f64, f64)>) -> String {
    let p = &lathe.p;
    let (scale, face) = view.side;
    let stock = 0.5 * p.stock_diameter;
    let mut upper = vec![(SIDE.0, stock), (face - p.length * scale, stock)];
    upper.push((face - p.length * scale, done));
    if let Some((behind, half)) = deeper {
        let at = face - behind.min(p.length) * scale;
        upper.extend([(at, done), (at, half), (face, half)]);
    } else {
        upper.push((face, done));
    }
    let lower = upper.iter().rev().map(|(x, half)| (*x, -half)).collect::<Vec<_>>();
    let points = upper.into_iter().chain(lower).map(|(x, half)| (x, half * scale));
    closed(points, (0.0, SIDE.1), 1.0)
}

//! Balloons: numbered circles with a leader to each part of a drawing, beside the parts where there is room, clear of labels and of each other.

use core::fmt::Write;

use super::drawing::crosses;
use super::letters::LETTER_BOX;
use super::look::Paint;
use super::parts::DrawnPart;
use super::scene::{Font, LETTER, LINE, Node, Placement, Pose, Scene, SceneGroup, Shape};
use crate::math::{self, PI};
use crate::text::columns;
use crate::text::number::fill;

/// Radius of a balloon, radius of the dot at the end of its leader, and least gap to labels and other balloons, in letter sizes.
const RADIUS: f64 = 0.8;
const DOT: f64 = 0.14;
const GAP: f64 = 0.25;
/// Distances of a balloon from its part in the search for a place: the first, the step, the number, in letter sizes; and the number of
/// directions.
const FIRST: f64 = 2.2;
const STEP: f64 = 0.7;
const DISTANCES: u32 = 40;
const DIRECTIONS: u32 = 32;
/// Number of distances within which a balloon leaves the solid shapes of the drawing free; farther away it lies on them.
const BESIDE: u32 = 14;
/// Share of the drawing's width and height from which a shape is a background, on which balloons may lie.
const BACKGROUND: f64 = 0.5;

/// A balloon in the drawing's coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Balloon {
    /// Item number.
    pub item: u32,
    /// Centre.
    pub at: (f64, f64),
    /// Radius.
    pub radius: f64,
    /// End of its leader, on the part.
    pub part: (f64, f64),
}

/// Left, top, right, bottom.
type Area = [f64; 4];

impl Balloon {
    /// Bounding square: left, top, right, bottom.
    pub fn area(&self) -> Area {
        let ((x, y), r) = (self.at, self.radius);
        [x - r, y - r, x + r, y + r]
    }

    /// Start of its leader, at the edge of the circle.
    pub fn edge(&self) -> (f64, f64) {
        let (dx, dy) = (self.part.0 - self.at.0, self.part.1 - self.at.1);
        let share = self.radius / math::hypot(dx, dy).max(self.radius);
        (self.at.0 + dx * share, self.at.1 + dy * share)
    }
}

fn grown([left, top, right, bottom]: Area, by: f64) -> Area {
    [left - by, top - by, right + by, bottom + by]
}

fn overlap(a: Area, b: Area) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

/// Whether two lines cross.
fn cross((a, b): ((f64, f64), (f64, f64)), (c, d): ((f64, f64), (f64, f64))) -> bool {
    let side = |p: (f64, f64), q: (f64, f64), r: (f64, f64)| (q.0 - p.0) * (r.1 - p.1) - (q.1 - p.1) * (r.0 - p.0);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

/// A group in a pose.
fn placed<'s>(scene: &'s Scene, pose: &Pose, group: u16) -> Option<(&'s SceneGroup, Placement)> {
    let rest = scene.groups.get(usize::from(group))?;
    let opacity = f64::from(u8::from(!rest.hidden));
    let moved = pose.placements.iter().find(|place| place.group == group).copied();
    Some((rest, moved.unwrap_or(Placement { opacity, ..Placement::of(group) })))
}

/// A point of a group in the drawing, drawing units per unit of the group, and whether the group is visible.
fn point(scene: &Scene, pose: &Pose, group: u16, at: (f64, f64)) -> ((f64, f64), f64, bool) {
    let ((mut x, mut y), mut scale, mut seen) = (at, 1.0, true);
    let mut group = group;
    // Ends also if groups form a circle.
    for _ in 0..scene.groups.len() {
        let Some((rest, place)) = placed(scene, pose, group).filter(|_| group != 0) else { break };
        (x, y) = (x * rest.scale * place.size.0 - place.cx, y * rest.scale * place.size.1 - place.cy);
        let (s, c) = math::sin_cos(place.turn * PI / 180.0);
        (x, y) = (x * c - y * s + place.cx, x * s + y * c + place.cy);
        (x, y) = (x + rest.at.0 + place.dx, y + rest.at.1 + place.dy);
        (scale, seen) = (scale * rest.scale, seen && place.opacity > 0.0);
        group = rest.parent;
    }
    ((x, y), scale, seen)
}

/// Area of a text's letters in a pose; `None` if it is not visible.
fn text_area(scene: &Scene, pose: &Pose, node: &Node) -> Option<Area> {
    let Shape::Text { x, y, anchor, text, line, font } = &node.shape else { return None };
    let posed = pose.texts.iter().find(|(id, _)| Some(*id) == node.id).map(|(_, text)| text);
    let count = columns(posed.unwrap_or(text));
    let ((x, y), scale, seen) = point(scene, pose, node.group, (*x, *y));
    let size = match font {
        Font::Engraved(size) => size * scale,
        _ => LETTER * scene.unit * scale,
    };
    (seen && count > 0).then(|| LETTER_BOX.area((x, y + line * LINE * size), *anchor, size, count))
}

/// Area of a filled shape in a pose; `None` for lines, paths, backgrounds, and shapes that are not visible.
fn solid_area(scene: &Scene, pose: &Pose, node: &Node) -> Option<Area> {
    let (x, y, half_width, half_height) = match node.shape {
        Shape::Circle { x, y, r } => (x, y, r, r),
        Shape::Ellipse { x, y, rx, ry } => (x, y, rx, ry),
        Shape::Rect { x, y, w, h, .. } => (x + 0.5 * w, y + 0.5 * h, 0.5 * w, 0.5 * h),
        Shape::Path { .. } | Shape::Text { .. } => return None,
    };
    let ((x, y), scale, seen) = point(scene, pose, node.group, (x, y));
    let (half_width, half_height) = (half_width * scale, half_height * scale);
    let [_, _, width, height] = scene.view;
    let background = 2.0 * half_width > BACKGROUND * width || 2.0 * half_height > BACKGROUND * height;
    let solid = seen && !background && node.look.fill != Paint::Clear && node.look.opacity > 0.5;
    solid.then_some([x - half_width, y - half_height, x + half_width, y + half_height])
}

/// Obstacles for a new balloon.
struct Taken {
    view: Area,
    texts: Vec<Area>,
    solids: Vec<Area>,
    parts: Vec<(f64, f64)>,
    balloons: Vec<Balloon>,
    /// Letter size.
    letter: f64,
}

impl Taken {
    /// Whether the circle of a balloon is within the drawing and covers nothing.
    fn has_room(&self, balloon: &Balloon) -> bool {
        let (own, gap) = (balloon.area(), GAP * self.letter);
        let within = own[0] > self.view[0] && own[1] > self.view[1] && own[2] < self.view[2] && own[3] < self.view[3];
        let inside =
            |at: &(f64, f64)| *at != balloon.part && at.0 > own[0] && at.0 < own[2] && at.1 > own[1] && at.1 < own[3];
        within
            && !self.texts.iter().any(|text| overlap(grown(*text, gap), own))
            && !self.balloons.iter().any(|other| overlap(grown(other.area(), gap), own))
            && !self.parts.iter().any(inside)
            && !self.balloons.iter().any(|other| crosses(other.edge(), other.part, grown(own, gap)))
    }

    /// Whether the leader of a balloon crosses no other balloon.
    fn leads_past(&self, balloon: &Balloon) -> bool {
        !self.balloons.iter().any(|other| crosses(balloon.edge(), balloon.part, other.area()))
    }

    /// Whether the leader of a balloon crosses no label and no other leader.
    fn leads_clear(&self, balloon: &Balloon) -> bool {
        let (from, to) = (balloon.edge(), balloon.part);
        !self.texts.iter().any(|text| crosses(from, to, *text))
            && !self.balloons.iter().any(|other| cross((from, to), (other.edge(), other.part)))
    }

    /// Whether a balloon covers no solid shape.
    fn lies_beside(&self, balloon: &Balloon) -> bool {
        !self.solids.iter().any(|solid| overlap(*solid, balloon.area()))
    }

    /// The nearest free place beside the solid shapes, or else on them. If no leader is clear of everything, one that at least crosses no
    /// balloon.
    fn place(&self, item: u32, part: (f64, f64)) -> Option<Balloon> {
        let radius = RADIUS * self.letter;
        let tries_to = |last: u32| {
            (0..last).flat_map(move |at| {
                let distance = (FIRST + STEP * f64::from(at)) * self.letter;
                (0..DIRECTIONS).map(move |turn| {
                    // From straight up, alternately to both sides.
                    let half = f64::from(turn.div_ceil(2)) * if turn % 2 == 0 { 1.0 } else { -1.0 };
                    let (s, c) = math::sin_cos(2.0 * PI * half / f64::from(DIRECTIONS) + 0.4);
                    Balloon { item, at: (part.0 + distance * s, part.1 - distance * c), radius, part }
                })
            })
        };
        let tries = || tries_to(DISTANCES);
        let free = |balloon: &Balloon| self.has_room(balloon) && self.leads_past(balloon);
        let clear = |balloon: &Balloon| free(balloon) && self.leads_clear(balloon);
        let beside = tries_to(BESIDE).find(|balloon| self.lies_beside(balloon) && clear(balloon));
        beside
            .or_else(|| tries().find(clear))
            .or_else(|| tries().find(free))
            .or_else(|| tries().find(|balloon| self.has_room(balloon)))
    }
}

/// Balloons of parts in a pose of their drawing, numbered from 1. A part without a free place has none.
pub fn balloons(scene: &Scene, pose: &Pose, parts: &[DrawnPart]) -> Vec<Balloon> {
    let [left, top, width, height] = scene.view;
    let letter = LETTER * if scene.unit > 0.0 { scene.unit } else { 1.0 };
    let view = grown([left, top, left + width, top + height], -0.3 * letter);
    let inside = |(x, y): (f64, f64)| (math::clamp(x, view[0], view[2]), math::clamp(y, view[1], view[3]));
    let places: Vec<(f64, f64)> = parts.iter().map(|part| inside(point(scene, pose, part.group, part.at).0)).collect();
    let texts = scene.nodes.iter().filter_map(|node| text_area(scene, pose, node)).collect();
    let solids = scene.nodes.iter().filter_map(|node| solid_area(scene, pose, node)).collect();
    let mut taken = Taken { view, texts, solids, parts: places.clone(), balloons: Vec::new(), letter };
    for (item, part) in (1..).zip(places) {
        let balloon = taken.place(item, part);
        taken.balloons.extend(balloon);
    }
    taken.balloons
}

/// Writes balloons, with the colours of lines and figures, and of the circle's fill.
pub(super) fn write(out: &mut String, balloons: &[Balloon], (ink, page): (&str, &str), letter: f64) {
    let _ = write!(out, "<g class=\"balloons\" stroke=\"{ink}\" fill=\"{page}\" text-anchor=\"middle\"");
    fill(out, " stroke-width=\"#\">", &[0.07 * letter]);
    for balloon in balloons {
        let (from, (x, y)) = (balloon.edge(), balloon.part);
        fill(out, "<path d=\"M# #L# #\" fill=\"none\"/>", &[from.0, from.1, x, y]);
        let _ = write!(out, "<circle fill=\"{ink}\"");
        fill(out, " cx=\"#\" cy=\"#\" r=\"#\"/>", &[x, y, DOT * letter]);
        let (x, y) = balloon.at;
        fill(out, "<circle cx=\"#\" cy=\"#\" r=\"#\"/>", &[x, y, balloon.radius]);
        let _ = write!(out, "<text class=\"value\" stroke=\"none\" fill=\"{ink}\"");
        fill(out, " x=\"#\" y=\"#\">", &[x, y + 0.35 * letter]);
        let _ = write!(out, "{}</text>", balloon.item);
    }
    out.push_str("</g>");
}

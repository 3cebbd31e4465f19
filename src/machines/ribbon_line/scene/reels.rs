//! Supply and take-up reel: stand, flange, the wound ribbon that shrinks and grows, and the hub.

use super::layout::{CORE, DrawnReel, Layout};
use super::parts::group;
use super::stations::DEEP;
use crate::text::number::{fill, filled};
use crate::view::drawing::barrel;
use crate::view::look::{Gradient, Ramp};
use crate::view::{Drawing, Look, Paint, SceneGroup};

/// Paints of wound ribbon: its body in depth, and its face.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wound {
    body: Paint,
    face: Paint,
}

/// Distance of two rings of the drawn winding at the plain size: there are too many turns to show each.
const RING: f64 = 6.0;

impl Wound {
    /// Adds the gradients to a drawing.
    pub(crate) fn new(drawing: &mut Drawing) -> Wound {
        use Paint::{Ribbon, RibbonLight, RibbonShade};
        let body = Gradient {
            ramp: Ramp::Between([-50.0, -120.0, 70.0, 110.0]),
            stops: vec![(0.0, RibbonLight, 1.0), (0.35, Ribbon, 1.0), (0.85, RibbonShade, 1.0)],
        };
        let face = Gradient {
            ramp: Ramp::Rings([0.0, 0.0, RING]),
            stops: vec![(0.1, Ribbon, 1.0), (0.72, RibbonLight, 1.0), (1.0, RibbonShade, 1.0)],
        };
        Wound { body: drawing.gradient(body), face: drawing.gradient(face) }
    }
}

/// Rings of a drawn winding at most: a reel that is large beside its machine has them further apart.
const RINGS: f64 = 40.0;

/// A spiral as half circles about two centres, from the core to a radius.
fn spiral(core: f64, radius: f64) -> String {
    let half = 0.5 * RING.max((radius - core) / RINGS);
    let mut d = filled("M# 0", &[core]);
    let mut x = core;
    let mut way = -1.0;
    while x < radius - 1.0 {
        let next = x + half;
        let r = 0.5 * (x + next);
        fill(&mut d, "A# # 0 0 1 # 0", &[r, r, way * next]);
        (x, way) = (next, -way);
    }
    d
}

/// Groups of the supply reel and of the take-up reel: at rest, body, face, hub.
pub(crate) const SUPPLY: [u16; 4] = [group::REEL, group::REEL_BODY, group::REEL_FACE, group::REEL_HUB];
pub(crate) const TAKE_UP: [u16; 4] = [group::TAKE_UP, group::TAKE_UP_BODY, group::TAKE_UP_FACE, group::TAKE_UP_HUB];

/// Stand, flange and body.
pub(crate) fn behind(drawing: &mut Drawing, layout: &Layout, reel: &DrawnReel, groups: [u16; 4], wound: Wound) {
    let [frame, body, face, hub] = groups;
    let scale = layout.scale;
    drawing.place(frame, SceneGroup { at: (reel.x, reel.y), scale, ..SceneGroup::default() });
    for group in [body, face] {
        drawing.place(group, SceneGroup { parent: frame, ..SceneGroup::default() });
    }
    let hub_scale = reel.core / (CORE * scale);
    drawing.place(hub, SceneGroup { parent: frame, scale: hub_scale, ..SceneGroup::default() });
    let (radius, flange, h) = (reel.r / scale, reel.range.1 / scale + 8.0, (layout.floor - reel.y) / scale);
    let (dx, dy) = DEEP;
    drawing.within(frame, |drawing| {
        let back = filled("M# #h22L# #h-15z", &[-2.0 + dx, 0.0, 36.0 + dx, h + dy]);
        drawing.path(back, Look::fill(Paint::DarkShade).faint(0.85));
        let legs = filled("M-14 0H14L34 #h-24L6 #H-6L-10 #h-24z", &[h, 0.55 * h, h]);
        drawing.path(legs, Look::fill(Paint::DarkFront).thin(Paint::Edge, 0.8));
        drawing.path(filled("M-12 20L-31 #", &[h - 6.0]), Look::RIM.faint(0.45));
        drawing.circle((dx, dy, flange), Look::fill(Paint::SteelShade));
        drawing.circle((dx - 1.6, dy + 1.0, flange), Look::line(Paint::Rim, 1.0).faint(0.5));
    });
    drawing.within(body, |drawing| {
        drawing.path(barrel((0.0, 0.0), radius, (0.86 * dx, 0.86 * dy)), Look::fill(wound.body));
    });
}

/// The face of the wound ribbon.
pub(crate) fn face(drawing: &mut Drawing, layout: &Layout, reel: &DrawnReel, [_, _, face, _]: [u16; 4], wound: Wound) {
    let radius = reel.r / layout.scale;
    drawing.within(face, |drawing| {
        drawing.circle((0.0, 0.0, radius), Look::fill(wound.face));
        drawing.path(spiral(reel.core / layout.scale, radius), Look::line(Paint::RibbonShade, 0.9).faint(0.75));
        drawing.circle((0.0, 0.0, radius), Look::line(Paint::RibbonShade, 1.6));
    });
}

/// The hub in the core.
pub(crate) fn hub(drawing: &mut Drawing, [_, _, _, hub]: [u16; 4]) {
    drawing.within(hub, |drawing| {
        drawing.circle((0.0, 0.0, CORE), Look::DARK_FACE);
        drawing.circle((0.0, 0.0, 27.0), Look::FACE);
        for turn in 0..3 {
            let d = window(120.0 * f64::from(turn));
            drawing.path(d, Look::HOLE);
        }
        drawing.circle((0.0, 0.0, 7.0), Look::DARK_FACE);
    });
}

/// An opening of the hub between two spokes, turned by degrees.
fn window(degrees: f64) -> String {
    let at = |angle: f64, r: f64| crate::view::drawing::polar((0.0, 0.0), angle + degrees, r);
    let [a, b, c, d] = [at(-128.0, 23.0), at(-52.0, 23.0), at(-62.0, 10.0), at(-118.0, 10.0)];
    filled("M# #A23 23 0 0 1 # #L# #A10 10 0 0 0 # #z", &[a.0, a.1, b.0, b.1, c.0, c.1, d.0, d.1])
}

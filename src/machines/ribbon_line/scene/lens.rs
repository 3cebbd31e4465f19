//! The lens at the point of contact: head, dots and their smear, magnified.

use super::layout::{LENS, Layout};
use super::parts::{group, node};
use crate::machines::ribbon_line::params::Params;
use crate::math::{self, PI};
use crate::text::number::filled;
use crate::view::{Drawing, Look, Paint, SceneGroup, Shape};

/// Height of the ribbon's upper edge and of its near edge in the lens, drawn with a radius of 80.
const SURFACE: f64 = -16.0;
const NEAR: f64 = 16.0;
/// Middle of the row of dots.
const ROW: f64 = 0.0;

/// Least distance of dots that are drawn one by one.
const CLOSEST: f64 = 0.5;

/// Scale and sizes of the lens, in the units of its own drawing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Lens {
    /// Units per mm of ribbon.
    pub(crate) per_mm: f64,
    /// Length of contact, diameter of a dot.
    pub(crate) dot: f64,
    /// Length of the smear.
    pub(crate) smear: f64,
    pub(crate) pitch: f64,
    /// Radius of the print roller over its heads.
    pub(crate) roller: f64,
}

impl Lens {
    pub(crate) fn new(layout: &Layout, p: &Params, smear: f64) -> Lens {
        let per_mm = layout.magnified * LENS / layout.lens.2;
        let least = 0.5;
        Lens {
            per_mm,
            dot: math::clamp(p.contact_length * per_mm, least, 22.0),
            smear: math::clamp(smear * per_mm, 0.0, 2.0 * LENS),
            pitch: p.pitch * per_mm,
            roller: 0.5 * p.print_roller_diameter * per_mm,
        }
    }

    /// Horizontal position of the point of contact from the middle of the lens.
    pub(crate) const CONTACT: f64 = -26.0;

    /// Centre of the print roller from the point of contact, down.
    pub(crate) fn centre(&self) -> f64 {
        ROW - self.roller
    }

    /// The row of dots up to a length from the point of contact, as `d`.
    pub(crate) fn row(&self, length: f64) -> String {
        filled("M0 #H#", &[ROW, math::clamp(length * self.per_mm, 0.1, 2.0 * LENS)])
    }
}

/// The lens with its leader to the point of contact.
pub(crate) fn lens(drawing: &mut Drawing, layout: &Layout, p: &Params, smear: f64, smears: bool) {
    let (x, y, r) = layout.lens;
    let own = Lens::new(layout, p, smear);
    let clip = Shape::Circle { x: 0.0, y: 0.0, r: LENS - 1.0 };
    drawing.place(group::LENS, SceneGroup { at: (x, y), scale: r / LENS, clip: Some(clip), ..SceneGroup::default() });
    let inner = SceneGroup { parent: group::LENS, at: (Lens::CONTACT, 0.0), ..SceneGroup::default() };
    drawing.place(group::LENS_HEADS, inner.clone());
    drawing.place(group::LENS_DOTS, inner);

    let (cx, ring) = (layout.print.x, 15.0 * layout.scale);
    let (dx, dy) = (x - cx, y);
    let away = math::hypot(dx, dy);
    let (from, to) = (ring / away, 1.0 - r / away);
    drawing.circle((cx, 0.0, ring), Look::POINTER);
    drawing
        .path(filled("M# #L# #", &[cx + from * dx, from * dy, cx + to * dx, to * dy]), Look::hair(Paint::Accent, 1.0));

    drawing.circle((x, y, r), Look::fill(Paint::Glass));
    drawing.showing("contact-length", |drawing| inside(drawing, &own, p));
    drawing.circle((x, y, r), Look::line(Paint::SkyHigh, 4.0 * layout.scale));
    if smears {
        // The smear of the dot that is being printed, marked below the ribbon.
        let left = x + Lens::CONTACT * r / LENS;
        let right = left + (own.smear * r / LENS).min(1.2 * r);
        let (top, bottom) = (y + (NEAR + 6.0) * r / LENS, y + (NEAR + 12.0) * r / LENS);
        let d =
            filled("M# #V#M# #V#M# #H#", &[left, top, bottom, right, top, bottom, left, 0.5 * (top + bottom), right]);
        drawing.path(d, Look::hair(Paint::Bad, 1.2));
    }
}

fn inside(drawing: &mut Drawing, own: &Lens, p: &Params) {
    drawing.within(group::LENS, |drawing| {
        let thick = math::clamp(p.ribbon_thickness * own.per_mm, 1.0, 14.0);
        drawing.rect([-90.0, NEAR + thick, 180.0, 90.0, 0.0], Look::fill(Paint::GlassDeep));
        drawing.rect([-90.0, SURFACE - 4.0, 180.0, NEAR - SURFACE + 4.0, 0.0], Look::fill(Paint::Ribbon));
        drawing.path(filled("M-90 #h180", &[SURFACE - 3.0]), Look::line(Paint::RibbonLight, 2.0));
        drawing.rect([-90.0, NEAR, 180.0, thick, 0.0], Look::fill(Paint::RibbonShade));
    });
    drawing.within_hidden(group::LENS_DOTS, |drawing| {
        let row = |look: Look, long: f64| {
            if own.pitch > CLOSEST { look.dashed(long, (own.pitch - long).max(0.0)) } else { look.faint(0.5) }
        };
        if own.smear > 0.0 {
            let smear = row(Look::line(Paint::Black, own.dot).faint(0.5), own.smear);
            drawing.path(own.row(0.0), smear).id = Some(node::LENS_SMEAR);
        }
        drawing.path(own.row(0.0), row(Look::line(Paint::Black, own.dot).round(), 0.02)).id = Some(node::LENS_DOTS);
    });
    drawing.within(group::LENS_HEADS, |drawing| {
        // A head at the contact, and the next one that comes.
        for head in 0..2 {
            // They move to the right below the roller, so that the next one is at the left.
            let turn = -2.0 * PI * f64::from(head) / p.heads.max(1.0);
            let (s, c) = math::sin_cos(turn);
            let at = |aside: f64, up: f64| {
                // A holder ends short of the centre of a small roller.
                let along = own.roller - up.min(0.85 * own.roller);
                (along * s + aside * c, along * c - aside * s - own.roller + ROW)
            };
            let (tip, wide) = (0.5 * own.dot.max(7.0), own.dot.max(7.0) + 10.0);
            let outline = |points: &[(f64, f64)]| {
                let points: Vec<(f64, f64)> = points.iter().map(|(aside, up)| at(*aside, *up)).collect();
                crate::view::drawing::polygon(&points)
            };
            let holder = [
                (-tip - 1.5, 8.0),
                (-tip - 2.5, 36.0),
                (-0.6 * wide, 52.0),
                (-0.6 * wide, 120.0),
                (0.6 * wide, 120.0),
                (0.6 * wide, 52.0),
                (tip + 2.5, 36.0),
                (tip + 1.5, 8.0),
            ];
            drawing.path(outline(&holder), Look::fill(Paint::DarkFront).thin(Paint::Edge, 0.6));
            let stamp = [(-tip, 0.0), (-tip - 1.5, 8.0), (tip + 1.5, 8.0), (tip, 0.0)];
            drawing.path(outline(&stamp), Look::fill(Paint::Accent));
            drawing.path(outline(&[(-0.45 * wide, 56.0), (-0.45 * wide, 110.0)]), Look::RIM.faint(0.5));
        }
    });
}

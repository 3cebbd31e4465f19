//! Print roller with its heads, its back-up, and the deflection roller behind it.

use super::layout::{Layout, PRINT_ROLLER, Station};
use super::parts::group;
use super::stations::{cabinet, plate};
use crate::machines::ribbon_line::params::Params;
use crate::math::{self, PI};
use crate::text::number::{fill, filled};
use crate::view::drawing::{barrel, polar};
use crate::view::{Anchor, Drawing, Font, Look, Paint, SceneGroup};

/// Heads that are drawn one by one; more are drawn as a dashed ring.
const SINGLE: f64 = 60.0;

/// Radius of the print roller's body and of its heads, drawn with 60 over the heads.
const BODY: f64 = 44.0;

/// Plate, cabinet, motor, back-up, body of the roller and of the deflection roller.
pub(crate) fn behind(drawing: &mut Drawing, layout: &Layout, letter: &str) {
    let Station { x, r, scale, cabinet: top } = layout.print;
    drawing.place(group::PRINT_UNIT, SceneGroup { at: (x, 0.0), scale, ..SceneGroup::default() });
    let (size, depth) = (r / PRINT_ROLLER, layout.depth);
    let frame = SceneGroup { at: (x, -r), scale: size, ..SceneGroup::default() };
    drawing.place(group::PRINT_FRAME, frame);
    drawing.within(group::PRINT_UNIT, |drawing| {
        let (under, h) = (0.5 * layout.thickness / scale + 1.5, (layout.floor - top) / scale);
        plate(drawing, -23.0, 96.0, -2.0 * r / scale - 16.0, layout.floor / scale);
        cabinet(drawing, [-39.0, 88.0, 82.0, h], Paint::CabinetFront, Paint::SteelLight, Paint::SteelShade);
        let joint = Look::HAIR.faint(0.45);
        drawing.rect([-31.0, 96.0, 66.0, h - 18.0, 2.0], joint);
        drawing.path(filled("M-31 #h66", &[88.0 + 0.45 * h]), joint);
        drawing.rect([26.0, 88.0 + 0.52 * h, 4.0, 24.0, 2.0], Look::fill(Paint::DarkFront).thin(Paint::Edge, 0.5));
        drawing.rect([-27.0, 102.0, 24.0, 13.0, 1.5], Look::fill(Paint::SteelLight).thin(Paint::Edge, 0.5));
        drawing.text((-15.0, 112.2), Anchor::Middle, letter, Font::Engraved(10.0), Paint::Dark);
        drawing.rect([-39.0, 84.0 + h, 82.0, 4.0, 0.0], Look::fill(Paint::DarkShade));
        // Back-up below the contact.
        cabinet(drawing, [-12.0, 16.0, 24.0, 72.0], Paint::DarkFront, Paint::DarkLight, Paint::DarkShade);
        cabinet(drawing, [-34.0, under, 68.0, 17.0 - under], Paint::DarkFront, Paint::DarkLight, Paint::DarkShade);
    });
    drawing.path(
        barrel((x + 2.0 * depth.0, -r + 2.0 * depth.1), 0.34 * r, (0.5 * depth.0, 0.5 * depth.1)),
        Look::fill(Paint::DarkBar),
    );
    drawing.path(barrel((x, -r), r * BODY / PRINT_ROLLER, depth), Look::fill(Paint::SteelBody));
    let (x, y, r) = layout.deflector;
    drawing.path(barrel((x, y), r, depth), Look::fill(Paint::SteelBody));
}

/// Width of a head: no more than its share of the circumference.
fn head_width(heads: f64) -> f64 {
    (0.6 * 2.0 * PI * BODY / heads).min(16.0)
}

/// All heads as two outlines, holders and tips; head 0 points down at the ribbon.
fn heads(count: f64) -> [String; 2] {
    let half = 0.5 * head_width(count);
    let mut outlines = [String::new(), String::new()];
    for head in 0..count as u32 {
        let (s, c) = math::sin_cos(PI / 2.0 + 2.0 * PI * f64::from(head) / count);
        let at = |along: f64, aside: f64| (along * c - aside * s, along * s + aside * c);
        let rings = [
            [(BODY - 3.0, 1.0), (50.0, 1.0), (55.0, 0.62)],
            [(55.0, 0.62), (PRINT_ROLLER, 0.56), (PRINT_ROLLER, 0.56)],
        ];
        for (d, ring) in outlines.iter_mut().zip(rings) {
            let right = ring.iter().map(|(along, wide)| at(*along, wide * half));
            let left = ring.iter().rev().map(|(along, wide)| at(*along, -wide * half));
            for (point, (x, y)) in right.chain(left).enumerate() {
                fill(d, if point == 0 { "M# #" } else { "L# #" }, &[x, y]);
            }
            d.push('Z');
        }
    }
    outlines
}

/// Draws the heads: each by its outlines, where they are few enough, else as dashed rings.
fn draw_heads(drawing: &mut Drawing, count: f64, outlines: Option<&[String; 2]>, holder: Paint, tip: Paint) {
    if let Some([holders, tips]) = outlines {
        drawing.path(holders.as_str(), Look::fill(holder));
        drawing.path(tips.as_str(), Look::fill(tip));
        return;
    }
    if holder == tip {
        drawing.circle((0.0, 0.0, 51.0), Look::line(holder, 18.0));
        return;
    }
    for (r, width, paint) in [(48.5, 13.0, holder), (57.5, 5.0, tip)] {
        let pitch = 2.0 * PI * r / count;
        drawing.circle((0.0, 0.0, r), Look::line(paint, width).dashed(0.55 * pitch, 0.45 * pitch));
    }
}

/// The roller with its heads in front of the ribbon.
pub(crate) fn before(drawing: &mut Drawing, layout: &Layout, p: &Params) {
    let size = layout.print.r / PRINT_ROLLER;
    let depth = (layout.depth.0 / size, layout.depth.1 / size);
    for layer in 0..group::LAYERS {
        // From the far end of the heads to their near one.
        let share = 0.78 - 0.66 * f64::from(layer) / f64::from(group::LAYERS - 1);
        let carrier = group::PRINT_LAYERS + 2 * layer;
        let at = (share * depth.0, share * depth.1);
        drawing.place(carrier, SceneGroup { parent: group::PRINT_FRAME, at, ..SceneGroup::default() });
        drawing.place(carrier + 1, SceneGroup { parent: carrier, ..SceneGroup::default() });
    }
    for group in [group::PRINT, group::PRINT_BLUR] {
        drawing.place(group, SceneGroup { parent: group::PRINT_FRAME, ..SceneGroup::default() });
    }
    let count = math::clamp(p.heads, 1.0, 1000.0);
    // Every layer has the same outlines.
    let outlines = (count <= SINGLE).then(|| heads(count));
    drawing.showing("heads", |drawing| {
        for layer in 0..group::LAYERS {
            let near = layer + 1 == group::LAYERS;
            let (holder, tip) = if near { (Paint::Dark, Paint::Accent) } else { (Paint::DarkShade, Paint::DarkShade) };
            drawing.within(group::PRINT_LAYERS + 2 * layer + 1, |drawing| {
                draw_heads(drawing, count, outlines.as_ref(), holder, tip);
            });
        }
        drawing.within_hidden(group::PRINT_BLUR, |drawing| {
            drawing.circle((0.0, 0.0, 52.0), Look::line(Paint::DarkLight, 15.0).faint(0.8));
            drawing.circle((0.0, 0.0, 58.0), Look::line(Paint::Accent, 4.0).faint(0.6));
        });
    });
    drawing.showing("print-roller-diameter", |drawing| {
        drawing.within(group::PRINT_FRAME, |drawing| {
            drawing.circle((0.0, 0.0, BODY), Look::FACE);
            drawing.circle((0.0, 0.0, 38.0), Look::HAIR.faint(0.35));
            drawing.circle((0.0, 0.0, 30.0), Look::line(Paint::DarkLight, 1.0));
            drawing.circle((0.0, 0.0, 11.0), Look::DARK_FACE);
        });
        drawing.within(group::PRINT, |drawing| {
            for hole in 0..3 {
                let (x, y) = polar((0.0, 0.0), 120.0 * f64::from(hole) - 90.0, 22.0);
                drawing.circle((x, y, 5.0), Look::HOLE);
            }
            drawing.path("M0 -10v6", Look::line(Paint::Rim, 1.8).round());
            drawing.text((0.0, 38.0), Anchor::Middle, "1", Font::Engraved(9.0), Paint::Dark);
        });
        drawing.within(group::PRINT_FRAME, |drawing| {
            drawing.path("M-40 -14A42 42 0 0 1 0 -42", Look::RIM);
            drawing.circle((0.0, 0.0, PRINT_ROLLER), Look::LEAD.dashed(3.0, 4.0).faint(0.7));
        });
    });
}

/// The face of the deflection roller, drawn with a radius of 18.
pub(crate) fn deflector(drawing: &mut Drawing, layout: &Layout) {
    let (x, y, r) = layout.deflector;
    drawing.place(group::DEFLECTOR, SceneGroup { at: (x, y), scale: r / 18.0, ..SceneGroup::default() });
    drawing.place(group::DEFLECTOR_MARKS, SceneGroup { parent: group::DEFLECTOR, ..SceneGroup::default() });
    drawing.within(group::DEFLECTOR, |drawing| {
        drawing.circle((0.0, 0.0, 18.0), Look::FACE);
    });
    drawing.within(group::DEFLECTOR_MARKS, |drawing| {
        drawing.circle((0.0, 0.0, 6.0), Look::HOLE);
        drawing.path("M0 -15v8", Look::line(Paint::Edge, 1.8).round());
    });
}

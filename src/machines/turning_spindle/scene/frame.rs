//! Fixed parts: floor, bed with its chip tray behind the front, headstock with the gate of the gear stages, tailstock.

use super::ids::{group, node};
use super::layout::{BED, Layout, TAIL};
use super::solid::AXIS;
use crate::machines::sheets::say;
use crate::machines::turning_spindle::params::Params;
use crate::text::number::filled;
use crate::view::drawing::Drawing;
use crate::view::letters::Anchor;
use crate::view::look::{Look, Paint};
use crate::view::scene::{Font, SceneGroup};

/// Right end and top of the headstock.
pub(super) const HEAD: (f64, f64) = (206.0, 222.0);
/// Centre of the gate.
const GATE: (f64, f64) = (100.0, 352.0);
/// Columns and rows of the gate from its centre.
const SLOTS: (f64, f64) = (28.0, 27.0);

/// Floor, feet of the bed, and its chip tray.
pub(super) fn draw_bed_back(drawing: &mut Drawing) {
    drawing.rect([-3000.0, 546.0, 7000.0, 900.0, 0.0], Look::fill(Paint::Floor));
    drawing.ellipse((500.0, 596.0), (660.0, 20.0), Look::fill(Paint::GroundShade));
    for x in [-70.0, 790.0] {
        drawing.path(
            filled("M# #h310l-14 34h-282Z", &[x, BED + 62.0]),
            Look::fill(Paint::DarkFront).thin(Paint::Edge, 1.0),
        );
    }
    // Tray between the feet.
    drawing.path(filled("M244 #h540l-16 26h-508Z", &[BED + 40.0]), Look::fill(Paint::DarkShade));
    drawing.path(filled("M250 #h528l-18 24h-492Z", &[BED + 38.0]), Look::fill(Paint::DarkShade));
}

/// Ways and front of the bed, with the opening to the chip tray; falling chips are drawn behind both.
pub(super) fn draw_bed_front(drawing: &mut Drawing) {
    let (top, opening) = (BED + 28.0, BED + 38.0);
    // The opening has the opposite direction of the outline, so it is not filled.
    drawing
        .path(filled("M-400 #H1400v36H-400ZM250 #l18 24h492l18 -24Z", &[top, opening]), Look::fill(Paint::SteelShade));
    drawing.rect([-400.0, BED, 1800.0, 30.0, 0.0], Look::fill(Paint::SteelBar));
    drawing.rect([-400.0, BED - 9.0, 1800.0, 10.0, 0.0], Look::fill(Paint::SteelLight));
    drawing.path(
        filled("M-400 #H1400M-400 #H1400M-400 #H1400", &[BED + 1.0, BED + 29.0, BED + 64.0]),
        Look::HAIR.faint(0.5),
    );
}

/// The tailstock that holds the work.
pub(super) fn draw_tailstock(drawing: &mut Drawing, layout: &Layout) {
    if !layout.holds_work {
        return;
    }
    let top = AXIS - 62.0;
    // The quill ends where its centre begins.
    let end = layout.face + CENTRE.1;
    drawing.showing("tailstock", |drawing| {
        drawing.path(filled("M# #H#v44H#l-22 -16v-12Z", &[end, AXIS - 22.0, TAIL, end]), Look::fill(Paint::SteelBar));
        drawing.path(
            filled("M# #h150V#H#V#q0 -14 14 -14Z", &[TAIL + 14.0, top, BED - 9.0, TAIL, top + 14.0]),
            Look::fill(Paint::CabinetFront).thin(Paint::Edge, 1.0),
        );
        drawing.path(filled("M# #h90", &[TAIL, AXIS + 44.0]), Look::HAIR.faint(0.2));
    });
}

/// The point of the tailstock's centre in the face of the work; `radius` is that of the finished face, in units of the drawing.
pub(super) fn draw_centre(drawing: &mut Drawing, layout: &Layout, radius: f64) {
    if !layout.holds_work {
        return;
    }
    let (depth, length) = CENTRE;
    // Thinner than the face, so that the tool passes beside it.
    let half = (0.5 * radius).min(CENTRE_RADIUS);
    drawing.showing("tailstock", |drawing| {
        let places =
            [layout.face - depth, AXIS, layout.face, AXIS - half, layout.face + length, half, half, layout.face];
        drawing.path(filled("M# #L# #H#v#v#H#Z", &places), Look::FACE);
    });
}

/// Length of the tailstock's centre in the work, and from the face to the quill.
const CENTRE: (f64, f64) = (10.0, 64.0);
/// Greatest radius of the point.
const CENTRE_RADIUS: f64 = 12.0;

/// Headstock with door, name plate and gate.
pub(super) fn draw_headstock(drawing: &mut Drawing, p: &Params) {
    let (right, top) = HEAD;
    drawing.path(
        filled("M-80 #H#q20 0 20 20V#H-80Z", &[top, right - 20.0, BED - 9.0]),
        Look::fill(Paint::DarkFront).thin(Paint::Edge, 1.0),
    );
    drawing.path(filled("M-80 #H#q17 0 18 16", &[top + 1.5, right - 20.0]), Look::RIM.faint(0.7));
    drawing.path(
        filled("M# #V#h-12V#q0 -16 -8 -20q20 0 20 22Z", &[right, top + 22.0, BED - 9.0, top + 22.0]),
        Look::fill(Paint::DarkShade),
    );
    // Door with hinges and a handle.
    drawing.rect([-60.0, 424.0, 232.0, 58.0, 4.0], Look::fill(Paint::DarkFront).thin(Paint::DarkShade, 1.0));
    drawing.path("M170 434v8M170 464v8", Look::line(Paint::DarkShade, 3.0));
    drawing.rect([8.0, 438.0, 9.0, 30.0, 4.5], Look::fill(Paint::SteelBar).thin(Paint::Edge, 0.8));
    drawing.rect([36.0, 442.0, 118.0, 22.0, 2.0], Look::fill(Paint::Steel).thin(Paint::Edge, 0.8));
    drawing.text((95.0, 457.0), Anchor::Middle, &say("turning.name"), Font::Engraved(11.5), Paint::Black);
    gate(drawing, p);
}

/// Position of the shift lever's knob in a gear stage (from 1), from the centre of the gate; in the middle during a shift.
pub(in super::super) fn knob(stage: u8, is_shifting: bool, stages: usize) -> (f64, f64) {
    if stages < 2 {
        return (0.0, 0.0);
    }
    let column = if stages == 2 { 0.0 } else { SLOTS.0 * if stage > 2 { 1.0 } else { -1.0 } };
    (column, if is_shifting { 0.0 } else { SLOTS.1 * if stage % 2 == 1 { -1.0 } else { 1.0 } })
}

/// The gate: a slot and a figure for every stage, and the lever with its knob.
fn gate(drawing: &mut Drawing, p: &Params) {
    let (x, y) = GATE;
    let fields = ["stage-1", "stage-2", "stage-3", "stage-4"];
    let count = p.stages().count();
    drawing.rect([x - 62.0, y - 55.0, 124.0, 110.0, 5.0], Look::fill(Paint::DarkShade).faint(0.6));
    for (stage, field) in (1..=count as u8).zip(fields) {
        let (dx, dy) = knob(stage, false, count);
        drawing.showing(field, |drawing| {
            drawing.path(filled("M# #V#", &[x + dx, y, y + dy]), Look::line(Paint::Black, 10.0).round());
            let (aside, low) = if count == 1 { (-34.0, 5.0) } else { (if dx > 0.0 { 20.0 } else { -20.0 }, 5.0) };
            let text = stage.to_string();
            drawing.text((x + dx + aside, y + dy + low), Anchor::Middle, &text, Font::Engraved(14.0), Paint::Rim);
        });
    }
    if count > 2 {
        drawing.path(filled("M# #H#", &[x - SLOTS.0, y, x + SLOTS.0]), Look::line(Paint::Black, 10.0).round());
    }
    drawing.circle((x, y, 9.0), Look::DARK_FACE);
    drawing.path(String::new(), Look::line(Paint::SteelLight, 7.0).round()).id = Some(node::LEVER);
    drawing.place(group::KNOB, SceneGroup { at: GATE, ..SceneGroup::default() });
    drawing.within(group::KNOB, |drawing| {
        drawing.circle((0.0, 0.0, 12.0), Look::fill(Paint::Black));
        drawing.path("M-6 -5a8 8 0 0 1 6 -4", Look::RIM);
    });
}

/// The lever from the middle of the gate to its knob.
pub(in super::super) fn lever((dx, dy): (f64, f64)) -> String {
    filled("M# #l# #", &[GATE.0, GATE.1, dx, dy])
}

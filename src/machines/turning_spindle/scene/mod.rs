//! The drawing of the turning spindle, seen by the operator a little from the right: headstock with its instruments, chuck, part, turret.
//!
//! Part, chuck jaws and ways of the tool are to one scale. Headstock, turret and tailstock take the room that there is: the form does not
//! have their sizes.

mod chuck;
mod driven_tool;
mod frame;
mod ids;
mod instruments;
mod layout;
mod lens;
mod solid;
mod turret;
mod work;

use super::params::{Params, Path};
use super::resolved::TurningSpindle;
use crate::machines::sheets::say;
use crate::text::catalog::number_text as show;
use crate::text::number::filled;
use crate::text::{columns, units};
use crate::view::Scene;
use crate::view::drawing::{Callout, Drawing};
use crate::view::letters::{Anchor, LETTER_BOX};
use crate::view::look::{Look, Paint};
use crate::view::scene::{Font, LETTER, SceneGroup};
pub(super) use frame::{knob, lever};
pub(super) use ids::{group, node};
pub(super) use instruments::needles;
pub(super) use layout::Layout;
use layout::{UNIT, VIEW};
use solid::AXIS;
pub(super) use turret::pose_chips;

/// Paths of the part, and of its piece in the lens.
pub(super) use {
    driven_tool::pose as pose_tools, lens::AtTip, lens::pose as pose_lens, lens::texts as lens_texts, solid::arc,
    work::pose as pose_work, work::pose_groove, work::sections,
};

/// The drawing at rest.
pub(super) fn scene(lathe: &TurningSpindle) -> Scene {
    let p = &lathe.params;
    let layout = Layout::new(p);
    let mut drawing = Drawing::new(UNIT);
    frame::draw_bed_back(&mut drawing);
    turret::draw_carriage(&mut drawing);
    turret::draw_cross_slide(&mut drawing);
    frame::draw_tailstock(&mut drawing, &layout);
    layout.chuck.draw_nose(&mut drawing);
    frame::draw_headstock(&mut drawing, p);
    layout.chuck.draw_body(&mut drawing);
    work::draw(&mut drawing, lathe, &layout);
    frame::draw_centre(&mut drawing, &layout, layout.side(0.0, p.finished_diameter).1);
    layout.chuck.draw_near_jaws(&mut drawing);
    drawing.path(String::new(), Look::POINTER).id = Some(node::ORIENTATION);
    turret::draw_axis(&mut drawing);
    turret::draw_way(&mut drawing, p, &layout);
    drawing.path(String::new(), Look::LEAD).id = Some(node::TOOL_LEADER);
    drawing.draw_leaders_here();
    turret::draw(&mut drawing);
    if lathe.keyway().is_some() {
        driven_tool::draw(&mut drawing, p, &layout);
    }
    turret::draw_chips(&mut drawing);
    frame::draw_bed_front(&mut drawing);
    for (group, at) in [group::SPEED, group::NEEDLE].into_iter().zip(instruments::PIVOTS) {
        drawing.place(group, SceneGroup { at, ..SceneGroup::default() });
    }
    instruments::draw(&mut drawing, lathe);
    lens::draw(&mut drawing, lathe, &layout);
    labels(&mut drawing, lathe, &layout);
    drawing.stations =
        vec![("turning.station.spindle", 130.0), ("turning.station.work", 430.0), ("turning.station.turret", 860.0)];
    drawing.scene(VIEW, "turning.scene.alt")
}

/// Base line of the names in the row above the machine.
const ROW: f64 = 46.0;

/// Names, dimensions and live values; each has its own place at any sizes of the form.
fn labels(drawing: &mut Drawing, lathe: &TurningSpindle, layout: &Layout) {
    let p = &lathe.params;
    let mm = |value: f64| units::text(value, 3, "mm");
    let callout = |drawing: &mut Drawing,
                   field: &'static str,
                   at,
                   anchor,
                   id: &'static str,
                   values: &[(Option<u16>, &str)],
                   part| {
        drawing.showing(field, |drawing| drawing.callout(&Callout { at, anchor, name: &say(id), values, part }));
    };
    drawing.text((instruments::PANEL[0], 22.0), Anchor::Start, "", Font::Label, Paint::Dim).id = Some(node::BOUND);
    let (left, radius) = layout.side(-layout.part_length, p.stock_diameter);
    let middle = 0.45 * (left.max(layout.chuck.front()) + layout.face) + 0.1 * layout.face;
    callout(
        drawing,
        "stock-diameter",
        (STOCK, ROW),
        Anchor::Start,
        "turning.scene.stock",
        &[(None, &mm(p.stock_diameter))],
        Some((middle - 24.0, AXIS - radius)),
    );
    let (from, to) = (mm(p.finished_diameter), mm(p.large_diameter));
    let finished = [(None, from.as_str()), (None, to.as_str())];
    let count = if p.path == Path::Taper { 2 } else { 1 };
    let low = p.finished_diameter.min(p.stock_diameter);
    let end = layout.tip(0.5 * low, if p.path == Path::Facing { 0.0 } else { -0.2 * p.length });
    callout(
        drawing,
        "finished-diameter",
        (FINISHED, ROW),
        Anchor::Start,
        "turning.scene.finished",
        &finished[..count],
        Some(end),
    );
    // The diameter there is that of the slides: a third line would lie on the turret.
    callout(
        drawing,
        "cutting-speed",
        (TOOL, ROW),
        Anchor::Start,
        "turning.scene.surface",
        &[(Some(node::SURFACE), "")],
        None,
    );
    let allowance = if p.path == Path::Facing { "allowance" } else { "depth" };
    callout(drawing, allowance, (LEFT, ROW), Anchor::Start, "turning.scene.left", &[(Some(node::LEFT), "")], None);
    let place = |at: f64| show(at, if at < 1000.0 { 3 } else { 1 });
    let across = p.start_x * if lathe.x_counts_diameters() { 1.0 } else { 0.5 };
    let start = format!("{} X{} Z{}", say("turning.scene.start"), place(across), place(p.start_z));
    let clearance = format!("{} {}", say("turning.clearance"), mm(p.clearance));
    drawing.showing("start-x", |drawing| {
        drawing.text((START, TOP_ROW), Anchor::Start, &start, Font::Label, Paint::Dim);
    });
    drawing.showing("clearance", |drawing| {
        drawing.text((CLEARANCE, TOP_ROW), Anchor::End, &clearance, Font::Label, Paint::Dim);
    });
    let (name, values) = (say("turning.scene.slides"), [(Some(node::X), ""), (Some(node::Z), "")]);
    drawing.callout_with(
        &Callout { at: SLIDES, anchor: Anchor::Start, name: &name, values: &values, part: None },
        SLIDE_LETTERS,
    );
    if layout.holds_work {
        drawing.text((980.0, 478.0), Anchor::Middle, &say("turning.scene.tailstock"), Font::Engraved(13.0), Paint::Dim);
    }
    drawing.text((4.0, 250.0), Anchor::Start, "", Font::Label, Paint::Rim).id = Some(node::STAGE);
    drawing.text((4.0, 274.0), Anchor::Start, "", Font::Value, Paint::Rim).id = Some(node::STAGE_SPEED);
    if lathe.positions() {
        callout(
            drawing,
            "keyway-angle",
            (SLIDES.0, SLIDES.1 + 74.0),
            Anchor::Start,
            "turning.scene.angle",
            &[(Some(node::ANGLE), "")],
            None,
        );
    }
    length(drawing, p, layout);
}

/// Left ends of the labels in the row above the machine.
const STOCK: f64 = 291.0;
const FINISHED: f64 = 403.0;
const TOOL: f64 = 515.0;
const LEFT: f64 = 688.0;
/// The row above it, where the turret does not come, the left end of its first label, and the right end of its second.
const TOP_ROW: f64 = 20.0;
const START: f64 = 396.0;
const CLEARANCE: f64 = 830.0;
/// Place of the figures of the slides, between instruments and chuck where the slides never come, and its width for the
/// longest figure, `X -5 999.999`.
const SLIDES: (f64, f64) = (236.0, 104.0);
const SLIDE_LETTERS: usize = 12;
/// Begin of the leader of the label at the tool: below its two lines where the letters are largest, and under their first letters.
const LEADER: (f64, f64) = (TOOL + 26.0, ROW + 44.0);

/// Leader of the label at the tool to its tip; none where the tip has left the drawing.
pub(super) fn tool_leader((x, y): (f64, f64)) -> String {
    if x > VIEW[0] + VIEW[2] || y < LEADER.1 {
        return String::new();
    }
    filled("M# #L# #", &[LEADER.0, LEADER.1, x, y - 11.0])
}

/// The length of the cut along the part, or the allowance of a face.
fn length(drawing: &mut Drawing, p: &Params, layout: &Layout) {
    let (field, id, from, to) = match p.path {
        Path::Facing => ("allowance", "turning.scene.allowance", 0.0, p.allowance),
        _ => ("length", "turning.scene.length", -p.length, 0.0),
    };
    let (y, top) = (476.0, AXIS + 0.5 * p.stock_diameter * layout.scale);
    let (left, right) = (layout.face + from * layout.scale, layout.face + to * layout.scale);
    drawing.showing(field, |drawing| {
        // Arrows between the lines, or from outside where there is no room.
        let arrows = if right - left > 26.0 {
            filled("M# #H#M# #l-8 4l8 4M# #l8 4l-8 4", &[left, y, right, left + 8.0, y - 4.0, right - 8.0, y - 4.0])
        } else {
            filled(
                "M# #H#M# #H#M# #l8 4l-8 4M# #l-8 4l8 4",
                &[left - 22.0, y, left, right, y, right + 22.0, left - 8.0, y - 4.0, right + 8.0, y - 4.0],
            )
        };
        let ends = filled("M# #V#M# #V#", &[left, top + 4.0, y + 5.0, right, top + 4.0, y + 5.0]);
        drawing.path([arrows, ends].concat(), Look::LEAD);
        let text = format!("{} {}", say(id), units::text(to - from, 3, "mm"));
        let width = LETTER_BOX.width * LETTER * UNIT * columns(&text) as f64;
        // Between its lines, else at the left if there is room beside the chuck: the carriage stands at the right.
        let (at, anchor) = if right - left >= width {
            ((0.5 * (left + right), y - 6.0), Anchor::Middle)
        } else if left - 26.0 - width > layout.chuck.base_front() {
            ((left - 26.0, y + 5.0), Anchor::End)
        } else {
            ((right + 30.0, y + 5.0), Anchor::Start)
        };
        drawing.text(at, anchor, &text, Font::Label, Paint::Ink);
    });
}

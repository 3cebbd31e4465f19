//! The drawing of the polygon lathe: the machine from the front and from above, the sides against their planes, the section as the work sees it.
//!
//! Section and cutter are to one scale, the bar from above to another. The lens magnifies the deviation of the sides, with its factors in
//! it. The sizes of chuck, headstock and slide are not in the form.

mod cutter;
mod front;
mod ids;
mod layout;
mod lens;
mod side;
mod turning_tool;

use super::resolved::PolygonLathe;
use crate::machines::sheets::say;
use crate::text::catalog::number_text as show;
use crate::text::number::filled;
use crate::text::{columns as columns_of, units};
use crate::view::Scene;
use crate::view::drawing::{Callout, Drawing};
use crate::view::letters::{Anchor, LETTER_BOX};
use crate::view::look::{Look, Paint};
use crate::view::scene::{Font, LETTER, SceneGroup};
pub(super) use cutter::{distance, figure_at};
pub(super) use front::traces;
pub(super) use ids::{TIPS, group, node};
pub(super) use layout::Layout;
use layout::{UNIT, VIEW};
pub(super) use lens::{form, wanted};
pub(super) use side::{bar, edges, profile};

/// The drawing at rest.
pub(super) fn scene(lathe: &PolygonLathe) -> Scene {
    let layout = Layout::new(lathe);
    let mut drawing = Drawing::new(UNIT);
    front::draw_back(&mut drawing, lathe, &layout);
    cutter::draw_base(&mut drawing, lathe, &layout);
    front::draw_chuck(&mut drawing, lathe, &layout);
    front::draw_work(&mut drawing, lathe, &layout);
    cutter::draw(&mut drawing, lathe, &layout);
    if lathe.has_main_spindle() {
        turning_tool::draw(&mut drawing, lathe, &layout);
    }
    front::draw_arrows(&mut drawing, lathe, &layout);
    side::draw(&mut drawing, lathe, &layout);
    lens::draw(&mut drawing, lathe, &layout);
    lens::draw_close(&mut drawing, lathe, &layout);
    labels(&mut drawing, lathe, &layout);
    drawing.stations = vec![
        ("polygon.station.work", layout.work.0),
        ("polygon.station.cutter", layout.cutter.0),
        ("polygon.station.details", 860.0),
    ];
    drawing.scene(VIEW, "polygon.scene.alt")
}

/// Base line of the names over the machine, and of those below the lens.
const ROW: f64 = 80.0;
const LOW_ROW: f64 = 239.0;
/// Base lines of the heading of the view from above, and of the first figure of the slides below it.
const ABOVE: f64 = 331.0;
const SLIDES: f64 = 593.0;
/// Left ends of the two columns of details, under lens and section, and of the pass between them.
const DETAILS: [f64; 2] = [632.0, 820.0];
const PASS: f64 = 736.0;
/// Right end of the details.
const RIGHT: f64 = 1008.0;
/// Least left ends of the labels of work and cutter, and width of the former.
const WORK: f64 = 180.0;
const CUTTER: f64 = 350.0;
const WIDE: f64 = 165.0;
/// Distance of the cutter's leader to the left of its texts, beside which it begins.
const BESIDE: f64 = 8.0;

/// Left ends of the labels of work and cutter: right of the leader from the contact to the lens.
fn columns(lathe: &PolygonLathe, layout: &Layout) -> (f64, f64) {
    let contact = lathe.polygons().map(|polygon| layout.contact(polygon).0).fold(0.0, f64::max);
    let work = WORK.max(contact + 14.0);
    (work, CUTTER.max(work + WIDE))
}

/// Place and anchor of the label of the section: in its column, or at the right end where a long number of the pass reaches into the column.
fn beside_passes(lathe: &PolygonLathe) -> (f64, Anchor) {
    let passes: usize = lathe.polygons().map(|polygon| polygon.sizes.len()).sum();
    let longest = columns_of(&format!("{passes} / {passes}"));
    let end = PASS + LETTER_BOX.width * LETTER * UNIT * longest as f64;
    if end < DETAILS[1] { (DETAILS[1], Anchor::Start) } else { (RIGHT, Anchor::End) }
}

/// Names, dimensions and live values; each has its own place at any sizes of the form.
fn labels(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    let p = &lathe.params;
    let mm = |value: f64| units::text(value, 3, "mm");
    let callout =
        |drawing: &mut Drawing, field: &'static str, at, anchor, name: &str, values: &[(Option<u16>, &str)], part| {
            drawing.showing(field, |drawing| drawing.callout(&Callout { at, anchor, name, values, part }));
        };
    let chuck = (layout.work.0 + 0.72 * layout.chuck, layout.work.1 - 0.62 * layout.chuck);
    let (work, cutter) = columns(lathe, layout);
    callout(
        drawing,
        "speed",
        (work, ROW),
        Anchor::Start,
        &say("polygon.scene.work"),
        &[(Some(node::WORK_SPEED), "")],
        Some(chuck),
    );
    if lathe.has_main_spindle() {
        let (x, y) = layout.main_motor();
        let at = (x - layout::MAIN_MOTOR, y - layout::MAIN_MOTOR - 20.0);
        drawing.showing("main-power", |drawing| {
            drawing.text(at, Anchor::Start, &say("polygon.scene.main-motor"), Font::Label, Paint::Dim);
        });
    }
    drawing.path(String::new(), Look::LEAD).id = Some(node::LEADER);
    let (name, [across, radius]) = (say("polygon.scene.cutter"), sizes(lathe));
    let values = [(Some(node::TOOL_SPEED), ""), (Some(node::RADIUS), radius.as_str())];
    callout(drawing, "tip-radius", (cutter, ROW), Anchor::Start, &name, &values, None);
    let ahead = [(Some(node::PHASE), ""), (Some(node::STATE), "")];
    callout(drawing, "", (DETAILS[0], LOW_ROW), Anchor::Start, &say("polygon.scene.phase"), &ahead, None);
    callout(
        drawing,
        "depth",
        (PASS, LOW_ROW),
        Anchor::Start,
        &say("polygon.scene.pass"),
        &[(Some(node::PASS), "")],
        None,
    );
    let stock = format!("Ø {}", mm(p.stock_diameter));
    let values = [(Some(node::ACROSS), across.as_str()), (None, stock.as_str())];
    let (at, anchor) = beside_passes(lathe);
    callout(drawing, "across-flats", (at, LOW_ROW), anchor, &say("polygon.scene.close"), &values, None);
    drawing.text((DETAILS[0], ABOVE), Anchor::Start, &say("polygon.scene.above"), Font::Label, Paint::Dim);
    // Below the slide at any of its positions.
    side::draw_arrows(drawing, (DETAILS[0] + 14.0, SLIDES));
    drawing.text((DETAILS[0] + 38.0, SLIDES), Anchor::Start, "", Font::Value, Paint::Ink).id = Some(node::SIZE);
    drawing.text((DETAILS[0] + 38.0, SLIDES + 24.0), Anchor::Start, "", Font::Value, Paint::Ink).id = Some(node::ALONG);
    let start = format!("X{} Z{}", show(lathe.x_of(p.start_x), 3), show(p.start_z, 3));
    callout(drawing, "start-x", (RIGHT, 450.0), Anchor::End, &say("polygon.scene.start"), &[(None, &start)], None);
    drawing.showing("clearance", |drawing| {
        let text = format!("{} {}", say("polygon.clearance"), mm(p.clearance));
        drawing.text((RIGHT, ABOVE), Anchor::End, &text, Font::Label, Paint::Dim);
    });
    // The distance of the axes, in the middle between them.
    drawing.path(String::new(), Look::LEAD.edge(Paint::Accent, 1.2)).id = Some(node::DISTANCE);
    let middle = (0.5 * (layout.work.0 + layout.cutter.0), cutter::DISTANCE);
    drawing.place(group::DISTANCE, SceneGroup { at: middle, ..SceneGroup::default() });
    drawing.within(group::DISTANCE, |drawing| {
        drawing.text((0.0, -7.0), Anchor::Middle, "", Font::Value, Paint::Ink).id = Some(node::APART);
    });
}

/// Distance across flats and tip radius of a polygon.
pub(super) fn sizes(lathe: &PolygonLathe) -> [String; 2] {
    let mm = |value: f64| units::text(value, 3, "mm");
    [format!("AF {}", mm(lathe.params.across_flats)), format!("r {}", mm(lathe.params.tip_radius))]
}

/// Leader of the cutter's label to the disc of the present polygon, `away` units from its last place; none where the disc has left the
/// drawing.
pub(super) fn leader((lathe, polygon): (&PolygonLathe, &PolygonLathe), layout: &Layout, away: f64) -> String {
    let r = 0.6 * polygon.params.tip_radius * layout.scale;
    let (x, y) = (layout.cutter.0 + away + 0.3 * r, layout.cutter.1 - 0.95 * r);
    if x > layout::RIGHT {
        return String::new();
    }
    filled("M# #V#L# #", &[columns(lathe, layout).1 - BESIDE, ROW - 12.0, ROW + 66.0, x, y])
}

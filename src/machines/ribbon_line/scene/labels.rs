//! Names and live values of the ribbon line, the ruler of the loop, and the figures of the lens.

use super::captions::{distance, names};
use super::layout::{Layout, Station};
use super::parts::{group, node};
use crate::machines::ribbon_line::params::Params;
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::sheets::say;
use crate::math;
use crate::text::catalog::number_text as show;
use crate::text::number::{figure, filled};
use crate::text::{columns, detailed, units};
use crate::view::letters::LETTER_BOX;
use crate::view::scene::{LETTER, LINE};
use crate::view::{Anchor, Callout, Drawing, Font, Look, Paint, SceneGroup};

/// A smear as the lens shows it, mm.
fn smear_text(smear: f64) -> String {
    const MOST: f64 = 999.0;
    if smear > MOST { format!("> {}", units::text(MOST, 0, "mm")) } else { units::figure(smear, 3, "mm") }
}

/// Most letters of the slack: `+12345.6 mm`.
const SLACK_LETTERS: usize = 11;

/// A magnification: `5 ×`, `1/20 ×`.
fn times(magnified: f64) -> String {
    if magnified < 1.0 {
        format!("1/{} ×", figure(1.0 / magnified, 0))
    } else {
        format!("{} ×", figure(magnified, 0))
    }
}

/// Names with values and leaders.
pub(crate) fn callouts(drawing: &mut Drawing, line: &RibbonLine, layout: &Layout) {
    let (p, unit) = (&line.params, layout.unit);
    let (lefts, base) = layout.names;
    let nip = |station: &Station| (station.x - 0.3 * station.r, -0.9 * station.r);
    let contact = (layout.print.x - 0.45 * layout.print.r, -1.5 * layout.print.r);
    let values = [
        [node::UNWINDER_SPEED, node::UNWINDER_VOLTS],
        [node::PULL_FEED, node::PULL_POSITION],
        [node::PRINT_SPEED, node::PRINT_HEAD],
    ];
    let parts = [nip(&layout.unwinder), nip(&layout.pull), contact];
    for (((name, left), [first, second]), part) in names(p).iter().zip(lefts).zip(values).zip(parts) {
        let values = [(Some(first), ""), (Some(second), "")];
        drawing.callout(&Callout { at: (left, base), anchor: Anchor::Start, name, values: &values, part: Some(part) });
    }
    let reel = &layout.supply;
    let ribbon = format!("{} × {}", units::plain(p.ribbon_thickness, 3, "mm"), units::text(p.ribbon_width, 1, "mm"));
    let line_height = LINE * LETTER * unit;
    drawing.callout(&Callout {
        at: (layout.view[0] + 12.0 * unit, reel.y - reel.r - 26.0 * unit - 2.0 * line_height),
        anchor: Anchor::Start,
        name: &say("ribbon.scene.reel"),
        values: &[(None, &ribbon), (Some(node::UNWOUND), "")],
        part: Some((reel.x - 0.35 * reel.r, reel.y - 0.9 * reel.r)),
    });
    drawing.showing("pitch", |drawing| {
        drawing.callout(&Callout {
            at: layout.take_up_text,
            anchor: Anchor::Start,
            name: &say("ribbon.scene.take-up"),
            values: &[(Some(node::DOT_COUNT), ""), (None, &distance(p))],
            part: None,
        });
    });
    foot(drawing, p, layout);
}

/// The row below the floor: a bar of a round length, the drives with their gear ratios, the factor of the drawn thickness.
fn foot(drawing: &mut Drawing, p: &Params, layout: &Layout) {
    let unit = layout.unit;
    let left = layout.view[0];
    let (y, gap) = (layout.floor + 18.0 * unit, 8.0 * unit);
    let wide = |text: &str| LETTER_BOX.width * LETTER * unit * columns(text) as f64;
    let long = units::metric(math::step_at_most(units::value(45.0 * unit, "mm")), "mm");
    let (x, bar) = (left + 12.0 * unit, y - 4.0 * unit);
    let (top, bottom) = (bar - 4.0 * unit, bar + 4.0 * unit);
    drawing.path(filled("M# #V#M# #H#M# #V#", &[x, top, bottom, x, bar, x + long, x + long, top, bottom]), Look::LEAD);
    let text = units::text(long, 3, "mm");
    let mut end = x + long + 6.0 * unit;
    drawing.text((end, y), Anchor::Start, &text, Font::Label, Paint::Dim);
    end += wide(&text) + gap;
    for (station, id, field, ratio) in [
        (&layout.unwinder, "ribbon.scene.inverter", "reduction-ratio", p.reduction_ratio),
        (&layout.pull, "ribbon.scene.servo", "gear-x", p.axes.pull.gear),
    ] {
        let text = detailed(say(id), format!("{} : 1", show(ratio, 2)));
        // In the middle below the cabinet, or beside the text before.
        let half = 0.5 * wide(&text);
        let middle = (station.x - 3.0 * station.scale).max(end + half);
        drawing.showing(field, |drawing| {
            drawing.text((middle, y), Anchor::Middle, &text, Font::Label, Paint::Dim);
        });
        end = middle + half + gap;
    }
    let note = format!("{} {}", say("ribbon.scene.thickness"), factor(layout.thickness / p.ribbon_thickness));
    // Apart from the print station, whose caption it is not.
    let half = 0.5 * wide(&note);
    let middle = (0.5 * (layout.print.x + layout.take_up.x)).max(end + half);
    drawing.text((middle, y), Anchor::Middle, &note, Font::Label, Paint::Dim);
}

/// Limits of the loop, ruler and pointer.
pub(crate) fn ruler(drawing: &mut Drawing, line: &RibbonLine, layout: &Layout) {
    let (p, unit) = (&line.params, layout.unit);
    let (left, right) = (layout.unwinder.x + layout.unwinder.r, layout.pull.x - layout.pull.r);
    let x = left + 0.36 * (right - left);
    let low = layout.full;
    drawing.place(group::POINTER, SceneGroup { at: (x, 0.0), ..SceneGroup::default() });
    drawing.path(filled("M# #H#", &[left + 4.0 * unit, low, right - 4.0 * unit]), Look::LEAD.dashed(5.0, 4.0));
    let step = units::metric(math::step_at_most(units::value(p.loop_capacity / 8.0, "mm")), "mm");
    let mut d = filled("M# 0V#", &[x, low]);
    let mut mark = 0.0;
    let mut count = 0;
    while p.loop_capacity > 0.0 && mark <= p.loop_capacity * 1.000001 && count < 200 {
        let long = if count % 5 == 0 { 10.0 } else { 5.0 };
        d += &filled("M# #h#", &[x, layout.slack.depth(mark), long * unit]);
        mark += step;
        count += 1;
    }
    drawing.path(d, Look::LEAD);
    drawing.within(group::POINTER, |drawing| {
        let (a, b) = (9.0 * unit, 4.5 * unit);
        drawing.path(filled("M0 0L# #V#z", &[-a, -b, b]), Look::fill(Paint::Accent));
    });
    drawing.text((x - 4.0 * unit, -8.0 * unit), Anchor::End, "0", Font::Label, Paint::Dim);
}

/// The slack and the state of the loop, over a dancer on a tight ribbon.
pub(crate) fn slack(drawing: &mut Drawing, layout: &Layout) {
    let unit = layout.unit;
    let plates = (layout.unwinder.x + 66.0 * layout.unwinder.scale, layout.pull.x - 52.0 * layout.pull.scale);
    let middle = 0.5 * (plates.0 + plates.1);
    let callout = Callout {
        at: (middle, -26.0 * unit - 2.0 * LINE * LETTER * unit),
        anchor: Anchor::Middle,
        name: &say("ribbon.scene.loop"),
        values: &[(Some(node::SLACK), ""), (Some(node::LOOP_STATE), "")],
        part: None,
    };
    let states = ["ribbon.scene.full", "ribbon.scene.empty"].map(|id| columns(&say(id)));
    drawing.callout_with(&callout, states.into_iter().fold(SLACK_LETTERS, usize::max));
}

/// The capacity of the loop below its limit, over a loop that hangs deeper.
pub(crate) fn limit(drawing: &mut Drawing, line: &RibbonLine, layout: &Layout) {
    let unit = layout.unit;
    let middle = 0.5 * (layout.unwinder.x + layout.unwinder.r + layout.pull.x - layout.pull.r);
    let mut limit = units::text(line.params.loop_capacity, 1, "mm");
    if layout.slack.share < 1.0 {
        let factor = 1.0 / layout.slack.share;
        limit = detailed(limit, format!("1:{}", show(factor, u8::from(factor < 10.0))));
    }
    drawing.text((middle, layout.full + 15.0 * unit), Anchor::Middle, &limit, Font::Label, Paint::Dim);
}

/// Rim and figures of the lens: smear and magnification.
pub(crate) fn lens(drawing: &mut Drawing, line: &RibbonLine, layout: &Layout) {
    let (x, y, r) = layout.lens;
    let bad = line.derived.surface.smear > line.params.smear_limit;
    let letter = LETTER * layout.unit;
    let (low, name) = (y + 0.52 * r, detailed(say("ribbon.scene.smear"), times(layout.magnified)));
    let paint = if bad { Paint::Bad } else { Paint::Ink };
    drawing.lens((x, y, r), |drawing| {
        drawing.text((x, low), Anchor::Middle, &name, Font::Label, Paint::Dim);
        drawing.text(
            (x, low + LINE * letter),
            Anchor::Middle,
            &smear_text(line.derived.surface.smear),
            Font::Value,
            paint,
        );
    });
}

/// A factor with two digits.
fn factor(factor: f64) -> String {
    let decimals = if factor < 0.1 {
        3
    } else if factor < 10.0 {
        1
    } else {
        0
    };
    format!("{} ×", show(factor, decimals))
}

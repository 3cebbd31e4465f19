//! The dancer: a roller that lies in the loop and goes up and down with it.

use super::layout::Layout;
use super::parts::group;
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::text::number::filled;
use crate::view::drawing::barrel;
use crate::view::{Drawing, Look, Paint, Placement, SceneGroup};

/// Radius of the roller, mm of the drawing: that of the deflection roller where the loop is wide enough.
fn radius(layout: &Layout) -> f64 {
    layout.deflector.2.min(layout.slack.largest_roller_radius())
}

/// Centre of the roller on a loop with a slack, mm of the drawing.
fn centre(layout: &Layout, slack: f64) -> (f64, f64) {
    let (x, y) = layout.slack.lowest(slack);
    (layout.unwinder.x + x, y - 0.5 * layout.thickness - radius(layout))
}

/// The body of the roller, behind the ribbon.
pub(super) fn behind(drawing: &mut Drawing, line: &RibbonLine) {
    let layout = line.layout();
    if !line.params.is_regulated() {
        return;
    }
    drawing.place(group::DANCER, SceneGroup { at: centre(layout, 0.0), ..SceneGroup::default() });
    drawing.showing("dancer", |drawing| {
        drawing.within(group::DANCER, |drawing| {
            let body = barrel((0.0, 0.0), radius(layout), layout.depth);
            drawing.path(body, Look::fill(Paint::SteelBody));
        });
    });
}

/// Its face, in front of the ribbon.
pub(super) fn before(drawing: &mut Drawing, line: &RibbonLine) {
    if !line.params.is_regulated() {
        return;
    }
    let r = radius(line.layout());
    drawing.showing("dancer", |drawing| {
        drawing.within(group::DANCER, |drawing| {
            drawing.circle((0.0, 0.0, r), Look::FACE);
            drawing.circle((0.0, 0.0, 0.3 * r), Look::HOLE);
            drawing.path(filled("M# 0H#M0 #V#", &[-0.12 * r, 0.12 * r, -0.12 * r, 0.12 * r]), Look::HAIR);
        });
    });
}

/// Placement of the roller at a slack (mm); none without a dancer.
pub(crate) fn pose(line: &RibbonLine, slack: f64) -> Option<Placement> {
    let layout = line.layout();
    let (from, to) = (centre(layout, 0.0), centre(layout, slack));
    line.params.is_regulated().then(|| Placement {
        dx: to.0 - from.0,
        dy: to.1 - from.1,
        ..Placement::of(group::DANCER)
    })
}

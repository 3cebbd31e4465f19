//! The driven tool in the turret that cuts the keyway: a right-angle head with an end mill, to the scale of the part.

use super::ids::{group, node};
use super::layout::Layout;
use crate::machines::turning_spindle::keyway::DrivenTool;
use crate::machines::turning_spindle::params::Params;
use crate::text::number::{fill, filled};
use crate::view::drawing::Drawing;
use crate::view::look::{Look, Paint};
use crate::view::scene::{Placement, SceneGroup};

/// Shortest and longest mill below its nut.
const REACH: (f64, f64) = (26.0, 88.0);
/// Least half width of the nut, its height, and that of the head.
const NUT: (f64, f64) = (13.0, 12.0);
const HEAD: f64 = 46.0;
/// Turn (degrees per frame) beyond which the flutes blur.
const SEEN: f64 = 60.0;
/// Flutes that are seen from the side, and the height of one turn of a flute in diameters.
const FLUTES: u8 = 2;
const LEAD: f64 = 2.4;

/// Half the width of the mill, and its length below the nut.
fn mill(p: &Params, layout: &Layout) -> (f64, f64) {
    let depth = p.keyway_depth * layout.scale;
    (0.5 * p.keyway_width * layout.scale, (depth + 12.0).max(REACH.0).min(REACH.1))
}

/// The head with its mill; its origin is the middle of the mill's end.
pub(super) fn draw(drawing: &mut Drawing, p: &Params, layout: &Layout) {
    let (half, reach) = mill(p, layout);
    let nut = NUT.0.max(half + 2.0);
    let (head, top) = (nut + 7.0, -reach - NUT.1 - HEAD);
    drawing.place(group::DRIVEN_TOOL, SceneGroup { parent: group::TURRET, ..SceneGroup::default() });
    drawing.within_hidden(group::DRIVEN_TOOL, |drawing| {
        // Flange on the disc, and head.
        let flange = top.max(-120.0) + 4.0;
        drawing.rect(
            [head - 4.0, flange, 96.0 - head + 4.0, 38.0, 0.0],
            Look::fill(Paint::DarkFront).thin(Paint::Edge, 1.0),
        );
        drawing.path(filled("M48 #h6v6h-6ZM80 #h6v6h-6Z", &[flange + 26.0, flange + 26.0]), Look::HOLE);
        drawing.rect([-head, top, 2.0 * head, HEAD, 4.0], Look::fill(Paint::DarkFront).thin(Paint::Edge, 1.0));
        drawing.path(filled("M# #h#", &[2.0 - head, top + 2.0, 2.0 * head - 4.0]), Look::RIM.faint(0.5));
        drawing.path(
            filled("M# #h#l-3 #h-#Z", &[-nut, -reach - NUT.1, 2.0 * nut, NUT.1, 2.0 * nut - 6.0]),
            Look::fill(Paint::SteelBar).thin(Paint::Edge, 0.8),
        );
        drawing.showing("keyway-width", |drawing| {
            drawing.rect([-half, -reach, 2.0 * half, reach, 0.0], Look::fill(Paint::Accent).thin(Paint::Edge, 0.8));
            drawing.path(String::new(), Look::line(Paint::Page, 1.6).faint(0.8)).id = Some(node::FLUTES);
        });
    });
}

/// The tool that works, turning tool or driven tool, and the flutes of a mill at a time (s) in steps (s) between two frames.
pub(in super::super) fn pose(
    p: &Params,
    layout: &Layout,
    tool: Option<DrivenTool>,
    (t, step): (f64, f64),
    placements: &mut Vec<Placement>,
    paths: &mut Vec<(u16, String)>,
) {
    placements.push(Placement::shown(group::TURNING_TOOL, tool.is_none()));
    placements.push(Placement::shown(group::DRIVEN_TOOL, tool.is_some()));
    let turning = tool.is_some_and(|tool| tool.turns);
    // No faster than the eye follows, whatever the speed of the page.
    let per_second = (6.0 * p.driven_speed).min(SEEN / step.max(1e-3));
    let turns = if turning { t * per_second / 360.0 } else { 0.0 };
    paths.push((node::FLUTES, if tool.is_some() { flutes(mill(p, layout), turns) } else { String::new() }));
}

/// The edges of the flutes on the near side of the mill: helices, drawn as lines.
fn flutes((half, reach): (f64, f64), turns: f64) -> String {
    let lead = LEAD * 2.0 * half;
    // A half turn lies on the near side, so that an edge rises over half a lead.
    let (rise, spacing) = (0.5 * lead, lead / f64::from(FLUTES));
    let first = -spacing * (turns * f64::from(FLUTES) - (turns * f64::from(FLUTES)).floor());
    let mut path = String::new();
    let mut below = first - rise;
    while spacing > 0.0 && below < reach {
        // Only the part of the line between the end of the mill and its nut.
        let (from, to) = (below.max(0.0), (below + rise).min(reach));
        if to > from {
            let x = |y: f64| -half + 2.0 * half * (y - below) / rise;
            fill(&mut path, "M# #L# #", &[x(from), -from, x(to), -to]);
        }
        below += spacing;
    }
    path
}

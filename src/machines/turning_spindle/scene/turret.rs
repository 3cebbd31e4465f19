//! The slides, the turret with its tool that they move, and the chips at its edge.

use super::ids::{group, node};
use super::layout::{BED, Layout};
use super::solid::AXIS;
use crate::machines::turning_spindle::params::Params;
use crate::text::number::filled;
use crate::view::drawing::Drawing;
use crate::view::look::{Look, Paint};
use crate::view::scene::{Placement, SceneGroup};

/// Top of the column, below the row of labels.
const TOP: f64 = 134.0;
/// Chips in the air, and how long one falls, s.
const CHIPS: u16 = 7;
const FALL: f64 = 0.25;
/// Height of the chips in the tray.
const TRAY: f64 = BED + 47.0;
/// Curls in the tray at most.
const PILE: u32 = 12;

/// The way of the tool from its start to the clearance.
pub(super) fn draw_way(drawing: &mut Drawing, p: &Params, layout: &Layout) {
    let (start, near) =
        (layout.tip(0.5 * p.start_x, p.start_z), layout.tip(0.5 * p.stock_diameter + p.clearance, p.clearance));
    drawing.showing("clearance", |drawing| {
        drawing.path(filled("M# #L# #", &[start.0, start.1, near.0, near.1]), Look::LEAD.dashed(7.0, 4.0).faint(0.7));
    });
    drawing.showing("start-x", |drawing| {
        drawing.path(filled("M# #h14M# #v14", &[start.0 - 7.0, start.1, start.0, start.1 - 7.0]), Look::LEAD);
    });
}

/// The carriage on the ways of the bed with its column, which goes along the bed with the turret; its origin is above the tip of the tool.
pub(super) fn draw_carriage(drawing: &mut Drawing) {
    let (foot, saddle) = (BED - 9.0, BED - 33.0);
    drawing.within(group::CARRIAGE, |drawing| {
        drawing.path(
            filled("M106 #V#h66V#Z", &[saddle - 6.0, TOP, saddle - 6.0]),
            Look::fill(Paint::CabinetFront).thin(Paint::Edge, 0.8),
        );
        drawing.path(filled("M172 #V#l12 7V#Z", &[saddle - 6.0, TOP, saddle - 6.0]), Look::fill(Paint::SteelShade));
        // Ways of the cross slide.
        drawing.path(
            filled("M116 #V#h10V#ZM152 #V#h10V#Z", &[saddle - 6.0, TOP, saddle - 6.0].repeat(2)),
            Look::fill(Paint::Steel),
        );
        drawing.path(filled("M72 #l14 -8h116l14 8Z", &[saddle]), Look::fill(Paint::DarkLight));
        drawing.rect([72.0, saddle, 144.0, foot - saddle, 0.0], Look::fill(Paint::DarkFront).thin(Paint::Edge, 0.8));
    });
}

/// The cross slide on the column, which carries the turret; its origin is the tip of the tool.
pub(super) fn draw_cross_slide(drawing: &mut Drawing) {
    drawing.within(group::CROSS_SLIDE, |drawing| {
        drawing.path("M186 -160l10 7V24l-10 6Z", Look::fill(Paint::SteelShade));
        drawing.rect([92.0, -160.0, 94.0, 190.0, 4.0], Look::fill(Paint::CabinetFront).thin(Paint::Edge, 1.0));
        drawing.path("M98 -12h82M104 8h7v7h-7ZM167 8h7v7h-7Z", Look::HAIR.faint(0.6));
    });
}

/// The turret with its turning tool; its origin is the tip of the tool.
pub(super) fn draw(drawing: &mut Drawing) {
    drawing.place(group::TURNING_TOOL, SceneGroup { parent: group::TURRET, ..SceneGroup::default() });
    drawing.within(group::TURRET, |drawing| {
        // Slide and housing behind the disc.
        drawing.path("M110 -150h58q6 0 6 6v92q0 6 -6 6h-58Z", Look::fill(Paint::DarkFront).thin(Paint::Edge, 1.0));
        drawing.path("M112 -148.500h56", Look::RIM.faint(0.5));
        drawing.path("M160 -140h6v6h-6ZM160 -62h6v6h-6Z", Look::HOLE);
        // Disc: its axis is level, seen from the right.
        drawing.path("M52 -158H104A16 60 0 0 0 104 -38H52A16 60 0 0 1 52 -158Z", Look::fill(Paint::SteelBar));
        drawing.path("M62 -158A16 60 0 0 0 62 -38M96 -158A16 60 0 0 0 96 -38", Look::HAIR.faint(0.4));
        drawing.ellipse((104.0, -98.0), (16.8, 60.0), Look::FACE);
        drawing.ellipse((104.0, -98.0), (6.4, 23.0), Look::DARK_FACE);
        drawing.path(
            "M101 -146h6v9h-6ZM101 -59h6v9h-6ZM112 -128l4 5l-3 8l-4 -5ZM96 -128l-4 5l3 8l4 -5ZM112 -68l4 -5l-3 -8l-4 5ZM96 -68l-4 -5l3 -8l4 5Z",
            Look::HOLE,
        );
    });
    drawing.within(group::TURNING_TOOL, |drawing| {
        // Block and shank.
        drawing.path("M40 -74h56v36H40Z", Look::fill(Paint::DarkFront).thin(Paint::Edge, 1.0));
        drawing.path("M41 -39V-73H95", Look::RIM.faint(0.5));
        drawing.path("M48 -48h6v6h-6ZM80 -48h6v6h-6Z", Look::HOLE);
        drawing.path("M14 -56h26v15H36v27l-10 9l-12 -2Z", Look::FACE);
        drawing.path("M16 -54v42", Look::RIM);
        // Insert.
        drawing.path("M0 0L10 -19H26L22 -4Z", Look::fill(Paint::Accent).thin(Paint::Edge, 0.8));
        drawing.circle((15.0, -11.0, 2.4), Look::fill(Paint::Black));
    });
}

/// Curls in the air and in the tray, which the front of the bed covers.
pub(super) fn draw_chips(drawing: &mut Drawing) {
    drawing.path(String::new(), Look::line(Paint::DarkLight, 3.0).round()).id = Some(node::PILE);
    for chip in 0..CHIPS {
        drawing.place(group::CHIPS + chip, SceneGroup::default());
        drawing.within_hidden(group::CHIPS + chip, |drawing| {
            let curl = "M-5 -2c6 -3 13 2 11 7s-11 5 -11 -1s8 -6 11 -1";
            drawing.path(curl, Look::line(Paint::Dark, 2.8).round());
            drawing.path(curl, Look::line(Paint::Rim, 1.0).round().faint(0.6));
        });
    }
}

/// Chips at a moment: `cuts` while the tool cuts, `removed` the part of the stock that is off, `step` the seconds between two frames.
pub(in super::super) fn pose_chips(
    tip: (f64, f64),
    (cuts, removed): (bool, f64),
    (t, step): (f64, f64),
    placements: &mut Vec<Placement>,
    paths: &mut Vec<(u16, String)>,
) {
    // Slow enough to be seen at any speed of the page.
    let fall = FALL.max(24.0 * step);
    for chip in 0..CHIPS {
        let turns = t / fall + f64::from(chip) / f64::from(CHIPS);
        let part = turns - turns.floor();
        let hand = if chip % 2 == 0 { 1.0 } else { -0.25 };
        let depth = (TRAY - tip.1).max(0.0);
        placements.push(Placement {
            dx: tip.0 + 6.0 + hand * (10.0 + 7.0 * f64::from(chip)) * part,
            dy: tip.1 + 10.0 + (depth - 10.0) * part * part,
            turn: 300.0 * part * hand + 50.0 * f64::from(chip),
            opacity: if cuts { 1.0 } else { 0.0 },
            ..Placement::of(group::CHIPS + chip)
        });
    }
    let curls = (removed * f64::from(PILE)).ceil() as u32;
    let curl = |at: u32| {
        // Spread over the tray, the first in its middle.
        let spread = [6, 4, 8, 5, 7, 3, 9, 2, 10, 1, 11, 0].get(at as usize).copied().unwrap_or(0);
        let (x, y) = (330.0 + 30.0 * f64::from(spread), TRAY + 3.0 * f64::from(at % 3));
        filled("M# #c8 -5 15 1 13 7s-13 4 -12 -3", &[x, y])
    };
    paths.push((node::PILE, (0..curls.min(PILE)).map(curl).collect()));
}

/// The axis line of the spindle, which the chips fall in front of.
pub(super) fn draw_axis(drawing: &mut Drawing) {
    drawing.path(filled("M206 #H1060", &[AXIS]), Look::LEAD.dashed(14.0, 5.0).faint(0.6));
}

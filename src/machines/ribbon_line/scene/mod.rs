//! The drawing of the ribbon line: reels, unwinder, slack loop, pull rollers, print roller with its heads, dots, and a lens at their contact.
//!
//! One unit is one millimetre. Only the thickness of the ribbon and the lens are magnified, each with its factor in the drawing.

pub(super) mod captions;
pub(super) mod dancer;
pub(super) mod labels;
pub(super) mod layout;
pub(super) mod lens;
pub(super) mod parts;
mod printing;
mod reels;
pub(super) mod slack_loop;
pub(super) mod stations;
pub(super) mod web;

use self::layout::Layout;
use self::parts::{group, node};
use self::stations::DriveKind;
use self::web::Web;
use super::resolved::RibbonLine;
use crate::math;
use crate::text::number::filled;
use crate::view::look::{Gradient, Ramp};
use crate::view::{Drawing, Look, Paint, Scene};

/// Edges and middle of the ribbon in the depth of the rollers: near edge, middle, far edge.
pub(super) fn lanes(layout: &Layout) -> [(f64, f64); 3] {
    [0.15, 0.47, 0.8].map(|share| (share * layout.depth.0, share * layout.depth.1))
}

/// Band and edge of a part of the ribbon, as `d`.
pub(super) fn band(layout: &Layout, web: &Web) -> [String; 2] {
    let [near, _, far] = lanes(layout);
    [web.band(near, far), web.path(near, f64::INFINITY)]
}

/// Length and width of a dot on the ribbon, mm. The width is no input.
pub(super) fn dot(line: &RibbonLine) -> (f64, f64) {
    let (p, s) = (&line.params, line.layout().scale);
    let long = (p.contact_length + line.derived.surface.smear).max(0.6 * s);
    (math::clamp(long, 0.05 * p.pitch, 0.7 * p.pitch), math::clamp(2.0 * p.contact_length, 1.6 * s, 4.0 * s))
}

/// The drawing at rest.
pub(super) fn scene(line: &RibbonLine) -> Scene {
    let (p, layout) = (&line.params, line.layout());
    let mut drawing = Drawing::new(layout.unit);
    let print = p.print_axis.letter();
    ground(&mut drawing, layout);
    let wound = reels::Wound::new(&mut drawing);
    drawing.showing("reel-diameter", |drawing| {
        reels::behind(drawing, layout, &layout.supply, reels::SUPPLY, wound);
    });
    stations::behind(&mut drawing, layout, &layout.unwinder, group::UNWINDER, "S");
    stations::behind(&mut drawing, layout, &layout.pull, group::PULL, "X");
    printing::behind(&mut drawing, layout, print);
    drawing.showing("loop-capacity", |drawing| labels::ruler(drawing, line, layout));
    reels::behind(&mut drawing, layout, &layout.take_up, reels::TAKE_UP, wound);
    dancer::behind(&mut drawing, line);
    drawing.showing("ribbon-thickness", |drawing| ribbon(drawing, line));
    dancer::before(&mut drawing, line);
    drawing.showing("loop-capacity", |drawing| {
        labels::slack(drawing, layout);
        labels::limit(drawing, line, layout);
    });
    drawing.showing("reel-diameter", |drawing| {
        reels::face(drawing, layout, &layout.supply, reels::SUPPLY, wound);
    });
    drawing.showing("reel-core-diameter", |drawing| reels::hub(drawing, reels::SUPPLY));
    reels::face(&mut drawing, layout, &layout.take_up, reels::TAKE_UP, wound);
    reels::hub(&mut drawing, reels::TAKE_UP);
    stations::before(&mut drawing, layout, &layout.unwinder, group::UNWINDER, DriveKind::Inverter);
    stations::before(&mut drawing, layout, &layout.pull, group::PULL, DriveKind::Servo);
    printing::before(&mut drawing, layout, p);
    printing::deflector(&mut drawing, layout);
    lens::lens(&mut drawing, layout, p, line.derived.surface.smear, line.derived.surface.smear > p.smear_limit);
    labels::lens(&mut drawing, line, layout);
    labels::callouts(&mut drawing, line, layout);
    let slack = 0.5 * (layout.unwinder.x + layout.pull.x);
    drawing.stations = vec![
        ("ribbon.station.reel", layout.supply.x),
        ("ribbon.station.loop", slack),
        ("ribbon.station.print", layout.print.x),
        ("ribbon.station.take-up", layout.take_up.x),
    ];
    Scene { drawing_option: Some("ribbon.scene.strobe"), ..drawing.scene(layout.view, "ribbon.scene.alt") }
}

/// Floor and shadows.
fn ground(drawing: &mut Drawing, layout: &Layout) {
    let (s, floor) = (layout.scale, layout.floor);
    let [left, top, width, height] = layout.view;
    let begin = floor - 46.0 * s;
    let low = top + height + 400.0 * s;
    drawing.rect([left - 3.0 * width, begin, 7.0 * width, low - begin, 0.0], Look::fill(Paint::Floor));
    let mut shadow = |x: f64, wide: f64| {
        drawing.ellipse((x, floor - 1.0 * s), (wide, 0.14 * wide), Look::fill(Paint::GroundShade));
    };
    shadow(layout.supply.x + 14.0 * s, 1.25 * layout.supply.r);
    shadow(0.5 * (layout.unwinder.x + layout.pull.x), 150.0 * s);
    for station in [&layout.unwinder, &layout.pull, &layout.print] {
        shadow(station.x + 14.0 * station.scale, 118.0 * station.scale);
    }
    shadow(layout.take_up.x + 14.0 * s, 120.0 * s);
}

/// The ribbon from reel to reel with its dots.
fn ribbon(drawing: &mut Drawing, line: &RibbonLine) {
    let layout = line.layout();
    let (from, to) = (layout.unwinder.x + layout.unwinder.r, layout.pull.x - layout.pull.r);
    let hanging = drawing.gradient(Gradient {
        ramp: Ramp::Between([from, 0.0, to, 0.0]),
        stops: vec![(0.0, Paint::RibbonLight, 1.0), (0.45, Paint::Ribbon, 1.0), (1.0, Paint::RibbonShade, 1.0)],
    });
    let edge = Look::line(Paint::RibbonShade, layout.thickness);
    let supply = band(layout, &layout.supply_web(layout.supply.r));
    let hangs = band(layout, &layout.slack.web(layout.unwinder.x, 0.0));
    let level = band(layout, &layout.level_web());
    let take_up = band(layout, &layout.take_up_web(layout.take_up.r));
    let rows = [
        (supply, Paint::RibbonLight, Some(node::SUPPLY)),
        (hangs, hanging, Some(node::LOOP)),
        (level, Paint::Ribbon, None),
        (take_up, Paint::Ribbon, Some(node::TAKE_UP)),
    ];
    for ([surface, line], paint, ids) in rows {
        drawing.path(surface, Look::fill(paint)).id = ids.map(|ids| ids[0]);
        drawing.path(line, edge).id = ids.map(|ids| ids[1]);
    }
    let (long, wide) = dot(line);
    let start = filled("M# 0h0.1", &[layout.print.x]);
    drawing.showing("pitch", |drawing| {
        drawing.within_hidden(group::DOTS_BLUR, |drawing| {
            drawing.path(start.clone(), Look::line(Paint::Black, wide).faint(0.5)).id = Some(node::STREAK);
        });
        drawing.within_hidden(group::DOTS, |drawing| {
            let look = Look::line(Paint::Black, wide);
            // Dots too close for the eye are drawn as a grey line.
            let look = if line.params.pitch > 0.6 * layout.scale {
                look.dashed(long, line.params.pitch - long)
            } else {
                look.faint(0.5)
            };
            drawing.path(start, look).id = Some(node::DOTS);
        });
    });
}

//! The drawing of the turning spindle at a moment: part, tool, chuck, needles, gear lever, chips, figures.

use super::keyway::{self, DrivenTool};
use super::progress::{self, Progress};
use super::resolved::TurningSpindle;
use super::scene::{self, Layout, group, node};
use crate::controls::{Code, CodeId};
use crate::drives::Bound;
use crate::drives::speed::surface_speed;
use crate::machines::machine::Frame;
use crate::machines::machine::Samples;
use crate::machines::sheets::say;
use crate::math::PI;
use crate::motion::Snapshot;
use crate::text::catalog::number_text as show;
use crate::text::number::figure;
use crate::text::units;
use crate::view::Pose;
use crate::view::scene::Placement;

/// Turn (degrees per frame) beyond which the jaws blur, and opacity of the blur.
const SEEN: f64 = 40.0;
const BLURRED: f64 = 0.35;

/// Placements, paths and figures at a moment.
pub(super) fn pose(lathe: &TurningSpindle, run: &dyn Samples, now: &Snapshot, frame: Frame) -> Pose {
    let p = &lathe.params;
    let layout = Layout::new(p);
    let tool = lathe.tool(now);
    let progress = progress::progress(lathe, run, now);
    let cuts = progress::cuts(lathe, progress, now);
    let spindle = &now.spindle;
    let seen = Frame::seen((spindle.actual * 6.0 * frame.step).abs(), SEEN);
    let tip = layout.tip(tool.0, tool.1);
    let mut pose = Pose::default();
    let placements = &mut pose.placements;
    for group in [group::TURRET, group::CROSS_SLIDE] {
        placements.push(Placement { dx: tip.0, dy: tip.1, ..Placement::of(group) });
    }
    placements.push(Placement { dx: tip.0, ..Placement::of(group::CARRIAGE) });
    let (speed, volts) = scene::needles(lathe, spindle.actual, spindle.volts);
    placements.push(Placement { turn: speed, ..Placement::of(group::SPEED) });
    placements.push(Placement { turn: volts, ..Placement::of(group::NEEDLE) });
    for group in [group::JAWS_FAR, group::JAWS_NEAR] {
        placements.push(Placement { opacity: seen, ..Placement::of(group) });
    }
    placements.push(Placement { opacity: BLURRED * (1.0 - seen), ..Placement::of(group::BLUR) });
    let knob = scene::knob(spindle.stage.max(1), spindle.bound == Bound::Shift, p.stages().count());
    placements.push(Placement { dx: knob.0, dy: knob.1, ..Placement::of(group::KNOB) });
    scene::pose_work(lathe, &layout, progress, spindle.turns, &mut pose.paths);
    let driven = keyway::driven_tool(lathe, run, now);
    let groove = keyway::groove(lathe, run, now);
    if lathe.keyway().is_some() {
        pose.paths.push((node::GROOVE, scene::pose_groove(lathe, &layout, groove)));
        scene::pose_tools(p, &layout, driven, (now.t, frame.step), placements, &mut pose.paths);
    }
    layout.chuck.pose(spindle.turns, &mut pose.paths);
    let sections = scene::sections(lathe, &layout, progress);
    let at_tip = scene::AtTip { sections: &sections, tool, cuts, mills: driven.is_some(), groove };
    scene::pose_lens(lathe, &layout, &at_tip, placements, &mut pose.paths);
    let chips = (cuts || driven.is_some_and(|tool| tool.cuts), progress::removed(lathe, progress));
    scene::pose_chips(tip, chips, (now.t, frame.step), placements, &mut pose.paths);
    pose.paths.push((node::LEVER, scene::lever(knob)));
    pose.paths.push((node::TOOL_LEADER, scene::tool_leader(tip)));
    pose.paths.push((node::ORIENTATION, orientation(lathe, &layout, now)));
    pose.texts = texts(lathe, now, progress, driven);
    pose.texts.extend(scene::lens_texts(p, &layout, driven.is_some()));
    pose
}

/// Path of the arc from the top to the zero mark of the spindle, while the spindle is held.
fn orientation(lathe: &TurningSpindle, layout: &Layout, now: &Snapshot) -> String {
    let mut d = String::new();
    if lathe.positions() && now.spindle.held {
        let angle = 2.0 * PI * (now.spindle.turns - now.spindle.turns.floor());
        let (x, radius) = layout.side(0.0, lathe.params.stock_diameter);
        scene::arc(&mut d, x, 0.82 * radius, 0.0, angle);
    }
    d
}

/// The code of a gear stage, or its number where the control has no codes for them.
fn gear(lathe: &TurningSpindle, stage: u8) -> String {
    let row = lathe.control.codes.iter().find(|row| row.code == Code::GearStage(stage));
    match row.map(|row| row.id) {
        Some(CodeId::M(number)) => format!("M{number}"),
        _ => stage.to_string(),
    }
}

/// Number of the pass, and the number of passes.
pub(super) fn pass(lathe: &TurningSpindle, progress: Progress) -> String {
    let pass = (progress.done + u32::from(progress.at.is_some())).max(1);
    format!("{pass} / {}", show(lathe.params.passes(), 0))
}

fn texts(lathe: &TurningSpindle, now: &Snapshot, progress: Progress, driven: Option<DrivenTool>) -> Vec<(u16, String)> {
    let p = &lathe.params;
    let spindle = &now.spindle;
    let diameter = lathe.diameter(now);
    let stage = lathe.params.stages().nth(usize::from(spindle.stage).saturating_sub(1)).unwrap_or(p.stage_1);
    let (radius, z) = lathe.tool(now);
    let across = if lathe.x_counts_diameters() { diameter } else { radius };
    // Of the mill's edge, or of the work at the tip.
    let at_the_tool = match driven {
        Some(tool) => {
            if tool.turns {
                keyway::cutting_speed(p)
            } else {
                0.0
            }
        }
        None => surface_speed(spindle.actual, diameter),
    };
    let mut texts = vec![
        (node::SPEED, format!("{} r/min", figure(spindle.actual, 0))),
        (node::SURFACE, units::figure(at_the_tool, 1, "m/min")),
        (node::STAGE, format!("{} {}", say("turning.scene.gear"), gear(lathe, spindle.stage))),
        (node::STAGE_SPEED, format!("{} r/min", figure(stage, 0))),
        (node::VOLTS, format!("{} V", figure(spindle.volts, 3))),
        (node::BOUND, bound(spindle.bound).map(say).unwrap_or_default()),
        (node::LEFT, units::text(p.left(f64::from(progress.done)), 3, "mm")),
        (node::X, format!("X {}", figure(across, 3))),
        (node::Z, format!("Z {}", figure(z, 3))),
    ];
    if lathe.positions() {
        texts.push((node::ANGLE, format!("{}°", figure(spindle.angle, 1))));
    }
    texts
}
/// Name of the limit that binds the speed.
fn bound(bound: Bound) -> Option<&'static str> {
    Some(match bound {
        Bound::None => return None,
        Bound::Machine => "turning.bound.machine",
        Bound::Gear => "turning.bound.gear",
        Bound::Upper => "turning.bound.upper",
        Bound::Surface => "turning.bound.surface",
        Bound::Lower => "turning.bound.lower",
        Bound::GearLow => "turning.bound.gear-low",
        Bound::SurfaceLow => "turning.bound.surface-low",
        Bound::Output => "turning.bound.output",
        Bound::Shift => "turning.bound.shift",
    })
}

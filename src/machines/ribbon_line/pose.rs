//! The drawing of the ribbon line at a moment: angles of the rollers, ribbon and dots, depth of the loop, figures.

use super::params::Params;
use super::resolved::RibbonLine;
use super::scene::layout::DrawnReel;
use super::scene::lens::Lens;
use super::scene::parts::group::{self, Station as Part};
use super::scene::parts::node;
use super::scene::{self, band, dancer};
use crate::machines::machine::Frame;
use crate::machines::sheets::say;
use crate::math::{self, PI};
use crate::motion::Snapshot;
use crate::msg;
use crate::text::catalog::{number_text as show, sentence};
use crate::text::number::figure;
use crate::text::units;
use crate::view::{Paint, Placement, Pose};

/// Degrees per frame beyond which a roller is drawn as a blurred ring.
const SEEN: f64 = 20.0;

/// Slack (mm, negative) below which the ribbon counts as tight.
const TIGHT: f64 = -0.5;

/// Lag of the pull roller, mm, within which a dot counts as printed.
const AT_DOT: f64 = 1e-4;

/// The state of the line at a moment, in the units of the drawing's figures.
pub(super) struct LineState {
    /// Revolutions of the unwinding roller.
    unwinder_turns: f64,
    /// Revolutions of the pull roller.
    pull_turns: f64,
    /// Degrees of the print roller.
    print_angle: f64,
    /// Ribbon pulled, mm.
    pub(super) pulled: f64,
    /// Ribbon unwound, mm.
    unwound: f64,
    /// Ribbon unwound less ribbon pulled, mm.
    pub(super) slack: f64,
    /// Degrees per second of the unwinding roller, of the pull roller and of the print roller.
    unwinder_speed: f64,
    pull_speed: f64,
    print_speed: f64,
}

impl LineState {
    pub(super) fn new(line: &RibbonLine, now: &Snapshot) -> LineState {
        let p = &line.params;
        let (pull, print) = (&now.axes[line.pull()], &now.axes[line.print()]);
        // The actual position of the axis, which lags its command.
        let pulled = pull.actual;
        let turns = now.spindle.turns / p.reduction_ratio;
        let unwound = p.laid_by_turns(now.spindle.turns);
        let degrees = if line.degrees() { 1.0 } else { 360.0 / (PI * p.print_roller_diameter) };
        LineState {
            unwinder_turns: turns,
            pull_turns: pulled / (PI * p.x_roller_diameter),
            print_angle: print.actual * degrees,
            pulled,
            unwound,
            slack: unwound - pulled,
            unwinder_speed: now.spindle.actual / p.reduction_ratio * 6.0,
            pull_speed: pull.feed / (PI * p.x_roller_diameter) * 6.0,
            print_speed: print.feed * degrees / 60.0,
        }
    }

    /// Register error, mm of ribbon: `y = α · heads / 360 · pitch - x`, with the angle α [°] of the print roller and the pulled length x.
    pub(super) fn register(&self, p: &Params) -> f64 {
        self.print_angle * p.heads / 360.0 * p.pitch - self.pulled
    }

    /// Share of a pitch that the newest dot has moved, and the number of dots before it.
    fn passed(&self, p: &Params) -> (f64, f64) {
        let passed = (self.pulled + AT_DOT) / p.pitch;
        (passed - passed.floor(), passed.floor())
    }
}

/// The number of dots on the ribbon.
pub(super) fn dots_printed(line: &RibbonLine, now: &Snapshot) -> f64 {
    LineState::new(line, now).passed(&line.params).1.max(0.0)
}

/// A group turned about its own origin.
fn turned(group: u16, turn: f64, opacity: f64) -> Placement {
    Placement { turn: turn % 360.0, opacity, ..Placement::of(group) }
}

/// A group with an opacity, 0 to 1.
fn shown(group: u16, opacity: f64) -> Placement {
    Placement { opacity, ..Placement::of(group) }
}

/// Placements, paths and figures at a moment.
pub(super) fn pose(line: &RibbonLine, now: &Snapshot, frame: Frame) -> Pose {
    let state = LineState::new(line, now);
    let mut pose = Pose::default();
    stations(line, now, frame, &state, &mut pose);
    reels(line, &state, &mut pose);
    print_roller(line, frame, &state, &mut pose);
    dots(line, now, frame, &state, &mut pose);
    slack_loop(line, &state, &mut pose);
    lamps(now, &state, &mut pose);
    pose.texts = texts(line, now, &state);
    pose
}

/// Visibility of single marks at a turn of `step` degrees per frame: 1 where the eye can follow them, 0 where they
/// blur.
fn seen(step: f64) -> f64 {
    Frame::seen(step.abs(), SEEN)
}

/// Rollers below the ribbon turn clockwise, rollers above it counter-clockwise; a motor turns by its gear ratio.
fn stations(line: &RibbonLine, now: &Snapshot, frame: Frame, state: &LineState, pose: &mut Pose) {
    let p = &line.params;
    let pinch = 1.0 / scene::layout::PINCH;
    let motor = now.spindle.turns;
    let rows = [
        (group::UNWINDER, 360.0 * state.unwinder_turns, state.unwinder_speed, 360.0 * motor, now.spindle.actual * 6.0),
        (
            group::PULL,
            360.0 * state.pull_turns,
            state.pull_speed,
            360.0 * state.pull_turns * p.axes.pull.gear,
            state.pull_speed * p.axes.pull.gear,
        ),
    ];
    for ((first, turn, speed, motor, motor_speed), (belt, station)) in
        rows.into_iter().zip(node::BELTS.into_iter().zip([&line.layout().unwinder, &line.layout().pull]))
    {
        let step = speed * frame.step;
        pose.placements.extend([
            turned(Part::Marks.of(first), turn, seen(step)),
            shown(Part::Blur.of(first), 1.0 - seen(step)),
            turned(Part::PinchMarks.of(first), -turn * pinch, 0.25 + 0.75 * seen(step * pinch)),
            turned(Part::Pulley.of(first), motor, 0.4 + 0.6 * seen(motor_speed * frame.step)),
        ]);
        // The belt runs on the hub of the roller.
        let pitch = 6.0 * station.scale;
        pose.dashes.push((belt, -(turn * PI / 180.0 * 0.44 * station.r) % pitch));
    }
    let (_, _, r) = line.layout().deflector;
    pose.placements.push(turned(group::DEFLECTOR_MARKS, state.pulled / r * 180.0 / PI, 1.0));
}

/// Reels turn with the ribbon on their radius, and shrink and grow by its thickness.
fn reels(line: &RibbonLine, state: &LineState, pose: &mut Pose) {
    let (layout, t) = (line.layout(), line.params.ribbon_thickness);
    let rows: [(&DrawnReel, f64, [u16; 3]); 2] = [
        (&layout.supply, -state.unwound.max(0.0), [group::REEL_BODY, group::REEL_FACE, group::REEL_HUB]),
        (&layout.take_up, state.pulled.max(0.0), [group::TAKE_UP_BODY, group::TAKE_UP_FACE, group::TAKE_UP_HUB]),
    ];
    for (reel, length, [body, face, hub]) in rows {
        let turn = 360.0 * reel.turns(t, length) % 360.0;
        let size = reel.radius(t, length) / reel.r;
        pose.placements.extend([
            Placement { size: (size, size), ..Placement::of(body) },
            Placement { turn, size: (size, size), ..Placement::of(face) },
            Placement { turn, ..Placement::of(hub) },
        ]);
    }
    let supply = layout.supply_web(layout.supply.radius(t, -state.unwound.max(0.0)));
    let take_up = layout.take_up_web(layout.take_up.radius(t, state.pulled.max(0.0)));
    pose.paths.extend(node::SUPPLY.into_iter().zip(band(layout, &supply)));
    pose.paths.extend(node::TAKE_UP.into_iter().zip(band(layout, &take_up)));
}

/// The print roller with its heads, also in the lens. The stroboscope flashes when a head meets the ribbon.
fn print_roller(line: &RibbonLine, frame: Frame, state: &LineState, pose: &mut Pose) {
    let head = 360.0 / line.params.heads;
    let angle = state.print_angle + 1e-6;
    let flash = if frame.drawing_option { (angle / head).floor() * head } else { angle };
    let heads_seen = if frame.drawing_option { 1.0 } else { seen(state.print_speed * frame.step) };
    for layer in 0..group::LAYERS {
        pose.placements.push(turned(group::PRINT_LAYERS + 2 * layer + 1, -flash, heads_seen));
    }
    pose.placements.push(turned(group::PRINT, -flash, heads_seen));
    pose.placements.push(shown(group::PRINT_BLUR, 0.6 * (1.0 - heads_seen)));
    let lens = Lens::new(line.layout(), &line.params, line.derived.surface.smear);
    let (cy, turn) = (lens.centre(), -(flash - (flash / head).floor() * head));
    pose.placements.push(Placement { turn, cy, opacity: 0.25 + 0.75 * heads_seen, ..Placement::of(group::LENS_HEADS) });
}

/// The dots move with X; the newest was printed where the last head met the ribbon.
fn dots(line: &RibbonLine, now: &Snapshot, frame: Frame, state: &LineState, pose: &mut Pose) {
    let (p, layout) = (&line.params, line.layout());
    let (part, _) = state.passed(p);
    let part = if frame.drawing_option { 0.0 } else { part };
    let step = (now.axes[line.pull()].feed / 60.0 * frame.step / p.pitch).abs();
    // Beyond a third of a pitch a frame the eye joins wrong dots.
    let clear = if frame.drawing_option { 1.0 } else { math::clamp((0.45 - step) / 0.15, 0.0, 1.0) };
    let any = if state.pulled > 0.0 { 1.0 } else { 0.0 };
    let [_, middle, _] = scene::lanes(layout);
    let radius = layout.take_up.radius(p.ribbon_thickness, state.pulled.max(0.0));
    let (long, _) = scene::dot(line);
    let row = layout.printed_web(radius).path(middle, state.pulled.max(0.0) + 0.5 * long);
    pose.paths.push((node::DOTS, row.clone()));
    pose.paths.push((node::STREAK, row));
    pose.dashes.push((node::DOTS, 0.5 * long - part * p.pitch));
    pose.placements.push(shown(group::DOTS, clear * any));
    pose.placements.push(shown(group::DOTS_BLUR, 0.7 * (1.0 - clear) * any));
    let lens = Lens::new(layout, p, line.derived.surface.smear);
    for id in [node::LENS_DOTS, node::LENS_SMEAR] {
        pose.dashes.push((id, -part * lens.pitch));
        pose.paths.push((id, lens.row(state.pulled.max(0.0))));
    }
    pose.placements.push(shown(group::LENS_DOTS, (0.3 + 0.7 * clear) * any));
}

/// Whether the loop is within its range: neither tight nor beyond its capacity.
fn holds(line: &RibbonLine, state: &LineState) -> bool {
    state.slack >= TIGHT && (state.slack <= line.params.loop_capacity || line.params.loop_capacity <= 0.0)
}

/// The loop hangs as deep as its slack, at most on the floor.
fn slack_loop(line: &RibbonLine, state: &LineState, pose: &mut Pose) {
    let layout = line.layout();
    let slack = state.slack.min(layout.on_floor);
    pose.paths.extend(node::LOOP.into_iter().zip(band(layout, &layout.slack.web(layout.unwinder.x, slack))));
    let depth = layout.slack.depth(slack);
    pose.placements.push(Placement { dy: depth, ..Placement::of(group::POINTER) });
    pose.placements.extend(dancer::pose(line, slack));
    // A short tight ribbon is no fault: the tension switch holds the program at its limit, and says so.
    let paint = if holds(line, state) || state.slack < 0.0 { Paint::Ink } else { Paint::Bad };
    pose.fills.extend([(node::SLACK, paint), (node::LOOP_STATE, paint)]);
}

/// A lamp is on while its drive turns.
fn lamps(now: &Snapshot, state: &LineState, pose: &mut Pose) {
    for (lamp, speed) in node::LAMPS.into_iter().zip([now.spindle.actual, state.pull_speed]) {
        pose.fills.push((lamp, if speed.abs() > 1e-6 { Paint::Good } else { Paint::DarkShade }));
    }
}

fn texts(line: &RibbonLine, now: &Snapshot, state: &LineState) -> Vec<(u16, String)> {
    let p = &line.params;
    let heads = p.heads.max(1.0);
    let met = (state.print_angle * heads / 360.0 + 1e-6).floor();
    let head = met - (met / heads).floor() * heads + 1.0;
    let state_of_loop = match holds(line, state) {
        true => String::new(),
        false if state.slack > 0.0 => say("ribbon.scene.full"),
        false => say("ribbon.scene.empty"),
    };
    let (_, printed) = state.passed(p);
    vec![
        (node::UNWOUND, format!("{} {}", say("ribbon.scene.unwound"), units::figure(state.unwound, 0, "mm"))),
        (node::UNWINDER_SPEED, format!("{} r/min", figure(now.spindle.actual, 1))),
        (node::UNWINDER_VOLTS, format!("{} V", figure(now.spindle.volts, 3))),
        (node::SLACK, [if state.slack >= 0.05 { "+" } else { "" }, &units::figure(state.slack, 1, "mm")].concat()),
        (node::LOOP_STATE, state_of_loop),
        (node::PULL_FEED, units::figure(now.axes[line.pull()].feed, 0, "mm/min")),
        (node::PULL_POSITION, units::figure(state.pulled, 1, "mm")),
        (node::PRINT_SPEED, format!("{} r/min", figure(state.print_speed / 6.0, 1))),
        (node::PRINT_HEAD, format!("{} {} / {}", say("ribbon.scene.head"), show(head, 0), show(heads, 0))),
        (node::DOT_COUNT, sentence(&msg!("ribbon.scene.dots", count = printed))),
    ]
}

//! The drawing of the ribbon line at a moment: angles of the rollers, dots, depth of the loop, figures.

use super::params::Params;
use super::resolved::RibbonLine;
use super::scene::{self, DOTS, PITCH, group, node};
use crate::machines::machine::Frame;
use crate::math::{self, PI};
use crate::motion::Snapshot;
use crate::text::catalog::number_text as show;
use crate::text::number::figure;
use crate::view::Pose;
use crate::view::scene::Placement;

/// Degrees per frame beyond which a roller is drawn as a blurred ring.
const SEEN: f64 = 20.0;

/// The state of the line at a moment, in the units of the drawing's figures.
pub(super) struct State {
    /// Revolutions of the unwinding roller.
    unwinder_turns: f64,
    /// Revolutions of the pull roller.
    pull_turns: f64,
    /// Degrees of the print roller.
    print_angle: f64,
    /// Ribbon pulled, mm.
    pub(super) pulled: f64,
    /// Ribbon unwound less ribbon pulled, mm.
    pub(super) slack: f64,
    /// Degrees per second of the rollers.
    speeds: [f64; 3],
}

impl State {
    pub(super) fn new(line: &RibbonLine, now: &Snapshot) -> State {
        let p = &line.p;
        let (x, y) = (&now.axes[line.pull()], &now.axes[line.print()]);
        // The axis itself, which lags its command.
        let pulled = x.actual;
        let turns = now.spindle.turns / p.reduction_ratio;
        let degrees = if line.degrees() { 1.0 } else { 360.0 / (PI * p.print_roller_diameter) };
        State {
            unwinder_turns: turns,
            pull_turns: pulled / (PI * p.x_roller_diameter),
            print_angle: y.actual * degrees,
            pulled,
            slack: turns * PI * p.press_roller_diameter - pulled,
            speeds: [
                now.spindle.actual / p.reduction_ratio * 6.0,
                x.feed / (PI * p.x_roller_diameter) * 6.0,
                y.feed * degrees / 60.0,
            ],
        }
    }

    /// Register error, mm of ribbon: `y = α · heads / 360 · pitch - x`, with the angle α [°] of the print roller and the pulled length x.
    pub(super) fn register(&self, p: &Params) -> f64 {
        self.print_angle * p.heads / 360.0 * p.pitch - self.pulled
    }
}

/// Placements, paths and figures at a moment.
pub(super) fn pose(line: &RibbonLine, now: &Snapshot, frame: Frame) -> Pose {
    let (p, state) = (&line.p, State::new(line, now));
    let [unwinder, pull, print] = state.speeds.map(|speed| (speed * frame.step).abs());
    let mut pose = Pose::default();
    let mut put = |group: u16, centre: (f64, f64, f64), turn: f64, opacity: f64| {
        let (cx, cy, _) = centre;
        pose.placements.push(Placement { turn: turn % 360.0, cx, cy, opacity, ..Placement::of(group) });
    };
    // Rollers below the ribbon turn with the clock, those above against it.
    let length = state.unwinder_turns * p.press_roller_diameter;
    let turn = 360.0 * state.unwinder_turns;
    put(group::REEL, scene::REEL, 360.0 * length / (6.0 * p.press_roller_diameter), 1.0);
    for (marks, blur, centre, turn, step) in [
        (group::UNWINDER, group::UNWINDER_BLUR, scene::UNWINDER, turn, unwinder),
        (group::PULL, group::PULL_BLUR, scene::PULL, 360.0 * state.pull_turns, pull),
    ] {
        put(marks, centre, turn, seen(step));
        put(blur, centre, 0.0, 0.5 * (1.0 - seen(step)));
    }
    let smaller = scene::UNWINDER.2 / scene::UNWINDER_PRESS.2;
    put(group::UNWINDER_PRESS, scene::UNWINDER_PRESS, -turn * smaller, seen(unwinder * smaller));
    put(group::PULL_PRESS, scene::PULL_PRESS, -360.0 * state.pull_turns * smaller, seen(pull * smaller));
    // The stroboscope flashes when a head meets the ribbon.
    let head = 360.0 / p.heads;
    let flash = |angle: f64| if frame.option { (angle / head).floor() * head } else { angle };
    let print_seen = if frame.option { 1.0 } else { seen(print) };
    put(group::PRINT, scene::PRINT, -flash(state.print_angle + 1e-6), print_seen);
    put(group::PRINT_BLUR, scene::PRINT, 0.0, 0.45 * (1.0 - print_seen));
    dots(line, now, frame, &state, &mut pose);
    pose.paths = vec![(node::LOOP, scene::loop_path(state.slack, p.loop_capacity))];
    pose.texts = texts(line, now, &state);
    pose
}

/// 1 where single marks can be followed by the eye, 0 where they blur, and a little in between.
fn seen(step: f64) -> f64 {
    Frame::seen(step, SEEN)
}

/// The dots move with X; the newest was printed where the last head met the ribbon.
fn dots(line: &RibbonLine, now: &Snapshot, frame: Frame, state: &State, pose: &mut Pose) {
    let p = &line.p;
    let passed = state.pulled / p.pitch + 1e-6;
    let printed = passed.floor();
    let part = if frame.option { 0.0 } else { passed - printed };
    let step = now.axes[line.pull()].feed / 60.0 * frame.step / p.pitch;
    // Beyond a third of a pitch a frame the eye joins wrong dots.
    let clear = if frame.option { 1.0 } else { math::clamp((0.45 - step) / 0.15, 0.0, 1.0) };
    for dot in 0..DOTS {
        let there = f64::from(dot) <= printed;
        pose.placements.push(Placement {
            group: group::DOTS + dot,
            dx: (f64::from(dot) + part) * PITCH,
            opacity: if there { clear } else { 0.0 },
            ..Placement::default()
        });
    }
    let streak = if printed >= f64::from(DOTS) { 0.35 * (1.0 - clear) } else { 0.0 };
    pose.placements.push(Placement { group: group::DOTS_BLUR, opacity: streak, ..Placement::default() });
}

fn texts(line: &RibbonLine, now: &Snapshot, state: &State) -> Vec<(u16, String)> {
    let p = &line.p;
    let heads = p.heads.max(1.0);
    let met = (state.print_angle * heads / 360.0 + 1e-6).floor();
    let head = met - (met / heads).floor() * heads + 1.0;
    let state_of_loop = if p.loop_capacity > 0.0 && state.slack.abs() > p.loop_capacity {
        if state.slack > 0.0 { "ribbon.scene.full" } else { "ribbon.scene.empty" }
    } else {
        "ribbon.scene.holds"
    };
    let say = |id| crate::text::catalog::words(crate::text::catalog::Language::English, id).to_owned();
    vec![
        (node::UNWINDER_SPEED, format!("{} r/min", figure(now.spindle.actual, 1))),
        (node::UNWINDER_VOLTS, format!("{} V", figure(now.spindle.volts, 3))),
        (node::SLACK, format!("{}{} mm", if state.slack >= 0.05 { "+" } else { "" }, figure(state.slack, 1))),
        (node::LOOP_STATE, say(state_of_loop)),
        (node::PULL_FEED, format!("{} mm/min", figure(now.axes[line.pull()].feed, 0))),
        (node::PULL_POSITION, format!("{} mm", figure(state.pulled, 1))),
        (node::PRINT_SPEED, format!("{} r/min", figure(state.speeds[2] / 6.0, 1))),
        (node::PRINT_HEAD, format!("{} {} / {}", say("ribbon.scene.head"), show(head, 0), show(heads, 0))),
        (node::DOT_COUNT, format!("{} {}", show((state.pulled / p.pitch + 1e-6).floor(), 0), say("ribbon.scene.dots"))),
    ]
}

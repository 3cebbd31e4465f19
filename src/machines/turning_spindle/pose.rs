//! The drawing of the turning spindle at a moment: outline of the part, positions of tool, jaws and needle, figures.

use super::params::{Output, Path};
use super::program::CUTS;
use super::resolved::TurningSpindle;
use super::scene::{self, JAWS, View, group, node};
use crate::drives::Bound;
use crate::drives::speed::surface_speed;
use crate::machines::machine::{Frame, Samples};
use crate::math::{self, PI};
use crate::motion::Snapshot;
use crate::text::catalog::number_text as show;
use crate::text::catalog::{Language, words};
use crate::text::number::{figure, filled};
use crate::view::Pose;
use crate::view::scene::Placement;

/// Points of the part's outline.
const POINTS: u32 = 48;
/// Degrees per frame beyond which the jaws blur.
const SEEN: f64 = 40.0;

/// How far the part is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Progress {
    /// Passes that are done.
    pub(super) done: u32,
    /// Where the tool cuts in the next one: Z along the part, the diameter on a face.
    pub(super) at: Option<f64>,
}

/// Progress of the part: starts of the cutting block, and position of the tool in it.
pub(super) fn progress(lathe: &TurningSpindle, run: &dyn Samples, now: &Snapshot) -> Progress {
    let p = &lathe.p;
    let (begun, mut cutting) = run.passes(CUTS[0], now.t);
    if p.path == Path::Taper {
        let (second, tapering) = run.passes(CUTS[1], now.t);
        // Between the two blocks of a pass.
        cutting |= tapering || second < begun;
    }
    let (radius, z) = lathe.tool(now);
    let at = if p.path == Path::Facing { 2.0 * radius } else { z };
    Progress { done: begun - u32::from(cutting && begun > 0), at: (cutting && begun > 0).then_some(at) }
}

/// Diameter of the finished part at a place: the taper goes on as a cylinder in front of the face.
fn contour(lathe: &TurningSpindle, z: f64) -> f64 {
    let p = &lathe.p;
    let end = if p.path == Path::Taper { p.large_diameter } else { p.finished_diameter };
    p.finished_diameter + (end - p.finished_diameter) * math::clamp(-z / p.length, 0.0, 1.0)
}

/// The outline of the part, both sides.
pub(super) fn outline(lathe: &TurningSpindle, progress: Progress) -> String {
    let (p, view) = (&lathe.p, View::new(&lathe.p));
    let Progress { done, at } = progress;
    let left = |pass: u32| p.left(f64::from(pass));
    let mut points: Vec<(f64, f64)> = vec![(-view.behind, p.stock_diameter)];
    if p.path == Path::Facing {
        let (face, rest) = (left(done), p.finished_diameter);
        match at.filter(|&d| d < p.stock_diameter) {
            Some(d) => {
                let (cut, d) = (left(done + 1), d.max(rest));
                points.extend([(cut, p.stock_diameter), (cut, d), (face, d)]);
            }
            None => points.push((face, p.stock_diameter)),
        }
        // The stub that remains where the cut ends short of the centre.
        let stub = if done > 0 { p.allowance } else { face };
        points.extend([(face, rest), (stub, rest), (stub, 0.0)]);
    } else {
        points.push((-p.length, p.stock_diameter));
        let cut = at.map_or(0.0, |z| math::clamp(z, -p.length, 0.0));
        let diameter = |z: f64, pass: u32| (contour(lathe, z) + left(pass)).min(p.stock_diameter);
        let places = (0..=POINTS).map(|k| -p.length * (1.0 - f64::from(k) / f64::from(POINTS)));
        points.extend(places.clone().filter(|&z| z < cut).map(|z| (z, diameter(z, done))));
        points.push((cut, diameter(cut, done)));
        if at.is_some() {
            points.push((cut, diameter(cut, done + 1)));
            points.extend(places.filter(|&z| z > cut).map(|z| (z, diameter(z, done + 1))));
        }
    }
    let mut d = String::new();
    let both = points.iter().copied().chain(points.iter().rev().map(|&(z, d)| (z, -d)));
    for (at, (z, diameter)) in both.enumerate() {
        let (x, y) = view.point(z, diameter);
        d += &filled(if at == 0 { "M# #" } else { "L# #" }, &[x, y]);
    }
    d.push('Z');
    d
}

/// Placements, paths and figures at a moment.
pub(super) fn pose(lathe: &TurningSpindle, run: &dyn Samples, now: &Snapshot, frame: Frame) -> Pose {
    let p = &lathe.p;
    let view = View::new(p);
    let (radius, z) = lathe.tool(now);
    let progress = progress(lathe, run, now);
    let turns = now.spindle.turns;
    let step = (now.spindle.actual * 6.0 * frame.step).abs();
    let seen = Frame::seen(step, SEEN);
    let mut pose = Pose::default();
    pose.placements.push(Placement {
        group: group::TOOL,
        dx: z * view.scale,
        dy: -radius * view.scale,
        opacity: 1.0,
        ..Placement::default()
    });
    let volts = now.spindle.volts / 10.0;
    let part = if p.output == Output::Bipolar { volts } else { 2.0 * volts - 1.0 };
    let (cx, cy, _) = scene::METER;
    let turn = math::clamp(part, -1.1, 1.1) * scene::SWEEP;
    pose.placements.push(Placement { turn, cx, cy, ..Placement::of(group::NEEDLE) });
    for jaw in 0..JAWS {
        let (s, c) = math::sin_cos(2.0 * PI * (turns % 1.0 + f64::from(jaw) / f64::from(JAWS)));
        let opacity = if c > -0.2 { seen } else { 0.25 * seen };
        pose.placements.push(Placement { group: group::JAWS + jaw, dy: 66.0 * s, opacity, ..Placement::default() });
    }
    pose.placements.push(Placement { group: group::BLUR, opacity: 0.35 * (1.0 - seen), ..Placement::default() });
    pose.paths = vec![(node::PART, outline(lathe, progress))];
    pose.texts = texts(lathe, now, progress);
    pose
}

fn texts(lathe: &TurningSpindle, now: &Snapshot, progress: Progress) -> Vec<(u16, String)> {
    let p = &lathe.p;
    let say = |id| words(Language::English, id).to_owned();
    let spindle = &now.spindle;
    let diameter = lathe.diameter(now);
    let pass = (progress.done + u32::from(progress.at.is_some())).max(1);
    let stage = lathe.p.stages().nth(usize::from(spindle.stage).saturating_sub(1)).unwrap_or(p.stage_1);
    vec![
        (node::SPEED, format!("{} r/min", figure(spindle.actual, 0))),
        (node::SURFACE, format!("{} m/min", figure(surface_speed(spindle.actual, diameter), 1))),
        (node::DIAMETER, format!("{} mm", figure(diameter, 2))),
        (node::STAGE, format!("{} · {} r/min", spindle.stage, show(stage, 0))),
        (node::VOLTS, format!("{} V", figure(spindle.volts, 3))),
        (node::PASS, format!("{pass} / {}", show(p.passes(), 0))),
        (node::BOUND, bound(spindle.bound).map(say).unwrap_or_default()),
    ]
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

//! The drawing of the polygon lathe at a moment: section, positions of cutter and slide, figures.

use super::outlines::closed;
use super::progress::{self, BarSection, GRID, Progress};
use super::resolved::{PolygonLathe, TOOL, WORK};
use super::scene::{self, Layout, TIPS, group, node};
use crate::machines::machine::Frame;
use crate::machines::machine::Samples;
use crate::math::{self, PI};
use crate::motion::Snapshot;
use crate::motion::snapshot::Mode;
use crate::text::catalog::words;
use crate::text::number::figure;
use crate::text::units;
use crate::view::Pose;
use crate::view::scene::Placement;

/// Turn (degrees per frame) beyond which a single insert blurs.
const SEEN: f64 = 60.0;
/// Turn (degrees per frame) beyond which the jaws of the chuck blur.
const SEEN_JAWS: f64 = 40.0;

/// Placements, paths and figures at a moment.
pub(super) fn pose(lathe: &PolygonLathe, run: &dyn Samples, now: &Snapshot, frame: Frame) -> Pose {
    let p = &lathe.params;
    let layout = Layout::new(lathe);
    let progress = progress::progress(lathe, run, now);
    let (across_flats, z) = lathe.slide(now);
    let mut pose = Pose::default();
    let mut place = |group: u16, turn: f64, (dx, dy): (f64, f64), opacity: f64| {
        pose.placements.push(Placement { turn, dx, dy, opacity, ..Placement::of(group) });
    };
    // Counter-clockwise in millimetres is clockwise on the screen, less the sign.
    let [mut work, tool] = [WORK, TOOL].map(|axis| -now.pmc[axis].actual % 360.0);
    // The main spindle turns the same work; the polygon's axes count on from where they were.
    let turns_end = progress::is_turning(now);
    if turns_end {
        work -= 360.0 * (now.spindle.turns - now.spindle.turns.floor());
    }
    let away = 0.5 * (across_flats - p.across_flats);
    let near = (0.0, 0.0);
    let present = progress::present(lathe, run, now, &progress);
    let polygon = lathe.polygons().nth(present).unwrap_or(lathe);
    // Distance of the present polygon's cutter from its own last position, and from that of the first cutter.
    let own = 0.5 * (across_flats - polygon.params.across_flats) * layout.scale;
    let aside = layout.of(polygon).cutter.0 + own - layout.cutter.0;
    let turned = |axis: usize, limit: f64| Frame::seen((6.0 * speed(now, axis) * frame.step).abs(), limit);
    let (seen, jaws) = (turned(TOOL, SEEN / polygon.params.inserts.max(1.0)), turned(WORK, SEEN_JAWS));
    place(group::WORK, work, near, 1.0);
    place(group::JAWS, 0.0, near, jaws);
    place(group::JAWS_BLUR, 0.0, near, 0.6 * (1.0 - jaws));
    place(group::EDGES, 0.0, near, turned(WORK, 0.5 * SEEN / polygon.params.sides.max(1.0)));
    for at in 0..=lathe.further.len() {
        let shown = f64::from(u8::from(at == present));
        let cutter = if turns_end { 0.0 } else { shown };
        place(group::of(group::DISC, at), 0.0, (own, 0.0), cutter);
        place(group::of(group::INSERTS, at), tool, near, seen);
        place(group::of(group::BLUR, at), 0.0, near, 0.5 * (1.0 - seen));
        for (group, opacity) in
            [(group::LENS, shown), (group::TRACES, cutter), (group::PASSES, shown), (group::RING, cutter)]
        {
            place(group::of(group, at), 0.0, near, opacity);
        }
    }
    if lathe.has_main_spindle() {
        let turning = f64::from(u8::from(turns_end));
        place(group::TURNING_TOOL, 0.0, (away * layout.scale, 0.0), turning);
        place(group::SIDE_TURNING, 0.0, near, turning);
        place(group::SIDE_CUTTER, 0.0, near, 1.0 - turning);
    }
    place(group::DISTANCE, 0.0, (scene::figure_at(&layout, aside), 0.0), 1.0);
    place(group::SIDE, 0.0, (z * layout.side, away * layout.side), 1.0);
    if let Some((_, tips)) = progress::tips(polygon, now) {
        let near = 1.02 * 0.5 * p.stock_diameter;
        for (group, (x, y)) in (group::TIPS..group::TIPS + TIPS).zip(tips) {
            let opacity = f64::from(u8::from(!turns_end && math::hypot(x, y) <= near));
            place(group, 0.0, (x * layout.close, -y * layout.close), opacity);
        }
    }
    let grid = progress::outline(lathe, &progress, now);
    let points = || {
        grid.iter().enumerate().map(|(at, radius)| {
            let (s, c) = math::sin_cos(2.0 * PI * at as f64 / GRID as f64);
            (radius * c, radius * s)
        })
    };
    let angle = -work / 180.0 * PI;
    let of_cutter = |path: String| if turns_end { String::new() } else { path };
    pose.paths = vec![
        (node::SECTION, closed(points(), (0.0, 0.0), layout.scale)),
        (node::CLOSE, closed(points(), (0.0, 0.0), layout.close)),
        (node::BAR, scene::bar(lathe, &layout, &progress)),
        (node::EDGES, edges(lathe, &layout, &progress, angle)),
        (node::DISTANCE, of_cutter(scene::distance(polygon, &layout, aside))),
        (node::LEADER, of_cutter(scene::leader((lathe, polygon), &layout, aside))),
        (node::IDEAL, scene::wanted(polygon, &layout)),
    ];
    pose.texts = texts((lathe, polygon), &layout, now, &progress);
    pose
}

/// Speed (r/min) of work or tool; the main spindle turns the work too.
fn speed(now: &Snapshot, axis: usize) -> f64 {
    now.pmc[axis].feed / 360.0 + if axis == WORK { now.spindle.actual } else { 0.0 }
}

/// The polygon from above: where the passes have cut deepest.
fn edges(lathe: &PolygonLathe, layout: &Layout, progress: &Progress, angle: f64) -> String {
    let cut = |BarSection { near, far, size }: BarSection| {
        scene::edges(lathe.at(0.5 * (near + far)), layout, size, (near, far), angle)
    };
    scene::profile(lathe, progress).into_iter().map(cut).collect()
}

/// Number of the pass; with the number of passes if its size is that of a pass of the form.
pub(super) fn pass(lathe: &PolygonLathe, progress: &Progress) -> String {
    let all: Vec<f64> = lathe.polygons().flat_map(|lathe| &lathe.sizes).copied().collect();
    let Some(now) = progress.now() else { return format!("1 / {}", all.len()) };
    let planned = all.get(now.before).is_some_and(|size| (size - now.size).abs() < 1e-3);
    let number = now.before + 1;
    if planned { format!("{number} / {}", all.len()) } else { number.to_string() }
}

fn texts(
    (lathe, polygon): (&PolygonLathe, &PolygonLathe),
    layout: &Layout,
    now: &Snapshot,
    progress: &Progress,
) -> Vec<(u16, String)> {
    let (across_flats, z) = lathe.slide(now);
    let [form, flatness, scales] = scene::form(polygon, layout);
    let [across, radius] = scene::sizes(polygon);
    let speed = |axis: usize| format!("{} r/min", figure(speed(now, axis), 1));
    let (turns, turns_end) = (now.pmc[TOOL].feed != 0.0, progress::is_turning(now));
    let state = match now.mode {
        Mode::EmergencyStop => "polygon.state.emergency",
        Mode::Hold if turns => "polygon.state.held",
        _ if turns => "polygon.state.turns",
        _ if turns_end => "polygon.state.turning",
        _ => "polygon.state.stands",
    };
    // Without the cutter there is no distance of its axis.
    let apart =
        if turns_end { String::new() } else { units::figure(0.5 * across_flats + polygon.params.tip_radius, 2, "mm") };
    vec![
        (node::WORK_SPEED, speed(WORK)),
        (node::TOOL_SPEED, speed(TOOL)),
        (node::SIZE, format!("X {}", figure(lathe.x_of(across_flats), 3))),
        (node::PASS, pass(lathe, progress)),
        (node::PHASE, format!("{}°", figure(lathe.phase(now), 2))),
        (node::APART, apart),
        (node::ALONG, format!("Z {}", figure(z, 3))),
        (node::STATE, words(state).to_owned()),
        (node::FORM, form),
        (node::FLATNESS, flatness),
        (node::SCALES, scales),
        (node::ACROSS, across),
        (node::RADIUS, radius),
    ]
}

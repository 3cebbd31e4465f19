//! Progress of the part: passes done, position of the present pass, and the outline of the stock at its face.
//!
//! Applies to any program: a pass is a visit of the slide to the stock, behind its face and within its diameter. The
//! outline is computed for every frame from the angles of the two axes at the start of the pass, so that a phase error
//! or a wrong start angle is visible. It is a polar grid for the drawing only; results come from the exact section.

use super::program;
use super::resolved::{PolygonLathe, TOOL, WORK};
use crate::drives::polygon::{Curve, CutterSetup};
use crate::machines::machine::Samples;
use crate::math::{self, PI};
use crate::motion::Snapshot;
use crate::motion::timeline::Visit;

/// Angles of the grid.
pub(super) const GRID: usize = 360;
/// Steps along a pass of an insert.
const STEPS: u32 = 48;
/// Greatest number of insert passes per frame.
const MOST: i64 = 600;
/// Greatest number of slide passes, the newest.
const MAX_SLIDE_PASSES: usize = 200;

/// A pass of the slide.
#[derive(Debug, Clone, Copy)]
pub(super) struct SlidePass {
    /// Number of passes before it.
    pub(super) before: usize,
    /// Across flats.
    pub(super) size: f64,
    /// Part of the work that it has cut: distances of its near and its far end from the face, mm.
    pub(super) span: (f64, f64),
    /// The machine at the time when the slide reached the stock.
    since: Snapshot,
}

impl SlidePass {
    /// Distance of its middle from the face, mm.
    pub(super) fn middle(&self) -> f64 {
        0.5 * (self.span.0 + self.span.1)
    }

    /// Whether both have cut a part of the same length.
    fn overlaps(&self, other: &SlidePass) -> bool {
        self.span.0 < other.span.1 && other.span.0 < self.span.1
    }
}

/// A section of the bar that is cut to one size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BarSection {
    /// Distances of both ends from the face, mm.
    pub(super) near: f64,
    pub(super) far: f64,
    /// Diameter or size across flats, mm.
    pub(super) size: f64,
}

/// The passes of the slide so far.
#[derive(Debug, Clone, Default)]
pub(super) struct Progress {
    /// All passes, or the newest of very many; the present one is the last.
    pub(super) passes: Vec<SlidePass>,
    /// The deepest pass before the last one on its length.
    pub(super) done: Option<SlidePass>,
    /// Sections that the spindle has turned.
    pub(super) turned_sections: Vec<BarSection>,
}

impl Progress {
    /// The passes, each with its section of the bar.
    pub(super) fn pass_sections(&self) -> impl Iterator<Item = BarSection> {
        self.passes.iter().map(|pass| BarSection { near: pass.span.0, far: pass.span.1, size: pass.size })
    }

    /// The present pass, or the last.
    pub(super) fn now(&self) -> Option<&SlidePass> {
        self.passes.last()
    }
}

/// Visits of the slide to the stock up to a time (s): beyond its face and within its diameter.
fn visits(lathe: &PolygonLathe, run: &dyn Samples, until: f64) -> Vec<Visit> {
    run.visits([(lathe.cross(), 0.5 * lathe.params.stock_diameter), (lathe.along(), 0.0)], until)
}

/// Whether the main spindle turns the work, with the tool axis at rest.
pub(super) fn is_turning(now: &Snapshot) -> bool {
    now.pmc[TOOL].feed == 0.0 && now.spindle.actual != 0.0
}

/// Progress of the slide up to now.
pub(super) fn progress(lathe: &PolygonLathe, run: &dyn Samples, now: &Snapshot) -> Progress {
    let p = &lathe.params;
    let visits = visits(lathe, run, now.t);
    let first = visits.len().saturating_sub(MAX_SLIDE_PASSES);
    let mut progress = Progress::default();
    for visit in visits.into_iter().skip(first) {
        let since = run.at(visit.begin);
        if is_turning(&since) {
            let far = -visit.along.0;
            let threaded = p.turned_ends.iter().filter(|end| end.on && end.pitch > 0.0 && far <= end.length);
            // The drawing of a thread has no flanks.
            let least = threaded.map(|end| end.diameter).fold(0.0, f64::max).min(p.stock_diameter);
            let (near, size) = ((-visit.along.1).max(0.0), (2.0 * visit.across).max(least));
            progress.turned_sections.push(BarSection { near, far, size });
        }
        if since.pmc[TOOL].feed == 0.0 {
            continue;
        }
        // The commanded end of the pass: the position at this moment may already belong to the retract.
        let span = ((-visit.along.1 - p.insert_width).max(0.0), -visit.along.0);
        progress.passes.push(SlidePass { before: progress.passes.len(), size: 2.0 * visit.across, span, since });
    }
    if let Some((now, before)) = progress.passes.split_last() {
        let before = before.iter().filter(|pass| pass.overlaps(now));
        progress.done = before.min_by(|a, b| a.size.total_cmp(&b.size)).copied();
    }
    progress
}

/// Spans (s) up to a time in which the slide is in the stock with the tool turning.
pub(super) fn cuts(lathe: &PolygonLathe, run: &dyn Samples, until: f64) -> Vec<(f64, f64)> {
    let visits = visits(lathe, run, until);
    let of_tool = visits.iter().filter(|visit| run.at(visit.begin).pmc[TOOL].feed != 0.0);
    of_tool.map(|visit| (visit.begin, visit.end)).collect()
}

/// Spans (s) up to a time in which the slide is in the stock while the main spindle turns it.
pub(super) fn turning_spans(lathe: &PolygonLathe, run: &dyn Samples, until: f64) -> Vec<(f64, f64)> {
    let visits = visits(lathe, run, until);
    let turned = visits.iter().filter(|visit| is_turning(&run.at(visit.begin)));
    turned.map(|visit| (visit.begin, visit.end)).collect()
}

/// Index (from 0) of the polygon being turned: the polygon of the newest pass, or the next one as soon as the program has begun with it.
pub(super) fn present(lathe: &PolygonLathe, run: &dyn Samples, now: &Snapshot, progress: &Progress) -> usize {
    let holds = |lathe: &PolygonLathe, at: f64| (lathe.params.from_face..=lathe.params.far_end()).contains(&at);
    let cut = progress.now().and_then(|pass| lathe.polygons().position(|lathe| holds(lathe, pass.middle())));
    let others = 1..=lathe.further.len();
    let begun = others.rev().find(|at| run.executions(program::change_over(*at as u32), now.t).begun > 0);
    cut.max(begun).unwrap_or(0)
}

/// Distances of the outline from the centre at the face, at [`GRID`] angles of the work.
pub(super) fn outline(lathe: &PolygonLathe, progress: &Progress, now: &Snapshot) -> Vec<f64> {
    let middle = progress.now().map_or(0.5 * lathe.params.length + lathe.params.from_face, SlidePass::middle);
    let over = progress.turned_sections.iter().filter(|turned| (turned.near..=turned.far).contains(&middle));
    let stock = over.map(|turned| turned.size).fold(lathe.params.stock_diameter, f64::min);
    let mut grid = vec![0.5 * stock; GRID];
    for pass in progress.done.iter().chain(progress.now()) {
        cut(&mut grid, lathe, pass, now);
    }
    grid
}

/// Cuts the grid by the insert passes since the slide reached the face, up to one closed pattern.
fn cut(grid: &mut [f64], lathe: &PolygonLathe, slide: &SlidePass, now: &Snapshot) {
    let Some(setup) = lathe.at(slide.middle()).params.setup(slide.size) else { return };
    let k = setup.ratio.value();
    let [work, tool] = [WORK, TOOL].map(|axis| slide.since.pmc[axis].actual / 360.0);
    let closes = f64::from(setup.ratio.work());
    let turns = math::clamp(now.pmc[WORK].actual / 360.0 - work, -closes, closes);
    for (at, tip) in setup.tips.iter().enumerate() {
        let Some(curve) = setup.curve(at) else { continue };
        // An insert points at the work when the turns of the tool and its own place come to a whole number.
        let here = tool + tip.angle / (2.0 * PI);
        let then = here + k * turns;
        let (first, last) = (here.min(then).ceil() as i64, here.max(then).floor() as i64);
        for crossing in (first..=last).take(MOST as usize) {
            let normal = -(work + (crossing as f64 - here) / k);
            pass(grid, &curve, 2.0 * PI * normal, 0.5 * lathe.params.stock_diameter);
        }
    }
}

/// One pass of an insert about a normal.
fn pass(grid: &mut [f64], curve: &Curve, normal: f64, stock: f64) {
    let edge = curve.sigma_at(stock);
    let point = |step: u32| {
        let sigma = edge * f64::from(step) / f64::from(STEPS);
        (curve.turn(sigma), curve.reach(sigma))
    };
    let pitch = 2.0 * PI / grid.len() as f64;
    for step in 0..STEPS {
        let (from, to) = (point(step), point(step + 1));
        for hand in [-1.0, 1.0] {
            let ends = [(normal + hand * from.0, from.1), (normal + hand * to.0, to.1)];
            let (low, high) = if ends[0].0 < ends[1].0 { (ends[0], ends[1]) } else { (ends[1], ends[0]) };
            let (first, last) = ((low.0 / pitch).ceil() as i64, (high.0 / pitch).floor() as i64);
            for at in first..=last.min(first + GRID as i64) {
                let part = (at as f64 * pitch - low.0) / (high.0 - low.0).max(1e-12);
                let reach = low.1 + (high.1 - low.1) * part;
                if let Some(place) = grid.get_mut(at.rem_euclid(GRID as i64) as usize) {
                    *place = place.min(reach);
                }
            }
        }
    }
}

/// Positions of the cutter's tips on the work, and the setup with the present distance of the axes.
pub(super) fn tips(lathe: &PolygonLathe, now: &Snapshot) -> Option<(CutterSetup, Vec<(f64, f64)>)> {
    let (across_flats, _) = lathe.slide(now);
    let mut setup = lathe.params.setup(across_flats)?;
    setup.distance = 0.5 * across_flats + setup.radius;
    let [work, tool] = [WORK, TOOL].map(|axis| now.pmc[axis].actual / 180.0 * PI);
    let on_work = (0..setup.tips.len()).filter_map(|insert| setup.tip_on_work(insert, work, tool)).collect();
    Some((setup, on_work))
}

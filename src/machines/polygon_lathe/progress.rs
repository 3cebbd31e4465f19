//! How far the part is: which passes have cut, how far the present one is, and what is left of the stock at its face.
//!
//! The outline is cut again for every frame from the angles of the two axes as they are: a phase error or a wrong start angle shows. It is a
//! polar grid, for the eye; what is measured comes from the exact section.

use super::fitted::{Fitted, TOOL, WORK};
use super::program;
use crate::drives::polygon::{Curve, Setup};
use crate::machines::Samples;
use crate::math::{self, PI};
use crate::motion::Snapshot;
use crate::motion::snapshot::Mode;

/// Angles of the grid.
pub(super) const GRID: usize = 360;
/// Steps along a pass of an insert.
const STEPS: u32 = 48;
/// Passes of inserts that are cut again at most.
const MOST: i64 = 600;

/// How far the part is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Progress {
    /// Passes of the slide that have cut past the face.
    pub(super) done: u32,
    /// Turns of the work since the present one has come to the face, and how far the slide is behind it in mm.
    pub(super) at: Option<(f64, f64)>,
}

/// Which of the cutting blocks have begun, and where the slide stands.
pub(super) fn progress(lathe: &Fitted, run: &dyn Samples, now: &Snapshot) -> Progress {
    let p = &lathe.p;
    let all = p.passes() as u32;
    let cuts = (1..=all).map(|pass| run.passes(program::number(pass) + 1, now.t));
    let (begun, cutting) =
        cuts.fold((0, false), |(begun, cutting), (times, now)| (begun + u32::from(times > 0), cutting || now));
    if !cutting || begun == 0 {
        return Progress { done: begun, at: None };
    }
    let (_, z) = lathe.slide(now);
    let behind = (-z).max(0.0);
    let turns = behind / p.feed_of(f64::from(begun));
    Progress { done: begun - 1, at: (behind > 0.0).then_some((turns, behind)) }
}

/// The angles that cut the part: what turns on when the program has been broken off cuts nothing at the face any more.
pub(super) fn cutting(lathe: &Fitted, run: &dyn Samples, now: &Snapshot) -> Snapshot {
    let blocks = || (1..=lathe.sizes.len() as u32).map(program::number);
    let begun = |t: f64| blocks().map(|block| run.passes(block + 1, t).0).sum::<u32>();
    let all = begun(now.t);
    if now.mode != Mode::EmergencyStop || all == 0 {
        return *now;
    }
    // When the last of the cutting blocks began.
    let (mut before, mut after) = (0.0, now.t);
    while after - before > 1e-3 {
        let middle = 0.5 * (before + after);
        *(if begun(middle) < all { &mut before } else { &mut after }) = middle;
    }
    run.at(after)
}

/// Distances of the outline from the centre at the face, at [`GRID`] angles of the work.
pub(super) fn outline(lathe: &Fitted, progress: Progress, now: &Snapshot) -> Vec<f64> {
    let p = &lathe.p;
    let mut grid = vec![0.5 * p.stock_diameter; GRID];
    let closes = lathe.ratio().map_or(0.0, |ratio| f64::from(ratio.work()));
    if progress.done > 0 {
        cut(&mut grid, lathe, p.size(f64::from(progress.done)), closes, now);
    }
    if let Some((turns, _)) = progress.at {
        cut(&mut grid, lathe, p.size(f64::from(progress.done + 1)), turns.min(closes), now);
    }
    grid
}

/// Cuts what the inserts have cut in the last turns of the work.
fn cut(grid: &mut [f64], lathe: &Fitted, across_flats: f64, turns: f64, now: &Snapshot) {
    let Some(setup) = lathe.setup(across_flats) else { return };
    let k = setup.ratio.value();
    let [work, tool] = [WORK, TOOL].map(|axis| now.pmc[axis].actual / 360.0);
    for (at, tip) in setup.tips.iter().enumerate() {
        let Some(curve) = setup.curve(at) else { continue };
        // An insert points at the work when the turns of the tool and its own place come to a whole number.
        let here = tool + tip.angle / (2.0 * PI);
        let since = here - k * turns;
        let (first, last) = (here.min(since).ceil() as i64, here.max(since).floor() as i64);
        for crossing in (first..=last).rev().take(MOST as usize) {
            let normal = -(work - (here - crossing as f64) / k);
            pass(grid, &curve, 2.0 * PI * normal, 0.5 * lathe.p.stock_diameter);
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

/// Where the tips are on the work, and how far the axes are apart, at a setting of the slide.
pub(super) fn tips(lathe: &Fitted, now: &Snapshot) -> Option<(Setup, Vec<(f64, f64)>)> {
    let (across_flats, _) = lathe.slide(now);
    let mut setup = lathe.setup(across_flats)?;
    setup.distance = 0.5 * across_flats + setup.radius;
    let [work, tool] = [WORK, TOOL].map(|axis| now.pmc[axis].actual / 180.0 * PI);
    let (s, c) = math::sin_cos(work);
    let on_work = setup.tips.iter().map(|tip| {
        let (sin, cos) = math::sin_cos(tool + tip.angle);
        let (x, y) = (setup.distance - tip.radius * cos, -tip.radius * sin);
        (x * c + y * s, y * c - x * s)
    });
    let on_work = on_work.collect();
    Some((setup, on_work))
}

//! Demand on the spindle's motor in a run: chuck and work against friction and cut.

use super::driven;
use super::params::Path;
use super::program::cut_block;
use super::resolved::TurningSpindle;
use crate::drives::cutting;
use crate::drives::load::through_gear;
use crate::drives::shaft_motion::{CutSpan, Motion};
use crate::machines::driven::{SpindleRun, speed_segments};
use crate::machines::machine::Samples;
use crate::math::{self, RPM};
use crate::motion::RunSegment;

/// Least and greatest number of pieces into which a cut is divided, each with one torque; and greatest number of pieces
/// of all cuts of a run.
const PIECES: (usize, usize) = (4, 48);
const ALL_PIECES: usize = 2000;

/// Halvings in the search for the time at which the tool enters or leaves the stock.
const HALVINGS: u32 = 20;

/// The spindle's motor in segments of a run, at its shaft.
pub(super) fn in_run(lathe: &TurningSpindle, run: &dyn Samples, segments: &[RunSegment]) -> SpindleRun {
    let (p, gear) = (&lathe.params, driven::gear(lathe));
    let idle = Motion::new(speed_segments(segments, gear * RPM), driven::load_at_motor(lathe), 0.0);
    p.spindle.run(driven::NAME, idle, cuts(lathe, run, segments))
}

/// The spans of a run in which the tool cuts, up to a time.
pub(super) fn working(lathe: &TurningSpindle, run: &dyn Samples, until: f64) -> Vec<(f64, f64)> {
    let whole = RunSegment { t: 0.0, seconds: until, from: 0.0, to: 0.0 };
    let mut works: Vec<(f64, f64)> = Vec::new();
    for cut in cuts(lathe, run, &[whole]) {
        match works.last_mut() {
            Some((_, end)) if *end == cut.begin => *end = cut.end,
            _ => works.push((cut.begin, cut.end)),
        }
    }
    works
}

/// The spans in which the tool cuts, each so short that its mean torque represents it.
fn cuts(lathe: &TurningSpindle, run: &dyn Samples, segments: &[RunSegment]) -> Vec<CutSpan> {
    let (p, gear) = (&lathe.params, driven::gear(lathe));
    let Some((from, to)) = segments.first().zip(segments.last()).map(|(a, b)| (a.t, b.t + b.seconds)) else {
        return Vec::new();
    };
    let spans = run.execution_spans(cut_block(p.path), to);
    let count = (ALL_PIECES / spans.len().max(1)).clamp(PIECES.0, PIECES.1);
    let mut cuts = Vec::new();
    for (begin, end) in spans {
        let (begin, end) = (begin.max(from), end.min(to));
        if begin >= end {
            continue;
        }
        let tips: Vec<Tip> =
            (0..=count).map(|at| Tip::at(lathe, run, begin + (end - begin) * at as f64 / count as f64)).collect();
        for pair in tips.windows(2) {
            if let [a, b] = pair
                && let Some((a, b)) = within_stock(lathe, run, *a, *b)
            {
                let torque = cutting::torque(p.cutting_force, 0.5 * (a.diameter + b.diameter));
                cuts.push(CutSpan { begin: a.t, end: b.t, torque: through_gear(torque, gear, p.efficiency / 100.0) });
            }
        }
    }
    cuts
}

/// The tool at a time in a run.
#[derive(Clone, Copy)]
struct Tip {
    /// Seconds.
    t: f64,
    /// Diameter at the middle of the edge, mm.
    diameter: f64,
    /// Whether the tool moves in the stock.
    cuts: bool,
}

impl Tip {
    fn at(lathe: &TurningSpindle, run: &dyn Samples, t: f64) -> Tip {
        let p = &lathe.params;
        let now = run.at(t);
        let (diameter, (_, z)) = (lathe.diameter(&now), lathe.tool(&now));
        let moves =
            [lathe.cross(), lathe.along()].iter().any(|axis| now.axes.get(*axis).is_some_and(|axis| axis.feed != 0.0));
        let along = p.path == Path::Facing || (-p.length..0.0).contains(&z);
        let cuts = moves && along && diameter.abs() < p.stock_diameter;
        Tip { t, diameter: p.middle_of_edge(diameter), cuts }
    }
}

/// The tool at the start and at the end of its motion in the stock, within a span of a cutting block from `a` to `b`.
fn within_stock(lathe: &TurningSpindle, run: &dyn Samples, a: Tip, b: Tip) -> Option<(Tip, Tip)> {
    let edge = |inside: Tip, outside: Tip| {
        let cuts = |t: f64| Tip::at(lathe, run, t).cuts;
        Tip::at(lathe, run, math::last_holding(inside.t, outside.t, HALVINGS, cuts))
    };
    match (a.cuts, b.cuts) {
        (true, true) => Some((a, b)),
        (true, false) => Some((a, edge(a, b))),
        (false, true) => Some((edge(b, a), b)),
        (false, false) => {
            let middle = Tip::at(lathe, run, 0.5 * (a.t + b.t));
            middle.cuts.then(|| (edge(middle, a), edge(middle, b)))
        }
    }
}

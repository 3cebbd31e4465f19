//! Demands on the inserts: relief, cutting speed, feed marks, and their position errors.

use super::cut::{DEGREES, PolygonCut};
use super::speeds::PolygonSpeeds;
use crate::drives::polygon::cut;
use crate::machines::polygon_lathe::params::Params;

/// The insert with the greatest error of one kind.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(in crate::machines::polygon_lathe) struct WorstInsert {
    /// Number, from 1.
    pub number: f64,
    pub error: f64,
}

/// Demands on the inserts, of all passes.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::machines::polygon_lathe) struct InsertDemands {
    /// Greatest relief that a pass needs (°), and the number of that pass, from 1.
    pub relief: f64,
    pub relief_pass: f64,
    /// Whether the inserts face as on a cutter that turns in the direction of the work.
    pub faces_forward: bool,
    /// Least and greatest cutting speed, m/min.
    pub slowest_cut: f64,
    pub fastest_cut: f64,
    /// Distances of the feed marks on a flat, in roughing and in the last pass, mm.
    pub mark_pitches: [f64; 2],
    /// Greatest radial error, mm.
    pub depth: WorstInsert,
    /// Greatest angular error, as the rotation of the insert's sides (°).
    pub turn: WorstInsert,
}

impl InsertDemands {
    pub(super) fn new(p: &Params, cut: &PolygonCut, speeds: &PolygonSpeeds) -> InsertDemands {
        let PolygonCut { setup, curve, demand, .. } = cut;
        let speed = speeds.work.abs();
        let worst = |error: fn((f64, f64)) -> f64| {
            let errors = (0..setup.tips.len())
                .map(|insert| WorstInsert { number: insert as f64 + 1.0, error: error(setup.error(insert)) });
            let more = |worst: WorstInsert, next: WorstInsert| {
                if next.error.abs() > worst.error.abs() { next } else { worst }
            };
            errors.fold(WorstInsert::default(), more)
        };
        let (depth, turn) = (worst(|error| error.0), worst(|error| error.1));
        InsertDemands {
            relief: demand.relief * DEGREES,
            relief_pass: cut.relief_pass,
            faces_forward: curve.faces_forward(),
            slowest_cut: speed * demand.speeds.0,
            fastest_cut: speed * demand.speeds.1,
            mark_pitches: [p.feed, p.finish_feed].map(|feed| cut::mark_pitch(setup.ratio, setup.inserts(), feed)),
            depth,
            turn: WorstInsert { error: turn.error * DEGREES / speeds.ratio, ..turn },
        }
    }
}

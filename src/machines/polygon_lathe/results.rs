//! Results of all polygons of a part: all results of the first polygon, and the results of each other one that are not shared.

use super::further::field;
use super::readouts::ROWS;
use super::resolved::PolygonLathe;
use super::rules::RULES;
use crate::machines::lathe::slides;
use crate::machines::verdict::{self, judge};
use crate::text::Phrase;
use crate::view::{Advice, FieldEntry, Readout};

/// Id of a result of the first polygon, with id and label of the corresponding result of each other polygon.
#[rustfmt::skip]
const RESULTS: &[(&str, [(&str, &str); 2])] = &[
    ("sides", [("second-sides", "polygon.second.sides"), ("third-sides", "polygon.third.sides")]),
    ("flatness", [("second-flatness", "polygon.second.flatness"), ("third-flatness", "polygon.third.flatness")]),
    ("across-flats", [("second-across-flats", "polygon.second.across-flats"), ("third-across-flats", "polygon.third.across-flats")]),
    (ANGLE, [("second-angle", "polygon.second.angle"), ("third-angle", "polygon.third.angle")]),
    ("orientation-error", [("second-angle-error", "polygon.second.angle-error"), ("third-angle-error", "polygon.third.angle-error")]),
    ("relief", [("second-relief", "polygon.second.relief"), ("third-relief", "polygon.third.relief")]),
    ("curvature", [("second-curvature", "polygon.second.curvature"), ("third-curvature", "polygon.third.curvature")]),
    ("tool-speed", [("second-tool-speed", "polygon.second.tool-speed"), ("third-tool-speed", "polygon.third.tool-speed")]),
    ("work-speed", [("second-work-speed", "polygon.second.work-speed"), ("third-work-speed", "polygon.third.work-speed")]),
    ("slowest-cut", [("second-slowest-cut", "polygon.second.slowest-cut"), ("third-slowest-cut", "polygon.third.slowest-cut")]),
    ("fastest-cut", [("second-fastest-cut", "polygon.second.fastest-cut"), ("third-fastest-cut", "polygon.third.fastest-cut")]),
    ("distance", [("second-distance", "polygon.second.distance"), ("third-distance", "polygon.third.distance")]),
    ("reach", [("second-reach", "polygon.second.reach"), ("third-reach", "polygon.third.reach")]),
    ("offset", [("second-offset", "polygon.second.offset"), ("third-offset", "polygon.third.offset")]),
    ("feed", [("second-feed", "polygon.second.feed"), ("third-feed", "polygon.third.feed")]),
    ("infeed", [("second-infeed", "polygon.second.infeed"), ("third-infeed", "polygon.third.infeed")]),
];

/// Ids of the results of a further polygon, from 0.
pub(super) fn ids(at: usize) -> Vec<&'static str> {
    RESULTS.iter().filter_map(|(_, others)| others.get(at)).map(|(id, _)| *id).collect()
}

/// The result that, for a further polygon, is its angle to the first polygon.
const ANGLE: &str = "orientation";

/// Rewrites an advice about the first polygon for another one. Its button stays only if every field has a counterpart
/// there.
fn advice(advice: Advice, at: usize) -> Advice {
    let of_other = |entry: FieldEntry| Some(FieldEntry { field: field(entry.field, at)?, ..entry });
    let entries: Option<Vec<FieldEntry>> = advice.entries.into_iter().map(of_other).collect();
    match (advice.button, entries) {
        (Some(button), Some(entries)) => Advice::from(advice.message).setting(button, entries),
        _ => Advice::from(advice.message),
    }
}

/// The results of all polygons of the part.
pub(super) fn results(lathe: &PolygonLathe) -> Vec<Readout> {
    let mut all: Vec<Readout> = verdict::results(ROWS, lathe, RULES).collect();
    for (at, other) in lathe.further.iter().enumerate() {
        for (first, others) in RESULTS {
            let row = ROWS.iter().find(|row| row.id == *first).filter(|row| (row.shown)(other));
            let (Some(row), Some((id, label))) = (row, others.get(at)) else { continue };
            let judged = judge(row, other, RULES);
            let advice = judged.advice.into_iter().map(|first| advice(first, at)).collect();
            let mut readout = Readout { id, label, headline: false, advice, ..judged };
            if *first == ANGLE {
                let pitch = 360.0 / other.derived.section.sides.max(1.0);
                readout.value = (other.derived.angles.orientation - lathe.derived.angles.orientation).rem_euclid(pitch);
                readout.formula = Phrase::new("E/k - A, less that of the first polygon");
            }
            all.push(readout);
        }
    }
    all.extend(slides::results(lathe));
    all
}

//! Fields and faults of the second and the third polygon of a part: own place, sides, start angles and cutter; all else is shared with the first.

use super::resolved::PolygonLathe;
use crate::msg;
use crate::text::Message;

/// Fields of the first polygon, and the corresponding ones of the others.
const COUNTERPARTS: &[(&str, [&str; 2])] = &[
    ("shape", ["second-shape", "third-shape"]),
    ("sides", ["second-sides", "third-sides"]),
    ("across-flats", ["second-across-flats", "third-across-flats"]),
    ("from-face", ["second-from-face", "third-from-face"]),
    ("length", ["second-length", "third-length"]),
    ("inserts", ["second-inserts", "third-inserts"]),
    ("work-ratio", ["second-work-ratio", "third-work-ratio"]),
    ("tool-ratio", ["second-tool-ratio", "third-tool-ratio"]),
    ("work-start", ["second-work-start", "third-work-start"]),
    ("tool-start", ["second-tool-start", "third-tool-start"]),
    // One overhang for all cutters.
    ("overhang", ["overhang", "overhang"]),
    ("tip-radius", ["second-tip-radius", "third-tip-radius"]),
];

/// The field of a further polygon, from 0; none if it shares the first one's.
pub(super) fn field(id: &str, at: usize) -> Option<&'static str> {
    COUNTERPARTS.iter().find(|(first, _)| *first == id).and_then(|(_, others)| others.get(at).copied())
}

/// Faults of the further polygons, each with its field: faults of a single polygon, overlapping places, cutters that do not fit.
pub(super) fn faults(
    lathe: &PolygonLathe,
    alone: impl Fn(&PolygonLathe) -> Vec<(Message, &'static str)>,
) -> Vec<(Message, &'static str)> {
    let mut all = Vec::new();
    for (at, other) in lathe.further.iter().enumerate() {
        all.extend(alone(other).into_iter().map(|(message, id)| (message, field(id, at).unwrap_or(id))));
        for (number, before) in (1_u32..).zip(lathe.polygons().take(at + 1)) {
            let (p, q) = (&before.p, &other.p);
            if p.from_face < q.far_end() && q.from_face < p.far_end() {
                let message = msg!("polygon.overlap", number, from = (p.from_face, 3), to = (p.far_end(), 3));
                all.extend(field("from-face", at).map(|id| (message, id)));
            }
            if p.tool == q.tool && p.inserts != q.inserts {
                let message = msg!("polygon.same-cutter", tool = q.tool, inserts = p.inserts, needed = q.inserts);
                all.push((message, ["second-tool", "third-tool"][at.min(1)]));
            }
            if p.tool == q.tool && p.tip_radius != q.tip_radius {
                let message =
                    msg!("polygon.same-radius", tool = q.tool, radius = (p.tip_radius, 3), needed = (q.tip_radius, 3));
                all.extend(field("tip-radius", at).map(|id| (message, id)));
            }
        }
    }
    all
}

//! Faults of the second and the third polygon of a part, which have their own position, sides, start angles and cutter; all else is shared with the first.

use super::further_form::FURTHER;
use super::resolved::PolygonLathe;
use crate::msg;
use crate::text::Message;

/// The field of the further polygon `at` (from 0) for a field of the first one; none if it shares that field.
pub(super) fn field(id: &str, at: usize) -> Option<&'static str> {
    FURTHER.get(at)?.counterpart(id)
}

/// Faults of the further polygons, each with its field: faults of the polygon by itself (`alone`), overlapping
/// positions, cutters that differ under one tool number.
pub(super) fn faults(
    lathe: &PolygonLathe,
    alone: impl Fn(&PolygonLathe) -> Vec<(Message, &'static str)>,
) -> Vec<(Message, &'static str)> {
    let mut all = Vec::new();
    for (at, other) in lathe.further.iter().enumerate() {
        all.extend(alone(other).into_iter().map(|(message, id)| (message, field(id, at).unwrap_or(id))));
        for (number, before) in (1_u32..).zip(lathe.polygons().take(at + 1)) {
            let (p, q) = (&before.params, &other.params);
            if p.from_face < q.far_end() && q.from_face < p.far_end() {
                let message = msg!("polygon.overlap", number, from = (p.from_face, 3), to = (p.far_end(), 3));
                all.extend(field("from-face", at).map(|id| (message, id)));
            }
            if p.tool == q.tool && p.inserts != q.inserts {
                let message = msg!("polygon.same-cutter", tool = q.tool, inserts = p.inserts, needed = q.inserts);
                all.push((message, FURTHER[at.min(1)].tool));
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

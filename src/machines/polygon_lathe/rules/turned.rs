//! The rule of an end turned after the polygons where the part is already thinner: its diameter is not reached.

use crate::machines::form::entry::at_most;
use crate::machines::polygon_lathe::params::FIELDS;
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::machines::polygon_lathe::turned_end_form::TURNED_ENDS;
use crate::machines::verdict::{Judgement, fail, ok};
use crate::msg;
use crate::view::Advice;
use crate::view::Limit::Equal;

/// Judges the diameter that the end turned after the polygons reaches against its entered one.
pub(super) fn reached(lathe: &PolygonLathe) -> Option<Judgement> {
    let p = &lathe.params;
    let [_, after] = &*p.turned_ends;
    let (reached, limit) = (after.reached(p), Equal(after.diameter));
    if reached >= after.diameter {
        return ok(limit);
    }
    let set = at_most(FIELDS, TURNED_ENDS[1].diameter, reached);
    let message = msg!("polygon.thinner-end", diameter = (reached, 3), asked = (after.diameter, 3));
    let button = msg!("advice.set-diameter", diameter = (set.value, 3));
    fail(limit, [Advice::from(message).setting(button, [set])])
}

//! The rules of the cutter's place: distance of the axes, reach of its body, and the jaws.

use crate::drives::polygon::SAME_LENGTH;
use crate::machines::form::entry::{at_least, at_most};
use crate::machines::polygon_lathe::params::FIELDS;
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::machines::verdict::{Judgement, fail, ok};
use crate::msg;
use crate::view::Limit::{AtLeast, AtMost};
use crate::view::{Advice, Verdict};

pub(super) fn distance(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    let (low, high) = (p.least_distance, p.greatest_distance);
    if d.place.distance < low {
        fail(AtLeast(low), [msg!("polygon.too-near", least = (low, 2)).into()])
    } else if d.place.distance > high {
        fail(AtMost(high), [msg!("polygon.too-far", most = (high, 2)).into()])
    } else {
        ok(None)
    }
}

/// Judges the body of the cutter, disc and holders, against stock beside the polygon.
pub(super) fn reach(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    // The overhang counts up to the radius of the tip circle, at which no body is left.
    let overhang = p.overhang.min(p.tip_radius);
    if d.place.reach <= overhang + SAME_LENGTH {
        return ok(AtMost(overhang));
    }
    let stock = at_most(FIELDS, "stock-diameter", p.across_flats + 2.0 * overhang);
    let fact = msg!(
        "polygon.body-touches",
        overlap = (d.place.reach - overhang, 3),
        overhang = (d.place.reach, 3),
        diameter = stock.text.as_str()
    );
    let set = at_least(FIELDS, "overhang", d.place.reach);
    let fits = d.place.reach < p.tip_radius;
    let advice = Advice::from(fact);
    let advice =
        if fits { advice.setting(msg!("advice.set-overhang", overhang = set.text.as_str()), [set]) } else { advice };
    fail(AtMost(overhang), [advice])
}

/// Judges the distance of the jaws from the face; an unknown distance is not judged, but has to be measured.
pub(super) fn jaws(lathe: &PolygonLathe) -> Option<Judgement> {
    let free = lathe.params.free_length;
    if free == 0.0 {
        let advice = vec![msg!("polygon.measure-free-length", needed = (lathe.length_to_jaws(), 3)).into()];
        return Some(Judgement { verdict: Verdict::None, limit: None, advice });
    }
    let limit = AtMost(free);
    if lathe.length_to_jaws() <= free {
        return ok(limit);
    }
    // The finding about the field has the sentence.
    fail(limit, [])
}

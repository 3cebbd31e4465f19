//! The rule of bending: slender work that deflects under the cutting force.

use super::knob_positions::at_knobs;
use super::remedies::with_depth;
use crate::drives::bending::NOTABLE;
use crate::machines::form::entry::at_least;
use crate::machines::lathe::turret;
use crate::machines::turning_spindle::bending;
use crate::machines::turning_spindle::params::{FIELDS, Params, Path};
use crate::machines::turning_spindle::resolved::{CutAtKnobs, TurningSpindle};
use crate::machines::verdict::{Judgement, fail, warn};
use crate::msg;
use crate::text::Message;
use crate::view::Limit::AtMost;
use crate::view::{Advice, FieldEntry};

fn bending_demand(cut: &CutAtKnobs) -> (f64, f64) {
    (bending::of(cut.params), NOTABLE)
}

/// Judges bending against [`NOTABLE`]. A tailstock leaves a small part of the bending; less depth lowers the force.
/// Work that bends by more than the depth of a cut along it is not cut at all: force and bending fall in proportion to
/// the depth, so no smaller depth helps.
pub(super) fn bends(lathe: &TurningSpindle) -> Option<Judgement> {
    let p = &lathe.params;
    let value = bending::of(p);
    if value <= NOTABLE {
        return at_knobs(lathe, NOTABLE, bending_demand, |cut, (bending, _)| {
            let (percent, bending) = ((cut.at.feed, 0), (bending, 2));
            if cut.params.tailstock {
                msg!("turning.held-work-bends-at-feed-knob", percent, bending)
            } else {
                msg!("turning.bends-at-feed-knob", percent, bending)
            }
        });
    }
    let (bending, depth, held) = ((value, 2), (p.depth, 3), (bending::held(p), 3));
    // Facing excludes a tailstock.
    let takes_tailstock = !p.tailstock && p.path != Path::Facing;
    if p.path != Path::Facing && value > p.depth {
        let advice = if takes_tailstock && bending::held(p) <= p.depth {
            fit_tailstock(p, msg!("turning.work-gives-way", bending, depth, held))
        } else {
            Advice::from(msg!("turning.held-work-gives-way", depth, held))
        };
        return fail(AtMost(p.depth), [advice]);
    }
    let greatest = lathe.at_highest_feed().map_or(value, |(_, fed)| bending::of(&fed.params));
    let shallower = |message: Message| with_depth(lathe, NOTABLE / greatest, message);
    match p.path {
        Path::Facing => warn(AtMost(NOTABLE), [shallower(msg!("turning.face-bends", bending))]),
        _ if takes_tailstock => {
            let tailstock = fit_tailstock(p, msg!("turning.work-bends", bending, held));
            warn(AtMost(NOTABLE), [tailstock, shallower(msg!("turning.less-depth"))])
        }
        _ => warn(AtMost(NOTABLE), [shallower(msg!("turning.held-work-bends", bending))]),
    }
}

/// An advice to hold the end of the work by the tailstock, and to start where the turret turns clear of it.
fn fit_tailstock(p: &Params, message: Message) -> Advice {
    let beside = at_least(FIELDS, "start-x", turret::beside(p.stock_diameter, p.turret_room));
    let start = (p.start_x < beside.value).then(|| FieldEntry::from(beside));
    let entries: Vec<_> = core::iter::once(FieldEntry::new("tailstock", "true")).chain(start).collect();
    Advice::from(message).setting(msg!("advice.tailstock"), entries)
}

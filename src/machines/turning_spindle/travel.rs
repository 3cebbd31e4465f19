//! Travels of the slides from the start of the tool to its last cut, compared with the travel of each slide and the length of its screw.

use super::params::Path;
use super::resolved::TurningSpindle;
use crate::machines::verdict::{Judgement, fail, ok};
use crate::msg;
use crate::text::Diagnostic;
use crate::view::Limit::AtMost;

/// Travels (mm) of X and Z that the part needs: from the start of the tool, or its farthest way out, to the last cut.
pub(super) fn needed(lathe: &TurningSpindle) -> [f64; 2] {
    let p = &lathe.params;
    let keyway = lathe.keyway().map(|surface| surface - 2.0 * p.keyway_depth);
    let smallest = keyway.map_or(lathe.derived.cut.smallest, |bottom| lathe.derived.cut.smallest.min(bottom));
    // A pass of a taper retracts by one depth from its end, at most from a diameter clear of the stock.
    let outermost = if p.path == Path::Taper { p.stock_diameter + 2.0 * (p.clearance + p.depth) } else { 0.0 };
    let cut = if p.path == Path::Facing { 0.0 } else { p.length };
    let far = if lathe.keyway().is_some() { cut.max(p.keyway_start + p.keyway_length) } else { cut };
    // A face begins in front of its allowance.
    let front = if p.path == Path::Facing { p.clearance.max(p.allowance) } else { p.clearance };
    [0.5 * (p.start_x.max(outermost) - smallest), p.start_z.max(front) + far]
}

/// Errors about needed travels beyond those of the slides, if these are known.
pub(super) fn findings(lathe: &TurningSpindle, found: &mut Vec<Diagnostic>) {
    let p = &lathe.params;
    let travels = [("travel-x", p.travel_x), ("travel-z", p.travel_z)];
    for ((field, travel), needed) in travels.into_iter().zip(needed(lathe)) {
        if travel > 0.0 && needed > travel {
            let message = msg!("turning.beyond-travel", needed = (needed, 3), travel = (travel, 3));
            found.push(Diagnostic::error(message).about(field));
        }
    }
}

/// Judges a travel (mm) against the length of the screw (mm), which the nut cannot leave.
fn judge(needed: f64, screw: f64) -> Option<Judgement> {
    if needed <= screw {
        return ok(AtMost(screw));
    }
    fail(AtMost(screw), [msg!("turning.screw-too-short", needed = (needed, 1), length = (screw, 1)).into()])
}

/// The travel of X against its screw.
pub(super) fn judge_x(lathe: &TurningSpindle) -> Option<Judgement> {
    judge(needed(lathe)[0], lathe.params.slides.x.screw_length)
}

/// The travel of Z against its screw.
pub(super) fn judge_z(lathe: &TurningSpindle) -> Option<Judgement> {
    judge(needed(lathe)[1], lathe.params.slides.z.screw_length)
}

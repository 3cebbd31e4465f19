//! The rule of the control's block time: the blocks read during a cut.

use super::remedies::with_feed;
use crate::controls::spindle::RapidSpeed;
use crate::machines::turning_spindle::params::Path;
use crate::machines::turning_spindle::resolved::TurningSpindle;
use crate::machines::verdict::{Judgement, warn};
use crate::msg;

/// Macro blocks between two passes, and the additional ones of a taper.
const BLOCKS_BETWEEN_PASSES: f64 = 5.0;
const BLOCKS_OF_TAPER: f64 = 3.0;

/// Blocks that are read while the cut lasts.
pub(super) fn block_time(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { params: p, derived: d, .. } = lathe;
    // If rapids keep the spindle speed, a cut begins with the highest speed of the previous cut.
    let keeps = lathe.surface() && lathe.rules().rapid == RapidSpeed::Kept;
    let least: f64 = if keeps { p.cuts(1.0).map(|cut| cut.time_at(d.speeds.high)).sum() } else { f64::INFINITY };
    let lasts = 1000.0 * (d.times.cutting / d.cut.passes.max(1.0)).min(least);
    let blocks = BLOCKS_BETWEEN_PASSES + if p.path == Path::Taper { BLOCKS_OF_TAPER } else { 0.0 };
    let needed = p.block_time + blocks * p.macro_time;
    // The block of a taper is read while the tool goes to its begin, over the clearance.
    let approach =
        if p.path == Path::Taper { 60_000.0 * p.clearance / (p.feed * d.speeds.high) } else { f64::INFINITY };
    let worse = lasts * p.block_time > approach * needed;
    let (lasts, needed) = if worse { (approach, p.block_time) } else { (lasts, needed) };
    if lasts >= needed {
        return None;
    }
    let advice = msg!("turning.blocks-too-slow", time = (lasts, 0), needed = (needed, 0));
    warn(None, [with_feed(lathe, lasts / needed, advice)])
}

//! The rules of the slides: their electronic gears, and the feed against its clamp.

use super::remedies::with_feed;
use crate::machines::driven::scaling;
use crate::machines::turning_spindle::params::Path;
use crate::machines::turning_spindle::resolved::TurningSpindle;
use crate::machines::verdict::{Judgement, fail, ok};
use crate::math;
use crate::msg;
use crate::view::Limit::AtMost;

pub(super) fn scaling_x(lathe: &TurningSpindle) -> Option<Judgement> {
    scaling::judge(lathe.control, &lathe.drives()[0])
}

pub(super) fn scaling_z(lathe: &TurningSpindle) -> Option<Judgement> {
    scaling::judge(lathe.control, &lathe.drives()[1])
}

/// The highest feed of the cut against the clamp of the slide that moves, at most its rapid traverse.
pub(super) fn clamped_feed(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { params: p, derived: d, .. } = lathe;
    let [x, z] = [&p.slides.x, &p.slides.z].map(|slide| slide.clamp.min(slide.rapid));
    let clamp = match p.path {
        Path::Facing => x,
        Path::Turning => z,
        Path::Taper => {
            // Feed of X: its share of the path.
            let across = 0.5 * (p.large_diameter - p.finished_diameter).abs();
            z.min(x * math::hypot(p.length, across) / across)
        }
    };
    if d.speeds.feed_top <= clamp {
        return ok(AtMost(clamp));
    }
    let advice = msg!("turning.above-clamp", feed = (d.speeds.feed_top, 0), clamp = (clamp, 0));
    fail(AtMost(clamp), [with_feed(lathe, clamp / d.speeds.feed_top, advice)])
}

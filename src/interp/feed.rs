//! The feed in force for a cut, per minute or per revolution.

use super::canon::Feed;
use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::modal::SecondSpindle;
use super::state::RunState;
use crate::controls::{Address, Alarm};
use crate::msg;

impl RunState {
    /// Feed of a cut; `None` if F0 means rapid traverse.
    #[inline]
    pub(super) fn feed_in_force(&self, cx: &BlockContext) -> BlockResult<Option<Feed>> {
        match self.modal.feed {
            Some(0.0) if cx.shared.rules.running.feed_zero_rapid => Ok(None),
            None | Some(0.0) => Err(no_feed(cx, self.modal.feed)),
            Some(feed) if !self.modal.per_revolution => Ok(Some(Feed::PerMinute(feed))),
            Some(feed) if self.modal.spindle.master > 1 => Ok(Some(Feed::PerMinute(feed * self.other_speed()?))),
            Some(feed) => Ok(Some(Feed::PerRevolution(feed))),
        }
    }
    /// Speed in r/min of a master spindle other than the machine's own spindle.
    #[cold]
    fn other_speed(&self) -> BlockResult<f64> {
        match self.modal.spindle.second {
            SecondSpindle { rpm, turns: true } if rpm > 0.0 => Ok(rpm),
            _ => Err(Trap::alarm(
                Alarm::NotSimulated,
                msg!("interp.other-spindle-at-rest", spindle = u32::from(self.modal.spindle.master)),
            )),
        }
    }
}

/// The alarm of a cut without a feed above 0.
#[cold]
pub(super) fn no_feed(cx: &BlockContext, feed: Option<f64>) -> Trap {
    match feed {
        None => Trap::alarm(Alarm::NoFeed, msg!("interp.no-feed")).hint(msg!("interp.hint-feed")),
        Some(_) => Trap::alarm(Alarm::FeedZero, msg!("interp.feed-zero"))
            .hint(msg!("interp.hint-feed-zero", guard = cx.control.guard(&format!("{}…", cx.control.syntax.variable))))
            .at_word(&[Address::F]),
    }
}

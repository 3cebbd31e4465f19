//! The operator's override knobs of feed and spindle: positions at which every lathe judges its cut, and the remedies there.

use crate::drives::speed::{KnobEnds, KnobRange};
use crate::machines::driven::devices::forced_cooling_advice;
use crate::machines::form::entry::NumberEntry;
use crate::msg;
use crate::text::Message;
use crate::view::Advice;

/// Position (%) of the feed override at which the feeds are those of the form.
pub(in crate::machines) const FULL_PERCENT: f64 = 100.0;

/// Positions of the override knobs, %.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::machines) struct KnobPositions {
    pub feed: f64,
    pub spindle: f64,
}

/// Highest position (%) of the feed override above 100 %; none on a control whose knob ends there.
pub(in crate::machines) fn highest_feed(knob: KnobRange) -> Option<f64> {
    knob.ends(FULL_PERCENT).higher
}

/// The positions, other than those of the form, at which a cut is judged: each knob at its ends, and both together.
/// Less feed needs less of every drive, so the feed override is judged only at its highest position. `present`:
/// position of the spindle override in the form, %.
pub(in crate::machines) fn positions(feed: KnobRange, spindle: KnobEnds, present: f64) -> Vec<KnobPositions> {
    let feeds = [highest_feed(feed), Some(FULL_PERCENT)].into_iter().flatten();
    let all = feeds.flat_map(|feed| {
        let spindles = [Some(present), spindle.higher, spindle.lower].into_iter().flatten();
        spindles.map(move |spindle| KnobPositions { feed, spindle })
    });
    all.filter(|at| *at != KnobPositions { feed: FULL_PERCENT, spindle: present }).collect()
}

/// The state with the greatest ratio of demand to limit above 1, with `(demand, limit)`; none if every demand is within
/// its limit.
pub(in crate::machines) fn worst<T>(
    states: impl IntoIterator<Item = T>,
    demand: impl Fn(&T) -> (f64, f64),
) -> Option<(T, (f64, f64))> {
    let all = states.into_iter().map(|state| {
        let numbers = demand(&state);
        (state, numbers)
    });
    let share = |(asked, limit): (f64, f64)| asked / limit;
    let exceeding = all.filter(|(_, (asked, limit))| asked > limit);
    exceeding.reduce(|worst, next| if share(next.1) > share(worst.1) { next } else { worst })
}

/// Least feed (mm per revolution) that an advice names: below it an edge rubs.
const LEAST_FEED: f64 = 0.01;

/// Adds a button with these lower feeds to an advice, unless one of them is below [`LEAST_FEED`].
pub(in crate::machines) fn setting_feeds(advice: Advice, sets: Vec<NumberEntry>) -> Advice {
    let values: Vec<&str> = sets.iter().map(|set| set.text.as_str()).collect();
    let least = sets.iter().map(|set| set.value).fold(f64::INFINITY, f64::min);
    let button = match values.as_slice() {
        [one] => msg!("advice.set-feed", feed = *one),
        several => msg!("advice.set-feeds", feeds = several.join(" / ").as_str()),
    };
    if sets.is_empty() || least < LEAST_FEED { advice } else { advice.setting(button, sets) }
}

/// Torque (Nm) of cut and friction on a main spindle at positions of the knobs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::machines) struct TorqueAtKnobs {
    pub at: KnobPositions,
    pub torque: f64,
    /// Torque of the motor there.
    pub limit: f64,
    /// The same with forced cooling.
    pub forced: f64,
    /// Speed of the motor, r/min.
    pub motor_speed: f64,
}

/// Remedy for a motor that is too weak at a position of the knobs.
pub(in crate::machines) enum TorqueRemedy {
    /// Forced cooling: with it the motor suffices at every position.
    Cooling(Advice),
    /// Less feed.
    Feed(Advice),
}

/// The remedy for the position where cut and friction exceed the torque of the motor most; none where it suffices at all of them. `cooling`:
/// field of the forced cooling; `slower`: the advice with less feed, for a sentence.
pub(in crate::machines) fn torque_remedy(
    all: &[TorqueAtKnobs],
    cooling: &'static str,
    slower: impl FnOnce(Message) -> Advice,
) -> Option<TorqueRemedy> {
    let (TorqueAtKnobs { at, torque, limit, motor_speed, .. }, _) =
        worst(all.iter().copied(), |of| (of.torque, of.limit))?;
    let (feed, spindle, torque, limit) = ((at.feed, 0), (at.spindle, 0), (torque, 1), (limit, 1));
    Some(if all.iter().all(|of| of.torque <= of.forced) {
        let speed = (motor_speed, 0);
        let message = msg!("lathe.shaft-fan-at-knobs", feed, spindle, speed, torque, limit);
        TorqueRemedy::Cooling(forced_cooling_advice(cooling, message))
    } else {
        TorqueRemedy::Feed(slower(msg!("lathe.torque-at-knobs", feed, spindle, torque, limit)))
    })
}

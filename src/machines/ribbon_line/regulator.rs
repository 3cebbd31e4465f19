//! The regulator of a dancer in the unwinder's inverter, for the run.

use super::resolved::RibbonLine;
use crate::motion::WebRegulator;

/// Time (s) between two samples of the inverter's regulator. Engineering choice.
pub(super) const SAMPLES: f64 = 0.1;

/// The regulator of the loop in the unwinder's inverter; none without a dancer, or where the motor's error uses up its trim. Source: ribbon
/// line facts, 7.
pub(super) fn regulator(line: &RibbonLine) -> Option<WebRegulator> {
    let p = &line.params;
    let limit = p.loop_trim();
    let per_turn = p.laid_by_turns(1.0);
    let regulator = WebRegulator { axis: line.pull(), per_turn, range: p.loop_trim_range(), limit, interval: SAMPLES };
    (limit > 0.0).then_some(regulator)
}

/// Slack (mm) that the regulator keeps; 0 without regulator. Source: ribbon line facts, 7.
pub(super) fn set_point(line: &RibbonLine) -> f64 {
    line.derived.slack.set_point
}

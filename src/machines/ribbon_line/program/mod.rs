//! The program of the ribbon line: O9100 computes, O9101 runs, O9102 sets the project's values once.
//!
//! Written with the words and codes of the control: G91 or incremental addresses, exact stop or none, #3004 or none.
//! O9100 and O9101 never write the operator's variables (those of O9102), so that products are changed by variables alone.

mod alarms;
mod blocks;
mod entries;
mod formulas;
mod limits;
mod listing;
mod numbers;
mod phase;
mod precomputed;
mod product_length;
mod published;
mod ready_made;
mod setup;

pub(super) use entries::variables;
pub(super) use numbers::{RUN, SETUP};
pub(super) use phase::position_variable;

use blocks::overrides_can_be_off;

use super::params::Variant;
use super::resolved::RibbonLine;
use crate::controls::interface::SignalRole;
use crate::nc::Deck;
use crate::nc::build::Builder;

/// The programs, one per file.
pub(super) fn deck(line: &RibbonLine) -> Deck {
    let mut b = Builder::new();
    match line.params.variant {
        Variant::ReadyMade => {
            ready_made::compute(&mut b, line);
            ready_made::run(&mut b, line);
        }
        Variant::Published => {
            published::compute(&mut b, line);
            published::run(&mut b, line);
        }
        Variant::Precomputed => {
            precomputed::compute(&mut b, line);
            precomputed::run(&mut b, line);
        }
    }
    setup::write(&mut b, line);
    b.finish()
}

/// Whether the feed override slows down the axes alone, without the unwinder: neither the program nor the PLC can fix
/// it at 100 %.
pub(super) fn feed_override_acts(line: &RibbonLine) -> bool {
    let fixed_by_plc = line.dialect.device(line.control, SignalRole::FeedOverrideOff).is_some();
    !overrides_can_be_off(line) && !fixed_by_plc && !feed_override_stops(line)
}

/// Whether the PLC fixes the feed override at 100 %, except at 0 %, which stops the axes alone, without the unwinder.
pub(super) fn feed_override_stops(line: &RibbonLine) -> bool {
    line.dialect.device(line.control, SignalRole::FeedOverrideValid).is_some()
}

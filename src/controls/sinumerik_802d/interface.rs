//! Registers between PLC and 802D: none that the simulation works with is known.

use crate::controls::Signal;

/// By device number.
pub(super) const SIGNALS: &[Signal] = &[];

//! The cut-to-length feeder on a control.

use std::sync::atomic::{AtomicUsize, Ordering};

use macroline::controls::{Address, Control, Dialect};
use macroline::machines::ControlContext;

use super::derive::Derived;
use super::params::Params;

/// The axis that feeds.
pub(super) const FEED_AXIS: Address = Address::Z;

/// Machines prepared so far: the test counts them.
pub(crate) static PREPARED: AtomicUsize = AtomicUsize::new(0);

/// The feeder on a control.
#[derive(Debug)]
pub(crate) struct CutToLength {
    pub(super) params: Params,
    pub(super) derived: Derived,
    pub(super) control: &'static Control,
    pub(super) dialect: Dialect,
}

impl CutToLength {
    /// Computes the formulas.
    pub(super) fn resolve(params: Params, on: ControlContext) -> CutToLength {
        PREPARED.fetch_add(1, Ordering::Relaxed);
        CutToLength { derived: Derived::new(&params), params, control: on.control, dialect: on.dialect() }
    }

    /// Index of the axis that feeds, in the control's order.
    pub(super) fn axis(&self) -> usize {
        self.control.axis(FEED_AXIS).unwrap_or(0)
    }
}

//! Which series of motors, amplifiers and inverters go with a control.

use crate::text::Citation;

/// A series of parts that goes with a control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveSystem {
    /// Series, as the catalogue of parts has it.
    pub series: &'static str,
    /// The control's maker sells it too.
    pub own: bool,
    /// Source and grade.
    pub cite: Citation,
}

impl DriveSystem {
    /// Series of the control's maker, one row each.
    pub(in crate::controls) const fn own<const N: usize>(
        series: [&'static str; N],
        cite: Citation,
    ) -> [DriveSystem; N] {
        DriveSystem::all(series, true, cite)
    }

    /// Series of other makers, one row each.
    pub(in crate::controls) const fn others<const N: usize>(
        series: [&'static str; N],
        cite: Citation,
    ) -> [DriveSystem; N] {
        DriveSystem::all(series, false, cite)
    }

    const fn all<const N: usize>(series: [&'static str; N], own: bool, cite: Citation) -> [DriveSystem; N] {
        let mut rows = [DriveSystem { series: "", own, cite }; N];
        let mut at = 0;
        while at < N {
            rows[at].series = series[at];
            at += 1;
        }
        rows
    }
}

//! Which series of motors, amplifiers and inverters go with a control.

use crate::text::Citation;

/// A series of parts that goes with a control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveSystem {
    /// Series, as the catalogue of parts has it.
    pub series: &'static str,
    /// What it does beside the control.
    pub role: DriveRole,
    /// Source and grade.
    pub cite: Citation,
}

/// What a drive system does beside a control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DriveRole {
    /// It follows the control: an axis that is interpolated, or the analog spindle.
    Axis,
    /// It positions by itself: the control's inputs and outputs or a field bus start it.
    Auxiliary,
}

impl DriveSystem {
    /// Series that follow the control, one row each.
    pub(in crate::controls) const fn axes<const N: usize>(
        series: [&'static str; N],
        cite: Citation,
    ) -> [DriveSystem; N] {
        DriveSystem::all(series, DriveRole::Axis, cite)
    }

    /// Series of auxiliary axes, one row each.
    pub(in crate::controls) const fn auxiliary<const N: usize>(
        series: [&'static str; N],
        cite: Citation,
    ) -> [DriveSystem; N] {
        DriveSystem::all(series, DriveRole::Auxiliary, cite)
    }

    const fn all<const N: usize>(series: [&'static str; N], role: DriveRole, cite: Citation) -> [DriveSystem; N] {
        let mut rows = [DriveSystem { series: "", role, cite }; N];
        let mut at = 0;
        while at < N {
            rows[at].series = series[at];
            at += 1;
        }
        rows
    }
}

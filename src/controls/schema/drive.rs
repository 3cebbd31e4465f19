//! Series of motors, amplifiers and inverters that suit a control.

use crate::text::Citation;

/// A series of drives that suits a control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveSystem {
    /// Series name, as in the parts catalogue.
    pub series: &'static str,
    /// Role on a machine with this control.
    pub role: DriveRole,
    /// Source and grade.
    pub cite: Citation,
}

/// Role of a drive on a machine: driven by the control, or positioning on its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DriveRole {
    /// An interpolated axis or the analog spindle, commanded by the control.
    Axis,
    /// A positioning drive, started by the control's inputs and outputs or a field bus.
    Auxiliary,
}

impl DriveSystem {
    /// Rows of series for axes and spindle, one per series.
    pub(in crate::controls) const fn axes<const N: usize>(
        series: [&'static str; N],
        cite: Citation,
    ) -> [DriveSystem; N] {
        DriveSystem::all(series, DriveRole::Axis, cite)
    }

    /// Rows of series for auxiliary axes, one per series.
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

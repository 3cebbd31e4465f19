//! Diagnostics that a run reports only once.

/// Diagnostics reported once per run; those of an axis once for each axis, by its index.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Once {
    Starved,
    SpindleClamp,
    SpindleAtRest,
    OffCentre,
    NoStage,
    NoEncoder,
    NotLocked,
    NoDrivenTool,
    FeedWithoutRotation,
    Notice,
    SmallOffset,
    Clamp(usize),
    Missing(usize),
}

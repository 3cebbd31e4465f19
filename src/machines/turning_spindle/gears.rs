//! Times of a gear change.

use super::resolved::TurningSpindle;

/// Times (s) of a gear change.
#[derive(Clone, Copy)]
pub(super) struct GearTimes {
    /// Time until the old gear is out.
    pub(super) before: f64,
    /// Until the new gear is in position.
    pub(super) meshing: f64,
    /// Until the voltage is that of the speed.
    pub(super) after: f64,
    /// Until a new gear that is not in position is an alarm; `None` without supervision.
    pub(super) patience: Option<f64>,
}

/// An eighth of the gear change before, half of it meshing, the rest after.
pub(super) fn gear_times(lathe: &TurningSpindle) -> GearTimes {
    let p = &lathe.p;
    let patience = (p.gear_patience > 0.0 && p.has_gear_alarm(lathe.control)).then_some(p.gear_patience);
    let seconds = p.gear_time;
    GearTimes { before: 0.125 * seconds, meshing: 0.5 * seconds, after: 0.375 * seconds, patience }
}

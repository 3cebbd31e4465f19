//! The supply reel of the ribbon line, from which the unwinder pulls the ribbon against a brake.

use super::params::Params;
use crate::drives::inertia::CM2;
use crate::drives::reel::{Reel, acceleration};
use crate::math::RPM;

/// The reel of the form; without ribbon if its core is not smaller than the full reel.
pub(super) fn wound(p: &Params) -> Reel {
    let unwinding = &p.unwinding;
    Reel {
        full: unwinding.reel_diameter / 1e3,
        core: unwinding.core_diameter / 1e3,
        width: p.ribbon_width / 1e3,
        thickness: p.ribbon_thickness / 1e3,
        density: p.web.density,
        core_inertia: unwinding.core_inertia * CM2,
    }
}

/// Acceleration in m/s² of the ribbon at the unwinder over the inverter's ramp, which is set for the speed at 10 V.
pub(super) fn ramp_acceleration(p: &Params) -> f64 {
    let speed = p.speed_at_10v * RPM / p.reduction_ratio * p.press_roller_diameter / 2e3;
    acceleration(speed, p.inverter_ramp)
}

//! Angles of the polygon on the work, and the phase of the tool.

use super::cut::{DEGREES, PolygonCut};
use super::speeds::PolygonSpeeds;
use crate::machines::polygon_lathe::params::Params;

/// Angles, degrees of the work unless noted otherwise.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::machines::polygon_lathe) struct WorkAngles {
    /// Angle of the polygon by the start angles, and its error at speed.
    pub orientation: f64,
    pub orientation_error: f64,
    /// Start angle A of the work for the wanted orientation.
    pub work_start: f64,
    /// Phase of the tool against the work, degrees of the tool; negative for a lag.
    pub phase: f64,
    /// Rotation of the polygon by the phase.
    pub phase_on_work: f64,
    /// Phase of the tool after both have coasted to rest, degrees of the tool.
    pub coast_phase: f64,
}

impl WorkAngles {
    pub(super) fn new(p: &Params, cut: &PolygonCut, speeds: &PolygonSpeeds) -> WorkAngles {
        let (setup, pitch) = (&cut.setup, cut.pitch());
        let near = |angle: f64| angle - pitch * (angle / pitch).round();
        let phase = p.phase();
        let on_work = phase / speeds.ratio;
        let orientation = setup.normal(0.0) * DEGREES;
        WorkAngles {
            orientation: orientation.rem_euclid(pitch),
            orientation_error: near(orientation + on_work - p.orientation),
            work_start: near(setup.work_start_for(p.orientation / DEGREES) * DEGREES + on_work),
            phase,
            phase_on_work: on_work,
            coast_phase: p.coast_phase(),
        }
    }
}

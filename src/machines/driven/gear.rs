//! A gear unit between motor and load, as a form has it.

use crate::drives::load::Load;
use crate::drives::shaft_motion::{Motion, SpeedSegment, Strikes};

/// A gear unit as a form has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FormGear {
    /// Speed of its input over that of its output.
    pub ratio: f64,
    /// Load at its output.
    pub output: Load,
    /// Torque at its output at standstill, Nm.
    pub standstill_torque: f64,
    /// Greatest torque (Nm) at its output at steady speed that no planned run shows, as `DrivenAxis::taut_torque`; 0
    /// without one.
    pub taut_torque: f64,
    /// Backlash (minutes of arc) that the machine's formulas use; none if it has no effect.
    pub backlash: Option<f64>,
    /// Fields of the form that take the figures of another gear unit.
    pub fields: GearFields,
}

impl FormGear {
    /// Motion of the output shaft under these segments of the speed of the input shaft.
    pub fn output_motion(&self, input: &[SpeedSegment]) -> Motion {
        let slower = |segment: &SpeedSegment| SpeedSegment {
            from: segment.from / self.ratio,
            to: segment.to / self.ratio,
            ..*segment
        };
        Motion::new(input.iter().map(slower), self.output, self.standstill_torque)
            .with_strikes(pulled_taut(Strikes::default(), self.taut_torque))
    }
}

/// Ids of the fields of a gear unit in a form.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GearFields {
    /// Its efficiency, %.
    pub efficiency: &'static str,
    /// Field of the moment of inertia at its input, kg cm²; none if the form includes it in another one.
    pub inertia: Option<&'static str>,
    /// Backlash, minutes of arc; none where the form has none.
    pub backlash: Option<&'static str>,
}

/// The strikes with the torque of a taut web added to their peak. The web pulls at steady speed, and too briefly to
/// count in the effective torque.
pub(super) fn pulled_taut(strikes: Strikes, taut: f64) -> Strikes {
    Strikes { peak: strikes.peak.max(taut), ..strikes }
}

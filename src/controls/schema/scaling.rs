//! Axis scaling of a control: the parameters that lead from turns of a motor to travel, and the numbers that they take.

use super::ParamRole;
use crate::text::Citation;

/// Parameters by which a control scales its axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ScalingKind {
    /// Counts of the encoder over output units, both per turn of the motor, in lowest terms.
    Counts,
    /// A feed gear of detection units over feedback counts, and the ratio of command units to detection units.
    FeedGear {
        /// Counts per turn of the motor to which the control scales any encoder.
        feedback: f64,
        /// Value of the command multiplier for one detection unit per command unit.
        multiplier: f64,
        /// Value of the command multiplier for two command units per detection unit: words that count diameters.
        diameter_multiplier: f64,
    },
    /// The gear's turns of motor and load, and the travel per turn of the load in whole millimetres.
    WholeLead,
    /// The gear's turns of motor and load, and the travel per turn of the load with decimals; a rotary axis has no such travel.
    Lead,
}

impl ScalingKind {
    /// The parameters that it writes for a linear axis, some of them where a ratio is no whole number.
    pub const fn roles(self) -> &'static [ParamRole] {
        match self {
            ScalingKind::Counts => &[ParamRole::CountsOver, ParamRole::CountsUnder],
            ScalingKind::FeedGear { .. } => &[
                ParamRole::CommandMultiplier,
                ParamRole::ReferenceCounts,
                ParamRole::ReferenceCountsUnder,
                ParamRole::FeedGearOver,
                ParamRole::FeedGearUnder,
            ],
            ScalingKind::WholeLead => {
                &[ParamRole::LoadTurns, ParamRole::MotorTurns, ParamRole::WholeLead, ParamRole::EncoderCounts]
            }
            ScalingKind::Lead => {
                &[ParamRole::LoadTurns, ParamRole::MotorTurns, ParamRole::EncoderCounts, ParamRole::Lead]
            }
        }
    }
}

/// Axis scaling of a control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisScaling {
    /// Parameters that it uses.
    pub kind: ScalingKind,
    /// Greatest numerator and denominator that macroline writes into them.
    pub greatest_term: u64,
    /// Source and grade of kind and numbers.
    pub cite: Citation,
}

//! The two axes of the polygon lathe that turn in ratio, work and tool, and the inputs of the form that each of them has.

use std::ops::Index;

/// Work axis or tool axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum PolygonAxis {
    Work,
    Tool,
}

/// Inputs of an axis that turns in ratio, and of its motor. Units as in the form.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct RatioAxis {
    /// Greatest speed of the axis.
    pub limit: f64,
    pub time_constant: f64,
    pub gain: f64,
    pub motor_teeth: f64,
    pub teeth: f64,
    pub encoder: f64,
    /// Time in which the axis coasts to rest from its greatest speed.
    pub coast: f64,
    pub power: f64,
    pub base: f64,
    /// Greatest speed of the motor.
    pub top: f64,
    pub inertia: f64,
}

/// The axes that turn in ratio.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct RatioAxes {
    pub work: RatioAxis,
    pub tool: RatioAxis,
}

impl RatioAxis {
    /// Turns of the axis per turn of its motor.
    pub(super) fn turns_per_motor_turn(&self) -> f64 {
        self.motor_teeth / self.teeth
    }

    /// Greatest speed (r/min) to which the motor turns the axis.
    pub(super) fn reach(&self) -> f64 {
        self.top * self.turns_per_motor_turn()
    }
}

impl Index<PolygonAxis> for RatioAxes {
    type Output = RatioAxis;

    fn index(&self, axis: PolygonAxis) -> &RatioAxis {
        match axis {
            PolygonAxis::Work => &self.work,
            PolygonAxis::Tool => &self.tool,
        }
    }
}

//! The command at the analog output.

use super::speeds::CutSpeeds;
use super::stage::EngagedStage;
use crate::controls::AnalogOutput;
use crate::machines::turning_spindle::params::{Params, SpindleDirection};

/// The command at the analog output.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::turning_spindle) struct OutputCommand {
    /// Volts at the largest and at the smallest diameter.
    pub volts_largest: f64,
    pub volts_smallest: f64,
    /// Speed of one step of the converter, r/min.
    pub step: f64,
}

impl OutputCommand {
    pub(super) fn new(p: &Params, stage: &EngagedStage, speeds: &CutSpeeds, output: &AnalogOutput) -> OutputCommand {
        let analog = p.analog(stage.speed, output);
        let sign = if p.direction == SpindleDirection::CounterClockwise { -1.0 } else { 1.0 };
        let middle = 0.5 * output.volts;
        OutputCommand {
            volts_largest: analog.output(sign * speeds.largest),
            volts_smallest: analog.output(sign * speeds.smallest),
            step: analog.speed(middle + output.volts / f64::from(analog.steps())) - analog.speed(middle),
        }
    }
}

//! The gear stage that the program engages, and the analog output in it.

use super::command::CommandedSpeed;
use super::cut::CutGeometry;
use crate::controls::AnalogOutput;
use crate::drives::Analog;
use crate::machines::turning_spindle::params::{Gear, Output, Params};

/// The engaged gear stage. Speeds in r/min.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::turning_spindle) struct EngagedStage {
    /// Number, from 1.
    pub number: u8,
    /// Speed at full output.
    pub speed: f64,
    /// Greatest speed of the analog output in this stage, offsets included.
    pub top: f64,
    /// Greatest speed in this stage under constant surface speed, which the control limits.
    pub surface_top: f64,
}

impl EngagedStage {
    pub(super) fn new(p: &Params, cut: &CutGeometry, command: &CommandedSpeed, output: &AnalogOutput) -> EngagedStage {
        let (number, speed) = p.stage(command.top(p, cut.smallest), output);
        let analog = p.analog(speed, output);
        EngagedStage { number, speed, top: analog.top_speed(), surface_top: analog.stage_maximum() }
    }
}

impl Params {
    /// The analog output in a gear stage of `stage_speed` r/min at 10 V.
    pub(in crate::machines::turning_spindle) fn analog(&self, stage_speed: f64, output: &AnalogOutput) -> Analog {
        Analog {
            offset_zero: self.offset_zero / 1000.0,
            offset_rated: self.offset_full / 1000.0,
            bipolar: self.output == Output::Bipolar,
            ..output.with_speed(stage_speed)
        }
    }

    /// Number (from 1) of the gear stage and its speed at full output, r/min: the chosen stage if it is fitted, else
    /// the lowest whose output reaches `top` r/min, else the fastest.
    fn stage(&self, top: f64, output: &AnalogOutput) -> (u8, f64) {
        let stages = || (1..).zip(self.stages());
        let chosen = stages().find(|(number, _)| self.gear != Gear::Best && *number == self.gear as u8);
        let most = |speed: f64| {
            let analog = self.analog(speed, output);
            if self.turns_at_fixed_speed() { analog.top_speed() } else { analog.stage_maximum() }
        };
        let reaches = || stages().filter(|(_, speed)| most(*speed) >= top).fold(None, slower);
        let fastest = || stages().fold((1, self.stage_1), |a, b| if b.1 > a.1 { b } else { a });
        chosen.or_else(reaches).unwrap_or_else(fastest)
    }
}

fn slower(best: Option<(u8, f64)>, next: (u8, f64)) -> Option<(u8, f64)> {
    Some(best.filter(|best| best.1 <= next.1).unwrap_or(next))
}

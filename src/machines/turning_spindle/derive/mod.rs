//! The formulas of the turning spindle, each once: results that need no run, by subject.
//!
//! Speeds in r/min, diameters in mm, times in s, voltages in V unless noted otherwise.

mod acceleration;
mod command;
mod cut;
mod limited_speed;
mod limits;
mod load;
mod output;
mod passes;
mod speeds;
mod stage;
mod times;

pub(super) use passes::{PASSES, TRACE};

use super::params::Params;
use crate::controls::{AnalogOutput, SpindleRules};
use acceleration::SpindleAcceleration;
use command::CommandedSpeed;
use cut::CutGeometry;
use limits::LimitDiameters;
use load::SteadyLoad;
use output::OutputCommand;
use speeds::CutSpeeds;
use stage::EngagedStage;
use times::CutTimes;

/// The results.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Derived {
    pub cut: CutGeometry,
    pub stage: EngagedStage,
    pub speeds: CutSpeeds,
    pub limits: LimitDiameters,
    pub times: CutTimes,
    pub output: OutputCommand,
    pub load: SteadyLoad,
    pub acceleration: SpindleAcceleration,
}

impl Derived {
    /// Computes the results for the analog output of a control with these rules of the spindle.
    pub(super) fn new(p: &Params, output: &AnalogOutput, rules: &SpindleRules) -> Derived {
        let cut = CutGeometry::new(p);
        let command = CommandedSpeed::new(p, rules);
        let stage = EngagedStage::new(p, &cut, &command, output);
        let speeds = CutSpeeds::new(p, &cut, &stage, &command);
        let limits = LimitDiameters::new(p, &cut, &command, &speeds);
        Derived {
            times: CutTimes::new(p, &cut, &stage, &command, &speeds),
            output: OutputCommand::new(p, &stage, &speeds, output),
            load: SteadyLoad::new(p, &cut, &stage, &limits, &speeds),
            acceleration: SpindleAcceleration::new(p, &cut, &stage, &limits, &speeds),
            cut,
            stage,
            speeds,
            limits,
        }
    }
}

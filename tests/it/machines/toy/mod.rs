//! A toy machine that follows `docs/adding-a-machine.md` step by step: Z feeds a strip, waits for the knife, and feeds again.

mod derive;
mod params;
mod plant;
mod program;
mod resolved;
mod rules;
mod scene;

use macroline::controls::Bench;
use macroline::machines::form::Field;
use macroline::machines::verdict::results;
use macroline::machines::{
    ControlContext, Design, DrawnMachine, DrivenMachine, Frame, Machine, MachineInfo, MachineProgram, MachineVariable,
    Prepared, Samples, chart_rows, sheets,
};
use macroline::motion::{BenchPlc, Plant, Plc, Snapshot};
use macroline::view::{Chart, DrawnPart, Pose, Scene, Sheet};

use params::{FIELDS, Params};
pub(super) use resolved::{CutToLength, PREPARED};

impl Machine for CutToLength {
    type Params = Params;
    const INFO: MachineInfo = MachineInfo {
        id: "cut-to-length",
        name: "toy.name",
        controls: &["mitsubishi-e60", "gsk-980tdc", "knd-k2000t"],
        speed: 1.0,
        ..MachineInfo::BASE
    };

    fn fields() -> &'static [Field<Params>] {
        FIELDS
    }

    fn new(params: Params, on: ControlContext) -> CutToLength {
        CutToLength::resolve(params, on)
    }
}

impl Prepared for CutToLength {
    fn results(&self) -> Design {
        let readouts = results(rules::READOUTS, self, rules::RULES).collect();
        Design { readouts, diagnostics: rules::findings(self) }
    }

    fn program(&self) -> MachineProgram {
        MachineProgram {
            deck: program::deck(self),
            setup: Some(program::SETUP),
            main: program::RUN,
            newline: self.params.newline.into(),
        }
    }

    fn plant(&self) -> Plant {
        plant::plant(self)
    }

    fn plc(&self) -> Box<dyn Plc> {
        let bench = Bench { fin_delay: 0.05, override_echo: None, ..self.control.bench };
        Box::new(BenchPlc::new(&bench, &self.plant().spindle.rules))
    }

    fn variables(&self) -> Vec<MachineVariable> {
        program::VARIABLES.to_vec()
    }

    fn sheets(&self) -> Vec<Sheet> {
        let units = sheets::AxisUnits { in_diameters: &[], rotary: &[] };
        vec![sheets::parameters(self.control, &units, plant::parameters(self))]
    }
}

impl DrawnMachine for CutToLength {
    fn parts(&self) -> Vec<DrawnPart> {
        scene::parts()
    }

    fn scene(&self) -> Scene {
        scene::scene()
    }

    fn pose(&self, _: &dyn Samples, now: &Snapshot, _: Frame) -> Pose {
        scene::pose(self, now)
    }

    fn charts(&self, run: &dyn Samples, from: f64, to: f64, points: usize) -> Vec<Chart> {
        chart_rows::charts(scene::CHARTS, self, run, from, to, points)
    }
}

impl DrivenMachine for CutToLength {}

//! The turning spindle: a lathe that faces, turns or cuts a taper, and what its spindle does on the way.

pub mod params;

pub mod derive;

mod resolved;

mod readouts;

mod rules;

mod program;

mod plant;

mod scene;

mod pose;

mod charts;

mod sheets;

use crate::controls::Control;
use crate::machines::chart_rows;
use crate::machines::form::Field;
use crate::machines::form::rows::LineEnds;
use crate::machines::verdict::{Rows, judge};
use crate::machines::{ControlContext, Defaults, Design, Frame, Machine, MachineProgram, Samples};
use crate::motion::{Action, Plant, Plc, Snapshot};
use crate::text::catalog::number_text as show;
use crate::view::{Chart, Pose, Scene, Sheet};
use derive::Derived;
use params::{FIELDS, Params};
use resolved::Resolved;
use rules::{Case, RULES};

/// The machine.
#[derive(Debug)]
pub struct TurningSpindle;

/// The lathe, for its rows.
struct Lathe;

impl Rows for Lathe {
    type Resolved<'a> = Resolved<'a>;
    type Derived = Derived;
    type Case<'a> = Case<'a>;
}

impl Machine for TurningSpindle {
    type Params = Params;
    const ID: &'static str = "turning-spindle";
    const NAME: &'static str = "turning.name";
    const CONTROLS: &'static [&'static str] = &["gsk-980tdc", "sinumerik-802d", "knd-k2000t", "mitsubishi-e60"];

    const LISTING: &'static str = "";
    const SPEED: f64 = 1.0;

    fn fields() -> &'static [Field<Params>] {
        FIELDS
    }

    /// The control's own times.
    fn start(control: &Control) -> Defaults {
        let mut start = Defaults::timing(control);
        start.keep_common(control);
        start
    }

    fn design(p: &Params, on: ControlContext) -> Design {
        let lathe = Resolved::new(p, on);
        let d = lathe.derived();
        let case = Case { lathe: &lathe, p: &lathe.p, d: &d };
        let shown = |id: &str| match id {
            "power" | "torque" => lathe.p.cutting_force > 0.0,
            "limit-diameter" | "limited-share" | "low-diameter" | "surface-smallest" | "acceleration-needed" => {
                lathe.surface()
            }
            _ => true,
        };
        let readouts = readouts::ROWS.iter().filter(|row| shown(row.id));
        let readouts = readouts.map(|row| judge(row, &d, row.unit, RULES, &case)).collect();
        Design { readouts, diagnostics: rules::findings(&case) }
    }

    fn plan(p: &Params, on: ControlContext) -> MachineProgram {
        let deck = program::deck(&Resolved::new(p, on));
        MachineProgram { deck, setup: program::SETUP, main: program::RUN, crlf: p.newline == LineEnds::CrLf }
    }

    fn plant(p: &Params, on: ControlContext) -> Plant {
        plant::plant(&Resolved::new(p, on))
    }

    fn hand(p: &Params) -> Vec<Action> {
        vec![Action::SpindleOverride(p.override_percent)]
    }

    fn plc(p: &Params, on: ControlContext) -> Box<dyn Plc> {
        Box::new(plant::plc(&Resolved::new(p, on)))
    }

    fn sheets(p: &Params, on: ControlContext) -> Vec<Sheet> {
        sheets::sheets(&Resolved::new(p, on))
    }

    fn variables(p: &Params, on: ControlContext) -> Vec<(u32, &'static str, &'static str)> {
        program::variables(&Resolved::new(p, on))
    }

    fn scene(p: &Params, on: ControlContext) -> Scene {
        scene::scene(&Resolved::new(p, on))
    }

    fn pose(p: &Params, on: ControlContext, run: &dyn Samples, now: &Snapshot, frame: Frame) -> Pose {
        pose::pose(&Resolved::new(p, on), run, now, frame)
    }

    fn charts(p: &Params, on: ControlContext, run: &dyn Samples, from: f64, to: f64, points: usize) -> Vec<Chart> {
        let lathe = Resolved::new(p, on);
        let mut all = chart_rows::charts(charts::ROWS, &lathe, run, from, to, points);
        all.extend(charts::over_diameter(&lathe, points));
        all
    }
}

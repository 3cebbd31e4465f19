//! The turning spindle: a lathe that faces, turns or cuts a taper, and what its spindle does on the way.

pub mod params;

pub mod derive;

mod fitted;

mod readouts;

mod rules;

mod program;

mod plant;

mod scene;

mod pose;

mod graphs;

mod sheets;

use crate::controls::Control;
use crate::machines::charts;
use crate::machines::form::Field;
use crate::machines::form::rows::Newline;
use crate::machines::judge::{Rows, judge};
use crate::machines::{Design, Frame, Machine, On, Plan, Samples, Start};
use crate::motion::{Action, Plant, Plc, Snapshot};
use crate::text::catalog::number_text as show;
use crate::view::{Chart, Pose, Scene, Sheet};
use derive::Derived;
use fitted::Fitted;
use params::{FIELDS, Params};
use rules::{Case, RULES};

/// The machine.
#[derive(Debug)]
pub struct TurningSpindle;

/// The lathe, for its rows.
struct Lathe;

impl Rows for Lathe {
    type Fitted<'a> = Fitted<'a>;
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
    fn start(control: &Control) -> Start {
        let mut start = Start::timing(control);
        start.keep_common(control);
        start
    }

    fn design(p: &Params, on: On) -> Design {
        let lathe = Fitted::new(p, on);
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

    fn plan(p: &Params, on: On) -> Plan {
        let deck = program::deck(&Fitted::new(p, on));
        Plan { deck, setup: program::SETUP, main: program::RUN, crlf: p.newline == Newline::CrLf }
    }

    fn plant(p: &Params, on: On) -> Plant {
        plant::plant(&Fitted::new(p, on))
    }

    fn hand(p: &Params) -> Vec<Action> {
        vec![Action::SpindleOverride(p.override_percent)]
    }

    fn plc(p: &Params, on: On) -> Box<dyn Plc> {
        Box::new(plant::plc(&Fitted::new(p, on)))
    }

    fn sheets(p: &Params, on: On) -> Vec<Sheet> {
        sheets::sheets(&Fitted::new(p, on))
    }

    fn variables(p: &Params, on: On) -> Vec<(u32, &'static str, &'static str)> {
        program::variables(&Fitted::new(p, on))
    }

    fn scene(p: &Params, on: On) -> Scene {
        scene::scene(&Fitted::new(p, on))
    }

    fn pose(p: &Params, on: On, run: &dyn Samples, now: &Snapshot, frame: Frame) -> Pose {
        pose::pose(&Fitted::new(p, on), run, now, frame)
    }

    fn charts(p: &Params, on: On, run: &dyn Samples, from: f64, to: f64, points: usize) -> Vec<Chart> {
        let lathe = Fitted::new(p, on);
        let mut all = charts::charts(graphs::ROWS, &lathe, run, from, to, points);
        all.extend(graphs::over_diameter(&lathe, points));
        all
    }
}

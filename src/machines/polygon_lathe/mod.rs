//! The polygon lathe: a cutter disc and the work turn in a fixed ratio, started and stopped by G512 and G502, and flats appear.

pub mod params;

pub mod derive;

mod fitted;

mod readouts;

mod rules;

mod program;

mod plant;

mod plc;

mod scene;

mod pose;

mod progress;

mod graphs;

mod sheets;

mod ladder;

mod other;

mod drawings;

mod explore;

use crate::controls::Control;
use crate::machines::charts;
use crate::machines::form::Field;
use crate::machines::form::rows::Newline;
use crate::machines::judge::{Rows, judge};
use crate::machines::{Design, Frame, Machine, On, Plan, Samples, Start};
use crate::motion::{Action, Plant, Plc, Snapshot};
use crate::nc::File;
use crate::text::catalog::number_text as show;
use crate::view::{Chart, Explorer, Pose, Scene, Sheet};
use derive::Derived;
use fitted::Fitted;
use params::{FIELDS, Params};
use rules::{Case, RULES};

/// The machine.
#[derive(Debug)]
pub struct PolygonLathe;

/// The lathe, for its rows.
struct Lathe;

impl Rows for Lathe {
    type Fitted<'a> = Fitted<'a>;
    type Derived = Derived;
    type Case<'a> = Case<'a>;
}

impl Machine for PolygonLathe {
    type Params = Params;
    const ID: &'static str = "polygon-lathe";
    const NAME: &'static str = "polygon.name";
    const CONTROLS: &'static [&'static str] = &["knd-k2000t"];

    const LISTING: &'static str = include_str!("listing.nc");
    const SPEED: f64 = 0.05;
    const EXPLORER: Option<fn(&Params, On) -> Explorer> = Some(|p, on| explore::explorer(&Fitted::new(p, on)));

    fn fields() -> &'static [Field<Params>] {
        FIELDS
    }

    /// The control's own times.
    fn start(control: &Control) -> Start {
        Start::timing(control)
    }

    fn design(p: &Params, on: On) -> Design {
        let lathe = Fitted::new(p, on);
        let d = lathe.derived();
        let case = Case { lathe: &lathe, p: &lathe.p, d: &d };
        let shown = |id: &str| match id {
            "tool-speed" | "work-speed" | "ratio" | "distance" | "offset" | "passes" | "feed" | "finish-feed"
            | "ready" => true,
            _ if !d.cuts => false,
            "least-across-flats" | "insert-depth" | "insert-turn" => !d.even,
            "coast-phase" => fitted::coasts(&lathe.p, on.control),
            "twist" | "twist-speed" => lathe.p.lead != 0.0,
            _ => true,
        };
        let readouts = readouts::ROWS.iter().filter(|row| shown(row.id));
        let readouts = readouts.map(|row| judge(row, &d, row.unit, RULES, &case)).collect();
        Design { readouts, diagnostics: rules::findings(&case) }
    }

    fn plan(p: &Params, on: On) -> Plan {
        let deck = program::deck(&Fitted::new(p, on));
        Plan { deck, setup: 0, main: program::PART, crlf: p.newline == Newline::CrLf }
    }

    fn plant(p: &Params, on: On) -> Plant {
        plant::plant(&Fitted::new(p, on))
    }

    fn hand(_: &Params) -> Vec<Action> {
        Vec::new()
    }

    fn plc(p: &Params, on: On) -> Box<dyn Plc> {
        Box::new(plc::PolygonPlc::new(&Fitted::new(p, on)))
    }

    fn sheets(p: &Params, on: On) -> Vec<Sheet> {
        sheets::sheets(&Fitted::new(p, on))
    }

    fn drawings(p: &Params, on: On) -> Vec<File> {
        drawings::drawings(&Fitted::new(p, on))
    }

    fn variables(_: &Params, _: On) -> Vec<(u32, &'static str, &'static str)> {
        program::VARIABLES.to_vec()
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
        all.extend(graphs::deviation(&lathe, points));
        all.extend(graphs::over_radius(&lathe, points));
        all
    }
}

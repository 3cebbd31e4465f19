//! The polygon lathe: a cutter disc and the work turn in a fixed ratio, started and stopped by G512 and G502, and flats appear.

pub mod params;

pub mod derive;

mod geometry;

mod resolved;

mod readouts;

mod rules;

mod program;

mod plant;

mod plc;

mod scene;

mod pose;

mod progress;

mod charts;

mod sheets;

mod ladder;

mod native_code;

mod drawings;

mod sequence;

mod explore;

use crate::controls::Control;
use crate::machines::chart_rows;
use crate::machines::form::Field;
use crate::machines::form::rows::LineEnds;
use crate::machines::verdict::{Rows, judge};
use crate::machines::{ControlContext, Defaults, Design, Frame, Machine, MachineProgram, Samples};
use crate::motion::{Action, Plant, Plc, Snapshot};
use crate::nc::File;
use crate::text::catalog::number_text as show;
use crate::view::{Chart, Explorer, Pose, Scene, Sheet};
use derive::Derived;
use params::{FIELDS, Params};
use resolved::Resolved;
use rules::{Case, RULES};

/// The machine.
#[derive(Debug)]
pub struct PolygonLathe;

/// The lathe, for its rows.
struct Lathe;

impl Rows for Lathe {
    type Resolved<'a> = Resolved<'a>;
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
    const EXPLORER: Option<fn(&Params, ControlContext) -> Explorer> =
        Some(|p, on| explore::explorer(&Resolved::new(p, on)));

    fn fields() -> &'static [Field<Params>] {
        FIELDS
    }

    /// The control's own times.
    fn start(control: &Control) -> Defaults {
        Defaults::timing(control)
    }

    fn design(p: &Params, on: ControlContext) -> Design {
        let lathe = Resolved::new(p, on);
        let d = lathe.derived();
        let case = Case { lathe: &lathe, p: &lathe.p, d: &d };
        let shown = |id: &str| match id {
            "tool-speed" | "work-speed" | "ratio" | "distance" | "offset" | "passes" | "feed" | "finish-feed"
            | "ready" => true,
            _ if !d.cuts => false,
            "least-across-flats" | "insert-depth" | "insert-turn" => !d.even,
            "coast-phase" => lathe.p.coasts(on.control),
            "twist" | "twist-speed" => lathe.p.lead != 0.0,
            _ => true,
        };
        let readouts = readouts::ROWS.iter().filter(|row| shown(row.id));
        let readouts = readouts.map(|row| judge(row, &d, row.unit, RULES, &case)).collect();
        Design { readouts, diagnostics: rules::findings(&case) }
    }

    fn plan(p: &Params, on: ControlContext) -> MachineProgram {
        let deck = program::deck(&Resolved::new(p, on));
        MachineProgram { deck, setup: 0, main: program::PART, crlf: p.newline == LineEnds::CrLf }
    }

    fn plant(p: &Params, on: ControlContext) -> Plant {
        plant::plant(&Resolved::new(p, on))
    }

    fn hand(_: &Params) -> Vec<Action> {
        Vec::new()
    }

    fn plc(p: &Params, on: ControlContext) -> Box<dyn Plc> {
        Box::new(plc::PolygonPlc::new(&Resolved::new(p, on)))
    }

    fn sheets(p: &Params, on: ControlContext) -> Vec<Sheet> {
        sheets::sheets(&Resolved::new(p, on))
    }

    fn drawings(p: &Params, on: ControlContext) -> Vec<File> {
        drawings::drawings(&Resolved::new(p, on))
    }

    fn variables(_: &Params, _: ControlContext) -> Vec<(u32, &'static str, &'static str)> {
        program::VARIABLES.to_vec()
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
        all.extend(charts::deviation(&lathe, points));
        all.extend(charts::over_radius(&lathe, points));
        all
    }
}

//! The ribbon dot-printing line: an inverter unwinds, X pulls, another axis prints a dot every pitch.

pub mod params;

pub mod derive;

mod resolved;

mod readouts;

mod rules;

mod program;

mod plant;

mod plc;

mod scene;

mod pose;

mod charts;

mod sheets;

use crate::controls::Control;
use crate::controls::options::SpeedReached;
use crate::machines::chart_rows;
use crate::machines::form::Field;
use crate::machines::form::rows::LineEnds;
use crate::machines::verdict::{Row, Rows, judge};
use crate::machines::{ControlContext, Defaults, Design, Frame, Machine, MachineProgram, Samples};
use crate::motion::{Action, Plant, Plc, Snapshot};
use crate::text::catalog::number_text as show;
use crate::view::{Chart, Pose, Scene, Sheet};
use derive::Derived;
use params::{FIELDS, Params};
use resolved::Resolved;
use rules::{Case, RULES};

/// Id of the machine.
const ID: &str = "ribbon-line";

/// The machine.
#[derive(Debug)]
pub struct RibbonLine;

impl Machine for RibbonLine {
    type Params = Params;
    const ID: &'static str = ID;
    const NAME: &'static str = "ribbon.name";
    const CONTROLS: &'static [&'static str] = &["mitsubishi-e60", "gsk-980tdc", "sinumerik-802d", "knd-k2000t"];

    const LISTING: &'static str = include_str!("listing.nc");
    const SPEED: f64 = 0.05;

    fn fields() -> &'static [Field<Params>] {
        FIELDS
    }

    fn start(control: &Control) -> Defaults {
        start(control)
    }

    fn design(p: &Params, on: ControlContext) -> Design {
        design(&Resolved::new(p, on))
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
        Box::new(plc::RibbonPlc::new(&Resolved::new(p, on)))
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

    fn pose(p: &Params, on: ControlContext, _: &dyn Samples, now: &Snapshot, frame: Frame) -> Pose {
        pose::pose(&Resolved::new(p, on), now, frame)
    }

    fn charts(p: &Params, on: ControlContext, run: &dyn Samples, from: f64, to: f64, points: usize) -> Vec<Chart> {
        chart_rows::charts(charts::ROWS, &Resolved::new(p, on), run, from, to, points)
    }
}

/// The line, for its rows.
struct Line;

impl Rows for Line {
    type Resolved<'a> = Resolved<'a>;
    type Derived = Derived;
    type Case<'a> = Case<'a>;
}

/// The control's own times and ranges, and the parameter without which a second start would find no values.
fn start(control: &Control) -> Defaults {
    let mut start = Defaults::timing(control);
    start.number("feed-limit", control.limits.feed_max);
    start.keep_common(control);
    // Axes that wait until the unwinder has its speed let the ribbon pile up meanwhile.
    start.set(control, SpeedReached::NoWait);
    start
}

/// Results, each judged by the rules about it, and the errors.
fn design(line: &Resolved) -> Design {
    let d = Derived::new(&line.p, line.control.bench.output_bits);
    let case = Case { line, p: &line.p, d: &d, limits: &line.control.limits };
    let judged = |row| judge(row, &d, unit(row, line), RULES, &case);
    let readouts = readouts::ROWS.iter().map(judged).collect();
    Design { readouts, diagnostics: rules::findings(&case) }
}

/// The print roller's axis counts degrees where it is fitted so.
fn unit(row: &Row<Line>, line: &Resolved) -> &'static str {
    match row.id {
        "y-stroke" | "y-drift" if line.degrees() => "°",
        "y-feed" if line.degrees() => "°/min",
        _ => row.unit,
    }
}

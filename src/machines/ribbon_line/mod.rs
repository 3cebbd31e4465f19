//! The ribbon dot-printing line: an inverter unwinds, X pulls, Y prints a dot every pitch.

pub mod params;

pub mod derive;

mod readouts;

mod rules;

mod program;

mod plant;

mod plc;

mod scene;

mod pose;

mod charts;

mod sheets;

use crate::controls::{Control, Switches};
use crate::machines::form::Field;
use crate::machines::{Design, Frame, Machine, Plan, Samples};
use crate::motion::{Action, Plant, Plc, Snapshot};
use crate::view::{Chart, Pose, Readout, Scene, Sheet, Verdict};
use derive::Derived;
use params::{FIELDS, Newline, Params, YUnit};
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
    const CONTROLS: &'static [&'static str] = &["mitsubishi-e60"];

    const LISTING: &'static str = include_str!("listing.nc");

    fn fields() -> &'static [Field<Params>] {
        FIELDS
    }

    fn design(p: &Params, control: &Control) -> Design {
        design(p, control)
    }

    fn plan(p: &Params, _control: &Control) -> Plan {
        Plan { deck: program::deck(p), setup: program::SETUP, main: program::RUN, crlf: p.newline == Newline::CrLf }
    }

    fn plant(p: &Params, control: &Control) -> Plant {
        plant::plant(p, control)
    }

    fn hand(p: &Params) -> Vec<Action> {
        vec![Action::SpindleOverride(p.override_percent)]
    }

    fn plc(p: &Params, _control: &Control, _switches: &Switches) -> Box<dyn Plc> {
        Box::new(plc::RibbonPlc::new(p))
    }

    fn sheets(p: &Params, control: &Control, switches: &Switches) -> Vec<Sheet> {
        sheets::sheets(p, control, switches)
    }

    fn variables(_control: &Control) -> Vec<(u32, &'static str, &'static str)> {
        program::VARIABLES.to_vec()
    }

    fn scene(p: &Params) -> Scene {
        scene::scene(p)
    }

    fn pose(p: &Params, now: &Snapshot, frame: Frame) -> Pose {
        pose::pose(p, now, frame)
    }

    fn charts(p: &Params, run: &dyn Samples, from: f64, to: f64, points: usize) -> Vec<Chart> {
        charts::charts(p, run, from, to, points)
    }
}

/// Results, each judged by the rules about it, and the errors.
fn design(p: &Params, control: &Control) -> Design {
    let d = Derived::new(p, control.bench.output_bits);
    let case = Case { p, d: &d, limits: &control.limits };
    let readouts = readouts::ROWS.iter().map(|row| judged(row, &case)).collect();
    Design { readouts, diagnostics: rules::errors(&case) }
}

/// A result with the judgement of every rule about it: the worst verdict, all advice.
fn judged(row: &readouts::Row, case: &Case) -> Readout {
    let mut readout = Readout {
        id: row.id,
        label: row.label,
        value: (row.value)(case.d),
        unit: unit(row, case.p),
        decimals: row.decimals,
        limit: None,
        verdict: Verdict::None,
        advice: Vec::new(),
        formula: row.formula,
        cite: row.cite,
        headline: row.headline,
    };
    for rule in RULES.iter().filter(|rule| rule.on == row.id) {
        let Some(judgement) = (rule.judge)(case) else { continue };
        if judgement.verdict >= readout.verdict {
            readout.cite = rule.cite;
        }
        readout.verdict = readout.verdict.max(judgement.verdict);
        readout.limit = readout.limit.or(judgement.limit);
        readout.advice.extend(judgement.advice);
    }
    readout
}

/// Y counts degrees where the form says so.
fn unit(row: &readouts::Row, p: &Params) -> &'static str {
    match (p.y_unit, row.id) {
        (YUnit::Degrees, "y-stroke" | "y-drift") => "°",
        (YUnit::Degrees, "y-feed") => "°/min",
        _ => row.unit,
    }
}

/// A number as it is shown.
fn show(number: f64, decimals: u8) -> String {
    crate::text::catalog::number_text(number, decimals)
}

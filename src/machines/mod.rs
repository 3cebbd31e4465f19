//! The applications: each machine is a form, formulas, rules, a program, a PLC and a scene.

pub mod form;

use crate::controls::{Control, Switches};
use crate::motion::{Plant, Plc, Snapshot};
use crate::nc::Deck;
use crate::text::Diagnostic;
use crate::view::{Chart, Pose, Readout, Scene, Sheet};
use form::{FieldInfo, Values};

/// What a machine's formulas say of its values.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Design {
    /// Results with verdicts, in the order they are shown.
    pub readouts: Vec<Readout>,
    /// Invalid fields (errors) and remarks.
    pub diagnostics: Vec<Diagnostic>,
}

/// The program of a machine, before it is written.
#[derive(Debug, Clone, Default)]
pub struct Plan {
    /// Programs, one per file.
    pub deck: Deck,
    /// Program number that sets the project's values, run once before the first start; 0 where there is none.
    pub setup: u32,
    /// Program number that runs the machine.
    pub main: u32,
}

/// How a chart or pose samples the run.
pub trait Samples {
    /// The machine at time `t`.
    fn at(&self, t: f64) -> Snapshot;
}

/// How a frame is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Machine seconds between two frames, to know what blurs.
    pub step: f64,
    /// Stroboscope: show the roller each time a head meets the ribbon.
    pub strobe: bool,
}

/// A machine, erased over its parameters so that the page is compiled once.
pub trait AnyMachine: Sync {
    /// Id, for instance `ribbon-line`.
    fn id(&self) -> &'static str;
    /// Catalog id of the name.
    fn name(&self) -> &'static str;
    /// Ids of the controls it goes with; the first is the default.
    fn controls(&self) -> &'static [&'static str];
    /// The form.
    fn fields(&self) -> Vec<FieldInfo>;
    /// Results and verdicts. Total.
    fn design(&self, values: &Values, control: &Control) -> Design;
    /// The program. Total; where values are invalid the last valid default stands in and `design` has said so.
    fn plan(&self, values: &Values, control: &Control) -> Plan;
    /// The plant that runs it.
    fn plant(&self, values: &Values, control: &Control) -> Plant;
    /// The builder's PLC.
    fn plc(&self, values: &Values, control: &Control, switches: &Switches) -> Box<dyn Plc>;
    /// Parameter sheet, interface, ladder list.
    fn sheets(&self, values: &Values, control: &Control) -> Vec<Sheet>;
    /// Variables of the control that the operator reads and sets: number, catalog id of the meaning, unit.
    fn variables(&self, control: &Control) -> Vec<(u32, &'static str, &'static str)>;
    /// The drawing.
    fn scene(&self, values: &Values) -> Scene;
    /// The drawing at a moment.
    fn pose(&self, values: &Values, now: &Snapshot, frame: Frame) -> Pose;
    /// Charts from `from` to `to` seconds with `points` points each.
    fn charts(&self, values: &Values, run: &dyn Samples, from: f64, to: f64, points: usize) -> Vec<Chart>;
}

/// All machines, in the order they are listed.
pub static ALL: &[&dyn AnyMachine] = &[];

/// The machine of an id.
pub fn find(id: &str) -> Option<&'static dyn AnyMachine> {
    ALL.iter().copied().find(|machine| machine.id() == id)
}

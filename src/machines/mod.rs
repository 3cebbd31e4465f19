//! The applications: each machine is a form, formulas, rules, a program, a PLC and a scene.

use core::marker::PhantomData;

pub mod form;

pub mod settings;

pub mod report;

mod verdict;

mod chart_rows;

mod writing;

mod sheets;

pub mod ribbon_line;

pub mod turning_spindle;

pub mod polygon_lathe;

use crate::controls::options::{CommonAtReset, SwitchChoice};
use crate::controls::{Control, Dialect, Switches};
use crate::math;
use crate::motion::{Action, Planner, Plant, Plc, RunningProgram, Snapshot};
use crate::msg;
use crate::nc::{Deck, File};
use crate::text::{Diagnostic, DiagnosticKind};
use crate::view::{Chart, Explorer, Pose, Readout, Scene, Sheet};
use form::{Field, FieldInfo, Origins, Value, Values};

/// The control that a machine is on, with its open points as they are set.
#[derive(Debug, Clone, Copy)]
pub struct ControlContext<'a> {
    /// The control.
    pub control: &'a Control,
    /// Settings of its open points.
    pub switches: &'a Switches,
}

impl ControlContext<'_> {
    /// What rows and settings come to.
    pub fn dialect(&self) -> Dialect {
        Dialect::resolve(self.control, self.switches)
    }
}

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
pub struct MachineProgram {
    /// Programs, one per file.
    pub deck: Deck,
    /// Program number that sets the project's values, run once before the first start; 0 where there is none.
    pub setup: u32,
    /// Program number that runs the machine.
    pub main: u32,
    /// Lines end in CR LF instead of LF.
    pub crlf: bool,
}

/// What a new project has besides the defaults of the form.
#[derive(Debug, Clone, Default)]
pub struct Defaults {
    /// Values by field id.
    pub values: Values,
    /// Settings that the machine needs.
    pub switches: Switches,
}

impl Defaults {
    /// The control's own times of blocks.
    fn timing(control: &Control) -> Defaults {
        let mut start = Defaults::default();
        for (id, value) in [
            ("block-time", control.timing.block * 1000.0),
            ("macro-time", control.timing.macro_block * 1000.0),
            ("preread", f64::from(control.timing.preread)),
        ] {
            start.number(id, value);
        }
        start
    }

    /// A number of the form, in thousandths.
    fn number(&mut self, id: &str, value: f64) {
        self.values.insert(id.to_owned(), Value::Number((value * 1000.0).round() / 1000.0));
    }

    /// Common variables stay at reset: without them a second start would find no values.
    fn keep_common(&mut self, control: &Control) {
        self.set(control, CommonAtReset::Kept);
    }

    /// A setting of the control that the machine needs, where that is not the default.
    fn set<C: SwitchChoice>(&mut self, control: &Control, choice: C) {
        let setting = choice.option().id;
        if let Some(row) = control.switch(C::SWITCH).filter(|row| row.takes(setting)) {
            self.switches.set(row, setting);
        }
    }
}

/// How a chart or pose samples the run.
pub trait Samples {
    /// The machine at time `t`.
    fn at(&self, t: f64) -> Snapshot;
    /// How often the block with this sequence number in the program that was started has begun until time `t`, and whether it
    /// executes then.
    fn passes(&self, sequence: u32, t: f64) -> (u32, bool);
    /// When an axis, by its index, was told below 0 until time `t`, and when it was lowest since then.
    fn dips(&self, axis: usize, t: f64) -> Vec<(f64, f64)>;
}

impl<P: RunningProgram> Samples for Planner<P> {
    fn at(&self, t: f64) -> Snapshot {
        self.timeline().at(t)
    }

    fn passes(&self, sequence: u32, t: f64) -> (u32, bool) {
        let Some(place) = self.program().numbered(sequence) else { return (0, false) };
        let timeline = self.timeline();
        (timeline.times(place, t), timeline.block_at(t) == Some(place))
    }

    fn dips(&self, axis: usize, t: f64) -> Vec<(f64, f64)> {
        self.timeline().dips(axis, t)
    }
}

/// How a frame is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Machine seconds between two frames, to know what blurs.
    pub step: f64,
    /// Stroboscope: show the roller each time a head meets the ribbon.
    pub strobe: bool,
}

impl Frame {
    /// How clearly a turning part is seen that turns `step` degrees from frame to frame: 1 up to `limit`, 0 where it blurs half as fast
    /// again, and a little in between.
    fn seen(step: f64, limit: f64) -> f64 {
        math::clamp((1.5 * limit - step) / (0.5 * limit), 0.0, 1.0)
    }
}

/// A machine: a form that fills `Params`, and what follows from them. Everything is total.
pub trait Machine: 'static {
    /// The values of the form as the formulas take them, all within their ranges.
    type Params: Default;
    /// Id, for instance `ribbon-line`.
    const ID: &'static str;
    /// Catalog id of the name.
    const NAME: &'static str;
    /// Ids of the controls it goes with; the first is the default.
    const CONTROLS: &'static [&'static str];
    /// The published listing of the machine's program, word for word as printed; empty where none is known.
    const LISTING: &'static str;
    /// Machine seconds per second at which there is something to see, one of the speeds of the page.
    const SPEED: f64;
    /// What is dragged to look for a shape; most machines have nothing.
    const EXPLORER: Option<fn(&Self::Params, ControlContext) -> Explorer> = None;
    /// The form, in the order it is shown.
    fn fields() -> &'static [Field<Self::Params>];
    /// What a new project has on this control instead of the defaults of the form: values of fields, settings of switches.
    fn start(control: &Control) -> Defaults;
    /// Results and verdicts.
    fn design(params: &Self::Params, on: ControlContext) -> Design;
    /// The program.
    fn plan(params: &Self::Params, on: ControlContext) -> MachineProgram;
    /// The plant that runs it.
    fn plant(params: &Self::Params, on: ControlContext) -> Plant;
    /// How the operator's knobs stand when a run begins.
    fn hand(params: &Self::Params) -> Vec<Action>;
    /// The builder's PLC.
    fn plc(params: &Self::Params, on: ControlContext) -> Box<dyn Plc>;
    /// Parameter sheet, interface, ladder list.
    fn sheets(params: &Self::Params, on: ControlContext) -> Vec<Sheet>;
    /// Drawings that leave with an export.
    fn drawings(_: &Self::Params, _: ControlContext) -> Vec<File> {
        Vec::new()
    }
    /// Variables that the operator reads and sets: number, catalog id of the meaning, unit.
    fn variables(params: &Self::Params, on: ControlContext) -> Vec<(u32, &'static str, &'static str)>;
    /// The drawing.
    fn scene(params: &Self::Params, on: ControlContext) -> Scene;
    /// The drawing at a moment.
    fn pose(params: &Self::Params, on: ControlContext, run: &dyn Samples, now: &Snapshot, frame: Frame) -> Pose;
    /// Charts from `from` to `to` seconds with `points` points each.
    fn charts(
        params: &Self::Params,
        on: ControlContext,
        run: &dyn Samples,
        from: f64,
        to: f64,
        points: usize,
    ) -> Vec<Chart>;
}

/// A machine, erased over its parameters so that the page is compiled once.
pub trait AnyMachine: Sync {
    /// Id, for instance `ribbon-line`.
    fn id(&self) -> &'static str;
    /// Catalog id of the name.
    fn name(&self) -> &'static str;
    /// Ids of the controls it goes with; the first is the default.
    fn controls(&self) -> &'static [&'static str];
    /// The published listing of its program, word for word as printed.
    fn listing(&self) -> &'static str;
    /// Machine seconds per second at which there is something to see.
    fn speed(&self) -> f64;
    /// The form.
    fn fields(&self) -> Vec<FieldInfo>;
    /// What a new project has on this control instead of the defaults of the form.
    fn start(&self, control: &Control) -> Defaults;
    /// Fields that have no meaning on this control with these values; their values stay.
    fn hidden(&self, values: &Values, control: &Control) -> Vec<&'static str>;
    /// Results and verdicts; invalid fields as errors, facts that are only assumed as a remark. Total.
    fn design(&self, values: &Values, origins: &Origins, on: ControlContext) -> Design;
    /// The program. Total; where values are invalid the default stands in and `design` has said so.
    fn plan(&self, values: &Values, on: ControlContext) -> MachineProgram;
    /// The plant that runs it.
    fn plant(&self, values: &Values, on: ControlContext) -> Plant;
    /// How the operator's knobs stand when a run begins.
    fn hand(&self, values: &Values) -> Vec<Action>;
    /// The builder's PLC.
    fn plc(&self, values: &Values, on: ControlContext) -> Box<dyn Plc>;
    /// Parameter sheet, interface, ladder list.
    fn sheets(&self, values: &Values, on: ControlContext) -> Vec<Sheet>;
    /// Drawings that leave with an export.
    fn drawings(&self, values: &Values, on: ControlContext) -> Vec<File>;
    /// Whether the machine has an explorer.
    fn explores(&self) -> bool;
    /// Values to drag and the shape that follows from them; most machines have none.
    fn explorer(&self, values: &Values, on: ControlContext) -> Option<Explorer>;
    /// Variables of the control that the operator reads and sets: number, catalog id of the meaning, unit.
    fn variables(&self, values: &Values, on: ControlContext) -> Vec<(u32, &'static str, &'static str)>;
    /// The drawing.
    fn scene(&self, values: &Values, on: ControlContext) -> Scene;
    /// The drawing at a moment.
    fn pose(&self, values: &Values, on: ControlContext, run: &dyn Samples, now: &Snapshot, frame: Frame) -> Pose;
    /// Charts from `from` to `to` seconds with `points` points each.
    fn charts(
        &self,
        values: &Values,
        on: ControlContext,
        run: &dyn Samples,
        from: f64,
        to: f64,
        points: usize,
    ) -> Vec<Chart>;
}

/// The erased form of a machine `M`.
#[derive(Debug)]
pub struct Erased<M>(PhantomData<fn() -> M>);

impl<M: Machine> Erased<M> {
    /// The machine as data.
    pub const fn new() -> Erased<M> {
        Erased(PhantomData)
    }

    fn params(values: &Values) -> (M::Params, Vec<Diagnostic>) {
        let mut params = M::Params::default();
        form::fill::defaults(M::fields(), &mut params);
        let found = form::fill::fill(M::fields(), values, &mut params);
        (params, found)
    }
}

impl<M: Machine> Default for Erased<M> {
    fn default() -> Erased<M> {
        Erased::new()
    }
}

impl<M: Machine> AnyMachine for Erased<M> {
    fn id(&self) -> &'static str {
        M::ID
    }

    fn name(&self) -> &'static str {
        M::NAME
    }

    fn controls(&self) -> &'static [&'static str] {
        M::CONTROLS
    }

    fn listing(&self) -> &'static str {
        M::LISTING
    }

    fn speed(&self) -> f64 {
        M::SPEED
    }

    fn fields(&self) -> Vec<FieldInfo> {
        M::fields().iter().map(Field::info).collect()
    }

    fn start(&self, control: &Control) -> Defaults {
        M::start(control)
    }

    fn hidden(&self, values: &Values, control: &Control) -> Vec<&'static str> {
        let params = Erased::<M>::params(values).0;
        M::fields().iter().filter(|field| !(field.shown)(&params, control)).map(|field| field.id).collect()
    }

    fn design(&self, values: &Values, origins: &Origins, on: ControlContext) -> Design {
        let (params, mut diagnostics) = Erased::<M>::params(values);
        let mut design = M::design(&params, on);
        diagnostics.append(&mut design.diagnostics);
        let hidden = self.hidden(values, on.control);
        let mut assumed = form::fill::assumed(&self.fields(), origins);
        assumed.retain(|id| !hidden.contains(id));
        if !assumed.is_empty() {
            diagnostics.push(
                Diagnostic::info(msg!("form.assumed", assumed.len() as u32, assumed.join(", ")))
                    .kind(DiagnosticKind::AssumedFacts),
            );
        }
        Design { diagnostics, ..design }
    }

    fn plan(&self, values: &Values, on: ControlContext) -> MachineProgram {
        M::plan(&Erased::<M>::params(values).0, on)
    }

    fn plant(&self, values: &Values, on: ControlContext) -> Plant {
        M::plant(&Erased::<M>::params(values).0, on)
    }

    fn hand(&self, values: &Values) -> Vec<Action> {
        M::hand(&Erased::<M>::params(values).0)
    }

    fn plc(&self, values: &Values, on: ControlContext) -> Box<dyn Plc> {
        M::plc(&Erased::<M>::params(values).0, on)
    }

    fn sheets(&self, values: &Values, on: ControlContext) -> Vec<Sheet> {
        M::sheets(&Erased::<M>::params(values).0, on)
    }

    fn drawings(&self, values: &Values, on: ControlContext) -> Vec<File> {
        M::drawings(&Erased::<M>::params(values).0, on)
    }

    fn explores(&self) -> bool {
        M::EXPLORER.is_some()
    }

    fn explorer(&self, values: &Values, on: ControlContext) -> Option<Explorer> {
        M::EXPLORER.map(|explorer| explorer(&Erased::<M>::params(values).0, on))
    }

    fn variables(&self, values: &Values, on: ControlContext) -> Vec<(u32, &'static str, &'static str)> {
        M::variables(&Erased::<M>::params(values).0, on)
    }

    fn scene(&self, values: &Values, on: ControlContext) -> Scene {
        M::scene(&Erased::<M>::params(values).0, on)
    }

    fn pose(&self, values: &Values, on: ControlContext, run: &dyn Samples, now: &Snapshot, frame: Frame) -> Pose {
        M::pose(&Erased::<M>::params(values).0, on, run, now, frame)
    }

    fn charts(
        &self,
        values: &Values,
        on: ControlContext,
        run: &dyn Samples,
        from: f64,
        to: f64,
        points: usize,
    ) -> Vec<Chart> {
        M::charts(&Erased::<M>::params(values).0, on, run, from, to, points)
    }
}

/// The list of the machines.
macro_rules! machines {
    ($($machine:ty),*) => {
        /// All machines, in the order of the choice on the page.
        pub static ALL: &[&dyn AnyMachine] = &[$(&Erased::<$machine>::new()),*];
    };
}

machines![ribbon_line::RibbonLine, turning_spindle::TurningSpindle, polygon_lathe::PolygonLathe];

/// The machine with this id.
pub fn find(id: &str) -> Option<&'static dyn AnyMachine> {
    ALL.iter().copied().find(|machine| machine.id() == id)
}

//! The interfaces of a machine: [`Machine`] is implemented once per machine, [`Prepared`] is a machine with its values on a control.
//!
//! A machine is prepared once per change of a value. The prepared machine gives design, program, plant, PLC, sheets,
//! drawing and charts; all of its functions are total.

use super::defaults::Defaults;
use super::design::{ControlContext, Design};
use super::prepared::Prepared;
use core::fmt;
use core::marker::PhantomData;
use core::ops::Deref;

use super::examples::Example;
use super::left_out::LeftOut;
use super::samples::Samples;
use crate::controls::{Control, Switches};
use crate::machines::driven::FormMotor;
use crate::machines::form::fill::{assumed, defaults, fill};
use crate::machines::form::read::with_entries;
use crate::machines::form::{Field, FieldInfo, Origins, Values};
use crate::math;
use crate::msg;
use crate::text::catalog::words;
use crate::text::{Diagnostic, DiagnosticKind, listed};
use crate::view::{Advice, FieldEntry, Readout, Verdict};

/// Constants of a type of machine.
#[derive(Debug, Clone, Copy)]
pub struct MachineInfo {
    /// Id, for instance `ribbon-line`.
    pub id: &'static str,
    /// Catalog id of the name.
    pub name: &'static str,
    /// Ids of the controls it goes with; the first is the default.
    pub controls: &'static [&'static str],
    /// The published listing of the machine's program, word for word as printed; `None` if none is known.
    pub listing: Option<&'static str>,
    /// Blocks that the listing leaves out.
    pub left_out: &'static [LeftOut],
    /// Playback speed (machine seconds per second) at which the motion is visible: one of the speeds of the page.
    pub speed: f64,
    /// Ids of the number fields whose increase raises the demand on the machine, for the limits of growth; the first is
    /// its speed.
    pub growth: &'static [&'static str],
    /// Id of the result with its speed; `None` if there is none.
    pub speed_result: Option<&'static str>,
    /// Id of the field with the customer's name; `None` if there is none.
    pub customer: Option<&'static str>,
    /// The motors that its form describes, in the order of a bill.
    pub motors: &'static [FormMotor],
    /// Whether it has an [explorer](Prepared::explorer).
    pub explores: bool,
    /// Named examples; a new project is the first, and the defaults of the form where there is none.
    pub examples: &'static [Example],
}

impl MachineInfo {
    /// Defaults for `MachineInfo { id, name, controls, ..MachineInfo::BASE }`: no listing, growth, motors, explorer or
    /// examples.
    pub const BASE: MachineInfo = MachineInfo {
        id: "",
        name: "",
        controls: &[],
        listing: None,
        left_out: &[],
        speed: 1.0,
        growth: &[],
        speed_result: None,
        customer: None,
        motors: &[],
        explores: false,
        examples: &[],
    };
}

/// A type of machine: a form that fills `Params`, and the [`Prepared`] machine made from them.
pub trait Machine: Prepared + Sized + 'static {
    /// The values of the form in the units of the formulas, all within their ranges.
    type Params: Default;
    /// Name, controls, examples and roles of fields and results.
    const INFO: MachineInfo;
    /// The fields of the form in their order.
    fn fields() -> &'static [Field<Self::Params>];
    /// Values and settings of a new project on this control in place of the form's defaults: the control's own block times.
    fn defaults(control: &Control) -> Defaults {
        Defaults::timing(control)
    }
    /// Prepares the machine: computes once what several functions need.
    fn new(params: Self::Params, on: ControlContext) -> Self;
}

/// A machine without the type of its parameters, for the list of machines.
pub trait AnyMachine: Sync {
    /// Its constants.
    fn info(&self) -> &'static MachineInfo;
    /// Id, for instance `ribbon-line`.
    fn id(&self) -> &'static str {
        self.info().id
    }
    /// Catalog id of the name.
    fn name(&self) -> &'static str {
        self.info().name
    }
    /// Ids of the controls it goes with; the first is the default.
    fn controls(&self) -> &'static [&'static str] {
        self.info().controls
    }
    /// Named examples; a new project is the first, and the defaults of the form where there is none.
    fn examples(&self) -> &'static [Example] {
        self.info().examples
    }
    /// The form.
    fn fields(&self) -> Vec<FieldInfo>;
    /// Values and settings that a new project on this control has instead of the defaults of the form.
    fn defaults(&self, control: &Control) -> Defaults;
    /// The machine with these values on a control. Invalid values are reported by [`PreparedMachine::design`] and replaced by their
    /// defaults.
    fn prepare(&self, values: &Values, on: ControlContext) -> PreparedMachine;
}

/// A prepared machine, and the findings of its form about the values.
pub struct PreparedMachine {
    machine: Box<dyn Prepared>,
    invalid: Vec<Diagnostic>,
    hidden: Vec<&'static str>,
    facts: Vec<&'static str>,
    trial: Trial,
}

/// The values that a machine was prepared from, for trials with other ones.
struct Trial {
    machine: &'static dyn AnyMachine,
    values: Values,
    control: &'static Control,
    switches: Switches,
}

impl Trial {
    /// Results and errors with other entries of the form; `None` if the form rejects one of them.
    fn with(&self, entries: &[FieldEntry]) -> Option<(Vec<Readout>, usize)> {
        let values = with_entries(&self.values, &self.machine.fields(), entries)?;
        let prepared =
            self.machine.prepare(&values, ControlContext { control: self.control, switches: &self.switches });
        let results = prepared.results();
        let errors = prepared.errors(&results);
        Some((results.readouts, errors))
    }
}

impl fmt::Debug for PreparedMachine {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("PreparedMachine").field("invalid", &self.invalid).finish_non_exhaustive()
    }
}

impl Deref for PreparedMachine {
    type Target = dyn Prepared;

    fn deref(&self) -> &(dyn Prepared + 'static) {
        &*self.machine
    }
}

impl PreparedMachine {
    /// Time (s) and catalog id of the first contact with the work, up to `until` (s).
    pub fn first_contact(&self, run: &dyn Samples, until: f64) -> Option<(f64, &'static str)> {
        let contact = |t: f64| self.machine.contact(run, &run.at(t));
        // A spindle at standstill does not cut any more: the contact was within the first span of work.
        let in_work = || self.machine.working(run, until)?.first().map(|(begin, end)| 0.5 * (begin + end));
        let with_name = |t: f64| Some((t, contact(t)?));
        let (latest, name) = with_name(until).or_else(|| with_name(in_work()?))?;
        // To a hundredth of a millisecond in a run of ten hours.
        let first = math::last_holding(latest, 0.0, 32, |t| contact(t).is_some());
        Some((first, name))
    }

    /// Ids of the facts that apply on this control with these values.
    pub fn facts(&self) -> &[&'static str] {
        &self.facts
    }

    /// Ids of the fields that do not apply on this control with these values; their values stay.
    pub fn hidden(&self) -> &[&'static str] {
        &self.hidden
    }

    fn errors(&self, results: &Design) -> usize {
        let found = self.invalid.iter().chain(&results.diagnostics);
        found.filter(|found| found.is_error()).count()
    }

    /// Tries the remedy of each advice. A remedy that does not improve the verdict of its result, or that raises
    /// another error, is removed; the message stays. After each other remedy follows an advice for each result that it
    /// makes fail.
    fn check_remedies(&self, design: &mut Design) {
        let errors = self.errors(design);
        let failing = |readouts: &[Readout]| {
            let failing = readouts.iter().filter(|readout| readout.verdict == Verdict::Fail);
            failing.map(|readout| (readout.id, readout.label)).collect::<Vec<_>>()
        };
        let before = failing(&design.readouts);
        for readout in &mut design.readouts {
            let (id, verdict) = (readout.id, readout.verdict);
            for mut advice in core::mem::take(&mut readout.advice) {
                let trial = if advice.entries.is_empty() { None } else { self.trial.with(&advice.entries) };
                let after = trial.filter(|(readouts, left)| {
                    let after = readouts.iter().find(|readout| readout.id == id);
                    *left <= errors && after.map_or(Verdict::None, |readout| readout.verdict) < verdict
                });
                let turned = after.as_ref().map(|(readouts, _)| failing(readouts)).unwrap_or_default();
                if after.is_none() {
                    advice = Advice::from(advice.message);
                }
                readout.advice.push(advice);
                let turned = turned.into_iter().filter(|row| !before.contains(row));
                readout.advice.extend(turned.map(|(_, label)| Advice::turns_red(label)));
            }
        }
    }

    /// Results and verdicts; invalid fields as errors, a site beyond the data sheets and assumed facts as remarks.
    pub fn design(&self, origins: &Origins) -> Design {
        let mut design = self.machine.results();
        self.check_remedies(&mut design);
        design.diagnostics.splice(0..0, self.invalid.iter().cloned());
        design.diagnostics.extend(self.machine.severe_site().map(|site| site.remark()));
        let assumed = assumed(&self.facts, origins);
        if !assumed.is_empty() {
            let fields = self.trial.machine.fields();
            let label = |id: &&str| fields.iter().find(|field| field.id == *id).map(|field| words(field.label));
            let labels = listed(assumed.iter().filter_map(label));
            let message = msg!("form.assumed", count = assumed.len() as u32, fields = labels);
            design.diagnostics.push(Diagnostic::info(message).kind(DiagnosticKind::AssumedFacts));
        }
        design
    }
}

/// A machine `M` as [`AnyMachine`].
#[derive(Debug)]
pub struct Erased<M>(PhantomData<fn() -> M>);

impl<M: Machine> Erased<M> {
    /// The machine as a value of the list.
    pub const fn new() -> Erased<M> {
        Erased(PhantomData)
    }
}

impl<M: Machine> Default for Erased<M> {
    fn default() -> Erased<M> {
        Erased::new()
    }
}

impl<M: Machine> AnyMachine for Erased<M> {
    fn info(&self) -> &'static MachineInfo {
        const { &M::INFO }
    }

    fn fields(&self) -> Vec<FieldInfo> {
        M::fields().iter().map(Field::info).collect()
    }

    fn defaults(&self, control: &Control) -> Defaults {
        M::defaults(control)
    }

    fn prepare(&self, values: &Values, on: ControlContext) -> PreparedMachine {
        let mut params = M::Params::default();
        defaults(M::fields(), &mut params);
        let invalid = fill(M::fields(), values, &mut params);
        let (shown, hidden) =
            M::fields().iter().partition::<Vec<&Field<M::Params>>, _>(|field| (field.shown)(&params, on.control));
        let facts = shown.into_iter().filter(|field| field.role.is_fact()).map(|field| field.id).collect();
        let hidden = hidden.into_iter().map(|field| field.id).collect();
        let trial = Trial {
            machine: const { &Erased::<M>::new() },
            values: values.clone(),
            control: on.control,
            switches: on.switches.clone(),
        };
        PreparedMachine { machine: Box::new(M::new(params, on)), invalid, hidden, facts, trial }
    }
}

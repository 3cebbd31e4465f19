//! The operating envelope: what happens to the machine at start, in the run, at the ends of the knob, at a change of speed, at every stop.
//!
//! Each event is a run of the program with an operator's hand at the middle of its work; formulas check these runs, see `tests/it/sizing`.

use super::choice::ampere_per_torque;
use super::runs::{SizingRuns, finish, plan};
use crate::machines::PreparedMachine;
use crate::machines::driven::{DrivenAxis, ProductSize};
use crate::motion::{Action, Event, RunEnd};
use crate::project::Project;
use crate::project::run::Run;
use crate::view::{Limit, Verdict};

/// Seconds after a change for which the machine is looked at.
const SPAN: f64 = 10.0;

/// Seconds from standstill to the next cycle start.
const PAUSE: f64 = 1.0;

/// Moments at which gauges are read.
const POINTS: usize = 400;

/// A tenth of the knob: what an operator turns at a time, %.
const TURN: f64 = 10.0;

/// Change of the product size that is tried, as a fraction of the present size.
const TENTH: f64 = 0.1;

/// An event of operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OperatingEvent {
    /// From cycle start to the first contact with the work.
    Start,
    /// From there to the end of the program.
    Run,
    /// The knob goes to either end.
    Knob,
    /// The knob is turned by one step, and back.
    SpeedChange,
    /// The operator types a product a tenth larger or smaller, and then the present one again.
    ProductChange,
    /// Feed hold, and cycle start after standstill.
    Hold,
    /// The inverter reports a fault.
    Alarm,
    /// Emergency stop.
    EmergencyStop,
    /// The supply fails: servo axes brake, the spindle coasts.
    PowerFailure,
}

impl OperatingEvent {
    /// All of them with the ids that programs read, in the order of operation.
    pub const IDS: [(OperatingEvent, &'static str); 9] = [
        (OperatingEvent::Start, "start"),
        (OperatingEvent::Run, "run"),
        (OperatingEvent::Knob, "knob"),
        (OperatingEvent::SpeedChange, "speed-change"),
        (OperatingEvent::ProductChange, "product-change"),
        (OperatingEvent::Hold, "hold"),
        (OperatingEvent::Alarm, "alarm"),
        (OperatingEvent::EmergencyStop, "estop"),
        (OperatingEvent::PowerFailure, "power-fail"),
    ];

    /// Its id.
    pub fn id(self) -> &'static str {
        OperatingEvent::IDS.iter().find(|row| row.0 == self).map_or("", |row| row.1)
    }

    /// Catalog id of its name.
    pub fn name(self) -> &'static str {
        match self {
            OperatingEvent::Start => "size.event.start",
            OperatingEvent::Run => "size.event.run",
            OperatingEvent::Knob => "size.event.knob",
            OperatingEvent::SpeedChange => "size.event.speed-change",
            OperatingEvent::ProductChange => "size.event.product-change",
            OperatingEvent::Hold => "size.event.hold",
            OperatingEvent::Alarm => "size.event.alarm",
            OperatingEvent::EmergencyStop => "size.event.emergency-stop",
            OperatingEvent::PowerFailure => "size.event.power-failure",
        }
    }
}

/// A quantity at an event.
#[derive(Debug, Clone, PartialEq)]
pub struct EnvelopeRow {
    /// The event.
    pub event: OperatingEvent,
    /// Id of the quantity, for instance `loop` or `x-torque`.
    pub id: String,
    /// Catalog id of its name.
    pub label: &'static str,
    /// Catalog id of the axis that it is about; none for others.
    pub axis: Option<&'static str>,
    /// Its worst value.
    pub value: f64,
    /// Unit.
    pub unit: &'static str,
    /// Decimals shown.
    pub decimals: u8,
    /// Its limit, in `unit`.
    pub limit: Option<Limit>,
    /// Field of the form that is the limit, where one is.
    pub field: Option<&'static str>,
    /// Whether it holds.
    pub verdict: Verdict,
    /// Whether it is the worst of this quantity over all events.
    pub is_worst: bool,
}

/// The rows of all events that the machine knows; `done` is called after each.
pub(super) fn envelope(project: &Project, whole: &SizingRuns, done: &mut dyn FnMut()) -> Vec<EnvelopeRow> {
    let prepared = &*project.prepared();
    let with_current = |axis: DrivenAxis| (axis, ampere_per_torque(project, &axis));
    let axes = prepared.driven_axes().into_iter().map(with_current).collect();
    let product = prepared.product_size().filter(|_| project.edited.is_none());
    let envelope = Envelope { prepared, whole, axes, product, middle: 0.5 * (whole.contact + whole.end) };
    let mut rows = Vec::new();
    for (event, _) in OperatingEvent::IDS {
        rows.extend(envelope.rows(event));
        done();
    }
    mark_worst(&mut rows);
    rows
}

/// Marks the worst row of each quantity: the one that is nearest to its limit or farthest beyond; of equal ones the first.
fn mark_worst(rows: &mut [EnvelopeRow]) {
    for at in 0..rows.len() {
        let others = rows.iter().enumerate().filter(|(_, other)| other.id == rows[at].id);
        let worst = others.reduce(|worst, next| if next.1.load() > worst.1.load() { next } else { worst });
        rows[at].is_worst = worst.is_some_and(|(worst, _)| worst == at);
    }
}

impl EnvelopeRow {
    /// How much its value asks of its limit.
    fn load(&self) -> f64 {
        Limit::load(self.limit, self.value)
    }
}

struct Envelope<'a> {
    prepared: &'a PreparedMachine,
    whole: &'a SizingRuns,
    /// The axes, each with the current of its motor for 1 Nm, where it is known.
    axes: Vec<(DrivenAxis, Option<f64>)>,
    /// The size that the operator may type; none where the program is not macroline's own.
    product: Option<ProductSize>,
    /// Time (s) at which the operator's hand acts.
    middle: f64,
}

impl Envelope<'_> {
    fn rows(&self, event: OperatingEvent) -> Vec<EnvelopeRow> {
        let (run, at) = (&self.whole.run, self.middle);
        match event {
            OperatingEvent::Start => {
                let mut rows = self.read(event, run, (0.0, self.whole.contact));
                rows.push(time(event, self.whole.contact));
                rows
            }
            OperatingEvent::Run => {
                let mut rows = self.read(event, run, (self.whole.contact, self.whole.end));
                rows.push(time(event, self.whole.end - self.whole.contact));
                rows
            }
            OperatingEvent::Knob => {
                let Some((low, high)) = self.whole.knob else { return Vec::new() };
                let turn = |percent| vec![(at, Action::SpindleOverride(percent))];
                worse([low, high].map(|percent| self.handled(event, turn(percent))))
            }
            OperatingEvent::SpeedChange => {
                let Some((low, high)) = self.whole.knob else { return Vec::new() };
                let now = self.prepared.panel().spindle_override.unwrap_or(100.0);
                let next = if now + TURN <= high { now + TURN } else { (now - TURN).max(low) };
                let [there, back] = [next, now].map(Action::SpindleOverride);
                self.handled(event, vec![(at, there), (at + 0.5 * SPAN, back)])
            }
            OperatingEvent::ProductChange => {
                let Some(product) = self.product else { return Vec::new() };
                // To thousandths, as it is typed.
                let typed = |size: f64| Action::Variable(product.variable, Some((1000.0 * size).round() / 1000.0));
                let change = |part: f64| {
                    let [other, present] = [part * product.size, product.size].map(typed);
                    self.handled(event, vec![(at, other), (at + 0.5 * SPAN, present)])
                };
                worse([1.0 - TENTH, 1.0 + TENTH].map(change))
            }
            OperatingEvent::Hold => self.held(),
            OperatingEvent::Alarm if self.prepared.plc().watches_inverter() => {
                self.stopped(event, Action::InverterFault(true))
            }
            OperatingEvent::Alarm => Vec::new(),
            OperatingEvent::EmergencyStop => self.stopped(event, Action::EmergencyStop),
            OperatingEvent::PowerFailure => {
                if self.prepared.plant().spindle.coasting.is_none() {
                    return Vec::new();
                }
                let mut run = run.clone();
                run.lose_power(at);
                finish(&mut run);
                self.to_standstill(event, &run)
            }
        }
    }

    /// The run with the operator's hand at some times, read from the middle on.
    fn handled(&self, event: OperatingEvent, hand: Vec<(f64, Action)>) -> Vec<EnvelopeRow> {
        let mut run = self.whole.run.clone();
        for (t, action) in hand {
            run.event(Event { t, action });
        }
        let until = self.middle + SPAN;
        let ended = plan(&mut run, until);
        let mut rows = self.read(event, &run, (self.middle, until));
        if let Some(RunEnd::Alarm(_)) = ended {
            rows.push(alarmed(event));
        }
        rows
    }

    fn stopped(&self, event: OperatingEvent, action: Action) -> Vec<EnvelopeRow> {
        let mut run = self.whole.run.clone();
        run.event(Event { t: self.middle, action });
        finish(&mut run);
        self.to_standstill(event, &run)
    }

    fn held(&self) -> Vec<EnvelopeRow> {
        let mut run = self.whole.run.clone();
        run.event(Event { t: self.middle, action: Action::Hold });
        finish(&mut run);
        let rests = run.timeline().end();
        run.event(Event { t: rests + PAUSE, action: Action::Start });
        let until = rests + PAUSE + SPAN;
        plan(&mut run, until);
        let mut rows = self.read(OperatingEvent::Hold, &run, (self.middle, until));
        rows.push(time(OperatingEvent::Hold, rests - self.middle));
        rows
    }

    fn to_standstill(&self, event: OperatingEvent, run: &Run) -> Vec<EnvelopeRow> {
        let end = run.timeline().end();
        let mut rows = self.read(event, run, (self.middle, end));
        rows.push(time(event, end - self.middle));
        rows
    }

    /// Gauges and torques in a part of a run.
    fn read(&self, event: OperatingEvent, run: &Run, span: (f64, f64)) -> Vec<EnvelopeRow> {
        let gauges = self.prepared.gauges(run, span, POINTS).into_iter().map(|gauge| EnvelopeRow {
            event,
            id: gauge.id.to_owned(),
            label: gauge.label,
            axis: None,
            value: gauge.value,
            unit: gauge.unit,
            decimals: gauge.decimals,
            limit: gauge.limit,
            field: gauge.field,
            verdict: verdict(gauge.limit, gauge.value),
            is_worst: false,
        });
        let motors = self.axes.iter().flat_map(|(axis, ampere_per_torque)| {
            let motion = axis.motion(&run.timeline().stretches(axis.mover, span.0, span.1));
            let torque = motion.work(axis.fitted.motor.rotor).peak.0;
            let limit = Some(Limit::AtMost(axis.fitted.peak()));
            let of_torque = EnvelopeRow {
                event,
                id: format!("{}-torque", axis.id),
                label: "size.torque",
                axis: Some(axis.name),
                value: torque,
                unit: "Nm",
                decimals: 3,
                limit,
                field: None,
                verdict: verdict(limit, torque),
                is_worst: false,
            };
            let of_current = ampere_per_torque.map(|per_torque| EnvelopeRow {
                id: format!("{}-current", axis.id),
                label: "size.current",
                value: torque * per_torque,
                unit: "A",
                decimals: 2,
                limit: None,
                verdict: Verdict::None,
                ..of_torque.clone()
            });
            [Some(of_torque), of_current].into_iter().flatten()
        });
        gauges.chain(motors).collect()
    }
}

/// An event at which the program stops by its alarm.
fn alarmed(event: OperatingEvent) -> EnvelopeRow {
    EnvelopeRow {
        id: "alarm".to_owned(),
        label: "size.alarm",
        value: 1.0,
        unit: "",
        decimals: 0,
        limit: Some(Limit::AtMost(0.0)),
        verdict: Verdict::Fail,
        ..time(event, 0.0)
    }
}

/// How long an event lasts.
fn time(event: OperatingEvent, seconds: f64) -> EnvelopeRow {
    EnvelopeRow {
        event,
        id: "time".to_owned(),
        label: "size.time",
        axis: None,
        value: seconds,
        unit: "s",
        decimals: 2,
        limit: None,
        field: None,
        verdict: Verdict::None,
        is_worst: false,
    }
}

fn verdict(limit: Option<Limit>, value: f64) -> Verdict {
    match limit {
        None => Verdict::None,
        Some(limit) if limit.holds(value) => Verdict::Ok,
        Some(_) => Verdict::Fail,
    }
}

/// Of two readings the worse row of each quantity; what only one of them has stays.
fn worse([one, mut other]: [Vec<EnvelopeRow>; 2]) -> Vec<EnvelopeRow> {
    let mut rows = Vec::new();
    for row in one {
        let same = other.iter().position(|theirs| theirs.id == row.id).map(|at| other.remove(at));
        rows.push(same.filter(|theirs| theirs.load() > row.load()).unwrap_or(row));
    }
    rows.extend(other);
    rows
}

//! The operating envelope: worst values at start, in the run, at the ends of the knobs, at a change of speed, at every stop.
//!
//! Each event is a run of the program with an action of the operator in the middle of its work, a stop also at the highest speed of the
//! spindle, with the knob at the form's position and near both of its ends; formulas check these runs, see `tests/it/sizing`.

mod holding_limits;
mod rows;

pub use holding_limits::HoldingLimit;
pub(super) use holding_limits::holding_limits;
pub use rows::{DriveName, EnvelopeRow, OperatingEvent, Quantity};

use rows::{at_feed, at_knob, current_row, gauged, heat_row, mark_worst, stop, time, torque_row, worst};

use super::choice::ampere_per_torque;
use super::runs::{OperatedKnob, SizingRuns, WholeRun};
use crate::drives::shaft_motion::OperatingPoint;
use crate::machines::driven::{CoastedAxes, DrivenAxis, ProductSize};
use crate::machines::{DrivenMachine, PreparedMachine};
use crate::motion::{Action, Event, Mover, RunEnd, RunSegment};
use crate::project::Project;
use crate::project::run::{Run, finish, plan};

/// Time (s) after a change in which the values are read.
const SPAN: f64 = 10.0;

/// The same (s) after the knob went up from its lowest position, and again until the values of the machine stay, at most so many times: the
/// blocks read ahead take their time at the old feed.
const LONG_SPAN: f64 = 30.0;
const LONG_SPANS: u32 = 10;

/// Relative change of a value over a long span below which it counts as settled.
const STAYS: f64 = 1e-3;

/// Time (s) from standstill to the next cycle start.
const PAUSE: f64 = 1.0;

/// Moments at which gauges are read.
const POINTS: usize = 400;

/// Step (%) by which an operator turns the knob: a tenth.
const TURN: f64 = 10.0;

/// Tried change of the product size, as a fraction of the present size.
const TENTH: f64 = 0.1;

/// The rows of all events that apply to the machine; `done` is called after each.
pub(super) fn envelope(project: &Project, runs: &SizingRuns, done: &mut dyn FnMut()) -> Vec<EnvelopeRow> {
    let prepared = &*project.prepared();
    let cutting = |machine: &dyn DrivenMachine| {
        let with_current = |axis: DrivenAxis| (axis, ampere_per_torque(project, &axis));
        machine.driven_axes().into_iter().map(with_current).collect()
    };
    let present = Cutting { machine: &**prepared, axes: cutting(&**prepared) };
    let fed = prepared.with_highest_feed().map(|(_, machine)| Cutting { machine, axes: cutting(machine) });
    let product = prepared.product_size().filter(|_| project.edited.is_none());
    let is_spindle_sized = prepared.inverter_drive().is_some();
    let envelope = Envelope { prepared, runs, present, fed, is_spindle_sized, product };
    let mut rows = Vec::new();
    for (event, _) in OperatingEvent::IDS {
        rows.extend(envelope.rows(event));
        done();
    }
    mark_worst(&mut rows);
    rows
}

/// A run that branches off in the middle of the work, with the operator's actions.
fn acted(whole: &WholeRun, actions: Vec<(f64, Action)>) -> Run {
    let mut run = whole.run.branch(whole.middle());
    for (t, action) in actions {
        run.event(Event { t, action });
    }
    run
}

/// The machine as it cuts at a position of the feed override.
struct Cutting<'a> {
    machine: &'a dyn DrivenMachine,
    /// The axes, each with the current (A) of its motor for 1 Nm, if it is known.
    axes: Vec<(DrivenAxis, Option<f64>)>,
}

struct Envelope<'a> {
    prepared: &'a PreparedMachine,
    runs: &'a SizingRuns,
    /// The machine at the form's feeds.
    present: Cutting<'a>,
    /// The machine as it cuts with the feed override at its highest position.
    fed: Option<Cutting<'a>>,
    /// Whether the demand of the main spindle's motor is known.
    is_spindle_sized: bool,
    /// The size of the product for the operator; none if the program is not macroline's own.
    product: Option<ProductSize>,
}

impl Envelope<'_> {
    /// The worst rows of an event over the positions of the knob.
    fn rows(&self, event: OperatingEvent) -> Vec<EnvelopeRow> {
        let runs = self.runs.all().filter(|whole| match event {
            OperatingEvent::SpeedChange => whole.knob.is_none(),
            _ => true,
        });
        // A run that never works has no middle of its work; a knob at 0 leaves nothing else.
        let begins = matches!(event, OperatingEvent::Start | OperatingEvent::Run);
        let runs = runs.filter(|whole| begins || self.counts(whole));
        let rows = runs.map(|whole| at_knob(self.rows_of(event, whole), whole.knob));
        let fed = self.runs.fed.iter().filter(|_| event == OperatingEvent::FeedKnob);
        worst(rows.chain(fed.map(|whole| at_knob(self.fed_rows(event, whole), whole.knob))))
    }

    /// The form's position (%) of the knob.
    fn present_position(&self) -> f64 {
        self.prepared.panel().spindle_override.unwrap_or(100.0)
    }

    /// Whether a run works, or none does.
    fn counts(&self, whole: &WholeRun) -> bool {
        whole.works_before_its_end() || !self.runs.all().any(WholeRun::works_before_its_end)
    }

    fn rows_of(&self, event: OperatingEvent, whole: &WholeRun) -> Vec<EnvelopeRow> {
        let at = whole.middle();
        match event {
            OperatingEvent::Start => {
                let mut rows = self.read(&self.present, event, &whole.run, (0.0, whole.contact));
                rows.extend(self.counts(whole).then(|| time(event, whole.contact)));
                rows.extend(hold(event, &whole.run).filter(|_| !whole.works_before_its_end()));
                rows
            }
            OperatingEvent::Run => {
                // After the end of the program axes and spindle slow down to rest.
                let spans = [(whole.contact, whole.end), (whole.end, whole.run.timeline().end())];
                let mut rows = worst(spans.map(|span| self.read(&self.present, event, &whole.run, span)));
                rows.push(time(event, whole.end - whole.contact));
                rows.extend(self.heat_of(&self.present, event, whole));
                rows.extend(alarm(event, Some(&whole.ended)));
                rows.extend(hold(event, &whole.run).filter(|_| whole.works_before_its_end()));
                rows
            }
            OperatingEvent::Knob => {
                let Some(OperatedKnob { low, high, stop }) = self.runs.knob else { return Vec::new() };
                let from = whole.knob.unwrap_or(self.present_position());
                let turn = |percent| vec![(at, Action::SpindleOverride(percent))];
                let down = stop.into_iter().chain([low]).filter(|percent| *percent < from);
                let down = down.map(|percent| self.handled(event, whole, turn(percent), SPAN));
                // From the lowest position the blocks read ahead take long.
                let up = |percent| {
                    let actions = turn(percent);
                    if from <= low {
                        self.settled(event, whole, actions)
                    } else {
                        self.handled(event, whole, actions, SPAN)
                    }
                };
                worst(down.chain((from < high).then(|| up(high))))
            }
            OperatingEvent::FeedKnob => {
                let Some((low, high)) = self.runs.feed else { return Vec::new() };
                let turn = |(percent, of): (f64, &Cutting)| {
                    let mut run = acted(whole, vec![(at, Action::FeedOverride(percent))]);
                    at_feed(self.read_on(of, event, &mut run, (at, at + SPAN)), percent)
                };
                worst(
                    [Some((low, &self.present)), self.fed.as_ref().map(|fed| (high, fed))]
                        .into_iter()
                        .flatten()
                        .map(turn),
                )
            }
            OperatingEvent::SpeedChange => {
                let Some(OperatedKnob { low, high, .. }) = self.runs.knob else { return Vec::new() };
                let now = self.present_position();
                let next = if now + TURN <= high { now + TURN } else { (now - TURN).max(low) };
                let [there, back] = [next, now].map(Action::SpindleOverride);
                self.handled(event, whole, vec![(at, there), (at + 0.5 * SPAN, back)], SPAN)
            }
            OperatingEvent::ProductChange => {
                let Some(product) = self.product else { return Vec::new() };
                // Rounded to thousandths, as typed.
                let typed = |size: f64| Action::Variable(product.variable, Some((1000.0 * size).round() / 1000.0));
                let change = |part: f64| {
                    let [other, present] = [part * product.size, product.size].map(typed);
                    self.handled(event, whole, vec![(at, other), (at + 0.5 * SPAN, present)], SPAN)
                };
                worst([1.0 - TENTH, 1.0 + TENTH].map(change))
            }
            OperatingEvent::Hold => self.held(whole),
            OperatingEvent::Alarm if self.prepared.plc().watches_inverter() => {
                let fault = |run: &mut Run, t| run.event(Event { t, action: Action::InverterFault(true) });
                self.stopped(event, whole, fault)
            }
            OperatingEvent::Alarm => Vec::new(),
            OperatingEvent::EmergencyStop => {
                self.stopped(event, whole, |run, t| run.event(Event { t, action: Action::EmergencyStop }))
            }
            OperatingEvent::PowerFailure => {
                let axes = self.prepared.without_supply().map_or_else(Vec::new, coasted);
                if self.prepared.plant().spindle.coasting.is_none() {
                    return axes;
                }
                worst([axes, self.stopped(event, whole, |run, at| run.lose_power(at))])
            }
        }
    }

    /// The rows of a run with the feed override at its highest position.
    fn fed_rows(&self, event: OperatingEvent, whole: &WholeRun) -> Vec<EnvelopeRow> {
        let Some((fed, percent)) = self.fed.as_ref().zip(whole.feed) else { return Vec::new() };
        let mut rows = self.read(fed, event, &whole.run, (0.0, whole.run.timeline().end()));
        rows.extend(self.heat_of(fed, event, whole));
        rows.extend(alarm(event, Some(&whole.ended)));
        rows.extend(hold(event, &whole.run));
        at_feed(rows, percent)
    }

    /// The run with the operator's actions at some times, read for a time (s) from the middle of the work on.
    fn handled(
        &self,
        event: OperatingEvent,
        whole: &WholeRun,
        actions: Vec<(f64, Action)>,
        span: f64,
    ) -> Vec<EnvelopeRow> {
        self.read_on(&self.present, event, &mut acted(whole, actions), (whole.middle(), whole.middle() + span))
    }

    /// The same, read until the values have settled.
    fn settled(&self, event: OperatingEvent, whole: &WholeRun, actions: Vec<(f64, Action)>) -> Vec<EnvelopeRow> {
        let (at, mut run) = (whole.middle(), acted(whole, actions));
        let mut before: Vec<EnvelopeRow> = Vec::new();
        for spans in 1..=LONG_SPANS {
            let rows = self.read_on(&self.present, event, &mut run, (at, at + LONG_SPAN * f64::from(spans)));
            let stays = |now: &EnvelopeRow| {
                let then = before.iter().find(|then| then.quantity == now.quantity);
                then.is_some_and(|then| (now.value - then.value).abs() <= STAYS * then.value.abs())
            };
            if rows.iter().filter(|row| row.quantity.axis().is_none()).all(stays) {
                return rows;
            }
            before = rows;
        }
        before
    }

    /// Plans a run to the end of a span (s), and reads it there.
    fn read_on(&self, of: &Cutting, event: OperatingEvent, run: &mut Run, (at, until): (f64, f64)) -> Vec<EnvelopeRow> {
        let ended = plan(run, until);
        let mut rows = self.read(of, event, run, (at, until));
        rows.extend(alarm(event, ended.as_ref()));
        rows.extend(hold(event, run));
        rows
    }

    /// The worst stop of a run: in the middle of the work, and at the highest speed of the spindle.
    fn stopped(&self, event: OperatingEvent, whole: &WholeRun, stop: impl Fn(&mut Run, f64)) -> Vec<EnvelopeRow> {
        worst(whole.stops().into_iter().map(|at| {
            let mut run = whole.run.branch(at);
            stop(&mut run, at);
            self.to_standstill(event, run, at)
        }))
    }

    fn held(&self, whole: &WholeRun) -> Vec<EnvelopeRow> {
        let (event, at) = (OperatingEvent::Hold, whole.middle());
        let mut run = whole.run.branch(at);
        run.event(Event { t: at, action: Action::Hold });
        finish(&mut run);
        let rests = run.timeline().end();
        run.event(Event { t: rests + PAUSE, action: Action::Start });
        let until = rests + PAUSE + SPAN;
        plan(&mut run, until);
        let mut rows = self.read(&self.present, event, &run, (at, until));
        rows.push(time(event, rests - at));
        rows.extend(hold(event, &run));
        rows
    }

    fn to_standstill(&self, event: OperatingEvent, mut run: Run, from: f64) -> Vec<EnvelopeRow> {
        finish(&mut run);
        let end = run.timeline().end();
        let mut rows = self.read(&self.present, event, &run, (from, end));
        rows.push(time(event, end - from));
        // A spindle that coasts on lays more ribbon, and takes longer.
        if coasts_on(&run, end) {
            rows.iter_mut().filter(|row| row.quantity.axis().is_none()).for_each(|row| row.is_truncated = true);
        }
        rows
    }

    /// Stretches of an axis in a part of a run in which its amplifier supplies current: at emergency stop and power failure until it is at
    /// rest, and none where the drive coasts.
    fn driven(&self, event: OperatingEvent, of: Mover, run: &Run, span: (f64, f64)) -> Vec<RunSegment> {
        let stops = matches!(event, OperatingEvent::EmergencyStop | OperatingEvent::PowerFailure);
        let coasts = stops && matches!(of, Mover::Turned(_)) && self.prepared.coasts_at_emergency_stop();
        let mut segments = if coasts { Vec::new() } else { run.timeline().run_segments(of, span.0, span.1) };
        while stops && segments.pop_if(|last| last.from == 0.0 && last.to == 0.0).is_some() {}
        segments
    }

    /// Heat of all motors of the form in a whole run.
    fn heat_of(&self, of: &Cutting, event: OperatingEvent, whole: &WholeRun) -> Vec<EnvelopeRow> {
        let axes = of.axes.iter().map(|(axis, _)| self.heat(event, axis, whole));
        axes.chain(self.spindle_heat(of, event, whole)).collect()
    }

    /// Effective torque of the form's spindle motor over a whole run and the pause after it, against its continuous curve at its site: above base
    /// speed as the torque below it that heats the motor as much.
    fn spindle_heat(&self, of: &Cutting, event: OperatingEvent, whole: &WholeRun) -> Option<EnvelopeRow> {
        let (drive, spindle) = (self.prepared.inverter_drive()?, whole.spindle(of.machine)?);
        let continuous = drive.continuous(&spindle.motor);
        let motion = spindle.motion.clone().with_pause(self.prepared.pause());
        let most = continuous.base_torque();
        let effective = motion.effective_share(spindle.rotor, &continuous) * most;
        Some(heat_row(event, DriveName { id: drive.id, name: drive.name }, effective, most))
    }

    /// Effective torque of the form's motor over a whole run and the pause after it: it heats the motor.
    fn heat(&self, event: OperatingEvent, axis: &DrivenAxis, whole: &WholeRun) -> EnvelopeRow {
        let rotor = axis.fitted.motor.rotor;
        let effective = whole.motion(axis).with_pause(self.prepared.pause()).motor_load(rotor).effective;
        heat_row(event, DriveName::of(axis), effective, axis.fitted.stall_limit())
    }

    /// Gauges, and torques of the motors that are supplied with current, in a part of a run.
    fn read(&self, of: &Cutting, event: OperatingEvent, run: &Run, span: (f64, f64)) -> Vec<EnvelopeRow> {
        let works = self.prepared.working(run, span.1);
        let gauges = self.prepared.gauges(run, span, POINTS).into_iter().map(|gauge| gauged(event, &gauge));
        let motors = of.axes.iter().flat_map(|(axis, ampere_per_torque)| {
            let segments = self.driven(event, axis.mover, run, span);
            if segments.is_empty() {
                return [None, None].into_iter().flatten();
            }
            // The limit falls with the speed, so that the greatest torque may not be the hardest.
            let OperatingPoint { torque, speed, .. } = worst_point(axis, &segments, works.as_deref());
            let of_torque = torque_row(event, DriveName::of(axis), torque, axis.fitted.short_time_limit(speed));
            let of_current =
                ampere_per_torque.map(|per_torque| current_row(event, DriveName::of(axis), torque * per_torque));
            [Some(of_torque), of_current].into_iter().flatten()
        });
        let segments = run.timeline().run_segments_of_driven_spindle(span.0, span.1);
        let is_driven = self.is_spindle_sized && !segments.is_empty();
        let spindle = if is_driven { of.machine.spindle_run(run, &segments) } else { None };
        let spindle = spindle.map(|spindle| {
            let OperatingPoint { torque, speed, share } = spindle.worst_point(&spindle.motor, spindle.rotor);
            let most =
                if share > 0.0 { torque / share } else { spindle.short_time.driving * spindle.motor.torque(speed) };
            torque_row(event, DriveName { id: "spindle", name: spindle.name }, torque, most)
        });
        gauges.chain(motors).chain(spindle).collect()
    }
}

/// The operating point that uses most of the limit of the axis's motor, of two motions: with the torque of its work
/// within these spans (s), and with none, because work helps to brake.
fn worst_point(axis: &DrivenAxis, segments: &[RunSegment], works: Option<&[(f64, f64)]>) -> OperatingPoint {
    let under = |works| axis.motion(segments, works).worst_point(&axis.fitted.motor);
    let working = under(works);
    let idle = works.map(|_| under(Some(&[])));
    idle.filter(|idle| idle.share > working.share).unwrap_or(working)
}

/// The rows of axes that coast to rest at a power failure.
fn coasted(rest: CoastedAxes) -> Vec<EnvelopeRow> {
    let event = OperatingEvent::PowerFailure;
    vec![gauged(event, &rest.gauge), time(event, rest.seconds)]
}

/// Whether the spindle has not come to rest at the end (s) at which a plan was cut.
fn coasts_on(run: &Run, end: f64) -> bool {
    let speed = |t: f64| run.timeline().at(t).spindle.actual.abs();
    speed(end + SPAN) < speed(end)
}

/// The row of an event at which the program stops with its own alarm.
fn alarm(event: OperatingEvent, ended: Option<&RunEnd>) -> Option<EnvelopeRow> {
    matches!(ended, Some(RunEnd::Alarm(_))).then(|| stop(event, Quantity::Alarm))
}

/// The row of an event at which a contact of the machine holds the program: other values of the event are those until then.
fn hold(event: OperatingEvent, run: &Run) -> Option<EnvelopeRow> {
    run.is_held_by_plc().then(|| stop(event, Quantity::Hold))
}

//! Rows of the operating envelope: an event, a quantity, its worst value, its limit and its verdict.

use crate::machines::driven::{DrivenAxis, Gauge};
use crate::machines::sheets::say;
use crate::msg;
use crate::text::catalog::sentence;
use crate::view::{Limit, Verdict};

/// An event of operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OperatingEvent {
    /// From cycle start to the first contact with the work.
    Start,
    /// From the first contact to the end of the program, and to standstill after it.
    Run,
    /// The knob goes to either end, and from its lowest position back to that of the form.
    Knob,
    /// The feed override goes to either end, and is at its highest position from the start on.
    FeedKnob,
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
    /// The supply fails: the servo axes of the slides brake, the spindle or the axes of work and tool coast.
    PowerFailure,
}

impl OperatingEvent {
    /// All events with their ids in JSON, in the order of operation.
    pub const IDS: [(OperatingEvent, &'static str); 10] = [
        (OperatingEvent::Start, "start"),
        (OperatingEvent::Run, "run"),
        (OperatingEvent::Knob, "knob"),
        (OperatingEvent::FeedKnob, "feed-knob"),
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
            OperatingEvent::FeedKnob => "size.event.feed-knob",
            OperatingEvent::SpeedChange => "size.event.speed-change",
            OperatingEvent::ProductChange => "size.event.product-change",
            OperatingEvent::Hold => "size.event.hold",
            OperatingEvent::Alarm => "size.event.alarm",
            OperatingEvent::EmergencyStop => "size.event.emergency-stop",
            OperatingEvent::PowerFailure => "size.event.power-failure",
        }
    }
}

/// A motor of the machine: the id of its drive, and the catalog id of its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DriveName {
    /// Id, for instance `x`.
    pub id: &'static str,
    /// Catalog id of its name.
    pub name: &'static str,
}

impl DriveName {
    pub(super) fn of(axis: &DrivenAxis) -> DriveName {
        DriveName { id: axis.id, name: axis.name }
    }
}

/// A quantity of operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// A quantity that the machine has checked, by its id and the catalog id of its name.
    Gauge(&'static str, &'static str),
    /// Greatest torque of a motor.
    Torque(DriveName),
    /// Current of a motor at that torque.
    Current(DriveName),
    /// Effective torque of a motor over a whole run, which heats it.
    EffectiveTorque(DriveName),
    /// Duration of the event.
    Time,
    /// The program stops with its own alarm.
    Alarm,
    /// A contact of the machine holds the program.
    Hold,
}

impl Quantity {
    /// Its id, for instance `loop` or `x-torque`.
    pub fn id(self) -> String {
        match self {
            Quantity::Gauge(id, _) => id.to_owned(),
            Quantity::Torque(drive) => format!("{}-torque", drive.id),
            Quantity::Current(drive) => format!("{}-current", drive.id),
            Quantity::EffectiveTorque(drive) => format!("{}-effective-torque", drive.id),
            Quantity::Time => "time".to_owned(),
            Quantity::Alarm => "alarm".to_owned(),
            Quantity::Hold => "hold".to_owned(),
        }
    }

    /// Catalog id of its name.
    pub fn label(self) -> &'static str {
        match self {
            Quantity::Gauge(_, label) => label,
            Quantity::Torque(_) => "size.torque",
            Quantity::Current(_) => "size.current",
            Quantity::EffectiveTorque(_) => "size.effective",
            Quantity::Time => "size.time",
            Quantity::Alarm => "size.alarm",
            Quantity::Hold => "size.hold",
        }
    }

    /// Catalog id of its axis; none for a quantity of the machine.
    pub fn axis(self) -> Option<&'static str> {
        match self {
            Quantity::Torque(drive) | Quantity::Current(drive) | Quantity::EffectiveTorque(drive) => Some(drive.name),
            Quantity::Gauge(..) | Quantity::Time | Quantity::Alarm | Quantity::Hold => None,
        }
    }

    /// Its name in words, with the axis.
    pub(in crate::project::size) fn name(self) -> String {
        self.axis().map_or_else(|| say(self.label()), |axis| format!("{}, {}", say(self.label()), say(axis)))
    }
}

/// The worst value of a quantity at an event.
#[derive(Debug, Clone, PartialEq)]
pub struct EnvelopeRow {
    /// The event.
    pub event: OperatingEvent,
    /// The quantity.
    pub quantity: Quantity,
    /// Its worst value.
    pub value: f64,
    /// Unit.
    pub unit: &'static str,
    /// Decimals shown.
    pub decimals: u8,
    /// Its limit, in `unit`.
    pub limit: Option<Limit>,
    /// Field of the form with the limit, if there is one.
    pub field: Option<&'static str>,
    /// Verdict of the value against its limit.
    pub verdict: Verdict,
    /// Position (%) of the knob with this value, if it is not that of the form.
    pub knob: Option<f64>,
    /// Position (%) of the feed override with this value, if it is not at 100 %.
    pub feed: Option<f64>,
    /// Whether the run was cut while the spindle coasted on: the true value is greater than `value`.
    pub is_truncated: bool,
    /// Whether it is the worst of this quantity over all events.
    pub is_worst: bool,
}

impl EnvelopeRow {
    /// A row with its verdict; `unit` with the decimals shown.
    fn new(
        event: OperatingEvent,
        quantity: Quantity,
        value: f64,
        (unit, decimals): (&'static str, u8),
        limit: Option<Limit>,
    ) -> EnvelopeRow {
        EnvelopeRow {
            event,
            quantity,
            value,
            unit,
            decimals,
            limit,
            field: None,
            verdict: verdict(limit, value),
            knob: None,
            feed: None,
            is_truncated: false,
            is_worst: false,
        }
    }

    /// Its event in words, with the position of the feed override.
    pub(in crate::project::size) fn event_name(&self) -> String {
        self.feed.map_or_else(|| say(self.event.name()), |percent| sentence(&msg!("size.event-at-feed", percent)))
    }

    /// Whether the row reports that a contact of the machine holds the program at the event.
    pub(in crate::project::size) fn is_hold(&self) -> bool {
        self.quantity == Quantity::Hold
    }

    /// Whether the row is the heat of a motor in a whole run.
    pub(in crate::project::size) fn is_heat(&self) -> bool {
        matches!(self.quantity, Quantity::EffectiveTorque(_))
    }

    /// Share of its limit that its value uses.
    fn load(&self) -> f64 {
        match self.limit {
            // The limit of a torque falls with the speed.
            Some(Limit::AtMost(most)) if most > 0.0 => self.value / most,
            limit => Limit::load(limit, self.value),
        }
    }
}

/// The heat of a motor: its effective torque and the greatest one, Nm.
pub(super) fn heat_row(event: OperatingEvent, drive: DriveName, effective: f64, most: f64) -> EnvelopeRow {
    let limit = Some(Limit::AtMost(most));
    EnvelopeRow::new(event, Quantity::EffectiveTorque(drive), effective, ("Nm", 3), limit)
}

/// The greatest torque (Nm) of a motor against a limit.
pub(super) fn torque_row(event: OperatingEvent, drive: DriveName, torque: f64, most: f64) -> EnvelopeRow {
    EnvelopeRow::new(event, Quantity::Torque(drive), torque, ("Nm", 3), Some(Limit::AtMost(most)))
}

/// The current (A) of a motor at its greatest torque.
pub(super) fn current_row(event: OperatingEvent, drive: DriveName, current: f64) -> EnvelopeRow {
    EnvelopeRow::new(event, Quantity::Current(drive), current, ("A", 2), None)
}

/// The row of a quantity that is checked during operation.
pub(super) fn gauged(event: OperatingEvent, gauge: &Gauge) -> EnvelopeRow {
    let quantity = Quantity::Gauge(gauge.id, gauge.label);
    let row = EnvelopeRow::new(event, quantity, gauge.value, (gauge.unit, gauge.decimals), gauge.limit);
    EnvelopeRow { field: gauge.field, ..row }
}

/// The row of an event at which the program stops.
pub(super) fn stop(event: OperatingEvent, quantity: Quantity) -> EnvelopeRow {
    EnvelopeRow::new(event, quantity, 1.0, ("", 0), Some(Limit::AtMost(0.0)))
}

/// Row with the duration (s) of an event.
pub(super) fn time(event: OperatingEvent, seconds: f64) -> EnvelopeRow {
    EnvelopeRow::new(event, Quantity::Time, seconds, ("s", 2), None)
}

/// The rows with a position (%) of the knob; none for that of the form.
pub(super) fn at_knob(mut rows: Vec<EnvelopeRow>, percent: Option<f64>) -> Vec<EnvelopeRow> {
    rows.iter_mut().for_each(|row| row.knob = percent);
    rows
}

/// The rows with a position (%) of the feed override.
pub(super) fn at_feed(mut rows: Vec<EnvelopeRow>, percent: f64) -> Vec<EnvelopeRow> {
    rows.iter_mut().for_each(|row| row.feed = Some(percent));
    rows
}

/// Marks the worst row of each quantity: nearest to its limit or farthest beyond, the first of equal ones.
pub(super) fn mark_worst(rows: &mut [EnvelopeRow]) {
    for at in 0..rows.len() {
        let others = rows.iter().enumerate().filter(|(_, other)| other.quantity == rows[at].quantity);
        let worst = others.reduce(|worst, next| if next.1.load() > worst.1.load() { next } else { worst });
        rows[at].is_worst = worst.is_some_and(|(worst, _)| worst == at);
    }
}

/// The worst row of each quantity over several readings; a quantity of one reading alone stays.
pub(super) fn worst(readings: impl IntoIterator<Item = Vec<EnvelopeRow>>) -> Vec<EnvelopeRow> {
    let mut rows: Vec<EnvelopeRow> = Vec::new();
    for next in readings.into_iter().flatten() {
        match rows.iter_mut().find(|row| row.quantity == next.quantity) {
            Some(row) if next.load() > row.load() => *row = next,
            Some(_) => {}
            None => rows.push(next),
        }
    }
    rows
}

fn verdict(limit: Option<Limit>, value: f64) -> Verdict {
    match limit {
        None => Verdict::None,
        Some(limit) if limit.holds(value) => Verdict::Ok,
        Some(_) => Verdict::Fail,
    }
}

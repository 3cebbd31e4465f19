//! Operator panel events over time. A run is a pure function of the project and these events.

use crate::drives::speed::SpeedLimit;

/// Action of the operator.
#[derive(Debug, Clone, PartialEq)]
pub enum Action {
    /// Spindle override in percent.
    SpindleOverride(f64),
    /// Cutting feed override in percent.
    FeedOverride(f64),
    /// Rapid override in percent.
    RapidOverride(f64),
    /// Cycle start.
    Start,
    /// Feed hold.
    Hold,
    /// Reset.
    Reset,
    /// Emergency stop.
    EmergencyStop,
    /// The fault relay of the spindle's inverter: on at a fault, off once it is cleared at the inverter.
    InverterFault(bool),
    /// Program zero return: the axes go to the program's reference point, on controls that have that mode.
    ProgramZeroReturn,
    /// Single block on or off.
    SingleBlock(bool),
    /// Optional stop on or off.
    OptionalStop(bool),
    /// Optional block skip on or off.
    BlockSkip(bool),
    /// S given by hand in r/min; 0 stops the spindle.
    ManualSpeed(f64),
    /// A limit of the spindle speed set in r/min, as in the setting data.
    SpeedLimit(SpeedLimit, f64),
    /// A macro input is forced: the variable (`#1033`), or its lower or upper half (`#1033.low`, `#1033.high`).
    Input(String, f64),
    /// A variable set on the control's screen, by number.
    Variable(u32, Option<f64>),
}

/// An action at a time.
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    /// Machine time (s).
    pub t: f64,
    /// The action.
    pub action: Action,
}

impl Event {
    /// The event with its time limited to 0 and the largest number.
    fn in_range(self) -> Event {
        Event { t: if self.t > 0.0 { self.t.min(f64::MAX) } else { 0.0 }, ..self }
    }
}

/// Events in the order of time; equal times keep the order in which they were given.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Panel {
    events: Vec<Event>,
}

impl Panel {
    /// Sorts the events by time; times that are negative or no number become 0, infinite ones the largest number.
    pub fn new(events: impl IntoIterator<Item = Event>) -> Panel {
        let mut events: Vec<Event> = events.into_iter().map(Event::in_range).collect();
        events.sort_by(|a, b| a.t.total_cmp(&b.t));
        Panel { events }
    }

    /// Adds an event behind all that are not later.
    pub fn add(&mut self, event: Event) {
        let event = event.in_range();
        let at = self.events.partition_point(|other| other.t <= event.t);
        self.events.insert(at, event);
    }

    /// All events.
    pub fn events(&self) -> &[Event] {
        &self.events
    }
}

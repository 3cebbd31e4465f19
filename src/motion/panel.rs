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

/// Value of an action.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ActionValue {
    /// A number in the unit of the action.
    Number(f64),
    /// On or off.
    State(bool),
    /// A variable without a value.
    Vacant,
}

impl Action {
    /// The value; `None` for a button.
    pub fn value(&self) -> Option<ActionValue> {
        match self {
            Action::SpindleOverride(number)
            | Action::FeedOverride(number)
            | Action::RapidOverride(number)
            | Action::ManualSpeed(number)
            | Action::SpeedLimit(_, number)
            | Action::Input(_, number)
            | Action::Variable(_, Some(number)) => Some(ActionValue::Number(*number)),
            Action::Variable(_, None) => Some(ActionValue::Vacant),
            Action::InverterFault(on) | Action::SingleBlock(on) | Action::OptionalStop(on) | Action::BlockSkip(on) => {
                Some(ActionValue::State(*on))
            }
            Action::Start | Action::Hold | Action::Reset | Action::EmergencyStop | Action::ProgramZeroReturn => None,
        }
    }

    /// The action with another value; `None` where its kind has no such value.
    pub fn with_value(&self, value: ActionValue) -> Option<Action> {
        Some(match (self, value) {
            (Action::SpindleOverride(_), ActionValue::Number(percent)) => Action::SpindleOverride(percent),
            (Action::FeedOverride(_), ActionValue::Number(percent)) => Action::FeedOverride(percent),
            (Action::RapidOverride(_), ActionValue::Number(percent)) => Action::RapidOverride(percent),
            (Action::ManualSpeed(_), ActionValue::Number(rpm)) => Action::ManualSpeed(rpm),
            (Action::SpeedLimit(limit, _), ActionValue::Number(rpm)) => Action::SpeedLimit(*limit, rpm),
            (Action::Input(name, _), ActionValue::Number(number)) => Action::Input(name.clone(), number),
            (Action::Variable(id, _), ActionValue::Number(number)) => Action::Variable(*id, Some(number)),
            (Action::Variable(id, _), ActionValue::Vacant) => Action::Variable(*id, None),
            (Action::InverterFault(_), ActionValue::State(on)) => Action::InverterFault(on),
            (Action::SingleBlock(_), ActionValue::State(on)) => Action::SingleBlock(on),
            (Action::OptionalStop(_), ActionValue::State(on)) => Action::OptionalStop(on),
            (Action::BlockSkip(_), ActionValue::State(on)) => Action::BlockSkip(on),
            _ => return None,
        })
    }

    /// Least and greatest number of the action on any control: % of an override, r/min of a limit.
    pub fn range(&self) -> (f64, f64) {
        match self {
            Action::SpindleOverride(_) | Action::FeedOverride(_) | Action::RapidOverride(_) => (0.0, 1000.0),
            Action::SpeedLimit(..) => (0.0, f64::MAX),
            _ => (f64::MIN, f64::MAX),
        }
    }

    /// Whether its number is within its [range](Action::range).
    pub fn is_in_range(&self) -> bool {
        let (least, most) = self.range();
        !matches!(self.value(), Some(ActionValue::Number(number)) if !(least..=most).contains(&number))
    }
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

    /// Adds an event behind all that are not later; its place.
    pub fn add(&mut self, event: Event) -> usize {
        let event = event.in_range();
        let at = self.events.partition_point(|other| other.t <= event.t);
        self.events.insert(at, event);
        at
    }

    /// Removes the event at a place.
    pub fn remove(&mut self, at: usize) -> Option<Event> {
        (at < self.events.len()).then(|| self.events.remove(at))
    }

    /// Replaces the event at a place; its new place. It stays where it was among events of its time, and goes behind those of another time.
    pub fn replace(&mut self, at: usize, event: Event) -> Option<usize> {
        let event = event.in_range();
        let present = self.events.get_mut(at)?;
        if present.t == event.t {
            *present = event;
            return Some(at);
        }
        self.events.remove(at);
        Some(self.add(event))
    }

    /// Time (s) of the earliest event that only one of two panels has, or has elsewhere in its order; `None` where they are equal.
    pub fn differs_from(&self, other: &Panel) -> Option<f64> {
        let same = self.events.iter().zip(&other.events).take_while(|(one, two)| one == two).count();
        let times = [&self.events, &other.events].map(|events| events.get(same).map(|event| event.t));
        times.into_iter().flatten().reduce(f64::min)
    }

    /// All events.
    pub fn events(&self) -> &[Event] {
        &self.events
    }
}

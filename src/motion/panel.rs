//! Operator panel events over time. A run is a pure function of the project and these events.

use super::input_name::InputName;
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
    /// Fault relay of the spindle inverter: on at a fault, off after the fault is cleared at the inverter.
    InverterFault(bool),
    /// Program zero return: the axes go to the program's reference point, on controls with that mode.
    ProgramZeroReturn,
    /// Single block on or off.
    SingleBlock(bool),
    /// Optional stop on or off.
    OptionalStop(bool),
    /// Optional block skip on or off.
    BlockSkip(bool),
    /// Manual S in r/min; 0 stops the spindle.
    ManualSpeed(f64),
    /// Spindle speed limit in r/min, as in the setting data.
    SpeedLimit(SpeedLimit, f64),
    /// Forced macro input.
    Input(InputName, f64),
    /// Variable set on the control's screen, by number; `None` makes it vacant.
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
    /// Whether it turns a knob.
    pub fn is_knob(&self) -> bool {
        matches!(self, Action::SpindleOverride(_) | Action::FeedOverride(_) | Action::RapidOverride(_))
    }

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

    /// The action with another value; `None` if the value does not suit the action.
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

/// Panel events by time; events of equal time keep their order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Panel {
    events: Vec<Event>,
}

impl Panel {
    /// Sorts the events by time. Negative times and NaN become 0, infinite ones the largest number.
    pub fn new(events: impl IntoIterator<Item = Event>) -> Panel {
        let mut events: Vec<Event> = events.into_iter().map(Event::in_range).collect();
        events.sort_by(|a, b| a.t.total_cmp(&b.t));
        Panel { events }
    }

    /// Adds an event after all events that are not later, and returns its index.
    pub fn add(&mut self, event: Event) -> usize {
        let event = event.in_range();
        let at = self.events.partition_point(|other| other.t <= event.t);
        self.events.insert(at, event);
        at
    }

    /// Adds an event of the operator at the panel, and returns its index. A further turn of the same knob at the same time replaces the
    /// earlier one.
    pub fn act(&mut self, event: Event) -> usize {
        let event = event.in_range();
        let same = |other: &Event| {
            other.t == event.t
                && event.action.is_knob()
                && core::mem::discriminant(&other.action) == core::mem::discriminant(&event.action)
        };
        match self.events.iter().rposition(same) {
            Some(at) => self.replace(at, event).unwrap_or(at),
            None => self.add(event),
        }
    }

    /// Removes the event at an index.
    pub fn remove(&mut self, at: usize) -> Option<Event> {
        (at < self.events.len()).then(|| self.events.remove(at))
    }

    /// Replaces the event at an index and returns its new index. At an unchanged time the index stays; at a new time the event comes last.
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

    /// Time (s) of the first event that differs between two panels; `None` if they are equal.
    pub fn differs_from(&self, other: &Panel) -> Option<f64> {
        let same = self.events.iter().zip(&other.events).take_while(|(one, two)| one == two).count();
        let times = [&self.events, &other.events].map(|events| events.get(same).map(|event| event.t));
        times.into_iter().flatten().reduce(f64::min)
    }

    /// The last value that actions up to a time (s) have set; `value`: the value that an action sets, if any.
    pub fn last<T>(&self, t: f64, value: impl Fn(&Action) -> Option<T>) -> Option<T> {
        self.events.iter().rev().filter(|event| event.t <= t).find_map(|event| value(&event.action))
    }

    /// All events.
    pub fn events(&self) -> &[Event] {
        &self.events
    }
}

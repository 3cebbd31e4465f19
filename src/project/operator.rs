//! The operator's actions as a list to edit: actions of a machine on its control, their names and values, and changes in words.

use super::Project;
use crate::controls::vars::HALF_RANGE;
use crate::controls::{Code, Control, VarKind};
use crate::drives::speed::SpeedLimit;
use crate::math;
use crate::motion::{Action, ActionValue, Event, InputName, Panel, WordPart};
use crate::msg;
use crate::text::Message;
use crate::text::catalog::{number_text, sentence, words};
use crate::text::number;

/// Decimals of a time (s) and of a value in a text.
const DECIMALS: u8 = 6;

/// Speed limit (r/min) that a new action sets until another one is typed.
const FIRST_LIMIT: f64 = 1000.0;

/// Percent of an override that no knob and no form has changed.
const UNCHANGED: f64 = 100.0;

impl Project {
    /// The spindle override (%) at a time (s): the operator's, or that of the form.
    pub fn spindle_override_at(&self, t: f64) -> f64 {
        let turned = self.panel.last(t, |action| match action {
            Action::SpindleOverride(percent) => Some(*percent),
            _ => None,
        });
        turned.or(self.prepared().panel().spindle_override).unwrap_or(UNCHANGED)
    }

    /// The feed override (%) at a time (s).
    pub fn feed_override_at(&self, t: f64) -> f64 {
        let turned = self.panel.last(t, |action| match action {
            Action::FeedOverride(percent) => Some(*percent),
            _ => None,
        });
        turned.unwrap_or(UNCHANGED)
    }
}

/// Actions of one kind.
#[derive(Debug, Clone, PartialEq)]
pub struct ActionGroup {
    /// Catalog id of its name.
    pub name: &'static str,
    /// The actions, each with the value that a new one has.
    pub actions: Vec<Action>,
}

/// Actions that the machine has on its control, without empty groups.
pub fn available(project: &Project) -> Vec<ActionGroup> {
    let (control, machine) = (project.control, project.prepared());
    let overrides =
        [Action::SpindleOverride, Action::FeedOverride, Action::RapidOverride].map(|turned| turned(UNCHANGED));
    let keys = [
        Some(Action::Start),
        Some(Action::Hold),
        Some(Action::Reset),
        Some(Action::EmergencyStop),
        machine.plc().watches_inverter().then_some(Action::InverterFault(true)),
        control.zero_return.is_some().then_some(Action::ProgramZeroReturn),
    ];
    let switches = [Action::SingleBlock, Action::OptionalStop, Action::BlockSkip].map(|turned| turned(true));
    let limits = [
        (Code::LowerLimits, SpeedLimit::Lower),
        (Code::UpperLimits, SpeedLimit::Upper),
        (Code::SurfaceSpeed, SpeedLimit::Surface),
    ];
    let limits = limits.into_iter().filter(|(code, _)| control.can(*code));
    let speeds = [Action::ManualSpeed(0.0)].into_iter().chain(limits.map(|row| Action::SpeedLimit(row.1, FIRST_LIMIT)));
    let inputs = control.vars.iter().filter(|row| row.input_range(row.first).is_some());
    let input = |number: u32| Action::Input(InputName::Variable(number, WordPart::Whole), 0.0);
    let is_set = |number: &u32| {
        let kind = control.var(*number).map(|row| row.kind);
        matches!(kind, Some(VarKind::Local | VarKind::Common | VarKind::Retained))
    };
    let variables = machine.variables().into_iter().map(|row| row.number).filter(is_set);
    let variables = variables.map(|number| Action::Variable(number, Some(0.0)));
    let groups = [
        ("operator.overrides", overrides.to_vec()),
        ("operator.keys", keys.into_iter().flatten().collect()),
        ("operator.switches", switches.to_vec()),
        ("operator.speeds", speeds.collect()),
        ("page.variables", variables.collect()),
        ("operator.inputs", inputs.flat_map(|row| row.first..=row.last).map(input).collect()),
    ];
    let groups = groups.into_iter().map(|(name, actions): (_, Vec<Action>)| ActionGroup { name, actions });
    groups.filter(|group| !group.actions.is_empty()).collect()
}

/// The action without its value: `Spindle override`, `#107`.
pub fn kind_name(action: &Action, control: &Control) -> String {
    let id = match action {
        Action::SpindleOverride(_) => "page.spindle-override",
        Action::FeedOverride(_) => "page.feed-override",
        Action::RapidOverride(_) => "page.rapid-override",
        Action::Start => "page.start",
        Action::Hold => "page.hold",
        Action::Reset => "page.reset",
        Action::EmergencyStop => "page.estop",
        Action::InverterFault(_) => "page.inverter-fault",
        Action::ProgramZeroReturn => "page.zero-return",
        Action::SingleBlock(_) => "page.single-block",
        Action::OptionalStop(_) => "page.optional-stop",
        Action::BlockSkip(_) => "page.block-skip",
        Action::ManualSpeed(_) => return "S".to_owned(),
        Action::SpeedLimit(SpeedLimit::Lower, _) => "page.lower-speed-limit",
        Action::SpeedLimit(SpeedLimit::Upper, _) => "page.upper-speed-limit",
        Action::SpeedLimit(SpeedLimit::Surface, _) => "page.surface-speed-limit",
        Action::Input(name, _) => return name.to_string(),
        Action::Variable(number, _) => return control.variable(*number),
    };
    words(id).to_owned()
}

/// The value with its unit: `80 %`, `on`; `None` for a button.
pub fn value_name(action: &Action, control: &Control) -> Option<String> {
    let text = match action.value()? {
        ActionValue::State(on) => words(if on { "page.on" } else { "page.off" }).to_owned(),
        ActionValue::Vacant if control.has_vacant() => words("page.vacant").to_owned(),
        ActionValue::Vacant => number_text(0.0, DECIMALS),
        ActionValue::Number(value) => number_text(value, DECIMALS),
    };
    let unit = unit(action);
    Some(if unit == "%" { format!("{text} {unit}") } else { text })
}

/// The action with its value: `Spindle override 80 %`, `#107 = 9.5`.
pub fn name(action: &Action, control: &Control) -> String {
    let kind = kind_name(action, control);
    let between = if matches!(action, Action::Input(..) | Action::Variable(..)) { " = " } else { " " };
    match value_name(action, control) {
        Some(value) => kind + between + &value,
        None => kind,
    }
}

/// Unit of the value.
pub fn unit(action: &Action) -> &'static str {
    match action {
        Action::SpindleOverride(_) | Action::FeedOverride(_) | Action::RapidOverride(_) => "%",
        Action::ManualSpeed(_) | Action::SpeedLimit(..) => "r/min",
        _ => "",
    }
}

/// The number of an action as text for its field; empty for a vacant variable, and for an action without a number.
pub fn typed_value(action: &Action) -> String {
    match action.value() {
        Some(ActionValue::Number(number)) => number_text(number, DECIMALS),
        _ => String::new(),
    }
}

/// Least and greatest number of an action on a control.
fn range(action: &Action, control: &Control) -> (f64, f64) {
    let Action::Input(name, _) = action else { return action.range() };
    let whole = match *name {
        InputName::Variable(number, WordPart::Whole) => control.var(number).and_then(|row| row.input_range(number)),
        _ => None,
    };
    whole.unwrap_or(HALF_RANGE)
}

/// The action with a typed number; an empty text makes a variable vacant, or 0 where the control has no vacant ones.
/// `Err` holds the allowed values.
pub fn read_value(action: &Action, text: &str, control: &Control) -> Result<Action, Message> {
    let text = text.replace(['\u{202f}', ' '], "");
    let variable = matches!(action, Action::Variable(..));
    let value = match number::read(&text) {
        Some(number) => Some(ActionValue::Number(number)),
        None if variable && text.is_empty() && control.has_vacant() => Some(ActionValue::Vacant),
        None if variable && text.is_empty() => Some(ActionValue::Number(0.0)),
        None => None,
    };
    let (least, most) = range(action, control);
    let fits = |value: &ActionValue| match value {
        ActionValue::Number(number) => (least..=most).contains(number),
        _ => true,
    };
    value.filter(fits).and_then(|value| action.with_value(value)).ok_or_else(|| {
        let kind = kind_name(action, control);
        let limit = |number: f64| format!("{} {}", number_text(number, DECIMALS), unit(action)).trim_end().to_owned();
        match (least == f64::MIN, most == f64::MAX) {
            _ if variable => msg!("page.not-a-value"),
            (false, false) => {
                msg!("operator.value-between", kind, least = number_text(least, DECIMALS), most = limit(most))
            }
            (false, true) => msg!("operator.value-from", kind, least = limit(least)),
            _ => msg!("operator.value-number", kind),
        }
    })
}

/// A time (s) as text for its field.
pub fn typed_time(t: f64) -> String {
    number_text(t, DECIMALS)
}

/// A typed time (s).
pub fn read_time(text: &str) -> Result<f64, Message> {
    number::read(text).filter(|t| *t >= 0.0).ok_or_else(|| msg!("operator.time-from-0"))
}

/// Step (s) of times on an axis: the greatest power of ten that is not above `least` (s), from 1 µs.
pub fn time_step(least: f64) -> f64 {
    math::pow(10.0, (math::log10(math::clamp(least, 1e-6, 1e6)) + 1e-9).floor())
}

/// The nearest whole count of steps (s), at least 0.
pub fn in_steps(t: f64, step: f64) -> f64 {
    let per_second = (1.0 / step).round();
    let t = if step < 1.0 { (t * per_second).round() / per_second } else { (t / step).round() * step };
    math::clamp(t, 0.0, f64::MAX)
}

/// An added, removed, moved or changed action in words; `None` if more than one action has changed.
pub(super) fn change_in_words(before: &Panel, after: &Panel, control: &Control) -> Option<String> {
    let (before, after) = (before.events(), after.events());
    let begin = before.iter().zip(after).take_while(|(one, other)| one == other).count();
    let (before, after) = (before.get(begin..)?, after.get(begin..)?);
    let end = before.iter().rev().zip(after.iter().rev()).take_while(|(one, other)| one == other).count();
    let (before, after) = (before.get(..before.len() - end)?, after.get(..after.len() - end)?);
    let named = |event: &Event| (typed_time(event.t), name(&event.action, control));
    let (from, to) = match (before, after) {
        ([], [added]) => {
            let (time, action) = named(added);
            return Some(sentence(&msg!("operator.added", time, action)));
        }
        ([removed], []) => {
            let (time, action) = named(removed);
            return Some(sentence(&msg!("operator.removed", time, action)));
        }
        ([from, passed @ ..], [others @ .., to]) if passed == others => (from, to),
        ([others @ .., from], [to, passed @ ..]) if passed == others => (from, to),
        _ => return None,
    };
    let ((was, name), (is, _)) = (named(from), named(to));
    if from.action == to.action {
        return Some(sentence(&msg!("operator.moved", action = name, before = was, after = is)));
    }
    let (kind, other) = (kind_name(&from.action, control), kind_name(&to.action, control));
    let (old, new) = (value_name(&from.action, control)?, value_name(&to.action, control)?);
    (from.t == to.t && kind == other)
        .then(|| sentence(&msg!("operator.changed", time = was, kind, before = old, after = new)))
}

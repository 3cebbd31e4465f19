//! Entries of a panel file: `{ "t": 2.5, "spindle_override": 80 }`.

use std::iter::once;

use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, MapDeserializer};
use serde_json::Value;
use serde_json::value::RawValue;

use crate::drives::speed::SpeedLimit;
use crate::motion::{Action, Event, Panel};
use crate::msg;
use crate::project::files::json::{JsonMember, JsonMembers, number};
use crate::project::findings::project_file::Findings;
use crate::text::escape::clip;

/// Events of a panel at most.
const MAX_EVENTS: usize = 100_000;

/// An action by its key. A button that is `false` is not pressed.
#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum PanelAction<'t> {
    SpindleOverride(f64),
    FeedOverride(f64),
    RapidOverride(f64),
    Start(bool),
    Hold(bool),
    Reset(bool),
    Estop(bool),
    InverterFault(bool),
    ProgramZero(bool),
    SingleBlock(bool),
    OptionalStop(bool),
    BlockSkip(bool),
    /// Speed in r/min.
    ManualS(f64),
    /// Limits in r/min.
    LowerSpeedLimit(f64),
    UpperSpeedLimit(f64),
    SurfaceSpeedLimit(f64),
    /// Values by input.
    #[serde(borrow)]
    Input(JsonMembers<'t>),
    /// Values by variable, `#107`; `null` is vacant.
    #[serde(borrow)]
    Variable(JsonMembers<'t>),
}

/// Reads the entries of a panel.
pub(super) fn read<'t>(entries: &[JsonMembers<'t>], found: &mut Findings<'t>) -> Panel {
    if entries.len() > MAX_EVENTS {
        found.error(msg!("project.panel-too-long", most = MAX_EVENTS as u32, count = entries.len() as u32), "");
        return Panel::default();
    }
    let mut events = Vec::new();
    for (entry, count) in entries.iter().zip(1_u32..) {
        let time = entry.0.iter().find(|entry| entry.key == "t").and_then(|entry| entry.value.value.as_f64());
        let Some(t) = time.filter(|t| *t >= 0.0) else {
            found
                .error(msg!("project.panel-no-time", number = count), entry.0.first().map_or("", |entry| entry.source));
            continue;
        };
        found.repeated(entry);
        for row in entry.0.iter().filter(|row| row.key != "t") {
            match actions(row, found) {
                Some(actions) => events.extend(actions.into_iter().map(|action| Event { t, action })),
                None => found.error(msg!("project.panel-unknown", number = count, action = clip(&row.key)), row.source),
            }
        }
    }
    Panel::new(events)
}

/// The actions of a key; `None` where it is no action or its value does not fit.
fn actions<'t>(entry: &JsonMember<'t>, found: &mut Findings<'t>) -> Option<Vec<Action>> {
    let value: &'t RawValue = serde_json::from_str(entry.value.source).ok()?;
    let pair = MapDeserializer::<_, serde_json::Error>::new(once((entry.key.as_str(), value)));
    let action = PanelAction::deserialize(MapAccessDeserializer::new(pair)).ok()?;
    let fitting = |action: Action| action.is_in_range().then(|| vec![action]);
    let pressed = |on: bool, action| Some(if on { vec![action] } else { Vec::new() });
    match action {
        PanelAction::SpindleOverride(percent) => fitting(Action::SpindleOverride(percent)),
        PanelAction::FeedOverride(percent) => fitting(Action::FeedOverride(percent)),
        PanelAction::RapidOverride(percent) => fitting(Action::RapidOverride(percent)),
        PanelAction::Start(on) => pressed(on, Action::Start),
        PanelAction::Hold(on) => pressed(on, Action::Hold),
        PanelAction::Reset(on) => pressed(on, Action::Reset),
        PanelAction::Estop(on) => pressed(on, Action::EmergencyStop),
        PanelAction::InverterFault(on) => Some(vec![Action::InverterFault(on)]),
        PanelAction::ProgramZero(on) => pressed(on, Action::ProgramZeroReturn),
        PanelAction::SingleBlock(on) => Some(vec![Action::SingleBlock(on)]),
        PanelAction::OptionalStop(on) => Some(vec![Action::OptionalStop(on)]),
        PanelAction::BlockSkip(on) => Some(vec![Action::BlockSkip(on)]),
        PanelAction::ManualS(rpm) => Some(vec![Action::ManualSpeed(rpm)]),
        PanelAction::LowerSpeedLimit(rpm) => fitting(Action::SpeedLimit(SpeedLimit::Lower, rpm)),
        PanelAction::UpperSpeedLimit(rpm) => fitting(Action::SpeedLimit(SpeedLimit::Upper, rpm)),
        PanelAction::SurfaceSpeedLimit(rpm) => fitting(Action::SpeedLimit(SpeedLimit::Surface, rpm)),
        PanelAction::Input(inputs) => {
            found.repeated(&inputs);
            let input = |row: JsonMember| Some(Action::Input(row.key.as_str().into(), row.value.value.as_f64()?));
            inputs.0.into_iter().map(input).collect()
        }
        PanelAction::Variable(variables) => {
            found.repeated(&variables);
            variables.0.into_iter().map(variable).collect()
        }
    }
}

fn variable(row: JsonMember) -> Option<Action> {
    let number = row.key.trim_start_matches('#').parse().ok()?;
    match row.value.value {
        Value::Null => Some(Action::Variable(number, None)),
        value => Some(Action::Variable(number, Some(value.as_f64()?))),
    }
}

/// An event as an object of JSON.
pub(super) fn members(event: &Event) -> JsonMembers<'static> {
    let (key, value) = match &event.action {
        Action::SpindleOverride(percent) => ("spindle_override", number(*percent)),
        Action::FeedOverride(percent) => ("feed_override", number(*percent)),
        Action::RapidOverride(percent) => ("rapid_override", number(*percent)),
        Action::Start => ("start", true.into()),
        Action::Hold => ("hold", true.into()),
        Action::Reset => ("reset", true.into()),
        Action::EmergencyStop => ("estop", true.into()),
        Action::InverterFault(on) => ("inverter_fault", (*on).into()),
        Action::ProgramZeroReturn => ("program_zero", true.into()),
        Action::SingleBlock(on) => ("single_block", (*on).into()),
        Action::OptionalStop(on) => ("optional_stop", (*on).into()),
        Action::BlockSkip(on) => ("block_skip", (*on).into()),
        Action::ManualSpeed(rpm) => ("manual_s", number(*rpm)),
        Action::SpeedLimit(SpeedLimit::Lower, rpm) => ("lower_speed_limit", number(*rpm)),
        Action::SpeedLimit(SpeedLimit::Upper, rpm) => ("upper_speed_limit", number(*rpm)),
        Action::SpeedLimit(SpeedLimit::Surface, rpm) => ("surface_speed_limit", number(*rpm)),
        Action::Input(name, value) => ("input", serde_json::json!({ name.to_string(): number(*value) })),
        Action::Variable(id, value) => {
            ("variable", serde_json::json!({ format!("#{id}"): value.map_or(Value::Null, number) }))
        }
    };
    [("t", number(event.t)), (key, value)].into_iter().collect()
}

//! A project as a file: JSON with a version. What comes in is hostile until checked; every old shape is upgraded.

use serde_json::{Map, Value as Json, json};

use super::Project;
use crate::controls::{self, Switches};
use crate::machines::form::{KindInfo, Provenance, Value};
use crate::machines::{self, AnyMachine};
use crate::motion::{Action, Event, Panel};
use crate::msg;
use crate::nc::{File, Files};
use crate::text::Diagnostic;

/// Version of the shape that is written.
pub const VERSION: u64 = 1;

/// Bytes of a project file at most: an edited program of 2 MB and room around it.
pub const MAX_BYTES: usize = 8 << 20;

/// Events of an operator's hand at most.
const MAX_EVENTS: usize = 100_000;

/// What a project file came to.
pub struct Loaded {
    /// The project; `None` where nothing could be made of the file.
    pub project: Option<Project>,
    /// What was wrong with it: errors without a project, warnings with one.
    pub diagnostics: Vec<Diagnostic>,
}

impl Project {
    /// The project as the text of its file.
    pub fn to_json(&self) -> String {
        let values: Map<String, Json> = self.values.iter().map(|(id, value)| (id.clone(), value_json(value))).collect();
        let provenance: Map<String, Json> =
            self.provenance.iter().map(|(id, from)| (id.clone(), json!(provenance_word(*from)))).collect();
        let switches: Map<String, Json> =
            self.switches.0.iter().map(|(id, setting)| (id.clone(), json!(setting))).collect();
        let mut out = json!({
            "version": VERSION,
            "name": self.name,
            "machine": self.machine.id(),
            "control": self.control.id,
            "values": values,
        });
        if let Some(object) = out.as_object_mut() {
            let mut put = |key: &str, value: Json, empty: bool| {
                if !empty {
                    object.insert(key.to_owned(), value);
                }
            };
            put("provenance", Json::Object(provenance), self.provenance.is_empty());
            put("switches", Json::Object(switches), self.switches.0.is_empty());
            put("silenced", json!(self.silenced), self.silenced.is_empty());
            put("panel", panel_json(&self.panel), self.panel.events().is_empty());
            if let Some(files) = &self.edited {
                let files: Vec<Json> = files.0.iter().map(|f| json!({ "name": f.name, "text": f.text })).collect();
                put("edited", Json::Array(files), false);
            }
        }
        let mut text = serde_json::to_string_pretty(&out).unwrap_or_default();
        text.push('\n');
        text
    }

    /// Reads a project file. Total: any text gives a project or errors that say what is wrong with it.
    pub fn from_json(text: &str) -> Loaded {
        let refuse = |message| Loaded { project: None, diagnostics: vec![Diagnostic::error(message)] };
        if text.len() > MAX_BYTES {
            return refuse(msg!("project.too-large", (text.len() >> 20) as u32, (MAX_BYTES >> 20) as u32));
        }
        let object = match serde_json::from_str::<Json>(text) {
            Ok(Json::Object(object)) => object,
            Ok(_) => return refuse(msg!("project.not-a-project")),
            Err(error) => {
                return refuse(msg!("project.not-json", error.line() as u32, error.column() as u32, reason(&error)));
            }
        };
        match object.get("version").and_then(Json::as_u64) {
            Some(VERSION) => {}
            Some(version) if version > VERSION => return refuse(msg!("project.newer", version as f64, VERSION as f64)),
            _ => return refuse(msg!("project.no-version")),
        }
        let Some(machine) = object.get("machine").and_then(Json::as_str).and_then(machines::find) else {
            let known = machines::ALL.iter().map(|m| m.id()).collect::<Vec<_>>().join(", ");
            return refuse(msg!("project.no-machine", known));
        };
        let control = object.get("control").and_then(Json::as_str).filter(|id| machine.controls().contains(id));
        let Some(control) = control.and_then(controls::find) else {
            return refuse(msg!("project.no-control", machine.controls().join(", ")));
        };
        let mut reader = Reader { found: Vec::new() };
        let mut project = Project::new(machine, control);
        project.name = text_of(object.get("name")).chars().filter(|c| !c.is_control()).take(120).collect();
        reader.values(&object, machine, &mut project);
        reader.switches(&object, &mut project);
        project.silenced = strings(object.get("silenced"));
        if let Some(panel) = object.get("panel") {
            project.panel = reader.panel(panel);
        }
        project.edited = reader.edited(object.get("edited"));
        Loaded { project: Some(project), diagnostics: reader.found }
    }
}

/// What is wrong with a JSON text, without the place, which stands before it.
fn reason(error: &serde_json::Error) -> String {
    let text = error.to_string();
    text.split(" at line ").next().unwrap_or_default().to_owned()
}

/// Reads a panel file: a JSON array of `{ "t": seconds, "spindle_override": 80, … }`.
pub fn panel_from_json(text: &str) -> (Panel, Vec<Diagnostic>) {
    let mut reader = Reader { found: Vec::new() };
    let panel = match serde_json::from_str::<Json>(text) {
        Ok(json) => reader.panel(&json),
        Err(error) => {
            let (line, column) = (error.line() as u32, error.column() as u32);
            reader.found.push(Diagnostic::error(msg!("project.not-json", line, column, reason(&error))));
            Panel::default()
        }
    };
    (panel, reader.found)
}

/// A panel as the JSON array that [`panel_from_json`] reads.
pub fn panel_json(panel: &Panel) -> Json {
    let event = |event: &Event| {
        let (key, value) = match &event.action {
            Action::SpindleOverride(percent) => ("spindle_override", json!(percent)),
            Action::FeedOverride(percent) => ("feed_override", json!(percent)),
            Action::RapidOverride(percent) => ("rapid_override", json!(percent)),
            Action::Start => ("start", json!(true)),
            Action::Hold => ("hold", json!(true)),
            Action::Reset => ("reset", json!(true)),
            Action::EmergencyStop => ("estop", json!(true)),
            Action::SingleBlock(on) => ("single_block", json!(on)),
            Action::OptionalStop(on) => ("optional_stop", json!(on)),
            Action::BlockSkip(on) => ("block_skip", json!(on)),
            Action::ManualSpeed(rpm) => ("manual_s", json!(rpm)),
            Action::Input(name, value) => ("input", json!({ name: value })),
            Action::Variable(number, value) => ("variable", json!({ number.to_string(): value })),
        };
        json!({ "t": event.t, key: value })
    };
    Json::Array(panel.events().iter().map(event).collect())
}

struct Reader {
    found: Vec<Diagnostic>,
}

impl Reader {
    fn values(&mut self, object: &Map<String, Json>, machine: &'static dyn AnyMachine, project: &mut Project) {
        let fields = machine.fields();
        let empty = Map::new();
        let saved = object.get("values").and_then(Json::as_object).unwrap_or(&empty);
        for (id, json) in saved {
            let Some(field) = fields.iter().find(|field| field.id == id) else {
                self.found.push(Diagnostic::warning(msg!("project.unknown-field", clip(id))));
                continue;
            };
            let value = match (&field.kind, json) {
                (KindInfo::Number { .. }, Json::Number(number)) => number.as_f64().map(Value::Number),
                (KindInfo::Flag(_), Json::Bool(flag)) => Some(Value::Flag(*flag)),
                (KindInfo::Choice(_) | KindInfo::Text(_), Json::String(text)) => Some(Value::Text(text.clone())),
                _ => None,
            };
            match value {
                // Out of range stays: the field says what is wrong, and nothing that was typed is lost.
                Some(value) => drop(project.values.insert(id.clone(), value)),
                None => self.found.push(
                    Diagnostic::error(msg!("project.wrong-kind", clip(id), clip(&json.to_string()))).about(field.id),
                ),
            }
        }
        if let Some(saved) = object.get("provenance").and_then(Json::as_object) {
            for (id, json) in saved {
                match json.as_str().and_then(provenance_of) {
                    Some(from) if fields.iter().any(|field| field.id == id) => {
                        project.provenance.insert(id.clone(), from);
                    }
                    _ => self.found.push(Diagnostic::warning(msg!("project.unknown-field", clip(id)))),
                }
            }
        }
    }

    fn switches(&mut self, object: &Map<String, Json>, project: &mut Project) {
        let Some(saved) = object.get("switches").and_then(Json::as_object) else { return };
        let mut switches = Switches::default();
        for (id, json) in saved {
            let row = project.control.switches.iter().find(|row| row.id == id);
            match (row, json.as_str()) {
                (Some(row), Some(setting)) if row.options.contains(&setting) => {
                    switches.0.push((id.clone(), setting.to_owned()));
                }
                _ => self.found.push(Diagnostic::warning(msg!("project.unknown-switch", clip(id)))),
            }
        }
        project.switches = switches;
    }

    fn edited(&mut self, json: Option<&Json>) -> Option<Files> {
        let list = json?.as_array()?;
        let files: Vec<File> = list
            .iter()
            .take(64)
            .map(|file| File { name: clip(&text_of(file.get("name"))), text: text_of(file.get("text")) })
            .collect();
        (!files.is_empty()).then_some(Files(files))
    }

    fn panel(&mut self, json: &Json) -> Panel {
        let Some(list) = json.as_array() else {
            self.found.push(Diagnostic::error(msg!("project.panel-not-a-list")));
            return Panel::default();
        };
        if list.len() > MAX_EVENTS {
            self.found.push(Diagnostic::error(msg!("project.panel-too-long", MAX_EVENTS as u32)));
        }
        let mut events = Vec::new();
        for (at, entry) in list.iter().take(MAX_EVENTS).enumerate() {
            let number = at as u32 + 1;
            let t = entry.get("t").and_then(Json::as_f64).filter(|t| *t >= 0.0);
            let (Some(object), Some(t)) = (entry.as_object(), t) else {
                self.found.push(Diagnostic::error(msg!("project.panel-no-time", number)));
                continue;
            };
            for (key, value) in object.iter().filter(|(key, _)| *key != "t") {
                match actions(key, value) {
                    Some(found) => events.extend(found.into_iter().map(|action| Event { t, action })),
                    None => self.found.push(Diagnostic::error(msg!("project.panel-unknown", number, clip(key)))),
                }
            }
        }
        Panel::new(events)
    }
}

/// The actions of one entry of a panel file; `None` where the entry is none. A switch that is `false` is not pressed.
fn actions(key: &str, value: &Json) -> Option<Vec<Action>> {
    let percent = || value.as_f64().filter(|percent| (0.0..=1000.0).contains(percent));
    let pressed = |action: Action| value.as_bool().map(|on| if on { vec![action] } else { Vec::new() });
    match key {
        "spindle_override" => percent().map(|p| vec![Action::SpindleOverride(p)]),
        "feed_override" => percent().map(|p| vec![Action::FeedOverride(p)]),
        "rapid_override" => percent().map(|p| vec![Action::RapidOverride(p)]),
        "start" => pressed(Action::Start),
        "hold" => pressed(Action::Hold),
        "reset" => pressed(Action::Reset),
        "estop" => pressed(Action::EmergencyStop),
        "single_block" => value.as_bool().map(|on| vec![Action::SingleBlock(on)]),
        "optional_stop" => value.as_bool().map(|on| vec![Action::OptionalStop(on)]),
        "block_skip" => value.as_bool().map(|on| vec![Action::BlockSkip(on)]),
        "manual_s" => value.as_f64().map(|rpm| vec![Action::ManualSpeed(rpm)]),
        "input" => {
            let inputs = value.as_object()?.iter();
            inputs.map(|(name, value)| Some(Action::Input(name.clone(), value.as_f64()?))).collect()
        }
        "variable" => {
            let variables = value.as_object()?.iter();
            variables
                .map(|(name, value)| {
                    let number = name.trim_start_matches('#').parse().ok()?;
                    if value.is_null() {
                        Some(Action::Variable(number, None))
                    } else {
                        Some(Action::Variable(number, Some(value.as_f64()?)))
                    }
                })
                .collect()
        }
        _ => None,
    }
}

fn value_json(value: &Value) -> Json {
    match value {
        // Whole numbers without a point, as people write them.
        Value::Number(number) if *number == number.trunc() && number.abs() < 1e15 => json!(*number as i64),
        Value::Number(number) => json!(number),
        Value::Flag(flag) => json!(flag),
        Value::Text(text) => json!(text),
    }
}

/// A provenance as it is saved.
pub fn provenance_word(from: Provenance) -> &'static str {
    match from {
        Provenance::Measured => "measured",
        Provenance::DataSheet => "data-sheet",
        Provenance::Assumed => "assumed",
    }
}

/// The provenance of a saved word.
pub fn provenance_of(word: &str) -> Option<Provenance> {
    [Provenance::Measured, Provenance::DataSheet, Provenance::Assumed].into_iter().find(|p| provenance_word(*p) == word)
}

fn text_of(json: Option<&Json>) -> String {
    json.and_then(Json::as_str).unwrap_or_default().to_owned()
}

fn strings(json: Option<&Json>) -> Vec<String> {
    let list = json.and_then(Json::as_array).map_or(&[][..], Vec::as_slice);
    list.iter().filter_map(|entry| entry.as_str().map(clip)).take(1000).collect()
}

fn clip(text: &str) -> String {
    text.chars().filter(|c| !c.is_control()).take(60).collect()
}

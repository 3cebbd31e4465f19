//! A project as a file: JSON with a version. What comes in is hostile until checked; every old shape is upgraded.

use super::Project;
use super::json::{Fault, Json};
use crate::controls::{self, Switches};
use crate::drives::speed::SpeedLimit;
use crate::machines::form::{KindInfo, Provenance, Value};
use crate::machines::{self, AnyMachine};
use crate::motion::{Action, Event, Panel};
use crate::msg;
use crate::nc::{File, Files};
use crate::text::{Diagnostic, Message};

/// Version of the shape that is written.
pub const VERSION: u32 = 1;

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
    ///
    /// Written by hand, as the library's way through a tree and its printing of floats would cost the page 10 KB.
    pub fn to_json(&self) -> String {
        let pairs = |pairs: Vec<(&str, String)>| {
            let lines: Vec<String> = pairs.iter().map(|(id, value)| format!("    {}: {value}", quoted(id))).collect();
            if lines.is_empty() { "{}".to_owned() } else { format!("{{\n{}\n  }}", lines.join(",\n")) }
        };
        let list = |lines: Vec<String>| format!("[\n    {}\n  ]", lines.join(",\n    "));
        let mut parts = vec![
            format!("\"version\": {VERSION}"),
            format!("\"name\": {}", quoted(&self.name)),
            format!("\"machine\": {}", quoted(self.machine.id())),
            format!("\"control\": {}", quoted(self.control.id)),
            format!("\"values\": {}", pairs(self.values.iter().map(|(id, v)| (id.as_str(), value_text(v))).collect())),
        ];
        if !self.provenance.is_empty() {
            let word = |from: &Provenance| quoted(provenance_word(*from));
            let all = self.provenance.iter().map(|(id, from)| (id.as_str(), word(from)));
            parts.push(format!("\"provenance\": {}", pairs(all.collect())));
        }
        if !self.switches.0.is_empty() {
            let all = self.switches.0.iter().map(|(id, setting)| (id.as_str(), quoted(setting)));
            parts.push(format!("\"switches\": {}", pairs(all.collect())));
        }
        if !self.silenced.is_empty() {
            parts.push(format!("\"silenced\": {}", list(self.silenced.iter().map(|id| quoted(id)).collect())));
        }
        if !self.panel.events().is_empty() {
            parts.push(format!("\"panel\": {}", list(self.panel.events().iter().map(event_text).collect())));
        }
        if let Some(files) = &self.edited {
            let file = |f: &File| format!("{{ \"name\": {}, \"text\": {} }}", quoted(&f.name), quoted(&f.text));
            parts.push(format!("\"edited\": {}", list(files.0.iter().map(file).collect())));
        }
        format!("{{\n  {}\n}}\n", parts.join(",\n  "))
    }

    /// Reads a project file. Total: any text gives a project or errors that say what is wrong with it.
    pub fn from_json(text: &str) -> Loaded {
        let loaded = |project, diagnostics| Loaded { project, diagnostics };
        let refuse = |message| loaded(None, vec![Diagnostic::error(message)]);
        if text.len() > MAX_BYTES {
            return refuse(msg!("project.too-large", (text.len() >> 20) as u32, (MAX_BYTES >> 20) as u32));
        }
        let object = match Json::read(text) {
            Ok(object @ Json::Object(_)) => object,
            Ok(_) => return refuse(msg!("project.not-a-project")),
            Err(fault) => return refuse(not_json(&fault)),
        };
        match object.get("version").and_then(Json::as_f64).filter(|version| *version >= 1.0 && version.fract() == 0.0) {
            Some(version) if version > f64::from(VERSION) => return refuse(msg!("project.newer", version, VERSION)),
            Some(_) => {}
            None => return refuse(msg!("project.no-version")),
        }
        let Some(machine) = object.get("machine").and_then(Json::as_str).and_then(machines::find) else {
            let known = machines::ALL.iter().map(|machine| machine.id()).collect::<Vec<_>>().join(", ");
            return refuse(msg!("project.no-machine", known));
        };
        let control = object.get("control").and_then(Json::as_str).filter(|id| machine.controls().contains(id));
        let Some(control) = control.and_then(controls::find) else {
            return refuse(msg!("project.no-control", machine.controls().join(", ")));
        };
        let mut reader = Reader { found: Vec::new() };
        let mut project = Project::new(machine, control);
        // A switch that a file does not name is at its default.
        project.switches = Switches::default();
        project.name = text_of(object.get("name")).chars().filter(|c| !c.is_control()).take(120).collect();
        reader.values(&object, machine, &mut project);
        reader.switches(&object, &mut project);
        project.silenced = strings(object.get("silenced"));
        if let Some(panel) = object.get("panel") {
            project.panel = reader.panel(panel);
        }
        project.edited = reader.edited(object.get("edited"));
        loaded(Some(project), reader.found)
    }
}

/// What is wrong with a JSON text.
fn not_json(fault: &Fault) -> Message {
    msg!("project.not-json", fault.line, fault.column, fault.reason)
}

/// Reads a panel file: a JSON array of `{ "t": seconds, "spindle_override": 80, … }`.
pub fn panel_from_json(text: &str) -> (Panel, Vec<Diagnostic>) {
    let mut reader = Reader { found: Vec::new() };
    let panel = match Json::read(text) {
        Ok(json) => reader.panel(&json),
        Err(fault) => {
            reader.found.push(Diagnostic::error(not_json(&fault)));
            Panel::default()
        }
    };
    (panel, reader.found)
}

/// An event as an entry of a panel file.
fn event_text(event: &Event) -> String {
    let (key, value) = match &event.action {
        Action::SpindleOverride(percent) => ("spindle_override", number(*percent)),
        Action::FeedOverride(percent) => ("feed_override", number(*percent)),
        Action::RapidOverride(percent) => ("rapid_override", number(*percent)),
        Action::Start => ("start", true.to_string()),
        Action::Hold => ("hold", true.to_string()),
        Action::Reset => ("reset", true.to_string()),
        Action::EmergencyStop => ("estop", true.to_string()),
        Action::SingleBlock(on) => ("single_block", on.to_string()),
        Action::OptionalStop(on) => ("optional_stop", on.to_string()),
        Action::BlockSkip(on) => ("block_skip", on.to_string()),
        Action::ManualSpeed(rpm) => ("manual_s", number(*rpm)),
        Action::SpeedLimit(limit, rpm) => {
            let key = match limit {
                SpeedLimit::Lower => "lower_speed_limit",
                SpeedLimit::Upper => "upper_speed_limit",
                SpeedLimit::Surface => "surface_speed_limit",
            };
            (key, number(*rpm))
        }
        Action::Input(name, value) => ("input", format!("{{ {}: {} }}", quoted(name), number(*value))),
        Action::Variable(number, Some(value)) => ("variable", format!("{{ \"#{number}\": {} }}", self::number(*value))),
        Action::Variable(number, None) => ("variable", format!("{{ \"#{number}\": null }}")),
    };
    format!("{{ \"t\": {}, \"{key}\": {value} }}", number(event.t))
}

/// A number as JSON: the shortest decimal that reads back as the same double, whole numbers without a point.
fn number(value: f64) -> String {
    match value.abs() {
        size if !size.is_finite() => "null".to_owned(),
        size if size != 0.0 && !(1e-7..1e16).contains(&size) => format!("{value:e}"),
        _ => value.to_string(),
    }
}

/// A text as a JSON string.
fn quoted(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            c if c < ' ' => out.push_str(&format!("\\u{:04x}", c as u32)),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

struct Reader {
    found: Vec<Diagnostic>,
}

impl Reader {
    fn values(&mut self, object: &Json, machine: &'static dyn AnyMachine, project: &mut Project) {
        let fields = machine.fields();
        let saved = object.get("values").and_then(Json::as_object).unwrap_or_default();
        for (id, json) in saved {
            let Some(field) = fields.iter().find(|field| field.id == id) else {
                self.found.push(Diagnostic::warning(msg!("project.unknown-field", clip(id))));
                continue;
            };
            let value = match (&field.kind, json) {
                (KindInfo::Number { .. }, Json::Number(number)) => Some(Value::Number(*number)),
                (KindInfo::Flag(_), Json::Bool(flag)) => Some(Value::Flag(*flag)),
                (KindInfo::Choice(_) | KindInfo::Text(_), Json::Text(text)) => Some(Value::Text(text.clone())),
                _ => None,
            };
            match value {
                // Out of range stays: the field says what is wrong, and nothing that was typed is lost.
                Some(value) => {
                    project.values.insert(id.clone(), value);
                }
                None => self
                    .found
                    .push(Diagnostic::error(msg!("project.wrong-kind", clip(id), kind_word(json))).about(field.id)),
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

    fn switches(&mut self, object: &Json, project: &mut Project) {
        let Some(saved) = object.get("switches").and_then(Json::as_object) else { return };
        let mut switches = Switches::default();
        for (id, json) in saved {
            let row = project.control.switches.iter().find(|row| row.id == id);
            match (row, json.as_str()) {
                (Some(row), Some(setting)) if row.takes(setting) => {
                    switches.0.push((id.clone(), setting.to_owned()));
                }
                _ => self.found.push(Diagnostic::warning(msg!("project.unknown-switch", clip(id)))),
            }
        }
        project.switches = switches;
    }

    fn edited(&mut self, json: Option<&Json>) -> Option<Files> {
        let list = json?.as_list()?;
        let files: Vec<File> = list
            .iter()
            .take(64)
            .map(|file| File { name: file_name(&text_of(file.get("name"))), text: text_of(file.get("text")) })
            .collect();
        (!files.is_empty()).then_some(Files(files))
    }

    fn panel(&mut self, json: &Json) -> Panel {
        let Some(list) = json.as_list() else {
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
            for (key, value) in object.iter().filter(|(key, _)| key != "t") {
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
    let limit = |limit| value.as_f64().filter(|rpm| *rpm >= 0.0).map(|rpm| vec![Action::SpeedLimit(limit, rpm)]);
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
        "lower_speed_limit" => limit(SpeedLimit::Lower),
        "upper_speed_limit" => limit(SpeedLimit::Upper),
        "surface_speed_limit" => limit(SpeedLimit::Surface),
        "input" => {
            let inputs = value.as_object()?.iter();
            inputs.map(|(name, value)| Some(Action::Input(name.clone(), value.as_f64()?))).collect()
        }
        "variable" => {
            let variables = value.as_object()?.iter();
            variables
                .map(|(name, value)| {
                    let number = name.trim_start_matches('#').parse().ok()?;
                    if matches!(value, Json::Null) {
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

/// A value as JSON: whole numbers without a point, as people write them. What is no number is none in JSON either.
fn value_text(value: &Value) -> String {
    match value {
        Value::Number(number) => self::number(*number),
        Value::Flag(flag) => flag.to_string(),
        Value::Text(text) => quoted(text),
    }
}

/// What kind of value stands there, for those who wrote it.
fn kind_word(json: &Json) -> &'static str {
    match json {
        Json::Null => "null",
        Json::Bool(_) => "true or false",
        Json::Number(_) => "a number",
        Json::Text(_) => "text",
        Json::List(_) => "a list",
        Json::Object(_) => "an object",
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
    let list = json.and_then(Json::as_list).unwrap_or_default();
    list.iter().filter_map(|entry| entry.as_str().map(clip)).take(1000).collect()
}

/// The name of a program file: a bare name, whatever a hostile project says, for an export writes it into a folder.
fn file_name(text: &str) -> String {
    let name = clip(text.rsplit(['/', '\\', ':']).next().unwrap_or_default());
    let bare = name.trim_start_matches('.');
    if bare.is_empty() { "program.nc".to_owned() } else { bare.to_owned() }
}

fn clip(text: &str) -> String {
    text.chars().filter(|c| !c.is_control()).take(60).collect()
}

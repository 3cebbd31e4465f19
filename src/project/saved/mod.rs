//! A project as a file: JSON with a version, one serde struct per version, every old one upgraded to the newest.
//!
//! A new version is a file `v2.rs` with its struct, a function that makes it from the struct of version 1, a row in
//! [`Project::from_json`], and a kept file in `tests/data/saved`. Only the newest is written and [resolved](resolve).

mod embedded;
mod history;
mod link;
mod loaded;
mod old_ids;
mod old_options;
mod panel;
mod resolve;
mod v1;

use serde::Deserialize;
use serde::de::IgnoredAny;

pub use self::embedded::embedded;
pub use self::history::{StepTexts, steps_from_json, steps_to_json};
pub use self::link::{MAX_LINK, is_link};
pub use self::loaded::{Loaded, MAX_BYTES, MAX_PROGRAM, MAX_PROGRAMS};
use self::v1::{ProgramV1, ProjectV1, TitleBlockV1, VariantV1};
use super::files::json::{self, JsonMembers, Located};
use super::findings::project_file::Findings;
use super::variants::variant::Variant;
use super::{Project, parts};
use crate::controls::Switches;
use crate::machines::form::{Value, Values};
use crate::machines::{self, AnyMachine};
use crate::motion::Panel;
use crate::msg;
use crate::text::catalog::{Language, sentence};
use crate::text::{Diagnostic, LineIndex, Message, without_byte_order_mark};

/// Version that is written.
pub const VERSION: u32 = 1;

/// Version of a project file; other contents are not checked.
#[derive(Deserialize)]
struct Head<'t> {
    #[serde(borrow)]
    version: Option<Located<'t>>,
}

impl Project {
    /// The project as the text of its file.
    pub fn to_json(&self) -> String {
        // Keys are texts and writing into a text does not fail.
        serde_json::to_string_pretty(&self.saved()).unwrap_or_default() + "\n"
    }

    /// The project in the version that is written.
    fn saved(&self) -> ProjectV1<'static> {
        let program = |file: &crate::nc::File| ProgramV1 { name: file.name.clone(), text: file.text.clone() };
        ProjectV1 {
            version: VERSION,
            name: self.name.clone(),
            title_block: TitleBlockV1 {
                customer: self.title_block.customer.clone(),
                author: self.title_block.author.clone(),
                number: self.title_block.number.clone(),
                revision: self.title_block.revision.clone(),
            },
            machine: Some(Located::new(self.machine.id())),
            control: Some(Located::new(self.control.id)),
            values: Some(values(&self.values)),
            provenance: self.provenance.iter().map(|(id, from)| (id, resolve::provenance_word(*from).into())).collect(),
            switches: switches(&self.switches),
            comments: (self.comments != Language::English).then(|| self.comments.code().to_owned()),
            silenced: self.silenced.clone(),
            panel: self.panel.events().iter().map(panel::members).collect(),
            edited: self.edited.as_ref().map(|files| files.0.iter().map(program).collect()),
            parts: self.parts.iter().map(parts::members).collect(),
            variants: self.variants.iter().map(variant).collect(),
        }
    }

    /// Reads a project file. Total: any text gives a project, or errors with their places.
    pub fn from_json(text: &str) -> Loaded {
        Project::from_json_among(machines::ALL, text)
    }

    /// Reads a project file of one of these machines.
    pub fn from_json_among(machines: &[&'static dyn AnyMachine], text: &str) -> Loaded {
        let mut found = Findings::new(text);
        match newest(text) {
            Ok(saved) => resolve::project(machines, saved, found),
            Err(finding) => {
                found.add(finding, "");
                Loaded::refused(found)
            }
        }
    }
}

/// Values as members of an object.
fn values(values: &Values) -> JsonMembers<'static> {
    let entry = |value: &Value| match value {
        Value::Number(number) => json::number(*number),
        Value::Flag(flag) => (*flag).into(),
        Value::Text(text) => text.as_str().into(),
    };
    values.iter().map(|(id, value)| (id, entry(value))).collect()
}

/// Settings of open points as members of an object.
fn switches(switches: &Switches) -> JsonMembers<'static> {
    switches.0.iter().map(|(id, setting)| (id, setting.as_str().into())).collect()
}

fn variant(variant: &Variant) -> VariantV1<'static> {
    VariantV1 {
        name: Located::new(variant.name.as_str()),
        control: Located::new(variant.control.id),
        values: values(&variant.values),
        switches: switches(&variant.switches),
    }
}

/// The file in the newest version.
fn newest(text: &str) -> Result<ProjectV1<'_>, Diagnostic> {
    let json = sized(text)?;
    let wrong = |error: serde_json::Error| {
        if error.is_data() { shape(text, json, &error) } else { not_json(text, json, &error) }
    };
    // serde would accept a list in place of a struct.
    if !json.trim_start().starts_with('{') {
        serde_json::from_str::<IgnoredAny>(json).map_err(wrong)?;
        return Err(Diagnostic::error(msg!("project.not-a-project")));
    }
    let head: Head = serde_json::from_str(json).map_err(wrong)?;
    let version = head.version.as_ref().and_then(|version| version.value.as_f64());
    match version.filter(|version| *version >= 1.0 && version.fract() == 0.0) {
        None => Err(Diagnostic::error(msg!("project.no-version"))),
        Some(1.0) => serde_json::from_str(json).map_err(wrong),
        Some(version) => Err(Diagnostic::error(msg!("project.newer", version, latest = VERSION))),
    }
}

/// The JSON of a file that is not too large: without its byte order mark.
fn sized(text: &str) -> Result<&str, Diagnostic> {
    if text.len() > MAX_BYTES {
        return Err(Diagnostic::error(msg!(
            "project.too-large",
            size = (text.len() >> 20) as u32,
            most = (MAX_BYTES >> 20) as u32
        )));
    }
    Ok(without_byte_order_mark(text))
}

fn not_json(text: &str, json: &str, error: &serde_json::Error) -> Diagnostic {
    located(msg!("project.not-json", reason = json::reason(error)), text, json, error)
}

fn shape(text: &str, json: &str, error: &serde_json::Error) -> Diagnostic {
    located(msg!("project.shape", reason = json::reason(error)), text, json, error)
}

fn located(message: Message, text: &str, json: &str, error: &serde_json::Error) -> Diagnostic {
    let mut place = json::error_place(json, error);
    let skipped = (text.len() - json.len()) as u32;
    place.span.start += skipped;
    place.span.end += skipped;
    Diagnostic::error(message).at(place)
}

/// Reads a panel file: a JSON array of `{ "t": seconds, "spindle_override": 80, … }`.
pub fn panel_from_json(text: &str) -> (Panel, Vec<Diagnostic>) {
    let read = sized(text).and_then(|json| {
        serde_json::from_str::<Vec<JsonMembers>>(json).map_err(|error| match error.is_data() {
            true if !json.trim_start().starts_with('[') => Diagnostic::error(msg!("project.panel-not-a-list")),
            true => shape(text, json, &error),
            false => not_json(text, json, &error),
        })
    });
    match read {
        Ok(entries) => {
            let mut found = Findings::new(text);
            let panel = panel::read(&entries, &mut found);
            (panel, found.into_diagnostics())
        }
        Err(finding) => (Panel::default(), vec![finding]),
    }
}

/// A panel file, one event a line.
pub fn panel_to_json(panel: &Panel) -> String {
    // Keys are texts and writing into a text does not fail.
    let line = |event| serde_json::to_string(&panel::members(event)).unwrap_or_default();
    let lines: Vec<String> = panel.events().iter().map(line).collect();
    if lines.is_empty() { "[]\n".to_owned() } else { format!("[\n  {}\n]\n", lines.join(",\n  ")) }
}

/// The sentence of a finding about a file, with its line where there is no excerpt beside it.
pub fn with_line(finding: &Diagnostic, text: &str) -> String {
    let message = sentence(&finding.message);
    match finding.place {
        None => message,
        Some(place) => {
            let at = LineIndex::new(text).position(text, place.span.start);
            sentence(&msg!("project.at-line", line = at.line, column = at.column, text = message))
        }
    }
}

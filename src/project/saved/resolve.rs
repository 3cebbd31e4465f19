//! From the newest shape of a project file to a project: ids become machines, controls, fields and switches, values are checked.

use serde_json::Value as Json;

use super::loaded::{Loaded, MAX_PROGRAMS};
use super::old_ids::{field_ids, warning_id};
use super::old_options::option_id;
use super::panel;
use super::v1::{ProgramV1, ProjectV1, VariantV1};
use crate::controls::{self, Control, Switches};
use crate::machines::AnyMachine;
use crate::machines::form::{FieldInfo, FieldKindInfo, Provenance, Value, Values};
use crate::msg;
use crate::nc::{File, Files};
use crate::project::files::json::{JsonMember, JsonMembers, Located, kind_word};
use crate::project::findings::project_file::Findings;
use crate::project::name::clean_name;
use crate::project::variants::variant::{MAX_VARIANTS, Variant, variant_name};
use crate::project::{Project, parts};
use crate::text::catalog::Language;
use crate::text::escape::clip;
use crate::text::{Diagnostic, listed};
use crate::view::report::TitleBlock;

/// The project that a file describes.
pub(super) fn project<'t>(
    machines: &[&'static dyn AnyMachine],
    saved: ProjectV1<'t>,
    mut found: Findings<'t>,
) -> Loaded {
    let part = |id: &Option<Located<'t>>| id.as_ref().map_or("", |id| id.source);
    let named = saved.machine.as_ref().and_then(|id| id.as_str());
    let Some(machine) = named.and_then(|id| machines.iter().copied().find(|machine| machine.id() == id)) else {
        let known = listed(machines.iter().map(|machine| machine.id()));
        found.error(msg!("project.no-machine", machines = known), part(&saved.machine));
        return Loaded::refused(found);
    };
    let Some(control) = saved.control.as_ref().and_then(|id| control_of(machine, id)) else {
        found.error(msg!("project.no-control", controls = listed(machine.controls())), part(&saved.control));
        return Loaded::refused(found);
    };
    let Some(saved_values) = &saved.values else {
        found.error(msg!("project.no-values"), "");
        return Loaded::refused(found);
    };
    let count = saved.edited.as_ref().map_or(0, Vec::len);
    if count > MAX_PROGRAMS {
        found.error(msg!("project.too-many-programs", count = count as u32, most = MAX_PROGRAMS as u32), "");
        return Loaded::refused(found);
    }
    let mut project = Project::of_form(machine, control);
    project.name = clean_name(&saved.name);
    project.title_block = TitleBlock {
        customer: clean_name(&saved.title_block.customer),
        author: clean_name(&saved.title_block.author),
        number: clean_name(&saved.title_block.number),
        revision: clean_name(&saved.title_block.revision),
    };
    values(saved_values, machine, &mut project.values, &mut found);
    origins(&saved.provenance, machine, &mut project, &mut found);
    project.switches = switches(&saved.switches, control, &mut found);
    project.comments = saved.comments.as_deref().and_then(Language::of_code).unwrap_or(Language::English);
    project.silenced = saved.silenced.iter().map(|id| clip(&warning_id(id))).collect();
    project.panel = panel::read(&saved.panel, &mut found);
    let (parts, about_parts) = parts::from_members(found.text(), &saved.parts);
    about_parts.into_iter().for_each(|finding| found.add(finding, ""));
    project.parts = parts;
    project.variants = variants(&saved.variants, machine, &mut found);
    project.edited = saved.edited.filter(|files| !files.is_empty()).map(edited);
    Loaded { project: Some(project), diagnostics: found.into_diagnostics() }
}

/// The control that a file names, if the machine can have it.
fn control_of(machine: &dyn AnyMachine, id: &Located) -> Option<&'static Control> {
    id.as_str().filter(|id| machine.controls().contains(id)).and_then(controls::find)
}

/// Reads the variants. A variant without a unique name, or on a control that the machine cannot have, is left out.
fn variants<'t>(saved: &[VariantV1<'t>], machine: &'static dyn AnyMachine, found: &mut Findings<'t>) -> Vec<Variant> {
    let mut variants: Vec<Variant> = Vec::new();
    for row in saved {
        if variants.len() == MAX_VARIANTS {
            found.error(msg!("project.too-many-variants", most = MAX_VARIANTS as u32), row.name.source);
            break;
        }
        let name = row.name.as_str().and_then(variant_name);
        let Some(name) = name.filter(|name| variants.iter().all(|other| other.name != *name)) else {
            found.error(msg!("project.variant-name"), row.name.source);
            continue;
        };
        let Some(control) = control_of(machine, &row.control) else {
            found.error(
                msg!("project.variant-control", variant = name, controls = listed(machine.controls())),
                row.control.source,
            );
            continue;
        };
        let mut own = Project::of_form(machine, control).values;
        values(&row.values, machine, &mut own, found);
        let switches = switches(&row.switches, control, found);
        variants.push(Variant { name, control, values: own, switches });
    }
    variants
}

/// Members by the present ids of their fields.
fn of_fields<'s, 't>(
    saved: &'s JsonMembers<'t>,
    fields: &'s [FieldInfo],
) -> impl Iterator<Item = (&'s JsonMember<'t>, &'s str)> {
    saved.0.iter().flat_map(move |entry| field_ids(&entry.key, fields).into_iter().map(move |id| (entry, id)))
}

/// The form's values. A value out of range is kept: the field shows its range, and no input is lost.
fn values<'t>(
    saved: &JsonMembers<'t>,
    machine: &'static dyn AnyMachine,
    values: &mut Values,
    found: &mut Findings<'t>,
) {
    found.repeated(saved);
    let fields = machine.fields();
    for (entry, id) in of_fields(saved, &fields) {
        let Some(field) = fields.iter().find(|field| field.id == id) else {
            found.error(msg!("project.unknown-field", field = clip(id)), entry.source);
            continue;
        };
        let value = match (&field.kind, &entry.value.value) {
            (FieldKindInfo::Number { .. }, Json::Number(number)) => number.as_f64().map(Value::Number),
            (FieldKindInfo::Flag(_), Json::Bool(flag)) => Some(Value::Flag(*flag)),
            (FieldKindInfo::Choice(_) | FieldKindInfo::Text(_), Json::String(text)) => Some(Value::Text(text.clone())),
            _ => None,
        };
        match value {
            Some(value) => {
                values.insert(id.to_owned(), value);
            }
            None => {
                let message = msg!("project.wrong-kind", field = clip(id), found = kind_word(&entry.value.value));
                found.add(Diagnostic::error(message).about(field.id), entry.value.source);
            }
        }
    }
}

/// Reads the sources of the values.
fn origins<'t>(
    saved: &JsonMembers<'t>,
    machine: &'static dyn AnyMachine,
    project: &mut Project,
    found: &mut Findings<'t>,
) {
    found.repeated(saved);
    let fields = machine.fields();
    for (entry, id) in of_fields(saved, &fields) {
        let known = fields.iter().any(|field| field.id == id);
        match entry.value.as_str().and_then(provenance_of) {
            _ if !known => found.error(msg!("project.unknown-field", field = clip(id)), entry.source),
            Some(from) => {
                project.provenance.insert(id.to_owned(), from);
            }
            None => found.error(msg!("project.unknown-origin", field = clip(id)), entry.value.source),
        }
    }
}

/// The settings of a control's switches. A switch that the file does not name is at its default.
fn switches<'t>(saved: &JsonMembers<'t>, control: &Control, found: &mut Findings<'t>) -> Switches {
    found.repeated(saved);
    let mut switches = Switches::default();
    for entry in &saved.0 {
        let row = control.switch(&entry.key);
        let setting = entry.value.as_str().map(|setting| option_id(&entry.key, setting));
        match (row, setting) {
            (Some(row), Some(setting)) if row.takes(setting) => {
                if switches.0.iter().all(|(id, _)| id != row.id()) {
                    switches.0.push((entry.key.clone(), setting.to_owned()));
                }
            }
            (row, _) => {
                let part = if row.is_some() { entry.value.source } else { entry.source };
                found.error(msg!("project.unknown-switch", switch = clip(&entry.key)), part);
            }
        }
    }
    switches
}

fn edited(files: Vec<ProgramV1>) -> Files {
    Files(files.into_iter().map(|file| File { name: file_name(&file.name), text: file.text }).collect())
}

/// Saved word of a provenance.
pub(super) fn provenance_word(from: Provenance) -> &'static str {
    match from {
        Provenance::Measured => "measured",
        Provenance::DataSheet => "data-sheet",
        Provenance::Assumed => "assumed",
    }
}

/// The provenance of a saved word.
fn provenance_of(word: &str) -> Option<Provenance> {
    [Provenance::Measured, Provenance::DataSheet, Provenance::Assumed].into_iter().find(|p| provenance_word(*p) == word)
}

/// The bare name of a program file: an export writes it into a folder, so paths in a project file are cut off.
fn file_name(text: &str) -> String {
    let name = clip(text.rsplit(['/', '\\', ':']).next().unwrap_or_default());
    let bare = name.trim_start_matches('.');
    if bare.is_empty() { "program.nc".to_owned() } else { bare.to_owned() }
}

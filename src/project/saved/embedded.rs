//! The address fragment of a page inside another one, and its project.

use super::super::Project;
use super::Loaded;
use super::link::is_link;
use crate::machines;
use crate::msg;
use crate::project::examples::NameKind;
use crate::text::catalog::Language;
use crate::text::escape::clip;
use crate::text::units::Lengths;
use crate::text::{Diagnostic, listed};

/// Begin of the fragment.
const EMBED: &str = "embed";

/// Project for a page that is embedded in another one, from its address fragment (`docs/embedding.md`): `embed`, then, each after `&`, a
/// link, or the ids of a machine and of a control. An unknown language or system of units is a warning; `boot.js` has already applied a
/// known one. `None` if the fragment does not begin with `embed`. Total, like [`Project::from_link`].
pub fn embedded(fragment: &str) -> Option<Loaded> {
    let mut parts = fragment.split('&');
    if parts.next() != Some(EMBED) {
        return None;
    }
    let (mut machine, mut control, mut link, mut found) = (None, None, None, Vec::new());
    for part in parts {
        match part.split_once('=') {
            _ if is_link(part) => link = link.or(Some(part)),
            Some(("lang", code)) => found.extend(unknown_language(code)),
            Some(("lengths", id)) => found.extend(unknown_lengths(id)),
            Some(("machine", id)) => machine = Some(id),
            Some(("control", id)) => control = Some(id),
            _ if part.is_empty() => {}
            _ => found.push(unknown_part(part)),
        }
    }
    let mut loaded = link.map_or_else(|| of_ids(machine, control), Project::from_link);
    loaded.diagnostics.extend(found);
    Some(loaded)
}

/// Warning about an unknown part of the address.
fn unknown_part(part: &str) -> Diagnostic {
    let known = listed(["machine=", "control=", "lang=", "lengths="].map(str::to_owned));
    Diagnostic::warning(msg!("project.embed-part", part = clip(part), known))
}

/// Warning about a language that the page does not have. The code counts without its region, as in the page.
fn unknown_language(code: &str) -> Option<Diagnostic> {
    let language = code.split('-').next().unwrap_or_default();
    let languages = || listed(Language::ALL.map(|known| format!("lang={}", known.code())));
    Language::of_code(language)
        .is_none()
        .then(|| Diagnostic::warning(msg!("project.embed-language", languages = languages())))
}

/// Warning about a system of units that the page does not have.
fn unknown_lengths(id: &str) -> Option<Diagnostic> {
    let lengths = || listed(Lengths::ALL.map(|known| format!("lengths={}", known.id())));
    Lengths::of_id(id).is_none().then(|| Diagnostic::warning(msg!("project.embed-lengths", lengths = lengths())))
}

/// The first example of a machine on a control, by their ids; without one the first machine, and its first control.
fn of_ids(machine: Option<&str>, control: Option<&str>) -> Loaded {
    let machine = machine.or(machines::ALL.first().map(|machine| machine.id())).unwrap_or_default();
    match Project::named(machine, control, None) {
        Ok(project) => Loaded { project: Some(project), diagnostics: Vec::new() },
        Err(unknown) => {
            let known = listed(unknown.known);
            // If only the control is unknown, the requested machine is kept.
            let (project, message) = if unknown.kind == NameKind::Control {
                (Project::named(machine, None, None).ok(), msg!("project.embed-control", controls = known))
            } else {
                (None, msg!("project.embed-machine", machines = known))
            };
            Loaded { project, diagnostics: vec![Diagnostic::error(message)] }
        }
    }
}

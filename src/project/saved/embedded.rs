//! The fragment of a page inside another one: the project that it asks for.

use super::super::Project;
use super::Loaded;
use super::link::is_link;
use crate::machines;
use crate::msg;
use crate::project::examples::NameKind;
use crate::text::{Diagnostic, listed};

/// Begin of the fragment.
const EMBED: &str = "embed";

/// The project that the fragment of a page inside another one asks for (`docs/embedding.md`): behind `embed`, each after `&`, a link, or the ids of
/// a machine and of a control. `None` where the fragment asks for no such page. Total, as [`Project::from_link`].
pub fn embedded(fragment: &str) -> Option<Loaded> {
    let mut parts = fragment.split('&');
    if parts.next() != Some(EMBED) {
        return None;
    }
    let (mut machine, mut control) = (None, None);
    for part in parts {
        match part.split_once('=') {
            _ if is_link(part) => return Some(Project::from_link(part)),
            Some(("machine", id)) => machine = Some(id),
            Some(("control", id)) => control = Some(id),
            _ => {}
        }
    }
    let machine = machine.or(machines::ALL.first().map(|machine| machine.id())).unwrap_or_default();
    Some(match Project::named(machine, control, None) {
        Ok(project) => Loaded { project: Some(project), diagnostics: Vec::new() },
        Err(unknown) => {
            let known = listed(unknown.known);
            let control = unknown.kind == NameKind::Control;
            let message = if control {
                msg!("project.embed-control", controls = known)
            } else {
                msg!("project.embed-machine", machines = known)
            };
            Loaded { project: None, diagnostics: vec![Diagnostic::error(message)] }
        }
    })
}

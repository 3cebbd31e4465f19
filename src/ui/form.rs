//! The form: the machine's fields in their groups, the essential ones first.

use super::dom;
use super::el::{El, el};
use super::field::field;
use super::model::Model;
use super::words::t;
use crate::machines::form::FieldInfo;

/// Fields of a group that stands open at first.
const SMALL: usize = 5;

/// All fields of the machine.
pub(super) fn form(model: Model) -> El {
    let groups = move || {
        // Another machine is another form; values of the same machine are not.
        model.machine.track();
        let fields = model.project.with_untracked(|project| project.machine.fields());
        groups_of(fields).into_iter().map(|(title, open, fields)| group(model, title, open, fields)).collect()
    };
    let form = el("form").at("autocomplete", "off").on("submit", |event| event.prevent_default()).swap(groups);
    let stale = el("p.stale").text(t("page.stale")).mark("shown", move || model.is_stale());
    el("section.pane.form#form").label(t("page.inputs")).add(&[form, stale])
}

/// Fields side by side with their group; whether it stands open at first.
fn groups_of(fields: Vec<FieldInfo>) -> Vec<(&'static str, bool, Vec<FieldInfo>)> {
    let mut groups: Vec<(&'static str, bool, Vec<FieldInfo>)> = Vec::new();
    for essential in [true, false] {
        for field in fields.iter().filter(|field| field.essential == essential) {
            let title = if essential { "page.essentials" } else { field.group };
            match groups.iter_mut().find(|(other, _, _)| *other == title) {
                Some((_, _, list)) => list.push(field.clone()),
                None => groups.push((title, essential, vec![field.clone()])),
            }
        }
    }
    groups
}

fn group(model: Model, title: &'static str, open: bool, fields: Vec<FieldInfo>) -> El {
    let count = fields.len();
    let all: Vec<&'static str> = fields.iter().map(|field| field.id).collect();
    let shown = move || model.hidden.with(|hidden| all.iter().filter(|id| !hidden.contains(id)).count().to_string());
    let ids: Vec<&'static str> = fields.iter().map(|field| field.id).collect();
    let rows: Vec<El> = fields.into_iter().map(|info| field(model, info)).collect();
    if open {
        return el("fieldset.group").add(&[el("legend").text(t(title))]).add(&rows);
    }
    let summary = el("summary").text(t(title)).add(&[el("span.count").live(shown)]);
    let group = el("details.group").add(&[summary]).add(&rows);
    // Small groups stand open where there is room; a group with a wrong field opens by itself.
    if count <= SMALL && dom::prefers("(min-width: 761px)") {
        dom::set(group.dom(), "open", "");
    }
    let node = group.dom().clone();
    let wrong = move || model.wrong_fields().iter().any(|d| d.field.is_some_and(|field| ids.contains(&field)));
    let follow = move || {
        let wrong = wrong();
        let _ = node.class_list().toggle_with_force("wrong", wrong);
        if wrong {
            dom::set(&node, "open", "");
        }
    };
    group.run(follow)
}

//! The form: the machine's fields in their groups, the essential ones first.

use leptos::html;
use leptos::prelude::*;

use super::dom;
use super::field::field;
use super::model::Model;
use super::words::t;
use crate::machines::form::FieldInfo;

/// Fields of a group that stands open at first.
const SMALL: usize = 5;

/// All fields of the machine.
pub(super) fn form(model: Model) -> AnyView {
    // Another machine is another form; values of the same machine are not.
    let machine = Memo::new(move |_| model.project.with(|project| project.machine.id()));
    let groups = move || {
        machine.track();
        let fields = model.project.with_untracked(|project| project.machine.fields());
        groups_of(fields).into_iter().map(|(title, open, fields)| group(model, title, open, fields)).collect_view()
    };
    let wrong = move || model.wrong_fields().len();
    view! {
        <section class="pane form" id="form" aria-label=t("page.inputs")>
            <form autocomplete="off" on:submit=|event| event.prevent_default()>{groups}</form>
            <p class="stale" class:shown=move || { wrong() > 0 }>{t("page.stale")}</p>
        </section>
    }
    .into_any()
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

fn group(model: Model, title: &'static str, open: bool, fields: Vec<FieldInfo>) -> AnyView {
    let ids: Vec<&'static str> = fields.iter().map(|field| field.id).collect();
    let count = ids.len();
    let wrong =
        Memo::new(move |_| model.wrong_fields().iter().any(|d| d.field.is_some_and(|field| ids.contains(&field))));
    let rows = fields.into_iter().map(|info| field(model, info)).collect_view();
    if open {
        return view! { <fieldset class="group"><legend>{t(title)}</legend>{rows}</fieldset> }.into_any();
    }
    // Small groups stand open where there is room; a group with a wrong field opens by itself.
    let node: NodeRef<html::Details> = NodeRef::new();
    let roomy = count <= SMALL && dom::prefers("(min-width: 761px)");
    Effect::new(move |_| {
        if let Some(node) = node.get()
            && (roomy || wrong.get())
        {
            node.set_open(true);
        }
    });
    view! {
        <details class="group" class:wrong=wrong node_ref=node>
            <summary>{t(title)} <span class="count">{count}</span></summary>
            {rows}
        </details>
    }
    .into_any()
}

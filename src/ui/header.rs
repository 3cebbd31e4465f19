//! The header: what machine and control, which project, and what can be done with it.

use leptos::prelude::*;

use super::dom;
use super::files::{self, open_button};
use super::model::Model;
use super::store::Kept;
use super::words::t;
use crate::controls;
use crate::machines::{self, AnyMachine};
use crate::project::Project;

/// Where the choice of light and dark is kept.
const THEME: &str = "macroline.theme";

/// Themes in the order in which the button goes through them, with sign and words.
const THEMES: [(&str, &str, &str); 3] =
    [("", "◐", "page.theme-system"), ("light", "☀", "page.theme-light"), ("dark", "☾", "page.theme-dark")];

/// The header.
pub(super) fn header(model: Model) -> AnyView {
    let named = move |event| {
        let name = event_target_value(&event);
        model.edit("name", |project| project.name = name.chars().filter(|c| !c.is_control()).take(120).collect());
    };
    let name = move || model.project.with(|project| project.name.clone());
    let kept = move || match model.kept.get() {
        Kept::Yes => t("page.kept"),
        Kept::Soon => t("page.kept-soon"),
        Kept::No => t("page.kept-not"),
    };
    view! {
        <header class="top">
            <h1>"macro" <i>"line"</i></h1>
            {machine_picker(model)}
            {control_picker(model)}
            <div class="project">
                <input type="text" class="name" maxlength="120" aria-label=t("page.name") placeholder=t("page.untitled") prop:value=name on:input=named />
                <span class="kept" class:warn=move || model.kept.get() == Kept::No>{kept}</span>
            </div>
            <div class="doing">
                <button type="button" class="icon" aria-label=t("page.undo") title=t("page.undo-key") disabled=move || !model.can.get().0 on:click=move |_| model.undo()>"↶"</button>
                <button type="button" class="icon" aria-label=t("page.redo") title=t("page.redo-key") disabled=move || !model.can.get().1 on:click=move |_| model.redo()>"↷"</button>
                <button type="button" class="quiet" on:click=move |_| files::fresh(model)>{t("page.new")}</button>
                {open_button(model)}
                <button type="button" class="quiet" title=t("page.save-about") on:click=move |_| files::save(model)>{t("page.save")}</button>
                <button type="button" class="primary" id="export" on:click=move |_| model.exporting.set(true)>{t("page.export")}</button>
                {theme_button()}
                <button type="button" class="icon" aria-label=t("page.help") title=t("page.help") on:click=move |_| model.helping.set(true)>"?"</button>
            </div>
        </header>
    }
    .into_any()
}

fn take_machine(model: Model, machine: &'static dyn AnyMachine) {
    if let Some(project) = Project::of(machine.id(), None) {
        model.replace(project);
    }
}

fn machine_picker(model: Model) -> AnyView {
    let rows = machines::ALL.iter().map(|machine| {
        let machine: &'static dyn AnyMachine = *machine;
        let chosen = move || model.project.with(|project| project.machine.id() == machine.id());
        let choose = move |_| {
            if !chosen() {
                take_machine(model, machine);
            }
        };
        view! { <button type="button" aria-pressed=move || chosen().to_string() on:click=choose>{t(machine.name())}</button> }
    });
    view! { <div class="segments" role="group" aria-label=t("page.machine")>{rows.collect_view()}</div> }.into_any()
}

fn control_picker(model: Model) -> AnyView {
    let rows = move || {
        let ids = model.project.with(|project| project.machine.controls());
        let rows = ids.iter().filter_map(|id| controls::find(id)).map(|control| {
            let chosen = move || model.project.with(|project| project.control.id == control.id);
            view! { <option value=control.id prop:selected=chosen>{control.name}</option> }
        });
        rows.collect_view()
    };
    let choose = move |event| {
        if let Some(control) = controls::find(&event_target_value(&event)) {
            model.edit("", |project| project.control = control);
        }
    };
    view! { <select class="control" aria-label=t("page.control") on:change=choose>{rows}</select> }.into_any()
}

/// Takes the theme that was chosen on an earlier visit.
pub(super) fn apply_theme(theme: &str) {
    if let Some(root) = document().document_element() {
        dom::set(&root, "data-theme", theme);
    }
}

fn theme_button() -> AnyView {
    let stored = dom::stored(THEME).unwrap_or_default();
    let at = RwSignal::new_local(THEMES.iter().position(|(id, ..)| *id == stored).unwrap_or(0));
    apply_theme(THEMES[at.get_untracked()].0);
    let next = move |_| {
        at.update(|at| *at = (*at + 1) % THEMES.len());
        let theme = THEMES[at.get_untracked()].0;
        apply_theme(theme);
        dom::store(THEME, theme);
    };
    view! {
        <button type="button" class="icon" aria-label=move || t(THEMES[at.get()].2) title=move || t(THEMES[at.get()].2) on:click=next>{move || THEMES[at.get()].1}</button>
    }
    .into_any()
}

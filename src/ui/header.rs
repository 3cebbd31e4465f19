//! The header: what machine and control, which project, and what can be done with it.

use leptos::prelude::*;

use super::dom;
use super::el::{El, button, el, icon_button, value};
use super::files;
use super::local::Local;
use super::model::Model;
use super::state::Kept;
use super::words::t;
use crate::controls;
use crate::machines;
use crate::project::Project;

/// Where the choice of light and dark is kept.
const THEME: &str = "macroline.theme";

/// Themes in the order in which the button goes through them, with sign and words.
const THEMES: [(&str, &str, &str); 3] =
    [("", "◐", "page.theme-system"), ("light", "☀", "page.theme-light"), ("dark", "☾", "page.theme-dark")];

/// The header.
pub(super) fn header(model: Model) -> El {
    let named = move |event| {
        let name: String = value(&event).chars().filter(|c| !c.is_control()).take(120).collect();
        model.edit("name", |project| project.name = name);
    };
    let kept = move || match model.kept.get() {
        Kept::Yes => t("page.kept").to_owned(),
        Kept::Soon => t("page.kept-soon").to_owned(),
        Kept::No => t("page.kept-not").to_owned(),
    };
    let name = el("input.name").at("type", "text").at("maxlength", "120").at("placeholder", t("page.untitled"));
    let name = name.label(t("page.name")).valued(move || model.project.with(|project| project.name.clone()));
    let doing = el("div.doing").add(&[
        icon_button("button.icon", "↶", t("page.undo"), move || model.undo())
            .at("title", t("page.undo-key"))
            .able(move || model.can.get().0),
        icon_button("button.icon", "↷", t("page.redo"), move || model.redo())
            .at("title", t("page.redo-key"))
            .able(move || model.can.get().1),
        button("button.quiet", t("page.new"), move || files::fresh(model)),
    ]);
    let doing = doing.add(&files::open_button(model)).add(&[
        button("button.quiet", t("page.save"), move || files::save(model)).at("title", t("page.save-about")),
        button("button.primary#export", t("page.export"), move || model.exporting.set(true)),
        theme_button(),
        icon_button("button.icon", "?", t("page.help"), move || model.helping.set(true)).at("title", t("page.help")),
    ]);
    el("header.top").add(&[
        el("h1").text("macro").add(&[el("i").text("line")]),
        machine_picker(model),
        control_picker(model),
        el("div.project").add(&[
            name.on("input", named),
            el("span.kept").live(kept).mark("warn", move || model.kept.get() == Kept::No),
        ]),
        doing,
    ])
}

fn machine_picker(model: Model) -> El {
    let rows: Vec<El> = machines::ALL
        .iter()
        .map(|machine| {
            let chosen = move || model.machine.get() == machine.id();
            let choose = move || {
                if !untrack(chosen) {
                    Project::of(machine.id(), None).into_iter().for_each(|project| model.replace(project));
                }
            };
            button("button", t(machine.name()), choose).state("aria-pressed", chosen)
        })
        .collect();
    el("div.segments").at("role", "group").label(t("page.machine")).add(&rows)
}

fn control_picker(model: Model) -> El {
    let rows = move || {
        model.machine.track();
        let ids = model.project.with_untracked(|project| project.machine.controls());
        let found = ids.iter().filter_map(|id| controls::find(id));
        found.map(|control| el("option").at("value", control.id).text(control.name)).collect()
    };
    let choose = move |event| {
        if let Some(control) = controls::find(&value(&event)) {
            model.edit("", |project| project.move_to(control));
        }
    };
    let present = move || model.project.with(|project| project.control.id).to_owned();
    el("select.control").label(t("page.control")).swap(rows).valued(present).on("change", choose)
}

fn take_theme(theme: &str) {
    if let Some(root) = document().document_element() {
        dom::set(&root, "data-theme", theme);
    }
}

fn theme_button() -> El {
    let stored = dom::stored(THEME).unwrap_or_default();
    let at = Local::new(THEMES.iter().position(|(id, ..)| *id == stored).unwrap_or(0));
    let theme = move || THEMES.get(at.get()).copied().unwrap_or(THEMES[0]);
    let next = move || {
        at.update(|at| *at = (*at + 1) % THEMES.len());
        dom::store(THEME, untrack(theme).0);
    };
    let words = move || t(theme().2).to_owned();
    let button = button("button.icon", "", next).live(move || theme().1.to_owned());
    button.bind("aria-label", words).bind("title", words).run(move || take_theme(theme().0))
}

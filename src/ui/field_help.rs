//! What there is to know about one field: help, range, default, and where its value comes from.

use super::el::{El, button, el};
use super::field::shown;
use super::model::Model;
use super::words::t;
use crate::machines::form::{FieldInfo, KindInfo, Provenance};
use crate::text::catalog::number_text;

/// Where values may come from, as they are listed.
const SOURCES: [(Provenance, &str); 3] = [
    (Provenance::Assumed, "page.assumed"),
    (Provenance::DataSheet, "page.data-sheet"),
    (Provenance::Measured, "page.measured"),
];

/// The one popup of the form; the button of a field opens it and says which field.
pub(super) fn about_popup(model: Model) -> El {
    let content = move || {
        let id = model.about.get();
        let fields = model.project.with_untracked(|project| project.machine.fields());
        fields.into_iter().find(|field| Some(field.id) == id).map_or_else(Vec::new, |info| about(model, info))
    };
    el("div.popup#about").at("popover", "auto").swap(content)
}

fn about(model: Model, info: FieldInfo) -> Vec<El> {
    let id = info.id;
    let default = info.default();
    let range = match &info.kind {
        KindInfo::Number { unit, min, max, .. } => {
            format!("{} … {} {unit}", number_text(*min, 6), number_text(*max, 6))
        }
        KindInfo::Text(max) => format!("{max} {}", t("page.characters")),
        _ => String::new(),
    };
    let default_text = match &info.kind {
        KindInfo::Number { unit, .. } => format!("{} {unit}", shown(&info, &default)),
        KindInfo::Choice(options) => options.first().map_or("", |(_, label)| t(label)).to_owned(),
        KindInfo::Flag(on) => t(if *on { "page.on" } else { "page.off" }).to_owned(),
        KindInfo::Text(_) => t("page.empty").to_owned(),
    };
    let mut facts = el("dl");
    if !range.is_empty() {
        facts = facts.add(&[el("dt").text(t("page.range")), el("dd").text(&range)]);
    }
    facts = facts.add(&[el("dt").text(t("page.default")), el("dd").text(&default_text)]);
    let present = default.clone();
    let changed = move || {
        model.project.with(|project| project.values.get(id).is_some_and(|value| *value != present))
            || model.refused(id).is_some()
    };
    let reset = move || {
        model.set(id, default.clone());
        model.reread.update(|count| *count += 1);
    };
    let title = el("h3").text(t(info.label)).text(" ").add(&[el("small").text(&model.spelled(info.symbol))]);
    let mut all = vec![title, el("p").text(t(info.help)), facts];
    if info.fact {
        all.push(sources(model, id));
    }
    all.push(button("button", t("page.reset-field"), reset).able(changed));
    all
}

fn sources(model: Model, id: &'static str) -> El {
    let from = move || model.project.with(|project| project.provenance.get(id).copied().unwrap_or_default());
    let choices = SOURCES.map(|(source, label)| {
        let input = el("input").at("type", "radio").at("name", "from").checked(move || from() == source);
        let input = input.on("change", move |_| model.set_provenance(id, source));
        el("label.radio").add(&[input]).text(t(label))
    });
    el("fieldset").add(&[el("legend").text(t("page.from"))]).add(&choices)
}

//! What there is to know about one field: help, range, default, and where its value comes from.

use leptos::prelude::*;

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
pub(super) fn about_popup(model: Model) -> AnyView {
    let content = move || {
        let id = model.about.get()?;
        let fields = model.project.with_untracked(|project| project.machine.fields());
        fields.into_iter().find(|field| field.id == id).map(|info| about(model, info))
    };
    view! { <div class="popup" id="about" popover="auto">{content}</div> }.into_any()
}

fn about(model: Model, info: FieldInfo) -> AnyView {
    let id = info.id;
    let default = info.default();
    let range = match &info.kind {
        KindInfo::Number { unit, min, max, .. } => {
            Some(format!("{} … {} {unit}", number_text(*min, 6), number_text(*max, 6)))
        }
        KindInfo::Text(max) => Some(format!("{max} {}", t("page.characters"))),
        _ => None,
    };
    let default_text = match &info.kind {
        KindInfo::Number { unit, .. } => format!("{} {unit}", shown(&info, &default)),
        KindInfo::Choice(options) => options.first().map_or("", |(_, label)| t(label)).to_owned(),
        KindInfo::Flag(on) => t(if *on { "page.on" } else { "page.off" }).to_owned(),
        KindInfo::Text(_) => t("page.empty").to_owned(),
    };
    let at_default = {
        let default = default.clone();
        move || {
            model.project.with(|project| project.values.get(id).is_none_or(|value| *value == default))
                && model.invalid.with(|invalid| !invalid.contains_key(id))
        }
    };
    let reset = move |_| {
        model.set(id, default.clone());
        model.reread.update(|count| *count += 1);
    };
    let sources = info.fact.then(|| {
        let from = move || model.project.with(|project| project.provenance.get(id).copied().unwrap_or_default());
        let choices = SOURCES.map(|(source, label)| {
            view! {
                <label class="radio">
                    <input type="radio" name="from" prop:checked=move || from() == source
                        on:change=move |_| model.set_provenance(id, source) />
                    {t(label)}
                </label>
            }
        });
        view! { <fieldset><legend>{t("page.from")}</legend>{choices.into_iter().collect_view()}</fieldset> }
    });
    view! {
        <h3>{t(info.label)} {(!info.symbol.is_empty()).then(|| view! { <small>{info.symbol}</small> })}</h3>
        <p>{t(info.help)}</p>
        <dl>
            {range.map(|range| view! { <dt>{t("page.range")}</dt><dd>{range}</dd> })}
            <dt>{t("page.default")}</dt>
            <dd>{default_text}</dd>
        </dl>
        {sources}
        <button type="button" disabled=at_default on:click=reset>{t("page.reset-field")}</button>
    }
    .into_any()
}

//! The help of one field: meaning, range, default, and where its value comes from.

use leptos::prelude::*;

use super::value::{origin_of, value_of};
use crate::machines::form::{FieldInfo, FieldKindInfo, Provenance, Value};
use crate::project::Project;
use crate::ui::state::Page;
use crate::ui::words::t;

/// Sources of a value, in the order of the list.
const SOURCES: [(Provenance, &str); 3] = [
    (Provenance::Assumed, "page.assumed"),
    (Provenance::DataSheet, "page.data-sheet"),
    (Provenance::Measured, "page.measured"),
];

/// The one popover of the form; the button of a field opens it and names the field.
#[component]
pub(crate) fn FieldHelp() -> impl IntoView {
    let page = Page::here();
    let content = move || {
        let id = page.view.about.get()?;
        let fields = page.project.with_untracked(|project| project.machine.fields());
        let info = fields.into_iter().find(|field| field.id == id)?;
        Some(view! { <Content info=info /> })
    };
    view! { <div class="popup" id="about" popover="auto">{content}</div> }
}

fn range(info: &FieldInfo) -> Option<String> {
    match info.kind {
        FieldKindInfo::Text(max) => Some(format!("{max} {}", t("page.characters"))),
        _ => info.range(),
    }
}

/// The value that a new project has on the present control.
fn value_of_new(page: Page, info: &FieldInfo) -> Value {
    let new = page.project.with(|project| Project::new(project.machine, project.control));
    new.values.get(info.id).cloned().unwrap_or_else(|| info.default())
}

fn default_text(info: &FieldInfo, default: &Value) -> String {
    match (&info.kind, default) {
        (FieldKindInfo::Number { .. }, _) => info.text_with_unit(default),
        (FieldKindInfo::Choice(options), Value::Text(id)) => {
            options.iter().find(|(option, _)| option == id).map_or("", |(_, label)| t(label)).to_owned()
        }
        (_, Value::Flag(on)) => t(if *on { "page.on" } else { "page.off" }).to_owned(),
        _ => t("page.empty").to_owned(),
    }
}

#[component]
fn Content(
    /// The field's row.
    info: FieldInfo,
) -> impl IntoView {
    let page = Page::here();
    let id = info.id;
    let (default, row) = (untrack(|| value_of_new(page, &info)), info.clone());
    let default_text = default_text(&info, &default);
    let present = default.clone();
    let changed = move || value_of(page, &row) != present || page.entries.refused(id).is_some();
    let reset = move |_| page.take_value(id, default.clone());
    let row = info.clone();
    let metric = move || {
        let text = row.metric_text(&value_of(page, &row))?;
        Some(view! { <dt>{t("page.in-program")}</dt><dd>{text}</dd> })
    };
    let range = range(&info).map(|range| view! { <dt>{t("page.range")}</dt><dd>{range}</dd> });
    view! {
        <h3>{t(info.label)} " " <small>{page.spelled(info.symbol)}</small></h3>
        <p>{t(info.help)}</p>
        <dl>
            {range}
            <dt>{t("page.default")}</dt>
            <dd>{default_text}</dd>
            {metric}
        </dl>
        {info.role.is_fact().then(|| view! { <Origin id=id /> })}
        <p>
            <button type="button" class="link" on:click=move |_| page.view.explain(format!("field.{id}"))>
                {t("help.more")}
            </button>
        </p>
        <button type="button" disabled=move || !changed() on:click=reset>{t("page.reset-field")}</button>
    }
}

/// The source of a fact's value.
#[component]
fn Origin(
    /// The field.
    id: &'static str,
) -> impl IntoView {
    let page = Page::here();
    let from = move || origin_of(page, id);
    let choice = |(source, label): (Provenance, &'static str)| {
        view! {
            <label class="radio">
                <input
                    type="radio" name="from"
                    prop:checked=move || from() == source
                    on:change=move |_| page.set_provenance(id, source)
                />
                {t(label)}
            </label>
        }
    };
    view! {
        <fieldset>
            <legend>{t("page.from")}</legend>
            {SOURCES.into_iter().map(choice).collect_view()}
        </fieldset>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{InInches, ViewBench, field, mount, settled};

    async fn about(id: &'static str) -> ViewBench {
        let bench = mount(|| view! { <FieldHelp /> }).await;
        assert!(bench.text("#about").is_empty());
        bench.page.view.about.set(Some(id));
        settled().await;
        bench
    }

    #[wasm_bindgen_test]
    async fn help_has_label_purpose_range_and_default() {
        let bench = about("pitch").await;
        let text = bench.text("#about");
        for part in [t(field("pitch").label), t(field("pitch").help), "0.01 … 10000 mm", "10 mm"] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }

    #[wasm_bindgen_test]
    async fn help_in_inches_has_the_value_of_the_program() {
        assert!(!about("pitch").await.text("#about").contains(t("page.in-program")));
        let _inches = InInches::new();
        let text = about("pitch").await.text("#about");
        for part in ["0.0004 … 393.7008 in", "0.3937 in", t("page.in-program"), "8 mm"] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }

    #[wasm_bindgen_test]
    async fn reset_is_offered_only_for_another_value() {
        let bench = about("pitch").await;
        bench.page.set("pitch", Value::Number(10.0));
        settled().await;
        assert!(bench.has("button[disabled]"));
        bench.page.set("pitch", Value::Number(9.0));
        settled().await;
        bench.press_button(t("page.reset-field")).await;
        assert_eq!(bench.setting("pitch"), Some(Value::Number(10.0)));
        assert!(bench.has("button[disabled]"));
    }

    #[wasm_bindgen_test]
    async fn reset_takes_a_wrong_entry_away() {
        let bench = about("pitch").await;
        bench.page.entries.refuse("pitch", *field("pitch").read_metric("x").unwrap_err());
        settled().await;
        bench.press_button(t("page.reset-field")).await;
        assert!(!bench.page.is_stale());
    }

    #[wasm_bindgen_test]
    async fn origin_of_a_fact_is_chosen_in_its_help() {
        let bench = about("heads").await;
        assert!(bench.checked("label:nth-of-type(1) input"));
        bench.press("label:nth-of-type(3) input").await;
        let from = bench.page.project.with_untracked(|project| project.provenance.get("heads").copied());
        assert_eq!(from, Some(Provenance::Measured));
    }

    #[wasm_bindgen_test]
    async fn choice_of_the_engineer_has_no_origin() {
        assert!(!about("job").await.has("fieldset"));
    }
}

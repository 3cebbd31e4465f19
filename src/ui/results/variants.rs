//! Variants of the project: kept under a name, compared in the worker or side by side in motion, taken into the form, removed.

use std::time::Duration;

use leptos::ev::KeyboardEvent;
use leptos::prelude::*;

use crate::msg;
use crate::project::variants::variant::{MAX_VARIANT_NAME, MAX_VARIANTS, variant_name};
use crate::ui::dom;
use crate::ui::parts::followed::{Answered, Followed, follow_variants};
use crate::ui::state::Page;
use crate::ui::state::view::Compared;
use crate::ui::words::{sentence, t};
use crate::ui::worker::messages::ComparedVariants;

/// Delay after the last change before the comparison: longer than a step of a dragged number, and shorter than the delay of the sizing.
const REST: Duration = Duration::from_millis(100);

/// Id of the field with the name of the next variant.
const NAME: &str = "variant-name";

/// The variants of the project, beside the present settings.
#[component]
pub(super) fn Variants() -> impl IntoView {
    let page = Page::here();
    let names = Memo::new(move |_| {
        page.project.with(|project| project.variants.iter().map(|kept| kept.name.clone()).collect())
    });
    let compared = follow_variants(REST);
    let lead = move || {
        let no_answer = compared.answer.with(|answer| *answer == Answered::Nothing);
        match names.with(Vec::len) {
            0 => t("page.variants-lead").to_owned(),
            _ if no_answer => t("page.no-answer").to_owned(),
            MAX_VARIANTS => sentence(&msg!("page.variants-full", count = MAX_VARIANTS as u32)),
            _ => String::new(),
        }
    };
    view! {
        <section class="variants" aria-labelledby="variants-title">
            <h3 id="variants-title">{t("variants.title")}</h3>
            <p class="lead">{lead}</p>
            <NextVariant names=names />
            <Show when=move || !names.with(Vec::is_empty)>
                <ComparedTable names=names compared=compared />
            </Show>
        </section>
    }
}

/// The name of the next variant, with the button that keeps the present settings under it.
#[component]
fn NextVariant(
    /// Names of the variants.
    names: Memo<Vec<String>>,
) -> impl IntoView {
    let page = Page::here();
    // The typed name with the names for which it was typed: once these have changed, a free name takes its place.
    let typed = RwSignal::new(None::<(Vec<String>, String)>);
    let name = Memo::new(move |_| {
        let own = typed.get().filter(|(about, _)| names.with(|names| names == about)).map(|(_, name)| name);
        own.unwrap_or_else(|| page.project.with(|project| project.free_variant_name()))
    });
    let is_known = Memo::new(move |_| {
        names.with(|names| name.with(|name| variant_name(name).is_some_and(|name| names.contains(&name))))
    });
    let is_full = move || !is_known.get() && names.with(Vec::len) >= MAX_VARIANTS;
    let enter = move |event: KeyboardEvent| {
        if event.key() == "Enter" {
            keep(page, &name.get_untracked());
        }
    };
    view! {
        <div class="keep">
            <input
                id=NAME type="text" maxlength=MAX_VARIANT_NAME.to_string() autocomplete="off" aria-label=t("page.variant-name")
                prop:value=name
                on:input=move |event| typed.set(Some((names.get_untracked(), event_target_value(&event))))
                on:keydown=enter
            />
            <button type="button" disabled=is_full on:click=move |_| keep(page, &name.get_untracked())>
                {move || t(if is_known.get() { "page.variant-replace" } else { "page.variant-keep" })}
            </button>
        </div>
    }
}

/// The rows in which the present settings and the variants differ.
#[component]
fn ComparedTable(
    /// Names of the variants.
    names: Memo<Vec<String>>,
    /// The rows.
    compared: Followed<ComparedVariants>,
) -> impl IntoView {
    let columns = move || names.get().into_iter().enumerate();
    // Rows with other columns would be misread.
    let rows = move || {
        compared.answer.with(|answer| match answer {
            Answered::Of(found) if names.with(|names| *names == found.names) => found.rows.clone(),
            _ => String::new(),
        })
    };
    view! {
        <div
            class="scroll" tabindex="0" role="group" aria-labelledby="variants-title"
            aria-busy=move || compared.progress.outdated.get().to_string()
        >
            <table>
                <thead>
                    <tr>
                        <th scope="col">{t("variants.row")}</th>
                        <th scope="col">{t("variants.now")}</th>
                        <For each=columns key=Clone::clone let:variant>
                            <VariantHead at=variant.0 name=variant.1 />
                        </For>
                    </tr>
                </thead>
                <tbody inner_html=rows></tbody>
            </table>
        </div>
    }
}

/// Head of a variant's column: its name, and what can be done with it.
#[component]
fn VariantHead(
    /// Its place among the variants.
    at: usize,
    /// Its name.
    name: String,
) -> impl IntoView {
    let page = Page::here();
    let take_about = sentence(&msg!("page.variant-take-about", variant = name.as_str()));
    let compare_about = sentence(&msg!("page.variant-compare-about", variant = name.as_str()));
    let remove_about = sentence(&msg!("page.variant-remove-about", variant = name.as_str()));
    let compare = move |_| page.view.compared.set(Some(Compared::Variant(at)));
    view! {
        <th scope="col">
            <span class="name">{name}</span>
            <span class="acts">
                <button type="button" class="link take" aria-label=take_about on:click=move |_| take(page, at)>
                    {t("page.variant-take")}
                </button>
                <button type="button" class="link compare" aria-label=compare_about on:click=compare>
                    {t("projects.compare")}
                </button>
                <button type="button" class="link remove" aria-label=remove_about on:click=move |_| remove(page, at)>
                    {t("page.variant-remove")}
                </button>
            </span>
        </th>
    }
}

/// Keeps the present settings under a name.
fn keep(page: Page, name: &str) {
    let mut kept = None;
    page.edit(|project| {
        let at = project.keep_variant(name);
        kept = at.and_then(|at| project.variants.get(at)).map(|variant| variant.name.clone());
    });
    if let Some(name) = kept {
        page.notices.announce(sentence(&msg!("page.variant-kept", variant = name)));
    }
}

/// Takes a variant into the form; invalid entries are dropped.
fn take(page: Page, at: usize) {
    page.entries.invalid.set(Vec::new());
    page.edit(|project| project.take_variant(at));
    page.entries.show_again();
    page.notices.announce(t("page.taken"));
}

/// Removes a variant.
fn remove(page: Page, at: usize) {
    page.edit(|project| project.drop_variant(at));
    page.notices.announce(t("page.variant-removed"));
    // The pressed button, which had the focus, no longer exists.
    if let Some(field) = dom::by_id(NAME) {
        let _ = field.focus();
    }
}

#[cfg(test)]
mod tests {
    use leptos::wasm_bindgen::JsCast;
    use wasm_bindgen_test::wasm_bindgen_test;
    use web_sys::HtmlElement;

    use super::*;
    use crate::machines::form::Value;
    use crate::ui::testing::{ViewBench, mount, settled, until, work_here};
    use crate::ui::worker::client::Client;

    /// The section on a page whose worker is here.
    async fn section() -> ViewBench {
        mount(|| {
            work_here(Client::here());
            view! { <Variants /> }
        })
        .await
    }

    fn heads(bench: &ViewBench) -> Vec<String> {
        bench.all("thead .name").iter().map(|head| head.text_content().unwrap_or_default()).collect()
    }

    #[wasm_bindgen_test]
    async fn empty_section_of_variants_explains_their_use() {
        let bench = section().await;
        assert_eq!((bench.text(".lead").as_str(), bench.value("input").as_str()), (t("page.variants-lead"), "A"));
        assert!(!bench.has("table"));
    }

    #[wasm_bindgen_test]
    async fn typed_name_outlives_a_change_of_the_form() {
        let bench = section().await;
        bench.type_into("input", "Wide").await;
        bench.page.set("pitch", Value::Number(20.0));
        settled().await;
        assert_eq!(bench.value("input"), "Wide");
    }

    #[wasm_bindgen_test]
    async fn kept_variant_has_a_column_and_the_field_the_next_name() {
        let bench = section().await;
        bench.press_button(t("page.variant-keep")).await;
        assert_eq!((heads(&bench), bench.value("input").as_str()), (vec!["A".to_owned()], "B"));
        assert!(bench.has("table"));
        bench.type_into("input", "Wide").await;
        bench.key("input", "Enter", false).await;
        assert_eq!((heads(&bench), bench.value("input").as_str()), (vec!["A".to_owned(), "Wide".to_owned()], "B"));
        assert_eq!(bench.text(".lead"), "");
        until(|| bench.has("tbody tr")).await;
        assert_eq!(bench.text("tbody"), t("variants.same"));
    }

    #[wasm_bindgen_test]
    async fn rows_follow_the_form_and_mark_what_differs() {
        let bench = section().await;
        bench.press_button(t("page.variant-keep")).await;
        bench.page.set("pitch", Value::Number(20.0));
        settled().await;
        assert!(bench.has(".scroll[aria-busy=true]"));
        until(|| bench.has("tbody td.differs")).await;
        assert!(bench.has(".scroll[aria-busy=false]"));
        let pitch =
            bench.all("tbody tr").into_iter().find(|row| row.text_content().unwrap().starts_with("Pitch")).unwrap();
        let cells: Vec<String> =
            crate::ui::dom::all(&pitch, "td").iter().filter_map(|cell| cell.text_content()).collect();
        assert_eq!(cells, ["20", "8"]);
        assert_eq!(crate::ui::dom::all(&pitch, "td.differs").len(), 1);
    }

    #[wasm_bindgen_test]
    async fn verdict_that_does_not_hold_has_sign_and_words() {
        let bench = section().await;
        bench.press_button(t("page.variant-keep")).await;
        bench.page.set("spindle-speed", Value::Number(3000.0));
        until(|| bench.has("tbody td i.fail")).await;
        assert_eq!(bench.text("tbody td i.fail"), "✕");
        assert!(bench.text("tbody td:has(i.fail) .hidden").contains(t("page.verdict-fail")));
    }

    #[wasm_bindgen_test]
    async fn taken_variant_is_one_step_and_stays() {
        let bench = section().await;
        bench.press_button(t("page.variant-keep")).await;
        bench.page.set("pitch", Value::Number(20.0));
        bench.page.entries.refuse("heads", *crate::ui::testing::field("heads").read_metric("x").unwrap_err());
        let button: HtmlElement = bench.find(".take").unchecked_into();
        button.focus().unwrap();
        button.click();
        settled().await;
        assert_eq!(bench.setting("pitch"), Some(Value::Number(8.0)));
        assert_eq!(document().active_element().as_ref(), Some(button.as_ref()));
        assert!(!untrack(|| bench.page.is_stale()), "the wrong entry gave way");
        assert_eq!(heads(&bench), ["A"]);
        bench.page.undo();
        assert_eq!(bench.setting("pitch"), Some(Value::Number(20.0)));
    }

    #[wasm_bindgen_test]
    async fn variant_is_asked_to_be_shown_in_motion() {
        let bench = section().await;
        bench.press_button(t("page.variant-keep")).await;
        bench.press(".compare").await;
        assert!(bench.page.view.compared.with_untracked(|compared| matches!(compared, Some(Compared::Variant(0)))));
        assert_eq!(
            bench.attribute(".compare", "aria-label"),
            sentence(&msg!("page.variant-compare-about", variant = "A"))
        );
    }

    #[wasm_bindgen_test]
    async fn removed_variant_comes_back_by_undo() {
        let bench = section().await;
        bench.press_button(t("page.variant-keep")).await;
        bench.press_button(t("page.variant-keep")).await;
        let button: HtmlElement = bench.find(".remove").unchecked_into();
        button.focus().unwrap();
        button.click();
        settled().await;
        assert_eq!(heads(&bench), ["B"]);
        assert_eq!(document().active_element().unwrap().id(), NAME);
        bench.page.undo();
        settled().await;
        assert_eq!(heads(&bench), ["A", "B"]);
    }

    #[wasm_bindgen_test]
    async fn known_name_replaces_its_variant() {
        let bench = section().await;
        bench.press_button(t("page.variant-keep")).await;
        bench.page.set("pitch", Value::Number(20.0));
        bench.type_into("input", "A").await;
        bench.press_button(t("page.variant-replace")).await;
        assert_eq!(heads(&bench), ["A"]);
        let kept = bench.page.project.with_untracked(|project| project.variants[0].values["pitch"].clone());
        assert_eq!(kept, Value::Number(20.0));
    }

    #[wasm_bindgen_test]
    async fn twelve_variants_are_kept_and_no_more() {
        let bench = section().await;
        for _ in 0..MAX_VARIANTS {
            bench.press_button(t("page.variant-keep")).await;
        }
        assert!(bench.has(".keep button[disabled]"));
        assert_eq!(bench.text(".lead"), sentence(&msg!("page.variants-full", count = MAX_VARIANTS as u32)));
        bench.key("input", "Enter", false).await;
        assert_eq!(heads(&bench).len(), MAX_VARIANTS);
        bench.type_into("input", "L").await;
        assert!(!bench.has(".keep button[disabled]"), "a known one is still replaced");
    }
}

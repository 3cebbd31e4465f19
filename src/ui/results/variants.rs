//! Variants of the project: kept under a name, compared in the worker or side by side in motion, taken into the form, removed.

use std::time::Duration;

use leptos::ev::{KeyboardEvent, MouseEvent};
use leptos::prelude::*;

use crate::msg;
use crate::project::Project;
use crate::project::variants::variant::{MAX_VARIANT_NAME, MAX_VARIANTS, Variant, variant_name};
use crate::ui::dom;
use crate::ui::dom::delayed::Delayed;
use crate::ui::state::view::Compared;
use crate::ui::state::{Page, put};
use crate::ui::words::{Tone, sentence, t};
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::{Request, Response};
use crate::view::svg::escape;

/// Delay after the last change before the comparison: longer than a step of a dragged number, and shorter than the delay of the sizing.
const REST: Duration = Duration::from_millis(100);

/// Id of the field with the name of the next variant.
const NAME: &str = "variant-name";

/// The variants of the project, beside the present settings.
#[component]
pub(super) fn Variants() -> impl IntoView {
    let page = Page::here();
    let typed = RwSignal::new(String::new());
    // Head and rows of the table, and whether the rows are those before the last change of the project.
    let (head, rows, outdated) = (RwSignal::new(String::new()), RwSignal::new(String::new()), RwSignal::new(true));
    let (lead, none) = (RwSignal::new(String::new()), RwSignal::new(true));
    let ask = asking(page, head, rows, outdated);
    let delayed = Delayed::new();
    Effect::new(move |_| {
        page.project.with(|project| {
            let present = head_of(&project.variants);
            // Rows with other columns would be misread, and the text in the field belongs to the former list of names.
            if head.with_untracked(|head| *head != present) {
                put(head, present);
                put(rows, String::new());
                put(typed, project.free_variant_name());
                put(lead, lead_of(project.variants.len()));
                put(none, project.variants.is_empty());
            }
        });
        put(outdated, true);
        if none.get_untracked() {
            delayed.cancel();
        } else {
            delayed.call(ask, REST);
        }
    });
    // Whether a variant has the typed name, and whether another variant can be kept.
    let known = Signal::derive(move || typed.with(|typed| page.project.with(|project| is_known(project, typed))));
    let blocked =
        Signal::derive(move || !known.get() && page.project.with(|project| project.variants.len() >= MAX_VARIANTS));
    let enter = move |event: KeyboardEvent| {
        if event.key() == "Enter" {
            keep(page, &typed.get_untracked());
        }
    };
    view! {
        <section class="variants" aria-labelledby="variants-title" on:click=move |event| act(page, typed, &event)>
            <h3 id="variants-title">{t("variants.title")}</h3>
            <p class="lead">{lead}</p>
            <div class="keep">
                <input
                    id=NAME type="text" maxlength=MAX_VARIANT_NAME.to_string() autocomplete="off" aria-label=t("page.variant-name")
                    prop:value=typed on:input=move |event| typed.set(event_target_value(&event)) on:keydown=enter
                />
                <button type="button" data-keep="" disabled=blocked>
                    {move || t(if known.get() { "page.variant-replace" } else { "page.variant-keep" })}
                </button>
            </div>
            <div
                class="scroll" tabindex="0" role="group" aria-labelledby="variants-title"
                class:gone=none aria-busy=move || outdated.get().to_string()
            >
                <table>
                    <thead inner_html=head></thead>
                    <tbody inner_html=rows></tbody>
                </table>
            </div>
        </section>
    }
}

/// Asks the worker for the rows of the table.
fn asking(page: Page, head: RwSignal<String>, rows: RwSignal<String>, outdated: RwSignal<bool>) -> impl Fn() + Copy {
    let worker = Client::here();
    move || {
        let about = head.get_untracked();
        let show = move |response: Option<Response>| match response {
            // The columns may have changed, or the tab may have been left.
            Some(Response::Html(html)) if head.try_get_untracked() == Some(about) => {
                let _ = rows.try_set(html);
                let _ = outdated.try_set(false);
            }
            Some(_) => {}
            None => page.notices.notify(Tone::Fail, t("page.no-answer").to_owned()),
        };
        page.project.with_untracked(|project| worker.ask(project, Request::Variants, show));
    }
}

/// Sentence above the table, by the number of variants.
fn lead_of(variants: usize) -> String {
    match variants {
        0 => t("page.variants-lead").to_owned(),
        MAX_VARIANTS => sentence(&msg!("page.variants-full", count = MAX_VARIANTS as u32)),
        _ => String::new(),
    }
}

/// Whether a text is the name of a variant.
fn is_known(project: &Project, typed: &str) -> bool {
    variant_name(typed).is_some_and(|name| project.variants.iter().any(|variant| variant.name == name))
}

/// Head of the table: names, and the buttons of each variant. It depends on the names alone, so that its buttons keep the focus.
fn head_of(variants: &[Variant]) -> String {
    let mut out = "<tr>".to_owned();
    for title in ["variants.row", "variants.now"] {
        out += &format!("<th scope=\"col\">{}</th>", t(title));
    }
    for (at, Variant { name, .. }) in variants.iter().enumerate() {
        out += "<th scope=\"col\"><span class=\"name\">";
        escape(&mut out, name);
        out += "</span><span class=\"acts\">";
        let acts = [
            ("take", msg!("page.variant-take-about", variant = name.as_str()), "page.variant-take"),
            ("compare", msg!("page.variant-compare-about", variant = name.as_str()), "projects.compare"),
            ("remove", msg!("page.variant-remove-about", variant = name.as_str()), "page.variant-remove"),
        ];
        for (act, about, words) in acts {
            out += &format!("<button type=\"button\" class=\"link\" data-{act}=\"{at}\" aria-label=\"");
            escape(&mut out, &sentence(&about));
            out += &format!("\">{}</button>", t(words));
        }
        out += "</span></th>";
    }
    out + "</tr>"
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

/// Carries out the clicked button: keeps a variant under the typed name, takes one, shows one in motion beside the present settings,
/// removes one.
fn act(page: Page, typed: RwSignal<String>, event: &MouseEvent) {
    let target = dom::target(event);
    let place = |act| target.as_ref()?.get_attribute(act)?.parse::<usize>().ok();
    if target.as_ref().is_some_and(|target| target.has_attribute("data-keep")) {
        keep(page, &typed.get_untracked());
    } else if let Some(at) = place("data-take") {
        // Invalid entries of the form are dropped.
        page.entries.invalid.set(Vec::new());
        page.edit(|project| project.take_variant(at));
        page.entries.show_again();
        page.notices.announce(t("page.taken"));
    } else if let Some(at) = place("data-compare") {
        page.view.compared.set(Some(Compared::Variant(at)));
    } else if let Some(at) = place("data-remove") {
        page.edit(|project| project.drop_variant(at));
        page.notices.announce(t("page.variant-removed"));
        // The pressed button, which had the focus, no longer exists.
        if let Some(field) = dom::by_id(NAME) {
            let _ = field.focus();
        }
    }
}

#[cfg(test)]
mod tests {
    use leptos::wasm_bindgen::JsCast;
    use wasm_bindgen_test::wasm_bindgen_test;
    use web_sys::HtmlElement;

    use super::*;
    use crate::machines::form::Value;
    use crate::ui::testing::{ViewBench, mount, settled, until};
    use crate::ui::worker::documents;

    /// The section on a page whose worker is here.
    async fn section() -> ViewBench {
        mount(|| {
            Client::here().answer_here(|project, request| match request {
                Request::Variants => Some(Response::Html(documents::variants(project))),
                _ => None,
            });
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
        assert!(bench.has(".scroll.gone"));
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
        assert!(!bench.has(".scroll.gone"));
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
        let button: HtmlElement = bench.find("[data-take]").unchecked_into();
        button.focus().unwrap();
        button.click();
        settled().await;
        assert_eq!(bench.setting("pitch"), Some(Value::Number(8.0)));
        assert_eq!(document().active_element().unwrap().get_attribute("data-take").as_deref(), Some("0"));
        assert!(!untrack(|| bench.page.is_stale()), "the wrong entry gave way");
        assert_eq!(heads(&bench), ["A"]);
        bench.page.undo();
        assert_eq!(bench.setting("pitch"), Some(Value::Number(20.0)));
    }

    #[wasm_bindgen_test]
    async fn variant_is_asked_to_be_shown_in_motion() {
        let bench = section().await;
        bench.press_button(t("page.variant-keep")).await;
        bench.press("[data-compare]").await;
        assert!(bench.page.view.compared.with_untracked(|compared| matches!(compared, Some(Compared::Variant(0)))));
        assert_eq!(
            bench.attribute("[data-compare]", "aria-label"),
            sentence(&msg!("page.variant-compare-about", variant = "A"))
        );
    }

    #[wasm_bindgen_test]
    async fn removed_variant_comes_back_by_undo() {
        let bench = section().await;
        bench.press_button(t("page.variant-keep")).await;
        bench.press_button(t("page.variant-keep")).await;
        let button: HtmlElement = bench.find("[data-remove]").unchecked_into();
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

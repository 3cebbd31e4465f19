//! The form: product fields first, then the machine's data in folded groups.

mod drag;
mod field;
pub(crate) mod field_help;
mod measure_first;
mod slider;
mod value;

use leptos::prelude::*;

use crate::machines::form::{FieldInfo, Provenance};
use crate::text::number::filled;
use crate::ui::dom;
use crate::ui::parts::Later;
use crate::ui::state::{Page, put};
use crate::ui::words::{sentence, t};
use field::FormField;
use measure_first::{MeasureFirst, decisive_facts};

/// Name and fields of each folded group, in the order of the form.
fn groups(fields: &[FieldInfo]) -> Vec<(&'static str, Vec<FieldInfo>)> {
    let mut groups: Vec<(&'static str, Vec<FieldInfo>)> = Vec::new();
    for field in fields.iter().filter(|field| !field.essential) {
        match groups.iter_mut().find(|(title, _)| *title == field.group) {
            Some((_, list)) => list.push(field.clone()),
            None => groups.push((field.group, vec![field.clone()])),
        }
    }
    groups
}

/// All fields of the machine.
#[component]
pub(crate) fn Form() -> impl IntoView {
    let page = Page::here();
    let rows = move || {
        // Only another machine changes the form; other values of the same machine do not.
        page.machine.track();
        let fields = page.project.with_untracked(|project| project.machine.fields());
        let product = fields.iter().filter(|field| field.essential).cloned();
        view! {
            <fieldset class="product">
                <legend>{t("page.essentials")}</legend>
                {product.map(|info| view! { <FormField info=info /> }).collect_view()}
            </fieldset>
            <Later><MachineData fields=fields /></Later>
        }
    };
    view! {
        <section class="pane form" id="form" aria-label=t("page.inputs")>
            <form autocomplete="off" on:submit=|event| event.prevent_default()><Later>{rows}</Later></form>
            <WrongFields />
        </section>
    }
}

/// The first fields of the product, for a page with little room.
#[component]
pub(crate) fn FirstFields(
    /// Number of fields.
    count: usize,
) -> impl IntoView {
    let page = Page::here();
    let fields = page.project.with_untracked(|project| project.machine.fields());
    let hidden = page.results.hidden.get_untracked();
    let product = fields.into_iter().filter(|field| field.essential && !hidden.contains(&field.id)).take(count);
    view! {
        <form autocomplete="off" on:submit=|event| event.prevent_default()>
            <fieldset class="product first" aria-label=t("page.essentials")>
                {product.map(|info| view! { <FormField info=info /> }).collect_view()}
            </fieldset>
        </form>
    }
}

/// Everything else about the machine, folded, with the count of facts that are only assumed.
#[component]
fn MachineData(
    /// Fields of the form.
    fields: Vec<FieldInfo>,
) -> impl IntoView {
    let page = Page::here();
    let facts: Vec<&'static str> = fields.iter().filter(|field| field.role.is_fact()).map(|field| field.id).collect();
    let count = Memo::new(move |_| {
        let here: Vec<_> =
            page.results.hidden.with(|hidden| facts.iter().copied().filter(|id| !hidden.contains(id)).collect());
        let assumed = page.project.with(|project| {
            let origin = |id: &&str| project.provenance.get(*id).copied().unwrap_or_default() == Provenance::Assumed;
            here.iter().filter(|id| origin(id)).count()
        });
        (assumed, here.len())
    });
    let known = move || {
        let (assumed, all) = count.get();
        filled("#%", &[100.0 * (all - assumed) as f64 / all.max(1) as f64])
    };
    let groups = groups(&fields);
    let open = RwSignal::new(false);
    let decisive = decisive_facts();
    view! {
        <details class="data" on:toggle=move |event| put(open, dom::is_open(&event))>
            <summary>
                <b>{t("page.machine-data")}</b>
                <span class="count">{move || sentence(&crate::msg!("page.assumed-of", count = count.get().0 as f64, all = count.get().1 as f64))}</span>
                <span class="known" style:--part=known></span>
            </summary>
            <Show when=move || open.get()><MeasureFirst found=decisive /></Show>
            {groups.into_iter().map(|(title, fields)| view! { <Group title=title fields=fields /> }).collect_view()}
        </details>
        <Show when=move || !open.get()><MeasureFirst found=decisive /></Show>
    }
}

/// A group of fields, which are built when the group is first opened. Most groups are never opened, so the page appears sooner.
#[component]
fn Group(
    /// Catalog id of its name.
    title: &'static str,
    /// The fields.
    fields: Vec<FieldInfo>,
) -> impl IntoView {
    let page = Page::here();
    let ids: Vec<&'static str> = fields.iter().map(|field| field.id).collect();
    let all = ids.clone();
    let shown = move || page.results.hidden.with(|hidden| all.iter().filter(|id| !hidden.contains(id)).count());
    let own = ids.clone();
    let cause = move || page.view.causes.with(|causes| own.iter().any(|id| causes.contains(id)));
    let within = ids.clone();
    let changed = move || within.iter().any(|id| page.marks.has(id));
    let holds = ids.join(" ");
    let wrong = move || page.wrong_fields().iter().any(|d| d.field.is_some_and(|field| ids.contains(&field)));
    let wrong = Memo::new(move |_| wrong());
    let opened = RwSignal::new(false);
    let rows = move || fields.iter().cloned().map(|info| view! { <FormField info=info /> }).collect_view();
    view! {
        <details
            class="group" class:wrong=wrong class:cause=cause class:changed=changed data-fields=holds
            on:toggle=move |event| if dom::is_open(&event) { put(opened, true) }
        >
            <summary>{t(title)}<span class="count">{shown}</span></summary>
            {move || opened.get().then(&rows)}
        </details>
    }
}

/// Count of the wrong fields, some of which may be out of sight; a click leads to the next one.
#[component]
fn WrongFields() -> impl IntoView {
    let page = Page::here();
    let count = Memo::new(move |_| page.wrong_fields().iter().filter(|found| found.field.is_some()).count());
    let words = move || {
        if page.is_stale() {
            t("page.stale").to_owned()
        } else {
            sentence(&crate::msg!("page.refused-values", count = count.get() as u32))
        }
    };
    view! {
        <p class="stale" class:shown=move || { count.get() > 0 }>
            {words} " "
            <button type="button" class="link" on:click=move |_| page.show_wrong_field()>
                {move || if count.get() > 1 { t("page.go-to-next-field") } else { t("page.go-to-field") }}
            </button>
        </p>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, mount, settled, until};

    async fn form() -> ViewBench {
        mount(|| view! { <Form /> }).await
    }

    #[wasm_bindgen_test]
    async fn product_fields_are_before_the_folded_groups() {
        let bench = form().await;
        let fields = crate::ui::testing::project().machine.fields();
        let essential = fields.iter().filter(|field| field.essential).count();
        assert_eq!(bench.all(".product .field").len(), essential);
        assert_eq!(bench.all("details.group").len(), groups(&fields).len());
        assert!(!bench.has("details[open]"));
        assert!(!bench.has(".data .field"), "fields that nobody looks at are built");
        for group in bench.all("details.group") {
            unfold(&group);
        }
        settled().await;
        assert_eq!(bench.all(".data .field").len(), fields.len() - essential);
    }

    fn unfold(group: &web_sys::Element) {
        group.set_attribute("open", "").unwrap();
        group.dispatch_event(&web_sys::Event::new("toggle").unwrap()).unwrap();
    }

    /// The form with the group of a field unfolded, so that its fields are there, and folded again.
    async fn form_with(field: &str) -> ViewBench {
        let bench = form().await;
        let group = bench.find(&format!("[data-fields~='{field}']"));
        unfold(&group);
        settled().await;
        group.remove_attribute("open").unwrap();
        bench
    }

    #[wasm_bindgen_test]
    async fn field_of_a_group_that_was_never_open_is_gone_to() {
        let bench = form().await;
        assert!(!bench.has("#clamp-x"));
        dom::go_to_field("clamp-x");
        until(|| document().active_element().is_some_and(|field| field.id() == "clamp-x")).await;
        assert_eq!((bench.all(".group[open]").len(), bench.has(".data[open]")), (1, true));
    }

    #[wasm_bindgen_test]
    async fn assumed_facts_are_counted() {
        let bench = form().await;
        let fields = crate::ui::testing::project().machine.fields();
        let hidden = bench.page.results.hidden.get_untracked();
        let all = fields.iter().filter(|field| field.role.is_fact() && !hidden.contains(&field.id)).count() as f64;
        let count = |assumed: f64| sentence(&crate::msg!("page.assumed-of", count = assumed, all));
        assert_eq!(
            (bench.text(".data > summary .count"), bench.style(".known", "--part")),
            (count(all), "0%".to_owned())
        );
        bench.page.set_provenance("heads", Provenance::Measured);
        settled().await;
        assert_eq!(bench.text(".data > summary .count"), count(all - 1.0));
        assert_ne!(bench.style(".known", "--part"), "0%");
    }

    #[wasm_bindgen_test]
    async fn wrong_field_in_a_folded_group_is_pointed_at() {
        let bench = form_with("clamp-x").await;
        assert!(!bench.has(".stale.shown") && !bench.has(".group.wrong"));
        bench.type_into("#clamp-x", "x").await;
        assert!(bench.has(".stale.shown"));
        assert_eq!(bench.all(".group.wrong").len(), 1);
        bench.press(".stale .link").await;
        assert_eq!(document().active_element().unwrap().id(), "clamp-x");
        assert!(bench.has(".group.wrong[open]"));
    }

    #[wasm_bindgen_test]
    async fn group_of_a_field_changed_elsewhere_is_marked() {
        let bench = form().await;
        bench.page.take_entries(&[crate::view::FieldEntry::new("clamp-x", "12000")]);
        settled().await;
        assert_eq!(bench.all(".group.changed").len(), 1);
        assert!(bench.has(".group.changed[data-fields~='clamp-x']"));
    }

    #[wasm_bindgen_test]
    async fn several_wrong_fields_are_visited_by_turns() {
        let bench = form_with("clamp-x").await;
        bench.type_into("#clamp-x", "x").await;
        bench.type_into("#pitch", "x").await;
        for field in ["clamp-x", "pitch", "clamp-x"] {
            bench.press_button(t("page.go-to-next-field")).await;
            assert_eq!(document().active_element().unwrap().id(), field);
        }
    }

    #[wasm_bindgen_test]
    async fn impossible_value_is_counted_and_has_results_of_its_own() {
        let bench = form().await;
        bench.type_into("#press-roller-diameter", "150").await;
        assert!(bench.text(".stale.shown").contains(&sentence(&crate::msg!("page.refused-values", count = 2_u32))));
        assert!(!untrack(|| bench.page.is_stale()));
    }

    #[wasm_bindgen_test]
    async fn another_machine_has_another_form() {
        let bench = form().await;
        bench.page.change_machine(crate::machines::ALL[1].id());
        settled().await;
        assert!(!bench.has("#pitch"));
        assert!(!bench.all(".product .field").is_empty());
    }
}

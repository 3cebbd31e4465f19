//! The control's variables at the play head, to be set as on its screen.

use leptos::html;
use leptos::prelude::*;

use crate::motion::Action;
use crate::ui::parts::input::number as read_number;
use crate::ui::state::Page;
use crate::ui::state::operator::act;
use crate::ui::words::{Tone, t, value_of};

/// The variables tab.
#[component]
pub(crate) fn VariablesTab() -> impl IntoView {
    let page = Page::here();
    let heads = ["page.variable", "page.value", "page.unit", "page.meaning"];
    let heads = heads.map(|id| view! { <th scope="col">{t(id)}</th> }).into_iter().collect_view();
    view! {
        <p class="lead">{t("page.variables-lead")}</p>
        <table class="variables">
            <thead><tr>{heads}</tr></thead>
            <tbody>
                <For
                    each=move || {
                        page.control.track();
                        page.results.variables.get()
                    }
                    key=move |row| (*row, page.control.get_untracked())
                    let:row
                >
                    <Row number=row.number meaning=row.label unit=row.unit />
                </For>
            </tbody>
        </table>
    }
}

/// A variable.
#[component]
fn Row(
    /// Number of the variable.
    number: u32,
    /// Catalog id of its meaning.
    meaning: &'static str,
    /// Unit of the variable.
    unit: &'static str,
) -> impl IntoView {
    let page = Page::here();
    let control = page.project.with_untracked(|project| project.control);
    let name = control.variable(number);
    let input: NodeRef<html::Input> = NodeRef::new();
    let shown = Memo::new(move |_| page.player.variable(control, number));
    // Two animations by turns make the row flash at each change but the first.
    let flash = RwSignal::new("");
    Effect::new(move |last: Option<Option<f64>>| {
        let (value, _) = shown.get();
        if let Some(input) = input.get().filter(|_| last != Some(value)) {
            input.set_value(&value_of(control, value, 6));
            if last.is_some() {
                flash.update(|flash| *flash = if *flash == "flash-a" { "flash-b" } else { "flash-a" });
            }
        }
        value
    });
    let set = move |event: web_sys::Event| {
        let typed = event_target_value(&event);
        match read_number(&event) {
            None if !typed.trim().is_empty() => page.notices.notify(Tone::Warn, t("page.not-a-value").to_owned()),
            None if !control.has_vacant() => act(page, Action::Variable(number, Some(0.0))),
            set => act(page, Action::Variable(number, set)),
        }
    };
    let changed = move || shown.get().1.then_some("");
    view! {
        <tr class=flash data-changed=changed>
            <th scope="row" data-means="program">{name.clone()}</th>
            <td>
                <input data-means="program" data-word=name.clone() node_ref=input type="text" inputmode="decimal" autocomplete="off" aria-label=name on:change=set />
            </td>
            <td>{unit}</td>
            <td>{t(meaning)}</td>
        </tr>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, mount};

    async fn variables() -> ViewBench {
        let bench = mount(|| view! { <VariablesTab /> }).await;
        bench.run().await;
        bench
    }

    #[wasm_bindgen_test]
    async fn every_variable_has_name_value_unit_and_meaning() {
        let bench = variables().await;
        let (rows, control) =
            (bench.page.results.variables.get_untracked(), bench.page.project.with_untracked(|p| p.control));
        let names: Vec<String> = bench.all("tbody th").iter().filter_map(|name| name.text_content()).collect();
        assert_eq!(names, rows.iter().map(|row| control.variable(row.number)).collect::<Vec<_>>());
        assert_eq!(bench.attribute("tbody input", "aria-label"), names[0]);
        assert_eq!(bench.text("tbody tr td:last-child"), t(rows[0].label));
    }

    #[wasm_bindgen_test]
    async fn value_is_that_of_the_head() {
        let bench = variables().await;
        bench.seek(3.5).await;
        let number = bench.page.results.variables.get_untracked()[0].number;
        let control = bench.page.project.with_untracked(|project| project.control);
        let (value, _) = untrack(|| bench.page.player.variable(control, number));
        assert_eq!(bench.value("tbody input"), value_of(control, value, 6));
    }

    #[wasm_bindgen_test]
    async fn typed_value_is_an_action_of_the_operator() {
        let bench = variables().await;
        let number = bench.page.results.variables.get_untracked()[0].number;
        bench.choose("tbody input", "12,5").await;
        assert_eq!(bench.actions(), [Action::Variable(number, Some(12.5))]);
    }

    #[wasm_bindgen_test]
    async fn text_that_is_no_number_is_refused() {
        let bench = variables().await;
        bench.choose("tbody input", "many").await;
        assert_eq!(bench.notices(), [t("page.not-a-value")]);
        assert!(bench.actions().is_empty());
    }
}

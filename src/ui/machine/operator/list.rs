//! The operator's actions as a list: adding one at the play head, editing rows, saving and opening files.

use leptos::ev::KeyboardEvent;
use leptos::prelude::*;

use super::rows::{KIND, ROW, Row, RowList, title};
use crate::motion::Action;
use crate::msg;
use crate::project::operator::{ActionGroup, available};
use crate::project::saved::panel_to_json;
use crate::ui::dom;
use crate::ui::state::Page;
use crate::ui::state::operator::{add, clear};
use crate::ui::words::{clock, sentence, t};

/// The list.
#[component]
pub(super) fn OperatorList() -> impl IntoView {
    let page = Page::here();
    let list = RowList::new(page);
    Effect::new(move |_| {
        if let Some(at) = page.view.action.get().filter(|_| list.scroller.get().is_some()) {
            page.view.action.set(None);
            list.focus(at, "time");
        }
    });
    let built = move || list.built();
    let above = move || format!("{}px", built().0 as f64 * ROW);
    let below = move || format!("{}px", (list.count.get() - built().1) as f64 * ROW);
    let keys = move |event: KeyboardEvent| {
        if event.key() == "Escape" {
            page.view.actions.set(false);
            let _ = dom::by_id("panel-list").map(|button| button.focus());
        }
    };
    let empty = move || list.count.get() == 0;
    view! {
        <section class="operator-list" aria-labelledby="operator-list-title" on:keydown=keys>
            <h3 id="operator-list-title" class="hidden">{t("operator.list")}</h3>
            <AddAction list=list />
            <div class="rows" node_ref=list.scroller on:scroll=move |_| list.scrolled()>
                <p class="lead" class:gone=move || !empty()>{t("operator.none")}</p>
                <ol style:padding-top=above style:padding-bottom=below class:gone=empty>
                    <For each=move || built().0..built().1 key=|at| *at let:at>
                        <Row at=at list=list />
                    </For>
                </ol>
            </div>
            <p class="told" id="operator-list-reason" role="status">{move || list.reason()}</p>
            <Files list=list />
        </section>
    }
}

/// The choice of an action, and the button that adds it at the play head.
#[component]
fn AddAction(list: RowList) -> impl IntoView {
    let page = list.page;
    let groups = Memo::new(move |_| page.project.with(available));
    let chosen = RwSignal::new(0_usize);
    Effect::new(move |_| {
        groups.track();
        chosen.set(0);
    });
    let options = move || {
        let mut at = 0;
        let group = |group: ActionGroup| {
            let option = |action: Action| {
                let own = at;
                at += 1;
                let words = page.project.with_untracked(|project| title(&action, project));
                view! { <option value=own.to_string() prop:selected=move || chosen.get() == own>{words}</option> }
            };
            let options = group.actions.into_iter().map(option).collect_view();
            view! { <optgroup label=t(group.name)>{options}</optgroup> }
        };
        groups.get().into_iter().map(group).collect_view()
    };
    let press = move |_| {
        let nth = |groups: &Vec<ActionGroup>| {
            groups.iter().flat_map(|group| &group.actions).nth(chosen.get_untracked()).cloned()
        };
        let Some(action) = groups.with_untracked(nth) else { return };
        // A variable starts with its present value.
        let action = match action {
            Action::Variable(number, _) => {
                let control = page.project.with_untracked(|project| project.control);
                Action::Variable(number, untrack(|| page.player.variable(control, number)).0)
            }
            action => action,
        };
        let column = if action.value().is_some() { "value" } else { "time" };
        list.focus(add(page, page.player.now.with_untracked(|now| now.t), action), column);
    };
    let when = move || sentence(&msg!("operator.add", time = clock(page.player.now.with(|now| now.t))));
    view! {
        <div class="add">
            <select id=KIND aria-label=t("operator.to-add") on:change=move |event| chosen.set(event_target_value(&event).parse().unwrap_or_default())>
                {options}
            </select>
            <button type="button" on:click=press>{when}</button>
        </div>
    }
}

/// Saving and opening files of actions, and removing all of them.
#[component]
fn Files(list: RowList) -> impl IntoView {
    let page = list.page;
    let save = move |_| {
        let (name, text) =
            page.project.with_untracked(|project| (project.file_name("panel.json"), panel_to_json(&project.panel)));
        dom::download(&name, "application/json", text.as_bytes());
    };
    // The page opens files of any kind in one place.
    let open = move |_| {
        if let Some(input) = dom::by_id("open") {
            input.click();
        }
    };
    let none = move || list.count.get() == 0;
    let all = move |_| {
        clear(page);
        list.focus_choice();
    };
    view! {
        <div class="files">
            <button type="button" class="quiet" title=t("operator.save-about") disabled=none on:click=save>{t("page.save")}</button>
            <button type="button" class="quiet" title=t("operator.open-about") on:click=open>{t("page.open")}</button>
            <span class="space"></span>
            <button type="button" class="quiet clear" disabled=none on:click=all>{t("page.clear-hand")}</button>
        </div>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::machines::MachineVariable;
    use crate::motion::Event;
    use crate::ui::machine::operator::rows::tests::{events, list, place, three};

    #[wasm_bindgen_test]
    async fn action_is_added_at_the_play_head() {
        let bench = three().await;
        bench.run().await;
        bench.seek(3.123_456).await;
        assert!(bench.has("optgroup") && bench.all("option").len() > 10);
        let values: Vec<String> = bench.all("option").iter().filter_map(|option| option.text_content()).collect();
        let reset = values.iter().position(|words| words == t("page.reset")).unwrap();
        bench.choose(&format!("#{KIND}"), &reset.to_string()).await;
        bench.press_button(&sentence(&msg!("operator.add", time = clock(3.1234)))).await;
        assert_eq!(events(&bench)[1], Event { t: 3.1234, action: Action::Reset });
        assert_eq!(place(), Some((1, "time".to_owned())));
        bench.page.undo();
        assert_eq!(events(&bench).len(), 3);
    }

    #[wasm_bindgen_test]
    async fn added_variable_begins_with_its_present_value() {
        let bench = list([]).await;
        bench.run().await;
        bench.seek(2.0).await;
        let MachineVariable { number, label, .. } = bench.page.results.variables.get_untracked()[0];
        let control = bench.page.project.with_untracked(|project| project.control);
        let words = format!("{} {}", control.variable(number), t(label));
        let at = bench.all("option").iter().position(|option| option.text_content() == Some(words.clone())).unwrap();
        bench.choose(&format!("#{KIND}"), &at.to_string()).await;
        let present = untrack(|| bench.page.player.variable(control, number)).0;
        bench.press(".add button").await;
        assert_eq!(bench.actions(), [Action::Variable(number, present)]);
        assert_eq!((place(), bench.text(".what")), (Some((0, "value".to_owned())), words));
    }

    #[wasm_bindgen_test]
    async fn all_actions_are_removed_in_one_step() {
        let bench = three().await;
        bench.press(".clear").await;
        assert!(events(&bench).is_empty() && bench.has(".clear[disabled]"));
        bench.page.undo();
        assert_eq!(events(&bench).len(), 3);
    }

    #[wasm_bindgen_test]
    async fn escape_goes_back_to_the_knobs() {
        let bench = three().await;
        bench.page.view.toggle_actions();
        assert!(bench.page.view.actions.get_untracked());
        bench.key("#action-kind", "Escape", false).await;
        assert!(!bench.page.view.actions.get_untracked() && bench.page.view.panel.get_untracked());
    }
}

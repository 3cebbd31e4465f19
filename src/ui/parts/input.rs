//! Inputs: the value of an event, and a slider that shows how far it is.

use leptos::ev;
use leptos::prelude::*;
use web_sys::Event;

use crate::math;
use crate::text::number::{filled, read};

/// The number in the input of an event.
pub(crate) fn number(event: &Event) -> Option<f64> {
    read(&event_target_value(event).replace(['\u{202f}', ' '], ""))
}

/// The filled part of a slider, in percent.
pub(crate) fn filled_part(value: f64, (low, high): (f64, f64)) -> String {
    let part = if high > low { (value - low) / (high - low) } else { 0.0 };
    filled("#%", &[math::clamp(part, 0.0, 1.0) * 100.0])
}

/// A field that passes its text on at Enter, and is cleared if the text was accepted.
#[component]
pub(crate) fn EntryField(
    /// Placeholder and accessible name.
    #[prop(into)]
    words: Signal<String>,
    /// Handles the text; returns whether it was accepted.
    #[prop(into)]
    take: Callback<String, bool>,
) -> impl IntoView {
    let enter = move |event: ev::KeyboardEvent| {
        let text = event_target_value(&event).trim().to_owned();
        if event.key() == "Enter" && !text.is_empty() && take.run(text) {
            event_target::<web_sys::HtmlInputElement>(&event).set_value("");
        }
    };
    view! { <input type="text" placeholder=words aria-label=words on:keydown=enter /> }
}

/// A check mark followed by words.
#[component]
pub(crate) fn CheckMark(
    /// The words.
    #[prop(into)]
    label: Signal<String>,
    /// Whether the box is checked.
    #[prop(into)]
    on: Signal<bool>,
    /// Takes the new state.
    #[prop(into)]
    set: Callback<bool>,
) -> impl IntoView {
    view! {
        <label class="check">
            <input type="checkbox" prop:checked=on on:change=move |event| set.run(event_target_checked(&event)) />
            {label}
        </label>
    }
}

/// A list to choose from. Further attributes are those of its element.
#[component]
pub(crate) fn Choice(
    /// Value and words of each option.
    #[prop(into)]
    options: Signal<Vec<(String, String)>>,
    /// The chosen value.
    #[prop(into)]
    chosen: Signal<String>,
    /// Takes another value.
    #[prop(into)]
    choose: Callback<String>,
) -> impl IntoView {
    // Each option follows the choice: a value of the list itself would be set before it has options.
    let option = move |(value, words): (String, String)| {
        let own = value.clone();
        view! { <option value=value prop:selected=move || chosen.with(|chosen| *chosen == own)>{words}</option> }
    };
    view! {
        <select on:change=move |event| choose.run(event_target_value(&event))>
            <For each=move || options.get() key=|row| row.clone() children=option />
        </select>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, mount, settled};

    async fn entry(taken: RwSignal<Vec<String>>, takes: bool) -> ViewBench {
        let take = move |text| {
            taken.update(|list| list.push(text));
            takes
        };
        mount(move || view! { <EntryField words="Watch" take=take /> }).await
    }

    #[wasm_bindgen_test]
    async fn entry_is_taken_at_enter_and_the_field_is_empty() {
        let taken = RwSignal::new(Vec::new());
        let bench = entry(taken, true).await;
        bench.type_into("input", "  #101 ").await;
        assert!(taken.with_untracked(Vec::is_empty));
        bench.key("input", "Enter", false).await;
        assert_eq!((taken.get_untracked(), bench.value("input")), (vec!["#101".to_owned()], String::new()));
    }

    #[wasm_bindgen_test]
    async fn refused_entry_stays_in_the_field() {
        let taken = RwSignal::new(Vec::new());
        let bench = entry(taken, false).await;
        bench.type_into("input", "#1 LT").await;
        bench.key("input", "Enter", false).await;
        assert_eq!((taken.with_untracked(Vec::len), bench.value("input").as_str()), (1, "#1 LT"));
    }

    #[wasm_bindgen_test]
    async fn empty_entry_is_not_taken() {
        let taken = RwSignal::new(Vec::new());
        let bench = entry(taken, true).await;
        bench.type_into("input", "   ").await;
        bench.key("input", "Enter", false).await;
        assert!(taken.with_untracked(Vec::is_empty));
        assert_eq!(bench.attribute("input", "aria-label"), "Watch");
    }

    #[wasm_bindgen_test]
    async fn check_mark_shows_and_sets_its_state() {
        let on = RwSignal::new(true);
        let bench = mount(move || view! { <CheckMark label="Follow" on=on set=move |new| on.set(new) /> }).await;
        assert_eq!(bench.text("label"), "Follow");
        assert!(bench.checked("input"));
        bench.press("label").await;
        assert!(!on.get_untracked() && !bench.checked("input"));
    }

    fn options(ids: &[&str]) -> Vec<(String, String)> {
        ids.iter().map(|id| ((*id).to_owned(), id.to_uppercase())).collect()
    }

    #[wasm_bindgen_test]
    async fn list_begins_with_the_chosen_value() {
        let bench = mount(|| view! { <Choice options=options(&["a", "b"]) chosen="b" choose=|_| () /> }).await;
        assert_eq!((bench.value("select").as_str(), bench.text("option").as_str()), ("b", "A"));
    }

    #[wasm_bindgen_test]
    async fn list_hands_out_the_new_choice() {
        let chosen = RwSignal::new("a".to_owned());
        let bench = mount(
            move || view! { <Choice options=options(&["a", "b"]) chosen=chosen choose=move |id| chosen.set(id) /> },
        )
        .await;
        bench.choose("select", "b").await;
        assert_eq!(chosen.get_untracked(), "b");
        chosen.set("a".to_owned());
        settled().await;
        assert_eq!(bench.value("select"), "a");
    }

    #[wasm_bindgen_test]
    async fn choice_stays_when_the_options_are_replaced() {
        let list = RwSignal::new(options(&["a", "b"]));
        let bench = mount(move || view! { <Choice options=list chosen="b" choose=|_| () /> }).await;
        list.set(options(&["c", "b", "d"]));
        settled().await;
        assert_eq!((bench.all("option").len(), bench.value("select").as_str()), (3, "b"));
    }

    #[wasm_bindgen_test]
    fn filled_part_stays_within_the_slider() {
        assert_eq!([5.0, 20.0, -1.0].map(|value| filled_part(value, (0.0, 10.0))), ["50%", "100%", "0%"]);
        assert_eq!(filled_part(1.0, (1.0, 1.0)), "0%");
    }
}

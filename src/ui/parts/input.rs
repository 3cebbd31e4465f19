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

/// A field that hands out its text at Enter, and is then empty again if the text was taken.
#[component]
pub(crate) fn EntryField(
    /// What to type.
    #[prop(into)]
    words: Signal<String>,
    /// Takes the text; whether it did.
    take: impl Fn(String) -> bool + 'static,
) -> impl IntoView {
    let enter = move |event: ev::KeyboardEvent| {
        let text = event_target_value(&event).trim().to_owned();
        if event.key() == "Enter" && !text.is_empty() && take(text) {
            event_target::<web_sys::HtmlInputElement>(&event).set_value("");
        }
    };
    view! { <input type="text" placeholder=words aria-label=words on:keydown=enter /> }
}

/// A check mark with words behind it.
#[component]
pub(crate) fn CheckMark(
    /// The words.
    #[prop(into)]
    label: Signal<String>,
    /// Whether it is set.
    #[prop(into)]
    on: Signal<bool>,
    /// Takes the new state.
    set: impl Fn(bool) + 'static,
) -> impl IntoView {
    view! {
        <label class="check">
            <input type="checkbox" prop:checked=on on:change=move |event| set(event_target_checked(&event)) />
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
    choose: impl Fn(String) + 'static,
) -> impl IntoView {
    // Each option follows the choice: a value of the list itself would be set before it has options.
    let option = move |(value, words): (String, String)| {
        let own = value.clone();
        view! { <option value=value prop:selected=move || chosen.with(|chosen| *chosen == own)>{words}</option> }
    };
    view! {
        <select on:change=move |event| choose(event_target_value(&event))>
            <For each=move || options.get() key=|row| row.clone() children=option />
        </select>
    }
}

//! One field of the form: the entry stays as typed, and the project gets it if it is a valid value.

use std::sync::Arc;

use leptos::ev::KeyboardEvent;
use leptos::html;
use leptos::prelude::*;

use super::drag::Drag;
use super::slider::Slider;
use super::value::{origin_of, value_of};
use crate::machines::form::{FieldInfo, FieldKindInfo, Provenance, Value};
use crate::math;
use crate::text::{headed, number, units};
use crate::ui::dom;
use crate::ui::parts::input::Choice;
use crate::ui::state::{Page, of_field};
use crate::ui::words::{sentence_with_hints, t};

/// A field with label, unit, error, help and the origin of its value; a product field also with a slider.
#[component]
pub(super) fn FormField(
    /// Row of the field in the form.
    info: FieldInfo,
) -> impl IntoView {
    let page = Page::here();
    let id = info.id;
    let wrong = Memo::new(move |_| {
        if let Some(problem) = page.entries.refused(id) {
            return sentence_with_hints(&problem);
        }
        page.results.errors.with(|errors| of_field(errors, id).map(sentence_with_hints).unwrap_or_default())
    });
    let is_wrong = Signal::derive(move || !wrong.with(String::is_empty));
    let unit = info.unit();
    let class = match &info.kind {
        FieldKindInfo::Number { .. } => "field",
        FieldKindInfo::Flag(_) => "field flag",
        FieldKindInfo::Choice(_) | FieldKindInfo::Text(_) => "field wide",
    };
    let from = move || match origin_of(page, id) {
        Provenance::Measured => "measured",
        Provenance::DataSheet => "data-sheet",
        Provenance::Assumed => "",
    };
    let info = Arc::new(info);
    let slides = info.essential && matches!(info.kind, FieldKindInfo::Number { .. });
    let slider = slides.then(|| view! { <Slider info=Arc::clone(&info) /> });
    let symbol = info.symbol;
    let drags = matches!(info.kind, FieldKindInfo::Number { .. });
    let drag = Drag::new(&info);
    let [pressed, held, pulled, released, cancelled, clicked] = core::array::from_fn(|_| drag.clone());
    view! {
        <div
            class=class
            class:drags=drags
            class:slides=slides
            class:cause=move || page.view.causes.with(|causes| causes.contains(&id))
            class:changed=move || page.marks.has(id)
            on:pointerdown=move |event| pressed.press(&event)
            on:mousedown=move |event| held.press_mouse(&event)
            on:pointermove=move |event| pulled.pull(&event)
            on:pointerup=move |event| released.release(&event)
            on:pointercancel=move |event| cancelled.release(&event)
            on:click=move |event| clicked.click(&event)
            class:absent=move || page.results.hidden.with(|hidden| hidden.contains(&id))
            class:wrong=is_wrong
        >
            <label for=id>
                {t(info.label)} " "
                {(!symbol.is_empty()).then(|| view! { <small>{move || page.spelled(symbol)}</small> })}
            </label>
            {slider}
            <span class="entry">
                <Input info=Arc::clone(&info) wrong=is_wrong />
                <span class="unit">{unit}</span>
                <button
                    type="button"
                    class="about"
                    popovertarget="about"
                    tabindex="-1"
                    aria-label=headed(t("page.about"), t(info.label))
                    data-from=from
                    on:click=move |_| page.view.about.set(Some(id))
                >
                    "?"
                </button>
            </span>
            <p class="note" id=format!("{id}-note")>{wrong}</p>
        </div>
    }
}

/// The input of a field, by its kind.
#[component]
fn Input(
    /// The field's row.
    info: Arc<FieldInfo>,
    /// Whether the entry is wrong.
    wrong: Signal<bool>,
) -> impl IntoView {
    let page = Page::here();
    let id = info.id;
    let note = format!("{id}-note");
    let invalid = move || wrong.get().to_string();
    match &info.kind {
        FieldKindInfo::Number { .. } | FieldKindInfo::Text(_) => {
            view! { <TypedInput info=info wrong=wrong /> }.into_any()
        }
        FieldKindInfo::Flag(_) => {
            let on = move || value_of(page, &info) == Value::Flag(true);
            view! {
                <input
                    id=id type="checkbox" class="switch" aria-describedby=note aria-invalid=invalid
                    prop:checked=on
                    on:change=move |event| page.set(id, Value::Flag(event_target_checked(&event)))
                />
            }
            .into_any()
        }
        FieldKindInfo::Choice(options) => {
            let options: Vec<_> = options.iter().map(|(one, label)| ((*one).to_owned(), t(label).to_owned())).collect();
            let chosen = move || if let Value::Text(text) = value_of(page, &info) { text } else { String::new() };
            view! {
                <Choice
                    attr:id=id attr:aria-describedby=note attr:aria-invalid=invalid
                    options=Signal::stored(options) chosen=Signal::derive(chosen)
                    choose=move |value| page.set(id, Value::Text(value))
                />
            }
            .into_any()
        }
    }
}

/// Text input that is read at every key, and not rewritten while it means the project's value.
#[component]
fn TypedInput(
    /// The field's row.
    info: Arc<FieldInfo>,
    /// Whether the entry is wrong.
    wrong: Signal<bool>,
) -> impl IntoView {
    let page = Page::here();
    let id = info.id;
    let numeric = matches!(info.kind, FieldKindInfo::Number { .. });
    let input: NodeRef<html::Input> = NodeRef::new();
    let row = Arc::clone(&info);
    Effect::new(move |last: Option<u32>| {
        let (value, reread) = (value_of(page, &row), page.entries.reread.get());
        let Some(input) = input.get() else { return reread };
        // Text with the same value stays: `1,5` is not rewritten into 1.5.
        let same = row.read_displayed(&input.value()).is_ok_and(|typed| typed == value);
        let forced = last != Some(reread);
        let kept = untrack(|| page.entries.refused(id)).is_some() && !forced;
        if !same && !kept {
            input.set_value(&row.text(&value));
        }
        reread
    });
    // The value before this entry, restored if the entry begins as a number and turns out to be none (`12e2`).
    let before: StoredValue<Option<Value>> = StoredValue::new(None);
    let valued = Arc::clone(&info);
    let enter = move || before.set_value(Some(untrack(|| value_of(page, &valued))));
    let (entered, whole) = (enter.clone(), Arc::clone(&info));
    // A finished entry with a unit of its own is shown in the field's: `4.5 in` as 114.3.
    let finish = move || {
        entered();
        let Some(input) = input.get() else { return };
        if let Ok(value) = whole.read_displayed(&input.value())
            && number::read(&input.value()).is_none()
        {
            input.set_value(&whole.text(&value));
        }
    };
    let reader = Arc::clone(&info);
    let take = move |typed: &str| {
        dom::mark("input");
        match reader.read_displayed(typed) {
            Ok(value) => page.set(id, value),
            Err(problem) => {
                if let Some(before) = before.get_value() {
                    page.set_below_text(id, before);
                }
                page.entries.refuse(id, *problem);
            }
        }
    };
    let taken = take.clone();
    let (undone, kept) = (take.clone(), Arc::clone(&info));
    // Brings the value before this entry back; an entry that has not changed leaves the key to others.
    let undo_entry = move |event: &KeyboardEvent| {
        let (Some(before), Some(input)) = (before.get_value(), input.get()) else { return };
        if kept.read_displayed(&input.value()).is_ok_and(|typed| typed == before) {
            return;
        }
        event.stop_propagation();
        let text = kept.text(&before);
        input.set_value(&text);
        undone(&text);
    };
    let step = move |event: KeyboardEvent| {
        let direction = match event.key().as_str() {
            "ArrowUp" => 1.0,
            "ArrowDown" => -1.0,
            "Escape" => return undo_entry(&event),
            _ => return,
        };
        let (FieldKindInfo::Number { unit, step, min, max, .. }, Some(input)) = (&info.kind, input.get()) else {
            return;
        };
        event.prevent_default();
        let scale = if event.shift_key() { 10.0 } else { 1.0 };
        let present = info.read_displayed(&input.value()).unwrap_or_else(|_| untrack(|| value_of(page, &info)));
        let Value::Number(from) = present else { return };
        let stepped =
            info.from_displayed(info.shown(from) + direction * scale * units::step(*step, unit)).unwrap_or(from);
        let text = info.text(&Value::Number(math::clamp(stepped, *min, *max)));
        input.set_value(&text);
        take(&text);
    };
    view! {
        <input
            node_ref=input id=id type="text" autocomplete="off" spellcheck="false"
            class=if numeric { "number" } else { "" }
            inputmode=if numeric { "decimal" } else { "text" }
            aria-describedby=format!("{id}-note")
            aria-invalid=move || wrong.get().to_string()
            on:focus=move |_| enter()
            on:change=move |_| finish()
            on:input=move |event| taken(&event_target_value(&event))
            on:keydown=step
        />
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{InInches, ViewBench, event, field, mount, settled};

    async fn mounted(id: &'static str) -> ViewBench {
        mount(move || view! { <FormField info=field(id) /> }).await
    }

    #[wasm_bindgen_test]
    async fn refused_text_leaves_the_value_before_it() {
        let bench = mounted("pitch").await;
        bench.find("#pitch").dispatch_event(&event("FocusEvent", "focus", &[])).unwrap();
        for typed in ["1", "12", "12e", "12e2"] {
            bench.type_into("#pitch", typed).await;
        }
        assert_eq!((bench.value("#pitch").as_str(), bench.setting("pitch")), ("12e2", Some(Value::Number(8.0))));
        assert!(bench.page.entries.refused("pitch").is_some());
        bench.type_into("#pitch", "12").await;
        assert_eq!(bench.setting("pitch"), Some(Value::Number(12.0)));
    }

    #[wasm_bindgen_test]
    async fn escape_brings_the_value_before_the_entry_back() {
        let bench = mounted("pitch").await;
        bench.find("#pitch").dispatch_event(&event("FocusEvent", "focus", &[])).unwrap();
        for typed in ["9", "-5"] {
            bench.type_into("#pitch", typed).await;
            bench.key("#pitch", "Escape", false).await;
            assert_eq!((bench.value("#pitch").as_str(), bench.setting("pitch")), ("8", Some(Value::Number(8.0))));
            assert_eq!(bench.attribute("#pitch", "aria-invalid"), "false", "{typed}");
        }
    }

    #[wasm_bindgen_test]
    async fn typed_text_stays_as_it_was_typed() {
        let bench = mounted("pitch").await;
        for (typed, value) in [("1,5", 1.5), ("1.50", 1.5), ("007", 7.0), ("9.", 9.0)] {
            bench.type_into("#pitch", typed).await;
            assert_eq!((bench.value("#pitch").as_str(), bench.setting("pitch")), (typed, Some(Value::Number(value))));
        }
    }

    #[wasm_bindgen_test]
    async fn finished_entry_is_converted_to_the_unit_of_the_field() {
        let bench = mounted("pitch").await;
        bench.type_into("#pitch", "0.5 in").await;
        assert_eq!((bench.value("#pitch").as_str(), bench.setting("pitch")), ("0.5 in", Some(Value::Number(12.7))));
        bench.find("#pitch").dispatch_event(&event("Event", "change", &[])).unwrap();
        assert_eq!(bench.value("#pitch"), "12.7");
    }

    #[wasm_bindgen_test]
    async fn wrong_entry_is_marked_and_names_the_range() {
        let bench = mounted("pitch").await;
        for typed in ["-1.50", "", "1e400", "x"] {
            bench.type_into("#pitch", typed).await;
            assert_eq!(bench.attribute("#pitch", "aria-invalid"), "true", "{typed}");
            assert!(bench.has(".field.wrong"), "{typed}");
            assert!(bench.text("#pitch-note").contains("Allowed"), "{typed}");
            assert_eq!((bench.value("#pitch").as_str(), bench.setting("pitch")), (typed, Some(Value::Number(8.0))));
        }
        bench.type_into("#pitch", "7").await;
        assert_eq!(
            (bench.attribute("#pitch", "aria-invalid").as_str(), bench.text("#pitch-note").as_str()),
            ("false", "")
        );
    }

    #[wasm_bindgen_test]
    async fn field_has_label_symbol_unit_and_note() {
        let bench = mounted("pitch").await;
        assert_eq!(bench.attribute("label", "for"), "pitch");
        assert!(bench.text("label").starts_with(t(field("pitch").label)));
        assert_eq!((bench.text("label small").as_str(), bench.text(".unit").as_str()), ("#107", "mm"));
        assert_eq!(bench.attribute("#pitch", "aria-describedby"), "pitch-note");
    }

    #[wasm_bindgen_test]
    async fn symbol_is_spelled_as_the_control_spells_it() {
        let bench = mounted("pitch").await;
        let control = crate::controls::find(crate::machines::ALL[0].controls()[2]).unwrap();
        bench.page.edit(|project| project.move_to(control));
        settled().await;
        assert_eq!(bench.text("label small"), control.variable(107));
    }

    #[wasm_bindgen_test]
    async fn arrow_keys_step_the_number() {
        let bench = mounted("pitch").await;
        for (key, shift, shown) in [("ArrowUp", false, "8.1"), ("ArrowUp", true, "9.1"), ("ArrowDown", false, "9")] {
            bench.key("#pitch", key, shift).await;
            assert_eq!(bench.value("#pitch"), shown);
        }
        assert_eq!(bench.setting("pitch"), Some(Value::Number(9.0)));
    }

    #[wasm_bindgen_test]
    async fn field_in_inches_keeps_millimetres() {
        let _inches = InInches::new();
        let bench = mounted("pitch").await;
        assert_eq!((bench.value("#pitch").as_str(), bench.text(".unit").as_str()), ("0.31496", "in"));
        bench.type_into("#pitch", "1,5").await;
        assert_eq!((bench.value("#pitch").as_str(), bench.setting("pitch")), ("1,5", Some(Value::Number(38.1))));
        bench.key("#pitch", "ArrowUp", false).await;
        assert_eq!((bench.value("#pitch").as_str(), bench.setting("pitch")), ("1.505", Some(Value::Number(38.227))));
        bench.type_into("#pitch", "500").await;
        assert_eq!(bench.text("#pitch-note"), "500 is too large. Allowed: 0.0004 to 393.7008 in");
    }

    #[wasm_bindgen_test]
    async fn arrow_key_stops_at_the_limit_of_the_field() {
        let bench = mounted("heads").await;
        bench.type_into("#heads", "1").await;
        bench.key("#heads", "ArrowDown", true).await;
        assert_eq!(bench.value("#heads"), "1");
    }

    #[wasm_bindgen_test]
    async fn undo_shows_the_value_before() {
        let bench = mounted("pitch").await;
        bench.type_into("#pitch", "9.5").await;
        bench.type_into("#pitch", "wrong").await;
        bench.page.undo();
        settled().await;
        assert_eq!(
            (bench.value("#pitch").as_str(), bench.attribute("#pitch", "aria-invalid").as_str()),
            ("8", "false")
        );
    }

    #[wasm_bindgen_test]
    async fn value_from_elsewhere_is_marked_and_said_once() {
        let bench = mounted("pitch").await;
        let said = || bench.page.notices.announcement.get_untracked();
        bench.type_into("#pitch", "9").await;
        assert_eq!((bench.has(".field.changed"), said().as_str()), (false, ""), "its own entry");
        bench.page.take_entries(&[crate::view::FieldEntry::new("pitch", "10")]);
        settled().await;
        assert_eq!((bench.has(".field.changed"), said().as_str()), (true, "Changed: Pitch 10 mm."));
        bench.type_into("#pitch", "9.5").await;
        assert!(!bench.has(".field.changed"));
        bench.page.undo();
        settled().await;
        assert_eq!((bench.has(".field.changed"), said().as_str()), (true, "Changed: Pitch 10 mm."));
        // Another project is no change of this one.
        bench.page.change_machine(crate::machines::ALL[1].id());
        settled().await;
        assert_eq!(said(), "Changed: Pitch 10 mm.");
    }

    #[wasm_bindgen_test]
    async fn mark_of_a_changed_value_ends_by_itself() {
        let bench = mounted("pitch").await;
        bench.page.take_value("pitch", Value::Number(10.0));
        settled().await;
        assert!(bench.has(".field.changed"));
        crate::ui::testing::pause(6100).await;
        assert!(!bench.has(".field.changed"));
    }

    #[wasm_bindgen_test]
    async fn choice_of_a_field_reaches_the_project() {
        let bench = mounted("job").await;
        let FieldKindInfo::Choice(options) = field("job").kind else { panic!("a choice") };
        assert_eq!(bench.value("#job"), options[0].0);
        bench.choose("#job", options[1].0).await;
        assert_eq!(bench.setting("job"), Some(Value::Text(options[1].0.to_owned())));
    }

    #[wasm_bindgen_test]
    async fn flag_of_a_field_reaches_the_project() {
        let bench = mounted("dancer").await;
        assert!(!bench.checked("#dancer"));
        bench.press("#dancer").await;
        assert_eq!(bench.setting("dancer"), Some(Value::Flag(true)));
        bench.page.undo();
        settled().await;
        assert!(!bench.checked("#dancer"));
    }

    #[wasm_bindgen_test]
    async fn text_longer_than_its_field_is_wrong() {
        let bench = mounted("customer").await;
        bench.type_into("#customer", "A name of 22 letters .").await;
        assert_eq!(bench.attribute("#customer", "aria-invalid"), "false");
        bench.type_into("#customer", "A name of 23 letters ..").await;
        assert_eq!(bench.attribute("#customer", "aria-invalid"), "true");
    }

    #[wasm_bindgen_test]
    async fn field_without_a_meaning_is_absent() {
        let bench = mounted("pitch").await;
        assert!(!bench.has(".field.absent"));
        bench.page.results.hidden.set(vec!["pitch"]);
        settled().await;
        assert!(bench.has(".field.absent"));
    }

    #[wasm_bindgen_test]
    async fn help_button_shows_the_origin_of_the_value() {
        let bench = mounted("heads").await;
        assert_eq!(bench.attribute(".about", "data-from"), "");
        bench.page.set_provenance("heads", Provenance::Measured);
        settled().await;
        assert_eq!(bench.attribute(".about", "data-from"), "measured");
        bench.press(".about").await;
        assert_eq!(bench.page.view.about.get_untracked(), Some("heads"));
    }

    #[wasm_bindgen_test]
    async fn only_numbers_of_the_product_have_sliders() {
        for (id, slides) in [("pitch", true), ("clamp-x", false), ("job", false)] {
            assert_eq!(mounted(id).await.has("input[type=range]"), slides, "{id}");
        }
    }
}

//! One field of the form: what is typed stays as it is typed, and the project gets it when it reads as a value.

use leptos::html;
use leptos::prelude::*;
use web_sys::KeyboardEvent;

use super::model::Model;
use super::words::{t, tell};
use crate::machines::form::{FieldInfo, KindInfo, Provenance, Value};
use crate::text::catalog::number_text;

/// A value as its field shows it.
pub(super) fn shown(info: &FieldInfo, value: &Value) -> String {
    match (value, &info.kind) {
        (Value::Number(number), KindInfo::Number { decimals, .. }) => number_text(*number, (*decimals).max(6)),
        (Value::Number(number), _) => number_text(*number, 6),
        (Value::Flag(flag), _) => flag.to_string(),
        (Value::Text(text), _) => text.clone(),
    }
}

/// A field with label, unit, what is wrong, help and where its value comes from.
pub(super) fn field(model: Model, info: FieldInfo) -> AnyView {
    let id = info.id;
    let stored = StoredValue::new_local(info.clone());
    let value = Memo::new(move |_| {
        model
            .project
            .with(|project| project.values.get(id).cloned().unwrap_or_else(|| stored.with_value(FieldInfo::default)))
    });
    let wrong = Memo::new(move |_| {
        if let Some(problem) = model.invalid.with(|invalid| invalid.get(id).map(tell)) {
            return Some(problem);
        }
        model.design.with(|design| {
            let errors = design.diagnostics.iter().filter(|d| d.severity == crate::text::Severity::Error);
            errors.filter(|d| d.field == Some(id)).map(tell).next()
        })
    });
    let control = match &info.kind {
        KindInfo::Number { .. } | KindInfo::Text(_) => text_control(model, &info, value, wrong),
        KindInfo::Flag(_) => {
            let checked = move || value.get() == Value::Flag(true);
            view! {
                <input type="checkbox" class="switch" id=id prop:checked=checked aria-describedby=format!("{id}-note")
                    on:change=move |event| model.set(id, Value::Flag(event_target_checked(&event))) />
            }
            .into_any()
        }
        KindInfo::Choice(options) => {
            let options = *options;
            let rows = options.iter().map(|(option, label)| {
                let chosen = move || value.get() == Value::Text((*option).to_owned());
                view! { <option value=*option prop:selected=chosen>{t(label)}</option> }
            });
            view! {
                <select id=id aria-describedby=format!("{id}-note")
                    on:change=move |event| model.set(id, Value::Text(event_target_value(&event)))>
                    {rows.collect_view()}
                </select>
            }
            .into_any()
        }
    };
    let unit = match &info.kind {
        KindInfo::Number { unit, .. } => *unit,
        _ => "",
    };
    let from = move || match model.project.with(|project| project.provenance.get(id).copied()) {
        Some(Provenance::Measured) => "measured",
        Some(Provenance::DataSheet) => "data-sheet",
        _ => "",
    };
    let flag = matches!(info.kind, KindInfo::Flag(_));
    let wide = matches!(info.kind, KindInfo::Choice(_) | KindInfo::Text(_));
    view! {
        <div class="field" class:wide=wide class:flag=flag class:wrong=move || wrong.with(Option::is_some)>
            <label for=id>{t(info.label)} {(!info.symbol.is_empty()).then(|| view! { <small>{info.symbol}</small> })}</label>
            {control}
            <span class="unit">{unit}</span>
            <button type="button" class="about" popovertarget="about" data-from=from
                aria-label=format!("{}: {}", t("page.about"), t(info.label)) on:click=move |_| model.about.set(Some(id))>"?"</button>
            <p class="note" id=format!("{id}-note")>{move || wrong.get()}</p>
        </div>
    }
    .into_any()
}

/// A text that is read while it is typed, and never written while it is right.
fn text_control(model: Model, info: &FieldInfo, value: Memo<Value>, wrong: Memo<Option<String>>) -> AnyView {
    let id = info.id;
    let stored = StoredValue::new_local(info.clone());
    let node: NodeRef<html::Input> = NodeRef::new();
    let numeric = matches!(info.kind, KindInfo::Number { .. });
    Effect::new(move |seen: Option<u32>| {
        let (value, count) = (value.get(), model.reread.get());
        let Some(input) = node.get() else { return count };
        stored.with_value(|info| {
            // The text stays where it means the value already: `1,5` is not rewritten into 1.5.
            let forced = seen.is_some_and(|seen| seen != count);
            let same = info.read(&input.value()).is_ok_and(|read| read == value);
            let kept = model.invalid.with_untracked(|invalid| invalid.contains_key(id)) && !forced;
            if !same && !kept {
                input.set_value(&shown(info, &value));
            }
        });
        count
    });
    let take = move |typed: String| {
        stored.with_value(|info| match info.read(&typed) {
            Ok(value) => model.set(id, value),
            Err(problem) => model.refuse(id, *problem),
        });
    };
    let typed = move |event: web_sys::Event| {
        model.timed();
        take(event_target_value(&event));
    };
    let step = move |event: KeyboardEvent| {
        let direction = match event.key().as_str() {
            "ArrowUp" => 1.0,
            "ArrowDown" => -1.0,
            _ => return,
        };
        stored.with_value(|info| {
            let (KindInfo::Number { step, min, max, .. }, Some(input)) = (&info.kind, node.get_untracked()) else {
                return;
            };
            event.prevent_default();
            let scale = if event.shift_key() { 10.0 } else { 1.0 };
            let Value::Number(from) = info.read(&input.value()).unwrap_or_else(|_| value.get_untracked()) else {
                return;
            };
            let to = Value::Number((from + direction * scale * step).clamp(*min, *max));
            let text = shown(info, &to);
            input.set_value(&text);
            model.timed();
            take(text);
        });
    };
    view! {
        <input type="text" id=id node_ref=node autocomplete="off" spellcheck="false"
            inputmode=if numeric { "decimal" } else { "text" }
            class:number=numeric
            aria-invalid=move || wrong.with(Option::is_some).to_string()
            aria-describedby=format!("{id}-note")
            on:input=typed on:keydown=step />
    }
    .into_any()
}

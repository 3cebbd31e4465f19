//! One field of the form: what is typed stays as it is typed, and the project gets it when it reads as a value.

use std::cell::Cell;
use std::rc::Rc;

use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::{Event, KeyboardEvent};

use super::el::{El, button, checked, el};
use super::model::Model;
use super::words::{t, tell};
use crate::machines::form::{FieldInfo, KindInfo, Provenance, Value};
use crate::math;
use crate::text::Severity;
use crate::text::catalog::number_text;

/// Reads the field's value of the project.
type Read = Rc<dyn Fn() -> Value>;

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
pub(super) fn field(model: Model, info: FieldInfo) -> El {
    let id = info.id;
    let stored = Rc::new(info);
    let info = Rc::clone(&stored);
    let value: Read = Rc::new(move || {
        model.project.with(|project| project.values.get(id).cloned().unwrap_or_else(|| stored.default()))
    });
    let wrong = move || {
        if let Some(problem) = model.refused(id) {
            return tell(&problem);
        }
        model.design.with(|design| {
            let errors = design.diagnostics.iter().filter(|d| d.severity == Severity::Error && d.field == Some(id));
            errors.map(tell).next().unwrap_or_default()
        })
    };
    let note = format!("{id}-note");
    let (control, class) = match &info.kind {
        KindInfo::Number { .. } => (text_control(model, &info, value), ""),
        KindInfo::Text(_) => (text_control(model, &info, value), "wide"),
        KindInfo::Flag(_) => {
            let input = el("input.switch").at("type", "checkbox").checked(move || value() == Value::Flag(true));
            (input.on("change", move |event| model.set(id, Value::Flag(checked(&event)))), "flag")
        }
        KindInfo::Choice(options) => {
            let rows: Vec<El> =
                options.iter().map(|(one, label)| el("option").at("value", one).text(t(label))).collect();
            let chosen = move || if let Value::Text(text) = value() { text } else { String::new() };
            let select = el("select").add(&rows).valued(chosen);
            (select.on("change", move |event| model.set(id, Value::Text(super::el::value(&event)))), "wide")
        }
    };
    let unit = if let KindInfo::Number { unit, .. } = &info.kind { *unit } else { "" };
    let from = move || match model.project.with(|project| project.provenance.get(id).copied()) {
        Some(Provenance::Measured) => "measured".to_owned(),
        Some(Provenance::DataSheet) => "data-sheet".to_owned(),
        _ => String::new(),
    };
    let about = button("button.about", "?", move || model.about.set(Some(id)))
        .at("popovertarget", "about")
        .label(&format!("{}: {}", t("page.about"), t(info.label)))
        .bind("data-from", from);
    let mut label = el("label").at("for", id).text(t(info.label)).text(" ");
    if !info.symbol.is_empty() {
        let symbol = info.symbol;
        label = label.add(&[el("small").live(move || model.spelled(symbol))]);
    }
    let control = control.at("id", id).at("aria-describedby", &note).state("aria-invalid", move || !wrong().is_empty());
    let unit = el("span.unit").text(unit);
    let note = el("p.note").at("id", &note).live(wrong);
    el("div.field")
        .at("class", &format!("field {class}"))
        .mark("absent", move || model.hidden.with(|hidden| hidden.contains(&id)))
        .mark("wrong", move || !wrong().is_empty())
        .add(&[label, control, unit, about, note])
}

/// A text that is read while it is typed, and never written while it means what the project holds.
fn text_control(model: Model, info: &Rc<FieldInfo>, value: Read) -> El {
    let id = info.id;
    let numeric = matches!(info.kind, KindInfo::Number { .. });
    let field = el(if numeric { "input.number" } else { "input" })
        .at("type", "text")
        .at("autocomplete", "off")
        .at("spellcheck", "false")
        .at("inputmode", if numeric { "decimal" } else { "text" });
    let input = field.input().clone();
    let (read, count) = (Rc::clone(info), Cell::new(0));
    let present = Rc::clone(&value);
    let shown_first = shown(info, &untrack(|| value()));
    input.set_value(&shown_first);
    let follow = move || {
        let (value, reread) = (present(), model.reread.get());
        // The text stays where it means the value already: `1,5` is not rewritten into 1.5.
        let same = read.read(&input.value()).is_ok_and(|typed| typed == value);
        let forced = count.replace(reread) != reread;
        let kept = untrack(|| model.refused(id)).is_some() && !forced;
        if !same && !kept {
            input.set_value(&shown(&read, &value));
        }
    };
    let reader = Rc::clone(info);
    let take = Rc::new(move |typed: &str| {
        model.timed();
        match reader.read(typed) {
            Ok(value) => model.set(id, value),
            Err(problem) => model.refuse(id, *problem),
        }
    });
    let taken = Rc::clone(&take);
    let info = Rc::clone(info);
    let field = field.run(follow).on("input", move |event| taken(&super::el::value(&event)));
    let input = field.input().clone();
    let step = move |event: Event| {
        let event: &KeyboardEvent = event.unchecked_ref();
        let direction = match event.key().as_str() {
            "ArrowUp" => 1.0,
            "ArrowDown" => -1.0,
            _ => return,
        };
        let KindInfo::Number { step, min, max, .. } = &info.kind else { return };
        event.prevent_default();
        let scale = if event.shift_key() { 10.0 } else { 1.0 };
        let Value::Number(from) = info.read(&input.value()).unwrap_or_else(|_| untrack(|| value())) else { return };
        let text = shown(&info, &Value::Number(math::clamp(from + direction * scale * step, *min, *max)));
        input.set_value(&text);
        take(&text);
    };
    field.on("keydown", step)
}

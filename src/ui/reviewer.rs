//! Warnings about a program of the user's own, from a worker: what macroline writes raises none, so the page opens without them.

use std::cell::Cell;
use std::rc::Rc;

use leptos::prelude::*;
use leptos::wasm_bindgen::JsValue;

use super::model::Model;
use super::script::get;
use crate::text::{Diagnostic, FileId, Fix, Message, Place, Severity, Span, Value, catalog};

/// Keeps the model's warnings up with its program.
pub(super) fn follow(model: Model) {
    let last = Rc::new(Cell::new(0));
    Effect::new(move |_| {
        model.written.track();
        // What is older than the last question is not waited for.
        let number = last.get() + 1;
        last.set(number);
        if !model.edited.get_untracked() {
            return model.warnings.put(Vec::new());
        }
        let last = Rc::clone(&last);
        let put = move |answer| {
            if let (Some(answer), true) = (answer, last.get() == number) {
                model.warnings.put(array(&answer, "rows").iter().filter_map(|row| warning(&row)).collect());
            }
        };
        model.project.with_untracked(|project| model.aside.ask("warnings", project, put));
    });
}

fn array(object: &JsValue, name: &str) -> js_sys::Array {
    js_sys::Array::from(&get(object, name))
}

fn number(value: &JsValue) -> u32 {
    value.as_f64().unwrap_or_default() as u32
}

/// A warning out of plain values; `work` made them.
fn warning(row: &JsValue) -> Option<Diagnostic> {
    let file = FileId(number(&get(row, "file")) as u16);
    let span = |start: &JsValue, end: &JsValue| Place { file, span: Span { start: number(start), end: number(end) } };
    let mut found = Diagnostic::warning(message(&get(row, "message"))?).at(span(&get(row, "start"), &get(row, "end")));
    if get(row, "info").as_bool() == Some(true) {
        found.severity = Severity::Info;
    }
    found.hints.extend(array(row, "hints").iter().filter_map(|hint| message(&hint)));
    for fix in array(row, "fixes").iter() {
        let parts: Vec<JsValue> = js_sys::Array::from(&fix).iter().collect();
        let Some((title, edits)) = parts.split_first() else { continue };
        let edit = |edit: &[JsValue]| Some((span(edit.first()?, edit.get(1)?), edit.get(2)?.as_string()?));
        found.fixes.push(Fix { title: message(title)?, edits: edits.chunks(3).filter_map(edit).collect() });
    }
    Some(found)
}

fn message(parts: &JsValue) -> Option<Message> {
    let mut parts = js_sys::Array::from(parts).into_iter().map(|part| part.as_string().unwrap_or_default());
    let id = catalog::id(&parts.next()?)?;
    Some(Message { id, values: parts.map(Value::Text).collect() })
}

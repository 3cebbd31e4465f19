//! What is said of a program, from a worker: the page reads it without the code that says what a mistake was meant to be, how to mend it,
//! and what will not do what was meant. What macroline writes has none of it, so the page opens without.

use std::cell::Cell;
use std::rc::Rc;

use leptos::prelude::*;
use leptos::wasm_bindgen::JsValue;

use super::model::Model;
use super::script::get;
use crate::controls::Control;
use crate::text::{Diagnostic, FileId, Fix, Message, MessageValue, Place, Span, catalog};

/// Keeps the model's findings up with its program.
pub(super) fn follow(model: Model) {
    let last = Rc::new(Cell::new(0));
    Effect::new(move |_| {
        // What is older than the last question is not waited for.
        let number = last.get() + 1;
        last.set(number);
        let (doubtful, control) =
            model.written.with(|written| (written.edited || !written.diagnostics.is_empty(), written.parsed.control()));
        model.pending.put(doubtful);
        model.reviewed.put(None);
        if !doubtful {
            return;
        }
        let last = Rc::clone(&last);
        let put = move |answer: Option<JsValue>| {
            if last.get() == number {
                let found = |answer| array(&answer, "rows").iter().filter_map(|row| finding(&row, control)).collect();
                model.reviewed.put(answer.map(found));
                model.pending.put(false);
            }
        };
        model.project.with_untracked(|project| model.aside.ask("review", project, put));
    });
}

fn array(object: &JsValue, name: &str) -> js_sys::Array {
    js_sys::Array::from(&get(object, name))
}

fn number(value: &JsValue) -> u32 {
    value.as_f64().unwrap_or_default() as u32
}

/// A finding out of plain values; `work` made them.
fn finding(row: &JsValue, control: &Control) -> Option<Diagnostic> {
    let make = [Diagnostic::error, Diagnostic::warning, Diagnostic::info];
    let mut found = make.get(number(&get(row, "severity")) as usize)?(message(&get(row, "message"))?);
    if let Some(file) = get(row, "file").as_f64() {
        let file = FileId(file as u16);
        let span =
            |start: &JsValue, end: &JsValue| Place { file, span: Span { start: number(start), end: number(end) } };
        found.place = Some(span(&get(row, "start"), &get(row, "end")));
        for fix in array(row, "fixes").iter() {
            let parts: Vec<JsValue> = js_sys::Array::from(&fix).iter().collect();
            let Some((title, edits)) = parts.split_first() else { continue };
            let edit = |edit: &[JsValue]| Some((span(edit.first()?, edit.get(1)?), edit.get(2)?.as_string()?));
            found.fixes.push(Fix { title: message(title)?, edits: edits.chunks(3).filter_map(edit).collect() });
        }
    }
    let wording = get(row, "wording").as_string();
    found.wording = control.alarms.iter().map(|row| row.text).find(|text| wording.as_deref() == Some(text));
    found.alarm = get(row, "alarm").as_string().map(Into::into);
    found.hints.extend(array(row, "hints").iter().filter_map(|hint| message(&hint)));
    Some(found)
}

fn message(parts: &JsValue) -> Option<Message> {
    let mut parts = js_sys::Array::from(parts).into_iter().map(|part| part.as_string().unwrap_or_default());
    let id = catalog::id(&parts.next()?)?;
    Some(Message { id, values: parts.map(MessageValue::Text).collect() })
}

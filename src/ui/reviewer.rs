//! Warnings about a program of the user's own, from a worker: what macroline writes raises none, so the page opens without them.

use std::cell::RefCell;
use std::rc::Rc;

use leptos::prelude::*;
use leptos::wasm_bindgen::closure::Closure;
use leptos::wasm_bindgen::{JsCast, JsValue};
use web_sys::{MessageEvent, Worker, WorkerOptions, WorkerType};

use super::model::Model;
use super::script::{get, object};
use crate::project::{Project, run};
use crate::text::{Diagnostic, FileId, Fix, Message, Place, Severity, Span, Value, catalog};

/// A worker; none where the browser has none. Its name brings the page's own hash along, so that no old module is taken.
pub(super) fn worker() -> Option<Worker> {
    let script = document().query_selector("script[data-wasm]").ok().flatten()?;
    let options = WorkerOptions::new();
    options.set_type(WorkerType::Module);
    options.set_name(&script.get_attribute("data-wasm")?);
    Worker::new_with_options("worker_boot.js", &options).ok()
}

/// A job for a worker: what it has to know of the project, and more.
pub(super) fn job<const N: usize>(project: &Project, more: [(&str, JsValue); N]) -> JsValue {
    let strings = |texts: &mut dyn Iterator<Item = &String>| texts.map(JsValue::from).collect::<js_sys::Array>();
    let job = object(more);
    let switches = strings(&mut project.switches.0.iter().flat_map(|(id, setting)| [id, setting]));
    for (name, value) in [
        ("control", project.control.id.into()),
        ("switches", switches.into()),
        ("silenced", strings(&mut project.silenced.iter()).into()),
    ] {
        let _ = js_sys::Reflect::set(&job, &name.into(), &value);
    }
    job
}

/// What takes the answers of a worker.
type Listener = Closure<dyn FnMut(MessageEvent)>;

/// The worker, and the last job: what is older is not waited for.
#[derive(Default)]
struct Reviewer {
    worker: Option<(Worker, Listener)>,
    ready: bool,
    waiting: Option<JsValue>,
    number: u32,
}

/// Keeps the model's warnings up with its program.
pub(super) fn follow(model: Model) {
    let reviewer = Rc::new(RefCell::new(Reviewer::default()));
    Effect::new(move |_| {
        model.written.track();
        let mut state = reviewer.borrow_mut();
        state.number += 1;
        if !model.edited.get_untracked() {
            drop(state);
            return model.warnings.put(Vec::new());
        }
        let job = question(model, state.number);
        if state.worker.is_none() {
            state.worker = worker().map(|worker| {
                let listener = listen(model, Rc::clone(&reviewer));
                worker.set_onmessage(Some(listener.as_ref().unchecked_ref()));
                (worker, listener)
            });
        }
        match &state.worker {
            Some((worker, _)) if state.ready => drop(worker.post_message(&job)),
            _ => state.waiting = Some(job),
        }
    });
}

fn question(model: Model, number: u32) -> JsValue {
    model.written.with_untracked(|written| {
        model.project.with_untracked(|project| {
            let set = run::set_by_operator(&[], &project.panel);
            let names = written.files.0.iter().map(|file| JsValue::from(file.name.as_str()));
            let texts = written.files.0.iter().map(|file| JsValue::from(file.text.as_str()));
            let more = [
                ("number", number.into()),
                ("start", written.main.into()),
                ("set", set.into_iter().map(JsValue::from).collect::<js_sys::Array>().into()),
                ("names", names.collect::<js_sys::Array>().into()),
                ("texts", texts.collect::<js_sys::Array>().into()),
            ];
            job(project, more)
        })
    })
}

fn listen(model: Model, reviewer: Rc<RefCell<Reviewer>>) -> Listener {
    Closure::new(move |event: MessageEvent| {
        let answer = event.data();
        if get(&answer, "kind").as_string().as_deref() == Some("ready") {
            // A message that is sent before the module runs would be lost.
            let mut state = reviewer.borrow_mut();
            state.ready = true;
            if let (Some((worker, _)), Some(job)) = (&state.worker, &state.waiting) {
                let _ = worker.post_message(job);
            }
        } else if get(&answer, "number").as_f64() == Some(f64::from(reviewer.borrow().number)) {
            model.warnings.put(array(&answer, "rows").iter().filter_map(|row| warning(&row)).collect());
        }
    })
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

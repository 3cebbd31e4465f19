//! Client of the worker: sends questions about the project and passes on the answers. The first question starts the worker.

use std::cell::RefCell;

use leptos::prelude::*;
use leptos::wasm_bindgen::closure::Closure;
use leptos::wasm_bindgen::{JsCast, JsValue};
use web_sys::{MessageEvent, Worker, WorkerOptions, WorkerType};

use super::script::{get, object, set};
use crate::project::Project;

/// A worker; none where the browser has none. Its name brings the page's own hash along, so that no old module is taken.
pub(super) fn worker() -> Option<Worker> {
    let script = document().query_selector("script[data-wasm]").ok().flatten()?;
    let options = WorkerOptions::new();
    options.set_type(WorkerType::Module);
    options.set_name(&script.get_attribute("data-wasm")?);
    Worker::new_with_options("worker_boot.js", &options).ok()
}

/// A question: what the worker has to do with a project.
pub(super) fn question(kind: &str, project: &Project) -> JsValue {
    object([("kind", kind.into()), ("project", project.to_json().into())])
}

/// The worker that answers the page. A handle: copies mean the same.
#[derive(Clone, Copy)]
pub(super) struct Aside(&'static RefCell<State>);

#[derive(Default)]
struct State {
    worker: Option<Running>,
    ready: bool,
    /// What has no answer yet.
    asked: Vec<Asked>,
    last: u32,
}

struct Running {
    worker: Worker,
    _answered: Closure<dyn FnMut(MessageEvent)>,
    _failed: Closure<dyn FnMut()>,
}

struct Asked {
    number: u32,
    question: JsValue,
    then: Box<dyn FnOnce(Option<JsValue>)>,
}

impl Aside {
    /// No worker yet.
    pub(super) fn new() -> Aside {
        Aside(Box::leak(Box::default()))
    }

    /// Asks about a project; `then` gets the answer, or none where no worker runs.
    pub(super) fn ask(self, kind: &str, project: &Project, then: impl FnOnce(Option<JsValue>) + 'static) {
        self.put(question(kind, project), Box::new(then));
    }

    fn put(self, question: JsValue, then: Box<dyn FnOnce(Option<JsValue>)>) {
        let mut state = self.0.borrow_mut();
        state.last += 1;
        let number = state.last;
        set(&question, "number", &number.into());
        if state.worker.is_none() {
            state.worker = worker().map(|worker| self.run(worker));
        }
        match &state.worker {
            None => {
                drop(state);
                return then(None);
            }
            Some(running) if state.ready => drop(running.worker.post_message(&question)),
            Some(_) => {}
        }
        state.asked.push(Asked { number, question, then });
    }

    fn run(self, worker: Worker) -> Running {
        let answered = Closure::new(move |event: MessageEvent| self.hear(event.data()));
        let failed = Closure::new(move || {
            // The next question tries another one.
            let lost = self.0.take();
            lost.asked.into_iter().for_each(|asked| (asked.then)(None));
        });
        worker.set_onmessage(Some(answered.as_ref().unchecked_ref()));
        worker.set_onerror(Some(failed.as_ref().unchecked_ref()));
        Running { worker, _answered: answered, _failed: failed }
    }

    fn hear(self, answer: JsValue) {
        let mut state = self.0.borrow_mut();
        let number = get(&answer, "number").as_f64();
        if let Some(at) = state.asked.iter().position(|asked| number == Some(asked.number.into())) {
            let asked = state.asked.remove(at);
            drop(state);
            (asked.then)(Some(answer));
        } else if let (None, Some(running)) = (number, &state.worker) {
            // It is ready: a question that is sent before its module runs would be lost.
            state.asked.iter().for_each(|asked| drop(running.worker.post_message(&asked.question)));
            state.ready = true;
        }
    }
}

//! The page's end of the connection: starts the worker with the first request and passes on its responses.

use std::cell::RefCell;
use std::rc::Rc;

use leptos::prelude::*;
use leptos::wasm_bindgen::closure::Closure;
use leptos::wasm_bindgen::{JsCast, JsValue};
use web_sys::{MessageEvent, Worker};

#[cfg(test)]
use super::messages::Request;
use super::messages::{Ask, Question, Reply};
use crate::project::Project;
use crate::project::help::texts::Texts;
use crate::text::{catalog, units};
use crate::ui::dom::script::{address_of, part_for_worker};

/// A running worker. It ends when this is dropped.
pub(crate) struct Running {
    worker: Worker,
    _heard: Closure<dyn FnMut(MessageEvent)>,
    _failed: Closure<dyn FnMut()>,
}

impl Running {
    /// Starts a worker; `None` if the browser has none. Its first message, to worker_boot.js, has its module, the page's sentences and the
    /// texts of help.
    pub(crate) fn start(mut heard: impl FnMut(Reply) + 'static, failed: impl FnMut() + 'static) -> Option<Running> {
        let script = document().query_selector("script[data-words]").ok().flatten()?;
        let words = script.get_attribute("data-words")?;
        let (manual, glossary) = Texts::files(catalog::spoken());
        let parts = ["worker.js", "worker_bg.wasm", &words, &manual, glossary].map(part_for_worker);
        let parts = parts.into_iter().collect::<Result<js_sys::Array, _>>().ok()?;
        parts.unshift(&units::shown().id().into());
        let worker = Worker::new(&address_of("worker_boot.js").ok()?).ok()?;
        worker.post_message(&parts).ok()?;
        let heard = Closure::new(move |event: MessageEvent| {
            if let Ok(reply) = serde_wasm_bindgen::from_value(event.data()) {
                heard(reply);
            }
        });
        let failed = Closure::new(failed);
        worker.set_onmessage(Some(heard.as_ref().unchecked_ref()));
        worker.set_onerror(Some(failed.as_ref().unchecked_ref()));
        Some(Running { worker, _heard: heard, _failed: failed })
    }

    /// Sends a question. Before [`Reply::Ready`] it would be lost.
    pub(crate) fn send(&self, question: &Question) {
        if let Ok(question) = serde_wasm_bindgen::to_value(question) {
            let _ = self.worker.post_message(&question);
        }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.worker.terminate();
    }
}

/// The worker that answers the page. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(crate) struct Client(StoredValue<Rc<RefCell<State>>, LocalStorage>);

#[derive(Default)]
struct State {
    worker: Option<Running>,
    ready: bool,
    /// Requests without a response yet.
    waiting: Vec<Waiting>,
    last: u32,
    /// Answers in place of a worker.
    #[cfg(test)]
    here: Option<Answer>,
}

#[cfg(test)]
type Answer = fn(&Project, &Request) -> Option<JsValue>;

struct Waiting {
    question: Question,
    then: Box<dyn FnOnce(Option<JsValue>)>,
    /// Receives the progress of the answer.
    progress: Rc<dyn Fn(f64)>,
}

impl Client {
    /// Hands a client to every component below. Its worker starts with the first request.
    pub(crate) fn provide() -> Client {
        let client = Client(StoredValue::new_local(Rc::default()));
        provide_context(client);
        client
    }

    /// The client of the page that a component is in.
    pub(crate) fn here() -> Client {
        expect_context()
    }

    /// Sends a request about a project; `then` gets the answer, or `None` where no worker runs.
    pub(crate) fn ask<A: Ask>(self, project: &Project, ask: A, then: impl FnOnce(Option<A::Answer>) + 'static) {
        self.ask_long(project, ask, |_| (), then);
    }

    /// Asks for a slow answer and reports its progress. Returns the number by which it can be [cancelled](Client::cancel).
    pub(crate) fn ask_long<A: Ask>(
        self,
        project: &Project,
        ask: A,
        progress: impl Fn(f64) + 'static,
        then: impl FnOnce(Option<A::Answer>) + 'static,
    ) -> u32 {
        let then = move |answer: Option<JsValue>| then(answer.and_then(A::received));
        let Some(state) = self.0.try_get_value() else { return 0 };
        let mut state = state.borrow_mut();
        #[cfg(test)]
        if let Some(answer) = state.here {
            drop(state);
            then(answer(project, &ask.request()));
            return 0;
        }
        state.last += 1;
        let number = state.last;
        let question = Question { number, project: project.to_json(), request: ask.request() };
        if state.worker.is_none() {
            state.worker = self.start();
        }
        match &state.worker {
            None => {
                drop(state);
                then(None);
                return number;
            }
            Some(running) if state.ready => running.send(&question),
            Some(_) => {}
        }
        state.waiting.push(Waiting { question, then: Box::new(then), progress: Rc::new(progress) });
        number
    }

    /// Cancels a running request: its worker ends, and another one answers the waiting requests.
    pub(crate) fn cancel(self, number: u32) {
        let Some(state) = self.0.try_get_value() else { return };
        let mut state = state.borrow_mut();
        let waits = state.waiting.len();
        state.waiting.retain(|waiting| waiting.question.number != number);
        if state.waiting.len() < waits {
            state.ready = false;
            state.worker = if state.waiting.is_empty() { None } else { self.start() };
        }
    }

    fn start(self) -> Option<Running> {
        Running::start(move |reply| self.receive(reply), move || self.fail())
    }

    /// Answers requests at once, in place of a worker.
    #[cfg(test)]
    pub(crate) fn answer_here(self, answer: Answer) {
        self.0.with_value(|state| state.borrow_mut().here = Some(answer));
    }

    /// Drops the worker; the next request starts another one.
    fn fail(self) {
        let Some(state) = self.0.try_get_value() else { return };
        let lost = state.take();
        // A listener must not be freed while it runs.
        if let Some(running) = lost.worker {
            set_timeout(move || drop(running), std::time::Duration::ZERO);
        }
        lost.waiting.into_iter().for_each(|waiting| (waiting.then)(None));
    }

    fn receive(self, reply: Reply) {
        let Some(state) = self.0.try_get_value() else { return };
        let mut state = state.borrow_mut();
        match reply {
            Reply::Ready => {
                state.ready = true;
                if let Some(running) = &state.worker {
                    state.waiting.iter().for_each(|waiting| running.send(&waiting.question));
                }
            }
            Reply::Answer(number, answer) => {
                let at = state.waiting.iter().position(|waiting| waiting.question.number == number);
                let waiting = at.map(|at| state.waiting.remove(at));
                drop(state);
                if let Some(waiting) = waiting {
                    (waiting.then)(Some(answer));
                }
            }
            Reply::Progress(number, far) => {
                let waiting = state.waiting.iter().find(|waiting| waiting.question.number == number);
                let progress = waiting.map(|waiting| Rc::clone(&waiting.progress));
                drop(state);
                if let Some(progress) = progress {
                    progress(far);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::mount;
    use crate::ui::worker::messages::FindFlips;

    #[wasm_bindgen_test]
    async fn request_without_a_worker_is_answered_by_none() {
        let bench = mount(|| ()).await;
        let answer = Rc::new(RefCell::new(Vec::new()));
        let heard = Rc::clone(&answer);
        bench.page.project.with_untracked(|project| {
            bench.worker.ask(project, FindFlips, move |found| heard.borrow_mut().push(found.is_none()));
        });
        assert_eq!(*answer.borrow(), [true]);
    }
}

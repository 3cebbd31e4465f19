//! Test bench of components: a view in an empty element of the page, with the actions and observations of a user.

use std::any::Any;
use std::cell::Cell;
use std::rc::Rc;

use leptos::mount::mount_to;
use leptos::prelude::*;
use leptos::wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::{Element, Event, HtmlElement, HtmlInputElement};

use super::dom::{self, script, turns};
use super::files::LargeFile;
use super::state::{Page, ProjectStart};
use super::worker::client::Client;
use super::worker::server;
use crate::machines::form::{FieldInfo, Value};
use crate::motion::Action;
use crate::project::Project;
use crate::project::help::texts::Texts;
use crate::text::catalog;
use crate::text::units::{self, Lengths};

wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_browser);

/// A mounted view with the state of its page; removed when this is dropped.
pub(crate) struct ViewBench {
    /// The state of the page.
    pub page: Page,
    /// The client of the worker. No worker answers, except by [`Client::answer_here`] and [`work_here`].
    pub worker: Client,
    host: HtmlElement,
    _mounted: Box<dyn Any>,
}

/// The first machine with its first control and the defaults of the form, not the values of an example.
pub(crate) fn project() -> Project {
    let machine = crate::machines::ALL[0];
    Project::of_form(machine, crate::controls::find(machine.controls()[0]).unwrap())
}

/// The project of a first visit.
pub(crate) fn first_project() -> Project {
    Project::of(crate::machines::ALL[0].id(), None).unwrap()
}

/// The row of a field of the first machine.
pub(crate) fn field(id: &str) -> FieldInfo {
    project().machine.fields().into_iter().find(|field| field.id == id).unwrap()
}

/// Continues as in a new tab, without the texts of the old tab's history entry.
pub(crate) fn new_tab() {
    window().history().unwrap().replace_state(&JsValue::NULL, "").unwrap();
}

/// A browser that takes no text into the entries of its history, while this lives.
pub(crate) struct WithoutHistory;

impl WithoutHistory {
    pub(crate) fn new() -> WithoutHistory {
        // `null` in place of the function: a call throws.
        script::set(&window().history().unwrap(), "replaceState", &JsValue::NULL);
        WithoutHistory
    }
}

impl Drop for WithoutHistory {
    fn drop(&mut self) {
        js_sys::Reflect::delete_property(&window().history().unwrap(), &"replaceState".into()).unwrap();
    }
}

/// Mounts a view in a browser that remembers nothing.
pub(crate) async fn mount<V: IntoView + 'static>(view: impl FnOnce() -> V + 'static) -> ViewBench {
    dom::storage().unwrap().clear().unwrap();
    new_tab();
    mount_project(project(), view).await
}

/// Mounts a view with a project, and everything that is built in turns; the browser's store stays unchanged.
pub(crate) async fn mount_project<V: IntoView + 'static>(
    project: Project,
    view: impl FnOnce() -> V + 'static,
) -> ViewBench {
    let bench = begin(project, view).await;
    until(turns::are_over).await;
    bench
}

/// Mounts a view, before anything that is built in its turn.
pub(crate) async fn mount_begun<V: IntoView + 'static>(view: impl FnOnce() -> V + 'static) -> ViewBench {
    begin(project(), view).await
}

async fn begin<V: IntoView + 'static>(project: Project, view: impl FnOnce() -> V + 'static) -> ViewBench {
    let body = document().body().unwrap();
    // A test that failed leaves its view in the page.
    dom::all(&body, ".bench").iter().for_each(Element::remove);
    let host: HtmlElement = document().create_element("div").unwrap().unchecked_into();
    host.set_class_name("bench");
    body.append_child(&host).unwrap();
    let provided = Rc::new(Cell::new(None));
    let provide = Rc::clone(&provided);
    let mounted = mount_to(host.clone(), move || {
        let page = Page::provide(ProjectStart::now(project), Vec::new());
        let worker = Client::provide();
        LargeFile::provide();
        provide.set(Some((page, worker)));
        view().into_any()
    });
    let (page, worker) = provided.get().unwrap();
    settled().await;
    ViewBench { page, worker, host, _mounted: Box::new(mounted) }
}

/// Answers requests at once as the worker would.
pub(crate) fn work_here(worker: Client) {
    worker.answer_here(|project, request| {
        let texts = Texts::shipped(catalog::spoken());
        server::answer(project, request, &mut |_| ()).or_else(|| server::help(project, Some(&texts), request))
    });
}

/// Waits until all effects of a change are in the page.
pub(crate) async fn settled() {
    for _ in 0..4 {
        leptos::task::tick().await;
    }
}

/// Waits some milliseconds.
pub(crate) async fn pause(milliseconds: i32) {
    let wait = js_sys::Promise::new(&mut |done, _| {
        let _ = window().set_timeout_with_callback_and_timeout_and_arguments_0(&done, milliseconds);
    });
    JsFuture::from(wait).await.unwrap();
}

/// Waits until a condition holds; fails after some seconds.
#[track_caller]
pub(crate) fn until(condition: impl Fn() -> bool) -> impl Future<Output = ()> {
    let caller = std::panic::Location::caller();
    async move {
        for _ in 0..500 {
            if condition() {
                return settled().await;
            }
            pause(10).await;
        }
        panic!("{caller}: does not come true");
    }
}

/// An event of the browser.
pub(crate) fn event(class: &str, kind: &str, members: &[(&str, JsValue)]) -> Event {
    let options = script::object([("bubbles", true.into()), ("cancelable", true.into())]);
    members.iter().for_each(|(name, value)| script::set(&options, name, value));
    let class = js_sys::Reflect::get(&js_sys::global(), &class.into()).unwrap();
    let class: js_sys::Function = class.unchecked_into();
    js_sys::Reflect::construct(&class, &js_sys::Array::of2(&kind.into(), &options)).unwrap().unchecked_into()
}

impl ViewBench {
    /// The actions of the operator in the project.
    pub(crate) fn actions(&self) -> Vec<Action> {
        let actions = |project: &Project| project.panel.events().iter().map(|event| event.action.clone()).collect();
        self.page.project.with_untracked(actions)
    }

    /// The only element, or the first one, that a selector finds.
    #[track_caller]
    pub(crate) fn find(&self, selector: &str) -> Element {
        self.host
            .query_selector(selector)
            .unwrap()
            .unwrap_or_else(|| panic!("no {selector}: {:.2000}", self.host.inner_html()))
    }

    /// All elements that a selector finds.
    pub(crate) fn all(&self, selector: &str) -> Vec<Element> {
        dom::all(&self.host, selector)
    }

    /// Whether a selector finds something.
    pub(crate) fn has(&self, selector: &str) -> bool {
        self.host.query_selector(selector).unwrap().is_some()
    }

    /// The words of an element.
    #[track_caller]
    pub(crate) fn text(&self, selector: &str) -> String {
        self.find(selector).text_content().unwrap_or_default().trim().to_owned()
    }

    /// An attribute of an element; empty where it lacks the attribute.
    #[track_caller]
    pub(crate) fn attribute(&self, selector: &str, name: &str) -> String {
        self.find(selector).get_attribute(name).unwrap_or_default()
    }

    /// A property of an element's style.
    #[track_caller]
    pub(crate) fn style(&self, selector: &str, property: &str) -> String {
        self.find(selector).unchecked_into::<HtmlElement>().style().get_property_value(property).unwrap()
    }

    /// The value of an input or a list.
    #[track_caller]
    pub(crate) fn value(&self, selector: &str) -> String {
        js_sys::Reflect::get(&self.find(selector), &"value".into()).unwrap().as_string().unwrap()
    }

    /// Whether a box is checked.
    #[track_caller]
    pub(crate) fn checked(&self, selector: &str) -> bool {
        self.find(selector).unchecked_into::<HtmlInputElement>().checked()
    }

    /// The button with this label or these words.
    #[track_caller]
    fn button(&self, words: &str) -> Element {
        let says = |button: &Element| {
            button.get_attribute("aria-label").as_deref() == Some(words)
                || button.text_content().is_some_and(|text| text.trim() == words)
        };
        self.all("button").into_iter().find(says).unwrap_or_else(|| panic!("no button {words}"))
    }

    /// Presses an element.
    pub(crate) async fn press(&self, selector: &str) {
        self.find(selector).unchecked_into::<HtmlElement>().click();
        settled().await;
    }

    /// Presses the button with this label or these words.
    pub(crate) async fn press_button(&self, words: &str) {
        self.button(words).unchecked_into::<HtmlElement>().click();
        settled().await;
    }

    async fn enter(&self, selector: &str, text: &str, kind: &str) {
        let element = self.find(selector);
        js_sys::Reflect::set(&element, &"value".into(), &text.into()).unwrap();
        element.dispatch_event(&event("Event", kind, &[])).unwrap();
        settled().await;
    }

    /// Types into a field, or drags a slider.
    pub(crate) async fn type_into(&self, selector: &str, text: &str) {
        self.enter(selector, text, "input").await;
    }

    /// Chooses in a list, or leaves a field with another text.
    pub(crate) async fn choose(&self, selector: &str, value: &str) {
        self.enter(selector, value, "change").await;
    }

    /// Presses a key in an element.
    pub(crate) async fn key(&self, selector: &str, key: &str, shift: bool) {
        let members = [("key", key.into()), ("shiftKey", shift.into())];
        self.find(selector).dispatch_event(&event("KeyboardEvent", "keydown", &members)).unwrap();
        settled().await;
    }

    /// Plans the run and waits until its first seconds are shown.
    pub(crate) async fn run(&self) {
        let page = self.page;
        // Edits in a row count as dragging, and the whole run follows later: wait as between two actions of a user.
        pause(100).await;
        page.player.settle();
        until(move || {
            let planned = page.player.planned.get_untracked();
            planned.end > 4.0 || planned.is_over
        })
        .await;
        self.drawn().await;
    }

    /// Sets the play head and waits until the page shows that time.
    pub(crate) async fn seek(&self, seconds: f64) {
        let player = self.page.player;
        player.seek(seconds);
        until(move || player.now.with_untracked(|now| now.t) == seconds).await;
    }

    /// Waits for two frames.
    pub(crate) async fn drawn(&self) {
        for _ in 0..2 {
            dom::frame().await;
        }
        settled().await;
    }

    /// A value of the project.
    pub(crate) fn setting(&self, id: &str) -> Option<Value> {
        self.page.project.with_untracked(|project| project.values.get(id).cloned())
    }

    /// The texts of the notices.
    pub(crate) fn notices(&self) -> Vec<String> {
        self.page.notices.list.with_untracked(|list| list.iter().map(|notice| notice.text.clone()).collect())
    }
}

impl Drop for ViewBench {
    fn drop(&mut self) {
        self.host.remove();
    }
}

/// Lengths in inches until this is dropped.
pub(crate) struct InInches;

impl InInches {
    pub(crate) fn new() -> InInches {
        units::show(Lengths::Inches);
        InInches
    }
}

impl Drop for InInches {
    fn drop(&mut self) {
        units::show(Lengths::Millimetres);
    }
}

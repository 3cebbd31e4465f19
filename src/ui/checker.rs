//! Large programs: read and checked in a worker, so that the page never waits; shown by their first lines.

use std::cell::RefCell;
use std::rc::Rc;

use leptos::wasm_bindgen::closure::Closure;
use leptos::wasm_bindgen::{JsCast, JsValue};
use web_sys::{Blob, File, HtmlDialogElement, MessageEvent, Worker};

use super::aside::{question, worker};
use super::dom;
use super::el::{El, button, el, icon_button};
use super::listing::SHOWN;
use super::model::Model;
use super::script::{get, rows, set, text};
use super::words::{figure, t};
use crate::text::catalog::number_text;

/// A text that is too large for the page.
pub(super) enum Source {
    /// A file.
    File(File),
    /// What was pasted.
    Text(String),
}

/// How far a check is.
#[derive(Clone, Default)]
pub(super) struct Check {
    name: String,
    /// Bytes read and in all; all are read when the check itself runs.
    progress: (f64, f64),
    report: Option<Report>,
    _worker: Option<Rc<Job>>,
}

/// What the worker found.
#[derive(Clone)]
struct Report {
    lines: f64,
    counts: String,
    head: String,
    /// Class and sentence.
    rows: Vec<[String; 2]>,
}

struct Job {
    worker: Worker,
    _listener: Closure<dyn FnMut(MessageEvent)>,
}

impl Drop for Job {
    fn drop(&mut self) {
        self.worker.terminate();
    }
}

/// Checks a text in a worker; the dialog shows how far it is.
pub(super) fn check(model: Model, source: Source) {
    let (name, blob): (String, Blob) = match source {
        Source::File(file) => (file.name(), file.into()),
        Source::Text(text) => {
            let parts = js_sys::Array::of1(&text.into());
            let Ok(blob) = Blob::new_with_str_sequence(&parts) else { return };
            (t("page.pasted").to_owned(), blob)
        }
    };
    let Some(worker) = worker() else {
        model.notify("fail", t("page.no-worker").to_owned());
        return;
    };
    let all = blob.size();
    let job = model.project.with_untracked(|project| question("check", project));
    set(&job, "blob", &blob);
    let waiting = RefCell::new(Some(job));
    let asked = worker.clone();
    let listener = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
        let data = event.data();
        match get(&data, "kind").as_string().as_deref() {
            // A message that is sent before the module runs would be lost.
            Some("ready") => {
                if let Some(job) = waiting.borrow_mut().take() {
                    let _ = asked.post_message(&job);
                }
            }
            Some("progress") => model.check.update(|check| {
                if let Some(check) = check {
                    check.progress.0 = get(&data, "read").as_f64().unwrap_or_default();
                }
            }),
            Some("report") => model.check.update(|check| {
                if let Some(check) = check {
                    check.progress.0 = check.progress.1;
                    check.report = Some(report(&data));
                }
            }),
            _ => {}
        }
    });
    worker.set_onmessage(Some(listener.as_ref().unchecked_ref()));
    let job = Rc::new(Job { worker, _listener: listener });
    model.check.set(Some(Check { name, progress: (0.0, all), report: None, _worker: Some(job) }));
}

fn report(data: &JsValue) -> Report {
    Report {
        lines: get(data, "lines").as_f64().unwrap_or_default(),
        counts: text(data, "counts"),
        head: text(data, "head"),
        rows: rows(data, "rows"),
    }
}

/// The dialog of a check.
pub(super) fn check_dialog(model: Model) -> El {
    let frame = el("dialog.dialog.wide").at("aria-labelledby", "check-title");
    let node: HtmlDialogElement = frame.dom().clone().unchecked_into();
    let open = move || model.check.with(Option::is_some);
    let follow = move || {
        if !open() {
            node.close();
        } else if !node.open() {
            let _ = node.show_modal();
        }
    };
    // Closing gives up the worker, whether it is done or not.
    let close = move || model.check.set(None);
    let part = move || model.check.with(|check| check.as_ref().map_or((0.0, 1.0), |check| check.progress));
    let done = move || model.check.with(|check| check.as_ref().is_some_and(|check| check.report.is_some()));
    let name = move || model.check.with(|check| check.as_ref().map_or(String::new(), |check| check.name.clone()));
    let state = move || match part() {
        _ if done() => t("page.checked").to_owned(),
        (read, all) if read < all => t("page.reading").to_owned(),
        _ => t("page.checking").to_owned(),
    };
    let bar = el("progress").label(t("page.progress")).at("max", "1");
    let element = bar.dom().clone();
    // Without a value the bar says that it goes on, but not how far it is.
    let fill = move || match part() {
        (read, all) if read < all => dom::set(&element, "value", &number_text(read / all, 3)),
        _ => drop(element.remove_attribute("value")),
    };
    let content = move || model.check.with(|check| check.as_ref()?.report.as_ref().map(shown)).unwrap_or_default();
    let title = el("h2#check-title").live(name);
    frame
        .add(&[
            el("header").add(&[title, icon_button("button.icon", "✕", t("page.close"), close)]),
            el("p").at("role", "status").live(state),
            el("div.progress")
                .mark("over", done)
                .add(&[bar.run(fill), button("button#cancel-check", t("page.cancel"), close)]),
            el("div.body-of").swap(content),
        ])
        .on("close", move |_| close())
        .run(follow)
}

fn shown(report: &Report) -> Vec<El> {
    let rows: Vec<El> = report.rows.iter().map(|[tone, text]| el("li").at("class", tone).text(text)).collect();
    let mut told = format!("{} {}  {}", figure(report.lines, 0), t("page.lines"), report.counts);
    if report.lines > f64::from(SHOWN) {
        told.push_str(&format!("  {} {SHOWN}", t("page.first-lines")));
    }
    vec![
        el("p").text(&told),
        el("ul.remarks.tall").add(&rows),
        el("pre.raw").at("tabindex", "0").label(t("page.listing")).text(&report.head),
    ]
}

//! Large programs: read and checked in a worker, so that the page never waits; shown by their first lines.

use std::rc::Rc;

use leptos::wasm_bindgen::JsCast;
use web_sys::{Blob, File, HtmlDialogElement};

use super::dom;
use super::el::{El, button, el, icon_button};
use super::listing::SHOWN;
use super::model::Model;
use super::state::Check;
use super::words::{figure, t};
use super::worker::client::Running;
use super::worker::messages::{Question, Reply, Report, Request, Response};
use crate::project::Project;
use crate::text::catalog::number_text;

/// A text that is too large for the page.
pub(super) enum Source {
    /// A file.
    File(File),
    /// What was pasted.
    Text(String),
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
    let all = blob.size();
    let project = model.project.with_untracked(Project::to_json);
    let mut waiting = Some(Question { number: 0, project, request: Request::Check(blob) });
    let heard = move |reply| match reply {
        Reply::Ready => {
            let question = waiting.take();
            model.check.with_untracked(|check| {
                question.iter().zip(check).for_each(|(question, check)| check.worker.send(question));
            });
        }
        Reply::Progress(read) => model.check.update(|check| {
            check.iter_mut().for_each(|check| check.progress.0 = read);
        }),
        Reply::Answer(_, Response::Check(report)) => model.check.update(|check| {
            if let Some(check) = check {
                check.progress.0 = check.progress.1;
                check.report = Some(report);
            }
        }),
        Reply::Answer(..) => {}
    };
    let Some(worker) = Running::start(heard, || {}) else {
        model.notify("fail", t("page.no-worker").to_owned());
        return;
    };
    model.check.set(Some(Check { name, progress: (0.0, all), report: None, worker: Rc::new(worker) }));
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
    let rows: Vec<El> = report.rows.iter().map(|(tone, text)| el("li").at("class", tone).text(text)).collect();
    let mut told = format!("{} {}  {}", figure(report.lines.into(), 0), t("page.lines"), report.counts);
    if report.lines > SHOWN {
        told.push_str(&format!("  {} {SHOWN}", t("page.first-lines")));
    }
    vec![
        el("p").text(&told),
        el("ul.remarks.tall").add(&rows),
        el("pre.raw").at("tabindex", "0").label(t("page.listing")).text(&report.head),
    ]
}

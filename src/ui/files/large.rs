//! Large programs: read and checked in a worker, so that the page never waits. The dialog shows their first lines.

use std::rc::Rc;

use leptos::prelude::*;
use web_sys::{Blob, File};

use crate::project::Project;
use crate::text::catalog::number_text;
use crate::ui::parts::Dialog;
use crate::ui::state::Page;
use crate::ui::words::{Tone, figure, t};
use crate::ui::worker::client::Running;
use crate::ui::worker::messages::{Ask, CheckText, Question, Reply, SHOWN, TextReport};

/// A text that is too large for the page.
pub(super) enum Source {
    /// A file.
    File(File),
    /// A pasted text.
    Text(String),
}

/// A check of a text that is too large for the page.
#[derive(Clone)]
struct Check {
    /// Name of the text.
    name: String,
    /// Bytes read, and total bytes; equal while the check itself runs.
    progress: (f64, f64),
    /// The findings, at the end of the check.
    report: Option<TextReport>,
    /// The worker that checks; it ends when this is dropped.
    worker: Rc<Running>,
}

/// The check of a large file, while its dialog is open. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(crate) struct LargeFile(RwSignal<Option<Check>, LocalStorage>);

impl LargeFile {
    /// Hands the check to every component below.
    pub(crate) fn provide() -> LargeFile {
        let large = LargeFile(RwSignal::new_local(None));
        provide_context(large);
        large
    }

    /// The check of the page that a component is in.
    pub(crate) fn here() -> LargeFile {
        expect_context()
    }

    fn update(self, change: impl FnOnce(&mut Check)) {
        self.0.update(|check| {
            if let Some(check) = check {
                change(check);
            }
        });
    }
}

/// Checks a text in a worker; the dialog shows how far it is.
pub(super) fn check(page: Page, large: LargeFile, source: Source) {
    let (name, blob): (String, Blob) = match source {
        Source::File(file) => (file.name(), file.into()),
        Source::Text(text) => {
            let parts = js_sys::Array::of1(&text.into());
            let Ok(blob) = Blob::new_with_str_sequence(&parts) else { return };
            (t("page.pasted").to_owned(), blob)
        }
    };
    let all = blob.size();
    let project = page.project.with_untracked(Project::to_json);
    let mut waiting = Some(Question { number: 0, project, request: CheckText(blob).request() });
    let heard = move |reply| match reply {
        Reply::Ready => {
            let question = waiting.take();
            large.0.with_untracked(|check| {
                question.iter().zip(check).for_each(|(question, check)| check.worker.send(question));
            });
        }
        Reply::Progress(_, read) => large.update(|check| check.progress.0 = read),
        Reply::Answer(_, report) => large.update(|check| {
            check.progress.0 = check.progress.1;
            check.report = CheckText::received(report);
        }),
    };
    let Some(worker) = Running::start(heard, || {}) else {
        page.notices.notify(Tone::Fail, t("page.no-worker").to_owned());
        return;
    };
    large.0.set(Some(Check { name, progress: (0.0, all), report: None, worker: Rc::new(worker) }));
}

/// The dialog of a check. Closing it ends the worker.
#[component]
pub(crate) fn LargeFileDialog() -> impl IntoView {
    let large = LargeFile::here();
    let close = move || large.0.set(None);
    let open = move || large.0.with(Option::is_some);
    let title = move || large.0.with(|check| check.as_ref().map(|check| check.name.clone())).unwrap_or_default();
    let part = move || large.0.with(|check| check.as_ref().map_or((0.0, 1.0), |check| check.progress));
    let done = move || large.0.with(|check| check.as_ref().is_some_and(|check| check.report.is_some()));
    let state = move || match part() {
        _ if done() => t("page.checked"),
        (read, all) if read < all => t("page.reading"),
        _ => t("page.checking"),
    };
    // Without a value the bar shows activity, but no progress.
    let fill = move || match part() {
        (read, all) if read < all => Some(number_text(read / all, 3)),
        _ => None,
    };
    let report = move || large.0.with(|check| check.as_ref()?.report.clone());
    view! {
        <Dialog id="check-title" title=Signal::derive(title) open=Signal::derive(open) close=close class="wide">
            <p role="status">{state}</p>
            <div class="progress" class:over=done>
                <progress aria-label=t("page.progress") max="1" value=fill></progress>
                <button type="button" id="cancel-check" on:click=move |_| close()>{t("page.cancel")}</button>
            </div>
            <div class="body-of">{move || report().map(|report| view! { <Findings report=report /> })}</div>
        </Dialog>
    }
}

/// The findings.
#[component]
fn Findings(
    /// The report of the worker.
    report: TextReport,
) -> impl IntoView {
    let mut counts = format!("{} {}  {}", figure(report.lines.into(), 0), t("page.lines"), report.counts);
    if report.lines > SHOWN {
        counts.push_str(&format!("  {} {SHOWN}", t("page.first-lines")));
    }
    let rows = report.rows.into_iter().map(|(tone, text)| view! { <li class=tone.class()>{text}</li> });
    view! {
        <p>{counts}</p>
        <ul class="remarks tall">{rows.collect_view()}</ul>
        <pre class="raw" tabindex="0" aria-label=t("page.listing")>{report.head}</pre>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::mount;

    #[wasm_bindgen_test]
    async fn report_counts_lines_and_lists_findings() {
        let report = TextReport {
            lines: SHOWN + 1,
            counts: "✕ 1".to_owned(),
            head: "G01\n".to_owned(),
            rows: vec![(Tone::Fail, "Line 1".to_owned())],
        };
        let bench = mount(move || view! { <Findings report=report /> }).await;
        assert!(bench.text("p").contains(t("page.first-lines")));
        assert_eq!((bench.text(".remarks .fail").as_str(), bench.text("pre").as_str()), ("Line 1", "G01"));
    }

    #[wasm_bindgen_test]
    async fn large_text_without_a_worker_is_a_notice() {
        let bench = mount(|| view! { <LargeFileDialog /> }).await;
        let large = LargeFile(RwSignal::new_local(None));
        check(bench.page, large, Source::Text("G01\n".to_owned()));
        assert_eq!(bench.notices(), [t("page.no-worker")]);
        assert!(!bench.has("dialog[open]"));
    }
}

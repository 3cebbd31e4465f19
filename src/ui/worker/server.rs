//! The worker's end of the connection: reviews programs, makes sheets and documents, checks large texts.

use std::cell::Cell;
use std::rc::Rc;

use js_sys::{Array, Function, Promise};
use leptos::wasm_bindgen::closure::Closure;
use leptos::wasm_bindgen::{JsCast, JsValue, throw_str};
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, DedicatedWorkerGlobalScope, MessageEvent};

use super::messages::{Ask, Finding, Question, Reply, Request, SHOWN, TextReport};
use super::{documents, editor, help, pictures, shelf};
use crate::msg;
use crate::nc::{self, Files};
use crate::project::Project;
use crate::project::findings::silence::silence;
use crate::project::help::texts::Texts;
use crate::project::sensitivity::Sensitivity;
use crate::text::units::{self, Lengths};
use crate::text::{Diagnostic, LineIndex, catalog};
use crate::ui::words::{Tone, counts, sentence, sentence_with_hints};

/// Greatest number of findings in the report of a large text.
const ROWS: usize = 200;

/// Bytes of a large text that are read between two reports of progress.
const PIECE: f64 = 4_000_000.0;

thread_local! {
    /// The texts of help, after the first request for them.
    static TEXTS: Cell<Option<Texts>> = const { Cell::new(None) };
}

/// The texts of help, fetched by `load`; `None` if they cannot be loaded.
async fn texts(load: &Function) -> Option<Texts> {
    if let Some(texts) = TEXTS.get() {
        return Some(texts);
    }
    let loading = load.call0(&JsValue::NULL).ok()?.dyn_into::<Promise>().ok()?;
    let loaded = JsFuture::from(loading).await.ok()?.dyn_into::<Array>().ok()?;
    let text = |at| Some(&*loaded.get(at).as_string()?.leak());
    let texts = Texts { manual: text(0)?, glossary: text(1)? };
    TEXTS.set(Some(texts));
    Some(texts)
}

/// Answers the requests of the page in the language of the sentences ([`catalog::speak`]), with lengths in the system of this id, as long
/// as the worker lives. `load` fetches the texts of help, those of [`Texts::files`].
pub fn work(sentences: String, lengths: &str, load: Function) {
    catalog::speak(sentences.leak());
    units::show(Lengths::of_id(lengths).unwrap_or(Lengths::Millimetres));
    std::panic::set_hook(Box::new(|panic| web_sys::console::error_1(&panic.to_string().into())));
    let Ok(scope) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() else { return };
    let page = scope.clone();
    let listener = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
        let Ok(Question { number, project, request }) = serde_wasm_bindgen::from_value(event.data()) else {
            throw_str("a question of the page does not read")
        };
        let Some(project) = Project::from_json(&project).project else {
            throw_str("the project of the page does not read")
        };
        let page = page.clone();
        match request {
            Request::ReadHelp(_) | Request::SearchHelp(_) => {
                let load = load.clone();
                // Leptos' own `spawn_local` waits for a mounted page.
                wasm_bindgen_futures::spawn_local(async move {
                    let texts = texts(&load).await;
                    send(&page, number, help(&project, texts.as_ref(), &request));
                });
            }
            Request::CheckText(ask) => wasm_bindgen_futures::spawn_local(async move {
                let text = read(&ask.0, &page, number).await;
                send(&page, number, ask.answer(&check(text, &project)));
            }),
            _ => {
                let mut progress = |far| post(&page, &Reply::Progress(number, far));
                send(&page, number, answer(&project, &request, &mut progress));
            }
        }
    });
    scope.set_onmessage(Some(listener.as_ref().unchecked_ref()));
    listener.forget();
    post(&scope, &Reply::Ready);
}

/// Answers a request that waits for nothing; reports progress where the work is long.
pub(in crate::ui) fn answer(project: &Project, request: &Request, progress: &mut dyn FnMut(f64)) -> Option<JsValue> {
    match request {
        Request::ReviewProgram(ask) => ask.answer(&review(project)),
        Request::WriteSheets(ask) => ask.answer(&documents::sheets(project)),
        Request::SizeProject(ask) => ask.answer(&documents::sizing(project, progress)),
        Request::DrawMachines(ask) => ask.answer(&documents::chance(project, progress)),
        Request::FindFlips(ask) => {
            ask.answer(&Sensitivity::new(project).flips().into_iter().map(|flip| flip.field.to_owned()).collect())
        }
        Request::FindRepairs(ask) => ask.answer(&documents::repairs(project)),
        Request::CompareVariants(ask) => ask.answer(&documents::variants(project)),
        Request::CompareProjects(ask) => ask.answer(&documents::compared_with(project, ask)),
        Request::ListProjects(ask) => ask.answer(&shelf::list(project, &ask.0)),
        Request::DrawExamples(ask) => ask.answer(&pictures::examples(ask.theme)),
        Request::ExportProject(ask) => ask.answer(&documents::export(project)),
        Request::WriteReport(ask) => ask.answer(&documents::report(project)),
        Request::ReadPartsTable(ask) => ask.answer(&documents::parts(project, ask)),
        Request::Complete(ask) => ask.answer(&editor::complete(project, ask.0)),
        Request::FindDefinition(ask) => ask.answer(&editor::definition(project, ask.0)),
        Request::FindUses(ask) => ask.answer(&editor::uses(project, ask.0)),
        Request::WriteOutline(ask) => ask.answer(&editor::outline(project)),
        Request::ReadHelp(_) | Request::SearchHelp(_) | Request::CheckText(_) => None,
    }
}

/// Answers a request about help; without its texts there is nothing to answer with.
pub(in crate::ui) fn help(project: &Project, texts: Option<&Texts>, request: &Request) -> Option<JsValue> {
    match request {
        Request::ReadHelp(ask) => ask.answer(&texts.map(|texts| help::page(project, texts, ask))),
        Request::SearchHelp(ask) => ask.answer(&texts.map(|texts| help::found(project, texts, &ask.0))),
        _ => None,
    }
}

fn send(page: &DedicatedWorkerGlobalScope, number: u32, answer: Option<JsValue>) {
    post(page, &Reply::Answer(number, answer.unwrap_or_default()));
}

fn post(page: &DedicatedWorkerGlobalScope, reply: &Reply) {
    if let Ok(reply) = serde_wasm_bindgen::to_value(reply) {
        let _ = page.post_message(&reply);
    }
}

/// The text of a blob, read in pieces, with its progress reported to the page.
async fn read(blob: &Blob, page: &DedicatedWorkerGlobalScope, number: u32) -> String {
    let all = blob.size();
    let mut bytes = Vec::with_capacity(all as usize);
    let mut at = 0.0;
    while at < all {
        let Ok(piece) = blob.slice_with_f64_and_f64(at, at + PIECE) else { break };
        let Ok(buffer) = JsFuture::from(piece.array_buffer()).await else { break };
        bytes.extend(js_sys::Uint8Array::new(&buffer).to_vec());
        at += PIECE;
        post(page, &Reply::Progress(number, at.min(all)));
    }
    String::from_utf8(bytes).unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned())
}

/// The report of a large text on the project's control.
fn check(text: String, project: &Project) -> TextReport {
    let lines = LineIndex::new(&text);
    let end = text.match_indices('\n').nth(SHOWN as usize - 1).map_or(text.len(), |(at, _)| at);
    let head = text.get(..end).unwrap_or_default().to_owned();
    let parsed = nc::parse_with(&Files::one("", text), project.control, &project.switches);
    let mut found = crate::project::findings::check::review(&Rc::new(parsed), None, &[]);
    silence(&mut found, &project.silenced);
    let row = |diagnostic: &Diagnostic| {
        let line = diagnostic.place.map_or(0, |place| lines.line_of(place.span.start));
        let text = match (&diagnostic.alarm, sentence_with_hints(diagnostic)) {
            (Some(alarm), text) => format!("{alarm} {text}"),
            (None, text) => text,
        };
        (diagnostic.severity.into(), sentence(&msg!("page.line", line, text)))
    };
    TextReport {
        lines: lines.count(),
        counts: counts(&found).map(|(severity, count)| format!("{} {count}", Tone::from(severity).sign())).join("  "),
        head,
        rows: found.iter().take(ROWS).map(row).collect(),
    }
}

/// All diagnostics of the project's program.
fn review(project: &Project) -> Vec<Finding> {
    let written = project.written();
    written
        .diagnostics
        .iter()
        .chain(&project.advice(&written))
        .map(|found| Finding::new(found, project.control))
        .collect()
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::project;

    #[wasm_bindgen_test]
    fn report_of_a_large_text_has_its_first_lines_and_findings() {
        let text = "G01 X1.\n".repeat(SHOWN as usize) + "G01 X\n";
        let report = check(text, &project());
        assert_eq!(report.head.lines().count(), SHOWN as usize);
        assert!(report.lines > SHOWN);
        let error = report.rows.iter().find(|row| row.0 == Tone::Fail).unwrap();
        assert!(error.1.contains(&(SHOWN + 1).to_string()), "{}", error.1);
    }
}

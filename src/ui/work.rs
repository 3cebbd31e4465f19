//! What a worker does for the page: checks large texts, says all that is to be said of a program, makes sheets and export.
//!
//! It is a module of its own (`src/bin/worker.rs`), so that opening the page does not load what it seldom needs.

use std::rc::Rc;

use leptos::wasm_bindgen::closure::Closure;
use leptos::wasm_bindgen::{JsCast, JsValue, throw_str};
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, DedicatedWorkerGlobalScope, MessageEvent};

use super::export;
use super::listing::{SHOWN, count};
use super::script::{get, object, set, table, text};
use super::words::{sign, t, tell, tone};
use crate::nc::{self, Files};
use crate::project::suppress::silence;
use crate::project::{Project, check};
use crate::text::catalog::number_text;
use crate::text::{Diagnostic, LineIndex, Message, MessageValue};

/// Findings that are listed at most.
const LISTED: usize = 200;

/// Bytes that are read in one go, between two reports of progress.
const PIECE: f64 = 4_000_000.0;

/// Waits for jobs and answers them, for ever.
pub fn work() {
    std::panic::set_hook(Box::new(|panic| web_sys::console::error_1(&panic.to_string().into())));
    let Ok(scope) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() else { return };
    let answer = scope.clone();
    let listener = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
        let (job, scope) = (event.data(), answer.clone());
        let Some(project) = Project::from_json(&text(&job, "project")).project else {
            throw_str("the project of the page does not read")
        };
        let answer = match text(&job, "kind").as_str() {
            "review" => reviewed(&project),
            "sheets" => export::sheets(&project),
            "export" => export::export(&project),
            _ => {
                let blob = get(&job, "blob").unchecked_into();
                // Not Leptos' own: that waits for a mounted page.
                return wasm_bindgen_futures::spawn_local(async move {
                    let text = read(&blob, &scope).await;
                    let _ = scope.post_message(&checked(text, &project));
                });
            }
        };
        set(&answer, "number", &get(&job, "number"));
        let _ = scope.post_message(&answer);
    });
    scope.set_onmessage(Some(listener.as_ref().unchecked_ref()));
    listener.forget();
    let _ = scope.post_message(&object([("kind", "ready".into())]));
}

/// The text of a blob, read in pieces.
async fn read(blob: &Blob, scope: &DedicatedWorkerGlobalScope) -> String {
    let all = blob.size();
    let mut bytes = Vec::with_capacity(all as usize);
    let mut at = 0.0;
    while at < all {
        let Ok(piece) = blob.slice_with_f64_and_f64(at, at + PIECE) else { break };
        let Ok(buffer) = JsFuture::from(piece.array_buffer()).await else { break };
        bytes.extend(js_sys::Uint8Array::new(&buffer).to_vec());
        at += PIECE;
        let _ = scope.post_message(&object([("kind", "progress".into()), ("read", at.min(all).into())]));
    }
    String::from_utf8(bytes).unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned())
}

/// A large text as the control reads it, and what is said of it.
fn checked(text: String, project: &Project) -> JsValue {
    let lines = LineIndex::new(&text);
    let end = text.match_indices('\n').nth(SHOWN as usize - 1).map_or(text.len(), |(at, _)| at);
    let head = text.get(..end).unwrap_or_default().to_owned();
    let parsed = nc::parse_with(&Files::one("", text), project.control, &project.switches);
    let mut found = check::review(&Rc::new(parsed), None, &[]);
    silence(&mut found, &project.silenced);
    let row = |diagnostic: &Diagnostic| {
        let line = diagnostic.place.map_or(0, |place| lines.line_of(place.span.start));
        let alarm = diagnostic.alarm.as_deref().unwrap_or_default();
        let text = format!("{} {line}: {alarm} {}", t("page.line"), tell(diagnostic));
        vec![tone(diagnostic.severity).into(), text.into()]
    };
    let counts = count(&found).map(|(severity, count)| format!("{} {count}", sign(tone(severity)))).join("  ");
    object([
        ("kind", "report".into()),
        ("lines", f64::from(lines.count()).into()),
        ("counts", counts.into()),
        ("head", head.into()),
        ("rows", table(found.iter().take(LISTED).map(row))),
    ])
}

/// What is said of the program of a project.
fn reviewed(project: &Project) -> JsValue {
    let written = project.written();
    let rows: js_sys::Array = written.diagnostics.iter().chain(&project.advice(&written)).map(row).collect();
    object([("rows", rows.into())])
}

/// A finding as plain values; `reviewer` makes one of them again.
fn row(diagnostic: &Diagnostic) -> JsValue {
    let place = diagnostic.place.unwrap_or_default();
    let fixes = diagnostic.fixes.iter().map(|fix| {
        let edits = fix
            .edits
            .iter()
            .flat_map(|(place, text)| [place.span.start.into(), place.span.end.into(), JsValue::from(text.as_str())]);
        JsValue::from([message(&fix.title)].into_iter().chain(edits).collect::<js_sys::Array>())
    });
    object([
        ("message", message(&diagnostic.message)),
        ("severity", (diagnostic.severity as u32).into()),
        ("alarm", diagnostic.alarm.as_deref().into()),
        ("wording", diagnostic.wording.into()),
        ("file", diagnostic.place.map(|place| u32::from(place.file.0)).into()),
        ("start", place.span.start.into()),
        ("end", place.span.end.into()),
        ("hints", diagnostic.hints.iter().map(message).collect::<js_sys::Array>().into()),
        ("fixes", fixes.collect::<js_sys::Array>().into()),
    ])
}

/// The id of a sentence, and its values as they are shown.
fn message(message: &Message) -> JsValue {
    let value = |value: &MessageValue| match value {
        MessageValue::Number(number, decimals) => JsValue::from(number_text(*number, *decimals)),
        MessageValue::Text(text) => text.as_str().into(),
    };
    [message.id.into()].into_iter().chain(message.values.iter().map(value)).collect::<js_sys::Array>().into()
}

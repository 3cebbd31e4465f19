//! What a worker does for the page: checks large texts, and finds the warnings about a program of the user's own.
//!
//! It is a module of its own (`src/bin/worker.rs`), so that opening the page does not load what it seldom needs.

use leptos::wasm_bindgen::closure::Closure;
use leptos::wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, DedicatedWorkerGlobalScope, MessageEvent};

use super::listing::{SHOWN, count};
use super::script::{get, object};
use super::words::{learn, sign, t, tell, tone};
use crate::controls::{self, Control, Switches};
use crate::nc::{self, File, Files};
use crate::project::silence::silence;
use crate::text::catalog::number_text;
use crate::text::{Diagnostic, LineIndex, Message, Severity, Value};

/// Findings that are listed at most.
const LISTED: usize = 200;

/// Bytes that are read in one go, between two reports of progress.
const PIECE: f64 = 4_000_000.0;

/// Waits for jobs and answers them, for ever.
pub fn work() {
    std::panic::set_hook(Box::new(|panic| web_sys::console::error_1(&panic.to_string().into())));
    learn();
    let Ok(scope) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() else { return };
    let answer = scope.clone();
    let listener = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
        let (job, scope) = (event.data(), answer.clone());
        let Some(control) = controls::find(&text(&job, "control")) else { return };
        let switches = strings(&job, "switches");
        let switches = switches.chunks_exact(2).map(|pair| (pair[0].clone(), pair[1].clone())).collect();
        let switches = Switches(switches);
        let blob = get(&job, "blob");
        if blob.is_undefined() {
            let _ = scope.post_message(&warnings(&job, control, &switches));
            return;
        }
        // Not Leptos' own: that waits for a mounted page.
        wasm_bindgen_futures::spawn_local(async move {
            let text = read(&blob.unchecked_into(), &scope).await;
            let _ = scope.post_message(&checked(text, control, &switches, &strings(&job, "silenced")));
        });
    });
    scope.set_onmessage(Some(listener.as_ref().unchecked_ref()));
    listener.forget();
    let _ = scope.post_message(&object([("kind", "ready".into())]));
}

fn text(object: &JsValue, name: &str) -> String {
    get(object, name).as_string().unwrap_or_default()
}

fn strings(object: &JsValue, name: &str) -> Vec<String> {
    js_sys::Array::from(&get(object, name)).iter().map(|text| text.as_string().unwrap_or_default()).collect()
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
fn checked(text: String, control: &'static Control, switches: &Switches, silenced: &[String]) -> JsValue {
    let lines = LineIndex::new(&text);
    let end = text.match_indices('\n').nth(SHOWN as usize - 1).map_or(text.len(), |(at, _)| at);
    let head = text.get(..end).unwrap_or_default().to_owned();
    let parsed = nc::parse_with(&Files::one("", text), control, switches);
    let mut found = nc::review(&parsed, None, &[]);
    silence(&mut found, silenced);
    let rows = js_sys::Array::new();
    for diagnostic in found.iter().take(LISTED) {
        let line = diagnostic.place.map_or(0, |place| lines.line_of(place.span.start));
        let alarm = diagnostic.alarm.as_deref().unwrap_or_default();
        let text = format!("{} {line}: {alarm} {}", t("page.line"), tell(diagnostic));
        rows.push(&object([("tone", tone(diagnostic.severity).into()), ("text", text.into())]));
    }
    let counts = count(&found).map(|(severity, count)| format!("{} {count}", sign(tone(severity)))).join("  ");
    object([
        ("kind", "report".into()),
        ("lines", f64::from(lines.count()).into()),
        ("counts", counts.into()),
        ("head", head.into()),
        ("rows", rows.into()),
    ])
}

/// The warnings about a program.
fn warnings(job: &JsValue, control: &'static Control, switches: &Switches) -> JsValue {
    let (names, texts) = (strings(job, "names"), strings(job, "texts"));
    let files = names.into_iter().zip(texts).map(|(name, text)| File { name, text }).collect();
    let parsed = nc::parse_with(&Files(files), control, switches);
    let set: Vec<u32> =
        js_sys::Array::from(&get(job, "set")).iter().filter_map(|set| Some(set.as_f64()? as u32)).collect();
    let start = get(job, "start").as_f64().map(|start| start as u32);
    let rows: js_sys::Array = nc::warnings(&parsed, start, &set).iter().map(row).collect();
    object([("kind", "warnings".into()), ("number", get(job, "number")), ("rows", rows.into())])
}

/// A warning as plain values; `reviewer` makes one of them again.
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
        ("info", (diagnostic.severity == Severity::Info).into()),
        ("file", u32::from(place.file.0).into()),
        ("start", place.span.start.into()),
        ("end", place.span.end.into()),
        ("hints", diagnostic.hints.iter().map(message).collect::<js_sys::Array>().into()),
        ("fixes", fixes.collect::<js_sys::Array>().into()),
    ])
}

/// The id of a sentence, and its values as they are shown.
fn message(message: &Message) -> JsValue {
    let value = |value: &Value| match value {
        Value::Number(number, decimals) => JsValue::from(number_text(*number, *decimals)),
        Value::Text(text) => text.as_str().into(),
    };
    [message.id.into()].into_iter().chain(message.values.iter().map(value)).collect::<js_sys::Array>().into()
}

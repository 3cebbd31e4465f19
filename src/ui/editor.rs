//! The editor of a program file and its difference to what the form writes, both loaded when first asked for.

use std::cell::Cell;
use std::time::Duration;

use leptos::prelude::*;
use leptos::wasm_bindgen::JsValue;
use leptos::wasm_bindgen::closure::Closure;

use super::dom;
use super::el::{El, el};
use super::listing::class;
use super::model::Model;
use super::script::{call, load, object, set, table};
use super::words::{say, t, tone};
use crate::nc::tokens;
use crate::text::{FileId, Span};

/// The bundle of the editor.
const MODULE: &str = "editor.js";

/// Milliseconds after which what was typed is read.
const PAUSE: Duration = Duration::from_millis(150);

type Handle = StoredValue<Option<JsValue>, LocalStorage>;

/// Where a byte of a text is in JavaScript's count of UTF-16 units.
fn units(text: &str, byte: u32) -> f64 {
    let before = text.get(..byte as usize).unwrap_or(text);
    if before.is_ascii() { before.len() as f64 } else { before.encode_utf16().count() as f64 }
}

/// What both the editor and the difference are told: their name, and how the words of the control are coloured.
fn options(model: Model, label: &'static str) -> JsValue {
    let pieces = move |line: JsValue| {
        let line = line.as_string().unwrap_or_default();
        let control = model.project.with_untracked(|project| project.control);
        let coloured =
            tokens(&line, control).into_iter().map(|(span, kind)| (span, class(kind))).filter(|row| !row.1.is_empty());
        table(coloured.map(|(Span { start, end }, class)| {
            vec![units(&line, start).into(), units(&line, end).into(), class.into()]
        }))
    };
    let pieces = Closure::<dyn Fn(JsValue) -> JsValue>::new(pieces).into_js_value();
    object([("label", t(label).into()), ("pieces", pieces)])
}

/// The findings of a file as the editor takes them.
fn findings(model: Model, at: usize) -> JsValue {
    let list = js_sys::Array::new();
    model.written.with_untracked(|written| {
        let Some(file) = written.files.0.get(at) else { return };
        for (number, diagnostic) in model.findings.get_untracked().iter().enumerate() {
            let Some(place) = diagnostic.place.filter(|place| place.file == FileId(at as u16)) else { continue };
            let Span { start, end } = place.span;
            let text = super::words::tell_alarm(diagnostic);
            let fixes: js_sys::Array = diagnostic.fixes.iter().map(|fix| JsValue::from(say(&fix.title))).collect();
            list.push(&object([
                ("from", units(&file.text, start).into()),
                ("to", units(&file.text, end).into()),
                ("tone", tone(diagnostic.severity).into()),
                ("text", text.into()),
                ("number", (number as u32).into()),
                ("fixes", fixes.into()),
            ]));
        }
    });
    list.into()
}

fn file_text(model: Model, at: usize) -> String {
    model.written.with_untracked(|written| written.files.0.get(at).map(|file| file.text.clone()).unwrap_or_default())
}

/// Takes what was typed last out of the editor into the project, which is detached from its form by that.
pub(super) fn take(model: Model) {
    let Some((at, text)) = model.typed.quietly(Option::take) else { return };
    if text == file_text(model, at) {
        return;
    }
    let files = model.written.with_untracked(|written| written.files.clone());
    model.edit("text", |project| {
        let edited = project.edited.get_or_insert(files);
        if let Some(file) = edited.0.get_mut(at) {
            file.text = text;
        }
    });
}

/// Opens the bundle and what `begin` makes of it in an element; closes it with the element.
fn mount(handle: Handle, begin: impl Fn(&JsValue, &JsValue) -> Result<JsValue, JsValue> + 'static) -> Vec<El> {
    let (host, note) = (el("div.editor"), el("p.note"));
    let (inside, told) = (host.dom().clone(), note.dom().clone());
    wasm_bindgen_futures::spawn_local(async move {
        let opened = load(MODULE).await.and_then(|module| begin(&module, &inside));
        match opened {
            Ok(editor) => drop(handle.try_set_value(Some(editor))),
            Err(error) => told.set_text_content(Some(&format!("{} {}", t("page.editor-failed"), dom::told(&error)))),
        }
    });
    on_cleanup(move || {
        if let Some(Some(editor)) = handle.try_get_value() {
            let _ = call(&editor, "close", &[]);
        }
    });
    vec![host, note]
}

/// The editor of the file that is shown.
pub(super) fn editor(model: Model) -> Vec<El> {
    let handle: Handle = StoredValue::new_local(None);
    let timer = Cell::new(None::<TimeoutHandle>);
    let changed = move |text: JsValue| {
        let Some(text) = text.as_string() else { return };
        if let Some(timer) = timer.take() {
            timer.clear();
        }
        let at = model.file.get_untracked();
        model.typed.quietly(|typed| *typed = Some((at, text)));
        timer.set(set_timeout_with_handle(move || take(model), PAUSE).ok());
    };
    let changed = Closure::<dyn Fn(JsValue)>::new(changed).into_js_value();
    let fix = Closure::<dyn Fn(JsValue, JsValue)>::new(move |diagnostic: JsValue, fix: JsValue| {
        if let (Some(diagnostic), Some(fix)) = (diagnostic.as_f64(), fix.as_f64()) {
            model.apply_fix(diagnostic as usize, fix as usize);
        }
    });
    let options = options(model, "page.listing");
    set(&options, "changed", &changed);
    set(&options, "fix", &fix.into_js_value());
    let all = mount(handle, move |module, host| {
        let at = model.file.get_untracked();
        let editor = call(module, "open", &[host, &file_text(model, at).into(), &options])?;
        call(&editor, "mark", &[&findings(model, at)])?;
        Ok(editor)
    });
    Effect::new(move |_| {
        let at = model.file.get();
        model.findings.track();
        let pending = model.pending.get();
        // What is typed and not read yet is newer than what is said here; once it is read this runs again.
        let typing = model.typed.with_untracked(|typed| typed.as_ref().is_some_and(|(of, _)| *of == at));
        if let Some(Some(editor)) = handle.try_get_value().filter(|_| !typing) {
            let _ = call(&editor, "set", &[&file_text(model, at).into()]);
            // Until all is known of a text, the marks of the text before it stay.
            if !pending {
                let _ = call(&editor, "mark", &[&findings(model, at)]);
            }
        }
    });
    all
}

/// What differs between the program as the form writes it and as it has been edited.
pub(super) fn difference(model: Model) -> Vec<El> {
    let at = model.file.get();
    mount(StoredValue::new_local(None), move |module, host| {
        let edited = file_text(model, at);
        let name = model.written.with_untracked(|written| written.files.0.get(at).map(|file| file.name.clone()));
        let mut generated = model.project.get_untracked();
        generated.edited = None;
        let files = generated.written().files.0;
        let same = files.iter().find(|file| Some(&file.name) == name.as_ref()).or(files.first());
        let before = same.map(|file| file.text.clone()).unwrap_or_default();
        call(module, "difference", &[host, &before.into(), &edited.into(), &options(model, "page.difference")])
    })
}

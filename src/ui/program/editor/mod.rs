//! The editor of a program file and its difference to the form's program, both loaded when first opened.

use std::cell::Cell;
use std::time::Duration;

use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsValue;
use leptos::wasm_bindgen::closure::Closure;

use crate::nc::tokens;
use crate::text::{FileId, Span, utf16, with_aside};
use crate::ui::dom::{
    self,
    script::{call, load, object, set, table},
};
use crate::ui::parts::listing::class;
use crate::ui::parts::phrases::phrases;
use crate::ui::parts::{Glyph, Icon};
use crate::ui::state::Page;
use crate::ui::words::{Tone, sentence, t, tell_alarm};

use super::{navigation, points};

/// The bundle of the editor.
const MODULE: &str = "editor.js";

/// Milliseconds without a key before the typed text is read.
const PAUSE: Duration = Duration::from_millis(150);

type Handle = StoredValue<Option<JsValue>, LocalStorage>;

/// Converts a byte offset of a text to UTF-16 units, as JavaScript counts.
fn units(text: &str, byte: u32) -> f64 {
    f64::from(utf16::units(text, byte))
}

/// Options of both the editor and the difference: their name, and the colours of the control's words.
fn options(page: Page, label: &'static str) -> JsValue {
    let pieces = move |line: JsValue| {
        let line = line.as_string().unwrap_or_default();
        let control = page.project.with_untracked(|project| project.control);
        let coloured =
            tokens(&line, control).into_iter().map(|(span, kind)| (span, class(kind))).filter(|row| !row.1.is_empty());
        table(coloured.map(|(Span { start, end }, class)| {
            vec![units(&line, start).into(), units(&line, end).into(), class.into()]
        }))
    };
    let pieces = Closure::<dyn Fn(JsValue) -> JsValue>::new(pieces).into_js_value();
    object([("label", t(label).into()), ("pieces", pieces), ("phrases", phrases())])
}

/// The findings of a file as the editor takes them.
fn findings(page: Page, at: usize) -> JsValue {
    let list = js_sys::Array::new();
    page.program.written.with_untracked(|written| {
        let Some(file) = written.files.0.get(at) else { return };
        for (number, diagnostic) in page.program.findings.get_untracked().iter().enumerate() {
            let Some(place) = diagnostic.place.filter(|place| place.file == FileId(at as u16)) else { continue };
            let Span { start, end } = place.span;
            let text = tell_alarm(diagnostic);
            let fixes: js_sys::Array = diagnostic.fixes.iter().map(|fix| JsValue::from(sentence(&fix.title))).collect();
            list.push(&object([
                ("from", units(&file.text, start).into()),
                ("to", units(&file.text, end).into()),
                ("tone", Tone::from(diagnostic.severity).class().into()),
                ("text", text.into()),
                ("number", (number as u32).into()),
                ("fixes", fixes.into()),
            ]));
        }
    });
    list.into()
}

/// The element of the bundle: opens it with `begin`, closes it when the element goes.
#[component]
fn Bundle(
    /// The editor, once the bundle has opened it.
    handle: Handle,
    /// Opens the editor: the module of the bundle, and the element.
    begin: impl Fn(&JsValue, &JsValue) -> Result<JsValue, JsValue> + 'static,
) -> impl IntoView {
    let host: NodeRef<html::Div> = NodeRef::new();
    let failed = RwSignal::new(String::new());
    host.on_load(move |host| {
        wasm_bindgen_futures::spawn_local(async move {
            match load(MODULE).await.and_then(|module| begin(&module, &host)) {
                Ok(editor) => drop(handle.try_set_value(Some(editor))),
                Err(error) => drop(failed.try_set(format!("{} {}", t("page.editor-failed"), dom::error_text(&error)))),
            }
        });
    });
    on_cleanup(move || {
        if let Some(Some(editor)) = handle.try_get_value() {
            let _ = call(&editor, "close", &[]);
        }
    });
    view! { <div class="editor" node_ref=host></div><p class="note">{failed}</p> }
}

/// Shows the running block of a file, without the focus.
fn show_running(page: Page, editor: &JsValue, file: usize) -> Result<(), JsValue> {
    let running = page.player.running.get_untracked().filter(|place| usize::from(place.file.0) == file);
    if let Some(place) = running {
        call(editor, "reveal", &[&units(&page.program.text(file), place.span.start).into()])?;
    }
    Ok(())
}

/// Sets the cursor of the editor to the place that is sought, or shows its file first.
fn seek(page: Page, editor: &JsValue, file: usize) {
    let Some(place) = page.view.sought.get() else { return };
    if usize::from(place.file.0) != file {
        return page.view.file.set(place.file.0.into());
    }
    page.view.sought.set(None);
    let _ = call(editor, "go", &[&units(&page.program.text(file), place.span.start).into()]);
}

/// Whether the editor has newer text of a file than findings and places, which are renewed once it is read.
fn is_typed(page: Page, file: usize) -> bool {
    page.program.typed.with_value(|typed| typed.as_ref().is_some_and(|(of, _)| *of == file))
}

/// The editor of the chosen file.
#[component]
pub(super) fn Editor() -> impl IntoView {
    let page = Page::here();
    let handle: Handle = StoredValue::new_local(None);
    let timer = Cell::new(None::<TimeoutHandle>);
    let changed = move |file: JsValue, text: JsValue| {
        let (Some(file), Some(text)) = (file.as_f64(), text.as_string()) else { return };
        if let Some(timer) = timer.take() {
            timer.clear();
        }
        page.program.typed.set_value(Some((file as usize, text)));
        timer.set(set_timeout_with_handle(move || page.take_typed(), PAUSE).ok());
    };
    let changed = Closure::<dyn Fn(JsValue, JsValue)>::new(changed).into_js_value();
    let fix = Closure::<dyn Fn(JsValue, JsValue)>::new(move |diagnostic: JsValue, fix: JsValue| {
        if let (Some(diagnostic), Some(fix)) = (diagnostic.as_f64(), fix.as_f64()) {
            page.apply_fix(diagnostic as usize, fix as usize);
        }
    });
    let breakpoints = points::all(page);
    let options = options(page, "page.listing");
    set(&options, "changed", &changed);
    set(&options, "fix", &fix.into_js_value());
    set(&options, "toggle", &points::toggle(page));
    navigation::add(page, &options);
    let begin = move |module: &JsValue, host: &JsValue| {
        let at = page.view.file.get_untracked();
        let editor = call(module, "open", &[host, &at.into(), &page.program.text(at).into(), &options])?;
        call(&editor, "mark", &[&findings(page, at)])?;
        call(&editor, "points", &[&breakpoints.with_untracked(|all| points::lines(page, at, all))])?;
        if untrack(|| page.view.sought.with(Option::is_none)) {
            show_running(page, &editor, at)?;
        }
        untrack(|| seek(page, &editor, at));
        Ok(editor)
    };
    Effect::new(move |_| {
        let at = page.view.file.get();
        page.view.sought.track();
        page.program.findings.track();
        page.program.written.track();
        let (pending, breakpoints) = (page.program.pending.get(), breakpoints.get());
        if let Some(Some(editor)) = handle.try_get_value().filter(|_| !is_typed(page, at)) {
            let _ = call(&editor, "show", &[&at.into(), &page.program.text(at).into()]);
            let _ = call(&editor, "points", &[&points::lines(page, at, &breakpoints)]);
            // The marks of the earlier text stay until the new text is reviewed.
            if !pending {
                let _ = call(&editor, "mark", &[&findings(page, at)]);
            }
            untrack(|| seek(page, &editor, at));
        }
    });
    let run = move |name: &'static str| {
        if let Some(Some(editor)) = handle.try_get_value() {
            let _ = call(&editor, "run", &[&name.into()]);
        }
    };
    view! {
        <Commands run=run />
        <Bundle handle=handle begin=begin />
    }
}

/// Names of the editor's commands, with catalog ids of their words and their keys.
const COMMANDS: [(&str, &str, &str); 7] = [
    ("outline", "page.go-to-place", "Ctrl+Shift+O"),
    ("define", "page.definition", "F12"),
    ("uses", "page.uses", "Shift+F12"),
    ("meaning", "page.meaning", "Ctrl+I"),
    ("findings", "page.findings", "Ctrl+."),
    ("toggle", "page.stepping-breakpoint", "F9"),
    ("find", "page.find", "Ctrl+F"),
];

/// The editor's commands as buttons, for the word and the line of its cursor.
#[component]
fn Commands(
    /// Does a command, by its name.
    run: impl Fn(&'static str) + Copy + 'static,
) -> impl IntoView {
    let button = move |(name, words, keys): (&'static str, &'static str, &'static str)| {
        let words = t(words);
        let content = match name {
            "toggle" => "●".into_any(),
            "find" => view! { <Icon glyph=Glyph::Find /> }.into_any(),
            _ => words.into_any(),
        };
        view! {
            <button
                type="button" class="quiet" title=with_aside(words, keys) aria-label=words
                aria-keyshortcuts=keys.replace("Ctrl", "Control") data-asks=(name == "meaning").then_some("")
                on:click=move |_| run(name)
            >
                {content}
            </button>
        }
    };
    view! {
        <div class="bar tools commands" role="group" aria-label=t("page.navigation")>
            {COMMANDS.map(button).collect_view()}
        </div>
    }
}

/// The difference between the program that the form writes and the edited one.
#[component]
pub(super) fn Difference() -> impl IntoView {
    let page = Page::here();
    move || {
        let at = page.view.file.get();
        let begin = move |module: &JsValue, host: &JsValue| {
            let edited = page.program.text(at);
            let name = page.program.written.with_untracked(|w| w.files.0.get(at).map(|file| file.name.clone()));
            let mut generated = page.project.get_untracked();
            generated.edited = None;
            let files = generated.written().files.0;
            let same = files.iter().find(|file| Some(&file.name) == name.as_ref()).or(files.first());
            let before = same.map(|file| file.text.clone()).unwrap_or_default();
            call(module, "difference", &[host, &before.into(), &edited.into(), &options(page, "page.difference")])
        };
        view! { <Bundle handle=StoredValue::new_local(None) begin=begin /> }
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, until};

    #[wasm_bindgen_test]
    fn places_are_counted_in_the_units_of_javascript() {
        assert_eq!([0, 1, 3, 6].map(|byte| units("aé€b", byte)), [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(units("(😀)M", 6), 4.0);
    }

    #[wasm_bindgen_test]
    async fn editor_that_cannot_be_loaded_gives_a_notice() {
        let bench = mount(|| view! { <Editor /> }).await;
        let note = bench.find(".note");
        until(move || note.text_content().is_some_and(|text| text.starts_with(t("page.editor-failed")))).await;
        assert!(!bench.page.program.edited.get_untracked());
    }
}

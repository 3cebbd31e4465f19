//! Files in and out: open, drop and paste; save the project; export the program.

use std::time::Duration;

use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use wasm_bindgen_futures::JsFuture;
use web_sys::{ClipboardEvent, DataTransfer, DragEvent, Element, File};

use super::checker::{self, Source};
use super::dom;
use super::model::Model;
use super::words::{say, t, tell, tone};
use crate::msg;
use crate::nc::{self, Files};
use crate::project::Project;
use crate::project::export::Export;
use crate::project::open::{MAX_PROGRAM, open};
use crate::text::{Diagnostic, Severity};

/// Bytes above which a text is not taken into the page but read aside.
const BIG: f64 = MAX_PROGRAM as f64;

/// A name for a file, of what the user calls the project.
pub(super) fn file_name(model: Model, ending: &str) -> String {
    let name = model.project.with_untracked(|project| project.name.trim().to_lowercase());
    let plain: String = name.chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
    let plain = plain.trim_matches('-');
    format!("{}.{ending}", if plain.is_empty() { "macroline" } else { plain })
}

/// Saves the project as a file.
pub(super) fn save(model: Model) {
    let text = model.project.with_untracked(Project::to_json);
    dom::download(&file_name(model, "json"), "application/json", text.as_bytes());
}

/// Begins a fresh project of the same machine and control.
pub(super) fn fresh(model: Model) {
    let (machine, control) = model.project.with_untracked(|project| (project.machine, project.control));
    model.replace(Project::new(machine, control));
}

/// Takes the files that a person opened, dropped or pasted.
fn take(model: Model, files: Vec<File>) {
    if let Some(big) = files.iter().find(|file| file.size() > BIG) {
        checker::check(model, Source::File(big.clone()));
        return;
    }
    leptos::task::spawn_local(async move {
        let mut texts = Vec::new();
        for file in files {
            let Ok(buffer) = JsFuture::from(file.array_buffer()).await else { continue };
            let bytes = js_sys::Uint8Array::new(&buffer).to_vec();
            texts.push(nc::File { name: file.name(), text: String::from_utf8_lossy(&bytes).into_owned() });
        }
        if !texts.is_empty() {
            read(model, texts);
        }
    });
}

/// Reads texts: a project, a program that carries its settings, or any other programs.
fn read(model: Model, files: Vec<nc::File>) {
    let Some(first) = files.first() else { return };
    let text = first.text.trim_start_matches('\u{feff}');
    let opened = model.project.with_untracked(|project| open(project, &first.name, text));
    for told in &opened.diagnostics {
        model.notify(tone(told.severity), tell(told));
    }
    let Some(mut project) = opened.project else { return };
    if project.edited.is_some() && !text.starts_with('{') {
        project.edited = Some(Files(files));
        model.notify("info", t("page.opened-program").to_owned());
    }
    model.file.set(0);
    model.tab.set(super::side::Tab::Program);
    model.replace(project);
    model.say(t("page.opened"));
}

fn dropped(model: Model, data: &DataTransfer) -> bool {
    let list = data
        .files()
        .map(|list| (0..list.length()).filter_map(|at| list.get(at)).collect::<Vec<_>>())
        .unwrap_or_default();
    if !list.is_empty() {
        take(model, list);
        return true;
    }
    let text = data.get_data("text").unwrap_or_default();
    if text.len() as f64 > BIG {
        checker::check(model, Source::Text(text));
    } else if text.trim().is_empty() {
        return false;
    } else {
        read(model, vec![nc::File { name: t("page.pasted").to_owned(), text }]);
    }
    true
}

/// Listens for files that are dropped or pasted anywhere on the page.
pub(super) fn listen(model: Model) {
    let _ = window_event_listener(leptos::ev::dragover, |event: DragEvent| event.prevent_default());
    let _ = window_event_listener(leptos::ev::drop, move |event: DragEvent| {
        event.prevent_default();
        if let Some(data) = event.data_transfer() {
            dropped(model, &data);
        }
    });
    // Before any text field gets it: a paste of many megabytes must not go into one.
    let paste =
        leptos::wasm_bindgen::closure::Closure::<dyn FnMut(ClipboardEvent)>::new(move |event: ClipboardEvent| {
            let Some(data) = event.clipboard_data() else { return };
            let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
            let in_text = target.is_some_and(|target| dom::takes_text(&target));
            if in_text && (data.get_data("text").map_or(0, |text| text.len()) as f64) < BIG {
                return;
            }
            if dropped(model, &data) {
                event.prevent_default();
                event.stop_propagation();
            }
        });
    let _ = document().add_event_listener_with_callback_and_bool("paste", paste.as_ref().unchecked_ref(), true);
    paste.forget();
}

/// The button that opens files.
pub(super) fn open_button(model: Model) -> AnyView {
    let input: NodeRef<html::Input> = NodeRef::new();
    let chosen = move |_| {
        let Some(input) = input.get() else { return };
        if let Some(list) = input.files() {
            take(model, (0..list.length()).filter_map(|at| list.get(at)).collect());
        }
        // The same file may be opened twice in a row.
        input.set_value("");
    };
    view! {
        <input type="file" id="open" class="hidden" multiple node_ref=input aria-label=t("page.open") on:change=chosen />
        <button type="button" class="quiet" id="open-button" title=t("page.open-about") on:click=move |_| if let Some(input) = input.get() { input.click() }>{t("page.open")}</button>
    }
    .into_any()
}

/// Everything that keeps the program from being exported.
fn reasons(model: Model, export: &Export) -> Vec<Diagnostic> {
    let mut found = model.wrong_fields();
    let errors = export.diagnostics.iter().filter(|d| d.severity == Severity::Error);
    found.extend(errors.filter(|d| !found.contains(d)).cloned().collect::<Vec<_>>());
    found
}

/// The dialog of the export: what is written, or why nothing is.
pub(super) fn export_dialog(model: Model) -> AnyView {
    let node: NodeRef<html::Dialog> = NodeRef::new();
    let export = RwSignal::new_local(None::<Export>);
    Effect::new(move |_| {
        if model.exporting.get()
            && let Some(dialog) = node.get()
        {
            export.set(Some(model.project.with_untracked(Project::export)));
            let _ = dialog.show_modal();
            model.exporting.set(false);
        }
    });
    let close = move |_| {
        if let Some(dialog) = node.get() {
            dialog.close();
        }
    };
    let content = move || {
        export.with(|export| {
            let export = export.as_ref()?;
            let reasons = reasons(model, export);
            Some(if reasons.is_empty() { offered(export) } else { refused(&reasons) })
        })
    };
    view! {
        <dialog node_ref=node class="dialog" aria-labelledby="export-title">
            <header><h2 id="export-title">{t("page.export")}</h2><button type="button" class="icon" aria-label=t("page.close") on:click=close>"✕"</button></header>
            {content}
        </dialog>
    }
    .into_any()
}

fn refused(reasons: &[Diagnostic]) -> AnyView {
    let rows: Vec<_> = reasons
        .iter()
        .map(|reason| {
            let field = reason.field;
            let go = move |_| {
                if let Some(input) = field.and_then(dom::by_id) {
                    input.scroll_into_view();
                    let _ = input.focus();
                }
            };
            view! {
                <li class="fail"><i aria-hidden="true">"✕"</i> {reason.alarm.map(|alarm| view! { <b>{alarm} " "</b> })} {tell(reason)}
                    {field.map(|_| view! { " " <button type="button" class="link" on:click=go formmethod="dialog">{t("page.go-to-field")}</button> })}</li>
            }
        })
        .collect();
    view! { <p>{t("page.refused")}</p> <ul class="remarks">{rows}</ul> }.into_any()
}

fn offered(export: &Export) -> AnyView {
    let files = export.files.clone();
    let rows: Vec<_> = files
        .iter()
        .map(|file| {
            let (name, text) = (file.name.clone(), file.text.clone());
            let size = say(&msg!("page.bytes", text.len() as f64));
            let label = name.clone();
            let save = move |_| dom::download(&name, "text/plain", text.as_bytes());
            view! { <tr><th scope="row">{label}</th><td>{size}</td><td><button type="button" on:click=save>{t("page.save-file")}</button></td></tr> }
        })
        .collect();
    // Browsers drop all but the first of several downloads that begin at the same moment.
    let all = move |_| {
        for (at, file) in files.iter().cloned().enumerate() {
            let save = move || dom::download(&file.name, "text/plain", file.text.as_bytes());
            set_timeout(save, Duration::from_millis(200 * at as u64));
        }
    };
    let remarks: Vec<_> =
        export.diagnostics.iter().map(|d| view! { <li class=tone(d.severity)>{tell(d)}</li> }).collect();
    view! {
        <p>{t("page.export-about")}</p>
        <table class="exported"><tbody>{rows}</tbody></table>
        <ul class="remarks">{remarks}</ul>
        <footer><button type="button" class="primary" id="save-all" on:click=all>{t("page.save-all")}</button></footer>
    }
    .into_any()
}

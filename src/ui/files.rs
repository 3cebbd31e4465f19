//! Files in and out: open, drop and paste; save the project; export the program.

use std::rc::Rc;
use std::time::Duration;

use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use wasm_bindgen_futures::JsFuture;
use web_sys::{ClipboardEvent, DataTransfer, DragEvent, Element, File, HtmlDialogElement};

use super::checker::{self, Source};
use super::dom;
use super::el::{El, button, el};
use super::help::dialog;
use super::local::Local;
use super::model::Model;
use super::state::Tab;
use super::words::{say, t, tell, tone};
use super::worker::messages::{Remark, Request, Response};
use crate::msg;
use crate::nc;
use crate::project::Project;
use crate::project::decode::Decoded;
use crate::project::import::{MAX_PROGRAM, open, programs};
use crate::project::saved::with_line;

/// Bytes above which a text is not taken into the page but read aside.
const BIG: f64 = MAX_PROGRAM as f64;

/// A name for a file, of what the user calls the project.
pub(super) fn file_name(model: Model, ending: &str) -> String {
    let name = model.project.with_untracked(|project| project.name.trim().to_ascii_lowercase());
    let plain: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
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
    model.say(t("page.fresh"));
}

/// Takes the files that a person opened, dropped or pasted.
fn take(model: Model, files: Vec<File>) {
    if let Some(big) = files.iter().find(|file| file.size() > BIG) {
        checker::check(model, Source::File(big.clone()));
        return;
    }
    wasm_bindgen_futures::spawn_local(async move {
        let mut texts = Vec::new();
        for file in files {
            let Ok(buffer) = JsFuture::from(file.array_buffer()).await else { continue };
            let bytes = js_sys::Uint8Array::new(&buffer).to_vec();
            texts.push(nc::File { name: file.name(), text: Decoded::new(bytes).text });
        }
        if !texts.is_empty() {
            read(model, &texts);
        }
    });
}

/// Reads texts: a project, a program that carries its settings, or any other programs.
fn read(model: Model, files: &[nc::File]) {
    let Some(first) = files.first() else { return };
    let text = first.text.trim_start_matches('\u{feff}');
    let opened = model.project.with_untracked(|project| open(project, &first.name, text));
    for told in &opened.diagnostics {
        model.notify(tone(told.severity), with_line(told, text));
    }
    let Some(mut project) = opened.project else { return };
    if project.edited.is_some() && !text.starts_with('{') {
        match programs(files) {
            Ok(files) => project.edited = Some(files),
            Err(finding) => {
                model.notify("error", tell(&finding));
                return;
            }
        }
        model.notify("info", t("page.opened-program").to_owned());
    }
    model.file.set(0);
    model.tab.set(Tab::Program);
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
        read(model, &[nc::File { name: t("page.pasted").to_owned(), text }]);
    }
    true
}

/// Listens for files that are dropped or pasted anywhere on the page.
pub(super) fn listen(model: Model) {
    dom::hear("dragover", |event| event.prevent_default());
    dom::hear("drop", move |event| {
        event.prevent_default();
        if let Some(data) = event.unchecked_ref::<DragEvent>().data_transfer() {
            dropped(model, &data);
        }
    });
    // Before any text field gets it: a paste of many megabytes must not go into one.
    dom::hear("paste", move |event| {
        let Some(data) = event.unchecked_ref::<ClipboardEvent>().clipboard_data() else { return };
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
}

/// The button that opens files, and the input behind it.
pub(super) fn open_button(model: Model) -> [El; 2] {
    let input =
        el("input.hidden#open").at("type", "file").at("multiple", "").at("tabindex", "-1").label(t("page.open"));
    let (chosen, node) = (input.input().clone(), input.html().clone());
    let take = move |_| {
        let files = chosen.files().map(|list| (0..list.length()).filter_map(|at| list.get(at)).collect());
        take(model, files.unwrap_or_default());
        // The same file may be opened twice in a row.
        chosen.set_value("");
    };
    let button = button("button.quiet", t("page.open"), move || node.click()).at("title", t("page.open-about"));
    [input.on("change", take), button]
}

/// An export: the files that the page runs, and the worker's documents about them.
struct Export {
    /// Programs first.
    files: Rc<[(String, String)]>,
    /// Findings about fields and program.
    remarks: Vec<Remark>,
}

/// The reasons that refuse the export: alarm, sentence, field.
fn reasons(model: Model, export: &Export) -> Vec<[String; 3]> {
    let wrong =
        model.wrong_fields().into_iter().map(|d| [String::new(), tell(&d), d.field.unwrap_or_default().to_owned()]);
    let mut found: Vec<[String; 3]> = wrong.collect();
    for Remark { alarm, text, field, .. } in export.remarks.iter().filter(|remark| remark.refuses).cloned() {
        let row = [alarm, text, field];
        if !found.contains(&row) {
            found.push(row);
        }
    }
    found
}

/// The dialog of the export: what is written, or why nothing is.
pub(super) fn export_dialog(model: Model) -> El {
    let asked = Local::new(false);
    let export = Local::new(None::<Export>);
    let open = move || {
        if !model.exporting.get() {
            return;
        }
        model.exporting.set(false);
        // The programs of this moment, which are those that run; the documents are about the same project.
        let written = model.written.get_untracked();
        let put = move |response: Option<Response>| {
            let Some(Response::Export(documents)) = response else {
                return model.notify("fail", t("page.no-answer").to_owned());
            };
            let programs = written.files.0.iter().map(|file| (file.name.clone(), file.text.clone()));
            export.set(Some(Export { files: programs.chain(documents.files).collect(), remarks: documents.remarks }));
            asked.set(true);
        };
        model.project.with_untracked(|project| model.worker.ask(project, Request::Export, put));
    };
    let content = move || {
        export.with(|export| {
            let Some(export) = export else { return Vec::new() };
            let reasons = untrack(|| reasons(model, export));
            if reasons.is_empty() { offered(export) } else { refused(reasons) }
        })
    };
    dialog("export-title", t("page.export"), asked).add(&[el("div.body-of").swap(content)]).run(open)
}

fn refused(reasons: Vec<[String; 3]>) -> Vec<El> {
    let row = |[alarm, reason, field]: [String; 3]| {
        let row = el("li.fail").add(&[el("i").at("aria-hidden", "true").text("✕ "), el("b").text(&alarm)]);
        let go = (!field.is_empty()).then(|| button("button.link", t("page.go-to-field"), move || go_to(&field)));
        row.text(" ").text(&reason).text(" ").maybe(go)
    };
    let rows: Vec<El> = reasons.into_iter().map(row).collect();
    vec![el("p").text(t("page.refused")), el("ul.remarks").add(&rows)]
}

/// Leaves the dialog, if there is one, for a field of the form.
pub(super) fn go_to(field: &str) {
    if let Ok(Some(open)) = document().query_selector("dialog[open]") {
        open.unchecked_into::<HtmlDialogElement>().close();
    }
    if let Some(input) = dom::by_id(field) {
        if let Ok(Some(group)) = input.closest("details") {
            dom::set(&group, "open", "");
        }
        input.scroll_into_view();
        let _ = input.focus();
    }
}

fn offered(export: &Export) -> Vec<El> {
    let files = Rc::clone(&export.files);
    let rows: Vec<El> = (0..files.len())
        .map(|at| {
            let (name, text) = &files[at];
            let size = say(&msg!("page.bytes", text.len() as f64));
            let head = el("th").at("scope", "row").text(name);
            let files = Rc::clone(&files);
            let save = button("button", t("page.save-file"), move || save_file(&files, at));
            el("tr").add(&[head, el("td").text(&size), el("td").add(&[save])])
        })
        .collect();
    // Browsers drop all but the first of several downloads that begin at the same moment.
    let all = move || {
        for at in 0..files.len() {
            let files = Rc::clone(&files);
            set_timeout(move || save_file(&files, at), Duration::from_millis(200 * at as u64));
        }
    };
    let remarks: Vec<El> =
        export.remarks.iter().map(|remark| el("li").at("class", &remark.tone).text(&remark.text)).collect();
    vec![
        el("p").text(t("page.export-about")),
        el("table.exported").add(&[el("tbody").add(&rows)]),
        el("ul.remarks").add(&remarks),
        el("footer").add(&[button("button.primary#save-all", t("page.save-all"), all)]),
    ]
}

fn save_file(files: &[(String, String)], at: usize) {
    if let Some((name, text)) = files.get(at) {
        dom::download(name, "text/plain", text.as_bytes());
    }
}

//! The export: the files that the page runs, and the worker's documents about them.

use std::sync::Arc;

use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;

use super::print::PrintButton;
use super::title_block::TitleBlockFields;
use crate::nc::File;
use crate::project::Project;
use crate::project::export::{REPORT, SUMMARY};
use crate::text::Place;
use crate::ui::dom::script::{call, load, table};
use crate::ui::dom::{self, go_to_field};
use crate::ui::parts::Dialog;
use crate::ui::state::Page;
use crate::ui::words::{Tone, figure, sentence, sentence_with_hints, t};
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::{ExportDocuments, ExportProject, ExportedDocument, Range, Remark};

/// The bundle that makes archives.
const ARCHIVE: &str = "archive.js";

/// A file of the export.
struct ExportFile {
    name: String,
    bytes: Vec<u8>,
    /// Kind of the file, in words.
    meaning: String,
}

/// An export that is offered.
#[derive(Clone)]
struct Export {
    /// Programs first.
    files: Arc<[ExportFile]>,
    /// The report without programs, as HTML, where the export is refused.
    draft: Option<String>,
    /// Findings about fields and program.
    remarks: Vec<Remark>,
}

/// A reason that refuses the export.
#[derive(Clone, PartialEq)]
struct ExportProblem {
    /// Number of the alarm, or name of the field.
    alarm: String,
    text: String,
    /// Id of the field, or empty.
    field: String,
    /// The place in the programs.
    place: Option<Range>,
}

fn reasons(page: Page, export: &Export) -> Vec<ExportProblem> {
    let fields = page.project.with(|project| project.machine.fields());
    let label = |id: &str| fields.iter().find(|field| field.id == id).map_or("", |field| t(field.label)).to_owned();
    let wrong = page.wrong_fields().into_iter().map(|found| {
        let field = found.field.unwrap_or_default().to_owned();
        ExportProblem { alarm: label(&field), text: sentence_with_hints(&found), field, place: None }
    });
    let mut found: Vec<ExportProblem> = wrong.collect();
    for Remark { alarm, text, field, place, .. } in export.remarks.iter().filter(|remark| remark.refuses).cloned() {
        let alarm = if alarm.is_empty() { label(&field) } else { alarm };
        let reason = ExportProblem { alarm, text, field, place };
        if !found.contains(&reason) {
            found.push(reason);
        }
    }
    found
}

/// The dialog of the export: the files, or the reasons why nothing is exported.
#[component]
pub(crate) fn ExportDialog() -> impl IntoView {
    let (page, worker) = (Page::here(), Client::here());
    let open = RwSignal::new(false);
    let export = RwSignal::new(None::<Export>);
    Effect::new(move |_| {
        if !page.view.exporting.get() {
            return;
        }
        page.view.exporting.set(false);
        // The export has the programs of this moment, the ones that the page runs; the documents are about the same project.
        let written = page.program.written.get_untracked();
        let take = move |documents: Option<ExportDocuments>| {
            let Some(documents) = documents else {
                return page.notices.notify(Tone::Fail, t("page.no-answer").to_owned());
            };
            let mut coded = documents.programs.into_iter();
            let bytes = |text: &str| text.as_bytes().to_vec();
            let program = |file: &File| ExportFile {
                name: file.name.clone(),
                bytes: coded.next().unwrap_or_else(|| bytes(&file.text)),
                meaning: t("page.file.program").to_owned(),
            };
            let programs: Vec<_> = written.files.0.iter().map(program).collect();
            let other =
                |ExportedDocument { name, meaning, text }| ExportFile { name, bytes: text.into_bytes(), meaning };
            let files = programs.into_iter().chain(documents.files.into_iter().map(other)).collect();
            export.set(Some(Export { files, draft: documents.draft, remarks: documents.remarks }));
            open.set(true);
        };
        page.project.with_untracked(|project| worker.ask(project, ExportProject, take));
    });
    let content = move || {
        let export = export.get()?;
        let reasons = untrack(|| reasons(page, &export));
        Some(if reasons.is_empty() {
            view! { <Offered export=export /> }.into_any()
        } else {
            view! { <Refused reasons=reasons draft=export.draft close=move || open.set(false) /> }.into_any()
        })
    };
    view! {
        <Dialog id="export-title" title=t("page.export-short") open=open close=move || open.set(false)>
            <div class="body-of">
                <TitleBlockFields />
                {content}
            </div>
        </Dialog>
    }
}

/// The reasons why nothing is exported.
#[component]
fn Refused(
    /// The reasons.
    reasons: Vec<ExportProblem>,
    /// The report without programs, as HTML.
    draft: Option<String>,
    /// Closes the dialog.
    close: impl Fn() + Copy + 'static,
) -> impl IntoView {
    let page = Page::here();
    let row = |ExportProblem { alarm, text, field, place }: ExportProblem| {
        let to_field = (!field.is_empty()).then(|| {
            view! { <button type="button" class="link" on:click=move |_| go_to_field(&field)>{t("page.go-to-field")}</button> }
        });
        let to_place = place.map(Place::from).and_then(|place| {
            let lead = move |_| {
                close();
                page.show_place(place);
            };
            let words = page.place_words(place)?;
            Some(view! { <button type="button" class="link" on:click=lead>{words}</button> })
        });
        view! { <li class="fail"><i aria-hidden="true">{Tone::Fail.sign()} " "</i><b>{alarm}</b> " " {text} " " {to_field} {to_place}</li> }
    };
    view! {
        <p>{t("page.refused")}</p>
        <ul class="remarks">{reasons.into_iter().map(row).collect_view()}</ul>
        {draft.map(|html| view! { <footer><PrintButton id="print-draft" words="page.print-draft" html=html /></footer> })}
    }
}

/// Size of a file in words: bytes, or kilobytes from 1000 on.
fn size(bytes: usize) -> String {
    match bytes {
        ..1000 => sentence(&crate::msg!("page.bytes", count = figure(bytes as f64, 0))),
        _ => sentence(&crate::msg!("page.kilobytes", count = figure((bytes as f64 / 1000.0).ceil(), 0))),
    }
}

/// The files.
#[component]
fn Offered(
    /// The export.
    export: Export,
) -> impl IntoView {
    let files = Arc::clone(&export.files);
    let row = move |at: usize| {
        let files = Arc::clone(&files);
        let ExportFile { name, bytes, meaning } = files.get(at)?;
        let (name, what, size) = (name.clone(), meaning.clone(), size(bytes.len()));
        Some(view! {
            <tr>
                <th scope="row">{name}</th>
                <td class="what">{what}</td>
                <td>{size}</td>
                <td><button type="button" on:click=move |_| save(&files, at)>{t("page.save-file")}</button></td>
            </tr>
        })
    };
    let rows = (0..export.files.len()).map(row).collect_view();
    let page = Page::here();
    let files = Arc::clone(&export.files);
    let all = move |_| save_all(page, Arc::clone(&files));
    let printed = |id: &'static str, words: &'static str, document: &str| {
        let file = export.files.iter().find(|file| file.name == document)?;
        let html = String::from_utf8_lossy(&file.bytes).into_owned();
        Some(view! { <PrintButton id=id words=words html=html /> })
    };
    let summary = printed("print-summary", "page.print-summary", SUMMARY);
    let report = printed("print-report", "page.print-report", REPORT);
    let remarks =
        export.remarks.iter().map(|remark| view! { <li class=remark.tone.class()>{remark.text.clone()}</li> });
    let failing = untrack(|| page.results.failing());
    let failing = (failing > 0).then(|| {
        let words = sentence(&crate::msg!("page.results-fail", count = failing));
        view! { <li class="fail"><b><i aria-hidden="true">{Tone::Fail.sign()} " "</i>{words}</b></li> }
    });
    view! {
        <div class="prints">{report} {summary}</div>
        <p>{t("page.export-about")}</p>
        <ul class="remarks" tabindex="0">{failing} {remarks.collect_view()}</ul>
        <div class="files" tabindex="0" role="group" aria-label=t("page.export-files")>
            <table class="exported"><tbody>{rows}</tbody></table>
        </div>
        <footer>
            <button type="button" class="primary" id="save-all" on:click=all>{t("page.save-all")}</button>
        </footer>
    }
}

/// Saves all files as one archive.
fn save_all(page: Page, files: Arc<[ExportFile]>) {
    let name = page.project.with_untracked(Project::archive_name);
    wasm_bindgen_futures::spawn_local(async move {
        let list = table(
            files
                .iter()
                .map(|file| vec![file.name.as_str().into(), js_sys::Uint8Array::from(file.bytes.as_slice()).into()]),
        );
        let archive = load(ARCHIVE).await.and_then(|module| call(&module, "zip", &[&list]));
        match archive.and_then(|archive| archive.dyn_into::<js_sys::Uint8Array>()) {
            Ok(bytes) => dom::download(&name, "application/zip", &bytes.to_vec()),
            Err(error) => page
                .notices
                .notify(Tone::Fail, sentence(&crate::msg!("page.no-archive", reason = dom::error_text(&error)))),
        }
    });
}

fn save(files: &[ExportFile], at: usize) {
    if let Some(file) = files.get(at) {
        dom::download(&file.name, "text/plain", &file.bytes);
    }
}

#[cfg(test)]
mod tests {
    use leptos::wasm_bindgen::JsValue;
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::machines::form::Value;
    use crate::text::{FileId, Span};
    use crate::ui::testing::{ViewBench, field, mount, settled};
    use crate::ui::worker::messages::{Ask, Request};

    fn documents(_: &Project, _: &Request) -> Option<JsValue> {
        ExportProject.answer(&ExportDocuments {
            programs: Vec::new(),
            files: vec![ExportedDocument {
                name: "report.html".to_owned(),
                meaning: "Report".to_owned(),
                text: "<p>".to_owned(),
            }],
            draft: None,
            remarks: Vec::new(),
        })
    }

    async fn asked(bench: &ViewBench) {
        bench.page.view.exporting.set(true);
        settled().await;
    }

    #[wasm_bindgen_test]
    async fn entry_of_the_title_block_is_saved_and_can_be_undone() {
        let bench = mount(|| view! { <ExportDialog /> }).await;
        bench.worker.answer_here(documents);
        asked(&bench).await;
        bench.choose(".title-block label:nth-of-type(3) input", "ML-4711").await;
        let number = || bench.page.project.with_untracked(|project| project.title_block.number.clone());
        assert_eq!(number(), "ML-4711");
        assert!(bench.has("dialog[open] #save-all"));
        bench.page.undo();
        settled().await;
        assert_eq!(number(), "");
    }

    #[wasm_bindgen_test]
    async fn customer_entered_at_the_export_is_in_the_program() {
        let bench = mount(|| view! { <ExportDialog /> }).await;
        bench.worker.answer_here(documents);
        asked(&bench).await;
        bench.choose(".title-block label:first-of-type input", "RIBBONS LTD").await;
        assert_eq!(bench.setting("customer"), Some(Value::Text("RIBBONS LTD".to_owned())));
        bench.press("#save-all").await;
        let written = bench.page.program.written.get_untracked();
        assert!(written.files.0.iter().any(|file| file.text.contains("RIBBONS LTD")));
    }

    #[wasm_bindgen_test]
    async fn long_customer_is_whole_in_the_block_and_cut_in_the_program() {
        const LONG: &str = "Shanghai Ribbon & Label Printing Works";
        let bench = mount(|| view! { <ExportDialog /> }).await;
        bench.worker.answer_here(documents);
        asked(&bench).await;
        let entry = ".title-block label:first-of-type input";
        bench.choose(entry, LONG).await;
        assert_eq!(bench.value(entry), LONG);
        assert_eq!(bench.setting("customer"), Some(Value::Text("Shanghai Ribbon & Labe".to_owned())));
        assert!(bench.text(".in-program").contains("Shanghai Ribbon & Labe"));
        bench.page.set("customer", Value::Text("Another".to_owned()));
        settled().await;
        assert_eq!((bench.value(entry).as_str(), bench.text(".in-program").as_str()), ("Another", ""));
    }

    #[wasm_bindgen_test]
    async fn export_offers_programs_and_documents() {
        let bench = mount(|| view! { <ExportDialog /> }).await;
        assert!(!bench.has("dialog[open]"));
        bench.worker.answer_here(documents);
        asked(&bench).await;
        let programs = bench.page.program.written.with_untracked(|written| written.files.0.len());
        assert!(bench.has("dialog[open] #save-all"));
        assert_eq!(bench.all(".exported tr").len(), programs + 1);
        assert_eq!(bench.text(".exported tr:last-child th"), "report.html");
        assert_eq!(bench.text(".exported tr:last-child .what"), "Report");
        assert!(bench.has(".prints #print-report") && !bench.has("footer #print-report"));
    }

    #[wasm_bindgen_test]
    async fn wrong_entry_refuses_the_export_and_leads_to_its_field() {
        let bench = mount(|| view! { <ExportDialog /> <input id="pitch" /> }).await;
        bench.worker.answer_here(documents);
        let wrong = *field("pitch").read_metric("x").unwrap_err();
        bench.page.entries.refuse("pitch", wrong.clone());
        asked(&bench).await;
        assert!(!bench.has("#save-all"));
        assert!(bench.text(".remarks .fail").contains(&sentence_with_hints(&wrong)));
        bench.press_button(t("page.go-to-field")).await;
        assert!(!bench.has("dialog[open]"));
        assert_eq!(document().active_element().unwrap().id(), "pitch");
    }

    #[wasm_bindgen_test]
    async fn refusing_finding_is_shown_and_leads_to_its_line() {
        let bench = mount(|| view! { <ExportDialog /> }).await;
        bench.worker.answer_here(|_, _| {
            let remark = |refuses, text: &str| Remark {
                refuses,
                tone: Tone::Fail,
                alarm: "P1".to_owned(),
                text: text.to_owned(),
                field: String::new(),
                place: Some(Place { file: FileId(1), span: Span::new(0, 1) }.into()),
            };
            let remarks = vec![remark(true, "refuses"), remark(false, "remarks")];
            let draft = Some("<p>".to_owned());
            ExportProject.answer(&ExportDocuments { programs: Vec::new(), files: Vec::new(), draft, remarks })
        });
        asked(&bench).await;
        assert!(bench.has("#print-draft") && !bench.has("#save-all"));
        assert_eq!(bench.all(".remarks li").len(), 1);
        assert_eq!(bench.text(".remarks b"), "P1");
        assert!(bench.text(".remarks li").contains("refuses"));
        bench.press(".remarks .link").await;
        assert!(!bench.has("dialog[open]"));
        assert_eq!(bench.page.view.sought.get_untracked().map(|place| place.file), Some(FileId(1)));
    }

    #[wasm_bindgen_test]
    async fn export_without_a_worker_is_a_notice() {
        let bench = mount(|| view! { <ExportDialog /> }).await;
        asked(&bench).await;
        assert_eq!(bench.notices(), [t("page.no-answer")]);
        assert!(!bench.has("dialog[open]"));
    }
}

//! Opening projects and programs: chosen, dropped or pasted.

use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use wasm_bindgen_futures::JsFuture;
use web_sys::{ClipboardEvent, DataTransfer, DragEvent, File, FileList};

use super::large::{LargeFile, Source, check};
use super::parts;
use super::shelf;
use crate::controls::options::CommentCharacters;
use crate::nc;
use crate::project::Project;
use crate::project::files::decode::{Decoded, Encoding};
use crate::project::import::{FileKind, MAX_PROGRAM, is_program, open};
use crate::project::saved::with_line;
use crate::text::catalog::{Language, spoken};
use crate::text::headed;
use crate::ui::dom;
use crate::ui::state::notices::Notice;
use crate::ui::state::view::Tab;
use crate::ui::state::{Page, operator};
use crate::ui::words::{Tone, sentence, t};
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::BEFORE_PROGRAM;

/// Bytes above which a text is checked in a worker instead of taken into the page.
const BIG: f64 = MAX_PROGRAM as f64;

/// Bytes of the largest project that is read: [`MAX_PROGRAM`] as JSON with every character escaped, and room for the form.
const PROJECT: f64 = 8.0 * BIG;

/// Takes files that a person opened, dropped or pasted: all of them or none.
fn take(page: Page, (large, worker): (LargeFile, Client), files: Vec<File>) {
    // A project may be larger than a program, because macroline opens every file that it saved.
    let is_project = |file: &File| file.name().to_ascii_lowercase().ends_with(".json") && file.size() <= PROJECT;
    if let Some(big) = files.iter().find(|file| file.size() > BIG && !is_project(file)) {
        if files.len() == 1 {
            check(page, large, Source::File(big.clone()));
        } else {
            page.notices.notify(
                Tone::Fail,
                sentence(&crate::msg!("page.none-taken-large", file = big.name(), most = (BIG / 1e6, 0))),
            );
        }
        return;
    }
    wasm_bindgen_futures::spawn_local(async move {
        let mut texts = Vec::new();
        for file in files {
            let Ok(buffer) = JsFuture::from(file.array_buffer()).await else {
                return page
                    .notices
                    .notify(Tone::Fail, sentence(&crate::msg!("page.none-taken-unread", file = file.name())));
            };
            let bytes = js_sys::Uint8Array::new(&buffer).to_vec();
            let decoded = Decoded::new(bytes);
            if let Some(other) = decoded.other {
                return page.notices.notify(Tone::Fail, headed(file.name(), sentence(&other)));
            }
            let is_set = page.project.with_untracked(reads_gbk);
            // A shop that reads this page in Chinese saves its programs in GBK; text of other countries could be read as GBK too.
            let tries_gbk = decoded.encoding == Encoding::Unknown && (is_set || spoken() == Language::Chinese);
            let gbk = if tries_gbk { dom::gbk(&buffer) } else { None };
            if gbk.is_some() && !is_set {
                page.notices.notify(Tone::Warn, sentence(&crate::msg!("page.read-as-gbk", file = file.name())));
            }
            texts.push(nc::File { name: file.name(), text: gbk.unwrap_or(decoded.text) });
        }
        read(page, worker, texts);
    });
}

/// Whether the control is set to read comments in GBK.
fn reads_gbk(project: &Project) -> bool {
    project.characters() == CommentCharacters::Gbk
}

/// Reads texts: a project, programs that carry its settings, or any other programs; tables of parts and the operator's actions join the project.
fn read(page: Page, worker: Client, files: Vec<nc::File>) {
    let is = |kind| move |file: &nc::File| FileKind::of(&file.text) == kind;
    let (tables, files): (Vec<_>, Vec<_>) = files.into_iter().partition(is(FileKind::Parts));
    let (panels, files): (Vec<_>, Vec<_>) = files.into_iter().partition(is(FileKind::Panel));
    let refused = !files.is_empty() && !read_programs(page, &files);
    if !refused && !panels.is_empty() {
        operator::take_files(page, &panels);
    }
    tables.iter().for_each(|table| parts::take(page, worker, table));
}

/// Reads projects and programs; whether they were taken. A text without a block of the control is taken only on request.
fn read_programs(page: Page, files: &[nc::File]) -> bool {
    let opened = page.project.with_untracked(|project| open(project, files));
    let project_file = files.iter().find(|file| FileKind::of(&file.text) == FileKind::Project);
    let text = project_file.map_or("", |file| &file.text);
    for finding in &opened.diagnostics {
        let says = with_line(finding, text);
        let says = project_file.map_or_else(|| says.clone(), |file| headed(&file.name, &says));
        page.notices.notify(Tone::from(finding.severity), says);
    }
    let Some(project) = opened.project else { return false };
    if project.edited.is_none() || project_file.is_some() {
        show_opened(page, project);
        return true;
    }
    match files.iter().find(|file| !is_program(project.control, file)) {
        Some(prose) => {
            let message = sentence(&crate::msg!("page.no-program", file = prose.name.as_str()));
            let files = files.to_vec();
            // Read again at the click: the project may have changed since.
            let anyway = Callback::new(move |()| {
                if let Some(project) = page.project.with_untracked(|project| open(project, &files)).project {
                    take_program(page, project);
                }
            });
            let offer = Some(("page.open-anyway", anyway));
            page.notices.show(Notice { offer, of_project: true, ..Notice::new(Tone::Warn, message) });
            false
        }
        None => {
            take_program(page, project);
            true
        }
    }
}

/// Takes a project with an opened program, after a version of the present one.
fn take_program(page: Page, project: Project) {
    shelf::version_before(page, BEFORE_PROGRAM);
    show(page, project);
    page.notices.confirm(t("page.opened-program").to_owned());
}

/// Replaces the present project, and says so to screen readers.
fn show_opened(page: Page, project: Project) {
    show(page, project);
    page.notices.announce(t("page.opened"));
}

/// Replaces the present project and shows the first program of the new one.
pub(super) fn show(page: Page, project: Project) {
    page.view.file.set(0);
    page.view.tab.set(Tab::Program);
    page.replace(project);
}

fn files_of(list: Option<FileList>) -> Vec<File> {
    list.map(|list| (0..list.length()).filter_map(|at| list.get(at)).collect()).unwrap_or_default()
}

/// Opens dropped or pasted files or text; returns whether there were any.
fn transferred(page: Page, (large, worker): (LargeFile, Client), data: &DataTransfer) -> bool {
    let list = files_of(data.files());
    if !list.is_empty() {
        take(page, (large, worker), list);
        return true;
    }
    let text = data.get_data("text").unwrap_or_default();
    if text.len() as f64 > BIG {
        check(page, large, Source::Text(text));
    } else if text.trim().is_empty() {
        return false;
    } else {
        read(page, worker, vec![nc::File { name: t("page.pasted").to_owned(), text }]);
    }
    true
}

/// Says over the page that files may be dropped, or no longer.
fn drop_sign(shown: bool) {
    let Some(root) = document().document_element() else { return };
    if shown {
        dom::set(&root, "data-drop", t("page.drop-here"));
    } else {
        let _ = root.remove_attribute("data-drop");
    }
}

/// Listens for files that are dropped or pasted anywhere on the page.
pub(crate) fn listen(page: Page, large: LargeFile, worker: Client) {
    dom::on_event("dragover", |event| {
        event.prevent_default();
        drop_sign(true);
    });
    dom::on_event("dragleave", |event| {
        // Between two elements of the page the pointer enters another one.
        if event.unchecked_ref::<DragEvent>().related_target().is_none() {
            drop_sign(false);
        }
    });
    dom::on_event("drop", move |event| {
        event.prevent_default();
        drop_sign(false);
        if let Some(data) = event.unchecked_ref::<DragEvent>().data_transfer() {
            transferred(page, (large, worker), &data);
        }
    });
    // Handled before any text field, because many megabytes must not be pasted into one.
    dom::on_event("paste", move |event| {
        let Some(data) = event.unchecked_ref::<ClipboardEvent>().clipboard_data() else { return };
        let target = dom::target(&event);
        let in_text = target.is_some_and(|target| dom::takes_text(&target));
        if in_text && (data.get_data("text").map_or(0, |text| text.len()) as f64) < BIG {
            return;
        }
        if transferred(page, (large, worker), &data) {
            event.prevent_default();
            event.stop_propagation();
        }
    });
}

/// The button that opens files.
#[component]
pub(super) fn OpenButton() -> impl IntoView {
    let (page, large, worker) = (Page::here(), LargeFile::here(), Client::here());
    let input: NodeRef<html::Input> = NodeRef::new();
    let chosen = move |_| {
        let Some(input) = input.get() else { return };
        take(page, (large, worker), files_of(input.files()));
        // An emptied input reports the same file again when it is opened twice in a row.
        input.set_value("");
    };
    let press = move |_| {
        if let Some(input) = input.get() {
            input.click();
        }
    };
    view! {
        <input node_ref=input id="open" class="hidden" type="file" multiple tabindex="-1" aria-label=t("page.open") on:change=chosen />
        <button type="button" class="quiet" title=t("page.open-about") on:click=press>{t("page.open")}</button>
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::rc::Rc;

    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::motion::{Action, Event};
    use crate::ui::testing::{ViewBench, mount, project, settled, until};

    async fn opened(name: &str, text: &str) -> ViewBench {
        let bench = mount(|| view! { <OpenButton /> }).await;
        read(bench.page, bench.worker, vec![nc::File { name: name.to_owned(), text: text.to_owned() }]);
        settled().await;
        bench
    }

    #[wasm_bindgen_test]
    async fn opened_project_replaces_the_present_one() {
        let mut project = Project::of(crate::machines::ALL[1].id(), None).unwrap();
        project.name = "Order 7".to_owned();
        let bench = opened("order.json", &project.to_json()).await;
        assert!(bench.page.project.get_untracked() == project);
        bench.page.undo();
        assert_eq!(bench.page.machine.get_untracked(), crate::machines::ALL[0].id());
    }

    #[wasm_bindgen_test]
    async fn project_larger_than_a_program_is_opened() {
        // The longest program allowed. In JSON each line feed takes two characters.
        let line = "N1 G04 X1.\n";
        let mut order = project();
        order.name = "Order 8".to_owned();
        let text = line.repeat(MAX_PROGRAM / line.len());
        order.edited = Some(nc::Files(vec![nc::File { name: "O1.nc".to_owned(), text }]));
        let json = order.to_json();
        assert!(json.len() as f64 > BIG);
        let large = Rc::new(Cell::new(None));
        let found = Rc::clone(&large);
        let bench = mount(move || found.set(Some(LargeFile::here()))).await;
        let file = File::new_with_str_sequence(&js_sys::Array::of1(&json.into()), "order.json").unwrap();
        take(bench.page, (large.get().unwrap(), bench.worker), vec![file]);
        until(move || bench.page.project.with_untracked(|project| project.name == "Order 8")).await;
        assert_eq!(bench.notices(), [""; 0]);
    }

    #[wasm_bindgen_test]
    async fn opened_program_is_an_edited_one() {
        let bench = opened("O1.nc", "%\nO1\nG01 X1. F100\nM30\n%\n").await;
        assert!(bench.page.program.edited.get_untracked());
        assert!(bench.page.program.text(0).contains("G01 X1."));
        assert!(bench.notices().contains(&t("page.opened-program").to_owned()));
        assert_eq!(bench.page.notices.announcement.get_untracked(), t("page.opened-program"));
    }

    #[wasm_bindgen_test]
    async fn project_with_byte_order_mark_and_edited_program_opens() {
        let mut order = project();
        order.edited = Some(nc::Files::one("O1.nc", "O1\nM30\n"));
        let bench = opened("order.json", &format!("\u{feff}{}", order.to_json())).await;
        assert!(bench.page.project.get_untracked() == order);
        let bench = opened("order.json", "\u{feff}{\n\"version\": 1,, }").await;
        assert!(bench.notices()[0].contains('2'), "{:?}", bench.notices());
    }

    #[wasm_bindgen_test]
    async fn prose_is_opened_only_on_request() {
        let bench = opened("note.txt", "Hello, please see the order attached.\nKind regards\n").await;
        assert!(bench.page.project.get_untracked() == project());
        let notice = bench.page.notices.list.get_untracked().pop().unwrap();
        assert!(notice.text.starts_with("note.txt"), "{}", notice.text);
        // The project has changed meanwhile.
        bench.page.edit(|project| project.name = "Order 7".to_owned());
        notice.offer.unwrap().1.run(());
        assert!(bench.page.program.text(0).starts_with("Hello"));
        assert_eq!(bench.page.project.with_untracked(|project| project.name.clone()), "Order 7");
    }

    #[wasm_bindgen_test]
    async fn broken_project_changes_nothing_and_gives_a_notice() {
        let bench = opened("order.json", "{ not a project").await;
        assert!(bench.page.project.get_untracked() == project());
        assert_eq!(bench.notices().len(), 1);
    }

    #[wasm_bindgen_test]
    async fn project_and_programs_that_come_together_are_all_taken() {
        let bench = mount(|| ()).await;
        let mut order = project();
        order.name = "Order 7".to_owned();
        let json = nc::File { name: "order.json".to_owned(), text: order.to_json() };
        let mut programs = order.written().files.0;
        programs[1].text.push_str("(mine)\n");
        read(bench.page, bench.worker, vec![programs[1].clone(), json.clone(), programs[0].clone()]);
        assert_eq!(bench.page.project.with_untracked(|project| project.name.clone()), "Order 7");
        assert!(bench.page.program.text(1).ends_with("(mine)\n"));
        assert_eq!(bench.page.program.text(0), programs[0].text);
    }

    #[wasm_bindgen_test]
    async fn files_that_do_not_go_together_are_all_refused() {
        let json = |text: &str| nc::File { name: "order.json".to_owned(), text: text.to_owned() };
        let program = nc::File { name: "O1.nc".to_owned(), text: "M30\n".to_owned() };
        let whole = project().to_json();
        for files in [
            vec![json(&whole), json(&whole)],
            vec![program.clone(), json("{ not a project")],
            vec![program.clone(), nc::File { name: "a.png".to_owned(), text: "\0\0".to_owned() }],
        ] {
            let bench = mount(|| ()).await;
            read(bench.page, bench.worker, files);
            assert!(bench.page.project.get_untracked() == project());
            assert_eq!(bench.notices().len(), 1);
        }
    }

    #[wasm_bindgen_test]
    async fn pasted_text_is_read_and_an_empty_one_is_left() {
        let bench = mount(|| view! { <OpenButton /> }).await;
        let data = DataTransfer::new().unwrap();
        assert!(!transferred(bench.page, (LargeFile::provide(), bench.worker), &data));
        data.set_data("text", "G01 X1.\nM30\n").unwrap();
        assert!(transferred(bench.page, (LargeFile::provide(), bench.worker), &data));
        settled().await;
        assert!(bench.page.program.text(0).contains("G01 X1."));
    }

    #[wasm_bindgen_test]
    async fn file_input_is_behind_the_button() {
        let bench = mount(|| view! { <OpenButton /> }).await;
        assert_eq!(
            (bench.attribute("input", "tabindex"), bench.attribute("input", "aria-label")),
            ("-1".to_owned(), t("page.open").to_owned())
        );
    }

    #[wasm_bindgen_test]
    async fn panel_file_takes_the_place_of_the_actions() {
        let bench = mount(|| ()).await;
        bench.page.note(Event { t: 1.0, action: Action::Hold });
        let file = |name: &str, text: &str| nc::File { name: name.to_owned(), text: text.to_owned() };
        let text = r#"[ { "t": 2.5, "spindle_override": 80 }, { "t": 1, "reset": true } ]"#;
        read(bench.page, bench.worker, vec![file("panel.json", text)]);
        assert_eq!(bench.actions(), [Action::Reset, Action::SpindleOverride(80.0)]);
        assert!(bench.notices()[0].contains("panel.json") && bench.notices()[0].contains('2'));
        bench.page.undo();
        assert_eq!(bench.actions(), [Action::Hold]);
        settled().await;
    }

    #[wasm_bindgen_test]
    async fn broken_panel_file_changes_nothing_and_gives_a_notice() {
        let bench = mount(|| ()).await;
        bench.page.note(Event { t: 1.0, action: Action::Hold });
        let file = |text: &str| nc::File { name: "panel.json".to_owned(), text: text.to_owned() };
        let good = file(r#"[ { "t": 2.5, "spindle_override": 80 } ]"#);
        for files in [vec![file(r#"[ { "t": 1, "dance": true } ]"#), good.clone()], vec![file("[ {"), good]] {
            read(bench.page, bench.worker, files);
            assert_eq!(bench.actions(), [Action::Hold]);
        }
        assert_eq!(bench.notices().len(), 2);
        settled().await;
    }
}

//! The lines of a file, with marks for the block that runs, the next block, the cursor and breakpoints.

use leptos::ev::KeyboardEvent;
use leptos::html;
use leptos::prelude::*;
use web_sys::Element;

use crate::text::{FileId, LineIndex, Place};
use crate::ui::dom;
use crate::ui::dom::children;
use crate::ui::parts::listing::rows as rows_of;
use crate::ui::state::Page;
use crate::ui::state::stepper::Stepper;
use crate::ui::words::t;

/// The lines in the page; marked and followed ones by their place in the list.
#[derive(Default)]
struct Rows {
    /// All rows of the list as HTML, findings too.
    html: Vec<String>,
    rows: Vec<Element>,
    lines: LineIndex,
    marked: Vec<usize>,
    followed: Option<usize>,
}

impl Rows {
    /// Shows other lines in the list; rows that are the same stay.
    fn show(&mut self, host: &Element, html: Vec<String>, lines: LineIndex) {
        self.unmark();
        children::change(host, &self.html, &html);
        *self = Rows { html, rows: dom::all(host, "[data-l]"), lines, ..Rows::default() };
    }

    fn unmark(&mut self) {
        for row in self.marked.drain(..).filter_map(|at| self.rows.get(at)) {
            row.set_class_name("");
            let _ = row.remove_attribute("aria-current");
        }
    }

    /// Marks the lines of a file: breakpoints, the cursor, the running block, the next block of the debugger.
    fn mark(&mut self, file: FileId, stepper: &Stepper, running: Option<Place>, follow: bool) {
        self.unmark();
        let next = stepper.place();
        let cursor = stepper.cursor.filter(|at| at.0 == file).map(|at| at.1);
        let line = |place: Option<Place>| Some(self.lines.line_of(place.filter(|p| p.file == file)?.span.start));
        let points = stepper.points.list().iter().map(|point| (line(point.place), "stop", point.condition.as_str()));
        let marks = [(line(running), "run", ""), (line(next), "next", ""), (cursor, "cursor", "")];
        for (line, class, condition) in marks.into_iter().chain(points) {
            let at = line.map_or(usize::MAX, |line| line as usize - 1);
            let Some(row) = self.rows.get(at) else { continue };
            let _ = row.class_list().add_1(class);
            match class {
                "run" => dom::set(row, "aria-current", "step"),
                "stop" => dom::set(row, "data-if", condition),
                _ => {}
            }
            self.marked.push(at);
        }
        let followed = line(next.or(running)).map(|line| line as usize - 1);
        if core::mem::replace(&mut self.followed, followed) != followed
            && let Some(row) = followed.and_then(|at| self.rows.get(at)).filter(|_| follow)
        {
            reveal(row);
        }
    }
}

/// The lines of the chosen file; arrow keys move the cursor.
#[component]
pub(super) fn Listing(
    /// Whether the running block is kept in view.
    follow: RwSignal<bool>,
) -> impl IntoView {
    let page = Page::here();
    let stepper = page.player.stepper;
    let host: NodeRef<html::Ol> = NodeRef::new();
    let rows = StoredValue::new_local(Rows::default());
    let file = move || FileId(page.view.file.get() as u16);
    let mark = move || {
        let (file, running, follow) = (untrack(file), page.player.running.get(), follow.get_untracked());
        stepper.with(|stepper| rows.update_value(|rows| rows.mark(file, stepper, running, follow)));
    };
    let seek = move || {
        let Some(place) = page.view.sought.get() else { return };
        if place.file != untrack(file) {
            // Another file is chosen first; then this effect runs again.
            return page.view.file.set(place.file.0 as usize);
        }
        let found = rows.with_value(|rows| {
            let line = rows.lines.line_of(place.span.start);
            Some((line, rows.rows.get(line as usize - 1)?.clone()))
        });
        let Some((line, row)) = found else { return };
        page.view.sought.set(None);
        stepper.update(|stepper| stepper.cursor = Some((place.file, line)));
        reveal(&row);
    };
    Effect::new(move |_| {
        let (file, Some(host)) = (file(), host.get()) else { return };
        let findings = page.program.findings.get();
        page.program.written.with(|written| {
            let Some(text) = written.files.get(file) else { return };
            let html = rows_of(text, file, written.parsed.control(), &findings);
            rows.update_value(|rows| rows.show(&host, html, LineIndex::new(&text.text)));
        });
        untrack(mark);
        untrack(seek);
    });
    Effect::new(move |_| mark());
    Effect::new(move |_| seek());
    // The open panel leaves less room.
    Effect::new(move |_| {
        if page.view.panel.get() {
            dom::soon(move || {
                rows.try_update_value(|rows| rows.followed = None);
                untrack(mark);
            });
        }
    });
    let keys = move |event: KeyboardEvent| {
        let step = match event.key().as_str() {
            "ArrowDown" => 1,
            "ArrowUp" => -1,
            _ => return,
        };
        event.prevent_default();
        let file = untrack(file);
        let at = stepper.with_untracked(|stepper| stepper.cursor.filter(|at| at.0 == file).map_or(0, |at| at.1));
        let line = at.saturating_add_signed(step).max(1);
        let Some(row) = rows.with_value(|rows| rows.rows.get(line as usize - 1).cloned()) else { return };
        reveal(&row);
        page.notices.announce(row.text_content().unwrap_or_default());
        stepper.update(|stepper| stepper.cursor = Some((file, line)));
    };
    view! {
        <ol
            class="listing" tabindex="0" aria-label=t("page.listing")
            aria-busy=move || page.program.pending.get().to_string()
            node_ref=host on:keydown=keys
        ></ol>
    }
}

/// Brings a line and the finding below it into view within its list only, so that the page itself does not move.
fn reveal(row: &Element) {
    let Some(list) = row.parent_element() else { return };
    let (line, area) = (row.get_bounding_client_rect(), list.get_bounding_client_rect());
    let finding = row.next_element_sibling().filter(|next| next.class_list().contains("says"));
    let bottom = finding.map_or(line.bottom(), |finding| finding.get_bounding_client_rect().bottom());
    let room = 40.0;
    if line.top() < area.top() + room || bottom > area.bottom() - room {
        // At a third of the height, so that the lines to come are in view, but above the end of its finding.
        let place = (area.height() / 3.0).min(area.height() - room - (bottom - line.top())).max(room);
        list.set_scroll_top(list.scroll_top() + (line.top() - area.top() - place) as i32);
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::text::{Diagnostic, Span};
    use crate::ui::testing::{ViewBench, mount, settled};

    async fn listing() -> ViewBench {
        mount(|| view! { <Listing follow=RwSignal::new(true) /> }).await
    }

    /// Numbers of the lines with a class.
    fn marked(bench: &ViewBench, class: &str) -> Vec<String> {
        bench.all(&format!("li.{class}")).iter().filter_map(|row| row.get_attribute("data-l")).collect()
    }

    fn line(bench: &ViewBench, number: u32) -> Place {
        let text = bench.page.program.text(0);
        let lines = LineIndex::new(&text);
        let start = lines.start(number);
        Place { file: FileId(0), span: Span { start, end: start + 1 } }
    }

    #[wasm_bindgen_test]
    async fn every_line_of_the_file_is_shown() {
        let bench = listing().await;
        let text = bench.page.program.text(0);
        assert_eq!(bench.all("li[data-l]").len(), text.lines().count());
        assert_eq!(bench.text("li[data-l='3']"), text.lines().nth(2).unwrap().trim());
    }

    #[wasm_bindgen_test]
    async fn running_block_is_marked_alone() {
        let bench = listing().await;
        for number in [2, 4] {
            bench.page.player.running.set(Some(line(&bench, number)));
            settled().await;
            assert_eq!(marked(&bench, "run"), [number.to_string()]);
            assert_eq!(bench.attribute("[aria-current=step]", "data-l"), number.to_string());
        }
        assert_eq!(bench.all("[aria-current]").len(), 1);
    }

    #[wasm_bindgen_test]
    async fn block_of_another_file_marks_nothing() {
        let bench = listing().await;
        bench.page.player.running.set(Some(Place { file: FileId(1), ..line(&bench, 2) }));
        settled().await;
        assert!(marked(&bench, "run").is_empty());
    }

    #[wasm_bindgen_test]
    async fn arrow_keys_move_the_cursor_and_say_the_line() {
        let bench = listing().await;
        for (key, at) in [("ArrowDown", "1"), ("ArrowDown", "2"), ("ArrowUp", "1"), ("ArrowUp", "1")] {
            bench.key(".listing", key, false).await;
            assert_eq!(marked(&bench, "cursor"), [at]);
        }
        assert_eq!(bench.page.notices.announcement.get_untracked().trim(), bench.text("li[data-l='1']"));
    }

    #[wasm_bindgen_test]
    async fn findings_appear_below_their_line() {
        let bench = listing().await;
        assert!(!bench.has("li.says"));
        let found = Diagnostic::warning(crate::msg!("page.not-a-value")).at(line(&bench, 2));
        bench.page.program.findings.set(vec![found]);
        settled().await;
        assert!(bench.text("li[data-l='2'] + li.says").contains(t("page.not-a-value")));
    }

    #[wasm_bindgen_test]
    async fn sought_place_gets_the_cursor_in_its_file() {
        let bench = listing().await;
        let text = bench.page.program.text(1);
        let start = LineIndex::new(&text).start(4);
        bench.page.show_place(Place { file: FileId(1), span: Span { start, end: start + 1 } });
        settled().await;
        assert_eq!((bench.page.view.file.get_untracked(), marked(&bench, "cursor")), (1, vec!["4".to_owned()]));
        assert_eq!(bench.page.view.sought.get_untracked(), None);
    }

    #[wasm_bindgen_test]
    async fn listing_is_busy_while_the_review_is_on_its_way() {
        let bench = listing().await;
        assert_eq!(bench.attribute(".listing", "aria-busy"), "false");
        bench.page.program.pending.set(true);
        settled().await;
        assert_eq!(bench.attribute(".listing", "aria-busy"), "true");
    }

    #[wasm_bindgen_test]
    async fn change_of_the_form_rewrites_the_lines() {
        let bench = mount(|| view! { <Listing follow=RwSignal::new(true) /> }).await;
        let found = |bench: &ViewBench| {
            let files = bench.page.program.written.with_untracked(|written| written.files.0.len());
            (0..files).find(|file| bench.page.program.text(*file).contains("#107=7.25"))
        };
        assert_eq!(found(&bench), None);
        bench.page.set("pitch", crate::machines::form::Value::Number(7.25));
        bench.page.view.file.set(found(&bench).unwrap());
        settled().await;
        assert!(bench.text(".listing").contains("#107=7.25"));
    }
}

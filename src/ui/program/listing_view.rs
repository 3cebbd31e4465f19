//! The lines of a file, with marks for the block that runs, the next block, the cursor and breakpoints.

use leptos::ev::KeyboardEvent;
use leptos::html;
use leptos::prelude::*;
use web_sys::Element;

use crate::text::{FileId, LineIndex, Place};
use crate::ui::dom;
use crate::ui::parts::listing::html as lines_html;
use crate::ui::state::Page;
use crate::ui::state::walk::Walk;
use crate::ui::words::t;

/// The lines in the page; marked and followed ones by their place in the list.
#[derive(Default)]
struct Rows {
    rows: Vec<Element>,
    lines: LineIndex,
    marked: Vec<usize>,
    followed: Option<usize>,
}

impl Rows {
    /// Marks the lines of a file: breakpoints, the cursor, the running block, the next block of the debugger.
    fn mark(&mut self, file: FileId, walk: &Walk, running: Option<Place>, follow: bool) {
        for row in self.marked.drain(..).filter_map(|at| self.rows.get(at)) {
            row.set_class_name("");
            let _ = row.remove_attribute("aria-current");
        }
        let next = walk.place();
        let cursor = walk.cursor.filter(|at| at.0 == file).map(|at| at.1);
        let line = |place: Option<Place>| Some(self.lines.line_of(place.filter(|p| p.file == file)?.span.start));
        let points = walk.points.list().iter().map(|point| (line(point.place), "stop", point.condition.as_str()));
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
    let walk = page.player.walk;
    let host: NodeRef<html::Ol> = NodeRef::new();
    let rows = StoredValue::new_local(Rows::default());
    let file = move || FileId(page.view.file.get() as u16);
    let mark = move || {
        let (file, running, follow) = (untrack(file), page.player.running.get(), follow.get_untracked());
        walk.with(|walk| rows.update_value(|rows| rows.mark(file, walk, running, follow)));
    };
    Effect::new(move |_| {
        let (file, Some(host)) = (file(), host.get()) else { return };
        let findings = page.program.findings.get();
        page.program.written.with(|written| {
            let Some(text) = written.files.get(file) else { return };
            host.set_inner_html(&lines_html(text, file, written.parsed.control(), &findings));
            let lines = LineIndex::new(&text.text);
            rows.set_value(Rows { rows: dom::all(&host, "[data-l]"), lines, ..Rows::default() });
        });
        untrack(mark);
    });
    Effect::new(move |_| mark());
    let keys = move |event: KeyboardEvent| {
        let step = match event.key().as_str() {
            "ArrowDown" => 1,
            "ArrowUp" => -1,
            _ => return,
        };
        event.prevent_default();
        let file = untrack(file);
        let at = walk.with_untracked(|walk| walk.cursor.filter(|at| at.0 == file).map_or(0, |at| at.1));
        let line = at.saturating_add_signed(step).max(1);
        let Some(row) = rows.with_value(|rows| rows.rows.get(line as usize - 1).cloned()) else { return };
        reveal(&row);
        page.notices.say(row.text_content().unwrap_or_default());
        walk.update(|walk| walk.cursor = Some((file, line)));
    };
    view! {
        <ol
            class="listing" tabindex="0" aria-label=t("page.listing")
            aria-busy=move || page.program.pending.get().to_string()
            node_ref=host on:keydown=keys
        ></ol>
    }
}

/// Brings a line into view within its list only, so that the page itself does not move.
fn reveal(row: &Element) {
    let Some(list) = row.parent_element() else { return };
    let (line, area) = (row.get_bounding_client_rect(), list.get_bounding_client_rect());
    let room = 40.0;
    if line.top() < area.top() + room {
        list.set_scroll_top(list.scroll_top() - (area.top() + room - line.top()) as i32);
    } else if line.bottom() > area.bottom() - room {
        list.set_scroll_top(list.scroll_top() + (line.bottom() - area.bottom() + room) as i32);
    }
}

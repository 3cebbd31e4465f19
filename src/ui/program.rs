//! The program files: the running block marked, findings at their place, and the ways to change the text.

use std::cell::RefCell;
use std::rc::Rc;

use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, Event, KeyboardEvent, MouseEvent};

use super::debug;
use super::dom;
use super::editor::{difference, editor};
use super::el::{El, button, check, el};
use super::listing;
use super::local::Local;
use super::model::Model;
use super::state::Shown;
use super::walk::Walk;
use super::words::{sign, t, tone};
use crate::text::{FileId, LineIndex, Place};

/// The program tab.
pub(super) fn program(model: Model) -> Vec<El> {
    let shown = model.shown;
    let follow = Local::new(true);
    let files = move || {
        let names: Vec<String> =
            model.written.with(|written| written.files.0.iter().map(|file| file.name.clone()).collect());
        let chip = |(at, name): (usize, &String)| {
            button("button.chip", name, move || model.file.set(at))
                .state("aria-pressed", move || model.file.get() == at)
        };
        names.iter().enumerate().map(chip).collect()
    };
    // The file that runs is shown while one follows the run; at a stop of the debugger the block that is next.
    let run = move || {
        let next = model.player.walk.with(Walk::place);
        if let Some(place) = next.or(model.player.running.get())
            && follow.get()
            && shown.get_untracked() == Shown::Listing
        {
            model.file.set(place.file.0 as usize);
        }
    };
    let copy = move || {
        model.written.with_untracked(|written| {
            if let Some(file) = written.files.0.get(model.file.get_untracked()) {
                dom::copy(&file.text);
                model.say(t("page.copied"));
            }
        });
    };
    let paper = move || {
        model.edit("", |project| project.edited = Some(project.listing()));
        model.file.set(0);
        shown.set(Shown::Listing);
    };
    let body = move || match shown.get() {
        Shown::Listing => vec![debug::bar(model), listing_view(model, follow), debug::seen(model)],
        Shown::Editor => editor(model),
        Shown::Difference => difference(model),
    };
    let counts = move || {
        model.findings.with(|findings| {
            let rows = listing::count(findings).into_iter().filter(|(_, count)| *count > 0);
            rows.map(|(severity, count)| {
                let tone = tone(severity);
                el("span").at("class", tone).text(&format!("{} {count}", sign(tone)))
            })
            .collect()
        })
    };
    let silenced = move || match model.silenced.get() {
        0 => Vec::new(),
        count => {
            let again = move || model.edit("", |project| project.silenced.clear());
            let told = format!("{count} {} ", t("page.silenced"));
            vec![el("p.silenced").text(&told).add(&[button("button.link", t("page.show-again"), again)])]
        }
    };
    let unpublished = move || {
        model.machine.track();
        model.project.with_untracked(|project| project.machine.listing().is_empty())
    };
    let bar = move || if model.edited.get() { detached(model, shown) } else { Vec::new() };
    vec![
        el("div.bar").add(&[
            el("div.chips").at("role", "group").label(t("page.files")).swap(files),
            el("span.counts").swap(counts),
        ]),
        el("div.bar.tools").add(&[
            toggle(shown, Shown::Editor, t("page.edit")),
            button("button.quiet", t("page.copy"), copy),
            check(t("page.follow"), move || follow.get(), move |on| follow.set(on)),
            button("button.quiet.end", t("page.paper"), paper).mark("gone", unpublished),
        ]),
        el("div").swap(bar),
        el("div").swap(silenced),
        el("div.fill").swap(body).run(run).on("click", move |event| press(model, &event)),
    ]
}

/// A button that shows something else in place of the listing, and the listing again.
fn toggle(shown: Local<Shown>, what: Shown, words: &str) -> El {
    let press = move || shown.update(|shown| *shown = if *shown == what { Shown::Listing } else { what });
    button("button.quiet", words, press).state("aria-pressed", move || shown.get() == what)
}

/// The bar of a program that the form does not write any more.
fn detached(model: Model, shown: Local<Shown>) -> Vec<El> {
    let again = move || {
        model.edit("", |project| project.edited = None);
        model.file.set(0);
        shown.set(Shown::Listing);
    };
    let bar = el("div.detached");
    let list = bar.dom().class_list();
    let keep = move || drop(list.add_1("small"));
    let why =
        el("p").add(&[el("b").text(t("page.detached"))]).text(" ").add(&[el("span").text(t("page.detached-why"))]);
    vec![bar.add(&[
        why,
        toggle(shown, Shown::Difference, t("page.difference")),
        button("button", t("page.write-again"), again),
        button("button.keep", t("page.keep"), keep),
    ])]
}

/// The lines that are shown, which of them are marked, and which is followed: from 0.
#[derive(Default)]
struct Rows {
    rows: Vec<Element>,
    lines: LineIndex,
    marked: Vec<usize>,
    followed: Option<usize>,
}

impl Rows {
    /// Marks the lines of a file: of breakpoints, of the cursor, the one that runs, the one that is next in the debugger.
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

/// Pixels at the left of a line that are its number.
const NUMBER: f64 = 46.0;

/// Something in the listing or around it was pressed: a fix, a command or a watch of the debugger; a line sets the cursor, its number a
/// breakpoint.
fn press(model: Model, event: &Event) {
    let Some(target) = event.target().and_then(|e| e.dyn_into::<Element>().ok()) else { return };
    let attribute = |name: &str| target.closest(&format!("[{name}]")).ok()??.get_attribute(name);
    let number = |name: &str| attribute(name)?.parse::<usize>().ok();
    if let (Some(diagnostic), Some(fix)) = (number("data-d"), number("data-fix")) {
        model.apply_fix(diagnostic, fix);
    } else if let Some(id) = attribute("data-silence") {
        model.edit("", |project| project.silenced.push(id));
    } else if let Some(key) = attribute("data-k") {
        debug::press(model, &key);
    } else if let Some(what) = attribute("data-r") {
        debug::remove(model, &what);
    } else if let Some(line) = number("data-l") {
        let file = FileId(model.file.get_untracked() as u16);
        model.player.walk.update(|walk| walk.cursor = Some((file, line as u32)));
        let event: &MouseEvent = event.unchecked_ref();
        let left = f64::from(event.client_x()) - target.get_bounding_client_rect().left();
        if target.tag_name() == "LI" && left < NUMBER {
            debug::set_point(model, None);
        }
    }
}

/// The lines of the chosen file; arrow keys move the cursor.
fn listing_view(model: Model, follow: Local<bool>) -> El {
    let walk = model.player.walk;
    let list = el("ol.listing").at("tabindex", "0").label(t("page.listing"));
    let list = list.state("aria-busy", move || model.pending.get());
    let host = list.dom().clone();
    let rows = Rc::new(RefCell::new(Rows::default()));
    let file = move || FileId(model.file.get_untracked() as u16);
    let marked = Rc::clone(&rows);
    let mark = move || {
        let running = model.player.running.get_untracked();
        let follow = follow.get_untracked();
        walk.with(|walk| marked.borrow_mut().mark(file(), walk, running, follow));
    };
    let again = mark.clone();
    let drawn = Rc::clone(&rows);
    let draw = move || {
        model.file.track();
        let findings = model.findings.get();
        model.written.with(|written| {
            let Some(text) = written.files.get(file()) else { return };
            let control = written.parsed.control();
            host.set_inner_html(&listing::html(text, file(), control, &findings));
            let lines = LineIndex::new(&text.text);
            drawn.replace(Rows { rows: dom::all(&host, "[data-l]"), lines, ..Rows::default() });
        });
        mark();
    };
    let keys = move |event: Event| {
        let event: &KeyboardEvent = event.unchecked_ref();
        let step = match event.key().as_str() {
            "ArrowDown" => 1,
            "ArrowUp" => -1,
            _ => return,
        };
        event.prevent_default();
        let at = walk.with_untracked(|walk| walk.cursor.filter(|at| at.0 == file()).map_or(0, |at| at.1));
        let line = at.saturating_add_signed(step).max(1);
        let Some(row) = rows.borrow().rows.get(line as usize - 1).cloned() else { return };
        reveal(&row);
        model.say(row.text_content().unwrap_or_default());
        walk.update(|walk| walk.cursor = Some((file(), line)));
    };
    let run = move || {
        model.player.running.track();
        again();
    };
    list.run(draw).run(run).on("keydown", keys)
}

/// Brings a line into view within its list only, so that the page itself stands still.
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

//! The program files: the running block marked, findings at their place, and the ways to change the text.

use std::cell::RefCell;
use std::rc::Rc;

use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, Event};

use super::dom;
use super::editor::{difference, editor};
use super::el::{El, button, check, el};
use super::listing;
use super::local::Local;
use super::model::Model;
use super::words::{sign, t, tone};
use crate::nc;
use crate::text::{FileId, LineIndex};

/// What is shown of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shown {
    Listing,
    Editor,
    Difference,
}

/// The program tab.
pub(super) fn program(model: Model) -> Vec<El> {
    let shown = Local::new(Shown::Listing);
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
    // The file that runs is shown while one follows the run.
    let run = move || {
        if let Some(place) = model.player.running.get()
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
        Shown::Listing => vec![listing_view(model, follow)],
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
            button("button.quiet.end", t("page.paper"), paper),
        ]),
        el("div").swap(bar),
        el("div").swap(silenced),
        el("div.fill").swap(body).run(run),
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

/// The lines that are shown, and which one is marked, from 0.
#[derive(Default)]
struct Rows {
    rows: Vec<Element>,
    lines: LineIndex,
    marked: Option<usize>,
}

/// The lines of the chosen file.
fn listing_view(model: Model, follow: Local<bool>) -> El {
    let list = el("ol.listing").at("tabindex", "0").label(t("page.listing"));
    let host = list.dom().clone();
    let rows = Rc::new(RefCell::new(Rows::default()));
    let marked = Rc::clone(&rows);
    let mark = move || {
        let place = model.player.running.get_untracked();
        let here = place.filter(|place| place.file.0 as usize == model.file.get_untracked());
        let mut rows = marked.borrow_mut();
        let line = here.map(|place| rows.lines.line_of(place.span.start) as usize - 1);
        if rows.marked == line {
            return;
        }
        if let Some(row) = rows.marked.and_then(|at| rows.rows.get(at)) {
            let _ = row.remove_attribute("aria-current");
        }
        rows.marked = line;
        if let Some(row) = line.and_then(|at| rows.rows.get(at)) {
            dom::set(row, "aria-current", "step");
            if follow.get_untracked() {
                reveal(row);
            }
        }
    };
    let again = mark.clone();
    let draw = move || {
        let at = model.file.get();
        let findings = model.findings.get();
        model.written.with(|written| {
            let Some(file) = written.files.0.get(at) else { return };
            let control = written.parsed.control();
            host.set_inner_html(&listing::html(file, FileId(at as u16), control, &findings));
            let lines = LineIndex::new(&file.text);
            rows.replace(Rows { rows: dom::all(&host, "[data-l]"), lines, marked: None });
        });
        mark();
    };
    let click = move |event: Event| {
        let target = event.target().and_then(|e| e.dyn_into::<Element>().ok());
        let pressed = |name: &str| target.as_ref()?.closest(&format!("[{name}]")).ok()??.get_attribute(name);
        if let Some(id) = pressed("data-silence") {
            model.edit("", |project| project.silenced.push(id));
        }
        let numbers = pressed("data-fix").unwrap_or_default();
        if let Some((diagnostic, fix)) = numbers.split_once(',')
            && let (Ok(diagnostic), Ok(fix)) = (diagnostic.parse(), fix.parse())
        {
            mend(model, diagnostic, fix);
        }
    };
    let run = move || {
        model.player.running.track();
        again();
    };
    list.run(draw).run(run).on("click", click)
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

/// Applies a fix, both by number; the program is then an edited one.
pub(super) fn mend(model: Model, diagnostic: usize, fix: usize) {
    let mended = model.findings.with_untracked(|findings| {
        let fix = findings.get(diagnostic)?.fixes.get(fix)?;
        Some(model.written.with_untracked(|written| nc::fix(&written.files, fix)))
    });
    if let Some(files) = mended {
        model.edit("", |project| project.edited = Some(files));
        model.say(t("page.mended"));
    }
}

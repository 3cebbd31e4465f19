//! The program files: the running block marked, findings at their place, and the ways to change the text.

use std::rc::Rc;

use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::Element;

use super::dom;
use super::editor::{difference, editor};
use super::listing;
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
pub(super) fn program(model: Model) -> AnyView {
    let shown = RwSignal::new_local(Shown::Listing);
    let follow = RwSignal::new_local(true);
    let files = move || {
        model.written.with(|written| {
            let chips = written.files.0.iter().enumerate().map(|(at, file)| {
                let chosen = move || model.file.get() == at;
                let name = file.name.clone();
                view! { <button type="button" class="chip" aria-pressed=move || chosen().to_string() on:click=move |_| model.file.set(at)>{name}</button> }
            });
            chips.collect_view()
        })
    };
    // The file that runs is shown while one follows the run.
    Effect::new(move |_| {
        if let Some(place) = model.player.running.get()
            && follow.get()
            && shown.get_untracked() == Shown::Listing
            && model.player.playing.get_untracked()
        {
            model.file.set(place.file.0 as usize);
        }
    });
    let copy = move |_| {
        model.written.with_untracked(|written| {
            if let Some(file) = written.files.0.get(model.file.get_untracked()) {
                dom::copy(&file.text);
                model.say(t("page.copied"));
            }
        });
    };
    let edit =
        move |_| shown.update(|shown| *shown = if *shown == Shown::Editor { Shown::Listing } else { Shown::Editor });
    let paper = move |_| {
        model.edit("", |project| project.edited = Some(project.listing()));
        model.file.set(0);
        shown.set(Shown::Listing);
    };
    let body = move || match shown.get() {
        Shown::Listing => listing_view(model, follow),
        Shown::Editor => editor(model),
        Shown::Difference => difference(model),
    };
    let counts = move || {
        model.written.with(|written| {
            let rows = listing::count(&written.diagnostics).into_iter().filter(|(_, count)| *count > 0);
            rows.map(|(severity, count)| view! { <span class=tone(severity)>{sign(tone(severity))} " " {count}</span> })
                .collect_view()
        })
    };
    view! {
        <div class="bar">
            <div class="chips" role="group" aria-label=t("page.files")>{files}</div>
            <span class="counts">{counts}</span>
        </div>
        <div class="bar tools">
            <button type="button" class="quiet" aria-pressed=move || (shown.get() == Shown::Editor).to_string() on:click=edit>{t("page.edit")}</button>
            <button type="button" class="quiet" on:click=copy>{t("page.copy")}</button>
            <label class="check"><input type="checkbox" prop:checked=move || follow.get() on:change=move |event| follow.set(event_target_checked(&event)) />{t("page.follow")}</label>
            <button type="button" class="quiet end" on:click=paper>{t("page.paper")}</button>
        </div>
        {move || model.written.with(|written| written.edited).then(|| detached(model, shown))}
        {body}
    }
    .into_any()
}

/// The bar of a program that the form does not write any more.
fn detached(model: Model, shown: RwSignal<Shown, LocalStorage>) -> AnyView {
    let again = move |_| {
        model.edit("", |project| project.edited = None);
        model.file.set(0);
        shown.set(Shown::Listing);
    };
    let difference = move |_| {
        shown.update(|shown| *shown = if *shown == Shown::Difference { Shown::Listing } else { Shown::Difference });
    };
    let hidden = RwSignal::new_local(false);
    view! {
        <div class="detached" class:small=move || hidden.get()>
            <p><b>{t("page.detached")}</b> <span>{t("page.detached-why")}</span></p>
            <button type="button" aria-pressed=move || (shown.get() == Shown::Difference).to_string() on:click=difference>{t("page.difference")}</button>
            <button type="button" on:click=again>{t("page.write-again")}</button>
            <button type="button" class="keep" on:click=move |_| hidden.set(true)>{t("page.keep")}</button>
        </div>
    }
    .into_any()
}

/// The lines of the chosen file.
fn listing_view(model: Model, follow: RwSignal<bool, LocalStorage>) -> AnyView {
    let host: NodeRef<html::Ol> = NodeRef::new();
    let rows = StoredValue::new_local((Vec::<Element>::new(), None::<usize>));
    let lines = StoredValue::new_local(None::<Rc<LineIndex>>);
    let mark = move || {
        let place = model.player.running.get_untracked();
        let here = place.filter(|place| place.file.0 as usize == model.file.get_untracked());
        let line = here.and_then(|place| {
            lines.with_value(|lines| lines.as_ref().map(|lines| lines.line_of(place.span.start) as usize - 1))
        });
        rows.update_value(|(rows, marked)| {
            if *marked == line {
                return;
            }
            if let Some(row) = marked.and_then(|at| rows.get(at)) {
                let _ = row.remove_attribute("aria-current");
            }
            *marked = line;
            if let Some(row) = line.and_then(|at| rows.get(at)) {
                dom::set(row, "aria-current", "step");
                if follow.get_untracked() {
                    reveal(row);
                }
            }
        });
    };
    Effect::new(move |_| {
        let Some(host) = host.get() else { return };
        let at = model.file.get();
        model.written.with(|written| {
            let Some(file) = written.files.0.get(at) else { return };
            let control = written.parsed.control();
            host.set_inner_html(&listing::html(file, FileId(at as u16), control, &written.diagnostics));
            lines.set_value(Some(Rc::new(LineIndex::new(&file.text))));
        });
        rows.set_value((dom::all(&host, "[data-l]"), None));
        mark();
    });
    Effect::new(move |_| {
        model.player.running.track();
        mark();
    });
    let click = move |event: web_sys::MouseEvent| {
        let button =
            event.target().and_then(|e| e.dyn_into::<Element>().ok()).and_then(|e| e.closest("[data-fix]").ok()?);
        let numbers = button.and_then(|button| button.get_attribute("data-fix")).unwrap_or_default();
        if let Some((diagnostic, fix)) = numbers.split_once(',')
            && let (Ok(diagnostic), Ok(fix)) = (diagnostic.parse(), fix.parse())
        {
            mend(model, diagnostic, fix);
        }
    };
    view! { <ol class="listing" tabindex="0" aria-label=t("page.listing") node_ref=host on:click=click></ol> }
        .into_any()
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
    let mended = model.written.with_untracked(|written| {
        let fix = written.diagnostics.get(diagnostic)?.fixes.get(fix)?;
        Some(nc::fix(&written.files, fix))
    });
    if let Some(files) = mended {
        model.edit("", |project| project.edited = Some(files));
        model.say(t("page.mended"));
    }
}

//! Meaning of the word under the pointer or the focus: one popover for the whole page, from the rows of the control.
//!
//! Words are the pieces of a listing's lines, and elements with the attribute `data-means`: the table they are looked up in. Arrow keys go
//! from word to word in a list that has the focus, after Enter.

use std::time::Duration;

use js_sys::Array;
use leptos::ev::{self, KeyboardEvent, PointerEvent};
use leptos::html;
use leptos::leptos_dom::helpers::TimeoutHandle;
use leptos::prelude::*;
use leptos::wasm_bindgen::{JsCast, JsValue};
use web_sys::{DomRect, Element, Event};

use crate::project::Project;
use crate::project::meaning::{self, Meaning, Table};
use crate::text::utf16;
use crate::ui::dom::{self, script::call};
use crate::ui::state::Page;
use crate::ui::words::{four_digits, sentence, t, value_of};

/// Time that the pointer rests on a word before its meaning appears, and time away from it before the meaning disappears.
const REST: Duration = Duration::from_millis(350);
const AWAY: Duration = Duration::from_millis(250);

/// Pixels between a word and its meaning, and between the meaning and the edges of the window.
const GAP: f64 = 6.0;

/// Elements with words of their own.
const MARKED: &str = "[data-means]";
/// Lines whose pieces are words.
const LINE: &str = ".listing [data-l] code";
/// The editor of a program, which provides its lines itself.
const EDITOR: &str = ".editor";
/// The button by which the editor asks for the word at its cursor.
const ASKS: &str = "[data-asks]";
/// Lists that can have the focus and have words.
const LIST: &str = ".listing, .sheets .scroll";

/// A word of the page and its place in the window.
#[derive(Clone, PartialEq)]
struct Word {
    meaning: Meaning,
    left: f64,
    top: f64,
    bottom: f64,
}

impl Word {
    fn at(meaning: Meaning, area: &DomRect) -> Word {
        Word { meaning, left: area.left(), top: area.top(), bottom: area.bottom() }
    }
}

/// The word of an element that is one.
fn marked(project: &Project, element: &Element) -> Option<Word> {
    let table = match element.get_attribute("data-means")?.as_str() {
        "interface" => Table::Interface,
        "parameters" => Table::Parameters,
        "alarms" => Table::Alarms,
        _ => Table::Program,
    };
    let word = element.get_attribute("data-word").or_else(|| element.text_content())?;
    Some(Word::at(meaning::of(project, &word, table)?, &element.get_bounding_client_rect()))
}

/// The words of a line with their places.
fn of_line<'l>(project: &'l Project, line: &'l Element) -> impl Iterator<Item = (DomRect, Option<Meaning>)> + 'l {
    let text = line.text_content().unwrap_or_default();
    meaning::words(&text, project.control).into_iter().filter_map(move |span| {
        let units = |to: u32| text.get(..to as usize).map(|before| before.encode_utf16().count() as u32);
        let area = dom::area_of_text(line, units(span.start)?, units(span.end)?)?;
        Some((area, meaning::of(project, span.of(&text), Table::Program)))
    })
}

/// The word of the editor's line at a point, or of the line with its cursor.
fn of_editor(project: &Project, editor: &Element, point: Option<(f64, f64)>) -> Option<Word> {
    let line = match point {
        Some((x, y)) => call(editor, "lineAtPoint", &[&x.into(), &y.into()]),
        None => call(editor, "lineAtCursor", &[]),
    };
    let line: Array = line.ok()?.dyn_into().ok()?;
    let (text, at, start) = (line.get(0).as_string()?, line.get(1).as_f64()?, line.get(2).as_f64()?);
    let at = utf16::byte(&text, at as u32);
    // A cursor directly after a word belongs to that word too.
    let found = meaning::at(project, &text, at);
    let before = || meaning::at(project, &text, at.checked_sub(1)?);
    let (span, meaning) = found.or_else(|| before().filter(|_| point.is_none()))?;
    let start = start + f64::from(utf16::units(&text, span.start));
    let area: Array = call(editor, "areaAt", &[&start.into()]).ok()?.dyn_into().ok()?;
    let side = |side: u32| area.get(side).as_f64();
    Some(Word { meaning, left: side(0)?, top: side(1)?, bottom: side(2)? })
}

/// The word at a point of an element.
fn at_point(project: &Project, target: &Element, (x, y): (f64, f64)) -> Option<Word> {
    if let Some(element) = target.closest(MARKED).ok()? {
        return marked(project, &element);
    }
    if let Some(editor) = target.closest(EDITOR).ok()? {
        return of_editor(project, &editor, Some((x, y)));
    }
    let line = target.closest(LINE).ok()??;
    let within =
        |area: &DomRect| (area.left()..=area.right()).contains(&x) && (area.top()..=area.bottom()).contains(&y);
    let (area, meaning) = of_line(project, &line).find(|(area, _)| within(area))?;
    Some(Word::at(meaning?, &area))
}

/// All words of a list that are in the window: of the listing's cursor or running line, or of the whole sheet.
fn of_list(project: &Project, list: &Element) -> Vec<Word> {
    let line = ["[data-l].cursor code", "[data-l][aria-current] code", "[data-l] code"];
    match line.iter().find_map(|line| dom::all(list, line).into_iter().next()) {
        Some(line) => of_line(project, &line).filter_map(|(area, meaning)| Some(Word::at(meaning?, &area))).collect(),
        None => dom::all(list, MARKED).iter().filter_map(|element| marked(project, element)).collect(),
    }
}

/// State of the tooltip with the meaning of a word.
#[derive(Clone, Copy)]
struct Shown {
    page: Page,
    word: RwSignal<Option<Word>>,
    timer: StoredValue<Option<TimeoutHandle>>,
    /// Whether the last input was a key: a press of the pointer focuses without asking for a meaning.
    by_key: StoredValue<bool>,
}

impl Shown {
    fn put(self, word: Option<Word>) {
        self.later(None);
        if self.word.try_with_untracked(|present| *present != word) == Some(true) {
            self.word.set(word);
        }
    }

    /// Schedules the next word to show, in place of the one scheduled before.
    fn later(self, then: Option<(Option<Word>, Duration)>) {
        let then = then.and_then(|(word, wait)| set_timeout_with_handle(move || self.put(word), wait).ok());
        if let Some(Some(before)) = self.timer.try_update_value(|timer| core::mem::replace(timer, then)) {
            before.clear();
        }
    }

    fn point(self, event: &PointerEvent) {
        let Some(target) = element(event).filter(|_| event.pointer_type() != "touch") else { return };
        if target.closest("#meaning").ok().flatten().is_some() {
            return self.later(None);
        }
        // A held press selects.
        if event.buttons() != 0 {
            return self.put(None);
        }
        let point = (f64::from(event.client_x()), f64::from(event.client_y()));
        let found = self.page.project.with_untracked(|project| at_point(project, &target, point));
        match (found, self.word.with_untracked(Option::is_some)) {
            (None, false) => self.later(None),
            (None, true) => self.later(Some((None, AWAY))),
            (found, true) => self.put(found),
            (found, false) => self.later(Some((found, REST))),
        }
    }

    /// A finger cannot hover: its tap shows the meaning at once. In the editor a tap sets the cursor, and a button shows the meaning.
    fn tap(self, event: &Event) {
        let tap = event.dyn_ref::<PointerEvent>().filter(|event| event.pointer_type() == "touch");
        if let (Some(event), Some(target)) = (tap, element(event)) {
            let point = (f64::from(event.client_x()), f64::from(event.client_y()));
            if target.closest(ASKS).ok().flatten().is_some() {
                return;
            }
            let words = Some(target).filter(|target| !in_editor(target));
            let found = |target| self.page.project.with_untracked(|project| at_point(project, &target, point));
            self.put(words.and_then(found));
        }
    }

    fn focus(self, event: &Event) {
        if !self.by_key.get_value() {
            return;
        }
        let element = element(event).and_then(|target| target.closest(MARKED).ok()?);
        let found = element.and_then(|element| self.page.project.with_untracked(|project| marked(project, &element)));
        self.put(found);
    }

    /// The editor asks for the word at its cursor.
    fn ask(self, event: &Event) {
        let editor = element(event).filter(in_editor);
        let found = |editor: Element| self.page.project.with_untracked(|project| of_editor(project, &editor, None));
        let found = editor.and_then(found);
        match &found {
            Some(word) => self.page.notices.announce(word.meaning.sentence()),
            None => self.page.notices.confirm(t("page.no-meaning").to_owned()),
        }
        self.put(found);
    }

    fn key(self, event: &KeyboardEvent) {
        self.by_key.set_value(true);
        let present = self.word.get_untracked();
        let list = element(event).filter(|target| target.matches(LIST).unwrap_or(false));
        let step = match (event.key().as_str(), &present) {
            ("Escape", Some(_)) => {
                event.prevent_default();
                return self.put(None);
            }
            ("Enter", None) => None,
            (key, Some(_)) if element(event).as_ref().is_some_and(in_editor) => {
                if !event.ctrl_key() && !event.meta_key() && !MODIFIERS.contains(&key) {
                    self.put(None);
                }
                return;
            }
            ("ArrowRight", Some(_)) => Some(1),
            ("ArrowLeft", Some(_)) => Some(-1),
            ("ArrowUp" | "ArrowDown", Some(_)) => return self.put(None),
            _ => return,
        };
        let Some(list) = list else { return };
        let words = self.page.project.with_untracked(|project| of_list(project, &list));
        let at = present.and_then(|present| words.iter().position(|word| *word == present));
        let to = match (at, step) {
            (Some(at), Some(step)) => at.checked_add_signed(step).unwrap_or(at).min(words.len().saturating_sub(1)),
            _ => 0,
        };
        let Some(word) = words.into_iter().nth(to) else { return };
        event.prevent_default();
        self.page.notices.announce(word.meaning.sentence());
        self.put(Some(word));
    }
}

/// Keys that type nothing.
const MODIFIERS: [&str; 4] = ["Alt", "Control", "Meta", "Shift"];

fn in_editor(element: &Element) -> bool {
    element.matches(EDITOR).unwrap_or(false)
}

fn element(event: &Event) -> Option<Element> {
    event.target()?.dyn_into().ok()
}

/// Below the word, or above it where there is no room below.
fn place(frame: &web_sys::HtmlElement, word: &Word) {
    let (width, height) = (f64::from(frame.offset_width()), f64::from(frame.offset_height()));
    let size = |size: Result<JsValue, JsValue>| size.ok().and_then(|size| size.as_f64());
    let wide = size(window().inner_width()).unwrap_or(width);
    let high = size(window().inner_height()).unwrap_or(height);
    let below = word.bottom + GAP;
    let top = if below + height > high { word.top - GAP - height } else { below };
    let left = word.left.min(wide - width - GAP).max(GAP);
    for (name, at) in [("--x", left), ("--y", top.max(GAP))] {
        let _ = frame.style().set_property(name, &format!("{at}px"));
    }
}

/// The popover; it listens to the whole page.
#[component]
pub(crate) fn MeaningPopover() -> impl IntoView {
    let page = Page::here();
    let word = RwSignal::new(None::<Word>);
    let shown = Shown { page, word, timer: StoredValue::new(None), by_key: StoredValue::new(false) };
    let listeners = [
        window_event_listener(ev::pointermove, move |event| shown.point(&event)),
        window_event_listener(ev::pointerdown, move |_| shown.by_key.set_value(false)),
        window_event_listener(ev::click, move |event| shown.tap(&event)),
        window_event_listener(ev::focusin, move |event| shown.focus(&event)),
        window_event_listener(ev::keydown, move |event| shown.key(&event)),
        window_event_listener(ev::wheel, move |_| shown.put(None)),
        window_event_listener_untyped("means", move |event| shown.ask(&event)),
    ];
    on_cleanup(move || {
        listeners.into_iter().for_each(WindowListenerHandle::remove);
        shown.later(None);
    });
    let frame: NodeRef<html::Div> = NodeRef::new();
    Effect::new(move |_| {
        let (word, Some(frame)) = (word.get(), frame.get()) else { return };
        let _ = match word {
            Some(_) => frame.show_popover(),
            None => frame.hide_popover(),
        };
        // The size of the popover is known once its words are in it.
        dom::soon(move || word.iter().for_each(|word| place(&frame, word)));
    });
    view! {
        <div class="popup means" id="meaning" popover="manual" role="tooltip" node_ref=frame>
            {move || word.get().map(|word| view! { <Content meaning=word.meaning /> })}
        </div>
    }
}

/// Word, present value, meaning, source.
#[component]
fn Content(
    /// The meaning.
    meaning: Meaning,
) -> impl IntoView {
    let page = Page::here();
    let row = meaning.clone();
    let live = move || {
        let (head, _) = (page.player.now.with(|now| now.t), page.player.plans.get());
        let live = page.project.with(|project| page.player.ask_planner(|run| row.live(project, run, head)))??;
        let control = page.project.with_untracked(|project| project.control);
        let text = live.value.map_or_else(|| value_of(control, None, 3), |value| four_digits(value, 3));
        Some(view! { <span class="hidden">{t("meaning.live")}</span> <b>{text} " "</b> <small>{live.unit}</small> })
    };
    let says: Vec<_> = meaning.says.iter().map(|message| view! { <p>{sentence(message)}</p> }).collect();
    let more = meaning.help().map(|id| {
        let open = move |_| page.view.explain(id.clone());
        view! { <button type="button" class="link" on:click=open>{t("help.more")}</button> }
    });
    let source =
        meaning.cite.map(|cite| view! { <p class="source">{cite.source.words()} " · " {cite.grade.words()}</p> });
    view! {
        <h3><code>{meaning.word.clone()}</code> <span class="live">{live}</span></h3>
        {says}
        {source}
        {more}
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, event, mount, settled, until};

    async fn page() -> ViewBench {
        let bench = mount(|| {
            view! {
                <ol class="listing" tabindex="0">
                    <li data-l="1"><code>"N35 "<span class="t-g">"G01"</span>" X"<span>"#110"</span>" (no word)"</code></li>
                </ol>
                <b data-means="program" data-word="S">"speed"</b>
                <input data-means="program" data-word="#104" />
                <div class="editor" tabindex="0"></div>
                <div class="sheets"><div class="scroll" tabindex="0"><i data-means="parameters">"#3001"</i></div></div>
                <MeaningPopover />
            }
        })
        .await;
        bench.run().await;
        bench
    }

    fn open(bench: &ViewBench) -> bool {
        bench.has("#meaning:popover-open")
    }

    fn word(bench: &ViewBench) -> String {
        bench.text("#meaning code")
    }

    /// Moves the pointer to a part of an element's text, by its characters.
    fn point(bench: &ViewBench, selector: &str, kind: &str, at: Option<u32>) {
        let element = bench.find(selector);
        let area = at.and_then(|at| dom::area_of_text(&element, at, at + 1));
        let area = area.unwrap_or_else(|| element.get_bounding_client_rect());
        let members = [
            ("clientX", (area.left() + 0.5 * area.width()).into()),
            ("clientY", (area.top() + 0.5 * area.height()).into()),
            ("pointerType", kind.into()),
        ];
        let name = if kind == "touch" { "click" } else { "pointermove" };
        element.dispatch_event(&event("PointerEvent", name, &members)).unwrap();
    }

    #[wasm_bindgen_test]
    async fn pointer_at_rest_shows_the_word_below_it() {
        let bench = page().await;
        for (at, expected) in [(5, "G1"), (8, "X"), (10, "#110"), (1, "N35")] {
            point(&bench, ".listing code", "mouse", Some(at));
            until(|| open(&bench) && word(&bench) == expected).await;
        }
        let area = bench.find("#meaning").get_bounding_client_rect();
        assert!(area.top() > bench.find(".listing code").get_bounding_client_rect().bottom());
        point(&bench, ".listing code", "mouse", Some(16));
        until(|| !open(&bench)).await;
    }

    #[wasm_bindgen_test]
    async fn meaning_has_live_value_and_source_of_its_row() {
        let bench = page().await;
        bench.seek(3.5).await;
        point(&bench, "b", "touch", None);
        settled().await;
        let speed = bench.page.player.now.with_untracked(|now| now.spindle.actual);
        let cite = bench.page.project.with_untracked(|project| project.control.spindle.cite);
        assert_eq!(bench.text("#meaning .live b"), four_digits(speed, 3));
        assert_eq!(bench.text("#meaning .live small"), "r/min");
        assert!(bench.text("#meaning .source").starts_with(cite.source.words()));
        bench.seek(0.0).await;
        assert_ne!(bench.text("#meaning .live b"), four_digits(speed, 3));
    }

    #[wasm_bindgen_test]
    async fn enter_and_arrows_walk_the_words_of_a_line_and_escape_closes() {
        let bench = page().await;
        let mut seen = Vec::new();
        for key in ["Enter", "ArrowRight", "ArrowRight", "ArrowRight", "ArrowRight", "ArrowLeft"] {
            bench.key(".listing", key, false).await;
            assert!(bench.page.notices.announcement.get_untracked().starts_with(&word(&bench)));
            seen.push(word(&bench));
        }
        assert_eq!(seen, ["N35", "G1", "X", "#110", "#110", "X"]);
        bench.key(".listing", "Escape", false).await;
        assert!(!open(&bench));
        bench.key(".sheets .scroll", "Enter", false).await;
        assert_eq!((open(&bench), word(&bench).as_str()), (true, "#3001"));
    }

    #[wasm_bindgen_test]
    async fn focus_by_key_shows_and_focus_by_press_does_not() {
        let bench = page().await;
        let focus = || bench.find("input").dispatch_event(&event("FocusEvent", "focusin", &[])).unwrap();
        bench.find("input").dispatch_event(&event("PointerEvent", "pointerdown", &[])).unwrap();
        focus();
        settled().await;
        assert!(!open(&bench));
        bench.key("input", "Tab", false).await;
        focus();
        settled().await;
        assert_eq!((open(&bench), word(&bench).as_str()), (true, "#104"));
    }

    #[wasm_bindgen_test]
    async fn editor_asks_for_the_word_at_its_cursor_and_typing_closes_it() {
        let bench = page().await;
        let editor = bench.find(".editor");
        let tell = |at: u32| {
            let line = format!("return ['N35 G01 X#110 ', {at}, 40]");
            for (name, body) in [("lineAtCursor", line.as_str()), ("areaAt", "return [at, 50, 60]")] {
                dom::script::set(&editor, name, &js_sys::Function::new_with_args("at", body));
            }
            editor.dispatch_event(&event("Event", "means", &[])).unwrap();
        };
        // On a word, and directly after it.
        for (at, expected) in [(5, "G1"), (8, "X#110"), (13, "#110"), (0, "N35"), (3, "N35")] {
            tell(at);
            settled().await;
            assert!(open(&bench) && expected.contains(&word(&bench)), "{at}: {}", word(&bench));
            assert!(bench.page.notices.announcement.get_untracked().starts_with(&word(&bench)));
        }
        bench.key(".editor", "Shift", false).await;
        assert!(open(&bench));
        bench.key(".editor", "A", false).await;
        assert!(!open(&bench));
        tell(15);
        settled().await;
        assert!(!open(&bench));
        assert_eq!(bench.page.notices.announcement.get_untracked(), t("page.no-meaning"));
    }

    #[wasm_bindgen_test]
    async fn meaning_stays_within_the_window() {
        let bench = page().await;
        let target: web_sys::HtmlElement = bench.find("b").unchecked_into();
        for (name, value) in [("position", "fixed"), ("right", "0"), ("bottom", "0")] {
            target.style().set_property(name, value).unwrap();
        }
        point(&bench, "b", "touch", None);
        settled().await;
        let area = bench.find("#meaning").get_bounding_client_rect();
        let (wide, high) = (window().inner_width().unwrap(), window().inner_height().unwrap());
        assert!(area.right() <= wide.as_f64().unwrap() && area.bottom() <= high.as_f64().unwrap());
    }
}

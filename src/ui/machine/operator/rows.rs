//! Rows of the list of the operator's actions: time and value to edit, focus, and which rows are built.

use std::time::Duration;

use leptos::ev::KeyboardEvent;
use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement, HtmlInputElement};

use crate::motion::{Action, ActionValue, Event};
use crate::msg;
use crate::project::Project;
use crate::project::operator::{kind_name, name, read_time, read_value, typed_time, typed_value, unit};
use crate::text::Message;
use crate::ui::dom;
use crate::ui::parts::input::Choice;
use crate::ui::parts::{Glyph, IconButton};
use crate::ui::state::Page;
use crate::ui::state::operator::{change, event_at, place_after, remove};
use crate::ui::words::{sentence, t};

/// Pixels of a row, as in the style sheet.
pub(super) const ROW: f64 = 40.0;

/// Rows that are built, whatever the length of the list, and how many of them are above the first one in sight.
const BUILT: usize = 32;
const ABOVE: usize = 8;

/// Ticks of the event loop within which a row is built.
const TURNS: usize = 8;

/// Id of the choice of the action to add.
pub(in crate::ui::machine) const KIND: &str = "action-kind";

/// The list's state. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(super) struct RowList {
    pub(in crate::ui::machine) page: Page,
    pub(in crate::ui::machine) scroller: NodeRef<html::Div>,
    /// The first row that is built.
    first: RwSignal<usize>,
    pub(in crate::ui::machine) count: Memo<usize>,
    /// The last entry, where it is wrong.
    wrong: RwSignal<Option<Wrong>>,
    /// The action of the pressed row: rows may move before the pointer goes up.
    pressed: StoredValue<Option<Event>>,
}

/// An entry that was not taken.
#[derive(Clone, PartialEq)]
struct Wrong {
    at: usize,
    column: &'static str,
    /// The action of its row; the entry is dropped when another action is there.
    event: Event,
    /// The values that the column accepts.
    reason: String,
}

/// An action with the meaning of its variable.
pub(in crate::ui::machine) fn title(action: &Action, project: &Project) -> String {
    let kind = kind_name(action, project.control);
    let Action::Variable(number, _) = action else { return kind };
    let meaning = project.prepared().variables().into_iter().find(|row| row.number == *number);
    meaning.map_or(kind.clone(), |row| format!("{kind} {}", t(row.label)))
}

/// The row of the action at one index of the list.
#[component]
pub(in crate::ui::machine) fn Row(
    /// The place.
    at: usize,
    /// The list.
    list: RowList,
) -> impl IntoView {
    let page = list.page;
    let event = Memo::new(move |_| page.project.with(|project| project.panel.events().get(at).cloned()));
    let of_project = move |words: fn(&Action, &Project) -> String| {
        event.with(|event| {
            let words = event.as_ref().map(|event| page.project.with(|project| words(&event.action, project)));
            words.unwrap_or_default()
        })
    };
    let kind = Memo::new(move |_| of_project(title));
    let named = Memo::new(move |_| of_project(|action, project| name(action, project.control)));
    let time =
        Memo::new(move |_| event.with(|event| event.as_ref().map_or_else(String::new, |event| typed_time(event.t))));
    let about = move |message: fn(String, String) -> Message| sentence(&message(time.get(), named.get()));
    let set_time = move |event: web_sys::Event| {
        let read = read_time(&event_target_value(&event));
        list.take(&event, at, "time", read.map(|t| move |present: Event| Event { t, ..present }));
    };
    let press = move |_| list.pressed.set_value(event.get_untracked());
    let go = move || {
        if let Some(event) = list.pressed_at(at).and_then(|at| event_at(page, at)) {
            page.player.seek(event.t);
        }
    };
    let keys = move |event: KeyboardEvent| {
        let to = match event.key().as_str() {
            "ArrowUp" => at.checked_sub(1),
            "ArrowDown" => Some(at + 1).filter(|to| *to < list.count.get_untracked()),
            _ => return,
        };
        let target = dom::target(&event);
        // A list uses these keys itself.
        let column = target.filter(|target| target.tag_name() != "SELECT").and_then(|target| column_of(&target));
        if let (Some(to), Some(column)) = (to, column) {
            event.prevent_default();
            list.focus(to, &column);
        }
    };
    view! {
        <li
            id=id_of(at) aria-setsize=move || list.count.get().to_string() aria-posinset=(at + 1).to_string()
            on:pointerdown=press on:keydown=keys
        >
            <input
                type="text" inputmode="decimal" autocomplete="off" data-column="time" aria-describedby="operator-list-reason"
                aria-label=move || about(|_, action| msg!("operator.time-of", action)) aria-invalid=move || list.is_wrong(at, "time")
                prop:value=time on:change=set_time
            />
            <span class="what" title=kind>{kind}</span>
            <Value at=at list=list event=event kind=kind />
            <IconButton attr:data-column="go" glyph=Glyph::Go label=Signal::derive(move || about(|time, action| msg!("operator.go", time, action))) press=go />
            <IconButton
                attr:data-column="remove" glyph=Glyph::Close label=Signal::derive(move || about(|time, action| msg!("operator.remove", time, action)))
                press=move || list.remove(at)
            />
        </li>
    }
}

/// Kinds of entries of a value.
#[derive(Clone, Copy, PartialEq)]
enum EntryKind {
    None,
    State,
    Number,
}

/// The value of an action.
#[component]
fn Value(
    /// The place of the action.
    at: usize,
    /// The list.
    list: RowList,
    /// The action.
    event: Memo<Option<Event>>,
    /// Name of the action.
    kind: Memo<String>,
) -> impl IntoView {
    let action = move || event.with(|event| event.as_ref().map(|event| event.action.clone()));
    let entry = Memo::new(move |_| match action().and_then(|action| action.value()) {
        None => EntryKind::None,
        Some(ActionValue::State(_)) => EntryKind::State,
        Some(ActionValue::Number(_) | ActionValue::Vacant) => EntryKind::Number,
    });
    let typed = Memo::new(move |_| action().map_or_else(String::new, |action| typed_value(&action)));
    let set = move |event: web_sys::Event| {
        let control = list.page.project.with_untracked(|project| project.control);
        let Some(action) = untrack(action) else { return };
        let read = read_value(&action, &event_target_value(&event), control);
        list.take(&event, at, "value", read.map(|action| move |present: Event| Event { action, ..present }));
    };
    let label = Signal::derive(move || sentence(&msg!("operator.value-of", kind = kind.get())));
    let turn = move |state: String| {
        let turned = event_at(list.page, at).and_then(|present| {
            let action = present.action.with_value(ActionValue::State(state == "1"))?;
            Some(Event { action, ..present })
        });
        if let Some(turned) = turned {
            change(list.page, at, turned, None);
        }
    };
    move || {
        match entry.get() {
        EntryKind::None => view! { <span></span> }.into_any(),
        EntryKind::State => {
            let options = [("1", "page.on"), ("0", "page.off")].map(|(value, id)| (value.to_owned(), t(id).to_owned()));
            let on = move || action().and_then(|action| action.value()) == Some(ActionValue::State(true));
            let chosen = Signal::derive(move || if on() { "1" } else { "0" }.to_owned());
            view! { <Choice attr:data-column="value" attr:aria-label=label options=Signal::stored(options.to_vec()) chosen=chosen choose=turn /> }
                .into_any()
        }
        EntryKind::Number => view! {
            <span class="value">
                <input
                    type="text" inputmode="decimal" autocomplete="off" data-column="value" aria-label=label aria-describedby="operator-list-reason"
                    aria-invalid=move || list.is_wrong(at, "value")
                    prop:value=typed on:change=set
                />
                <small>{move || action().map_or("", |action| unit(&action))}</small>
            </span>
        }
        .into_any(),
    }
    }
}

/// Id of the row of a place in the list.
fn id_of(at: usize) -> String {
    format!("action-{at}")
}

/// The column that an element of a row is in.
fn column_of(element: &Element) -> Option<String> {
    element.closest("[data-column]").ok().flatten()?.get_attribute("data-column")
}

/// Place and column of the element that has the focus, if that is in the list.
fn focused() -> Option<(usize, String)> {
    let element = document().active_element()?;
    let row = element.closest("li[id^=action-]").ok().flatten()?;
    Some((row.id().strip_prefix("action-")?.parse().ok()?, column_of(&element)?))
}

impl RowList {
    pub(in crate::ui::machine) fn new(page: Page) -> RowList {
        RowList {
            page,
            scroller: NodeRef::new(),
            first: RwSignal::new(0),
            count: Memo::new(move |_| page.project.with(|project| project.panel.events().len())),
            wrong: RwSignal::new(None),
            pressed: StoredValue::new(None),
        }
    }

    /// The first row that is built, and the row after the last one.
    pub(in crate::ui::machine) fn built(self) -> (usize, usize) {
        let first = self.first.get().min(self.count.get().saturating_sub(BUILT));
        (first, (first + BUILT).min(self.count.get()))
    }

    /// The values that the column of a wrong entry accepts.
    pub(in crate::ui::machine) fn reason(self) -> Option<String> {
        self.wrong.with(|wrong| wrong.as_ref().filter(|wrong| self.holds(wrong)).map(|wrong| wrong.reason.clone()))
    }

    /// Takes a typed entry, or shows the allowed values and keeps the text as typed.
    fn take(
        self,
        typed: &web_sys::Event,
        at: usize,
        column: &'static str,
        read: Result<impl FnOnce(Event) -> Event, Message>,
    ) {
        let Some(present) = event_at(self.page, at) else { return };
        let event = match read {
            Ok(new) => new(present.clone()),
            Err(message) => {
                return self.wrong.set(Some(Wrong { at, column, event: present, reason: sentence(&message) }));
            }
        };
        self.wrong.set(None);
        let input: HtmlInputElement = event_target(typed);
        if column == "time" {
            // The key or press that confirmed the entry moves the focus first; the rows move after that.
            set_timeout(move || self.move_row(at, &present, event, &input), Duration::ZERO);
        } else if change(self.page, at, event, None).is_some() {
            self.write(at, column, &input);
        }
    }

    /// Restores an entry from the list, after another text or another action came to its place.
    fn write(self, at: usize, column: &str, input: &HtmlInputElement) {
        if let Some(shown) = event_at(self.page, at) {
            input.set_value(&if column == "time" { typed_time(shown.t) } else { typed_value(&shown.action) });
        }
    }

    /// Moves an action to another time; the focus follows its row.
    fn move_row(self, at: usize, present: &Event, event: Event, input: &HtmlInputElement) {
        // The page may be gone, or another action be there.
        if self.page.project.is_disposed() || event_at(self.page, at).as_ref() != Some(present) {
            return;
        }
        let had_focus = focused();
        let Some(to) = change(self.page, at, event, None) else { return };
        self.write(at, "time", input);
        if let Some((row, column)) = had_focus.filter(|_| to != at) {
            self.focus(place_after(row, (at, to)), &column);
        }
    }

    /// Whether a wrong entry is still in its row.
    fn holds(self, wrong: &Wrong) -> bool {
        self.page.project.with(|project| project.panel.events().get(wrong.at) == Some(&wrong.event))
    }

    /// `aria-invalid` of an entry.
    fn is_wrong(self, at: usize, column: &str) -> Option<&'static str> {
        self.wrong.with(|wrong| {
            wrong.as_ref().filter(|wrong| wrong.at == at && wrong.column == column && self.holds(wrong)).map(|_| "true")
        })
    }

    /// The present place of the action whose row was pressed; of the row itself where keys pressed it.
    fn pressed_at(self, at: usize) -> Option<usize> {
        let Some(pressed) = self.pressed.try_update_value(Option::take).flatten() else { return Some(at) };
        let same = |event: &Event| *event == pressed;
        self.page.project.with_untracked(|project| {
            let events = project.panel.events();
            if events.get(at).is_some_and(same) { Some(at) } else { events.iter().position(same) }
        })
    }

    fn remove(self, at: usize) {
        let Some(at) = self.pressed_at(at) else { return };
        remove(self.page, at);
        match self.count.get_untracked().checked_sub(1) {
            Some(last) => self.focus(at.min(last), "remove"),
            None => self.focus_choice(),
        }
    }

    pub(super) fn focus_choice(self) {
        if let Some(choice) = dom::by_id(KIND) {
            let _ = choice.focus();
        }
    }

    /// Builds the rows that have come into sight.
    pub(in crate::ui::machine) fn scrolled(self) {
        let Some(scroller) = self.scroller.get_untracked() else { return };
        let first = ((f64::from(scroller.scroll_top()) / ROW) as usize).saturating_sub(ABOVE) / 4 * 4;
        if self.first.get_untracked() == first {
            return;
        }
        let had_focus = focused();
        self.first.set(first);
        // Rows that are moved within the page lose the focus.
        if let Some((at, column)) = had_focus.filter(|(at, _)| in_sight(&scroller, *at)) {
            dom::soon(move || {
                let lost = document().active_element().is_some_and(|element| element.tag_name() == "BODY");
                if let Some(entry) = entry(at, &column).filter(|_| lost) {
                    let _ = entry.focus();
                }
            });
        }
    }

    /// Scrolls to a row and focuses one of its columns, or its time if it lacks that column; without rows, focuses the
    /// choice.
    pub(in crate::ui::machine) fn focus(self, at: usize, column: &str) {
        let (Some(scroller), Some(last)) = (self.scroller.get_untracked(), self.count.get_untracked().checked_sub(1))
        else {
            return self.focus_choice();
        };
        let at = at.min(last);
        if !in_sight(&scroller, at) {
            let aside = 0.5 * (f64::from(scroller.client_height()) - ROW);
            scroller.set_scroll_top((at as f64 * ROW - aside).max(0.0) as i32);
        }
        self.scrolled();
        let first = self.first.get_untracked();
        if !(first..first + BUILT).contains(&at) {
            self.first.set(at.saturating_sub(ABOVE));
        }
        let column = column.to_owned();
        wasm_bindgen_futures::spawn_local(async move {
            // The row may have to be built first.
            for _ in 0..TURNS {
                leptos::task::tick().await;
                let Some(entry) = entry(at, &column).or_else(|| entry(at, "time")) else { continue };
                let _ = entry.focus();
                if let Some(input) = entry.dyn_ref::<HtmlInputElement>() {
                    input.select();
                }
                return;
            }
        });
    }
}

/// Whether all of a row lies within the part of the list that is seen.
fn in_sight(scroller: &Element, at: usize) -> bool {
    let (top, height) = (f64::from(scroller.scroll_top()), f64::from(scroller.client_height()));
    let row = at as f64 * ROW;
    row >= top && row + ROW <= top + height
}

/// The element of a row in a column, where the row is built and has one.
fn entry(at: usize, column: &str) -> Option<HtmlElement> {
    let found = dom::by_id(&id_of(at))?.query_selector(&format!("[data-column={column}]")).ok()?;
    found.map(JsCast::unchecked_into)
}

#[cfg(test)]
pub(in crate::ui::machine) mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::motion::Panel;
    use crate::ui::machine::operator::list::OperatorList;
    use crate::ui::testing::{ViewBench, event, mount, settled, until};

    fn feed(t: f64, percent: f64) -> Event {
        Event { t, action: Action::FeedOverride(percent) }
    }

    pub(crate) async fn list(events: impl IntoIterator<Item = Event>) -> ViewBench {
        let panel = Panel::new(events);
        let bench = mount(|| {
            view! { <div style="height:360px;overflow:hidden;display:grid"><OperatorList /></div> }
        })
        .await;
        bench.page.edit(|project| project.panel = panel);
        settled().await;
        bench
    }

    pub(crate) async fn three() -> ViewBench {
        let hold = Event { t: 6.0, action: Action::SingleBlock(true) };
        list([feed(2.0, 80.0), Event { t: 4.0, action: Action::Hold }, hold]).await
    }

    pub(crate) fn events(bench: &ViewBench) -> Vec<Event> {
        bench.page.project.with_untracked(|project| project.panel.events().to_vec())
    }

    /// Row and column of the focus.
    pub(crate) fn place() -> Option<(usize, String)> {
        focused()
    }

    fn selector(at: usize, column: &str) -> String {
        format!("#action-{at} [data-column={column}]")
    }

    fn focus(bench: &ViewBench, selector: &str) {
        bench.find(selector).unchecked_into::<HtmlElement>().focus().unwrap();
    }

    #[wasm_bindgen_test]
    async fn each_action_has_a_row_with_time_and_value() {
        let bench = three().await;
        let whats: Vec<String> = bench.all(".what").iter().filter_map(|what| what.text_content()).collect();
        assert_eq!(whats, [t("page.feed-override"), t("page.hold"), t("page.single-block")]);
        assert_eq!([0, 1, 2].map(|at| bench.value(&selector(at, "time"))), ["2", "4", "6"]);
        assert_eq!(bench.value(&selector(0, "value")), "80");
        assert_eq!(bench.text("#action-0 small"), "%");
        assert!(!bench.has(&selector(1, "value")));
        assert_eq!(bench.value(&selector(2, "value")), "1");
        assert_eq!(bench.attribute("li", "aria-setsize"), "3");
    }

    #[wasm_bindgen_test]
    async fn typed_value_is_one_step_that_undo_takes_back() {
        let bench = three().await;
        bench.choose(&selector(0, "value"), "70,5").await;
        bench.choose(&selector(2, "value"), "0").await;
        assert_eq!(events(&bench)[0], feed(2.0, 70.5));
        assert_eq!(events(&bench)[2].action, Action::SingleBlock(false));
        assert_eq!(bench.value(&selector(0, "value")), "70.5");
        bench.page.undo();
        bench.page.undo();
        settled().await;
        assert_eq!(events(&bench)[0], feed(2.0, 80.0));
        assert_eq!(
            (bench.value(&selector(0, "value")).as_str(), bench.value(&selector(2, "value")).as_str()),
            ("80", "1")
        );
    }

    #[wasm_bindgen_test]
    async fn wrong_entry_stays_and_has_its_allowed_values() {
        let bench = three().await;
        bench.choose(&selector(0, "value"), "1001").await;
        assert_eq!(bench.value(&selector(0, "value")), "1001");
        assert_eq!(bench.attribute(&selector(0, "value"), "aria-invalid"), "true");
        assert!(bench.text("#operator-list-reason").contains("1000 %"));
        assert_eq!(events(&bench)[0], feed(2.0, 80.0));
        bench.choose(&selector(0, "value"), "90").await;
        assert!(bench.text("#operator-list-reason").is_empty() && !bench.has("[aria-invalid]"));
        bench.choose(&selector(0, "time"), "soon").await;
        assert_eq!(bench.text("#operator-list-reason"), t("operator.time-from-0"));
        bench.page.edit(|project| drop(project.panel.remove(0)));
        settled().await;
        assert!(
            !bench.has("[aria-invalid]") && bench.text("#operator-list-reason").is_empty(),
            "another action is there now"
        );
        assert_eq!(bench.value(&selector(0, "time")), "4");
    }

    #[wasm_bindgen_test]
    async fn focus_follows_the_action_whose_time_has_changed() {
        let bench = three().await;
        focus(&bench, &selector(0, "time"));
        bench.choose(&selector(0, "time"), "5").await;
        until(|| place() == Some((1, "time".to_owned()))).await;
        assert_eq!([0, 1, 2].map(|at| bench.value(&selector(at, "time"))), ["4", "5", "6"]);
        // The Tab key goes on to the value before the row moves.
        focus(&bench, &selector(1, "time"));
        let input = bench.find(&selector(1, "time"));
        js_sys::Reflect::set(&input, &"value".into(), &"7".into()).unwrap();
        input.dispatch_event(&event("Event", "change", &[])).unwrap();
        focus(&bench, &selector(1, "remove"));
        until(|| place() == Some((2, "remove".to_owned()))).await;
        assert_eq!(events(&bench)[2], feed(7.0, 80.0));
    }

    #[wasm_bindgen_test]
    async fn removed_row_leaves_the_focus_on_its_neighbour() {
        let bench = three().await;
        for (at, left) in [(2, Some(1)), (0, Some(0)), (0, None)] {
            focus(&bench, &selector(at, "remove"));
            bench.press(&selector(at, "remove")).await;
            assert_eq!(place(), left.map(|at| (at, "remove".to_owned())));
        }
        assert!(events(&bench).is_empty());
        assert_eq!(document().active_element().unwrap().id(), KIND);
        assert_eq!(bench.text(".rows"), t("operator.none"));
        bench.page.undo();
        settled().await;
        assert_eq!(events(&bench).len(), 1);
    }

    #[wasm_bindgen_test]
    async fn pressed_button_means_the_row_that_was_pressed() {
        let bench = three().await;
        bench.find(&selector(1, "remove")).dispatch_event(&event("PointerEvent", "pointerdown", &[])).unwrap();
        // The press ends the entry of a time, and the rows move before the pointer is up.
        bench.choose(&selector(0, "time"), "5").await;
        until(|| events(&bench)[1] == feed(5.0, 80.0)).await;
        bench.press(&selector(1, "remove")).await;
        assert!(!events(&bench).iter().any(|event| event.action == Action::Hold));
        assert_eq!(events(&bench).len(), 2);
    }

    #[wasm_bindgen_test]
    async fn row_leads_to_its_time() {
        let bench = three().await;
        bench.press(&selector(1, "go")).await;
        assert_eq!(bench.page.player.head(), 4.0);
    }

    #[wasm_bindgen_test]
    async fn arrows_go_from_row_to_row() {
        let bench = three().await;
        focus(&bench, &selector(0, "value"));
        bench.key(&selector(0, "value"), "ArrowDown", false).await;
        assert_eq!(place(), Some((1, "time".to_owned())), "a button has no value");
        bench.key(&selector(1, "time"), "ArrowUp", false).await;
        assert_eq!(place(), Some((0, "time".to_owned())));
    }

    #[wasm_bindgen_test]
    async fn rows_of_a_long_list_are_built_where_they_are_in_sight() {
        let bench = list((0..5000).map(|at| feed(f64::from(at), 100.0))).await;
        assert_eq!(bench.all("li").len(), BUILT);
        bench.page.view.show_action(3000);
        settled().await;
        until(|| place() == Some((3000, "time".to_owned()))).await;
        assert_eq!((bench.value(&selector(3000, "time")).as_str(), bench.all("li").len()), ("3000", BUILT));
        bench.choose(&selector(3000, "time"), "4000,5").await;
        until(|| place() == Some((4000, "time".to_owned()))).await;
        assert_eq!(bench.value(&selector(4000, "time")), "4000.5");
    }
}

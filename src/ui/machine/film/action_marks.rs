//! The operator's actions on the time axis: each mark leads to its time, and is dragged or moved by keys to another one.

use leptos::ev::{KeyboardEvent, MouseEvent, PointerEvent};
use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::HtmlElement;

use crate::math;
use crate::motion::Event;
use crate::msg;
use crate::project::operator::{in_steps, name, time_step};
use crate::text::headed;
use crate::text::number::filled;
use crate::ui::dom;
use crate::ui::state::operator::{announce_action, change, event_at, place_after, remove};
use crate::ui::state::{EditKey, Page};
use crate::ui::words::{clock, t};

/// Pixels before a press is a pull.
const SLACK: f64 = 4.0;

/// Steps of an arrow key across the whole axis; with Shift ten at once.
const STEPS: f64 = 100.0;

/// Greatest number of marks; with more actions only those on the axis have one, at most this many.
const MOST: usize = 1000;

/// A press on a mark that may become a pull.
#[derive(Clone, Copy)]
struct Pull {
    at: usize,
    /// Start of the pull in pixels, and the time (s) there.
    x: f64,
    from: f64,
    moved: bool,
}

/// The marks' state. A handle: copies share its state.
#[derive(Clone, Copy)]
struct State {
    page: Page,
    axis: RwSignal<(f64, f64)>,
    host: NodeRef<html::Div>,
    /// The mark that the Tab key reaches.
    current: RwSignal<usize>,
    /// The mark that is dragged, and the time (s) that it would have.
    moving: RwSignal<Option<(usize, f64)>>,
    pull: StoredValue<Option<Pull>>,
    /// A pull has just ended, so its click is ignored.
    ended: StoredValue<bool>,
}

/// The marks.
#[component]
pub(super) fn ActionMarks(
    /// Ends of the shown time, in seconds.
    axis: RwSignal<(f64, f64)>,
) -> impl IntoView {
    let page = Page::here();
    let state = State {
        page,
        axis,
        host: NodeRef::new(),
        current: RwSignal::new(0),
        moving: RwSignal::new(None),
        pull: StoredValue::new(None),
        ended: StoredValue::new(false),
    };
    let marked = Memo::new(move |_| page.project.with(|project| marked(project.panel.events(), || axis.get())));
    let told = move || {
        let (_, seconds) = state.moving.get()?;
        let percent = state.percent(seconds);
        let class = if percent > 50.0 { "moving left" } else { "moving" };
        Some(view! { <output class=class style=("--at", filled("#", &[percent]))>{clock(seconds)}</output> })
    };
    let empty = move || marked.with(Vec::is_empty);
    view! {
        <div class="actions-marked" node_ref=state.host role="group" aria-label=t("operator.marks") class:gone=empty>
            <For each=move || marked.get() key=|at| *at let:at>
                <Mark at=at state=state />
            </For>
            {told}
        </div>
    }
}

/// Places of the actions that have a mark.
fn marked(events: &[Event], axis: impl FnOnce() -> (f64, f64)) -> Vec<usize> {
    if events.len() <= MOST {
        return (0..events.len()).collect();
    }
    let (from, to) = axis();
    let apart = (to - from) / MOST as f64;
    let mut last = f64::NEG_INFINITY;
    let on_axis = events.iter().enumerate().filter(|(_, event)| (from..=to).contains(&event.t));
    let clear = on_axis.filter(|(_, event)| {
        let clear = event.t - last >= apart;
        last = if clear { event.t } else { last };
        clear
    });
    clear.map(|(at, _)| at).collect()
}

/// The mark of the action at one index of the list.
#[component]
fn Mark(
    /// The place.
    at: usize,
    /// The marks.
    state: State,
) -> impl IntoView {
    let page = state.page;
    let event = Memo::new(move |_| {
        page.project.with(|project| {
            let event = project.panel.events().get(at)?;
            Some((event.t, name(&event.action, project.control)))
        })
    });
    let seconds = move || match state.moving.get() {
        Some((moving, seconds)) if moving == at => seconds,
        _ => event.with(|event| event.as_ref().map_or(0.0, |event| event.0)),
    };
    let title = move || event.with(|event| event.as_ref().map(|(t, name)| headed(clock(*t), name)));
    let away = move || {
        let (from, to) = state.axis.get();
        !(from..=to).contains(&seconds())
    };
    let reached = move || state.current.get() == at && !away();
    view! {
        <button
            type="button" id=id_of(at) class="mark" class:away=away
            class:moving=move || state.moving.with(|moving| moving.is_some_and(|(moving, _)| moving == at))
            tabindex=move || if reached() { "0" } else { "-1" } aria-hidden=move || away().then_some("true")
            aria-label=title title=title aria-keyshortcuts="ArrowLeft ArrowRight Delete Enter"
            style=("--at", move || filled("#", &[state.percent(seconds())]))
            on:focus=move |_| state.current.set(at)
            on:click=move |event| state.click(at, &event)
            on:keydown=move |event| state.key(at, &event)
            on:pointerdown=move |event| state.press(at, &event)
            on:pointermove=move |event| state.pull(&event)
            on:pointerup=move |_| state.release()
            on:pointercancel=move |_| state.let_go()
        ></button>
    }
}

/// Id of the mark of a place in the list.
fn id_of(at: usize) -> String {
    format!("action-mark-{at}")
}

impl State {
    /// Percent of the axis at which a time is.
    fn percent(self, seconds: f64) -> f64 {
        let (from, to) = self.axis.get();
        math::clamp(100.0 * (seconds - from) / (to - from), 0.0, 100.0)
    }

    /// Goes to the time of a mark.
    fn click(self, at: usize, event: &MouseEvent) {
        if self.ended.try_update_value(core::mem::take) == Some(true) {
            return event.prevent_default();
        }
        if let Some(event) = event_at(self.page, at) {
            self.page.player.seek(event.t);
        }
    }

    fn press(self, at: usize, event: &PointerEvent) {
        self.ended.set_value(false);
        let from = event_at(self.page, at).filter(|_| event.button() == 0);
        let pull = |action: Event| Pull { at, x: f64::from(event.client_x()), from: action.t, moved: false };
        self.pull.set_value(from.map(pull));
    }

    fn pull(self, event: &PointerEvent) {
        let (Some(mut pull), Some(host)) = (self.pull.get_value(), self.host.get_untracked()) else { return };
        let pixels = f64::from(event.client_x()) - pull.x;
        if !pull.moved {
            if pixels.abs() < SLACK {
                return;
            }
            if let Some(mark) = event.current_target() {
                let _ = mark.unchecked_into::<HtmlElement>().set_pointer_capture(event.pointer_id());
            }
            pull.moved = true;
            self.pull.set_value(Some(pull));
        }
        let (from, to) = self.axis.get_untracked();
        let pixel = (to - from) / f64::from(host.client_width().max(1));
        let seconds = in_steps(pull.from + pixels * pixel, time_step(pixel));
        self.moving.set(Some((pull.at, math::clamp(seconds, from, to))));
        event.prevent_default();
    }

    fn release(self) {
        let moved = self.moving.get_untracked();
        self.ended.set_value(moved.is_some());
        self.let_go();
        if let Some((at, seconds)) = moved {
            self.put(at, seconds, None);
        }
    }

    /// Ends a pull without a change.
    fn let_go(self) {
        self.pull.set_value(None);
        self.moving.set(None);
    }

    /// Gives an action another time; the focus stays on its mark.
    fn put(self, at: usize, seconds: f64, key: Option<EditKey>) {
        let Some(event) = event_at(self.page, at).map(|event| Event { t: seconds, ..event }) else { return };
        if let Some(to) = change(self.page, at, event.clone(), key) {
            announce_action(self.page, &event, |time, action| msg!("operator.at", time, action));
            self.current.update(|current| *current = place_after(*current, (at, to)));
            focus(to);
        }
    }

    fn key(self, at: usize, event: &KeyboardEvent) {
        let plain = !(event.ctrl_key() || event.meta_key() || event.alt_key());
        let (from, to) = self.axis.get_untracked();
        let step = time_step((to - from) / STEPS) * if event.shift_key() { 10.0 } else { 1.0 };
        let by = |steps: f64| {
            if let Some(event) = event_at(self.page, at) {
                // A mark may be moved beyond the end of the run; the plan is extended.
                self.put(at, in_steps(event.t + steps * step, step), Some(EditKey::ActionTime));
            }
        };
        match event.key().as_str() {
            "ArrowLeft" if plain => by(-1.0),
            "ArrowRight" if plain => by(1.0),
            "ArrowUp" if plain => self.go(at.checked_sub(1)),
            "ArrowDown" if plain => self.go(Some(at + 1)),
            "Delete" | "Backspace" if plain => {
                remove(self.page, at);
                let last = self.page.project.with_untracked(|project| project.panel.events().len()).checked_sub(1);
                match last {
                    Some(last) => focus(at.min(last)),
                    None => drop(dom::by_id("head").map(|head| head.focus())),
                }
            }
            "Enter" if plain => self.page.view.show_action(at),
            "Escape" if self.moving.with_untracked(Option::is_some) => self.let_go(),
            _ => return,
        }
        event.prevent_default();
    }

    /// Moves the focus to another mark; its own moves are a new step of the history.
    fn go(self, to: Option<usize>) {
        self.page.hold(false);
        if let Some(to) = to {
            focus(to);
        }
    }
}

/// Gives the focus to the mark of a place in the list, if there is one.
fn focus(at: usize) {
    dom::soon(move || {
        if let Some(mark) = dom::by_id(&id_of(at)) {
            let _ = mark.focus();
        }
    });
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::motion::Action;
    use crate::ui::testing::{ViewBench, event, mount, settled};

    fn feed(t: f64, percent: f64) -> Event {
        Event { t, action: Action::FeedOverride(percent) }
    }

    /// Three actions on an axis of ten seconds and 500 pixels.
    async fn marks() -> (ViewBench, RwSignal<(f64, f64)>) {
        let axis = RwSignal::new((0.0, 10.0));
        let bench = mount(move || {
            view! { <div style="position:relative;width:500px;height:16px"><ActionMarks axis=axis /></div> }
        })
        .await;
        [feed(2.0, 80.0), feed(4.0, 60.0), feed(6.0, 100.0)].into_iter().for_each(|event| bench.page.note(event));
        settled().await;
        (bench, axis)
    }

    fn times(bench: &ViewBench) -> Vec<f64> {
        bench.page.project.with_untracked(|project| project.panel.events().iter().map(|event| event.t).collect())
    }

    async fn pointer(bench: &ViewBench, at: usize, kind: &str, x: f64) {
        let members = [("clientX", x.into()), ("pointerId", 1.into())];
        bench.find(&format!("#action-mark-{at}")).dispatch_event(&event("PointerEvent", kind, &members)).unwrap();
        settled().await;
    }

    fn focused() -> String {
        document().active_element().map(|element| element.id()).unwrap_or_default()
    }

    #[wasm_bindgen_test]
    async fn click_on_a_mark_leads_to_its_time() {
        let (bench, axis) = marks().await;
        assert_eq!(bench.style("#action-mark-0", "--at"), "20");
        assert!(bench.attribute("#action-mark-0", "aria-label").contains(t("page.feed-override")));
        bench.press("#action-mark-0").await;
        assert_eq!(bench.page.player.head(), 2.0);
        axis.set((5.0, 10.0));
        settled().await;
        assert!(bench.has("#action-mark-0.away[tabindex='-1'][aria-hidden=true]"));
        assert!(!bench.has("#action-mark-2.away"));
    }

    #[wasm_bindgen_test]
    async fn dragged_mark_shows_its_time_and_is_one_step() {
        let (bench, _) = marks().await;
        let width = bench.find(".actions-marked").get_bounding_client_rect().width();
        pointer(&bench, 0, "pointerdown", 100.0).await;
        pointer(&bench, 0, "pointermove", 100.0 + width * 0.15).await;
        assert_eq!(bench.text("output"), "00:03.5000");
        assert_eq!(times(&bench), [2.0, 4.0, 6.0], "nothing is planned anew while it moves");
        pointer(&bench, 0, "pointermove", 100.0 + width * 0.25).await;
        pointer(&bench, 0, "pointerup", 0.0).await;
        bench.press("#action-mark-0").await;
        assert_eq!(times(&bench), [4.0, 4.5, 6.0]);
        assert_eq!(bench.page.player.head(), 0.0, "the click at the end of a pull leads nowhere");
        assert!(!bench.has("output"));
        assert_eq!(focused(), "action-mark-1");
        bench.page.undo();
        assert_eq!(times(&bench), [2.0, 4.0, 6.0]);
    }

    #[wasm_bindgen_test]
    async fn pull_is_given_up_by_escape() {
        let (bench, _) = marks().await;
        pointer(&bench, 0, "pointerdown", 100.0).await;
        pointer(&bench, 0, "pointermove", 200.0).await;
        bench.key("#action-mark-0", "Escape", false).await;
        pointer(&bench, 0, "pointerup", 200.0).await;
        assert_eq!(times(&bench), [2.0, 4.0, 6.0]);
    }

    #[wasm_bindgen_test]
    async fn mark_stays_on_the_axis() {
        let (bench, _) = marks().await;
        for (x, t) in [(-9000.0, 0.0), (9000.0, 10.0)] {
            let at = times(&bench).iter().position(|t| [2.0, 0.0].contains(t)).unwrap();
            pointer(&bench, at, "pointerdown", 0.0).await;
            pointer(&bench, at, "pointermove", x).await;
            pointer(&bench, at, "pointerup", x).await;
            assert!(times(&bench).contains(&t), "{:?}", times(&bench));
        }
    }

    #[wasm_bindgen_test]
    async fn arrows_move_a_mark_past_another_with_the_focus() {
        let (bench, _) = marks().await;
        bench.key("#action-mark-0", "ArrowRight", false).await;
        assert_eq!(times(&bench), [2.1, 4.0, 6.0]);
        for at in [0, 0] {
            bench.key(&format!("#action-mark-{at}"), "ArrowRight", true).await;
        }
        assert_eq!((times(&bench), focused().as_str()), (vec![4.0, 4.0, 6.0], "action-mark-1"));
        bench.key("#action-mark-1", "ArrowLeft", false).await;
        assert_eq!((times(&bench), focused().as_str()), (vec![3.9, 4.0, 6.0], "action-mark-0"));
        bench.page.undo();
        assert_eq!(times(&bench), [2.0, 4.0, 6.0], "moves that follow at once are one step");
    }

    #[wasm_bindgen_test]
    async fn one_mark_is_reached_by_tab_and_others_by_arrows() {
        let (bench, _) = marks().await;
        assert_eq!(bench.all(".mark[tabindex='0']").len(), 1);
        bench.key("#action-mark-0", "ArrowDown", false).await;
        assert_eq!(
            (focused().as_str(), bench.attribute(".mark[tabindex='0']", "id").as_str()),
            ("action-mark-1", "action-mark-1")
        );
        bench.key("#action-mark-1", "ArrowUp", false).await;
        assert_eq!(focused(), "action-mark-0");
    }

    #[wasm_bindgen_test]
    async fn delete_removes_and_enter_opens_the_list_there() {
        let (bench, _) = marks().await;
        bench.key("#action-mark-2", "Delete", false).await;
        assert_eq!((times(&bench), focused().as_str()), (vec![2.0, 4.0], "action-mark-1"));
        bench.key("#action-mark-1", "Enter", false).await;
        let view = bench.page.view;
        assert!(view.panel.get_untracked() && view.actions.get_untracked());
        assert_eq!(view.action.get_untracked(), Some(1));
    }

    #[wasm_bindgen_test]
    fn a_thousand_marks_are_drawn_at_most() {
        let events: Vec<Event> = (0..50_000).map(|at| feed(f64::from(at) * 0.01, 100.0)).collect();
        let places = marked(&events, || (100.0, 200.0));
        assert!(places.len() <= MOST && places.len() > MOST / 2, "{}", places.len());
        assert!(places.iter().all(|at| (100.0..=200.0).contains(&events[*at].t)));
    }
}

//! Actions of the operator: at the play head, with the sentence about their effect, and as a list to change.

use leptos::prelude::*;

use super::{EditKey, Page};
use crate::machines::MachineVariable;
use crate::motion::{Action, Event, Panel};
use crate::msg;
use crate::nc;
use crate::project::operator::{name, typed_time};
use crate::project::run;
use crate::project::saved::{panel_from_json, with_line};
use crate::text::{Message, headed, listed};
use crate::ui::dom;
use crate::ui::words::{Tone, clock, sentence, short, t, value_of};

/// Machine seconds after an action at which its effect is reported.
const EFFECT: f64 = 1.0;

/// Parts of a second that the clock shows.
const CLOCK: f64 = 1e4;

/// Applies an action at the play head and reports its effect, by comparing the run a little later with and without it.
pub(crate) fn act(page: Page, action: Action) {
    dom::mark("knob-turned");
    let player = page.player;
    let later = player.head() + EFFECT;
    player.plan_to(later);
    let places = action == Action::ProgramZeroReturn;
    let without = watched(page, later, places);
    let event = player.act(action);
    page.note(event.clone());
    dom::soon(move || {
        player.plan_to(later);
        let mut changes: Vec<String> = Vec::new();
        for ((name, old), (_, new)) in without.into_iter().zip(watched(page, later, places)) {
            if old != new {
                changes.push(sentence(&crate::msg!("page.changed-value", name, value = new, without = old)));
            }
        }
        let effect = if changes.is_empty() {
            t("page.no-change").to_owned()
        } else {
            sentence(&crate::msg!("page.changed-values", values = listed(changes)))
        };
        let done = page.project.with_untracked(|project| name(&event.action, project.control));
        player.changed.set(headed(clock(event.t), format!("{done} · {effect}")));
        dom::mark("knob-answered");
        dom::measure("knob", "knob-turned", "knob-answered");
    });
}

/// Replaces an action at a place of the list; its new place. Changes with the same key, if they have one, that follow at once are one step
/// of the history.
pub(crate) fn change(page: Page, at: usize, event: Event, key: Option<EditKey>) -> Option<usize> {
    let mut to = None;
    page.edit_as(key, |project| to = project.panel.replace(at, event));
    to
}

/// Adds an action at a time (s), as far as the clock shows it; its place in the list.
pub(crate) fn add(page: Page, t: f64, action: Action) -> usize {
    let mut at = 0;
    // Rounded so that a time shown by the clock is kept in spite of its last bit.
    let event = Event { t: (t * CLOCK + 1e-6).floor() / CLOCK, action };
    announce_action(page, &event, |time, action| msg!("operator.added", time, action));
    page.edit(|project| at = project.panel.add(event));
    at
}

/// Removes the action at a place of the list.
pub(crate) fn remove(page: Page, at: usize) {
    if let Some(event) = event_at(page, at) {
        announce_action(page, &event, |time, action| msg!("operator.removed", time, action));
    }
    page.edit(|project| drop(project.panel.remove(at)));
}

/// Removes all actions.
pub(crate) fn clear(page: Page) {
    page.edit(|project| project.panel = Panel::default());
}

/// Shows the list of the actions with the focus on the last one before the play head, or hides the list.
pub(crate) fn toggle_list(page: Page) {
    page.view.toggle_actions();
    if page.view.actions.get_untracked() {
        let head = page.player.head();
        let next =
            page.project.with_untracked(|project| project.panel.events().partition_point(|event| event.t <= head));
        page.view.show_action(next.saturating_sub(1));
    }
}

/// The action at a place of the list.
pub(crate) fn event_at(page: Page, at: usize) -> Option<Event> {
    page.project.with_untracked(|project| project.panel.events().get(at).cloned())
}

/// Announces a message about an action, made of its time and name, to screen readers.
pub(crate) fn announce_action(page: Page, event: &Event, message: impl FnOnce(String, String) -> Message) {
    let name = page.project.with_untracked(|project| name(&event.action, project.control));
    page.notices.announce(sentence(&message(typed_time(event.t), name)));
}

/// Place of a list's element after the element at `from` was moved to `to`.
pub(crate) fn place_after(at: usize, (from, to): (usize, usize)) -> usize {
    match at {
        _ if at == from => to,
        _ if from < at && at <= to => at - 1,
        _ if to <= at && at < from => at + 1,
        _ => at,
    }
}

/// Takes the actions of panel files in place of the present ones; none where one of the files has an error.
pub(crate) fn take_files(page: Page, files: &[nc::File]) {
    let mut events = Vec::new();
    let mut notices = Vec::new();
    for file in files {
        let (panel, found) = panel_from_json(&file.text);
        notices.extend(found.iter().map(|finding| (Tone::from(finding.severity), with_line(finding, &file.text))));
        events.extend_from_slice(panel.events());
    }
    let broken = notices.iter().any(|(tone, _)| *tone == Tone::Fail);
    notices.into_iter().for_each(|(tone, text)| page.notices.notify(tone, text));
    if !broken {
        let names = listed(files.iter().map(|file| file.name.clone()));
        let taken = sentence(&msg!("operator.taken", files = names, count = events.len() as u32));
        page.edit(|project| project.panel = Panel::new(events));
        page.notices.confirm(taken);
    }
}

/// Names and values at a time that an action may change: variables, feeds, spindle, and positions of the axes if `places`.
fn watched(page: Page, t: f64, places: bool) -> Vec<(String, String)> {
    let (rows, control) =
        (page.results.variables.get_untracked(), page.project.with_untracked(|project| project.control));
    let mut out = Vec::with_capacity(rows.len() + 4);
    page.player.ask_planner(|planner| {
        for MachineVariable { number, .. } in &rows {
            out.push((control.variable(*number), value_of(control, run::shown(planner, control, *number, t), 3)));
        }
        let now = planner.timeline().at(t);
        for (axis, state) in control.axes.iter().zip(&now.axes) {
            out.push((format!("{} mm/min", axis.letter), short(state.feed, 0)));
        }
        let words = planner.timeline().words_at(t);
        for (axis, word) in control.axes.iter().zip(words).filter(|_| places) {
            out.push((axis.letter.to_string(), short(word, 3)));
        }
        out.push((self::t("page.spindle-actual").to_owned(), short(now.spindle.command, 0)));
        out.push((self::t("page.volts").to_owned(), short(now.spindle.volts, 3)));
    });
    out
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, settled};

    #[wasm_bindgen_test]
    async fn action_is_a_step_that_undo_takes_back() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        act(page, Action::SpindleOverride(80.0));
        settled().await;
        assert_eq!(page.project.with_untracked(|project| project.panel.events().len()), 1);
        assert!(page.player.changed.get_untracked().contains(" 80 %"));
        page.undo();
        settled().await;
        assert!(page.project.with_untracked(|project| project.panel.events().is_empty()));
    }

    #[wasm_bindgen_test]
    fn places_follow_an_element_that_has_gone_elsewhere() {
        let after = |moved| [0, 1, 2, 3].map(|at| place_after(at, moved));
        assert_eq!(after((0, 2)), [2, 0, 1, 3]);
        assert_eq!(after((3, 1)), [0, 2, 3, 1]);
        assert_eq!(after((1, 1)), [0, 1, 2, 3]);
    }

    #[wasm_bindgen_test]
    async fn list_is_shown_with_the_last_action_before_the_head() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        for t in [1.0, 2.0, 3.0] {
            page.note(Event { t, action: Action::Hold });
        }
        page.player.seek(2.5);
        toggle_list(page);
        assert_eq!((page.view.actions.get_untracked(), page.view.action.get_untracked()), (true, Some(1)));
        toggle_list(page);
        assert!(!page.view.actions.get_untracked());
        settled().await;
    }
}

//! Actions of the operator at the play head, and the sentence about their effect.

use leptos::prelude::*;

use super::Page;
use crate::controls::Control;
use crate::drives::speed::SpeedLimit;
use crate::motion::{Action, Event};
use crate::project::run;
use crate::text::catalog::number_text;
use crate::text::listed;
use crate::ui::dom;
use crate::ui::words::{clock, short, t, value_of};

/// Machine seconds after an action at which its effect is reported.
const EFFECT: f64 = 1.0;

/// Does an action at the head and tells what it changes: the run a little later, with and without it.
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
                changes.push(format!("{name} {old} → {new}"));
            }
        }
        let effect = if changes.is_empty() { t("page.no-change").to_owned() } else { listed(changes) };
        let done = page.project.with_untracked(|project| name(&event.action, project.control));
        player.changed.set(format!("{} s: {done} · {effect}", clock(event.t)));
        dom::mark("knob-answered");
        dom::measure("knob", "knob-turned", "knob-answered");
    });
}

/// The position of a switch or knob at a time.
pub(crate) fn standing<T: Copy>(events: &[Event], at: f64, first: T, of: impl Fn(&Action) -> Option<T>) -> T {
    events.iter().rev().filter(|event| event.t <= at).find_map(|event| of(&event.action)).unwrap_or(first)
}

/// Names and values that an action may change, at a time: variables, feeds, spindle, and where asked for the places of the axes.
fn watched(page: Page, t: f64, places: bool) -> Vec<(String, String)> {
    let (rows, control) =
        (page.results.variables.get_untracked(), page.project.with_untracked(|project| project.control));
    let mut out = Vec::with_capacity(rows.len() + 4);
    page.player.ask_planner(|planner| {
        for (number, _, _) in &rows {
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

/// The name of an action.
pub(crate) fn name(action: &Action, control: &Control) -> String {
    let plain = |number: f64| number_text(number, 6);
    let on = |id: &'static str, on: bool| format!("{} {}", t(id), t(if on { "page.on" } else { "page.off" }));
    let share = |id: &'static str, percent: f64| format!("{} {} %", t(id), plain(percent));
    match action {
        Action::SpindleOverride(percent) => share("page.spindle-override", *percent),
        Action::FeedOverride(percent) => share("page.feed-override", *percent),
        Action::RapidOverride(percent) => share("page.rapid-override", *percent),
        Action::Start => t("page.start").to_owned(),
        Action::Hold => t("page.hold").to_owned(),
        Action::Reset => t("page.reset").to_owned(),
        Action::EmergencyStop => t("page.estop").to_owned(),
        Action::InverterFault(state) => on("page.inverter-fault", *state),
        Action::ProgramZeroReturn => t("page.zero-return").to_owned(),
        Action::SingleBlock(state) => on("page.single-block", *state),
        Action::OptionalStop(state) => on("page.optional-stop", *state),
        Action::BlockSkip(state) => on("page.block-skip", *state),
        Action::ManualSpeed(rpm) => format!("S {}", plain(*rpm)),
        Action::SpeedLimit(limit, rpm) => {
            let id = match limit {
                SpeedLimit::Lower => "page.lower-speed-limit",
                SpeedLimit::Upper => "page.upper-speed-limit",
                SpeedLimit::Surface => "page.surface-speed-limit",
            };
            format!("{} {}", t(id), plain(*rpm))
        }
        Action::Input(name, value) => format!("{name} = {}", plain(*value)),
        Action::Variable(number, value) => format!("{} = {}", control.variable(*number), value_of(control, *value, 6)),
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, project, settled};

    #[wasm_bindgen_test]
    fn last_setting_before_a_time_counts() {
        let feed = |t, percent| Event { t, action: Action::FeedOverride(percent) };
        let events = [feed(1.0, 50.0), Event { t: 2.0, action: Action::Start }, feed(3.0, 70.0)];
        let at = |t| {
            standing(&events, t, 100.0, |action| match action {
                Action::FeedOverride(percent) => Some(*percent),
                _ => None,
            })
        };
        assert_eq!([0.5, 1.0, 2.5, 3.5].map(at), [100.0, 50.0, 50.0, 70.0]);
    }

    #[wasm_bindgen_test]
    fn action_is_named_with_value_and_unit() {
        let control = project().control;
        assert!(name(&Action::SpindleOverride(80.0), control).ends_with(" 80 %"));
        assert_eq!(name(&Action::Variable(101, Some(2.0)), control), format!("{} = 2", control.variable(101)));
    }

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
}

//! The operator's hand: what a person at the machine turns and presses, acting at the play head.

use leptos::prelude::*;

use super::dom;
use super::el::{El, button, el, icon_button};
use super::model::Model;
use super::words::{clock, short, t, value_of};
use crate::controls::Control;
use crate::drives::speed::SpeedLimit;
use crate::math;
use crate::motion::{Action, Event, Mode};
use crate::project::{Project, run};
use crate::text::catalog::number_text;
use crate::text::number::filled;

/// Percent that the knobs reach.
const FULL: f64 = 200.0;

/// Machine seconds behind an action after which its effect is told.
const EFFECT: f64 = 1.0;

/// A number as it is set.
fn plain(number: f64) -> String {
    number_text(number, 6)
}

/// What an action is called.
fn name(action: &Action, control: &Control) -> String {
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

/// Does an action at the head and tells what it changes: the run a little later, with and without it.
pub(super) fn act(model: Model, action: Action) {
    dom::mark("knob-turned");
    let player = model.player;
    let later = player.head() + EFFECT;
    player.plan_to(later);
    let without = watched(model, later);
    let event = player.act(action);
    model.note(event.clone());
    let tell = move || {
        player.plan_to(later);
        let mut changes: Vec<String> = Vec::new();
        for ((name, old), (_, new)) in without.into_iter().zip(watched(model, later)) {
            if old != new {
                changes.push(format!("{name} {old} → {new}"));
            }
        }
        let effect = if changes.is_empty() { t("page.no-change").to_owned() } else { changes.join(", ") };
        let done = model.project.with_untracked(|project| name(&event.action, project.control));
        model.changed.set(format!("{} s: {done} · {effect}", clock(event.t)));
        dom::mark("knob-answered");
        dom::measure("knob", "knob-turned", "knob-answered");
    };
    dom::soon(tell);
}

/// Names and values that an action may change, at a time: variables, feeds, spindle.
fn watched(model: Model, t: f64) -> Vec<(String, String)> {
    let (rows, control) = (model.variables.get_untracked(), model.project.with_untracked(|project| project.control));
    let mut out = Vec::with_capacity(rows.len() + 4);
    model.player.ask_planner(|planner| {
        for (number, _, _) in &rows {
            out.push((control.variable(*number), value_of(control, run::shown(planner, control, *number, t), 3)));
        }
        let now = planner.timeline().at(t);
        for (axis, state) in control.axes.iter().zip(&now.axes) {
            out.push((format!("{} mm/min", axis.letter), short(state.feed, 0)));
        }
        out.push((self::t("page.spindle-actual").to_owned(), short(now.spindle.command, 0)));
        out.push((self::t("page.volts").to_owned(), short(now.spindle.volts, 3)));
    });
    out
}

/// What the knobs stand at, at a time.
fn standing<T: Copy>(events: &[Event], at: f64, first: T, of: impl Fn(&Action) -> Option<T>) -> T {
    events.iter().rev().filter(|event| event.t <= at).find_map(|event| of(&event.action)).unwrap_or(first)
}

/// The panel.
pub(super) fn hand(model: Model) -> El {
    let player = model.player;
    let standing = move |first: fn(&Project) -> f64, of: fn(&Action) -> Option<f64>| {
        move || {
            let head = player.now.with(|now| now.t);
            model.project.with(|project| standing(project.panel.events(), head, first(project), of))
        }
    };
    let spindle = standing(
        |project| project.prepared().panel().spindle_override.unwrap_or(100.0),
        |action| match action {
            Action::SpindleOverride(percent) => Some(*percent),
            _ => None,
        },
    );
    let feed = standing(
        |_| 100.0,
        |action| match action {
            Action::FeedOverride(percent) => Some(*percent),
            _ => None,
        },
    );
    let single = standing(
        |_| 0.0,
        |action| match action {
            Action::SingleBlock(on) => Some(f64::from(*on)),
            _ => None,
        },
    );
    let step = move || model.project.with(|project| project.prepared().panel().override_step);
    let waits = move || matches!(player.now.with(|now| now.mode), Mode::Hold | Mode::Stopped);
    let press = move |class: &str, label: &'static str, action: Action| {
        button(class, t(label), move || act(model, action.clone()))
    };
    let turn_single = move || act(model, Action::SingleBlock(untrack(single) == 0.0));
    let presses = el("div.presses").add(&[
        press("button.start", "page.start", Action::Start).mark("due", waits),
        press("button", "page.hold", Action::Hold),
        press("button", "page.reset", Action::Reset),
        button("button", t("page.single-block"), turn_single).state("aria-pressed", move || single() != 0.0),
        press("button.stop", "page.estop", Action::EmergencyStop),
    ]);
    let clear = move || model.edit("", |project| project.panel = crate::motion::Panel::default());
    let count = move || model.project.with(|project| project.panel.events().len());
    let told = move || match model.changed.get() {
        told if told.is_empty() => t("page.hand-hint").to_owned(),
        told => told,
    };
    let clear = button("button.link", t("page.clear-hand"), clear).live(move || format!(" ({})", count()));
    el("section.pane.hand").label(t("page.hand")).add(&[
        knob(model, "spindle-knob", t("page.spindle-override"), spindle, step, Action::SpindleOverride),
        knob(model, "feed-knob", t("page.feed-override"), feed, || 10.0, Action::FeedOverride),
        presses,
        el("p.changed").add(&[el("span#changed").live(told), clear.mark("gone", move || count() == 0)]),
    ])
}

fn knob(
    model: Model,
    id: &'static str,
    label: &str,
    value: impl Fn() -> f64 + Copy + 'static,
    step: impl Fn() -> f64 + Copy + 'static,
    action: fn(f64) -> Action,
) -> El {
    let turn = move |percent: f64| {
        let percent = math::clamp(percent, 0.0, FULL);
        if percent != untrack(value) {
            act(model, action(percent));
        }
    };
    let by = move |sign: f64| turn(untrack(value) + sign * untrack(step));
    let slider = el("input").at("type", "range").at("id", id).at("min", "0").at("max", "200");
    let input = slider.html().clone();
    let part = move || drop(input.style().set_property("--part", &filled("#%", &[value() / FULL * 100.0])));
    let turned = move |event| {
        if let Some(percent) = super::el::number(&event) {
            turn(percent);
        }
    };
    let slider = slider.bind("step", move || plain(step())).valued(move || plain(value())).run(part);
    el("div.knob").add(&[
        el("label").at("for", id).text(label),
        icon_button("button.icon", "−", &format!("{label} −"), move || by(-1.0)),
        slider.on("input", turned),
        icon_button("button.icon", "+", &format!("{label} +"), move || by(1.0)),
        el("output").at("for", id).live(move || format!("{} %", plain(value()))),
    ])
}

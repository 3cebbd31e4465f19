//! The operator's hand: what a person at the machine turns and presses, acting at the play head.

use leptos::prelude::*;

use super::dom;
use super::model::Model;
use super::words::{clock, figure, t};
use crate::machines::form::Value;
use crate::motion::{Action, Event, Mode};
use crate::project::Project;

/// Percent that the knobs reach.
const FULL: f64 = 200.0;

/// Machine seconds behind an action after which its effect is told.
const EFFECT: f64 = 1.0;

/// What an action is called.
fn name(action: &Action) -> String {
    let on = |id: &'static str, on: bool| format!("{} {}", t(id), t(if on { "page.on" } else { "page.off" }));
    match action {
        Action::SpindleOverride(percent) => format!("{} {percent} %", t("page.spindle-override")),
        Action::FeedOverride(percent) => format!("{} {percent} %", t("page.feed-override")),
        Action::RapidOverride(percent) => format!("{} {percent} %", t("page.rapid-override")),
        Action::Start => t("page.start").to_owned(),
        Action::Hold => t("page.hold").to_owned(),
        Action::Reset => t("page.reset").to_owned(),
        Action::EmergencyStop => t("page.estop").to_owned(),
        Action::SingleBlock(state) => on("page.single-block", *state),
        Action::OptionalStop(state) => on("page.optional-stop", *state),
        Action::BlockSkip(state) => on("page.block-skip", *state),
        Action::ManualSpeed(rpm) => format!("S {rpm}"),
        Action::Input(name, value) => format!("{name} = {value}"),
        Action::Variable(number, Some(value)) => format!("#{number} = {value}"),
        Action::Variable(number, None) => format!("#{number} = {}", t("page.vacant")),
    }
}

/// Does an action at the head and tells what it changed.
pub(super) fn act(model: Model, action: Action) {
    dom::mark("knob-turned");
    let player = model.player;
    let before = watched(model, player.head());
    let event = player.act(action);
    model.note(event.clone());
    let told = format!("{} s: {}", clock(event.t), name(&event.action));
    let pending = StoredValue::new_local(Some(before));
    let tell = move |at: f64| {
        let after = watched(model, at);
        let changes: Vec<String> = pending
            .get_value()
            .unwrap_or_default()
            .into_iter()
            .zip(after)
            .filter(|((_, old), (_, new))| old != new)
            .map(|((name, old), (_, new))| format!("{name} {old} → {new}"))
            .collect();
        let effect = if changes.is_empty() { t("page.no-change").to_owned() } else { changes.join(", ") };
        model.changed.set(format!("{told} · {effect}"));
    };
    // The plan behind the event grows in slices; the effect is told from what stands there a little later.
    let at = event.t + EFFECT;
    leptos::task::spawn_local(async move {
        leptos::task::tick().await;
        player.plan_to(at);
        tell(at);
        dom::mark("knob-answered");
        dom::measure("knob", "knob-turned", "knob-answered");
    });
}

/// Names and values that an action may change, at a time.
fn watched(model: Model, t: f64) -> Vec<(String, String)> {
    let rows = model.project.with_untracked(|project| project.machine.variables(project.control));
    let mut out = Vec::with_capacity(rows.len() + 2);
    model.player.ask_planner(|planner| {
        for (number, _, _) in &rows {
            let value = planner.variable_at(*number, t);
            out.push((format!("#{number}"), value.map_or_else(vacant, |value| figure(value, 3))));
        }
        let now = planner.timeline().at(t);
        out.push((t_("page.spindle-actual"), figure(now.spindle.command, 0)));
        out.push((t_("page.volts"), figure(now.spindle.volts, 3)));
    });
    out
}

fn t_(id: &'static str) -> String {
    t(id).to_owned()
}

fn vacant() -> String {
    t("page.vacant").to_owned()
}

/// What the knobs stand at, at a time.
fn standing<T: Copy>(events: &[Event], at: f64, first: T, of: impl Fn(&Action) -> Option<T>) -> T {
    events.iter().rev().filter(|event| event.t <= at).find_map(|event| of(&event.action)).unwrap_or(first)
}

/// The panel.
pub(super) fn hand(model: Model) -> AnyView {
    let player = model.player;
    let head = Memo::new(move |_| player.now.with(|now| now.t));
    let state = move |first: fn(&Project) -> f64, of: fn(&Action) -> Option<f64>| {
        Memo::new(move |_| {
            model.project.with(|project| standing(project.panel.events(), head.get(), first(project), of))
        })
    };
    let spindle = state(
        |project| number(project, "override", 100.0),
        |action| match action {
            Action::SpindleOverride(percent) => Some(*percent),
            _ => None,
        },
    );
    let feed = state(
        |_| 100.0,
        |action| match action {
            Action::FeedOverride(percent) => Some(*percent),
            _ => None,
        },
    );
    let single = Memo::new(move |_| {
        model.project.with(|project| {
            standing(project.panel.events(), head.get(), false, |action| match action {
                Action::SingleBlock(on) => Some(*on),
                _ => None,
            })
        })
    });
    let step = Memo::new(move |_| model.project.with(|project| number(project, "knob-step", 10.0)));
    let mode = Memo::new(move |_| player.now.with(|now| now.mode));
    let waits = move || matches!(mode.get(), Mode::Hold | Mode::Stopped);
    let press = move |label: &'static str, class: &'static str, action: Action| {
        view! { <button type="button" class=class on:click=move |_| act(model, action.clone())>{t(label)}</button> }
    };
    let clear = move |_| model.edit("", |project| project.panel = crate::motion::Panel::default());
    let count = move || model.project.with(|project| project.panel.events().len());
    view! {
        <section class="pane hand" aria-label=t("page.hand")>
            {knob(model, "spindle-knob", "page.spindle-override", spindle, step, Action::SpindleOverride)}
            {knob(model, "feed-knob", "page.feed-override", feed, Memo::new(|_| 10.0), Action::FeedOverride)}
            <div class="presses">
                <button type="button" class="start" class:due=waits on:click=move |_| act(model, Action::Start)>{t("page.start")}</button>
                {press("page.hold", "", Action::Hold)}
                {press("page.reset", "", Action::Reset)}
                <button type="button" aria-pressed=move || single.get().to_string()
                    on:click=move |_| act(model, Action::SingleBlock(!single.get_untracked()))>{t("page.single-block")}</button>
                {press("page.estop", "stop", Action::EmergencyStop)}
            </div>
            <p class="changed" id="changed">
                {move || model.changed.with(|changed| if changed.is_empty() { t("page.hand-hint").to_owned() } else { changed.clone() })} " "
                {move || (count() > 0).then(|| view! { <button type="button" class="link" on:click=clear>{t("page.clear-hand")} " (" {count} ")"</button> })}
            </p>
        </section>
    }
    .into_any()
}

/// A number of the project's form; of a choice, its id as a number.
fn number(project: &Project, id: &str, otherwise: f64) -> f64 {
    match project.values.get(id) {
        Some(Value::Number(number)) => *number,
        Some(Value::Text(text)) => text.parse().unwrap_or(otherwise),
        _ => otherwise,
    }
}

fn knob(
    model: Model,
    id: &'static str,
    label: &'static str,
    value: Memo<f64>,
    step: Memo<f64>,
    action: fn(f64) -> Action,
) -> AnyView {
    let turn = move |percent: f64| {
        let percent = percent.clamp(0.0, FULL);
        if percent != value.get_untracked() {
            act(model, action(percent));
        }
    };
    let turned = move |event| {
        if let Ok(percent) = event_target_value(&event).parse() {
            turn(percent);
        }
    };
    let part = move || format!("{:.1}%", value.get() / FULL * 100.0);
    view! {
        <div class="knob">
            <label for=id>{t(label)}</label>
            <button type="button" class="icon" aria-label=format!("{} −", t(label)) on:click=move |_| turn(value.get_untracked() - step.get_untracked())>"−"</button>
            <input type="range" id=id min="0" max=FULL step=step style:--part=part prop:value=move || value.get().to_string() on:input=turned />
            <button type="button" class="icon" aria-label=format!("{} +", t(label)) on:click=move |_| turn(value.get_untracked() + step.get_untracked())>"+"</button>
            <output for=id>{move || value.get().to_string()} " %"</output>
        </div>
    }
    .into_any()
}

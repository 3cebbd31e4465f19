//! Play, pause, single steps, speed, and the slider of the play head.

use leptos::prelude::*;

use super::dom;
use super::model::Model;
use super::player::SPEEDS;
use super::words::t;
use crate::motion::Mode;

const ICON_START: &str = "M3 3h2v10H3zM13 3v10L6 8z";
const ICON_BACK: &str = "M11 3h2v10h-2zM9 3v10L2 8z";
const ICON_STEP: &str = "M3 3h2v10H3zM7 3v10l7-5z";
const ICON_PLAY: &str = "M4 2.5v11l9-5.5z";
const ICON_PAUSE: &str = "M4 3h3v10H4zM9 3h3v10H9z";

/// A sign that looks the same with every font.
fn icon(path: &'static str) -> AnyView {
    view! { <svg class="sign" viewBox="0 0 16 16" aria-hidden="true"><path d=path /></svg> }.into_any()
}

/// What the control does, in words.
pub(super) fn mode_words(mode: Mode) -> &'static str {
    match mode {
        Mode::Running => t("page.mode-running"),
        Mode::Hold => t("page.mode-hold"),
        Mode::Stopped => t("page.mode-stopped"),
        Mode::WaitFin => t("page.mode-wait-fin"),
        Mode::Dwell => t("page.mode-dwell"),
        Mode::Ended => t("page.mode-ended"),
        Mode::Alarm => t("page.mode-alarm"),
        Mode::EmergencyStop => t("page.mode-estop"),
    }
}

/// The class of a mode.
pub(super) fn mode_tone(mode: Mode) -> &'static str {
    match mode {
        Mode::Running => "ok",
        Mode::Alarm | Mode::EmergencyStop => "fail",
        Mode::Hold | Mode::Stopped => "warn",
        _ => "info",
    }
}

/// A speed as people say it: `1/20`, `2`.
fn speed_text(speed: f64) -> String {
    if speed < 1.0 { format!("1/{:.0} ×", 1.0 / speed) } else { format!("{speed:.0} ×") }
}

/// The transport.
pub(super) fn transport(model: Model) -> AnyView {
    let player = model.player;
    let playing = player.playing;
    let speeds = SPEEDS.map(|speed| {
        let chosen = move || player.speed.get() == speed;
        view! { <option value=speed.to_string() prop:selected=chosen>{speed_text(speed)}</option> }
    });
    let set_speed = move |event| {
        if let Ok(speed) = event_target_value(&event).parse() {
            player.speed.set(speed);
        }
    };
    let scrub = move |event| {
        player.playing.set(false);
        if let Ok(ms) = event_target_value(&event).parse::<f64>() {
            player.seek(ms / 1000.0);
        }
    };
    let seek = move |event: web_sys::Event| {
        let text = event_target_value(&event).replace(',', ".");
        if let Ok(t) = text.trim().parse::<f64>() {
            player.playing.set(false);
            player.seek(t);
        }
        if let Some(input) = dom::by_id("go-to") {
            let _ = input.blur();
        }
    };
    let total = move || super::words::clock(player.planned.get().0);
    view! {
        <section class="transport" aria-label=t("page.transport")>
            <input type="range" id="head" class="scrub" min="0" max="1" step="1" aria-label=t("page.head") on:input=scrub />
            <div class="keys">
                <button type="button" class="icon" aria-label=t("page.to-start") title=t("page.to-start-key") on:click=move |_| player.seek(0.0)>{icon(ICON_START)}</button>
                <button type="button" class="icon" aria-label=t("page.step-back") title=t("page.step-back-key") on:click=move |_| player.step(false)>{icon(ICON_BACK)}</button>
                <button type="button" class="icon play" id="play" aria-label=move || t(if playing.get() { "page.pause" } else { "page.play" })
                    title=t("page.play-key") on:click=move |_| player.toggle()>{move || icon(if playing.get() { ICON_PAUSE } else { ICON_PLAY })}</button>
                <button type="button" class="icon" aria-label=t("page.step") title=t("page.step-key") on:click=move |_| player.step(true)>{icon(ICON_STEP)}</button>
                <span class="time"><b id="clock">"00:00.0000"</b> <span class="total">{total}</span></span>
                <select class="speed" aria-label=t("page.speed") on:change=set_speed>{speeds.into_iter().collect_view()}</select>
                <label class="goto"><span>{t("page.go-to")}</span>
                    <input type="text" id="go-to" inputmode="decimal" autocomplete="off" placeholder="s" on:change=seek /></label>
            </div>
        </section>
    }
    .into_any()
}

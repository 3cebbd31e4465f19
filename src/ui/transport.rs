//! Play, pause, single steps, speed, and the slider of the play head.

use web_sys::Event;

use super::dom;
use super::el::{El, button, el, number};
use super::model::Model;
use super::player::SPEEDS;
use super::words::t;
use crate::motion::Mode;
use crate::text::catalog::number_text;
use crate::text::number::filled;

const ICON_START: &str = "M3 3h2v10H3zM13 3v10L6 8z";
const ICON_BACK: &str = "M11 3h2v10h-2zM9 3v10L2 8z";
const ICON_STEP: &str = "M3 3h2v10H3zM7 3v10l7-5z";
const ICON_PLAY: &str = "M4 2.5v11l9-5.5z";
const ICON_PAUSE: &str = "M4 3h3v10H4zM9 3h3v10H9z";

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
    if speed < 1.0 { filled("1/# ×", &[1.0 / speed]) } else { filled("# ×", &[speed]) }
}

/// The transport.
pub(super) fn transport(model: Model) -> El {
    let player = model.player;
    let playing = move || player.playing.get();
    let speeds = SPEEDS.map(|speed| el("option").at("value", &number_text(speed, 6)).text(&speed_text(speed)));
    let speed =
        el("select.speed").label(t("page.speed")).add(&speeds).valued(move || number_text(player.speed.get(), 6));
    let speed = speed.on("change", move |event| {
        if let Some(speed) = number(&event) {
            player.speed.set(speed);
        }
    });
    let scrub = move |event| {
        player.playing.set(false);
        if let Some(ms) = number(&event) {
            player.seek(ms / 1000.0);
        }
    };
    let go_to = move |event: Event| {
        if let Some(t) = number(&event) {
            player.playing.set(false);
            player.seek(t);
        }
    };
    let play = key("button.icon.play#play", ICON_PLAY, "page.play", "page.play-key", move || player.toggle());
    let sign = play.dom().query_selector("path").ok().flatten();
    let follow = move || {
        if let Some(sign) = &sign {
            dom::set(sign, "d", if playing() { ICON_PAUSE } else { ICON_PLAY });
        }
    };
    let play =
        play.run(follow).bind("aria-label", move || t(if playing() { "page.pause" } else { "page.play" }).to_owned());
    let total = move || super::words::clock(player.planned.get().0);
    let go_to =
        el("input#go-to").at("type", "text").at("inputmode", "decimal").at("placeholder", "s").on("change", go_to);
    let head = el("input.scrub#head").at("type", "range").at("min", "0").at("max", "1").label(t("page.head"));
    let keys = el("div.keys").add(&[
        key("button.icon", ICON_START, "page.to-start", "page.to-start-key", move || player.seek(0.0)),
        key("button.icon", ICON_BACK, "page.step-back", "page.step-back-key", move || player.step(false)),
        play,
        key("button.icon", ICON_STEP, "page.step", "page.step-key", move || player.step(true)),
        el("span.time").add(&[el("b#clock").text("00:00.0000"), el("span.total").live(total)]),
        speed,
        el("label.goto").text(t("page.go-to")).add(&[go_to]),
    ]);
    el("section.transport").label(t("page.transport")).add(&[head.on("input", scrub), keys])
}

/// A button with a sign that looks the same with every font.
fn key(spec: &str, path: &str, words: &'static str, title: &'static str, press: impl Fn() + 'static) -> El {
    let sign = el("svg").at("viewBox", "0 0 16 16").at("aria-hidden", "true").at("class", "sign");
    let sign = sign.add(&[el("path").at("d", path)]);
    button(spec, "", press).label(t(words)).at("title", t(title)).add(&[sign])
}

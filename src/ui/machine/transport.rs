//! Play, pause, single blocks, clock, speed.

use leptos::html;
use leptos::prelude::*;

use crate::text::catalog::number_text;
use crate::ui::parts::input::{Choice, number};
use crate::ui::parts::{Glyph, Icon, IconButton};
use crate::ui::state::Page;
use crate::ui::state::player::SPEEDS;
use crate::ui::words::{clock, speed_text, t};

/// The transport.
#[component]
pub(super) fn Transport() -> impl IntoView {
    let player = Page::here().player;
    let playing = player.playing;
    let play_words = move || t(if playing.get() { "page.pause" } else { "page.play" });
    let sign = Signal::derive(move || if playing.get() { Glyph::Pause } else { Glyph::Play });
    view! {
        <div class="keys">
            <IconButton glyph=Glyph::ToStart label=t("page.to-start") title=t("page.to-start-key") press=move || player.seek(0.0) />
            <IconButton glyph=Glyph::Back label=t("page.step-back") title=t("page.step-back-key") press=move || player.step(false) />
            <button type="button" class="icon play" id="play" aria-label=play_words title=t("page.play-key") on:click=move |_| player.toggle()>
                <Icon glyph=sign />
            </button>
            <IconButton glyph=Glyph::Forth label=t("page.step") title=t("page.step-key") press=move || player.step(true) />
            <Clock />
            <span class="space"></span>
            <RunningBlock />
            <GoTo />
            <Speed />
            <button
                type="button" class="icon repeat" aria-label=t("page.repeat") title=t("page.repeat")
                aria-pressed=move || player.repeat.get().to_string()
                on:click=move |_| player.repeat.update(|on| *on = !*on)
            >
                <Icon glyph=Glyph::Repeat />
            </button>
        </div>
    }
}

/// The time of the head, written in each frame, and the length of the run.
#[component]
fn Clock() -> impl IntoView {
    let player = Page::here().player;
    let place: NodeRef<html::B> = NodeRef::new();
    let mut last = String::new();
    player.paint(move |moment| {
        let text = clock(moment.now.t);
        if let Some(place) = place.get_untracked().filter(|_| text != last) {
            place.set_text_content(Some(&text));
            last = text;
        }
    });
    view! {
        <span class="time">
            <b id="clock" node_ref=place>"00:00.0000"</b>
            <span class="total">{move || clock(player.planned.get().0)}</span>
        </span>
    }
}

/// The block that runs, as it stands in the program.
#[component]
fn RunningBlock() -> impl IntoView {
    let page = Page::here();
    let text = move || {
        let place = page.player.running.get()?;
        page.program.written.with(|written| {
            let file = written.files.get(place.file)?;
            Some(place.span.of(&file.text).trim().to_owned())
        })
    };
    view! { <code class="where">{move || text().unwrap_or_default()}</code> }
}

/// A time to go to.
#[component]
fn GoTo() -> impl IntoView {
    let player = Page::here().player;
    let go = move |event| {
        if let Some(t) = number(&event) {
            player.playing.set(false);
            player.seek(t);
        }
    };
    view! {
        <label class="goto">
            {t("page.go-to")} " "
            <input id="go-to" type="text" inputmode="decimal" placeholder="s" on:change=go />
        </label>
    }
}

/// Machine seconds per second.
#[component]
fn Speed() -> impl IntoView {
    let page = Page::here();
    let player = page.player;
    let value = |speed: f64| number_text(speed, 6);
    let options = move || {
        page.machine.track();
        let visible = page.project.with_untracked(|project| project.machine.speed());
        let automatic = ("0".to_owned(), format!("{} {}", t("page.automatic"), speed_text(visible)));
        core::iter::once(automatic).chain(SPEEDS.map(|speed| (value(speed), speed_text(speed)))).collect::<Vec<_>>()
    };
    let choose = move |speed: String| {
        if let Ok(speed) = speed.parse() {
            player.speed.set(speed);
        }
    };
    view! {
        <Choice
            attr:class="speed" attr:aria-label=t("page.speed") attr:title=t("page.speed")
            options=Signal::derive(options) chosen=Signal::derive(move || value(player.speed.get())) choose=choose
        />
    }
}

//! Play, pause, single blocks, clock, speed.

use leptos::html;
use leptos::prelude::*;

use crate::msg;
use crate::text::LineIndex;
use crate::text::catalog::number_text;
use crate::ui::dom;
use crate::ui::parts::input::Choice;
use crate::ui::parts::{Glyph, Icon, IconButton, Later};
use crate::ui::state::Page;
use crate::ui::state::planning::HORIZON;
use crate::ui::state::player::{PlannedPart, SPEEDS};
use crate::ui::words::{Tone, clock, read_clock, sentence, speed_text, t};

/// The transport.
#[component]
pub(in crate::ui::machine) fn Transport() -> impl IntoView {
    let player = Page::here().player;
    let playing = player.playing;
    let play_words = move || t(if playing.get() { "page.pause" } else { "page.play" });
    let sign = Signal::derive(move || if playing.get() { Glyph::Pause } else { Glyph::Play });
    view! {
        <div class="keys">
            <Later>
                <IconButton glyph=Glyph::ToStart label=t("page.to-start") title=t("page.to-start-key") press=move || player.seek(0.0) />
                <IconButton glyph=Glyph::Back label=t("page.step-back") title=t("page.step-back-key") class="block" press=move || player.pause_at_block_before() />
                <button type="button" class="icon play" id="play" aria-label=play_words title=t("page.play-key") on:click=move |_| player.toggle()>
                    <Icon glyph=sign />
                </button>
                <IconButton glyph=Glyph::Forth label=t("page.step") title=t("page.step-key") class="block" press=move || player.pause_at_next_block() />
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
            </Later>
        </div>
    }
}

/// The time of the play head, written in each frame, and the length of the run.
#[component]
fn Clock() -> impl IntoView {
    let player = Page::here().player;
    let place: NodeRef<html::B> = NodeRef::new();
    let rate: NodeRef<html::Span> = NodeRef::new();
    let mut last = String::new();
    let mut last_rate = None;
    player.paint(move |moment| {
        let now = Some(moment.speed).filter(|_| player.speed.get_untracked() == 0.0);
        if let Some(rate) = rate.get_untracked().filter(|_| now != last_rate) {
            let words = now.map(|now| sentence(&msg!("page.rate-now", rate = speed_text(now))));
            dom::set_text(&rate, &words.unwrap_or_default());
            last_rate = now;
        }
        let text = clock(moment.now.t);
        if let Some(place) = place.get_untracked().filter(|_| text != last) {
            dom::set_text(&place, &text);
            last = text;
        }
    });
    let total = move || match player.planned.get() {
        PlannedPart { end, is_over: false } if end >= HORIZON => format!("> {}", clock(end)),
        PlannedPart { end, .. } => clock(end),
    };
    view! {
        <span class="time">
            <b id="clock" node_ref=place>"00:00.0000"</b>
            <span class="total">{total}</span>
            <span class="rate" node_ref=rate></span>
        </span>
    }
}

/// Text of the running block; where there is little room, its number or its line alone, in a slot of fixed width.
#[component]
fn RunningBlock() -> impl IntoView {
    let page = Page::here();
    let block = Memo::new(move |_| {
        let place = page.player.running.get()?;
        page.program.written.with(|written| {
            let file = written.files.get(place.file)?;
            let text = place.span.of(&file.text).trim().to_owned();
            let line = sequence_number(&text).is_none().then(|| LineIndex::new(&file.text).line_of(place.span.start));
            Some((text, line))
        })
    });
    let parts = move || {
        block.with(|block| {
            let (text, line) = block.as_ref()?;
            let (number, words) = text.split_at(sequence_number(text).map_or(0, str::len));
            let line = line.map(|line| view! { <i>{sentence(&msg!("page.block-line", line))}</i> });
            Some(view! { {line}{number.to_owned()}<span>{words.to_owned()}</span> })
        })
    };
    let title = move || block.with(|block| block.as_ref().map(|(text, _)| text.clone()));
    view! { <code class="where" title=title>{parts}</code> }
}

/// The sequence number `N10` at the start of a block.
fn sequence_number(text: &str) -> Option<&str> {
    let digits = text.strip_prefix('N')?.bytes().take_while(u8::is_ascii_digit).count();
    (digits != 0).then(|| text.get(..=digits)).flatten()
}

/// Input of a time (s) to which the play head goes.
#[component]
fn GoTo() -> impl IntoView {
    let page = Page::here();
    let go = move |event: web_sys::Event| {
        let input = event_target::<web_sys::HtmlInputElement>(&event);
        let text = input.value();
        match read_clock(&text) {
            Some(t) => {
                page.player.playing.set(false);
                page.player.seek(t);
            }
            None if text.trim().is_empty() => {}
            None => page.notices.confirm_as(Tone::Warn, sentence(&msg!("page.no-time", text))),
        }
        // The clock shows the time from now on.
        input.set_value("");
    };
    view! {
        <input id="go-to" class="goto" type="text" inputmode="decimal" aria-label=t("page.go-to") placeholder=t("page.go-to") on:change=go />
    }
}

/// Machine seconds per second.
#[component]
fn Speed() -> impl IntoView {
    let player = Page::here().player;
    let value = |speed: f64| number_text(speed, 6);
    let options = move || {
        let automatic = ("0".to_owned(), t("page.automatic").to_owned());
        core::iter::once(automatic).chain(SPEEDS.map(|speed| (value(speed), speed_text(speed)))).collect::<Vec<_>>()
    };
    let choose = move |speed: String| {
        if let Ok(speed) = speed.parse() {
            player.speed.set(speed);
            player.ask();
        }
    };
    view! {
        <Choice
            attr:class="speed" attr:aria-label=t("page.speed") attr:title=t("page.speed")
            options=Signal::derive(options) chosen=Signal::derive(move || value(player.speed.get())) choose=choose
        />
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, mount, settled, until};

    async fn transport() -> ViewBench {
        let bench = mount(|| view! { <Transport /> }).await;
        bench.run().await;
        bench
    }

    async fn shows(bench: &ViewBench, time: &'static str) {
        let clock = bench.find("#clock");
        until(move || clock.text_content().as_deref() == Some(time)).await;
    }

    #[wasm_bindgen_test]
    async fn play_button_names_its_action() {
        let bench = transport().await;
        assert_eq!(bench.attribute("#play", "aria-label"), t("page.play"));
        bench.press("#play").await;
        assert_eq!(bench.attribute("#play", "aria-label"), t("page.pause"));
        let player = bench.page.player;
        until(move || player.head() > 0.0).await;
        bench.press("#play").await;
        assert_eq!(bench.attribute("#play", "aria-label"), t("page.play"));
    }

    #[wasm_bindgen_test]
    async fn steps_go_forth_and_back_by_a_block() {
        let bench = transport().await;
        let player = bench.page.player;
        let mut heads = vec![player.head()];
        for words in ["page.step", "page.step", "page.step-back", "page.to-start"] {
            bench.press_button(t(words)).await;
            heads.push(player.head());
        }
        assert!(heads[1] > heads[0] && heads[2] > heads[1], "{heads:?}");
        assert_eq!((heads[3], heads[4]), (heads[1], 0.0));
    }

    #[wasm_bindgen_test]
    async fn clock_shows_the_entered_time() {
        let bench = transport().await;
        shows(&bench, "00:00.0000").await;
        bench.choose("#go-to", "2,5").await;
        shows(&bench, "00:02.5000").await;
        bench.choose("#go-to", "soon").await;
        assert_eq!(bench.page.player.head(), 2.5);
        assert!(bench.notices().iter().any(|notice| notice.contains("soon")), "{:?}", bench.notices());
        bench.choose("#go-to", "00:01.25").await;
        shows(&bench, "00:01.2500").await;
    }

    #[wasm_bindgen_test]
    async fn running_block_is_shown_as_in_the_program() {
        let bench = transport().await;
        bench.seek(3.0).await;
        let place = bench.page.player.running.get_untracked().unwrap();
        let text = bench.page.program.text(place.file.0 as usize);
        let block = place.span.of(&text).trim();
        assert!(!block.is_empty() && bench.text(".where").ends_with(block));
        assert_eq!(bench.attribute(".where", "title"), block);
    }

    #[wasm_bindgen_test]
    async fn running_block_without_a_number_has_its_line() {
        let bench = transport().await;
        let page = bench.page;
        let place = |is_numbered: bool| {
            page.program.written.with_untracked(|written| {
                let deck = written.parsed.deck();
                let found = deck.programs.iter().find_map(|program| {
                    let text = &written.files.get(program.file)?.text;
                    let fits = |block: &&crate::nc::Block| {
                        let block = block.span.of(text).trim();
                        !block.is_empty() && sequence_number(block).is_some() == is_numbered
                    };
                    let block = deck.blocks_of(program).iter().find(fits)?;
                    Some((crate::text::Place { file: program.file, span: block.span }, text.clone()))
                });
                found.unwrap()
            })
        };
        let (numbered, _) = place(true);
        page.player.running.set(Some(numbered));
        settled().await;
        assert!(!bench.has(".where i") && bench.text(".where").starts_with('N'));
        let (other, text) = place(false);
        page.player.running.set(Some(other));
        settled().await;
        let line = LineIndex::new(&text).line_of(other.span.start);
        assert_eq!(bench.text(".where i"), sentence(&msg!("page.block-line", line)));
        assert_eq!(bench.text(".where span"), other.span.of(&text).trim());
    }

    #[wasm_bindgen_test]
    fn sequence_number_is_n_with_digits() {
        let read = ["N45 G01", "N7", "NEXT:", "G04 X1", "/N10 G0"].map(sequence_number);
        assert_eq!(read, [Some("N45"), Some("N7"), None, None, None]);
    }

    #[wasm_bindgen_test]
    async fn speed_begins_automatic_and_can_be_chosen() {
        let bench = transport().await;
        assert_eq!((bench.value(".speed").as_str(), bench.all(".speed option").len()), ("0", SPEEDS.len() + 1));
        bench.choose(".speed", "0.1").await;
        assert_eq!(bench.page.player.speed.get_untracked(), 0.1);
        bench.page.change_machine(crate::machines::ALL[1].id());
        settled().await;
        assert_eq!(bench.value(".speed"), "0");
    }

    #[wasm_bindgen_test]
    async fn automatic_rate_is_shown_beside_the_clock() {
        let bench = transport().await;
        bench.seek(3.0).await;
        let visible = bench.page.project.with_untracked(|project| project.machine.info().speed);
        let told = |speed| sentence(&msg!("page.rate-now", rate = speed_text(speed)));
        assert!([visible, 2.0].map(told).contains(&bench.text(".rate")), "{}", bench.text(".rate"));
        bench.choose(".speed", "0.1").await;
        bench.drawn().await;
        assert_eq!(bench.text(".rate"), "");
    }

    #[wasm_bindgen_test]
    async fn repeat_button_shows_its_state() {
        let bench = transport().await;
        assert_eq!(bench.attribute(".repeat", "aria-pressed"), "false");
        bench.press(".repeat").await;
        assert_eq!(bench.attribute(".repeat", "aria-pressed"), "true");
    }
}

//! The drawing of the machine, its state, and what can be done with the picture.

use leptos::ev::MouseEvent;
use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::Element;

use super::notices::NoticeBand;
use super::pictures::SavePicture;
use super::scene_view::Drawn;
use crate::motion::{Mode, RunEnd};
use crate::project::check::reported;
use crate::ui::dom;
use crate::ui::parts::scene::svg;
use crate::ui::parts::{Glyph, IconButton};
use crate::ui::state::Page;
use crate::ui::words::{end_words, mode_tone, mode_words, t, tell_alarm};

/// The drawing, moved by the run.
#[component]
pub(crate) fn Stage() -> impl IntoView {
    let page = Page::here();
    let player = page.player;
    let section: NodeRef<html::Section> = NodeRef::new();
    let host: NodeRef<html::Div> = NodeRef::new();
    let drawn = StoredValue::new_local(None::<Drawn>);
    Effect::new(move |_| {
        let Some(host) = host.get() else { return };
        page.results.scene.with(|scene| {
            host.set_inner_html(&svg(scene));
            drawn.set_value(Some(Drawn::new(&host, scene)));
        });
        player.ask();
    });
    // Labels keep their size when the stage gets another.
    for event in ["resize", "fullscreenchange"] {
        dom::hear(event, move |_| {
            drawn.try_with_value(|drawn| drawn.iter().for_each(Drawn::fit));
        });
    }
    player.paint(move |moment| {
        drawn.update_value(|drawn| {
            if let Some(drawn) = drawn {
                drawn.pose(&moment.machine.pose(moment.run, moment.now, moment.frame));
            }
        });
    });
    let option = move || page.results.scene.with(|scene| scene.option);
    let strobe = move || {
        player.option.update(|on| *on = !*on);
        player.ask();
    };
    // Words and class of the state: the machine's, as long as the film shows it in motion.
    let state = Memo::new(move |_| {
        let (mode, begun) = player.now.with(|now| (now.mode, now.t > 0.0));
        let moves = matches!(mode, Mode::Running | Mode::Dwell | Mode::WaitFin);
        match player.playing.get() {
            false if moves && begun => ("page.mode-paused", "info"),
            false if !begun => ("page.mode-ready", "info"),
            _ => (mode_words(mode), mode_tone(mode)),
        }
    });
    let open_field = move |event: MouseEvent| {
        let part = event.target().and_then(|target| target.dyn_into::<Element>().ok());
        let part = part.and_then(|part| part.closest("[data-field]").ok().flatten());
        if let Some(field) = part.and_then(|part| part.get_attribute("data-field")) {
            dom::go_to_field(&field);
        }
    };
    let full = move || {
        if let Some(section) = section.get_untracked() {
            dom::full_screen(&section);
        }
    };
    view! {
        <section class="pane drawing" id="machine" aria-label=t("page.drawing") node_ref=section>
            <div class="stage" role="group" aria-label=t("page.drawing") node_ref=host on:click=open_field></div>
            <span class=move || format!("mode {}", state.get().1)>{move || t(state.get().0)}</span>
            <div class="band">
                <p class="why" role="status">{move || why(page)}</p>
                <NoticeBand />
                <span class="space"></span>
                <Show when=move || option().is_some()>
                    <button
                        type="button" class="icon strobe"
                        aria-label=move || option().map(t).unwrap_or_default()
                        title=move || option().map(t).unwrap_or_default()
                        aria-pressed=move || player.option.get().to_string()
                        on:click=move |_| strobe()
                    >
                        <crate::ui::parts::Icon glyph=Glyph::Strobe />
                    </button>
                </Show>
                <SavePicture />
                <IconButton glyph=Glyph::Full label=t("page.full-screen") press=full />
            </div>
        </section>
    }
}

/// Why the machine stands at the end of the plan.
fn why(page: Page) -> String {
    let (at, (planned, _)) = (page.player.now.with(|now| now.t), page.player.planned.get());
    match page.player.ended.get().filter(|_| at >= planned) {
        // In the words that stand at its place in the program.
        Some(RunEnd::Alarm(alarm)) => {
            page.program.findings.with(|findings| tell_alarm(reported(findings, &alarm).unwrap_or(&alarm)))
        }
        end => end.map_or_else(String::new, |end| end_words(&end)),
    }
}

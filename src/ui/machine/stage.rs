//! The drawing of the machine, its state, and what can be done with the picture.

use leptos::ev::MouseEvent;
use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::Element;

use super::notices::NoticeBand;
use super::pictures;
use super::scene_view::Drawn;
use crate::motion::RunEnd;
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
    let mode = Memo::new(move |_| {
        let mode = player.now.with(|now| now.mode);
        let begun = player.playing.get() || player.now.with(|now| now.t > 0.0);
        (mode, begun)
    });
    let state = move || match mode.get() {
        (_, false) => t("page.mode-ready"),
        (mode, true) => mode_words(mode),
    };
    let tone = move || format!("mode {}", if mode.get().1 { mode_tone(mode.get().0) } else { "info" });
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
            <span class=tone>{state}</span>
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
                <IconButton glyph=Glyph::Picture label=t("page.save-picture") press=move || pictures::save_svg(page) />
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

//! When the block at the cursor of the listing runs: how often in the planned run, and a button that shows the machine when it runs next.

use leptos::prelude::*;

use crate::msg;
use crate::ui::state::player::next_begin;
use crate::ui::state::{Page, stepping};
use crate::ui::words::{clock, sentence};

/// The times of the block at the cursor. Without a block there it is absent.
#[component]
pub(super) fn BlockTimes() -> impl IntoView {
    let page = Page::here();
    let player = page.player;
    let times = Memo::new(move |_| {
        let (_, place) = stepping::at_cursor(page)?;
        player.plans.track();
        Some(player.ask_planner(|run| run.timeline().begins(place).collect::<Vec<_>>()).unwrap_or_default())
    });
    let shown = Memo::new(move |_| {
        times.with(|times| {
            let times = times.as_ref()?;
            let next = next_begin(times, player.now.with(|now| now.t));
            Some(match next {
                Some(t) => sentence(&msg!("page.block-begins", count = times.len() as u32, at = clock(t))),
                None => sentence(&msg!("page.block-never-begins")),
            })
        })
    });
    let never = move || times.with(|times| times.as_ref().is_none_or(Vec::is_empty));
    view! {
        <Show when=move || shown.with(Option::is_some)>
            <button type="button" class="begins" prop:disabled=never on:click=move |_| stepping::show_block(page)>
                {move || shown.get()}
            </button>
        </Show>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::text::FileId;
    use crate::ui::testing::{ViewBench, mount, settled};
    use crate::ui::words::t;

    /// Sets the cursor to the first line of the first program that has a text.
    async fn cursor(bench: &ViewBench, text: &str) {
        let found = bench.page.program.written.with_untracked(|written| {
            let line = |text_of: &str| text_of.lines().position(|line| line.contains(text));
            let files = written.files.0.iter().enumerate();
            files.into_iter().find_map(|(at, file)| Some((FileId(at as u16), line(&file.text)? as u32 + 1)))
        });
        bench.page.player.stepper.update(|stepper| stepper.cursor = found);
        settled().await;
    }

    #[wasm_bindgen_test]
    async fn cursor_block_shows_its_next_time_and_goes_there() {
        let bench = mount(|| view! { <BlockTimes /> }).await;
        bench.run().await;
        assert!(!bench.has(".begins"));
        cursor(&bench, "M30").await;
        assert!(bench.text(".begins").contains("Runs 1 time "), "{}", bench.text(".begins"));
        assert_eq!(bench.page.player.head(), 0.0);
        bench.press(".begins").await;
        let head = bench.page.player.head();
        assert!(head > 0.0 && bench.text(".begins").contains(&clock(head)), "{}", bench.text(".begins"));
    }

    #[wasm_bindgen_test]
    async fn block_that_does_not_run_has_a_note() {
        let bench = mount(|| view! { <BlockTimes /> }).await;
        bench.run().await;
        cursor(&bench, "#3000").await;
        assert_eq!(bench.text(".begins"), t("page.block-never-begins"));
    }
}

//! When the block at the cursor of the listing runs: how often in the planned run, and a button that shows the machine when it runs next.

use leptos::prelude::*;

use crate::msg;
use crate::nc::{Parsed, Stmt};
use crate::text::Place;
use crate::ui::state::player::next_begin;
use crate::ui::state::{Page, stepping};
use crate::ui::words::{clock, sentence, t};

/// The times of the block at the cursor. Without a block there it is absent.
#[component]
pub(super) fn BlockTimes() -> impl IntoView {
    let page = Page::here();
    let player = page.player;
    let times = Memo::new(move |_| {
        let (_, place) = stepping::at_cursor(page)?;
        player.plans.track();
        Some(player.ask_planner(|run| run.timeline().starts(place).collect::<Vec<_>>()).unwrap_or_default())
    });
    let calculates = Memo::new(move |_| {
        let Some((_, place)) = stepping::at_cursor(page) else { return false };
        page.program.written.with(|written| is_calculation(&written.parsed, place))
    });
    let shown = Memo::new(move |_| {
        times.with(|times| {
            let times = times.as_ref()?;
            let head = player.now.with(|now| now.t);
            let count = times.len() as u32;
            Some(match next_begin(times, head) {
                Some(at) if at > head => sentence(&msg!("page.block-begins", count, at = clock(at))),
                Some(at) => sentence(&msg!("page.block-began", count, at = clock(at))),
                None if calculates.get() => t("page.block-calculates").to_owned(),
                None => t("page.block-never-begins").to_owned(),
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

/// Whether a block calculates or jumps: it acts when the control reads it, and has no time of its own in the run.
fn is_calculation(parsed: &Parsed, place: Place) -> bool {
    let deck = parsed.deck();
    let programs = deck.programs.iter().filter(|program| program.file == place.file);
    let block = programs.flat_map(|program| deck.blocks_of(program)).find(|block| block.span == place.span);
    block.is_some_and(|block| {
        matches!(
            block.stmt,
            Stmt::Assign { .. }
                | Stmt::Assigns { .. }
                | Stmt::If { .. }
                | Stmt::Ifs { .. }
                | Stmt::IfThen { .. }
                | Stmt::Goto { .. }
                | Stmt::While { .. }
                | Stmt::End { .. }
        )
    })
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::text::FileId;
    use crate::ui::testing::{ViewBench, mount, settled};

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
        assert!(bench.text(".begins").starts_with("Runs 1 time · next at "), "{}", bench.text(".begins"));
        assert_eq!(bench.page.player.head(), 0.0);
        bench.press(".begins").await;
        bench.drawn().await;
        let head = bench.page.player.head();
        let last = format!("Runs 1 time · last at {}", clock(head));
        assert!(head > 0.0 && bench.text(".begins").starts_with(&last), "{}", bench.text(".begins"));
    }

    #[wasm_bindgen_test]
    async fn executions_in_direct_succession_are_counted() {
        let bench = mount(|| view! { <BlockTimes /> }).await;
        bench.run().await;
        // Between two dots there are calculations alone.
        cursor(&bench, "N44 G01").await;
        let (_, place) = untrack(|| stepping::at_cursor(bench.page)).unwrap();
        let player = bench.page.player;
        let count = player.ask_planner(|run| run.timeline().starts(place).count()).unwrap();
        let once = player.ask_planner(|run| run.timeline().begins(place).count()).unwrap();
        assert!(count > once, "{count} {once}");
        let told = bench.text(".begins");
        assert!(told.starts_with(&format!("Runs {count} times")), "{told}");
    }

    #[wasm_bindgen_test]
    async fn calculation_is_said_to_take_no_time() {
        let bench = mount(|| view! { <BlockTimes /> }).await;
        bench.run().await;
        cursor(&bench, "N45 #").await;
        assert_eq!(bench.text(".begins"), t("page.block-calculates"));
        assert!(bench.has(".begins:disabled"));
    }
}

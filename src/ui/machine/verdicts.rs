//! The few results above the drawing, one line each.

use leptos::prelude::*;

use crate::machines::Design;
use crate::ui::parts::Later;
use crate::ui::parts::verdict::VerdictLines;
use crate::ui::state::Page;
use crate::ui::words::{Tone, limit_sign, t, verdict_words};
use crate::view::{Readout, Verdict};

/// The results above the drawing: those of the headline, where failing results replace those without a limit.
fn above_the_drawing(design: &Design) -> Vec<Readout> {
    let (headline, others): (Vec<_>, Vec<_>) = design.readouts.iter().partition(|readout| readout.headline);
    let mut failing = others.into_iter().filter(|readout| readout.verdict == Verdict::Fail);
    let place = |readout: &Readout| match readout.limit {
        None if matches!(readout.verdict, Verdict::None | Verdict::Ok) => failing.next().unwrap_or(readout).clone(),
        _ => readout.clone(),
    };
    headline.into_iter().map(place).collect()
}

/// The verdicts.
#[component]
pub(crate) fn Verdicts() -> impl IntoView {
    let page = Page::here();
    let design = page.results.design;
    let headline = Memo::new(move |_| design.with(|design| above_the_drawing(design)));
    let rooms = move || {
        let count = headline.with_untracked(Vec::len);
        (0..count).map(|_| view! { <div class="card plain"></div> }).collect_view()
    };
    view! {
        <section
            class="cards" aria-label=t("page.headline") class:old=move || page.is_stale() || page.program.edited.get()
            title=move || page.program.edited.get().then(|| t("page.results-of-form"))>
            <div class="row">
                <Later meanwhile=rooms><VerdictLines readouts=headline /></Later>
            </div>
        </section>
    }
}

/// The results above the drawing as short lines, for a layout without the list of all results.
#[component]
pub(super) fn VerdictList() -> impl IntoView {
    let page = Page::here();
    let row = |readout: &Readout| {
        let readout = readout.clone().shown();
        let tone = Tone::from(readout.verdict);
        view! {
            <li class=tone.class()>
                <i aria-hidden="true">{tone.sign()}</i> " " {t(readout.label)} " "
                <b>{readout.value_text()} " " {readout.unit}</b>
                <span class="hidden">{verdict_words(readout.verdict)}</span>
                <span class="n">{limit_sign(&readout)}</span>
            </li>
        }
    };
    let rows = move || page.results.design.with(|design| above_the_drawing(design).iter().map(row).collect_view());
    view! { <ul class="verdicts" aria-label=t("page.headline") class:old=move || page.is_stale()>{rows}</ul> }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::state::view::Tab;
    use crate::ui::testing::{field, mount, settled};

    #[wasm_bindgen_test]
    async fn headline_results_have_a_line_each() {
        let bench = mount(|| view! { <Verdicts /> }).await;
        let design = bench.page.results.design.get_untracked();
        assert_eq!(bench.all(".card").len(), design.readouts.iter().filter(|readout| readout.headline).count());
        bench.press(".card .to-result").await;
        assert_eq!(bench.page.view.tab.get_untracked(), Tab::Results);
    }

    #[wasm_bindgen_test]
    async fn failing_result_takes_the_place_of_one_without_a_limit() {
        let bench = mount(|| view! { <Verdicts /> }).await;
        let count = bench.all(".card").len();
        // So low a pinch force makes the web slip, which no headline result shows.
        let fails = |readout: &&Readout| readout.verdict == Verdict::Fail && !readout.headline;
        bench.page.set("pinch-force", crate::machines::form::Value::Number(1.0));
        settled().await;
        let design = bench.page.results.design.get_untracked();
        let failing = design.readouts.iter().find(fails).map(|readout| t(readout.label)).unwrap();
        assert!(bench.text(".cards").contains(failing), "{failing}");
        assert_eq!(bench.all(".card").len(), count);
    }

    #[wasm_bindgen_test]
    async fn verdicts_are_old_while_an_entry_is_wrong() {
        let bench = mount(|| view! { <Verdicts /> }).await;
        assert!(!bench.has(".cards.old"));
        bench.page.entries.refuse("pitch", *field("pitch").read_metric("x").unwrap_err());
        settled().await;
        assert!(bench.has(".cards.old"));
    }

    #[wasm_bindgen_test]
    async fn verdicts_of_values_that_the_machine_cannot_have_are_not_old() {
        let bench = mount(|| view! { <Verdicts /> }).await;
        bench.page.set("press-roller-diameter", crate::machines::form::Value::Number(150.0));
        settled().await;
        assert!(!untrack(|| bench.page.wrong_fields()).is_empty() && !bench.has(".cards.old"));
    }

    #[wasm_bindgen_test]
    async fn verdicts_follow_the_form() {
        let bench = mount(|| view! { <Verdicts /> }).await;
        let before = bench.text(".cards");
        bench.page.set("pitch", crate::machines::form::Value::Number(16.0));
        settled().await;
        assert_ne!(bench.text(".cards"), before);
    }
}

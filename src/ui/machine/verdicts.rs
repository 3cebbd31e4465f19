//! The few results above the drawing, one line each.

use leptos::prelude::*;

use crate::ui::parts::verdict::VerdictLine;
use crate::ui::state::Page;
use crate::ui::words::t;

/// The verdicts.
#[component]
pub(crate) fn Verdicts() -> impl IntoView {
    let page = Page::here();
    let lines = move || {
        let design = page.results.design.get();
        let headline = design.readouts.iter().filter(|readout| readout.headline).cloned();
        let line = |readout: crate::view::Readout| {
            let id = readout.id;
            view! { <VerdictLine readout=readout open=move || page.show_result(id) /> }
        };
        headline.map(line).collect_view()
    };
    view! {
        <section class="cards" aria-label=t("page.headline") class:old=move || page.is_stale()>
            <div class="row">{lines}</div>
            <p class="stale-short" class:gone=move || !page.is_stale()>{t("page.stale-short")}</p>
        </section>
    }
}

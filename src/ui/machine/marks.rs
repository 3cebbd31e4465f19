//! Marks on the time axis: actions of the operator, and the end of the run.

use leptos::prelude::*;

use crate::text::number::filled;
use crate::ui::state::Page;
use crate::ui::state::operator::name;
use crate::ui::words::{clock, t};

/// The marks.
#[component]
pub(super) fn Marks(
    /// Ends of the shown time, in seconds.
    axis: RwSignal<(f64, f64)>,
) -> impl IntoView {
    let page = Page::here();
    let place = move |seconds: f64| {
        let (from, to) = axis.get();
        (from..=to).contains(&seconds).then(|| 100.0 * (seconds - from) / (to - from))
    };
    let rows = move || {
        page.project.with(|project| {
            let events = project.panel.events().iter();
            events.map(|event| (event.t, name(&event.action, project.control))).collect::<Vec<_>>()
        })
    };
    let actions = move || {
        let marks = rows().into_iter().filter_map(|(seconds, words)| Some((place(seconds)?, seconds, words)));
        let mark = |(percent, seconds, words): (f64, f64, String)| {
            let title = format!("{} s: {words}", clock(seconds));
            let go = move |_| page.player.seek(seconds);
            view! {
                <button type="button" class="mark" tabindex="-1" aria-label=title.clone() title=title style:left=filled("#%", &[percent]) on:click=go></button>
            }
        };
        marks.map(mark).collect_view()
    };
    let end = move || {
        let (planned, over) = page.player.planned.get();
        let percent = place(planned).filter(|_| over)?;
        Some(view! { <i class="mark end" style:left=filled("#%", &[percent]) title=t("page.end")></i> })
    };
    view! { <div class="marks">{actions}{end}</div> }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::motion::{Action, Event};
    use crate::ui::testing::{Bench, mount, settled};

    async fn marks() -> (Bench, RwSignal<(f64, f64)>) {
        let axis = RwSignal::new((0.0, 10.0));
        (mount(move || view! { <Marks axis=axis /> }).await, axis)
    }

    #[wasm_bindgen_test]
    async fn action_of_the_operator_is_marked_and_leads_to_its_time() {
        let (bench, axis) = marks().await;
        bench.page.note(Event { t: 2.5, action: Action::Hold });
        settled().await;
        assert_eq!(bench.style("button.mark", "left"), "25%");
        assert!(bench.attribute("button.mark", "aria-label").contains(t("page.hold")));
        bench.press("button.mark").await;
        assert_eq!(bench.page.player.head(), 2.5);
        axis.set((5.0, 10.0));
        settled().await;
        assert!(!bench.has("button.mark"));
    }

    #[wasm_bindgen_test]
    async fn end_is_marked_only_when_the_run_is_over() {
        let (bench, _) = marks().await;
        bench.page.player.planned.set((8.0, false));
        settled().await;
        assert!(!bench.has(".mark.end"));
        bench.page.player.planned.set((8.0, true));
        settled().await;
        assert_eq!(bench.style(".mark.end", "left"), "80%");
    }
}

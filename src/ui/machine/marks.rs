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

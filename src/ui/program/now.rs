//! Positions, feed and spindle at the play head, as the control's position page has them.

use leptos::prelude::*;

use crate::ui::state::Page;
use crate::ui::words::{figure, t};

/// Axes, feed and spindle.
#[component]
pub(super) fn Now() -> impl IntoView {
    let page = Page::here();
    let cells = move || {
        let control = page.project.with_untracked(|project| {
            page.control.track();
            project.control
        });
        page.player.now.with(|now| {
            let axes = control.axes.iter().zip(&now.axes);
            let mut cells: Vec<(String, String)> =
                axes.map(|(axis, state)| (axis.letter.to_string(), figure(state.position, 3))).collect();
            cells.push(("S".to_owned(), figure(now.spindle.actual, 0)));
            cells
        })
    };
    view! {
        <dl class="now" aria-label=t("page.now")>
            {move || cells().into_iter().map(|(name, value)| view! { <div><dt>{name}</dt><dd>{value}</dd></div> }).collect_view()}
        </dl>
    }
}

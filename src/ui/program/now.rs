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
            {move || cells().into_iter().map(|(name, value)| view! { <div><dt data-means="program">{name}</dt><dd>{value}</dd></div> }).collect_view()}
        </dl>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, settled};

    #[wasm_bindgen_test]
    async fn positions_have_the_axes_of_the_control_and_the_spindle() {
        let bench = mount(|| view! { <Now /> }).await;
        bench.run().await;
        let control = bench.page.project.with_untracked(|project| project.control);
        let mut names: Vec<String> = control.axes.iter().map(|axis| axis.letter.to_string()).collect();
        names.push("S".to_owned());
        assert_eq!(bench.all("dt").iter().filter_map(|name| name.text_content()).collect::<Vec<_>>(), names);
        assert_eq!(bench.text("dd"), "0.000");
    }

    #[wasm_bindgen_test]
    async fn positions_follow_the_head() {
        let bench = mount(|| view! { <Now /> }).await;
        bench.run().await;
        bench.seek(3.5).await;
        settled().await;
        let x = bench.page.player.now.with_untracked(|now| now.axes[0].position);
        assert_eq!(bench.text("dd"), figure(x, 3));
        assert_ne!(bench.text("div:last-child dd"), "0");
    }
}

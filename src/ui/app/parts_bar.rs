//! Links to the parts of the page, on layouts whose first screen does not show all of them.

use leptos::prelude::*;

use crate::ui::dom;
use crate::ui::parts::{Glyph, Icon};
use crate::ui::words::t;

/// The parts from top to bottom: id, catalog id of the name, sign.
const PARTS: [(&str, &str, Glyph); 3] = [
    ("machine", "page.machine", Glyph::Roller),
    ("form", "page.inputs", Glyph::Sliders),
    ("side", "page.program", Glyph::Code),
];

/// The lowest part that begins in the upper half of the window, else the first.
fn part_in_view() -> usize {
    let half = 0.5 * window().inner_height().ok().and_then(|height| height.as_f64()).unwrap_or_default();
    let top = |id| Some(dom::by_id(id)?.get_bounding_client_rect().top());
    let tops = PARTS.iter().enumerate().filter_map(|(at, (id, ..))| Some((at, top(id)?)));
    tops.filter(|(_, top)| *top < half).max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(at, _)| at)
}

/// A button for each part; the one in view is marked.
#[component]
pub(super) fn PartsBar() -> impl IntoView {
    let current = RwSignal::new(0);
    // The window scrolls on a phone, the page within it on a wider screen; the listing scrolls too, at every block of a run.
    dom::on_event("scroll", move |event| {
        let scrolled = dom::target(&event);
        if scrolled.is_some_and(|element| element.tag_name() != "MAIN") {
            return;
        }
        let part = part_in_view();
        if current.try_get_untracked().is_some_and(|before| before != part) {
            current.set(part);
        }
    });
    let button = |(at, (id, name, glyph)): (usize, (&'static str, &'static str, Glyph))| {
        let go = move |_| {
            if let Some(part) = dom::by_id(id) {
                part.scroll_into_view();
            }
        };
        view! {
            <button type="button" aria-current=move || (current.get() == at).then_some("true") on:click=go>
                <Icon glyph=glyph />
                {t(name)}
            </button>
        }
    };
    view! {
        <nav class="parts-bar" aria-label=t("page.parts")>{PARTS.into_iter().enumerate().map(button).collect_view()}</nav>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, until};

    #[wasm_bindgen_test]
    async fn part_in_view_is_marked_and_a_press_leads_to_another() {
        let bench = mount(|| {
            let tall = |id: &'static str| view! { <div id=id style="height: 2000px"></div> };
            view! { {tall("machine")} {tall("form")} {tall("side")} <PartsBar /> }
        })
        .await;
        let marked = || bench.text(".parts-bar [aria-current]");
        assert_eq!(marked(), t("page.machine"));
        for name in ["page.program", "page.inputs", "page.machine"] {
            bench.press_button(t(name)).await;
            until(|| marked() == t(name)).await;
        }
    }
}

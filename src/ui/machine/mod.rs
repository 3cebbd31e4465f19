//! The machine in the middle of the page: verdicts, drawing, film with its charts, operator's panel.

mod compare;
mod drawing;
mod film;
pub(crate) mod operator;
mod verdicts;

use leptos::prelude::*;

use crate::ui::words::t;

pub(crate) use compare::CompareDialog;
use drawing::Stage;
use film::{Film, Scrubber, Transport};
use verdicts::{VerdictList, Verdicts};

/// Verdicts, drawing and film, from top to bottom.
#[component]
pub(crate) fn Machine() -> impl IntoView {
    view! {
        <div class="centre">
            <Verdicts />
            <Stage />
            <Film />
        </div>
    }
}

/// Drawing, transport and verdicts, for a page inside another one.
#[component]
pub(crate) fn EmbeddedMachine() -> impl IntoView {
    view! {
        <Stage />
        <section class="film" aria-label=t("page.transport")>
            <Transport />
            <Scrubber />
        </section>
        <VerdictList />
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::mount;

    #[wasm_bindgen_test]
    async fn verdicts_drawing_and_film_are_from_top_to_bottom() {
        let bench = mount(|| view! { <Machine /> }).await;
        let sections: Vec<String> = bench.all(".centre > section").iter().map(|section| section.class_name()).collect();
        assert_eq!(sections, ["cards", "pane drawing", "film"]);
        assert!(bench.all(".centre > section").iter().all(|section| section.has_attribute("aria-label")));
    }
}

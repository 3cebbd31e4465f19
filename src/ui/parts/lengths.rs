//! The choice of millimetres or inches.

use leptos::prelude::*;

use super::reload::reload_with;
use crate::text::units::{self, Lengths};
use crate::ui::state::Page;
use crate::ui::words::t;

/// Key in the browser's store of the unit of length.
const LENGTHS: &str = "macroline.lengths";

/// Shows lengths by the choice that `boot.js` has noted, of this browser or of the page around; millimetres by default.
pub(crate) fn show_chosen() {
    let chosen = document().document_element().and_then(|root| root.get_attribute("data-lengths"));
    units::show(chosen.and_then(|id| Lengths::of_id(&id)).unwrap_or(Lengths::Millimetres));
}

/// Button of the other system of units. It changes everything drawn and written, so the page is reloaded.
#[component]
pub(crate) fn LengthsButton() -> impl IntoView {
    let page = Page::here();
    let (other, name, about) = match units::shown() {
        Lengths::Millimetres => (Lengths::Inches, "page.inches", "page.inches-about"),
        Lengths::Inches => (Lengths::Millimetres, "page.millimetres", "page.millimetres-about"),
    };
    let choose = move |_| reload_with(page, LENGTHS, other.id());
    view! { <button type="button" class="quiet language lengths" title=t(about) on:click=choose>{t(name)}</button> }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::dom;
    use crate::ui::state::view::Kept;
    use crate::ui::testing::{InInches, mount};

    #[wasm_bindgen_test]
    async fn other_system_of_units_is_offered() {
        assert_eq!(mount(|| view! { <LengthsButton /> }).await.text("button"), t("page.inches"));
        let _inches = InInches::new();
        let bench = mount(|| view! { <LengthsButton /> }).await;
        assert_eq!(bench.text("button"), t("page.millimetres"));
    }

    #[wasm_bindgen_test]
    async fn choice_is_shown_and_nonsense_is_millimetres() {
        let root = document().document_element().unwrap();
        for (chosen, shown) in [("inch", Lengths::Inches), ("ell", Lengths::Millimetres), ("", Lengths::Millimetres)] {
            dom::set(&root, "data-lengths", chosen);
            show_chosen();
            let found = units::shown();
            units::show(Lengths::Millimetres);
            root.remove_attribute("data-lengths").unwrap();
            assert_eq!(found, shown, "{chosen}");
        }
    }

    #[wasm_bindgen_test]
    async fn page_that_is_not_kept_keeps_its_units() {
        let bench = mount(|| view! { <LengthsButton /> }).await;
        bench.page.view.kept.set(Kept::No);
        bench.press("button").await;
        assert_eq!(bench.notices(), [t("page.language-unkept")]);
    }
}

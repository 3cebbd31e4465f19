//! The choice of a language.

use leptos::prelude::*;

use super::reload::reload_with;
use crate::text::catalog::{Language, spoken};
use crate::ui::state::Page;

/// Key in the browser's store of the language; `boot.js` reads it.
const LANGUAGE: &str = "macroline.language";

/// Buttons of the other languages, each by its own name. Another language is another catalog, so the page is reloaded.
#[component]
pub(crate) fn LanguageButtons() -> impl IntoView {
    let page = Page::here();
    let button = |language: Language| {
        let speak = move |_| reload_with(page, LANGUAGE, language.code());
        view! { <button type="button" class="quiet language" lang=language.code() on:click=speak>{language.name()}</button> }
    };
    Language::ALL.into_iter().filter(|language| *language != spoken()).map(button).collect_view()
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::state::view::Kept;
    use crate::ui::testing::mount;
    use crate::ui::words::t;

    #[wasm_bindgen_test]
    async fn other_languages_are_offered_by_their_own_names() {
        let bench = mount(|| view! { <LanguageButtons /> }).await;
        assert_eq!((bench.text("button").as_str(), bench.attribute("button", "lang").as_str()), ("中文", "zh"));
        assert_eq!(bench.all("button").len(), Language::ALL.len() - 1);
    }

    #[wasm_bindgen_test]
    async fn page_that_is_not_kept_keeps_its_language() {
        let bench = mount(|| view! { <LanguageButtons /> }).await;
        bench.page.view.kept.set(Kept::No);
        bench.press("button").await;
        assert_eq!(bench.notices(), [t("page.language-unkept")]);
    }
}

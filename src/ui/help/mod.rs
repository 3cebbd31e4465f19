//! Help: a dialog with search, pages of machines and controls, and the keys.

pub(crate) mod keys;
mod reader;
pub(crate) mod tour;

use leptos::prelude::*;

use self::reader::Reader;
use crate::ui::parts::Dialog;
use crate::ui::state::Page;
use crate::ui::words::t;

/// The dialog of help. Its content is made when it is first opened.
#[component]
pub(crate) fn HelpDialog() -> impl IntoView {
    let page = Page::here();
    let open = page.view.helping;
    let wanted = Memo::new(move |before: Option<&bool>| before == Some(&true) || open.get());
    let close = move || {
        open.set(false);
        page.view.help_at.set(String::new());
    };
    view! {
        <Dialog id="help-title" title=t("page.help") class="help" open=open close=close>
            {move || wanted.get().then(|| view! { <Reader /> })}
        </Dialog>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, settled};

    #[wasm_bindgen_test]
    async fn content_is_made_when_help_is_first_opened_and_kept() {
        let bench = mount(|| view! { <HelpDialog /> }).await;
        assert!(bench.has("dialog.help:not([open])") && !bench.has("#help-search"));
        bench.page.view.helping.set(true);
        settled().await;
        assert_eq!(bench.text("#help-title"), t("page.help"));
        bench.type_into("#help-search", "slack").await;
        bench.press_button(t("page.close")).await;
        assert!(bench.has("dialog.help:not([open])"));
        assert_eq!(bench.value("#help-search"), "slack", "what was looked for is there when help is opened again");
    }

    #[wasm_bindgen_test]
    async fn closing_forgets_the_place_that_was_asked_for() {
        let bench = mount(|| view! { <HelpDialog /> }).await;
        bench.page.view.explain("field.pitch");
        settled().await;
        assert!(bench.has("dialog.help[open]"));
        bench.press_button(t("page.close")).await;
        assert!(bench.page.view.help_at.get_untracked().is_empty());
    }
}

//! Help: the keys, and what the page is.

pub(crate) mod keys;

use leptos::prelude::*;

use crate::ui::dom;
use crate::ui::parts::input::CheckMark;
use crate::ui::parts::{Dialog, LanguageButtons};
use crate::ui::state::Page;
use crate::ui::state::stepping::COMMANDS;
use crate::ui::words::t;

/// Keys and their effects.
const KEYS: [(&str, &str); 10] = [
    ("Space", "page.key-play"),
    (", .", "page.key-step"),
    ("Home", "page.key-start"),
    ("← →", "page.key-arrows"),
    ("↑ ↓", "page.key-fields"),
    ("+ − 0", "page.key-zoom"),
    ("Enter", "page.key-meaning"),
    ("Ctrl Z", "page.key-undo"),
    ("Ctrl Shift Z", "page.key-redo"),
    ("?", "page.key-help"),
];

/// The dialog of help.
#[component]
pub(crate) fn HelpDialog() -> impl IntoView {
    let page = Page::here();
    let row = |(key, what): (&'static str, &'static str)| {
        view! { <tr><th scope="row"><kbd>{key}</kbd></th><td>{t(what)}</td></tr> }
    };
    let rows = KEYS.into_iter().chain(COMMANDS.into_iter().map(|(key, _, what)| (key, what))).map(row).collect_view();
    let keys_on = RwSignal::new(keys::on());
    let turn = move |on| {
        keys::turn(on);
        keys_on.set(on);
    };
    view! {
        <Dialog id="help-title" title=t("page.help") open=page.view.helping close=move || page.view.helping.set(false)>
            <p>{t("page.help-about")}</p>
            <p>{t("page.help-program")}</p>
            <p>{t("page.help-hand")}</p>
            <p>{t("page.help-walk")}</p>
            {dom::is_installable().then(|| view! {
                <p>{t("page.help-offline")} " " <a href="macroline.html" download="macroline.html">{t("page.help-one-file")}</a></p>
            })}
            <p>{t("page.language")} <LanguageButtons /></p>
            <h3>{t("page.keys")}</h3>
            <table class="shortcuts"><tbody>{rows}</tbody></table>
            <CheckMark label=t("page.keys-on") on=keys_on set=turn />
        </Dialog>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, mount_project, project, settled};

    #[wasm_bindgen_test]
    async fn help_opens_when_asked_and_lists_every_key() {
        let bench = mount(|| view! { <HelpDialog /> }).await;
        assert!(!bench.has("dialog[open]"));
        bench.page.view.helping.set(true);
        settled().await;
        assert!(bench.has("dialog[open]"));
        assert_eq!(bench.all(".shortcuts tr").len(), KEYS.len() + COMMANDS.len());
        bench.press_button(t("page.close")).await;
        assert!(!bench.page.view.helping.get_untracked());
    }

    #[wasm_bindgen_test]
    async fn single_keys_are_turned_off_and_that_is_remembered() {
        let bench = mount(|| view! { <HelpDialog /> }).await;
        assert!(bench.checked(".check input") && keys::on());
        bench.press(".check input").await;
        assert!(!keys::on());
        drop(bench);
        let bench = mount_project(project(), || view! { <HelpDialog /> }).await;
        assert!(!bench.checked(".check input"));
        bench.press(".check input").await;
        assert!(keys::on());
    }
}

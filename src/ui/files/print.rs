//! Documents in a tab of their own, to be printed by the browser.

use leptos::prelude::*;
use leptos::wasm_bindgen;
use leptos::wasm_bindgen::JsValue;
use leptos::wasm_bindgen::prelude::wasm_bindgen;
use web_sys::Window;

use crate::ui::dom::{self};
use crate::ui::state::Page;
use crate::ui::words::{Tone, sentence, t};
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::WriteReport;

#[wasm_bindgen(module = "/src/ui/files/tab.js")]
extern "C" {
    #[wasm_bindgen(catch)]
    fn print(tab: &Window, html: &str) -> Result<(), JsValue>;
}

/// A button that shows a document in a tab of its own, for print.
#[component]
pub(super) fn PrintButton(
    /// Id of the button.
    id: &'static str,
    /// Catalog id of its words.
    words: &'static str,
    /// The document.
    html: String,
) -> impl IntoView {
    let page = Page::here();
    view! {
        <button type="button" id=id title=t("page.print-about") on:click=move |_| show(page, &html)>{t(words)}</button>
    }
}

/// A tab of its own; a notice if the browser allows none.
fn new_tab(page: Page) -> Option<Window> {
    let tab = window().open_with_url_and_target("", "_blank").ok().flatten();
    if tab.is_none() {
        page.notices.notify(Tone::Warn, t("page.no-tab").to_owned());
    }
    tab
}

/// The report to print, or its draft. The tab opens at once, for the browser allows it only at a press.
pub(super) fn show_report(page: Page, worker: Client) {
    let Some(tab) = new_tab(page) else { return };
    let take = move |report: Option<Option<String>>| match report.flatten() {
        Some(html) => show_in(page, &tab, &html),
        None => {
            let _ = tab.close();
            page.notices.notify(Tone::Fail, t("page.no-answer").to_owned());
        }
    };
    page.project.with_untracked(|project| worker.ask(project, WriteReport, take));
}

/// Shows a document in a tab of its own and prints it; a notice if the browser allows neither.
fn show(page: Page, html: &str) {
    if let Some(tab) = new_tab(page) {
        show_in(page, &tab, html);
    }
}

fn show_in(page: Page, tab: &Window, html: &str) {
    if let Err(error) = print(tab, html) {
        let _ = tab.close();
        page.notices.notify(Tone::Fail, sentence(&crate::msg!("page.no-print", reason = dom::error_text(&error))));
    }
}

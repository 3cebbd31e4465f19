//! Sheets that the worker writes, written again after every change of the project.

use leptos::prelude::*;

use super::followed::{Answered, Followed};
use crate::ui::words::t;

/// Sheets as HTML.
#[component]
pub(crate) fn SheetView(
    /// The followed HTML.
    sheets: Followed<String>,
    /// Shown below the sheets once they are there.
    #[prop(optional)]
    children: Option<Children>,
) -> impl IntoView {
    let lead = |id| format!("<p class=\"lead\">{}</p>", t(id));
    let html = move || match sheets.answer.get() {
        Answered::Waiting => lead("page.reading"),
        Answered::Nothing => lead("page.no-answer"),
        Answered::Of(html) if html.is_empty() => lead("page.no-sheet"),
        Answered::Of(html) => html,
    };
    let is_answered = Memo::new(move |_| sheets.answer.with(|answer| *answer != Answered::Waiting));
    let mut children = children;
    view! {
        <div class="sheets" aria-busy=move || sheets.progress.outdated.get().to_string() inner_html=html></div>
        {move || is_answered.get().then(|| children.take().map(|children| children()))}
    }
}

#[cfg(test)]
mod tests {
    use leptos::wasm_bindgen::JsValue;
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::parts::followed::follow_sheets;
    use crate::ui::testing::{mount, settled};
    use crate::ui::worker::client::Client;
    use crate::ui::worker::messages::{Ask, Sheets, WriteSheets};

    fn plc(text: &str) -> Option<JsValue> {
        WriteSheets.answer(&Sheets { plc: format!("<b>{text}</b>"), ..Sheets::default() })
    }

    #[wasm_bindgen_test]
    async fn sheet_without_a_worker_gives_a_notice() {
        let bench = mount(|| view! { <SheetView sheets=follow_sheets(|sheets| sheets.plc) /> }).await;
        assert_eq!(bench.text(".sheets"), t("page.no-answer"));
    }

    #[wasm_bindgen_test]
    async fn sheet_follows_the_project() {
        let bench = mount(|| {
            Client::here().answer_here(|project, _| plc(&project.name));
            view! {
                <SheetView sheets=follow_sheets(|sheets| sheets.plc) />
                <SheetView sheets=follow_sheets(|sheets| sheets.ways) />
            }
        })
        .await;
        bench.page.edit(|project| project.name = "Customer".to_owned());
        settled().await;
        assert_eq!(bench.text("b"), "Customer");
        assert_eq!(bench.text(".sheets + .sheets"), t("page.no-sheet"));
    }

    #[wasm_bindgen_test]
    async fn kept_variant_asks_for_no_other_sheet() {
        let bench = mount(|| {
            Client::here().answer_here(|project, _| plc(&project.variants.len().to_string()));
            view! { <SheetView sheets=follow_sheets(|sheets| sheets.plc) /> }
        })
        .await;
        bench.page.edit(|project| assert_eq!(project.keep_variant("A"), Some(0)));
        settled().await;
        assert_eq!((bench.text("b").as_str(), bench.attribute(".sheets", "aria-busy").as_str()), ("0", "false"));
    }
}

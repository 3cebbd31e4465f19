//! Messages over the lower edge of the stage, so that no control of the page moves.

use leptos::prelude::*;

use crate::ui::dom;
use crate::ui::parts::{Glyph, IconButton};
use crate::ui::state::Page;
use crate::ui::words::t;

/// The messages, the newest at the bottom.
#[component]
pub(crate) fn NoticeBand() -> impl IntoView {
    let page = Page::here();
    view! {
        <div class="notices" aria-live="polite">
            <For each=move || page.notices.list.get() key=|notice| notice.text.clone() let:notice>
                <div class=format!("notice {}", notice.tone)>
                    <p><i aria-hidden="true">{notice.tone.sign()}</i> " " {notice.text.clone()}</p>
                    {notice.file.clone().map(|(name, content)| view! {
                        <button type="button" on:click=move |_| dom::download(name, "text/plain", content.as_bytes())>
                            {t("page.save-file")}
                        </button>
                    })}
                    {notice.offer.map(|(words, act)| view! {
                        <button type="button" class="primary" on:click=move |_| act.run(())>{t(words)}</button>
                    })}
                    <IconButton glyph=Glyph::Close label=t("page.dismiss") press=move || page.notices.dismiss(&notice.text) />
                </div>
            </For>
        </div>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::state::notices::Notice;
    use crate::ui::testing::{mount, settled};
    use crate::ui::words::Tone;

    #[wasm_bindgen_test]
    async fn notice_stays_until_it_is_dismissed() {
        let bench = mount(|| view! { <NoticeBand /> }).await;
        bench.page.notices.notify(Tone::Warn, "Set aside.".to_owned());
        bench.page.notices.confirm("Opened.".to_owned());
        settled().await;
        assert_eq!(bench.all(".notice").len(), 2);
        assert_eq!(bench.text(".notice.warn p"), "▲ Set aside.");
        bench.press(&format!(".notice.warn [aria-label={}]", t("page.dismiss"))).await;
        assert_eq!((bench.all(".notice").len(), bench.text(".notice p").as_str()), (1, "ⓘ Opened."));
    }

    #[wasm_bindgen_test]
    async fn notice_with_a_file_offers_to_save_it() {
        let bench = mount(|| view! { <NoticeBand /> }).await;
        bench.page.notices.confirm("Plain.".to_owned());
        bench.page.notices.show(Notice::new(Tone::Warn, "Kept.".to_owned()).with_file("state.txt", "{".to_owned()));
        settled().await;
        let offers: Vec<bool> = bench
            .all(".notice")
            .iter()
            .map(|notice| notice.text_content().unwrap_or_default().contains(t("page.save-file")))
            .collect();
        assert_eq!(offers, [false, true]);
        assert_eq!(bench.attribute(".notices", "aria-live"), "polite");
    }
}

//! Messages over the lower edge of the stage: they move no control.

use leptos::prelude::*;

use crate::ui::dom;
use crate::ui::parts::{Glyph, IconButton};
use crate::ui::state::Page;
use crate::ui::words::{sign, t};

/// The messages, the newest at the bottom.
#[component]
pub(crate) fn NoticeBand() -> impl IntoView {
    let page = Page::here();
    view! {
        <div class="notices" aria-live="polite">
            <For each=move || page.notices.list.get() key=|notice| notice.text.clone() let:notice>
                <div class=format!("notice {}", notice.tone)>
                    <p><i aria-hidden="true">{sign(notice.tone)}</i> " " {notice.text.clone()}</p>
                    {notice.file.clone().map(|(name, content)| view! {
                        <button type="button" on:click=move |_| dom::download(name, "text/plain", content.as_bytes())>
                            {t("page.save-file")}
                        </button>
                    })}
                    <IconButton glyph=Glyph::Close label=t("page.dismiss") press=move || page.notices.dismiss(&notice.text) />
                </div>
            </For>
        </div>
    }
}

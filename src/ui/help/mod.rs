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

//! What the keys do, and what the page is.

use leptos::html;
use leptos::prelude::*;

use super::keys;
use super::model::Model;
use super::words::t;

/// Keys and what they do.
const KEYS: [(&str, &str); 8] = [
    ("Space", "page.key-play"),
    (", .", "page.key-step"),
    ("Home", "page.key-start"),
    ("← →", "page.key-arrows"),
    ("↑ ↓", "page.key-fields"),
    ("Ctrl Z", "page.key-undo"),
    ("Ctrl Shift Z", "page.key-redo"),
    ("?", "page.key-help"),
];

/// The dialog of help.
pub(super) fn help_dialog(model: Model) -> AnyView {
    let node: NodeRef<html::Dialog> = NodeRef::new();
    Effect::new(move |_| {
        if model.helping.get()
            && let Some(dialog) = node.get()
        {
            let _ = dialog.show_modal();
            model.helping.set(false);
        }
    });
    let close = move |_| {
        if let Some(dialog) = node.get() {
            dialog.close();
        }
    };
    let rows = KEYS.map(|(key, what)| view! { <tr><th scope="row"><kbd>{key}</kbd></th><td>{t(what)}</td></tr> });
    view! {
        <dialog node_ref=node class="dialog" aria-labelledby="help-title">
            <header><h2 id="help-title">{t("page.help")}</h2><button type="button" class="icon" aria-label=t("page.close") on:click=close>"✕"</button></header>
            <p>{t("page.help-about")}</p>
            <p>{t("page.help-program")}</p>
            <p>{t("page.help-hand")}</p>
            <h3>{t("page.keys")}</h3>
            <table class="shortcuts"><tbody>{rows.into_iter().collect_view()}</tbody></table>
            <label class="check"><input type="checkbox" checked=keys::on() on:change=move |event| keys::turn(event_target_checked(&event)) />{t("page.keys-on")}</label>
        </dialog>
    }
    .into_any()
}

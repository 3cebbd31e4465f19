//! What the keys do, and what the page is.

use leptos::wasm_bindgen::JsCast;
use web_sys::HtmlDialogElement;

use super::debug::COMMANDS;
use super::el::{El, check, el, icon_button};
use super::keys;
use super::local::Local;
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
pub(super) fn help_dialog(model: Model) -> El {
    let row = |key: &str, what: &'static str| {
        let head = el("th").at("scope", "row").add(&[el("kbd").text(key)]);
        el("tr").add(&[head, el("td").text(t(what))])
    };
    let keys = KEYS.iter().map(|(key, what)| row(key, what));
    let rows: Vec<El> = keys.chain(COMMANDS.iter().map(|(key, _, what)| row(key, what))).collect();
    let body = [
        el("p").text(t("page.help-about")),
        el("p").text(t("page.help-program")),
        el("p").text(t("page.help-hand")),
        el("p").text(t("page.help-walk")),
        el("h3").text(t("page.keys")),
        el("table.shortcuts").add(&[el("tbody").add(&rows)]),
        check(t("page.keys-on"), keys::on, keys::turn),
    ];
    dialog("help-title", t("page.help"), model.helping).add(&body)
}

/// A dialog with a title and a way out, opened when a signal asks for it.
pub(super) fn dialog(id: &str, title: &str, asked: Local<bool>) -> El {
    let frame = el("dialog.dialog").at("aria-labelledby", id);
    let node: HtmlDialogElement = frame.dom().clone().unchecked_into();
    let shut = node.clone();
    let close = icon_button("button.icon", "✕", t("page.close"), move || shut.close());
    let open = move || {
        if asked.get() {
            let _ = node.show_modal();
            asked.set(false);
        }
    };
    frame.add(&[el("header").add(&[el("h2").at("id", id).text(title), close])]).run(open)
}

//! Words of the editor's library in the language of the page.

use leptos::wasm_bindgen::JsValue;

use crate::ui::dom::script::{object, set};
use crate::ui::words::t;

/// The library's own words, with the catalog ids of ours.
const PHRASES: [(&str, &str); 21] = [
    ("$ unchanged lines", "page.unchanged-lines"),
    ("Completions", "page.completions"),
    ("Control character", "page.control-character"),
    ("Find", "page.find"),
    ("Go to line", "page.go-to-line"),
    ("Replace", "page.replace-by"),
    ("Selection deleted", "page.selection-deleted"),
    ("all", "page.find-all"),
    ("by word", "page.whole-words"),
    ("close", "page.close"),
    ("current match", "page.current-match"),
    ("go", "page.go"),
    ("match case", "page.match-case"),
    ("next", "page.find-next"),
    ("on line", "page.on-line"),
    ("previous", "page.find-previous"),
    ("regexp", "page.pattern"),
    ("replace", "page.replace"),
    ("replace all", "page.replace-all"),
    ("replaced $ matches", "page.replaced-count"),
    ("replaced match on line $", "page.replaced-on-line"),
];

/// All phrases as an object for the library.
pub(crate) fn phrases() -> JsValue {
    let all = object([]);
    PHRASES.iter().for_each(|(english, id)| set(&all, english, &t(id).into()));
    all
}

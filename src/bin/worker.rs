//! The worker beside the page: the same library, started when the page first asks for warnings, sheets, an export or a large file.

use js_sys::Function;
use wasm_bindgen::prelude::wasm_bindgen;

/// Answers the page's questions. `sentences` is the catalog of its language, `lengths` the id of its units, `load` fetches the texts of help; `ui/worker/worker_boot.js` has both.
#[wasm_bindgen]
pub fn work(sentences: String, lengths: String, load: Function) {
    macroline::ui::work(sentences, &lengths, load);
}

// The module is started by `work`.
fn main() {}

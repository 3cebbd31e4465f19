//! The worker beside the page: the same library, started when the page first asks for warnings, sheets, an export or a large file.

use wasm_bindgen::prelude::wasm_bindgen;

/// Answers the page's questions. `sentences` is the catalog of its language; `ui/worker/worker_boot.js` loads both.
#[wasm_bindgen]
pub fn work(sentences: String) {
    macroline::ui::work(sentences);
}

// The module is started by `work`.
fn main() {}

//! The browser app: opens the page.

use wasm_bindgen::prelude::wasm_bindgen;

/// Opens the page. `sentences` is the catalog of its language; `ui/boot.js` loads both.
#[wasm_bindgen]
pub fn open(sentences: String) {
    macroline::ui::open(sentences);
}

// The module is started by `open`.
fn main() {}

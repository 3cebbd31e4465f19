//! Components in a real browser: mounted, acted upon, and asked what the page then shows.
#![cfg(target_arch = "wasm32")]
#![allow(clippy::unwrap_used)]

use leptos::mount::mount_to;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use macroline::ui::App;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

/// An empty element of the page to mount a component in.
fn host() -> web_sys::HtmlElement {
    let host = document().create_element("div").unwrap();
    document().body().unwrap().append_child(&host).unwrap();
    host.unchecked_into()
}

#[wasm_bindgen_test]
async fn the_app_mounts() {
    let host = host();
    let _mounted = mount_to(host.clone(), App);
    leptos::task::tick().await;
    assert!(host.text_content().unwrap().contains("macroline"));
}

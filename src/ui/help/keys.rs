//! Keys of the page: transport, undo, help. They never take a key from a text field.

use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, KeyboardEvent};

use crate::ui::dom;
use crate::ui::state::{Page, stepping};

/// Where it is kept that single keys are off (whoever speaks to the computer may need that).
const OFF: &str = "macroline.keys-off";

/// Whether single keys do something.
pub(crate) fn on() -> bool {
    dom::stored(OFF).is_none()
}

/// Turns single keys on or off.
pub(crate) fn turn(on: bool) {
    if on {
        dom::forget(OFF);
    } else {
        dom::store(OFF, "1");
    }
}

/// Listens to the keys.
pub(crate) fn listen(page: Page) {
    dom::hear("keydown", move |event| {
        if press(page, event.unchecked_ref()) {
            event.prevent_default();
        }
    });
}

fn press(page: Page, event: &KeyboardEvent) -> bool {
    let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
    let tag = target.as_ref().map(Element::tag_name).unwrap_or_default();
    let dialog = document().query_selector("dialog[open]").ok().flatten().is_some();
    if dialog || target.as_ref().is_some_and(dom::takes_text) || event.alt_key() {
        return false;
    }
    let key = event.key();
    if event.ctrl_key() || event.meta_key() {
        match (key.to_ascii_lowercase().as_str(), event.shift_key()) {
            ("z", false) => page.undo(),
            ("z", true) | ("y", false) => page.redo(),
            _ => return false,
        }
        return true;
    }
    if !on() {
        return false;
    }
    let player = page.player;
    // A button that has the focus keeps its space bar, a slider its arrows and ends.
    let button = matches!(tag.as_str(), "BUTTON" | "SUMMARY" | "A");
    match key.as_str() {
        " " if !button => player.toggle(),
        "," => player.step(false),
        "." => player.step(true),
        "Home" if tag != "INPUT" => player.seek(0.0),
        "?" => page.view.helping.set(true),
        key => return stepping::press(page, key),
    }
    true
}

//! Texts in this tab's entry of the browser's history: a reload keeps them where the browser's store is full or denied.

use leptos::prelude::*;
use leptos::wasm_bindgen::JsValue;

use super::script;
use crate::ui::dom;

/// A text of the entry.
pub(crate) fn carried(key: &str) -> Option<String> {
    script::get(&entry(), key).as_string()
}

/// Puts texts into the entry beside its others; false if the browser refuses them.
pub(crate) fn carry(texts: &[(&str, &str)]) -> bool {
    let state = entry();
    texts.iter().for_each(|(key, text)| script::set(&state, key, &(*text).into()));
    replace(&state)
}

/// Takes texts out of the entry.
pub(crate) fn drop_carried(keys: &[&str]) {
    if keys.iter().any(|key| carried(key).is_some()) {
        let state = entry();
        keys.iter().for_each(|key| drop(js_sys::Reflect::delete_property(&state, &(*key).into())));
        replace(&state);
    }
}

/// Keeps a text in the browser's store, or else for this tab; false if the browser refuses both.
pub(crate) fn remember(key: &str, text: &str) -> bool {
    if dom::store(key, text) {
        drop_carried(&[key]);
        return true;
    }
    carry(&[(key, text)])
}

/// A text that [`remember`] kept.
pub(crate) fn remembered(key: &str) -> Option<String> {
    carried(key).or_else(|| dom::stored(key))
}

/// Copy of the entry's state.
fn entry() -> js_sys::Object {
    let state = window().history().and_then(|history| history.state()).unwrap_or_default();
    js_sys::Object::try_from(&state).cloned().unwrap_or_default()
}

fn replace(state: &JsValue) -> bool {
    window().history().is_ok_and(|history| history.replace_state(state, "").is_ok())
}

//! JavaScript values, and modules of JavaScript that the page loads late.

use leptos::wasm_bindgen;
use leptos::wasm_bindgen::prelude::wasm_bindgen;
use leptos::wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;

/// A member of an object; `undefined` where there is none.
pub(super) fn get(object: &JsValue, name: &str) -> JsValue {
    js_sys::Reflect::get(object, &name.into()).unwrap_or_default()
}

/// Sets a member of an object.
pub(crate) fn set(object: &JsValue, name: &str, value: &JsValue) {
    let _ = js_sys::Reflect::set(object, &name.into(), value);
}

/// An object of these members.
pub(crate) fn object<const N: usize>(members: [(&str, JsValue); N]) -> JsValue {
    let object = js_sys::Object::new().into();
    members.iter().for_each(|(name, value)| set(&object, name, value));
    object
}

/// A list of rows.
pub(crate) fn table(rows: impl Iterator<Item = Vec<JsValue>>) -> JsValue {
    rows.map(|row| row.into_iter().collect::<js_sys::Array>()).collect::<js_sys::Array>().into()
}

/// Calls a method.
pub(crate) fn call(object: &JsValue, name: &str, values: &[&JsValue]) -> Result<JsValue, JsValue> {
    let function: js_sys::Function = get(object, name).dyn_into()?;
    function.apply(object, &values.iter().copied().collect())
}

#[wasm_bindgen(module = "/src/ui/dom/import.js")]
extern "C" {
    #[wasm_bindgen(js_name = importModule)]
    fn import_module(address: &str) -> js_sys::Promise;
}

/// Addresses of the files that the page loads after its first load, from `boot.js`.
#[wasm_bindgen(js_namespace = macroline)]
extern "C" {
    /// The address of a part.
    #[wasm_bindgen(catch, js_name = address)]
    pub(crate) fn address_of(part: &str) -> Result<String, JsValue>;

    /// A part for the worker: its address, or the part itself where the page is one file.
    #[wasm_bindgen(catch, js_name = part)]
    pub(crate) fn part_for_worker(part: &str) -> Result<JsValue, JsValue>;
}

/// Loads a module of JavaScript that is no part of the first load.
pub(crate) async fn load(part: &str) -> Result<JsValue, JsValue> {
    JsFuture::from(import_module(&address_of(part)?)).await
}

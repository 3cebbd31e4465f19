//! Calls into the modules of JavaScript that are loaded only when asked for.

use leptos::wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;

/// A member of an object; `undefined` where there is none.
pub(super) fn get(object: &JsValue, name: &str) -> JsValue {
    js_sys::Reflect::get(object, &name.into()).unwrap_or_default()
}

/// An object of these members.
pub(super) fn object<const N: usize>(members: [(&str, JsValue); N]) -> JsValue {
    let object = js_sys::Object::new();
    for (name, value) in members {
        let _ = js_sys::Reflect::set(&object, &name.into(), &value);
    }
    object.into()
}

/// Calls a method.
pub(super) fn call(object: &JsValue, name: &str, values: &[&JsValue]) -> Result<JsValue, JsValue> {
    let function: js_sys::Function = get(object, name).dyn_into()?;
    function.apply(object, &values.iter().copied().collect())
}

/// Loads a module that stands beside the page. `import()` is no function that wasm can call: boot.js hands one out.
pub(super) async fn load(path: &str) -> Result<JsValue, JsValue> {
    let promise = call(&js_sys::global(), "lazyImport", &[&path.into()])?;
    JsFuture::from(promise.dyn_into::<js_sys::Promise>()?).await
}

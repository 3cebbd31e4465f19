//! The browser: time, frames, storage, files, elements.

pub(crate) mod children;
pub(crate) mod delayed;
pub(crate) mod script;
pub(crate) mod tab_entry;
pub(crate) mod turns;

use std::cell::Cell;

use leptos::prelude::*;
use leptos::wasm_bindgen::{JsCast, JsValue, closure::Closure};
use web_sys::{
    Blob, BlobPropertyBag, DomRect, Element, Event, HtmlAnchorElement, HtmlDialogElement, HtmlElement, Node,
    Performance, ResizeObserver, Storage, Url,
};

use crate::text::catalog::{self, Language};
use crate::ui::words::sentence;
use crate::view::Theme;

/// Milliseconds since the page began.
pub(crate) fn now() -> f64 {
    performance().map_or(0.0, |p| p.now())
}

fn performance() -> Option<Performance> {
    web_sys::window()?.performance()
}

/// A moment of the browser's performance record.
pub(crate) fn mark(name: &str) {
    if let Some(performance) = performance() {
        let _ = performance.mark(name);
    }
}

/// The time between two moments. Only the last few hundred are kept, as the page may run for days.
pub(crate) fn measure(name: &str, from: &str, to: &str) {
    let Some(performance) = performance() else { return };
    let _ = performance.measure_with_start_mark_and_end_mark(name, from, to);
    performance.clear_marks_with_mark_name(from);
    performance.clear_marks_with_mark_name(to);
    if performance.get_entries_by_name(name).length() > 400 {
        performance.clear_measures_with_measure_name(name);
    }
}

/// Calls `tick` with the time (ms) of each frame that [`ask`](Frames::ask) requests.
pub(crate) struct Frames(Closure<dyn FnMut(f64)>);

impl Frames {
    pub(crate) fn new(tick: impl FnMut(f64) + 'static) -> Frames {
        Frames(Closure::new(tick))
    }

    /// Requests one frame.
    pub(crate) fn ask(&self) {
        if let Some(window) = web_sys::window() {
            let _ = window.request_animation_frame(self.0.as_ref().unchecked_ref());
        }
    }
}

/// Waits for the next frame.
pub(crate) async fn frame() {
    let next = js_sys::Promise::new(&mut |done, _| {
        let _ = window().request_animation_frame(&done);
    });
    let _ = wasm_bindgen_futures::JsFuture::from(next).await;
}

/// Runs `act` after the effects of the present change.
pub(crate) fn soon(act: impl FnOnce() + 'static) {
    let act: Box<dyn FnOnce()> = Box::new(act);
    wasm_bindgen_futures::spawn_local(async move {
        leptos::task::tick().await;
        act();
    });
}

/// The local storage of the page in this browser.
pub(crate) fn storage() -> Option<Storage> {
    web_sys::window()?.local_storage().ok().flatten()
}

/// A text of the store.
pub(crate) fn stored(key: &str) -> Option<String> {
    storage()?.get_item(key).ok().flatten()
}

/// The keys of the store.
pub(crate) fn stored_keys() -> Vec<String> {
    let Some(storage) = storage() else { return Vec::new() };
    (0..storage.length().unwrap_or(0)).filter_map(|at| storage.key(at).ok().flatten()).collect()
}

/// Keeps a text in the store; false if there is no room or no store.
pub(crate) fn store(key: &str, text: &str) -> bool {
    storage().is_some_and(|storage| storage.set_item(key, text).is_ok())
}

/// Drops a text of the store.
pub(crate) fn forget(key: &str) {
    if let Some(storage) = storage() {
        let _ = storage.remove_item(key);
    }
}

/// An id that is unique in this browser: the time in milliseconds and a random number.
pub(crate) fn fresh_id() -> String {
    format!("{:x}{:08x}", js_sys::Date::now() as u64, (js_sys::Math::random() * 4_294_967_296.0) as u64)
}

/// Hands a file to the user.
pub(crate) fn download(name: &str, kind: &str, bytes: &[u8]) {
    let parts = js_sys::Array::of1(&js_sys::Uint8Array::from(bytes));
    let bag = BlobPropertyBag::new();
    bag.set_type(kind);
    let Ok(blob) = Blob::new_with_u8_array_sequence_and_options(&parts, &bag) else { return };
    let Ok(url) = Url::create_object_url_with_blob(&blob) else { return };
    if let Ok(anchor) = document().create_element("a").map(JsCast::unchecked_into::<HtmlAnchorElement>) {
        anchor.set_href(&url);
        anchor.set_download(name);
        anchor.click();
    }
    // The browser needs the address until it has read the file.
    set_timeout(move || drop(Url::revoke_object_url(&url)), std::time::Duration::from_secs(20));
}

/// Copies a text to the clipboard, then calls `then` with whether the browser allowed it.
pub(crate) fn copy(text: &str, then: impl FnOnce(bool) + 'static) {
    let clipboard = window().navigator().clipboard();
    // A page that was not loaded by HTTPS has no clipboard.
    if clipboard.is_undefined() {
        return then(false);
    }
    let promise = clipboard.write_text(text);
    wasm_bindgen_futures::spawn_local(async move {
        then(wasm_bindgen_futures::JsFuture::from(promise).await.is_ok());
    });
}

thread_local! {
    /// Whether the page reloads itself.
    static RELOADS: Cell<bool> = const { Cell::new(false) };
}

/// Loads the page again.
pub(crate) fn reload() {
    RELOADS.set(true);
    let _ = window().location().reload();
}

/// Whether the page reloads itself.
pub(crate) fn reloads() -> bool {
    RELOADS.get()
}

/// The address of the page without its fragment, and the fragment without its `#`.
pub(crate) fn address() -> (String, String) {
    let address = window().location().href().unwrap_or_default();
    match address.split_once('#') {
        Some((page, fragment)) => (page.to_owned(), fragment.to_owned()),
        None => (address, String::new()),
    }
}

/// Removes the fragment from the address of the page.
pub(crate) fn forget_fragment() {
    let (page, _) = address();
    if let Ok(history) = window().history() {
        let state = history.state().unwrap_or_default();
        let _ = history.replace_state_with_url(&state, "", Some(&page));
    }
}

/// Whether the browser may install the page: it has a manifest (missing in the one-file page of scripts/one_file.mjs), and the browser
/// supports service workers.
pub(crate) fn is_installable() -> bool {
    let keeps =
        js_sys::Reflect::get(&window().navigator(), &"serviceWorker".into()).is_ok_and(|keeper| keeper.is_object());
    keeps && document().query_selector("link[rel=manifest]").is_ok_and(|link| link.is_some())
}

/// Whether a media query holds.
pub(crate) fn prefers(query: &str) -> bool {
    window().match_media(query).ok().flatten().is_some_and(|list| list.matches())
}

/// Theme of the page: as chosen, or as the system.
pub(crate) fn theme() -> Theme {
    let root = document().document_element();
    let chosen = root.and_then(|root| root.get_attribute("data-theme")).unwrap_or_default();
    let is_dark = chosen == "dark" || chosen.is_empty() && prefers("(prefers-color-scheme: dark)");
    if is_dark { Theme::Dark } else { Theme::Light }
}

/// Decodes GBK with the browser's table; `None` unless all bytes are valid.
pub(crate) fn gbk(bytes: &JsValue) -> Option<String> {
    let options = web_sys::TextDecoderOptions::new();
    options.set_fatal(true);
    let decoder = web_sys::TextDecoder::new_with_label_and_options("gbk", &options).ok()?;
    decoder.decode_with_buffer_source(bytes.unchecked_ref()).ok()
}

/// Opens the browser's dialog for printing; a missing dialog is ignored.
pub(crate) fn print() {
    let _ = window().print();
}

/// Sets an attribute; a refusal of the browser is ignored.
pub(crate) fn set(element: &Element, name: &str, value: &str) {
    let _ = element.set_attribute(name, value);
}

/// The element at which an event happened.
pub(crate) fn target(event: &Event) -> Option<Element> {
    event.target()?.dyn_into().ok()
}

/// The element of a selector that holds the place of an event.
pub(crate) fn closest(event: &Event, selector: &str) -> Option<Element> {
    target(event)?.closest(selector).ok()?
}

/// Sets the text of an element without other content. Its text node stays: another one would cost the styles around it at every frame.
pub(crate) fn set_text(element: &Element, text: &str) {
    match element.first_child().filter(|node| node.node_type() == Node::TEXT_NODE) {
        Some(node) => node.set_node_value(Some(text)),
        None => element.set_text_content(Some(text)),
    }
}

/// Whether the `details` element of a toggle event is open.
pub(crate) fn is_open(event: &Event) -> bool {
    event.target().is_some_and(|details| details.unchecked_into::<Element>().has_attribute("open"))
}

/// Shows and focuses a field of the form: leaves an open dialog, opens the groups around the field.
pub(crate) fn go_to_field(id: &str) {
    if let Ok(Some(open)) = document().query_selector("dialog[open]") {
        open.unchecked_into::<HtmlDialogElement>().close();
    }
    if let Some(input) = by_id(id) {
        return show_field(&input);
    }
    // The group of the field builds the field when it is opened.
    let Ok(Some(group)) = document().query_selector(&format!("details[data-fields~='{id}']")) else { return };
    set(&group, "open", "");
    if let Ok(toggled) = Event::new("toggle") {
        let _ = group.dispatch_event(&toggled);
    }
    let id = id.to_owned();
    turns::at_last(move || {
        if let Some(input) = by_id(&id) {
            show_field(&input);
        }
    });
}

fn show_field(input: &HtmlElement) {
    let mut inside = input.closest("details").ok().flatten();
    while let Some(group) = inside {
        set(&group, "open", "");
        inside = group.parent_element().and_then(|outer| outer.closest("details").ok().flatten());
    }
    // With its label.
    input.closest(".field").ok().flatten().as_ref().unwrap_or(input).scroll_into_view();
    let _ = input.focus();
}

/// Shows an element on the whole screen, or ends that.
pub(crate) fn full_screen(element: &Element) {
    if document().fullscreen_element().is_some() {
        document().exit_fullscreen();
    } else {
        let _ = element.request_fullscreen();
    }
}

/// Elements below `root` that a selector finds.
pub(crate) fn all(root: &Element, selector: &str) -> Vec<Element> {
    let Ok(list) = root.query_selector_all(selector) else { return Vec::new() };
    (0..list.length()).filter_map(|at| list.get(at)?.dyn_into().ok()).collect()
}

/// Rectangle in the window of the characters `from..to` (UTF-16 units) of an element's text; `None` where the text is
/// shorter.
pub(crate) fn area_of_text(element: &Element, from: u32, to: u32) -> Option<DomRect> {
    let range = document().create_range().ok()?;
    let (mut done, mut ends) = (0, 0);
    for node in texts(element) {
        let length = node.text_content()?.encode_utf16().count() as u32;
        if (done..done + length).contains(&from) {
            range.set_start(&node, from - done).ok()?;
            ends += 1;
        }
        if (done + 1..=done + length).contains(&to) {
            range.set_end(&node, to - done).ok()?;
            ends += 1;
        }
        done += length;
    }
    (ends == 2).then(|| range.get_bounding_client_rect())
}

/// The pieces of text in an element, in order.
fn texts(node: &Node) -> Vec<Node> {
    let children = node.child_nodes();
    let children = (0..children.length()).filter_map(|at| children.get(at));
    children.flat_map(|child| if child.node_type() == Node::TEXT_NODE { vec![child] } else { texts(&child) }).collect()
}

/// The element with an id.
pub(crate) fn by_id(id: &str) -> Option<HtmlElement> {
    document().get_element_by_id(id)?.dyn_into().ok()
}

/// Calls `act` at each event of a kind on the window, until the component is removed. Pastes and scrolls are caught in
/// the capture phase: a paste before its element handles it, a scroll because it does not bubble.
pub(crate) fn on_event(event: &'static str, act: impl Fn(Event) + 'static) {
    let act = StoredValue::new_local(Closure::<dyn Fn(Event)>::new(act));
    let first = ["paste", "scroll"].contains(&event);
    act.with_value(|act| {
        let _ = window().add_event_listener_with_callback_and_bool(event, act.as_ref().unchecked_ref(), first);
    });
    on_cleanup(move || {
        act.with_value(|act| {
            let _ = window().remove_event_listener_with_callback_and_bool(event, act.as_ref().unchecked_ref(), first);
        });
    });
}

/// Calls `act` whenever the browser has given an element a size, also the first time, until the component is removed.
/// The size can be read then without another layout.
pub(crate) fn on_resize(element: &Element, act: impl Fn() + 'static) {
    let act = Closure::<dyn Fn()>::new(act);
    let Ok(observer) = ResizeObserver::new(act.as_ref().unchecked_ref()) else { return };
    observer.observe(element);
    let observed = StoredValue::new_local((observer, act));
    on_cleanup(move || observed.with_value(|(observer, _)| observer.disconnect()));
}

/// Whether keys pressed in this element are text.
pub(crate) fn takes_text(element: &Element) -> bool {
    let kind = element.get_attribute("type").unwrap_or_default();
    match element.tag_name().as_str() {
        "INPUT" => !matches!(kind.as_str(), "range" | "checkbox" | "radio" | "button" | "file"),
        "TEXTAREA" | "SELECT" => true,
        _ => element.closest("[contenteditable],.editor").ok().flatten().is_some(),
    }
}

/// Text of a JavaScript error. Browsers write it in English, so in another language the name of the error alone is shown.
pub(crate) fn error_text(error: &JsValue) -> String {
    if let Some(text) = error.as_string() {
        return text;
    }
    match property(error, "message").filter(|text| !text.is_empty()) {
        Some(text) if catalog::spoken() == Language::English => text,
        _ => sentence(&crate::msg!("page.browser-reports", name = error_name(error))),
    }
}

/// The name of a JavaScript error, such as `QuotaExceededError`; empty if the value is not an error.
pub(crate) fn error_name(error: &JsValue) -> String {
    property(error, "name").unwrap_or_default()
}

fn property(value: &JsValue, name: &str) -> Option<String> {
    js_sys::Reflect::get(value, &name.into()).ok()?.as_string()
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::mount;

    #[wasm_bindgen_test]
    async fn only_text_fields_and_lists_take_text() {
        let view = || view! { <input type="text" /> <input type="range" /> <input type="checkbox" /> <select></select> <button></button> };
        let bench = mount(view).await;
        let takes = bench.all("*").iter().map(takes_text).collect::<Vec<_>>();
        assert_eq!(takes, [true, false, false, true, false]);
    }

    #[wasm_bindgen_test]
    async fn going_to_a_field_opens_the_groups_around_it() {
        let view = || view! { <details><summary></summary><details><summary></summary><input id="deep" /></details></details> };
        let bench = mount(view).await;
        go_to_field("deep");
        assert_eq!(bench.all("details[open]").len(), 2);
        assert_eq!(document().active_element().unwrap().id(), "deep");
    }

    #[wasm_bindgen_test]
    async fn removed_component_hears_no_event_of_the_window() {
        let heard = ArcStoredValue::new(0);
        let own = heard.clone();
        let listen = move || on_event("online", move |_| own.update_value(|count| *count += 1));
        let bench = mount(move || {
            listen();
            view! { <p></p> }
        });
        let bench = bench.await;
        let announce = || window().dispatch_event(&Event::new("online").unwrap()).unwrap();
        announce();
        drop(bench);
        announce();
        assert_eq!(heard.get_value(), 1);
    }

    #[wasm_bindgen_test]
    async fn text_is_set_beside_a_marker_of_the_view_and_again() {
        let bench = mount(|| view! { <p>{None::<()>}</p> }).await;
        for text in ["first", "second"] {
            set_text(&bench.find("p"), text);
            assert_eq!(bench.text("p"), text);
        }
    }

    #[wasm_bindgen_test]
    async fn part_of_a_text_has_its_own_place() {
        let bench = mount(|| view! { <code>"ab"<i>"cd"</i>"ef"</code> }).await;
        let area = |from, to| area_of_text(&bench.find("code"), from, to);
        let (cd, inner) = (area(2, 4).unwrap(), bench.find("i").get_bounding_client_rect());
        assert_eq!((cd.left(), cd.right()), (inner.left(), inner.right()));
        assert!(area(1, 5).unwrap().width() > cd.width());
        assert!(area(4, 7).is_none());
    }

    #[wasm_bindgen_test]
    fn forgotten_text_is_no_longer_stored() {
        assert!(store("macroline.some", "text"));
        assert_eq!(stored("macroline.some").as_deref(), Some("text"));
        forget("macroline.some");
        assert_eq!(stored("macroline.some"), None);
    }
}

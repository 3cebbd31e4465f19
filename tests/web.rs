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

/// The app in a fresh browser, mounted; it stays as long as the handle.
async fn app() -> (web_sys::HtmlElement, impl Sized) {
    window().local_storage().unwrap().unwrap().clear().unwrap();
    let host = host();
    let mounted = mount_to(host.clone(), App);
    settled().await;
    (host, mounted)
}

/// Until all that follows from a change is in the page.
async fn settled() {
    for _ in 0..4 {
        leptos::task::tick().await;
    }
}

fn find<T: JsCast>(id: &str) -> T {
    document().get_element_by_id(id).unwrap_or_else(|| panic!("no #{id}")).unchecked_into()
}

/// Types into a field as a person does: the text, then the event.
async fn type_into(id: &str, text: &str) -> web_sys::HtmlInputElement {
    let input: web_sys::HtmlInputElement = find(id);
    input.set_value(text);
    input.dispatch_event(&web_sys::Event::new("input").unwrap()).unwrap();
    settled().await;
    input
}

/// Chooses in a list as a person does.
async fn choose(list: &web_sys::Element, value: &str) {
    js_sys::Reflect::set(list, &"value".into(), &value.into()).unwrap();
    list.dispatch_event(&web_sys::Event::new("change").unwrap()).unwrap();
    settled().await;
}

fn press(button: &web_sys::Element) {
    button.unchecked_ref::<web_sys::HtmlElement>().click();
}

#[wasm_bindgen_test]
async fn app_mounts() {
    let (host, _mounted) = app().await;
    assert!(host.text_content().unwrap().contains("macroline"));
}

#[wasm_bindgen_test]
async fn field_keeps_typed_text_and_shows_its_error() {
    let (_, _mounted) = app().await;
    for (typed, wrong) in
        [("1.05", false), ("1,5", false), ("0.05", false), ("-1.50", true), ("", true), ("1e400", true)]
    {
        let input = type_into("pitch", typed).await;
        assert_eq!(input.value(), typed);
        assert_eq!(input.get_attribute("aria-invalid").unwrap(), wrong.to_string(), "{typed}");
        let note: web_sys::Element = find("pitch-note");
        assert_eq!(note.text_content().unwrap().contains("Allowed"), wrong, "{typed}");
    }
}

#[wasm_bindgen_test]
async fn undo_restores_the_shown_field() {
    let (host, _mounted) = app().await;
    let input = type_into("pitch", "9.5").await;
    press(&host.query_selector("[aria-label=Undo]").unwrap().unwrap());
    settled().await;
    assert_eq!(input.value(), "8");
}

#[wasm_bindgen_test]
async fn field_change_reaches_the_program() {
    let (host, _mounted) = app().await;
    type_into("pitch", "7,25").await;
    let files = host.query_selector_all("[aria-label='Program files'] button").unwrap();
    let shown = (0..files.length()).map(|at| {
        press(&files.get(at).unwrap().unchecked_into());
        host.query_selector(".listing").unwrap().unwrap()
    });
    let mut found = false;
    for listing in shown {
        settled().await;
        found |= listing.text_content().unwrap().contains("#107=7.25");
    }
    assert!(found, "no file sets #107 to 7.25");
}

#[wasm_bindgen_test]
async fn change_of_control_rewrites_the_program() {
    let (host, _mounted) = app().await;
    let choice = host.query_selector("select.control").unwrap().unwrap();
    choose(&choice, "sinumerik-802d").await;
    assert!(host.query_selector(".listing").unwrap().unwrap().text_content().unwrap().contains("GOTOF"));
    let field: web_sys::Element = find("form");
    assert!(field.text_content().unwrap().contains("R107"));
}

#[wasm_bindgen_test]
async fn broken_stored_state_is_set_aside() {
    let store = window().local_storage().unwrap().unwrap();
    store.clear().unwrap();
    store.set_item("macroline.project", "{ not a project").unwrap();
    let host = host();
    let _mounted = mount_to(host.clone(), App);
    settled().await;
    assert!(host.query_selector(".notice").unwrap().unwrap().text_content().unwrap().contains("set aside"));
    assert_eq!(store.get_item("macroline.set-aside").unwrap().unwrap(), "{ not a project");
}

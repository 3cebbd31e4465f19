//! Keys of the page: transport, undo, help. They never take a key from a text field.

use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, KeyboardEvent};

use crate::project::Project;
use crate::ui::dom;
use crate::ui::state::stepping::SteppingCommand;
use crate::ui::state::{Page, operator, stepping};

/// Key in the browser's store that turns single-key shortcuts off, as speech input may require.
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
    dom::on_event("keydown", move |event| {
        if press(page, event.unchecked_ref()) {
            event.prevent_default();
        }
    });
}

fn press(page: Page, event: &KeyboardEvent) -> bool {
    let target = dom::target(event);
    let tag = target.as_ref().map(Element::tag_name).unwrap_or_default();
    let dialog = document().query_selector("dialog[open]").ok().flatten().is_some();
    // The usual key for help, in text fields too: at a field of the form it leads to that field's place.
    if !dialog && event.key() == "F1" {
        let id = target.as_ref().map(Element::id).unwrap_or_default();
        let is_field = |project: &Project| project.machine.fields().iter().any(|field| field.id == id);
        if page.project.with_untracked(is_field) {
            page.view.explain(format!("field.{id}"))
        } else {
            page.view.helping.set(true)
        }
        return true;
    }
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
        "," => player.pause_at_block_before(),
        "." => player.pause_at_next_block(),
        "a" => operator::toggle_list(page),
        "g" => stepping::show_block(page),
        "Home" if tag != "INPUT" => player.seek(0.0),
        "?" | "/" => page.view.helping.set(true),
        key => match SteppingCommand::of_key(key) {
            Some(command) => command.run(page),
            None => return false,
        },
    }
    true
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::state::history::Undoable;
    use crate::ui::testing::{event, mount};

    fn key(key: &str) -> KeyboardEvent {
        event("KeyboardEvent", "keydown", &[("key", key.into())]).unchecked_into()
    }

    fn control_key(key: &str, shift: bool) -> KeyboardEvent {
        let members = [("key", key.into()), ("ctrlKey", true.into()), ("shiftKey", shift.into())];
        event("KeyboardEvent", "keydown", &members).unchecked_into()
    }

    #[wasm_bindgen_test]
    async fn single_keys_play_go_home_and_ask_for_help() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        assert!(press(page, &key(" ")) && page.player.playing.get_untracked());
        page.player.seek(1.0);
        assert!(press(page, &key("Home")) && page.player.head() == 0.0);
        assert!(press(page, &key("?")) && page.view.helping.get_untracked());
        for help in ["/", "F1"] {
            page.view.helping.set(false);
            assert!(press(page, &key(help)) && page.view.helping.get_untracked(), "{help}");
        }
        assert_eq!(page.view.help_at.get_untracked(), "");
        assert!(press(page, &key("a")) && page.view.panel.get_untracked() && page.view.actions.get_untracked());
        assert!(!press(page, &key("q")));
        page.player.playing.set(false);
        crate::ui::testing::settled().await;
    }

    #[wasm_bindgen_test]
    async fn help_key_in_a_field_leads_to_the_field() {
        let bench = mount(|| leptos::html::input().id("pitch")).await;
        let page = bench.page;
        let members = [("key", "F1".into()), ("bubbles", true.into())];
        listen(page);
        bench.find("#pitch").dispatch_event(&event("KeyboardEvent", "keydown", &members)).unwrap();
        assert_eq!(
            (page.view.helping.get_untracked(), page.view.help_at.get_untracked().as_str()),
            (true, "field.pitch")
        );
    }

    #[wasm_bindgen_test]
    async fn keys_that_are_off_do_nothing_but_undo() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        turn(false);
        page.set("pitch", crate::machines::form::Value::Number(9.0));
        assert!(!press(page, &key("?")) && !page.view.helping.get_untracked());
        assert!(press(page, &control_key("z", false)));
        assert_eq!(page.undoable.get_untracked(), Undoable { undo: false, redo: true });
        assert!(press(page, &control_key("Z", true)));
        assert_eq!(page.undoable.get_untracked(), Undoable { undo: true, redo: false });
        crate::ui::testing::settled().await;
    }

    #[wasm_bindgen_test]
    async fn open_dialog_keeps_its_keys() {
        let bench = mount(|| leptos::html::dialog().attr("open", "")).await;
        assert!(bench.has("dialog[open]"));
        assert!(!press(bench.page, &key("?")));
    }
}

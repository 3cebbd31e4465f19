//! The shell: signals and components, without formulas.

#![allow(unreachable_pub, reason = "the macro of components writes `pub` for their properties")]

mod words;

mod dom;

mod state;

mod worker;

mod parts;

mod form;

mod machine;

mod program;

mod results;

mod files;

mod help;

mod app;

use dom::turns::in_turn;
use leptos::prelude::*;

use crate::text::catalog;

pub use app::embed::{Embedded, EmbeddedApp};
pub use app::{App, PageStart};
pub use worker::server::work;

/// Opens the page with the sentences of its language ([`catalog::speak`]) in place of the first drawing in its HTML: the whole page, or the
/// embedded one if the address requests it. A panic is reported in its place.
pub fn open(sentences: String) {
    catalog::speak(sentences.leak());
    std::panic::set_hook(Box::new(|panic| {
        web_sys::console::error_1(&panic.to_string().into());
        broken(&panic.to_string());
    }));
    parts::lengths::show_chosen();
    if Embedded::is_asked_for() {
        return in_turn(|| {
            Embedded::in_turns(|embedded| {
                leptos::mount::mount_to_body(|| embedded.map(|embedded| view! { <EmbeddedApp embedded=embedded /> }));
            });
        });
    }
    in_turn(|| {
        PageStart::in_turns(|start| {
            leptos::mount::mount_to_body(|| start.map(|start| view! { <App start=start /> }));
        });
    });
}

/// Shows in plain DOM that the page has stopped: after a panic no signal works any more.
fn broken(reason: &str) {
    let Some(body) = web_sys::window().and_then(|window| window.document()?.body()) else { return };
    let Ok(paragraph) = document().create_element("p") else { return };
    paragraph.set_class_name("broken");
    paragraph.set_text_content(Some(&words::sentence(&crate::msg!("page.broken", reason))));
    let _ = body.prepend_with_node_1(&paragraph);
}

#[cfg(test)]
mod testing;

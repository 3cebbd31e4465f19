//! A dialog over the page, with a title and a way out.

use leptos::html;
use leptos::prelude::*;

use super::icon::{Glyph, IconButton};
use crate::ui::words::t;

/// A dialog that is open while `open` holds.
#[component]
pub(crate) fn Dialog(
    /// Id of its title.
    id: &'static str,
    /// The title.
    #[prop(into)]
    title: Signal<String>,
    /// Whether it is open; closing sets it to false.
    open: RwSignal<bool>,
    /// Further classes.
    #[prop(optional)]
    class: &'static str,
    /// Its content.
    children: Children,
) -> impl IntoView {
    let frame: NodeRef<html::Dialog> = NodeRef::new();
    Effect::new(move |_| {
        let (open, Some(frame)) = (open.get(), frame.get()) else { return };
        if !open {
            frame.close();
        } else if !frame.open() {
            let _ = frame.show_modal();
        }
    });
    view! {
        <dialog node_ref=frame class=format!("dialog {class}") aria-labelledby=id on:close=move |_| open.set(false)>
            <header>
                <h2 id=id>{title}</h2>
                <IconButton glyph=Glyph::Close label=t("page.close") press=move || open.set(false) />
            </header>
            {children()}
        </dialog>
    }
}

//! A dialog over the page, with a title and a way out.

use leptos::html;
use leptos::prelude::*;

use super::icon::{Glyph, IconButton};
use crate::ui::words::t;

/// A dialog that is open while `open` is true.
#[component]
pub(crate) fn Dialog(
    /// Id of its title.
    id: &'static str,
    /// The title.
    #[prop(into)]
    title: Signal<String>,
    /// Whether the dialog is open.
    #[prop(into)]
    open: Signal<bool>,
    /// Sets `open` to false: called by the button, by Esc and by other ways of closing.
    #[prop(into)]
    close: Callback<()>,
    /// Further classes.
    #[prop(optional)]
    class: &'static str,
    /// Content of the dialog.
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
        <dialog node_ref=frame class=format!("dialog {class}") aria-labelledby=id on:close=move |_| close.run(())>
            <header>
                <h2 id=id>{title}</h2>
                <IconButton glyph=Glyph::Close label=t("page.close") press=close />
            </header>
            {children()}
        </dialog>
    }
}

/// A button of the header that opens a dialog.
#[component]
pub(crate) fn DialogButton(
    /// Id of the button.
    id: &'static str,
    /// Catalog id of its name.
    label: &'static str,
    /// Catalog id of the sentence about the dialog.
    about: &'static str,
    /// Whether the dialog is open.
    open: RwSignal<bool>,
) -> impl IntoView {
    view! { <button type="button" class="quiet" id=id title=t(about) on:click=move |_| open.set(true)>{t(label)}</button> }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use leptos::wasm_bindgen::JsCast;

    use crate::ui::testing::{ViewBench, mount, settled};

    async fn dialog(open: RwSignal<bool>) -> ViewBench {
        mount(move || view! { <Dialog id="some-title" title="Title" open=open close=move || open.set(false)><p>"Content"</p></Dialog> }).await
    }

    #[wasm_bindgen_test]
    async fn dialog_is_closed_until_asked_for() {
        let open = RwSignal::new(false);
        let bench = dialog(open).await;
        assert!(!bench.has("dialog[open]"));
        open.set(true);
        settled().await;
        assert!(bench.has("dialog[open]"));
        assert_eq!((bench.text("dialog p"), bench.text("#some-title")), ("Content".to_owned(), "Title".to_owned()));
    }

    #[wasm_bindgen_test]
    async fn dialog_is_labelled_and_takes_the_focus() {
        let bench = dialog(RwSignal::new(true)).await;
        assert_eq!(bench.attribute("dialog", "aria-labelledby"), "some-title");
        assert!(document().active_element().unwrap().closest("dialog").unwrap().is_some());
    }

    #[wasm_bindgen_test]
    async fn close_button_closes_the_dialog() {
        let open = RwSignal::new(true);
        let bench = dialog(open).await;
        bench.press_button(t("page.close")).await;
        assert!(!open.get_untracked() && !bench.has("dialog[open]"));
    }

    #[wasm_bindgen_test]
    async fn dialog_closed_by_the_browser_can_open_again() {
        let open = RwSignal::new(true);
        let bench = dialog(open).await;
        bench.find("dialog").unchecked_into::<web_sys::HtmlDialogElement>().close();
        crate::ui::testing::until(move || !open.get_untracked()).await;
        open.set(true);
        settled().await;
        assert!(bench.has("dialog[open]"));
    }
}

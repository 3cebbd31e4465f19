//! A part of the page that is built in a turn of its own.

use leptos::prelude::*;

use crate::ui::dom::turns::in_turn;

/// Builds its content in a task of its own, after all waiting tasks, so that no part of the page delays another.
/// The content must not move its surroundings, unless `meanwhile` keeps the space for it.
#[component]
pub(crate) fn Later(
    /// Placeholder until the content is built.
    #[prop(optional, into)]
    meanwhile: ViewFn,
    /// The content.
    children: Children,
) -> impl IntoView {
    let due = RwSignal::new(false);
    // The page may be gone.
    in_turn(move || {
        let _ = due.try_set(true);
    });
    let mut children = Some(children);
    move || if due.get() { children.take().map(|children| children()) } else { Some(meanwhile.run()) }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, mount_begun};

    #[wasm_bindgen_test]
    async fn content_is_built_after_the_page_around_it() {
        let view = || view! { <p>"around"</p><Later><b>"content"</b></Later> };
        assert!(!mount_begun(view).await.has("b"));
        assert_eq!(mount(view).await.text("b"), "content");
    }
}

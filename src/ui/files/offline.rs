//! The page without a network: the browser keeps its files, and a newer build of them is announced and taken when the user asks for it.

use leptos::prelude::*;
use leptos::wasm_bindgen::closure::Closure;

use super::store;
use crate::ui::dom;
use crate::ui::dom::script;
use crate::ui::state::Page;
use crate::ui::state::notices::Notice;
use crate::ui::words::{Tone, t};

/// The module beside the page that talks to the service worker.
const MODULE: &str = "offline.js";

/// Makes the browser keep the files of the page, and announces newer ones. Some browsers and hosts do not allow it; the page works without
/// it too.
pub(crate) fn keep(page: Page) {
    if !dom::is_installable() {
        return;
    }
    leptos::task::spawn_local(async move {
        let Ok(module) = script::load(MODULE).await else { return };
        let announce = Closure::<dyn Fn()>::new(move || {
            // The page may be gone.
            if !page.is_gone() {
                announce(page, take);
            }
        });
        let _ = script::call(&module, "keep", &[&announce.into_js_value()]);
    });
}

/// Switches to the newer build, which reloads the page.
fn take() {
    leptos::task::spawn_local(async {
        if let Ok(module) = script::load(MODULE).await {
            let _ = script::call(&module, "take", &[]);
        }
    });
}

/// Announces a newer build. It is taken only after the project is stored, so that nothing is lost.
fn announce(page: Page, take: fn()) {
    let act = move |()| {
        if store::store_before_reload(page) {
            take()
        } else {
            page.notices.notify(Tone::Warn, t("page.version-unkept").to_owned())
        }
    };
    let offer = Some(("page.version-take", Callback::new(act)));
    page.notices.show(Notice { offer, ..Notice::new(Tone::Info, t("page.version-ready").to_owned()) });
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::machines::form::Value;
    use crate::ui::state::view::Kept;
    use crate::ui::testing::{ViewBench, WithoutHistory, mount};

    thread_local! {
        static TAKEN: Cell<u32> = const { Cell::new(0) };
    }

    /// A page that offers a newer build, with a changed project that is not stored yet.
    async fn announced(kept: Kept) -> ViewBench {
        TAKEN.set(0);
        let bench = mount(|| ()).await;
        bench.page.set("pitch", Value::Number(9.0));
        bench.page.view.kept.set(kept);
        announce(bench.page, || TAKEN.set(TAKEN.get() + 1));
        bench
    }

    /// Presses the button of the last notice.
    fn press(bench: &ViewBench) {
        let offer = bench.page.notices.list.with_untracked(|list| list.last().and_then(|notice| notice.offer));
        offer.unwrap().1.run(());
    }

    #[wasm_bindgen_test]
    async fn newer_version_is_announced_once_and_waits() {
        let bench = announced(Kept::Yes).await;
        announce(bench.page, take);
        assert_eq!(bench.notices(), [t("page.version-ready")]);
        assert_eq!(TAKEN.get(), 0);
    }

    #[wasm_bindgen_test]
    async fn project_is_stored_before_the_version_is_taken() {
        let bench = announced(Kept::Soon).await;
        press(&bench);
        assert_eq!(TAKEN.get(), 1);
        assert!(store::load().project == Some(bench.page.project.get_untracked()));
    }

    #[wasm_bindgen_test]
    async fn version_is_not_taken_where_the_project_has_no_room() {
        let bench = announced(Kept::Yes).await;
        bench.page.edit(|project| project.name = "x".repeat(6_000_000));
        let denied = WithoutHistory::new();
        press(&bench);
        drop(denied);
        assert_eq!(TAKEN.get(), 0);
        assert!(bench.notices().contains(&t("page.version-unkept").to_owned()));
    }

    #[wasm_bindgen_test]
    async fn version_is_taken_where_the_tab_keeps_the_project() {
        let bench = announced(Kept::Yes).await;
        bench.page.edit(|project| project.name = "x".repeat(6_000_000));
        press(&bench);
        assert_eq!(TAKEN.get(), 1);
        assert!(dom::stored("macroline.project").is_none());
        let own = bench.page.project.with_untracked(|project| project.values.clone());
        assert_eq!(store::load().project.unwrap().values, own);
    }

    #[wasm_bindgen_test]
    async fn entries_of_a_watching_tab_are_set_aside_before() {
        let bench = announced(Kept::Elsewhere).await;
        press(&bench);
        assert_eq!(TAKEN.get(), 1);
        assert_eq!(dom::stored_keys().iter().filter(|key| key.contains("other-tab")).count(), 1);
        assert!(dom::stored("macroline.project").is_none());
    }
}

//! Light or dark, and contrast: each a button that goes through its choices.

use leptos::prelude::*;

use super::icon::{Glyph, Icon};
use crate::ui::dom;
use crate::ui::dom::tab_entry::{remember, remembered};
use crate::ui::state::Page;
use crate::ui::words::t;

/// Key in the browser's store of the theme.
const THEME: &str = "macroline.theme";

/// Themes in the order in which the button goes through them, with their words.
const THEMES: [(&str, &str); 3] =
    [("", "page.theme-system"), ("light", "page.theme-light"), ("dark", "page.theme-dark")];

/// Key in the browser's store of the contrast.
const CONTRAST: &str = "macroline.contrast";

/// Contrasts in the order in which the button goes through them, as media for which their sheet counts, with their words.
const CONTRASTS: [(&str, &str); 3] = [
    ("(prefers-contrast: more)", "page.contrast-system"),
    ("all", "page.contrast-high"),
    ("not all", "page.contrast-standard"),
];

/// Light, dark, or as the system.
#[component]
pub(crate) fn ThemeButton() -> impl IntoView {
    let apply = |theme| {
        if let Some(root) = document().document_element() {
            dom::set(&root, "data-theme", theme);
        }
    };
    view! { <CycleButton class="icon theme" glyph=Glyph::Theme at=Page::here().view.appearance.theme key=THEME choices=&THEMES apply=apply /> }
}

/// High contrast, standard, or as the system.
#[component]
pub(crate) fn ContrastButton() -> impl IntoView {
    let apply = |media| {
        if let Some(sheet) = dom::by_id("contrast") {
            dom::set(&sheet, "media", media);
        }
    };
    view! { <CycleButton class="icon contrast" glyph=Glyph::Contrast at=Page::here().view.appearance.contrast key=CONTRAST choices=&CONTRASTS apply=apply /> }
}

/// A button that goes through choices, applies the present one and remembers it.
#[component]
fn CycleButton(
    /// Classes.
    class: &'static str,
    /// Icon of the button.
    glyph: Glyph,
    /// The present choice, counted from 0.
    at: RwSignal<usize>,
    /// Key in the browser's store.
    key: &'static str,
    /// Choices with their words; the first one is the default.
    choices: &'static [(&'static str, &'static str); 3],
    /// Applies a choice.
    apply: fn(&'static str),
) -> impl IntoView {
    let stored = remembered(key).unwrap_or_default();
    at.set(choices.iter().position(|(id, _)| *id == stored).unwrap_or(0));
    let choice = move || choices.get(at.get()).copied().unwrap_or(choices[0]);
    Effect::new(move |_| apply(choice().0));
    let next = move |_| {
        at.update(|at| *at = (*at + 1) % choices.len());
        remember(key, untrack(choice).0);
    };
    view! {
        <button type="button" class=class aria-label=move || t(choice().1) title=move || t(choice().1) on:click=next>
            <Icon glyph=glyph />
        </button>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, mount, mount_project, project};

    type Choices = [(&'static str, &'static str); 3];

    /// Presses a button through all choices: each with its effect and words, the first one last.
    async fn goes_round(bench: &ViewBench, class: &str, choices: Choices, effect: fn(&ViewBench) -> String) {
        for (id, words) in [choices[1], choices[2], choices[0]] {
            bench.press(class).await;
            assert_eq!((effect(bench).as_str(), bench.attribute(class, "aria-label").as_str()), (id, t(words)));
        }
    }

    fn theme(_: &ViewBench) -> String {
        document().document_element().unwrap().get_attribute("data-theme").unwrap()
    }

    fn media(bench: &ViewBench) -> String {
        bench.attribute("#contrast", "media")
    }

    #[wasm_bindgen_test]
    async fn theme_goes_round_and_is_remembered() {
        let bench = mount(|| view! { <ThemeButton /> }).await;
        goes_round(&bench, ".theme", THEMES, theme).await;
        bench.press(".theme").await;
        drop(bench);
        let bench = mount_project(project(), || view! { <ThemeButton /> }).await;
        assert_eq!(
            (theme(&bench).as_str(), bench.attribute(".theme", "aria-label").as_str()),
            ("light", t("page.theme-light"))
        );
    }

    #[wasm_bindgen_test]
    async fn contrast_goes_round_and_is_remembered() {
        let bench = mount(|| view! { <style id="contrast"></style> <ContrastButton /> }).await;
        goes_round(&bench, ".contrast", CONTRASTS, media).await;
        bench.press(".contrast").await;
        drop(bench);
        let bench = mount_project(project(), || view! { <style id="contrast"></style> <ContrastButton /> }).await;
        assert_eq!(
            (media(&bench).as_str(), bench.attribute(".contrast", "aria-label").as_str()),
            ("all", t("page.contrast-high"))
        );
    }

    #[wasm_bindgen_test]
    async fn two_buttons_of_one_choice_agree() {
        let bench = mount(|| view! { <ThemeButton /> <i><ThemeButton /></i> }).await;
        bench.press("i .theme").await;
        assert_eq!(bench.attribute(".theme", "aria-label"), bench.attribute("i .theme", "aria-label"));
    }
}

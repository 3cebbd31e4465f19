//! Signs that look the same with every font.

use leptos::prelude::*;

/// A sign, as the path of a 16 × 16 drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Glyph {
    /// Back to the start.
    ToStart,
    /// One block back.
    Back,
    /// One block forth.
    Forth,
    /// Play.
    Play,
    /// Pause.
    Pause,
    /// Repeat from the start at the end of the run.
    Repeat,
    /// Undo.
    Undo,
    /// Redo.
    Redo,
    /// Close.
    Close,
    /// Unfold upwards.
    Up,
    /// Whole screen.
    Full,
    /// One flash per head.
    Strobe,
    /// Save a picture.
    Picture,
    /// Help.
    Help,
    /// Light, dark, or as the system.
    Theme,
    /// Contrast.
    Contrast,
    /// Step through the program.
    Step,
    /// Plus.
    More,
    /// Minus.
    Less,
    /// Magnifying glass.
    Find,
    /// A list.
    List,
    /// Go to a moment.
    Go,
    /// A roller on the ribbon, for the machine.
    Roller,
    /// Sliders, for inputs.
    Sliders,
    /// Angle brackets, for a program.
    Code,
}

impl Glyph {
    /// The path, drawn as a line.
    fn path(self) -> &'static str {
        match self {
            Glyph::ToStart => "M3 3v10M13 3.5v9L6 8z",
            Glyph::Back => "M12.500 3v10M9.500 3.500v9L3 8z",
            Glyph::Forth => "M3.500 3v10M6.500 3.500v9L13 8z",
            Glyph::Play => "M4.500 2.800v10.400L13 8z",
            Glyph::Pause => "M5 3v10M11 3v10",
            Glyph::Repeat => "M3 7a4 4 0 0 1 4-4h5M10 1l2 2-2 2M13 9a4 4 0 0 1-4 4H4M6 15l-2-2 2-2",
            Glyph::Undo => "M3 6h6.500a3.500 3.500 0 0 1 0 7H6M6 3 3 6l3 3",
            Glyph::Redo => "M13 6H6.500a3.500 3.500 0 0 0 0 7H10M10 3l3 3-3 3",
            Glyph::Close => "m4 4 8 8M12 4l-8 8",
            Glyph::Up => "m4 10 4-4 4 4",
            Glyph::Full => "M3 6V3h3M10 3h3v3M13 10v3h-3M6 13H3v-3",
            Glyph::Strobe => "M9 1.500 3.500 9H8l-1 5.500L12.500 7H8z",
            Glyph::Picture => "M8 2v8M5 7l3 3 3-3M3 13h10",
            Glyph::Help => "M5.800 6a2.200 2.200 0 1 1 3.200 2c-.7.4-1 .8-1 1.500M8 12.200v.1",
            Glyph::Theme => "M8 2a6 6 0 1 0 0 12zM8 2a6 6 0 0 1 0 12",
            Glyph::Contrast => {
                "M1.500 8q2.600-4.500 6.500-4.500t6.500 4.500q-2.600 4.500-6.500 4.500t-6.500-4.500zM8 6a2 2 0 1 0 0 4a2 2 0 1 0 0-4"
            }
            Glyph::Step => "M3 4h6M3 8h4M3 12h6M12 5v6M9.800 9 12 11.200 14.200 9",
            Glyph::Find => "M7 2.500a4.500 4.500 0 1 1 0 9a4.500 4.500 0 1 1 0-9M10.300 10.300l3.700 3.700",
            Glyph::More => "M8 3.500v9M3.500 8h9",
            Glyph::Less => "M3.500 8h9",
            Glyph::List => "M6 4h7M6 8h7M6 12h7M3 4v.1M3 8v.1M3 12v.1",
            Glyph::Go => "M2.500 8h10M9 4.500 12.500 8 9 11.500",
            Glyph::Roller => "M8 2a4.500 4.500 0 1 1 0 9a4.500 4.500 0 1 1 0-9M8 6.500v4.500M2 13.500h12",
            Glyph::Sliders => {
                "M2 5h2M8 5h6M6 3a2 2 0 1 1 0 4a2 2 0 1 1 0-4M2 11h6M12 11h2M10 9a2 2 0 1 1 0 4a2 2 0 1 1 0-4"
            }
            Glyph::Code => "M5.500 4 1.500 8l4 4M10.500 4l4 4-4 4",
        }
    }
}

/// A sign, hidden from screen readers.
#[component]
pub(crate) fn Icon(
    /// The icon.
    #[prop(into)]
    glyph: Signal<Glyph>,
) -> impl IntoView {
    view! {
        <svg class="sign" viewBox="0 0 16 16" aria-hidden="true">
            <path d=move || glyph.get().path() />
        </svg>
    }
}

/// A button with a sign, and words for screen readers.
#[component]
pub(crate) fn IconButton(
    /// The sign.
    #[prop(into)]
    glyph: Signal<Glyph>,
    /// Accessible name: the action of the button.
    #[prop(into)]
    label: Signal<String>,
    /// Words shown when the pointer rests on it; the label where there are none.
    #[prop(optional, into)]
    title: Option<String>,
    /// Further classes.
    #[prop(optional)]
    class: &'static str,
    /// Whether the button is disabled.
    #[prop(optional, into)]
    disabled: Signal<bool>,
    /// Action of the button.
    #[prop(into)]
    press: Callback<()>,
) -> impl IntoView {
    let title = move || title.clone().unwrap_or_else(|| label.get());
    view! {
        <button type="button" class=format!("icon {class}") aria-label=label title=title disabled=disabled on:click=move |_| press.run(())>
            <Icon glyph=glyph />
        </button>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::mount;

    #[wasm_bindgen_test]
    async fn icon_button_has_words_for_all_and_does_its_work() {
        let presses = RwSignal::new(0);
        let bench = mount(move || {
            let press = move || presses.update(|count| *count += 1);
            view! { <IconButton glyph=Glyph::Undo label="Undo" press=press /> }
        })
        .await;
        assert_eq!(
            (bench.attribute("button", "aria-label"), bench.attribute("button", "title")),
            ("Undo".to_owned(), "Undo".to_owned())
        );
        assert_eq!(bench.attribute("svg", "aria-hidden"), "true");
        bench.press_button("Undo").await;
        assert_eq!(presses.get_untracked(), 1);
    }

    #[wasm_bindgen_test]
    async fn disabled_icon_button_does_nothing() {
        let (presses, disabled) = (RwSignal::new(0), RwSignal::new(true));
        let bench = mount(move || {
            let press = move || presses.update(|count| *count += 1);
            view! { <IconButton glyph=Glyph::Undo label="Undo" title="Undo (Ctrl+Z)" disabled=disabled press=press /> }
        })
        .await;
        assert_eq!(bench.attribute("button", "title"), "Undo (Ctrl+Z)");
        bench.press("button").await;
        assert_eq!(presses.get_untracked(), 0);
        disabled.set(false);
        crate::ui::testing::settled().await;
        bench.press("button").await;
        assert_eq!(presses.get_untracked(), 1);
    }

    #[wasm_bindgen_test]
    async fn sign_follows_its_state() {
        let glyph = RwSignal::new(Glyph::Play);
        let bench = mount(move || view! { <Icon glyph=glyph /> }).await;
        let play = bench.attribute("path", "d");
        glyph.set(Glyph::Pause);
        crate::ui::testing::settled().await;
        assert_ne!(bench.attribute("path", "d"), play);
    }
}

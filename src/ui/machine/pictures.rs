//! The drawing as a file.

use leptos::prelude::*;

use crate::ui::dom;
use crate::ui::state::Page;
use crate::view::svg::Theme;

/// Saves the drawing at the play head as SVG, in the colours of the page.
pub(super) fn save_svg(page: Page) {
    let root = document().document_element();
    let chosen = root.and_then(|root| root.get_attribute("data-theme")).unwrap_or_default();
    let dark = chosen == "dark" || chosen.is_empty() && dom::prefers("(prefers-color-scheme: dark)");
    let theme = if dark { Theme::Dark } else { Theme::Light };
    if let Some(svg) = page.player.picture(theme) {
        let name = page.project.with_untracked(|project| project.file_name("svg"));
        dom::download(&name, "image/svg+xml", svg.as_bytes());
    }
}

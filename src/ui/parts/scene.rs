//! A scene as SVG for the page.

use web_sys::HtmlElement;

use crate::ui::words::t;
use crate::view::{Scene, svg};

/// The scene with its alternative text. Words in it are escaped.
pub(crate) fn svg(scene: &Scene) -> String {
    svg::page(scene, t(scene.alt))
}

/// Keeps labels at their size in pixels, as far as they have room: `--u` is the number of drawing units per pixel, at most `most` where
/// the scene gives one.
pub(crate) fn fit(picture: &HtmlElement, [_, _, width, height]: [f64; 4], most: f64) {
    let room = picture.get_bounding_client_rect();
    if room.width() > 0.0 && room.height() > 0.0 {
        let unit = (width / room.width()).max(height / room.height());
        let unit = if most > 0.0 { unit.min(most) } else { unit };
        let _ = picture.style().set_property("--u", &format!("{unit:.4}"));
    }
}

//! A scene as SVG for the page.

use crate::ui::words::t;
use crate::view::{Scene, svg};

/// The scene with its alternative text. Words in it are escaped.
pub(crate) fn svg(scene: &Scene) -> String {
    svg::page(scene, t(scene.alt))
}

//! The turning tool of the turned ends, on the slide in the place of the cutter; the form does not have its size.

use super::cutter::{self, column};
use super::ids::group;
use super::layout::Layout;
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::text::number::filled;
use crate::view::drawing::Drawing;
use crate::view::look::{Look, Paint};
use crate::view::scene::SceneGroup;

/// Half the height of the tool post, and of the shank in it.
const POST: f64 = 34.0;
const SHANK: f64 = 9.0;

/// The tool from the front, with its post on the column; its origin is the axis of the cutter, so that its tip is where the cutter's are.
pub(super) fn draw(drawing: &mut Drawing, lathe: &PolygonLathe, layout: &Layout) {
    let reach = column(lathe, layout);
    let r = lathe.params.tip_radius * layout.scale;
    let place = SceneGroup { parent: group::WINDOW, at: layout.cutter, ..SceneGroup::default() };
    drawing.place(group::TURNING_TOOL, place);
    drawing.within_hidden(group::TURNING_TOOL, |drawing| {
        cutter::draw_column(drawing, reach);
        // The post in front of the column, the shank in it, and the insert with its face at the height of the axis.
        let (left, right) = (-reach - 6.0, reach + 6.0);
        drawing.path(
            filled("M# #l12 -7H#V#l-12 7Z", &[right, -POST, right + 12.0, POST - 7.0]),
            Look::fill(Paint::DarkShade),
        );
        drawing.path(filled("M# #l12 -7H#l-12 7Z", &[left, -POST, right + 12.0]), Look::fill(Paint::DarkLight));
        drawing.rect([left, -POST, right - left, 2.0 * POST, 2.0], Look::fill(Paint::DarkFront).thin(Paint::Edge, 0.8));
        drawing.path(
            filled("M# -2H#V#H#L# 7Z", &[6.0 - r, right - 10.0, 2.0 * SHANK - 2.0, 26.0 - r, 10.0 - r]),
            Look::FACE,
        );
        for x in [left + 10.0, right - 16.0] {
            drawing.rect([x, -POST + 8.0, 8.0, 8.0, 1.0], Look::HOLE);
        }
        drawing.path(filled("M# 0l20 -3v8l-14 3Z", &[-r]), Look::fill(Paint::Accent).thin(Paint::Edge, 0.8));
    });
}

/// The tool from above; its origin is that of the slide.
pub(super) fn draw_from_above(drawing: &mut Drawing) {
    drawing.path("M2 16h16V80H2Z", Look::fill(Paint::SteelBody).thin(Paint::Edge, 0.8));
    drawing.rect([-10.0, 50.0, 40.0, 26.0, 2.0], Look::fill(Paint::DarkFront).thin(Paint::Edge, 0.8));
    drawing.path("M-4 56h6v6h-6ZM18 56h6v6h-6Z", Look::HOLE);
    drawing.path("M0 0L13 7L15 22H5Z", Look::fill(Paint::Accent).thin(Paint::Edge, 0.8));
}

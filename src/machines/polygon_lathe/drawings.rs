//! Files beside programs and sheets: the section in true millimetres as SVG and DXF, and the part program in the native codes of other controls.

use super::native_code;
use super::outlines::ideal;
use super::resolved::PolygonLathe;
use crate::nc::File;
use crate::view::outline::{Outline, OutlineShape};

/// Steps along an arc of the section: half a micrometre on a usual part.
const STEPS: u32 = 64;

/// The files beside programs and sheets.
pub(super) fn drawings(lathe: &PolygonLathe) -> Vec<File> {
    let file = |name: &str, text: String| File { name: name.to_owned(), text };
    let mut files: Vec<File> = native_code::file(lathe).into_iter().collect();
    if let Some(outline) = section(lathe) {
        files.push(file("section.svg", outline.svg()));
        files.push(file("section.dxf", outline.dxf()));
    }
    files
}

/// The finished section, the ideal polygon and the stock.
fn section(lathe: &PolygonLathe) -> Option<Outline> {
    let section = lathe.p.section()?;
    let p = &lathe.p;
    let mut shapes = vec![
        OutlineShape { layer: "FINISHED", points: section.points(STEPS), radius: 0.0 },
        OutlineShape { layer: "STOCK", points: Vec::new(), radius: section.stock() },
    ];
    if p.sides > 2.0 {
        let points = ideal(p.sides as u32, 0.5 * p.across_flats, section.begin());
        shapes.push(OutlineShape { layer: "IDEAL", points, radius: 0.0 });
    }
    Some(Outline { shapes })
}

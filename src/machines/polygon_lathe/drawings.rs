//! Files beside programs and sheets: the section in true millimetres as SVG and DXF, and the part program in the native codes of other controls.

use super::native_code;
use super::outlines::ideal;
use super::resolved::PolygonLathe;
use crate::drives::polygon::Section;
use crate::machines::MachineFile;
use crate::machines::sheets::say;
use crate::math::{self, PI};
use crate::msg;
use crate::nc::File;
use crate::text::catalog::{number_text as show, sentence};
use crate::text::detailed;
use crate::view::outline::{Dimension, LineKind, Outline, OutlineShape, Plate};

/// Arcs per cut side: on a usual part they deviate from it by less than 0.01 µm.
const SPANS: u32 = 8;

/// The files beside programs and sheets.
pub(super) fn files(lathe: &PolygonLathe) -> Vec<MachineFile> {
    let drawn = |name: &str, text: String, meaning| MachineFile { file: File { name: name.to_owned(), text }, meaning };
    let other = native_code::file(lathe).map(|file| MachineFile { file, meaning: "page.file.other-program" });
    let mut files: Vec<MachineFile> = other.into_iter().collect();
    let sections: Vec<(String, Outline)> =
        lathe.polygons().zip(NAMES).filter_map(|(one, name)| Some((title(lathe, one, name), section(one)?))).collect();
    if !sections.is_empty() {
        let plate = Plate::new(&sections);
        files.push(drawn("section.svg", plate.svg(legend), "page.file.drawing"));
        files.push(drawn("section.dxf", plate.dxf(), "page.file.outline"));
    }
    files
}

/// Names of the polygons in their order.
pub(super) const NAMES: [&str; 3] = ["polygon.first", "polygon.second", "polygon.third"];

/// Name and place of a section; empty if it is the only one.
fn title(lathe: &PolygonLathe, one: &PolygonLathe, name: &'static str) -> String {
    if lathe.further.is_empty() {
        return String::new();
    }
    let [first, last] = [one.params.from_face, one.params.far_end()].map(|at| show(-at, 3));
    // In words: a dash beside a minus would be misread.
    detailed(say(name), format!("Z {}", sentence(&msg!("form.open.range", first, last))))
}

/// The finished section, the ideal polygon and the stock, with centre lines and dimensions.
fn section(lathe: &PolygonLathe) -> Option<Outline> {
    let section = lathe.params.section()?;
    let p = &lathe.params;
    let mut shapes = vec![
        (LineKind::Part, OutlineShape::through(&section.spans(SPANS))),
        (LineKind::Stock, OutlineShape::Circle((0.0, 0.0), section.stock())),
    ];
    if p.sides > 2.0 {
        let corners = ideal(p.sides as u32, 0.5 * p.across_flats, section.begin());
        shapes.push((LineKind::Ideal, OutlineShape::polygon(&corners)));
    }
    let mut outline = Outline { shapes, dimensions: Vec::new() };
    outline.dimensions = dimensions(&section, p.across_flats, outline.beside());
    let end = 1.12 * outline.reach();
    for angle in [section.begin(), section.begin() + 0.5 * PI] {
        outline.shapes.push((LineKind::Centre, OutlineShape::Line(at(angle + PI, end), at(angle, end))));
    }
    Some(outline)
}

/// A point at an angle and a distance from the centre.
fn at(angle: f64, distance: f64) -> (f64, f64) {
    let (sin, cos) = math::sin_cos(angle);
    (distance * cos, distance * sin)
}

/// Across flats, across corners where the sides meet, and the stock, each at a side of its own.
fn dimensions(section: &Section, across_flats: f64, away: f64) -> Vec<Dimension> {
    let (normal, half) = (section.begin(), 0.5 * across_flats);
    let across = |angle: f64, half: f64, away: f64, text: String| Dimension {
        from: at(angle + PI, half),
        to: at(angle, half),
        away,
        text,
    };
    let opposite = section.sides().len().is_multiple_of(2);
    let corner = section.corners().first().copied();
    // Extension lines begin at the ends of the flats.
    let end = corner.map_or(0.0, |corner| (corner.radius * corner.radius - half * half).max(0.0).sqrt());
    let aside = at(normal + 0.5 * PI, end);
    let beside = |(x, y): (f64, f64)| (x + aside.0, y + aside.1);
    let (from, text) = if opposite { (at(normal + PI, half), across_flats) } else { ((0.0, 0.0), half) };
    let flats = Dimension { from: beside(from), to: beside(at(normal, half)), away: away - end, text: show(text, 3) };
    let stock = across(normal + 0.5 * PI, section.stock(), away, format!("⌀{}", show(2.0 * section.stock(), 3)));
    let corner = corner.filter(|corner| corner.meets && opposite);
    let corner = corner.map(|corner| across(corner.angle, corner.radius, -away, show(section.across_corners().0, 3)));
    [flats, stock].into_iter().chain(corner).collect()
}

/// Word of the legend for a kind of line.
fn legend(kind: LineKind) -> String {
    say(match kind {
        LineKind::Part => "polygon.drawing.part",
        LineKind::Stock => "polygon.drawing.stock",
        LineKind::Ideal => "polygon.drawing.ideal",
        LineKind::Centre => "polygon.drawing.centre",
    })
}

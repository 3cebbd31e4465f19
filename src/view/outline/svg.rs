//! The drawing as SVG in millimetres, for printing in true size.

use core::fmt::Write;

use super::dimension::LAYER;
use super::plate::Plate;
use super::shapes::{LineKind, OutlineShape, Vertex};
use crate::math;
use crate::text::number::Plain;
use crate::view::svg::escape;

/// Decimals of a coordinate in mm.
const DECIMALS: u8 = 6;

/// Line styles by kind, as in technical drawings (ISO 128): thick and full, dashed, thin, dash and dot.
const STYLE: &str = "path,circle,line{fill:none;stroke:#000;stroke-width:.18}\
    .part path{fill:#e6e9ed;stroke-width:.5}.stock circle,.stock line{stroke:#5b6673;stroke-dasharray:1.6 .8}\
    .ideal path,.ideal line{stroke:#0b62c4;stroke-dasharray:2.4 .6 .4 .6}.centre line{stroke:#8a2b2b;stroke-dasharray:4 .8 .8 .8}\
    .part line{stroke-width:.5}polygon{fill:#000}text{font-family:sans-serif;text-anchor:middle}.legend text{text-anchor:start}";

impl Plate {
    /// The plate as SVG. `name` gives the legend's text for a kind of line.
    pub fn svg(&self, name: impl Fn(LineKind) -> String) -> String {
        let letter = self.letter;
        let kinds: Vec<LineKind> =
            LineKind::ALL.into_iter().filter(|kind| self.shapes.iter().any(|(other, _)| other == kind)).collect();
        let [left, lowest, right, highest] = self.room;
        // In SVG y points down.
        let (top, foot, wide) = (-highest, -lowest, right - left);
        let high = foot - top + (1.6 * letter * (kinds.len() as f64 + 0.5)).ceil();
        let mut out = String::new();
        let [l, t, w, h] = [left, top, wide, high].map(|value| Plain(value, 0));
        let _ = write!(
            out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}mm\" height=\"{h}mm\" viewBox=\"{l} {t} {w} {h}\">\
             <style>{STYLE}text{{font-size:{}px}}</style>",
            number(letter)
        );
        for kind in &kinds {
            let _ = write!(out, "<g id=\"{}\" class=\"{}\">", kind.layer(), class(*kind));
            for (_, shape) in self.shapes.iter().filter(|(other, _)| other == kind) {
                put(&mut out, shape);
            }
            out.push_str("</g>");
        }
        self.svg_dimensions(&mut out);
        for (name, (x, y)) in &self.names {
            let _ = write!(out, "<text x=\"{}\" y=\"{}\">", number(*x), number(-y));
            escape(&mut out, name);
            out.push_str("</text>");
        }
        out.push_str("<g class=\"legend\">");
        for (row, kind) in kinds.iter().enumerate() {
            let y = foot + letter * (1.6 * row as f64 + 0.8);
            let (from, to) = (left + letter, left + 4.0 * letter);
            let _ = write!(out, "<g class=\"{}\">", class(*kind));
            line(&mut out, (from, -y), (to, -y));
            let _ = write!(out, "</g><text x=\"{}\" y=\"{}\">", number(to + 0.6 * letter), number(y + 0.35 * letter));
            escape(&mut out, &name(*kind));
            out.push_str("</text>");
        }
        out.push_str("</g></svg>\n");
        out
    }

    fn svg_dimensions(&self, out: &mut String) {
        if self.dimensions.is_empty() {
            return;
        }
        let _ = write!(out, "<g id=\"{LAYER}\">");
        for (dimension, drawn) in self.drawn() {
            for [from, to] in drawn.lines {
                line(out, from, to);
            }
            for arrow in drawn.arrows {
                let points = arrow.map(|(x, y)| format!("{},{}", number(x), number(-y))).join(" ");
                let _ = write!(out, "<polygon points=\"{points}\"/>");
            }
            let [x, y] = [drawn.foot.0, -drawn.foot.1].map(number);
            let angle = number(-drawn.angle);
            let _ = write!(out, "<text x=\"{x}\" y=\"{y}\" transform=\"rotate({angle} {x} {y})\">");
            escape(out, &dimension.text);
            out.push_str("</text>");
        }
        out.push_str("</g>");
    }
}

fn class(kind: LineKind) -> &'static str {
    match kind {
        LineKind::Part => "part",
        LineKind::Stock => "stock",
        LineKind::Ideal => "ideal",
        LineKind::Centre => "centre",
    }
}

fn number(value: f64) -> Plain {
    Plain(value, DECIMALS)
}

fn line(out: &mut String, from: (f64, f64), to: (f64, f64)) {
    let [x1, y1, x2, y2] = [from.0, -from.1, to.0, -to.1].map(number);
    let _ = write!(out, "<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"/>");
}

fn put(out: &mut String, shape: &OutlineShape) {
    match shape {
        OutlineShape::Circle((x, y), radius) => {
            let [x, y, r] = [*x, -y, *radius].map(number);
            let _ = write!(out, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>");
        }
        OutlineShape::Line(from, to) => line(out, *from, *to),
        OutlineShape::Contour(corners) => {
            out.push_str("<path d=\"");
            let next = corners.iter().cycle().skip(1);
            for (at, (corner, next)) in corners.iter().zip(next).enumerate() {
                if at == 0 {
                    let _ = write!(out, "M{} {}", number(corner.at.0), number(-corner.at.1));
                }
                piece(out, corner, next.at);
            }
            out.push_str("Z\"/>");
        }
    }
}

/// Writes the piece from a corner to the next point; y points down in SVG, so the sweep is reversed.
fn piece(out: &mut String, corner: &Vertex, (x, y): (f64, f64)) {
    let [to_x, to_y] = [x, -y].map(number);
    let bulge = corner.bulge;
    if bulge == 0.0 {
        let _ = write!(out, "L{to_x} {to_y}");
        return;
    }
    let chord = math::hypot(x - corner.at.0, y - corner.at.1);
    let radius = number(chord * (1.0 + bulge * bulge) / (4.0 * bulge.abs()));
    let (large, sweep) = (u8::from(bulge.abs() > 1.0), u8::from(bulge < 0.0));
    let _ = write!(out, "A{radius} {radius} 0 {large} {sweep} {to_x} {to_y}");
}

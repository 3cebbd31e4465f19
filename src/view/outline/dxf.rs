//! The drawing as DXF of release 12, readable by every CAD program: layers, line types, arcs as arcs, dimensions, millimetres.

use core::fmt::{Display, Write};

use super::dimension::{DrawnDimension, LAYER};
use super::plate::Plate;
use super::shapes::{LineKind, OutlineShape};
use crate::text::number::Plain;

/// Decimals of a coordinate in mm.
const DECIMALS: u8 = 9;

/// A line type: name, description, dashes and gaps in mm.
type LineType = (&'static str, &'static str, &'static [f64]);

/// Width over height of the initial window.
const ASPECT: f64 = 1.5;

const LINE_TYPES: [LineType; 3] = [
    ("CONTINUOUS", "Solid line", &[]),
    ("DASHED", "__ __ __ __", &[1.6, -0.8]),
    ("CENTER", "____ _ ____ _", &[4.0, -0.8, 0.8, -0.8]),
];

/// Colour (AutoCAD colour index) and line type of a layer.
fn layer_look(kind: LineKind) -> (u8, &'static str) {
    match kind {
        LineKind::Part => (7, "CONTINUOUS"),
        LineKind::Stock => (8, "DASHED"),
        LineKind::Ideal => (5, "CENTER"),
        LineKind::Centre => (1, "CENTER"),
    }
}

/// Pairs of group code and value, one line each.
struct Pairs(String);

impl Pairs {
    fn put(&mut self, code: u32, value: impl Display) {
        let _ = write!(self.0, "{code}\n{value}\n");
    }

    fn all(&mut self, pairs: &[(u32, &str)]) {
        pairs.iter().for_each(|(code, value)| self.put(*code, value));
    }

    fn number(&mut self, code: u32, value: f64) {
        self.put(code, Plain(value, DECIMALS));
    }

    /// Writes a point; `code` is the group code of its x.
    fn point(&mut self, code: u32, (x, y): (f64, f64)) {
        self.number(code, x);
        self.number(code + 10, y);
        self.number(code + 20, 0.0);
    }

    /// Starts an entity on a layer.
    fn entity(&mut self, name: &str, layer: &str) {
        self.all(&[(0, name), (8, layer)]);
    }

    fn table(&mut self, name: &str, rows: usize, put: impl FnOnce(&mut Pairs)) {
        self.all(&[(0, "TABLE"), (2, name)]);
        self.put(70, rows);
        put(self);
        self.put(0, "ENDTAB");
    }

    fn section(&mut self, name: &str, put: impl FnOnce(&mut Pairs)) {
        self.all(&[(0, "SECTION"), (2, name)]);
        put(self);
        self.put(0, "ENDSEC");
    }
}

impl Plate {
    /// The plate as DXF; lengths in mm.
    pub fn dxf(&self) -> String {
        let mut out = Pairs(String::new());
        let [left, low, right, high] = self.room;
        out.section("HEADER", |out| {
            out.all(&[(9, "$ACADVER"), (1, "AC1009"), (9, "$INSUNITS"), (70, "4"), (9, "$MEASUREMENT"), (70, "1")]);
            for (name, at) in [("$EXTMIN", (left, low)), ("$EXTMAX", (right, high))] {
                out.put(9, name);
                out.point(10, at);
            }
        });
        out.section("TABLES", |out| self.tables(out));
        out.section("BLOCKS", |out| self.blocks(out));
        out.section("ENTITIES", |out| {
            self.shapes.iter().for_each(|(kind, shape)| entity(out, kind.layer(), shape));
            self.dxf_dimensions(out);
            self.dxf_names(out);
        });
        out.put(0, "EOF");
        out.0
    }

    fn tables(&self, out: &mut Pairs) {
        let [left, low, right, high] = self.room;
        let middle = (0.5 * (left + right), 0.5 * (low + high));
        // Initial view after opening the file.
        out.table("VPORT", 1, |out| {
            out.all(&[(0, "VPORT"), (2, "*ACTIVE"), (70, "0")]);
            for (code, at) in [(10, (0.0, 0.0)), (11, (1.0, 1.0)), (12, middle)] {
                out.number(code, at.0);
                out.number(code + 10, at.1);
            }
            out.number(40, (high - low).max((right - left) / ASPECT));
            out.number(41, ASPECT);
        });
        out.table("LTYPE", LINE_TYPES.len(), |out| {
            for (name, text, dashes) in LINE_TYPES {
                out.all(&[(0, "LTYPE"), (2, name), (70, "0"), (3, text), (72, "65")]);
                out.put(73, dashes.len());
                out.number(40, dashes.iter().map(|dash| dash.abs()).sum());
                dashes.iter().for_each(|dash| out.number(49, *dash));
            }
        });
        out.table("LAYER", LineKind::ALL.len() + 2, |out| {
            let kinds = LineKind::ALL.map(|kind| (kind.layer(), layer_look(kind)));
            for (name, (colour, line_type)) in
                [("0", (7, "CONTINUOUS")), (LAYER, (3, "CONTINUOUS"))].into_iter().chain(kinds)
            {
                out.all(&[(0, "LAYER"), (2, name), (70, "0")]);
                out.put(62, colour);
                out.put(6, line_type);
            }
        });
        out.table("STYLE", 1, |out| {
            out.all(&[(0, "STYLE"), (2, "STANDARD"), (70, "0"), (40, "0"), (41, "1"), (50, "0"), (71, "0")]);
            out.number(42, self.letter);
            out.all(&[(3, "txt"), (4, "")]);
        });
        out.table("DIMSTYLE", 1, |out| {
            out.all(&[(0, "DIMSTYLE"), (2, "STANDARD"), (70, "0")]);
            // Size of the arrow, gap and overshoot of extension lines, height of the text; text above and along the line.
            for (code, part) in [(41, 1.0), (42, 0.3), (44, 0.6), (140, 1.0)] {
                out.number(code, part * self.letter);
            }
            out.all(&[(73, "0"), (74, "0"), (77, "1")]);
        });
    }

    /// Pictures of the dimensions, for programs that do not draw dimensions themselves.
    fn blocks(&self, out: &mut Pairs) {
        for (at, (dimension, drawn)) in self.drawn().enumerate() {
            out.entity("BLOCK", LAYER);
            out.put(2, format_args!("*D{at}"));
            out.put(70, 1);
            out.point(10, (0.0, 0.0));
            out.put(3, format_args!("*D{at}"));
            lines(out, &drawn);
            self.words(out, &dimension.text, drawn.foot, drawn.angle);
            out.entity("ENDBLK", LAYER);
        }
    }

    /// Writes a text centred on its foot.
    fn words(&self, out: &mut Pairs, text: &str, foot: (f64, f64), angle: f64) {
        out.entity("TEXT", LAYER);
        out.point(10, foot);
        out.number(40, self.letter);
        out.put(1, plain(text));
        out.number(50, angle);
        out.put(72, 1);
        out.point(11, foot);
    }

    fn dxf_names(&self, out: &mut Pairs) {
        self.names.iter().for_each(|(name, foot)| self.words(out, name, *foot, 0.0));
    }

    fn dxf_dimensions(&self, out: &mut Pairs) {
        for (at, (dimension, drawn)) in self.drawn().enumerate() {
            out.entity("DIMENSION", LAYER);
            out.put(2, format_args!("*D{at}"));
            out.point(10, drawn.lines[2][1]);
            out.point(11, drawn.middle);
            // Aligned with the two points.
            out.put(70, 1);
            out.put(1, plain(&dimension.text));
            out.point(13, dimension.from);
            out.point(14, dimension.to);
            out.put(3, "STANDARD");
        }
    }
}

fn lines(out: &mut Pairs, drawn: &DrawnDimension) {
    for [from, to] in drawn.lines {
        out.entity("LINE", LAYER);
        out.point(10, from);
        out.point(11, to);
    }
    for [tip, one, other] in drawn.arrows {
        out.entity("SOLID", LAYER);
        for (code, at) in [(10, tip), (11, one), (12, other), (13, other)] {
            out.point(code, at);
        }
    }
}

/// Replaces the diameter sign by its code in release 12.
fn plain(text: &str) -> String {
    text.replace('⌀', "%%c")
}

fn entity(out: &mut Pairs, layer: &str, shape: &OutlineShape) {
    match shape {
        OutlineShape::Circle(centre, radius) => {
            out.entity("CIRCLE", layer);
            out.point(10, *centre);
            out.number(40, *radius);
        }
        OutlineShape::Line(from, to) => {
            out.entity("LINE", layer);
            out.point(10, *from);
            out.point(11, *to);
        }
        OutlineShape::Contour(corners) => {
            out.entity("POLYLINE", layer);
            out.put(66, 1);
            out.point(10, (0.0, 0.0));
            out.put(70, 1);
            for corner in corners {
                out.entity("VERTEX", layer);
                out.point(10, corner.at);
                if corner.bulge != 0.0 {
                    out.number(42, corner.bulge);
                }
            }
            out.entity("SEQEND", layer);
        }
    }
}

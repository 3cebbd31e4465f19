//! A drawing in true millimetres: closed lines and circles on layers, as SVG and as DXF.

use core::fmt::Write;

use crate::math;
use crate::text::number::Plain;

/// A closed line through points, or a circle about the origin.
#[derive(Debug, Clone, PartialEq)]
pub struct OutlineShape {
    /// Layer.
    pub layer: &'static str,
    /// Points in mm, y upwards; none for a circle.
    pub points: Vec<(f64, f64)>,
    /// Radius in mm; 0 for a line.
    pub radius: f64,
}

/// Shapes on one sheet.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outline {
    /// In drawing order.
    pub shapes: Vec<OutlineShape>,
}

/// Decimals of a coordinate in mm.
const DECIMALS: u8 = 6;

impl Outline {
    /// The farthest that anything is from the origin.
    fn reach(&self) -> f64 {
        let far =
            |shape: &OutlineShape| shape.points.iter().map(|(x, y)| math::hypot(*x, *y)).fold(shape.radius, f64::max);
        self.shapes.iter().map(far).fold(0.0, f64::max)
    }

    /// As SVG whose unit is the millimetre: it prints in true size.
    pub fn svg(&self) -> String {
        let edge = self.reach().ceil() + 1.0;
        let (low, size) = (Plain(-edge, 0), Plain(2.0 * edge, 0));
        let mut out = String::new();
        let _ = write!(
            out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{size}mm\" height=\"{size}mm\" viewBox=\"{low} {low} {size} {size}\">\
             <g fill=\"none\" stroke=\"black\" stroke-width=\"0.1\">"
        );
        for shape in &self.shapes {
            let _ = write!(out, "<g id=\"{}\">", shape.layer);
            if shape.points.is_empty() {
                let _ = write!(out, "<circle r=\"{}\"/>", Plain(shape.radius, DECIMALS));
            } else {
                out.push_str("<path d=\"");
                for (at, (x, y)) in shape.points.iter().enumerate() {
                    let letter = if at == 0 { 'M' } else { 'L' };
                    let _ = write!(out, "{letter}{} {}", Plain(*x, DECIMALS), Plain(-*y, DECIMALS));
                }
                out.push_str("Z\"/>");
            }
            out.push_str("</g>");
        }
        out.push_str("</g></svg>\n");
        out
    }

    /// As DXF of release 12, which every program reads: polylines and circles in mm.
    pub fn dxf(&self) -> String {
        let mut out = String::new();
        let mut put = |code: u32, value: &dyn core::fmt::Display| {
            let _ = write!(out, "{code}\n{value}\n");
        };
        for (code, value) in
            [(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009"), (9, "$INSUNITS"), (70, "4")]
        {
            put(code, &value);
        }
        for (code, value) in [(0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")] {
            put(code, &value);
        }
        for shape in &self.shapes {
            if shape.points.is_empty() {
                put(0, &"CIRCLE");
                put(8, &shape.layer);
                for (code, value) in [(10, 0.0), (20, 0.0), (30, 0.0), (40, shape.radius)] {
                    put(code, &Plain(value, DECIMALS));
                }
                continue;
            }
            for (code, value) in [(0, "POLYLINE"), (8, shape.layer), (66, "1"), (70, "1")] {
                put(code, &value);
            }
            for (x, y) in &shape.points {
                put(0, &"VERTEX");
                put(8, &shape.layer);
                put(10, &Plain(*x, DECIMALS));
                put(20, &Plain(*y, DECIMALS));
            }
            put(0, &"SEQEND");
        }
        put(0, &"ENDSEC");
        put(0, &"EOF");
        out
    }
}

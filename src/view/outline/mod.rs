//! A drawing in true millimetres: lines in layers by kind, and dimensions; as SVG and as DXF.

mod dimension;
mod dxf;
mod plate;
mod shapes;
mod svg;

pub use dimension::Dimension;
pub use plate::Plate;
pub use shapes::{LineKind, Outline, OutlineShape, Vertex};

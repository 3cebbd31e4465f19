//! A drawing in true millimetres: lines of kinds that have layers, and dimensions; as SVG and as DXF.

mod dimension;
mod dxf;
mod plate;
mod shapes;
mod svg;

pub use dimension::Dimension;
pub use plate::Plate;
pub use shapes::{LineKind, Outline, OutlineShape, Vertex};

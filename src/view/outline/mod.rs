//! A drawing in true millimetres: lines of kinds that have layers, and dimensions; as SVG and as DXF.

mod dimension;
mod dxf;
mod shapes;
mod svg;

pub use dimension::Dimension;
pub use shapes::{LineKind, Outline, OutlineShape, Vertex};

//! Shapes of a polygon, as the form offers them.

use crate::options;

options! {
    /// Shape of the part; it sets the number of inserts and the ratio.
    pub(crate) enum Shape {
        /// Two inserts at ratio 2.
        Square = "square" "polygon.shape.square",
        /// One insert at ratio 2.
        Knob = "knob" "polygon.shape.knob",
        /// Two inserts at ratio 3:2.
        Triangle = "triangle" "polygon.shape.triangle",
        /// Three inserts at ratio 2.
        Hexagon = "hexagon" "polygon.shape.hexagon",
        /// Inserts and ratio as typed in the form.
        Own = "own" "polygon.shape.own",
    }
}

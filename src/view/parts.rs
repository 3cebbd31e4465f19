//! Parts of a machine for the parts list, each with its place in the drawing.

/// A part: a row of the parts list, and a balloon with its item number in the drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnPart {
    /// Catalog id of its name.
    pub name: &'static str,
    /// Number of pieces.
    pub quantity: u32,
    /// Data of the part: a prefix (`Ø` or empty) and the id of the form field. Hidden fields are omitted.
    pub data: Vec<(&'static str, &'static str)>,
    /// Group of the drawing that it moves with; group 0 never moves.
    pub group: u16,
    /// End of the balloon's leader, in the coordinates of that group.
    pub at: (f64, f64),
}

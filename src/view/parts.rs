//! Parts of a machine as a parts list names them, each with its place in the drawing.

/// A part: a row of the parts list, and a balloon with its item number in the drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnPart {
    /// Catalog id of its name.
    pub name: &'static str,
    /// How many there are.
    pub quantity: u32,
    /// Its data: what stands before each (`Ø`, or nothing), and the id of the field that has it. Fields that the form hides are left out.
    pub data: Vec<(&'static str, &'static str)>,
    /// The group of the drawing that it moves with; 0 never moves.
    pub group: u16,
    /// Where its balloon points, in the coordinates of that group.
    pub at: (f64, f64),
}

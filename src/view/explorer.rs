//! Explorer: values that follow a drag at once, before they are entered in the form.

use super::{Chart, FieldEntry, Scene};

/// A form value as a slider.
#[derive(Debug, Clone, PartialEq)]
pub struct Slider {
    /// Id of the field.
    pub field: &'static str,
    /// Smallest and largest value.
    pub range: (f64, f64),
    /// Step between two values.
    pub step: f64,
    /// Present value.
    pub value: f64,
    /// Other entries that the value needs to be effective.
    pub along: Vec<FieldEntry>,
}

/// Sliders and their consequences.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Explorer {
    /// The sliders; the same fields in the same order for all values.
    pub sliders: Vec<Slider>,
    /// Drawing of the consequences.
    pub scene: Scene,
    /// Charts of the consequences.
    pub charts: Vec<Chart>,
    /// Ids of the results concerned; empty for the headline results.
    pub results: Vec<&'static str>,
}

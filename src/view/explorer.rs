//! Explorer: values that follow a drag at once, before the form takes them.

use super::{Chart, Scene};

/// A value of the form as a slider.
#[derive(Debug, Clone, PartialEq)]
pub struct Knob {
    /// Id of the field.
    pub field: &'static str,
    /// Smallest and largest.
    pub range: (f64, f64),
    /// Between two values.
    pub step: f64,
    /// Present value.
    pub value: f64,
    /// What has to be set with it, so that it means anything: id of a field, and what is typed there.
    pub along: Vec<(&'static str, String)>,
}

/// Sliders and what follows from them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Explorer {
    /// The sliders; the same fields in the same order for all values.
    pub knobs: Vec<Knob>,
    /// What comes of them.
    pub scene: Scene,
    /// The same as numbers over something.
    pub charts: Vec<Chart>,
    /// Ids of the results that it is about; empty for the headline ones.
    pub results: Vec<&'static str>,
}

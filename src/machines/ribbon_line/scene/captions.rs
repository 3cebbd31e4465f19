//! Texts of the ribbon line's drawing whose width sets its layout: names of the stations with their diameters, distance of the dots.

use crate::machines::ribbon_line::params::Params;
use crate::machines::sheets::say;
use crate::text::{detailed, units};

/// Names above unwinder, pull rollers and print roller, with their diameters.
pub(crate) fn names(p: &Params) -> [String; 3] {
    let name = |id: &'static str, axis: &str, diameter: f64| {
        detailed(say(id) + axis, format!("Ø {}", units::dimension(diameter, 1)))
    };
    let print = format!(" {}", p.print_axis.address());
    [
        name("ribbon.scene.unwinder", "", p.press_roller_diameter),
        name("ribbon.scene.pull", "", p.x_roller_diameter),
        name("ribbon.scene.print", &print, p.print_roller_diameter),
    ]
}

/// Distance of two dots.
pub(crate) fn distance(p: &Params) -> String {
    format!("{} {}", say("ribbon.scene.every"), units::text(p.pitch, 3, "mm"))
}

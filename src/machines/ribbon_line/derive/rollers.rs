//! Spacing of the heads and share of the ribbon's thickness, by the diameters of the rollers alone.

use crate::machines::ribbon_line::params::Params;
use crate::math::PI;

impl Params {
    /// Arc (mm) from head to head on the circumference of the print roller.
    pub(in crate::machines::ribbon_line) fn head_spacing(&self) -> f64 {
        PI * self.print_roller_diameter / self.heads
    }

    /// Ribbon that the press roller lays more than the pull roller takes up without a trim, as a share of the line speed, where the diameters
    /// are entered without the ribbon's thickness: `t / D - t / Dx`; 0 for equal rollers. Source: ribbon line facts, 3.
    pub(super) fn share_of_thickness(&self) -> f64 {
        if self.effective_diameter {
            return 0.0;
        }
        self.ribbon_thickness / self.press_roller_diameter - self.ribbon_thickness / self.x_roller_diameter
    }
}

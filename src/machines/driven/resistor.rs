//! Braking with more torque than an inverter can absorb: the demand on a brake resistor.

/// Braking torque (% of the rated one) that an inverter absorbs without a brake resistor. Source: turning spindle
/// facts, 5.
pub const WITHOUT_RESISTOR: f64 = 20.0;

/// Braking of a motor with more torque than its inverter absorbs without a brake resistor.
#[derive(Debug, Clone, PartialEq)]
pub struct ResistorDemand {
    /// Catalog id of the name of its drive.
    pub name: &'static str,
    /// Braking torque of the form, % of the rated one.
    pub percent: f64,
    /// Energies (J) returned while one part is made, one for each time that the drive brakes.
    pub energies: Vec<f64>,
    /// Time (s) from one start to the next.
    pub cycle: f64,
}

impl ResistorDemand {
    /// Mean power, W.
    pub fn power(&self) -> f64 {
        if self.cycle > 0.0 { self.energies.iter().sum::<f64>() / self.cycle } else { 0.0 }
    }

    /// Greatest energy of all, J.
    pub fn greatest(&self) -> f64 {
        self.energies.iter().copied().fold(0.0, f64::max)
    }
}

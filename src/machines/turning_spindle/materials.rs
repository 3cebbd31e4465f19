//! Materials of the part: specific cutting force by the formula of Kienzle.

use super::params::Material;

/// Specific cutting force of a material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Kienzle {
    /// At a chip of 1 mm by 1 mm and a rake angle of 0°, N/mm².
    pub unit_force: f64,
    /// Exponent of the chip thickness.
    pub exponent: f64,
}

/// The row of a material; `None` where the force is entered.
///
/// Source: ISCAR turning catalogue 2017, p.558, read from the text of the page (`reference/turning-spindle.md` 4).
pub(super) fn row(material: Material) -> Option<Kienzle> {
    let (unit_force, exponent) = match material {
        Material::None => return None,
        Material::MildSteel => (1350.0, 0.21),
        Material::C45 => (1500.0, 0.22),
        Material::C45Tempered => (1675.0, 0.24),
        Material::LowAlloy => (1775.0, 0.24),
        Material::LowAlloyTempered => (1725.0, 0.24),
        Material::ToolSteel => (2450.0, 0.23),
        Material::Stainless => (2150.0, 0.20),
        Material::GreyIron => (1350.0, 0.28),
        Material::NodularIron => (1225.0, 0.25),
        Material::Aluminium => (800.0, 0.25),
        Material::Brass => (700.0, 0.27),
        Material::Titanium => (2110.0, 0.22),
    };
    Some(Kienzle { unit_force, exponent })
}

//! Materials of the part, for every machine that cuts: specific cutting force by the formula of Kienzle.

use crate::drives::bending::STEEL;
use crate::drives::cutting::Kienzle;
use crate::options;

options! {
    /// Material of the part, for its specific cutting force.
    pub(crate) enum Material {
        /// The cutting force is entered.
        None = "none" "material.none",
        /// Unalloyed steel below 0.25 % C.
        MildSteel = "mild-steel" "material.mild-steel",
        /// C45, annealed.
        C45 = "c45" "material.c45",
        /// C45, quenched and tempered.
        C45Tempered = "c45-tempered" "material.c45-tempered",
        /// Low alloy steel, annealed: 16MnCr5, 42CrMo4.
        LowAlloy = "low-alloy" "material.low-alloy",
        /// Low alloy steel, tempered.
        LowAlloyTempered = "low-alloy-tempered" "material.low-alloy-tempered",
        /// High alloy and tool steel, annealed.
        ToolSteel = "tool-steel" "material.tool-steel",
        /// Austenitic stainless steel 1.4301.
        Stainless = "stainless" "material.stainless",
        /// Grey iron GJL-250.
        GreyIron = "grey-iron" "material.grey-iron",
        /// Nodular iron GJS-400.
        NodularIron = "nodular-iron" "material.nodular-iron",
        /// Wrought aluminium, cured.
        Aluminium = "aluminium" "material.aluminium",
        /// Brass CuZn39Pb.
        Brass = "brass" "material.brass",
        /// Ti-6Al-4V.
        Titanium = "titanium" "material.titanium",
    }
}

impl Material {
    /// Modulus of elasticity, N/mm²; that of steel where the force is entered. Source: memory (polygon turning facts 3.13).
    pub(crate) fn elasticity(self) -> f64 {
        match self {
            Material::GreyIron => 110_000.0,
            Material::NodularIron => 169_000.0,
            Material::Stainless => 200_000.0,
            Material::Aluminium => 70_000.0,
            Material::Brass => 100_000.0,
            Material::Titanium => 114_000.0,
            _ => STEEL,
        }
    }

    /// The row of a material; `None` where the force is entered.
    ///
    /// Source: ISCAR turning catalogue 2017, p.558, read from the text of the page (`docs/reference/turning-spindle.md` section 4).
    pub(crate) fn kienzle(self) -> Option<Kienzle> {
        let (unit_force, exponent) = match self {
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
}

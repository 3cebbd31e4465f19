//! Units as types, so that a millimetre per minute never meets a second unnoticed at a seam.

use serde::Serialize;

macro_rules! unit {
    ($($(#[$doc:meta])* $name:ident $suffix:literal;)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default, Serialize)]
        #[serde(transparent)]
        pub struct $name(pub f64);

        impl $name {
            /// The unit as it is written behind a number.
            pub const UNIT: &'static str = $suffix;
        }

        impl core::ops::Add for $name {
            type Output = $name;
            fn add(self, other: $name) -> $name {
                $name(self.0 + other.0)
            }
        }

        impl core::ops::Sub for $name {
            type Output = $name;
            fn sub(self, other: $name) -> $name {
                $name(self.0 - other.0)
            }
        }
    )*};
}

unit! {
    /// A length or position in millimetres.
    Mm "mm";
    /// A time in seconds.
    Sec "s";
    /// A speed of rotation in revolutions per minute; negative is M4.
    Rpm "r/min";
    /// A feed in millimetres (or degrees) per minute.
    MmPerMin "mm/min";
    /// A voltage in volts.
    Volt "V";
    /// An angle in degrees.
    Deg "°";
}

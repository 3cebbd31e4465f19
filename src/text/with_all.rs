//! Enums with a constant list of their variants.

/// Defines an enum together with the list of its variants.
macro_rules! with_all {
    ($(#[$about:meta])* pub enum $name:ident { $($(#[$variant_about:meta])* $variant:ident,)+ }) => {
        $(#[$about])*
        pub enum $name {
            $($(#[$variant_about])* $variant,)+
        }

        impl $name {
            /// All variants in order: `ALL[variant as usize]` is the variant.
            pub const ALL: &[$name] = &[$($name::$variant),+];
        }
    };
}

pub(crate) use with_all;

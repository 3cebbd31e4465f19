//! Rows of a form: short spellings of [`Field`](super::Field) and [`Kind`](super::Kind), for every machine.

use crate::controls::Control;

/// A choice of the form; the first is the default.
macro_rules! choice {
    ($(#[$doc:meta])* $name:ident { $(#[$first_doc:meta])* $first:ident, $($(#[$rest_doc:meta])* $rest:ident),* $(,)? }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
        pub enum $name {
            $(#[$first_doc])*
            #[default]
            $first,
            $($(#[$rest_doc])* $rest),*
        }

        impl $name {
            pub(in crate::machines) fn at(index: usize) -> $name {
                [$name::$first, $($name::$rest),*].get(index).copied().unwrap_or_default()
            }
        }
    };
}

choice! {
    /// Line ends.
    Newline {
        /// LF.
        Lf,
        /// CR LF.
        CrLf,
    }
}

/// `number!(member, unit, min..max, default, decimals, step)`: a number.
macro_rules! number {
    ($member:ident, $unit:literal, $min:literal .. $max:literal, $default:literal, $decimals:literal, $step:literal) => {
        $crate::machines::form::Kind::Number {
            unit: $unit,
            min: $min,
            max: $max,
            default: $default,
            decimals: $decimals,
            step: $step,
            get: |p| p.$member,
            set: |p, value| p.$member = value,
        }
    };
}

/// A check mark.
macro_rules! flag {
    ($member:ident) => {
        $crate::machines::form::Kind::Flag { default: false, get: |p| p.$member, set: |p, value| p.$member = value }
    };
}

/// `one_of!(member: Type, "id" "label", …)`: one of a [`choice`].
macro_rules! one_of {
    ($member:ident: $kind:ident, $($option:literal $label:literal),+) => {
        $crate::machines::form::Kind::Choice {
            options: &[$(($option, $label)),+],
            get: |p| p.$member as usize,
            set: |p, index| p.$member = $kind::at(index),
        }
    };
}

/// A short text.
macro_rules! words {
    ($member:ident) => {
        $crate::machines::form::Kind::Text { max: 22, get: |p| &p.$member, set: |p, text| p.$member = text }
    };
}

/// One of the few that define the product, and its variable.
macro_rules! essential {
    ($id:literal, $group:literal, $label:literal, $help:literal, $symbol:literal, fact $fact:literal, $kind:expr) => {
        $crate::machines::form::Field {
            id: $id,
            group: $group,
            label: $label,
            help: $help,
            symbol: $symbol,
            essential: true,
            fact: $fact,
            shown: $crate::machines::form::rows::always,
            kind: $kind,
        }
    };
}

/// A fact of the machine.
macro_rules! fact {
    ($id:literal, $group:literal, $label:literal, $help:literal, $symbol:literal, $kind:expr) => {
        $crate::machines::form::Field {
            id: $id,
            group: $group,
            label: $label,
            help: $help,
            symbol: $symbol,
            essential: false,
            fact: true,
            shown: $crate::machines::form::rows::always,
            kind: $kind,
        }
    };
}

/// A choice of the engineer; `when` says where there is one.
macro_rules! setting {
    ($id:literal, $group:literal, $label:literal, $help:literal, $symbol:literal, $kind:expr) => {
        setting!($id, $group, $label, $help, $symbol, when $crate::machines::form::rows::always, $kind)
    };
    ($id:literal, $group:literal, $label:literal, $help:literal, $symbol:literal, when $shown:path, $kind:expr) => {
        $crate::machines::form::Field {
            id: $id,
            group: $group,
            label: $label,
            help: $help,
            symbol: $symbol,
            essential: false,
            fact: false,
            shown: $shown,
            kind: $kind,
        }
    };
}

/// A field that means something on every control.
pub(in crate::machines) fn always<P>(_: &P, _: &Control) -> bool {
    true
}

pub(in crate::machines) use {choice, essential, fact, flag, number, one_of, setting, words};

//! Rows of a form, read by name: `number("feed", member!(Params.feed)).unit("mm/rev").range(0.001..=10.0).default(0.2)`.
//!
//! A row begins with its kind, its id and the member of the parameters that it fills; everything else has a name.

use core::ops::RangeInclusive;

use super::{Field, FieldKind, FieldRole};
use crate::controls::Control;

/// Getter and setter of a member of the parameters `P`.
pub type Member<P, T> = (fn(&P) -> T, fn(&mut P, T));

/// The options of a choice, and getter and setter of its index.
pub type ChoiceMember<P> = (&'static [(&'static str, &'static str)], Member<P, usize>);

/// Getter and setter of a text.
pub type TextMember<P> = (fn(&P) -> &str, fn(&mut P, String));

/// The member that a row fills: `member!(Params.feed)`, of a choice with its type: `member!(Params.path: Path)`, of a text with `&`.
#[macro_export]
macro_rules! member {
    ($params:ident$(.$member:ident)+) => {
        (|p: &$params| p$(.$member)+, |p: &mut $params, value| p$(.$member)+ = value)
    };
    ($params:ident.$member:ident: $choice:ident) => {
        ($choice::OPTIONS, (|p: &$params| p.$member as usize, |p: &mut $params, at| p.$member = $choice::at(at)))
    };
    (&$params:ident$(.$member:ident)+) => {
        (|p: &$params| p$(.$member)+.as_str(), |p: &mut $params, text| p$(.$member)+ = text)
    };
}

/// The options of a choice, each with its id in projects and the catalog id of its label; the first is the default.
#[macro_export]
macro_rules! options {
    ($(#[$doc:meta])* $vis:vis enum $name:ident {
        $(#[$first_doc:meta])* $first:ident = $first_id:literal $first_label:literal,
        $($(#[$rest_doc:meta])* $rest:ident = $rest_id:literal $rest_label:literal),* $(,)?
    }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
        $vis enum $name {
            $(#[$first_doc])*
            #[default]
            $first,
            $($(#[$rest_doc])* $rest),*
        }

        impl $name {
            /// `(id, catalog id of the label)`.
            $vis const OPTIONS: &'static [(&'static str, &'static str)] =
                &[($first_id, $first_label), $(($rest_id, $rest_label)),*];

            /// The option at an index; the first for an index beyond the last.
            $vis fn at(index: usize) -> $name {
                [$name::$first, $($name::$rest),*].get(index).copied().unwrap_or_default()
            }
        }
    };
}

/// A whole number in steps of 1, without unit and limits until they are set.
pub const fn number<P>(id: &'static str, (get, set): Member<P, f64>) -> Field<P> {
    let (min, max) = (f64::NEG_INFINITY, f64::INFINITY);
    Field::new(id, FieldKind::Number { unit: "", min, max, default: 0.0, decimals: 0, step: 1.0, get, set })
}

/// A check mark, off by default.
pub const fn flag<P>(id: &'static str, (get, set): Member<P, bool>) -> Field<P> {
    Field::new(id, FieldKind::Flag { default: false, get, set })
}

/// A choice between options.
pub const fn choice<P>(id: &'static str, (options, (get, set)): ChoiceMember<P>) -> Field<P> {
    Field::new(id, FieldKind::Choice { options, get, set })
}

/// A short text, 22 characters at most.
pub const fn text<P>(id: &'static str, (get, set): TextMember<P>) -> Field<P> {
    Field::new(id, FieldKind::Text { max: 22, get, set })
}

/// Shown with all parameters on all controls.
fn always<P>(_: &P, _: &Control) -> bool {
    true
}

/// Number of rows in all lists.
pub const fn count<P>(lists: &[&[Field<P>]]) -> usize {
    let (mut count, mut list) = (0, 0);
    while list < lists.len() {
        count += lists[list].len();
        list += 1;
    }
    count
}

/// The rows of all lists as one, in their order; `N` is their [`count`].
pub const fn joined<P, const N: usize>(lists: &[&[Field<P>]]) -> [Field<P>; N] {
    let mut rows = [const { Field::new("", FieldKind::Text { max: 0, get: |_| "", set: |_, _| () }) }; N];
    let (mut count, mut list) = (0, 0);
    while list < lists.len() {
        let mut row = 0;
        while row < lists[list].len() {
            rows[count] = lists[list][row];
            count += 1;
            row += 1;
        }
        list += 1;
    }
    rows
}

impl<P> Field<P> {
    const fn new(id: &'static str, kind: FieldKind<P>) -> Field<P> {
        Field {
            id,
            group: "",
            label: "",
            help: "",
            symbol: "",
            essential: false,
            role: FieldRole::Choice,
            shown: always,
            kind,
        }
    }

    /// Catalog id of its group.
    pub const fn group(mut self, group: &'static str) -> Field<P> {
        self.group = group;
        self
    }

    /// Catalog id of its label.
    pub const fn label(mut self, label: &'static str) -> Field<P> {
        self.label = label;
        self
    }

    /// Catalog id of its help.
    pub const fn help(mut self, help: &'static str) -> Field<P> {
        self.help = help;
        self
    }

    /// Its symbol in formulas, or its variable.
    pub const fn symbol(mut self, symbol: &'static str) -> Field<P> {
        self.symbol = symbol;
        self
    }

    /// Marks a field that defines the product: shown first, and always in a program's header.
    pub const fn essential(mut self) -> Field<P> {
        self.essential = true;
        self
    }

    /// A fact of the machine (measured, from a data sheet or assumed), not a choice of the engineer.
    pub const fn fact(mut self) -> Field<P> {
        self.role = FieldRole::Fact;
        self
    }

    /// A fact that is set, counted or agreed: exact once its value is known.
    pub const fn setting(mut self) -> Field<P> {
        self.role = FieldRole::ExactFact;
        self
    }

    /// Shows the field only where the condition holds; its value stays while it is hidden.
    pub const fn when(mut self, shown: fn(&P, &Control) -> bool) -> Field<P> {
        self.shown = shown;
        self
    }

    /// Unit of a number.
    pub const fn unit(mut self, value: &'static str) -> Field<P> {
        if let FieldKind::Number { unit, .. } = &mut self.kind {
            *unit = value;
        }
        self
    }

    /// Least and greatest value of a number.
    pub const fn range(mut self, range: RangeInclusive<f64>) -> Field<P> {
        if let FieldKind::Number { min, max, .. } = &mut self.kind {
            (*min, *max) = (*range.start(), *range.end());
        }
        self
    }

    /// Default of a number.
    pub const fn default(mut self, value: f64) -> Field<P> {
        if let FieldKind::Number { default, .. } = &mut self.kind {
            *default = value;
        }
        self
    }

    /// Decimals that a number may have; 0 is a whole number.
    pub const fn decimals(mut self, count: u8) -> Field<P> {
        if let FieldKind::Number { decimals, .. } = &mut self.kind {
            *decimals = count;
        }
        self
    }

    /// Step of the arrow keys in a number.
    pub const fn step(mut self, value: f64) -> Field<P> {
        if let FieldKind::Number { step, .. } = &mut self.kind {
            *step = value;
        }
        self
    }

    /// Characters of a text at most.
    pub const fn characters(mut self, count: usize) -> Field<P> {
        if let FieldKind::Text { max, .. } = &mut self.kind {
            *max = count;
        }
        self
    }
}

//! A form as data: fields with unit, range, default and help, and their values.

pub mod common;
pub mod entry;
pub mod fill;
pub mod read;
pub mod rows;
mod shown;

use std::collections::BTreeMap;

use crate::controls::Control;
pub use crate::text::Provenance;

/// A value of a field, as saved.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number in the field's unit.
    Number(f64),
    /// A check mark.
    Flag(bool),
    /// Id of a choice, or free text.
    Text(String),
}

/// Values by field id; a missing one has its default.
pub type Values = BTreeMap<String, Value>;

/// Origins by field id; a missing one is assumed.
pub type Origins = BTreeMap<String, Provenance>;

/// Role of a field's value in the design.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FieldRole {
    /// A choice of the engineer.
    Choice,
    /// A fact of the machine: measured, from a data sheet or assumed.
    Fact,
    /// A fact that is set, counted or agreed, such as a gain or a time constant of an axis. It has a provenance, but no
    /// uncertainty: the sensitivity does not vary it.
    ExactFact,
}

impl FieldRole {
    /// Whether the value is a fact of the machine, which has a provenance.
    pub fn is_fact(self) -> bool {
        self != FieldRole::Choice
    }
}

/// A field of a machine with parameters `P`.
pub struct Field<P: 'static> {
    /// Id in projects, for instance `pitch`.
    pub id: &'static str,
    /// Catalog id of its group.
    pub group: &'static str,
    /// Catalog id of the label.
    pub label: &'static str,
    /// Catalog id of the help.
    pub help: &'static str,
    /// Symbol or variable, for instance `#107`, or empty.
    pub symbol: &'static str,
    /// Whether the field defines the product: shown first, and always in a program's header.
    pub essential: bool,
    /// Choice of the engineer or fact of the machine.
    pub role: FieldRole,
    /// Whether the field is shown with these parameters on this control.
    pub shown: fn(&P, &Control) -> bool,
    /// Kind and limits of its value.
    pub kind: FieldKind<P>,
}

/// Kind of a field, with getter and setter of its member of the parameters.
pub enum FieldKind<P: 'static> {
    /// A number.
    Number {
        /// Unit, or empty.
        unit: &'static str,
        /// Smallest allowed value.
        min: f64,
        /// Largest allowed value.
        max: f64,
        /// Default.
        default: f64,
        /// Decimals allowed; 0 is a whole number.
        decimals: u8,
        /// Step of the arrow keys.
        step: f64,
        /// Reads it.
        get: fn(&P) -> f64,
        /// Writes it.
        set: fn(&mut P, f64),
    },
    /// A check mark.
    Flag {
        /// Default.
        default: bool,
        /// Reads it.
        get: fn(&P) -> bool,
        /// Writes it.
        set: fn(&mut P, bool),
    },
    /// One of several options.
    Choice {
        /// `(id, catalog id of the label)`; the first is the default.
        options: &'static [(&'static str, &'static str)],
        /// Index of the chosen option.
        get: fn(&P) -> usize,
        /// Sets it by index.
        set: fn(&mut P, usize),
    },
    /// A short text, for instance the customer's name, that reaches a program comment.
    Text {
        /// Characters at most.
        max: usize,
        /// Reads it.
        get: fn(&P) -> &str,
        /// Writes it.
        set: fn(&mut P, String),
    },
}

// `derive` would require `P: Clone` and `P: Copy`.
impl<P> Clone for Field<P> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<P> Copy for Field<P> {}

impl<P> Clone for FieldKind<P> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<P> Copy for FieldKind<P> {}

/// A field without the type of its parameters, for pages and reports.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldInfo {
    /// Id.
    pub id: &'static str,
    /// Catalog id of the group.
    pub group: &'static str,
    /// Catalog id of the label.
    pub label: &'static str,
    /// Catalog id of the help.
    pub help: &'static str,
    /// Symbol or variable.
    pub symbol: &'static str,
    /// Shown first.
    pub essential: bool,
    /// Choice or fact: a fact has a provenance.
    pub role: FieldRole,
    /// Kind and limits of its value.
    pub kind: FieldKindInfo,
}

/// Kind and limits of a value.
#[derive(Debug, Clone, PartialEq)]
pub enum FieldKindInfo {
    /// A number.
    Number {
        /// Unit.
        unit: &'static str,
        /// Smallest.
        min: f64,
        /// Largest.
        max: f64,
        /// Default.
        default: f64,
        /// Decimals allowed.
        decimals: u8,
        /// Step of the arrow keys.
        step: f64,
    },
    /// A check mark with its default.
    Flag(bool),
    /// `(id, catalog id of the label)`, the first is the default.
    Choice(&'static [(&'static str, &'static str)]),
    /// A text of at most this many characters.
    Text(usize),
}

impl<P> Field<P> {
    /// The field without `P`.
    pub fn info(&self) -> FieldInfo {
        FieldInfo {
            id: self.id,
            group: self.group,
            label: self.label,
            help: self.help,
            symbol: self.symbol,
            essential: self.essential,
            role: self.role,
            kind: match self.kind {
                FieldKind::Number { unit, min, max, default, decimals, step, .. } => {
                    FieldKindInfo::Number { unit, min, max, default, decimals, step }
                }
                FieldKind::Flag { default, .. } => FieldKindInfo::Flag(default),
                FieldKind::Choice { options, .. } => FieldKindInfo::Choice(options),
                FieldKind::Text { max, .. } => FieldKindInfo::Text(max),
            },
        }
    }
}

impl FieldInfo {
    /// The default value.
    pub fn default(&self) -> Value {
        match &self.kind {
            FieldKindInfo::Number { default, .. } => Value::Number(*default),
            FieldKindInfo::Flag(default) => Value::Flag(*default),
            FieldKindInfo::Choice(options) => {
                Value::Text(options.first().map_or(String::new(), |(id, _)| (*id).to_owned()))
            }
            FieldKindInfo::Text(_) => Value::Text(String::new()),
        }
    }
}

//! Values of fields in the displayed units: conversion, text and range.

use super::{FieldInfo, FieldKindInfo, Value};
use crate::text::catalog::{number_text, words};
use crate::text::{number, units};

/// Least number of decimals of a number's text, so that typed digits stay.
const TYPED: u8 = 6;

impl FieldInfo {
    /// Unit and decimals of a number in the project.
    fn metric(&self) -> (&'static str, u8) {
        match self.kind {
            FieldKindInfo::Number { unit, decimals, .. } => (unit, decimals),
            _ => ("", TYPED),
        }
    }

    /// Displayed unit; empty for a field without unit.
    pub fn unit(&self) -> &'static str {
        units::unit(self.metric().0)
    }

    /// Converts a number from the field's unit to the displayed unit.
    pub fn shown(&self, number: f64) -> f64 {
        units::value(number, self.metric().0)
    }

    /// Converts a number from the displayed unit to the field's unit, rounded to the field's decimals.
    pub fn from_displayed(&self, shown: f64) -> Option<f64> {
        let (unit, decimals) = self.metric();
        number::read(&number_text(units::metric(shown, unit), decimals))
    }

    /// Text of a value in its field; [`read_displayed`](FieldInfo::read_displayed) reads it back unchanged.
    pub fn text(&self, value: &Value) -> String {
        let (unit, decimals) = self.metric();
        match value {
            Value::Number(number) if self.unit() != unit => units::exact(*number, decimals, unit),
            Value::Number(number) => number_text(*number, decimals.max(TYPED)),
            Value::Flag(flag) => flag.to_string(),
            Value::Text(text) => text.clone(),
        }
    }

    /// Formats a value with its unit.
    pub fn text_with_unit(&self, value: &Value) -> String {
        format!("{} {}", self.text(value), self.unit())
    }

    /// The word for a value of a choice or a flag: the label of the option, yes or no.
    pub fn word(&self, value: &Value) -> Option<&'static str> {
        match (&self.kind, value) {
            (FieldKindInfo::Choice(options), Value::Text(id)) => {
                options.iter().find(|(option, _)| option == id).map(|(_, label)| words(label))
            }
            (_, Value::Flag(flag)) => Some(words(if *flag { "form.report.yes" } else { "form.report.no" })),
            _ => None,
        }
    }

    /// A number with the unit that files and programs have, if the displayed unit is another one.
    pub fn metric_text(&self, value: &Value) -> Option<String> {
        let (unit, decimals) = self.metric();
        match value {
            Value::Number(number) if self.unit() != unit => Some(format!("{} {unit}", number_text(*number, decimals))),
            _ => None,
        }
    }

    /// The range of a number with its unit: `0.01 … 10000 mm`.
    pub fn range(&self) -> Option<String> {
        let FieldKindInfo::Number { min, max, .. } = self.kind else { return None };
        let [min, max] = [min, max].map(|limit| self.text(&Value::Number(limit)));
        Some(format!("{min} … {max} {}", self.unit()))
    }
}

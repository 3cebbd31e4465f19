//! Reading the settings in the comments of a program; see [`super::header`]. Programs are upper case, so texts come back in capitals.

use super::header::{CONTROL, MARK};
use crate::machines::form::{FieldInfo, Values};
use crate::machines::list::ALL;
use crate::machines::machine::AnyMachine;

/// Settings found in a program.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// Id of the machine.
    pub machine: &'static str,
    /// Id of the control.
    pub control: &'static str,
    /// Values of the form.
    pub values: Values,
}

/// Settings found in the comments of a program of any listed machine: values that its fields know and allow. `None` without a header.
pub fn read(text: &str) -> Option<Found> {
    read_among(ALL, text)
}

/// Settings found in the comments of a program of one of these machines.
pub fn read_among(machines: &[&dyn AnyMachine], text: &str) -> Option<Found> {
    // Comments are in round brackets, or from a semicolon to the end of the line.
    let mut comments = text.split(['(', ';']).skip(1).filter_map(|tail| tail.split([')', '\n']).next());
    let id = comments.find_map(|comment| {
        let mut words = comment.split_whitespace();
        (words.next() == Some(MARK)).then(|| words.next()).flatten()
    })?;
    let machine = machines.iter().find(|machine| machine.id().eq_ignore_ascii_case(id))?;
    let fields: Vec<FieldInfo> = machine.fields();
    let mut found = Found { machine: machine.id(), control: machine.controls().first()?, values: Values::new() };
    for comment in comments {
        let Some((key, typed)) = comment.split_once('=') else { continue };
        let key = key.trim().to_ascii_lowercase();
        if key == CONTROL {
            let named = machine.controls().iter().find(|id| id.eq_ignore_ascii_case(typed.trim()));
            found.control = named.unwrap_or(&found.control);
            continue;
        }
        let Some(field) = fields.iter().find(|field| field.id == key) else { continue };
        let value = field.read_metric(typed).or_else(|_| field.read_metric(&typed.to_ascii_lowercase()));
        if let Ok(value) = value {
            found.values.insert(key, value);
        }
    }
    Some(found)
}

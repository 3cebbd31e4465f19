//! A machine's settings as comments of a program, so that a dropped program restores the form.
//!
//! The first line names machine and form (`MACROLINE RIBBON-LINE 1`), the next the control where it is not the machine's first
//! (`CONTROL=…`), each further one a field (`PITCH=8`): the essential ones always, the others where they differ from the default.
//! Programs are upper case, so texts come back in capitals.

use super::form::{Field, FieldInfo, Kind, Values};
use super::{Machine, find};
use crate::controls::Control;
use crate::text::catalog::number_text;

/// First word of the first line.
const MARK: &str = "MACROLINE";
/// Form of the lines.
const VERSION: &str = "1";
/// Key of the control's line.
const CONTROL: &str = "control";

/// Comment lines, without brackets, that hold the parameters of a machine on a control.
pub fn write<M: Machine>(params: &M::Params, control: &Control) -> Vec<String> {
    let mut lines = vec![format!("{MARK} {} {VERSION}", M::ID).to_ascii_uppercase()];
    if M::CONTROLS.first() != Some(&control.id) {
        lines.push(format!("{CONTROL}={}", control.id).to_ascii_uppercase());
    }
    let fields: &[Field<M::Params>] = M::fields();
    for field in fields {
        let text = match &field.kind {
            Kind::Number { get, default, decimals, .. } => {
                let number = get(params);
                (field.essential || number != *default).then(|| number_text(number, *decimals))
            }
            Kind::Flag { get, default, .. } => (get(params) != *default).then(|| get(params).to_string()),
            Kind::Choice { options, get, .. } => {
                options.get(get(params)).filter(|_| get(params) != 0).map(|(option, _)| (*option).to_owned())
            }
            Kind::Text { get, .. } => Some(plain(get(params))).filter(|text| !text.is_empty()),
        };
        lines.extend(text.map(|text| format!("{}={}", field.id, text).to_ascii_uppercase()));
    }
    lines
}

/// Text as it may stand inside a comment: printable ASCII without brackets and per cent signs.
fn plain(text: &str) -> String {
    let keep = |c: char| if c.is_ascii_graphic() && !matches!(c, '(' | ')' | '%') { c } else { ' ' };
    text.chars().map(keep).collect::<String>().split_whitespace().collect::<Vec<_>>().join(" ")
}

/// What a program carries.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// Id of the machine.
    pub machine: &'static str,
    /// Id of the control.
    pub control: &'static str,
    /// Values of the form.
    pub values: Values,
}

/// Settings found in the comments of a program: values that the machine's fields know and allow. `None` where the text carries none.
pub fn read(text: &str) -> Option<Found> {
    // In round brackets, or behind a semicolon up to the end of the line.
    let mut comments = text.split(['(', ';']).skip(1).filter_map(|tail| tail.split([')', '\n']).next());
    let id = comments.find_map(|comment| {
        let mut words = comment.split_whitespace();
        (words.next() == Some(MARK)).then(|| words.next()).flatten()
    })?;
    let machine = find(&id.to_ascii_lowercase())?;
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
        let value = field.read(typed).or_else(|_| field.read(&typed.to_ascii_lowercase()));
        if let Ok(value) = value {
            found.values.insert(key, value);
        }
    }
    Some(found)
}

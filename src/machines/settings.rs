//! A machine's settings as comments of a program, so that a dropped program restores the form.
//!
//! The first line names machine and form (`MACROLINE RIBBON-LINE 1`), each further one a field (`PITCH=8`): the essential ones always,
//! the others where they differ from the default. Programs are upper case, so texts come back in capitals.

use super::form::{Field, FieldInfo, Kind, Values};
use crate::text::catalog::number_text;

/// First word of the first line.
const MARK: &str = "MACROLINE";
/// Form of the lines.
const VERSION: &str = "1";

/// Comment lines, without brackets, that hold the parameters of the machine `id`.
pub fn write<P>(id: &str, fields: &[Field<P>], params: &P) -> Vec<String> {
    let mut lines = vec![format!("{MARK} {} {VERSION}", id.to_ascii_uppercase())];
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
    let keep = |c: char| if c.is_ascii_graphic() && !"()%".contains(c) { c } else { ' ' };
    text.chars().map(keep).collect::<String>().split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Settings found in the comments of a program: the machine's id in lower case, and the values that `fields` of that id know and
/// allow. `None` where the text carries none.
pub fn read(text: &str, fields: impl Fn(&str) -> Option<Vec<FieldInfo>>) -> Option<(String, Values)> {
    let mut comments = text.split('(').skip(1).filter_map(|tail| tail.split(')').next());
    let id = comments.find_map(|comment| {
        let mut words = comment.split_whitespace();
        (words.next() == Some(MARK)).then(|| words.next()).flatten()
    })?;
    let id = id.to_ascii_lowercase();
    let fields = fields(&id)?;
    let mut values = Values::new();
    for comment in comments {
        let Some((key, typed)) = comment.split_once('=') else { continue };
        let key = key.trim().to_ascii_lowercase();
        let Some(field) = fields.iter().find(|field| field.id == key) else { continue };
        let value = field.read(typed).or_else(|_| field.read(&typed.to_ascii_lowercase()));
        if let Ok(value) = value {
            values.insert(key, value);
        }
    }
    Some((id, values))
}

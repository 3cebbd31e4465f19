//! A list of parts as JSON: objects with the names of the columns.

use std::collections::BTreeSet;

use serde_json::Value as Json;

use super::columns::{self, COLUMNS};
use super::row::{Cell, Decimals, MAX_PARTS, PAIRS, Rows};
use super::table;
use crate::drives::parts::Part;
use crate::msg;
use crate::project::files::json::{self, JsonMembers};
use crate::text::escape::clip;
use crate::text::{Diagnostic, listed, without_byte_order_mark};

/// Greatest number of unknown names that are listed.
const LISTED: usize = 20;

/// Reads a list of parts.
pub(super) fn read(text: &str) -> (Vec<Part>, Vec<Diagnostic>) {
    let plain = without_byte_order_mark(text);
    match serde_json::from_str::<Vec<JsonMembers>>(plain) {
        Ok(list) => from_members(text, &list),
        Err(error) => {
            let message = if error.is_data() {
                msg!("parts.not-a-list")
            } else {
                msg!("project.not-json", reason = json::reason(&error))
            };
            let mut place = json::error_place(plain, &error);
            let skipped = (text.len() - plain.len()) as u32;
            place.span.start += skipped;
            place.span.end += skipped;
            (Vec::new(), vec![Diagnostic::error(message).at(place)])
        }
    }
}

/// The parts of objects that were read from a text.
pub(in crate::project) fn from_members<'t>(text: &'t str, list: &[JsonMembers<'t>]) -> (Vec<Part>, Vec<Diagnostic>) {
    let mut rows = Rows::new(text, Decimals::default());
    if list.len() > MAX_PARTS {
        rows.found.error(msg!("parts.too-many", most = MAX_PARTS as u32), "");
        return rows.finish();
    }
    let mut unknown = BTreeSet::new();
    for members in list {
        rows.found.repeated(members);
        let mut cells = Vec::new();
        let mut sound = true;
        for member in &members.0 {
            let Some(column) = columns::column(&member.key) else {
                if unknown.len() < LISTED && unknown.insert(member.key.as_str()) {
                    let message = msg!("parts.unknown-column", column = clip(&member.key), columns = listed(COLUMNS));
                    rows.found.error(message, member.source);
                }
                continue;
            };
            let source = member.value.source;
            let text = match &member.value.value {
                Json::Null => None,
                Json::String(text) => Some(text.clone()),
                // The source text of a number keeps its digits.
                Json::Number(_) if columns::is_number(column) => Some(source.to_owned()),
                Json::Array(models) if column == "fits" && models.iter().all(Json::is_string) => {
                    let models: Vec<&str> = models.iter().filter_map(Json::as_str).collect();
                    Some(models.join(&PAIRS.to_string()))
                }
                other => {
                    rows.found.error(msg!("parts.wrong-kind", column, found = json::kind_word(other)), source);
                    sound = false;
                    None
                }
            };
            let text = text.filter(|text| !text.trim().is_empty());
            cells.extend(text.map(|text| Cell { column, text: text.into(), source }));
        }
        // The braces are not in the list: the first key is the place of the object.
        rows.add(&cells, members.0.first().map_or("", |member| member.source), sound);
    }
    rows.finish()
}

/// Entries of a part's object: the known values alone.
pub(in crate::project) fn members(part: &Part) -> JsonMembers<'static> {
    let value = |(column, text): (&'static str, String)| match text.parse() {
        Ok(number) if columns::is_number(column) => (column, json::number(number)),
        _ if column == "fits" => (column, part.fits.clone().into()),
        _ => (column, text.into()),
    };
    table::cells(part).into_iter().map(value).collect()
}

/// The parts as a list in JSON.
pub fn write_json<'p>(parts: impl IntoIterator<Item = &'p Part>) -> String {
    let list: Vec<JsonMembers> = parts.into_iter().map(members).collect();
    // Keys are texts and writing into a text does not fail.
    serde_json::to_string_pretty(&list).unwrap_or_default() + "\n"
}

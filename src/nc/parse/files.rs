//! All files of a program, read one after the other into one deck.

use super::reader::Reader;
use super::tables::Tables;
use crate::controls::{Control, Dialect};
use crate::msg;
use crate::nc::ast::Deck;
use crate::nc::codes::Codes;
use crate::nc::files::Files;
use crate::nc::parsed::PartPlaces;
use crate::text::{Diagnostic, FileId};

/// The tree of all files, and the findings of the blocks; checks of whole programs follow.
#[derive(Debug, Default)]
pub(in crate::nc) struct ReadFiles {
    pub(in crate::nc) deck: Deck,
    pub(in crate::nc) places: PartPlaces,
    pub(in crate::nc) found: Vec<Diagnostic>,
    /// Blocks with calls and jumps in words, whose targets may be in a later file.
    pub(in crate::nc) deferred_checks: Vec<u32>,
}

/// Reads files as on a control with these settings.
pub(in crate::nc) fn read_files(
    files: &Files,
    control: &'static Control,
    dialect: &Dialect,
    codes: &Codes,
) -> ReadFiles {
    let tables = Tables::new(control, dialect, codes);
    let mut all = ReadFiles::default();
    for (index, file) in files.0.iter().enumerate() {
        let Ok(id) = u16::try_from(index) else {
            all.found.push(Diagnostic::error(msg!("nc.too-many-files", most = u32::from(u16::MAX))));
            break;
        };
        if u32::try_from(file.text.len()).is_err() {
            all.found.push(Diagnostic::error(msg!("nc.file-too-large", file = file.name.as_str())));
            continue;
        }
        let mut reader = Reader::new(control, &tables, FileId(id), &file.text, all.deck);
        reader.file.name = &file.name;
        reader.places = all.places;
        reader.reserve();
        reader.file();
        (all.deck, all.places) = (reader.deck, reader.places);
        all.found.append(&mut reader.findings.list);
        all.deferred_checks.append(&mut reader.findings.deferred_checks);
    }
    all
}

//! Text to tree: every file of a program, block by block.

use std::rc::Rc;

use super::advice::programs::programs;
use super::ast::Deck;
use super::codes::Codes;
use super::files::Files;
use super::parse::reader::{FINDINGS, Reader};
use super::parse::tables::Tables;
use super::parsed::{Parsed, PartPlaces};
use crate::controls::{Control, Dialect, Switches};
use crate::msg;
use crate::text::{Diagnostic, FileId};

/// Parses files as on a control with default settings. Total: any text gives a value.
pub fn parse(files: &Files, control: &'static Control) -> Parsed {
    parse_with(files, control, &Switches::default())
}

/// Parses files as on a control with these settings. Total: any text gives a value.
pub fn parse_with(files: &Files, control: &'static Control, switches: &Switches) -> Parsed {
    let dialect = Rc::new(Dialect::resolve(control, switches));
    let codes = Codes::new(control, &dialect);
    let tables = Tables::new(control, &dialect, &codes);
    let mut deck = Deck::default();
    let mut places = PartPlaces::default();
    let mut found = Vec::new();
    let mut later = Vec::new();
    for (index, file) in files.0.iter().enumerate() {
        let Ok(id) = u16::try_from(index) else {
            found.push(Diagnostic::error(msg!("nc.too-many-files", most = u32::from(u16::MAX))));
            break;
        };
        if u32::try_from(file.text.len()).is_err() {
            found.push(Diagnostic::error(msg!("nc.file-too-large", file = file.name.as_str())));
            continue;
        }
        let mut reader = Reader::new(control, &tables, FileId(id), &file.text, deck);
        reader.file.name = &file.name;
        reader.places = places;
        reader.reserve();
        reader.file();
        (deck, places) = (reader.deck, reader.places);
        found.append(&mut reader.findings.list);
        later.append(&mut reader.findings.later);
    }
    programs((&deck, &places), (control, &codes), files, &later, &mut found);
    Diagnostic::in_order(&mut found);
    if found.len() > FINDINGS {
        found.truncate(FINDINGS);
        found.push(Diagnostic::info(msg!("nc.more-findings", most = FINDINGS as u32)));
    }
    deck.shrink();
    places.exprs.shrink_to_fit();
    places.texts.shrink_to_fit();
    Parsed {
        files: files.clone(),
        deck,
        diagnostics: found,
        control,
        switches: switches.clone(),
        dialect,
        codes,
        places,
    }
}

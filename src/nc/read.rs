//! [`Parsed`] from files: text to tree, then the checks of whole programs.

use std::rc::Rc;

use super::checks::programs::check_programs;
use super::codes::Codes;
use super::files::Files;
use super::parse::files::{ReadFiles, read_files};
use super::parsed::{FINDINGS, Parsed};
use crate::controls::{Control, Dialect, Switches};
use crate::msg;
use crate::text::Diagnostic;

/// Parses files as on a control with default settings. Total: any text gives a value.
pub fn parse(files: &Files, control: &'static Control) -> Parsed {
    parse_with(files, control, &Switches::default())
}

/// Parses files as on a control with these settings. Total: any text gives a value.
pub fn parse_with(files: &Files, control: &'static Control, switches: &Switches) -> Parsed {
    let dialect = Rc::new(Dialect::resolve(control, switches));
    let codes = Codes::new(control, &dialect);
    let ReadFiles { mut deck, mut places, mut found, deferred_checks } = read_files(files, control, &dialect, &codes);
    check_programs((&deck, &places), (control, &codes), files, &deferred_checks, &mut found);
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

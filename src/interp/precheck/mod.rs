//! Static pre-check: interprets each block in isolation with constants only and reports the alarms that any run would raise.

mod check;
mod clean;
mod modal_states;
mod statements;
mod words;

use std::cell::RefCell;
use std::rc::Rc;

use super::context::BlockContext;
use super::world::MachineAtRest;
use super::{Interp, StartProgram};
use crate::nc::Parsed;
use crate::text::{Diagnostic, Place};
use check::{Listener, Precheck};

/// Maximum findings in the list.
const FINDINGS: usize = 1000;

/// Number of findings after which only errors are added.
const REMARKS: usize = 200;

/// Alarms and warnings that blocks raise in every run, in text order. Blocks that depend on values of the run, and blocks with an error of
/// the reader, are left out.
pub fn precheck(parsed: &Rc<Parsed>) -> Vec<Diagnostic> {
    let Interp { shared, state } = Interp::new(Rc::clone(parsed), StartProgram::First);
    let deck = parsed.deck();
    let heard = RefCell::new(Vec::new());
    let mut world = Listener { machine: MachineAtRest::default(), heard: &heard };
    let cx = BlockContext { shared: &shared, control: shared.control, deck, world: &mut world, parts: 1.0 };
    let mut check = Precheck::new(cx, state, &heard);
    let errors = parsed.diagnostics().iter().filter(|finding| finding.is_error());
    let errors: Vec<Place> = errors.filter_map(|finding| finding.place).collect();
    let mut found: Vec<Diagnostic> = Vec::new();
    for (index, program) in deck.programs.iter().enumerate() {
        check.state.go_to_program(deck, index as u32);
        for (at, block) in (program.first..).zip(deck.blocks_of(program)) {
            check.block(at, block);
            let here = Place { file: program.file, span: block.span };
            if found.len() >= REMARKS {
                // The remaining room is for errors.
                check.found.retain(|finding| finding.is_error());
            }
            if !check.found.is_empty() && !errors.iter().any(|error| error.meets(here)) {
                found.append(&mut check.found);
            }
            check.found.clear();
            heard.take();
        }
        if found.len() >= FINDINGS {
            found.truncate(FINDINGS);
            break;
        }
    }
    Diagnostic::in_order(&mut found);
    found
}

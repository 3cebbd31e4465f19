//! Warnings about programs that parse: blocks with an effect other than intended.
//!
//! A few linear passes over the tree, each with a budget. Jumps are not followed in programs with errors, and variables named in blocks
//! that do not parse are not checked. In case of doubt there is no warning.

mod again;
mod call_words;
mod context;
mod endless;
mod facts;
mod faulty;
mod feed_unit;
mod feeds;
mod flow;
mod loops;
mod messages;
mod points;
mod position;
mod retract;
mod roles;
mod settings;
mod short;
mod surface_speed;
mod values;
mod vars;
mod word_formula;
mod words;

use super::parsed::Parsed;
use crate::text::Diagnostic;
use context::Lint;
use flow::Flow;
use roles::Roles;
use vars::Vars;

/// The warnings, in text order. `start` is the number of the started program, if known; `set` are variables set by the operator.
pub fn warnings(parsed: &Parsed, start: Option<u32>, set: &[u32]) -> Vec<Diagnostic> {
    let deck = parsed.deck();
    let mut lint = Lint::new(parsed, start, set);
    let roles = Roles::new(lint.control, parsed.codes());
    settings::idle_texts(&mut lint);
    let facts = words::survey(&mut lint, &roles);
    retract::retracts(&mut lint, &roles);
    word_formula::without_brackets(&mut lint);
    if facts.surface {
        surface_speed::surface_speed(&mut lint, &roles, &facts);
    }
    facts.main_returns(&mut lint);
    if !facts.functions {
        let mut flows: Vec<Flow> = Vec::new();
        let each_block = facts.programs.iter().any(|part| part.each_block);
        for program in (0..deck.programs.len()).filter(|&program| facts.programs[program].follows()) {
            let flow = Flow::new(deck, lint.control, &roles, program);
            flow.unreachable(&mut lint, &facts);
            flow.twice(&mut lint, &facts);
            if !each_block {
                endless::endless(&mut lint, &flow);
            }
            flows.push(flow);
        }
        loops::loops(&mut lint, &facts, &flows);
        if !deck.exprs.is_empty() {
            let mut vars = Vars::new(&lint, &facts);
            vars.settle();
            vars.report(&mut lint, &facts);
        }
    }
    let mut found = lint.found;
    Diagnostic::in_order(&mut found);
    found
}

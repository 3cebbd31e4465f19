//! Warnings about programs that parse: blocks that do something other than intended.
//!
//! A few linear looks at the tree, each with a budget. Jumps are not followed in programs with errors, and of variables that stand in blocks
//! that do not read nothing is known. Each warning is meant to be right; where the text leaves a doubt, nothing is said.

mod faulty;
mod flow;
mod loops;
mod messages;
mod retract;
mod roles;
mod settings;
mod short;
mod values;
mod vars;
mod words;

use super::ast::{Deck, ExprId, Word, WordValue};
use super::parsed::Parsed;
use super::program_names::ProgramNames;
use crate::controls::syntax::RoundBrackets;
use crate::controls::{AddressSet, Control};
use crate::text::{Diagnostic, LineIndex, Message, MessageValue, Place, Span};
use flow::Flow;
use roles::Roles;
use vars::Vars;

/// No index, no number.
const NONE: u32 = u32::MAX;

/// Findings that are listed, those of the reader among them.
const FINDINGS: usize = 1000;

struct Lint<'a> {
    parsed: &'a Parsed,
    deck: &'a Deck,
    control: &'static Control,
    start: Option<u32>,
    set: &'a [u32],
    programs: ProgramNames<'a>,
    /// How many are listed at most.
    most: usize,
    /// Words that were told to overwrite others.
    again: usize,
    found: Vec<Diagnostic>,
}

/// The warnings, in the order of the text. `start` is the number of the program that is started, where somebody has said; `set` are
/// variables that the operator sets.
pub fn warnings(parsed: &Parsed, start: Option<u32>, set: &[u32]) -> Vec<Diagnostic> {
    let deck = parsed.deck();
    let programs = ProgramNames::new(deck);
    let most = FINDINGS.saturating_sub(parsed.diagnostics().len());
    let mut lint =
        Lint { parsed, deck, control: parsed.control(), start, set, programs, most, again: 0, found: Vec::new() };
    let roles = Roles::new(lint.control, parsed.codes());
    settings::idle_texts(&mut lint);
    let facts = words::survey(&mut lint, &roles);
    retract::retracts(&mut lint, &roles);
    facts.main_returns(&mut lint);
    if !facts.functions {
        let mut flows: Vec<Flow> = Vec::new();
        for program in (0..deck.programs.len()).filter(|&program| facts.parts[program].follows()) {
            let flow = Flow::new(deck, lint.control, &roles, program);
            flow.unreachable(&mut lint, &facts);
            flow.twice(&mut lint, &facts);
            flows.push(flow);
        }
        loops::loops(&mut lint, &facts, &flows);
        if !deck.exprs.is_empty() {
            let mut vars = Vars::new(&lint, &facts);
            vars.settle();
            vars.tell(&mut lint, &facts);
        }
    }
    let mut found = lint.found;
    Diagnostic::in_order(&mut found);
    found
}

impl Lint<'_> {
    /// Says a sentence about bytes of a block's file; the block is an index in the deck. {0} of the sentence is what stands there, {1}
    /// and so on are `more`. `hint` is the id of another sentence with the same values, or empty.
    fn say(
        &mut self,
        block: u32,
        span: Span,
        id: &'static str,
        more: &[&str],
        hint: &'static str,
    ) -> Option<&mut Diagnostic> {
        let mut place = self.place(block, span);
        // A formula may end in space.
        let mut text = self.parsed.text(place);
        if self.control.syntax.round == RoundBrackets::Comment {
            text = text.split('(').next().unwrap_or(text);
        }
        let text = text.trim_end();
        place.span.end = span.start + text.len() as u32;
        if self.found.len() >= self.most {
            return None;
        }
        let text = [text.trim_matches(['[', ']'])];
        let message =
            |id| Message { id, values: text.iter().chain(more).map(|text| MessageValue::from(*text)).collect() };
        let mut finding = Diagnostic::warning(message(id)).at(place);
        if !hint.is_empty() {
            finding.hints.push(message(hint));
        }
        self.found.push(finding);
        self.found.last_mut()
    }

    /// Bytes of the file of a block.
    fn place(&self, block: u32, span: Span) -> Place {
        let program = self.deck.programs.partition_point(|program| program.end <= block);
        Place { file: self.deck.programs.get(program).map_or_else(Default::default, |program| program.file), span }
    }

    /// The sequence number of a block, with its letter.
    fn number(&self, block: u32) -> Span {
        let span = self.deck.blocks.get(block as usize).map_or_else(Span::default, |block| block.span);
        let text = self.parsed.text(self.place(block, span)).as_bytes();
        let start = text.iter().position(|b| b | 0x20 == b'n').unwrap_or(0);
        let behind = text.get(start + 1..).unwrap_or_default();
        let len = behind.iter().take_while(|b| b.is_ascii_digit() || **b == b' ').count();
        Span::new(span.start + start as u32, span.start + (start + 1 + len).min(text.len()) as u32)
    }

    /// The line that a block stands in, from 1.
    fn line(&self, block: u32) -> String {
        let span = self.deck.blocks.get(block as usize).map_or_else(Span::default, |block| block.span);
        let file = self.parsed.files().get(self.place(block, span).file);
        file.map_or(1, |file| LineIndex::new(&file.text).line_of(span.start)).to_string()
    }

    /// A part of a formula of a block; the block where it is not found again.
    fn part(&self, block: u32, part: ExprId) -> Span {
        let span = self.deck.blocks.get(block as usize).map_or_else(Span::default, |block| block.span);
        self.parsed.expr_span(self.place(block, span), part).unwrap_or(span)
    }

    /// Addresses whose number counts increments without a point: for dimensions, and for arguments of macros.
    fn increments(&self) -> [AddressSet; 2] {
        let numbers = &self.parsed.dialect().numbers;
        let none = AddressSet::EMPTY;
        let counting = if numbers.whole_units { none } else { self.control.syntax.increment_addresses };
        [counting, if numbers.argument_increments { counting } else { none }]
    }
}

/// The number of a word, `least` for each increment that it counts ([`Lint::increments`]); `None` where it is calculated.
fn measure(word: &Word, increments: AddressSet, least: f64) -> Option<f64> {
    let WordValue::Number(dec) = word.value else { return None };
    let counts = !dec.point && increments.contains(word.letter);
    Some(if counts { dec.to_f64() * least } else { dec.to_f64() })
}

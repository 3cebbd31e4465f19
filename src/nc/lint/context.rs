//! [`Lint`]: the programs under check and the warnings so far.

use super::super::ast::{Deck, ExprId, Word, WordValue};
use super::super::dec::{Dec, POW10};
use super::super::parsed::{FINDINGS, Parsed};
use super::super::program_names::ProgramNames;
use crate::controls::syntax::RoundBrackets;
use crate::controls::{Address, AddressSet, Control};
use crate::text::{Diagnostic, DiagnosticKind, FileId, Fix, LineIndex, Message, Place, Span};

/// The programs under check and the warnings so far.
pub(super) struct Lint<'a> {
    pub(super) parsed: &'a Parsed,
    pub(super) deck: &'a Deck,
    pub(super) control: &'static Control,
    /// Number of the started program, if known.
    pub(super) start: Option<u32>,
    /// Variables set by the operator.
    pub(super) set: &'a [u32],
    pub(super) programs: ProgramNames<'a>,
    /// Maximum warnings in the list.
    most: usize,
    /// Number of words reported for overwriting others.
    pub(super) again: usize,
    pub(super) found: Vec<Diagnostic>,
    /// Cache: the lines of the last requested file.
    lines: Option<(FileId, LineIndex)>,
}

impl<'a> Lint<'a> {
    /// Context without warnings.
    pub(super) fn new(parsed: &'a Parsed, start: Option<u32>, set: &'a [u32]) -> Lint<'a> {
        let deck = parsed.deck();
        Lint {
            parsed,
            deck,
            control: parsed.control(),
            start,
            set,
            programs: ProgramNames::new(deck),
            most: FINDINGS.saturating_sub(parsed.diagnostics().len()),
            again: 0,
            found: Vec::new(),
            lines: None,
        }
    }

    /// Whether the list of warnings is full.
    pub(super) fn is_full(&self) -> bool {
        self.found.len() >= self.most
    }

    /// Place and text of bytes of a block (by index in the deck), without trailing space and comment, and without enclosing square
    /// brackets.
    pub(super) fn written(&self, block: u32, span: Span) -> (Place, &'a str) {
        let mut place = self.place(block, span);
        // The span of a formula may include trailing space.
        let mut text = self.parsed.text(place);
        if self.control.syntax.round == RoundBrackets::Comment {
            text = text.split('(').next().unwrap_or(text);
        }
        let text = text.trim_end();
        place.span.end = span.start + text.len() as u32;
        (place, without_brackets(text))
    }

    /// Place and text of the word with a letter in a block; of the block if it has no such word.
    pub(super) fn written_word(&self, block: u32, words: &[Word], letter: Address) -> (Place, &'a str) {
        let Some(row) = self.deck.blocks.get(block as usize) else { return Default::default() };
        let span = words.iter().find(|word| word.letter == letter).map_or(row.span, |word| word.span(row));
        self.written(block, span)
    }

    /// Adds a warning.
    pub(super) fn warn(&mut self, place: Place, message: Message) -> Option<&mut Diagnostic> {
        if self.is_full() {
            return None;
        }
        self.found.push(Diagnostic::warning(message).kind(DiagnosticKind::Lint).at(place));
        self.found.last_mut()
    }

    /// Adds a fix to the last finding: another text for each of these words of its file; none if a comment is inside one of them.
    pub(super) fn fix(&mut self, title: Message, words: &[(Span, Dec)], text: &dyn Fn(Dec) -> String) {
        if let Some(finding) = self.found.last_mut()
            && let Some(place) = finding.place
        {
            let comment = |span: Span| self.parsed.text(Place { span, ..place }).contains('(');
            if words.iter().any(|word| comment(word.0)) {
                return;
            }
            let edits = words.iter().map(|&(span, dec)| (Place { span, ..place }, text(dec))).collect();
            finding.fixes.push(Fix { title, edits });
        }
    }
    /// Place of a span in the file of a block.
    pub(super) fn place(&self, block: u32, span: Span) -> Place {
        let program = self.deck.programs.partition_point(|program| program.end <= block);
        Place { file: self.deck.programs.get(program).map_or_else(Default::default, |program| program.file), span }
    }

    /// Span of a block's sequence number, with its letter.
    pub(super) fn number(&self, block: u32) -> Span {
        self.deck.blocks.get(block as usize).map_or_else(Span::default, |block| block.number_at.span(block))
    }

    /// Line of a block, from 1.
    pub(super) fn line(&mut self, block: u32) -> String {
        let span = self.deck.blocks.get(block as usize).map_or_else(Span::default, |block| block.span);
        let id = self.place(block, span).file;
        let known = self.lines.take().filter(|known| known.0 == id);
        let text = || self.parsed.files().get(id).map_or("", |file| file.text.as_str());
        let (_, lines) = self.lines.insert(known.unwrap_or_else(|| (id, LineIndex::new(text()))));
        lines.line_of(span.start).to_string()
    }

    /// Span of a part of a formula; the block's span if unknown.
    pub(super) fn part(&self, block: u32, part: ExprId) -> Span {
        let span = self.deck.blocks.get(block as usize).map_or_else(Span::default, |block| block.span);
        self.parsed.expr_span(self.place(block, span), part).unwrap_or(span)
    }

    /// Addresses whose numbers count increments without a point: in dimensions, and in macro arguments.
    pub(super) fn increments(&self) -> [AddressSet; 2] {
        let numbers = &self.parsed.dialect().numbers;
        let none = AddressSet::EMPTY;
        let counting = if numbers.whole_units { none } else { self.control.syntax.increment_addresses };
        [counting, if numbers.argument_increments { counting } else { none }]
    }
}

/// Number of a word, multiplied by `least` if it counts increments ([`Lint::increments`]); `None` if calculated.
pub(super) fn measure(word: &Word, increments: AddressSet, least: f64) -> Option<f64> {
    let WordValue::Number(dec) = word.value else { return None };
    let counts = !dec.point && increments.contains(word.letter);
    Some(if counts { dec.to_f64() * least } else { dec.to_f64() })
}

/// A text without the square brackets that enclose all of it: `#1` of `[#1]`, and all of `X-[#1]` and `[#1]*[#2]`.
fn without_brackets(text: &str) -> &str {
    let Some(inner) = text.strip_prefix('[').and_then(|text| text.strip_suffix(']')) else { return text };
    let mut depth = 0_i32;
    let paired = inner.bytes().all(|byte| {
        depth += i32::from(byte == b'[') - i32::from(byte == b']');
        depth >= 0
    });
    if paired && depth == 0 { without_brackets(inner) } else { text }
}

/// The value of a whole number written as such.
pub(super) fn whole(value: WordValue) -> Option<u32> {
    let WordValue::Number(dec) = value else { return None };
    let unit = POW10[dec.scale.min(18) as usize];
    if dec.mantissa % unit == 0 { u32::try_from(dec.mantissa / unit).ok() } else { None }
}

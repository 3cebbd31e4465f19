//! Checks of whole programs: jump targets, calls, the last block, several programs of one number.

use std::collections::BTreeSet;

use super::context::Check;
use super::jump_targets::JumpTargets;
use crate::controls::{Address, Alarm, Code, CodeId, Control};
use crate::msg;
use crate::nc::ast::{Block, Deck, Expr, Program, Stmt, WordValue};
use crate::nc::codes::{Codes, m_number};
use crate::nc::dec::Dec;
use crate::nc::files::Files;
use crate::nc::lex::keywords::KEYWORDS;
use crate::nc::lex::spelling::{holds_macro, holds_word, keyword_in_prose, prose};
use crate::nc::parsed::PartPlaces;
use crate::nc::program_names::{ProgramNames, split_repeats};
use crate::nc::unread;
use crate::text::lines::line_end;
use crate::text::{Diagnostic, DiagnosticKind, Place, Span};

/// Addresses that may name a sequence number.
const NAMING: [Address; 2] = [Address::P, Address::H];

/// Checks every program. `deferred_checks` are the blocks with calls and jumps in words, checked once all files are read.
pub(in crate::nc) fn check_programs(
    (deck, places): (&Deck, &PartPlaces),
    (control, codes): (&Control, &Codes),
    files: &Files,
    deferred_checks: &[u32],
    found: &mut Vec<Diagnostic>,
) {
    let known = ProgramNames::new(deck);
    let without_do = |(finding, at): (&Diagnostic, usize)| {
        finding.place.filter(|_| finding.kind == DiagnosticKind::WhileWithoutDo).map(|place| (place, at))
    };
    let without_do = found.iter().zip(0..).filter_map(without_do).collect();
    for (program, repeated) in deck.programs.iter().zip(repeated(deck)) {
        let text = files.get(program.file).map_or("", |file| file.text.as_str());
        let blocks = deck.blocks_of(program);
        let targets = JumpTargets::new(deck, control, blocks, text);
        let mut check = Check {
            deck,
            places,
            known: &known,
            control,
            codes,
            program,
            blocks,
            text,
            targets,
            without_do: &without_do,
            found,
        };
        if check.is_full() {
            return;
        }
        check.loops();
        match control.syntax.names() {
            Some(_) => check.symbolic(),
            None => check.numbered_jumps(),
        }
        check.end();
        let from = deferred_checks.get(deferred_checks.partition_point(|&at| at < program.first)..).unwrap_or_default();
        for block in from.iter().take_while(|&&at| at < program.end) {
            if let Some(block) = deck.blocks.get(*block as usize) {
                check.sub_call(block);
                check.function_jump(block);
            }
        }
        if repeated {
            let place = Place { file: program.file, span: program.span };
            let name = program.name.map(|name| deck.text(Some(name)).to_owned());
            let message = msg!("nc.program-twice", program = name.unwrap_or_else(|| format!("O{}", program.number)));
            check.found.push(Diagnostic::warning(message).at(place));
        }
    }
}

/// For each program of the deck in order: whether an earlier one has the same number, or the same name in a language with names.
fn repeated(deck: &Deck) -> Vec<bool> {
    let mut known = BTreeSet::new();
    let repeats = |program: &Program| {
        let name = deck.text(program.name);
        let identified = program.number != 0 || !name.is_empty();
        identified && !known.insert((program.number, program.sub, name))
    };
    deck.programs.iter().map(repeats).collect()
}

impl Check<'_> {
    /// Checks jumps to constant numbers that are missing in the program.
    fn numbered_jumps(&mut self) {
        for block in self.blocks {
            let (Stmt::If { target, .. } | Stmt::Goto { target, .. }) = block.stmt else { continue };
            let Expr::Number(number) = self.deck.expr(target) else { continue };
            if !self.targets.has_number(number) {
                self.no_target(Alarm::GotoTarget, number, self.expr_span(block, target));
            }
        }
    }

    fn no_target(&mut self, missing: Alarm, number: Dec, span: Span) {
        if !self.is_full() {
            let numbers = self.control.syntax.sequence_numbers();
            if numbers.contains(&number.to_f64()) {
                self.report(missing, span, msg!("nc.no-such-sequence", block = format!("N{number}")));
            } else {
                let (least, most) = (numbers.start, numbers.end - 1.0);
                self.report(Alarm::JumpNumber, span, msg!("nc.jump-range", number = (number.to_f64(), 9), least, most));
            }
        }
    }

    /// The last word with this letter and a constant number, and its span.
    fn number_word(&self, block: &Block, letter: Address) -> Option<(Dec, Span)> {
        let word = self.deck.words_of(block).iter().rfind(|word| word.letter == letter)?;
        match word.value {
            WordValue::Number(number) => Some((number, word.span(block))),
            WordValue::Expr(_) => None,
        }
    }

    /// `M98 P21000` on a control with repeats in L calls O21000; reported if only O1000 exists.
    fn sub_call(&mut self, block: &Block) {
        let Some((number, span)) = self.number_word(block, Address::P).filter(|_| !self.control.macros.repeats_in_p)
        else {
            return;
        };
        let program = |number: i64| u32::try_from(number).is_ok_and(|number| self.known.number(number).is_some());
        let (repeats, called) = split_repeats(number.mantissa);
        let call = self.number_word(block, Address::M).is_some_and(|(code, _)| self.is_code(code, Code::SubCall));
        let has_count = self.number_word(block, Address::L).is_some();
        if !call || has_count || number.scale > 0 || repeats == 0 || program(number.mantissa) || !program(called) {
            return;
        }
        let place = Place { file: self.program.file, span };
        let right = format!("P{called} L{repeats}");
        let message = msg!(
            "nc.repeats-in-p",
            word = format!("P{number}"),
            program = format!("O{number}"),
            correct = right.as_str()
        );
        let finding = Diagnostic::warning(message).at(place);
        self.found.push(finding.fix(msg!("nc.fix.write", text = right.as_str()), vec![(place, right.clone())]));
    }

    /// Checks `G65 H80 P` and the like for a number that is missing in the program.
    fn function_jump(&mut self, block: &Block) {
        let Some((function, (number, span))) =
            self.number_word(block, Address::H).zip(self.number_word(block, Address::P))
        else {
            return;
        };
        let row = self.control.macros.functions.iter().find(|row| f64::from(row.0) == function.0.to_f64());
        if row.is_some_and(|row| row.1.jumps()) && !self.targets.has_number(number) {
            self.no_target(Alarm::NoSequence, number, span);
        }
    }

    /// Whether the M code with this number has this meaning.
    fn is_code(&self, number: Dec, code: Code) -> bool {
        let id = m_number(number).filter(|_| number.scale == 0).map(CodeId::M);
        id.and_then(|id| self.codes.row(id)).is_some_and(|row| row.code == code)
    }

    /// Reports a program that runs out of blocks.
    fn end(&mut self) {
        let blocks = self.blocks;
        let comment = |block: &&Block| {
            let empty = block.stmt == Stmt::Empty && block.number.is_none();
            // A remark without brackets is reported as such, and is no block behind the end.
            empty || matches!(block.stmt, Stmt::Bad(_)) && is_remark(block.span.of(self.text).as_bytes())
        };
        let mut last = blocks.iter().rev().find(|block| !comment(block));
        // A sequence number alone behind M30, and no jump to it.
        if last.is_some_and(|block| block.stmt == Stmt::Empty)
            && let Some(named) = self.named_numbers()
        {
            let idle = |block: &&Block| {
                block.stmt == Stmt::Empty && block.number.is_none_or(|number| !named.contains(&number))
            };
            last = blocks.iter().rev().find(|block| !idle(block));
        }
        if last.is_some_and(|block| !self.falls_through(blocks, block)) {
            return;
        }
        let span = last.or(blocks.last()).map_or(self.program.span, |block| block.span);
        let after = self.text.get(span.end as usize..).unwrap_or("");
        let line = after.find('\n').unwrap_or(after.len());
        let newline = line_end(self.text);
        let tail = after.get(..line).unwrap_or("");
        // A `;` may end the block, and another program may begin after it in the same line; a `%` there ends the record.
        let more = tail.trim_ascii_start().strip_prefix(';').is_some_and(|rest| !rest.trim_ascii().is_empty());
        let at = if (more || tail.trim_ascii_end().ends_with('%')) && self.control.syntax.names().is_none() {
            span.end
        } else {
            span.end + tail.strip_suffix('\r').unwrap_or(tail).len() as u32
        };
        let place = Place { file: self.program.file, span };
        let insert = Place { file: self.program.file, span: Span::at(at) };
        let shown = self.control.alarm_shown(Alarm::NoProgramEnd);
        let mut finding =
            Diagnostic::error(msg!("nc.no-program-end", code = self.control.program_ends())).at(place).alarm(shown);
        // Standard programs of machine builder and user are subprograms: a return is their more likely end.
        let called = self.program.number >= 8000 || self.program.sub;
        let ends = if called { [Code::SubEnd, Code::EndRewind] } else { [Code::EndRewind, Code::SubEnd] };
        for end in ends {
            let Some(row) = self.control.codes.iter().find(|row| row.code == end) else { continue };
            let code = self.control.code_name(row.id);
            let title = match end {
                Code::SubEnd => msg!("nc.fix.end-sub", code = code.as_str()),
                _ => msg!("nc.fix.end-main", code = code.as_str()),
            };
            finding = finding.fix(title, vec![(insert, format!("{newline}{code}"))]);
        }
        self.found.push(finding);
    }

    /// The sequence numbers that jumps and the words P and H of the program name; `None` if one of them is calculated.
    fn named_numbers(&self) -> Option<BTreeSet<u32>> {
        let mut named = BTreeSet::new();
        let mut name = |number: Dec| named.extend(u32::try_from(number.mantissa).ok().filter(|_| number.scale == 0));
        for block in self.blocks {
            match block.stmt {
                Stmt::If { target, .. } | Stmt::Goto { target, .. } => match self.deck.expr(target) {
                    Expr::Number(number) => name(number),
                    _ => return None,
                },
                Stmt::Words { .. } => {
                    for word in self.deck.words_of(block).iter().filter(|word| NAMING.contains(&word.letter)) {
                        let WordValue::Number(number) = word.value else { return None };
                        name(number);
                    }
                }
                Stmt::Bad(_) => return None,
                _ => {}
            }
        }
        Some(named)
    }

    /// Whether the program continues after a block.
    fn falls_through(&self, blocks: &[Block], block: &Block) -> bool {
        match block.stmt {
            Stmt::Words { .. } => !self.deck.words_of(block).iter().any(|word| match word.value {
                WordValue::Number(_) if word.letter == Address::Name => {
                    self.codes.row_of(word).is_some_and(|row| row.code == Code::Return)
                }
                WordValue::Number(number) if word.letter == Address::M => {
                    [Code::End, Code::EndRewind, Code::SubEnd].iter().any(|end| self.is_code(number, *end))
                }
                _ => false,
            }),
            Stmt::Goto { .. } => false,
            // A loop without a condition never continues after its END.
            Stmt::End { label, .. } => {
                let heads = blocks.iter().rev().find_map(|block| match block.stmt {
                    Stmt::While { cond, label: other, .. } if other == label => Some(cond),
                    _ => None,
                });
                heads.is_none_or(|cond| cond.is_some_and(|cond| self.deck.holds(cond) != Some(true)))
            }
            Stmt::Assign { to, .. } => !self.deck.raises_alarm(self.control, to),
            Stmt::Bad(_) => {
                let codes = unread::codes(block.span.of(self.text), self.control);
                let ends = |id: &CodeId| {
                    let code = self.codes.row(*id).map(|row| row.code);
                    matches!(code, Some(Code::End | Code::EndRewind | Code::SubEnd | Code::Return))
                };
                !codes.iter().any(ends)
            }
            _ => true,
        }
    }
}

/// Whether the text of a block that does not parse is a remark without brackets, with no word or statement in it.
fn is_remark(text: &[u8]) -> bool {
    (prose(text) || keyword_in_prose(text, &KEYWORDS)) && !holds_macro(text) && !holds_word(text)
}

//! Facts about all programs for the checks: calls, returns, ends and errors.

use std::collections::BTreeSet;

use super::super::ast::Word;
use super::super::dec::Dec;
use super::super::program_names::split_repeats;
use super::context::{Lint, whole};
use super::roles::{CALL, EACH_BLOCK, END, RETURN, Roles, SUB};
use crate::controls::{Address, Alarm, Code};
use crate::msg;
use crate::text::Severity;

/// First number of the standard programs of machine builder and user, which are on the machine and are called.
const STANDARD: u32 = 8000;

/// Maximum missing programs in the warnings.
const MISSED: usize = 100;

/// Facts about one program.
#[derive(Clone, Copy, Default)]
pub(super) struct ProgramFacts {
    /// It has a program end.
    pub(super) ends: bool,
    /// A program of these files calls it.
    pub(super) called: bool,
    /// The words of blocks are its arguments.
    pub(super) each_block: bool,
    /// A block may continue elsewhere than at the next block.
    pub(super) bends: bool,
    /// It has an error.
    pub(super) faulty: bool,
    /// Number of returns (`M99`), and the block of the last one.
    returns: u32,
    return_at: u32,
}

impl ProgramFacts {
    /// Whether the jumps of the program are followed: it has jumps and no errors.
    pub(super) fn follows(&self) -> bool {
        self.bends && !self.faulty
    }
}

/// A call of a program by its number.
#[derive(Clone, Copy)]
pub(super) struct Call {
    pub(super) block: u32,
    /// Indices of caller and called program.
    pub(super) from: u32,
    pub(super) to: u32,
    /// With arguments; otherwise as a subprogram that shares its caller's local variables.
    pub(super) with_locals: bool,
}

/// Facts from one pass over all words.
#[derive(Default)]
pub(super) struct Facts {
    /// One per program.
    pub(super) programs: Vec<ProgramFacts>,
    /// Calls in the order of the blocks.
    pub(super) calls: Vec<Call>,
    /// A program is called by a calculated number, so any may be called.
    pub(super) any_called: bool,
    /// Sequence numbers used by calls and returns, with the program; `None` for any program.
    pub(super) entries: BTreeSet<(Option<u32>, u32)>,
    /// A call or return goes to a calculated sequence number.
    pub(super) any_entry: bool,
    /// Numbers of called programs that are missing in the files.
    pub(super) missed: Vec<u32>,
    /// Blocks that do not parse, with the indices of their programs.
    pub(super) bad: Vec<(u32, u32)>,
    /// Variables and jumps are used by `G65 H`, which these checks do not follow.
    pub(super) functions: bool,
    /// A program switches constant surface speed on.
    pub(super) surface: bool,
}

impl Facts {
    /// Records calls, returns and ends of a block, both by index.
    pub(super) fn note(
        &mut self,
        lint: &mut Lint,
        roles: &Roles,
        (program, block): (u32, u32),
        words: &[Word],
        bits: u32,
    ) {
        let number = |letter: Address| words.iter().find(|word| word.letter == letter).map(|word| whole(word.value));
        let Some(part) = self.programs.get_mut(program as usize) else { return };
        part.ends |= bits & END != 0;
        if bits & RETURN != 0 {
            part.returns += 1;
            part.return_at = block;
            self.entry(None, number(Address::P));
        }
        let macros = &lint.control.macros;
        if bits & CALL != 0 && !macros.functions.is_empty() && number(Address::H).is_some() {
            self.functions = true;
        } else if bits & (CALL | SUB) != 0 {
            let sub = bits & SUB != 0;
            let to = match (roles.called(words), number(Address::P)) {
                (Some((word, number)), _) => {
                    let to = lint.programs.number(number);
                    if to.is_none() {
                        self.missing(lint, (block, word), number);
                    }
                    to
                }
                (None, Some(Some(number))) => {
                    let called = if sub && macros.repeats_in_p { split_repeats(number).1 } else { number };
                    let to = lint.programs.number(called);
                    // The reader reports repeats in P.
                    let is_missing =
                        to.is_none() && (called <= 9999 || lint.programs.number(split_repeats(called).1).is_none());
                    if let Some(word) = words.iter().find(|word| is_missing && word.letter == Address::P) {
                        self.missing(lint, (block, word), called);
                    }
                    to
                }
                (None, None) => {
                    if sub && macros.sub_sequence && number(Address::H).is_none() {
                        let (place, code) = lint.written_word(block, words, Address::M);
                        lint.warn(place, msg!("lint.calls-itself", code));
                    }
                    sub.then_some(program)
                }
                (None, Some(None)) => {
                    self.any_called = true;
                    None
                }
            };
            if sub && macros.sub_sequence {
                self.entry(to, number(Address::H));
            }
            if let Some(to) = to
                && let Some(part) = self.programs.get_mut(to as usize)
            {
                part.each_block |= bits & EACH_BLOCK != 0;
                self.call(Call { block, from: program, to, with_locals: !sub });
            }
        }
    }

    /// Reports a call of a program that is missing in the files, each program once. Programs from 8000 on are standard programs of machine
    /// builder and user, which are on the machine.
    fn missing(&mut self, lint: &mut Lint, (block, word): (u32, &Word), number: u32) {
        if !self.missed.contains(&number) && self.missed.len() < MISSED {
            self.missed.push(number);
            let alarm = lint.control.alarm_number(Alarm::NoProgram).unwrap_or("");
            let Some(row) = lint.deck.blocks.get(block as usize) else { return };
            let (place, _) = lint.written(block, word.span(row));
            let finding = lint.warn(place, msg!("lint.no-such-program", program = format!("O{number}"), alarm));
            if let Some(finding) = finding.filter(|_| number >= STANDARD) {
                finding.severity = Severity::Info;
            }
        }
    }

    pub(super) fn call(&mut self, call: Call) {
        if let Some(part) = self.programs.get_mut(call.to as usize) {
            // A call by the program itself is not a call from elsewhere.
            part.called |= call.to != call.from;
            self.calls.push(call);
        }
    }

    /// Records the sequence number in P of a return or in H of a call.
    fn entry(&mut self, program: Option<u32>, number: Option<Option<u32>>) {
        match number {
            Some(Some(label)) => drop(self.entries.insert((program, label))),
            Some(None) => self.any_entry = true,
            None => {}
        }
    }

    /// Whether a call or return goes to a sequence number of a program.
    pub(super) fn enters(&self, program: u32, number: u32) -> bool {
        self.any_entry || [Some(program), None].into_iter().any(|program| self.entries.contains(&(program, number)))
    }

    /// Reports a main program that returns, and so restarts for ever: the started program, if known; else the first one, if no program here
    /// has an end and none is called by a calculated number.
    pub(super) fn main_returns(&self, lint: &mut Lint) {
        if lint.control.macros.main_ends {
            return;
        }
        let ends = self.any_called || self.programs.iter().any(|part| part.ends);
        let main = match lint.start {
            Some(number) => lint.programs.number(number),
            None => lint.deck.programs.first().filter(|row| row.number < STANDARD && !ends).map(|_| 0),
        };
        let end = lint.control.codes.iter().find(|row| row.code == Code::EndRewind);
        if let (Some(main), Some(end)) = (main, end)
            && let Some(part) = self.programs.get(main as usize)
            && part.returns > 0
            && !part.faulty
            && !part.called
            && !part.ends
            && let Some(block) = lint.deck.blocks.get(part.return_at as usize)
            && let Some(word) = lint.deck.words_of(block).iter().find(|word| word.letter == Address::M)
        {
            let span = word.span(block);
            let end = lint.control.code_name(end.id);
            let (place, code) = lint.written(part.return_at, span);
            lint.warn(place, msg!("lint.main-returns", code, end = end.as_str()));
            if part.returns == 1 {
                lint.fix(msg!("nc.fix.end-main", code = end.as_str()), &[(span, Dec::default())], &|_| end.clone());
            }
        }
    }
}

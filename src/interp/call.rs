//! Subprograms and macros: calls, arguments, returns.

use std::rc::Rc;

use super::fault::{Run, Trap};
use super::state::{Cx, State};
use super::vars::{LOCALS, Locals, VACANT};
use crate::controls::Alarm;
use crate::msg;
use crate::nc::{Block, Word};

/// What a call remembers of its caller.
#[derive(Debug, Clone)]
pub(super) struct Frame {
    /// The caller's program.
    pub(super) program: u32,
    /// The block behind the call.
    pub(super) back: u32,
    /// The modal call of a macro's caller.
    modal_call: Option<Rc<ModalCall>>,
    /// First block of the called program, for repeats.
    entry: u32,
    /// How often it runs again.
    pub(super) again: u32,
    /// Arguments of a macro; a subprogram has none and shares its caller's locals.
    pub(super) arguments: Option<Rc<Locals>>,
}

/// G66 or G66.1 in force.
#[derive(Debug)]
pub(super) struct ModalCall {
    /// Number of the macro.
    pub(super) program: u32,
    /// How often each call runs it.
    pub(super) repeats: u32,
    /// Arguments of each call; G66.1 takes those of the block instead.
    pub(super) arguments: Rc<Locals>,
    /// G66.1: each block is a call, and nothing but a call.
    pub(super) each_block: bool,
}

/// P, L and arguments of a macro call.
pub(super) struct Arguments {
    pub(super) program: Option<f64>,
    pub(super) repeats: Option<f64>,
    pub(super) locals: Locals,
}

/// Local variable of an address in argument specification I, by letter from A; 0 where an address is no argument. G, L, N, O and P
/// are arguments of G66.1 only.
const ARGUMENT: [u8; 26] =
    [1, 2, 3, 7, 8, 9, 10, 11, 4, 5, 6, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26];
/// Sets of I, J, K in argument specification II.
const SETS: usize = 10;

impl State {
    /// How many macros are running inside one another.
    fn macro_depth(&self) -> usize {
        self.frames.iter().filter(|frame| frame.arguments.is_some()).count()
    }

    fn enter(&mut self, cx: &Cx, program: u32, entry: u32, repeats: u32, arguments: Option<Rc<Locals>>) -> Run<()> {
        let limits = &cx.control.limits;
        let macros = self.macro_depth();
        if arguments.is_some() && macros >= limits.macro_depth as usize {
            return Err(Trap::alarm(Alarm::MacroNesting, msg!("interp.macro-nesting", u32::from(limits.macro_depth))));
        }
        if arguments.is_none() && self.frames.len() - macros >= limits.sub_depth as usize {
            return Err(Trap::alarm(Alarm::SubNesting, msg!("interp.sub-nesting", u32::from(limits.sub_depth))));
        }
        if repeats == 0 {
            return Ok(());
        }
        // A macro starts without modal call; a subprogram goes on with its caller's.
        let mut modal_call = None;
        if let Some(arguments) = &arguments {
            self.vars.enter(arguments, cx.shared.rules.keep_locals);
            modal_call = self.modal_call.take();
        }
        let frame = Frame { program: self.program, back: self.at, modal_call, entry, again: repeats - 1, arguments };
        self.frames.push(frame);
        self.go_to_program(cx.deck, program);
        self.at = entry;
        Ok(())
    }

    /// A program by its number as it stands behind P.
    fn program_of(&self, cx: &Cx, number: f64) -> Run<u32> {
        let found = if (1.0..4e9).contains(&number) { cx.shared.index.program(number as u32) } else { None };
        let hint = msg!("interp.hint-program");
        found.ok_or_else(|| Trap::alarm(Alarm::NoProgram, msg!("interp.no-program", (number, 0))).hint(hint))
    }

    fn repeats(&self, cx: &Cx, repeats: Option<f64>) -> Run<u32> {
        let max = cx.control.limits.repeat_max;
        match repeats {
            None => Ok(1),
            Some(repeats) if (0.0..=f64::from(max)).contains(&repeats) => Ok(repeats as u32),
            Some(repeats) => Err(Trap::alarm(Alarm::OutOfRange, msg!("interp.value-range", repeats, 0_u32, max))),
        }
    }

    /// `M98 P H L`.
    pub(super) fn call_sub(&mut self, cx: &Cx, p: Option<f64>, h: Option<f64>, l: Option<f64>) -> Run<()> {
        let program = match p {
            Some(number) => self.program_of(cx, number)?,
            None => self.program,
        };
        let first = cx.deck.programs.get(program as usize).map_or(0, |program| program.first);
        let entry = match h {
            None => first,
            Some(number) => {
                let wanted = if (1.0..4e9).contains(&number) { number as u32 } else { 0 };
                let found = cx.shared.index.sequence(program, wanted, first);
                found.ok_or_else(|| Trap::alarm(Alarm::NoSequence, msg!("interp.no-sequence", (number, 0))))?
            }
        };
        let repeats = self.repeats(cx, l)?;
        self.enter(cx, program, entry, repeats, None)
    }

    /// One call of a macro.
    pub(super) fn call_macro(&mut self, cx: &Cx, program: u32, repeats: u32, arguments: Rc<Locals>) -> Run<()> {
        let program = self.program_of(cx, f64::from(program))?;
        let entry = cx.deck.programs.get(program as usize).map_or(0, |program| program.first);
        self.enter(cx, program, entry, repeats, Some(arguments))
    }

    /// `G65 P L arguments`, or `G66`, `G66.1` that put a call in force.
    pub(super) fn macro_words(&mut self, cx: &mut Cx, block: &Block, words: &[Word], modal: Option<bool>) -> Run<()> {
        let arguments = self.arguments(cx, block, words, false)?;
        let Some(number) = arguments.program else {
            return Err(Trap::alarm(Alarm::NoProgram, msg!("interp.call-without-program")));
        };
        let repeats = self.repeats(cx, arguments.repeats)?;
        // The program has to be there when the call is put in force.
        self.program_of(cx, number)?;
        let (program, locals) = (number as u32, Rc::new(arguments.locals));
        match modal {
            None => self.call_macro(cx, program, repeats, locals),
            Some(each_block) => {
                self.modal_call = Some(Rc::new(ModalCall { program, repeats, arguments: locals, each_block }));
                Ok(())
            }
        }
    }

    /// Arguments of both specifications, mixed: the later of two for one variable holds. With `all`, G, L, N, O and P are arguments too.
    pub(super) fn arguments(&self, cx: &mut Cx, block: &Block, words: &[Word], all: bool) -> Run<Arguments> {
        let mut found = Arguments { program: None, repeats: None, locals: [VACANT; LOCALS] };
        // Set of I, J, K that is being filled, and the last of its letters.
        let (mut set, mut last) = (0, None);
        for word in words {
            let letter = word.letter;
            if letter == b'G' && !all {
                continue;
            }
            let Some(value) = self.plain(cx, block, word)? else { continue };
            let variable = match letter {
                b'P' if !all => {
                    found.program = Some(value.round());
                    continue;
                }
                b'L' if !all => {
                    found.repeats = Some(value.round());
                    continue;
                }
                b'I' | b'J' | b'K' => {
                    if last.is_some_and(|last| letter <= last) {
                        set += 1;
                    }
                    last = Some(letter);
                    if set >= SETS {
                        let sets = SETS as u32;
                        let trap = Trap::alarm(Alarm::ArgumentSets, msg!("interp.argument-sets", sets));
                        return Err(trap.within(word_span(block, word)));
                    }
                    3 * set + 4 + (letter - b'I') as usize
                }
                _ => ARGUMENT.get(letter.wrapping_sub(b'A') as usize).map_or(0, |&variable| variable as usize),
            };
            if let Some(place) = variable.checked_sub(1).and_then(|at| found.locals.get_mut(at)) {
                *place = value;
            }
        }
        if let (true, Some(number)) = (all, block.number) {
            found.locals[13] = f64::from(number);
        }
        Ok(found)
    }

    /// `M99 P`: the end of a subprogram or macro, or once more from the head of the main program.
    pub(super) fn end_sub(&mut self, cx: &Cx, at: u32, p: Option<f64>) -> Run<()> {
        let keep = cx.shared.rules.keep_locals;
        match self.frames.last_mut() {
            None => {
                self.at = self.first;
                return p.map_or(Ok(()), |number| self.go_to_number(cx, at, number));
            }
            Some(frame) if frame.again > 0 => {
                frame.again -= 1;
                self.at = frame.entry;
                if let Some(arguments) = &frame.arguments {
                    self.vars.arguments(arguments, keep);
                }
                return Ok(());
            }
            Some(_) => {}
        }
        let Some(frame) = self.frames.pop() else { return Ok(()) };
        if frame.arguments.is_some() {
            self.vars.leave();
            self.modal_call = frame.modal_call;
        }
        self.go_to_program(cx.deck, frame.program);
        self.at = frame.back;
        p.map_or(Ok(()), |number| self.go_to_number(cx, frame.back.saturating_sub(1), number))
    }
}

/// The bytes of a word.
pub(super) fn word_span(block: &Block, word: &Word) -> crate::text::Span {
    let start = block.span.start.saturating_add(u32::from(word.offset));
    crate::text::Span::new(start, start.saturating_add(u32::from(word.len)))
}

//! Subprograms and macros: calls, arguments, returns.

use crate::controls::Address;
use std::rc::Rc;

use super::canon::Canon;
use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::frame::{CallArguments, CallFrame, CalledBy, ModalCall};
use super::state::RunState;
use super::step::End;
use super::vars::{LOCALS, Locals, VACANT};
use crate::controls::Alarm;
use crate::controls::macros::{ARGUMENT, ArgumentSets, CallKind, CodeCall};
use crate::msg;
use crate::nc::dec::POW10;
use crate::nc::{Block, ExprId, TextId, Word};

/// The word of a block that calls a macro.
#[derive(Debug, Clone, Copy)]
pub(super) struct Caller {
    /// Index in the block; `None` for a call by a modal call in force.
    pub(super) word: Option<usize>,
    /// G, L, N, O and P are arguments too.
    pub(super) all: bool,
}

/// A call: program, kind and repeats.
struct Callee {
    program: u32,
    /// The first block to run.
    entry: u32,
    repeats: u32,
    arguments: Option<CallArguments>,
    modal_call: Option<Rc<ModalCall>>,
    called_by: CalledBy,
}

/// P, L and arguments of a macro call.
pub(super) struct Arguments {
    pub(super) program: Option<f64>,
    pub(super) repeats: Option<f64>,
    locals: Locals,
    without_point: u64,
}

impl Arguments {
    /// The arguments without P and L.
    pub(super) fn into_call_arguments(self) -> CallArguments {
        CallArguments { locals: Rc::new(self.locals), without_point: self.without_point }
    }
}

/// Maximum sets of I, J, K in argument specification II.
const SETS: usize = 10;

impl RunState {
    /// Number of nested macro calls.
    fn macro_depth(&self) -> usize {
        self.frames.iter().filter(|frame| frame.arguments.is_some()).count()
    }

    /// Whether the running program was called by a code, directly or indirectly. Codes call no further programs then.
    pub(super) fn called_by_code(&self) -> bool {
        self.frames.iter().any(|frame| frame.called_by == CalledBy::Code)
    }

    fn enter(&mut self, cx: &BlockContext, callee: Callee) -> BlockResult<()> {
        let limits = &cx.control.limits;
        let macros = self.macro_depth();
        if callee.arguments.is_some() && macros >= limits.macro_depth as usize {
            return Err(Trap::alarm(
                Alarm::MacroNesting,
                msg!("interp.macro-nesting", most = u32::from(limits.macro_depth)),
            ));
        }
        if callee.arguments.is_none() && self.frames.len() - macros >= cx.shared.rules.running.sub_depth as usize {
            let most = u32::from(cx.shared.rules.running.sub_depth);
            return Err(Trap::alarm(Alarm::SubNesting, msg!("interp.sub-nesting", most)));
        }
        if callee.program == self.program && cx.control.raises(Alarm::OwnCall) {
            return Err(Trap::alarm(Alarm::OwnCall, msg!("interp.own-call")));
        }
        if callee.repeats == 0 {
            return Ok(());
        }
        let Callee { program, entry, repeats, arguments, called_by, .. } = callee;
        // A subprogram keeps the modal call of its caller.
        let mut modal_call = None;
        if let Some(arguments) = &arguments {
            self.vars.enter(&arguments.locals, cx.shared.rules.running.keep_locals);
            modal_call = core::mem::replace(&mut self.modal_call, callee.modal_call);
        }
        let back = self.at;
        let frame =
            CallFrame { program: self.program, back, modal_call, entry, again: repeats - 1, arguments, called_by };
        self.frames.push(frame);
        self.go_to_program(cx.deck, program);
        self.at = entry;
        Ok(())
    }

    /// Index of the program with the number P.
    fn program_of(&self, cx: &BlockContext, number: f64) -> BlockResult<u32> {
        let found = if (1.0..4e9).contains(&number) { cx.shared.index.program(number as u32) } else { None };
        let hint = msg!("interp.hint-program");
        let trap = || {
            Trap::alarm(Alarm::NoProgram, msg!("interp.no-program", program = (number, 0)))
                .hint(hint)
                .at_word(&[Address::P])
        };
        found.ok_or_else(trap)
    }

    fn repeats(&self, cx: &BlockContext, repeats: Option<f64>, at: &'static [Address]) -> BlockResult<u32> {
        let max = cx.control.limits.repeat_max;
        // On controls with an alarm for repeats, 0 repeats raise it too.
        let min = u32::from(cx.control.raises(Alarm::RepeatRange));
        match repeats {
            None => Ok(1),
            Some(repeats) if (f64::from(min)..=f64::from(max)).contains(&repeats) => Ok(repeats as u32),
            Some(repeats) => Err(Trap::alarm(
                Alarm::RepeatRange,
                msg!("interp.repeat-range", count = repeats, least = min, most = max),
            )
            .at_word(at)),
        }
    }

    /// Subprogram call by `M98 P H L`, or by a code bound to a subprogram.
    pub(super) fn call_sub(
        &mut self,
        cx: &BlockContext,
        p: Option<f64>,
        h: Option<f64>,
        l: Option<f64>,
        called_by: CalledBy,
    ) -> BlockResult<()> {
        let macros = &cx.control.macros;
        self.refuse_in_modal(cx)?;
        let at: &'static [Address] = if l.is_some() { &[Address::L] } else { &[Address::P] };
        let (mut p, mut l) = (p, l);
        if let (Some(number), true, CalledBy::Word) = (p, macros.repeats_in_p, called_by) {
            // The repeats are the digits in front of the program number.
            let programs = POW10.get(usize::from(cx.control.syntax.program_digits)).map_or(1e18, |&p| p as f64);
            if number >= programs {
                p = Some(number % programs);
                l = l.or(Some((number / programs).trunc()));
            }
        }
        let program = match p {
            Some(number) => self.program_of(cx, number)?,
            None if macros.sub_sequence => self.program,
            None => return Err(Trap::alarm(Alarm::NoCallProgram, msg!("interp.call-without-program"))),
        };
        let first = cx.deck.programs.get(program as usize).map_or(0, |program| program.first);
        let entry = match h.filter(|_| macros.sub_sequence) {
            None => first,
            Some(number) => {
                let wanted = if (1.0..4e9).contains(&number) { number as u32 } else { 0 };
                let found = cx.shared.index.sequence(program, wanted, first);
                found.ok_or_else(|| {
                    Trap::alarm(Alarm::NoSequence, msg!("interp.no-sequence", number = (number, 0)))
                        .at_word(&[Address::H])
                })?
            }
        };
        let repeats = self.repeats(cx, l, at)?;
        self.enter(cx, Callee { program, entry, repeats, arguments: None, modal_call: None, called_by })
    }

    /// A call of a program by its name.
    pub(super) fn call_named(
        &mut self,
        cx: &mut BlockContext,
        name: TextId,
        repeats: Option<ExprId>,
    ) -> BlockResult<()> {
        let name = cx.deck.text(Some(name));
        let Some(program) = cx.shared.index.named(name) else {
            let trap = Trap::alarm(Alarm::NoProgram, msg!("interp.no-program", program = name));
            return Err(trap.hint(msg!("interp.hint-program")));
        };
        let max = cx.control.limits.repeat_max;
        let repeats = match repeats {
            None => 1,
            Some(id) => {
                let repeats = self.number(cx, id)?.round();
                if !(1.0..=f64::from(max)).contains(&repeats) {
                    let message = msg!("interp.repeat-range", count = repeats, least = 1_u32, most = max);
                    return Err(Trap::alarm(Alarm::RepeatRange, message).part(id));
                }
                repeats as u32
            }
        };
        let entry = cx.deck.programs.get(program as usize).map_or(0, |program| program.first);
        self.enter(cx, Callee { program, entry, repeats, arguments: None, modal_call: None, called_by: CalledBy::Word })
    }

    /// Raises the alarm of a call or jump during a modal macro call, on controls that have it.
    fn refuse_in_modal(&self, cx: &BlockContext) -> BlockResult<()> {
        if self.modal_call.is_some() && cx.control.raises(Alarm::ReturnInModal) {
            return Err(Trap::alarm(Alarm::ReturnInModal, msg!("interp.call-in-modal")));
        }
        Ok(())
    }

    /// One call of a macro.
    fn call_macro(
        &mut self,
        cx: &BlockContext,
        (program, repeats): (u32, u32),
        arguments: CallArguments,
        modal_call: Option<Rc<ModalCall>>,
        called_by: CalledBy,
    ) -> BlockResult<()> {
        let program = self.program_of(cx, f64::from(program))?;
        let entry = cx.deck.programs.get(program as usize).map_or(0, |program| program.first);
        self.enter(cx, Callee { program, entry, repeats, arguments: Some(arguments), modal_call, called_by })
    }

    /// One call of the modal macro in force.
    pub(super) fn call_modal(
        &mut self,
        cx: &BlockContext,
        call: &ModalCall,
        arguments: CallArguments,
    ) -> BlockResult<()> {
        self.call_macro(cx, (call.program, call.repeats), arguments, call.outer.clone(), call.called_by)
    }

    /// `G65 P L arguments`, or `G66` or `G66.1`, which set a modal call.
    pub(super) fn macro_words(
        &mut self,
        cx: &mut BlockContext,
        block: &Block,
        words: &[Word],
        caller: Caller,
        kind: CallKind,
    ) -> BlockResult<()> {
        let arguments = self.arguments(cx, block, words, caller)?;
        let Some(number) = arguments.program else {
            return Err(Trap::alarm(Alarm::NoCallProgram, msg!("interp.call-without-program")));
        };
        // G66 and G66.1 already need the program.
        self.program_of(cx, number)?;
        self.call_as(cx, number as u32, arguments, kind, CalledBy::Word)
    }

    /// Macro call by a code bound to a macro; the words of the block are arguments.
    pub(super) fn call_by_code(
        &mut self,
        cx: &mut BlockContext,
        block: &Block,
        words: &[Word],
        caller: Caller,
        call: CodeCall,
    ) -> BlockResult<()> {
        // On controls where codes cannot be arguments, the calling code has to be the only code of its block.
        let letter = caller.word.and_then(|at| words.get(at)).map(|word| word.letter);
        let first = words.iter().position(|word| Some(word.letter) == letter).filter(|at| caller.word != Some(*at));
        if let Some(word) = first.and_then(|at| words.get(at)).filter(|_| cx.control.raises(Alarm::ArgumentAddress)) {
            let letter = word.letter.to_string();
            let trap = Trap::alarm(Alarm::ArgumentAddress, msg!("interp.argument-address", address = letter));
            return Err(trap.within(word.span(block)));
        }
        let arguments = self.arguments(cx, block, words, caller)?;
        self.call_as(cx, call.program, arguments, call.kind, CalledBy::Code)
    }

    fn call_as(
        &mut self,
        cx: &BlockContext,
        program: u32,
        arguments: Arguments,
        kind: CallKind,
        called_by: CalledBy,
    ) -> BlockResult<()> {
        let repeats = self.repeats(cx, arguments.repeats, &[Address::L])?;
        let arguments = arguments.into_call_arguments();
        if matches!(kind, CallKind::Modal | CallKind::ModalBlock) {
            let (each_block, outer) = (kind == CallKind::ModalBlock, self.modal_call.take());
            self.modal_call = Some(Rc::new(ModalCall { program, repeats, arguments, each_block, called_by, outer }));
            return Ok(());
        }
        if cx.control.macros.call_ends_modal {
            self.modal_call = None;
        }
        self.call_macro(cx, (program, repeats), arguments, None, called_by)
    }

    /// Arguments of both specifications, mixed. Of two words for one variable the later one counts.
    pub(super) fn arguments(
        &self,
        cx: &mut BlockContext,
        block: &Block,
        words: &[Word],
        caller: Caller,
    ) -> BlockResult<Arguments> {
        let mut found = Arguments { program: None, repeats: None, locals: [VACANT; LOCALS], without_point: 0 };
        let all = caller.all;
        // For argument sets in order: the present set of I, J, K and its last letter. For sets per letter: the counts of I, J and K.
        let (mut set, mut last, mut counts) = (0, None, [0; 3]);
        for (at, word) in words.iter().enumerate() {
            let letter = word.letter;
            if caller.word == Some(at) {
                continue;
            }
            if matches!(letter, Address::G | Address::N | Address::O) && !all {
                if caller.word.is_some_and(|caller| caller < at) && cx.control.raises(Alarm::ArgumentAddress) {
                    let letter = letter.to_string();
                    let trap = Trap::alarm(Alarm::ArgumentAddress, msg!("interp.argument-address", address = letter));
                    return Err(trap.within(word.span(block)));
                }
                continue;
            }
            let Some(value) = self.argument(cx, block, word)? else { continue };
            let variable = match letter {
                Address::P if !all => {
                    found.program = Some(value.round());
                    continue;
                }
                Address::L if !all => {
                    found.repeats = Some(value.round());
                    continue;
                }
                Address::I | Address::J | Address::K => {
                    let at = letter.after(Address::I).unwrap_or(0);
                    let set = match cx.control.macros.argument_sets {
                        ArgumentSets::InOrder => {
                            set += usize::from(last.is_some_and(|last| letter <= last));
                            last = Some(letter);
                            set
                        }
                        ArgumentSets::PerLetter => {
                            counts[at] += 1;
                            counts[at] - 1
                        }
                    };
                    if set >= SETS {
                        let trap = Trap::alarm(Alarm::ArgumentSets, msg!("interp.argument-sets", most = SETS as u32));
                        return Err(trap.within(word.span(block)));
                    }
                    3 * set + 4 + at
                }
                _ => ARGUMENT.get(letter as usize).map_or(0, |&variable| variable as usize),
            };
            if let Some(place) = variable.checked_sub(1).and_then(|at| found.locals.get_mut(at)) {
                *place = value;
                let bit = 1_u64 << (variable - 1);
                let increments = self.counts_argument(cx, word);
                found.without_point = if increments { found.without_point | bit } else { found.without_point & !bit };
            }
        }
        if let (true, Some(number)) = (all, block.number) {
            found.locals[13] = f64::from(number);
        }
        Ok(found)
    }

    /// Whether a local variable still has the value of an argument that was written without a decimal point and counted increments.
    pub(super) fn was_written_without_point(&self, variable: u32, value: f64) -> bool {
        let given = self.frames.iter().rev().find_map(|frame| frame.arguments.as_ref());
        let at = (variable as usize).wrapping_sub(1);
        given.is_some_and(|given| given.without_point >> at.min(63) & 1 == 1 && given.locals.get(at) == Some(&value))
    }

    /// `M99 P`: returns from a subprogram or macro, or restarts the main program.
    pub(super) fn end_sub(&mut self, cx: &BlockContext, at: u32, p: Option<f64>) -> BlockResult<()> {
        let keep = cx.shared.rules.running.keep_locals;
        if p.is_some() {
            self.refuse_in_modal(cx)?;
        }
        match self.frames.last_mut() {
            None if cx.control.macros.main_ends => {
                self.queue.push(Canon::End);
                self.ended = Some(End::Program);
                return Ok(());
            }
            None => {
                self.at = self.first;
                return p.map_or(Ok(()), |number| self.go_to_number(cx, at, number, Alarm::NoSequence));
            }
            Some(frame) if frame.again > 0 => {
                frame.again -= 1;
                self.at = frame.entry;
                if let Some(arguments) = &frame.arguments {
                    self.vars.arguments(&arguments.locals, keep);
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
        p.map_or(Ok(()), |number| self.go_to_number(cx, frame.back.saturating_sub(1), number, Alarm::NoSequence))
    }
}

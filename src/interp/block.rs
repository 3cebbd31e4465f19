//! A block of NC words: codes first, then values, then commands in the order of the machine.

use crate::controls::Address;
use std::rc::Rc;

use super::call::Caller;
use super::canon::Canon;
use super::codes::{BlockCodes, END, OPTIONAL_STOP, STOP, macro_kind};
use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::frame::CalledBy;
use super::state::RunState;
use super::step::End;
use super::words::BlockWords;
use crate::controls::macros::CallKind;
use crate::controls::{Alarm, Code};
use crate::drives::Rotation;
use crate::drives::speed::SpeedLimit;
use crate::msg;
use crate::nc::{Block, Word, are_data};
use crate::text::{Diagnostic, DiagnosticKind, Place};

impl RunState {
    /// Executes a block of words.
    pub(super) fn execute_words(
        &mut self,
        cx: &mut BlockContext,
        at: u32,
        block: &Block,
        words: &[Word],
    ) -> BlockResult<()> {
        if self.modal.unmoved.data && self.is_data(words) {
            self.counts.nc += 1;
            return Ok(());
        }
        let surface = self.modal.spindle.surface.then(|| self.surface_zero(cx));
        let mut codes = BlockCodes { words_read: words.len(), ..BlockCodes::default() };
        self.codes(cx, block, words, &mut codes)?;
        let words = words.get(..codes.words_read).unwrap_or(words);
        if self.macro_call(cx, at, block, words, &codes)? {
            return Ok(());
        }
        let mut values = BlockWords::default();
        self.values(cx, block, words, &codes, &mut values)?;
        if self.modal.spindle.surface && surface.is_none() && values.speed.is_none() {
            self.remark_no_surface_speed(cx, block, words);
        }
        let moved = self.commands(cx, &codes, &values, surface)?;
        let commands = !self.queue.is_empty();
        self.stops(&codes);
        if codes.contour {
            self.pass_contour(cx, at, block, words, &values)?;
        }
        if !moved && values.radius.is_some() {
            self.remark_point_arc(cx, block, words, &codes);
        }
        self.flow(cx, at, &codes, &values, moved)?;
        // A block with only a call or return ends when it is read.
        if (codes.flow.is_some() || codes.call.is_some()) && !commands {
            self.counts.macros += 1;
        } else {
            self.counts.nc += 1;
        }
        Ok(())
    }

    /// Whether the words of a block are data for the control, to which the first G or M code puts an end.
    #[cold]
    fn is_data(&mut self, words: &[Word]) -> bool {
        self.modal.unmoved.data = are_data(words);
        self.modal.unmoved.data
    }

    /// Calls a macro with the block's words as arguments, or ends a modal call; returns whether it called.
    fn macro_call(
        &mut self,
        cx: &mut BlockContext,
        at: u32,
        block: &Block,
        words: &[Word],
        codes: &BlockCodes,
    ) -> BlockResult<bool> {
        if let Some(call) = self.modal_call.as_ref().filter(|call| call.each_block).map(Rc::clone)
            && codes.special != Some(Code::MacroModalEnd)
            && codes.flow.is_none()
            && codes.stops == 0
        {
            let caller = Caller { word: None, all: true };
            let arguments = self.arguments(cx, block, words, caller)?;
            self.counts.macros += 1;
            return self.call_modal(cx, &call, arguments.into_call_arguments()).map(|()| true);
        }
        if codes.special.is_none() && codes.call.is_none() {
            return Ok(false);
        }
        if let Some(kind) = macro_kind(codes) {
            self.counts.macros += 1;
            return self.call_words(cx, at, block, words, codes, kind).map(|()| true);
        }
        if codes.special == Some(Code::MacroModalEnd) {
            match self.modal_call.take() {
                Some(call) => self.modal_call.clone_from(&call.outer),
                None if cx.control.raises(Alarm::NoModalCall) => {
                    return Err(Trap::alarm(Alarm::NoModalCall, msg!("interp.no-modal-call")));
                }
                None => {}
            }
        }
        Ok(false)
    }

    /// Queues the commands of a block in the machine's order, without stops; returns whether the block moves. `surface` is the work zero
    /// for constant surface speed before the block.
    fn commands(
        &mut self,
        cx: &mut BlockContext,
        codes: &BlockCodes,
        values: &BlockWords,
        surface: Option<i64>,
    ) -> BlockResult<bool> {
        if let Some(stage) = codes.gear {
            self.queue.push(Canon::Gear { stage });
        }
        if let Some(rpm) = values.speed_limit {
            self.limit_speed(SpeedLimit::Surface, rpm);
        }
        self.queue_speed(cx, codes, values, surface)?;
        let stops_last = codes.rotation == Some(Rotation::Stopped) && cx.shared.rules.spindle.stop_last;
        if let Some(rotation) = codes.rotation.filter(|_| !stops_last) {
            self.queue.push(Canon::SpindleDirection { rotation });
        }
        for &code in codes.auxiliary.iter().take(codes.auxiliaries) {
            self.queue.push(Canon::Auxiliary { code });
        }
        if let Some(code) = values.tool {
            self.modal.set_shown(Address::T, f64::from(code));
            self.queue.push(Canon::Tool { code });
        }
        if codes.changes_path_mode {
            self.queue.push(Canon::PathMode { exact: self.modal.exact });
        }
        if let Some((angle, approach)) = values.orient.or(codes.orient) {
            self.orient(cx, angle, approach)?;
        }
        let moved = self.queue_motion(cx, codes, values)?;
        if stops_last {
            self.queue.push(Canon::SpindleDirection { rotation: Rotation::Stopped });
        }
        Ok(moved)
    }

    /// Queues stops and the program end.
    fn stops(&mut self, codes: &BlockCodes) {
        if codes.stops & STOP != 0 {
            self.queue.push(Canon::Stop);
        } else if codes.stops & OPTIONAL_STOP != 0 {
            self.queue.push(Canon::OptionalStop);
        }
        if codes.stops & END != 0 {
            self.queue.push(Canon::End);
            self.ended = Some(End::Program);
        }
        // A program may read the end point of a skipped motion.
        self.pause = codes.stops != 0 || codes.special == Some(Code::Skip);
    }

    /// Calls or returns; after a motion, calls the modal macro.
    fn flow(
        &mut self,
        cx: &mut BlockContext,
        at: u32,
        codes: &BlockCodes,
        values: &BlockWords,
        moved: bool,
    ) -> BlockResult<()> {
        match (codes.flow, codes.call) {
            (_, Some(call)) => {
                let program = f64::from(call.program);
                self.call_sub(cx, Some(program), None, values.call.l, CalledBy::Code)
            }
            (Some(Code::SubCall), None) => {
                self.call_sub(cx, values.call.p, values.call.h, values.call.l, CalledBy::Word)
            }
            (Some(Code::Return), None) if self.frames.is_empty() => {
                let code = cx.control.names_of(&[Code::Return]);
                let end = cx.control.names_of(&[Code::End, Code::EndRewind]);
                Err(Trap::alarm(Alarm::MainReturn, msg!("interp.main-return", code, end)))
            }
            (Some(_), None) => self.end_sub(cx, at, values.call.p),
            (None, None) => match self.modal_call.as_ref().filter(|_| moved).map(Rc::clone) {
                Some(call) => {
                    let arguments = call.arguments.clone();
                    self.call_modal(cx, &call, arguments)
                }
                None => Ok(()),
            },
        }
    }

    /// Reads codes and values of a block without executing its commands. Returns whether the block calls or returns; `None` if that depends
    /// on the calling program.
    pub(super) fn read_words(
        &mut self,
        cx: &mut BlockContext,
        block: &Block,
        words: &[Word],
    ) -> BlockResult<Option<bool>> {
        if self.modal.unmoved.data && self.is_data(words) {
            return Ok(Some(false));
        }
        let mut codes = BlockCodes { words_read: words.len(), ..BlockCodes::default() };
        self.codes(cx, block, words, &mut codes)?;
        if codes.call.is_some() {
            return Ok(None);
        }
        let called = macro_kind(&codes).is_some();
        if called {
            self.arguments(cx, block, words, Caller { word: Some(codes.caller), all: false })?;
        } else {
            self.values(cx, block, words, &codes, &mut BlockWords::default())?;
        }
        Ok(Some(called || codes.flow.is_some()))
    }

    /// Executes a block whose words are macro arguments.
    fn call_words(
        &mut self,
        cx: &mut BlockContext,
        at: u32,
        block: &Block,
        words: &[Word],
        codes: &BlockCodes,
        kind: CallKind,
    ) -> BlockResult<()> {
        let here = |trap: Trap| match words.get(codes.caller) {
            Some(word) => trap.within(word.span(block)),
            None => trap,
        };
        if cx.control.raises(Alarm::CallMixed) && (codes.mixed || codes.stops != 0 || codes.flow.is_some()) {
            return Err(here(Trap::alarm(Alarm::CallMixed, msg!("interp.call-mixed"))));
        }
        let caller = Caller { word: Some(codes.caller), all: false };
        if let (true, None, Some(word)) = (cx.control.macros.program_next, codes.call, words.get(codes.caller + 1))
            && !matches!(word.letter, Address::P | Address::H)
        {
            let trap = Trap::alarm(Alarm::NoCallProgram, msg!("interp.call-program-next"));
            return Err(trap.within(word.span(block)));
        }
        if let Some(call) = codes.call {
            return self.call_by_code(cx, block, words, caller, call);
        }
        if cx.control.macros.call_first && codes.caller > 0 {
            return Err(here(Trap::alarm(Alarm::CallNotFirst, msg!("interp.call-not-first"))));
        }
        if kind == CallKind::Macro && self.is_function(cx, words) {
            return self.function_words(cx, at, block, words);
        }
        self.macro_words(cx, block, words, caller, kind)
    }

    /// Warns that a cycle with a contour is left out, and jumps past the contour if it lies ahead. The alarm if its first block is not in the
    /// program, or its last one does not follow.
    #[cold]
    fn pass_contour(
        &mut self,
        cx: &mut BlockContext,
        at: u32,
        block: &Block,
        words: &[Word],
        values: &BlockWords,
    ) -> BlockResult<()> {
        let number = |value: Option<f64>| value.filter(|value| (1.0..1e9).contains(value)).map(|value| value as u32);
        let (Some(first), Some(last)) = (number(values.call.p), number(values.call.q)) else { return Ok(()) };
        let index = &cx.shared.index;
        let missing = |number: u32, letter: &'static [Address]| {
            Trap::alarm(Alarm::NoContour, msg!("interp.no-contour", number, first, last)).at_word(letter)
        };
        let next = at.saturating_add(1);
        let Some(start) = index.sequence(self.program, first, next) else {
            return Err(missing(first, &[Address::P]));
        };
        let Some(end) = index.sequence(self.program, last, start).filter(|&end| end >= start) else {
            return Err(missing(last, &[Address::Q]));
        };
        let cycle = words.iter().find_map(|word| {
            let row = cx.codes().row_of(word).filter(|row| row.code == Code::Roughing)?;
            Some((word.span(block), format!("{} ({})", cx.control.code_name(row.id), row.text)))
        });
        let (span, code) = cycle.unwrap_or((block.span, String::new()));
        let message = if start < at {
            // The contour stands in front of the cycle: its blocks have run as motions.
            msg!("nc.not-simulated", code)
        } else {
            self.at = end.saturating_add(1);
            msg!("interp.contour", first, last)
        };
        let remark = Diagnostic::warning(message).kind(DiagnosticKind::Contour);
        cx.world.remark(remark.at(Place { file: self.file, span }));
        Ok(())
    }

    /// Warns about constant surface speed without any cutting speed so far, which is 0, on a control without an alarm for it.
    #[cold]
    fn remark_no_surface_speed(&self, cx: &mut BlockContext, block: &Block, words: &[Word]) {
        let word = words.iter().find(|word| cx.codes().row_of(word).is_some_and(|row| row.code == Code::SurfaceSpeed));
        let missing = self.modal.spindle.surface_speed.is_none() && !cx.control.raises(Alarm::NoSurfaceSpeed);
        if let Some(word) = word.filter(|_| missing) {
            self.remark(cx, word.span(block), msg!("interp.surface-speed-zero"));
        }
    }

    /// Warns about an arc by its radius that ends where it starts, on a control where it moves nothing.
    #[cold]
    fn remark_point_arc(&self, cx: &mut BlockContext, block: &Block, words: &[Word], codes: &BlockCodes) {
        let idle = codes.special.is_some() || codes.unmoved || self.modal.unmoved.any();
        let arc = matches!(self.modal.motion, Code::ArcCw | Code::ArcCcw) && !idle;
        if arc && cx.control.limits.point_arc_rests {
            let word = words.iter().find(|word| word.letter == Address::R);
            let span = word.map_or(block.span, |word| word.span(block));
            self.remark(cx, span, msg!("interp.point-arc"));
        }
    }
}

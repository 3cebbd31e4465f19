//! G and M codes of a block: modal codes, and their effect on the meaning of other words.

use super::canon::Canon;
use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::rules::M_CODES;
use super::state::RunState;
use crate::controls::Address;
use crate::controls::macros::{CallKind, CodeCall};
use crate::controls::{Alarm, Code, CodeDef, CodeId, Group};
use crate::drives::{Approach, Rotation};
use crate::msg;
use crate::nc::{Block, Word, WordValue};

/// M00.
pub(super) const STOP: u8 = 1;

/// M01.
pub(super) const OPTIONAL_STOP: u8 = 2;

/// M02, M30.
pub(super) const END: u8 = 4;

/// The codes of a block.
#[derive(Default)]
pub(super) struct BlockCodes {
    /// The one-shot code that defines the meaning of the words: dwell, reference return, coordinate setting, macro call …
    pub(super) special: Option<Code>,
    /// The axis words belong to a code that is not simulated: no motion.
    pub(super) unmoved: bool,
    /// Blocks from P to Q are the contour of a roughing cycle, not motions.
    pub(super) contour: bool,
    /// Input of data (G10), by this block and perhaps by those behind it.
    pub(super) data: bool,
    /// Every word is allowed, because a code that is not simulated, or its cancel, may use it.
    pub(super) any_word: bool,
    /// Exact stop in this block.
    pub(super) exact: bool,
    /// Exact stop mode or cutting mode is commanded.
    pub(super) changes_path_mode: bool,
    /// M03, M04, M05.
    pub(super) rotation: Option<Rotation>,
    pub(super) gear: Option<u8>,
    /// Spindle orientation: angle in degrees and approach.
    pub(super) orient: Option<(f64, Approach)>,
    pub(super) auxiliary: [u32; M_CODES as usize],
    pub(super) auxiliaries: usize,
    /// [`STOP`], [`OPTIONAL_STOP`], [`END`].
    pub(super) stops: u8,
    /// M98, M99.
    pub(super) flow: Option<Code>,
    /// A code bound to a program by parameter.
    pub(super) call: Option<CodeCall>,
    /// A macro call has an M word that excludes a call in its block.
    pub(super) mixed: bool,
    /// Index of the word that calls a macro.
    pub(super) caller: usize,
    /// Number of words read: all, or those in front of an optional block skip.
    pub(super) words_read: usize,
}

impl BlockCodes {
    /// Whether S is a speed limit in this block.
    pub(super) fn s_is_limit(&self) -> bool {
        matches!(self.special, Some(Code::LowerLimits | Code::UpperLimits | Code::SetCoordinates))
    }
}

impl RunState {
    /// Puts the codes of a block in force.
    #[inline]
    pub(super) fn codes(
        &mut self,
        cx: &mut BlockContext,
        block: &Block,
        words: &[Word],
        codes: &mut BlockCodes,
    ) -> BlockResult<()> {
        for (at, word) in words.iter().enumerate() {
            match word.letter {
                Address::G => {
                    let Some(number) = self.code_number(cx, block, word)? else { continue };
                    let id = CodeId::G(number);
                    if self.calls(cx, id, at, codes) {
                        continue;
                    }
                    let Some(row) = cx.codes().row(id) else {
                        let written = self.raw(cx, block, word)?.unwrap_or(0.0);
                        let trap = Trap::alarm(Alarm::UnknownCode, msg!("interp.unknown-code", number = written));
                        return Err(trap.within(word.span(block)));
                    };
                    self.g_code(cx, cx.codes().meant(row, words), at, codes);
                }
                // After a macro call, M is an argument.
                Address::M if codes.special.is_some() && macro_kind(codes).is_some() => codes.mixed |= mixes(cx, word),
                Address::M if self.spindle_of(word) > 1 && self.other_spindle(cx, block, word)? => {}
                Address::M if at + 1 < words.len() && self.is_overtaken(cx, block, words, at)? => {}
                Address::M => self.m_word(cx, block, word, at, codes)?,
                Address::Name => self.named_code(cx, word, at, codes)?,
                Address::Skip if self.skips(cx, word) => {
                    codes.words_read = at;
                    break;
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// The spindle addressed by a word.
    #[inline]
    pub(super) fn spindle_of(&self, word: &Word) -> u8 {
        word.index.unwrap_or(self.modal.spindle.master)
    }

    /// Handles an M word of a second spindle; returns whether the word addresses one.
    #[cold]
    fn other_spindle(&mut self, cx: &mut BlockContext, block: &Block, word: &Word) -> BlockResult<bool> {
        let Some(number) = self.whole(cx, block, word)? else { return Ok(word.index.is_some()) };
        let code = cx.codes().row(CodeId::M(number as u32)).map(|row| row.code);
        if let Some(rotation) = code.and_then(Code::rotation) {
            self.modal.spindle.second.turns = rotation != Rotation::Stopped;
            self.queue.push(Canon::OtherSpindle { spindle: self.spindle_of(word), rotation });
            return Ok(true);
        }
        if matches!(code, Some(Code::SpindleOrient | Code::GearStage(_))) {
            let spindle = u32::from(self.spindle_of(word));
            self.remark(cx, word.span(block), msg!("interp.other-spindle-word", spindle));
            return Ok(true);
        }
        Ok(word.index.is_some())
    }

    /// Whether the block has enough further M codes for this one not to act.
    fn is_overtaken(&self, cx: &mut BlockContext, block: &Block, words: &[Word], at: usize) -> BlockResult<bool> {
        let most = cx.shared.rules.running.m_codes;
        let mut behind = 0;
        for word in words.get(at + 1..).unwrap_or_default() {
            match word.letter {
                Address::Skip if self.skips(cx, word) => break,
                Address::M if word.index.is_none_or(|spindle| spindle <= 1) && self.raw(cx, block, word)?.is_some() => {
                    behind += 1;
                }
                _ => continue,
            }
            if behind == most && cx.shared.rules.running.m_alarm {
                let trap = Trap::alarm(Alarm::Auxiliaries, msg!("interp.m-codes", most = u32::from(most)));
                return Err(trap.within(word.span(block)));
            }
        }
        if behind >= most
            && let Some(word) = words.get(at)
        {
            self.remark(cx, word.span(block), msg!("interp.m-code-dropped", most = u32::from(most)));
        }
        Ok(behind >= most)
    }

    /// Handles a named code.
    #[cold]
    fn named_code(&mut self, cx: &BlockContext, word: &Word, at: usize, codes: &mut BlockCodes) -> Result<(), Trap> {
        match cx.codes().row_of(word) {
            Some(row) if row.code == Code::StopReading && !self.synced => return Err(Trap::Sync),
            Some(row) if row.code == Code::StopReading => codes.any_word = true,
            Some(row) if row.code == Code::Return => codes.flow = Some(Code::Return),
            Some(row) if row.code == Code::MasterSpindle => self.modal.spindle.master = word.index.unwrap_or(1),
            Some(row) => self.g_code(cx, row, at, codes),
            None => {}
        }
        Ok(())
    }

    /// Whether an optional block skip in the middle of a block is switched on.
    #[cold]
    fn skips(&self, cx: &mut BlockContext, word: &Word) -> bool {
        let WordValue::Number(number) = word.value else { return false };
        cx.world.block_skip(u8::try_from(number.mantissa).unwrap_or(1).max(1))
    }

    /// Handles a code bound to a program. Within a program called by a code, codes call no program.
    #[inline]
    fn calls(&self, cx: &BlockContext, id: CodeId, at: usize, codes: &mut BlockCodes) -> bool {
        let call = cx.codes().call(id).filter(|_| !self.called_by_code());
        if call.is_some() {
            (codes.call, codes.caller) = (call.copied(), at);
        }
        call.is_some()
    }

    #[inline]
    fn g_code(&mut self, cx: &BlockContext, row: &CodeDef, at: usize, codes: &mut BlockCodes) {
        use Code::*;
        match row.code {
            GoTo(_) | Dwell | ReferenceReturn | MachineCoordinates | MachineRapid | SetCoordinates
            | LocalCoordinates | Offset | OffsetMore | LowerLimits | UpperLimits | MacroCall | MacroModal
            | MacroModalBlock | MacroModalEnd | Skip => {
                (codes.special, codes.caller) = (Some(row.code), at);
            }
            Tapping if row.group == Group::OneShot => codes.special = Some(row.code),
            ExactStopOnce => codes.exact = true,
            ExactStop | Cutting => codes.changes_path_mode = self.modal.exact != (row.code == ExactStop),
            MoreCoordinates => codes.any_word = true,
            DataInput(_) => (codes.any_word, codes.unmoved, codes.data) = (true, true, true),
            NotSimulated | Cancel => {
                codes.any_word = true;
                codes.unmoved |= row.code == NotSimulated && row.group == Group::OneShot;
            }
            TakesAxisWords | CancelForAxes | ReplacesPositions => (codes.any_word, codes.unmoved) = (true, true),
            Roughing => (codes.any_word, codes.unmoved, codes.contour) = (true, true, true),
            _ => {}
        }
        self.modal.set(cx.control, row);
    }

    fn m_word(
        &mut self,
        cx: &mut BlockContext,
        block: &Block,
        word: &Word,
        at: usize,
        codes: &mut BlockCodes,
    ) -> BlockResult<()> {
        let Some(number) = self.whole(cx, block, word)? else { return Ok(()) };
        if !(0.0..=99_999_999.0).contains(&number) {
            return Err(self.out_of_range(cx, block, word, 0.0, 99_999_999.0));
        }
        let number = number as u32;
        self.modal.set_shown(Address::M, f64::from(number));
        let id = CodeId::M(number);
        if self.calls(cx, id, at, codes) {
            return Ok(());
        }
        match cx.codes().row(id).map(|row| row.code) {
            Some(Code::End | Code::EndRewind) if cx.shared.rules.running.ends_return && !self.frames.is_empty() => {
                codes.flow = Some(Code::SubEnd);
            }
            Some(Code::Stop) => codes.stops |= STOP,
            Some(Code::OptionalStop) => codes.stops |= OPTIONAL_STOP,
            Some(Code::End | Code::EndRewind) => codes.stops |= END,
            Some(code @ (Code::SubCall | Code::SubEnd)) => codes.flow = Some(code),
            Some(code @ (Code::SpindleCw | Code::SpindleCcw | Code::SpindleStop)) => codes.rotation = code.rotation(),
            Some(Code::GearStage(stage)) => codes.gear = Some(stage),
            Some(Code::SpindleOrient) if cx.shared.rules.spindle.orients => {
                codes.orient = Some((0.0, Approach::Direct))
            }
            _ => {
                if let Some(place) = codes.auxiliary.get_mut(codes.auxiliaries) {
                    *place = number;
                    codes.auxiliaries += 1;
                }
            }
        }
        Ok(())
    }
}

/// Kind of the block's macro call; `None` if it calls no macro.
pub(super) fn macro_kind(codes: &BlockCodes) -> Option<CallKind> {
    match (codes.call, codes.special) {
        (Some(call), _) => (call.kind != CallKind::Sub).then_some(call.kind),
        (None, Some(Code::MacroCall)) => Some(CallKind::Macro),
        (None, Some(Code::MacroModal)) => Some(CallKind::Modal),
        (None, Some(Code::MacroModalBlock)) => Some(CallKind::ModalBlock),
        (None, _) => None,
    }
}

/// Whether an M word in a macro call is a stop, end, call or return.
#[cold]
fn mixes(cx: &BlockContext, word: &Word) -> bool {
    use Code::{End, EndRewind, OptionalStop, Stop, SubCall, SubEnd};
    let row = cx.codes().row_of(word);
    row.is_some_and(|row| matches!(row.code, Stop | OptionalStop | End | EndRewind | SubCall | SubEnd))
}

//! Blocks of NC words: codes first, then values, then commands in the order of the machine.

use std::rc::Rc;

use super::End;
use super::call::{Caller, word_span};
use super::canon::{AXES, Canon};
use super::error::{Run, Trap};
use super::modal::Radii;
use super::state::{BlockContext, State};
use crate::controls::macros::{CallKind, CodeCall};
use crate::controls::syntax::long;
use crate::controls::{Alarm, Code, CodeId, Group};
use crate::drives::Approach;
use crate::drives::speed::SpeedLimit;
use crate::msg;
use crate::nc::{Block, Dimensioning, Word, WordValue};

/// M codes of a block that act on any control.
pub(super) const M_CODES: u8 = 8;

/// M00.
const STOP: u8 = 1;
/// M01.
const OPTIONAL_STOP: u8 = 2;
/// M02, M30.
const END: u8 = 4;

/// Words that do nothing in most blocks: the centre of an arc, its radius, what is called and how often, all others.
const CENTRE: u8 = 1;
const RADIUS: u8 = 2;
const CALLED: u8 = 4;
const OTHERS: u8 = 8;

/// Which of them a letter is for; 0 where it is for none.
const fn class(letter: u8) -> u8 {
    match letter {
        b'I' | b'J' | b'K' => CENTRE,
        b'R' | long::CR => RADIUS,
        b'P' | b'L' => CALLED,
        b'B' | b'E' | b'Q' => OTHERS,
        _ => 0,
    }
}

/// The codes of a block.
#[derive(Default)]
pub(super) struct Codes {
    /// Dwell, reference return, coordinate setting, macro call …: what the words are for.
    pub(super) special: Option<Code>,
    /// A code that is not simulated takes the axis words.
    pub(super) unmoved: bool,
    /// Blocks from P to Q are a contour, not motions.
    contour: bool,
    /// A code that is not simulated, or the end of one, may take any word.
    any_word: bool,
    /// Exact stop in this block.
    pub(super) exact: bool,
    /// Exact stop mode or cutting mode is commanded.
    path: bool,
    spindle: Option<i8>,
    gear: Option<u8>,
    /// Angle that the spindle goes to.
    orient: Option<(f64, Approach)>,
    auxiliary: [u32; M_CODES as usize],
    auxiliaries: usize,
    /// [`STOP`], [`OPTIONAL_STOP`], [`END`].
    stops: u8,
    /// M98, M99.
    flow: Option<Code>,
    /// A code that calls a program by parameter.
    call: Option<CodeCall>,
    /// An argument is the number of an M code that cannot stand beside a call.
    mixed: bool,
    /// Index of the word that calls a macro.
    caller: usize,
    /// Words that are read: all, or those in front of an optional block skip.
    count: usize,
}

impl Codes {
    /// S is a limit of the speed.
    fn limits(&self) -> bool {
        matches!(self.special, Some(Code::LowerLimits | Code::UpperLimits | Code::SetCoordinates))
    }
}

/// The values of a block.
#[derive(Default)]
pub(super) struct Words {
    pub(super) axes: [i64; AXES],
    /// Bit `k`: axis `k` was programmed.
    pub(super) mask: u8,
    /// Bit `k`: by its incremental address, or as an incremental value.
    pub(super) incremental: u8,
    /// Bit `k`: as an absolute value, whatever is in force.
    pub(super) absolute: u8,
    /// Axes X, Y, Z whose lead is programmed, bit by bit.
    pub(super) leads: u8,
    /// How the axes go to angles.
    pub(super) ways: [Dimensioning; AXES],
    /// I, J, K.
    pub(super) center: [Option<i64>; 3],
    /// I1, J1, K1: a point on the way.
    pub(super) through: [Option<i64>; 3],
    pub(super) radius: Option<i64>,
    /// Degrees that an arc goes round.
    pub(super) turn: Option<f64>,
    pub(super) speed: Option<f64>,
    /// Highest speed under constant surface speed.
    speed_limit: Option<f64>,
    /// Angle that the spindle goes to.
    orient: Option<(f64, Approach)>,
    tool: Option<u32>,
    pub(super) dwell: Option<f64>,
    /// Turns of the spindle that a dwell lasts.
    pub(super) dwell_turns: Option<f64>,
    p: Option<f64>,
    q: Option<f64>,
    h: Option<f64>,
    l: Option<f64>,
    /// Classes of the words that do nothing in most blocks.
    rare: u8,
}

impl State {
    /// Runs a block of words.
    pub(super) fn words(&mut self, cx: &mut BlockContext, at: u32, block: &Block, words: &[Word]) -> Run<()> {
        let surface = self.modal.surface.then(|| self.surface_zero(cx));
        let mut codes = Codes { count: words.len(), ..Codes::default() };
        self.codes(cx, block, words, &mut codes)?;
        let words = words.get(..codes.count).unwrap_or(words);
        if let Some(call) = self.modal_call.as_ref().filter(|call| call.each_block).map(Rc::clone)
            && codes.special != Some(Code::MacroModalEnd)
            && codes.flow.is_none()
            && codes.stops == 0
        {
            let caller = Caller { word: None, all: true };
            let arguments = self.arguments(cx, block, words, caller)?;
            self.counts.macros += 1;
            return self.call_modal(cx, &call, Rc::new(arguments.locals));
        }
        if codes.special.is_some() || codes.call.is_some() {
            if let Some(kind) = macro_kind(&codes) {
                self.counts.macros += 1;
                return self.call_words(cx, at, block, words, &codes, kind);
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
        }
        let mut values = Words::default();
        self.values(cx, block, words, &codes, &mut values)?;
        if let Some(stage) = codes.gear {
            self.queue.push(Canon::Gear { stage });
        }
        if let Some(rpm) = values.speed_limit {
            self.limit_speed(SpeedLimit::Surface, rpm);
        }
        self.speed(cx, &codes, &values, surface)?;
        let stops_last = codes.spindle == Some(0) && cx.shared.rules.spindle.stop_last;
        if let Some(sign) = codes.spindle.filter(|_| !stops_last) {
            self.queue.push(Canon::SpindleDirection { sign });
        }
        for &code in codes.auxiliary.iter().take(codes.auxiliaries) {
            self.queue.push(Canon::Auxiliary { code });
        }
        if let Some(code) = values.tool {
            self.modal.word(b'T', f64::from(code));
            self.queue.push(Canon::Tool { code });
        }
        if codes.path {
            self.queue.push(Canon::PathMode { exact: self.modal.exact });
        }
        if let Some((angle, approach)) = values.orient.or(codes.orient) {
            self.orient(cx, angle, approach)?;
        }
        let moved = self.motion(cx, &codes, &values)?;
        if stops_last {
            self.queue.push(Canon::SpindleDirection { sign: 0 });
        }
        let commands = !self.queue.is_empty();
        if codes.stops & STOP != 0 {
            self.queue.push(Canon::Stop);
        } else if codes.stops & OPTIONAL_STOP != 0 {
            self.queue.push(Canon::OptionalStop);
        }
        if codes.stops & END != 0 {
            self.queue.push(Canon::End);
            self.ended = Some(End::Program);
        }
        // What comes behind a skipped motion may ask where it ended.
        self.pause = codes.stops != 0 || codes.special == Some(Code::Skip);
        if codes.contour {
            self.pass_contour(cx, at, block, words, &values);
        }
        match (codes.flow, codes.call) {
            (_, Some(call)) => {
                let program = f64::from(call.program);
                self.call_sub(cx, Some(program), None, values.l, true)?;
            }
            (Some(Code::SubCall), None) => self.call_sub(cx, values.p, values.h, values.l, false)?,
            (Some(Code::Return), None) if self.frames.is_empty() => {
                return Err(Trap::alarm(Alarm::MainReturn, msg!("interp.main-return")));
            }
            (Some(_), None) => self.end_sub(cx, at, values.p)?,
            (None, None) => {
                if let (true, Some(call)) = (moved, self.modal_call.as_ref().map(Rc::clone)) {
                    let arguments = Rc::clone(&call.arguments);
                    self.call_modal(cx, &call, arguments)?;
                }
            }
        }
        // A call or return alone is over when it is read.
        if (codes.flow.is_some() || codes.call.is_some()) && !commands {
            self.counts.macros += 1;
        } else {
            self.counts.nc += 1;
        }
        Ok(())
    }

    /// Reads codes and values of a block, and does nothing of what they command. Whether the block calls or returns; `None` where that
    /// depends on who has called.
    pub(super) fn read_words(&mut self, cx: &mut BlockContext, block: &Block, words: &[Word]) -> Run<Option<bool>> {
        let mut codes = Codes { count: words.len(), ..Codes::default() };
        self.codes(cx, block, words, &mut codes)?;
        if codes.call.is_some() {
            return Ok(None);
        }
        let called = macro_kind(&codes).is_some();
        if called {
            self.arguments(cx, block, words, Caller { word: Some(codes.caller), all: false })?;
        } else {
            self.values(cx, block, words, &codes, &mut Words::default())?;
        }
        Ok(Some(called || codes.flow.is_some()))
    }

    /// A block whose words are the arguments of a macro.
    fn call_words(
        &mut self,
        cx: &mut BlockContext,
        at: u32,
        block: &Block,
        words: &[Word],
        codes: &Codes,
        kind: CallKind,
    ) -> Run<()> {
        let here = |trap: Trap| match words.get(codes.caller) {
            Some(word) => trap.within(word_span(block, word)),
            None => trap,
        };
        if cx.control.raises(Alarm::CallMixed) && (codes.mixed || codes.stops != 0 || codes.flow.is_some()) {
            return Err(here(Trap::alarm(Alarm::CallMixed, msg!("interp.call-mixed"))));
        }
        let caller = Caller { word: Some(codes.caller), all: false };
        if let (true, None, Some(word)) = (cx.control.macros.program_next, codes.call, words.get(codes.caller + 1))
            && !matches!(word.letter, b'P' | b'H')
        {
            let trap = Trap::alarm(Alarm::NoCallProgram, msg!("interp.call-program-next"));
            return Err(trap.within(word_span(block, word)));
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

    /// Puts the codes of a block in force.
    #[inline]
    fn codes(&mut self, cx: &mut BlockContext, block: &Block, words: &[Word], codes: &mut Codes) -> Run<()> {
        for (at, word) in words.iter().enumerate() {
            match word.letter {
                b'G' => {
                    let Some(number) = self.code_number(cx, block, word)? else { continue };
                    let id = CodeId::G(number);
                    if self.calls(cx, id, at, codes) {
                        continue;
                    }
                    let Some(row) = cx.codes().row(id) else {
                        let written = self.raw(cx, block, word)?.unwrap_or(0.0);
                        let trap = Trap::alarm(Alarm::UnknownCode, msg!("interp.unknown-code", written));
                        return Err(trap.within(word_span(block, word)));
                    };
                    self.g_code(cx, row, at, codes);
                }
                // Behind a macro call it is an argument.
                b'M' if codes.special.is_some() && macro_kind(codes).is_some() => codes.mixed |= mixes(cx, word),
                b'M' if self.spindle_of(word) > 1 && self.other_spindle(cx, block, word)? => {}
                b'M' if at + 1 < words.len() && self.is_overtaken(cx, block, words, at)? => {}
                b'M' => self.m_word(cx, block, word, at, codes)?,
                long::NAME => self.named_code(cx, word, at, codes),
                b'/' if self.skips(cx, word) => {
                    codes.count = at;
                    break;
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// The spindle that a word is for.
    #[inline]
    fn spindle_of(&self, word: &Word) -> u8 {
        word.index.unwrap_or(self.modal.master)
    }

    /// Takes an M word of another spindle than the machine's own; whether it is that spindle's.
    #[cold]
    fn other_spindle(&mut self, cx: &mut BlockContext, block: &Block, word: &Word) -> Run<bool> {
        let Some(number) = self.whole(cx, block, word)? else { return Ok(word.index.is_some()) };
        let sign = match cx.codes().row(CodeId::M(number as u32)).map(|row| row.code) {
            Some(Code::SpindleCw) => 1,
            Some(Code::SpindleCcw) => -1,
            Some(Code::SpindleStop) => 0,
            Some(Code::SpindleOrient | Code::GearStage(_)) => {
                let spindle = u32::from(self.spindle_of(word));
                self.remark(cx, word_span(block, word), msg!("interp.other-spindle-word", spindle));
                return Ok(true);
            }
            _ => return Ok(word.index.is_some()),
        };
        self.modal.other.1 = sign != 0;
        self.queue.push(Canon::OtherSpindle { spindle: self.spindle_of(word), sign });
        Ok(true)
    }

    /// Whether so many M codes follow that this one does not act.
    fn is_overtaken(&self, cx: &mut BlockContext, block: &Block, words: &[Word], at: usize) -> Run<bool> {
        let most = cx.shared.rules.m_codes;
        let mut behind = 0;
        for word in words.get(at + 1..).unwrap_or_default() {
            match word.letter {
                b'/' if self.skips(cx, word) => break,
                b'M' if word.index.is_none_or(|spindle| spindle <= 1) && self.raw(cx, block, word)?.is_some() => {
                    behind += 1;
                }
                _ => continue,
            }
            if behind == most && cx.shared.rules.m_alarm {
                let trap = Trap::alarm(Alarm::Auxiliaries, msg!("interp.m-codes", u32::from(most)));
                return Err(trap.within(word_span(block, word)));
            }
        }
        if behind >= most
            && let Some(word) = words.get(at)
        {
            self.remark(cx, word_span(block, word), msg!("interp.m-code-dropped", u32::from(most)));
        }
        Ok(behind >= most)
    }

    /// Goes on behind the contour of a cycle that is not simulated, where it lies ahead.
    #[cold]
    fn pass_contour(&mut self, cx: &mut BlockContext, at: u32, block: &Block, words: &[Word], values: &Words) {
        let number = |value: Option<f64>| value.filter(|value| (1.0..1e9).contains(value)).map(|value| value as u32);
        let (Some(first), Some(last)) = (number(values.p), number(values.q)) else { return };
        let index = &cx.shared.index;
        let start = index.sequence(self.program, first, at.saturating_add(1)).filter(|&start| start > at);
        let end = start.and_then(|start| Some((start, index.sequence(self.program, last, start)?)));
        let Some((_, end)) = end.filter(|(start, end)| end >= start) else { return };
        self.at = end.saturating_add(1);
        let word = words.iter().find(|word| word.letter == b'G');
        let span = word.map_or(block.span, |word| word_span(block, word));
        self.remark(cx, span, msg!("interp.contour", first, last));
    }

    /// Takes a code that is a name.
    #[cold]
    fn named_code(&mut self, cx: &BlockContext, word: &Word, at: usize, codes: &mut Codes) {
        match cx.codes().row_of(word) {
            Some(row) if row.code == Code::Return => codes.flow = Some(Code::Return),
            Some(row) if row.code == Code::MasterSpindle => self.modal.master = word.index.unwrap_or(1),
            Some(row) => self.g_code(cx, row, at, codes),
            None => {}
        }
    }

    /// Whether an optional block skip in the middle of a block is switched on.
    #[cold]
    fn skips(&self, cx: &mut BlockContext, word: &Word) -> bool {
        let WordValue::Number(number) = word.value else { return false };
        cx.world.block_skip(u8::try_from(number.mantissa).unwrap_or(1).max(1))
    }

    /// Takes a code that calls a program. Within a program that was called by a code there are none.
    #[inline]
    fn calls(&self, cx: &BlockContext, id: CodeId, at: usize, codes: &mut Codes) -> bool {
        let call = cx.codes().call(id).filter(|_| !self.called_by_code());
        if call.is_some() {
            (codes.call, codes.caller) = (call.copied(), at);
        }
        call.is_some()
    }

    #[inline]
    fn g_code(&mut self, cx: &BlockContext, row: &crate::controls::CodeDef, at: usize, codes: &mut Codes) {
        use Code::*;
        match row.code {
            GoTo(_) | Dwell | ReferenceReturn | MachineCoordinates | MachineRapid | SetCoordinates
            | LocalCoordinates | Offset | OffsetMore | LowerLimits | UpperLimits | MacroCall | MacroModal
            | MacroModalBlock | MacroModalEnd | Skip => {
                (codes.special, codes.caller) = (Some(row.code), at);
            }
            Tapping if row.group == Group::OneShot => codes.special = Some(row.code),
            ExactStopOnce => codes.exact = true,
            ExactStop | Cutting => codes.path = self.modal.exact != (row.code == ExactStop),
            NotSimulated | Cancel => {
                codes.any_word = true;
                codes.unmoved |= row.code == NotSimulated && row.group == Group::OneShot;
            }
            Roughing => (codes.any_word, codes.unmoved, codes.contour) = (true, true, true),
            _ => {}
        }
        self.modal.set(cx.control, row);
    }

    fn m_word(&mut self, cx: &mut BlockContext, block: &Block, word: &Word, at: usize, codes: &mut Codes) -> Run<()> {
        let Some(number) = self.whole(cx, block, word)? else { return Ok(()) };
        if !(0.0..=99_999_999.0).contains(&number) {
            return Err(self.out_of_range(cx, block, word, 0.0, 99_999_999.0));
        }
        let number = number as u32;
        self.modal.word(b'M', f64::from(number));
        let id = CodeId::M(number);
        if self.calls(cx, id, at, codes) {
            return Ok(());
        }
        match cx.codes().row(id).map(|row| row.code) {
            Some(Code::End | Code::EndRewind) if cx.shared.rules.ends_return && !self.frames.is_empty() => {
                codes.flow = Some(Code::SubEnd);
            }
            Some(Code::Stop) => codes.stops |= STOP,
            Some(Code::OptionalStop) => codes.stops |= OPTIONAL_STOP,
            Some(Code::End | Code::EndRewind) => codes.stops |= END,
            Some(code @ (Code::SubCall | Code::SubEnd)) => codes.flow = Some(code),
            Some(Code::SpindleCw) => codes.spindle = Some(1),
            Some(Code::SpindleCcw) => codes.spindle = Some(-1),
            Some(Code::SpindleStop) => codes.spindle = Some(0),
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

    /// Reads the values of a block; F stays in force.
    #[inline]
    fn values(
        &mut self,
        cx: &mut BlockContext,
        block: &Block,
        words: &[Word],
        codes: &Codes,
        values: &mut Words,
    ) -> Run<()> {
        let inch = self.modal.inch;
        let thread = matches!(self.modal.motion, Code::Thread | Code::Tapping);
        // Limits behind S, and the first S of a surface speed, are words of their own.
        let surface = self.modal.surface && !codes.limits();
        for word in words {
            let letter = word.letter;
            // Words of another spindle, or of what is not simulated.
            let spindles = matches!(letter, b'M' | b'S' | long::SPOS | long::LIMS);
            // Whatever stands behind the axes that go to a point: X1=0.
            if let (Some(Code::GoTo(_)), Some((axis, _))) = (codes.special, cx.shared.index.axis(letter)) {
                values.mask |= 1 << axis;
                continue;
            }
            if spindles && self.spindle_of(word) > 1 && codes.special != Some(Code::Dwell)
                || !spindles && word.index.is_some()
            {
                self.indexed_word(cx, block, word, values)?;
                continue;
            }
            if codes.special == Some(Code::Dwell) && cx.control.syntax.dwell_addresses.contains(&letter) {
                let value = self.dwell_word(cx, block, word)?;
                *(if letter == b'S' { &mut values.dwell_turns } else { &mut values.dwell }) = value;
            } else if let Some((axis, incremental)) = cx.shared.index.axis(letter) {
                let inch = inch && !cx.control.axes[axis].rotary;
                let bit = 1 << axis;
                let yields = incremental && values.mask & bit != 0 && cx.control.syntax.absolute_holds;
                if let (Some(value), false) = (self.dimension(cx, block, word, inch)?, yields) {
                    values.axes[axis] = value;
                    values.mask |= bit;
                    let relative = incremental || word.form == Dimensioning::Incremental;
                    if relative || values.incremental != 0 {
                        values.incremental = values.incremental & !bit | u8::from(relative) << axis;
                    }
                    if !matches!(word.form, Dimensioning::Plain | Dimensioning::Incremental) {
                        values.absolute |= bit;
                        values.ways[axis] = word.form;
                    }
                }
            } else {
                match letter {
                    b'F' if thread && !cx.control.syntax.lead_by_axis => {
                        if let Some(lead) = self.lead_word(cx, block, word, inch)? {
                            self.modal.lead = Some(lead);
                            self.modal.word(b'F', lead);
                        }
                    }
                    b'F' => {
                        if let Some(feed) = self.feed_word(cx, block, word, self.modal.inch_feed)? {
                            self.modal.feed = Some(feed);
                            self.modal.word(b'F', feed);
                        }
                    }
                    b'S' => values.speed = self.speed_word(cx, block, word, surface)?,
                    b'T' => {
                        let tool = self.whole(cx, block, word)?;
                        if let Some(tool) = tool {
                            let most = f64::from(cx.control.limits.tool_max);
                            if !(0.0..=most).contains(&tool) {
                                return Err(self.out_of_range(cx, block, word, 0.0, most));
                            }
                            values.tool = Some(tool as u32);
                        }
                    }
                    _ if thread && cx.control.syntax.threads_per_inch == Some(letter) => {
                        let lead = match cx.shared.rules.fine_lead {
                            true => self.lead_word(cx, block, word, inch)?,
                            false => self.threads_word(cx, block, word)?,
                        };
                        self.modal.lead = lead.or(self.modal.lead);
                    }
                    b'I' | b'J' | b'K' if thread && cx.control.syntax.lead_by_axis => {
                        self.modal.lead = self.lead_word(cx, block, word, inch)?.or(self.modal.lead);
                        values.leads |= 1 << (letter - b'I');
                    }
                    b'I' | b'J' | b'K' => {
                        values.center[(letter - b'I') as usize] = self.dimension(cx, block, word, inch)?;
                        values.rare |= CENTRE;
                    }
                    b'R' | long::CR => {
                        values.radius = self.dimension(cx, block, word, inch)?;
                        values.rare |= RADIUS;
                    }
                    long::AR => {
                        values.turn = self.raw(cx, block, word)?;
                        if let Some(turn) = values.turn.filter(|turn| !(*turn > 0.0 && *turn < 360.0)) {
                            let trap = Trap::alarm(Alarm::Arc, msg!("interp.arc-angle", (turn, 9)));
                            return Err(trap.within(word_span(block, word)));
                        }
                    }
                    long::LIMS => values.speed_limit = self.speed_word(cx, block, word, false)?,
                    long::SPOS => {
                        let approach = match word.form {
                            Dimensioning::Plain | Dimensioning::Absolute | Dimensioning::Shortest => Approach::Direct,
                            Dimensioning::Positive => Approach::Clockwise,
                            Dimensioning::Negative => Approach::CounterClockwise,
                            Dimensioning::Incremental => Approach::Incremental,
                        };
                        values.orient = self.raw(cx, block, word)?.map(|angle| (angle, approach));
                    }
                    b'P' | b'L' => {
                        let number = self.whole(cx, block, word)?;
                        *(if letter == b'P' { &mut values.p } else { &mut values.l }) = number;
                        values.rare |= CALLED;
                    }
                    b'Q' => {
                        values.q = self.raw(cx, block, word)?;
                        values.rare |= OTHERS;
                    }
                    b'D' | b'H' => {
                        let number = self.whole(cx, block, word)?;
                        if let Some(number) = number {
                            let most = cx.control.limits.offset_max.filter(|_| letter == b'D').map(f64::from);
                            if let Some(most) = most.filter(|most| !(0.0..=*most).contains(&number)) {
                                return Err(self.out_of_range(cx, block, word, 0.0, most));
                            }
                            self.modal.word(letter, number);
                        }
                        if letter == b'H' {
                            values.h = number;
                        }
                    }
                    b'B' | b'E' => values.rare |= OTHERS,
                    _ => {}
                }
            }
        }
        let idle = values.rare != 0 && values.rare & !self.uses(codes, values) != 0;
        if idle || codes.special == Some(Code::Dwell) && values.mask != 0 {
            self.idle_words(cx, block, words, (codes, values))?;
        }
        if self.modal.radii != Radii::No {
            self.double(cx, values);
        }
        Ok(())
    }

    /// A word of another spindle, or of a point on the way; all others with a number are of what is not simulated.
    #[cold]
    fn indexed_word(&mut self, cx: &mut BlockContext, block: &Block, word: &Word, values: &mut Words) -> Run<()> {
        let at = usize::from(word.letter.wrapping_sub(b'I'));
        if word.letter == b'S' {
            self.modal.other.0 = self.speed_word(cx, block, word, false)?.unwrap_or(self.modal.other.0);
        } else if matches!(word.letter, long::SPOS | long::LIMS) {
            let spindle = u32::from(self.spindle_of(word));
            self.remark(cx, word_span(block, word), msg!("interp.other-spindle-word", spindle));
        } else if let (Code::ArcThrough, Some(1), Some(_)) = (self.modal.motion, word.index, values.through.get(at)) {
            values.through[at] = self.dimension(cx, block, word, self.modal.inch)?;
        }
        Ok(())
    }

    /// The classes of rare words that do something in a block with these codes.
    #[inline]
    fn uses(&self, codes: &Codes, values: &Words) -> u8 {
        let any = codes.any_word || codes.call.is_some() || self.modal.cycle || self.modal.motion == Code::NotSimulated;
        let arc = matches!(self.modal.motion, Code::ArcCw | Code::ArcCcw);
        match (any, arc) {
            (true, _) => u8::MAX,
            // An arc that has its radius needs no centre.
            (_, true) if values.radius.is_some() => RADIUS,
            (_, true) => CENTRE,
            (_, false) if codes.flow.is_some() => CALLED,
            _ => 0,
        }
    }

    /// Remarks the words of a block that do nothing in it, or refuses them where the control does.
    #[cold]
    fn idle_words(
        &self,
        cx: &mut BlockContext,
        block: &Block,
        words: &[Word],
        (codes, values): (&Codes, &Words),
    ) -> Run<()> {
        let (uses, dwell) = (self.uses(codes, values), codes.special == Some(Code::Dwell));
        for word in words {
            let class = match word.letter {
                letter if dwell && cx.control.syntax.dwell_addresses.contains(&letter) => continue,
                letter if letter.is_ascii_alphabetic() && cx.shared.index.axis(letter).is_some() => {
                    if !dwell {
                        continue;
                    }
                    0
                }
                letter if class(letter) != 0 => class(letter),
                _ => continue,
            };
            let corner = cx.control.syntax.corners.iter().any(|corner| corner.0 == word.letter);
            let thread = self.modal.motion == Code::Thread && cx.control.syntax.threads_per_inch == Some(word.letter);
            if uses & class == 0 && !corner && !thread {
                let message = msg!("interp.idle-word", cx.control.address(word.letter));
                if cx.control.raises(Alarm::IdleAddress) {
                    return Err(Trap::alarm(Alarm::IdleAddress, message).within(word_span(block, word)));
                }
                self.remark(cx, word_span(block, word), message);
            }
        }
        Ok(())
    }

    /// Words that count radii, on an axis whose positions are diameters.
    #[cold]
    fn double(&self, cx: &BlockContext, values: &mut Words) {
        for k in (0..AXES).filter(|&k| cx.shared.rules.moves[k] != 1.0) {
            let bit = 1 << k;
            let relative = (values.incremental & bit != 0 || !self.modal.absolute) && values.absolute & bit == 0;
            if self.modal.radii == Radii::All || relative {
                values.axes[k] = values.axes[k].saturating_mul(2);
            }
            let letter = cx.control.axes.get(k).map_or(0, |axis| axis.letter);
            if self.modal.radii == Radii::All || !self.modal.absolute {
                let point = values.through.get_mut(usize::from(letter.wrapping_sub(b'X')));
                point.into_iter().flatten().for_each(|value| *value = value.saturating_mul(2));
            }
        }
    }
}

/// How the block calls a macro with its words as arguments, if it does.
fn macro_kind(codes: &Codes) -> Option<CallKind> {
    match (codes.call, codes.special) {
        (Some(call), _) => (call.kind != CallKind::Sub).then_some(call.kind),
        (None, Some(Code::MacroCall)) => Some(CallKind::Macro),
        (None, Some(Code::MacroModal)) => Some(CallKind::Modal),
        (None, Some(Code::MacroModalBlock)) => Some(CallKind::ModalBlock),
        (None, _) => None,
    }
}

/// Whether an M word in a macro call is one that stops, ends, calls or returns.
#[cold]
fn mixes(cx: &BlockContext, word: &Word) -> bool {
    use Code::{End, EndRewind, OptionalStop, Stop, SubCall, SubEnd};
    let row = cx.codes().row_of(word);
    row.is_some_and(|row| matches!(row.code, Stop | OptionalStop | End | EndRewind | SubCall | SubEnd))
}

//! The values of a block: axis words, feeds, speeds and the words that only some codes use.

use super::canon::AXES;
use super::codes::BlockCodes;
use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::modal::Radii;
use super::state::RunState;
use super::value::inches;
use crate::controls::Address;
use crate::controls::{Alarm, Code};
use crate::drives::Approach;
use crate::msg;
use crate::nc::{Block, Dec, Dimensioning, Word, WordValue};
use crate::text::{Diagnostic, Place};

/// Bit flags for words that only some codes use: I/J/K, R, P/L, and letters of missing axes, of cycles and of offsets.
const CENTRE: u8 = 1;

const RADIUS: u8 = 2;

const CALLED: u8 = 4;

const OTHERS: u8 = 8;

/// The flag of a letter; 0 for letters allowed in every block.
const fn class(letter: Address) -> u8 {
    match letter {
        Address::I | Address::J | Address::K => CENTRE,
        Address::R | Address::Cr => RADIUS,
        Address::P | Address::L => CALLED,
        Address::A | Address::B | Address::D | Address::E | Address::Q | Address::U | Address::V | Address::W => OTHERS,
        _ => 0,
    }
}

/// The words of calls, returns and cycles: P, Q, H, L.
#[derive(Default)]
pub(super) struct CallWords {
    pub(super) p: Option<f64>,
    pub(super) q: Option<f64>,
    pub(super) h: Option<f64>,
    pub(super) l: Option<f64>,
}

/// The values of a block.
#[derive(Default)]
pub(super) struct BlockWords {
    pub(super) axes: [i64; AXES],
    /// Bit `k`: axis `k` was programmed.
    pub(super) mask: u8,
    /// Bit `k`: axis `k` was programmed by its incremental address or as an incremental value.
    pub(super) incremental: u8,
    /// Bit `k`: axis `k` was programmed as an absolute value by the word itself.
    pub(super) absolute: u8,
    /// Bit 0 to 2: the lead along X, Y, Z is programmed.
    pub(super) leads: u8,
    /// Direction in which each axis approaches its angle.
    pub(super) ways: [Dimensioning; AXES],
    /// I, J, K.
    pub(super) center: [Option<i64>; 3],
    /// Bit 0 to 2: I, J, K is a position by the word itself, `I=AC(40)`, and no distance from the start of the arc.
    pub(super) center_absolute: u8,
    /// I1, J1, K1: an intermediate point of the arc.
    pub(super) through: [Option<i64>; 3],
    pub(super) radius: Option<i64>,
    /// Swept angle of an arc in degrees (AR).
    pub(super) turn: Option<f64>,
    pub(super) speed: Option<f64>,
    /// Highest speed under constant surface speed.
    pub(super) speed_limit: Option<f64>,
    /// Spindle orientation: angle in degrees and approach.
    pub(super) orient: Option<(f64, Approach)>,
    pub(super) tool: Option<u32>,
    pub(super) dwell: Option<f64>,
    /// Dwell in spindle revolutions.
    pub(super) dwell_turns: Option<f64>,
    pub(super) call: CallWords,
    /// Flags of the programmed words that only some codes use.
    pub(super) rare: u8,
}

impl RunState {
    /// Reads the values of a block; F stays in force.
    #[inline]
    pub(super) fn values(
        &mut self,
        cx: &mut BlockContext,
        block: &Block,
        words: &[Word],
        codes: &BlockCodes,
        values: &mut BlockWords,
    ) -> BlockResult<()> {
        let inch = self.modal.inch;
        let dwell = codes.special == Some(Code::Dwell);
        // Limits by S, and the first S of a surface speed, are handled elsewhere.
        let surface = self.modal.spindle.surface && !codes.s_is_limit();
        for word in words {
            let letter = word.letter;
            // Words of a second spindle, and words that are not simulated.
            let spindles = matches!(letter, Address::M | Address::S | Address::Spos | Address::Lims);
            // G74 and G75 ignore the value of an axis word: X1=0.
            if let (Some(Code::GoTo(_)), Some((axis, _))) = (codes.special, cx.shared.index.axis(letter)) {
                values.mask |= 1 << axis;
                continue;
            }
            if spindles && self.spindle_of(word) > 1 && !dwell || !spindles && word.index.is_some() {
                self.indexed_word(cx, block, word, values)?;
                continue;
            }
            if dwell && cx.control.syntax.dwell_addresses.contains(letter) {
                let value = self.dwell_word(cx, block, word)?;
                *(if letter == Address::S { &mut values.dwell_turns } else { &mut values.dwell }) = value;
            } else if let Some(axis) = cx.shared.index.axis(letter) {
                self.axis_word(cx, block, word, axis, values)?;
            } else {
                match letter {
                    Address::F => self.f_word(cx, block, word)?,
                    Address::S => values.speed = self.speed_word(cx, block, word, surface)?,
                    Address::T => values.tool = self.tool_word(cx, block, word)?.or(values.tool),
                    _ if self.cuts_threads() && self.thread_word(cx, block, word, values)? => {}
                    Address::I | Address::J | Address::K => {
                        let at = letter.after(Address::I).unwrap_or(0);
                        values.center[at] = self.dimension(cx, block, word, inch)?;
                        values.center_absolute |= u8::from(word.form == Dimensioning::Absolute) << at;
                        values.rare |= CENTRE;
                    }
                    Address::R | Address::Cr => {
                        values.radius = self.dimension(cx, block, word, inch)?;
                        values.rare |= RADIUS;
                    }
                    _ => self.rare_word(cx, block, word, values)?,
                }
            }
        }
        let idle = values.rare != 0 && values.rare & !self.uses(codes, values) != 0;
        if idle || dwell && values.mask != 0 {
            self.idle_words(cx, block, words, (codes, values))?;
        }
        if self.modal.radii != Radii::No {
            self.double_radii(cx, values);
        }
        if codes.data {
            self.modal.unmoved.data = cx.codes().opens_data(words);
        }
        Ok(())
    }

    /// Whether the motion in force uses a thread lead.
    #[inline]
    fn cuts_threads(&self) -> bool {
        matches!(self.modal.motion, Code::Thread | Code::Tapping)
    }

    /// Reads an axis word, absolute or incremental.
    #[inline]
    fn axis_word(
        &self,
        cx: &mut BlockContext,
        block: &Block,
        word: &Word,
        (axis, incremental): (usize, bool),
        values: &mut BlockWords,
    ) -> BlockResult<()> {
        let inch = self.modal.inch && !cx.control.axes[axis].rotary;
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
        Ok(())
    }

    /// F: the feed, or the lead of a thread.
    #[inline]
    fn f_word(&mut self, cx: &mut BlockContext, block: &Block, word: &Word) -> BlockResult<()> {
        let lead = self.cuts_threads() && !cx.control.syntax.lead_by_axis;
        let inch = if lead { self.modal.inch } else { self.modal.inch_feed };
        let value = if lead { self.lead_word(cx, block, word, inch)? } else { self.feed_word(cx, block, word, inch)? };
        if let Some(value) = value {
            *(if lead { &mut self.modal.lead } else { &mut self.modal.feed }) = Some(value);
            self.modal.set_shown(Address::F, if inch { inches(value) } else { value });
        }
        Ok(())
    }

    /// T: a tool number within its range.
    fn tool_word(&self, cx: &mut BlockContext, block: &Block, word: &Word) -> BlockResult<Option<u32>> {
        let Some(tool) = self.whole(cx, block, word)? else { return Ok(None) };
        let most = f64::from(cx.control.limits.tool_max);
        if (0.0..=most).contains(&tool) {
            Ok(Some(tool as u32))
        } else {
            Err(self.out_of_range(cx, block, word, 0.0, most))
        }
    }

    /// Reads the lead of a thread by I, J, K or by threads per inch; returns whether the word is one.
    #[cold]
    fn thread_word(
        &mut self,
        cx: &mut BlockContext,
        block: &Block,
        word: &Word,
        values: &mut BlockWords,
    ) -> BlockResult<bool> {
        let inch = self.modal.inch;
        let lead = match word.letter {
            letter if cx.control.syntax.threads_per_inch == Some(letter) => {
                if cx.shared.rules.numbers.fine_lead {
                    self.lead_word(cx, block, word, inch)?
                } else {
                    self.threads_word(cx, block, word)?
                }
            }
            Address::I | Address::J | Address::K if cx.control.syntax.lead_by_axis => {
                values.leads |= 1 << word.letter.after(Address::I).unwrap_or(0);
                self.lead_word(cx, block, word, inch)?
            }
            _ => return Ok(false),
        };
        self.modal.lead = lead.or(self.modal.lead);
        Ok(true)
    }

    /// Reads a word that few blocks have: AR, LIMS, SPOS, P, L, Q, D, H, B, E.
    fn rare_word(
        &mut self,
        cx: &mut BlockContext,
        block: &Block,
        word: &Word,
        values: &mut BlockWords,
    ) -> BlockResult<()> {
        match word.letter {
            Address::Ar => {
                values.turn = self.raw(cx, block, word)?;
                if let Some(turn) = values.turn.filter(|turn| !(*turn > 0.0 && *turn < 360.0)) {
                    let trap = Trap::alarm(Alarm::Arc, msg!("interp.arc-angle", angle = (turn, 9)));
                    return Err(trap.within(word.span(block)));
                }
            }
            Address::Lims => values.speed_limit = self.speed_word(cx, block, word, false)?,
            Address::Spos => {
                let approach = match word.form {
                    Dimensioning::Plain | Dimensioning::Absolute | Dimensioning::Shortest => Approach::Direct,
                    Dimensioning::Positive => Approach::Clockwise,
                    Dimensioning::Negative => Approach::CounterClockwise,
                    Dimensioning::Incremental => Approach::Incremental,
                };
                values.orient = self.raw(cx, block, word)?.map(|angle| (angle, approach));
            }
            Address::P | Address::L => {
                let number = self.whole(cx, block, word)?;
                *(if word.letter == Address::P { &mut values.call.p } else { &mut values.call.l }) = number;
                values.rare |= CALLED;
            }
            Address::Q => {
                values.call.q = self.raw(cx, block, word)?;
                values.rare |= OTHERS;
            }
            Address::D | Address::H => {
                let number = self.whole(cx, block, word)?;
                if let Some(number) = number {
                    let most = cx.control.limits.offset_max.filter(|_| word.letter == Address::D).map(f64::from);
                    if let Some(most) = most.filter(|most| !(0.0..=*most).contains(&number)) {
                        return Err(self.out_of_range(cx, block, word, 0.0, most));
                    }
                    self.modal.set_shown(word.letter, number);
                }
                if word.letter == Address::H {
                    values.call.h = number;
                } else if !cx.shared.units.integer_letters.contains(word.letter) {
                    // On controls without offset numbers D belongs to cycles and corners.
                    values.rare |= OTHERS;
                }
            }
            letter if class(letter) == OTHERS => values.rare |= OTHERS,
            _ => {}
        }
        Ok(())
    }

    /// Reads a word of a second spindle or of an intermediate point; other indexed words are not simulated.
    #[cold]
    fn indexed_word(
        &mut self,
        cx: &mut BlockContext,
        block: &Block,
        word: &Word,
        values: &mut BlockWords,
    ) -> BlockResult<()> {
        let at = word.letter.after(Address::I).unwrap_or(usize::MAX);
        if word.letter == Address::S {
            self.modal.spindle.second.rpm =
                self.speed_word(cx, block, word, false)?.unwrap_or(self.modal.spindle.second.rpm);
        } else if matches!(word.letter, Address::Spos | Address::Lims) {
            let spindle = u32::from(self.spindle_of(word));
            self.remark(cx, word.span(block), msg!("interp.other-spindle-word", spindle));
        } else if let (Code::ArcThrough, Some(1), Some(_)) = (self.modal.motion, word.index, values.through.get(at)) {
            values.through[at] = self.dimension(cx, block, word, self.modal.inch)?;
        }
        Ok(())
    }

    /// Flags of the rare words that have an effect in a block with these codes.
    #[inline]
    fn uses(&self, codes: &BlockCodes, values: &BlockWords) -> u8 {
        let any = codes.any_word
            || codes.call.is_some()
            || self.modal.unmoved.any()
            || self.modal.motion == Code::NotSimulated;
        let arc = matches!(self.modal.motion, Code::ArcCw | Code::ArcCcw);
        let called = if codes.flow.is_some() { CALLED } else { 0 };
        match (any, arc) {
            (true, _) => u8::MAX,
            // An arc by radius needs no centre.
            (_, true) if values.radius.is_some() => RADIUS | called,
            (_, true) => CENTRE | called,
            _ => called,
        }
    }

    /// Warns about words without effect in their block, or raises the control's alarm for them.
    #[cold]
    fn idle_words(
        &self,
        cx: &mut BlockContext,
        block: &Block,
        words: &[Word],
        (codes, values): (&BlockCodes, &BlockWords),
    ) -> BlockResult<()> {
        let (uses, dwell) = (self.uses(codes, values), codes.special == Some(Code::Dwell));
        for word in words {
            let class = match word.letter {
                letter if dwell && cx.control.syntax.dwell_addresses.contains(letter) => continue,
                Address::D if cx.shared.units.integer_letters.contains(Address::D) => continue,
                letter if !letter.is_long() && cx.shared.index.axis(letter).is_some() => {
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
                let message = msg!("interp.idle-word", address = cx.control.address(word.letter));
                if cx.control.raises(Alarm::IdleAddress) {
                    return Err(Trap::alarm(Alarm::IdleAddress, message).within(word.span(block)));
                }
                let mut remark = Diagnostic::warning(message).at(Place { file: self.file, span: word.span(block) });
                if word.letter == Address::P && local_call(cx, words) {
                    remark = remark.hint(msg!("interp.hint-local-call"));
                }
                cx.world.remark(remark);
            }
        }
        Ok(())
    }

    /// Doubles words that count radii on an axis whose positions are diameters.
    #[cold]
    fn double_radii(&self, cx: &BlockContext, values: &mut BlockWords) {
        for k in (0..AXES).filter(|&k| cx.shared.rules.moves[k] != 1.0) {
            let bit = 1 << k;
            let relative = (values.incremental & bit != 0 || !self.modal.absolute) && values.absolute & bit == 0;
            if self.modal.radii == Radii::All || relative {
                values.axes[k] = values.axes[k].saturating_mul(2);
            }
            let at = cx.control.axes.get(k).and_then(|axis| axis.letter.after(Address::X));
            if let Some(at) = at.filter(|at| self.modal.radii == Radii::All && values.center_absolute >> at & 1 != 0) {
                let center = values.center.get_mut(at);
                center.into_iter().flatten().for_each(|value| *value = value.saturating_mul(2));
            }
            if self.modal.radii == Radii::All || !self.modal.absolute {
                let point = at.and_then(|at| values.through.get_mut(at));
                point.into_iter().flatten().for_each(|value| *value = value.saturating_mul(2));
            }
        }
    }
}

/// Whether a block has M97, the call of a part of the same program on the controls of Haas, and the control has no such code.
#[cold]
fn local_call(cx: &BlockContext, words: &[Word]) -> bool {
    let number = WordValue::Number(Dec::int(97));
    words.iter().any(|word| word.letter == Address::M && word.value == number && cx.codes().row_of(word).is_none())
}

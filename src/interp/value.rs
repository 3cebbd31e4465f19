//! Words as numbers: command increments, feeds, whole numbers, with the effect of the decimal point and the range of each address.

use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::operators::WHOLE;
use super::state::RunState;
use crate::controls::Address;
use crate::controls::{Alarm, Code, CodeNumber};
use crate::msg;
use crate::nc::dec::POW10;
use crate::nc::{Block, Dec, Word, WordValue};
use crate::text::units::INCH;

/// Tenths of a millimetre per inch.
const INCH_TENTHS: i64 = 254;
/// Additional decimals of the increment in inches: 0.0001 inch if the metric increment is 0.001 mm.
const INCH_DECIMALS: usize = 1;

/// Parts of an inch to which a read length is rounded, finer than any step of a control: 2 inches stay 2.
const INCH_PARTS: f64 = 1e8;

/// A length in inches.
pub(super) fn inches(millimetres: f64) -> f64 {
    (millimetres / INCH * INCH_PARTS).round() / INCH_PARTS
}

/// `mantissa / 10^scale`, rounded half away from zero; exact.
#[inline]
fn rounded_scale(mantissa: i64, scale: i32) -> Option<i64> {
    if scale <= 0 {
        return mantissa.checked_mul(*POW10.get(scale.unsigned_abs() as usize)?);
    }
    let divisor = *POW10.get(scale as usize)?;
    let (whole, rest) = (mantissa / divisor, mantissa % divisor);
    Some(if rest.unsigned_abs() * 2 >= divisor as u64 { whole + mantissa.signum() } else { whole })
}

/// Truncates to a whole number, with a tolerance for rounding errors.
fn truncated(value: f64) -> f64 {
    let nearest = value.round();
    if (value - nearest).abs() < WHOLE { nearest } else { value.trunc() }
}

impl RunState {
    /// Command increments per mm, or per inch in inch input.
    pub(super) fn increments_per_unit(&self, cx: &BlockContext) -> f64 {
        let per_unit = cx.shared.units.per_unit;
        if self.modal.inch { per_unit * POW10[INCH_DECIMALS] as f64 } else { per_unit }
    }

    /// Value of a word as written; `None` if it is vacant and the word is left out. On some controls a vacant word is 0.
    pub(super) fn raw(&self, cx: &mut BlockContext, block: &Block, word: &Word) -> BlockResult<Option<f64>> {
        if !cx.shared.rules.numbers.round_to_step {
            return self.as_written(cx, block, word);
        }
        let units = &cx.shared.units;
        cx.parts = match word.letter {
            letter if units.integer_letters.contains(letter) => 1.0,
            Address::F => units.per_feed,
            _ => self.increments_per_unit(cx),
        };
        let value = self.as_written(cx, block, word);
        cx.parts = 1.0;
        value
    }

    /// Value of a word as written, with ROUND to a whole number, as in macro arguments.
    fn as_written(&self, cx: &mut BlockContext, block: &Block, word: &Word) -> BlockResult<Option<f64>> {
        match word.value {
            WordValue::Number(dec) => Ok(Some(dec.to_f64())),
            WordValue::Expr(id) => match self.value(cx, id) {
                Ok(value) if value.is_nan() => Ok(cx.shared.rules.vacant_word.then_some(0.0)),
                Ok(value) => Ok(Some(value)),
                Err(trap) => Err(trap.within(word.span(block))),
            },
        }
    }

    /// Whether a number without a decimal point after this address counts command increments.
    #[inline]
    fn counts_increments(&self, cx: &BlockContext, letter: Address, dec: Dec) -> bool {
        !dec.point && !cx.shared.rules.numbers.whole_units && cx.shared.units.increment_letters.contains(letter)
    }

    /// Value of a word as a macro argument.
    pub(super) fn argument(&self, cx: &mut BlockContext, block: &Block, word: &Word) -> BlockResult<Option<f64>> {
        match word.value {
            WordValue::Number(dec) if self.counts_argument(cx, word) => {
                Ok(Some(dec.to_f64() / cx.shared.units.per_unit))
            }
            _ => self.as_written(cx, block, word),
        }
    }

    /// Whether a macro argument is a number without a decimal point that counts command increments.
    pub(super) fn counts_argument(&self, cx: &BlockContext, word: &Word) -> bool {
        let counts =
            cx.shared.rules.numbers.argument_increments && cx.shared.units.increment_letters.contains(word.letter);
        counts && matches!(word.value, WordValue::Number(dec) if !dec.point)
    }

    /// Value of a word in the unit of its address, such as seconds or millimetres.
    pub(super) fn plain(&self, cx: &mut BlockContext, block: &Block, word: &Word) -> BlockResult<Option<f64>> {
        match word.value {
            WordValue::Number(dec) if self.counts_increments(cx, word.letter, dec) => {
                Ok(Some(dec.to_f64() / cx.shared.units.per_unit))
            }
            _ => self.raw(cx, block, word),
        }
    }

    /// Value of a word as a whole number. Decimals are dropped; on some controls a calculated value is rounded instead.
    pub(super) fn whole(&self, cx: &mut BlockContext, block: &Block, word: &Word) -> BlockResult<Option<f64>> {
        let value = self.raw(cx, block, word)?;
        self.note_truncation(cx, block, word);
        let round = cx.control.macros.round_words && matches!(word.value, WordValue::Expr(_));
        Ok(value.map(|value| if round { value.round() } else { truncated(value) }))
    }

    /// Warns about a number with decimals after an integer address.
    #[inline]
    fn note_truncation(&self, cx: &mut BlockContext, block: &Block, word: &Word) {
        if let WordValue::Number(dec @ Dec { scale: 1.., .. }) = word.value
            && dec.to_f64().fract() != 0.0
        {
            let letter = word.letter.to_string();
            self.remark(cx, word.span(block), msg!("interp.decimals-dropped", address = letter));
        }
    }

    /// Number of a G code, for a look-up; `None` if the word is left out.
    #[inline]
    pub(super) fn code_number(
        &self,
        cx: &mut BlockContext,
        block: &Block,
        word: &Word,
    ) -> BlockResult<Option<CodeNumber>> {
        if let WordValue::Number(Dec { mantissa, scale: 0, .. }) = word.value {
            return Ok(Some(CodeNumber::from_decimal(mantissa, 0).unwrap_or(CodeNumber::NONE)));
        }
        let Some(value) = self.raw(cx, block, word)? else { return Ok(None) };
        Ok(Some(CodeNumber::from_value(value, WHOLE).unwrap_or(CodeNumber::NONE)))
    }

    /// A length or angle in command increments, rounded half away from zero; `None` if the word is left out.
    #[inline]
    pub(super) fn dimension(
        &self,
        cx: &mut BlockContext,
        block: &Block,
        word: &Word,
        inch: bool,
    ) -> BlockResult<Option<i64>> {
        let units = &cx.shared.units;
        let increments = match word.value {
            WordValue::Number(dec) if !inch => {
                let decimals = i32::from(units.decimals);
                if self.counts_increments(cx, word.letter, dec) {
                    rounded_scale(dec.mantissa, i32::from(dec.scale))
                } else {
                    rounded_scale(dec.mantissa, i32::from(dec.scale) - decimals)
                }
            }
            WordValue::Number(dec) => {
                let decimals = i32::from(units.decimals);
                let counts = self.counts_increments(cx, word.letter, dec);
                let written = i32::from(dec.scale) + if counts { decimals + INCH_DECIMALS as i32 } else { 0 };
                let tenths = dec.mantissa.checked_mul(INCH_TENTHS);
                tenths.and_then(|tenths| rounded_scale(tenths, written + 1 - decimals))
            }
            WordValue::Expr(_) => {
                let Some(value) = self.raw(cx, block, word)? else { return Ok(None) };
                let millimetres = if inch { value * INCH } else { value };
                let increments = (millimetres * units.per_unit).round();
                (increments.abs() < 9e18).then_some(increments as i64)
            }
        };
        match increments {
            Some(increments) if increments.unsigned_abs() <= units.coordinate_max => Ok(Some(increments)),
            _ => {
                let max = cx.control.limits.coordinate_max;
                Err(self.out_of_range(cx, block, word, -max, max))
            }
        }
    }

    /// F in mm/min, rounded to the control's feed step, or in mm/rev.
    #[inline]
    pub(super) fn feed_word(
        &self,
        cx: &mut BlockContext,
        block: &Block,
        word: &Word,
        inch: bool,
    ) -> BlockResult<Option<f64>> {
        if self.modal.per_revolution {
            return self.lead_word(cx, block, word, inch);
        }
        let Some(value) = self.plain(cx, block, word)? else { return Ok(None) };
        let millimetres = if inch { value * INCH } else { value };
        let feed = (millimetres * cx.shared.units.per_feed).round() / cx.shared.units.per_feed;
        let max = cx.control.limits.feed_max;
        if (0.0..=max).contains(&feed) { Ok(Some(feed)) } else { Err(self.out_of_range(cx, block, word, 0.0, max)) }
    }

    /// F in mm/rev: a feed, or the lead of a thread. The lead of a left-hand tap is negative.
    pub(super) fn lead_word(
        &self,
        cx: &mut BlockContext,
        block: &Block,
        word: &Word,
        inch: bool,
    ) -> BlockResult<Option<f64>> {
        let Some(value) = self.plain(cx, block, word)? else { return Ok(None) };
        let lead = if inch { value * INCH } else { value };
        let limits = &cx.control.limits;
        let (lead, max) = match word.letter {
            Address::F => (lead, limits.revolution_feed_max),
            _ if self.modal.motion == Code::Tapping => (lead.abs(), limits.lead_max),
            _ => (lead, limits.lead_max),
        };
        if (0.0..=max).contains(&lead) { Ok(Some(lead)) } else { Err(self.out_of_range(cx, block, word, 0.0, max)) }
    }

    /// Lead of a thread in mm/rev from its threads per inch.
    pub(super) fn threads_word(&self, cx: &mut BlockContext, block: &Block, word: &Word) -> BlockResult<Option<f64>> {
        let Some(threads) = self.raw(cx, block, word)? else { return Ok(None) };
        let least = INCH / cx.control.limits.revolution_feed_max;
        if threads >= least && threads.is_finite() {
            Ok(Some(INCH / threads))
        } else {
            Err(self.out_of_range(cx, block, word, least, cx.control.limits.coordinate_max))
        }
    }

    /// S in r/min, or as a surface speed in m/min.
    pub(super) fn speed_word(
        &self,
        cx: &mut BlockContext,
        block: &Block,
        word: &Word,
        surface: bool,
    ) -> BlockResult<Option<f64>> {
        let whole = cx.shared.units.integer_letters.contains(word.letter);
        let speed = match self.raw(cx, block, word)? {
            None => return Ok(None),
            Some(value) if whole && cx.shared.rules.numbers.round_speed => value.round(),
            Some(value) if whole => truncated(value),
            Some(value) => value,
        };
        if whole {
            self.note_truncation(cx, block, word);
        }
        let limits = &cx.control.limits;
        let own = match word.letter {
            Address::Lims => limits.speed_limit,
            _ => cx.control.spindle.surface_range.filter(|_| surface),
        };
        let (min, max) = own.unwrap_or((0.0, limits.speed_max));
        if (min..=max).contains(&speed) {
            Ok(Some(speed))
        } else if surface {
            let message = msg!("interp.surface-range", speed = (speed, 9), least = min, most = max);
            Err(Trap::alarm(Alarm::SurfaceRange, message).within(word.span(block)))
        } else {
            Err(self.out_of_range(cx, block, word, min, max))
        }
    }

    /// Dwell time: P in whole milliseconds, S in spindle revolutions, other addresses in seconds.
    pub(super) fn dwell_word(&self, cx: &mut BlockContext, block: &Block, word: &Word) -> BlockResult<Option<f64>> {
        let seconds = match word.letter {
            Address::P => self.whole(cx, block, word)?.map(|milliseconds| milliseconds / 1000.0),
            _ => self.plain(cx, block, word)?,
        };
        let max = cx.control.limits.coordinate_max;
        match seconds {
            Some(seconds) if !(0.0..=max).contains(&seconds) => Err(self.out_of_range(cx, block, word, 0.0, max)),
            seconds => Ok(seconds),
        }
    }

    /// The alarm for a value outside the range of its address.
    #[cold]
    pub(super) fn out_of_range(&self, cx: &mut BlockContext, block: &Block, word: &Word, min: f64, max: f64) -> Trap {
        let value = self.raw(cx, block, word).ok().flatten().unwrap_or(0.0);
        let equals = if word.letter.is_long() { "=" } else { "" };
        let address = cx.control.address(word.letter) + equals;
        let message = msg!("interp.word-range", address, value = (value, 9), least = min, most = max);
        let alarm = match word.letter {
            Address::F => Alarm::FeedRange,
            Address::S => Alarm::SpeedRange,
            Address::Lims => Alarm::SpeedLimitRange,
            _ => Alarm::OutOfRange,
        };
        Trap::alarm(alarm, message).within(word.span(block))
    }
}

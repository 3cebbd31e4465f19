//! The encoder of a spindle that the control counts turns and angle by: its lines and its ratio to the spindle, as form and parameters.

use crate::controls::{Control, ParamRole};
use crate::machines::form::Field;
use crate::machines::form::rows::{Member, number};
use crate::machines::sheets::{self, AxisValues, ParamValues, answer};
use crate::msg;
use crate::text::Diagnostic;

/// Lines per turn of the encoder that makers of controls assume.
const LINES: f64 = 1024.0;

/// An encoder beside the spindle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::machines) struct EncoderParams {
    /// Lines per turn of the encoder.
    pub lines: f64,
    /// Turns of the encoder in its ratio to the spindle, a whole number.
    pub turns: f64,
    /// Turns of the spindle in that ratio, a whole number.
    pub spindle_turns: f64,
}

impl Default for EncoderParams {
    fn default() -> EncoderParams {
        EncoderParams { lines: LINES, turns: 1.0, spindle_turns: 1.0 }
    }
}

/// A field for the lines.
pub(in crate::machines) const fn lines<P>(group: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number("encoder-lines", member).group(group).label("encoder.lines").help("encoder.lines.help");
    row.range(1.0..=1_000_000.0).default(LINES).decimals(0).step(256.0).fact()
}

/// A field for the turns of the encoder in its ratio to the spindle.
pub(in crate::machines) const fn turns<P>(group: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number("encoder-turns", member).group(group).label("encoder.turns").help("encoder.turns.help");
    row.range(1.0..=1000.0).default(1.0).decimals(0).step(1.0).fact()
}

/// A field for the turns of the spindle in that ratio.
pub(in crate::machines) const fn spindle_turns<P>(group: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number("spindle-turns", member).group(group).label("encoder.spindle-turns");
    row.help("encoder.turns.help").range(1.0..=1000.0).default(1.0).decimals(0).step(1.0).fact()
}

impl EncoderParams {
    /// Turns of the encoder per turn of the spindle.
    pub(in crate::machines) fn ratio(&self) -> f64 {
        self.turns / self.spindle_turns
    }

    /// The two bits, the high one first, for 1, 2, 4 or 8 turns of the spindle per turn of the encoder; none for
    /// another ratio.
    fn bits(&self) -> Option<[bool; 2]> {
        let magnified = |times: f64| self.turns * times == self.spindle_turns;
        [1.0, 2.0, 4.0, 8.0].into_iter().zip(0u8..).find(|(times, _)| magnified(*times)).map(|(_, code)| {
            // The high bit first.
            [code & 2 != 0, code & 1 != 0]
        })
    }

    /// Whether the control can be set to this ratio: by two numbers, by a power of two, or 1 : 1 only.
    fn is_known(&self, control: &Control) -> bool {
        let has = |role| control.param(role).is_some();
        if has(ParamRole::SpindleEncoderTurns) {
            return true;
        }
        if has(ParamRole::SpindleEncoderHigh) { self.bits().is_some() } else { self.turns == self.spindle_turns }
    }

    /// Rows of the parameter sheet.
    pub(in crate::machines) fn parameters(&self, control: &Control) -> ParamValues<'static> {
        let [high, low] = self.bits().unwrap_or_default();
        let if_known = |values: AxisValues<'static>| if self.is_known(control) { values } else { Vec::new() };
        vec![
            (ParamRole::SpindleEncoderLines, sheets::number(self.lines)),
            (ParamRole::SpindleEncoderDirect, answer(true)),
            (ParamRole::SpindleEncoderTurns, sheets::number(self.turns)),
            (ParamRole::SpindleEncoderSpindleTurns, sheets::number(self.spindle_turns)),
            (ParamRole::SpindleEncoderHigh, if_known(answer(high))),
            (ParamRole::SpindleEncoderLow, if_known(answer(low))),
        ]
    }

    /// A warning about a ratio or a number of lines that no known parameter of the control has: feed per revolution, thread and angle would
    /// be wrong by it.
    pub(in crate::machines) fn finding(&self, control: &Control) -> Option<Diagnostic> {
        let powers = control.param(ParamRole::SpindleEncoderHigh).is_some();
        let ratio = (self.ratio(), 4);
        let message = if powers {
            msg!("encoder.not-a-power-of-two", ratio)
        } else {
            msg!("encoder.not-direct", ratio, control = control.name)
        };
        let of_ratio = (!self.is_known(control)).then(|| Diagnostic::warning(message).about("encoder-turns"));
        of_ratio.or_else(|| {
            let untold = self.lines != LINES && control.param(ParamRole::SpindleEncoderLines).is_none();
            let message = || msg!("encoder.other-lines", lines = self.lines, usual = LINES, control = control.name);
            untold.then(|| Diagnostic::warning(message()).about("encoder-lines"))
        })
    }
}

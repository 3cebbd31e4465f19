//! Blocks of NC words: codes first, then values, then commands in the order of the machine.

use std::rc::Rc;

use super::End;
use super::arc::{Chord, Impossible, by_center, by_radius};
use super::call::word_span;
use super::canon::{AXES, Canon, Feed, Target};
use super::fault::{Run, Trap};
use super::state::{Cx, State};
use crate::controls::{Alarm, Code, Group};
use crate::msg;
use crate::nc::{Block, Word};

/// M codes of a block that act on any control.
const M_CODES: usize = 8;

/// The codes of a block.
#[derive(Default)]
struct Codes {
    /// Dwell, reference return, coordinate setting, macro call …: what the words are for.
    special: Option<Code>,
    /// A code that is not simulated takes the axis words.
    unmoved: bool,
    /// Exact stop in this block.
    exact: bool,
    /// Exact stop mode or cutting mode is commanded.
    path: bool,
    spindle: Option<i8>,
    auxiliary: [u32; M_CODES],
    auxiliaries: usize,
    /// M00, M01, M02, M30.
    stop: Option<Code>,
    /// M98, M99.
    flow: Option<Code>,
}

/// The values of a block.
#[derive(Default)]
struct Words {
    axes: [i64; AXES],
    mask: u8,
    /// I, J, K.
    center: [Option<i64>; 3],
    radius: Option<i64>,
    speed: Option<f64>,
    tool: Option<u32>,
    dwell: Option<f64>,
    p: Option<f64>,
    h: Option<f64>,
    l: Option<f64>,
}

impl State {
    /// Runs a block of words.
    pub(super) fn words(&mut self, cx: &mut Cx, at: u32, block: &Block, words: &[Word]) -> Run<()> {
        let codes = self.codes(cx, block, words)?;
        if let Some(call) = self.modal_call.as_ref().filter(|call| call.each_block).map(Rc::clone)
            && codes.special != Some(Code::MacroModalEnd)
            && codes.flow.is_none()
            && codes.stop.is_none()
        {
            let arguments = self.arguments(cx, block, words, true)?;
            self.counts.macros += 1;
            return self.call_macro(cx, call.program, call.repeats, Rc::new(arguments.locals));
        }
        match codes.special {
            Some(code @ (Code::MacroCall | Code::MacroModal | Code::MacroModalBlock)) => {
                self.counts.macros += 1;
                let modal = (code != Code::MacroCall).then_some(code == Code::MacroModalBlock);
                return self.macro_words(cx, block, words, modal);
            }
            Some(Code::MacroModalEnd) if self.modal_call.take().is_none() && cx.control.raises(Alarm::NoModalCall) => {
                return Err(Trap::alarm(Alarm::NoModalCall, msg!("interp.no-modal-call")));
            }
            _ => {}
        }
        let values = self.values(cx, block, words, &codes)?;
        if let Some(rpm) = values.speed {
            self.modal.word(b'S', rpm);
            self.queue.push(Canon::SpindleSpeed { rpm });
        }
        if let Some(sign) = codes.spindle {
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
        let moved = self.motion(cx, block, words, &codes, &values)?;
        let commands = !self.queue.is_empty();
        match codes.stop {
            Some(Code::Stop) => self.queue.push(Canon::Stop),
            Some(Code::OptionalStop) => self.queue.push(Canon::OptionalStop),
            Some(_) => {
                self.queue.push(Canon::End);
                self.ended = Some(End::Program);
            }
            None => {}
        }
        self.pause = codes.stop.is_some();
        match codes.flow {
            Some(Code::SubCall) => self.call_sub(cx, values.p, values.h, values.l)?,
            Some(_) => self.end_sub(cx, at, values.p)?,
            None => {
                if let (true, Some(call)) = (moved, self.modal_call.as_ref().map(Rc::clone)) {
                    self.call_macro(cx, call.program, call.repeats, Rc::clone(&call.arguments))?;
                }
            }
        }
        // A call or return alone is over when it is read.
        if codes.flow.is_some() && !commands {
            self.counts.macros += 1;
        } else {
            self.counts.nc += 1;
        }
        Ok(())
    }

    /// Puts the codes of a block in force.
    #[inline]
    fn codes(&mut self, cx: &mut Cx, block: &Block, words: &[Word]) -> Run<Codes> {
        let mut codes = Codes::default();
        for word in words {
            match word.letter {
                b'G' => {
                    let Some(number) = self.code_number(cx, block, word)? else { continue };
                    let Some(row) = cx.shared.index.code(cx.control, b'G', number) else {
                        let written = self.raw(cx, block, word)?.unwrap_or(0.0);
                        let trap = Trap::alarm(Alarm::UnknownCode, msg!("interp.unknown-code", written));
                        return Err(trap.within(word_span(block, word)));
                    };
                    self.g_code(cx, row, &mut codes);
                }
                b'M' => self.m_word(cx, block, word, &mut codes)?,
                _ => {}
            }
        }
        Ok(codes)
    }

    #[inline]
    fn g_code(&mut self, cx: &Cx, row: &crate::controls::CodeDef, codes: &mut Codes) {
        use Code::*;
        match row.code {
            Dwell | ReferenceReturn | MachineCoordinates | SetCoordinates | LocalCoordinates | MacroCall
            | MacroModal | MacroModalBlock | MacroModalEnd => codes.special = Some(row.code),
            ExactStopOnce => codes.exact = true,
            ExactStop | Cutting => codes.path = self.modal.exact != (row.code == ExactStop),
            NotSimulated if row.group == Group::OneShot => codes.unmoved = true,
            _ => {}
        }
        self.modal.set(cx.control, row);
    }

    fn m_word(&mut self, cx: &mut Cx, block: &Block, word: &Word, codes: &mut Codes) -> Run<()> {
        let Some(number) = self.whole(cx, block, word)? else { return Ok(()) };
        if !(0.0..=99_999_999.0).contains(&number) {
            return Err(self.out_of_range(cx, block, word, 0.0, 99_999_999.0));
        }
        let number = number as u32;
        self.modal.word(b'M', f64::from(number));
        match cx.shared.index.code(cx.control, b'M', number.saturating_mul(10)).map(|row| row.code) {
            Some(code @ (Code::Stop | Code::OptionalStop | Code::End | Code::EndRewind)) => codes.stop = Some(code),
            Some(code @ (Code::SubCall | Code::SubEnd)) => codes.flow = Some(code),
            Some(Code::SpindleCw) => codes.spindle = Some(1),
            Some(Code::SpindleCcw) => codes.spindle = Some(-1),
            Some(Code::SpindleStop) => codes.spindle = Some(0),
            _ => {
                let max = (cx.control.limits.m_codes as usize).clamp(1, M_CODES);
                if codes.auxiliaries == max {
                    codes.auxiliary.rotate_left(1);
                    codes.auxiliaries -= 1;
                }
                codes.auxiliary[codes.auxiliaries] = number;
                codes.auxiliaries += 1;
            }
        }
        Ok(())
    }

    /// Reads the values of a block; F stays in force.
    #[inline]
    fn values(&mut self, cx: &mut Cx, block: &Block, words: &[Word], codes: &Codes) -> Run<Words> {
        let mut values = Words::default();
        let inch = self.modal.inch;
        for word in words {
            let letter = word.letter;
            if codes.special == Some(Code::Dwell) && matches!(letter, b'X' | b'U' | b'P') {
                values.dwell = self.dwell_word(cx, block, word)?;
            } else if let Some(axis) = cx.shared.index.axis(letter) {
                let inch = inch && !cx.control.axes[axis].rotary;
                if let Some(value) = self.dimension(cx, block, word, inch)? {
                    values.axes[axis] = value;
                    values.mask |= 1 << axis;
                }
            } else {
                match letter {
                    b'F' => {
                        if let Some(feed) = self.feed_word(cx, block, word, inch)? {
                            self.modal.feed = Some(feed);
                            self.modal.word(b'F', feed);
                        }
                    }
                    b'S' => values.speed = self.speed_word(cx, block, word)?,
                    b'T' => {
                        let tool = self.whole(cx, block, word)?;
                        if let Some(tool) = tool {
                            if !(0.0..=99_999_999.0).contains(&tool) {
                                return Err(self.out_of_range(cx, block, word, 0.0, 99_999_999.0));
                            }
                            values.tool = Some(tool as u32);
                        }
                    }
                    b'I' | b'J' | b'K' => {
                        values.center[(letter - b'I') as usize] = self.dimension(cx, block, word, inch)?;
                    }
                    b'R' => values.radius = self.dimension(cx, block, word, inch)?,
                    b'P' => values.p = self.whole(cx, block, word)?,
                    b'L' => values.l = self.whole(cx, block, word)?,
                    b'D' | b'H' => {
                        let number = self.whole(cx, block, word)?;
                        if let Some(number) = number {
                            self.modal.word(letter, number);
                        }
                        if letter == b'H' {
                            values.h = number;
                        }
                    }
                    _ => {}
                }
            }
        }
        Ok(values)
    }

    /// The command for the axis words of a block; whether axes move.
    #[inline]
    fn motion(&mut self, cx: &Cx, block: &Block, words: &[Word], codes: &Codes, values: &Words) -> Run<bool> {
        match codes.special {
            Some(Code::Dwell) => {
                self.queue.push(Canon::Dwell { seconds: values.dwell.unwrap_or(0.0) });
                return Ok(false);
            }
            Some(Code::SetCoordinates) => {
                self.set_coordinates(values);
                return Ok(false);
            }
            Some(Code::LocalCoordinates) => {
                for k in (0..AXES).filter(|k| values.mask & 1 << k != 0) {
                    self.modal.local[k] = values.axes[k];
                }
                return Ok(false);
            }
            _ => {}
        }
        let full_circle = matches!(self.modal.motion, Code::ArcCw | Code::ArcCcw) && values.center != [None; 3];
        if values.mask == 0 && !full_circle || codes.unmoved || self.modal.cycle {
            return Ok(false);
        }
        let machine = codes.special == Some(Code::MachineCoordinates);
        let mut to = Target { position: self.position, mask: values.mask };
        for k in 0..AXES {
            if values.mask & 1 << k != 0 {
                let from = match (machine, self.modal.absolute) {
                    (true, _) => 0,
                    (false, true) => self.modal.zero(k),
                    (false, false) => self.position[k],
                };
                to.position[k] = from.saturating_add(values.axes[k]);
            }
        }
        if codes.special == Some(Code::ReferenceReturn) {
            if to.position != self.position {
                self.queue.push(Canon::Rapid { to });
            }
            for k in (0..AXES).filter(|k| values.mask & 1 << k != 0) {
                to.position[k] = 0;
            }
            self.position = to.position;
            self.queue.push(Canon::Rapid { to });
            return Ok(true);
        }
        let motion = match self.modal.motion {
            Code::Rapid => Canon::Rapid { to },
            Code::Linear | Code::ArcCw | Code::ArcCcw => {
                let exact = codes.exact || self.modal.exact;
                match self.modal.feed {
                    Some(0.0) if cx.shared.rules.feed_zero_rapid => Canon::Rapid { to },
                    None | Some(0.0) => return Err(self.no_feed()),
                    Some(feed) => {
                        let per_revolution = self.modal.per_revolution;
                        let feed = if per_revolution { Feed::PerRevolution(feed) } else { Feed::PerMinute(feed) };
                        if self.modal.motion == Code::Linear {
                            Canon::Linear { to, feed, exact }
                        } else {
                            let center = words.iter().find(|word| matches!(word.letter, b'I' | b'J' | b'K' | b'R'));
                            let within = |trap: Trap| match center {
                                Some(word) => trap.within(word_span(block, word)),
                                None => trap,
                            };
                            self.arc(cx, values, to, feed, exact).map_err(within)?
                        }
                    }
                }
            }
            _ => return Ok(false),
        };
        self.position = to.position;
        self.queue.push(motion);
        Ok(true)
    }

    fn set_coordinates(&mut self, values: &Words) {
        if values.mask == 0 {
            return;
        }
        for k in (0..AXES).filter(|k| values.mask & 1 << k != 0) {
            let zero = self.position[k].saturating_sub(values.axes[k]);
            self.modal.origin[k] = zero.saturating_sub(self.modal.local[k]);
        }
        self.queue.push(Canon::Preset { to: Target { position: values.axes, mask: values.mask } });
    }

    #[cold]
    fn no_feed(&self) -> Trap {
        match self.modal.feed {
            None => Trap::alarm(Alarm::NoFeed, msg!("interp.no-feed")).hint(msg!("interp.hint-feed")),
            Some(_) => Trap::alarm(Alarm::NoFeed, msg!("interp.feed-zero")).hint(msg!("interp.hint-feed-zero")),
        }
    }

    fn arc(&self, cx: &Cx, values: &Words, mut to: Target, feed: Feed, exact: bool) -> Run<Canon> {
        let [first, second, _] = self.modal.plane;
        let delta = |axis: u8| to.position[axis as usize].saturating_sub(self.position[axis as usize]) as f64;
        let clockwise = self.modal.motion == Code::ArcCw;
        let chord = Chord { end: (delta(first), delta(second)), clockwise };
        let units = &cx.shared.units;
        let tolerance = cx.control.limits.arc_tolerance * units.per_unit;
        let center = match values.radius {
            Some(radius) => by_radius(chord, radius as f64, tolerance),
            None => {
                let offset = |axis: u8| {
                    let letter = cx.control.axes.get(axis as usize).map_or(0, |axis| axis.letter);
                    let at = letter.wrapping_sub(b'X') as usize;
                    values.center.get(at).copied().flatten().unwrap_or(0) as f64
                };
                by_center(chord, (offset(first), offset(second)), tolerance)
            }
        };
        let millimetres = |increments: f64| (increments / units.per_unit, 4);
        let (x, y) = center.map_err(|why| {
            let message = match why {
                Impossible::NoCenter => msg!("interp.arc-no-center"),
                Impossible::Deviation(start, end) => {
                    msg!("interp.arc-deviation", millimetres(start), millimetres(end), cx.control.limits.arc_tolerance)
                }
                Impossible::Radius(radius, least) => msg!("interp.arc-radius", millimetres(radius), millimetres(least)),
            };
            Trap::alarm(Alarm::Arc, message)
        })?;
        to.mask |= 1 << first | 1 << second;
        let start = |axis: u8| self.position[axis as usize] as f64;
        let center = (start(first) + x, start(second) + y);
        Ok(Canon::Arc { to, plane: (first, second), center, clockwise, feed, exact })
    }
}

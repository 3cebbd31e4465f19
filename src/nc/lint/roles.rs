//! What the codes of a block mean to the warnings, as bits: looked up once per review, or-ed together per block.

use super::super::ast::{Word, WordValue};
use crate::controls::macros::{CallKind, CodeCall};
use crate::controls::syntax::long;
use crate::controls::{Code, CodeDef, Control, Group};

pub(super) const RAPID: u32 = 1;
pub(super) const LINEAR: u32 = 1 << 1;
/// Arcs, threads, and motions that are not simulated.
pub(super) const CURVED: u32 = 1 << 2;
pub(super) const ABSOLUTE: u32 = 1 << 3;
pub(super) const INCREMENTAL: u32 = 1 << 4;
pub(super) const PER_MINUTE: u32 = 1 << 5;
/// Feed per revolution or by time.
pub(super) const OTHER_FEED: u32 = 1 << 6;
/// Exact stop, for one block or from here on.
pub(super) const EXACT: u32 = 1 << 7;
pub(super) const CUTTING: u32 = 1 << 8;
pub(super) const INCH: u32 = 1 << 9;
pub(super) const DWELL: u32 = 1 << 10;
/// The words are arguments of a macro.
pub(super) const CALL: u32 = 1 << 11;
/// `M98`.
pub(super) const SUB: u32 = 1 << 12;
/// `M99`.
pub(super) const RETURN: u32 = 1 << 13;
/// `M02`, `M30`.
pub(super) const END: u32 = 1 << 14;
/// `M00`, `M01`.
pub(super) const STOP: u32 = 1 << 15;
/// Axis words of this block are no plain motion: reference return, coordinate setting, cycles.
pub(super) const SPECIAL: u32 = 1 << 16;
/// `M03`, `M04`.
pub(super) const SPINDLE: u32 = 1 << 17;
/// `M05`, `M19`.
pub(super) const SPINDLE_REST: u32 = 1 << 18;
/// Any other M code that the PLC answers.
pub(super) const AUXILIARY: u32 = 1 << 19;

/// The words of every following block are arguments.
pub(super) const EACH_BLOCK: u32 = 1 << 20;

/// Codes up to `G99.9` and `M99`.
const TABLE: usize = 1000;

/// The bits of every code.
pub(super) struct Roles<'a> {
    g: Vec<u32>,
    m: Vec<u32>,
    /// Codes that are names.
    named: Vec<u32>,
    /// Codes that call programs by parameter; they go before what the control has itself.
    calls: &'a [CodeCall],
}

fn bits(row: &CodeDef) -> u32 {
    match row.code {
        Code::Rapid => RAPID,
        Code::Linear => LINEAR,
        Code::Absolute => ABSOLUTE,
        Code::Incremental => INCREMENTAL,
        Code::FeedPerMinute => PER_MINUTE,
        Code::ExactStop | Code::ExactStopOnce => EXACT,
        Code::Cutting => CUTTING,
        Code::Inch => INCH,
        Code::Dwell => DWELL,
        Code::MacroCall | Code::MacroModal => CALL,
        Code::MacroModalBlock => CALL | EACH_BLOCK,
        Code::SubCall => SUB,
        Code::SubEnd | Code::Return => RETURN,
        Code::End | Code::EndRewind => END,
        Code::Stop | Code::OptionalStop => STOP,
        Code::SpindleCw | Code::SpindleCcw => SPINDLE,
        Code::SpindleStop | Code::SpindleOrient => SPINDLE_REST,
        Code::Auxiliary | Code::GearStage(_) => AUXILIARY,
        Code::ReferenceReturn
        | Code::MachineCoordinates
        | Code::MachineRapid
        | Code::SetCoordinates
        | Code::Offset
        | Code::OffsetMore
        | Code::LowerLimits
        | Code::UpperLimits
        | Code::LocalCoordinates => SPECIAL,
        _ => match row.group {
            Group::Motion => CURVED,
            Group::FeedUnit => OTHER_FEED,
            Group::Cycle | Group::OneShot | Group::Coordinates => SPECIAL,
            _ => 0,
        },
    }
}

impl<'a> Roles<'a> {
    pub(super) fn new(control: &Control, calls: &'a [CodeCall]) -> Roles<'a> {
        let mut roles = Roles { g: vec![0; TABLE], m: vec![AUXILIARY; TABLE], named: vec![0; TABLE], calls };
        for row in control.codes {
            let table = match row.letter {
                b'G' => &mut roles.g,
                b'M' => &mut roles.m,
                _ => &mut roles.named,
            };
            if let Some(slot) = table.get_mut(row.number as usize) {
                *slot = bits(row);
            }
        }
        roles
    }

    /// The bits of a G or M word; none where its number is calculated.
    #[inline]
    pub(super) fn word(&self, word: &Word) -> u32 {
        let WordValue::Number(number) = word.value else { return 0 };
        let tenths = match number.scale {
            0 => number.mantissa.wrapping_mul(10),
            1 => number.mantissa,
            _ => return 0,
        };
        if !self.calls.is_empty()
            && let Some(call) = self.call(word.letter, tenths)
        {
            return match call.kind {
                CallKind::Sub => SUB,
                CallKind::Macro | CallKind::Modal => CALL,
                CallKind::ModalBlock => CALL | EACH_BLOCK,
            };
        }
        let (table, beyond) = match word.letter {
            b'G' => (&self.g, 0),
            b'M' => (&self.m, AUXILIARY),
            _ => (&self.named, 0),
        };
        table.get(tenths as usize).copied().unwrap_or(beyond)
    }

    /// The bits of all codes of a block.
    pub(super) fn block(&self, words: &[Word]) -> u32 {
        words
            .iter()
            .filter(|word| matches!(word.letter, b'G' | b'M' | long::NAME))
            .fold(0, |bits, word| bits | self.word(word))
    }

    fn call(&self, letter: u8, tenths: i64) -> Option<&CodeCall> {
        self.calls.iter().find(|call| call.letter == letter && i64::from(call.number) == tenths)
    }

    /// The program that a code of these words calls by parameter.
    pub(super) fn called(&self, words: &[Word]) -> Option<u32> {
        words.iter().filter(|_| !self.calls.is_empty()).find_map(|word| {
            let WordValue::Number(number) = word.value else { return None };
            self.call(word.letter, number.tenths()?.into()).map(|call| call.program)
        })
    }
}

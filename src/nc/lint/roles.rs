//! Meaning of codes for the warnings, as bits: looked up per word, combined per block.

use super::super::ast::{Word, WordValue};
use super::super::codes::{Codes, code_of};
use crate::controls::Address;
use crate::controls::macros::CallKind;
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
/// Exact stop, in one block or modal.
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
/// Axis words of this block are not a plain motion: reference return, coordinate setting, cycles.
pub(super) const SPECIAL: u32 = 1 << 16;
/// `M03`, `M04`.
pub(super) const SPINDLE: u32 = 1 << 17;
/// `M05`, `M19`.
pub(super) const SPINDLE_REST: u32 = 1 << 18;
/// Any other M code, answered by the PLC.
pub(super) const AUXILIARY: u32 = 1 << 19;

/// The words of every following block are arguments.
pub(super) const EACH_BLOCK: u32 = 1 << 20;
/// `G96`.
pub(super) const SURFACE: u32 = 1 << 21;
/// `G10`.
pub(super) const DATA: u32 = 1 << 22;

/// The bits of every code.
pub(super) struct Roles<'a> {
    codes: &'a Codes,
    /// By the index of the code's row.
    rows: Vec<u32>,
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
        Code::SurfaceSpeed if row.group == Group::FeedUnit => SURFACE | OTHER_FEED,
        Code::SurfaceSpeed => SURFACE,
        Code::DataInput(_) => SPECIAL | DATA,
        Code::ReferenceReturn
        | Code::MachineCoordinates
        | Code::MachineRapid
        | Code::SetCoordinates
        | Code::Offset
        | Code::OffsetMore
        | Code::LowerLimits
        | Code::UpperLimits
        | Code::TakesAxisWords
        | Code::ReplacesPositions
        | Code::CancelForAxes
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
    pub(super) fn new(control: &Control, codes: &'a Codes) -> Roles<'a> {
        Roles { codes, rows: control.codes.iter().map(bits).collect() }
    }

    /// The bits of a code word; none for a calculated number.
    #[inline]
    pub(super) fn word(&self, word: &Word) -> u32 {
        let WordValue::Number(_) = word.value else { return 0 };
        let beyond = if word.letter == Address::M { AUXILIARY } else { 0 };
        let Some(id) = code_of(word) else { return beyond };
        if let Some(call) = self.codes.call(id) {
            return match call.kind {
                CallKind::Sub => SUB,
                CallKind::Macro | CallKind::Modal => CALL,
                CallKind::ModalBlock => CALL | EACH_BLOCK,
            };
        }
        self.codes.index(id).and_then(|at| self.rows.get(at)).copied().unwrap_or(beyond)
    }

    /// The bits of all codes of a block.
    pub(super) fn block(&self, words: &[Word]) -> u32 {
        words
            .iter()
            .filter(|word| matches!(word.letter, Address::G | Address::M | Address::Name))
            .fold(0, |bits, word| bits | self.word(word))
    }

    /// The code of these words that calls a program by parameter, and the number of the program.
    pub(super) fn called<'w>(&self, words: &'w [Word]) -> Option<(&'w Word, u32)> {
        words.iter().find_map(|word| Some((word, self.codes.call_of(word)?.program)))
    }
}

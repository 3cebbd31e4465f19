//! Ranges of variables: contents, lifetime, and write access.

use super::table::{Key, digits, range_ends};
use super::{Address, Group};
use crate::text::{Citation, Phrase};

/// Meaning of a range of variables.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum VarKind {
    /// `#0`: always vacant, never written.
    Vacant,
    /// Local, one set per macro level.
    Local,
    /// Common, kept or cleared by parameter.
    Common,
    /// Common to all part systems, kept at power-off.
    Retained,
    /// One bit from the PLC, read-only; bit `number - first` of the word with the range's device.
    InputBit,
    /// A word from the PLC, read-only.
    InputWord(Width),
    /// One bit to the PLC.
    OutputBit,
    /// A word to the PLC.
    OutputWord(Width),
    /// A word in both directions: a read gives the PLC's value; a write goes to the PLC and does not change the value read. From the first
    /// number on every fourth variable has 32 bits; the others and the last have 8.
    ExchangeWord,
    /// Tool offsets and other numbers that are stored without effect on the simulated machine.
    Kept,
    /// Zero of a work coordinate system, axis by axis: 1 to 6, or 0 for the common shift.
    WorkOffset(u8),
    /// Zero of a work coordinate system as [`VarKind::WorkOffset`], read-only.
    WorkOffsetShown(u8),
    /// `#3000`: alarm with message.
    AlarmMessage,
    /// Time since power-on.
    PowerOnTime(Clock),
    /// Time of automatic running.
    RunTime(Clock),
    /// Time of the present automatic run in seconds, read-only.
    PartTime,
    /// `#3003`: single block and FIN suppressed.
    SuppressSingleBlock,
    /// `#3004`: bit 0 feed hold, bit 1 cutting override, bit 2 exact stop check off.
    SuppressOverride,
    /// `#3006`: stop with message.
    StopMessage,
    /// Code in force of a modal group, at the block read ahead.
    ModalCode(Group),
    /// Last word of an address letter, at the block read ahead.
    ModalWord(Address),
    /// Code in force of a modal group in the executing block.
    ExecutingCode(Group),
    /// Last word of an address letter in the executing block.
    ExecutingWord(Address),
    /// End point of the preceding block, work coordinates, axis by axis.
    BlockEnd,
    /// Machine position, axis by axis.
    MachinePosition,
    /// Work position, axis by axis.
    WorkPosition,
    /// End point of the last motion with a skip signal, work coordinates, axis by axis.
    SkipPosition,
    /// Exists on the control; the simulation neither reads nor writes it.
    NotSimulated,
}

/// Size of a PLC word; signed except for single bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Width {
    /// 0 to 255.
    Byte,
    /// 16 bits.
    Word,
    /// 32 bits.
    Long,
}

impl Width {
    /// Least and greatest value.
    pub fn range(self) -> (f64, f64) {
        match self {
            Width::Byte => (0.0, 255.0),
            Width::Word => (-32_768.0, 32_767.0),
            Width::Long => (-2_147_483_648.0, 2_147_483_647.0),
        }
    }
}

/// Unit of a clock variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Clock {
    /// Milliseconds.
    Milliseconds,
    /// Seconds.
    Seconds,
    /// Hours.
    Hours,
}

impl Clock {
    /// Milliseconds per unit.
    pub fn milliseconds(self) -> f64 {
        match self {
            Clock::Milliseconds => 1.0,
            Clock::Seconds => 1000.0,
            Clock::Hours => 3_600_000.0,
        }
    }
}

/// Whether a common variable is in a fitted range; an empty list means that all are fitted.
pub fn is_fitted(fitted: &[(u32, u32)], number: u32) -> bool {
    fitted.is_empty() || fitted.iter().any(|&(first, last)| (first..=last).contains(&number))
}

/// A range of variable numbers of one kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VarRange {
    /// First number.
    pub first: u32,
    /// Last number.
    pub last: u32,
    /// Meaning of the range.
    pub kind: VarKind,
    /// PLC device that the first variable reads or writes, for instance `R74`; empty for none.
    pub device: &'static str,
    /// Short description.
    pub text: Phrase,
    /// Source and grade.
    pub cite: Citation,
}

/// A row of variables.
pub(in crate::controls) const fn range(
    first: u32,
    last: u32,
    kind: VarKind,
    device: &'static str,
    text: &'static str,
    cite: Citation,
) -> VarRange {
    VarRange { first, last, kind, device, text: Phrase::new(text), cite }
}

impl VarRange {
    /// Size of a variable's PLC word; `None` if the range has no words.
    pub fn width(&self, number: u32) -> Option<Width> {
        match self.kind {
            VarKind::InputWord(width) | VarKind::OutputWord(width) => Some(width),
            VarKind::ExchangeWord if number.wrapping_sub(self.first).is_multiple_of(4) && number < self.last => {
                Some(Width::Long)
            }
            VarKind::ExchangeWord => Some(Width::Byte),
            _ => None,
        }
    }

    /// Least and greatest value of a variable written by the PLC; `None` for others.
    pub fn input_range(&self, number: u32) -> Option<(f64, f64)> {
        match self.kind {
            VarKind::InputBit => Some((0.0, 1.0)),
            VarKind::InputWord(_) | VarKind::ExchangeWord => Some(self.width(number)?.range()),
            _ => None,
        }
    }
}

/// Least and greatest value of half an input word, which may be signed or unsigned.
pub const HALF_RANGE: (f64, f64) = (-32_768.0, 65_535.0);

impl VarKind {
    /// Whether the number of such variables is an option of the control.
    pub fn common(self) -> bool {
        matches!(self, VarKind::Common | VarKind::Retained)
    }

    /// Whether a program may assign a variable of this kind.
    pub fn writable(self) -> bool {
        !matches!(
            self,
            VarKind::Vacant
                | VarKind::InputBit
                | VarKind::InputWord(_)
                | VarKind::PartTime
                | VarKind::WorkOffsetShown(_)
                | VarKind::ModalCode(_)
                | VarKind::ModalWord(_)
                | VarKind::ExecutingCode(_)
                | VarKind::ExecutingWord(_)
                | VarKind::BlockEnd
                | VarKind::MachinePosition
                | VarKind::WorkPosition
                | VarKind::SkipPosition
        )
    }
}

impl VarRange {
    /// Whether the table is sorted, for binary search.
    pub const SORTED: bool = true;

    /// Key for replacing a family's rows by the control's own rows of the same variable numbers.
    pub const fn key(&self) -> Key {
        (self.first as u64, self.last as u64)
    }

    /// The key range of an entry in a row list: `100`, `1-33`.
    pub const fn listed_key(word: &[u8]) -> Key {
        let (first, last) = range_ends(word);
        (digits(first), digits(last))
    }
}

//! Look-up of codes for parser, checks and interpreter: row and program call of a code.

use super::ast::{Word, WordValue};
use super::dec::Dec;
use crate::controls::Address;
use crate::controls::macros::CodeCall;
use crate::controls::{Code, CodeDef, CodeId, CodeNumber, Control, Dialect, Group};

/// Table size for G codes: G0 to G99.9.
const G_SLOTS: usize = 1000;

/// Table size for M codes: M0 to M99.
const M_SLOTS: usize = 100;

/// Flag of a table entry: a parameter binds the code to a program.
const CALLS: u16 = 1 << 15;

/// Codes of a control under its switch settings.
#[derive(Debug, Clone)]
pub struct Codes {
    control: &'static Control,
    /// Index + 1 into the control's rows, 0 for none, combined with [`CALLS`].
    g: Box<[u16; G_SLOTS]>,
    /// Like `g`, by M number.
    m: Box<[u16; M_SLOTS]>,
    calls: Vec<CodeCall>,
    /// Codes disabled by a switch.
    off: &'static [CodeId],
}

impl Codes {
    /// Builds the tables for a control and its settings.
    pub(super) fn new(control: &'static Control, dialect: &Dialect) -> Codes {
        let mut codes = Codes {
            control,
            g: Box::new([0; G_SLOTS]),
            m: Box::new([0; M_SLOTS]),
            calls: dialect.calls().to_vec(),
            off: dialect.reading.codes_off,
        };
        for (row, at) in control.codes.iter().zip(1..) {
            if !codes.off.contains(&row.id)
                && let Some(slot) = codes.slot_mut(row.id)
            {
                *slot = at;
            }
        }
        for at in 0..codes.calls.len() {
            let id = codes.calls.get(at).map(|call| call.code);
            if let Some(slot) = id.and_then(|id| codes.slot_mut(id)) {
                *slot |= CALLS;
            }
        }
        codes
    }

    fn slot_mut(&mut self, id: CodeId) -> Option<&mut u16> {
        match id {
            CodeId::G(number) => self.g.get_mut(g_slot(number)?),
            CodeId::M(number) => self.m.get_mut(number as usize),
            CodeId::Named(_) => None,
        }
    }

    /// Table entry of a code; `None` for a code outside the tables.
    #[inline]
    fn slot(&self, id: CodeId) -> Option<u16> {
        match id {
            CodeId::G(number) => self.g.get(g_slot(number)?).copied(),
            CodeId::M(number) => self.m.get(number as usize).copied(),
            CodeId::Named(_) => None,
        }
    }

    /// Index of a code's row in [`Control::codes`]; `None` if the control lacks the code or a switch disables it.
    #[inline(always)]
    pub fn index(&self, id: CodeId) -> Option<usize> {
        match self.slot(id) {
            Some(slot) => usize::from(slot & !CALLS).checked_sub(1),
            None => self.search(id),
        }
    }

    /// Row index of a code outside the tables.
    #[cold]
    fn search(&self, id: CodeId) -> Option<usize> {
        self.control.code_index(id).filter(|_| !self.off.contains(&id))
    }

    /// Row of a code; `None` if the control lacks the code or a switch disables it.
    #[inline(always)]
    pub fn row(&self, id: CodeId) -> Option<&'static CodeDef> {
        self.control.codes.get(self.index(id)?)
    }

    /// Program call bound to a code by a parameter. It precedes the code's own row.
    #[inline(always)]
    pub fn call(&self, id: CodeId) -> Option<&CodeCall> {
        let none = self.calls.is_empty() || self.slot(id).is_some_and(|slot| slot & CALLS == 0);
        if none { None } else { self.calls.iter().find(|call| call.code == id) }
    }

    /// All codes bound to programs by parameters.
    pub fn calls(&self) -> &[CodeCall] {
        &self.calls
    }

    /// Row of a code word with a constant number.
    #[inline]
    pub(crate) fn row_of(&self, word: &Word) -> Option<&'static CodeDef> {
        self.row(code_of(word)?)
    }

    /// Row of the code that a code means beside the words of its block: work coordinate system 1 with P is an additional one, unless P
    /// belongs to another code of the block, as in `G54 M98 P2`.
    #[inline]
    pub fn meant(&self, row: &'static CodeDef, words: &[Word]) -> &'static CodeDef {
        let numbered = row.code == Code::WorkCoordinates(1)
            && words.iter().any(|word| word.letter == Address::P)
            && !words.iter().any(|word| self.takes_p(word));
        if numbered { self.more_coordinates().unwrap_or(row) } else { row }
    }

    /// Whether P belongs to this code word: a call, a dwell, a cycle, or another code with numbers of its own.
    #[cold]
    fn takes_p(&self, word: &Word) -> bool {
        use Code::{DataInput, Dwell, MacroCall, MacroModal, MacroModalBlock, NotSimulated, Roughing};
        use Code::{SubCall, SubEnd, SurfaceSpeed, TakesAxisWords};
        self.call_of(word).is_some()
            || self.row_of(word).is_some_and(|row| match row.code {
                MacroCall | MacroModal | MacroModalBlock | SubCall | SubEnd | Dwell | DataInput(_) | Roughing
                | SurfaceSpeed | TakesAxisWords => true,
                NotSimulated => matches!(row.group, Group::Cycle | Group::OneShot),
                _ => false,
            })
    }

    /// Row of the additional work coordinate systems.
    pub fn more_coordinates(&self) -> Option<&'static CodeDef> {
        self.control.codes.iter().find(|row| row.code == Code::MoreCoordinates)
    }

    /// Whether the blocks behind one with these words are data (`G10 L50`), up to the next one with a code.
    #[cold]
    pub fn opens_data(&self, words: &[Word]) -> bool {
        let lists = words.iter().find_map(|word| match self.row_of(word)?.code {
            Code::DataInput(lists) => Some(lists),
            _ => None,
        });
        let named = |list: &u16| {
            let number = WordValue::Number(Dec::int(i64::from(*list)));
            words.iter().any(|word| word.letter == Address::L && word.value == number)
        };
        lists.is_some_and(|lists| lists.iter().any(named))
    }

    /// Program call of a code word with a constant number.
    #[inline]
    pub(crate) fn call_of(&self, word: &Word) -> Option<&CodeCall> {
        if self.calls.is_empty() { None } else { self.call(code_of(word)?) }
    }
}

/// Table entry of a G number.
#[inline]
fn g_slot(number: CodeNumber) -> Option<usize> {
    let whole = number.integer() as usize;
    (whole < G_SLOTS / 10).then(|| 10 * whole + usize::from(number.tenth()))
}

/// The code of a word with a constant number; `None` for a calculated number, or one outside the range of codes.
#[inline]
pub(crate) fn code_of(word: &Word) -> Option<CodeId> {
    let WordValue::Number(number) = word.value else { return None };
    match word.letter {
        Address::G => Some(CodeId::G(g_number(number)?)),
        Address::M => m_number(number).map(CodeId::M),
        Address::Name => Some(CodeId::Named(u16::try_from(number.mantissa).ok()?)),
        _ => None,
    }
}

/// Whether the words of a block are data where data are expected: none is a code.
pub fn are_data(words: &[Word]) -> bool {
    words.iter().all(|word| !matches!(word.letter, Address::G | Address::M))
}

/// A constant as the number of a G code.
#[inline]
pub(super) fn g_number(number: Dec) -> Option<CodeNumber> {
    CodeNumber::from_decimal(number.mantissa, number.scale)
}

/// A constant as the number of an M code; its decimals have to be zeros.
#[inline]
pub(super) fn m_number(number: Dec) -> Option<u32> {
    match number.scale {
        0 => u32::try_from(number.mantissa).ok(),
        _ => {
            CodeNumber::from_decimal(number.mantissa, number.scale).filter(|m| m.tenth() == 0).map(CodeNumber::integer)
        }
    }
}

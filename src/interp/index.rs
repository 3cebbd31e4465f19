//! Look-up tables of a run, built once per program: axes, variables, sequence numbers, pairs of DO and END.

use crate::controls::Address;
use crate::controls::vars::is_fitted;
use crate::controls::{Alarm, Control, Dialect, VarKind, VarRange};
use crate::nc::{Deck, Expr, ExprId, Jump, Program, SequenceNumbers, Stmt, labels_of};

/// Storage of a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum VariableSlot {
    /// No variable with this number.
    None,
    /// Local variable `#n`, as index from 0.
    Local(u8),
    /// A common variable, as index into the store.
    Common(u16),
    /// Any other variable: index of its row in the control's table.
    Row(u16),
}

/// Marks the letter for incremental words of an axis.
const INCREMENTAL: u8 = 0x40;
/// Variable numbers below this are in the direct table.
const DIRECT: u32 = 2048;
/// A row without storage.
const NOT_STORED: u32 = u32::MAX;

/// A DO with its END, as block indices of the deck.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Loop {
    start: u32,
    end: u32,
    /// Index of the loop around it.
    parent: Option<u32>,
}

/// The partner of a DO or END.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Partner {
    /// Block index of the partner.
    Block(u32),
    /// No partner.
    Fault(Alarm),
}

/// Jump targets of one program.
#[derive(Debug, Default)]
struct Jumps {
    numbers: SequenceNumbers,
    /// Loops by their first block.
    loops: Vec<Loop>,
    /// (block of DO or END, partner), sorted by block.
    pairs: Vec<(u32, Partner)>,
}

/// All look-up tables of a run.
#[derive(Debug)]
pub(super) struct Index {
    /// Axis by address, with [`INCREMENTAL`]; [`u8::MAX`] for no axis.
    axes: [u8; 64],
    direct: Vec<VariableSlot>,
    /// Start of each variable row in the store, or [`NOT_STORED`].
    bases: Vec<u32>,
    /// Number of stored variables.
    pub(super) stored: u32,
    /// (program number, index of the first program with it), sorted.
    numbers: Vec<(u32, u32)>,
    jumps: Vec<Jumps>,
    /// (target of a jump, its block), sorted; for languages with jump directions.
    targets: Vec<(u32, u32)>,
    /// (name, index of the program), sorted.
    names: Vec<(Box<str>, u32)>,
    /// Ranges of fitted common variables.
    fitted: &'static [(u32, u32)],
}

/// Whether the interpreter stores values of these variables.
fn is_stored(kind: VarKind) -> bool {
    use VarKind::*;
    matches!(kind, Common | Retained | OutputWord(_) | Kept | SuppressSingleBlock | SuppressOverride)
}

impl Index {
    /// Builds the tables from a deck and a control.
    pub(super) fn new(deck: &Deck, control: &Control, dialect: &Dialect) -> Index {
        let mut axes = [u8::MAX; 64];
        for (k, axis) in control.axes.iter().enumerate().take(super::canon::AXES) {
            axes[axis.letter as usize] = k as u8;
            if let Some(letter) = axis.incremental {
                axes[letter as usize] = k as u8 | INCREMENTAL;
            }
        }
        let (mut bases, mut stored) = (Vec::with_capacity(control.vars.len()), 0);
        for row in control.vars {
            bases.push(if is_stored(row.kind) { stored } else { NOT_STORED });
            if is_stored(row.kind) {
                stored += row.last - row.first + 1;
            }
        }
        let mut numbers: Vec<(u32, u32)> = Vec::with_capacity(deck.programs.len());
        numbers.extend(deck.programs.iter().enumerate().map(|(at, program)| (program.number, at as u32)));
        numbers.sort_by_key(|&(number, _)| number);
        let mut index = Index {
            axes,
            direct: Vec::new(),
            bases,
            stored,
            numbers,
            jumps: deck.programs.iter().map(|program| jumps(deck, program, control)).collect(),
            targets: Vec::new(),
            names: Vec::new(),
            fitted: dialect.reading.fitted,
        };
        if control.syntax.names().is_some() {
            index.targets = deck.programs.iter().flat_map(|program| targets(deck, program)).collect();
            index.targets.sort_by_key(|&(target, _)| target);
            let names = deck.programs.iter().zip(0..).filter(|(program, _)| program.name.is_some());
            index.names = names.map(|(program, at)| (deck.text(program.name).into(), at)).collect();
            index.names.sort();
        }
        index.direct = (0..DIRECT).map(|number| index.find_slot(control, number)).collect();
        index
    }

    /// Axis index of an address, and whether the address is the axis's incremental one.
    #[inline]
    pub(super) fn axis(&self, letter: Address) -> Option<(usize, bool)> {
        let axis = self.axes[letter as usize & 63];
        (axis != u8::MAX).then_some(((axis & !INCREMENTAL) as usize, axis & INCREMENTAL != 0))
    }

    fn find_slot(&self, control: &Control, number: u32) -> VariableSlot {
        let Some(at) = control.var_index(number) else {
            return VariableSlot::None;
        };
        match (control.vars[at].kind, self.stored_at(&control.vars[at], at, number)) {
            (VarKind::Local, _) => VariableSlot::Local((number - control.vars[at].first).min(32) as u8),
            (kind, _) if kind.common() && !is_fitted(self.fitted, number) => VariableSlot::None,
            (VarKind::Common | VarKind::Retained, Some(slot)) => VariableSlot::Common(slot),
            _ => VariableSlot::Row(at as u16),
        }
    }

    /// Storage of a variable.
    #[inline]
    pub(super) fn slot(&self, control: &Control, number: u32) -> VariableSlot {
        match self.direct.get(number as usize) {
            Some(&slot) => slot,
            None => self.find_slot(control, number),
        }
    }

    /// Index in the store of a row's variable.
    pub(super) fn stored_at(&self, row: &VarRange, at: usize, number: u32) -> Option<u16> {
        let base = self.bases.get(at).copied().filter(|&base| base != NOT_STORED)?;
        u16::try_from(base + number.checked_sub(row.first)?).ok()
    }

    /// The target block of a jump.
    pub(super) fn target(&self, target: ExprId) -> Option<u32> {
        let at = self.targets.binary_search_by_key(&target.0, |row| row.0).ok()?;
        self.targets.get(at).map(|row| row.1)
    }

    /// Index of the first program with a name, in capitals.
    pub(super) fn named(&self, name: &str) -> Option<u32> {
        let at = self.names.partition_point(|row| *row.0 < *name);
        self.names.get(at).filter(|row| *row.0 == *name).map(|row| row.1)
    }

    /// Index of the first program with a number.
    pub(super) fn program(&self, number: u32) -> Option<u32> {
        let at = self.numbers.partition_point(|&(n, _)| n < number);
        self.numbers.get(at).filter(|&&(n, _)| n == number).map(|&(_, program)| program)
    }

    /// The block with a sequence number: searched from `from` to the end of the program, then from its first block.
    pub(super) fn sequence(&self, program: u32, number: u32, from: u32) -> Option<u32> {
        self.jumps.get(program as usize)?.numbers.find(number, from)
    }

    /// The partner of the DO or END in a block.
    #[inline]
    pub(super) fn partner(&self, program: u32, block: u32) -> Partner {
        let pairs = self.jumps.get(program as usize).map_or(&[][..], |jumps| &jumps.pairs);
        match pairs.binary_search_by_key(&block, |&(at, _)| at) {
            Ok(at) => pairs[at].1,
            Err(_) => Partner::Fault(Alarm::MissingEnd),
        }
    }

    /// Whether a jump enters a loop from outside.
    pub(super) fn enters_loop(&self, program: u32, from: u32, to: u32) -> bool {
        let loops = self.jumps.get(program as usize).map_or(&[][..], |jumps| &jumps.loops);
        // The innermost loop around the target; a jump to its DO is allowed.
        let mut at = loops.partition_point(|l| l.start < to).checked_sub(1).map(|at| at as u32);
        while let Some(inner) = at.and_then(|at| loops.get(at as usize)) {
            if inner.end >= to {
                return !(inner.start <= from && from <= inner.end);
            }
            at = inner.parent;
        }
        false
    }
}

/// Targets of the jumps of a program, in a language with jump directions.
fn targets(deck: &Deck, program: &Program) -> Vec<(u32, u32)> {
    let blocks = deck.blocks_of(program);
    let (numbers, labels) = (SequenceNumbers::new(blocks, 0), labels_of(deck, blocks));
    let mut found = Vec::new();
    for (at, block) in (0..).zip(blocks) {
        for Jump { target, way, .. } in deck.jumps_of(block.stmt) {
            let to = match deck.expr(target) {
                Expr::Label(name) => {
                    let named = labels.get(deck.text(Some(name)));
                    named.and_then(|named| way.nearest(at as usize, named)).map(|to| to as u32)
                }
                Expr::Number(number) => {
                    let number = u32::try_from(number.mantissa);
                    number.ok().and_then(|number| numbers.target(number, at, way))
                }
                _ => None,
            };
            found.extend(to.map(|to| (target.0, program.first + to)));
        }
    }
    found
}

fn jumps(deck: &Deck, program: &Program, control: &Control) -> Jumps {
    let blocks = deck.blocks_of(program);
    let mut jumps = Jumps { numbers: SequenceNumbers::new(blocks, program.first), ..Jumps::default() };
    // Open loops: (label, block of the DO).
    let mut open: Vec<(u16, u32)> = Vec::new();
    for (at, block) in (program.first..).zip(blocks) {
        match block.stmt {
            Stmt::While { label, .. } => {
                if open.len() >= control.syntax.do_depth as usize {
                    jumps.pairs.push((at, Partner::Fault(Alarm::DoNesting)));
                } else if open.iter().any(|&(outer, _)| outer == label) {
                    jumps.pairs.push((at, Partner::Fault(Alarm::DoPair)));
                } else {
                    open.push((label, at));
                }
            }
            Stmt::End { label, .. } => match open.last() {
                Some(&(last, start)) if last == label => {
                    open.pop();
                    jumps.pairs.push((start, Partner::Block(at)));
                    jumps.pairs.push((at, Partner::Block(start)));
                    jumps.loops.push(Loop { start, end: at, parent: None });
                }
                // No DO, or crossing another loop. A DO without END stays without a partner.
                _ => {
                    let crosses = open.iter().any(|&(other, _)| other == label);
                    let alarm = if crosses { Alarm::DoPair } else { Alarm::MissingDo };
                    jumps.pairs.push((at, Partner::Fault(alarm)));
                }
            },
            _ => {}
        }
    }
    jumps.pairs.sort_by_key(|&(at, _)| at);
    jumps.loops.sort_by_key(|l| l.start);
    let mut around: Vec<u32> = Vec::new();
    for at in 0..jumps.loops.len() {
        let start = jumps.loops[at].start;
        while around.last().is_some_and(|&outer| jumps.loops[outer as usize].end < start) {
            around.pop();
        }
        jumps.loops[at].parent = around.last().copied();
        around.push(at as u32);
    }
    jumps
}

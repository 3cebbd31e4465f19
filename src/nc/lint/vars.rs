//! Variables of a deck, and their uses in all programs together.

use super::super::ast::{Block, Deck, Expr, ExprId, Op, Stmt, Word, WordValue};
use super::super::codes::Codes;
use super::context::Lint;
use super::facts::{Call, Facts};
use super::faulty::variables;
use crate::controls::Address;
use crate::controls::AddressSet;
use crate::controls::macros::ARGUMENT;
use crate::controls::syntax::Function;
use crate::controls::{Code, Control, VarKind};
use crate::text::Span;

/// Largest variable number followed.
const NUMBERS: usize = 16_384;

/// Number of local variables of a level.
pub(super) const LOCALS: u32 = 33;

/// Possible values of a variable or formula, for comparisons.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum ValueKind {
    /// Whole numbers.
    Whole,
    /// Entered by the operator: unknown.
    Entered,
    /// Decimals, exactly as written or entered.
    Decimals,
    /// Results of a calculation, with digits after the point.
    Calculated,
}

/// Origin of the values assigned to a variable, numbers excepted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum CopySource {
    /// None: numbers at most are assigned.
    Nothing,
    /// Always the variable with this index in the list, which it copies.
    Variable(u32),
    /// Several variables, or results of formulas.
    Mixed,
}

impl CopySource {
    /// The source after another assignment.
    fn joined(self, other: CopySource) -> CopySource {
        match (self, other) {
            (source, CopySource::Nothing) | (CopySource::Nothing, source) => source,
            _ if self == other => self,
            _ => CopySource::Mixed,
        }
    }
}

/// A variable. Blocks are indices in the deck.
pub(super) struct Var {
    pub(super) number: u32,
    pub(super) kind: ValueKind,
    /// No assigned value can be 0, as far as is known; only for assigned variables.
    pub(super) nonzero: bool,
    /// Number of assignments, calls included.
    pub(super) sets: u32,
    /// Number of calls that pass it as an argument.
    pub(super) given: u32,
    pub(super) copies: CopySource,
    /// Group of programs with this variable, for a local one.
    pub(super) group: u32,
    /// First and last block of a comparison.
    pub(super) compared: Option<(u32, u32)>,
    /// The same without comparisons for equality with 0 where vacant is not equal to 0: a vacant variable passes those.
    pub(super) compared_if_vacant: Option<(u32, u32)>,
    /// The variable is compared with the vacant variable.
    pub(super) vacancy: bool,
    /// First read, comparisons with the vacant variable excepted.
    pub(super) read: Option<(u32, ExprId)>,
    /// First axis word of only this variable.
    pub(super) word: Option<(u32, Span)>,
    /// First assignment.
    pub(super) set_at: Option<(u32, ExprId)>,
    /// An assignment calculates it from the program's own variables.
    pub(super) scratch: bool,
    /// Formulas or words of other variables read it.
    pub(super) used: bool,
}

/// One assignment.
pub(super) struct Set {
    /// The variable, by its index in the list.
    pub(super) slot: u32,
    /// Group of the local variables in the value.
    pub(super) group: u32,
    pub(super) value: WordValue,
}

/// A part of a formula, checked after all programs are read.
#[derive(Clone, Copy)]
pub(super) struct FormulaSite {
    pub(super) block: u32,
    pub(super) group: u32,
    pub(super) id: ExprId,
}

/// All variables.
pub(super) struct Vars<'a> {
    pub(super) deck: &'a Deck,
    codes: &'a Codes,
    pub(super) control: &'static Control,
    /// Index of a number in `list`; local variables are kept apart.
    slots: Vec<Option<u32>>,
    pub(super) list: Vec<Var>,
    /// Group of programs that share local variables, by program; and index of the first local variable of each group.
    pub(super) group: Vec<u32>,
    pub(super) locals: Vec<Option<u32>>,
    /// Groups with callers outside these files.
    pub(super) open: Vec<bool>,
    /// Calls with arguments, by group.
    pub(super) calls: Vec<u32>,
    pub(super) sets: Vec<Set>,
    /// Tests for equality.
    pub(super) equals: Vec<FormulaSite>,
    pub(super) divisors: Vec<FormulaSite>,
    /// Comparisons as operands of AND, OR or XOR.
    pub(super) loose: Vec<FormulaSite>,
    /// FIX and FUP of constants that binary arithmetic leaves slightly beside a whole number.
    pub(super) cuts: Vec<FormulaSite>,
    /// Arc tangents of one number that are divided.
    pub(super) divided_angles: Vec<FormulaSite>,
    /// A variable is assigned by a calculated number.
    pub(super) wild: bool,
    /// Number of variables, from 1, local to each level.
    pub(super) local_count: u32,
    /// Variables set by the operator.
    operator_set: &'a [u32],
}

impl<'a> Vars<'a> {
    /// Reads every formula once.
    pub(super) fn new(lint: &Lint<'a>, facts: &Facts) -> Vars<'a> {
        let programs = lint.deck.programs.len();
        let mut vars = Vars {
            deck: lint.deck,
            codes: lint.parsed.codes(),
            control: lint.control,
            slots: vec![None; NUMBERS],
            list: Vec::new(),
            group: (0..programs as u32).collect(),
            locals: vec![None; programs],
            open: vec![facts.any_called; programs],
            calls: vec![0; programs],
            sets: Vec::new(),
            equals: Vec::new(),
            divisors: Vec::new(),
            loose: Vec::new(),
            cuts: Vec::new(),
            divided_angles: Vec::new(),
            wild: false,
            operator_set: lint.set,
            local_count: if lint.control.vars.iter().any(|row| row.kind == VarKind::Local) { LOCALS } else { 0 },
        };
        // Subprograms share the local variables of their callers.
        for call in facts.calls.iter().filter(|call| !call.with_locals) {
            let (a, b) = (vars.root(call.from), vars.root(call.to));
            vars.group[a as usize] = b;
        }
        let start = lint.start.and_then(|number| lint.programs.number(number));
        for (index, part) in (0..).zip(&facts.programs) {
            let group = vars.root(index);
            vars.group[index as usize] = group;
            vars.open[group as usize] |= part.each_block || !part.called && !part.ends && start != Some(index);
        }
        let increments = lint.increments()[1];
        for call in facts.calls.iter().filter(|call| call.with_locals) {
            vars.arguments(increments, call);
        }
        for &(program, at) in &facts.bad {
            vars.unread(lint, program, at);
        }
        for (index, program) in lint.deck.programs.iter().enumerate() {
            for (at, block) in (program.first..).zip(lint.deck.blocks_of(program)) {
                vars.block(at, vars.group[index], block);
            }
        }
        vars
    }

    /// Excludes variables named in blocks that do not parse, because such a block may set and test them.
    fn unread(&mut self, lint: &Lint, program: u32, at: u32) {
        let span = self.deck.blocks.get(at as usize).map_or_else(Span::default, |block| block.span);
        let text = lint.parsed.text(lint.place(at, span));
        let (numbers, any) = variables(text, self.control.syntax.variable);
        self.wild |= any;
        for number in numbers {
            if let Some(var) = self.make(self.group[program as usize], number) {
                var.sets += 1;
                (var.compared, var.compared_if_vacant) = (Some((0, u32::MAX)), Some((0, u32::MAX)));
                var.nonzero = false;
            }
        }
    }

    /// Root of a program's group in the union-find forest of `group`, with path halving.
    fn root(&mut self, program: u32) -> u32 {
        let mut at = program;
        while self.group[at as usize] != at {
            let next = self.group[self.group[at as usize] as usize];
            self.group[at as usize] = next;
            at = next;
        }
        at
    }

    /// Index of a variable in the list; `None` if it is not followed.
    pub(super) fn slot(&self, group: u32, number: u32) -> Option<usize> {
        let slot = match number.wrapping_sub(1) {
            local if local < self.local_count => (*self.locals.get(group as usize)?).map(|base| base + local),
            _ => *self.slots.get(number as usize)?,
        };
        slot.map(|slot| slot as usize)
    }

    pub(super) fn get(&self, group: u32, number: u32) -> Option<&Var> {
        self.list.get(self.slot(group, number)?)
    }

    /// The variable, added to the list on first use.
    fn make(&mut self, group: u32, number: u32) -> Option<&mut Var> {
        if self.slot(group, number).is_none() {
            let vacant = self.control.var(0).filter(|row| row.kind == VarKind::Vacant);
            let next = self.list.len() as u32;
            let local = (1..=self.local_count).contains(&number);
            let (table, at) = if local { (&mut self.locals, group) } else { (&mut self.slots, number) };
            *table.get_mut(at as usize).filter(|_| number != 0 || vacant.is_none())? = Some(next);
            for number in if local { 1..=LOCALS } else { number..=number } {
                self.list.push(Var {
                    number,
                    kind: ValueKind::Whole,
                    nonzero: true,
                    sets: 0,
                    given: 0,
                    copies: CopySource::Nothing,
                    group,
                    compared: None,
                    compared_if_vacant: None,
                    vacancy: false,
                    read: None,
                    word: None,
                    set_at: None,
                    scratch: false,
                    used: false,
                });
            }
        }
        let slot = self.slot(group, number)?;
        self.list.get_mut(slot)
    }

    /// Records the variables set by the arguments of a macro call.
    fn arguments(&mut self, increments: AddressSet, call: &Call) {
        let (from, to) = (self.group[call.from as usize], self.group[call.to as usize]);
        self.calls[to as usize] += 1;
        let mut mask = 0_u64;
        for word in self.deck.words_of(&self.deck.blocks[call.block as usize]) {
            let letter = word.letter;
            let number = ARGUMENT.get(letter as usize).copied().unwrap_or(0);
            if number == 0 || matches!(letter, Address::G | Address::L | Address::N | Address::O | Address::P) {
                continue;
            }
            // With a second I, J or K any argument variable may be set.
            if mask & 1 << number != 0 && matches!(letter, Address::I | Address::J | Address::K) {
                mask = u64::MAX;
                break;
            }
            mask |= 1 << number;
            let mut value = word.value;
            if let WordValue::Number(dec) = &mut value
                && !dec.point
                && increments.contains(letter)
            {
                // As increments, 1 is 0.001.
                dec.scale = (dec.scale + 3).min(18);
            }
            self.set(from, to, number.into(), value);
        }
        for number in 1..=LOCALS {
            if let Some(var) = self.make(to, number) {
                var.given += (mask >> number & 1) as u32;
            }
        }
    }

    /// Records an assignment: local variables of the value belong to `from`, the assigned one to `to`.
    fn set(&mut self, from: u32, to: u32, number: u32, value: WordValue) {
        let copied = match value {
            WordValue::Number(_) => CopySource::Nothing,
            WordValue::Expr(id) => match self.deck.expr(id) {
                Expr::Number(_) | Expr::Var(0) => CopySource::Nothing,
                Expr::Var(other) => {
                    self.make(from, other);
                    self.slot(from, other).map_or(CopySource::Mixed, |slot| CopySource::Variable(slot as u32))
                }
                _ => CopySource::Mixed,
            },
        };
        let Some(var) = self.make(to, number) else { return };
        var.sets += 1;
        var.copies = var.copies.joined(copied);
        if let Some(slot) = self.slot(to, number) {
            self.sets.push(Set { slot: slot as u32, group: from, value });
        }
    }

    /// Records the formulas of a block, by its index.
    fn block(&mut self, at: u32, group: u32, block: &Block) {
        let site = |id| FormulaSite { block: at, group, id };
        match block.stmt {
            Stmt::Assign { to, value } => self.assign(to, site(value)),
            Stmt::IfThen { cond, to, value } => {
                self.compare(site(cond));
                self.assign(to, site(value));
            }
            Stmt::If { cond, target, .. } => {
                self.compare(site(cond));
                self.read(site(target), None);
            }
            Stmt::Goto { target, .. } => self.read(site(target), None),
            Stmt::Assigns { first, count } => {
                for assignment in self.deck.assignments_at(first, count) {
                    self.assign(assignment.to, site(assignment.value));
                }
            }
            Stmt::Ifs { first, count } => {
                for cond in self.deck.jumps_at(first, count).iter().filter_map(|jump| jump.cond) {
                    self.compare(site(cond));
                }
            }
            Stmt::Call { repeats: Some(repeats), .. } => self.read(site(repeats), None),
            Stmt::While { cond: Some(cond), .. } => self.compare(site(cond)),
            Stmt::Words { .. } => {
                let words = self.deck.words_of(block);
                for word in words {
                    let WordValue::Expr(id) = word.value else { continue };
                    self.read(site(id), None);
                    let bare = match self.deck.expr(id) {
                        Expr::Negate(inner) => self.deck.expr(inner),
                        expr => expr,
                    };
                    if let Expr::Var(number) = bare
                        && self.control.is_axis(word.letter)
                        && !words.iter().any(|word| self.takes_words(word))
                        && let Some(var) = self.make(group, number)
                    {
                        var.word.get_or_insert((at, word.span(block)));
                    }
                }
            }
            _ => {}
        }
    }

    /// Whether a code uses axis words otherwise: as a time, or as arguments.
    fn takes_words(&self, word: &Word) -> bool {
        use Code::{Dwell, MacroCall, MacroModal, MacroModalBlock};
        let row = self.codes.row_of(word);
        row.is_some_and(|row| matches!(row.code, Dwell | MacroCall | MacroModal | MacroModalBlock))
    }

    /// Records the assignment of a value.
    fn assign(&mut self, to: ExprId, value: FormulaSite) {
        let Expr::Var(number) = self.deck.expr(to) else {
            self.wild = true;
            self.read(FormulaSite { id: to, ..value }, None);
            return self.read(value, None);
        };
        self.read(value, Some(number));
        // Measured values are stored in kept variables; values computed from other variables are scratch.
        let mut scratch = !matches!(self.deck.expr(value.id), Expr::Number(_));
        visit(self.deck, value.id, &mut |_, expr| {
            if let Expr::Var(other) = expr {
                scratch &= other != number && (other <= self.local_count || self.is_common(other));
            }
        });
        self.set(value.group, value.group, number, WordValue::Expr(value.id));
        if let Some(var) = self.make(value.group, number) {
            var.set_at.get_or_insert((value.block, to));
            var.scratch |= scratch;
        }
    }

    /// Records a condition.
    fn compare(&mut self, site: FormulaSite) {
        let deck = self.deck;
        let Expr::Binary(op, left, right) = deck.expr(site.id) else { return };
        let equal = matches!(op, Op::Equal | Op::NotEqual);
        let vacant = self.control.var(0).is_some_and(|row| row.kind == VarKind::Vacant);
        let vacancy = equal && vacant && (deck.expr(left) == Expr::Var(0) || deck.expr(right) == Expr::Var(0));
        let zero = |id| matches!(deck.expr(id), Expr::Number(number) if number.mantissa == 0);
        let variable = |id| matches!(deck.expr(id), Expr::Var(_));
        let with_zero = zero(left) && variable(right) || variable(left) && zero(right);
        let misses_vacant = equal && with_zero && !self.control.macros.vacant_equals_zero;
        let and_here = |range: Option<(u32, u32)>| {
            let (first, last) = range.unwrap_or((site.block, site.block));
            Some((first.min(site.block), last.max(site.block)))
        };
        visit(deck, site.id, &mut |_, expr| {
            let Expr::Var(number) = expr else { return };
            if let Some(var) = self.make(site.group, number) {
                var.vacancy |= vacancy;
                var.compared = and_here(var.compared);
                if !misses_vacant {
                    var.compared_if_vacant = and_here(var.compared_if_vacant);
                }
            }
        });
        if !vacancy {
            self.read(site, None);
            if equal {
                self.equals.push(site);
            }
        }
    }

    /// Records everything that a formula reads and divides by; `to` is the variable assigned from it, if any.
    fn read(&mut self, site: FormulaSite, to: Option<u32>) {
        visit(self.deck, site.id, &mut |id, expr| match expr {
            Expr::Var(number) => {
                if let Some(var) = self.make(site.group, number) {
                    var.read.get_or_insert((site.block, id));
                    var.used |= to != Some(number);
                }
            }
            Expr::Call(Function::Fix | Function::Fup, inner)
                if self.deck.constant(inner).is_some_and(is_beside_whole) =>
            {
                self.cuts.push(FormulaSite { id, ..site });
            }
            Expr::Binary(op @ (Op::Divide | Op::Modulo), divided, divisor) => {
                self.divisors.push(FormulaSite { id: divisor, ..site });
                if op == Op::Divide && matches!(self.deck.expr(divided), Expr::Call(Function::Atan, _)) {
                    self.divided_angles.push(FormulaSite { id, ..site });
                }
            }
            Expr::Binary(op, left, right)
                if op.opposite() != op
                    && self.control.macros.truths
                    && [left, right].into_iter().any(|side| self.joins_number(side)) =>
            {
                self.loose.push(FormulaSite { id, ..site });
            }
            _ => {}
        });
    }

    /// Whether a part is AND, OR or XOR with a number operand, so that a comparison probably lacks its brackets.
    fn joins_number(&self, id: ExprId) -> bool {
        let Expr::Binary(Op::And | Op::Or | Op::Xor, left, right) = self.deck.expr(id) else { return false };
        let truth = |id: ExprId| {
            let Expr::Binary(op, ..) = self.deck.expr(id) else { return false };
            matches!(op, Op::And | Op::Or | Op::Xor) || op.opposite() != op
        };
        !truth(left) || !truth(right)
    }

    /// Whether a variable can be vacant: no program sets it, or a call does not pass it, or it copies such a variable; `rounds` limits the
    /// copies of copies.
    pub(super) fn may_be_vacant(&self, var: &Var, rounds: u32) -> bool {
        if self.wild || var.vacancy {
            return false;
        }
        let group = var.group as usize;
        let never_set = if (1..=self.local_count).contains(&var.number) {
            var.sets == var.given && (self.open[group] || var.given < self.calls[group])
        } else {
            var.sets == 0 && self.is_common(var.number) && !self.operator_set.contains(&var.number)
        };
        never_set
            || match var.copies {
                CopySource::Variable(slot) if rounds > 0 => {
                    self.list.get(slot as usize).is_some_and(|other| self.may_be_vacant(other, rounds - 1))
                }
                _ => false,
            }
    }

    /// Whether a variable keeps values written by programs and operators.
    fn is_common(&self, number: u32) -> bool {
        let kind = self.control.var(number).map(|row| row.kind);
        matches!(kind, Some(VarKind::Common | VarKind::Retained))
    }
}

/// Whether a value differs from a whole number by rounding errors only.
fn is_beside_whole(value: f64) -> bool {
    let off = (value - value.round()).abs();
    off > 0.0 && off <= 1e-9 * value.abs().max(1.0)
}

/// Visits every part of a formula. The recursion is as deep as the formula; the parser limits it.
pub(super) fn visit(deck: &Deck, id: ExprId, each: &mut dyn FnMut(ExprId, Expr)) {
    let expr = deck.expr(id);
    each(id, expr);
    match expr {
        Expr::Number(_) | Expr::Label(_) | Expr::Var(_) => {}
        Expr::Indirect(inner) | Expr::Negate(inner) | Expr::Call(_, inner) => visit(deck, inner, each),
        Expr::Binary(_, left, right) => {
            visit(deck, left, each);
            visit(deck, right, each);
        }
    }
}

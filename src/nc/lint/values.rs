//! Values known without a run: decimals compared for equality, division by zero, variables without any assignment.

use std::collections::BTreeSet;

use super::super::ast::{Expr, ExprId, Op, WordValue};
use super::super::dec::{Dec, POW10};
use super::context::Lint;
use super::facts::Facts;
use super::vars::{CopySource, FormulaSite, LOCALS, ValueKind, Var, Vars, visit};
use crate::controls::Address;
use crate::controls::address::LETTERS;
use crate::controls::macros::{ARGUMENT, VacantWord};
use crate::controls::syntax::Function;
use crate::controls::{Alarm, Control, VarKind};
use crate::msg;
use crate::text::Severity;

/// Maximum rounds of propagating kinds through assignments; each round visits every assignment.
const ROUNDS: usize = 8;

/// Maximum copies of copies followed to a variable that can be vacant.
const COPIES: u32 = 8;

/// Maximum variables named in one remark.
const NAMES: usize = 20;

impl Vars<'_> {
    /// Determines the possible values of each variable.
    pub(super) fn settle(&mut self) {
        for var in &mut self.list {
            let entered = if var.word.is_none() { ValueKind::Entered } else { ValueKind::Decimals };
            var.kind = match self.control.var(var.number).map(|row| row.kind) {
                Some(VarKind::Kept) => entered,
                Some(VarKind::Local | VarKind::Common | VarKind::Retained) if var.sets == 0 => entered,
                Some(VarKind::BlockEnd | VarKind::MachinePosition | VarKind::WorkPosition) => ValueKind::Calculated,
                _ => ValueKind::Whole,
            };
        }
        for _ in 0..ROUNDS {
            let mut changed = false;
            for at in 0..self.sets.len() {
                let set = &self.sets[at];
                let slot = set.slot as usize;
                let (kind, nonzero) = match set.value {
                    WordValue::Number(number) => (written(number), number.mantissa != 0),
                    WordValue::Expr(id) => (self.kind(set.group, id), self.nonzero(set.group, id, None)),
                };
                let var = &mut self.list[slot];
                changed |= kind > var.kind || var.nonzero && !nonzero;
                var.kind = var.kind.max(kind);
                var.nonzero &= nonzero;
            }
            if !changed {
                break;
            }
        }
    }

    fn kind(&self, group: u32, id: ExprId) -> ValueKind {
        match self.deck.expr(id) {
            Expr::Number(number) => written(number),
            Expr::Var(number) if number == 0 && self.local_count > 0 => ValueKind::Whole,
            Expr::Var(number) => self.get(group, number).map_or(ValueKind::Entered, |var| var.kind),
            Expr::Indirect(_) | Expr::Label(_) => ValueKind::Entered,
            Expr::Negate(inner) | Expr::Call(Function::Abs, inner) => self.kind(group, inner),
            Expr::Call(function, _) if rounds(function) => ValueKind::Whole,
            Expr::Call(..) | Expr::Binary(Op::Divide | Op::Atan | Op::Power, ..) => ValueKind::Calculated,
            Expr::Binary(Op::Add | Op::Subtract | Op::Multiply | Op::Modulo, left, right) => {
                match self.kind(group, left).max(self.kind(group, right)) {
                    ValueKind::Decimals => ValueKind::Calculated,
                    kind => kind,
                }
            }
            Expr::Binary(..) => ValueKind::Whole,
        }
    }

    /// Whether a value cannot be 0. Variables compared before `block` count as guarded; without a block, variables compared anywhere.
    fn nonzero(&self, group: u32, id: ExprId, block: Option<u32>) -> bool {
        match self.deck.expr(id) {
            Expr::Number(number) => number.mantissa != 0,
            Expr::Var(number) => {
                let var = self.get(group, number);
                var.is_some_and(|var| var.sets > 0 && var.nonzero || self.guarded(var, block))
            }
            Expr::Negate(inner)
            | Expr::Binary(Op::Divide, inner, _)
            | Expr::Call(Function::Abs | Function::Sqrt, inner) => self.nonzero(group, inner, block),
            Expr::Binary(Op::Multiply, left, right) => {
                self.nonzero(group, left, block) && self.nonzero(group, right, block)
            }
            // With a number added, zero would be a coincidence.
            Expr::Binary(Op::Add, left, right) => {
                matches!(self.deck.expr(left), Expr::Number(_)) || matches!(self.deck.expr(right), Expr::Number(_))
            }
            Expr::Call(Function::Exp, _) => true,
            _ => false,
        }
    }

    /// Whether the variable was compared before a block, by a comparison that holds back a vacant one too where it can be vacant.
    fn guarded(&self, var: &Var, block: Option<u32>) -> bool {
        let vacant = self.may_be_vacant(var, COPIES);
        self.reaches(if vacant { var.compared_if_vacant } else { var.compared }, block)
    }

    /// Whether comparisons, by their first and last block, are before a block of its program, or in another program; without a block, anywhere.
    fn reaches(&self, compared: Option<(u32, u32)>, block: Option<u32>) -> bool {
        let Some((first, last)) = compared else { return false };
        let Some(block) = block else { return true };
        let program = self.deck.programs.partition_point(|program| program.end <= block);
        first < block || self.deck.programs.get(program).is_some_and(|program| last >= program.end)
    }

    /// The part of a divisor that can be 0: a variable or a difference that was not compared before.
    fn can_be_zero(&self, site: FormulaSite) -> Option<ExprId> {
        match self.deck.expr(site.id) {
            // Variables without any assignment have their own warning.
            Expr::Var(number) => (!self.nonzero(site.group, site.id, Some(site.block))
                && !self.unset(site.group, number))
            .then_some(site.id),
            Expr::Negate(id) | Expr::Call(Function::Abs | Function::Sqrt, id) => {
                self.can_be_zero(FormulaSite { id, ..site })
            }
            Expr::Binary(Op::Multiply, left, right) => self
                .can_be_zero(FormulaSite { id: left, ..site })
                .or_else(|| self.can_be_zero(FormulaSite { id: right, ..site })),
            Expr::Binary(Op::Subtract, left, right) => {
                let open = |id| match self.deck.expr(id) {
                    Expr::Var(number) => Some(
                        !self.reaches(self.get(site.group, number)?.compared, Some(site.block))
                            && !self.unset(site.group, number),
                    ),
                    Expr::Number(_) => Some(true),
                    _ => None,
                };
                let numbers = [left, right].iter().all(|id| matches!(self.deck.expr(*id), Expr::Number(_)));
                (!numbers && open(left)? && open(right)?).then_some(site.id)
            }
            _ => None,
        }
    }

    /// Whether a variable is the vacant one, or a local one that no call passes and no block assigns or tests for vacancy.
    fn unset(&self, group: u32, number: u32) -> bool {
        match self.get(group, number) {
            Some(var) if (1..=self.local_count).contains(&number) => {
                !self.wild && !self.open[group as usize] && var.sets == 0 && var.given == 0 && !var.vacancy
            }
            _ => self.control.var(number).is_some_and(|row| row.kind == VarKind::Vacant),
        }
    }

    /// Reports all findings.
    pub(super) fn report(&self, lint: &mut Lint, facts: &Facts) {
        let divisors = self.divisors(lint);
        self.comparisons(lint);
        let unset = self.commons(lint, facts, &divisors);
        self.entries(lint, unset);
        for (group, base) in self.locals.iter().enumerate() {
            if let Some(base) = *base
                && !self.open[group]
                && !self.wild
            {
                for var in self.list.iter().skip(base as usize).take(LOCALS as usize) {
                    self.local(lint, facts, group, var);
                }
            }
        }
    }

    /// Reports divisors that can be 0, each variable once per program; returns the reported variables.
    fn divisors(&self, lint: &mut Lint) -> BTreeSet<u32> {
        let alarm = self.control.alarm_number(Alarm::DivisionByZero).unwrap_or("");
        let mut reported: BTreeSet<(usize, u32)> = BTreeSet::new();
        for site in &self.divisors {
            let Some(id) = self.can_be_zero(*site) else { continue };
            let (place, divisor) = lint.written(site.block, lint.part(site.block, id));
            let (variable, hint) = match (self.deck.expr(id), self.control.syntax.names()) {
                (Expr::Var(number), None) => (Some(number), msg!("nc.hint.divisor", divisor)),
                (Expr::Var(number), Some(_)) => (Some(number), msg!("nc.hint.divisor-named", divisor)),
                (_, None) => (None, msg!("nc.hint.difference", divisor)),
                (_, Some(_)) => (None, msg!("nc.hint.difference-named", divisor)),
            };
            let program = self.deck.programs.partition_point(|program| program.end <= site.block);
            // The comparison with 0 lets a vacant variable pass.
            let compared = variable.and_then(|number| self.get(site.group, number)?.compared);
            let message = if self.reaches(compared, Some(site.block)) {
                msg!("lint.vacant-divisor", divisor, alarm)
            } else {
                msg!("lint.zero-divisor", divisor, alarm)
            };
            if variable.is_none_or(|number| reported.insert((program, number)))
                && let Some(finding) = lint.warn(place, message)
            {
                finding.hints.push(hint);
            }
        }
        reported.into_iter().map(|key| key.1).collect()
    }

    /// Reports comparisons without brackets around them, and decimals compared for equality.
    fn comparisons(&self, lint: &mut Lint) {
        for site in &self.loose {
            let (place, condition) = lint.written(site.block, lint.part(site.block, site.id));
            lint.warn(place, msg!("lint.loose-comparison", condition));
        }
        for site in &self.cuts {
            let Expr::Call(function, inner) = self.deck.expr(site.id) else { continue };
            let Some(value) = self.deck.constant(inner) else { continue };
            let cut = if function == Function::Fix { value.trunc() } else { value.trunc() + value.signum() };
            let [value, result] = [format!("{value}"), format!("{cut}")];
            let function = self.control.syntax.functions.iter().find(|row| row.1 == function).map_or("", |row| row.0);
            let (place, formula) = lint.written(site.block, lint.part(site.block, inner));
            lint.warn(place, msg!("lint.cut-decimal", formula, value, function, result));
        }
        let atan = self.control.syntax.functions.iter().filter(|row| row.1 == Function::Atan).map(|row| row.0);
        let atan: Vec<&str> = atan.collect();
        for site in &self.divided_angles {
            let (place, formula) = lint.written(site.block, lint.part(site.block, site.id));
            // Only as it would be written for a control with an arc tangent of two numbers.
            let compact: String = formula.chars().filter(|c| *c != ' ').collect();
            if compact.contains("]/[") && atan.iter().any(|name| compact.starts_with(name)) {
                lint.warn(place, msg!("lint.divided-angle", formula, control = self.control.name));
            }
        }
        let exact = self.control.macros.equal_within == 0.0;
        for site in self.equals.iter().filter(|site| exact && self.differs(site)) {
            let (place, condition) = lint.written(site.block, lint.part(site.block, site.id));
            if let Some(finding) = lint.warn(place, msg!("lint.equal-decimals", condition)) {
                finding.hints.push(msg!("nc.hint.equal"));
            }
        }
    }

    /// Checks variables that are not local; returns those read but never assigned, with their index in the list.
    fn commons(&self, lint: &mut Lint, facts: &Facts, divisors: &BTreeSet<u32>) -> Vec<(u64, usize)> {
        let ends = facts.programs.iter().any(|part| part.ends);
        let mut unset: Vec<(u64, usize)> = Vec::new();
        for (slot, var) in self.list.iter().enumerate().filter(|row| row.1.number > self.local_count) {
            let Some(row) = self.control.var(var.number) else { continue };
            match row.kind {
                VarKind::Common | VarKind::Retained
                    if var.sets == 0 && !self.wild && !lint.set.contains(&var.number) =>
                {
                    if var.read.is_some() {
                        unset.push((var.number.into(), slot));
                    }
                    if var.compared.is_none() && !divisors.contains(&var.number) {
                        self.vacant_word(lint, var);
                    }
                }
                VarKind::Kept if var.scratch && var.used => {
                    if let Some((block, id)) = var.set_at {
                        let (place, variable) = lint.written(block, lint.part(block, id));
                        lint.warn(place, msg!("lint.kept-as-scratch", variable, meaning = row.text));
                    }
                }
                // Safeguards that the programs switch off and never switch on again.
                VarKind::SuppressSingleBlock | VarKind::SuppressOverride if !ends && var.nonzero => {
                    if let Some((block, id)) = var.set_at {
                        let (place, variable) = lint.written(block, lint.part(block, id));
                        lint.warn(place, msg!("lint.suppression-stays", variable));
                    }
                }
                _ => {}
            }
        }
        unset
    }

    /// Whether a test for equality may be false because of rounding errors.
    fn differs(&self, site: &FormulaSite) -> bool {
        let Expr::Binary(_, left, right) = self.deck.expr(site.id) else { return false };
        // A comparison with a rounded value tests for whole numbers.
        let mut whole = false;
        visit(self.deck, site.id, &mut |_, expr| whole |= matches!(expr, Expr::Call(function, _) if rounds(function)));
        // A comparison with the variable's own copy detects a change.
        let slot = |id| match self.deck.expr(id) {
            Expr::Var(number) => self.slot(site.group, number),
            _ => None,
        };
        if let (Some(a), Some(b)) = (slot(left), slot(right)) {
            let copies = |one: usize, other: usize| self.list[one].copies == CopySource::Variable(other as u32);
            whole |= copies(a, b) || copies(b, a);
        }
        let (left, right) = (self.kind(site.group, left), self.kind(site.group, right));
        let most = left.max(right);
        !whole
            && (most == ValueKind::Calculated || most == ValueKind::Decimals && left.min(right) == ValueKind::Entered)
    }

    /// Checks a local variable that is never assigned, or that not every call passes.
    fn local(&self, lint: &mut Lint, facts: &Facts, group: usize, var: &Var) {
        let calls = self.calls[group];
        if var.sets == 0 && var.given == 0 && !var.vacancy {
            let Some((block, id)) = var.read else { return };
            let argument = ARGUMENT.iter().position(|&number| u32::from(number) == var.number);
            let letter = LETTERS.get(argument.unwrap_or(0)).copied().unwrap_or(Address::A);
            // Whether a subprogram call has a word with this letter, which only a macro call passes as an argument.
            let lost = || {
                let subs = facts.calls.iter().filter(|call| !call.with_locals);
                let mut here = subs.filter(|call| self.group[call.to as usize] as usize == group);
                here.any(|call| {
                    let block = self.deck.blocks.get(call.block as usize);
                    block.is_some_and(|block| self.deck.words_of(block).iter().any(|word| word.letter == letter))
                })
            };
            let (place, variable) = lint.written(block, lint.part(block, id));
            let hint = match argument {
                Some(_) if calls > 0 => msg!("nc.hint.argument", address = letter.to_string()),
                Some(_) if lost() => msg!("nc.hint.sub-argument", variable, address = letter.to_string()),
                _ => msg!("nc.hint.unset-local", variable),
            };
            if let Some(finding) = lint.warn(place, msg!("lint.unset-local", variable)) {
                finding.hints.push(hint);
            }
        } else if var.given < calls && var.sets <= var.given && var.compared.is_none() {
            self.vacant_word(lint, var);
        }
    }

    fn vacant_word(&self, lint: &mut Lint, var: &Var) {
        if let Some((block, span)) = var.word
            && self.control.macros.vacant_word == VacantWord::Dropped
        {
            let (place, word) = lint.written(block, span);
            let variable = name(self.control, var);
            if let Some(finding) = lint.warn(place, msg!("lint.vacant-word", word, variable = variable.as_str())) {
                finding.hints.push(msg!("nc.hint.vacant", variable));
            }
        }
    }

    /// Reports variables that the operator has to set, in one remark at the first one read.
    fn entries(&self, lint: &mut Lint, mut unset: Vec<(u64, usize)>) {
        let mut names = String::new();
        let first = unset.iter().filter_map(|&(_, slot)| self.list[slot].read).min_by_key(|(block, id)| (*block, id.0));
        let Some((block, id)) = first else { return };
        unset.sort_unstable();
        for (count, &(_, slot)) in unset.iter().enumerate() {
            let var = &self.list[slot];
            if count <= NAMES {
                names += if count > 0 { ", " } else { "" };
                names += &if count < NAMES { name(self.control, var) } else { "…".to_owned() };
            }
        }
        let (place, _) = lint.written(block, lint.part(block, id));
        let message = match self.control.syntax.names() {
            None => msg!("lint.unset-common", variables = names),
            Some(_) => msg!("lint.unset-parameter", variables = names),
        };
        if let Some(finding) = lint.warn(place, message) {
            finding.severity = Severity::Info;
        }
    }
}

/// The variable in the control's spelling.
fn name(control: &Control, var: &Var) -> String {
    control.variable(var.number)
}

/// Kind of a number as written.
fn written(number: Dec) -> ValueKind {
    if number.mantissa % POW10[number.scale.min(18) as usize] == 0 { ValueKind::Whole } else { ValueKind::Decimals }
}

/// Whether a function gives whole numbers.
fn rounds(function: Function) -> bool {
    matches!(function, Function::Round | Function::Fix | Function::Fup | Function::Bin | Function::Bcd)
}

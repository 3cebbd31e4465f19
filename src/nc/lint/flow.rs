//! Control flow: the successors of each block, and unreachable blocks.

use std::collections::{BTreeMap, BTreeSet};

use super::super::ast::{Block, Deck, Expr, ExprId, Jump, JumpDirection, Stmt, WordValue};
use super::super::block_index::{SequenceNumbers, labels_of};
use super::context::{Lint, whole};
use super::facts::Facts;
use super::roles::{END, RETURN, Roles};
use crate::controls::Address;
use crate::controls::Control;
use crate::msg;

/// Maximum repeated sequence numbers in the warnings of a program.
const TWICE: usize = 20;

/// Target of the jump of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum JumpTo {
    /// It does not jump, or its target does not exist.
    Nowhere,
    /// This block; one beyond the last where a loop is the end of its program.
    Block(u32),
    /// Any block: a calculated sequence number, or one of several targets.
    Anywhere,
}

impl JumpTo {
    /// The target with this index, if it exists.
    fn block(index: Option<u32>) -> JumpTo {
        index.map_or(JumpTo::Nowhere, JumpTo::Block)
    }
}

/// Successors of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Successors {
    pub(super) jump: JumpTo,
    /// The next block may follow.
    pub(super) falls: bool,
}

/// The blocks of one program and their successors. Indices count from its first block.
pub(super) struct Flow<'a> {
    pub(super) deck: &'a Deck,
    pub(super) control: &'static Control,
    pub(super) roles: &'a Roles<'a>,
    /// Index of the program.
    program: u32,
    pub(super) blocks: &'a [Block],
    /// Index of the first block in the deck.
    pub(super) base: u32,
    numbers: SequenceNumbers,
    /// Blocks of each label, rising.
    labels: BTreeMap<&'a str, Vec<usize>>,
    /// END of a DO and DO of an END; empty without loops.
    partner: Vec<Option<u32>>,
}

impl<'a> Flow<'a> {
    pub(super) fn new(deck: &'a Deck, control: &'static Control, roles: &'a Roles<'a>, program: usize) -> Flow<'a> {
        let row = &deck.programs[program];
        let blocks = deck.blocks_of(row);
        let mut partner = Vec::new();
        let mut open: Vec<(u64, usize)> = Vec::new();
        for (at, block) in blocks.iter().enumerate() {
            match block.stmt {
                Stmt::While { label, .. } => open.push((label.into(), at)),
                Stmt::End { .. } => {
                    // The reader reports loops that do not match.
                    if let Some((_, start)) = open.pop() {
                        partner.resize(blocks.len(), None);
                        partner[start] = Some(at as u32);
                        partner[at] = Some(start as u32);
                    }
                }
                _ => {}
            }
        }
        let (numbers, labels) = (SequenceNumbers::new(blocks, 0), labels_of(deck, blocks));
        Flow { deck, control, roles, program: program as u32, blocks, base: row.first, numbers, labels, partner }
    }

    fn jump(&self, target: ExprId, from: u32, way: JumpDirection) -> JumpTo {
        match self.deck.expr(target) {
            Expr::Label(label) => {
                let places = self.labels.get(self.deck.text(Some(label))).map_or(&[][..], Vec::as_slice);
                JumpTo::block(way.nearest(from as usize, places).map(|to| to as u32))
            }
            Expr::Number(number) => {
                let number = whole(WordValue::Number(number));
                JumpTo::block(number.and_then(|number| self.numbers.target(number, from, way)))
            }
            _ => JumpTo::Anywhere,
        }
    }

    /// Successors of a block.
    pub(super) fn successors(&self, at: u32) -> Successors {
        use JumpTo::{Anywhere, Nowhere};
        let Some(block) = self.blocks.get(at as usize) else { return Successors { jump: Nowhere, falls: false } };
        let partner = || self.partner.get(at as usize).copied().flatten();
        let (jump, falls) = match block.stmt {
            Stmt::Words { .. } => {
                let words = self.deck.words_of(block);
                // A `/` in the middle of a block makes the rest optional.
                (
                    Nowhere,
                    self.roles.block(words) & (END | RETURN) == 0
                        || words.iter().any(|word| word.letter == Address::Skip),
                )
            }
            Stmt::If { cond, target, way, .. } => match self.deck.holds(cond) {
                Some(true) => (self.jump(target, at, way), false),
                Some(false) => (Nowhere, true),
                None => (self.jump(target, at, way), true),
            },
            Stmt::Goto { target, way, .. } => (self.jump(target, at, way), false),
            // To one of several targets.
            Stmt::Ifs { .. } => (Anywhere, true),
            Stmt::While { cond: Some(cond), .. } => match self.deck.holds(cond) {
                Some(true) => (Nowhere, true),
                holds => (JumpTo::block(partner().map(|end| end + 1)), holds.is_none()),
            },
            Stmt::End { .. } => (JumpTo::block(partner()), false),
            Stmt::Assign { to, .. } => (Nowhere, !self.deck.raises_alarm(self.control, to)),
            _ => (Nowhere, true),
        };
        Successors { jump, falls: falls || block.skip > 0 }
    }

    /// Whether a block leads to an alarm before anything else; jumps to it handle errors.
    pub(super) fn is_alarm_exit(&self, from: u32) -> bool {
        let goes_on = Successors { jump: JumpTo::Nowhere, falls: true };
        let mut at = from;
        while at < from + 20 && self.successors(at) == goes_on {
            at += 1;
        }
        match self.blocks.get(at as usize) {
            Some(Block { stmt: Stmt::Assign { to, .. }, .. }) => self.deck.raises_alarm(self.control, *to),
            _ => false,
        }
    }

    /// Reports repeated sequence numbers that are jump targets.
    pub(super) fn twice(&self, lint: &mut Lint, facts: &Facts) {
        if self.control.syntax.names().is_some() {
            // In a language with labels each jump has a direction, so that a repeated number is no mistake.
            return;
        }
        let twice = || self.numbers.all().windows(2).filter(|pair| pair[0].0 == pair[1].0);
        if twice().next().is_none() || lint.is_full() {
            return;
        }
        let (jumped, any) = self.jumped();
        let entered = |number| any || facts.enters(self.program, number) || jumped.contains(&number);
        for pair in twice().filter(|pair| entered(pair[0].0)).take(TWICE) {
            let [first, second] = [pair[0], pair[1]].map(|row| self.base + row.1);
            let (place, block) = lint.written(second, lint.number(second));
            let line = lint.line(first);
            lint.warn(place, msg!("lint.number-twice", block, line));
        }
    }

    /// Sequence numbers that the program jumps to, and whether it jumps to calculated ones.
    fn jumped(&self) -> (BTreeSet<u32>, bool) {
        let (mut numbers, mut any) = (BTreeSet::new(), false);
        for Jump { target, .. } in self.blocks.iter().flat_map(|block| self.deck.jumps_of(block.stmt)) {
            match self.deck.expr(target) {
                Expr::Number(target) => numbers.extend(whole(WordValue::Number(target))),
                _ => any = true,
            }
        }
        (numbers, any)
    }

    /// Reports unreachable blocks, each run of them once.
    pub(super) fn unreachable(&self, lint: &mut Lint, facts: &Facts) {
        let part = facts.programs[self.program as usize];
        let mut seen = vec![false; self.blocks.len()];
        let mut open = vec![JumpTo::Block(0)];
        let firsts = self.numbers.all().chunk_by(|a, b| a.0 == b.0).filter_map(<[_]>::first);
        open.extend(firsts.filter(|row| facts.enters(self.program, row.0)).map(|row| JumpTo::Block(row.1)));
        // If the callers of a subprogram are not here, any sequence number may be an entry.
        if !part.called && !part.ends || facts.any_entry {
            open.push(JumpTo::Anywhere);
        }
        let mut all = false;
        while let Some(jump) = open.pop() {
            let mut at = match jump {
                JumpTo::Block(at) => at,
                JumpTo::Anywhere if !all => {
                    all = true;
                    let labelled = self.blocks.iter().enumerate().filter(|row| row.1.label.is_some());
                    let numbered = self.numbers.all().iter().map(|row| row.1);
                    open.extend(numbered.chain(labelled.map(|row| row.0 as u32)).map(JumpTo::Block));
                    continue;
                }
                JumpTo::Anywhere | JumpTo::Nowhere => continue,
            };
            while let Some(seen) = seen.get_mut(at as usize).filter(|seen| !**seen) {
                *seen = true;
                let Successors { jump, falls } = self.successors(at);
                open.push(jump);
                if !falls {
                    break;
                }
                at += 1;
            }
        }
        // A reachable block after the last one ends each run.
        seen.push(true);
        let (mut first, mut count) = (0, 0_u32);
        for (at, seen) in seen.into_iter().enumerate() {
            if let Some(block) = self.blocks.get(at).filter(|_| !seen) {
                // A program needs its end even if it is unreachable.
                let words = self.deck.words_of(block);
                let end = words.len() == 1 && self.roles.block(words) & (END | RETURN) != 0;
                if block.stmt != Stmt::Empty && !end {
                    first = if count == 0 { at } else { first };
                    count += 1;
                }
            } else if count > 0 {
                let span = self.blocks[first].span;
                let (place, _) = lint.written(self.base + first as u32, span);
                lint.warn(place, msg!("lint.unreachable", count));
                count = 0;
            }
        }
    }
}

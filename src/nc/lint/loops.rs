//! Spindle and auxiliary functions in every pass of a loop: each waits for the PLC and stops the path.

use std::collections::BTreeSet;

use super::super::ast::{Block, Expr, Stmt, Word, WordValue};
use super::context::Lint;
use super::facts::Facts;
use super::flow::{Flow, JumpTo, Successors};
use super::roles::{AUXILIARY, CALL, CURVED, DWELL, LINEAR, RAPID, SPECIAL, SPINDLE, SPINDLE_REST, SUB, SURFACE};
use super::vars::visit;
use crate::controls::Address;
use crate::msg;
use crate::text::{DiagnosticKind, Message, Place, Span};

/// Maximum visits of blocks per block of the text; inner loops are visited again.
const BUDGET: usize = 8;

/// Maximum checked programs that loops call.
const CALLED: usize = 1000;

/// Maximum different words kept of one kind.
const KINDS: usize = 4;

/// Words of one kind in a pass.
#[derive(Default)]
struct Function<'a> {
    /// All different words; a pass that alternates between them does so intentionally.
    all: Vec<&'a Word>,
    /// The first word of each block that is in every pass, with the block.
    always: Vec<(u32, Span)>,
}

/// Checks the loops of all programs.
pub(super) fn loops(lint: &mut Lint, facts: &Facts, flows: &[Flow]) {
    let mut called: Vec<u32> = Vec::new();
    for flow in flows {
        let mut budget = BUDGET * flow.blocks.len();
        for at in 0..flow.blocks.len() as u32 {
            let JumpTo::Block(start) = flow.successors(at).jump else { continue };
            let Some(blocks) = at.checked_sub(start).map(|blocks| blocks as usize) else { continue };
            if blocks <= budget {
                budget -= blocks;
                pass(lint, flow, facts, (start, at), &mut called);
            }
        }
    }
    let Some(flow) = flows.first() else { return };
    let mut at = 0;
    while let Some(&program) = called.get(at).filter(|_| at < CALLED) {
        if !called[..at].contains(&program) && !facts.programs[program as usize].faulty {
            let flow = Flow::new(flow.deck, flow.control, flow.roles, program as usize);
            let end = flow.blocks.len().saturating_sub(1) as u32;
            pass(lint, &flow, facts, (0, end), &mut called);
        }
        at += 1;
    }
}

/// Checks one pass of a loop, or of a program called by a loop: the blocks from `start` to `end`. Blocks that a jump within the pass may
/// skip are not in every pass. Programs called in every pass are added to `called`.
fn pass(lint: &mut Lint, flow: &Flow, facts: &Facts, (start, end): (u32, u32), called: &mut Vec<u32>) {
    let mut pass = Pass::default();
    // Blocks before this one are not in every pass.
    let mut certain = start;
    for at in start..=end {
        let Some(block) = flow.blocks.get(at as usize) else { break };
        let always = at >= certain && block.skip == 0;
        match flow.successors(at) {
            // Blocks after one that never continues are reached only by a jump.
            Successors { jump: JumpTo::Anywhere, .. } => certain = end + 1,
            Successors { falls: false, .. } if at < end => certain = end + 1,
            Successors { jump: JumpTo::Block(to), .. } if to > at && to <= end && !flow.is_alarm_exit(to) => {
                certain = certain.max(to);
            }
            _ => {}
        }
        if let Stmt::Assign { to, .. } | Stmt::IfThen { to, .. } = block.stmt {
            match flow.deck.expr(to) {
                Expr::Var(number) => drop(pass.assigned.insert(number)),
                _ => pass.assigns_any = true,
            }
        }
        let bits = flow.roles.block(flow.deck.words_of(block));
        let here = at + flow.base;
        if bits & (CALL | SUB) != 0 && always {
            let call = facts.calls.partition_point(|call| call.block < here);
            called.extend(facts.calls.get(call).filter(|call| call.block == here).map(|call| call.to));
        }
        if bits & (CALL | SPECIAL) == 0 {
            pass.words(flow, (here, block), bits, always);
        }
    }
    pass.report(lint, flow);
}

/// Actions of the blocks of a pass.
#[derive(Default)]
struct Pass<'a> {
    spindle: Function<'a>,
    auxiliary: Function<'a>,
    /// Variables assigned by the pass.
    assigned: BTreeSet<u32>,
    /// A variable with a calculated number is assigned.
    assigns_any: bool,
    /// A block moves in rapid traverse; axes move; a block cuts.
    rapid: bool,
    moves: bool,
    cuts: bool,
    /// The spindle stops, or is positioned.
    rests: bool,
    /// A surface speed is commanded; the program dwells.
    surface: bool,
    dwells: bool,
}

impl<'a> Pass<'a> {
    /// Records the words of a block; `always` if the block is in every pass.
    fn words(&mut self, flow: &Flow<'a>, (here, block): (u32, &Block), bits: u32, always: bool) {
        self.rapid |= bits & RAPID != 0;
        self.cuts |= bits & (LINEAR | CURVED) != 0;
        self.rests |= bits & SPINDLE_REST != 0;
        self.surface |= bits & SURFACE != 0;
        self.dwells |= bits & DWELL != 0;
        for word in flow.deck.words_of(block) {
            self.moves |= flow.control.is_axis(word.letter);
            let role = if word.letter == Address::M { flow.roles.word(word) } else { 0 };
            let function = if word.letter == Address::S || role & SPINDLE != 0 {
                &mut self.spindle
            } else if role & AUXILIARY != 0 {
                &mut self.auxiliary
            } else {
                continue;
            };
            let is_new = function.all.iter().all(|row| (row.letter, row.value) != (word.letter, word.value));
            if function.all.len() < KINDS && is_new {
                function.all.push(word);
            }
            if always && function.always.last().is_none_or(|row| row.0 != here) {
                function.always.push((here, word.span(block)));
            }
        }
    }

    /// Whether the pass commands the spindle intentionally: it stops it, reverses it, changes its speed, or waits for the surface speed of
    /// another diameter.
    fn controls_spindle(&self, flow: &Flow) -> bool {
        let spindle = &self.spindle.all;
        let twice = |(at, word): (usize, &&Word)| spindle[..at].iter().any(|other| other.letter == word.letter);
        let changes = |word: &&Word| {
            let WordValue::Expr(id) = word.value else { return false };
            let mut changes = self.assigns_any;
            visit(flow.deck, id, &mut |_, expr| {
                changes |= matches!(expr, Expr::Var(number) if self.assigned.contains(&number));
            });
            changes
        };
        let waits = self.surface && self.dwells;
        self.rests || waits || spindle.iter().enumerate().any(twice) || spindle.iter().any(changes)
    }

    fn report(&self, lint: &mut Lint, flow: &Flow) {
        if !self.controls_spindle(flow) {
            self.spindle.report(lint, DiagnosticKind::SpindleInLoop, |code| msg!("lint.spindle-in-loop", code));
        }
        if self.auxiliary.all.len() == 1 && (self.cuts || self.moves && !self.rapid) {
            self.auxiliary.report(lint, DiagnosticKind::AuxiliaryInLoop, |code| msg!("lint.auxiliary-in-loop", code));
        }
    }
}

impl Function<'_> {
    fn report(&self, lint: &mut Lint, kind: DiagnosticKind, message: fn(&str) -> Message) {
        for &(block, span) in &self.always {
            if lint.is_full() {
                return;
            }
            let (place, code) = lint.written(block, span);
            // An inner loop, or a program called by two loops, is visited twice.
            let start = |place: Place| (place.file, place.span.start);
            if lint.found.iter().all(|d| d.kind != kind || d.place.map(start) != Some(start(place)))
                && let Some(finding) = lint.warn(place, message(code))
            {
                finding.kind = kind;
            }
        }
    }
}

//! Pre-check of statements: constant parts of formulas, assignments and jump targets.

use super::check::Precheck;
use crate::controls::{Alarm, VarKind};
use crate::nc::{Assignment, Block, Expr, ExprId, Jump, Stmt, WordValue};

/// Alarms of writing to a variable, without the alarms that programs raise on purpose.
const WRITES: [Alarm; 4] = [Alarm::VariableRange, Alarm::ReadOnly, Alarm::VacantWritten, Alarm::VariableSide];

impl Precheck<'_> {
    /// Checks a block.
    pub(super) fn block(&mut self, at: u32, block: &Block) {
        let deck = self.cx.deck;
        match block.stmt {
            Stmt::Words { .. } => {
                let words = deck.words_of(block);
                for word in words {
                    if let WordValue::Expr(id) = word.value {
                        self.formula(block, id);
                    }
                }
                if self.words_as_commands {
                    self.block_words(at, block, words);
                }
            }
            Stmt::IfThen { cond, to, value } => {
                self.formula(block, cond);
                self.formula(block, value);
                self.assigned(block, to, value);
            }
            Stmt::While { cond, .. } => cond.into_iter().for_each(|id| self.formula(block, id)),
            Stmt::Call { repeats, .. } => repeats.into_iter().for_each(|id| self.formula(block, id)),
            stmt => {
                for Assignment { to, value } in deck.assignments_of(stmt) {
                    self.formula(block, value);
                    self.assigned(block, to, value);
                }
                for Jump { cond, target, .. } in deck.jumps_of(stmt) {
                    cond.into_iter().chain([target]).for_each(|id| self.formula(block, id));
                    if self.is_constant(target) {
                        let jumped = self.state.go_to(&mut self.cx, at, target);
                        self.report(
                            block,
                            jumped,
                            &[Alarm::IntoLoop, Alarm::JumpNumber, Alarm::GotoTarget, Alarm::NoSequence],
                        );
                    }
                }
            }
        }
    }

    /// Writes to the variable of an assignment, if it is constant and not merely stored.
    fn assigned(&mut self, block: &Block, to: ExprId, value: ExprId) {
        use VarKind::{Common, Kept, Local, Retained};
        let kept = |number| {
            self.cx.control.var(number).is_some_and(|row| matches!(row.kind, Local | Common | Retained | Kept))
        };
        match self.cx.deck.expr(to) {
            Expr::Var(number) if kept(number) => return,
            Expr::Indirect(x) => {
                self.formula(block, x);
                if !self.is_constant(x) {
                    return;
                }
            }
            _ => {}
        }
        let mut state = self.state.clone();
        let outcome = if self.is_constant(value) {
            state.assign(&mut self.cx, block, to, value)
        } else {
            let number = state.variable_of(&mut self.cx, to);
            number.and_then(|number| state.write(&mut self.cx, block, number, 0.0).map_err(|trap| trap.part(to)))
        };
        match outcome {
            // With another value the warning may differ.
            Ok(()) if self.is_constant(value) => self.found.extend(self.heard.take()),
            outcome => self.report(block, outcome, &WRITES),
        }
    }

    /// Calculates the constant parts of a formula.
    fn formula(&mut self, block: &Block, id: ExprId) {
        let expr = self.cx.deck.expr(id);
        if self.is_constant(id) {
            if !matches!(expr, Expr::Number(_) | Expr::Var(_)) {
                let value = self.state.value(&mut self.cx, id).map(|_| ());
                self.report(block, value, &[]);
            }
            return;
        }
        match expr {
            Expr::Number(_) | Expr::Label(_) | Expr::Var(_) => {}
            Expr::Indirect(x) if self.is_constant(x) => {
                let value = self.state.value(&mut self.cx, id).map(|_| ());
                self.report(block, value, &[]);
            }
            Expr::Indirect(x) | Expr::Negate(x) | Expr::Call(_, x) => self.formula(block, x),
            Expr::Binary(op, left, right) => {
                self.formula(block, left);
                if self.is_constant(right) {
                    let value = self.state.operand(&mut self.cx, op, right);
                    self.report(block, value, &[]);
                } else {
                    self.formula(block, right);
                }
            }
        }
    }
}

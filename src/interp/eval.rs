//! Evaluation of formulas, vacant variables included, and location of the part that raises an alarm.

use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::operators::{calculate, function, is_zero_divisor, truth, zero_if_vacant};
use super::state::RunState;
use crate::controls::syntax::Function;
use crate::controls::{Alarm, VarKind};
use crate::msg;
use crate::nc::{Expr, ExprId, Op};
use crate::text::catalog::number_text;

impl RunState {
    /// Value of an expression; vacant if it is only a vacant variable. An alarm is located at the part without a value.
    pub(super) fn value(&self, cx: &mut BlockContext, id: ExprId) -> BlockResult<f64> {
        match self.part(cx, id) {
            Err(trap @ Trap::Alarm(_)) => Err(self.blame(cx, id, trap)),
            value => value,
        }
    }

    /// Value of a part of an expression.
    ///
    /// The recursion is as deep as the formula; the parser limits formulas to a few hundred parts.
    fn part(&self, cx: &mut BlockContext, id: ExprId) -> BlockResult<f64> {
        match cx.deck.expr(id) {
            Expr::Number(dec) => Ok(dec.to_f64()),
            Expr::Var(number) => self.read(cx, number),
            Expr::Label(_) => Err(Trap::alarm(Alarm::Format, msg!("interp.not-a-variable"))),
            Expr::Binary(op, left, right) => self.binary(cx, op, left, right),
            Expr::Indirect(number) => {
                let number = self.part(cx, number)?;
                let number = variable_number(cx, number)?;
                self.read(cx, number)
            }
            Expr::Negate(x) => {
                // A vacant variable with a sign stays vacant: `X-#1` is dropped like `X#1`.
                Ok(-self.part(cx, x)?)
            }
            Expr::Call(Function::AddPoint, x) => {
                let value = zero_if_vacant(self.part(cx, x)?);
                let Expr::Var(number) = cx.deck.expr(x) else { return Ok(value) };
                Ok(if self.was_written_without_point(number, value) { value * cx.shared.units.per_unit } else { value })
            }
            Expr::Call(name, x) => {
                let x = self.part(cx, x)?;
                function(cx, name, zero_if_vacant(x))
            }
        }
    }

    /// Finds the smallest part without a value whose operands have values.
    #[cold]
    fn blame(&self, cx: &mut BlockContext, mut id: ExprId, trap: Trap) -> Trap {
        loop {
            let parts = match cx.deck.expr(id) {
                Expr::Number(_) | Expr::Label(_) | Expr::Var(_) => [None; 2],
                Expr::Indirect(x) | Expr::Negate(x) | Expr::Call(_, x) => [Some(x), None],
                Expr::Binary(_, left, right) => [Some(left), Some(right)],
            };
            match parts.into_iter().flatten().find(|part| self.part(cx, *part).is_err()) {
                Some(part) => id = part,
                None => return trap.part(id),
            }
        }
    }

    /// Value stored by an assignment: vacant only if the right side is a variable alone, never `-0`.
    pub(super) fn assigned(&self, cx: &mut BlockContext, id: ExprId) -> BlockResult<f64> {
        let alone = matches!(cx.deck.expr(id), Expr::Var(_) | Expr::Indirect(_));
        let value = self.value(cx, id)?;
        // Adding 0 turns -0 into 0 and changes no other value.
        Ok(if alone { value + 0.0 } else { zero_if_vacant(value) + 0.0 })
    }

    /// The value of an expression as a number.
    #[inline]
    pub(super) fn number(&self, cx: &mut BlockContext, id: ExprId) -> BlockResult<f64> {
        Ok(zero_if_vacant(self.value(cx, id)?))
    }

    /// Checks that the right operand is non-vacant and valid for every left operand.
    pub(super) fn operand(&self, cx: &mut BlockContext, op: Op, right: ExprId) -> BlockResult<()> {
        let value = self.number(cx, right)?;
        if is_zero_divisor(cx, op, value) { Err(self.division_by_zero(cx, right)) } else { Ok(()) }
    }

    fn binary(&self, cx: &mut BlockContext, op: Op, left: ExprId, right: ExprId) -> BlockResult<f64> {
        let left = self.part(cx, left)?;
        let divisor = right;
        let right = self.part(cx, right)?;
        let (a, b) = (zero_if_vacant(left), zero_if_vacant(right));
        let tells = || left.is_nan() != right.is_nan() && !cx.shared.rules.vacant_equals_zero;
        match op {
            Op::Divide | Op::Modulo if is_zero_divisor(cx, op, b) => Err(self.division_by_zero(cx, divisor)),
            // Only EQ and NE distinguish vacant from 0.
            Op::Equal if tells() => truth(false),
            Op::NotEqual if tells() => truth(true),
            op => calculate(cx, op, a, b),
        }
    }

    /// The alarm, with a hint for each vacant or zero variable in the divisor.
    #[cold]
    fn division_by_zero(&self, cx: &mut BlockContext, divisor: ExprId) -> Trap {
        let mut trap = Trap::alarm(Alarm::DivisionByZero, msg!("interp.division-by-zero")).part(divisor);
        let mut open = vec![divisor];
        let mut named: Vec<u32> = Vec::new();
        while let Some(id) = open.pop() {
            let number = match cx.deck.expr(id) {
                Expr::Number(_) | Expr::Label(_) => None,
                Expr::Negate(x) | Expr::Call(_, x) => {
                    open.push(x);
                    None
                }
                Expr::Binary(_, left, right) => {
                    open.extend([right, left]);
                    None
                }
                Expr::Var(number) => Some(number),
                Expr::Indirect(x) => self.value(cx, x).ok().and_then(|x| variable_number(cx, x).ok()),
            };
            let Some(number) = number.filter(|number| !named.contains(number)) else { continue };
            named.push(number);
            let (name, value) = (cx.control.variable(number), self.read(cx, number));
            let guard = cx.control.guard(&name);
            match value {
                Ok(_) if cx.control.var(number).is_some_and(|row| row.kind == VarKind::Vacant) => {
                    trap = trap.hint(msg!("interp.hint-divisor-null", variable = name));
                }
                Ok(x) if x.is_nan() => trap = trap.hint(msg!("interp.hint-divisor-vacant", variable = name, guard)),
                Ok(0.0) => trap = trap.hint(msg!("interp.hint-divisor-zero", variable = name, guard)),
                _ => {}
            }
        }
        trap
    }
}

/// Variable number from a calculated value; vacant gives `#0`.
pub(super) fn variable_number(cx: &BlockContext, x: f64) -> BlockResult<u32> {
    let whole = zero_if_vacant(x).round();
    if (0.0..=4e9).contains(&whole) {
        Ok(whole as u32)
    } else {
        let name = format!("{}{}", cx.control.syntax.variable, number_text(x, 0));
        Err(Trap::alarm(Alarm::VariableRange, msg!("interp.no-such-variable", variable = name)))
    }
}

//! Expressions: vacant variables, degrees, and an alarm wherever a calculation has no result.

use super::error::{Run, Trap};
use super::rules::AsinRange;
use super::state::{BlockContext, State};
use crate::controls::syntax::Function;
use crate::controls::{Alarm, VarKind};
use crate::math;
use crate::msg;
use crate::nc::{Expr, ExprId, Op};
use crate::text::catalog::number_text;

/// A vacant operand of a calculation counts as 0.
#[inline]
pub(super) fn or_zero(x: f64) -> f64 {
    if x.is_nan() { 0.0 } else { x }
}

/// A value that misses a whole number by less than this is that number.
pub(super) const WHOLE: f64 = 1e-6;

/// A value as a number of 32 bits, for AND, OR and XOR.
fn bits(cx: &BlockContext, x: f64) -> Run<i32> {
    let whole = x.round();
    if cx.control.macros.whole_bits && (x - whole).abs() >= WHOLE {
        return Err(Trap::alarm(Alarm::NotWhole, msg!("interp.not-whole", (x, 9))));
    }
    if whole.abs() > 4_294_967_295.0 {
        return Err(Trap::alarm(Alarm::Calculation, msg!("interp.not-32-bits", x)));
    }
    // The upper half of the unsigned range wraps to negative numbers.
    Ok(whole as i64 as i32)
}

/// Decimal digits of a whole number as groups of four bits, or back.
fn regroup(x: f64, from: i64, to: i64) -> Run<f64> {
    let error = || Trap::alarm(Alarm::Calculation, msg!("interp.not-bcd", x));
    let mut rest = x.round() as i64;
    if rest < 0 || rest > 99_999_999 && from == 10 || rest > 0x9999_9999 {
        return Err(error());
    }
    let (mut result, mut place) = (0_i64, 1_i64);
    while rest > 0 {
        if rest % from > 9 {
            return Err(error());
        }
        result += rest % from * place;
        rest /= from;
        place *= to;
    }
    Ok(result as f64)
}

/// The value of a function.
pub(super) fn function(cx: &BlockContext, function: Function, x: f64) -> Run<f64> {
    let outside = |alarm: Alarm| {
        let name = cx.control.syntax.functions.iter().find(|row| row.1 == function).map_or("", |row| row.0);
        Err(Trap::alarm(alarm, msg!("interp.outside-domain", name, (x, 9))))
    };
    let result = match function {
        Function::Sin => math::sin_cos_degrees(x).0,
        Function::Cos => math::sin_cos_degrees(x).1,
        Function::Tan => match math::tan_degrees(x) {
            Some(tan) => tan,
            None => return outside(Alarm::Tangent),
        },
        Function::Asin | Function::Acos if x.abs() > 1.0 => return outside(Alarm::ArcFunction),
        Function::Asin => match (math::asin_degrees(x), cx.shared.rules.asin) {
            (angle, AsinRange::AroundHalfTurn) => 180.0 - angle,
            (angle, AsinRange::WithinTurn) if angle < 0.0 => angle + 360.0,
            (angle, _) => angle,
        },
        Function::Acos => math::acos_degrees(x),
        Function::Atan => math::atan2_degrees(x, 1.0),
        Function::Sqrt if x < 0.0 => return outside(Alarm::SquareRoot),
        Function::Sqrt => x.sqrt(),
        Function::Abs => x.abs(),
        Function::Bin => regroup(x, 16, 10)?,
        Function::Bcd => regroup(x, 10, 16)?,
        Function::Square => x * x,
        // Half away from zero, as Rust rounds.
        Function::Round => (x * cx.parts).round() / cx.parts,
        Function::Fix => x.trunc(),
        Function::Fup => x.abs().ceil().copysign(x),
        Function::Ln if x <= 0.0 => return outside(Alarm::Logarithm),
        Function::Ln => math::ln(x),
        Function::Exp => math::exp(x),
    };
    in_range(cx, result)
}

/// A result, if the control's numbers reach to it.
#[inline]
fn in_range(cx: &BlockContext, x: f64) -> Run<f64> {
    let (least, most) = cx.shared.rules.result;
    let size = x.abs();
    if size <= most && (size >= least || size == 0.0) {
        Ok(x)
    } else {
        Err(out_of_range(size >= least || size.is_nan()))
    }
}

#[cold]
fn out_of_range(large: bool) -> Trap {
    Trap::alarm(Alarm::Overflow, if large { msg!("interp.overflow") } else { msg!("interp.underflow") })
}

/// The value of an operator between two numbers. Comparisons give 1 or 0.
pub(super) fn operate(cx: &BlockContext, op: Op, a: f64, b: f64) -> Run<f64> {
    calculate(cx, op, a, b)
}

/// Whether nothing can be divided by a number: MOD rounds it before, but for controls with truths.
#[inline]
fn divides_not(cx: &BlockContext, op: Op, b: f64) -> bool {
    match op {
        Op::Divide => b == 0.0,
        Op::Modulo if cx.control.macros.truths => b == 0.0,
        Op::Modulo => b.round() == 0.0,
        _ => false,
    }
}

/// The same in the midst of a formula.
#[inline(always)]
fn calculate(cx: &BlockContext, op: Op, a: f64, b: f64) -> Run<f64> {
    match op {
        Op::Add => in_range(cx, a + b),
        Op::Subtract => in_range(cx, a - b),
        Op::Multiply => in_range(cx, a * b),
        Op::Divide | Op::Modulo if divides_not(cx, op, b) => {
            Err(Trap::alarm(Alarm::DivisionByZero, msg!("interp.division-by-zero")))
        }
        Op::Divide => in_range(cx, a / b),
        Op::Modulo if cx.control.macros.truths => in_range(cx, a % b),
        // Both are rounded before, as in Custom Macro B.
        Op::Modulo => in_range(cx, a.round() % b.round()),
        Op::Atan => {
            let angle = math::atan2_degrees(a, b);
            Ok(if cx.shared.rules.atan_turn && angle < 0.0 { angle + 360.0 } else { angle })
        }
        Op::And | Op::Or | Op::Xor if cx.control.macros.truths => truth(match op {
            Op::And => a != 0.0 && b != 0.0,
            Op::Or => a != 0.0 || b != 0.0,
            _ => (a != 0.0) != (b != 0.0),
        }),
        Op::And => Ok(f64::from(bits(cx, a)? & bits(cx, b)?)),
        Op::Or => Ok(f64::from(bits(cx, a)? | bits(cx, b)?)),
        Op::Xor => Ok(f64::from(bits(cx, a)? ^ bits(cx, b)?)),
        Op::Equal => truth(a == b || close(cx, a, b)),
        Op::NotEqual => truth(a != b && !close(cx, a, b)),
        Op::Greater => truth(a > b && !close(cx, a, b)),
        Op::GreaterEqual => truth(a >= b || close(cx, a, b)),
        Op::Less => truth(a < b && !close(cx, a, b)),
        Op::LessEqual => truth(a <= b || close(cx, a, b)),
    }
}

/// Whether two numbers count as equal although they differ.
#[inline]
fn close(cx: &BlockContext, a: f64, b: f64) -> bool {
    let part = cx.control.macros.equal_within;
    part > 0.0 && (a - b).abs() <= part * a.abs().max(b.abs())
}

#[inline]
fn truth(x: bool) -> Run<f64> {
    Ok(f64::from(u8::from(x)))
}

impl State {
    /// The value of an expression; vacant where it is nothing but a vacant variable. An alarm is about the part that has no value.
    pub(super) fn value(&self, cx: &mut BlockContext, id: ExprId) -> Run<f64> {
        match self.part(cx, id) {
            Err(trap @ Trap::Alarm(_)) => Err(self.blame(cx, id, trap)),
            value => value,
        }
    }

    /// The value of a part of an expression.
    ///
    /// It goes as deep as the formula does; the parser takes formulas of a few hundred parts at most.
    fn part(&self, cx: &mut BlockContext, id: ExprId) -> Run<f64> {
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
                // A vacant variable with a sign stays vacant: `X-#1` is dropped as `X#1` is.
                Ok(-self.part(cx, x)?)
            }
            Expr::Call(name, x) => {
                let x = self.part(cx, x)?;
                function(cx, name, or_zero(x))
            }
        }
    }

    /// Finds the smallest part without a value: what it is made of has one.
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

    /// What an assignment stores: vacant only from a variable alone, never `-0`.
    pub(super) fn assigned(&self, cx: &mut BlockContext, id: ExprId) -> Run<f64> {
        let alone = matches!(cx.deck.expr(id), Expr::Var(_) | Expr::Indirect(_));
        let value = self.value(cx, id)?;
        // Adding 0 makes -0 to 0 and leaves everything else as it is.
        Ok(if alone { value + 0.0 } else { or_zero(value) + 0.0 })
    }

    /// The value of an expression as a number.
    #[inline]
    pub(super) fn number(&self, cx: &mut BlockContext, id: ExprId) -> Run<f64> {
        Ok(or_zero(self.value(cx, id)?))
    }

    /// What stands right of an operator has a value, and one that the operator takes whatever stands left of it.
    pub(super) fn operand(&self, cx: &mut BlockContext, op: Op, right: ExprId) -> Run<()> {
        let value = self.number(cx, right)?;
        if divides_not(cx, op, value) { Err(self.division_by_zero(cx, right)) } else { Ok(()) }
    }

    fn binary(&self, cx: &mut BlockContext, op: Op, left: ExprId, right: ExprId) -> Run<f64> {
        let left = self.part(cx, left)?;
        let divisor = right;
        let right = self.part(cx, right)?;
        let (a, b) = (or_zero(left), or_zero(right));
        let tells = || left.is_nan() != right.is_nan() && !cx.shared.rules.vacant_equals_zero;
        match op {
            Op::Divide | Op::Modulo if divides_not(cx, op, b) => Err(self.division_by_zero(cx, divisor)),
            // EQ and NE alone tell vacant from 0.
            Op::Equal if tells() => truth(false),
            Op::NotEqual if tells() => truth(true),
            op => calculate(cx, op, a, b),
        }
    }

    /// The alarm, with the variables that make the divisor 0.
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
                    trap = trap.hint(msg!("interp.hint-divisor-null", name));
                }
                Ok(x) if x.is_nan() => trap = trap.hint(msg!("interp.hint-divisor-vacant", name, guard)),
                Ok(0.0) => trap = trap.hint(msg!("interp.hint-divisor-zero", name, guard)),
                _ => {}
            }
        }
        trap
    }
}

/// The variable that a calculated number names; vacant names `#0`.
pub(super) fn variable_number(cx: &BlockContext, x: f64) -> Run<u32> {
    let whole = or_zero(x).round();
    if (0.0..=4e9).contains(&whole) {
        Ok(whole as u32)
    } else {
        let name = format!("{}{}", cx.control.syntax.variable, number_text(x, 0));
        Err(Trap::alarm(Alarm::VariableRange, msg!("interp.no-such-variable", name)))
    }
}

//! Expressions: vacant variables, degrees, and an alarm wherever a calculation has no result.

use super::fault::{Run, Trap};
use super::state::{Cx, State};
use crate::controls::Alarm;
use crate::controls::syntax::Function;
use crate::math;
use crate::msg;
use crate::nc::{Expr, ExprId, Op};

/// A vacant operand of a calculation counts as 0.
#[inline]
fn or_zero(x: f64) -> f64 {
    if x.is_nan() { 0.0 } else { x }
}

/// A value as a number of 32 bits, for AND, OR and XOR.
fn bits(x: f64) -> Run<i32> {
    let whole = x.round();
    if whole.abs() > 4_294_967_295.0 {
        return Err(Trap::alarm(Alarm::Calculation, msg!("interp.not-32-bits", x)));
    }
    // The upper half of the unsigned range wraps to negative numbers.
    Ok(whole as i64 as i32)
}

/// `x` in degrees within one turn, and whether sine or cosine of it are exactly 0 or ±1: (sine, cosine).
fn sin_cos_degrees(x: f64) -> (f64, f64) {
    let turn = x % 360.0;
    match turn {
        0.0 => (0.0, 1.0),
        90.0 | -270.0 => (1.0, 0.0),
        180.0 | -180.0 => (0.0, -1.0),
        270.0 | -90.0 => (-1.0, 0.0),
        _ => math::sin_cos(turn * (math::PI / 180.0)),
    }
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

fn call(cx: &Cx, function: Function, x: f64) -> Run<f64> {
    let degrees = 180.0 / math::PI;
    let outside = || {
        let name = cx.control.syntax.functions.iter().find(|row| row.1 == function).map_or("", |row| row.0);
        Trap::alarm(Alarm::Calculation, msg!("interp.outside-domain", name, (x, 9)))
    };
    let result = match function {
        Function::Sin => sin_cos_degrees(x).0,
        Function::Cos => sin_cos_degrees(x).1,
        Function::Tan => {
            let (sin, cos) = sin_cos_degrees(x);
            if cos == 0.0 {
                return Err(outside());
            }
            sin / cos
        }
        Function::Asin | Function::Acos if x.abs() > 1.0 => return Err(outside()),
        Function::Asin => math::asin(x) * degrees,
        Function::Acos => math::acos(x) * degrees,
        Function::Atan => math::atan(x) * degrees,
        Function::Sqrt if x < 0.0 => return Err(outside()),
        Function::Sqrt => x.sqrt(),
        Function::Abs => x.abs(),
        Function::Bin => regroup(x, 16, 10)?,
        Function::Bcd => regroup(x, 10, 16)?,
        // Half away from zero, as Rust rounds.
        Function::Round => x.round(),
        Function::Fix => x.trunc(),
        Function::Fup => x.abs().ceil().copysign(x),
        Function::Ln if x <= 0.0 => return Err(outside()),
        Function::Ln => math::ln(x),
        Function::Exp => math::exp(x),
    };
    finite(result)
}

#[inline]
fn finite(x: f64) -> Run<f64> {
    if x.is_finite() { Ok(x) } else { Err(Trap::alarm(Alarm::Calculation, msg!("interp.overflow"))) }
}

#[inline]
fn truth(x: bool) -> Run<f64> {
    Ok(f64::from(u8::from(x)))
}

impl State {
    /// The value of an expression; vacant where it is nothing but a vacant variable.
    ///
    /// It goes as deep as the formula does; the parser takes formulas of a few hundred parts at most.
    pub(super) fn value(&self, cx: &mut Cx, id: ExprId) -> Run<f64> {
        match cx.deck.expr(id) {
            Expr::Number(dec) => Ok(dec.to_f64()),
            Expr::Var(number) => self.read(cx, number),
            Expr::Binary(op, left, right) => self.binary(cx, op, left, right),
            Expr::Indirect(number) => {
                let number = self.value(cx, number)?;
                self.read(cx, variable_number(number)?)
            }
            Expr::Negate(x) => {
                // A vacant variable with a sign stays vacant: `X-#1` is dropped as `X#1` is.
                Ok(-self.value(cx, x)?)
            }
            Expr::Call(function, x) => {
                let x = self.value(cx, x)?;
                call(cx, function, or_zero(x))
            }
        }
    }

    /// What an assignment stores: vacant only from a variable alone, never `-0`.
    pub(super) fn assigned(&self, cx: &mut Cx, id: ExprId) -> Run<f64> {
        let alone = matches!(cx.deck.expr(id), Expr::Var(_) | Expr::Indirect(_));
        let value = self.value(cx, id)?;
        // Adding 0 makes -0 to 0 and leaves everything else as it is.
        Ok(if alone { value + 0.0 } else { or_zero(value) + 0.0 })
    }

    /// The value of an expression as a number.
    #[inline]
    pub(super) fn number(&self, cx: &mut Cx, id: ExprId) -> Run<f64> {
        Ok(or_zero(self.value(cx, id)?))
    }

    fn binary(&self, cx: &mut Cx, op: Op, left: ExprId, right: ExprId) -> Run<f64> {
        let left = self.value(cx, left)?;
        let divisor = right;
        let right = self.value(cx, right)?;
        // EQ and NE alone tell vacant from 0.
        match op {
            Op::Equal | Op::NotEqual => {
                let equal =
                    if left.is_nan() || right.is_nan() { left.is_nan() && right.is_nan() } else { left == right };
                return truth(equal == (op == Op::Equal));
            }
            _ => {}
        }
        let (a, b) = (or_zero(left), or_zero(right));
        match op {
            Op::Add => finite(a + b),
            Op::Subtract => finite(a - b),
            Op::Multiply => finite(a * b),
            Op::Divide if b != 0.0 => finite(a / b),
            Op::Modulo if b != 0.0 => finite(a % b),
            Op::Divide | Op::Modulo => Err(self.division_by_zero(cx, divisor)),
            Op::Atan => Ok(math::atan2(a, b) * (180.0 / math::PI)),
            Op::And => Ok(f64::from(bits(a)? & bits(b)?)),
            Op::Or => Ok(f64::from(bits(a)? | bits(b)?)),
            Op::Xor => Ok(f64::from(bits(a)? ^ bits(b)?)),
            Op::Greater => truth(a > b),
            Op::GreaterEqual => truth(a >= b),
            Op::Less => truth(a < b),
            Op::LessEqual | Op::Equal | Op::NotEqual => truth(a <= b),
        }
    }

    /// The alarm, with the variables that make the divisor 0.
    #[cold]
    fn division_by_zero(&self, cx: &mut Cx, divisor: ExprId) -> Trap {
        let mut trap = Trap::alarm(Alarm::DivisionByZero, msg!("interp.division-by-zero"));
        let mut open = vec![divisor];
        let mut named: Vec<u32> = Vec::new();
        while let Some(id) = open.pop() {
            let number = match cx.deck.expr(id) {
                Expr::Number(_) => None,
                Expr::Negate(x) | Expr::Call(_, x) => {
                    open.push(x);
                    None
                }
                Expr::Binary(_, left, right) => {
                    open.extend([right, left]);
                    None
                }
                Expr::Var(number) => Some(number),
                Expr::Indirect(x) => self.value(cx, x).ok().and_then(|x| variable_number(x).ok()),
            };
            let Some(number) = number.filter(|number| !named.contains(number)) else { continue };
            named.push(number);
            match self.read(cx, number) {
                Ok(x) if x.is_nan() => trap = trap.hint(msg!("interp.hint-divisor-vacant", number)),
                Ok(0.0) => trap = trap.hint(msg!("interp.hint-divisor-zero", number)),
                _ => {}
            }
        }
        trap
    }
}

/// The variable that a calculated number names; vacant names `#0`.
pub(super) fn variable_number(x: f64) -> Run<u32> {
    let whole = or_zero(x).round();
    if (0.0..=4e9).contains(&whole) {
        Ok(whole as u32)
    } else {
        Err(Trap::alarm(Alarm::VariableRange, msg!("interp.no-such-variable", (x, 0))))
    }
}

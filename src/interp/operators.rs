//! Operators and functions of formulas: angles in degrees, 32-bit logic, and an alarm for each calculation without a result.

use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use crate::controls::Alarm;
use crate::controls::dialect::AsinRange;
use crate::controls::syntax::Function;
use crate::math;
use crate::msg;
use crate::nc::Op;

/// Value as an operand: vacant counts as 0.
#[inline]
pub(super) fn zero_if_vacant(x: f64) -> f64 {
    if x.is_nan() { 0.0 } else { x }
}

/// Tolerance for whole numbers: a value closer to one counts as that number.
pub(super) const WHOLE: f64 = 1e-6;

/// A value as a 32-bit number, for AND, OR and XOR.
fn bits(cx: &BlockContext, x: f64) -> BlockResult<i32> {
    let whole = x.round();
    if cx.control.macros.whole_bits && (x - whole).abs() >= WHOLE {
        return Err(Trap::alarm(Alarm::NotWhole, msg!("interp.not-whole", value = (x, 9))));
    }
    if whole.abs() > 4_294_967_295.0 {
        return Err(Trap::alarm(Alarm::Calculation, msg!("interp.not-32-bits", value = x)));
    }
    // The upper half of the unsigned range wraps to negative numbers.
    Ok(whole as i64 as i32)
}

/// Converts decimal digits to groups of four bits (BCD), or back.
fn regroup(x: f64, from: i64, to: i64) -> BlockResult<f64> {
    let error = || Trap::alarm(Alarm::Calculation, msg!("interp.not-bcd", value = x));
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
pub(super) fn function(cx: &BlockContext, function: Function, x: f64) -> BlockResult<f64> {
    let outside = |alarm: Alarm| {
        let name = cx.control.syntax.functions.iter().find(|row| row.1 == function).map_or("", |row| row.0);
        Err(Trap::alarm(alarm, msg!("interp.outside-domain", function = name, value = (x, 9))))
    };
    let result = match function {
        Function::Sin => math::sin_cos_degrees(x).0,
        Function::Cos => math::sin_cos_degrees(x).1,
        Function::Tan => match math::tan_degrees(x) {
            Some(tan) => tan,
            None => return outside(Alarm::Tangent),
        },
        Function::Asin | Function::Acos if x.abs() > 1.0 => return outside(Alarm::ArcFunction),
        Function::Asin => match (math::asin_degrees(x), cx.shared.rules.numbers.asin) {
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
        // Half away from zero, like Rust's `round`.
        Function::Round => (x * cx.parts).round() / cx.parts,
        Function::Fix => x.trunc(),
        Function::Fup => x.abs().ceil().copysign(x),
        Function::Ln if x <= 0.0 => return outside(Alarm::Logarithm),
        Function::Ln => math::ln(x),
        Function::Exp => math::exp(x),
        // POW is parsed as a binary operator; ADP is evaluated together with its argument.
        Function::Power | Function::AddPoint => x,
    };
    in_range(cx, result)
}

/// A result within the control's range of numbers.
#[inline]
fn in_range(cx: &BlockContext, x: f64) -> BlockResult<f64> {
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

/// Result of an operator between two numbers, outside the hot path of formulas. Comparisons give 1 or 0.
pub(super) fn operate(cx: &BlockContext, op: Op, a: f64, b: f64) -> BlockResult<f64> {
    calculate(cx, op, a, b)
}

/// Whether a divisor is 0. MOD rounds it first, except on controls with logical AND, OR and XOR.
#[inline]
pub(super) fn is_zero_divisor(cx: &BlockContext, op: Op, b: f64) -> bool {
    match op {
        Op::Divide => b == 0.0,
        Op::Modulo if cx.control.macros.truths => b == 0.0,
        Op::Modulo => b.round() == 0.0,
        _ => false,
    }
}

/// Result of an operator between two numbers, inlined into the evaluation of formulas.
#[inline(always)]
pub(super) fn calculate(cx: &BlockContext, op: Op, a: f64, b: f64) -> BlockResult<f64> {
    match op {
        Op::Add => in_range(cx, a + b),
        Op::Subtract => in_range(cx, a - b),
        Op::Multiply => in_range(cx, a * b),
        Op::Divide | Op::Modulo if is_zero_divisor(cx, op, b) => {
            Err(Trap::alarm(Alarm::DivisionByZero, msg!("interp.division-by-zero")))
        }
        Op::Divide => in_range(cx, a / b),
        Op::Modulo if cx.control.macros.truths => in_range(cx, a % b),
        // Both operands are rounded first, as in Custom Macro B.
        Op::Modulo => in_range(cx, a.round() % b.round()),
        Op::Atan => {
            let angle = math::atan2_degrees(a, b);
            Ok(if cx.shared.rules.numbers.atan_turn && angle < 0.0 { angle + 360.0 } else { angle })
        }
        Op::Power if a < 0.0 && b != b.trunc() || a == 0.0 && b < 0.0 => {
            Err(Trap::alarm(Alarm::Calculation, msg!("interp.no-power", base = (a, 9), exponent = (b, 9))))
        }
        Op::Power => in_range(cx, math::pow(a, b)),
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

/// Whether two different numbers count as equal.
#[inline]
fn close(cx: &BlockContext, a: f64, b: f64) -> bool {
    let part = cx.control.macros.equal_within;
    part > 0.0 && (a - b).abs() <= part * a.abs().max(b.abs())
}

#[inline]
pub(super) fn truth(x: bool) -> BlockResult<f64> {
    Ok(f64::from(u8::from(x)))
}

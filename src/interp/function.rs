//! `G65 Hnn P Q R`: calculations and jumps by function number.

use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::operators::{function, operate, zero_if_vacant};
use super::state::RunState;
use super::system_variables::user_alarm;
use crate::controls::Address;
use crate::controls::Alarm;
use crate::controls::syntax::{Function, Operation};
use crate::msg;
use crate::nc::{Block, Op, Word, WordValue};

impl RunState {
    /// Whether a G65 is a function: H comes before P, on a control with functions.
    pub(super) fn is_function(&self, cx: &BlockContext, words: &[Word]) -> bool {
        let first = words.iter().find(|word| matches!(word.letter, Address::H | Address::P));
        !cx.control.macros.functions.is_empty() && first.is_some_and(|word| word.letter == Address::H)
    }

    /// Executes a `G65 H` function.
    pub(super) fn function_words(
        &mut self,
        cx: &mut BlockContext,
        at: u32,
        block: &Block,
        words: &[Word],
    ) -> BlockResult<()> {
        let word = |letter: Address| words.iter().rfind(|word| word.letter == letter);
        let number = match word(Address::H) {
            Some(word) => self.whole(cx, block, word)?.unwrap_or(0.0),
            None => 0.0,
        };
        let row = cx.control.macros.functions.iter().find(|row| f64::from(row.0) == number);
        let Some(&(_, operation)) = row else {
            return Err(Trap::alarm(Alarm::CallFunction, msg!("interp.no-function", number = (number, 0)))
                .at_word(&[Address::H]));
        };
        let missing = |letter: &str| {
            Trap::alarm(Alarm::CallOperands, msg!("interp.no-operand", address = letter, number = (number, 0)))
        };
        // Constants count as written.
        let mut operand = |letter: Address, needed: bool| match word(letter) {
            Some(Word { value: WordValue::Number(dec), .. }) => Ok(dec.to_f64()),
            Some(Word { value: WordValue::Expr(id), .. }) => self.value(cx, *id),
            None if needed => Err(missing(&letter.to_string())),
            None => Ok(0.0),
        };
        let needed = operation.operands();
        let (q, r) =
            (operand(Address::Q, needed.contains(&Address::Q))?, operand(Address::R, needed.contains(&Address::R))?);
        let vacant_or = |x: f64| if operation == Operation::Assign { x } else { zero_if_vacant(x) };
        let (q, r) = (vacant_or(q), zero_if_vacant(r));
        let jump = match operation {
            Operation::Goto => Some(true),
            Operation::IfEqual => Some(q == r),
            Operation::IfNotEqual => Some(q != r),
            Operation::IfGreater => Some(q > r),
            Operation::IfLess => Some(q < r),
            Operation::IfGreaterEqual => Some(q >= r),
            Operation::IfLessEqual => Some(q <= r),
            _ => None,
        };
        if jump.is_none() && operation != Operation::Alarm {
            let Some(Word { value: WordValue::Expr(id), .. }) = word(Address::P) else {
                return Err(Trap::alarm(Alarm::CallOperands, msg!("interp.function-result")).at_word(&[Address::P]));
            };
            let target = self.variable_of(cx, *id)?;
            // Adding 0 turns -0 into 0.
            let operand: &'static [Address] = if needed.contains(&Address::R) { &[Address::R] } else { &[Address::Q] };
            let value = self.calculate(cx, operation, (q, r), target).map_err(|trap| trap.at_word(operand))? + 0.0;
            return self.write(cx, block, target, value).map_err(|trap| trap.part(*id));
        }
        let p = zero_if_vacant(operand(Address::P, true)?);
        match jump {
            Some(true) => self.go_to_number(cx, at, p, Alarm::NoSequence).map_err(|trap| trap.at_word(&[Address::P])),
            Some(false) => Ok(()),
            None => Err(user_alarm(cx, block, p.round()).at_word(&[Address::P])),
        }
    }

    fn calculate(
        &self,
        cx: &mut BlockContext,
        operation: Operation,
        (q, r): (f64, f64),
        target: u32,
    ) -> BlockResult<f64> {
        use Operation::*;
        match operation {
            Add => operate(cx, Op::Add, q, r),
            Subtract => operate(cx, Op::Subtract, q, r),
            Multiply => operate(cx, Op::Multiply, q, r),
            Divide => operate(cx, Op::Divide, q, r),
            Or => operate(cx, Op::Or, q, r),
            And => operate(cx, Op::And, q, r),
            Xor => operate(cx, Op::Xor, q, r),
            Atan => operate(cx, Op::Atan, q, r),
            Sqrt => function(cx, Function::Sqrt, q),
            Abs => function(cx, Function::Abs, q),
            Bin => function(cx, Function::Bin, q),
            Bcd => function(cx, Function::Bcd, q),
            Remainder => {
                let whole = operate(cx, Op::Divide, q, r)?.trunc();
                operate(cx, Op::Subtract, q, whole * r)
            }
            MultiplyDivide => {
                let present = zero_if_vacant(self.read(cx, target)?);
                let product = operate(cx, Op::Multiply, present, q)?;
                operate(cx, Op::Divide, product, r)
            }
            Hypotenuse => {
                let square = operate(cx, Op::Add, q * q, r * r)?;
                function(cx, Function::Sqrt, square)
            }
            Sin => operate(cx, Op::Multiply, q, function(cx, Function::Sin, r)?),
            Cos => operate(cx, Op::Multiply, q, function(cx, Function::Cos, r)?),
            Tan => operate(cx, Op::Multiply, q, function(cx, Function::Tan, r)?),
            _ => Ok(q),
        }
    }
}

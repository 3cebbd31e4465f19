//! The `G65 H` functions of the 980TDc, in the order of their numbers.

use crate::controls::syntax::Operation::{self, *};

/// Number and operation of each function.
pub(super) const FUNCTIONS: &[(u8, Operation)] = &[
    (1, Assign),
    (2, Add),
    (3, Subtract),
    (4, Multiply),
    (5, Divide),
    (11, Or),
    (12, And),
    (13, Xor),
    (21, Sqrt),
    (22, Abs),
    (23, Remainder),
    (24, Bin),
    (25, Bcd),
    (26, MultiplyDivide),
    (27, Hypotenuse),
    (31, Sin),
    (32, Cos),
    (33, Tan),
    (34, Atan),
    (80, Goto),
    (81, IfEqual),
    (82, IfNotEqual),
    (83, IfGreater),
    (84, IfLess),
    (85, IfGreaterEqual),
    (86, IfLessEqual),
    (99, Alarm),
];

//! Spelling and binding levels of operators.

use crate::nc::ast::Op;

/// Level and spelling of an operator; a higher level binds more tightly.
pub(super) fn operator(op: Op) -> (u8, &'static str) {
    match op {
        Op::Add => (1, "+"),
        Op::Subtract => (1, "-"),
        Op::Or => (1, " OR "),
        Op::Xor => (1, " XOR "),
        Op::Multiply => (2, "*"),
        Op::Divide | Op::Atan | Op::Power => (2, "/"),
        Op::And => (2, " AND "),
        Op::Modulo => (2, " MOD "),
        Op::Equal => (0, " EQ "),
        Op::NotEqual => (0, " NE "),
        Op::Greater => (0, " GT "),
        Op::GreaterEqual => (0, " GE "),
        Op::Less => (0, " LT "),
        Op::LessEqual => (0, " LE "),
    }
}

/// Level and spelling of an operator in a language with names.
pub(super) fn symbolic_operator(op: Op) -> (u8, &'static str) {
    match op {
        Op::Equal => (0, "=="),
        Op::NotEqual => (0, "<>"),
        Op::Greater => (0, ">"),
        Op::GreaterEqual => (0, ">="),
        Op::Less => (0, "<"),
        Op::LessEqual => (0, "<="),
        Op::Or => (1, " OR "),
        Op::Xor => (2, " XOR "),
        Op::And => (3, " AND "),
        Op::Add => (4, "+"),
        Op::Subtract => (4, "-"),
        Op::Multiply => (5, "*"),
        Op::Divide | Op::Atan | Op::Power => (5, "/"),
        Op::Modulo => (5, " MOD "),
    }
}

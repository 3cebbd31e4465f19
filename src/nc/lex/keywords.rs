//! Words and signs of macro statements: comparisons, keywords, external statements.

use crate::nc::ast::Op;

/// Comparisons as words.
pub(in crate::nc) const COMPARISONS: [(&str, Op); 6] = [
    ("EQ", Op::Equal),
    ("NE", Op::NotEqual),
    ("GT", Op::Greater),
    ("GE", Op::GreaterEqual),
    ("LT", Op::Less),
    ("LE", Op::LessEqual),
];

/// Comparisons as signs, longer ones first, and whether controls with comparison signs have this one.
pub(in crate::nc) const SIGNS: [(&str, Op, bool); 13] = [
    ("==", Op::Equal, true),
    ("<>", Op::NotEqual, true),
    (">=", Op::GreaterEqual, true),
    ("<=", Op::LessEqual, true),
    ("!=", Op::NotEqual, false),
    ("=>", Op::GreaterEqual, false),
    ("=<", Op::LessEqual, false),
    (">", Op::Greater, true),
    ("<", Op::Less, true),
    ("=", Op::Equal, false),
    ("≠", Op::NotEqual, false),
    ("≥", Op::GreaterEqual, false),
    ("≤", Op::LessEqual, false),
];

/// Keywords that start a macro statement.
pub(in crate::nc) const KEYWORDS: [&str; 5] = ["IF", "GOTO", "WHILE", "DO", "END"];

/// Statements of the control that the simulation ignores.
pub const IGNORED_STATEMENTS: [&str; 5] = ["POPEN", "PCLOS", "DPRNT", "SETVN", "BPRNT"];

/// The spelling of a comparison.
pub(in crate::nc) fn letters_of(op: Op) -> &'static str {
    COMPARISONS.iter().find(|(_, other)| *other == op).map_or("", |(word, _)| word)
}

/// Operators that are words.
pub(in crate::nc) const OPERATORS: [(&str, Op); 4] =
    [("AND", Op::And), ("MOD", Op::Modulo), ("OR", Op::Or), ("XOR", Op::Xor)];

/// In a language with names: logic operators, from the weakest to the strongest binding.
pub(in crate::nc) const LOGIC: [(&str, Op); 3] = [("OR", Op::Or), ("XOR", Op::Xor), ("AND", Op::And)];

/// In a language with names: words that start a statement.
pub(in crate::nc) const SYMBOLIC_STATEMENTS: [&str; 4] = ["IF", "GOTOF", "GOTOB", "MSG"];

/// In a language with names: statements of the macro languages of other controls.
pub(in crate::nc) const FOREIGN_STATEMENTS: [&str; 5] = ["GOTO", "WHILE", "DO", "END", "THEN"];

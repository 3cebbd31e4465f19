//! How a control's macro language counts and calls: what differs between dialects of one family, as rows.

use super::address::Address;
use super::code::CodeId;
use super::syntax::Operation;
use crate::text::Citation;

/// What a word does whose value is nothing but a vacant variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum VacantWord {
    /// The word counts as not written.
    Dropped,
    /// Its value is 0.
    Zero,
}

/// How I, J, K of argument specification II find their variables.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArgumentSets {
    /// A letter that does not follow its predecessor in the alphabet begins the next set: `K1 I2` are #6 and #7.
    InOrder,
    /// Each letter counts its own sets: `K1 I2` are #6 and #4.
    PerLetter,
}

/// How a code calls its program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CallKind {
    /// As a subprogram, without arguments.
    Sub,
    /// As a macro, with arguments.
    Macro,
    /// As a macro after each block with axis motion from now on.
    Modal,
    /// As a macro at each block from now on.
    ModalBlock,
}

/// What a parameter of the control binds a code to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CodeCalls {
    /// `count` parameters from `first` on hold one code each; the k-th calls program `program + k`.
    Each {
        /// How the codes call.
        kind: CallKind,
        /// `G` or `M`.
        letter: Address,
        /// Number of the first parameter.
        first: u32,
        /// How many there are.
        count: u32,
        /// Program of the first.
        program: u32,
    },
    /// Codes that follow one another call programs that follow one another: how many, the first code, the first program.
    Range {
        /// How the codes call.
        kind: CallKind,
        /// `G` or `M`.
        letter: Address,
        /// Number of the parameter that holds how many.
        count: u32,
        /// Number of the parameter that holds the first code.
        code: u32,
        /// Number of the parameter that holds the first program.
        program: u32,
    },
    /// Pairs of parameters hold a code and its program; the k-th pair `step` numbers behind the first.
    Pairs {
        /// `G` or `M`.
        letter: Address,
        /// Number of the first parameter that holds a code.
        code: u32,
        /// Number of the first parameter that holds how the code calls: 0 subprogram, 1 macro, 2 modal, 3 modal at each block.
        kind: u32,
        /// Number of the first parameter that holds a program.
        program: u32,
        /// From pair to pair.
        step: u32,
        /// How many pairs there are.
        count: u32,
    },
}

/// The dialect of macro programs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Macros {
    /// A word of a vacant variable alone.
    pub vacant_word: VacantWord,
    /// EQ and NE take vacant for 0, as the other comparisons do.
    pub vacant_equals_zero: bool,
    /// Numbers that differ by no more than this part of the larger one count as equal in comparisons.
    pub equal_within: f64,
    /// AND, OR, XOR tell whether conditions hold; else they work bit by bit.
    pub truths: bool,
    /// AND, OR, XOR of numbers that are not whole are an alarm; else they are rounded.
    pub whole_bits: bool,
    /// Least and largest magnitude of a result other than 0; `None` where only infinity is too large.
    pub value_range: Option<(f64, f64)>,
    /// The calculated value of an address of whole numbers is rounded; else what stands behind its point is dropped.
    pub round_words: bool,
    /// I, J, K of argument specification II.
    pub argument_sets: ArgumentSets,
    /// `M98 P` with more than four digits holds the repeats in front of the program number.
    pub repeats_in_p: bool,
    /// The end of a subprogram ends a main program; else that starts again.
    pub main_ends: bool,
    /// The end of a program returns from a subprogram.
    pub ends_return: bool,
    /// `M98 H` starts at a sequence number of the subprogram.
    pub sub_sequence: bool,
    /// Nothing but a sequence number may stand in front of a macro call.
    pub call_first: bool,
    /// P or H stands directly behind the code of a macro call.
    pub program_next: bool,
    /// A one-shot macro call ends a modal one.
    pub call_ends_modal: bool,
    /// A return to the reference point is a motion that a modal macro call follows.
    pub call_after_return: bool,
    /// The control keeps common variables at power-off, where its parameters are set so.
    pub common_kept: bool,
    /// `G65 Hnn P Q R` as functions: number and what it does. Empty where the control lacks them.
    pub functions: &'static [(u8, Operation)],
    /// Codes that call macros, by parameter. The settings are the text of the switch `call-parameters`.
    pub code_calls: &'static [CodeCalls],
    /// A code that calls a macro comes before the control's own of the same number; else it is not bound.
    pub calls_override: bool,
    /// Number of a user alarm, first and last.
    pub user_alarms: (u32, u32),
    /// What is added to the number of a user alarm to give the number that is shown; `None` where one number is shown for all.
    pub user_alarm_base: Option<u32>,
    /// Letters in front of the number of a user alarm: `MC` makes 3005 `MC3005`.
    pub user_alarm_prefix: &'static str,
    /// Source and grade.
    pub cite: Citation,
}

/// Local variable of an address in argument specification I, by letter from A; 0 where an address is no argument. G, L, N, O and P
/// are arguments of G66.1 only.
pub const ARGUMENT: [u8; 26] =
    [1, 2, 3, 7, 8, 9, 10, 11, 4, 5, 6, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26];

/// A code that calls a macro.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CodeCall {
    /// The code.
    pub code: CodeId,
    /// How it calls.
    pub kind: CallKind,
    /// The program that it calls.
    pub program: u32,
}

/// Largest number of codes that one row can bind, whatever its parameters say.
const CALLS: u32 = 100;

impl Macros {
    /// Whether a parameter is one of calls by code.
    pub fn has_parameter(&self, number: u32) -> bool {
        let within = |first: u32, step: u32, count: u32| {
            let behind = number.wrapping_sub(first);
            behind.is_multiple_of(step.max(1)) && behind / step.max(1) < count
        };
        self.code_calls.iter().any(|row| match *row {
            CodeCalls::Each { first, count, .. } => within(first, 1, count),
            CodeCalls::Range { count, code, program, .. } => [count, code, program].contains(&number),
            CodeCalls::Pairs { code, kind, program, step, count, .. } => {
                [code, kind, program].into_iter().any(|first| within(first, step, count))
            }
        })
    }

    /// The codes that call macros under these parameters (number and value); of two settings of a parameter the later one holds.
    pub fn calls(&self, set: &[(u32, u32)]) -> Vec<CodeCall> {
        let value = |parameter: u32| set.iter().rev().find(|(number, _)| *number == parameter).map(|(_, value)| *value);
        let mut calls = Vec::new();
        let mut bind = |letter: Address, code: Option<u32>, kind: CallKind, program: Option<u32>| {
            // A code 0 is a parameter that is not set.
            if let (Some(code @ 1..), Some(program @ 1..)) = (code, program) {
                let code = if letter == Address::M { CodeId::M(code) } else { CodeId::g(code) };
                calls.push(CodeCall { code, kind, program });
            }
        };
        for row in self.code_calls {
            match *row {
                CodeCalls::Each { kind, letter, first, count, program } => {
                    (0..count.min(CALLS)).for_each(|k| bind(letter, value(first + k), kind, Some(program + k)));
                }
                CodeCalls::Range { kind, letter, count, code, program } => {
                    let count = value(count).unwrap_or(0).min(CALLS);
                    let from = |parameter: u32, k: u32| value(parameter).map(|first| first.saturating_add(k));
                    (0..count).for_each(|k| bind(letter, from(code, k), kind, from(program, k)));
                }
                CodeCalls::Pairs { letter, code, kind, program, step, count } => {
                    for k in (0..count.min(CALLS)).map(|k| step * k) {
                        let kind = match value(kind + k) {
                            None | Some(0) => CallKind::Sub,
                            Some(1) => CallKind::Macro,
                            Some(2) => CallKind::Modal,
                            Some(_) => CallKind::ModalBlock,
                        };
                        bind(letter, value(code + k), kind, value(program + k));
                    }
                }
            }
        }
        calls
    }
}

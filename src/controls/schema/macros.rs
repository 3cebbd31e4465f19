//! Values, calls and arguments of a control's macro language: the differences between dialects of one family, as rows.

use super::address::Address;
use super::code::CodeId;
use super::syntax::Operation;
use crate::text::Citation;

/// Effect of a word whose value is only a vacant variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum VacantWord {
    /// The word is ignored.
    Dropped,
    /// The word has the value 0.
    Zero,
}

/// Assignment of I, J, K to variables in argument specification II.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArgumentSets {
    /// A letter that does not come later in the alphabet than its predecessor begins the next set: `K1 I2` sets #6 and #7.
    InOrder,
    /// Each letter counts its own sets: `K1 I2` sets #6 and #4.
    PerLetter,
}

/// Kind of program call by a code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CallKind {
    /// Subprogram call, without arguments.
    Sub,
    /// Macro call, with arguments.
    Macro,
    /// Modal macro call, after each block with axis motion.
    Modal,
    /// Modal macro call at each block.
    ModalBlock,
}

/// Parameter layout that binds codes to programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CodeCalls {
    /// `count` parameters from `first` on hold one code each; the k-th calls program `program + k`.
    Each {
        /// Kind of call.
        kind: CallKind,
        /// Kind of call of a code given with a minus sign; none where the control does not take one.
        negative: Option<CallKind>,
        /// `G` or `M`.
        letter: Address,
        /// Number of the first parameter.
        first: u32,
        /// Number of parameters.
        count: u32,
        /// Program called by the code of the first parameter.
        program: u32,
    },
    /// Consecutive codes call consecutive programs. Three parameters hold the number of codes, the first code and the first program.
    Range {
        /// Kind of call.
        kind: CallKind,
        /// `G` or `M`.
        letter: Address,
        /// Number of the parameter that holds the number of codes.
        count: u32,
        /// Number of the parameter that holds the first code.
        code: u32,
        /// Number of the parameter that holds the first program.
        program: u32,
    },
    /// Pairs of parameters hold a code and its program. Parameter numbers rise by `step` from pair to pair.
    Pairs {
        /// `G` or `M`.
        letter: Address,
        /// Number of the first parameter that holds a code.
        code: u32,
        /// Number of the first parameter that holds the kind of call: 0 subprogram, 1 macro, 2 modal, 3 modal at each block.
        kind: u32,
        /// Number of the first parameter that holds a program.
        program: u32,
        /// Increment of the parameter numbers from pair to pair.
        step: u32,
        /// Number of pairs.
        count: u32,
    },
}

/// The dialect of macro programs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Macros {
    /// Effect of a word whose value is only a vacant variable.
    pub vacant_word: VacantWord,
    /// EQ and NE treat vacant as 0, like the other comparisons.
    pub vacant_equals_zero: bool,
    /// Relative tolerance of comparisons: numbers count as equal if they differ by at most this fraction of the larger one.
    pub equal_within: f64,
    /// AND, OR, XOR are logical and combine conditions; otherwise they are bitwise.
    pub truths: bool,
    /// AND, OR, XOR of numbers with decimals are an alarm; otherwise the numbers are rounded.
    pub whole_bits: bool,
    /// Least and largest magnitude of a result other than 0; `None`: only infinity is out of range.
    pub value_range: Option<(f64, f64)>,
    /// The calculated value of an integer address is rounded; otherwise it is truncated.
    pub round_words: bool,
    /// Assignment of I, J, K in argument specification II.
    pub argument_sets: ArgumentSets,
    /// In `M98 P` with more than four digits, the digits in front of the program number are the repeat count.
    pub repeats_in_p: bool,
    /// M99 in a main program ends it; otherwise the program restarts.
    pub main_ends: bool,
    /// M02 and M30 in a subprogram return to the caller.
    pub ends_return: bool,
    /// `M98 H` starts at a sequence number of the subprogram.
    pub sub_sequence: bool,
    /// Only a sequence number is allowed in front of a macro call.
    pub call_first: bool,
    /// P or H has to follow the code of a macro call directly.
    pub program_next: bool,
    /// A one-shot macro call ends a modal macro call.
    pub call_ends_modal: bool,
    /// A return to the reference point triggers a modal macro call.
    pub call_after_return: bool,
    /// The control can keep common variables at power-off, by parameter.
    pub common_kept: bool,
    /// Functions `G65 Hnn P Q R`: number and operation. Empty if the control lacks them.
    pub functions: &'static [(u8, Operation)],
    /// Codes bound to programs by parameters. The switch `call-parameters` holds the parameter values.
    pub code_calls: &'static [CodeCalls],
    /// A code bound to a macro replaces the control's own code of the same number; otherwise the binding is ignored.
    pub calls_override: bool,
    /// A code bound to a macro stands in a block of its own, with its arguments alone: M, S and T beside it are a mistake.
    pub code_calls_alone: bool,
    /// First and last number of user alarms.
    pub user_alarms: (u32, u32),
    /// Offset from the programmed number of a user alarm to the displayed number; `None` where all user alarms show one number.
    pub user_alarm_base: Option<u32>,
    /// Letters in front of the number of a user alarm: `MC` makes 3005 `MC3005`. The number behind letters has at least four digits, and the
    /// row of `Alarm::User` has the number of the base.
    pub user_alarm_prefix: &'static str,
    /// Source and grade.
    pub cite: Citation,
}

impl Macros {
    /// A number of a user alarm, its base included, as the control shows it.
    pub(crate) fn user_alarm_shown(&self, number: u32) -> String {
        match self.user_alarm_prefix {
            "" => number.to_string(),
            prefix => format!("{prefix}{number:04}"),
        }
    }
}

/// Local variable of each letter from A in argument specification I. G, L, N, O and P pass arguments in G66.1 only.
pub const ARGUMENT: [u8; 26] =
    [1, 2, 3, 7, 8, 9, 10, 11, 4, 5, 6, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26];

/// A code bound to a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CodeCall {
    /// The code.
    pub code: CodeId,
    /// Kind of call.
    pub kind: CallKind,
    /// Number of the called program.
    pub program: u32,
}

/// Maximum number of codes bound by one row, to limit absurd parameter values.
const CALLS: u32 = 100;

impl Macros {
    /// Whether a parameter belongs to calls by code.
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

    /// Codes bound to programs by these parameters (number and value). Of two values for one parameter the later one counts.
    pub fn calls(&self, set: &[(u32, i32)]) -> Vec<CodeCall> {
        let value = |parameter: u32| set.iter().rev().find(|(number, _)| *number == parameter).map(|(_, value)| *value);
        let mut calls = Vec::new();
        let mut bind = |letter: Address, code: Option<i32>, kind: CallKind, program: Option<i32>| {
            // Parameter value 0: no code is bound.
            if let (Some(code @ 1..), Some(program @ 1..)) = (code, program) {
                let (code, program) = (code.unsigned_abs(), program.unsigned_abs());
                let code = if letter == Address::M { CodeId::M(code) } else { CodeId::g(code) };
                calls.push(CodeCall { code, kind, program });
            }
        };
        for row in self.code_calls {
            match *row {
                CodeCalls::Each { kind, negative, letter, first, count, program } => {
                    for k in 0..count.min(CALLS) {
                        let (code, program) = (value(first + k), i32::try_from(program + k).ok());
                        match negative {
                            Some(kind) if code.is_some_and(i32::is_negative) => {
                                bind(letter, code.map(i32::saturating_abs), kind, program);
                            }
                            _ => bind(letter, code, kind, program),
                        }
                    }
                }
                CodeCalls::Range { kind, letter, count, code, program } => {
                    let count = value(count).unwrap_or(0).min(CALLS as i32);
                    let from = |parameter: u32, k: i32| value(parameter).map(|first| first.saturating_add(k));
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

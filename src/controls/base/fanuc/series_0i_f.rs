//! The series FANUC 0i-F: changes to the family's rows common to its lathes and mills.

use super::sources::MEMORY;
use super::switches;
use super::{FUNCTIONS, LATER_FUNCTIONS, SHORT_FUNCTIONS};
use crate::controls::base::drives::{ANALOG_SPINDLE, AUXILIARY};
use crate::controls::macros::{CallKind, CodeCalls};
use crate::controls::options::*;
use crate::controls::schema::table::{extended, joined};
use crate::controls::switch::switch;
use crate::controls::syntax::{ArcTangent, Function};
use crate::controls::{Address, DriveSystem, Limits, Macros, Switch, Syntax};

/// Spelling, characters and file form.
pub const SYNTAX: Syntax = Syntax {
    sequence_digits: 8,
    sequence_zero: true,
    bracket_names: true,
    atan: ArcTangent::OfOneOrTwo,
    functions: joined![(&str, Function): &FUNCTIONS, &SHORT_FUNCTIONS, &LATER_FUNCTIONS],
    block_words: 26,
    ..super::SYNTAX
};

/// Calls, arguments and values of macro programs.
pub const MACROS: Macros = Macros {
    code_calls: &[
        CodeCalls::Each {
            kind: CallKind::Macro,
            negative: Some(CallKind::Modal),
            letter: Address::G,
            first: 6050,
            count: 10,
            program: 9010,
        },
        CodeCalls::Each {
            kind: CallKind::Macro,
            negative: None,
            letter: Address::M,
            first: 6080,
            count: 10,
            program: 9020,
        },
        CodeCalls::Each {
            kind: CallKind::Sub,
            negative: None,
            letter: Address::M,
            first: 6071,
            count: 9,
            program: 9001,
        },
    ],
    user_alarm_prefix: "MC",
    ..super::MACROS
};

/// Ranges of words and depths of calls.
pub const LIMITS: Limits = Limits { coordinate_max: 999_999.999, sub_depth: 10, macro_depth: 5, ..super::LIMITS };

/// Drive systems: only the maker's own for feed axes; others for auxiliary axes and spindle.
pub const DRIVES: &[DriveSystem] = joined![
    DriveSystem: &DriveSystem::axes(["alpha iS", "alpha iF", "beta iS"], super::OWN_DRIVES),
    &AUXILIARY,
    ANALOG_SPINDLE,
];

/// Switches of the series.
const SWITCHES: &[Switch] = &[
    switch(CommonVariables::of(&[CommonVariables::Sets600, CommonVariables::Sets100]), MEMORY)
        .label("switch.common-variables-fitted"),
    switch(UserAlarmBase::of(&[UserAlarmBase::From3000, UserAlarmBase::From0]), MEMORY)
        .label("switch.user-alarm-base-3000")
        .parameter("6008#1"),
    switch(JoinedConditions::of(&[JoinedConditions::Alarm, JoinedConditions::Read]), MEMORY).parameter("6006#0"),
];

/// Switches of a lathe.
pub const LATHE_SWITCHES: &[Switch] = extended![Switch: switches::LATHE, SWITCHES];

/// Switches of a mill.
pub const MILL_SWITCHES: &[Switch] = extended![Switch: switches::MILL, SWITCHES];

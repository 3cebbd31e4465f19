//! Rows of the 0i-TF that are not those of every FANUC lathe.

use crate::controls::Switch;
use crate::controls::base::fanuc;
use crate::controls::base::fanuc::MEMORY;
use crate::controls::options::*;
use crate::controls::schema::table::extended;
use crate::controls::switch::switch;

/// Points that no manual at hand settles, and parameters that change what a program means.
pub(super) const SWITCHES: &[Switch] = extended![
    Switch: fanuc::LATHE_SWITCHES,
    &[
        switch(CommonVariables::of(&[CommonVariables::Sets600, CommonVariables::Sets100]), MEMORY)
            .label("switch.common-variables-fitted"),
        switch(UserAlarmBase::of(&[UserAlarmBase::From3000, UserAlarmBase::From0]), MEMORY)
            .label("switch.user-alarm-base-3000")
            .parameter("6008#1"),
    ],
];

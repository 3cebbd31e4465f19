//! Rows of the 808D: rows of the SINUMERIK family, under the 808D's own citations where a page documents them.

use super::sources::{DIAGNOSTICS, RANGES};
use crate::controls::Alarm::{LabelTwice, NoFeed};
use crate::controls::alarm::alarm;
use crate::controls::base::sinumerik;
use crate::controls::options::*;
use crate::controls::schema::table::{cited, extended};
use crate::controls::switch::switch;
use crate::controls::{AlarmDef, CodeDef, ParamDef, Switch};
use crate::text::{Citation, Grade};

const THREAD: Citation = Citation::new("alarms 16720 and 16730 of the 808D, p.238", Grade::Manual);
const ALONE: Citation = Citation::new("alarm 12120 of the 808D, p.142", Grade::Manual);
const FEEDS: Citation = Citation::new("808D turning 01/2017, p.86", Grade::Manual);
const OTHER_LIST: Citation = Citation::new("828D diagnostics 03/2013, p.96 and 125", Grade::Sister);
const TRANSVERSE: Citation = Citation::new("alarm 10870 of the 808D, p.132", Grade::Manual);
const ENCODER: Citation = Citation::new("alarm 16770 of the 808D, p.243", Grade::Manual);
const SPINDLE: Citation = Citation::new("808D function manual 01/2017, p.168", Grade::Manual);
const REACHED: Citation = Citation::new("808D parameter manual: MD35500 and MD35150", Grade::Manual);
const M5: Citation = Citation::new("808D parameter manual, p.60: before, where the builder leaves it", Grade::Manual);
const JUMPS: Citation = Citation::new("alarm 14080 of the 808D, p.184: asks for a label, not a number", Grade::Manual);

/// G and M codes.
pub(super) const CODES: &[CodeDef] =
    cited![CodeDef: sinumerik::CODES, THREAD => "G33", ALONE => "G4 G25 G26 G110-G112", FEEDS => "G94-G97"];

/// Alarms. Two are only in the list of the 828D.
pub(super) const ALARMS: &[AlarmDef] = extended![
    AlarmDef: cited![AlarmDef: sinumerik::ALARMS, Sister DIAGNOSTICS],
    &[
        alarm(NoFeed, "10860", "No feedrate programmed", OTHER_LIST),
        alarm(LabelTwice, "12450", "Label defined twice", OTHER_LIST),
    ],
];

/// Machine and setting data that a machine has to set.
pub(super) const PARAMS: &[ParamDef] = cited![
    ParamDef: sinumerik::PARAMS,
    TRANSVERSE => "MD20100",
    ENCODER => "MD30200",
    SPINDLE => "MD35100 MD35130 MD35140",
    REACHED => "MD35150 MD35500",
];

/// Switches: points that no manual at hand settles, and data that change the meaning of a program.
pub(super) const SWITCHES: &[Switch] = extended![
    Switch: cited![
        Switch: sinumerik::SWITCHES,
        REACHED => "speed-reached",
        M5 => "m5-timing",
        JUMPS => "block-number-jumps",
    ],
    &[switch(SubprogramLevels::of(&[SubprogramLevels::Sixteen, SubprogramLevels::Eight]), RANGES)],
];

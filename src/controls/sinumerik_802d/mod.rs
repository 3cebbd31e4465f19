//! SINUMERIK 802D, turning: rows only. Where no page of the 802D itself is known, the 808D, its successor, and the 840D stand in, and say so.

mod alarms;
mod codes;
mod interface;
mod params;
mod switches;
mod vars;

use super::base::sinumerik;
use super::base::sinumerik::MEMORY;
use super::code::g_codes;
use super::syntax::Names;
use super::{AxisDef, Control, Limits, SpindleRules, Syntax};
use crate::controls::Address;
use crate::text::{Citation, Grade};

/// The page about S, M3, G25, SPOS and G96 of this very control.
const SPINDLE: Citation =
    Citation::new("SINUMERIK 802D spindle commands, Shenyang No. 1 Machine Tool, 2010", Grade::Manual);
/// Block layout, words, comments, block skip.
const BLOCKS: Citation = Citation::new("802D turning BP-D 08/2005, p.133", Grade::Manual);
/// Words, ranges, one G code per group.
const WORDS: Citation =
    Citation::new("802D sl BP-N 06/2006, p.8-122 and 8-126; grinding 07/2009, p.225", Grade::Manual);
/// Ranges of words: of T and of leads only memory knows.
const RANGES: Citation = Citation::new(
    "802D sl BP-N 06/2006, p.8-126 (F, D); 808D diagnostics, p.217 (S, LIMS); S, T and leads unverified",
    Grade::Manual,
);

/// The control.
pub static CONTROL: Control = Control {
    id: "sinumerik-802d",
    name: "SINUMERIK 802D",
    syntax: Syntax {
        names: Some(Names { codes: codes::NAMES, ..sinumerik::NAMES }),
        cite: BLOCKS,
        ..sinumerik::SYNTAX
    },
    macros: sinumerik::MACROS,
    axes: &[
        AxisDef { letter: Address::X, rotary: false, incremental: None, diameter: true, cite: SPINDLE },
        AxisDef { letter: Address::Y, rotary: false, incremental: None, diameter: false, cite: MEMORY },
        AxisDef { letter: Address::Z, rotary: false, incremental: None, diameter: false, cite: SPINDLE },
    ],
    startup: &g_codes([1, 18, 40, 60, 71, 90, 95, 500]),
    limits: Limits { cite: RANGES, ..sinumerik::LIMITS },
    spindle: SpindleRules { cite: SPINDLE, ..sinumerik::SPINDLE },
    timing: sinumerik::TIMING,
    codes: codes::CODES,
    vars: vars::VARS,
    alarms: alarms::ALARMS,
    params: params::PARAMS,
    interface: interface::SIGNALS,
    switches: switches::SWITCHES,
    bench: sinumerik::BENCH,
};

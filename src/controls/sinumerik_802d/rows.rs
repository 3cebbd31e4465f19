//! Rows of the 802D: rows of the SINUMERIK family, under the 802D's own citations where a page documents them.

use super::sources::{BLOCKS, SPINDLE, WORDS};
use crate::controls::Code::*;
use crate::controls::base::sinumerik;
use crate::controls::base::sinumerik::MEMORY;
use crate::controls::code::{Group, g, named};
use crate::controls::options::*;
use crate::controls::schema::table::{cited, extended};
use crate::controls::switch::switch;
use crate::controls::{CodeDef, ParamDef, Switch};
use crate::text::{Citation, Grade};

const M_CODES: Citation = Citation::new("802D milling ISF 09.01, p.8-44", Grade::Manual);
const ARC: Citation = Citation::new(
    "CIP and CT: page on 802D spindle commands; I1=, K1=: grinding 07/2009, p.225; I1 counts as X does: memory",
    Grade::Open,
);
const FRAME: Citation =
    Citation::new("page on 802D spindle commands: TRANS, ATRANS on X; rules from memory", Grade::Open);
const SETTING: Citation =
    Citation::new("the page on 802D spindle commands: setting data; numbers unverified", Grade::Open);
const RADII: Citation =
    Citation::new("G22 and G23 belong to the 802S and 802C; the 802D has DIAMOF and DIAMON", Grade::Open);
const M5: Citation = Citation::new(
    "the page on 802D spindle commands, 1(2): the axes first; 808D parameter manual, p.60: before, where the builder leaves it",
    Grade::Manual,
);
const BUILDER: Citation = Citation::new(
    "the machine builder's; the page on 802D spindle commands asks for lock and driven tool",
    Grade::Open,
);

/// G and M codes.
pub(super) const CODES: &[CodeDef] = extended![
    CodeDef: cited![
        CodeDef: sinumerik::CODES,
        SPINDLE => "G0-G3 G25 G26 G94-G97 M3-M5",
        WORDS => "G4 G17-G19 G40-G42 G54-G60 G64 G70 G71 G90 G91 G500",
        M_CODES => "M0-M2 M17 M19 M30 M40-M45 M70",
    ],
    &[
        g(22, Radii, Group::Diameter, "radius dimensions (802S, 802C)", MEMORY),
        g(23, Diameters, Group::Diameter, "diameter dimensions (802S, 802C)", MEMORY),
        named(1, ArcThrough, Group::Motion, "arc through an intermediate point", ARC),
        named(2, ArcTangent, Group::Motion, "arc with tangential transition", ARC),
        named(3, Offset, Group::OneShot, "programmable offset", FRAME),
        named(4, OffsetMore, Group::OneShot, "additional programmable offset", FRAME),
        named(5, Diameters, Group::Diameter, "diameter dimensions", WORDS),
        named(6, Radii, Group::Diameter, "radius dimensions", WORDS),
    ],
];

/// Machine and setting data that a machine has to set.
pub(super) const PARAMS: &[ParamDef] = cited![ParamDef: sinumerik::PARAMS, SETTING => "SD43210 SD43220 SD43230"];

/// Switches: points that no manual at hand settles, and data that change the meaning of a program.
pub(super) const SWITCHES: &[Switch] = extended![
    Switch: cited![
        Switch: sinumerik::SWITCHES,
        SPINDLE => "diameter lims-in-g97 rapid-look-ahead g9x-without-s",
        BUILDER => "spindle-lock driven-tool rotary-axes reference-point fixed-point",
        BLOCKS => "block-length",
    ],
    &[
        switch(M5Timing::of(&[M5Timing::End, M5Timing::Before]), M5).label("switch.m5-timing-stops"),
        switch(CodesG22G23::of(&[CodesG22G23::Alarm, CodesG22G23::RadiusAndDiameter]), RADII),
    ],
];

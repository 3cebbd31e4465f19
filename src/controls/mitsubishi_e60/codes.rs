//! G and M codes of the E60 (machining-center type), sorted by letter and number.

use super::sources::MEMORY;
use crate::controls::Code::*;
use crate::controls::CodeDef;
use crate::controls::base::fanuc;
use crate::controls::code::{Group, g, g_dot, m};
use crate::controls::schema::table::{extended, taken};
use crate::text::{Citation, Grade};

const P23: Citation = Citation::new("M700V/M70V programming manual, machining center", Grade::Sister);
const FEED: Citation = Citation::new("M700V/M70V programming manual, p.128", Grade::Sister);
const EXACT: Citation = Citation::new("M700V/M70V programming manual, p.143", Grade::Sister);
const MACHINE: Citation =
    Citation::new("M700V/M70V programming manual, p.508: G53 under G91 is incremental", Grade::Sister);
const STOPS: Citation = Citation::new("M700V/M70V programming manual, p.158", Grade::Sister);
const MACRO: Citation = Citation::new("M700V/M70V programming manual, p.326", Grade::Sister);
const HEADER: Citation = Citation::new("Mitsubishi Custom-API header, call types", Grade::Sister);

/// Every code.
pub(super) const CODES: &[CodeDef] = extended![
    CodeDef: taken![
        CodeDef: fanuc::MILL_CODES,
        P23 => "G0 G2-G4 G17-G19",
        FEED => "G1 G94 G95",
        MEMORY => "G37 G50 G51 G52 G54 G55-G59 G62-G64 G68 G69 G92.1 M5 M19 M99",
        MACRO => "G65 G66.1",
        HEADER => "G67 M98",
        STOPS => "M0-M2 M30",
    ],
    &[
        g_dot(2, 1, NotSimulated, Group::Motion, "spiral interpolation, clockwise", MEMORY),
        g_dot(3, 1, NotSimulated, Group::Motion, "spiral interpolation, counter-clockwise", MEMORY),
        g(5, NotSimulated, Group::OneShot, "high-speed machining mode", MEMORY),
        g_dot(5, 1, NotSimulated, Group::OneShot, "high-speed high-accuracy control", MEMORY),
        g(7, NotSimulated, Group::OneShot, "hypothetical axis interpolation", MEMORY),
        g_dot(7, 1, TakesAxisWords, Group::Other, "cylindrical interpolation", MEMORY),
        g(9, ExactStopOnce, Group::OneShot, "exact stop check", EXACT),
        g(10, NotSimulated, Group::OneShot, "program data input", MEMORY),
        g(11, Cancel, Group::OneShot, "program data input cancel", MEMORY),
        g(12, NotSimulated, Group::OneShot, "circular cutting, clockwise", MEMORY),
        g_dot(12, 1, ReplacesPositions, Group::Positions, "polar coordinate interpolation", MEMORY),
        g(13, NotSimulated, Group::OneShot, "circular cutting, counter-clockwise", MEMORY),
        g_dot(13, 1, Cancel, Group::Positions, "polar coordinate interpolation cancel", MEMORY),
        g(15, Cancel, Group::Positions, "polar coordinate command cancel", MEMORY),
        g(16, ReplacesPositions, Group::Positions, "polar coordinate command", MEMORY),
        g(20, Inch, Group::LengthUnit, "inch command", P23),
        g(21, Metric, Group::LengthUnit, "metric command", P23),
        g(22, TakesAxisWords, Group::Other, "stroke check before travel", MEMORY),
        g(23, Cancel, Group::Other, "stroke check before travel cancel", MEMORY),
        g(27, NotSimulated, Group::OneShot, "reference position check", MEMORY),
        g(28, ReferenceReturn, Group::OneShot, "reference position return", MEMORY),
        g(29, NotSimulated, Group::OneShot, "start position return", MEMORY),
        g(30, NotSimulated, Group::OneShot, "2nd to 4th reference position return", MEMORY),
        g(31, Skip, Group::OneShot, "skip", MEMORY),
        g_dot(31, 1, Skip, Group::OneShot, "multi-step skip 1", MEMORY),
        g_dot(31, 2, Skip, Group::OneShot, "multi-step skip 2", MEMORY),
        g_dot(31, 3, Skip, Group::OneShot, "multi-step skip 3", MEMORY),
        g(33, Thread, Group::Motion, "thread cutting", MEMORY),
        g(34, NotSimulated, Group::OneShot, "special fixed cycle, bolt hole circle", MEMORY),
        g(35, NotSimulated, Group::OneShot, "special fixed cycle, line at angle", MEMORY),
        g(36, NotSimulated, Group::OneShot, "special fixed cycle, arc", MEMORY),
        g_dot(37, 1, NotSimulated, Group::OneShot, "special fixed cycle, grid", MEMORY),
        g(38, NotSimulated, Group::OneShot, "tool radius compensation, vector", MEMORY),
        g(39, NotSimulated, Group::OneShot, "tool radius compensation, corner arc", MEMORY),
        g(40, Cancel, Group::Other, "tool radius compensation cancel", MEMORY),
        g_dot(40, 1, Cancel, Group::Other, "normal line control cancel", MEMORY),
        g(41, NotSimulated, Group::Other, "tool radius compensation, left", MEMORY),
        g_dot(41, 1, NotSimulated, Group::Other, "normal line control, left", MEMORY),
        g(42, NotSimulated, Group::Other, "tool radius compensation, right", MEMORY),
        g_dot(42, 1, NotSimulated, Group::Other, "normal line control, right", MEMORY),
        g(43, NotSimulated, Group::Other, "tool length offset, plus", MEMORY),
        g(44, NotSimulated, Group::Other, "tool length offset, minus", MEMORY),
        g(45, NotSimulated, Group::OneShot, "tool position offset, increase", MEMORY),
        g(46, NotSimulated, Group::OneShot, "tool position offset, decrease", MEMORY),
        g(47, NotSimulated, Group::OneShot, "tool position offset, double", MEMORY),
        g(48, NotSimulated, Group::OneShot, "tool position offset, half", MEMORY),
        g(49, Cancel, Group::Other, "tool length offset cancel", MEMORY),
        g_dot(50, 1, CancelForAxes, Group::Other, "mirror image cancel", MEMORY),
        g_dot(51, 1, TakesAxisWords, Group::Other, "mirror image", MEMORY),
        g(53, MachineCoordinates, Group::OneShot, "machine coordinate system", MACHINE),
        g_dot(54, 1, NotSimulated, Group::Coordinates, "extended work coordinate system", MEMORY),
        g(60, NotSimulated, Group::OneShot, "unidirectional positioning", MEMORY),
        g(61, ExactStop, Group::PathMode, "exact stop check mode", EXACT),
        g_dot(61, 1, NotSimulated, Group::PathMode, "high-accuracy control", MEMORY),
        g(66, MacroModal, Group::MacroModal, "modal macro call, after each axis motion", MACRO),
        g(73, NotSimulated, Group::Cycle, "fixed cycle, step drilling", MEMORY),
        g(74, NotSimulated, Group::Cycle, "fixed cycle, reverse tapping", MEMORY),
        g(75, NotSimulated, Group::Cycle, "fixed cycle, circular cutting", MEMORY),
        g(76, NotSimulated, Group::Cycle, "fixed cycle, fine boring", MEMORY),
        g(80, Cancel, Group::Cycle, "fixed cycle cancel", MEMORY),
        g(81, NotSimulated, Group::Cycle, "fixed cycle, drilling", MEMORY),
        g(82, NotSimulated, Group::Cycle, "fixed cycle, counter boring", MEMORY),
        g(83, NotSimulated, Group::Cycle, "fixed cycle, deep hole drilling", MEMORY),
        g(84, NotSimulated, Group::Cycle, "fixed cycle, tapping", MEMORY),
        g(85, NotSimulated, Group::Cycle, "fixed cycle, boring", MEMORY),
        g(86, NotSimulated, Group::Cycle, "fixed cycle, boring with spindle stop", MEMORY),
        g(87, NotSimulated, Group::Cycle, "fixed cycle, back boring", MEMORY),
        g(88, NotSimulated, Group::Cycle, "fixed cycle, boring with dwell", MEMORY),
        g(89, NotSimulated, Group::Cycle, "fixed cycle, boring with dwell at the bottom", MEMORY),
        g(90, Absolute, Group::Distance, "absolute value command", P23),
        g(91, Incremental, Group::Distance, "incremental value command", P23),
        g(92, SetCoordinates, Group::OneShot, "coordinate system setting", MEMORY),
        g(93, NotSimulated, Group::FeedUnit, "inverse time feed", MEMORY),
        g(96, NotSimulated, Group::SurfaceSpeed, "constant surface speed", MEMORY),
        g(97, SurfaceSpeedOff, Group::SurfaceSpeed, "constant surface speed cancel", MEMORY),
        g(98, Cancel, Group::Other, "fixed cycle, return to the initial level", MEMORY),
        g(99, NotSimulated, Group::Other, "fixed cycle, return to the R level", MEMORY),
        m(3, SpindleCw, "spindle forward", MEMORY),
        m(4, SpindleCcw, "spindle reverse", MEMORY),
        m(96, NotSimulated, "user macro interrupt enable", P23),
        m(97, NotSimulated, "user macro interrupt disable", P23),
    ],
];

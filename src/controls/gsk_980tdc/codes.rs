//! G and M codes of the 980TDc, sorted by letter and number.

use super::sources::{MACRO, MEMORY, SPINDLE};
use crate::controls::Code::*;
use crate::controls::CodeDef;
use crate::controls::base::fanuc;
use crate::controls::code::{Group, g, g_dot};
use crate::controls::schema::table::{extended, taken};
use crate::text::{Citation, Grade};

/// The chapter on G codes.
const TDI: Citation = Citation::new("GSK980TDi manual, chapter 3", Grade::Sister);

/// Every code.
pub(super) const CODES: &[CodeDef] = extended![
    CodeDef: taken![
        CodeDef: fanuc::LATHE_CODES,
        TDI => "G1-G4 G7.1 G12.1 G13.1 G17-G21 G34 G40-G42 G50.2 G51.2 G52 G54-G59 G70 G92 G98 G99 M30 M98 M99",
        MACRO => "G66 G67",
        MEMORY => "M0-M2",
        SPINDLE => "M3-M5 M41-M44",
    ],
    &[
        g(0, Rapid, Group::Motion, "rapid positioning", TDI),
        g(5, NotSimulated, Group::Motion, "arc through three points", TDI),
        g_dot(5, 1, NotSimulated, Group::Motion, "arc through three points, absolute", TDI),
        g_dot(6, 2, NotSimulated, Group::Motion, "elliptic interpolation, clockwise", TDI),
        g_dot(6, 3, NotSimulated, Group::Motion, "elliptic interpolation, counter-clockwise", TDI),
        g_dot(7, 2, NotSimulated, Group::Motion, "parabolic interpolation, clockwise", TDI),
        g_dot(7, 3, NotSimulated, Group::Motion, "parabolic interpolation, counter-clockwise", TDI),
        g(10, NotSimulated, Group::OneShot, "data input", MEMORY),
        g(11, Cancel, Group::OneShot, "data input cancel", MEMORY),
        g(15, Cancel, Group::Positions, "polar coordinates cancel", TDI),
        g(16, ReplacesPositions, Group::Positions, "polar coordinates", TDI),
        g(22, TakesAxisWords, Group::Other, "stored stroke limit 2 on", TDI),
        g(23, Cancel, Group::Other, "stored stroke limit 2 off", TDI),
        g(28, ReferenceReturn, Group::OneShot, "return to machine zero", TDI),
        g(30, NotSimulated, Group::OneShot, "return to the 2nd, 3rd, 4th reference point", TDI),
        g(31, Skip, Group::OneShot, "skip interpolation", TDI),
        g(32, Thread, Group::Motion, "thread cutting of constant lead", TDI),
        g_dot(32, 1, NotSimulated, Group::Motion, "rigid thread cutting", TDI),
        g_dot(32, 2, NotSimulated, Group::Motion, "thread cutting on an arc, clockwise", TDI),
        g_dot(32, 3, NotSimulated, Group::Motion, "thread cutting on an arc, counter-clockwise", TDI),
        g(33, NotSimulated, Group::Motion, "tapping cycle along Z", TDI),
        g(35, NotSimulated, Group::OneShot, "torque control", TDI),
        g(36, NotSimulated, Group::OneShot, "automatic tool offset X", TDI),
        g(37, NotSimulated, Group::OneShot, "automatic tool offset Z", TDI),
        g(50, SetCoordinates, Group::OneShot, "work coordinate system setting; speed limit", SPINDLE),
        g(53, MachineRapid, Group::OneShot, "positioning in the machine coordinate system", TDI),
        g(65, MacroCall, Group::OneShot, "macro call, macro function", MACRO),
        g(71, Roughing, Group::OneShot, "axial roughing cycle", TDI),
        g(72, Roughing, Group::OneShot, "radial roughing cycle", TDI),
        g(73, Roughing, Group::OneShot, "closed cutting cycle", TDI),
        g(74, NotSimulated, Group::OneShot, "axial grooving cycle", TDI),
        g_dot(74, 1, NotSimulated, Group::OneShot, "axial recessing cycle", TDI),
        g(75, NotSimulated, Group::OneShot, "radial grooving cycle", TDI),
        g_dot(75, 1, NotSimulated, Group::OneShot, "radial recessing cycle", TDI),
        g(76, NotSimulated, Group::OneShot, "multiple thread cutting cycle", TDI),
        g(78, NotSimulated, Group::OneShot, "enhanced thread cutting cycle", TDI),
        g(80, Cancel, Group::Cycle, "drilling cycle cancel, hobbing cancel", TDI),
        g(81, NotSimulated, Group::OneShot, "gear hobbing", TDI),
        g(83, NotSimulated, Group::Cycle, "drilling cycle, face", TDI),
        g_dot(83, 1, NotSimulated, Group::Cycle, "drilling cycle, inclined", TDI),
        g_dot(83, 2, NotSimulated, Group::Cycle, "drilling cycle, inclined", TDI),
        g(84, NotSimulated, Group::Cycle, "rigid tapping, face", TDI),
        g_dot(84, 1, NotSimulated, Group::Cycle, "rigid tapping, inclined", TDI),
        g_dot(84, 2, NotSimulated, Group::Cycle, "rigid tapping of the main spindle", TDI),
        g(86, NotSimulated, Group::OneShot, "reciprocating feed cycle", TDI),
        g(87, NotSimulated, Group::Cycle, "drilling cycle, side", TDI),
        g_dot(87, 1, NotSimulated, Group::Cycle, "drilling cycle, inclined", TDI),
        g(88, NotSimulated, Group::Cycle, "rigid tapping, side", TDI),
        g_dot(88, 1, NotSimulated, Group::Cycle, "rigid tapping, inclined", TDI),
        g(90, NotSimulated, Group::Motion, "axial cutting cycle", TDI),
        g_dot(92, 1, NotSimulated, Group::Motion, "rigid thread cutting cycle", TDI),
        g_dot(92, 3, NotSimulated, Group::Motion, "thread cutting of variable lead and constant crest", TDI),
        g(94, NotSimulated, Group::Motion, "radial cutting cycle", TDI),
        g(96, SurfaceSpeed, Group::SurfaceSpeed, "constant surface speed", SPINDLE),
        g(97, SurfaceSpeedOff, Group::SurfaceSpeed, "constant rotational speed", SPINDLE),
    ],
];

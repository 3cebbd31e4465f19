//! G and M codes of the 802D, sorted by letter and number, and those of its codes that are names.

use super::{MEMORY, SPINDLE, WORDS};
use crate::controls::Code::*;
use crate::controls::code::{Group, g, m, mg, named};
use crate::controls::{CodeDef, Point};
use crate::text::{Citation, Grade};

const THREAD: Citation = Citation::new("808D milling, p.79; alarms 16720 and 16730", Grade::Sister);
const TAPS: Citation =
    Citation::new("alarms 16763 and 16770 of the 808D, p.242; G63 acts in its block alone: memory", Grade::Open);
const GROUPS: Citation = Citation::new("840D sl NC programming 12/2019, p.1249", Grade::Sister);
const M_CODES: Citation = Citation::new("802D milling ISF 09.01, p.8-44", Grade::Manual);
const ARC: Citation = Citation::new(
    "CIP and CT: page on 802D spindle commands; I1=, K1=: grinding 07/2009, p.225; I1 counts as X does: memory",
    Grade::Open,
);
const AREA: Citation = Citation::new(
    "alarm 12120 of the 808D, p.142, and 840D NC programming 12/2019, p.1249: G25, G26; machine frame, end points: memory",
    Grade::Open,
);
const FRAME: Citation =
    Citation::new("page on 802D spindle commands: TRANS, ATRANS on X; rules from memory", Grade::Open);

/// Codes that are names; their place is their number.
pub(super) const NAMES: &[&str] = &[
    "RET", "CIP", "CT", "TRANS", "ATRANS", "DIAMON", "DIAMOF", "DIAM90", "BRISK", "SOFT", "FFWON", "FFWOF", "NORM",
    "KONT", "WALIMON", "WALIMOF", "CFC", "CFTCP", "CFIN", "ROT", "AROT", "SCALE", "ASCALE", "MIRROR", "AMIRROR",
    "STOPRE", "SETMS", "TRANSMIT", "TRACYL", "TRAFOOF", "SPCON", "SPCOF", "CYCLE",
];

/// Every code.
pub(super) const CODES: &[CodeDef] = &[
    g(0, Rapid, Group::Motion, "rapid traverse", SPINDLE),
    g(1, Linear, Group::Motion, "linear interpolation at feed", SPINDLE),
    g(2, ArcCw, Group::Motion, "circular interpolation, clockwise", SPINDLE),
    g(3, ArcCcw, Group::Motion, "circular interpolation, counter-clockwise", SPINDLE),
    g(4, Dwell, Group::OneShot, "dwell", WORDS),
    g(9, ExactStopOnce, Group::OneShot, "exact stop in this block", MEMORY),
    g(17, PlaneXy, Group::Plane, "plane X-Y", WORDS),
    g(18, PlaneZx, Group::Plane, "plane Z-X", WORDS),
    g(19, PlaneYz, Group::Plane, "plane Y-Z", WORDS),
    g(22, Radii, Group::Diameter, "radius dimensions (802S, 802C)", MEMORY),
    g(23, Diameters, Group::Diameter, "diameter dimensions (802S, 802C)", MEMORY),
    g(25, LowerLimits, Group::OneShot, "lower spindle speed limit, lower working area limit", SPINDLE),
    g(26, UpperLimits, Group::OneShot, "upper spindle speed limit, upper working area limit", SPINDLE),
    g(33, Thread, Group::Motion, "thread cutting of constant lead", THREAD),
    g(40, Cancel, Group::Compensation, "tool radius compensation off", WORDS),
    g(41, NotSimulated, Group::Compensation, "tool radius compensation, left", WORDS),
    g(42, NotSimulated, Group::Compensation, "tool radius compensation, right", WORDS),
    g(53, MachineCoordinates, Group::OneShot, "settable offset suppressed in this block", MEMORY),
    g(54, WorkCoordinates(1), Group::Coordinates, "settable work offset 1", WORDS),
    g(55, WorkCoordinates(2), Group::Coordinates, "settable work offset 2", WORDS),
    g(56, WorkCoordinates(3), Group::Coordinates, "settable work offset 3", WORDS),
    g(57, WorkCoordinates(4), Group::Coordinates, "settable work offset 4", WORDS),
    g(58, WorkCoordinates(5), Group::Coordinates, "settable work offset 5", WORDS),
    g(59, WorkCoordinates(6), Group::Coordinates, "settable work offset 6", WORDS),
    g(60, ExactStop, Group::PathMode, "exact stop", WORDS),
    g(63, Tapping, Group::OneShot, "tapping with compensating chuck", TAPS),
    g(64, Cutting, Group::PathMode, "continuous path", WORDS),
    g(70, Inch, Group::LengthUnit, "inch input", WORDS),
    g(71, Metric, Group::LengthUnit, "metric input", WORDS),
    g(74, GoTo(Point::Reference), Group::OneShot, "reference point approach", MEMORY),
    g(75, GoTo(Point::Fixed), Group::OneShot, "fixed point approach", MEMORY),
    g(90, Absolute, Group::Distance, "absolute dimensions", WORDS),
    g(91, Incremental, Group::Distance, "incremental dimensions", WORDS),
    g(94, FeedPerMinute, Group::FeedUnit, "feed per minute", SPINDLE),
    g(95, FeedPerRevolution, Group::FeedUnit, "feed per revolution", SPINDLE),
    g(96, SurfaceSpeed, Group::FeedUnit, "constant cutting speed on", SPINDLE),
    g(97, SurfaceSpeedOff, Group::FeedUnit, "constant cutting speed off", SPINDLE),
    g(110, NotSimulated, Group::OneShot, "pole, from the last position", GROUPS),
    g(111, NotSimulated, Group::OneShot, "pole", GROUPS),
    g(112, NotSimulated, Group::OneShot, "pole, from the last pole", GROUPS),
    g(153, MachineCoordinates, Group::OneShot, "all offsets suppressed in this block", MEMORY),
    g(331, Tapping, Group::Motion, "tapping in position control", TAPS),
    g(332, Tapping, Group::Motion, "tapping in position control, retraction", TAPS),
    g(450, Cancel, Group::Other, "transition circle", MEMORY),
    g(451, NotSimulated, Group::Other, "point of intersection", MEMORY),
    g(500, WorkCoordinates(0), Group::Coordinates, "settable work offset off", WORDS),
    g(601, Cancel, Group::Other, "exact stop window, fine", MEMORY),
    g(602, NotSimulated, Group::Other, "exact stop window, coarse", MEMORY),
    g(700, Inch, Group::LengthUnit, "inch input, of feeds too", MEMORY),
    g(710, Metric, Group::LengthUnit, "metric input, of feeds too", MEMORY),
    mg(0, Stop, Group::Flow, "program stop", M_CODES),
    mg(1, OptionalStop, Group::Flow, "optional stop", M_CODES),
    mg(2, End, Group::Flow, "program end", M_CODES),
    mg(3, SpindleCw, Group::Spindle, "spindle clockwise", SPINDLE),
    mg(4, SpindleCcw, Group::Spindle, "spindle counter-clockwise", SPINDLE),
    mg(5, SpindleStop, Group::Spindle, "spindle stop", SPINDLE),
    mg(17, SubEnd, Group::Flow, "end of subprogram", M_CODES),
    mg(19, SpindleOrient, Group::Spindle, "spindle positioning", M_CODES),
    mg(30, EndRewind, Group::Flow, "program end and rewind", M_CODES),
    mg(40, GearStage(0), Group::Gear, "automatic gear change", M_CODES),
    mg(41, GearStage(1), Group::Gear, "gear 1", M_CODES),
    mg(42, GearStage(2), Group::Gear, "gear 2", M_CODES),
    mg(43, GearStage(3), Group::Gear, "gear 3", M_CODES),
    mg(44, GearStage(4), Group::Gear, "gear 4", M_CODES),
    mg(45, GearStage(5), Group::Gear, "gear 5", M_CODES),
    m(70, NotSimulated, "spindle becomes an axis", M_CODES),
    named(0, Return, Group::Flow, "end of subprogram, without stopping the path", GROUPS),
    named(1, ArcThrough, Group::Motion, "arc through an intermediate point", ARC),
    named(2, ArcTangent, Group::Motion, "arc with tangential transition", ARC),
    named(3, Offset, Group::OneShot, "programmable offset", FRAME),
    named(4, OffsetMore, Group::OneShot, "additional programmable offset", FRAME),
    named(5, Diameters, Group::Diameter, "diameter dimensions", WORDS),
    named(6, Radii, Group::Diameter, "radius dimensions", WORDS),
    named(7, DiametersAbsolute, Group::Diameter, "absolute dimensions as diameters, incremental as radii", MEMORY),
    named(8, Cancel, Group::Other, "acceleration in steps", MEMORY),
    named(9, NotSimulated, Group::Other, "acceleration with limited jerk", MEMORY),
    named(10, NotSimulated, Group::Other, "feedforward on", MEMORY),
    named(11, Cancel, Group::Other, "feedforward off", MEMORY),
    named(12, Cancel, Group::Other, "approach on a straight line", MEMORY),
    named(13, NotSimulated, Group::Other, "approach around the contour", MEMORY),
    named(14, WorkingArea(true), Group::Other, "working area limits on", AREA),
    named(15, WorkingArea(false), Group::Other, "working area limits off", AREA),
    named(16, Cancel, Group::Other, "constant feed on the contour", MEMORY),
    named(17, NotSimulated, Group::Other, "constant feed of the tool centre", MEMORY),
    named(18, NotSimulated, Group::Other, "constant feed on inner radii", MEMORY),
    named(19, NotSimulated, Group::OneShot, "programmable rotation", MEMORY),
    named(20, NotSimulated, Group::OneShot, "additional programmable rotation", MEMORY),
    named(21, NotSimulated, Group::OneShot, "programmable scale", MEMORY),
    named(22, NotSimulated, Group::OneShot, "additional programmable scale", MEMORY),
    named(23, NotSimulated, Group::OneShot, "programmable mirroring", MEMORY),
    named(24, NotSimulated, Group::OneShot, "additional programmable mirroring", MEMORY),
    named(25, Cancel, Group::Other, "preprocessing stop", MEMORY),
    named(26, MasterSpindle, Group::Other, "master spindle", MEMORY),
    named(27, NotSimulated, Group::Other, "milling of faces by turning", MEMORY),
    named(28, NotSimulated, Group::Other, "milling of cylinders by turning", MEMORY),
    named(29, Cancel, Group::Other, "transformation off", MEMORY),
    named(30, NotSimulated, Group::Other, "spindle under position control", MEMORY),
    named(31, Cancel, Group::Other, "spindle under speed control", MEMORY),
    named(32, NotSimulated, Group::OneShot, "cycle", MEMORY),
];

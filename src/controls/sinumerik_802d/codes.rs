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

/// Every code; numbers are ten times what is written.
pub(super) const CODES: &[CodeDef] = &[
    g(0, Rapid, Group::Motion, "rapid traverse", SPINDLE),
    g(10, Linear, Group::Motion, "linear interpolation at feed", SPINDLE),
    g(20, ArcCw, Group::Motion, "circular interpolation, clockwise", SPINDLE),
    g(30, ArcCcw, Group::Motion, "circular interpolation, counter-clockwise", SPINDLE),
    g(40, Dwell, Group::OneShot, "dwell", WORDS),
    g(90, ExactStopOnce, Group::OneShot, "exact stop in this block", MEMORY),
    g(170, PlaneXy, Group::Plane, "plane X-Y", WORDS),
    g(180, PlaneZx, Group::Plane, "plane Z-X", WORDS),
    g(190, PlaneYz, Group::Plane, "plane Y-Z", WORDS),
    g(220, Radii, Group::Diameter, "radius dimensions (802S, 802C)", MEMORY),
    g(230, Diameters, Group::Diameter, "diameter dimensions (802S, 802C)", MEMORY),
    g(250, LowerLimits, Group::OneShot, "lower spindle speed limit, lower working area limit", SPINDLE),
    g(260, UpperLimits, Group::OneShot, "upper spindle speed limit, upper working area limit", SPINDLE),
    g(330, Thread, Group::Motion, "thread cutting of constant lead", THREAD),
    g(400, Cancel, Group::Compensation, "tool radius compensation off", WORDS),
    g(410, NotSimulated, Group::Compensation, "tool radius compensation, left", WORDS),
    g(420, NotSimulated, Group::Compensation, "tool radius compensation, right", WORDS),
    g(530, MachineCoordinates, Group::OneShot, "settable offset suppressed in this block", MEMORY),
    g(540, WorkCoordinates(1), Group::Coordinates, "settable work offset 1", WORDS),
    g(550, WorkCoordinates(2), Group::Coordinates, "settable work offset 2", WORDS),
    g(560, WorkCoordinates(3), Group::Coordinates, "settable work offset 3", WORDS),
    g(570, WorkCoordinates(4), Group::Coordinates, "settable work offset 4", WORDS),
    g(580, WorkCoordinates(5), Group::Coordinates, "settable work offset 5", WORDS),
    g(590, WorkCoordinates(6), Group::Coordinates, "settable work offset 6", WORDS),
    g(600, ExactStop, Group::PathMode, "exact stop", WORDS),
    g(630, Tapping, Group::OneShot, "tapping with compensating chuck", TAPS),
    g(640, Cutting, Group::PathMode, "continuous path", WORDS),
    g(700, Inch, Group::LengthUnit, "inch input", WORDS),
    g(710, Metric, Group::LengthUnit, "metric input", WORDS),
    g(740, GoTo(Point::Reference), Group::OneShot, "reference point approach", MEMORY),
    g(750, GoTo(Point::Fixed), Group::OneShot, "fixed point approach", MEMORY),
    g(900, Absolute, Group::Distance, "absolute dimensions", WORDS),
    g(910, Incremental, Group::Distance, "incremental dimensions", WORDS),
    g(940, FeedPerMinute, Group::FeedUnit, "feed per minute", SPINDLE),
    g(950, FeedPerRevolution, Group::FeedUnit, "feed per revolution", SPINDLE),
    g(960, SurfaceSpeed, Group::FeedUnit, "constant cutting speed on", SPINDLE),
    g(970, SurfaceSpeedOff, Group::FeedUnit, "constant cutting speed off", SPINDLE),
    g(1100, NotSimulated, Group::OneShot, "pole, from the last position", GROUPS),
    g(1110, NotSimulated, Group::OneShot, "pole", GROUPS),
    g(1120, NotSimulated, Group::OneShot, "pole, from the last pole", GROUPS),
    g(1530, MachineCoordinates, Group::OneShot, "all offsets suppressed in this block", MEMORY),
    g(3310, Tapping, Group::Motion, "tapping in position control", TAPS),
    g(3320, Tapping, Group::Motion, "tapping in position control, retraction", TAPS),
    g(4500, Cancel, Group::Other, "transition circle", MEMORY),
    g(4510, NotSimulated, Group::Other, "point of intersection", MEMORY),
    g(5000, WorkCoordinates(0), Group::Coordinates, "settable work offset off", WORDS),
    g(6010, Cancel, Group::Other, "exact stop window, fine", MEMORY),
    g(6020, NotSimulated, Group::Other, "exact stop window, coarse", MEMORY),
    g(7000, Inch, Group::LengthUnit, "inch input, of feeds too", MEMORY),
    g(7100, Metric, Group::LengthUnit, "metric input, of feeds too", MEMORY),
    mg(0, Stop, Group::Flow, "program stop", M_CODES),
    mg(10, OptionalStop, Group::Flow, "optional stop", M_CODES),
    mg(20, End, Group::Flow, "program end", M_CODES),
    mg(30, SpindleCw, Group::Spindle, "spindle clockwise", SPINDLE),
    mg(40, SpindleCcw, Group::Spindle, "spindle counter-clockwise", SPINDLE),
    mg(50, SpindleStop, Group::Spindle, "spindle stop", SPINDLE),
    mg(170, SubEnd, Group::Flow, "end of subprogram", M_CODES),
    mg(190, SpindleOrient, Group::Spindle, "spindle positioning", M_CODES),
    mg(300, EndRewind, Group::Flow, "program end and rewind", M_CODES),
    mg(400, GearStage(0), Group::Gear, "automatic gear change", M_CODES),
    mg(410, GearStage(1), Group::Gear, "gear 1", M_CODES),
    mg(420, GearStage(2), Group::Gear, "gear 2", M_CODES),
    mg(430, GearStage(3), Group::Gear, "gear 3", M_CODES),
    mg(440, GearStage(4), Group::Gear, "gear 4", M_CODES),
    mg(450, GearStage(5), Group::Gear, "gear 5", M_CODES),
    m(700, NotSimulated, "spindle becomes an axis", M_CODES),
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

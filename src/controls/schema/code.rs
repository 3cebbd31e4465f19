//! G and M codes: what they mean to the interpreter, in which modal group they stand.

use super::table::{Key, digits, divided, range_ends, single};
use core::fmt;

use crate::text::{Citation, Phrase};

/// What a code does, in the words of the trade; the interpreter knows these and no numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Code {
    /// Positioning.
    Rapid,
    /// Linear cutting feed.
    Linear,
    /// Clockwise arc.
    ArcCw,
    /// Counter-clockwise arc.
    ArcCcw,
    /// Arc through an intermediate point (CIP).
    ArcThrough,
    /// Arc that goes on in the direction of the motion before it (CT).
    ArcTangent,
    /// Thread cutting: a straight line whose feed per revolution is the lead, without overrides.
    Thread,
    /// Tapping: a straight line, in position control (G331) at S times the lead, with a compensating chuck (G63) at F. What the spindle does
    /// in it is not simulated.
    Tapping,
    /// Straight cutting feed in this block, which a signal breaks off; in the simulation none comes.
    Skip,
    /// Dwell.
    Dwell,
    /// Exact stop in this block.
    ExactStopOnce,
    /// Exact stop mode.
    ExactStop,
    /// Cutting mode: no deceleration between blocks.
    Cutting,
    /// Plane XY.
    PlaneXy,
    /// Plane ZX.
    PlaneZx,
    /// Plane YZ.
    PlaneYz,
    /// Inch input.
    Inch,
    /// Metric input.
    Metric,
    /// Return to the reference point.
    ReferenceReturn,
    /// Machine coordinate system in this block.
    MachineCoordinates,
    /// Machine coordinate system in this block, at rapid traverse whatever motion is in force.
    MachineRapid,
    /// Work coordinate system 1 to 6.
    WorkCoordinates(u8),
    /// Setting of the coordinate system; with S, of the highest spindle speed.
    SetCoordinates,
    /// Zero of the local coordinate system, within the work coordinate system.
    LocalCoordinates,
    /// Absolute dimensions.
    Absolute,
    /// Incremental dimensions.
    Incremental,
    /// Feed per minute.
    FeedPerMinute,
    /// Feed per revolution.
    FeedPerRevolution,
    /// Constant surface speed on.
    SurfaceSpeed,
    /// Constant surface speed off.
    SurfaceSpeedOff,
    /// One-shot macro call.
    MacroCall,
    /// Modal macro call after each block with axis motion.
    MacroModal,
    /// Modal macro call at each block.
    MacroModalBlock,
    /// End of a modal macro call.
    MacroModalEnd,
    /// Subprogram call (M98).
    SubCall,
    /// End of subprogram (M99).
    SubEnd,
    /// Program stop (M00).
    Stop,
    /// Optional stop (M01).
    OptionalStop,
    /// Program end (M02).
    End,
    /// Program end and rewind (M30).
    EndRewind,
    /// Spindle clockwise (M03).
    SpindleCw,
    /// Spindle counter-clockwise (M04).
    SpindleCcw,
    /// Spindle stop (M05).
    SpindleStop,
    /// Gear stage of the spindle (M41 …), 0 for automatic selection by S (M40).
    GearStage(u8),
    /// Lower limit of the spindle speed behind S, of the working area behind axes (G25).
    LowerLimits,
    /// The upper ones (G26).
    UpperLimits,
    /// Working area limits on or off.
    WorkingArea(bool),
    /// Spindle orientation (M19).
    SpindleOrient,
    /// The spindle that S and M words without a number are for (SETMS).
    MasterSpindle,
    /// The named axes go to their reference points (G74), or to a fixed point (G75), wherever those are.
    GoTo(Point),
    /// Programmable offset in place of the one before.
    Offset,
    /// Programmable offset on top of the one before.
    OffsetMore,
    /// Words of the transverse axis count diameters.
    Diameters,
    /// Words of the transverse axis count radii.
    Radii,
    /// Absolute words of the transverse axis count diameters, incremental ones radii.
    DiametersAbsolute,
    /// End of subprogram that a main program cannot have (RET).
    Return,
    /// The next block is read when all before it are done (STOPRE).
    StopReading,
    /// Cancel or default state that the simulation is in anyway (G40, G80 …).
    Cancel,
    /// The control has it, the simulation does not act on it; said once per kind.
    NotSimulated,
    /// Not simulated; the axis words of its block are its own (a centre, factors, limits) and move nothing.
    TakesAxisWords,
    /// Not simulated; until it is cancelled, axis words are no positions of the axes (polar coordinates) and move nothing.
    ReplacesPositions,
    /// Cancel of a code for the axes that its block names, whose words move nothing.
    CancelForAxes,
    /// A cycle that is not simulated, whose blocks from P to Q are a contour and no motions.
    Roughing,
    /// Any other M code: handed to the PLC, which answers with FIN.
    Auxiliary,
}

impl Code {
    /// Whether the control acts on it and the simulation does not.
    pub fn is_left_out(self) -> bool {
        matches!(self, Code::NotSimulated | Code::TakesAxisWords | Code::ReplacesPositions | Code::Roughing)
    }
}

/// A place on the machine that a code goes to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Point {
    /// Where the axes are referenced.
    Reference,
    /// A fixed point of the machine builder, for instance of tool change.
    Fixed,
}

/// Modal group of a code.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Group {
    /// Acts in its own block only.
    OneShot,
    /// Motion: G00 … G03.
    Motion,
    /// Plane.
    Plane,
    /// Absolute or incremental.
    Distance,
    /// Feed per minute or per revolution.
    FeedUnit,
    /// Inch or metric.
    LengthUnit,
    /// Work coordinate system.
    Coordinates,
    /// Exact stop or cutting mode.
    PathMode,
    /// Constant surface speed.
    SurfaceSpeed,
    /// Modal macro call.
    MacroModal,
    /// Fixed cycles.
    Cycle,
    /// Tool radius compensation.
    Compensation,
    /// What axis words are: positions of the axes, or polar coordinates.
    Positions,
    /// Words of the transverse axis.
    Diameter,
    /// Spindle on and off.
    Spindle,
    /// Gears of the spindle.
    Gear,
    /// Program stops and ends.
    Flow,
    /// M codes and everything else.
    Other,
}

/// Number of a G code, with at most one decimal: 61.1 in `G61.1`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CodeNumber {
    whole: u32,
    tenth: u8,
}

impl CodeNumber {
    /// A number that no code has.
    pub const NONE: CodeNumber = CodeNumber { whole: u32::MAX, tenth: 0 };

    /// A whole number: 5 in `G05`.
    pub const fn whole(whole: u32) -> CodeNumber {
        CodeNumber { whole, tenth: 0 }
    }

    /// A number with one decimal: 5 and 1 in `G05.1`.
    pub const fn dot(whole: u32, tenth: u8) -> CodeNumber {
        assert!(tenth < 10, "one decimal");
        CodeNumber { whole, tenth }
    }

    /// `mantissa / 10^scale`; `None` where no code has such a number.
    #[inline]
    pub fn from_decimal(mantissa: i64, scale: u8) -> Option<CodeNumber> {
        match scale {
            0 => Some(CodeNumber::whole(u32::try_from(mantissa).ok()?)),
            1 => Some(CodeNumber {
                whole: u32::try_from(mantissa.div_euclid(10)).ok()?,
                tenth: mantissa.rem_euclid(10) as u8,
            }),
            _ => None,
        }
    }

    /// The number of a calculated value that is within `tolerance` of a tenth; `None` where no code has such a number.
    pub fn from_value(value: f64, tolerance: f64) -> Option<CodeNumber> {
        let tenths = value * 10.0;
        let fits = (0.0..1e9).contains(&tenths) && (tenths - tenths.round()).abs() < tolerance;
        if fits { CodeNumber::from_decimal(tenths.round() as i64, 1) } else { None }
    }

    /// The part in front of the point.
    #[inline]
    pub const fn integer(self) -> u32 {
        self.whole
    }

    /// The decimal.
    #[inline]
    pub const fn tenth(self) -> u8 {
        self.tenth
    }

    /// The number as a value.
    pub fn to_f64(self) -> f64 {
        (f64::from(self.whole) * 10.0 + f64::from(self.tenth)) / 10.0
    }
}

impl fmt::Display for CodeNumber {
    /// `5`, `61.1`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.tenth {
            0 => write!(f, "{}", self.whole),
            tenth => write!(f, "{}.{tenth}", self.whole),
        }
    }
}

/// A code as a program names it. Rows of a control are sorted by it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CodeId {
    /// `G61.1`.
    G(CodeNumber),
    /// `M03`.
    M(u32),
    /// A name such as `DIAMON`: its place in [`Names::codes`](super::syntax::Names::codes).
    Named(u16),
}

impl CodeId {
    /// A G code with a whole number.
    pub const fn g(number: u32) -> CodeId {
        CodeId::G(CodeNumber::whole(number))
    }

    /// A G code with one decimal: `g_dot(61, 1)` is `G61.1`.
    pub const fn g_dot(whole: u32, tenth: u8) -> CodeId {
        CodeId::G(CodeNumber::dot(whole, tenth))
    }

    /// The place among all codes, for tables that are sorted when the library is compiled.
    pub(in crate::controls) const fn rank(self) -> u64 {
        match self {
            CodeId::G(number) => 10 * number.whole as u64 + number.tenth as u64,
            CodeId::M(number) => 1 << 40 | number as u64,
            CodeId::Named(place) => 2 << 40 | place as u64,
        }
    }

    /// The number; a name has none.
    pub fn number(self) -> Option<CodeNumber> {
        match self {
            CodeId::G(number) => Some(number),
            CodeId::M(number) => Some(CodeNumber::whole(number)),
            CodeId::Named(_) => None,
        }
    }

    /// The value that variables show for the code: its number, or the place of its name.
    pub fn to_f64(self) -> f64 {
        match self {
            CodeId::Named(place) => f64::from(place),
            _ => self.number().map_or(0.0, CodeNumber::to_f64),
        }
    }
}

/// G codes with whole numbers, for a list in a row.
pub(in crate::controls) const fn g_codes<const N: usize>(numbers: [u32; N]) -> [CodeId; N] {
    let mut codes = [CodeId::g(0); N];
    let mut at = 0;
    while at < N {
        codes[at] = CodeId::g(numbers[at]);
        at += 1;
    }
    codes
}

/// A code of a control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CodeDef {
    /// Letter and number, or name.
    pub id: CodeId,
    /// What it does.
    pub code: Code,
    /// Its modal group.
    pub group: Group,
    /// What it is, as the control's manual calls it.
    pub text: Phrase,
    /// Source and grade.
    pub cite: Citation,
}

/// A row of a G code with a whole number: `g(5, …)` is G05.
pub(in crate::controls) const fn g(
    number: u32,
    code: Code,
    group: Group,
    text: &'static str,
    cite: Citation,
) -> CodeDef {
    CodeDef { id: CodeId::g(number), code, group, text: Phrase::new(text), cite }
}

/// A row of a G code with one decimal: `g_dot(5, 1, …)` is G05.1.
pub(in crate::controls) const fn g_dot(
    whole: u32,
    tenth: u8,
    code: Code,
    group: Group,
    text: &'static str,
    cite: Citation,
) -> CodeDef {
    CodeDef { id: CodeId::g_dot(whole, tenth), code, group, text: Phrase::new(text), cite }
}

/// A row of an M code: `m(3, …)` is M03.
pub(in crate::controls) const fn m(number: u32, code: Code, text: &'static str, cite: Citation) -> CodeDef {
    mg(number, code, Group::Other, text, cite)
}

/// A row of an M code in a modal group.
pub(in crate::controls) const fn mg(
    number: u32,
    code: Code,
    group: Group,
    text: &'static str,
    cite: Citation,
) -> CodeDef {
    CodeDef { id: CodeId::M(number), code, group, text: Phrase::new(text), cite }
}

/// A row of a code that is a name: the `place`-th of its control's names.
pub(in crate::controls) const fn named(
    place: u16,
    code: Code,
    group: Group,
    text: &'static str,
    cite: Citation,
) -> CodeDef {
    CodeDef { id: CodeId::Named(place), code, group, text: Phrase::new(text), cite }
}

impl CodeDef {
    /// Whether it says what the words of its block mean: motions, and what takes axis words otherwise.
    pub fn defines_syntax(&self) -> bool {
        let one_shot = self.group == Group::OneShot && !matches!(self.id, CodeId::M(_));
        self.group == Group::Motion
            || one_shot && !matches!(self.code, Code::ExactStopOnce | Code::MachineCoordinates | Code::Return)
    }

    /// Whether its block holds nothing but its own values.
    pub fn stands_alone(&self) -> bool {
        matches!(self.code, Code::Dwell | Code::LowerLimits | Code::UpperLimits)
    }
}

impl CodeDef {
    /// Whether its table is sorted, for searches by halves.
    pub const SORTED: bool = true;

    /// What the row is about, for tables that are made of a family's rows and a control's own.
    pub const fn key(&self) -> Key {
        single(self.id.rank())
    }

    /// The key of the rows that a list names: `G7.1`, `M30`, `G54-G59`.
    pub const fn listed_key(word: &[u8]) -> Key {
        let (first, last) = range_ends(word);
        (listed_rank(first), listed_rank(last))
    }
}

/// The place of a code among all codes, as a list names it.
const fn listed_rank(word: &[u8]) -> u64 {
    let (letter, number) = word.split_at(1);
    let (whole, tenth) = divided(number, b'.');
    let tenth = if tenth.is_empty() { 0 } else { digits(tenth) };
    match letter[0] {
        b'G' => CodeId::g_dot(digits(whole) as u32, tenth as u8).rank(),
        b'M' => CodeId::M(digits(whole) as u32).rank(),
        _ => panic!("a list names G and M codes"),
    }
}

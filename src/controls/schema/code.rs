//! G and M codes: their meaning for the interpreter, and their modal groups.

use super::table::{Key, digits, divided, range_ends, single};
use core::fmt;

use crate::drives::Rotation;
use crate::text::{Citation, Phrase};

/// Meaning of a code. The interpreter acts on the meaning and never on the code's number.
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
    /// Arc tangential to the preceding motion (CT).
    ArcTangent,
    /// Thread cutting: a straight line with the lead as feed per revolution, without overrides.
    Thread,
    /// Tapping: a straight line, in position control (G331) at S times the lead, with a compensating chuck (G63) at F. The motion of the
    /// spindle during tapping is not simulated.
    Tapping,
    /// Straight cutting feed in this block, ended early by the skip signal. The simulation has no skip signal.
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
    /// Machine coordinate system in this block: absolute words count from machine zero, incremental ones from the present position.
    MachineCoordinates,
    /// Machine coordinate system in this block, always absolute and at rapid traverse.
    MachineRapid,
    /// Work coordinate system 1 to 6.
    WorkCoordinates(u8),
    /// Additional work coordinate systems, numbered by P (G54.1). Work coordinate system 1 with P is the same code. Not simulated.
    MoreCoordinates,
    /// Setting of the coordinate system; with S, maximum spindle speed.
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
    /// Gear stage of the spindle (M41 and up); 0: automatic selection by S (M40).
    GearStage(u8),
    /// Lower limits (G25): of the spindle speed by S, of the working area by axis words.
    LowerLimits,
    /// Upper limits (G26), as for [`Code::LowerLimits`].
    UpperLimits,
    /// Working area limits on or off.
    WorkingArea(bool),
    /// Spindle orientation (M19).
    SpindleOrient,
    /// Selection of the spindle addressed by S and M words without a number (SETMS).
    MasterSpindle,
    /// Motion of the named axes to their reference points (G74) or to a fixed point (G75).
    GoTo(Point),
    /// Programmable offset that replaces the preceding one.
    Offset,
    /// Programmable offset added to the preceding one.
    OffsetMore,
    /// Words of the transverse axis count diameters.
    Diameters,
    /// Words of the transverse axis count radii.
    Radii,
    /// Absolute words of the transverse axis count diameters, incremental ones radii.
    DiametersAbsolute,
    /// End of subprogram, not allowed in a main program (RET).
    Return,
    /// Read-ahead stop: the next block is read after all preceding blocks are executed (STOPRE).
    StopReading,
    /// Cancel or default state, without effect here because the simulation never leaves it (G40, G80 …).
    Cancel,
    /// A code that the simulation ignores, reported once per kind.
    NotSimulated,
    /// Not simulated. Input of data by its block; after one of these numbers in L also by the blocks behind it, up to the next G or M code.
    DataInput(&'static [u16]),
    /// Not simulated. The axis words of its block are parameters of the code (a centre, factors, limits) and move nothing.
    TakesAxisWords,
    /// Not simulated. Until it is cancelled, axis words are not axis positions (polar coordinates) and move nothing.
    ReplacesPositions,
    /// Cancel of a code for the axes named in the block; their words move nothing.
    CancelForAxes,
    /// A cycle that is not simulated; the blocks from P to Q are its contour and move nothing.
    Roughing,
    /// Any other M code: handed to the PLC, which answers with FIN.
    Auxiliary,
}

impl Code {
    /// The code of a rotation: M03, M04 or M05.
    pub fn of_rotation(rotation: Rotation) -> Code {
        match rotation {
            Rotation::Stopped => Code::SpindleStop,
            Rotation::Clockwise => Code::SpindleCw,
            Rotation::CounterClockwise => Code::SpindleCcw,
        }
    }

    /// Rotation commanded by M03, M04 and M05.
    pub fn rotation(self) -> Option<Rotation> {
        match self {
            Code::SpindleStop => Some(Rotation::Stopped),
            Code::SpindleCw => Some(Rotation::Clockwise),
            Code::SpindleCcw => Some(Rotation::CounterClockwise),
            _ => None,
        }
    }

    /// Whether the simulation ignores the code although the control acts on it.
    pub fn is_left_out(self) -> bool {
        use Code::{DataInput, MoreCoordinates, NotSimulated, ReplacesPositions, Roughing, TakesAxisWords};
        matches!(self, NotSimulated | MoreCoordinates | DataInput(_) | TakesAxisWords | ReplacesPositions | Roughing)
    }
}

/// Target position of a code, fixed on the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Point {
    /// Reference points of the axes.
    Reference,
    /// A fixed point of the machine builder, for instance the tool change position.
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
    /// Meaning of axis words: axis positions or polar coordinates.
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
    /// A number outside the range of codes.
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

    /// `mantissa / 10^scale`; `None` unless it is a whole number or has one decimal.
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

    /// The number of a code as written: `61.1`.
    pub fn from_text(text: &str) -> Option<CodeNumber> {
        let (whole, decimals) = text.split_once('.').unwrap_or((text, ""));
        let decimals = decimals.trim_end_matches('0');
        let digits = format!("{whole}{decimals}");
        let all = digits.bytes().all(|byte| byte.is_ascii_digit());
        let mantissa = digits.parse().ok().filter(|_| all)?;
        CodeNumber::from_decimal(mantissa, u8::try_from(decimals.len()).ok()?)
    }

    /// The number nearest to a calculated value, if within `tolerance` tenths of it; else `None`.
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

/// Spelling of a code in a program. Rows of a control are sorted by it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CodeId {
    /// `G61.1`.
    G(CodeNumber),
    /// `M03`.
    M(u32),
    /// A name such as `DIAMON`: its index in [`Names::codes`](super::syntax::Names::codes).
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

    /// Sort key among all codes, for tables sorted at compile time.
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

    /// Value of the code in a modal system variable: its number, or the index of its name.
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
    /// Meaning for the interpreter.
    pub code: Code,
    /// Modal group of the code.
    pub group: Group,
    /// Description, in the words of the control's manual.
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

/// A row of a code that is a name, by its index in [`Names::codes`](super::syntax::Names::codes).
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
    /// Whether the code defines the meaning of its block's words: motion codes, and one-shot G codes that use axis words otherwise.
    pub fn defines_syntax(&self) -> bool {
        let one_shot = self.group == Group::OneShot && !matches!(self.id, CodeId::M(_));
        self.group == Group::Motion
            || one_shot && !matches!(self.code, Code::ExactStopOnce | Code::MachineCoordinates | Code::Return)
    }

    /// Whether the code has to be alone in its block, apart from its own values.
    pub fn stands_alone(&self) -> bool {
        matches!(self.code, Code::Dwell | Code::LowerLimits | Code::UpperLimits)
    }
}

impl CodeDef {
    /// Whether the table is sorted, for binary search.
    pub const SORTED: bool = true;

    /// Key for replacing a family's row by the control's own row of the same code.
    pub const fn key(&self) -> Key {
        single(self.id.rank())
    }

    /// The key range of an entry in a row list: `G7.1`, `M30`, `G54-G59`.
    pub const fn listed_key(word: &[u8]) -> Key {
        let (first, last) = range_ends(word);
        (listed_rank(first), listed_rank(last))
    }
}

/// Sort key of a code as an entry in a row list spells it.
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

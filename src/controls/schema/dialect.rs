//! `Dialect`: a control's rules under the project's switch settings, resolved once for parser, lint, interpreter, planner and machines.

use super::address::Address;
use super::code::{CodeId, Group};
use super::control::Control;
use super::interface::SignalRole;
use super::macros::CodeCall;
use super::options::*;
use super::spindle::{LimitPlace, PANEL, REACHED, RapidSpeed, SWITCH_CODES, SpindleRules, TENS_CODES};
use super::switch::Switches;
use crate::text::{Citation, number};

/// G22 and G23.
const DIAMETER_CODES: &[CodeId] = &[CodeId::g(22), CodeId::g(23)];

/// Digits of a number on controls without a narrower limit.
const DIGITS: usize = 18;

/// A control's rules with all switch settings applied. Code outside reads the dialect and never a setting.
#[derive(Debug, Clone, PartialEq)]
pub struct Dialect {
    pub(crate) reading: ReadingRules,
    pub(crate) numbers: NumberRules,
    pub(crate) running: RunningRules,
    /// G codes in force after power-on.
    pub(crate) startup: Vec<CodeId>,
    /// Bits of axis indexes: words count diameters.
    diameters: u32,
    /// Bits of axis indexes: the axis is rotary (degrees).
    rotary: u32,
    /// Axis index and coordinate (mm or °, machine frame) of the reference points; axes not listed are at 0.
    pub(crate) reference_points: Vec<(usize, f64)>,
    /// Axis index and coordinate of the fixed point.
    pub(crate) fixed_point: Vec<(usize, f64)>,
    spindle: SpindleRules,
    calls: Vec<CodeCall>,
    call_parts: Vec<CallPart>,
    /// Offset in registers of the macro inputs from the device numbers in their rows.
    inputs_moved: i64,
    /// The feed override acts on axes moved by the PMC.
    pub(crate) pmc_override: bool,
    /// Parts of text settings that could not be read: switch id and part.
    unread: Vec<(&'static str, String)>,
}

/// Rules for reading the text of a program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ReadingRules {
    /// Characters of comments.
    pub(crate) characters: CommentCharacters,
    /// Maximum characters of a block.
    pub(crate) block_chars: u32,
    /// Maximum characters of a label; 0 where the control has no labels.
    pub(crate) label_chars: usize,
    /// Maximum digits of a number.
    pub(crate) digits: usize,
    /// GOTOF and GOTOB take block numbers.
    pub(crate) number_jumps: bool,
    /// A point after a variable is ignored, not an alarm.
    pub(crate) variable_point: bool,
    /// A block may hold several assignments.
    pub(crate) assignments: bool,
    /// `IF [ ] THEN` is read, not an alarm.
    pub(crate) if_then: bool,
    /// `AND`, `OR` and `XOR` between conditions in brackets are read, not an alarm; `None` where no setting of the control joins them.
    pub(crate) joined_conditions: Option<bool>,
    /// `MOD` is read, not an alarm.
    pub(crate) modulo: bool,
    /// A formula after an address needs brackets.
    pub(crate) enclosed: bool,
    /// Ranges of fitted common variables; empty if all are fitted.
    pub(crate) fitted: &'static [(u32, u32)],
    /// Codes disabled by a switch.
    pub(crate) codes_off: &'static [CodeId],
}

/// Rules for counting, rounding and limiting numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NumberRules {
    /// A coordinate without a point counts millimetres, not increments.
    pub(crate) whole_units: bool,
    /// A macro argument without a point counts increments.
    pub(crate) argument_increments: bool,
    /// A value that a program writes to an offset counts increments.
    pub(crate) offset_increments: bool,
    /// ROUND in a word rounds to the step of its address, not to a whole number.
    pub(crate) round_to_step: bool,
    /// S is rounded, not truncated.
    pub(crate) round_speed: bool,
    /// S under constant surface speed is in ft/min in inch input, not in m/min.
    pub(crate) surface_feet: bool,
    /// `E` of a thread is a lead, not threads per inch.
    pub(crate) fine_lead: bool,
    /// `ATAN[y]/[x]` is within 0 to 360, not -180 to 180.
    pub(crate) atan_turn: bool,
    /// Range of the results of ASIN.
    pub(crate) asin: AsinRange,
}

/// Range of the results of ASIN, in degrees.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum AsinRange {
    /// -90 to 90.
    AroundZero,
    /// 90 to 270.
    AroundHalfTurn,
    /// 270 to 360 and 0 to 90.
    WithinTurn,
}

/// Origin of coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum CoordinateFrame {
    /// The work zero of the program.
    Program,
    /// Machine zero.
    Machine,
}

/// Rules for the execution of codes and calls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RunningRules {
    /// F0 is rapid traverse, not an alarm.
    pub(crate) feed_zero_rapid: bool,
    /// A dwell under feed per revolution counts revolutions of the spindle, not seconds.
    pub(crate) dwell_counts_turns: bool,
    /// `#3004` switches the cutting override off.
    pub(crate) suppress_override: bool,
    /// A local variable without an argument keeps its last value.
    pub(crate) keep_locals: bool,
    /// Common variables become vacant at reset.
    pub(crate) clear_common: bool,
    /// F of a helix is the feed along its arc; otherwise along the path with all axes.
    pub(crate) helix_by_arc: bool,
    /// Maximum effective M codes of a block.
    pub(crate) m_codes: u8,
    /// More M codes than `m_codes` are an alarm; otherwise the last ones act.
    pub(crate) m_alarm: bool,
    /// Working area limits stop the axes.
    pub(crate) area: bool,
    /// Coordinates that are checked against the range of words; `None`: no check.
    pub(crate) range: Option<CoordinateFrame>,
    /// M02 and M30 in a subprogram return.
    pub(crate) ends_return: bool,
    /// Maximum depth of nested subprograms.
    pub(crate) sub_depth: u8,
    /// Offset from the programmed number of a user alarm to the displayed number; `None` where all user alarms show one number.
    pub(crate) user_alarm_base: Option<u32>,
}

/// Whether a switch of two options is set to this one; `None` where the control has no such switch. A switch with a third option needs a
/// `match` that gives the effect of each, so that here it does not compile.
fn is_set_to<C: SwitchChoice>(setting: Option<C>, option: C) -> Option<bool> {
    const { assert!(C::COUNT == 2, "a switch of two options") };
    setting.map(|setting| setting == option)
}

impl Dialect {
    /// Resolves the rows of a control and the switch settings.
    pub fn resolve(control: &Control, switches: &Switches) -> Dialect {
        let set = Settings::new(control.switches.iter().map(|row| (row.kind, switches.setting(row))));
        let mut unread = Vec::new();
        let call_parts = call_parts(set.call_parameters.unwrap_or(""));
        let diameters = set.diameter != Some(Diameter::Radius);
        let counts = control.axes.iter().map(|axis| axis.diameter && diameters);
        let turning = rotary_axes(control, set.rotary_axes.unwrap_or(""), &mut unread);
        let turns = control.axes.iter().enumerate().map(|(at, axis)| axis.rotary || turning & 1 << at != 0);
        Dialect {
            reading: ReadingRules::new(control, &set),
            numbers: NumberRules::new(control, &set),
            running: RunningRules::new(control, &set),
            startup: startup(control, &set),
            diameters: bits(counts),
            rotary: bits(turns),
            reference_points: point(control, ReferencePoint::ID, set.reference_point.unwrap_or(""), &mut unread),
            fixed_point: point(control, FixedPoint::ID, set.fixed_point.unwrap_or(""), &mut unread),
            spindle: spindle(control.spindle, &set, &mut unread),
            calls: calls(control, &call_parts.iter().filter_map(|part| part.1).collect::<Vec<_>>()),
            call_parts,
            inputs_moved: set.macro_input_base.map_or(0, |base| base.register() - input_rows(control)),
            pmc_override: is_set_to(set.pmc_override, PmcOverride::Acts).unwrap_or(false),
            unread,
        }
    }

    /// Whether the words of an axis (by index) count diameters.
    pub fn counts_diameters(&self, axis: usize) -> bool {
        axis < 32 && self.diameters & 1 << axis != 0
    }

    /// Units that the words of an axis (by index) count per millimetre of its slide: 2 for diameters.
    pub fn words_per_mm(&self, axis: usize) -> f64 {
        if self.counts_diameters(axis) { 2.0 } else { 1.0 }
    }

    /// Whether an axis (by index) is rotary (degrees).
    pub fn is_rotary(&self, axis: usize) -> bool {
        axis < 32 && self.rotary & 1 << axis != 0
    }

    /// Whether a local variable without an argument keeps its last value.
    pub fn keeps_locals(&self) -> bool {
        self.running.keep_locals
    }

    /// Characters allowed in comments.
    pub fn comment_characters(&self) -> CommentCharacters {
        self.reading.characters
    }

    /// The rules of the spindle.
    pub fn spindle(&self) -> SpindleRules {
        self.spindle
    }

    /// Codes bound to programs by parameters.
    pub fn calls(&self) -> &[CodeCall] {
        &self.calls
    }

    /// Device of a signal role, with its source; `None` if the control has none.
    pub fn device(&self, control: &Control, role: SignalRole) -> Option<(String, Citation)> {
        let row = control.interface.iter().find(|row| row.role == role)?;
        Some((self.moved(row.role, row.device), row.cite))
    }

    /// The role of a register.
    pub fn role(&self, control: &Control, device: &str) -> Option<SignalRole> {
        let row = control.interface.iter().find(|row| self.moved(row.role, row.device).eq_ignore_ascii_case(device))?;
        Some(row.role)
    }

    /// A device of the rows, shifted by the setting for the macro inputs.
    fn moved(&self, role: SignalRole, device: &str) -> String {
        match (role, device.split_at_checked(1).map(|(letter, number)| (letter, number.parse::<i64>()))) {
            (SignalRole::MacroInputLow(_) | SignalRole::MacroInputHigh(_), Some((letter, Ok(number)))) => {
                format!("{letter}{}", number + self.inputs_moved)
            }
            _ => device.to_owned(),
        }
    }
}

impl ReadingRules {
    fn new(control: &Control, set: &Settings) -> ReadingRules {
        let syntax = &control.syntax;
        ReadingRules {
            characters: set.comment_characters.unwrap_or(CommentCharacters::Ascii),
            block_chars: match set.block_length {
                Some(BlockLength::Chars200) => 200,
                Some(BlockLength::Chars512) => 512,
                None => syntax.block_read_chars,
            },
            label_chars: match set.label_length {
                Some(LabelLength::Eight) => 8,
                Some(LabelLength::ThirtyTwo) => 32,
                None => 0,
            },
            digits: match set.number_digits {
                Some(NumberDigits::Twelve) => 12,
                Some(NumberDigits::Eight) => 8,
                None => DIGITS,
            },
            number_jumps: is_set_to(set.block_number_jumps, BlockNumberJumps::Yes).unwrap_or(false),
            variable_point: is_set_to(set.point_after_variable, PointAfterVariable::Ignored).unwrap_or(false),
            assignments: is_set_to(set.assignments, Assignments::Several).unwrap_or(false),
            joined_conditions: is_set_to(set.joined_conditions, JoinedConditions::Read),
            if_then: syntax.if_then || is_set_to(set.if_then, IfThen::Read).unwrap_or(false),
            modulo: syntax.modulo || is_set_to(set.modulo, Modulo::Read).unwrap_or(false),
            enclosed: is_set_to(set.word_formula, WordFormula::InBrackets).unwrap_or(false),
            fitted: match (set.common_variables, set.r_parameters) {
                (Some(CommonVariables::Sets100), _) => &[(100, 149), (500, 549)],
                (Some(CommonVariables::Sets200), _) => &[(100, 199), (500, 599)],
                (Some(CommonVariables::Sets300), _) => &[(100, 199), (500, 699)],
                (Some(CommonVariables::Sets600), _) => &[(100, 199), (500, 999)],
                (None, Some(RParameters::All300)) => &[(0, 299)],
                (None, Some(RParameters::All250)) => &[(0, 249)],
                (None, None) => &[],
            },
            codes_off: match set.codes_g22_g23 {
                Some(CodesG22G23::Alarm) => DIAMETER_CODES,
                Some(CodesG22G23::RadiusAndDiameter) | None => &[],
            },
        }
    }
}

impl NumberRules {
    fn new(control: &Control, set: &Settings) -> NumberRules {
        let (atan_turn, asin) = match set.angle_range {
            Some(AngleRange::AtanTurnAsinAroundZero) => (true, AsinRange::AroundZero),
            Some(AngleRange::AtanTurnAsinWithinTurn) => (true, AsinRange::WithinTurn),
            Some(AngleRange::AtanHalfTurnAsinAroundZero) | None => (false, AsinRange::AroundZero),
            Some(AngleRange::AtanHalfTurnAsinAroundHalfTurn) => (false, AsinRange::AroundHalfTurn),
        };
        NumberRules {
            whole_units: is_set_to(set.decimal_point, DecimalPoint::Millimetres).unwrap_or(false),
            argument_increments: is_set_to(set.argument_point, ArgumentPoint::Increments).unwrap_or(false),
            offset_increments: is_set_to(set.offset_values, OffsetValues::Increments).unwrap_or(false),
            round_to_step: is_set_to(set.round_in_word, RoundInWord::AddressStep).unwrap_or(false),
            round_speed: is_set_to(set.spindle_word, SpindleWord::Round).unwrap_or(control.macros.round_words),
            surface_feet: is_set_to(set.surface_speed_in_inch, SurfaceSpeedInInch::FeetPerMinute).unwrap_or(false),
            fine_lead: is_set_to(set.thread_e, ThreadE::Lead).unwrap_or(false),
            atan_turn,
            asin,
        }
    }
}

impl RunningRules {
    fn new(control: &Control, set: &Settings) -> RunningRules {
        let (m_codes, m_alarm) = match set.m_codes {
            Some(MCodes::LastThreeAct) => (3, false),
            Some(MCodes::LastActs) | None => (control.limits.m_codes, false),
            Some(MCodes::Alarm) => (control.limits.m_codes, true),
        };
        RunningRules {
            feed_zero_rapid: is_set_to(set.feed_zero, FeedZero::Rapid).unwrap_or(false),
            dwell_counts_turns: is_set_to(set.dwell_unit, DwellUnit::Revolutions).unwrap_or(false),
            suppress_override: is_set_to(set.override_suppression, OverrideSuppression::Yes).unwrap_or(true),
            keep_locals: is_set_to(set.locals_of_calls, LocalsOfCalls::Kept).unwrap_or(false),
            clear_common: is_set_to(set.common_at_reset, CommonAtReset::Vacant).unwrap_or(false),
            helix_by_arc: is_set_to(set.helix_feed, HelixFeed::Arc).unwrap_or(false),
            m_codes,
            m_alarm,
            area: is_set_to(set.working_area, WorkingArea::Limit).unwrap_or(true),
            range: match set.coordinate_range {
                Some(CoordinateRange::Program) => Some(CoordinateFrame::Program),
                Some(CoordinateRange::Machine) => Some(CoordinateFrame::Machine),
                Some(CoordinateRange::NoAlarm) | None => None,
            },
            ends_return: is_set_to(set.end_in_subprogram, EndInSubprogram::Return)
                .unwrap_or(control.macros.ends_return),
            // The switch counts the main program as one level.
            sub_depth: match set.subprogram_levels {
                Some(SubprogramLevels::Eight) => 7,
                Some(SubprogramLevels::Sixteen) => 15,
                None => control.limits.sub_depth,
            },
            user_alarm_base: match set.user_alarm_base {
                Some(UserAlarmBase::From5900) => Some(5900),
                Some(UserAlarmBase::From500) => Some(500),
                Some(UserAlarmBase::From3000) => Some(3000),
                Some(UserAlarmBase::From0) => Some(0),
                None => control.macros.user_alarm_base,
            },
        }
    }
}

impl MacroInputBase {
    /// Register number.
    fn register(self) -> i64 {
        match self {
            MacroInputBase::R72 => 72,
            MacroInputBase::R172 => 172,
            MacroInputBase::R24 => 24,
            MacroInputBase::R124 => 124,
            MacroInputBase::R6436 => 6436,
        }
    }
}

/// First register of the macro inputs in the rows of a control: the switch's default.
fn input_rows(control: &Control) -> i64 {
    let default = control.switches.iter().find_map(|row| match row.kind {
        SwitchKind::MacroInputBase(options) => options.first().copied(),
        _ => None,
    });
    default.map_or(0, MacroInputBase::register)
}

/// Packs the first 32 booleans into bits, from bit 0 up.
fn bits(holds: impl Iterator<Item = bool>) -> u32 {
    holds.take(32).enumerate().fold(0, |bits, (at, holds)| bits | u32::from(holds) << at)
}

/// Codes in force after power-on: the control's rows, then the codes set by switches.
fn startup(control: &Control, set: &Settings) -> Vec<CodeId> {
    let distance = set.startup_distance.map(|code| match code {
        StartupDistance::G90 => (90, Group::Distance),
        StartupDistance::G91 => (91, Group::Distance),
    });
    let motion = set.startup_motion.map(|code| match code {
        StartupMotion::G00 | StartupMotion::G0 => (0, Group::Motion),
        StartupMotion::G01 | StartupMotion::G1 => (1, Group::Motion),
    });
    let feed = set.startup_feed.map(|code| match code {
        StartupFeed::G94 => (94, Group::FeedUnit),
        StartupFeed::G95 => (95, Group::FeedUnit),
        StartupFeed::G98 => (98, Group::FeedUnit),
        StartupFeed::G99 => (99, Group::FeedUnit),
    });
    let path = set.startup_path.map(|code| match code {
        StartupPath::G60 => (60, Group::PathMode),
        StartupPath::G64 => (64, Group::PathMode),
    });
    let mut startup = control.startup.to_vec();
    let set = [distance, motion, feed, path].into_iter().flatten();
    let rows = set.filter_map(|(number, group)| control.code(CodeId::g(number)).filter(|row| row.group == group));
    startup.extend(rows.map(|row| row.id));
    startup
}

/// Spindle rules of the control's row, overridden by switch settings.
fn spindle(row: SpindleRules, set: &Settings, unread: &mut Vec<(&'static str, String)>) -> SpindleRules {
    SpindleRules {
        limit_place: match set.speed_limit_sets_zero {
            Some(SpeedLimitSetsZero::ReferencePoint) => LimitPlace::ReferencePoint,
            Some(SpeedLimitSetsZero::WorkZero) => LimitPlace::WorkZero,
            Some(SpeedLimitSetsZero::Nothing) => LimitPlace::Nothing,
            None => row.limit_place,
        },
        reached: match set.speed_reached {
            Some(SpeedReached::Wait) => row.reached.or(Some(REACHED)),
            Some(SpeedReached::NoWait) => None,
            None => row.reached,
        },
        volts_stay: is_set_to(set.volts_at_stop, VoltsAtStop::Kept).unwrap_or(row.volts_stay),
        emergency_clears: is_set_to(set.volts_at_emergency_stop, VoltsAtEmergencyStop::Off)
            .unwrap_or(row.emergency_clears),
        stop_last: is_set_to(set.m5_timing, M5Timing::End).unwrap_or(row.stop_last),
        surface_limit_stays: is_set_to(set.limit_in_g97, LimitInG97::Yes).unwrap_or(row.surface_limit_stays),
        surface_at_once: is_set_to(set.g96_at_once, G96AtOnce::Yes).unwrap_or(row.surface_at_once),
        rapid: rapid_speed(row.rapid, set),
        offset_at_rest: is_set_to(set.offset_at_rest, OffsetAtRest::PutOut).unwrap_or(row.offset_at_rest),
        small_offset: match set.small_offset {
            Some(SmallOffset::Tenth) => 0.1,
            Some(SmallOffset::Half) => 0.5,
            Some(SmallOffset::Nothing) => 0.0,
            None => row.small_offset,
        },
        override_last: is_set_to(set.override_order, OverrideOrder::AfterLimits).unwrap_or(row.override_last),
        last_speed_back: is_set_to(set.feed_code_without_s, FeedCodeWithoutS::LastProgrammed)
            .unwrap_or(row.last_speed_back),
        angle_wraps: is_set_to(set.spos_out_of_range, SposOutOfRange::Modulo).unwrap_or(row.angle_wraps),
        turns_through_reset: is_set_to(set.spindle_at_reset, SpindleAtReset::Turns).unwrap_or(row.turns_through_reset),
        stop_between: is_set_to(set.reversal, Reversal::Alarm).unwrap_or(row.stop_between),
        knob: match set.spindle_knob {
            Some(SpindleKnob::From50To120) => PANEL,
            Some(SpindleKnob::From0To200) | None => row.knob,
        },
        override_codes: match set.override_code {
            Some(OverrideCode::Switch) => SWITCH_CODES,
            Some(OverrideCode::Tens) => TENS_CODES,
            None => row.override_codes,
        },
        lower_wins: is_set_to(set.crossed_limits, CrossedLimits::LowerHolds).unwrap_or(row.lower_wins),
        end_stops: is_set_to(set.spindle_at_end, SpindleAtEnd::Stops).unwrap_or(row.end_stops),
        manual_in_automatic: is_set_to(set.manual_s, ManualS::Taken).unwrap_or(row.manual_in_automatic),
        lock: m_code(SpindleLock::ID, set.spindle_lock, unread).or(row.lock),
        driven_tool: m_code(DrivenTool::ID, set.driven_tool, unread).or(row.driven_tool),
        ..row
    }
}

/// The speed in a rapid under constant surface speed.
fn rapid_speed(row: RapidSpeed, set: &Settings) -> RapidSpeed {
    match (set.rapid_look_ahead, set.speed_in_rapid) {
        (Some(RapidLookAhead::NextBlock), _) => RapidSpeed::BeforeCutBlock,
        (Some(RapidLookAhead::NextMotion), _) => RapidSpeed::BeforeCut,
        (None, Some(SpeedInRapid::Kept)) => RapidSpeed::Kept,
        (None, Some(SpeedInRapid::OfEnd)) => RapidSpeed::OfEnd,
        (None, None) => row,
    }
}

/// Number of an M code in a text setting: `M81` or `81`.
fn m_code(id: &'static str, text: Option<&str>, unread: &mut Vec<(&'static str, String)>) -> Option<u32> {
    let text = text?;
    let number = text.trim_start_matches(['M', 'm']).parse().ok();
    if number.is_none() && !text.trim().is_empty() {
        unread.push((id, text.trim().to_owned()));
    }
    number
}

/// Bits of the axis indexes for axis letters in a text setting, `Y` or `Y A`.
fn rotary_axes(control: &Control, text: &str, unread: &mut Vec<(&'static str, String)>) -> u32 {
    let mut turning = 0;
    for letter in text.chars().filter(|c| !c.is_whitespace() && !SEPARATORS.contains(c)) {
        let axis = u8::try_from(letter).ok().and_then(Address::of).and_then(|letter| control.axis(letter));
        match axis {
            Some(axis) => turning |= bits((0..=axis).map(|at| at == axis)),
            None => unread.push((RotaryAxes::ID, letter.to_string())),
        }
    }
    turning
}

/// Axis index and coordinate of each word in a text setting, `X300 Z-50.5`. Of two words for one axis the later one counts.
fn point(
    control: &Control,
    id: &'static str,
    words: &str,
    unread: &mut Vec<(&'static str, String)>,
) -> Vec<(usize, f64)> {
    let mut place = Vec::new();
    for word in words.split(SEPARATORS).filter(|word| !word.is_empty()) {
        let axis = word.bytes().next().and_then(Address::of).and_then(|letter| control.axis(letter));
        match axis.zip(word.get(1..).and_then(number::read)) {
            Some(word) => place.push(word),
            None => unread.push((id, word.to_owned())),
        }
    }
    place
}

/// Separators between the words of a text setting.
const SEPARATORS: [char; 3] = [' ', ',', ';'];

/// A word of the switch `call-parameters`, and the parameter number and value it sets.
type CallPart = (String, Option<(u32, i32)>);

/// Splits the text of the switch `call-parameters` into words.
fn call_parts(text: &str) -> Vec<CallPart> {
    let words = text.split(SEPARATORS).filter(|word| !word.is_empty());
    words.map(|word| (word.to_owned(), call_parameter(word))).collect()
}

/// Parameter number and value of a word such as `4120=512` or `6051=-200`, with or without `#` or `No.` in front.
fn call_parameter(word: &str) -> Option<(u32, i32)> {
    let (number, value) = word.split_once('=')?;
    let number = number.trim_start_matches(|c: char| !c.is_ascii_digit()).parse().ok()?;
    let value = value.trim_start_matches(|c: char| !c.is_ascii_digit() && c != '-').parse().ok()?;
    Some((number, value))
}

/// Codes bound to programs by these parameters.
fn calls(control: &Control, parameters: &[(u32, i32)]) -> Vec<CodeCall> {
    let mut calls = control.macros.calls(parameters);
    calls.retain(|call| control.macros.calls_override || control.code(call.code).is_none());
    calls
}

impl Dialect {
    /// Parts of text settings without effect: switch id and part.
    pub fn idle_texts<'a>(&'a self, control: &'a Control) -> impl Iterator<Item = (&'static str, &'a str)> {
        let unread = self.unread.iter().map(|(id, part)| (*id, part.as_str()));
        unread.chain(self.idle_call_parts(control).map(|part| (CallParameters::ID, part)))
    }

    /// Words of the switch `call-parameters` that change no call. A value of 0 is allowed: it leaves the parameter unset.
    fn idle_call_parts<'a>(&'a self, control: &'a Control) -> impl Iterator<Item = &'a str> {
        let parts = self.call_parts.iter().enumerate();
        parts
            .filter(|(at, (_, set))| match *set {
                None => true,
                Some((number, 0)) if control.macros.has_parameter(number) => false,
                Some(_) => {
                    let others = self.call_parts.iter().enumerate().filter(|(other, _)| other != at);
                    let others: Vec<(u32, i32)> = others.filter_map(|(_, (_, set))| *set).collect();
                    calls(control, &others) == self.calls
                }
            })
            .map(|(_, (part, _))| part.as_str())
    }
}

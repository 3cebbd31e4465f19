//! What rows and switches of a control come to while a program runs: open points as they are set, ranges, roundings.

use super::canon::AXES;
use crate::controls::macros::VacantWord;
use crate::controls::syntax::letter_bits;
use crate::controls::{Alarm, Code, CodeId, Control, Group, Limits, Point, SpindleRules, Switches};
use crate::text::number;

/// M codes of a block that act on any control.
pub(super) const M_CODES: u8 = 8;

/// Where the results of ASIN lie, in degrees.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum AsinRange {
    /// -90 to 90.
    AroundZero,
    /// 90 to 270.
    AroundHalfTurn,
    /// 270 to 360 and 0 to 90.
    WithinTurn,
}

/// The control's open points, as they are set, and its dialect.
#[derive(Debug)]
pub(super) struct Rules {
    /// A coordinate without a point counts millimetres, not increments.
    pub(super) whole_units: bool,
    /// A macro argument without a point counts increments.
    pub(super) argument_increments: bool,
    /// F0 is rapid traverse, not an alarm.
    pub(super) feed_zero_rapid: bool,
    /// ROUND in a word rounds to the step of its address, not to a whole number.
    pub(super) round_to_step: bool,
    /// S is rounded, not cut.
    pub(super) round_speed: bool,
    /// `#3004` switches the cutting override off.
    pub(super) suppress_override: bool,
    /// A local variable without argument keeps its last value.
    pub(super) keep_locals: bool,
    /// Common variables become vacant at reset.
    pub(super) clear_common: bool,
    /// What a program writes to an offset counts increments.
    pub(super) offset_increments: bool,
    /// M codes of a block that act.
    pub(super) m_codes: u8,
    /// One more is an alarm; else the last ones act.
    pub(super) m_alarm: bool,
    /// What stands in the place of threads per inch is a lead.
    pub(super) fine_lead: bool,
    /// A word of nothing but a vacant variable is 0, not left out.
    pub(super) vacant_word: bool,
    /// EQ and NE take vacant for 0.
    pub(super) vacant_equals_zero: bool,
    /// Least and largest magnitude of a result that is not 0.
    pub(super) result: (f64, f64),
    /// `ATAN[y]/[x]` lies within 0 to 360, not -180 to 180.
    pub(super) atan_turn: bool,
    pub(super) asin: AsinRange,
    /// What an axis moves per unit of its words: 0.5 where they count diameters.
    pub(super) moves: [f64; AXES],
    /// Axes that turn, and whose angles begin anew with each turn.
    pub(super) modulo: [bool; AXES],
    /// Limits of the working area hold the axes.
    pub(super) area: bool,
    /// Arcs may go on in the direction of the motion before.
    pub(super) tangents: bool,
    /// Where reference points and fixed point lie, in command increments, machine frame.
    pub(super) points: [[i64; AXES]; 2],
    /// M02 and M30 in a subprogram return.
    pub(super) ends_return: bool,
    /// Subprograms inside one another at most.
    pub(super) sub_depth: u8,
    /// The axis that is square to the spindle, for constant surface speed.
    pub(super) surface_axis: usize,
    /// What is added to the number of a user alarm to give the number that is shown.
    pub(super) user_alarm_base: Option<u32>,
    /// What the control does with its spindle.
    pub(super) spindle: SpindleRules,
    /// G codes in force at the start.
    pub(super) startup: Vec<CodeId>,
}

impl Rules {
    pub(super) fn new(control: &Control, switches: &Switches) -> Rules {
        let get = |id: &str| switches.get(control.switches, id);
        let is = |id: &str, setting: &str| get(id) == Some(setting);
        let mut startup = control.startup.to_vec();
        let groups = [Group::Distance, Group::Motion, Group::FeedUnit, Group::PathMode];
        let ids = ["startup-distance", "startup-motion", "startup-feed", "startup-path"];
        for (id, group) in ids.into_iter().zip(groups) {
            let number = get(id).and_then(|setting| setting.get(1..)).and_then(|number| number.parse().ok());
            let row = number.and_then(|number| control.code(CodeId::g(number)));
            startup.extend(row.filter(|row| row.group == group).map(|row| row.id));
        }
        let macros = &control.macros;
        let levels: Option<u8> = get("subprogram-levels").and_then(|levels| levels.parse().ok());
        let angles = get("angle-range").unwrap_or("");
        let square = control.axes.iter().position(|axis| axis.diameter).or(control.axis(b'X'));
        Rules {
            whole_units: is("decimal-point", "millimetres"),
            argument_increments: is("argument-point", "increments"),
            feed_zero_rapid: is("feed-zero", "rapid"),
            round_to_step: is("round-in-word", "to the step of the address"),
            round_speed: get("spindle-word").map_or(macros.round_words, |setting| setting == "round"),
            suppress_override: !is("override-suppression", "no"),
            keep_locals: is("locals-of-calls", "kept"),
            clear_common: is("common-at-reset", "vacant"),
            offset_increments: is("offset-values", "increments"),
            m_codes: if is("m-codes", "the last 3 act") { 3 } else { control.limits.m_codes.clamp(1, M_CODES) },
            m_alarm: is("m-codes", "alarm"),
            fine_lead: is("thread-e", "lead"),
            vacant_word: macros.vacant_word == VacantWord::Zero,
            vacant_equals_zero: macros.vacant_equals_zero,
            result: macros.value_range.unwrap_or((0.0, f64::MAX)),
            atan_turn: angles.contains("ATAN 0 to 360"),
            asin: if angles.contains("ASIN 90 to 270") {
                AsinRange::AroundHalfTurn
            } else if angles.contains("ASIN 270 to 90") {
                AsinRange::WithinTurn
            } else {
                AsinRange::AroundZero
            },
            moves: core::array::from_fn(|k| if control.counts_diameters(k, switches) { 0.5 } else { 1.0 }),
            modulo: core::array::from_fn(|k| control.raises(Alarm::PositiveWay) && control.is_rotary(k, switches)),
            area: !is("working-area", "limit not"),
            tangents: control.can(Code::ArcTangent),
            points: ["reference-point", "fixed-point"].map(|id| point(control, get(id).unwrap_or(""))),
            ends_return: get("end-in-subprogram").map_or(macros.ends_return, |setting| setting == "return"),
            sub_depth: levels.map_or(control.limits.sub_depth, |levels| levels.saturating_sub(1)),
            surface_axis: square.unwrap_or(0).min(AXES - 1),
            user_alarm_base: get("user-alarm-base").and_then(|base| base.parse().ok()).or(macros.user_alarm_base),
            spindle: control.spindle_rules(switches),
            startup,
        }
    }

    /// What an axis of a plane moves per unit of its words; see [`Rules::moves`].
    pub(super) fn moved(&self, axis: u8) -> f64 {
        self.moves.get(usize::from(axis)).copied().unwrap_or(1.0)
    }

    /// Where a point lies.
    pub(super) fn point(&self, point: Point) -> [i64; AXES] {
        self.points[usize::from(point == Point::Fixed)]
    }
}

/// A place as words, `X300 Z-50.5`, in command increments; axes that are not named stay at 0.
fn point(control: &Control, words: &str) -> [i64; AXES] {
    let mut place = [0; AXES];
    for word in words.split_ascii_whitespace() {
        let axis = word.bytes().next().and_then(|letter| control.axis(letter.to_ascii_uppercase()));
        let value = word.get(1..).and_then(number::read);
        if let (Some(slot), Some(value)) = (axis.and_then(|axis| place.get_mut(axis)), value) {
            *slot = (value / control.limits.increment).round() as i64;
        }
    }
    place
}

/// Ranges and roundings of words, in the numbers that the hot path needs.
#[derive(Debug)]
pub(super) struct Units {
    /// Decimals of a command increment: 3 for 0.001.
    pub(super) decimals: u8,
    /// Command increments per millimetre or degree.
    pub(super) per_unit: f64,
    /// Largest coordinate in increments.
    pub(super) coordinate_max: u64,
    /// Feed increments per mm/min.
    pub(super) per_feed: f64,
    /// Bit `letter & 31`: a word without a point counts increments.
    pub(super) increment_letters: u32,
    /// Bit `letter & 31`: what stands behind the point is dropped.
    pub(super) integer_letters: u32,
}

impl Units {
    pub(super) fn new(control: &Control) -> Units {
        let Limits { increment, coordinate_max, feed_increment, .. } = control.limits;
        let (mut decimals, mut per_unit) = (0, 1.0);
        while decimals < 9 && increment * per_unit < 0.999 {
            decimals += 1;
            per_unit *= 10.0;
        }
        Units {
            decimals,
            per_unit,
            coordinate_max: (coordinate_max * per_unit).round() as u64,
            per_feed: (1.0 / feed_increment).round(),
            increment_letters: letter_bits(control.syntax.increment_addresses.iter().copied()),
            integer_letters: letter_bits(control.syntax.integer_addresses.iter().copied()),
        }
    }
}

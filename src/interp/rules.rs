//! Rules of a run, from the rows and switches of a control: settings of open points, ranges, roundings.

use std::rc::Rc;

use super::canon::AXES;
use crate::controls::dialect::{NumberRules, RunningRules};
use crate::controls::macros::VacantWord;
use crate::controls::{Address, AddressSet, Alarm, Code, Control, Dialect, Limits, Point, SpindleRules};

/// Maximum effective M codes of a block on any control.
pub(super) const M_CODES: u8 = 8;

/// The control's dialect and the values derived from its rows for a run.
#[derive(Debug)]
pub(super) struct Rules {
    pub(super) dialect: Rc<Dialect>,
    /// Rules for counting and rounding numbers.
    pub(super) numbers: NumberRules,
    /// Rules for the execution of codes and calls.
    pub(super) running: RunningRules,
    /// A word of only a vacant variable is 0; otherwise the word is left out.
    pub(super) vacant_word: bool,
    /// EQ and NE treat vacant as 0.
    pub(super) vacant_equals_zero: bool,
    /// Least and largest magnitude of a result other than 0.
    pub(super) result: (f64, f64),
    /// Travel of each axis per unit of its words: 0.5 for words that count diameters.
    pub(super) moves: [f64; AXES],
    /// Rotary axes whose coordinates restart with each turn.
    pub(super) modulo: [bool; AXES],
    /// The control has tangential arcs (CT).
    pub(super) tangents: bool,
    /// Reference points, in command increments, machine frame.
    pub(super) reference_points: [i64; AXES],
    /// Fixed point, in command increments, machine frame.
    pub(super) fixed_point: [i64; AXES],
    /// The axis perpendicular to the spindle, for constant surface speed.
    pub(super) surface_axis: usize,
    /// Rules of the control for its spindle.
    pub(super) spindle: SpindleRules,
}

impl Rules {
    pub(super) fn new(control: &Control, dialect: &Rc<Dialect>) -> Rules {
        let macros = &control.macros;
        let diameter_axis = control.axes.iter().position(|axis| axis.diameter).or(control.axis(Address::X));
        let running = RunningRules { m_codes: dialect.running.m_codes.clamp(1, M_CODES), ..dialect.running };
        Rules {
            numbers: dialect.numbers,
            running,
            vacant_word: macros.vacant_word == VacantWord::Zero,
            vacant_equals_zero: macros.vacant_equals_zero,
            result: macros.value_range.unwrap_or((0.0, f64::MAX)),
            moves: core::array::from_fn(|k| 1.0 / dialect.words_per_mm(k)),
            modulo: core::array::from_fn(|k| control.raises(Alarm::PositiveWay) && dialect.is_rotary(k)),
            tangents: control.can(Code::ArcTangent),
            reference_points: point(control, &dialect.reference_points),
            fixed_point: point(control, &dialect.fixed_point),
            surface_axis: diameter_axis.unwrap_or(0).min(AXES - 1),
            spindle: dialect.spindle(),
            dialect: Rc::clone(dialect),
        }
    }

    /// Travel of an axis per unit of its words; see [`Rules::moves`].
    pub(super) fn moved(&self, axis: u8) -> f64 {
        self.moves.get(usize::from(axis)).copied().unwrap_or(1.0)
    }

    /// Position of a reference or fixed point.
    pub(super) fn point(&self, point: Point) -> [i64; AXES] {
        match point {
            Point::Reference => self.reference_points,
            Point::Fixed => self.fixed_point,
        }
    }
}

/// Coordinates by axis, in command increments. Of two for one axis the later one counts; axes not listed are at 0.
fn point(control: &Control, coordinates: &[(usize, f64)]) -> [i64; AXES] {
    let mut place = [0; AXES];
    for (axis, coordinate) in coordinates {
        if let Some(slot) = place.get_mut(*axis) {
            *slot = (coordinate / control.limits.increment).round() as i64;
        }
    }
    place
}

/// Ranges and roundings of words, precalculated for the hot path.
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
    /// Addresses whose words count increments without a point.
    pub(super) increment_letters: AddressSet,
    /// Addresses of integer words: decimals are dropped.
    pub(super) integer_letters: AddressSet,
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
            increment_letters: control.syntax.increment_addresses,
            integer_letters: control.syntax.integer_addresses,
        }
    }
}

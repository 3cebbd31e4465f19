//! Typed quantities: a number with a unit of its own, `4.5 in` or `15 m/min`, converted to the unit of its field.

use super::number;
use super::units::{self, FOOT, INCH};

/// A typed number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Typed {
    /// Without a unit, or in the one that is shown.
    Shown(f64),
    /// Converted to the field's unit from the one behind the number.
    Converted(f64),
}

/// Reads a typed number of a field in `metric`, with the field's unit behind it, another of the same quantity, or none. `None` for
/// anything else.
pub fn read(text: &str, metric: &str) -> Option<Typed> {
    if let Some(number) = number::read(text) {
        return Some(Typed::Shown(number));
    }
    let text = text.trim();
    if text.len() > LONGEST {
        return None;
    }
    let (own, shown) = (spelled(metric), spelled(units::unit(metric)));
    let known = SIZES.iter().find_map(|quantity| Some((quantity, size_of(quantity, &own)?)));
    text.char_indices().find_map(|(at, _)| {
        let (number, unit) = text.split_at_checked(at)?;
        let (number, unit) = (number::read(number)?, spelled(unit));
        if unit == shown {
            return Some(Typed::Shown(number));
        }
        let (quantity, own_size) = known?;
        Some(Typed::Converted(number * size_of(quantity, &unit)? / own_size))
    })
}

/// Maximum bytes of a number with its unit.
const LONGEST: usize = 64;

/// A unit as it is compared: small letters, powers as digits, nothing between its parts.
fn spelled(unit: &str) -> String {
    let plain = |c: char| match c {
        ' ' | '·' | '*' | '^' | '-' | '⁻' | '.' => None,
        '²' => Some('2'),
        '³' => Some('3'),
        '¹' => Some('1'),
        'µ' | 'μ' => Some('u'),
        '″' | '”' => Some('"'),
        '′' | '’' => Some('\''),
        other => Some(other),
    };
    unit.chars().filter_map(plain).flat_map(char::to_lowercase).collect()
}

fn size_of(quantity: &[(&str, f64)], spelled: &str) -> Option<f64> {
    quantity.iter().find(|(unit, _)| *unit == spelled).map(|(_, size)| *size)
}

/// Mass of a pound in kilograms, exact by the international agreement of 1959.
const POUND: f64 = 0.453_592_37;
/// Standard acceleration of free fall in m/s², exact (3rd CGPM, 1901).
const FREE_FALL: f64 = 9.806_65;
/// Weight of a pound in newtons.
const POUND_FORCE: f64 = POUND * FREE_FALL;

/// Units of each quantity, as [`spelled`], with their sizes in the first one. Units of temperature are missing, because their scales
/// begin at different points.
const SIZES: &[&[(&str, f64)]] = &[
    // Length.
    &[
        ("mm", 1.0),
        ("um", 0.001),
        ("cm", 10.0),
        ("m", 1000.0),
        ("in", INCH),
        ("\"", INCH),
        ("inch", INCH),
        ("ft", FOOT * 1000.0),
        ("'", FOOT * 1000.0),
    ],
    // Feed and surface speed.
    &[
        ("mm/min", 1.0),
        ("m/min", 1000.0),
        ("mm/s", 60.0),
        ("m/s", 60_000.0),
        ("in/min", INCH),
        ("ipm", INCH),
        ("in/s", INCH * 60.0),
        ("ft/min", FOOT * 1000.0),
        ("fpm", FOOT * 1000.0),
        ("sfm", FOOT * 1000.0),
    ],
    // Feed per revolution.
    &[("mm/rev", 1.0), ("mm/r", 1.0), ("in/rev", INCH), ("ipr", INCH)],
    // Rotational speed.
    &[("r/min", 1.0), ("rpm", 1.0), ("1/min", 1.0), ("min1", 1.0), ("r/s", 60.0), ("rps", 60.0)],
    // Time.
    &[("s", 1.0), ("ms", 0.001), ("us", 1e-6), ("min", 60.0)],
    // Angle.
    &[("°", 1.0), ("deg", 1.0), ("'", 1.0 / 60.0), ("rad", 180.0 / core::f64::consts::PI)],
    // Torque.
    &[
        ("nm", 1.0),
        ("ncm", 0.01),
        ("lbfin", POUND_FORCE * INCH / 1000.0),
        ("lbin", POUND_FORCE * INCH / 1000.0),
        ("inlb", POUND_FORCE * INCH / 1000.0),
        ("lbfft", POUND_FORCE * FOOT),
        ("lbft", POUND_FORCE * FOOT),
        ("ftlb", POUND_FORCE * FOOT),
    ],
    // Force.
    &[("n", 1.0), ("kn", 1000.0), ("kgf", FREE_FALL), ("kp", FREE_FALL), ("lbf", POUND_FORCE)],
    // Mass.
    &[("kg", 1.0), ("g", 0.001), ("t", 1000.0), ("lb", POUND)],
    // Moment of inertia.
    &[
        ("kgm2", 1.0),
        ("kgcm2", 1e-4),
        ("gcm2", 1e-7),
        ("lbin2", POUND * INCH * INCH * 1e-6),
        ("lbft2", POUND * FOOT * FOOT),
    ],
    // Power: the horsepower of 550 ft lbf/s, and the metric one of 75 kgf m/s.
    &[("kw", 1.0), ("w", 0.001), ("hp", 0.55 * FOOT * POUND_FORCE), ("ps", 0.075 * FREE_FALL)],
    // Pressure and strength.
    &[("n/mm2", 1.0), ("mpa", 1.0), ("bar", 0.1), ("psi", POUND_FORCE / (INCH * INCH))],
    // Voltage.
    &[("v", 1.0), ("mv", 0.001)],
    // Frequency.
    &[("hz", 1.0), ("khz", 1000.0)],
];

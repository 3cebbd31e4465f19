//! Shown units of length: the program's, or inches. Files, programs and `--json` always have millimetres.
//!
//! One system is shown at a time and per thread ([`show`]), like the language (`catalog`).

use std::cell::Cell;

use super::number::{self, Plain};
use crate::math;

/// A system of units for lengths, feeds and surface speeds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lengths {
    /// Millimetres, as in programs and on the control.
    Millimetres,
    /// Inches, and feet for surface speeds.
    Inches,
}

impl Lengths {
    /// All systems.
    pub const ALL: [Lengths; 2] = [Lengths::Millimetres, Lengths::Inches];

    /// Id in options and storage.
    pub fn id(self) -> &'static str {
        match self {
            Lengths::Millimetres => "mm",
            Lengths::Inches => "inch",
        }
    }

    /// The system with this id.
    pub fn of_id(id: &str) -> Option<Lengths> {
        Lengths::ALL.into_iter().find(|lengths| lengths.id() == id)
    }
}

thread_local! {
    static SHOWN: Cell<Lengths> = const { Cell::new(Lengths::Millimetres) };
}

/// Sets the shown system for this thread.
pub fn show(lengths: Lengths) {
    SHOWN.set(lengths);
}

/// The shown system.
pub fn shown() -> Lengths {
    SHOWN.get()
}

/// Calls `make` with millimetres as the shown system: for files of the control and of other programs.
pub fn in_millimetres<T>(make: impl FnOnce() -> T) -> T {
    let before = SHOWN.replace(Lengths::Millimetres);
    let made = make();
    show(before);
    made
}

/// A unit of length and its counterpart.
struct Unit {
    metric: &'static str,
    inch: &'static str,
    /// Metric units per counterpart.
    size: f64,
    /// Difference in decimals to the metric figure: 0.001 mm corresponds to 0.0001 in.
    decimals: i8,
}

const fn row(metric: &'static str, inch: &'static str, size: f64, decimals: i8) -> Unit {
    Unit { metric, inch, size, decimals }
}

/// Millimetres per inch, exact by the international agreement of 1959.
pub const INCH: f64 = 25.4;

/// Metres per foot, exact by the same agreement.
pub const FOOT: f64 = 0.3048;

/// Units with a counterpart. Angles, forces, torques, masses and pressures have none, because data sheets of drives and materials are
/// metric.
const UNITS: &[Unit] = &[
    row("mm", "in", INCH, 1),
    row("mm/min", "in/min", INCH, 1),
    row("mm/rev", "in/rev", INCH, 1),
    row("mm/s", "in/s", INCH, 1),
    row("mm/h", "in/h", INCH, 1),
    row("mm²", "in²", INCH * INCH, 2),
    row("1/mm", "1/in", 1.0 / INCH, -1),
    row("mm/m", "in/ft", INCH / FOOT, 1),
    row("µm", "µin", INCH / 1000.0, -1),
    row("µm/m", "µin/in", 1.0, 0),
    row("m", "ft", FOOT, 0),
    row("m/min", "ft/min", FOOT, 0),
    row("m/s²", "ft/s²", FOOT, 0),
];

/// The counterpart of a unit, if inches are shown.
fn counterpart(metric: &str) -> Option<&'static Unit> {
    (shown() == Lengths::Inches).then(|| UNITS.iter().find(|unit| unit.metric == metric)).flatten()
}

/// Metric units with a counterpart.
pub fn converted() -> impl Iterator<Item = &'static str> {
    UNITS.iter().map(|unit| unit.metric)
}

/// The shown unit for a metric one.
pub fn unit(metric: &str) -> &str {
    counterpart(metric).map_or(metric, |unit| unit.inch)
}

/// A number in the shown unit, from the metric one.
pub fn value(number: f64, metric: &str) -> f64 {
    counterpart(metric).map_or(number, |unit| number / unit.size)
}

/// A metric number with four digits, or all those before the point, in the shown unit, with the unit.
pub fn four_digits(number: f64, decimals: u8, metric: &str) -> String {
    format!("{} {}", number::four_digits(value(number, metric), self::decimals(decimals, metric)), unit(metric))
}

/// A number in the metric unit, from the shown one.
pub fn metric(number: f64, metric: &str) -> f64 {
    counterpart(metric).map_or(number, |unit| number * unit.size)
}

/// Decimals of a figure in the shown unit, from those in the metric one.
pub fn decimals(decimals: u8, metric: &str) -> u8 {
    counterpart(metric).map_or(decimals, |unit| decimals.saturating_add_signed(unit.decimals))
}

/// A number without its unit, with a maximum number of metric decimals.
pub fn plain(number: f64, places: u8, metric: &str) -> String {
    Plain(value(number, metric), decimals(places, metric)).to_string()
}

/// A number with its unit, with a maximum number of metric decimals: `8 mm`, `0.315 in`.
pub fn text(number: f64, places: u8, metric: &str) -> String {
    with_unit(&plain(number, places, metric), metric)
}

/// A figure on the screen with its unit, with a fixed number of metric decimals.
pub fn figure(number: f64, places: u8, metric: &str) -> String {
    with_unit(&number::figure(value(number, metric), decimals(places, metric)), metric)
}

/// A length in a drawing, with millimetres without their unit: `100`, `3.94 in`.
pub fn dimension(number: f64, places: u8) -> String {
    match shown() {
        Lengths::Millimetres => plain(number, places, "mm"),
        Lengths::Inches => text(number, places, "mm"),
    }
}

/// A number and its shown unit.
pub fn with_unit(number: &str, metric: &str) -> String {
    [number, unit(metric)].join(" ").trim_end().to_owned()
}

/// A step of a metric unit in the shown unit: a similar size, rounded to 1, 2 or 5 times a power of ten.
pub fn step(number: f64, metric: &str) -> f64 {
    let Some(unit) = counterpart(metric).filter(|_| number > 0.0) else { return number };
    let wanted = number / unit.size;
    let power = math::pow(10.0, math::log10(wanted).floor());
    let nice = [1.0, 2.0, 5.0].into_iter().find(|nice| wanted < 1.5 * nice * power);
    nice.unwrap_or(10.0) * power
}

/// Maximum decimals of an exact entry.
const MOST: u8 = 10;

/// An entry in the shown unit, with the fewest decimals that [`entered`] converts back unchanged.
pub fn exact(number: f64, places: u8, metric: &str) -> String {
    if counterpart(metric).is_none() {
        return Plain(number, places).to_string();
    }
    let shown = value(number, metric);
    let kept = Plain(number, places).to_string();
    let same = |text: &String| {
        let read = number::read(text).map(|read| entered(read, places, metric));
        read.is_some_and(|read| Plain(read, places).to_string() == kept)
    };
    let fewest = (0..MOST).map(|decimals| Plain(shown, decimals).to_string()).find(same);
    fewest.unwrap_or_else(|| Plain(shown, MOST).to_string())
}

/// The metric number of an entry in the shown unit, rounded to a number of decimals. A metric entry is unchanged.
pub fn entered(number: f64, places: u8, metric: &str) -> f64 {
    match counterpart(metric) {
        Some(unit) => number::rounded(number * unit.size, places),
        None => number,
    }
}

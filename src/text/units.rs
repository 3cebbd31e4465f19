//! Units of length as people read and type them: those of the program, or inches. Files, programs and `--json` have millimetres always.
//!
//! One system is shown at a time and per thread ([`show`]), as one language is spoken (`catalog`).

use std::cell::Cell;

use super::number::{self, Plain};
use crate::math;

/// A system of units for lengths, feeds and surface speeds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lengths {
    /// As the program and the control have them.
    Millimetres,
    /// Inches, and feet for surface speeds.
    Inches,
}

impl Lengths {
    /// Every system.
    pub const ALL: [Lengths; 2] = [Lengths::Millimetres, Lengths::Inches];

    /// Its id in options and stores.
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

/// Shows lengths in this system from now on, in this thread.
pub fn show(lengths: Lengths) {
    SHOWN.set(lengths);
}

/// The system that is shown.
pub fn shown() -> Lengths {
    SHOWN.get()
}

/// What a closure makes with lengths in millimetres, whatever is shown: files for the control and for other programs.
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
    /// Metric units in one of the other.
    size: f64,
    /// Decimals more than the metric figure has: where controls step 0.001 mm, they step 0.0001 in.
    decimals: i8,
}

const fn row(metric: &'static str, inch: &'static str, size: f64, decimals: i8) -> Unit {
    Unit { metric, inch, size, decimals }
}

/// Millimetres in an inch, and metres in a foot.
const INCH: f64 = 25.4;
const FOOT: f64 = 0.3048;

/// Units with a counterpart. Angles, forces, torques, masses and pressures have none: data sheets of drives and materials state them so.
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

/// The counterpart of a unit, where it is shown.
fn counterpart(metric: &str) -> Option<&'static Unit> {
    (shown() == Lengths::Inches).then(|| UNITS.iter().find(|unit| unit.metric == metric)).flatten()
}

/// Metric units that have a counterpart.
pub fn converted() -> impl Iterator<Item = &'static str> {
    UNITS.iter().map(|unit| unit.metric)
}

/// The unit that is shown for a metric one.
pub fn unit(metric: &str) -> &str {
    counterpart(metric).map_or(metric, |unit| unit.inch)
}

/// A number of a metric unit in the one that is shown.
pub fn value(number: f64, metric: &str) -> f64 {
    counterpart(metric).map_or(number, |unit| number / unit.size)
}

/// A number of the unit that is shown in the metric one.
pub fn metric(number: f64, metric: &str) -> f64 {
    counterpart(metric).map_or(number, |unit| number * unit.size)
}

/// Decimals of a figure of a metric unit in the one that is shown.
pub fn decimals(decimals: u8, metric: &str) -> u8 {
    counterpart(metric).map_or(decimals, |unit| decimals.saturating_add_signed(unit.decimals))
}

/// A number without its unit, with at most so many decimals of the metric one.
pub fn plain(number: f64, places: u8, metric: &str) -> String {
    Plain(value(number, metric), decimals(places, metric)).to_string()
}

/// A number with its unit, with at most so many decimals of the metric one: `8 mm`, `0.315 in`.
pub fn text(number: f64, places: u8, metric: &str) -> String {
    with_unit(&plain(number, places, metric), metric)
}

/// A number with its unit, with all of so many decimals, for figures on the screen.
pub fn figure(number: f64, places: u8, metric: &str) -> String {
    with_unit(&number::figure(value(number, metric), decimals(places, metric)), metric)
}

/// A length in a drawing, where millimetres stand without their unit: `100`, `3.94″`.
pub fn dimension(number: f64, places: u8) -> String {
    let mark = if shown() == Lengths::Inches { "″" } else { "" };
    [plain(number, places, "mm").as_str(), mark].concat()
}

/// A length with the shortest sign of its unit, where there is little room: `1 mm`, `0.0394″`.
pub fn short(number: f64, places: u8) -> String {
    match shown() {
        Lengths::Millimetres => text(number, places, "mm"),
        Lengths::Inches => dimension(number, places),
    }
}

/// A shown number and the unit behind it.
pub fn with_unit(number: &str, metric: &str) -> String {
    [number, unit(metric)].join(" ").trim_end().to_owned()
}

/// A step of a metric unit in the one that is shown: there near it, as 1, 2 or 5 of a power of ten.
pub fn step(number: f64, metric: &str) -> f64 {
    let Some(unit) = counterpart(metric).filter(|_| number > 0.0) else { return number };
    let wanted = number / unit.size;
    let power = math::pow(10.0, math::log10(wanted).floor());
    let nice = [1.0, 2.0, 5.0].into_iter().find(|nice| wanted < 1.5 * nice * power);
    nice.unwrap_or(10.0) * power
}

/// Decimals of an exact entry at most.
const MOST: u8 = 10;

/// An entry of at most so many metric decimals in the unit that is shown: with the fewest decimals that [`entered`] takes back unchanged.
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

/// The metric number of an entry in the unit that is shown, on the last of so many decimals. A metric entry stays as it is typed.
pub fn entered(number: f64, places: u8, metric: &str) -> f64 {
    match counterpart(metric) {
        Some(unit) => Plain(number * unit.size, places).to_string().parse().unwrap_or(number * unit.size),
        None => number,
    }
}

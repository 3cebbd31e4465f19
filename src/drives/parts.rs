//! Parts as data: servo and induction motors, amplifiers, inverters, gear units, brake resistors and encoders with ratings and evidence.

use super::servo::{Acceptance, Servo};
use super::shaft_motion::ResistorLoad;
use crate::text::{Citation, Grade};

/// A part for ordering.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Maker, as on its data sheets.
    pub maker: String,
    /// Series, for instance `HG-KN`; empty if unknown. It selects acceptance limits and the drive systems of a control.
    pub series: String,
    /// Order number or type: with the maker, the key of a part.
    pub model: String,
    /// Production status; `None` without a dated statement.
    pub status: Option<Status>,
    /// Ratings for its kind.
    pub ratings: Ratings,
    /// Models paired with it by the source, for instance the motors of an amplifier; empty if no pairing is known.
    pub fits: Vec<String>,
    /// Source of the ratings.
    pub evidence: Evidence,
}

/// Production status.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// In the maker's current programme.
    Current,
    /// Being phased out or out of production; new machines use its successor.
    PhasedOut,
    /// Made only for repair.
    SparePart,
}

impl Status {
    /// All values with their words in tables.
    pub const WORDS: [(&'static str, Status); 3] =
        [("current", Status::Current), ("phased out", Status::PhasedOut), ("spare part", Status::SparePart)];
}

/// Source and quality of a part's ratings.
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    /// Source; for parts of the shipped catalogue a key of `docs/reference/parts.md`.
    pub source: String,
    /// Quality of the source.
    pub grade: PartGrade,
    /// Remarks besides the ratings: conditions, contradictions, omissions.
    pub note: String,
}

/// Quality of the source of a part's ratings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum PartGrade {
    /// A page of the maker's manual.
    Manual,
    /// The maker's data sheet, catalogue page or web specification.
    DataSheet,
    /// A transcription by others, to be confirmed with the maker's data sheet before an order.
    Secondary,
    /// The user's own entry.
    Entered,
    /// Contradictory, or without a source.
    Open,
}

impl PartGrade {
    /// All values with their words in tables.
    pub const WORDS: [(&'static str, PartGrade); 5] = [
        ("manual", PartGrade::Manual),
        ("data sheet", PartGrade::DataSheet),
        ("secondary", PartGrade::Secondary),
        ("entered", PartGrade::Entered),
        ("open", PartGrade::Open),
    ];
}

/// Ratings by kind of part; `None` for a rating missing in the source.
#[derive(Debug, Clone, PartialEq)]
pub enum Ratings {
    /// A servo motor.
    Servo(ServoRatings),
    /// An induction motor.
    Induction(InductionRatings),
    /// An amplifier of servo motors.
    Amplifier(AmplifierRatings),
    /// An inverter of induction motors.
    Inverter(InverterRatings),
    /// A gear unit.
    Gear(GearRatings),
    /// A brake resistor.
    Resistor(ResistorRatings),
    /// An encoder of a spindle.
    Encoder(EncoderRatings),
}

/// Ratings of a servo motor, without brake.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ServoRatings {
    /// Rated power, W.
    pub rated_power: Option<f64>,
    /// Rated speed, r/min.
    pub rated_speed: Option<f64>,
    /// Highest speed, r/min.
    pub top_speed: Option<f64>,
    /// Torque at rated speed, Nm.
    pub rated_torque: Option<f64>,
    /// Continuous torque at standstill, Nm.
    pub stall_torque: Option<f64>,
    /// Short-time torque, Nm, of the combination of motor and amplifier.
    pub peak_torque: Option<f64>,
    /// Moment of inertia of the rotor, kg m².
    pub inertia: Option<f64>,
    /// Rated current, A.
    pub rated_current: Option<f64>,
    /// Highest current, A.
    pub peak_current: Option<f64>,
    /// Pulses of the encoder per revolution.
    pub encoder_pulses: Option<f64>,
}

impl ServoRatings {
    /// Current in A per Nm of torque at the rated point; in a permanent-magnet motor torque is proportional to current.
    pub fn ampere_per_torque(&self) -> Option<f64> {
        let (current, torque) = self.rated_current.zip(self.rated_torque.or(self.stall_torque))?;
        (torque > 0.0).then(|| current / torque)
    }
}

/// Ratings of an induction motor at its base frequency.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct InductionRatings {
    /// Rated power, W.
    pub rated_power: Option<f64>,
    /// Rated phase-to-phase voltage, V.
    pub voltage: Option<f64>,
    /// Rated speed, r/min.
    pub rated_speed: Option<f64>,
    /// Highest speed that its maker allows, r/min.
    pub top_speed: Option<f64>,
    /// Rated torque, Nm.
    pub rated_torque: Option<f64>,
    /// Moment of inertia of the rotor, kg m².
    pub inertia: Option<f64>,
    /// Rated current, A.
    pub rated_current: Option<f64>,
    /// Efficiency, 0 to 1.
    pub efficiency: Option<f64>,
}

/// Ratings of an amplifier of servo motors.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct AmplifierRatings {
    /// Rated power of its largest motor, W.
    pub rated_power: Option<f64>,
    /// Continuous output current, A.
    pub rated_current: Option<f64>,
    /// Highest output current, A.
    pub peak_current: Option<f64>,
    /// Efficiency of regeneration, 0 to 1: energy at the bus per energy returned at the shaft.
    pub regeneration_efficiency: Option<f64>,
    /// Energy that its capacitors can store, J.
    pub capacitor_energy: Option<f64>,
    /// Continuous power of its built-in brake resistor, W.
    pub brake_power: Option<f64>,
    /// Peak power of its built-in brake resistor, W.
    pub brake_peak_power: Option<f64>,
    /// Overload in the maker's words; may be empty.
    pub overload: String,
}

/// Ratings of an inverter of induction motors.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct InverterRatings {
    /// Rated power of its motor, W.
    pub rated_power: Option<f64>,
    /// Rated voltage of its motor and of its supply, V.
    pub voltage: Option<f64>,
    /// Rated output current, A.
    pub rated_current: Option<f64>,
    /// Output current that it gives for 3 s at least, % of the rated one.
    pub overload_percent: Option<f64>,
    /// Overload in the maker's words; may be empty.
    pub overload: String,
}

impl InverterRatings {
    /// Output current (A) that it gives for 3 s at least; none if rated current or overload is unknown.
    pub fn short_time_current(&self) -> Option<f64> {
        Some(self.rated_current? * self.overload_percent? / 100.0)
    }

    /// Whether the inverter can feed a motor, by all known values of power, current and voltage. 380 to 440 V are one class, 200 to 240 V
    /// another.
    pub fn feeds(&self, motor: &InductionRatings) -> bool {
        let known = |own: Option<f64>, its: Option<f64>, does: fn(f64, f64) -> bool| {
            own.zip(its).is_none_or(|(own, its)| does(own, its))
        };
        known(self.rated_power, motor.rated_power, |own, its| own >= its)
            && known(self.rated_current, motor.rated_current, |own, its| own >= its)
            && known(self.voltage, motor.voltage, |own, its| (own - its).abs() <= SAME_CLASS * own)
    }
}

/// Largest relative difference of voltages of one class.
const SAME_CLASS: f64 = 0.2;

/// Ratings of a gear unit. The output speed is the motor speed divided by the ratio.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct GearRatings {
    /// Input speed over output speed.
    pub ratio: Option<f64>,
    /// Rated torque at the output, Nm.
    pub rated_torque: Option<f64>,
    /// Highest torque at the output, Nm.
    pub peak_torque: Option<f64>,
    /// Rated speed at the input, r/min.
    pub rated_speed: Option<f64>,
    /// Highest speed at the input, r/min.
    pub top_speed: Option<f64>,
    /// Moment of inertia at the input, kg m².
    pub inertia: Option<f64>,
    /// Efficiency, 0 to 1.
    pub efficiency: Option<f64>,
    /// Backlash at the output, minutes of arc.
    pub backlash: Option<f64>,
}

/// Ratings of a brake resistor.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ResistorRatings {
    /// Continuous power, W.
    pub brake_power: Option<f64>,
    /// Peak power, W.
    pub brake_peak_power: Option<f64>,
    /// Energy of one stop, J.
    pub brake_energy: Option<f64>,
}

impl ResistorRatings {
    /// Whether the resistor can take a load. Its continuous power has to be known; peak power and stop energy are checked if known.
    pub fn takes(&self, asked: &ResistorLoad) -> bool {
        let keeps = |most: Option<f64>, value: f64| most.is_none_or(|most| value <= most);
        self.brake_power.is_some_and(|most| asked.mean <= most)
            && keeps(self.brake_peak_power, asked.peak)
            && keeps(self.brake_energy, asked.stop)
    }
}

/// Ratings of an encoder of a spindle.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct EncoderRatings {
    /// Pulses per revolution.
    pub pulses: Option<f64>,
    /// Highest speed, r/min.
    pub top_speed: Option<f64>,
}

/// Limits of a series of motors, with their source.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeriesLimits {
    /// Beginning of the series name; empty for all others.
    pub series: &'static str,
    /// The limits.
    pub limits: Acceptance,
    /// Source and grade.
    pub cite: Citation,
}

const FEED_AXIS: Citation =
    Citation::new("feed axis manual B-65262EN/03, p.60: inertia up to 3, 70 % of stall torque", Grade::Manual);

/// Limits by series; the last row is for all others. Source: sizing facts 2.3.
static ACCEPTANCE: [SeriesLimits; 6] = [
    row("MELDAS HC", 5.0, 0.8, Citation::new("MELDAS HC series manual, p.13 to 15: inertia up to 5", Grade::Manual)),
    row("HG-KN", 15.0, 0.8, Citation::new("web specification of the HG-KN motors: inertia up to 15", Grade::Manual)),
    row("alpha iS", 3.0, 0.7, FEED_AXIS),
    row("alpha iF", 3.0, 0.7, FEED_AXIS),
    row("beta iS", 3.0, 0.7, FEED_AXIS),
    row(
        "",
        10.0,
        0.8,
        Citation::new("general servo guides: inertia up to 10; shares of torque of MELDAS", Grade::Inferred),
    ),
];

const fn row(series: &'static str, inertia_ratio: f64, effective: f64, cite: Citation) -> SeriesLimits {
    SeriesLimits { series, limits: Acceptance { inertia_ratio, peak: 0.8, effective }, cite }
}

impl Part {
    /// Maker and model, for display.
    pub fn name(&self) -> String {
        format!("{} {}", self.maker, self.model)
    }

    /// Whether both rows are the same part, by maker and model.
    pub fn is(&self, other: &Part) -> bool {
        self.maker == other.maker && self.model == other.model
    }

    /// Ratings for checking a servo motor. Stall torque and rated torque replace each other, rated speed replaces the highest speed; `None`
    /// for other kinds, and if peak torque, rotor or speed is unknown.
    pub fn servo(&self) -> Option<Servo> {
        let Ratings::Servo(of) = &self.ratings else { return None };
        let rated_speed = of.rated_speed.or(of.top_speed)?;
        Some(Servo {
            rated: of.rated_torque.or(of.stall_torque)?,
            stall: of.stall_torque.or(of.rated_torque)?,
            peak: of.peak_torque?,
            rated_speed,
            top_speed: of.top_speed.unwrap_or(rated_speed),
            rotor: of.inertia?,
        })
    }

    /// Limits of its series.
    pub fn limits(&self) -> &'static SeriesLimits {
        let [own @ .., others] = &ACCEPTANCE;
        own.iter().find(|row| self.series.starts_with(row.series)).unwrap_or(others)
    }

    /// The acceptance limits of its series.
    pub fn acceptance(&self) -> Acceptance {
        self.limits().limits
    }
}

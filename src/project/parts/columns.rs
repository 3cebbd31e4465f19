//! The columns of a table of parts, and which of them each kind has.

use crate::drives::parts::Ratings;
use crate::drives::parts::{
    AmplifierRatings, EncoderRatings, GearRatings, InductionRatings, InverterRatings, ResistorRatings, ServoRatings,
};

/// The columns that each table has.
pub const REQUIRED: [&str; 3] = ["kind", "maker", "model"];

/// All columns in the order in which they are written.
pub const COLUMNS: [&str; 29] = [
    "kind",
    "maker",
    "series",
    "model",
    "status",
    "rated_power_w",
    "voltage_v",
    "rated_speed_rpm",
    "max_speed_rpm",
    "rated_torque_nm",
    "stall_torque_nm",
    "peak_torque_nm",
    "inertia_kgm2",
    "rated_current_a",
    "max_current_a",
    "encoder_pulses",
    "ratio",
    "efficiency",
    "backlash_arcmin",
    "capacitor_j",
    "regen_w",
    "peak_power_w",
    "brake_energy_j",
    "overload_percent",
    "overload",
    "fits",
    "source",
    "grade",
    "note",
];

/// The kinds of parts, as the column `kind` has them.
pub(super) const KINDS: [&str; 7] = ["servo", "induction", "amplifier", "inverter", "gear", "resistor", "encoder"];

/// Columns of shares, from above 0 to 1.
pub(super) const SHARES: [&str; 1] = ["efficiency"];

/// Columns of percentages, 100 or more.
pub(super) const PERCENTAGES: [&str; 1] = ["overload_percent"];

/// Columns of one kind or another that hold text.
pub(super) const OVERLOAD: &str = "overload";

/// The column of a name; capitals, spaces and dashes do not matter.
pub(super) fn column(name: &str) -> Option<&'static str> {
    let plain = name.trim().to_ascii_lowercase().replace([' ', '-'], "_");
    COLUMNS.into_iter().find(|column| *column == plain)
}

/// Empty ratings of a kind.
pub(super) fn ratings(kind: &str) -> Option<Ratings> {
    Some(match kind {
        "servo" => Ratings::Servo(ServoRatings::default()),
        "induction" => Ratings::Induction(InductionRatings::default()),
        "amplifier" => Ratings::Amplifier(AmplifierRatings::default()),
        "inverter" => Ratings::Inverter(InverterRatings::default()),
        "gear" => Ratings::Gear(GearRatings::default()),
        "resistor" => Ratings::Resistor(ResistorRatings::default()),
        "encoder" => Ratings::Encoder(EncoderRatings::default()),
        _ => return None,
    })
}

/// The kind of ratings.
pub fn kind(ratings: &Ratings) -> &'static str {
    match ratings {
        Ratings::Servo(_) => "servo",
        Ratings::Induction(_) => "induction",
        Ratings::Amplifier(_) => "amplifier",
        Ratings::Inverter(_) => "inverter",
        Ratings::Gear(_) => "gear",
        Ratings::Resistor(_) => "resistor",
        Ratings::Encoder(_) => "encoder",
    }
}

/// The numbers of a kind with their columns.
pub(super) fn numbers(ratings: &mut Ratings) -> Vec<(&'static str, &mut Option<f64>)> {
    match ratings {
        Ratings::Servo(of) => vec![
            ("rated_power_w", &mut of.rated_power),
            ("rated_speed_rpm", &mut of.rated_speed),
            ("max_speed_rpm", &mut of.top_speed),
            ("rated_torque_nm", &mut of.rated_torque),
            ("stall_torque_nm", &mut of.stall_torque),
            ("peak_torque_nm", &mut of.peak_torque),
            ("inertia_kgm2", &mut of.inertia),
            ("rated_current_a", &mut of.rated_current),
            ("max_current_a", &mut of.peak_current),
            ("encoder_pulses", &mut of.encoder_pulses),
        ],
        Ratings::Induction(of) => vec![
            ("rated_power_w", &mut of.rated_power),
            ("voltage_v", &mut of.voltage),
            ("rated_speed_rpm", &mut of.rated_speed),
            ("max_speed_rpm", &mut of.top_speed),
            ("rated_torque_nm", &mut of.rated_torque),
            ("inertia_kgm2", &mut of.inertia),
            ("rated_current_a", &mut of.rated_current),
            ("efficiency", &mut of.efficiency),
        ],
        Ratings::Amplifier(of) => vec![
            ("rated_power_w", &mut of.rated_power),
            ("rated_current_a", &mut of.rated_current),
            ("max_current_a", &mut of.peak_current),
            ("efficiency", &mut of.regeneration_efficiency),
            ("capacitor_j", &mut of.capacitor_energy),
            ("regen_w", &mut of.brake_power),
            ("peak_power_w", &mut of.brake_peak_power),
        ],
        Ratings::Inverter(of) => {
            vec![
                ("rated_power_w", &mut of.rated_power),
                ("voltage_v", &mut of.voltage),
                ("rated_current_a", &mut of.rated_current),
                ("overload_percent", &mut of.overload_percent),
            ]
        }
        Ratings::Gear(of) => vec![
            ("ratio", &mut of.ratio),
            ("rated_torque_nm", &mut of.rated_torque),
            ("peak_torque_nm", &mut of.peak_torque),
            ("rated_speed_rpm", &mut of.rated_speed),
            ("max_speed_rpm", &mut of.top_speed),
            ("inertia_kgm2", &mut of.inertia),
            ("efficiency", &mut of.efficiency),
            ("backlash_arcmin", &mut of.backlash),
        ],
        Ratings::Resistor(of) => vec![
            ("regen_w", &mut of.brake_power),
            ("peak_power_w", &mut of.brake_peak_power),
            ("brake_energy_j", &mut of.brake_energy),
        ],
        Ratings::Encoder(of) => vec![("encoder_pulses", &mut of.pulses), ("max_speed_rpm", &mut of.top_speed)],
    }
}

/// The overload of a kind that has one.
pub(super) fn overload(ratings: &mut Ratings) -> Option<&mut String> {
    match ratings {
        Ratings::Amplifier(of) => Some(&mut of.overload),
        Ratings::Inverter(of) => Some(&mut of.overload),
        _ => None,
    }
}

/// Whether a column holds numbers.
pub fn is_number(column: &str) -> bool {
    // The numeric columns are neighbours in the order of writing.
    COLUMNS
        .iter()
        .skip_while(|name| **name != "rated_power_w")
        .take_while(|name| **name != OVERLOAD)
        .any(|name| *name == column)
}

/// The columns of ratings that a kind has.
pub(super) fn of_kind(ratings: &Ratings) -> Vec<&'static str> {
    let mut ratings = ratings.clone();
    let mut columns: Vec<&'static str> = numbers(&mut ratings).into_iter().map(|(column, _)| column).collect();
    columns.extend(overload(&mut ratings).map(|_| OVERLOAD));
    columns
}

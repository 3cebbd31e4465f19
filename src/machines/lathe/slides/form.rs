//! The form of the slides of a lathe: mass, friction, screw and motor of each.

use crate::machines::driven::{FormMotor, MotorFields, motor_fields};
use crate::machines::form::Field;
use crate::machines::form::rows::{Member, TextMember, number, text};

/// Inputs of a slide. Units as in the form.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::machines) struct SlideParams {
    pub rapid: f64,
    pub clamp: f64,
    pub lead: f64,
    pub motor_teeth: f64,
    pub screw_teeth: f64,
    pub mass: f64,
    pub friction: f64,
    pub screw_diameter: f64,
    pub screw_length: f64,
    pub motor: String,
    pub rated: f64,
    pub stall: f64,
    pub peak: f64,
    pub rotor: f64,
    pub rated_speed: f64,
    pub top_speed: f64,
    pub inertia_limit: f64,
    pub effective_limit: f64,
    pub encoder: f64,
}

/// The groups of the fields: mechanics, and the motors of X and Z.
const GROUP: &str = "slides.group.mechanics";
pub(super) const MOTOR_GROUPS: [&str; 2] = ["slides.group.motor-x", "slides.group.motor-z"];

/// Catalog ids of the names of the drives.
pub(super) const NAMES: [&str; 2] = ["slides.drive.x", "slides.drive.z"];

/// Fields of the motors of X and Z.
pub(super) const FIELDS: [MotorFields; 2] =
    [motor_fields!("x", "encoder-counts-x"), motor_fields!("z", "encoder-counts-z")];

/// The motors as the form describes them.
pub(in crate::machines) const MOTORS: [FormMotor; 2] = [
    FormMotor {
        drive: "x",
        name: NAMES[0],
        is_on_inverter: false,
        figures: &[
            ("size.figure.rated-torque", "motor-rated-torque-x"),
            ("size.figure.peak-torque", "motor-peak-x"),
            ("size.figure.rated-speed", "motor-rated-x"),
            ("size.figure.rotor", "motor-rotor-x"),
        ],
    },
    FormMotor {
        drive: "z",
        name: NAMES[1],
        is_on_inverter: false,
        figures: &[
            ("size.figure.rated-torque", "motor-rated-torque-z"),
            ("size.figure.peak-torque", "motor-peak-z"),
            ("size.figure.rated-speed", "motor-rated-z"),
            ("size.figure.rotor", "motor-rotor-z"),
        ],
    },
];

/// Defines a function for a row of a fact: help, unit, range, decimals and step are the same for each slide; id, label
/// and default are arguments.
macro_rules! fact {
    ($(#[$doc:meta])* $name:ident: $help:literal, $unit:literal, $range:expr, $decimals:literal, $step:literal) => {
        $(#[$doc])*
        pub(super) const fn $name<P>(
            id: &'static str,
            label: &'static str,
            default: f64,
            member: Member<P, f64>,
        ) -> Field<P> {
            let row = number(id, member).group(GROUP).label(label).help($help);
            row.unit($unit).range($range).default(default).decimals($decimals).step($step).fact()
        }
    };
}

fact!(
    /// A field for the mass that a slide moves.
    mass: "slides.mass.help", "kg", 0.1..=20_000.0, 1, 10.0
);
fact!(
    /// A field for the friction along a way.
    friction: "slides.friction.help", "N", 0.0..=100_000.0, 0, 10.0
);
fact!(
    /// A field for the diameter of a screw.
    screw_diameter: "slides.screw.help", "mm", 4.0..=200.0, 1, 1.0
);
fact!(
    /// A field for the length of a screw.
    screw_length: "slides.screw.help", "mm", 10.0..=20_000.0, 0, 50.0
);
fact!(
    /// A field for the rated torque of a motor.
    rated: "slides.motor-rated-torque.help", "Nm", 0.001..=10_000.0, 3, 0.1
);
fact!(
    /// A field for the stall torque of a motor.
    stall: "slides.motor-stall.help", "Nm", 0.001..=10_000.0, 3, 0.1
);
fact!(
    /// A field for the peak torque of a motor.
    peak: "slides.motor-peak.help", "Nm", 0.001..=10_000.0, 3, 0.1
);
fact!(
    /// A field for the inertia of a rotor.
    rotor: "slides.motor-rotor.help", "kg cm²", 0.01..=100_000.0, 4, 0.1
);
fact!(
    /// A field for the rated speed of a motor.
    rated_speed: "slides.motor-rated.help", "r/min", 1.0..=100_000.0, 1, 100.0
);
fact!(
    /// A field for the highest speed of a motor.
    top_speed: "slides.motor-max.help", "r/min", 1.0..=100_000.0, 1, 100.0
);

/// A field for maker and model of a motor.
pub(super) const fn motor<P>(id: &'static str, label: &'static str, member: TextMember<P>) -> Field<P> {
    text(id, member).group(GROUP).label(label).help("slides.motor.help").characters(40)
}

/// A field for the greatest ratio of inertias.
pub(super) const fn inertia_limit<P>(id: &'static str, label: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number(id, member).group(GROUP).label(label).help("slides.inertia-limit.help");
    row.unit(": 1").range(0.1..=1000.0).default(5.0).decimals(1).step(1.0).setting()
}

/// A field for the share of the stall torque that the effective torque may take.
pub(super) const fn effective_limit<P>(id: &'static str, label: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number(id, member).group(GROUP).label(label).help("slides.effective-limit.help");
    row.unit("%").range(1.0..=100.0).default(80.0).decimals(1).step(1.0).setting()
}

/// A field for the angle of the way of X.
pub(super) const fn bed_angle<P>(member: Member<P, f64>) -> Field<P> {
    let row = number("bed-angle", member).group(GROUP).label("slides.bed-angle").help("slides.bed-angle.help");
    row.symbol("α").unit("°").range(0.0..=90.0).default(0.0).decimals(1).step(5.0).fact()
}

/// A field for the efficiency of the screws.
pub(super) const fn efficiency<P>(member: Member<P, f64>) -> Field<P> {
    let row = number("screw-efficiency", member).group(GROUP);
    let row = row.label("slides.screw-efficiency").help("slides.screw-efficiency.help").symbol("η");
    row.unit("%").range(1.0..=100.0).default(90.0).decimals(0).step(1.0).fact()
}

/// A field for the force against the feed, as a share of the cutting force.
pub(super) const fn feed_force<P>(member: Member<P, f64>) -> Field<P> {
    let row = number("feed-force", member).group(GROUP).label("slides.feed-force").help("slides.feed-force.help");
    row.unit("%").range(0.0..=300.0).default(50.0).decimals(0).step(5.0).fact()
}

//! The drives of a machine as it is sized: motors and gears with their loads, devices, axis scaling, and quantities checked in operation.

mod axis;
pub mod devices;
mod fields;
mod gauges;
mod gear;
mod inverter;
mod resistor;
pub mod scaling;
pub mod site;
mod spindle;
pub(super) mod spindle_encoder;

pub use axis::{DrivenAxis, speed_segments};
pub(super) use fields::motor_fields;
pub use fields::{FormMotor, InductionFields, MotorFields};
pub use gauges::{CoastedAxes, Gauge, GaugeRow, ProductSize, read};
pub use gear::{FormGear, GearFields};
pub use inverter::{FullSignal, InverterCycle, InverterDrive};
pub use resistor::{ResistorDemand, WITHOUT_RESISTOR};
pub use spindle::{SpindleEncoder, SpindleRun};

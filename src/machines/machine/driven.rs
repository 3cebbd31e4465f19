//! The drives of a prepared machine for the sizing: motors with their demand in a run, devices, and the pauses of the shift.

use super::samples::Samples;
use crate::machines::driven::devices::AskedDevice;
use crate::machines::driven::site::SevereSite;
use crate::machines::driven::{
    CoastedAxes, DrivenAxis, Gauge, InverterDrive, ProductSize, ResistorDemand, SpindleEncoder, SpindleRun,
};
use crate::motion::RunSegment;
use crate::text::Message;

/// Lowest position (%) of the override knob of the spindle at which a machine is judged: at 0 % nothing moves. Engineering choice.
pub const LOWEST_KNOB: f64 = 10.0;

/// The drives of a machine. Each default is that of a machine without the drive. All functions are total.
pub trait DrivenMachine {
    /// The servo motors for the sizing.
    fn driven_axes(&self) -> Vec<DrivenAxis> {
        Vec::new()
    }
    /// The motor on the inverter, for the sizing; none if the machine has none, or if its demand is unknown.
    fn inverter_drive(&self) -> Option<InverterDrive> {
        None
    }
    /// The motor of a main spindle in these segments of a run, with the torques of its cut; none for other drives.
    fn spindle_run(&self, _run: &dyn Samples, _segments: &[RunSegment]) -> Option<SpindleRun> {
        None
    }
    /// Demand on the brake resistor of the spindle's inverter in these segments of a run, if the form's braking torque
    /// needs a resistor. Resistors of servo amplifiers are sized with their motors.
    fn resistor_demand(&self, _run: &dyn Samples, _segments: &[RunSegment]) -> Option<ResistorDemand> {
        None
    }
    /// Highest position (%) of the feed override, and the machine as it cuts there; none where the knob does not act on
    /// the cut, or ends at 100 %.
    fn with_highest_feed(&self) -> Option<(f64, &dyn DrivenMachine)> {
        None
    }
    /// The encoder of the spindle, if it has one of its own; a servo motor includes its encoder.
    fn spindle_encoder(&self) -> Option<SpindleEncoder> {
        None
    }
    /// Abilities that the inverter of the spindle needs besides its ratings, as open points of its order.
    fn inverter_abilities(&self) -> Vec<Message> {
        Vec::new()
    }
    /// Devices that the form's options need, and sensors with a known place, with their requirements.
    fn devices(&self) -> Vec<AskedDevice> {
        Vec::new()
    }
    /// The site of the drives, if it is higher or warmer than the data sheets of amplifiers and inverters allow.
    fn severe_site(&self) -> Option<SevereSite> {
        None
    }
    /// The axes that coast at a power failure by the formulas of the machine, beside a spindle that coasts in the run.
    fn without_supply(&self) -> Option<CoastedAxes> {
        None
    }
    /// Whether an emergency stop leaves the axes that the PLC turns to coast without current.
    fn coasts_at_emergency_stop(&self) -> bool {
        false
    }
    /// Spans (s) of a run in which the motors of the axes carry the torque of their work; none if they always do.
    fn working(&self, _run: &dyn Samples, _until: f64) -> Option<Vec<(f64, f64)>> {
        None
    }
    /// Pause (s) from the end of a run to the next start, in the pattern of the shift.
    fn pause(&self) -> f64 {
        0.0
    }
    /// Highest position (%) of the spindle override that the PLC of the machine passes on.
    fn highest_knob(&self) -> f64 {
        f64::INFINITY
    }
    /// Lowest position (%) of the spindle override at which the machine is operated.
    fn lowest_knob(&self) -> f64 {
        LOWEST_KNOB
    }
    /// Mean time (s) of a part beside its run from rest and the pause: changes of material, ways back to where the run begins.
    fn time_between_parts(&self) -> f64 {
        0.0
    }
    /// Whether the first part of a series takes another time than each further one: its program changes what stays, such as a gear stage.
    fn first_part_differs(&self) -> bool {
        false
    }
    /// Variable and present value of the product's size, if the program accepts another size while the machine runs.
    fn product_size(&self) -> Option<ProductSize> {
        None
    }
    /// Quantities checked during operation: their worst values in a part of a run, sampled at `points` times.
    fn gauges(&self, _run: &dyn Samples, _span: (f64, f64), _points: usize) -> Vec<Gauge> {
        Vec::new()
    }
}

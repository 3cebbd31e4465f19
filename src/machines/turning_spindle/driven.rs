//! Drives that the turning spindle is sized by: its motor behind inverter and gear, and its speed against the limit of the chuck.

use super::resolved::TurningSpindle;
use super::run_up;
use crate::drives::inertia;
use crate::drives::load::{Load, Move, power, through_gear};
use crate::machines::driven::{GaugeRow, InverterCycle, InverterDrive, ResistorDemand, SpindleEncoder};
use crate::math::RPM;
use crate::view::Limit;

/// The spindle's motor: the cut at the largest diameter, where it asks the greatest torque, between run-up and stop over the ramp; none where
/// nothing is known of the cutting force.
pub(super) fn inverter(lathe: &TurningSpindle) -> Option<InverterDrive> {
    let (p, d) = (&lathe.p, &lathe.d);
    if p.cutting_force <= 0.0 || d.stage_speed <= 0.0 {
        return None;
    }
    let gear = p.motor_top / d.stage_speed;
    Some(InverterDrive {
        id: "spindle",
        name: "turning.drive.spindle",
        torque: through_gear(d.torque, gear, p.efficiency / 100.0),
        speed: d.speed_largest * gear,
        // The inverter is set for it at 10 V, whatever the program asks.
        top_speed: p.motor_top,
        site_share: p.site_share / 100.0,
        brake: 0.0,
        cycle: (p.spindle_ramp > 0.0).then(|| cycle(lathe, gear)),
        turn: gear * RPM,
        turned: turned(lathe, gear),
        rotor: p.rotor_inertia,
        work: cut_energy(lathe, gear),
        // Stages of the headstock.
        gear: None,
        fields: None,
    })
}

/// Energy (J) at the motor that the cuts of a part take: their power at the largest diameter, which is the greatest of all, over their time.
fn cut_energy(lathe: &TurningSpindle, gear: f64) -> f64 {
    let (p, d) = (&lathe.p, &lathe.d);
    let torque = through_gear(d.torque, gear, p.efficiency / 100.0);
    let energy = power(torque, d.speed_largest * gear * RPM) * d.cutting_time;
    if energy.is_finite() { energy } else { 0.0 }
}

/// Chuck and work at the motor, against the friction of the spindle.
fn turned(lathe: &TurningSpindle, gear: f64) -> Load {
    let (p, efficiency) = (&lathe.p, lathe.p.efficiency / 100.0);
    Load {
        inertia: inertia::through_gear(p.spindle_inertia + p.work_inertia(), gear),
        torque: through_gear(p.spindle_friction, gear, efficiency),
        efficiency,
    }
}

/// Run-up to the highest speed and stop, with the cut between them, behind a gear of motor speed over spindle speed.
fn cycle(lathe: &TurningSpindle, gear: f64) -> InverterCycle {
    let (p, d) = (&lathe.p, &lathe.d);
    let (load, highest) = (turned(lathe, gear), run_up::highest(lathe));
    let ramp = p.spindle_ramp * highest / d.stage_speed;
    let of = Move { speed: highest * gear * RPM, ramp, run: d.cutting_time, pause: p.pause, hold: 0.0 };
    InverterCycle { load, rotor: Some(p.rotor_inertia), of, peak: [p.motor_peak / 100.0, p.motor_braking / 100.0] }
}

/// Braking torque (% of the rated one) that an inverter takes back without a brake resistor. Source: turning spindle facts, 5.
const WITHOUT_RESISTOR: f64 = 20.0;

/// The brake resistor that the form's braking torque assumes: the energy of a stop, over run-up, cut, stop and pause.
pub(super) fn resistor(lathe: &TurningSpindle) -> Option<ResistorDemand> {
    let (p, d) = (&lathe.p, &lathe.d);
    let energy = run_up::stop_energy(lathe);
    let cycle = 2.0 * p.spindle_ramp * run_up::highest(lathe) / d.stage_speed + d.cutting_time + p.pause;
    let power = if cycle > 0.0 { energy / cycle } else { 0.0 };
    let asked = ResistorDemand { name: "turning.drive.spindle", percent: p.motor_braking, energy, power };
    (p.motor_braking > WITHOUT_RESISTOR && energy > 0.0).then_some(asked)
}

/// The encoder of the spindle: the control counts the speed by it in every gear stage.
pub(super) fn encoder(lathe: &TurningSpindle) -> SpindleEncoder {
    SpindleEncoder { name: "turning.drive.spindle", speed: run_up::highest(lathe) }
}

/// Quantity checked during operation: the speed of the spindle.
pub(super) const GAUGES: &[GaugeRow<TurningSpindle>] = &[GaugeRow {
    id: "speed",
    label: "turning.gauge.speed",
    unit: "r/min",
    decimals: 1,
    limit: |lathe| Some(Limit::AtMost(lathe.p.chuck_limit)),
    field: None,
    value: |_, now| now.spindle.actual.abs(),
}];

//! What the turning spindle is sized by: its motor behind inverter and gear, and its speed against the chuck's.

use super::resolved::TurningSpindle;
use crate::drives::load::through_gear;
use crate::machines::driven::{GaugeRow, InverterDrive};
use crate::view::Limit;

/// The spindle's motor at the largest diameter, where the cut asks the greatest torque; none where nothing is known of the cutting force.
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
        brake: 0.0,
        fields: None,
    })
}

/// What is watched: the speed of the spindle.
pub(super) const GAUGES: &[GaugeRow<TurningSpindle>] = &[GaugeRow {
    id: "speed",
    label: "turning.gauge.speed",
    unit: "r/min",
    decimals: 1,
    limit: |lathe| Some(Limit::AtMost(lathe.p.chuck_limit)),
    field: None,
    value: |_, now| now.spindle.actual.abs(),
}];

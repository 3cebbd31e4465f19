//! What the polygon lathe is sized by: the motors of work and tool, and their phase.

use super::demand::Asked;
use super::load::Spindle;
use super::resolved::{PolygonLathe, TOOL, WORK};
use crate::drives::load::{Load, through_gear};
use crate::machines::driven::{DrivenAxis, Fitted, GaugeRow};
use crate::math::PI;
use crate::motion::Mover;

/// The motors of work and tool, as if each cut at the greatest mean torque for as long as it turns.
pub(super) fn axes(lathe: &PolygonLathe) -> Vec<DrivenAxis> {
    let axis = |id, name, at, spindle: Spindle, (motor_teeth, teeth): (f64, f64)| {
        let p = &lathe.p;
        // Motor speed over spindle speed.
        let (gear, efficiency) = (teeth / motor_teeth, p.drive_efficiency / 100.0);
        let (rated, most) = p.torques(spindle);
        let torque = lathe.demand(spindle, Asked::Mean).0;
        // The form's torques and inertia stand behind the gear, with the rotor; losses of the gear are in the torques.
        let at_motor = |torque: f64| torque / (gear * efficiency);
        DrivenAxis {
            id,
            name,
            mover: Mover::Turned(at),
            turn: gear * PI / 180.0,
            load: Load {
                inertia: p.drive(spindle).inertia / (gear * gear),
                torque: through_gear(torque, gear, efficiency),
                efficiency,
            },
            hold: 0.0,
            fitted: Fitted { rotor: 0.0, peak: at_motor(most), effective: at_motor(rated) },
            fields: None,
        }
    };
    let p = &lathe.p;
    vec![
        axis("work", "polygon.drive.work", WORK, Spindle::Work, (p.work_motor_teeth, p.work_teeth)),
        axis("tool", "polygon.drive.tool", TOOL, Spindle::Tool, (p.tool_motor_teeth, p.tool_teeth)),
    ]
}

/// What is watched: how far the tool is ahead of its ratio to the work.
pub(super) const GAUGES: &[GaugeRow<PolygonLathe>] = &[GaugeRow {
    id: "phase",
    label: "polygon.gauge.phase",
    unit: "°",
    decimals: 3,
    limit: |_| None,
    value: |lathe, now| lathe.phase(now).abs(),
}];

//! The drives of the ribbon line for the sizing: motors of pull roller, print roller and unwinder; loop and tension of the web as gauges.

use super::mechanics::{ServoAxis, unwinder_load};
use super::pose::LineState;
use super::resolved::RibbonLine;
use super::tension_switch::TensionSwitch;
use super::unwinder_motor::SHORT_TIME;
use super::variables::PITCH;
use crate::drives::ShortTime;
use crate::drives::load::{Load, Move};
use crate::drives::shaft_motion::Strikes;
use crate::machines::driven::{
    DrivenAxis, FormGear, FullSignal, GaugeRow, GearFields, InductionFields, InverterCycle, InverterDrive, MotorFields,
    ProductSize, ResistorDemand, SpindleEncoder, WITHOUT_RESISTOR, motor_fields,
};
use crate::math::{PI, RPM};
use crate::motion::{Mover, Snapshot};
use crate::view::Limit;

/// Fields of the motor of the pull roller.
const PULL: MotorFields = motor_fields!("x", "encoder-resolution-x");

/// Fields of the motor of the print roller.
const PRINT: MotorFields = motor_fields!("y", "encoder-resolution-y");

/// Fields of the motor of the unwinder.
const UNWINDER: InductionFields = InductionFields {
    name: "unwinder-motor",
    rated: "unwinder-torque-rated",
    load: "unwinder-load",
    frequency: "frequency-at-10v",
    rated_speed: "rated-load-speed",
};

/// Fields of the gear unit of the pull roller.
const PULL_GEAR: GearFields =
    GearFields { efficiency: "efficiency-x", inertia: Some("gear-inertia-x"), backlash: Some("gear-backlash") };

/// Fields of the gear unit of the print roller.
const PRINT_GEAR: GearFields =
    GearFields { efficiency: "efficiency-y", inertia: Some("gear-inertia-y"), backlash: Some("gear-backlash") };

/// Fields of the gear unit of the unwinder. Its inertia is in that of the form.
const UNWINDER_GEAR: GearFields = GearFields { efficiency: "unwinder-efficiency", inertia: None, backlash: None };

/// The servo motors.
pub(super) fn axes(line: &RibbonLine) -> Vec<DrivenAxis> {
    let p = &line.params;
    let per_turn = |diameter: f64| PI * diameter;
    let print_turn = if line.degrees() { 360.0 } else { per_turn(p.print_roller_diameter) };
    let gear = |ratio: f64, of: &ServoAxis, fields| FormGear {
        ratio,
        output: of.output,
        standstill_torque: of.hold * ratio,
        taut_torque: of.output_taut.abs(),
        backlash: of.reverses(p.path_mode).then_some(p.gear_backlash),
        fields,
    };
    let axis = |id, name, at, (ratio, turn): (f64, f64), of: &ServoAxis, (fields, gear_fields)| DrivenAxis {
        id,
        name,
        mover: Mover::Axis(at),
        radians_per_unit: 2.0 * PI * ratio / turn,
        load: of.load,
        standstill_torque: of.hold,
        weight: 0.0,
        strikes: Strikes::default(),
        taut_torque: of.taut.abs(),
        cut: None,
        continuous_cut_torque: None,
        starts_per_minute: 0.0,
        gear: is_geared(ratio).then(|| gear(ratio, of, gear_fields)),
        fitted: of.fitted,
        site_share: p.site().share(),
        fields: Some(fields),
    };
    let m = &line.mechanics;
    vec![
        axis(
            "x",
            "ribbon.drive.pull",
            line.pull(),
            (p.axes.pull.gear, per_turn(p.x_roller_diameter)),
            &m.axes.pull,
            (&PULL, PULL_GEAR),
        ),
        axis(
            "y",
            "ribbon.drive.print",
            line.print(),
            (p.axes.print.gear, print_turn),
            &m.axes.print,
            (&PRINT, PRINT_GEAR),
        ),
    ]
}

/// Whether there is a gear unit: at ratio 1 the motor is on the roller's shaft.
fn is_geared(ratio: f64) -> bool {
    ratio != 1.0
}

/// The unwinder's gear unit. The inertia at its output is the form's, which includes the rotor, so that the demand on its teeth is
/// overestimated, never underestimated. A ribbon pulled taut drives the press roller forwards, against brake and friction.
fn unwinder_gear(line: &RibbonLine) -> FormGear {
    let pulled = line.mechanics.tautest * line.params.press_roller_diameter / 2e3 - line.mechanics.unwound;
    let ratio = line.params.reduction_ratio;
    let load = unwinder_load(&line.params, line.mechanics.unwinder);
    let output = Load { inertia: load.inertia * ratio * ratio, torque: line.mechanics.unwound, efficiency: 1.0 };
    FormGear {
        ratio,
        output,
        standstill_torque: 0.0,
        taut_torque: pulled.max(0.0),
        backlash: None,
        fields: UNWINDER_GEAR,
    }
}

/// Run-up and stop of the unwinder over the inverter's ramp, with a product between them, at the fastest position of the knob.
fn unwinder_cycle(line: &RibbonLine) -> InverterCycle {
    let (p, speed) = (&line.params, line.fast.unwinder.actual);
    let ramp = p.ramp_to(speed);
    InverterCycle {
        load: unwinder_load(p, line.mechanics.unwinder),
        // The inertia of the form includes the rotor.
        rotor: None,
        motion: Move { speed: speed * RPM, ramp, seconds_at_speed: line.fast.product.time, pause: p.pause, hold: 0.0 },
        short_time: ShortTime { driving: SHORT_TIME, braking: p.unwinding.motor_braking / 100.0 },
    }
}

/// The unwinder: its steady torque at the fastest position of the knob, with the upward trim of a dancer.
pub(super) fn inverter(line: &RibbonLine) -> InverterDrive {
    let speed = line.fast.unwinder.actual * line.trimmed_up();
    InverterDrive {
        id: "unwinder",
        name: "ribbon.drive.unwinder",
        torque: line.mechanics.unwinder,
        speed,
        top_speed: speed,
        site_share: line.params.unwinding.site_share / 100.0,
        brake: line.params.unwinding.motor_brake,
        cycle: Some(unwinder_cycle(line)),
        radians_per_rpm: RPM,
        load_at_motor: unwinder_load(&line.params, line.mechanics.unwinder),
        rotor: 0.0,
        gear: is_geared(line.params.reduction_ratio).then(|| unwinder_gear(line)),
        full: Some(FullSignal { frequency: line.params.frequency_at_10v, no_load: line.params.no_load_speed }),
        cooled_at: (!line.params.unwinding.forced_cooling).then_some(line.slow.unwinder.actual),
        fields: Some(&UNWINDER),
    }
}

/// The brake resistor of the unwinder's inverter: the energy of a stop, `T ω t / 2`, over a product and its pause, with the knob at its
/// highest position.
pub(super) fn resistor(line: &RibbonLine) -> Option<ResistorDemand> {
    let (p, speed, torque) = (&line.params, line.fast.unwinder.actual, line.mechanics.unwinder_braking);
    let ramp = p.ramp_to(speed);
    let energy = 0.5 * torque * speed * RPM * ramp;
    let cycle = line.fast.product.time + p.pause;
    let is_asked = torque > WITHOUT_RESISTOR / 100.0 * p.unwinding.torque && energy > 0.0 && cycle.is_finite();
    is_asked.then(|| ResistorDemand {
        name: "ribbon.drive.unwinder",
        percent: p.unwinding.motor_braking,
        energies: vec![energy],
        cycle,
    })
}

/// The encoder of the unwinder's motor, where the form has one.
pub(super) fn encoder(line: &RibbonLine) -> Option<SpindleEncoder> {
    let of = &line.params.encoder;
    let speed = line.fast.unwinder.actual * of.ratio();
    line.params.spindle_encoder.then_some(SpindleEncoder { name: "ribbon.drive.unwinder", speed, lines: of.lines })
}

/// The pitch, which the program reads before each block.
pub(super) fn pitch(line: &RibbonLine) -> ProductSize {
    ProductSize { variable: PITCH, size: line.params.pitch }
}

/// Gauges: greatest and least ribbon in the loop, and tension while the loop is empty.
pub(super) const GAUGES: &[GaugeRow<RibbonLine>] = &[
    GaugeRow {
        id: "loop",
        label: "ribbon.gauge.loop",
        unit: "mm",
        decimals: 1,
        limit: |line| Some(Limit::AtMost(line.params.loop_capacity)),
        field: Some("loop-capacity"),
        value: |line, now| LineState::new(line, now).slack,
    },
    GaugeRow {
        id: "loop-least",
        label: "ribbon.gauge.loop-least",
        unit: "mm",
        decimals: 1,
        limit: |line| Some(Limit::AtLeast(-TensionSwitch::new(line).missing)),
        field: None,
        value: |line, now| LineState::new(line, now).slack,
    },
    GaugeRow {
        id: "tension",
        label: "ribbon.gauge.tension",
        unit: "N",
        decimals: 2,
        limit: |line| Some(Limit::AtMost(TensionSwitch::new(line).tension)),
        field: None,
        value: tension,
    },
];

/// Tension of the web in N: by the brake, and with an empty loop also by the stretch for the missing length.
fn tension(line: &RibbonLine, now: &Snapshot) -> f64 {
    line.params.tension_with_missing((-LineState::new(line, now).slack).max(0.0))
}

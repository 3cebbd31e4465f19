//! Drives that a machine is sized by: the servo motors of its axes, the motor on its inverter, and quantities checked during operation.

use crate::drives::ShortTime;
use crate::drives::holding_brake;
use crate::drives::load::{Load, Move, Phase};
use crate::drives::servo::FittedMotor;
use crate::drives::shaft_motion::{CutSpan, Motion, OperatingPoint, SpeedSegment, Strikes};
use crate::drives::spindle_motor::MotorCurve;
use crate::math::RPM;
use crate::motion::{Mover, Snapshot, Stretch};
use crate::view::Limit;

/// A servo motor of a machine, and the source of its motion in a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrivenAxis {
    /// Id, for instance `x`.
    pub id: &'static str,
    /// Catalog id of its name.
    pub name: &'static str,
    /// Source of its motion in a run.
    pub mover: Mover,
    /// Radians of the motor per unit of the run: per millimetre or degree.
    pub turn: f64,
    /// Load at the motor's shaft, without the rotor.
    pub load: Load,
    /// Torque at standstill, Nm.
    pub hold: f64,
    /// Torque (Nm) of a weight that it lifts in the positive direction, besides `hold`; 0 without one.
    pub weight: f64,
    /// Its interrupted cut.
    pub strikes: Strikes,
    /// Greatest additional torque (Nm) at steady speed that no planned run shows: a web pulled taut after a start. 0 without one.
    pub taut: f64,
    /// Torque (Nm) of the cut while the machine works, besides the steady torque of the load; none if the load's torque already includes
    /// the work.
    pub cut: Option<f64>,
    /// Torque (Nm) that the whole cut may ask without a pause, with friction and weight; none where no cut adds to the load.
    pub lasting: Option<f64>,
    /// Starts per minute by the formulas of the form, while the work lasts; 0 where those of the run alone count.
    pub starts_per_minute: f64,
    /// The gear unit between motor and load, if it is a purchased part.
    pub gear: Option<FormGear>,
    /// The motor that the form has.
    pub fitted: FittedMotor,
    /// Share of its continuous torque that the site leaves a motor, 0 to 1.
    pub site_share: f64,
    /// Fields of the form that take another motor; none where the form has the power of the drive alone.
    pub fields: Option<&'static MotorFields>,
}

/// Ids of the fields of a servo motor in a form. Torques in Nm, rotor in kg cm², speeds in r/min.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MotorFields {
    /// Maker and model, as text.
    pub name: &'static str,
    /// Torque at rated speed.
    pub rated: &'static str,
    /// Torque at standstill.
    pub stall: &'static str,
    /// Torque for a short time.
    pub peak: &'static str,
    /// Inertia of the rotor.
    pub rotor: &'static str,
    /// Rated speed.
    pub rated_speed: &'static str,
    /// Highest speed.
    pub top_speed: &'static str,
    /// Greatest load inertia over rotor inertia.
    pub inertia_limit: &'static str,
    /// Greatest effective torque, % of the torque at standstill.
    pub effective_limit: &'static str,
    /// Pulses of its encoder per revolution.
    pub encoder: &'static str,
}

/// The fields of the servo motor of an axis: ids that end with its letter, and the id of the field of its encoder.
macro_rules! motor_fields {
    ($axis:literal, $encoder:literal) => {
        $crate::machines::driven::MotorFields {
            name: concat!("motor-", $axis),
            rated: concat!("motor-rated-torque-", $axis),
            stall: concat!("motor-stall-", $axis),
            peak: concat!("motor-peak-", $axis),
            rotor: concat!("motor-rotor-", $axis),
            rated_speed: concat!("motor-rated-", $axis),
            top_speed: concat!("motor-max-", $axis),
            inertia_limit: concat!("inertia-limit-", $axis),
            effective_limit: concat!("effective-limit-", $axis),
            encoder: $encoder,
        }
    };
}
pub(super) use motor_fields;

/// Ids of a form's fields for a motor on an inverter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct InductionFields {
    /// Maker and model, as text.
    pub name: &'static str,
    /// Rated torque, Nm.
    pub rated: &'static str,
    /// Load, % of the rated torque.
    pub load: &'static str,
    /// Frequency at the full analog signal, Hz.
    pub frequency: &'static str,
    /// Speed under rated torque at the full signal, r/min.
    pub rated_speed: &'static str,
}

/// Frequency and speed of a motor on an inverter at the full analog signal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FullSignal {
    /// Frequency, Hz.
    pub frequency: f64,
    /// Speed without load, r/min.
    pub no_load: f64,
}

/// A gear unit as a form has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FormGear {
    /// Speed of its input over that of its output.
    pub ratio: f64,
    /// Load at its output.
    pub output: Load,
    /// Torque at its output at standstill, Nm.
    pub hold: f64,
    /// Greatest torque (Nm) at its output at steady speed that the load of a run does not have, as [`DrivenAxis::taut`]; 0 without one.
    pub taut: f64,
    /// Backlash (minutes of arc) that the machine's formulas use; none if it has no effect.
    pub backlash: Option<f64>,
    /// Fields of the form for another gear unit.
    pub fields: GearFields,
}

impl FormGear {
    /// Motion of the output shaft under these segments of the speed of the input shaft.
    pub fn output_motion(&self, input: &[SpeedSegment]) -> Motion {
        let slower = |segment: &SpeedSegment| SpeedSegment {
            from: segment.from / self.ratio,
            to: segment.to / self.ratio,
            ..*segment
        };
        Motion::new(input.iter().map(slower), self.output, self.hold)
            .with_strikes(pulled_taut(Strikes::default(), self.taut))
    }
}

/// Ids of the fields of a gear unit in a form.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GearFields {
    /// Its efficiency, %.
    pub efficiency: &'static str,
    /// Field of the moment of inertia at its input, kg cm²; none if the form includes it in another one.
    pub inertia: Option<&'static str>,
    /// Backlash, minutes of arc; none where the form has none.
    pub backlash: Option<&'static str>,
}

/// A motor of a machine as its form describes it, by figures; the form may also name maker and model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FormMotor {
    /// Id of its drive, that of [`DrivenAxis`] or [`InverterDrive`].
    pub drive: &'static str,
    /// Catalog id of the name of its drive.
    pub name: &'static str,
    /// Whether an inverter feeds the motor; otherwise a servo amplifier does.
    pub is_on_inverter: bool,
    /// Its figures: catalog id of the name, field of the form.
    pub figures: &'static [(&'static str, &'static str)],
}

impl DrivenAxis {
    /// Greatest way (in units of the run) that its weight moves it from rest until the brake at its motor has closed; none without a
    /// weight.
    pub fn sinks(&self) -> Option<f64> {
        let inertia = self.load.inertia + self.fitted.motor.rotor;
        (self.weight > 0.0).then(|| holding_brake::turn_until_closed(self.weight, inertia) / self.turn)
    }

    /// The motion of the motor's shaft in a part of a run, under the torque of its work within these spans (s); without spans always.
    pub fn motion(&self, stretches: &[Stretch], works: Option<&[(f64, f64)]>) -> Motion {
        let motion = Motion::new(speed_segments(stretches, self.turn), self.load, self.hold)
            .with_weight(self.weight)
            .with_strikes(pulled_taut(self.strikes, self.taut));
        match (works, self.cut) {
            (None, _) => motion,
            (Some(works), None) => motion.with_loaded_spans(works.to_vec()),
            (Some(works), Some(torque)) => {
                motion.with_cuts(works.iter().map(|&(begin, end)| CutSpan { begin, end, torque }).collect())
            }
        }
    }
}

/// Strikes with the torque of a taut web. It pulls at steady speed, and not for long enough to count in the effective torque.
fn pulled_taut(strikes: Strikes, taut: f64) -> Strikes {
    Strikes { peak: strikes.peak.max(taut), ..strikes }
}

/// Stretches of a run as segments of the speed of a shaft, with its radians per unit of the run.
pub fn speed_segments(stretches: &[Stretch], per_unit: f64) -> impl Iterator<Item = SpeedSegment> {
    stretches.iter().map(move |stretch| SpeedSegment {
        t: stretch.t,
        seconds: stretch.seconds,
        from: stretch.from * per_unit,
        to: stretch.to * per_unit,
    })
}

/// The size of a product that the operator types while the machine runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProductSize {
    /// Number of its variable.
    pub variable: u32,
    /// The present size, in the variable's unit.
    pub size: f64,
}

/// Demand on the motor on the inverter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InverterDrive {
    /// Id, for instance `unwinder`.
    pub id: &'static str,
    /// Catalog id of its name.
    pub name: &'static str,
    /// Continuous torque at the motor's shaft, Nm.
    pub torque: f64,
    /// Speed of the motor with it, r/min.
    pub speed: f64,
    /// Highest speed at which the machine runs the motor, r/min.
    pub top_speed: f64,
    /// Share of its rated torque and power that the site leaves the motor, 0 to 1.
    pub site_share: f64,
    /// Torque of the brake at the motor that closes without current, Nm; 0 without one.
    pub brake: f64,
    /// Run-up and stop, if the cycle includes them.
    pub cycle: Option<InverterCycle>,
    /// Radians per second of the motor per r/min of the spindle in a run.
    pub turn: f64,
    /// Load at the motor's shaft, without the rotor: inertia, and torque besides that of the work.
    pub load_at_motor: Load,
    /// Inertia of its rotor, kg m²; 0 if the load includes it.
    pub rotor: f64,
    /// The gear unit between motor and load, if it is a purchased part.
    pub gear: Option<FormGear>,
    /// Its frequency and speed at the full analog signal; none if its speed is not commanded in an open loop.
    pub full: Option<FullSignal>,
    /// Lowest speed (r/min) at which the fan on its shaft has to cool it; none with forced cooling, or where nothing is known.
    pub cooled_at: Option<f64>,
    /// Fields of the form that take another motor.
    pub fields: Option<&'static InductionFields>,
}

impl InverterDrive {
    /// Motion of the motor's shaft in a part of a run; for a main spindle without the torque of its cut.
    pub fn motion(&self, stretches: &[Stretch]) -> Motion {
        Motion::new(speed_segments(stretches, self.turn), self.load_at_motor, 0.0)
    }

    /// Segments of the speed of the motor's shaft in run-up, work and stop; without a cycle of ramps, in the work alone.
    pub fn speed_segments(&self) -> Vec<SpeedSegment> {
        let speed = self.speed.abs() * RPM;
        let steady = |t: f64, seconds: f64| SpeedSegment { t, seconds, from: speed, to: speed };
        match self.cycle {
            None => vec![steady(0.0, 1.0)],
            Some(InverterCycle { of, .. }) => {
                let rise = SpeedSegment { t: 0.0, seconds: of.ramp, from: 0.0, to: speed };
                let fall = SpeedSegment { t: of.ramp + of.run, seconds: of.ramp, from: speed, to: 0.0 };
                vec![rise, steady(of.ramp, of.run), fall]
            }
        }
    }
}

/// Run-up and stop of a motor on an inverter, with its work between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InverterCycle {
    /// Load of the ramps, at the motor's shaft and without the rotor.
    pub load: Load,
    /// Inertia (kg m²) of the rotor of a motor whose own is not known; none where `load` has the rotor already.
    pub rotor: Option<f64>,
    /// Its ramps, and the time of the work between them.
    pub of: Move,
    /// Short-time torque of the motor in the run-up and in the stop.
    pub short_time: ShortTime,
}

impl InverterCycle {
    /// Torques of run-up and stop with a rotor, signed.
    pub fn ramps(&self, rotor: Option<f64>) -> [Phase; 2] {
        let [rise, _, fall, _] = self.load.phases(self.rotor.map_or(0.0, |own| rotor.unwrap_or(own)), self.of);
        [rise, fall]
    }
}

/// The motor of a main spindle in a part of a run: cut, friction and acceleration together. Torques at its shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct SpindleRun {
    /// Catalog id of the name of its drive.
    pub name: &'static str,
    /// Motion of its shaft, without the rotor: friction and cut, and the inertia of chuck and work.
    pub motion: Motion,
    /// The same motion in a run without stock: no cut helps to brake.
    pub idle: Motion,
    /// Inertia of the form's rotor, kg m².
    pub rotor: f64,
    /// The form's motor by its data sheet.
    pub motor: MotorCurve,
    /// Short-time torque of the motor.
    pub short_time: ShortTime,
}

impl SpindleRun {
    /// The operating point with the largest fraction of the short-time torque of a motor with this curve and rotor (kg m²), with and
    /// without stock.
    pub fn worst_point(&self, motor: &MotorCurve, rotor: f64) -> OperatingPoint {
        let (cut, idle) = (self.under(&self.motion, motor, rotor), self.worst_point_idle(motor, rotor));
        if idle.share > cut.share { idle } else { cut }
    }

    /// The operating point with the largest fraction in a run without stock, where only the ramps load the motor.
    pub fn worst_point_idle(&self, motor: &MotorCurve, rotor: f64) -> OperatingPoint {
        self.under(&self.idle, motor, rotor)
    }

    fn under(&self, motion: &Motion, motor: &MotorCurve, rotor: f64) -> OperatingPoint {
        motion.worst_point_under(rotor, |brakes, speed| self.short_time.at(brakes) * motor.torque(speed))
    }

    /// The greatest share of the torque that the rated current of a motor with this curve and rotor (kg m²) gives at the same speed, with
    /// and without stock.
    pub fn share_of_rated(&self, motor: &MotorCurve, rotor: f64) -> f64 {
        let share = |motion: &Motion| motion.worst_point_under(rotor, |_, speed| motor.torque(speed)).share;
        share(&self.motion).max(share(&self.idle))
    }

    /// The brake resistor that a braking torque (% of the rated one) of the form assumes: all energy that comes back in a run without
    /// stock, over the run and its pause (s).
    pub fn resistor(&self, percent: f64, pause: f64) -> Option<ResistorDemand> {
        let energies = self.idle.returns(self.rotor);
        let seconds: f64 = self.idle.segments().iter().map(|segment| segment.seconds).sum();
        let is_asked = percent > WITHOUT_RESISTOR && !energies.is_empty();
        is_asked.then_some(ResistorDemand { name: self.name, percent, energies, cycle: seconds + pause })
    }

    /// The operating point of cut and friction with the largest fraction of the torque that this curve gives.
    pub fn worst_point_steady(&self, motor: &MotorCurve) -> OperatingPoint {
        self.motion.clone().without_inertia().worst_point_under(0.0, |_, speed| motor.torque(speed))
    }
}

/// Demand on the encoder of a spindle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpindleEncoder {
    /// Catalog id of the name of its drive.
    pub name: &'static str,
    /// Greatest speed of the encoder, r/min.
    pub speed: f64,
    /// Lines per turn of the encoder.
    pub lines: f64,
}

/// Braking torque (% of the rated one) that an inverter takes back without a brake resistor. Source: turning spindle facts, 5.
pub const WITHOUT_RESISTOR: f64 = 20.0;

/// Braking of a motor on an inverter with more torque than the inverter takes back without a brake resistor.
#[derive(Debug, Clone, PartialEq)]
pub struct ResistorDemand {
    /// Catalog id of the name of its drive.
    pub name: &'static str,
    /// Braking torque of the form, % of the rated one.
    pub percent: f64,
    /// Energies (J) that come back in a part, one for each time that the drive brakes.
    pub energies: Vec<f64>,
    /// Time (s) from one start to the next.
    pub cycle: f64,
}

impl ResistorDemand {
    /// Mean power, W.
    pub fn power(&self) -> f64 {
        if self.cycle > 0.0 { self.energies.iter().sum::<f64>() / self.cycle } else { 0.0 }
    }

    /// Greatest energy of all, J.
    pub fn greatest(&self) -> f64 {
        self.energies.iter().copied().fold(0.0, f64::max)
    }
}

/// A quantity of a machine `M` that is checked during operation.
pub struct GaugeRow<M: 'static> {
    /// Id, for instance `loop`.
    pub id: &'static str,
    /// Catalog id of its name.
    pub label: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Decimals shown.
    pub decimals: u8,
    /// Its limit.
    pub limit: fn(&M) -> Option<Limit>,
    /// Field of the form with the limit, if there is one.
    pub field: Option<&'static str>,
    /// Its value at a moment of the run.
    pub value: fn(&M, &Snapshot) -> f64,
}

/// The worst value of a watched quantity in a part of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gauge {
    /// Id, for instance `loop`.
    pub id: &'static str,
    /// Catalog id of its name.
    pub label: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Decimals shown.
    pub decimals: u8,
    /// Its limit, in `unit`.
    pub limit: Option<Limit>,
    /// Field of the form with the limit, if there is one.
    pub field: Option<&'static str>,
    /// The worst value: the smallest for a lower limit, otherwise the largest; by magnitude if the limit applies to both signs.
    pub value: f64,
}

impl<M> GaugeRow<M> {
    /// The quantity with this value on a machine.
    pub fn gauge(&self, machine: &M, value: f64) -> Gauge {
        let GaugeRow { id, label, unit, decimals, field, .. } = *self;
        Gauge { id, label, unit, decimals, limit: (self.limit)(machine), field, value }
    }
}

/// Axes of work and tool that coast to rest at a power failure, each at its own rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoastedAxes {
    /// Time (s) until both are at rest.
    pub seconds: f64,
    /// The quantity that they lose, at rest.
    pub gauge: Gauge,
}

/// Reads the gauges from `from` to `to` seconds at `points` moments, 2 at least; `at` is the machine at a moment.
pub fn read<M>(
    rows: &[GaugeRow<M>],
    machine: &M,
    at: impl Fn(f64) -> Snapshot,
    (from, to): (f64, f64),
    points: usize,
) -> Vec<Gauge> {
    let points = points.max(2);
    let step = (to - from) / (points - 1) as f64;
    let moments: Vec<Snapshot> = (0..points).map(|point| at(from + step * point as f64)).collect();
    let gauge = |row: &GaugeRow<M>| {
        let limit = (row.limit)(machine);
        let values = moments.iter().map(|now| (row.value)(machine, now));
        let worse = |worst: f64, next: f64| {
            if Limit::load(limit, next) > Limit::load(limit, worst) { next } else { worst }
        };
        row.gauge(machine, values.reduce(worse).unwrap_or(0.0))
    };
    rows.iter().map(gauge).collect()
}

//! Demand of one or several runs on the motor of an axis, for any rotor, and its chart over the motor's curves.

use std::collections::BTreeMap;

use super::runs::WholeRun;
use crate::drives::load::Regeneration;
use crate::drives::motor_trial::MotorTrial;
use crate::drives::servo::{MotorDemand, Servo};
use crate::drives::shaft_motion::{Motion, MotorLoad, OperatingPoint, ResistorLoad};
use crate::machines::driven::DrivenAxis;
use crate::math::RPM;
use crate::view::{OperatingLine, TorqueChart};

/// Greatest number of a run's lines in a chart.
const MOST_LINES: usize = 600;

/// Number of straight pieces of a motor's curve above its rated speed.
const BEND: u32 = 8;

/// Reciprocal of the resolution (r/min, Nm) at which speeds and torques count as equal.
const ALIKE: f64 = 1e3;

/// Mean regenerated power (W) below which none is reported. Our choice.
pub(super) const LEAST_RETURNED: f64 = 0.05;

/// Demand of one or several runs on a shaft.
pub(super) struct RunsDemand {
    /// The motions of the runs at the feed of the form, that of the present run first.
    pub motions: Vec<Motion>,
    /// Greatest mean speed of a run, r/min.
    pub mean_speed: f64,
    /// Greatest number of starts per minute of a run.
    pub starts_per_minute: f64,
    /// Position (%) of the knob in the second run.
    pub knob: Option<f64>,
    /// The motions with the feed override at its highest position.
    fed: Vec<Motion>,
    /// That position, %.
    feed: Option<f64>,
    /// All motions, for the motors of the catalogue.
    trials: Vec<MotorTrial>,
}

impl RunsDemand {
    /// Demand on an axis in these runs, and on the same axis in the runs at another feed.
    pub(super) fn new(
        axis: &DrivenAxis,
        runs: &[&WholeRun],
        fed: Option<(&DrivenAxis, &[WholeRun])>,
        pause: f64,
    ) -> RunsDemand {
        let motion = |axis: &DrivenAxis, whole: &WholeRun| whole.motion(axis).with_pause(pause);
        let motions: Vec<Motion> = runs.iter().map(|whole| motion(axis, whole)).collect();
        let feed = fed.and_then(|(_, runs)| runs.first()?.feed);
        let fed = fed.into_iter().flat_map(|(axis, runs)| runs.iter().map(|whole| motion(axis, whole)));
        let fed: Vec<Motion> = fed.collect();
        let greatest = |figure: fn(&Motion) -> f64| motions.iter().chain(&fed).map(figure).fold(0.0, f64::max);
        let (mean_speed, starts_per_minute) = (greatest(Motion::mean_speed), greatest(Motion::starts_per_minute));
        let knob = runs.iter().find_map(|whole| whole.knob);
        let trials = motions.iter().chain(&fed).map(MotorTrial::new).collect();
        RunsDemand { motions, mean_speed, starts_per_minute, knob, fed, feed, trials }
    }

    /// The motions of all runs.
    fn all(&self) -> impl Iterator<Item = &Motion> + Clone {
        self.motions.iter().chain(&self.fed)
    }

    /// Whether the second run has the greatest torque.
    pub(super) fn peak_is_at_knob(&self, rotor: f64) -> bool {
        let peak = |motion: &Motion| motion.motor_load(rotor).peak.torque;
        self.peak_feed(rotor).is_none()
            && matches!(self.motions.as_slice(), [first, second] if peak(second) > peak(first))
    }

    /// Position (%) of the feed override if a run with it has the greatest torque.
    pub(super) fn peak_feed(&self, rotor: f64) -> Option<f64> {
        let peak =
            |motions: &[Motion]| motions.iter().map(|motion| motion.motor_load(rotor).peak.torque).fold(0.0, f64::max);
        self.feed.filter(|_| peak(&self.fed) > peak(&self.motions))
    }

    /// The greatest value of each figure over all runs, of the energies over those at the feed of the form.
    pub(super) fn motor_load(&self, rotor: f64) -> MotorLoad {
        let loads = self.all().map(|motion| motion.motor_load(rotor));
        let at_form = loads.clone().take(self.motions.len());
        let (given, returned) = at_form
            .fold((0.0_f64, 0.0_f64), |(given, returned), load| (given.max(load.given), returned.max(load.returned)));
        let worst = loads.fold(MotorLoad::default(), |worst, next| MotorLoad {
            peak: if next.peak.torque > worst.peak.torque { next.peak } else { worst.peak },
            effective: worst.effective.max(next.effective),
            speed: worst.speed.max(next.speed),
            seconds: worst.seconds.max(next.seconds),
            ..worst
        });
        MotorLoad { given, returned, ..worst }
    }

    /// The demand on a motor with a rotor (kg m²): the greatest value of each figure over all runs.
    pub(super) fn on_motor(&self, rotor: f64) -> MotorDemand {
        let greatest = |figure: &dyn Fn(&MotorTrial) -> f64| self.trials.iter().map(figure).fold(0.0, f64::max);
        MotorDemand {
            peak: greatest(&|trial| trial.peak(rotor).torque),
            effective: greatest(&|trial| trial.effective(rotor)),
            speed: greatest(&MotorTrial::speed) / RPM,
        }
    }

    /// Moment with the greatest share of the motor's short-time torque.
    pub(super) fn worst_point(&self, motor: &Servo) -> OperatingPoint {
        let all = self.trials.iter().map(|trial| trial.worst_point(motor));
        all.reduce(|worst, next| if next.share > worst.share { next } else { worst }).unwrap_or_default()
    }

    /// Energy and power beyond the capacitors, the greatest value of each figure over all runs.
    pub(super) fn to_resistor(&self, rotor: f64, back: &Regeneration) -> ResistorLoad {
        let all = self.trials.iter().map(|trial| trial.to_resistor(rotor, back));
        all.reduce(ResistorLoad::max).unwrap_or_default()
    }

    /// All of the energy and power that come back with a rotor, the greatest value of each figure over all runs; none without any.
    pub(super) fn returned(&self, rotor: f64) -> Option<ResistorLoad> {
        let returned = self.to_resistor(rotor, &Regeneration { efficiency: 1.0, capacitor: 0.0 });
        (returned.mean > LEAST_RETURNED).then_some(returned)
    }

    /// Mean speed (r/min) and effective torque (Nm) of the run with the greatest effective torque.
    fn effective(&self, rotor: f64) -> (f64, f64) {
        let point = |motion: &Motion| (motion.mean_speed(), motion.motor_load(rotor).effective);
        let greater = |worst: (f64, f64), next: (f64, f64)| if next.1 > worst.1 { next } else { worst };
        self.all().map(point).reduce(greater).unwrap_or_default()
    }

    /// Torque over speed of a motor at its site, with the lines of all runs; lines of a run with equal speeds and torque are merged.
    pub(super) fn chart(&self, motor: &Servo, site_share: f64) -> TorqueChart {
        let mut lines: BTreeMap<(usize, i64, i64, i64), OperatingLine> = BTreeMap::new();
        for (run, motion) in self.motions.iter().enumerate() {
            for segment in motion.segments() {
                let steady =
                    motion.torque(segment, motor.rotor) * if segment.from + segment.to < 0.0 { -1.0 } else { 1.0 };
                let speeds = (segment.from.abs() / RPM, segment.to.abs() / RPM);
                let key = |value: f64| (value * ALIKE).round() as i64;
                // An interrupted cut has two lines, its mean torque and its strikes.
                for torque in [Some(steady), motion.strike(segment)].into_iter().flatten() {
                    let is_at_highest_knob = run > 0;
                    let line = OperatingLine { speeds, torque, t: segment.t, seconds: 0.0, is_at_highest_knob };
                    let alike = (run, key(speeds.0), key(speeds.1), key(torque));
                    lines.entry(alike).or_insert(line).seconds += segment.seconds;
                }
            }
        }
        // The longest lines; the others are too short to be seen.
        let mut lines: Vec<OperatingLine> = lines.into_values().collect();
        lines.sort_by(|a, b| b.seconds.total_cmp(&a.seconds));
        lines.truncate(MOST_LINES);
        let points = |torque: &dyn Fn(f64) -> f64| {
            let bend = motor.rated_speed.min(motor.top_speed);
            let above = (1..=BEND).map(|at| bend + (motor.top_speed - bend) * f64::from(at) / f64::from(BEND));
            [0.0, bend].into_iter().chain(above).map(|speed| (speed, torque(speed))).collect::<Vec<_>>()
        };
        TorqueChart {
            continuous: points(&|speed| motor.continuous_at(site_share, speed)),
            peak: points(&|speed| motor.short_time_torque(speed)),
            lines,
            effective: self.effective(motor.rotor),
        }
    }
}

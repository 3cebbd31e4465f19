//! A main spindle on its inverter, for every lathe that has one: rows of the form, motor, verdict of its ramp, fan, charts over the speed.

use crate::drives::inertia;
use crate::drives::load::{Load, through_gear};
use crate::drives::shaft_motion::{CutSpan, Motion};
use crate::drives::spindle_motor::{self, GearedMotor, MotorCurve};
use crate::drives::{MainSpindle, ShortTime};
use crate::machines::driven::SpindleRun;
use crate::machines::driven::devices::{AskedDevice, BillItem};
use crate::machines::form::Field;
use crate::machines::form::entry::{at_least, field_max};
use crate::machines::form::rows::{Member, flag, number};
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::msg;
use crate::view::Limit::AtMost;
use crate::view::{Advice, Chart, ChartAxis, Series};

/// Motor, ramp of the inverter and friction of a main spindle, by the fields of the form.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::machines) struct SpindleDrive {
    /// Rated power of the motor, kW.
    pub power: f64,
    /// Base speed of the motor, r/min.
    pub base: f64,
    /// Speed of the motor at 10 V, r/min.
    pub top: f64,
    /// Whether the motor has a fan with its own drive, not one on its shaft.
    pub forced_cooling: bool,
    /// Short-time driving torque of the motor, % of its rated torque at the same speed.
    pub peak: f64,
    /// Short-time braking torque of the motor, % of its rated torque at the same speed.
    pub braking: f64,
    /// Moment of inertia of the rotor, kg m².
    pub rotor: f64,
    /// Friction of the spindle, Nm.
    pub friction: f64,
    /// Time of the inverter's ramp from 0 to the speed at 10 V, s.
    pub ramp: f64,
}

/// A gear stage of a main spindle: speed (r/min) of the spindle at 10 V, and efficiency of the gear, %.
#[derive(Debug, Clone, Copy)]
pub(in crate::machines) struct SpindleGear {
    pub speed_at_10v: f64,
    pub efficiency: f64,
}

impl SpindleDrive {
    /// Speed of the motor over that of the spindle.
    pub(in crate::machines) fn gear(&self, speed_at_10v: f64) -> f64 {
        self.top / speed_at_10v
    }

    /// Curve of the motor by its data sheet, reduced to the spindle.
    pub(in crate::machines) fn motor(&self, stage: SpindleGear) -> MotorCurve {
        MotorCurve::through_gear(GearedMotor {
            power: self.power,
            base: self.base,
            top: self.top,
            spindle_top: stage.speed_at_10v,
            efficiency: stage.efficiency / 100.0,
        })
    }

    /// Continuous curve of the motor at the spindle, derated for its site (`site_share`, %) and, without forced cooling, for a fan on its shaft.
    pub(in crate::machines) fn continuous(&self, stage: SpindleGear, site_share: f64) -> MotorCurve {
        self.motor(stage).share(site_share / 100.0).with_shaft_fan(!self.forced_cooling)
    }

    /// Moment of inertia (kg m²) of the rotor at the spindle: `J_rotor (n_m / n10)²`. Source: sizing facts 2.1.
    pub(in crate::machines) fn rotor_at_spindle(&self, speed_at_10v: f64) -> f64 {
        inertia::through_gear(self.rotor, speed_at_10v / self.top)
    }

    /// The spindle with its motor. `inertia`: moment of inertia (kg m²) of all rotating parts, without the rotor.
    pub(in crate::machines) fn main_spindle(&self, stage: SpindleGear, inertia: f64) -> MainSpindle {
        let speed_at_10v = stage.speed_at_10v;
        MainSpindle {
            speed_at_10v,
            ramp: self.ramp,
            load_at_spindle: Load {
                inertia: inertia + self.rotor_at_spindle(speed_at_10v),
                torque: self.friction,
                efficiency: 1.0,
            },
            motor: self.motor(stage),
            short_time: self.short_time(),
        }
    }

    /// Short-time torque of the motor.
    fn short_time(&self) -> ShortTime {
        ShortTime { driving: self.peak / 100.0, braking: self.braking / 100.0 }
    }

    /// Load at the motor's shaft: an inertia (kg m²) at the spindle reduced to the shaft, and the friction of the
    /// spindle.
    pub(in crate::machines) fn load_at_motor(&self, stage: SpindleGear, inertia: f64) -> Load {
        let (gear, efficiency) = (self.gear(stage.speed_at_10v), stage.efficiency / 100.0);
        Load {
            inertia: inertia::through_gear(inertia, gear),
            torque: through_gear(self.friction, gear, efficiency),
            efficiency,
        }
    }

    /// The motor in a part of a run, at its shaft.
    pub(in crate::machines) fn run(&self, name: &'static str, idle: Motion, cuts: Vec<CutSpan>) -> SpindleRun {
        SpindleRun {
            name,
            motion: idle.clone().with_cuts(cuts),
            idle,
            rotor: self.rotor,
            motor: MotorCurve::at_shaft(self.power, self.base),
            short_time: self.short_time(),
        }
    }
}

/// A field for the rated power of a motor.
pub(in crate::machines) const fn power<P>(
    id: &'static str,
    label: &'static str,
    help: &'static str,
    member: Member<P, f64>,
) -> Field<P> {
    let row = number(id, member).label(label).help(help).symbol("P");
    row.unit("kW").range(0.01..=1000.0).default(7.5).decimals(2).step(0.5).fact()
}

/// A field for the speed up to which a motor has its rated torque.
pub(in crate::machines) const fn base_speed<P>(
    id: &'static str,
    label: &'static str,
    help: &'static str,
    member: Member<P, f64>,
) -> Field<P> {
    let row = number(id, member).label(label).help(help).symbol("n b");
    row.unit("r/min").range(1.0..=60000.0).default(1500.0).decimals(0).step(100.0).fact()
}

/// A field for the speed of a motor at 10 V.
pub(in crate::machines) const fn top_speed<P>(
    id: &'static str,
    label: &'static str,
    help: &'static str,
    default: f64,
    member: Member<P, f64>,
) -> Field<P> {
    let row = number(id, member).label(label).help(help).symbol("n m");
    row.unit("r/min").range(1.0..=60000.0).default(default).decimals(0).step(100.0).fact()
}

/// A field for the forced cooling of a motor.
pub(in crate::machines) const fn forced_cooling<P>(
    id: &'static str,
    label: &'static str,
    member: Member<P, bool>,
) -> Field<P> {
    flag(id, member).label(label).help("lathe.motor-forced-cooling.help").fact()
}

/// A field for the short-time torque of a motor.
pub(in crate::machines) const fn peak<P>(id: &'static str, label: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number(id, member).label(label).help("lathe.motor-peak.help");
    row.unit("%").range(100.0..=600.0).default(150.0).decimals(0).step(10.0).fact()
}

/// A field for the torque with which a motor brakes.
pub(in crate::machines) const fn braking<P>(id: &'static str, label: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number(id, member).label(label).help("lathe.motor-braking.help");
    row.unit("%").range(1.0..=600.0).default(150.0).decimals(0).step(10.0).fact()
}

/// A field for the moment of inertia of a rotor.
pub(in crate::machines) const fn rotor<P>(
    id: &'static str,
    label: &'static str,
    help: &'static str,
    member: Member<P, f64>,
) -> Field<P> {
    let row = number(id, member).label(label).help(help);
    row.unit("kg m²").range(0.0..=1000.0).default(0.03).decimals(4).step(0.001).fact()
}

/// A field for the friction of a spindle.
pub(in crate::machines) const fn friction<P>(
    id: &'static str,
    label: &'static str,
    help: &'static str,
    member: Member<P, f64>,
) -> Field<P> {
    let row = number(id, member).label(label).help(help);
    row.unit("Nm").range(0.01..=10000.0).default(2.0).decimals(2).step(0.1).fact()
}

/// Highest position of the override knob, and the speed there.
#[derive(Debug, Clone, Copy)]
pub(in crate::machines) struct SpeedAtKnob {
    /// Position, %.
    pub percent: f64,
    /// Speed of the spindle, r/min.
    pub speed: f64,
}

/// Judges the ramp of the form (field `id`) against the shortest one that the motor can follow to `highest`, the
/// highest speed of the program in r/min. A warning if the ramp suffices for that speed, but not for the speed `at_knob`.
pub(in crate::machines) fn judge_ramp<P>(
    spindle: &MainSpindle,
    highest: f64,
    at_knob: Option<SpeedAtKnob>,
    (fields, id): (&[Field<P>], &'static str),
) -> Option<Judgement> {
    let (ramp, shortest) = (spindle.ramp, spindle.shortest_ramp(highest));
    let limit = AtMost(ramp);
    if limit.holds(shortest) {
        let at_knob = at_knob.map(|knob| (knob.percent, spindle.shortest_ramp(knob.speed)));
        let Some((percent, shortest)) = at_knob.filter(|(_, shortest)| !limit.holds(*shortest)) else {
            return ok(limit);
        };
        if shortest == f64::INFINITY {
            return warn(limit, [msg!("lathe.friction-stalls-at-knob", percent = (percent, 0)).into()]);
        }
        let set = at_least(fields, id, shortest);
        let advice =
            Advice::from(msg!("lathe.ramp-at-knob", percent = (percent, 0), needed = (shortest, 2), ramp = (ramp, 2)));
        let button = msg!("advice.set-ramp", time = set.text.as_str());
        return warn(limit, [if shortest <= field_max(fields, id) { advice.setting(button, [set]) } else { advice }]);
    }
    if shortest == f64::INFINITY {
        let gives = spindle.driving_motor().torque(highest);
        let friction = (spindle.load_at_spindle.torque, 1);
        return fail(limit, [msg!("lathe.friction-stalls", friction, torque = (gives, 1)).into()]);
    }
    let set = at_least(fields, id, shortest);
    let advice = Advice::from(msg!("lathe.ramp-too-short", needed = (shortest, 2), ramp = (ramp, 2)));
    let button = msg!("advice.set-ramp", time = set.text.as_str());
    fail(limit, [if shortest <= field_max(fields, id) { advice.setting(button, [set]) } else { advice }])
}

/// The fan with a supply of its own, where a drive has forced cooling (IC 416).
pub(in crate::machines) fn fan(drive: &'static str, is_forced: bool) -> Option<AskedDevice> {
    is_forced.then(|| AskedDevice { item: BillItem::Fan, drive: Some(drive), asked: msg!("lathe.device.fan") })
}

/// Colours of the cut, and of the short-time rating in the engaged stage.
const CUT: u8 = 4;
const SHORT: u8 = 5;

/// Curves of the motor over the speed of the spindle, each up to the speed (r/min) at 10 V, and the demand of the cut.
pub(in crate::machines) struct SpeedCurves {
    /// Continuous curve of each gear stage, with label and colour.
    pub stages: Vec<(&'static str, u8, MotorCurve, f64)>,
    /// Short-time curve in the engaged stage.
    pub short_time: Option<(MotorCurve, f64)>,
    /// Speeds (r/min) with the torque (Nm) of cut and friction; empty where none is known.
    pub cut: Vec<(f64, f64)>,
}

/// Charts over the speed of the spindle: torque and power of the motor, and the demand of the cut.
pub(in crate::machines) fn charts_by_speed(curves: SpeedCurves, points: usize) -> Vec<Chart> {
    let points = points.max(2);
    // P = M ω: it grows with the speed below base speed.
    let lines = |of: fn(f64, f64) -> f64| -> Vec<Series> {
        let line = |label, tone, points| Series { label, tone, address: None, points };
        let curve = |motor: &MotorCurve, top: f64| {
            let speeds = (0..points).map(|at| top * (at as f64 / (points - 1) as f64));
            speeds.map(|speed| (speed, of(motor.torque(speed), speed))).collect::<Vec<_>>()
        };
        let stages = curves.stages.iter().map(|(label, tone, motor, top)| line(label, *tone, curve(motor, *top)));
        let short = curves.short_time.as_ref();
        let short = short.map(|(motor, top)| line("lathe.chart.short-time", SHORT, curve(motor, *top)));
        let cut = curves.cut.iter().map(|(speed, torque)| (*speed, of(*torque, *speed))).collect::<Vec<_>>();
        let cut = (!cut.is_empty()).then(|| line("lathe.chart.cut", CUT, cut));
        stages.chain(short).chain(cut).collect()
    };
    let chart = |id, title, unit, series| Chart {
        id,
        title,
        unit,
        least_span: 0.0,
        x: ChartAxis::Speed,
        series,
        limits: Vec::new(),
    };
    vec![
        chart("torque-speed", "lathe.chart.torque-speed", "Nm", lines(|torque, _| torque)),
        chart("power-speed", "lathe.chart.power-speed", "kW", lines(spindle_motor::power)),
    ]
}

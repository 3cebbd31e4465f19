//! The main spindle of the polygon lathe, which turns the bar before and after the polygons: its motor on the inverter, demand, verdicts.

use super::params::{FIELDS, Params};
use super::resolved::PolygonLathe;
use super::turned_end_form::{TURNED_ENDS, TurnedEnd};
use crate::drives::MainSpindle;
use crate::drives::analog::FEW_VOLTS;
use crate::drives::cutting;
use crate::drives::load::{Load, through_gear};
use crate::drives::shaft_motion::{CutSpan, Motion};
use crate::drives::speed::KnobEnds;
use crate::drives::spindle_motor::{self, MotorCurve};
use crate::machines::driven::devices::{AskedDevice, forced_cooling_advice};
use crate::machines::driven::{InverterDrive, SpindleEncoder, SpindleRun, speed_segments};
use crate::machines::form::entry::at_most;
use crate::machines::lathe::knobs::{self, KnobPositions, TorqueAtKnobs, TorqueRemedy};
use crate::machines::lathe::main_spindle::{self, SpeedAtKnob, SpeedCurves, SpindleGear};
use crate::machines::machine::Samples;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::math::RPM;
use crate::motion::RunSegment;
use crate::msg;
use crate::text::Message;
use crate::view::Limit::{AtLeast, AtMost};
use crate::view::{Advice, Chart};

/// Catalog id of the name of the drive.
pub(super) const NAME: &str = "polygon.drive.main";

impl Params {
    /// The spindle with its motor. The work's motor stays on the spindle, so that its inertia includes that of the work axis.
    pub(super) fn main_spindle(&self) -> MainSpindle {
        self.main.main_spindle(self.main_spindle_gear(), self.axes.work.inertia)
    }

    /// Continuous curve of its motor at the spindle, derated for the site and, without forced cooling, for a fan on its shaft.
    fn main_continuous(&self) -> MotorCurve {
        self.main.continuous(self.main_spindle_gear(), self.site_share)
    }

    fn main_spindle_gear(&self) -> SpindleGear {
        SpindleGear { speed_at_10v: self.main_speed, efficiency: self.drive_efficiency }
    }

    /// Clamp (r/min) of the control for the spindle: its speed at 10 V, at most the highest speed of the work axis,
    /// whose motor and chuck turn with it.
    pub(super) fn main_clamp(&self) -> f64 {
        self.main_speed.min(self.axes.work.limit)
    }

    /// Speed of its motor over that of the spindle.
    fn main_gear(&self) -> f64 {
        self.main.gear(self.main_speed)
    }
}

impl PolygonLathe {
    /// Ends of the override knob; the form has it at 100 %.
    fn knob_ends(&self) -> KnobEnds {
        self.dialect.spindle().knob.ends(100.0)
    }

    /// Speed (r/min) of the spindle at a position (%) of the override knob, for a speed of the form: at most the clamp of the control.
    fn speed_at(&self, speed: f64, percent: f64) -> f64 {
        (speed * percent / 100.0).min(self.params.main_clamp())
    }

    /// The turned ends of the program, with the fields of their depths.
    fn turned_ends(&self) -> impl Iterator<Item = (&TurnedEnd, &'static str)> {
        self.params.turned_ends.iter().zip(TURNED_ENDS.map(|fields| fields.depth)).filter(|(end, _)| end.on)
    }

    /// Whether the program turns the bar by its main spindle.
    pub(super) fn has_main_spindle(&self) -> bool {
        self.params.turns_ends()
    }

    /// Torque (Nm) of the cut at a turned end, at the diameter from which it is cut: `F D / 2000`. Source: turning spindle facts, 4.
    fn cut_torque(&self, end: &TurnedEnd) -> f64 {
        cutting::torque(self.end_force(end), end.blank(&self.params))
    }

    /// Torque (Nm) of cut and friction at a turned end.
    fn end_torque(&self, end: &TurnedEnd) -> f64 {
        self.cut_torque(end) + self.params.main.friction
    }

    /// The turned end that uses the largest share of the motor's continuous torque, with the field of its depth.
    fn hardest_end(&self) -> Option<(&TurnedEnd, &'static str)> {
        let curve = self.params.main_continuous();
        let share = |end: &TurnedEnd| self.end_torque(end) / curve.torque(end.speed);
        self.turned_ends().max_by(|a, b| share(a.0).total_cmp(&share(b.0)))
    }
}

/// Greatest speed of the turned ends, r/min.
pub(super) fn programmed_speed(lathe: &PolygonLathe) -> f64 {
    lathe.turned_ends().map(|(end, _)| end.speed).fold(0.0, f64::max)
}

/// Greatest commanded speed (r/min) with the knob at any position: S, or S at the knob's highest position, limited by
/// the clamp of the control.
pub(super) fn greatest_speed(lathe: &PolygonLathe) -> f64 {
    programmed_speed(lathe).max(speed_at_highest_knob(lathe))
}

/// Torque (Nm) of cut and friction at the end with the greatest demand on the motor.
pub(super) fn torque(lathe: &PolygonLathe) -> f64 {
    lathe.hardest_end().map_or(0.0, |(end, _)| lathe.end_torque(end))
}

/// Greatest power (kW) of cut and friction.
pub(super) fn power(lathe: &PolygonLathe) -> f64 {
    let power = |end: &TurnedEnd| spindle_motor::power(lathe.end_torque(end), end.speed);
    lathe.turned_ends().map(|(end, _)| power(end)).fold(0.0, f64::max)
}

/// Voltage (V) of the control's output at the greatest speed.
pub(super) fn volts(lathe: &PolygonLathe) -> f64 {
    lathe.control.analog_output.with_speed(lathe.params.main_speed).output(programmed_speed(lathe))
}

/// Voltage (V) of the control's output at the slowest turned end.
pub(super) fn least_volts(lathe: &PolygonLathe) -> f64 {
    let slowest = lathe.turned_ends().map(|(end, _)| end.speed).fold(f64::INFINITY, f64::min);
    lathe.control.analog_output.with_speed(lathe.params.main_speed).output(slowest)
}

/// Judges the voltage at the slowest turned end against [`FEW_VOLTS`].
pub(super) fn judge_volts(lathe: &PolygonLathe) -> Option<Judgement> {
    let (volts, limit) = (least_volts(lathe), AtLeast(FEW_VOLTS));
    if limit.holds(volts) {
        return ok(limit);
    }
    warn(limit, [msg!("polygon.few-volts", volts = (volts, 3)).into()])
}

/// Judges cut and friction against the continuous torque of the motor.
pub(super) fn judge_torque(lathe: &PolygonLathe) -> Option<Judgement> {
    let (p, (end, field)) = (&lathe.params, lathe.hardest_end()?);
    let (torque, speed) = (lathe.end_torque(end), end.speed);
    let curve = p.main_continuous();
    let most = curve.torque(speed);
    if torque <= most {
        return judge_torque_at_knobs(lathe, most);
    }
    let (shown, limit) = ((torque, 1), (most, 1));
    let mut advice = Vec::new();
    if torque <= curve.with_shaft_fan(false).torque(speed) {
        let message = msg!("lathe.shaft-fan", speed = (speed * p.main_gear(), 0), torque = shown, limit);
        advice.push(forced_cooling_advice("main-forced-cooling", message));
    }
    let weak = Advice::from(msg!("polygon.main-spindle-weak", torque = shown, speed = (speed, 0), limit));
    let share = (most - p.main.friction) / (torque - p.main.friction);
    let set = at_most(FIELDS, field, end.depth * share);
    let depth = set.value;
    let is_endless = TurnedEnd { depth, ..end.clone() }.is_endless(end.blank(p));
    advice.push(if depth >= cutting::LEAST_DEPTH && !is_endless {
        weak.setting(msg!("advice.set-depth", depth = set.text.as_str()), [set])
    } else {
        weak
    });
    fail(AtMost(most), advice)
}

/// Cut and friction of a turned end at the positions of the knobs.
fn torques_at_knobs(lathe: &PolygonLathe, end: &TurnedEnd) -> Vec<TorqueAtKnobs> {
    let curve = lathe.params.main_continuous();
    let all = knobs::positions(lathe.control.feed_knob.positions, lathe.knob_ends(), 100.0);
    let torque = |at: KnobPositions| {
        let fed = TurnedEnd { feed: end.feed * at.feed / 100.0, ..end.clone() };
        let speed = lathe.speed_at(end.speed, at.spindle);
        TorqueAtKnobs {
            at,
            torque: lathe.end_torque(&fed),
            limit: curve.torque(speed),
            forced: curve.with_shaft_fan(false).torque(speed),
            motor_speed: speed * lathe.params.main_gear(),
        }
    };
    all.into_iter().map(torque).collect()
}

/// Judges a cut within the motor's torque at the form's positions of the knobs: a warning if it exceeds the torque at
/// another position. The advised feeds suffice at all positions.
fn judge_torque_at_knobs(lathe: &PolygonLathe, limit: f64) -> Option<Judgement> {
    let p = &lathe.params;
    let all: Vec<TorqueAtKnobs> = lathe.turned_ends().flat_map(|(end, _)| torques_at_knobs(lathe, end)).collect();
    let lower = |(end, field): (&TurnedEnd, &'static str)| {
        let cut = |torque: f64| (torque - p.main.friction).max(0.0);
        let shares = torques_at_knobs(lathe, end).into_iter().map(|of| cut(of.limit) / cut(of.torque));
        let share = shares.fold(1.0, f64::min);
        (share < 1.0).then(|| at_most(FIELDS, field, end.feed * cutting::feed_share(share, p.specific().exponent)))
    };
    let slower = |message: Message| {
        let ends = p.turned_ends.iter().zip(TURNED_ENDS.map(|fields| fields.feed)).filter(|(end, _)| end.on);
        knobs::setting_feeds(Advice::from(message), ends.filter_map(lower).collect())
    };
    match knobs::torque_remedy(&all, "main-forced-cooling", slower) {
        Some(TorqueRemedy::Cooling(advice) | TorqueRemedy::Feed(advice)) => warn(AtMost(limit), [advice]),
        None => ok(AtMost(limit)),
    }
}

/// Judges the greatest speed of the turned ends, with the knob at any position, against the highest speed of the work
/// axis, whose motor and chuck turn with it.
pub(super) fn judge_speed(lathe: &PolygonLathe) -> Option<Judgement> {
    let (speed, most) = (greatest_speed(lathe), lathe.params.axes.work.limit);
    if speed <= most {
        return ok(AtMost(most));
    }
    let fields = TURNED_ENDS.map(|fields| fields.speed).into_iter().zip(lathe.params.turned_ends.iter());
    let fast = fields.filter(|(_, end)| end.on && end.speed > most);
    let sets: Vec<_> = fast.map(|(field, _)| at_most(FIELDS, field, most)).collect();
    let advice = Advice::from(msg!("polygon.work-runs-along", speed = (speed, 0), limit = (most, 0)));
    fail(AtMost(most), [advice.setting(msg!("advice.set-speed", speed = (most, 0)), sets)])
}

/// Judges the ramp of the inverter against the shortest one to the greatest speed of the turned ends.
pub(super) fn judge_ramp(lathe: &PolygonLathe) -> Option<Judgement> {
    let speed = programmed_speed(lathe);
    let at_knob =
        lathe.knob_ends().higher.map(|percent| SpeedAtKnob { percent, speed: lathe.speed_at(speed, percent) });
    main_spindle::judge_ramp(&lathe.params.main_spindle(), speed, at_knob, (FIELDS, "main-ramp"))
}

/// The main motor for the sizing, at the turned end with the greatest demand on it; none without turned ends, or if the
/// cutting force is not known.
pub(super) fn inverter(lathe: &PolygonLathe) -> Option<InverterDrive> {
    let (p, (end, _)) = (&lathe.params, lathe.hardest_end()?);
    let gear = p.main_gear();
    (lathe.greatest_end_force() > 0.0).then(|| InverterDrive {
        id: "main",
        name: NAME,
        torque: through_gear(lathe.end_torque(end), gear, p.drive_efficiency / 100.0),
        speed: end.speed * gear,
        top_speed: p.main.top,
        site_share: p.site_share / 100.0,
        brake: 0.0,
        cycle: None,
        radians_per_rpm: gear * RPM,
        load_at_motor: load_at_motor(p),
        rotor: p.main.rotor,
        gear: None,
        full: None,
        cooled_at: (!p.main.forced_cooling)
            .then(|| gear * lathe.speed_at(end.speed, lathe.knob_ends().lower.unwrap_or(100.0))),
        fields: None,
    })
}

/// Chuck, work and the work's motor at the shaft of the main motor, against the friction of the spindle.
fn load_at_motor(p: &Params) -> Load {
    p.main.load_at_motor(p.main_spindle_gear(), p.axes.work.inertia)
}

/// The main motor in a part of a run: friction always, and the greatest cut while the slide is in the stock and the
/// spindle turns it.
pub(super) fn in_run(lathe: &PolygonLathe, run: &dyn Samples, segments: &[RunSegment]) -> Option<SpindleRun> {
    let p = &lathe.params;
    let until = segments.last().map(|segment| segment.t + segment.seconds)?;
    let cut = lathe.turned_ends().map(|(end, _)| lathe.cut_torque(end)).fold(0.0, f64::max);
    let torque = through_gear(cut, p.main_gear(), p.drive_efficiency / 100.0);
    let idle = Motion::new(speed_segments(segments, p.main_gear() * RPM), load_at_motor(p), 0.0);
    let spans = super::progress::turning_spans(lathe, run, until);
    let cuts = spans.into_iter().map(|(begin, end)| CutSpan { begin, end, torque }).collect();
    lathe.has_main_spindle().then(|| p.main.run(NAME, idle, cuts))
}

/// Greatest speed (r/min) that the knob allows.
pub(super) fn speed_at_highest_knob(lathe: &PolygonLathe) -> f64 {
    lathe.speed_at(programmed_speed(lathe), lathe.knob_ends().higher.unwrap_or(100.0))
}

/// The encoder by which the control feeds per revolution and cuts a thread.
pub(super) fn encoder(lathe: &PolygonLathe) -> Option<SpindleEncoder> {
    let of = &lathe.params.encoder;
    let speed = speed_at_highest_knob(lathe) * of.ratio();
    lathe.has_main_spindle().then_some(SpindleEncoder { name: NAME, speed, lines: of.lines })
}

/// The fan of its motor with forced cooling.
pub(super) fn devices(lathe: &PolygonLathe) -> Vec<AskedDevice> {
    Vec::from_iter(main_spindle::fan(NAME, lathe.has_main_spindle() && lathe.params.main.forced_cooling))
}

/// Charts of its torque and power over its speed, with the turned ends.
pub(super) fn charts(lathe: &PolygonLathe, points: usize) -> Vec<Chart> {
    if !lathe.has_main_spindle() {
        return Vec::new();
    }
    let (p, spindle) = (&lathe.params, lathe.params.main_spindle());
    let continuous = p.main_continuous();
    let cut = lathe.turned_ends().map(|(end, _)| (end.speed, lathe.end_torque(end)));
    main_spindle::charts_by_speed(
        SpeedCurves {
            stages: vec![("polygon.chart.main-continuous", 0, continuous, spindle.speed_at_10v)],
            short_time: Some((spindle.driving_motor(), spindle.speed_at_10v)),
            cut: if lathe.greatest_end_force() > 0.0 { cut.collect() } else { Vec::new() },
        },
        points,
    )
}

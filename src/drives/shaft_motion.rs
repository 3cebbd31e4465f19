//! Motion of a shaft under load: torque of its motor over time for any rotor, and the energy in both directions.

use super::duty::{counted_pause, with_pause};
use super::load::{Load, Regeneration, power, through_gear};
use super::servo::Servo;
use super::spindle_motor::MotorCurve;
use crate::math::RPM;

/// A piece of a motion with constant acceleration, at a steady speed or at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpeedSegment {
    /// Start, s.
    pub t: f64,
    /// Duration, s.
    pub seconds: f64,
    /// Speed at the start, rad/s, signed.
    pub from: f64,
    /// Speed at the end, rad/s, signed.
    pub to: f64,
}

impl SpeedSegment {
    /// Splits the segment at a time within it.
    fn split(self, t: f64) -> [SpeedSegment; 2] {
        let first = t - self.t;
        let between = self.from + (self.to - self.from) * first / self.seconds;
        [
            SpeedSegment { seconds: first, to: between, ..self },
            SpeedSegment { t, seconds: self.seconds - first, from: between, to: self.to },
        ]
    }
}

/// The motion of a shaft with its load, without the rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    segments: Vec<SpeedSegment>,
    /// The work during each segment: every motor that is tried asks for it.
    works: Vec<Work>,
    load: Load,
    hold: f64,
    weight: f64,
    strikes: Strikes,
    pause: f64,
    /// Start and end times (s) of the load's steady torque; `None`: it always acts.
    loaded_spans: Option<Vec<(f64, f64)>>,
    /// Further steady torques, in order and without overlaps; `None` for a load that is always in work.
    cut_spans: Option<Vec<CutSpan>>,
}

/// The work during a segment.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Work {
    /// Steady torque of load and cut at the shaft, Nm.
    torque: f64,
    /// Whether the cut asks torque, or the steady torque of a load without cuts.
    is_at_work: bool,
}

/// A span of a cut with one torque, which acts besides the steady torque of the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutSpan {
    /// Start, s.
    pub begin: f64,
    /// End, s.
    pub end: f64,
    /// Torque at the shaft, Nm.
    pub torque: f64,
}

/// An interrupted cut at a steady speed: its torque around the mean, which is the steady torque of the load. All zero without such a cut.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Strikes {
    /// Greatest torque at the shaft, Nm.
    pub peak: f64,
    /// Mean of the squared torque, minus the square of its mean, (Nm)².
    pub spread: f64,
}

impl Strikes {
    /// Strikes of one torque during a share of the time, from their greatest and their mean torque, Nm. The mean square of such a torque is
    /// `T² c` with the share `c`. Source: sizing facts, section 7, polygon add-on.
    pub fn new(peak: f64, mean: f64) -> Strikes {
        Strikes { peak, spread: (peak * mean - mean * mean).max(0.0) }
    }
}

/// The greatest torque of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PeakTorque {
    /// Torque, Nm.
    pub torque: f64,
    /// Its time, s.
    pub t: f64,
}

/// Load of a whole motion on a motor.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MotorLoad {
    /// Greatest torque.
    pub peak: PeakTorque,
    /// Effective torque, Nm.
    pub effective: f64,
    /// Greatest speed, rad/s.
    pub speed: f64,
    /// Energy from the motor, J.
    pub given: f64,
    /// Energy back to the motor, J.
    pub returned: f64,
    /// Duration of the motion, s.
    pub seconds: f64,
}

/// The torque of a segment over the inertia of the rotor: `a + b J`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TorqueLine {
    pub segment: SpeedSegment,
    /// Torque without a rotor, Nm.
    pub torque: f64,
    /// Acceleration, rad/s².
    pub slope: f64,
    /// Greatest torque of its strikes, Nm.
    pub strike: f64,
    /// Addition of its strikes to the mean square, (Nm)².
    pub spread: f64,
}

/// Load on a brake resistor.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ResistorLoad {
    /// Mean power over a run and its pause, W.
    pub mean: f64,
    /// Greatest energy of a stop, J.
    pub stop: f64,
    /// Greatest power back to the amplifier, W. It counts in full, because the capacitors may already be full.
    pub peak: f64,
}

impl ResistorLoad {
    /// The greater of each figure.
    pub fn max(self, other: ResistorLoad) -> ResistorLoad {
        ResistorLoad {
            mean: self.mean.max(other.mean),
            stop: self.stop.max(other.stop),
            peak: self.peak.max(other.peak),
        }
    }
}

/// Largest relative change of speed in a segment that counts as steady, for rounding errors.
const STEADY: f64 = 1e-6;

/// Most demanding operating point of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct OperatingPoint {
    /// Torque, Nm.
    pub torque: f64,
    /// Highest speed with this torque, r/min.
    pub speed: f64,
    /// Torque as a fraction of the motor's short-time torque at this speed.
    pub share: f64,
}

/// Speed in rad/s below which a shaft counts as at rest, for rounding errors.
const REST_SPEED: f64 = 1e-9;

impl Motion {
    /// A motion from its segments, without gaps. The steady torque of the load acts against the motion; at standstill the motor holds `hold`
    /// Nm.
    pub fn new(segments: impl IntoIterator<Item = SpeedSegment>, load: Load, hold: f64) -> Motion {
        let segments = segments.into_iter().flat_map(at_reversal).filter(|segment| segment.seconds > 0.0).collect();
        let motion = Motion {
            segments,
            works: Vec::new(),
            load,
            hold,
            weight: 0.0,
            strikes: Strikes::default(),
            pause: 0.0,
            loaded_spans: None,
            cut_spans: None,
        };
        motion.with_works()
    }

    /// The motion, with the work during each of its segments looked up.
    fn with_works(self) -> Motion {
        let works = self.segments.iter().map(|segment| self.work(segment)).collect();
        Motion { works, ..self }
    }

    /// The same motion with these of its segments alone, which need not follow one another.
    pub(super) fn of_segments(&self, places: &[usize]) -> Motion {
        let segments = places.iter().filter_map(|at| self.segments.get(*at).copied()).collect();
        let works = places.iter().filter_map(|at| self.works.get(*at).copied()).collect();
        Motion { segments, works, loaded_spans: None, cut_spans: None, ..*self }
    }

    /// The motion, with an interrupted cut during all steady speeds.
    pub fn with_strikes(self, strikes: Strikes) -> Motion {
        Motion { strikes, ..self }
    }

    /// The motion, with a weight that it lifts in the positive direction and holds at standstill; its torque at rest in Nm.
    pub fn with_weight(self, weight: f64) -> Motion {
        Motion { weight, ..self }
    }

    /// The motion, followed by a standstill of `pause` seconds until the next run.
    pub fn with_pause(self, pause: f64) -> Motion {
        Motion { pause, ..self }
    }

    /// The motion, with the load's steady torque and strikes only within these times (s), in order and without overlaps; otherwise it
    /// idles.
    pub fn with_loaded_spans(self, spans: Vec<(f64, f64)>) -> Motion {
        let segments = split_at(&self.segments, spans.iter().flat_map(|(from, to)| [*from, *to]));
        Motion { segments, loaded_spans: Some(spans), ..self }.with_works()
    }

    /// The motion with the torques of a cut besides the steady torque of the load.
    pub fn with_cuts(self, spans: Vec<CutSpan>) -> Motion {
        let segments = split_at(&self.segments, spans.iter().flat_map(|cut| [cut.begin, cut.end]));
        Motion { segments, cut_spans: Some(spans), ..self }.with_works()
    }

    /// The motion of a load without inertia: its steady torques alone.
    pub fn without_inertia(self) -> Motion {
        Motion { load: Load { inertia: 0.0, ..self.load }, ..self }
    }

    /// Torque (Nm) at standstill.
    fn at_rest(&self) -> f64 {
        self.hold + self.weight
    }

    /// Torque (Nm) of a cut during a segment; none for a load without cuts.
    fn cut_torque(&self, segment: &SpeedSegment) -> Option<f64> {
        let middle = segment.t + 0.5 * segment.seconds;
        let cuts = self.cut_spans.as_ref()?;
        let at = cuts.partition_point(|cut| cut.begin <= middle).checked_sub(1);
        let within = at.and_then(|at| cuts.get(at)).filter(|cut| middle < cut.end);
        Some(within.map_or(0.0, |cut| cut.torque))
    }

    /// Whether the load's steady torque acts during a segment.
    fn is_loaded(&self, segment: &SpeedSegment) -> bool {
        let middle = segment.t + 0.5 * segment.seconds;
        self.loaded_spans.as_ref().is_none_or(|spans| {
            let at = spans.partition_point(|(from, _)| *from <= middle);
            at.checked_sub(1).and_then(|at| spans.get(at)).is_some_and(|(_, to)| middle < *to)
        })
    }

    /// The work during a segment.
    fn work(&self, segment: &SpeedSegment) -> Work {
        let (is_loaded, cut) = (self.is_loaded(segment), self.cut_torque(segment));
        Work {
            torque: if is_loaded { self.load.torque } else { 0.0 } + cut.unwrap_or(0.0),
            is_at_work: cut.map_or(is_loaded, |torque| torque > 0.0),
        }
    }

    /// Its segments, each with its work.
    fn worked(&self) -> impl Iterator<Item = (&SpeedSegment, Work)> {
        self.segments.iter().zip(self.works.iter().copied())
    }

    /// Time (s) under load: with the steady torque, or while the speed changes.
    pub fn loaded_time(&self) -> f64 {
        let counts = |(segment, work): &(&SpeedSegment, Work)| {
            let speed = segment.from.abs().max(segment.to.abs());
            speed >= REST_SPEED && (work.is_at_work || (segment.to - segment.from).abs() > STEADY * speed)
        };
        self.worked().filter(counts).map(|(segment, _)| segment.seconds).sum()
    }

    /// Its segments; none reverses its direction.
    pub fn segments(&self) -> &[SpeedSegment] {
        &self.segments
    }

    /// Torque in Nm during a segment, positive in the positive direction: steady torque and `(J_L / η + J_M) α` while the shaft accelerates,
    /// `(J_L η + J_M) α` while it decelerates; a weight takes `T / η` upwards and gives `T η` downwards. Source: sizing facts 2.2.
    pub fn torque(&self, segment: &SpeedSegment, rotor: f64) -> f64 {
        self.torque_against(self.work(segment).torque, segment, rotor)
    }

    /// The same against a steady torque (Nm) of the work.
    fn torque_against(&self, steady: f64, segment: &SpeedSegment, rotor: f64) -> f64 {
        let SpeedSegment { from, to, seconds, .. } = *segment;
        if from.abs() < REST_SPEED && to.abs() < REST_SPEED {
            return self.at_rest();
        }
        let side = (from + to).signum();
        let rises = side * (to - from) > 0.0;
        let change = |by: f64| by * (to - from).abs() / seconds;
        let along = if rises {
            steady + change(self.load.accelerating(rotor, 1.0, 1.0))
        } else {
            steady - change(self.load.braking(rotor, 1.0, 1.0))
        };
        side * along + through_gear(side * self.weight, 1.0, self.load.efficiency) * side
    }

    /// Each segment with its torque as `a + b J` of the rotor's inertia, as [`Motion::greatest`] takes it.
    pub(super) fn torque_lines(&self) -> impl Iterator<Item = TorqueLine> {
        self.worked().map(|(segment, work)| {
            let torque = self.torque_against(work.torque, segment, 0.0);
            let (greatest, spread) = self.greatest(segment, work, 0.0);
            let rests = segment.from.abs() < REST_SPEED && segment.to.abs() < REST_SPEED;
            let slope = if rests { 0.0 } else { (segment.to - segment.from) / segment.seconds };
            TorqueLine { segment: *segment, torque, slope, strike: greatest, spread }
        })
    }

    /// Pause (s) after the motion, and the torque (Nm) at its standstill.
    pub(super) fn rest(&self) -> (f64, f64) {
        (self.pause, self.at_rest())
    }

    /// Greatest torque in Nm during a segment, without sign, and the addition of its strikes to the mean square, (Nm)².
    fn greatest(&self, segment: &SpeedSegment, work: Work, torque: f64) -> (f64, f64) {
        let speed = segment.from.abs().max(segment.to.abs());
        let is_steady = speed >= REST_SPEED && (segment.to - segment.from).abs() <= STEADY * speed;
        let strikes = is_steady && work.is_at_work;
        if strikes { (torque.abs().max(self.strikes.peak), self.strikes.spread) } else { (torque.abs(), 0.0) }
    }

    /// Greatest torque in Nm of the strikes during a segment, without sign; none where the work does not strike.
    pub fn strike(&self, segment: &SpeedSegment) -> Option<f64> {
        let (strike, _) = self.greatest(segment, self.work(segment), 0.0);
        (strike > 0.0).then_some(strike)
    }

    /// Load of the whole motion on a motor with a rotor in kg m².
    pub fn motor_load(&self, rotor: f64) -> MotorLoad {
        let mut load = MotorLoad::default();
        let mut square = 0.0;
        for (segment, work) in self.worked() {
            let torque = self.torque_against(work.torque, segment, rotor);
            let energy = 0.5 * torque * (segment.from + segment.to) * segment.seconds;
            let (greatest, spread) = self.greatest(segment, work, torque);
            if greatest > load.peak.torque {
                load.peak = PeakTorque { torque: greatest, t: segment.t };
            }
            square += (torque * torque + spread) * segment.seconds;
            load.speed = load.speed.max(segment.from.abs()).max(segment.to.abs());
            load.given += energy.max(0.0);
            load.returned += (-energy).max(0.0);
            load.seconds += segment.seconds;
        }
        if load.seconds > 0.0 {
            load.effective = with_pause((square / load.seconds).sqrt(), load.seconds, self.pause, self.at_rest());
        }
        load
    }

    /// The operating point with the largest fraction of the motor's short-time torque at its speed.
    pub fn worst_point(&self, motor: &Servo) -> OperatingPoint {
        self.worst_point_under(motor.rotor, |_, speed| motor.short_time_torque(speed))
    }

    /// The operating point with the largest fraction of the torque (Nm) that a drive gives at a speed in r/min, with a rotor in kg m². The
    /// first argument of `most` is whether the drive brakes.
    pub fn worst_point_under(&self, rotor: f64, most: impl Fn(bool, f64) -> f64) -> OperatingPoint {
        let mut worst_point = OperatingPoint::default();
        for (segment, work) in self.worked() {
            let signed = self.torque_against(work.torque, segment, rotor);
            let (torque, _) = self.greatest(segment, work, signed);
            let brakes = signed * (segment.from + segment.to) < 0.0;
            // Torque of a motor with a shaft fan is least at the slow end; of equal shares the fast end is taken.
            let fast = segment.from.abs().max(segment.to.abs()) / RPM;
            let slow = segment.from.abs().min(segment.to.abs()) / RPM;
            for speed in [fast, slow] {
                let share = torque / most(brakes, speed);
                if share > worst_point.share {
                    worst_point = OperatingPoint { torque, speed, share };
                }
            }
        }
        worst_point
    }

    /// Effective torque as a fraction of a motor's continuous curve, over the motion and its pause: `√(Σ ∫ (T / M(n))² dt / t)`. Above base
    /// speed the curve falls, so that a torque heats the motor as a greater one does below. Source: turning spindle facts, 4.
    pub fn effective_share(&self, rotor: f64, curve: &MotorCurve) -> f64 {
        let (mut square, mut seconds) = (0.0, self.counted_pause());
        for (segment, work) in self.worked() {
            let speeds = (segment.from / RPM, segment.to / RPM);
            let torque = self.torque_against(work.torque, segment, rotor);
            square += curve.mean_square(torque, speeds) * segment.seconds;
            seconds += segment.seconds;
        }
        if seconds > 0.0 { (square / seconds).sqrt() } else { 0.0 }
    }

    /// Energies (J) that come back at the shaft, one for each time that the load drives the motor, in their order. Source: sizing facts
    /// 2.4.
    pub fn returns(&self, rotor: f64) -> Vec<f64> {
        let mut all = vec![0.0];
        for (segment, work) in self.worked() {
            let back =
                -0.5 * self.torque_against(work.torque, segment, rotor) * (segment.from + segment.to) * segment.seconds;
            match all.last_mut() {
                Some(last) if back > 0.0 => *last += back,
                Some(last) if *last > 0.0 => all.push(0.0),
                _ => {}
            }
        }
        all.retain(|energy| *energy > 0.0);
        all
    }

    /// Mean speed in r/min over the whole motion and its pause, without sign.
    pub fn mean_speed(&self) -> f64 {
        let (mut way, mut seconds) = (0.0, self.counted_pause());
        for segment in &self.segments {
            way += 0.5 * (segment.from.abs() + segment.to.abs()) * segment.seconds;
            seconds += segment.seconds;
        }
        if seconds > 0.0 { way / seconds / RPM } else { 0.0 }
    }

    /// Part of the pause (s) that counts for the motor's heating.
    fn counted_pause(&self) -> f64 {
        counted_pause(self.segments.iter().map(|segment| segment.seconds).sum(), self.pause)
    }

    /// Starts from standstill per minute of the motion.
    pub fn starts_per_minute(&self) -> f64 {
        let starts = self
            .segments
            .iter()
            .filter(|segment| segment.from.abs() < REST_SPEED && segment.to.abs() >= REST_SPEED)
            .count();
        let seconds = self.segments.iter().map(|segment| segment.seconds).sum::<f64>();
        // A single start has no frequency.
        if starts > 1 { 60.0 * starts as f64 / seconds } else { 0.0 }
    }

    /// Load of the regenerated energy on a brake resistor, after the capacitors have taken their part at each stop. Source: sizing facts
    /// 2.4.
    pub fn to_resistor(&self, rotor: f64, regeneration: &Regeneration) -> ResistorLoad {
        self.to_resistor_over(self.counted_seconds(), rotor, regeneration)
    }

    /// Time (s) of the motion and the part of its pause that counts.
    pub(super) fn counted_seconds(&self) -> f64 {
        self.segments.iter().fold(self.counted_pause(), |sum, segment| sum + segment.seconds)
    }

    /// The same load with its mean over a time (s).
    pub(super) fn to_resistor_over(&self, seconds: f64, rotor: f64, regeneration: &Regeneration) -> ResistorLoad {
        let mut taken = ResistorLoad::default();
        let (mut sum, mut stop) = (0.0, 0.0);
        let mut end = |stop: &mut f64, most: &mut f64| {
            let joules = regeneration.to_resistor(core::mem::take(stop));
            sum += joules;
            *most = most.max(joules);
        };
        for (segment, work) in self.worked() {
            let torque = self.torque_against(work.torque, segment, rotor);
            let back = -0.5 * torque * (segment.from + segment.to) * segment.seconds;
            if back > 0.0 {
                stop += back;
                let most = power(-torque, segment.from).max(power(-torque, segment.to));
                taken.peak = taken.peak.max(regeneration.efficiency * most);
            } else {
                end(&mut stop, &mut taken.stop);
            }
        }
        end(&mut stop, &mut taken.stop);
        if seconds > 0.0 {
            taken.mean = sum / seconds;
        }
        if taken.stop > 0.0 { taken } else { ResistorLoad::default() }
    }
}

/// Energy in J that motors on one DC bus draw from the supply and return to it; energy returned by one motor may drive another at the same
/// time. Each motor is a motion with a rotor inertia in kg m². Source: sizing facts 2.4, power of all axes added.
pub fn on_one_bus(motors: &[(&Motion, f64)]) -> (f64, f64) {
    // Power is linear within a segment, so power and slope change only at the start and end of a segment.
    let mut changes: Vec<(f64, f64, f64)> = Vec::new();
    for (motion, rotor) in motors {
        for (segment, work) in motion.worked() {
            let torque = motion.torque_against(work.torque, segment, *rotor);
            let (begin, end) = (power(torque, segment.from), power(torque, segment.to));
            let slope = (end - begin) / segment.seconds;
            changes.push((segment.t, begin, slope));
            changes.push((segment.t + segment.seconds, -end, -slope));
        }
    }
    changes.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut given, mut returned) = (0.0, 0.0);
    let (mut t, mut watts, mut slope) = (0.0, 0.0, 0.0);
    for (next, jump, bend) in changes {
        let end = watts + slope * (next - t);
        let (over, under) = areas(watts, end, next - t);
        (given, returned) = (given + over, returned + under);
        (t, watts, slope) = (next, end + jump, slope + bend);
    }
    (given, returned)
}

/// Areas above and below 0 of a straight line from `a` to `b` over `seconds`.
fn areas(a: f64, b: f64, seconds: f64) -> (f64, f64) {
    let whole = 0.5 * (a + b) * seconds;
    if a * b >= 0.0 {
        return (whole.max(0.0), (-whole).max(0.0));
    }
    let crossing = seconds * a / (a - b);
    let (first, second) = (0.5 * a * crossing, 0.5 * b * (seconds - crossing));
    (first.max(second), -first.min(second))
}

/// Least length (s) of a part: sums of times differ by rounding, and a sliver would have the work of one neighbour with the acceleration of the
/// other.
const SLIVER: f64 = 1e-9;

/// Splits segments at these times (s), which ascend.
fn split_at(segments: &[SpeedSegment], times: impl Iterator<Item = f64>) -> Vec<SpeedSegment> {
    let mut times = times.peekable();
    let mut parts = Vec::with_capacity(segments.len());
    for segment in segments {
        let mut rest = *segment;
        while times.next_if(|t| *t <= rest.t + SLIVER).is_some() {}
        while let Some(t) = times.next_if(|t| *t < rest.t + rest.seconds - SLIVER) {
            let [first, second] = rest.split(t);
            parts.push(first);
            rest = second;
        }
        parts.push(rest);
    }
    parts.retain(|segment| segment.seconds > 0.0);
    parts
}

/// Splits a segment where its direction reverses.
fn at_reversal(segment: SpeedSegment) -> impl Iterator<Item = SpeedSegment> {
    let SpeedSegment { t, seconds, from, to } = segment;
    let part = if from * to < 0.0 { from / (from - to) } else { 1.0 };
    let middle = if part < 1.0 { 0.0 } else { to };
    let first = SpeedSegment { t, seconds: part * seconds, from, to: middle };
    let second = SpeedSegment { t: t + part * seconds, seconds: (1.0 - part) * seconds, from: middle, to };
    [first, second].into_iter()
}

//! The demand of a motion on many motors in turn: only the segments that can be decisive for some rotor inertia are computed again.

use super::duty::with_pause;
use super::load::Regeneration;
use super::servo::Servo;
use super::shaft_motion::{Motion, OperatingPoint, PeakTorque, ResistorLoad, TorqueLine};

/// A motion, prepared for the trial of many servo motors.
///
/// The torque of a segment is linear in the rotor's inertia `J`, `T = a + b J`: a segment whose `a` and `b` are both below those of a faster
/// one is never the hardest, whatever the motor, because its short-time torque falls with the speed. The effective torque needs three sums,
/// `Σ T² t = Σ a² t + 2 J Σ a b t + J² Σ b² t`. Source: sizing facts 2.2.
#[derive(Debug, Clone, PartialEq)]
pub struct MotorTrial {
    /// The segments that may have the greatest torque, or the greatest share of a motor's torque.
    hardest: Motion,
    /// The segments that may return energy, and one between each two such stops.
    returning: Motion,
    /// The sums of `a² t` with the strikes, of `a b t` and of `b² t`.
    squares: [f64; 3],
    /// Duration of the motion, s, and with the part of its pause that counts.
    seconds: f64,
    counted: f64,
    /// Pause, s, and torque at rest, Nm.
    rest: (f64, f64),
    /// Greatest speed, rad/s.
    speed: f64,
}

/// Least inertia (kg m²) of a rotor: 0.01 kg cm², below those of all servo motors. Engineering choice.
const LEAST_ROTOR: f64 = 1e-6;

/// Relative difference from which on one torque counts as greater than another, far above rounding errors.
const GREATER: f64 = 1e-9;

/// A torque that no motor is asked below a speed: `a + b J` up to `speed` rad/s.
#[derive(Clone, Copy)]
struct Bound {
    a: f64,
    b: f64,
    speed: f64,
}

impl Bound {
    /// The torques of a segment without sign: one of both signs, and its strikes.
    fn of(line: &TorqueLine) -> impl Iterator<Item = Bound> + use<> {
        let speed = line.segment.from.abs().max(line.segment.to.abs());
        let all = [(line.torque, line.slope), (-line.torque, -line.slope), (line.strike, 0.0)];
        all.into_iter().filter(|(a, b)| *a > 0.0 || *b > 0.0).map(move |(a, b)| Bound { a, b, speed })
    }

    /// Whether another one is at most as great at each rotor and at most as fast.
    fn covers(&self, other: &Bound) -> bool {
        self.a >= other.a && self.b >= other.b && self.speed >= other.speed
    }

    /// The same, and greater at each rotor by more than rounding errors.
    fn exceeds(&self, other: &Bound) -> bool {
        let (a, b) = (self.a.abs(), self.b.abs() * LEAST_ROTOR);
        let gap = (self.a - other.a) + (self.b - other.b) * LEAST_ROTOR;
        self.covers(other) && gap > GREATER * a.max(b)
    }
}

/// Places of the segments that may be the hardest for some rotor; of equal ones all.
fn hardest(lines: &[TorqueLine]) -> Vec<usize> {
    let mut bounds: Vec<(usize, Bound)> =
        lines.iter().enumerate().flat_map(|(at, line)| Bound::of(line).map(move |bound| (at, bound))).collect();
    bounds.sort_by(|(_, one), (_, other)| other.speed.total_cmp(&one.speed).then(other.a.total_cmp(&one.a)));
    let mut frontier: Vec<Bound> = Vec::new();
    let mut places = Vec::new();
    for (at, bound) in bounds {
        if frontier.iter().any(|of| of.exceeds(&bound)) {
            continue;
        }
        places.push(at);
        if !frontier.iter().any(|of| of.covers(&bound)) {
            frontier.push(bound);
        }
    }
    places.sort_unstable();
    places.dedup();
    places
}

/// Places of the segments that return energy with some rotor, and of the first of each row of others.
fn returning(lines: &[TorqueLine]) -> Vec<usize> {
    let drives = |line: &TorqueLine| {
        let way = line.segment.from + line.segment.to;
        line.torque * way >= 0.0 && line.slope * way >= 0.0
    };
    let mut is_apart = true;
    let counts = |(at, line): (usize, &TorqueLine)| {
        let was_apart = core::mem::replace(&mut is_apart, drives(line));
        (!is_apart || !was_apart).then_some(at)
    };
    lines.iter().enumerate().filter_map(counts).collect()
}

impl MotorTrial {
    /// Prepares a motion.
    pub fn new(motion: &Motion) -> MotorTrial {
        let lines: Vec<TorqueLine> = motion.torque_lines().collect();
        let mut squares = [0.0; 3];
        let (mut seconds, mut speed) = (0.0, 0.0_f64);
        for TorqueLine { segment, torque, slope, spread, .. } in &lines {
            let terms = [torque * torque + spread, torque * slope, slope * slope];
            squares.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term * segment.seconds);
            seconds += segment.seconds;
            speed = speed.max(segment.from.abs()).max(segment.to.abs());
        }
        MotorTrial {
            hardest: motion.of_segments(&hardest(&lines)),
            returning: motion.of_segments(&returning(&lines)),
            squares,
            seconds,
            counted: motion.counted_seconds(),
            rest: motion.rest(),
            speed,
        }
    }

    /// Number of segments among which the hardest is sought for each motor.
    pub fn hardest_segments(&self) -> usize {
        self.hardest.segments().len()
    }

    /// Greatest torque with a rotor in kg m².
    pub fn peak(&self, rotor: f64) -> PeakTorque {
        self.hardest.motor_load(rotor).peak
    }

    /// Effective torque (Nm) with a rotor in kg m², over the motion and its pause.
    pub fn effective(&self, rotor: f64) -> f64 {
        let [plain, mixed, inert] = self.squares;
        let square = (plain + 2.0 * rotor * mixed + rotor * rotor * inert).max(0.0);
        let (pause, hold) = self.rest;
        if self.seconds > 0.0 { with_pause((square / self.seconds).sqrt(), self.seconds, pause, hold) } else { 0.0 }
    }

    /// Greatest speed, rad/s.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// The operating point with the largest fraction of a motor's short-time torque at its speed.
    pub fn worst_point(&self, motor: &Servo) -> OperatingPoint {
        self.hardest.worst_point(motor)
    }

    /// Load of the regenerated energy on a brake resistor, after the capacitors have taken their part at each stop.
    pub fn to_resistor(&self, rotor: f64, regeneration: &Regeneration) -> ResistorLoad {
        self.returning.to_resistor_over(self.counted, rotor, regeneration)
    }
}

//! Load of a motion on its motor: torque at the shaft over time for any rotor, and the energy in both directions.

use super::load::{Load, Regeneration, power, through_gear};
use super::servo::Servo;
use super::spindle_motor::MotorCurve;
use crate::math::RPM;

/// A part of a motion with constant acceleration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn {
    /// Start, s.
    pub t: f64,
    /// Duration, s.
    pub seconds: f64,
    /// Speed at the start, rad/s, signed.
    pub from: f64,
    /// Speed at the end, rad/s, signed.
    pub to: f64,
}

impl Turn {
    /// Splits the turn at a time within it.
    fn split(self, t: f64) -> [Turn; 2] {
        let first = t - self.t;
        let between = self.from + (self.to - self.from) * first / self.seconds;
        [
            Turn { seconds: first, to: between, ..self },
            Turn { t, seconds: self.seconds - first, from: between, to: self.to },
        ]
    }
}

/// The motion of a shaft with its load, without the rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    turns: Vec<Turn>,
    load: Load,
    hold: f64,
    weight: f64,
    strikes: Strikes,
    pause: f64,
    /// Start and end times (s) of the load's steady torque; `None`: it always acts.
    works: Option<Vec<(f64, f64)>>,
    /// Further steady torques, in order and without overlaps; `None` for a load that is always in work.
    cuts: Option<Vec<CutSpan>>,
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

/// Load of a motion on a motor.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Work {
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

/// Largest relative change of speed in a turn that counts as steady, for rounding errors.
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
const STANDS: f64 = 1e-9;

impl Motion {
    /// A motion from its turns, without gaps. The steady torque of the load acts against the motion; at standstill the motor holds `hold`
    /// Nm.
    pub fn new(turns: impl IntoIterator<Item = Turn>, load: Load, hold: f64) -> Motion {
        let turns = turns.into_iter().flat_map(at_reversal).filter(|turn| turn.seconds > 0.0).collect();
        Motion { turns, load, hold, weight: 0.0, strikes: Strikes::default(), pause: 0.0, works: None, cuts: None }
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
    pub fn with_work(self, works: Vec<(f64, f64)>) -> Motion {
        let turns = split_at(&self.turns, works.iter().flat_map(|(from, to)| [*from, *to]));
        Motion { turns, works: Some(works), ..self }
    }

    /// The motion with the torques of a cut besides the steady torque of the load.
    pub fn with_cuts(self, cuts: Vec<CutSpan>) -> Motion {
        let turns = split_at(&self.turns, cuts.iter().flat_map(|cut| [cut.begin, cut.end]));
        Motion { turns, cuts: Some(cuts), ..self }
    }

    /// The motion of a load without inertia: its steady torques alone.
    pub fn without_inertia(self) -> Motion {
        Motion { load: Load { inertia: 0.0, ..self.load }, ..self }
    }

    /// Torque (Nm) at standstill.
    fn at_rest(&self) -> f64 {
        self.hold + self.weight
    }

    /// Torque (Nm) of a cut during a turn; none for a load without cuts.
    fn cut(&self, turn: &Turn) -> Option<f64> {
        let middle = turn.t + 0.5 * turn.seconds;
        let cuts = self.cuts.as_ref()?;
        let at = cuts.partition_point(|cut| cut.begin <= middle).checked_sub(1);
        let within = at.and_then(|at| cuts.get(at)).filter(|cut| middle < cut.end);
        Some(within.map_or(0.0, |cut| cut.torque))
    }

    /// Whether the load's steady torque acts during a turn.
    fn works(&self, turn: &Turn) -> bool {
        let middle = turn.t + 0.5 * turn.seconds;
        self.works.as_ref().is_none_or(|works| {
            let at = works.partition_point(|(from, _)| *from <= middle);
            at.checked_sub(1).and_then(|at| works.get(at)).is_some_and(|(_, to)| middle < *to)
        })
    }

    /// Whether the cut of a turn asks torque, or the steady torque of a load without cuts.
    fn cuts_or_works(&self, turn: &Turn) -> bool {
        self.cut(turn).map_or_else(|| self.works(turn), |torque| torque > 0.0)
    }

    /// Time (s) under load: with the steady torque, or while the speed changes.
    pub fn loaded(&self) -> f64 {
        let is_loaded = |turn: &&Turn| {
            let speed = turn.from.abs().max(turn.to.abs());
            speed >= STANDS && (self.cuts_or_works(turn) || (turn.to - turn.from).abs() > STEADY * speed)
        };
        self.turns.iter().filter(is_loaded).map(|turn| turn.seconds).sum()
    }

    /// The turns; none reverses its direction.
    pub fn turns(&self) -> &[Turn] {
        &self.turns
    }

    /// Torque in Nm during a turn, positive in the positive direction: steady torque and `(J_L / η + J_M) α` while the shaft accelerates,
    /// `(J_L η + J_M) α` while it decelerates; a weight takes `T / η` upwards and gives `T η` downwards. Source: sizing facts 2.2.
    pub fn torque(&self, turn: &Turn, rotor: f64) -> f64 {
        let Turn { from, to, seconds, .. } = *turn;
        if from.abs() < STANDS && to.abs() < STANDS {
            return self.at_rest();
        }
        let side = (from + to).signum();
        let rises = side * (to - from) > 0.0;
        let change = |by: f64| by * (to - from).abs() / seconds;
        let steady = if self.works(turn) { self.load.torque } else { 0.0 } + self.cut(turn).unwrap_or(0.0);
        let along = if rises {
            steady + change(self.load.accelerating(rotor, 1.0, 1.0))
        } else {
            steady - change(self.load.braking(rotor, 1.0, 1.0))
        };
        side * along + through_gear(side * self.weight, 1.0, self.load.efficiency) * side
    }

    /// Greatest torque in Nm during a turn, without sign, and the addition of its strikes to the mean square, (Nm)².
    fn greatest(&self, turn: &Turn, torque: f64) -> (f64, f64) {
        let speed = turn.from.abs().max(turn.to.abs());
        let is_steady = speed >= STANDS && (turn.to - turn.from).abs() <= STEADY * speed;
        let strikes = is_steady && self.cuts_or_works(turn);
        if strikes { (torque.abs().max(self.strikes.peak), self.strikes.spread) } else { (torque.abs(), 0.0) }
    }

    /// Load of the whole motion with a rotor in kg m².
    pub fn work(&self, rotor: f64) -> Work {
        let mut work = Work::default();
        let mut square = 0.0;
        for turn in &self.turns {
            let torque = self.torque(turn, rotor);
            let energy = 0.5 * torque * (turn.from + turn.to) * turn.seconds;
            let (greatest, spread) = self.greatest(turn, torque);
            if greatest > work.peak.torque {
                work.peak = PeakTorque { torque: greatest, t: turn.t };
            }
            square += (torque * torque + spread) * turn.seconds;
            work.speed = work.speed.max(turn.from.abs()).max(turn.to.abs());
            work.given += energy.max(0.0);
            work.returned += (-energy).max(0.0);
            work.seconds += turn.seconds;
        }
        if work.seconds > 0.0 {
            work.effective = with_pause((square / work.seconds).sqrt(), work.seconds, self.pause, self.at_rest());
        }
        work
    }

    /// The operating point with the largest fraction of the motor's short-time torque at its speed.
    pub fn worst_point(&self, motor: &Servo) -> OperatingPoint {
        self.worst_point_under(motor.rotor, |_, speed| motor.short_time_torque(speed))
    }

    /// The operating point with the largest fraction of the torque (Nm) that a drive gives at a speed in r/min, with a rotor in kg m². The
    /// first argument of `most` is whether the drive brakes.
    pub fn worst_point_under(&self, rotor: f64, most: impl Fn(bool, f64) -> f64) -> OperatingPoint {
        let mut worst_point = OperatingPoint::default();
        for turn in &self.turns {
            let signed = self.torque(turn, rotor);
            let (torque, _) = self.greatest(turn, signed);
            let brakes = signed * (turn.from + turn.to) < 0.0;
            // Torque of a motor with a shaft fan is least at the slow end; of equal shares the fast end is taken.
            let fast = turn.from.abs().max(turn.to.abs()) / RPM;
            let slow = turn.from.abs().min(turn.to.abs()) / RPM;
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
        for turn in &self.turns {
            let speeds = (turn.from / RPM, turn.to / RPM);
            square += curve.mean_square(self.torque(turn, rotor), speeds) * turn.seconds;
            seconds += turn.seconds;
        }
        if seconds > 0.0 { (square / seconds).sqrt() } else { 0.0 }
    }

    /// Energies (J) that come back at the shaft, one for each time that the load drives the motor, in their order. Source: sizing facts
    /// 2.4.
    pub fn returns(&self, rotor: f64) -> Vec<f64> {
        let mut all = vec![0.0];
        for turn in &self.turns {
            let back = -0.5 * self.torque(turn, rotor) * (turn.from + turn.to) * turn.seconds;
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
        for turn in &self.turns {
            way += 0.5 * (turn.from.abs() + turn.to.abs()) * turn.seconds;
            seconds += turn.seconds;
        }
        if seconds > 0.0 { way / seconds / RPM } else { 0.0 }
    }

    /// Part of the pause (s) that counts for the motor's heating.
    fn counted_pause(&self) -> f64 {
        counted_pause(self.turns.iter().map(|turn| turn.seconds).sum(), self.pause)
    }

    /// Starts from standstill per minute of the motion.
    pub fn starts_per_minute(&self) -> f64 {
        let starts = self.turns.iter().filter(|turn| turn.from.abs() < STANDS && turn.to.abs() >= STANDS).count();
        let seconds = self.turns.iter().map(|turn| turn.seconds).sum::<f64>();
        // A single start has no frequency.
        if starts > 1 { 60.0 * starts as f64 / seconds } else { 0.0 }
    }

    /// Load of the regenerated energy on a brake resistor, after the capacitors have taken their part at each stop. Source: sizing facts
    /// 2.4.
    pub fn to_resistor(&self, rotor: f64, regeneration: &Regeneration) -> ResistorLoad {
        let mut taken = ResistorLoad::default();
        let (mut sum, mut stop, mut seconds) = (0.0, 0.0, self.counted_pause());
        let mut end = |stop: &mut f64, most: &mut f64| {
            let joules = regeneration.to_resistor(core::mem::take(stop));
            sum += joules;
            *most = most.max(joules);
        };
        for turn in &self.turns {
            seconds += turn.seconds;
            let torque = self.torque(turn, rotor);
            let back = -0.5 * torque * (turn.from + turn.to) * turn.seconds;
            if back > 0.0 {
                stop += back;
                let most = power(-torque, turn.from).max(power(-torque, turn.to));
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
    // Power is linear within a turn, so power and slope change only at the start and end of a turn.
    let mut changes: Vec<(f64, f64, f64)> = Vec::new();
    for (motion, rotor) in motors {
        for turn in &motion.turns {
            let torque = motion.torque(turn, *rotor);
            let (begin, end) = (power(torque, turn.from), power(torque, turn.to));
            let slope = (end - begin) / turn.seconds;
            changes.push((turn.t, begin, slope));
            changes.push((turn.t + turn.seconds, -end, -slope));
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

/// Duty type of an electric machine by IEC 60034-1, for a drive that turns under load or is at rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DutyType {
    /// S1: continuous duty.
    Continuous,
    /// S3: periodic duty with standstill; cyclic duration factor, %: 15, 25, 40 or 60.
    Intermittent(u8),
    /// S6: periodic duty without standstill, alternately loaded and idle; cyclic duration factor, %: 15, 25, 40 or 60.
    Periodic(u8),
}

/// Share of turning time from which a drive counts as turning without standstill. Chosen here, without a source.
const WITHOUT_STANDSTILL: f64 = 0.98;

/// Longest cycle of S3 and S6, seconds.
const LONGEST_CYCLE: f64 = 600.0;

/// Part of a pause (s) after a run that counts for the heating of a motor: a cycle has at most 10 min, because in a longer run the motor
/// reaches its final temperature whatever the pause. Source: sizing facts 2.8.
pub fn counted_pause(run: f64, pause: f64) -> f64 {
    pause.min((LONGEST_CYCLE - run).max(0.0))
}

/// Effective torque in Nm of a run and the following pause: `√((T² t + T_hold² t_pause) / (t + t_pause))`, from the effective torque and
/// the duration (s) of the run and the holding torque at standstill. For a pause of 10 min or more, a duty of its own, the result is at
/// least the holding torque.
/// Source: sizing facts 2.2 (7-9) and 2.8.
pub fn with_pause(effective: f64, run: f64, pause: f64, hold: f64) -> f64 {
    let counted = counted_pause(run, pause);
    let over_both = if counted > 0.0 {
        ((effective * effective * run + hold * hold * counted) / (run + counted)).sqrt()
    } else {
        effective
    };
    if pause >= LONGEST_CYCLE { over_both.max(hold.abs()) } else { over_both }
}

/// Duty type of a drive that turns for the share `turning` of a cycle and is loaded for the share `loaded`, both 0 to 1: the smallest
/// cyclic duration factor of the standard that covers it. Source: sizing facts 2.8, from memory.
pub fn duty_type(turning: f64, loaded: f64, cycle: f64) -> DutyType {
    if cycle > LONGEST_CYCLE {
        return DutyType::Continuous;
    }
    let covering = |share: f64| [15, 25, 40, 60].into_iter().find(|factor| share <= f64::from(*factor) / 100.0);
    match (covering(turning), covering(loaded)) {
        (Some(factor), _) => DutyType::Intermittent(factor),
        (None, Some(factor)) if turning >= WITHOUT_STANDSTILL => DutyType::Periodic(factor),
        _ => DutyType::Continuous,
    }
}

/// Splits turns at these times (s), which ascend.
fn split_at(turns: &[Turn], times: impl Iterator<Item = f64>) -> Vec<Turn> {
    let mut times = times.peekable();
    let mut parts = Vec::with_capacity(turns.len());
    for turn in turns {
        let mut rest = *turn;
        while times.next_if(|t| *t <= rest.t).is_some() {}
        while let Some(t) = times.next_if(|t| *t < rest.t + rest.seconds) {
            let [first, second] = rest.split(t);
            parts.push(first);
            rest = second;
        }
        parts.push(rest);
    }
    parts.retain(|turn| turn.seconds > 0.0);
    parts
}

/// Splits a turn where its direction reverses.
fn at_reversal(turn: Turn) -> impl Iterator<Item = Turn> {
    let Turn { t, seconds, from, to } = turn;
    let part = if from * to < 0.0 { from / (from - to) } else { 1.0 };
    let middle = if part < 1.0 { 0.0 } else { to };
    let first = Turn { t, seconds: part * seconds, from, to: middle };
    let second = Turn { t: t + part * seconds, seconds: (1.0 - part) * seconds, from: middle, to };
    [first, second].into_iter()
}

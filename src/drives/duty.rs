//! What a motion asks of its motor: torque at the shaft over time for any rotor, and the energy that goes to and fro.

use super::load::{Load, Regeneration};

/// A part of a motion with constant acceleration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn {
    /// When it begins, s.
    pub t: f64,
    /// How long it is, s.
    pub seconds: f64,
    /// Speed at its begin, rad/s, signed.
    pub from: f64,
    /// Speed at its end, rad/s, signed.
    pub to: f64,
}

/// The motion of a shaft with its load, without the rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    turns: Vec<Turn>,
    load: Load,
    hold: f64,
}

/// What a motion asks of a motor.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Work {
    /// Greatest torque, Nm, and when, s.
    pub peak: (f64, f64),
    /// Effective torque, Nm.
    pub effective: f64,
    /// Greatest speed, rad/s.
    pub speed: f64,
    /// Energy that the motor gives, J.
    pub given: f64,
    /// Energy that comes back to it, J.
    pub returned: f64,
    /// Seconds of the motion.
    pub seconds: f64,
}

/// Speed in rad/s below which a shaft stands: rounding leaves a little.
const STANDS: f64 = 1e-9;

impl Motion {
    /// A motion by its turns, without gaps. The steady torque of the load acts against the motion; at standstill the motor holds `hold` Nm.
    pub fn new(turns: impl IntoIterator<Item = Turn>, load: Load, hold: f64) -> Motion {
        let turns = turns.into_iter().flat_map(at_reversal).filter(|turn| turn.seconds > 0.0).collect();
        Motion { turns, load, hold }
    }

    /// The turns; none changes its direction.
    pub fn turns(&self) -> &[Turn] {
        &self.turns
    }

    /// Torque in Nm during a turn, positive where it drives in the positive direction: steady torque and `(J_L / η + J_M) α` while the shaft
    /// gets faster, `(J_L η + J_M) α` while it gets slower. Source: sizing facts 2.2.
    pub fn torque(&self, turn: &Turn, rotor: f64) -> f64 {
        let Turn { from, to, seconds, .. } = *turn;
        if from.abs() < STANDS && to.abs() < STANDS {
            return self.hold;
        }
        let side = (from + to).signum();
        let rises = side * (to - from) > 0.0;
        let change = |by: f64| by * (to - from).abs() / seconds;
        let along = if rises {
            self.load.torque + change(self.load.accelerating(rotor, 1.0, 1.0))
        } else {
            self.load.torque - change(self.load.braking(rotor, 1.0, 1.0))
        };
        side * along
    }

    /// The whole motion with a rotor in kg m².
    pub fn work(&self, rotor: f64) -> Work {
        let mut work = Work::default();
        let mut square = 0.0;
        for turn in &self.turns {
            let torque = self.torque(turn, rotor);
            let energy = 0.5 * torque * (turn.from + turn.to) * turn.seconds;
            if torque.abs() > work.peak.0 {
                work.peak = (torque.abs(), turn.t);
            }
            square += torque * torque * turn.seconds;
            work.speed = work.speed.max(turn.from.abs()).max(turn.to.abs());
            work.given += energy.max(0.0);
            work.returned += (-energy).max(0.0);
            work.seconds += turn.seconds;
        }
        if work.seconds > 0.0 {
            work.effective = (square / work.seconds).sqrt();
        }
        work
    }

    /// Mean power in W that a brake resistor takes of what comes back, whose capacitors take their part at each stop. Source: sizing facts 2.4.
    pub fn to_resistor(&self, rotor: f64, regeneration: &Regeneration) -> f64 {
        let (mut sum, mut stop, mut seconds) = (0.0, 0.0, 0.0);
        for turn in &self.turns {
            seconds += turn.seconds;
            let torque = self.torque(turn, rotor);
            let back = -0.5 * torque * (turn.from + turn.to) * turn.seconds;
            if back > 0.0 {
                stop += back;
            } else {
                sum += regeneration.to_resistor(core::mem::take(&mut stop));
            }
        }
        sum += regeneration.to_resistor(stop);
        if seconds > 0.0 { sum / seconds } else { 0.0 }
    }
}

/// A turn in two where it changes its direction.
fn at_reversal(turn: Turn) -> impl Iterator<Item = Turn> {
    let Turn { t, seconds, from, to } = turn;
    let part = if from * to < 0.0 { from / (from - to) } else { 1.0 };
    let middle = if part < 1.0 { 0.0 } else { to };
    let first = Turn { t, seconds: part * seconds, from, to: middle };
    let second = Turn { t: t + part * seconds, seconds: (1.0 - part) * seconds, from: middle, to };
    [first, second].into_iter()
}

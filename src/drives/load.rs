//! Load of a motor, reduced to its shaft: torque of a ramp, of a cycle, and the returned energy. Newton metres, kg m², rad/s, seconds.

/// A load driven through a gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// Moment of inertia at the shaft without the rotor, kg m².
    pub inertia: f64,
    /// Steady torque at the shaft, Nm; negative where the load drives the motor.
    pub torque: f64,
    /// Efficiency of the gear, 0 to 1.
    pub efficiency: f64,
}

/// A time with one torque.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase {
    /// Torque at the shaft, Nm.
    pub torque: f64,
    /// Seconds.
    pub seconds: f64,
}

/// A move between two standstills.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Move {
    /// Top speed, rad/s.
    pub speed: f64,
    /// Duration of each of the two linear ramps, s.
    pub ramp: f64,
    /// Time at top speed, s.
    pub seconds_at_speed: f64,
    /// Pause after the move, s.
    pub pause: f64,
    /// Torque in the pause, Nm: pull of the web on a motor at rest.
    pub hold: f64,
}

impl Move {
    /// Time from one start to the next, s.
    pub fn cycle(&self) -> f64 {
        2.0 * self.ramp + self.seconds_at_speed + self.pause
    }
}

/// Coasting time in seconds of a drive without current from `speed` rad/s to rest: `J ω / T`, with the inertia of all rotating parts;
/// infinite without a braking torque. Source: sizing facts 2.2, the fall without a torque of the motor.
pub fn coasting(inertia: f64, speed: f64, torque: f64) -> f64 {
    if torque > 0.0 { inertia * speed / torque } else { f64::INFINITY }
}

/// Torque in Nm for braking a drive from `speed` rad/s to rest in `seconds`: `J ω / t`. Source: sizing facts 2.2.
pub fn braking(inertia: f64, speed: f64, seconds: f64) -> f64 {
    inertia * speed / seconds
}

/// Power in W of a torque in Nm at a speed in rad/s: `T ω`.
pub fn power(torque: f64, speed: f64) -> f64 {
    torque * speed
}

/// Steady torque in Nm at the shaft of a motor for `torque` Nm at the output of a gear: `T / (i η)`; `T η / i` if the load drives the
/// motor. Source: sizing facts 2.2, checked as B7, C6 and D1.
pub fn through_gear(torque: f64, ratio: f64, efficiency: f64) -> f64 {
    if torque < 0.0 { torque * efficiency / ratio } else { torque / (ratio * efficiency) }
}

impl Load {
    /// Torque in Nm of a linear acceleration to `speed` in `seconds`, added to the steady torque: `(J_L / η + J_M) ω / t`.
    /// Source: sizing facts 2.2, checked as B8 and C7.
    pub fn accelerating(&self, rotor: f64, speed: f64, seconds: f64) -> f64 {
        (self.inertia / self.efficiency + rotor) * speed / seconds
    }

    /// Torque in Nm returned by a linear deceleration from `speed` in `seconds`, before the steady torque: `(J_L η + J_M) ω / t`.
    /// Source: sizing facts 2.2.
    pub fn braking(&self, rotor: f64, speed: f64, seconds: f64) -> f64 {
        (self.inertia * self.efficiency + rotor) * speed / seconds
    }

    /// Shortest linear ramp to `speed` in seconds with a torque in Nm: `(J_L / η + J_M) ω / (T - T_L)`; infinite if the steady torque uses
    /// all of it. Source: sizing facts 2.2 (7-2), checked as B11 and C10.
    pub fn shortest_ramp(&self, rotor: f64, speed: f64, torque: f64) -> f64 {
        let left = torque - self.torque;
        if left > 0.0 { self.accelerating(rotor, speed, 1.0) / left } else { f64::INFINITY }
    }

    /// Torques of a move with its pause. Source: sizing facts 2.2.
    pub fn phases(&self, rotor: f64, of: Move) -> [Phase; 4] {
        let rise = self.torque + self.accelerating(rotor, of.speed, of.ramp);
        let fall = self.torque - self.braking(rotor, of.speed, of.ramp);
        [(rise, of.ramp), (self.torque, of.seconds_at_speed), (fall, of.ramp), (of.hold, of.pause)]
            .map(|(torque, seconds)| Phase { torque, seconds })
    }

    /// Energy in J returned at the shaft by a stop from `speed` in `seconds`, minus the energy used by the steady torque:
    /// `½ (J_L η + J_M) ω² - ½ T_L ω t`; negative if the steady torque uses more. Source: sizing facts 2.4, checked as C15.
    pub fn stop_energy(&self, rotor: f64, speed: f64, seconds: f64) -> f64 {
        0.5 * (self.inertia * self.efficiency + rotor) * speed * speed - 0.5 * self.torque * speed * seconds
    }
}

/// Effective torque of a cycle in Nm, for the motor's heating: `√(Σ T² t / Σ t)`. Source: sizing facts 2.2 (7-9), checked as B16 and C13.
pub fn effective(phases: &[Phase]) -> f64 {
    let seconds: f64 = phases.iter().map(|phase| phase.seconds).sum();
    let square: f64 = phases.iter().map(|phase| phase.torque * phase.torque * phase.seconds).sum();
    if seconds > 0.0 { (square / seconds).sqrt() } else { 0.0 }
}

/// Regeneration data of a servo amplifier.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Regeneration {
    /// Efficiency of regeneration, 0 to 1.
    pub efficiency: f64,
    /// Energy in J that the amplifier's capacitors can store.
    pub capacitor: f64,
}

impl Regeneration {
    /// Energy in J per cycle to the brake resistor, of `returned` J at the shaft: `η E - E_c`, at least 0.
    /// Source: sizing facts 2.4, checked as C18; divided by the cycle time it is the power, C19.
    pub fn to_resistor(&self, returned: f64) -> f64 {
        (self.efficiency * returned - self.capacitor).max(0.0)
    }
}

/// Energy in J returned to the motor by a linear deceleration to standstill at one torque: `½ · -T ω t`; 0 if the motor drives.
/// Source: sizing facts 2.4, checked as C17.
pub fn returned(fall: Phase, speed: f64) -> f64 {
    0.5 * (-fall.torque).max(0.0) * speed * fall.seconds
}

//! What a motor drives, seen at its shaft: torque of a ramp, of a cycle, and the energy that comes back. Newton metres, kg m², rad/s, seconds.

/// A load behind its gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// Moment of inertia at the shaft without the rotor, kg m².
    pub inertia: f64,
    /// Steady torque at the shaft, Nm; negative where the load drives the motor.
    pub torque: f64,
    /// Efficiency of the gear, 0 to 1.
    pub efficiency: f64,
}

/// A stretch of one torque.
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
    /// Seconds of each of the two linear ramps.
    pub ramp: f64,
    /// Seconds at top speed.
    pub run: f64,
    /// Seconds of the pause behind it.
    pub pause: f64,
    /// Torque in the pause, Nm: what the web pulls at a motor that stands.
    pub hold: f64,
}

impl Move {
    /// Seconds from one start to the next.
    pub fn cycle(&self) -> f64 {
        2.0 * self.ramp + self.run + self.pause
    }
}

/// Seconds in which a drive without current coasts to rest from `speed` rad/s: `J ω / T`, with all that turns; infinite where nothing slows it.
/// Source: sizing facts 2.2, the fall without a torque of the motor.
pub fn coasting(inertia: f64, speed: f64, torque: f64) -> f64 {
    if torque > 0.0 { inertia * speed / torque } else { f64::INFINITY }
}

/// Torque in Nm that brings a drive from `speed` rad/s to rest in `seconds`: `J ω / t`. Source: sizing facts 2.2.
pub fn braking(inertia: f64, speed: f64, seconds: f64) -> f64 {
    inertia * speed / seconds
}

/// Power in W of a torque in Nm at a speed in rad/s: `T ω`.
pub fn power(torque: f64, speed: f64) -> f64 {
    torque * speed
}

/// Steady torque in Nm at the shaft of a motor that drives `torque` Nm behind a gear: `T / (i η)`. A load that drives the motor gives
/// `T η / i`. Source: sizing facts 2.2, checked as B7, C6 and D1.
pub fn through_gear(torque: f64, ratio: f64, efficiency: f64) -> f64 {
    if torque < 0.0 { torque * efficiency / ratio } else { torque / (ratio * efficiency) }
}

impl Load {
    /// Torque in Nm that a linear rise to `speed` in `seconds` takes besides the steady one: `(J_L / η + J_M) ω / t`.
    /// Source: sizing facts 2.2, checked as B8 and C7.
    pub fn accelerating(&self, rotor: f64, speed: f64, seconds: f64) -> f64 {
        (self.inertia / self.efficiency + rotor) * speed / seconds
    }

    /// Torque in Nm that a linear fall from `speed` in `seconds` gives back before the steady one: `(J_L η + J_M) ω / t`.
    /// Source: sizing facts 2.2.
    pub fn braking(&self, rotor: f64, speed: f64, seconds: f64) -> f64 {
        (self.inertia * self.efficiency + rotor) * speed / seconds
    }

    /// Shortest linear rise to `speed` in seconds with a torque in Nm: `(J_L / η + J_M) ω / (T - T_L)`; infinite where the steady torque
    /// takes all of it. Source: sizing facts 2.2 (7-2), checked as B11 and C10.
    pub fn shortest_ramp(&self, rotor: f64, speed: f64, torque: f64) -> f64 {
        let left = torque - self.torque;
        if left > 0.0 { self.accelerating(rotor, speed, 1.0) / left } else { f64::INFINITY }
    }

    /// Torques of a move with its pause. Source: sizing facts 2.2.
    pub fn phases(&self, rotor: f64, of: Move) -> [Phase; 4] {
        let rise = self.torque + self.accelerating(rotor, of.speed, of.ramp);
        let fall = self.torque - self.braking(rotor, of.speed, of.ramp);
        [(rise, of.ramp), (self.torque, of.run), (fall, of.ramp), (of.hold, of.pause)]
            .map(|(torque, seconds)| Phase { torque, seconds })
    }

    /// Energy in J that a stop from `speed` in `seconds` gives back at the shaft, less what the steady torque takes of it:
    /// `½ (J_L η + J_M) ω² - ½ T_L ω t`; negative where it takes more. Source: sizing facts 2.4, checked as C15.
    pub fn stop_energy(&self, rotor: f64, speed: f64, seconds: f64) -> f64 {
        0.5 * (self.inertia * self.efficiency + rotor) * speed * speed - 0.5 * self.torque * speed * seconds
    }
}

/// Effective torque of a cycle in Nm, by which a motor gets warm: `√(Σ T² t / Σ t)`. Source: sizing facts 2.2 (7-9), checked as B16 and C13.
pub fn effective(phases: &[Phase]) -> f64 {
    let seconds: f64 = phases.iter().map(|phase| phase.seconds).sum();
    let square: f64 = phases.iter().map(|phase| phase.torque * phase.torque * phase.seconds).sum();
    if seconds > 0.0 { (square / seconds).sqrt() } else { 0.0 }
}

/// How a servo amplifier takes energy back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Regeneration {
    /// Efficiency of the way back, 0 to 1.
    pub efficiency: f64,
    /// Energy in J that its capacitors take.
    pub capacitor: f64,
}

impl Regeneration {
    /// Energy in J of a cycle that its brake resistor takes, of `returned` J at the shaft: `η E - E_c`, at least 0.
    /// Source: sizing facts 2.4, checked as C18; divided by the cycle time it is the power, C19.
    pub fn to_resistor(&self, returned: f64) -> f64 {
        (self.efficiency * returned - self.capacitor).max(0.0)
    }
}

/// Energy in J that comes back to the motor in a linear fall to standstill at one torque: `½ · -T ω t`; 0 where the motor drives.
/// Source: sizing facts 2.4, checked as C17.
pub fn returned(fall: Phase, speed: f64) -> f64 {
    0.5 * (-fall.torque).max(0.0) * speed * fall.seconds
}

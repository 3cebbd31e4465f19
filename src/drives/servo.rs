//! A servo motor against its load: the four ratios that a drive displays in operation, and the limits that they keep.

use super::load::Load;

/// Ratings of a servo motor. Nm, r/min, kg m².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Servo {
    /// Rated torque.
    pub rated: f64,
    /// Torque that it holds at standstill for ever.
    pub stall: f64,
    /// Torque that it gives for a short time.
    pub peak: f64,
    /// Rated speed.
    pub rated_speed: f64,
    /// Highest speed.
    pub top_speed: f64,
    /// Moment of inertia of the rotor.
    pub rotor: f64,
}

/// What is asked of a motor. Nm, r/min.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Duty {
    /// Highest torque.
    pub peak: f64,
    /// Effective torque of a cycle.
    pub effective: f64,
    /// Highest speed.
    pub speed: f64,
}

/// Limits of a motor series: shares of peak torque and of stall torque, and the ratio of inertias.
///
/// Source: sizing facts 2.3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Acceptance {
    /// Highest load inertia over rotor inertia.
    pub inertia_ratio: f64,
    /// Highest share of the peak torque: the rest is for the control and for friction when cold.
    pub peak: f64,
    /// Highest share of the stall torque, as effective torque.
    pub effective: f64,
}

impl Acceptance {
    /// Mitsubishi's rules for the servos of its CNCs: 0.8 of the peak torque, 0.8 of the stall torque, with the ratio of inertias of the
    /// series. Source: sizing facts 2.3.
    pub fn mitsubishi(inertia_ratio: f64) -> Acceptance {
        Acceptance { inertia_ratio, peak: 0.8, effective: 0.8 }
    }

    /// The limits of a motor that starts so often in a minute: a stiff coupling of its speed to the load asks for a ratio of inertias of 3 at
    /// most above 100 starts, of 5 above 60. Source: sizing facts 2.3, MELSERVO J2S.
    pub fn at_starts(self, per_minute: f64) -> Acceptance {
        let most = match per_minute {
            often if often > 100.0 => 3.0,
            often if often >= 60.0 => 5.0,
            _ => f64::INFINITY,
        };
        Acceptance { inertia_ratio: self.inertia_ratio.min(most), ..self }
    }

    /// The limits where the air leaves a share of the continuous torque: the peak torque stays, for it warms the motor too briefly.
    pub fn derated(self, share: f64) -> Acceptance {
        Acceptance { effective: self.effective * share, ..self }
    }
}

/// A motor with its load, as shares of what it has: 1 is all of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shares {
    /// Load inertia over rotor inertia.
    pub inertia_ratio: f64,
    /// Highest torque of the peak torque.
    pub peak: f64,
    /// Effective torque of the stall torque.
    pub effective: f64,
    /// Highest speed of the highest speed.
    pub speed: f64,
}

/// Why a motor does not go, in the order in which it is asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reason {
    /// It does not turn so fast.
    Speed,
    /// Its peak torque does not do.
    Peak,
    /// It gets too warm.
    Effective,
    /// Its rotor is too light for the load.
    Inertia,
}

impl Servo {
    /// Continuous torque in Nm at a speed in r/min: from the stall torque evenly to the rated one at rated speed, at rated power above.
    ///
    /// Data sheets draw these lines; their figures give standstill and rated speed alone.
    pub fn continuous(&self, speed: f64) -> f64 {
        if speed <= self.rated_speed {
            self.stall + (self.rated - self.stall) * speed / self.rated_speed
        } else {
            self.rated * self.rated_speed / speed
        }
    }

    /// The same where the site leaves a share x of it: `x · M(n / x)`. Source: sizing facts 2.7.
    pub fn continuous_at(&self, share: f64, speed: f64) -> f64 {
        share * self.continuous(speed / share)
    }

    /// Torque in Nm for a short time at a speed in r/min: the peak torque up to rated speed, at constant power above.
    pub fn most(&self, speed: f64) -> f64 {
        self.peak * (self.rated_speed / speed).min(1.0)
    }

    /// The shares of a load and a duty.
    pub fn shares(&self, load: &Load, duty: &Duty) -> Shares {
        Shares {
            inertia_ratio: load.inertia / self.rotor,
            peak: duty.peak / self.peak,
            effective: duty.effective / self.stall,
            speed: duty.speed / self.top_speed,
        }
    }
}

impl Shares {
    /// The first reason why the motor does not go; none where it does.
    pub fn fails(&self, limits: &Acceptance) -> Option<Reason> {
        // A share that is no number fails too.
        let over = |share: f64, most: f64| share.is_nan() || share > most;
        [
            (Reason::Speed, over(self.speed, 1.0)),
            (Reason::Peak, over(self.peak, limits.peak)),
            (Reason::Effective, over(self.effective, limits.effective)),
            (Reason::Inertia, over(self.inertia_ratio, limits.inertia_ratio)),
        ]
        .into_iter()
        .find_map(|(reason, fails)| fails.then_some(reason))
    }
}

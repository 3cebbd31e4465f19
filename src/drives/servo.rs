//! A servo motor compared with its load: the four ratios that a drive displays in operation, and their limits.

use super::load::Load;

/// Ratings of a servo motor. Nm, r/min, kg m².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Servo {
    /// Rated torque.
    pub rated: f64,
    /// Continuous torque at standstill.
    pub stall: f64,
    /// Short-time torque.
    pub peak: f64,
    /// Rated speed.
    pub rated_speed: f64,
    /// Highest speed.
    pub top_speed: f64,
    /// Moment of inertia of the rotor.
    pub rotor: f64,
}

/// Demand of a cycle on a motor. Nm, r/min.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotorDemand {
    /// Highest torque.
    pub peak: f64,
    /// Effective torque.
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
    /// Highest fraction of the peak torque; the rest is reserved for control and for friction when cold.
    pub peak: f64,
    /// Highest effective torque as a fraction of the stall torque.
    pub effective: f64,
}

/// Ratio of inertias above which the dynamic brake of none of the listed motors stops the load without burning: the greatest figure of their maker.
/// Source: sizing facts 2.3, J4DB.
pub const DYNAMIC_BRAKE_RATIO: f64 = 35.0;

/// Highest share of the stall torque for holding a weight. Source: sizing facts 2.3, SPJ188.
pub const WEIGHT_SHARE: f64 = 0.6;

impl Acceptance {
    /// Mitsubishi's rules for its CNC servos: 0.8 of the peak torque, 0.8 of the stall torque, and the series' ratio of inertias. Source:
    /// sizing facts 2.3.
    pub fn mitsubishi(inertia_ratio: f64) -> Acceptance {
        Acceptance { inertia_ratio, peak: 0.8, effective: 0.8 }
    }

    /// Limits of a form: the ratio of inertias, and the share (%) of the stall torque. A motor taken from the list sets those of its series,
    /// so that form and list judge it alike.
    pub fn of_form(inertia_ratio: f64, effective_percent: f64) -> Acceptance {
        Acceptance { effective: effective_percent / 100.0, ..Acceptance::mitsubishi(inertia_ratio) }
    }

    /// Limits for a number of starts per minute. A stiff coupling of motor speed and load needs a ratio of inertias of at most 3 above 100
    /// starts, and of 5 above 60. Source: sizing facts 2.3, MELSERVO J2S.
    pub fn at_starts(self, per_minute: f64) -> Acceptance {
        let most = match per_minute {
            often if often > 100.0 => 3.0,
            often if often >= 60.0 => 5.0,
            _ => f64::INFINITY,
        };
        Acceptance { inertia_ratio: self.inertia_ratio.min(most), ..self }
    }

    /// Limits at a site that reduces the continuous torque to a share. The peak torque stays, because it heats the motor too briefly.
    pub fn derated(self, share: f64) -> Acceptance {
        Acceptance { effective: self.effective * share, ..self }
    }
}

/// A servo motor with its limits, as a form has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedMotor {
    /// Its ratings; the rotor is 0 where the load includes it.
    pub motor: Servo,
    /// Its limits, reduced by starts and site.
    pub limits: Acceptance,
}

impl FittedMotor {
    /// Greatest torque (Nm) that its limits allow for a short time at a speed in r/min.
    pub fn short_time_limit(&self, speed: f64) -> f64 {
        self.limits.peak * self.motor.short_time_torque(speed)
    }

    /// Greatest effective torque (Nm) that its limits allow at standstill and at low speeds.
    pub fn stall_limit(&self) -> f64 {
        self.limits.effective * self.motor.stall
    }

    /// Greatest effective torque (Nm) that its limits allow at a mean speed in r/min.
    pub fn continuous_limit(&self, mean_speed: f64) -> f64 {
        self.limits.effective * self.motor.stall.min(self.motor.continuous(mean_speed))
    }
}

/// Utilization of a motor by its load: 1 is full utilization.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shares {
    /// Load inertia over rotor inertia.
    pub inertia_ratio: f64,
    /// Highest torque over peak torque.
    pub peak: f64,
    /// Effective torque over stall torque.
    pub effective: f64,
    /// Highest speed over the motor's highest speed.
    pub speed: f64,
}

/// Reason for rejecting a motor, in the order of the checks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ServoRefusal {
    /// Its highest speed is too low.
    Speed,
    /// Its peak torque is too small.
    Peak,
    /// It overheats.
    Effective,
    /// Its rotor inertia is too small for the load.
    Inertia,
}

impl Servo {
    /// Continuous torque in Nm at a speed in r/min: linear from stall torque to rated torque at rated speed, rated power above.
    ///
    /// Data sheets draw these curves and give figures only for standstill and rated speed.
    pub fn continuous(&self, speed: f64) -> f64 {
        if speed <= self.rated_speed {
            self.stall + (self.rated - self.stall) * speed / self.rated_speed
        } else {
            self.rated * self.rated_speed / speed
        }
    }

    /// Continuous torque in Nm at a site with the remaining share x: `x · M(n / x)`. Source: sizing facts 2.7.
    pub fn continuous_at(&self, share: f64, speed: f64) -> f64 {
        share * self.continuous(speed / share)
    }

    /// Short-time torque in Nm at a speed in r/min: the peak torque up to rated speed, constant power above.
    pub fn short_time_torque(&self, speed: f64) -> f64 {
        self.peak * (self.rated_speed / speed).min(1.0)
    }

    /// Utilization by the inertia of a load and by a demand.
    pub fn shares(&self, load: &Load, demand: &MotorDemand) -> Shares {
        Shares {
            inertia_ratio: load.inertia / self.rotor,
            peak: demand.peak / self.peak,
            effective: demand.effective / self.stall,
            speed: demand.speed / self.top_speed,
        }
    }
}

impl Shares {
    /// The first reason for rejecting the motor; `None` if it is suitable.
    pub fn fails(&self, limits: &Acceptance) -> Option<ServoRefusal> {
        // A NaN fails too.
        let over = |share: f64, most: f64| share.is_nan() || share > most;
        [
            (ServoRefusal::Speed, over(self.speed, 1.0)),
            (ServoRefusal::Peak, over(self.peak, limits.peak)),
            (ServoRefusal::Effective, over(self.effective, limits.effective)),
            (ServoRefusal::Inertia, over(self.inertia_ratio, limits.inertia_ratio)),
        ]
        .into_iter()
        .find_map(|(reason, fails)| fails.then_some(reason))
    }
}

//! Electronic cams of a print roller: same speed as the web in the contact, correction between two contacts by a law of motion.

use crate::math::PI;

/// A law of motion from rest to rest over one correction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Law {
    /// 3-4-5 polynomial, `10u³ - 15u⁴ + 6u⁵`.
    Polynomial345,
    /// Modified sine.
    ModifiedSine,
    /// Cycloid, `u - sin 2πu / 2π`.
    Cycloid,
    /// A third each of acceleration, constant speed and deceleration.
    Trapezoid,
    /// Constant acceleration and deceleration.
    ConstantAcceleration,
}

/// Peaks of a law for a travel of one metre in one second.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficients {
    /// Highest speed, C_v.
    pub speed: f64,
    /// Highest acceleration, C_a.
    pub acceleration: f64,
    /// Effective acceleration.
    pub effective: f64,
}

impl Law {
    /// Coefficients of the law. The effective acceleration of the modified sine is `4π² / (4 + π) / √2`, because the mean square of a sine
    /// over whole quarters is one half. Source: sizing facts 3.3.
    pub fn coefficients(self) -> Coefficients {
        let (speed, acceleration, effective) = match self {
            Law::Polynomial345 => (15.0 / 8.0, 10.0 / 3f64.sqrt(), (120f64 / 7.0).sqrt()),
            Law::ModifiedSine => {
                let peak = 4.0 * PI * PI / (4.0 + PI);
                (4.0 * PI / (4.0 + PI), peak, peak / 2f64.sqrt())
            }
            Law::Cycloid => (2.0, 2.0 * PI, 2.0 * PI / 2f64.sqrt()),
            Law::Trapezoid => (1.5, 4.5, 4.5 * (2f64 / 3.0).sqrt()),
            Law::ConstantAcceleration => (2.0, 4.0, 4.0),
        };
        Coefficients { speed, acceleration, effective }
    }
}

/// One correction per pitch. Metres and seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Correction {
    /// Length of web between two dots.
    pub pitch: f64,
    /// Length of web over which roller and web have the same speed.
    pub contact: f64,
    /// Arc of the roller between two heads.
    pub arc: f64,
    /// Speed of the web.
    pub speed: f64,
}

impl Correction {
    /// Lead of the roller's surface over the web per pitch, m; negative for a lag.
    pub fn travel(&self) -> f64 {
        self.arc - self.pitch
    }

    /// Time between two contacts in seconds: `(p - c) / v`.
    pub fn seconds(&self) -> f64 {
        (self.pitch - self.contact) / self.speed
    }

    /// Highest speed of the roller's surface (lowest if its arc is shorter than the pitch), m/s: `v + C_v h / T`.
    /// Source: sizing facts 3.3.
    pub fn peak_speed(&self, law: Coefficients) -> f64 {
        self.speed + law.speed * self.travel() / self.seconds()
    }

    /// Highest acceleration of the surface, m/s²: `C_a |h| / T²`. Source: sizing facts 3.3.
    pub fn peak_acceleration(&self, law: Coefficients) -> f64 {
        law.acceleration * self.travel().abs() / (self.seconds() * self.seconds())
    }

    /// Effective acceleration over a whole pitch, m/s²: `q |h| / T² · √((p - c) / p)`. Source: sizing facts 3.3.
    pub fn effective_acceleration(&self, law: Coefficients) -> f64 {
        let share = (self.pitch - self.contact) / self.pitch;
        law.effective * self.travel().abs() / (self.seconds() * self.seconds()) * share.sqrt()
    }

    /// Largest difference by which the arc may be shorter than the pitch without the roller turning back, m: `(p - c) / C_v`. Source:
    /// checked as E6.
    pub fn longest_lag(&self, law: Coefficients) -> f64 {
        (self.pitch - self.contact) / law.speed
    }

    /// Highest web speed in m/s for a limit of the surface's acceleration: `(p - c) √(a / (C_a |h|))`; infinite without a correction.
    /// Source: sizing facts 3.3, checked as E7.
    pub fn speed_at(&self, law: Coefficients, acceleration: f64) -> f64 {
        self.speed_with(acceleration, law.acceleration)
    }

    /// Highest web speed in m/s for a limit of the surface's effective acceleration: `(p - c) √(a / (q |h| √((p - c) / p)))`; infinite
    /// without a correction. Source: sizing facts 3.3, checked as E8.
    pub fn speed_at_effective(&self, law: Coefficients, acceleration: f64) -> f64 {
        let share = (self.pitch - self.contact) / self.pitch;
        self.speed_with(acceleration, law.effective * share.sqrt())
    }

    fn speed_with(&self, acceleration: f64, coefficient: f64) -> f64 {
        let corrected = coefficient * self.travel().abs();
        if corrected > 0.0 { (self.pitch - self.contact) * (acceleration / corrected).sqrt() } else { f64::INFINITY }
    }

    /// Number of blocks of constant speed and equal time within `error` m of the correction: at least `√(C_a |h| / (8 e))`, because a chord
    /// deviates from its curve by an eighth of acceleration times time squared. Source: sizing facts 3.5.
    pub fn blocks(&self, law: Coefficients, error: f64) -> f64 {
        (law.acceleration * self.travel().abs() / (8.0 * error)).sqrt().ceil().max(1.0)
    }
}

//! Electronic cams of a print roller: matched with the web in the contact, corrected between two contacts by a law of motion.

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

/// Peaks of a law for one metre in one second.
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
    /// Its coefficients. The effective acceleration of the modified sine is `4π² / (4 + π) / √2`, for the square of a sine over whole quarters
    /// is a half. Source: sizing facts 3.3.
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
    /// Length of web from dot to dot.
    pub pitch: f64,
    /// Length of web in which roller and web move alike.
    pub contact: f64,
    /// Arc of the roller from head to head.
    pub arc: f64,
    /// Speed of the web.
    pub speed: f64,
}

impl Correction {
    /// Surface that the roller runs ahead of the web (or behind, negative) per pitch, m.
    pub fn travel(&self) -> f64 {
        self.arc - self.pitch
    }

    /// Seconds between two contacts: `(p - c) / v`.
    pub fn seconds(&self) -> f64 {
        (self.pitch - self.contact) / self.speed
    }

    /// Highest speed of the roller's surface (the lowest where its arc is shorter than the pitch), m/s: `v + C_v h / T`.
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

    /// Most that an arc may be shorter than the pitch without the roller turning back, m: `(p - c) / C_v`. Source: checked as E6.
    pub fn longest_lag(&self, law: Coefficients) -> f64 {
        (self.pitch - self.contact) / law.speed
    }

    /// Highest speed of the web in m/s at a highest acceleration of the surface: `(p - c) √(a / (C_a |h|))`; any where nothing is corrected.
    /// Source: sizing facts 3.3, checked as E7.
    pub fn speed_at(&self, law: Coefficients, acceleration: f64) -> f64 {
        self.speed_with(acceleration, law.acceleration)
    }

    /// Highest speed of the web in m/s at a highest effective acceleration of the surface: `(p - c) √(a / (q |h| √((p - c) / p)))`; any where
    /// nothing is corrected. Source: sizing facts 3.3, checked as E8.
    pub fn speed_at_effective(&self, law: Coefficients, acceleration: f64) -> f64 {
        let share = (self.pitch - self.contact) / self.pitch;
        self.speed_with(acceleration, law.effective * share.sqrt())
    }

    fn speed_with(&self, acceleration: f64, coefficient: f64) -> f64 {
        let corrected = coefficient * self.travel().abs();
        if corrected > 0.0 { (self.pitch - self.contact) * (acceleration / corrected).sqrt() } else { f64::INFINITY }
    }

    /// Blocks of constant speed and equal time that come within `error` m of the correction: at least `√(C_a |h| / (8 e))`, for a chord is off
    /// its curve by an eighth of acceleration times time squared. Source: sizing facts 3.5.
    pub fn blocks(&self, law: Coefficients, error: f64) -> f64 {
        (law.acceleration * self.travel().abs() / (8.0 * error)).sqrt().ceil().max(1.0)
    }
}

//! Direction of rotation of a spindle, seen from behind it: clockwise by M3, counter-clockwise by M4, or at rest.

/// Rotation of a spindle. A clockwise speed is positive.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rotation {
    /// At rest (M5).
    #[default]
    Stopped,
    /// Clockwise (M3).
    Clockwise,
    /// Counter-clockwise (M4).
    CounterClockwise,
}

impl Rotation {
    /// Signed speeds and angles below this count as rest.
    const REST: f64 = 1e-9;

    /// Rotation of a signed speed or angle.
    pub fn of(value: f64) -> Rotation {
        if value > Rotation::REST {
            Rotation::Clockwise
        } else if value < -Rotation::REST {
            Rotation::CounterClockwise
        } else {
            Rotation::Stopped
        }
    }

    /// Sign of its speeds and angles: 1, -1, or 0 at rest.
    pub fn sign(self) -> f64 {
        match self {
            Rotation::Stopped => 0.0,
            Rotation::Clockwise => 1.0,
            Rotation::CounterClockwise => -1.0,
        }
    }

    /// The other direction; rest stays rest.
    pub fn reversed(self) -> Rotation {
        match self {
            Rotation::Stopped => Rotation::Stopped,
            Rotation::Clockwise => Rotation::CounterClockwise,
            Rotation::CounterClockwise => Rotation::Clockwise,
        }
    }
}

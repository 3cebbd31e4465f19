//! An induction motor on an open-loop inverter that follows an analog speed command.

/// A motor and its inverter settings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Induction {
    /// Speed commanded by the full analog signal, r/min.
    pub full_command: f64,
    /// Speed without load at the full signal, r/min (synchronous at 50 Hz: 1500 with four poles).
    pub no_load: f64,
    /// Speed under rated torque at the full signal, r/min (the name plate).
    pub rated: f64,
    /// Torque as a fraction of the rated one.
    pub load: f64,
}

impl Induction {
    /// Speed without load per commanded speed.
    pub fn gain(&self) -> f64 {
        self.no_load / self.full_command
    }

    /// Speed loss under the load, r/min: proportional to torque and, at constant V/f, the same at any frequency.
    /// Source: sizing facts 2.6, checked as D4.
    pub fn slip(&self) -> f64 {
        (self.no_load - self.rated) * self.load
    }

    /// Speed for a command in r/min: `command · gain - slip`. Source: sizing facts 2.6, checked as D5.
    pub fn speed(&self, command: f64) -> f64 {
        command * self.gain() - self.slip()
    }

    /// Relative speed error at a command: `speed / command - 1`. Source: sizing facts 2.6, checked as D6 and D8.
    pub fn error(&self, command: f64) -> f64 {
        if command > 0.0 { self.speed(command) / command - 1.0 } else { 0.0 }
    }
}

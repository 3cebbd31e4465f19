//! [`World`]: how a program reads machine state (positions, inputs, clocks).

use crate::text::Diagnostic;

/// A clock of the machine that programs read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MachineClock {
    /// Time since power-on (`#3001`).
    PowerOn,
    /// Time of automatic operation (`#3002`).
    AutomaticRun,
}

/// The machine as seen by the interpreter. It is read when a block is read, possibly several blocks ahead of execution.
pub trait World {
    /// A macro input from the PLC (bit or signed word), by variable number.
    fn input(&mut self, variable: u32) -> f64;
    /// Milliseconds of a clock.
    fn clock_ms(&mut self, clock: MachineClock) -> f64;
    /// Position of an axis in millimetres or degrees as its words count (diameter on a diameter axis), machine frame. Called only after a
    /// [`Step::Sync`](super::Step::Sync).
    fn position(&mut self, axis: usize) -> f64;
    /// Whether optional block skip number 1 to 9 is switched on.
    fn block_skip(&mut self, number: u8) -> bool;
    /// Number of commands waiting after the executing one, without commands that act when read; `None` if the machine is at rest with all
    /// commands done.
    fn waiting(&mut self) -> Option<usize> {
        None
    }
    /// Whether the coordinates of an axis restart with each turn, so that it has no range.
    fn is_endless(&self, _axis: usize) -> bool {
        false
    }
    /// Reports a change of a common variable by the program (`None`: vacant), for displays of variables over time.
    fn changed(&mut self, _variable: u32, _value: Option<f64>) {}
    /// Reports a part of a block without effect or with another effect than written, for which the control has no known alarm.
    fn remark(&mut self, _remark: Diagnostic) {}
}

/// A machine with fixed inputs, at rest at zero: for checks and tests of the language.
#[derive(Debug, Clone, Default)]
pub struct MachineAtRest {
    /// Inputs that are not 0, by variable number.
    pub inputs: Vec<(u32, f64)>,
    /// Positions in millimetres or degrees.
    pub positions: [f64; super::canon::AXES],
    /// Optional block skip.
    pub block_skip: bool,
    /// The coordinates of every axis roll over.
    pub endless: bool,
    /// Remarks in the order of the run, with repetitions.
    pub remarks: Vec<Diagnostic>,
}

impl World for MachineAtRest {
    fn input(&mut self, variable: u32) -> f64 {
        self.inputs.iter().find(|(number, _)| *number == variable).map_or(0.0, |(_, value)| *value)
    }

    fn clock_ms(&mut self, _clock: MachineClock) -> f64 {
        0.0
    }

    fn position(&mut self, axis: usize) -> f64 {
        self.positions.get(axis).copied().unwrap_or(0.0)
    }

    fn block_skip(&mut self, _number: u8) -> bool {
        self.block_skip
    }

    fn is_endless(&self, _axis: usize) -> bool {
        self.endless
    }

    fn remark(&mut self, remark: Diagnostic) {
        self.remarks.push(remark);
    }
}

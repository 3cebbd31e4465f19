//! The servo axes of the ribbon line, pull roller and print roller, and values that each of them has.

use std::ops::Index;

/// A servo axis of the line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LineAxis {
    /// The pull roller, X.
    Pull,
    /// The print roller.
    Print,
}

/// A value of each servo axis.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct PerAxis<T> {
    pub pull: T,
    pub print: T,
}

impl LineAxis {
    /// The axes in the order of the program's words.
    pub(super) const BOTH: [LineAxis; 2] = [LineAxis::Pull, LineAxis::Print];
}

impl<T> PerAxis<T> {
    /// The values that `of` gives for each axis.
    pub(super) fn of(of: impl Fn(LineAxis) -> T) -> PerAxis<T> {
        PerAxis { pull: of(LineAxis::Pull), print: of(LineAxis::Print) }
    }

    /// Values computed from those of each axis.
    pub(super) fn map<U>(&self, of: impl Fn(&T) -> U) -> PerAxis<U> {
        PerAxis { pull: of(&self.pull), print: of(&self.print) }
    }

    /// The values in the order of the axes.
    pub(super) fn both(self) -> [T; 2] {
        [self.pull, self.print]
    }
}

impl<T> Index<LineAxis> for PerAxis<T> {
    type Output = T;

    fn index(&self, axis: LineAxis) -> &T {
        match axis {
            LineAxis::Pull => &self.pull,
            LineAxis::Print => &self.print,
        }
    }
}

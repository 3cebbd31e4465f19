//! Numbers of the programs of the ribbon line.

/// Number of the program that computes.
pub(in crate::machines::ribbon_line) const COMPUTE: u32 = 9100;
/// Number of the program that runs the machine.
pub(in crate::machines::ribbon_line) const RUN: u32 = 9101;
/// Number of the program that sets the project's values.
pub(in crate::machines::ribbon_line) const SETUP: u32 = 9102;

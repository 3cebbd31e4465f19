//! Polygon turning: a cutter disc and the work turn in a fixed ratio, and each pass of an insert cuts a nearly flat side.
//!
//! Angles are in radians, counter-clockwise, both rotations seen from the same side; lengths in mm. The work turns about the origin, the
//! tool about (a, 0) with its tips at radius r, k times as fast. "Sheet" is `docs/reference/polygon-turning.md`, whose section 3 derives the
//! formulas; it agrees with the paper of the machine (the polygon turning paper about the KND K2000T, 2022) except for the mistakes listed
//! in its section 3.7.

pub mod choose;
pub mod curve;
pub mod cut;
pub mod ellipse;
mod envelope;
pub mod load;
pub mod ratio;
pub mod section;
pub mod setup;

pub use curve::Curve;
pub use ratio::Ratio;
pub use section::{SAME_LENGTH, Section};
pub use setup::{CutterSetup, Tip};

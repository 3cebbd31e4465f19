//! The pattern of a shift: a run, and the pause until the next start.

use super::form::Field;
use super::form::rows::{Member, number};

/// A field for the time in s from the end of a run to the next start, in which drives stand and hold.
pub(super) const fn pause<P>(group: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number("pause", member).group(group).label("form.pause").help("form.pause.help");
    row.unit("s").range(0.0..=36000.0).default(0.0).decimals(1).step(1.0)
}

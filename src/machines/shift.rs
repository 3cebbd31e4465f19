//! The pattern of a shift: a run, and the pause until the next start.

use super::form::Field;
use super::form::rows::{Member, number};

/// Field of the pause (s) from the end of a run to the next start, in which the drives hold at standstill.
pub(super) const fn pause<P>(group: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number("pause", member).group(group).label("form.pause").help("form.pause.help");
    row.unit("s").range(0.0..=36000.0).default(0.0).decimals(1).step(1.0)
}

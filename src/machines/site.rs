//! The site of a motor that has no table of its own here: the share of its ratings that its maker leaves it there.

use super::form::Field;
use super::form::rows::{Member, number};

/// A field for the share (%) of its rated torque and power that a motor gives continuously at its site. Short-time torque stays.
pub(super) const fn share<P>(id: &'static str, group: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number(id, member).group(group).label("form.site-share").help("form.site-share.help").symbol("x");
    row.unit("%").range(10.0..=100.0).default(100.0).decimals(1).step(1.0).fact()
}

//! Contacts that hold the program: inverter ready, loop at its longest and at its shortest, reel at its end.

use super::resolved::RibbonLine;
use crate::machines::ladder::MachineContact;
use crate::text::{Citation, Grade};

/// Source of the contacts and of their places.
pub(super) const CONTACTS: Citation = Citation::new("ribbon line facts, 11", Grade::Inferred);

/// The contacts, closed while nothing is wrong.
pub(super) const HOLDING: [MachineContact; 4] = [
    MachineContact::InverterEnabled,
    MachineContact::LoopNotFull,
    MachineContact::WebNotTight,
    MachineContact::ReelNotEmpty,
];

/// Ribbon (mm) that the unwinder still takes off the reel at a hold with the knob at its end: `v · t_r / 2`. Source: ribbon line facts, 11.
pub(super) fn left_at_reel_end(line: &RibbonLine) -> f64 {
    let (p, fast) = (&line.p, &line.fast);
    let ramp = p.inverter_ramp * fast.actual_speed / p.speed_at_10v;
    fast.line_speed / 60.0 * ramp / 2.0
}

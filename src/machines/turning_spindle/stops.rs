//! Interruptions of the lathe: the spindle turns on while the tool is in the cut, until the operator ends the program.

use super::resolved::TurningSpindle;
use super::run_up::{engaged, highest};
use crate::drives::holding_brake::CLOSING;
use crate::machines::driven::DrivenAxis;
use crate::machines::slides;
use crate::machines::stops::{
    Interruption, Reaction, SpindleReaction, slides_at_emergency_stop, slides_without_supply,
};
use crate::msg;
use crate::text::{Citation, Grade, Message};

const DESIGN: Citation = Citation::new("turning spindle facts, 7", Grade::Inferred);

/// Reaction of the spindle to an interruption.
pub(super) fn spindle(lathe: &TurningSpindle, at: Interruption) -> SpindleReaction {
    match at {
        Interruption::Hold | Interruption::BlockStop | Interruption::Alarm => SpindleReaction::Turns,
        Interruption::Reset if lathe.rules().turns_through_reset => SpindleReaction::Turns,
        Interruption::Reset | Interruption::EmergencyStop => SpindleReaction::Off,
        Interruption::InverterFault | Interruption::PowerFailure => SpindleReaction::OutputOff,
    }
}

/// The table.
pub(super) fn reactions(lathe: &TurningSpindle) -> Vec<Reaction> {
    let row = |at, axes: Message, material: Message, operator: Message| Reaction {
        at,
        cause: None,
        spindle: spindle(lathe, at),
        axes,
        material,
        operator,
        cite: DESIGN,
    };
    let off = spindle(lathe, Interruption::Reset) == SpindleReaction::Off;
    let (block, retract) = (msg!("lathe.stops.axes-block"), msg!("lathe.stops.anew"));
    let reset = if off { msg!("lathe.stops.work-slows") } else { msg!("lathe.stops.work-turns") };
    let coasts = (engaged(lathe).coasting(highest(lathe)), 1);
    let sinks = slides::axes(lathe).iter().find_map(DrivenAxis::sinks);
    let mut rows = vec![
        row(
            Interruption::Hold,
            msg!("lathe.stops.axes-hold"),
            msg!("turning.stops.work-rubs"),
            msg!("lathe.stops.start"),
        ),
        row(Interruption::BlockStop, block.clone(), msg!("lathe.stops.work-turns"), msg!("lathe.stops.start")),
        row(Interruption::Alarm, block, msg!("turning.stops.work-rubs"), msg!("turning.stops.mend")),
        row(Interruption::Reset, msg!("lathe.stops.axes-reset"), reset, retract),
        row(
            Interruption::EmergencyStop,
            slides_at_emergency_stop(sinks),
            msg!("lathe.stops.work-slows"),
            msg!("lathe.stops.clear"),
        ),
        row(
            Interruption::InverterFault,
            msg!("lathe.stops.axes-reset"),
            msg!("lathe.stops.work-coasts", time = coasts),
            msg!("lathe.stops.fault"),
        ),
    ];
    rows.extend(sinks.map(|way| Reaction {
        cite: CLOSING,
        ..row(
            Interruption::PowerFailure,
            slides_without_supply(Some(way)),
            msg!("lathe.stops.work-coasts", time = coasts),
            msg!("lathe.stops.anew"),
        )
    }));
    rows
}

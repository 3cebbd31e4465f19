//! Interruptions of the polygon lathe, from hold to power failure: work and tool keep their ratio as long as their drives are on.

use super::citations::OURS;
use super::main_spindle::speed_at_highest_knob;
use super::resolved::PolygonLathe;
use super::turned_end_form::TurnedEnd;
use crate::drives::holding_brake::CLOSING;
use crate::machines::driven::DrivenAxis;
use crate::machines::lathe::slides;
use crate::machines::stops::{
    Interruption, Reaction, SpindleReaction, slides_at_emergency_stop, slides_without_supply,
};
use crate::msg;
use crate::text::{Citation, Grade, Message};

const DESIGN: Citation = Citation::new("turning spindle facts, 7", Grade::Inferred);

/// Reaction of work and tool to an interruption.
pub(super) fn axes(lathe: &PolygonLathe, at: Interruption) -> SpindleReaction {
    match at {
        Interruption::Hold | Interruption::BlockStop => SpindleReaction::TurnsInRatio,
        Interruption::PowerFailure => SpindleReaction::Coasts,
        Interruption::EmergencyStop if lathe.params.coasts(lathe.control) => SpindleReaction::Coasts,
        // Work and tool have servo drives; the only inverter is that of the main spindle, whose fault holds the
        // program.
        Interruption::Alarm | Interruption::Reset | Interruption::EmergencyStop | Interruption::InverterFault => {
            SpindleReaction::StopsInRatio
        }
    }
}

/// Reaction of the main spindle to an interruption while it turns the bar.
pub(super) fn main_spindle(lathe: &PolygonLathe, at: Interruption) -> SpindleReaction {
    match at {
        Interruption::Hold | Interruption::BlockStop | Interruption::Alarm => SpindleReaction::Turns,
        Interruption::Reset if lathe.dialect.spindle().turns_through_reset => SpindleReaction::Turns,
        Interruption::Reset | Interruption::EmergencyStop => SpindleReaction::Off,
        Interruption::InverterFault | Interruption::PowerFailure => SpindleReaction::OutputOff,
    }
}

/// Rows about the main spindle, where the program turns the bar by it.
fn of_main_spindle(lathe: &PolygonLathe) -> Vec<Reaction> {
    if !lathe.has_main_spindle() {
        return Vec::new();
    }
    let row = |at, cause: Option<&'static str>, axes: Message, material: Message, operator: Message| Reaction {
        at,
        cause,
        spindle: main_spindle(lathe, at),
        axes,
        material,
        operator,
        cite: DESIGN,
    };
    // A control finishes the block of a thread before it holds: a thread interrupted within it would be spoilt.
    let threads = lathe.params.turned_ends.iter().any(TurnedEnd::threads);
    let in_thread = threads.then(|| {
        row(
            Interruption::Hold,
            Some("polygon.stops.thread-hold"),
            msg!("polygon.stops.axes-thread"),
            msg!("polygon.stops.thread-turns"),
            msg!("lathe.stops.start"),
        )
    });
    let turns = main_spindle(lathe, Interruption::Reset) == SpindleReaction::Turns;
    let after_reset = if turns { msg!("lathe.stops.work-turns") } else { msg!("lathe.stops.work-slows") };
    let coasts = lathe.params.main_spindle().coasting(speed_at_highest_knob(lathe));
    let [hold, alarm] = ["polygon.stops.main-hold", "polygon.stops.main-alarm"].map(Some);
    let [reset, emergency] = ["polygon.stops.main-reset", "polygon.stops.main-emergency"].map(Some);
    let sinks = slides::axes(lathe).iter().find_map(DrivenAxis::sinks);
    let mut rows = vec![
        row(
            Interruption::Hold,
            hold,
            msg!("lathe.stops.axes-hold"),
            msg!("lathe.stops.work-turns"),
            msg!("lathe.stops.start"),
        ),
        row(
            Interruption::Alarm,
            alarm,
            msg!("lathe.stops.axes-block"),
            msg!("lathe.stops.work-turns"),
            msg!("polygon.stops.mend"),
        ),
        row(Interruption::Reset, reset, msg!("lathe.stops.axes-reset"), after_reset, msg!("lathe.stops.anew")),
        row(
            Interruption::EmergencyStop,
            emergency,
            slides_at_emergency_stop(sinks),
            msg!("lathe.stops.work-slows"),
            msg!("lathe.stops.clear"),
        ),
        row(
            Interruption::InverterFault,
            None,
            msg!("lathe.stops.axes-reset"),
            msg!("lathe.stops.work-coasts", time = (coasts, 1)),
            msg!("lathe.stops.fault"),
        ),
    ];
    // After the row of the hold in other cuts.
    rows.splice(1..1, in_thread);
    rows
}

/// The table.
pub(super) fn reactions(lathe: &PolygonLathe) -> Vec<Reaction> {
    let row = |at, slides: Message, material: Message, operator: Message| Reaction {
        at,
        cause: None,
        spindle: axes(lathe, at),
        axes: slides,
        material,
        operator,
        cite: OURS,
    };
    let coasts = axes(lathe, Interruption::EmergencyStop) == SpindleReaction::Coasts;
    let broken = if coasts { msg!("polygon.stops.out-of-ratio") } else { msg!("polygon.stops.part-cut") };
    let sinks = slides::axes(lathe).iter().find_map(DrivenAxis::sinks);
    let (block, start) = (msg!("lathe.stops.axes-block"), msg!("lathe.stops.start"));
    let mut rows = vec![
        row(Interruption::Hold, msg!("lathe.stops.axes-hold"), msg!("polygon.stops.rubs"), start.clone()),
        row(Interruption::BlockStop, block.clone(), msg!("polygon.stops.in-ratio"), start),
        row(Interruption::Alarm, block, msg!("polygon.stops.part-cut"), msg!("polygon.stops.mend")),
        row(
            Interruption::Reset,
            msg!("lathe.stops.axes-reset"),
            msg!("polygon.stops.part-cut"),
            msg!("polygon.stops.anew"),
        ),
        row(Interruption::EmergencyStop, slides_at_emergency_stop(sinks), broken, msg!("polygon.stops.clear")),
        Reaction {
            cite: if sinks.is_some() { CLOSING } else { OURS },
            ..row(
                Interruption::PowerFailure,
                slides_without_supply(sinks),
                msg!("polygon.stops.phase-lost", angle = (lathe.derived.angles.coast_phase.abs(), 0)),
                msg!("polygon.stops.discard"),
            )
        },
    ];
    rows.push(Reaction {
        cause: Some("polygon.stops.one-drive"),
        spindle: SpindleReaction::StopsBeside,
        ..row(
            Interruption::Alarm,
            msg!("lathe.stops.axes-reset"),
            msg!("polygon.stops.out-of-ratio"),
            msg!("polygon.stops.discard"),
        )
    });
    rows.extend(of_main_spindle(lathe));
    rows
}

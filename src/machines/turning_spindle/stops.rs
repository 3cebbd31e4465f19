//! Interruptions of the lathe: the spindle keeps turning while the tool is in the cut, until the operator ends the program.

use super::gears;
use super::program;
use super::resolved::{CodePair, TurningSpindle};
use super::run_up;
use crate::controls::interface::SignalRole;
use crate::drives::holding_brake::CLOSING;
use crate::machines::driven::DrivenAxis;
use crate::machines::lathe::slides;
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

/// The table: the interruptions of every lathe, then those of gears, tailstock and keyway where the lathe has them.
pub(super) fn reactions(lathe: &TurningSpindle) -> Vec<Reaction> {
    let sinks = slides::axes(lathe).iter().find_map(DrivenAxis::sinks);
    let mut rows = Vec::from(in_the_cut(lathe));
    rows.extend(without_control(lathe, sinks));
    rows.extend(late_gear(lathe));
    rows.extend(lost_gear(lathe));
    rows.extend(open_tailstock(lathe));
    if lathe.keyway().is_some() {
        rows.extend(in_keyway(lathe, sinks));
    }
    rows
}

/// An interruption with the usual reaction of the spindle: effects on the axes and on the work, steps of the operator.
fn row(lathe: &TurningSpindle, at: Interruption, axes: Message, material: Message, operator: Message) -> Reaction {
    Reaction { at, cause: None, spindle: spindle(lathe, at), axes, material, operator, cite: DESIGN }
}

/// Rows of the interruptions by operator or program while the tool cuts.
fn in_the_cut(lathe: &TurningSpindle) -> [Reaction; 4] {
    let off = spindle(lathe, Interruption::Reset) == SpindleReaction::Off;
    let block = msg!("lathe.stops.axes-block");
    let reset = if off { msg!("lathe.stops.work-slows") } else { msg!("lathe.stops.work-turns") };
    let (rubs, start, anew) = (msg!("turning.stops.work-rubs"), msg!("lathe.stops.start"), anew(lathe));
    [
        row(lathe, Interruption::Hold, msg!("lathe.stops.axes-hold"), rubs.clone(), start.clone()),
        row(lathe, Interruption::BlockStop, block.clone(), msg!("lathe.stops.work-turns"), start),
        row(lathe, Interruption::Alarm, block, rubs, anew(Interruption::Alarm)),
        row(lathe, Interruption::Reset, msg!("lathe.stops.axes-reset"), reset, anew(Interruption::Reset)),
    ]
}

/// Rows of the interruptions in which drives are without control or without supply. `sinks`: mm by which a slide sinks before its brake holds.
fn without_control(lathe: &TurningSpindle, sinks: Option<f64>) -> [Reaction; 3] {
    let (time, anew) = ((run_up::coasting(lathe), 1), anew(lathe));
    let coasts = msg!("lathe.stops.work-coasts", time);
    let slows = msg!("lathe.stops.work-slows");
    let unpowered =
        if lathe.params.has_several_stages() { msg!("turning.stops.coasts-in-gear", time) } else { coasts.clone() };
    let [emergency, fault, failure] =
        [Interruption::EmergencyStop, Interruption::InverterFault, Interruption::PowerFailure];
    [
        row(lathe, emergency, slides_at_emergency_stop(sinks), slows, anew(emergency)),
        row(lathe, fault, msg!("lathe.stops.axes-reset"), coasts, anew(fault)),
        Reaction {
            cite: if sinks.is_some() { CLOSING } else { DESIGN },
            ..row(lathe, failure, slides_without_supply(sinks), unpowered, anew(failure))
        },
    ]
}

/// Row of a gear that is not in position in time, where the PLC supervises it.
fn late_gear(lathe: &TurningSpindle) -> Option<Reaction> {
    let patience = gears::gear_times(lathe).patience.filter(|_| lathe.params.has_several_stages())?;
    let work = msg!("turning.stops.gear-late-work", time = (patience, 1));
    let mend = msg!("turning.stops.gear-late-mend");
    Some(Reaction {
        cause: Some("turning.stops.gear-late"),
        spindle: SpindleReaction::Off,
        ..row(lathe, Interruption::Alarm, msg!("lathe.stops.axes-block"), work, mend)
    })
}

/// Row of a gear that leaves its position while the spindle turns.
fn lost_gear(lathe: &TurningSpindle) -> Option<Reaction> {
    let (work, mend) = (msg!("turning.stops.gear-lost-work"), msg!("turning.stops.gear-lost-mend"));
    lathe.params.has_several_stages().then(|| Reaction {
        cause: Some("turning.stops.gear-lost"),
        spindle: SpindleReaction::OutputOff,
        ..row(lathe, Interruption::Hold, msg!("lathe.stops.axes-hold"), work, mend)
    })
}

/// Row of a tailstock that lets the work go.
fn open_tailstock(lathe: &TurningSpindle) -> Option<Reaction> {
    let (work, mend) = (msg!("turning.stops.let-go-work"), msg!("turning.stops.let-go-mend"));
    lathe.params.tailstock.then(|| Reaction {
        cause: Some("turning.stops.let-go"),
        ..row(lathe, Interruption::InverterFault, msg!("lathe.stops.axes-hold"), work, mend)
    })
}

/// Steps of the operator before a restart; a variable that marks a begun part is set back.
fn anew(lathe: &TurningSpindle) -> impl Fn(Interruption) -> Message {
    let flag = program::begun(lathe);
    move |at| match (at, flag.as_deref()) {
        (Interruption::Alarm, None) => msg!("turning.stops.mend"),
        (Interruption::Alarm, Some(variable)) => msg!("turning.stops.mend-by-hand", variable),
        (Interruption::EmergencyStop, None) => msg!("lathe.stops.clear"),
        (Interruption::EmergencyStop, Some(variable)) => msg!("turning.stops.clear-by-hand", variable),
        (Interruption::InverterFault, None) => msg!("lathe.stops.fault"),
        (Interruption::InverterFault, Some(variable)) => msg!("turning.stops.fault-by-hand", variable),
        (Interruption::PowerFailure, None) => msg!("lathe.stops.power-on"),
        (Interruption::PowerFailure, Some(variable)) => msg!("turning.stops.power-on-by-hand", variable),
        (_, None) => msg!("lathe.stops.anew"),
        (_, Some(variable)) => msg!("turning.stops.anew-by-hand", variable),
    }
}

/// Reactions of the locked spindle to a reset and to an emergency stop.
fn of_locked_spindle(lathe: &TurningSpindle) -> [SpindleReaction; 2] {
    // A clamp without a release code is opened by the ladder at reset; without any code the operator locks the spindle.
    let opens = matches!(lathe.lock_codes(), Some(CodePair { off: None, .. }));
    // Where the PLC reads the reset key, an emergency stop is no reset to it.
    let reads_key = lathe.dialect.device(lathe.control, SignalRole::ResetRequest).is_some();
    [opens, opens && !reads_key]
        .map(|opens| if opens { SpindleReaction::Unlocks } else { SpindleReaction::StaysLocked })
}

/// Rows of the keyway: the spindle is locked at its angle, and the driven tool turns in the work.
fn in_keyway(lathe: &TurningSpindle, sinks: Option<f64>) -> [Reaction; 4] {
    let [at_reset, at_emergency] = of_locked_spindle(lathe);
    let (locked, anew) = (SpindleReaction::StaysLocked, anew(lathe));
    let locked_row = |cause, spindle, of: Reaction| Reaction { cause: Some(cause), spindle, ..of };
    let (turns, stops) = (msg!("turning.stops.driven-turns"), msg!("turning.stops.driven-stops"));
    let [hold, reset, emergency, failure] =
        [Interruption::Hold, Interruption::Reset, Interruption::EmergencyStop, Interruption::PowerFailure];
    let of_hold = row(lathe, hold, msg!("lathe.stops.axes-hold"), turns, msg!("lathe.stops.start"));
    let of_reset = row(lathe, reset, msg!("lathe.stops.axes-reset"), stops.clone(), anew(reset));
    let of_emergency = row(lathe, emergency, slides_at_emergency_stop(sinks), stops, anew(emergency));
    let unpowered = msg!("turning.stops.clamp-unpowered");
    let of_failure = row(lathe, failure, slides_without_supply(sinks), unpowered, anew(failure));
    [
        locked_row("turning.stops.keyway-hold", locked, of_hold),
        locked_row("turning.stops.keyway-reset", at_reset, of_reset),
        locked_row("turning.stops.keyway-emergency", at_emergency, of_emergency),
        locked_row("turning.stops.keyway-power", locked, of_failure),
    ]
}

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
    let block = msg!("lathe.stops.axes-block");
    let reset = if off { msg!("lathe.stops.work-slows") } else { msg!("lathe.stops.work-turns") };
    let coasts = (run_up::coasting(lathe), 1);
    let sinks = slides::axes(lathe).iter().find_map(DrivenAxis::sinks);
    let anew = anew(lathe);
    let mut rows = vec![
        row(
            Interruption::Hold,
            msg!("lathe.stops.axes-hold"),
            msg!("turning.stops.work-rubs"),
            msg!("lathe.stops.start"),
        ),
        row(Interruption::BlockStop, block.clone(), msg!("lathe.stops.work-turns"), msg!("lathe.stops.start")),
        row(Interruption::Alarm, block, msg!("turning.stops.work-rubs"), anew(Interruption::Alarm)),
        row(Interruption::Reset, msg!("lathe.stops.axes-reset"), reset, anew(Interruption::Reset)),
        row(
            Interruption::EmergencyStop,
            slides_at_emergency_stop(sinks),
            msg!("lathe.stops.work-slows"),
            anew(Interruption::EmergencyStop),
        ),
        row(
            Interruption::InverterFault,
            msg!("lathe.stops.axes-reset"),
            msg!("lathe.stops.work-coasts", time = coasts),
            anew(Interruption::InverterFault),
        ),
    ];
    let unpowered = if lathe.params.has_several_stages() {
        msg!("turning.stops.coasts-in-gear", time = coasts)
    } else {
        msg!("lathe.stops.work-coasts", time = coasts)
    };
    rows.push(Reaction {
        cite: if sinks.is_some() { CLOSING } else { DESIGN },
        ..row(Interruption::PowerFailure, slides_without_supply(sinks), unpowered, anew(Interruption::PowerFailure))
    });
    if let Some(patience) = gears::gear_times(lathe).patience.filter(|_| lathe.params.has_several_stages()) {
        rows.push(Reaction {
            cause: Some("turning.stops.gear-late"),
            spindle: SpindleReaction::Off,
            ..row(
                Interruption::Alarm,
                msg!("lathe.stops.axes-block"),
                msg!("turning.stops.gear-late-work", time = (patience, 1)),
                msg!("turning.stops.gear-late-mend"),
            )
        });
    }
    if lathe.params.has_several_stages() {
        rows.push(Reaction {
            cause: Some("turning.stops.gear-lost"),
            spindle: SpindleReaction::OutputOff,
            ..row(
                Interruption::Hold,
                msg!("lathe.stops.axes-hold"),
                msg!("turning.stops.gear-lost-work"),
                msg!("turning.stops.gear-lost-mend"),
            )
        });
    }
    if lathe.params.tailstock {
        rows.push(Reaction {
            cause: Some("turning.stops.let-go"),
            ..row(
                Interruption::InverterFault,
                msg!("lathe.stops.axes-hold"),
                msg!("turning.stops.let-go-work"),
                msg!("turning.stops.let-go-mend"),
            )
        });
    }
    if lathe.keyway().is_some() {
        rows.extend(in_keyway(lathe, sinks));
    }
    rows
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

/// Rows of the keyway: the spindle is locked at its angle, and the driven tool turns in the work.
fn in_keyway(lathe: &TurningSpindle, sinks: Option<f64>) -> [Reaction; 4] {
    // A clamp without a release code is opened by the ladder at reset; without any code the operator locks the spindle.
    let opens = matches!(lathe.lock_codes(), Some(CodePair { off: None, .. }));
    // Where the PLC reads the reset key, an emergency stop is no reset to it.
    let reads_key = lathe.dialect.device(lathe.control, SignalRole::ResetRequest).is_some();
    let [at_reset, at_emergency] = [opens, opens && !reads_key]
        .map(|opens| if opens { SpindleReaction::Unlocks } else { SpindleReaction::StaysLocked });
    let anew = anew(lathe);
    let row = |at, cause, spindle, axes: Message, material: Message, operator: Message| Reaction {
        at,
        cause: Some(cause),
        spindle,
        axes,
        material,
        operator,
        cite: DESIGN,
    };
    let (turns, stops) = (msg!("turning.stops.driven-turns"), msg!("turning.stops.driven-stops"));
    [
        row(
            Interruption::Hold,
            "turning.stops.keyway-hold",
            SpindleReaction::StaysLocked,
            msg!("lathe.stops.axes-hold"),
            turns,
            msg!("lathe.stops.start"),
        ),
        row(
            Interruption::Reset,
            "turning.stops.keyway-reset",
            at_reset,
            msg!("lathe.stops.axes-reset"),
            stops.clone(),
            anew(Interruption::Reset),
        ),
        row(
            Interruption::EmergencyStop,
            "turning.stops.keyway-emergency",
            at_emergency,
            slides_at_emergency_stop(sinks),
            stops,
            anew(Interruption::EmergencyStop),
        ),
        row(
            Interruption::PowerFailure,
            "turning.stops.keyway-power",
            SpindleReaction::StaysLocked,
            slides_without_supply(sinks),
            msg!("turning.stops.clamp-unpowered"),
            anew(Interruption::PowerFailure),
        ),
    ]
}

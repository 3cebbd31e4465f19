//! Interruptions of the ribbon line, from hold to inverter fault: the unwinder stops with the axes, or coasts and fills the loop.

use super::coasting;
use super::contacts::{CONTACTS, left_at_reel_end, room_below_sensor};
use super::resolved::RibbonLine;
use super::rules::slack::worst_loop;
use super::variables::PHASE;
use crate::machines::stops::{Interruption, Reaction, SpindleReaction};
use crate::msg;
use crate::text::{Citation, Grade, Message};

const MODEL: Citation = Citation::new("ribbon line facts, 7", Grade::Inferred);

/// Source of the effect of dry run and machine lock.
const DRY_RUN: Citation = Citation::new("ribbon line facts, 7", Grade::Open);

/// Reaction of the unwinder to an interruption.
pub(super) fn unwinder(at: Interruption) -> SpindleReaction {
    match at {
        Interruption::Hold | Interruption::BlockStop | Interruption::Alarm => SpindleReaction::Waits,
        Interruption::Reset | Interruption::EmergencyStop => SpindleReaction::Off,
        Interruption::InverterFault | Interruption::PowerFailure => SpindleReaction::OutputOff,
    }
}

/// The table, with the ribbon (mm) that each interruption lays into the loop.
pub(super) fn reactions(line: &RibbonLine) -> Vec<Reaction> {
    let (d, print) = (&line.derived, line.params.print_axis.letter());
    let laid = |mm: f64| msg!("ribbon.stops.laid", length = (mm, 0));
    let worst = worst_loop(line);
    let left = line.params.loop_capacity - (worst.slack.loop_needed - worst.slack.interruption);
    let again = match worst.slack.interruption {
        none if none <= 0.0 => laid(0.0),
        each => {
            let (hold, restart, pause) = ((d.slack.hold, 0), (d.slack.resume, 0), (d.slack.interruption, 0));
            let count = (left / each).max(0.0).floor();
            match line.regulating_time() {
                Some(time) => msg!("ribbon.stops.laid-twice-dancer", hold, restart, pause, time = (time, 0), count),
                None => msg!("ribbon.stops.laid-twice", hold, restart, pause, count),
            }
        }
    };
    let goes_on =
        if line.feeds_per_revolution() { msg!("ribbon.stops.start-in-step") } else { msg!("ribbon.stops.start") };
    // After a broken-off product a head has to be brought to the ribbon again.
    let finds_the_head = line.reads_positions();
    let variable = line.control.variable(PHASE);
    let anew = |by_program: fn(&str) -> Message, by_hand: fn(&str, &str) -> Message| {
        if finds_the_head { by_program(print) } else { by_hand(print, variable.as_str()) }
    };
    let row = |at, axes: Message, material, operator| Reaction {
        at,
        cause: None,
        spindle: unwinder(at),
        axes,
        material,
        operator,
        cite: MODEL,
    };
    let block = msg!("ribbon.stops.axes-block", axis = print);
    let mut rows = vec![
        row(Interruption::Hold, msg!("ribbon.stops.axes-hold", axis = print), again.clone(), goes_on.clone()),
        row(Interruption::BlockStop, block.clone(), again, goes_on),
        row(
            Interruption::Alarm,
            block,
            laid(d.slack.stop),
            anew(
                |axis| msg!("ribbon.stops.mend", axis),
                |axis, variable| msg!("ribbon.stops.mend-by-hand", axis, variable),
            ),
        ),
        row(
            Interruption::Reset,
            msg!("ribbon.stops.axes-reset", axis = print),
            laid(d.slack.hold),
            anew(
                |axis| msg!("ribbon.stops.anew", axis),
                |axis, variable| msg!("ribbon.stops.anew-by-hand", axis, variable),
            ),
        ),
        row(
            Interruption::EmergencyStop,
            msg!("ribbon.stops.axes-emergency", axis = print),
            laid(d.slack.hold),
            anew(
                |axis| msg!("ribbon.stops.clear", axis),
                |axis, variable| msg!("ribbon.stops.clear-by-hand", axis, variable),
            ),
        ),
        row(
            Interruption::InverterFault,
            msg!("ribbon.stops.axes-reset", axis = print),
            laid(coasting::laid_in_move(line, d)),
            anew(
                |axis| msg!("ribbon.stops.fault", axis),
                |axis, variable| msg!("ribbon.stops.fault-by-hand", axis, variable),
            ),
        ),
    ];
    rows.push(row(
        Interruption::PowerFailure,
        msg!("ribbon.stops.axes-unpowered", axis = print),
        laid(coasting::laid_in_move(line, d)),
        anew(
            |axis| msg!("ribbon.stops.power-on", axis),
            |axis, variable| msg!("ribbon.stops.power-on-by-hand", axis, variable),
        ),
    ));
    rows.extend(by_contacts(line));
    rows.push(dry_run(line));
    rows
}

/// Row of dry run and machine lock: the program runs on, the axes have another feed or stand still, and no signal tells the ladder to stop the
/// unwinder.
fn dry_run(line: &RibbonLine) -> Reaction {
    let (print, capacity) = (line.params.print_axis.letter(), line.params.loop_capacity);
    let (axis, speed) = (print, line.derived.feeds.mm_per_second());
    Reaction {
        at: Interruption::Hold,
        cause: Some("ribbon.stops.dry-run"),
        spindle: SpindleReaction::Turns,
        axes: msg!("ribbon.stops.axes-dry-run", axis),
        material: if speed > 0.0 {
            msg!("ribbon.stops.dry-run-fills", capacity = (capacity, 0), time = (capacity / speed, 1))
        } else {
            msg!("ribbon.stops.laid", length = (0.0, 0))
        },
        operator: msg!("ribbon.stops.without-ribbon", axis),
        cite: DRY_RUN,
    }
}

/// Rows of the contacts that hold the program, with the alarm of an inverter that is not ready.
fn by_contacts(line: &RibbonLine) -> [Reaction; 4] {
    let (d, print) = (&line.derived, line.params.print_axis.letter());
    let (axis, finds_the_head, in_step) = (print, line.reads_positions(), line.feeds_per_revolution());
    let variable = line.control.variable(PHASE);
    let variable = variable.as_str();
    let row = |at, cause, axes, material, operator| Reaction {
        at,
        cause: Some(cause),
        spindle: unwinder(at),
        axes,
        material,
        operator,
        cite: CONTACTS,
    };
    let hold = || msg!("ribbon.stops.axes-hold", axis);
    let laid = |mm: f64| msg!("ribbon.stops.laid", length = (mm, 0));
    [
        row(
            Interruption::Hold,
            "ribbon.stops.loop-full",
            hold(),
            msg!("ribbon.stops.room", length = (room_below_sensor(line), 0)),
            if finds_the_head {
                msg!("ribbon.stops.shorten", axis)
            } else {
                msg!("ribbon.stops.shorten-by-hand", axis, variable)
            },
        ),
        row(
            Interruption::Hold,
            "ribbon.stops.web-tight",
            hold(),
            laid(d.slack.hold),
            if in_step { msg!("ribbon.stops.hangs-in-step") } else { msg!("ribbon.stops.hangs") },
        ),
        row(
            Interruption::Hold,
            "ribbon.stops.reel-empty",
            hold(),
            msg!("ribbon.stops.left", length = (left_at_reel_end(line), 0)),
            if in_step { msg!("ribbon.stops.splice-in-step") } else { msg!("ribbon.stops.splice") },
        ),
        row(
            Interruption::InverterFault,
            "ribbon.stops.not-ready",
            msg!("ribbon.stops.axes-reset", axis),
            laid(coasting::laid_in_move(line, d)),
            if finds_the_head {
                msg!("ribbon.stops.make-ready", axis)
            } else {
                msg!("ribbon.stops.make-ready-by-hand", axis, variable)
            },
        ),
    ]
}

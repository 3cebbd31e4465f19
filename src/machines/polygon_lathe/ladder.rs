//! The PMC program of the paper's figure 5, reconstructed from the signals in its text; the picture is lost.
//!
//! The paper names channels and their signals, but not the instructions that turn an axis to an angle or at a speed. Those are a named
//! block (`AXIS6`, `AXIS7`: tool and work) with its interface: the rungs request a motion, and read whether it is finished or the axis is
//! at rest.

use super::citations::PAPER;
use super::program::{
    self, AT_ANGLE, AT_SPEED, IDLE, INDEX, ON, SPEED, TOOL_ANGLE, TOOL_RATIO, TURN, WORK_ANGLE, WORK_RATIO,
};
use super::resolved::PolygonLathe;
use super::stops;
use super::turned_end_form::TurnedEnd;
use crate::controls::interface::SignalRole;
use crate::machines::ladder::book::Book;
use crate::machines::ladder::codes::{DirectionSignal, STARTED, SpindleRequirements};
use crate::machines::ladder::{Bit, Ladder, MachineContact, MachineOutput, Operator, PlcNumber, PlcWidth, off, on};
use crate::motion::PMC_AXES;
use crate::text::{Citation, Grade};

pub(super) const OURS: Citation =
    Citation::new("our own choice; signals and channels by the paper's section 3.1", Grade::Open);

/// Signals of the named blocks, work before tool.
pub(super) const GO_TO_ANGLE: [Bit; PMC_AXES] = [Bit::Block("AXIS7.INDEX"), Bit::Block("AXIS6.INDEX")];
pub(super) const RUN: [Bit; PMC_AXES] = [Bit::Block("AXIS7.RUN"), Bit::Block("AXIS6.RUN")];
pub(super) const DONE: [Bit; PMC_AXES] = [Bit::Block("AXIS7.DONE"), Bit::Block("AXIS6.DONE")];
pub(super) const AT_STANDSTILL: [Bit; PMC_AXES] = [Bit::Block("AXIS7.STANDS"), Bit::Block("AXIS6.STANDS")];
pub(super) const ANGLE: [PlcNumber; PMC_AXES] = [PlcNumber::Block("AXIS7.ANGLE"), PlcNumber::Block("AXIS6.ANGLE")];
pub(super) const RPM: [PlcNumber; PMC_AXES] = [PlcNumber::Block("AXIS7.SPEED"), PlcNumber::Block("AXIS6.SPEED")];
/// Slow down and stop: channels 7 and 6.
pub(super) const STOP: [Bit; PMC_AXES] = [Bit::Device("G400.3"), Bit::Device("G360.3")];

/// Relay of the sequence: the request has been accepted.
const TAKEN: Bit = Bit::Relay("taken");
const STOPPING: Bit = Bit::Relay("stopping");
const SPENT: Bit = Bit::Relay("spent");
const INDEXED: Bit = Bit::Relay("indexed");
const TURNING: Bit = Bit::Relay("turning");
/// The spindle override is 100 % at any position of the knob.
const OVERRIDE_FIXED: Bit = Bit::Relay("override-fixed");
/// M3 or M4 while the sequence holds the main spindle: its answer waits.
const SPINDLE_WAITS: Bit = Bit::Relay("spindle-waits");

/// The ladder of the lathe.
pub(super) fn ladder(lathe: &PolygonLathe) -> Ladder {
    let mut book = Book::new(lathe.control, &lathe.dialect);
    // The emergency stop is delayed by its relay until work and tool are at rest: at once it would switch off their
    // drives in the cut.
    let delayed = !lathe.params.coasts(lathe.control);
    book.emergency_by(if delayed { MachineContact::EmergencyDelayed } else { MachineContact::Emergency });
    let mut busy = Vec::new();
    if lathe.has_main_spindle() {
        // Before the run command: both read the sequence of the scan before, so that the answer never precedes the run command.
        let waits = [3, 4].map(|code| vec![on(book.function(code)), on(TAKEN)]);
        book.coil(SPINDLE_WAITS, waits.to_vec(), "polygon.ladder.spindle-waits");
        busy.push(SPINDLE_WAITS);
        book.program_state();
        spindle_override(&mut book, lathe);
        let rules = lathe.dialect.spindle();
        let reaction = |at| stops::main_spindle(lathe, at);
        let reports_speed = rules.reached.is_some();
        let requirements = SpindleRequirements {
            reaction: &reaction,
            reports_speed,
            reports_standstill: true,
            holds: &[],
            locked_by: &[TAKEN],
            has_gears: false,
            positions: false,
            emergency_holds: delayed,
            direction: DirectionSignal::Contacts,
        };
        book.spindle(&rules, &requirements);
        follow_up(&mut book);
    } else {
        let button = delayed.then_some(MachineContact::Emergency);
        let closed = [MachineContact::HoldKey].into_iter().chain(button).map(|contact| on(Bit::Input(contact)));
        let note = if delayed { "polygon.ladder.emergency-hold" } else { "polygon.ladder.hold-key" };
        book.coil(Bit::Signal(SignalRole::HoldReleased), vec![closed.collect()], note);
    }
    channels(&mut book);
    sequence(&mut book, lathe.params.settling(), delayed);
    answers(&mut book, lathe.has_main_spindle());
    // A single cutter is on its own spindle at the slide: its T only selects the offset, and no turret turns.
    busy.extend(program::changes_tools(lathe).then(|| book.turret()));
    book.answer(&busy);
    meanings(&mut book);
    book.finish()
}

/// The knob of the spindle override to the control. With a thread the override is 100 % from M49 until M5 or the end of
/// the program.
fn spindle_override(book: &mut Book, lathe: &PolygonLathe) {
    let threads = lathe.params.turned_ends.iter().any(TurnedEnd::threads);
    if !threads || book.has(SignalRole::SpindleOverrideCode) {
        book.spindle_override();
        return;
    }
    let [fixes, stops] = [program::OVERRIDE_OFF, 5].map(|code| book.function(code));
    let stays = [on(fixes), on(OVERRIDE_FIXED)].map(|first| vec![first, on(STARTED), off(stops)]);
    book.coil(OVERRIDE_FIXED, stays.to_vec(), "polygon.ladder.override-fixed");
    let register = PlcNumber::Signal(SignalRole::SpindleOverride);
    book.copy(PlcNumber::Knob, register, vec![vec![off(OVERRIDE_FIXED)]], "turning.ladder.override");
    book.copy(PlcNumber::Constant(100), register, vec![vec![on(OVERRIDE_FIXED)]], "polygon.ladder.override-whole");
    book.override_valid();
}

/// Servo off of the work's axis (axis 4), and its follow-up, which acts while the signal is 0. Both signals are from
/// memory.
const SERVO_OFF: Bit = Bit::Device("G126.3");
const FOLLOW_UP: Bit = Bit::Device("G7.5");

/// While the main spindle turns the work, the servo motor on the same shaft is off and its position is followed up,
/// because its position loop would work against the inverter.
fn follow_up(book: &mut Book) {
    let mut turns = [MachineOutput::Forward, MachineOutput::Reverse].map(|run| vec![on(Bit::Output(run))]).to_vec();
    // Until the spindle is at rest, unless the servo itself turns it.
    turns.push(vec![off(Bit::Input(MachineContact::AtStandstill)), off(TAKEN)]);
    let rows = [
        (SERVO_OFF, turns, "polygon.ladder.servo-off"),
        (FOLLOW_UP, vec![vec![off(SERVO_OFF)]], "polygon.ladder.follow-up"),
    ];
    for (device, branches, note) in rows {
        book.coil(device, branches, note);
        book.means(device, note, OURS);
    }
}

/// Rungs that assign the axes to their channels, and the signals that are always on for the channels.
fn channels(book: &mut Book) {
    for (device, note) in [
        ("G159.2", "polygon.ladder.overlap-tool"),
        ("G159.3", "polygon.ladder.overlap-work"),
        ("G366.2", "polygon.ladder.select-tool"),
        ("G406.3", "polygon.ladder.select-work"),
    ] {
        book.coil(Bit::Device(device), Book::always(), note);
        book.means(Bit::Device(device), note, PAPER);
    }
    let reset = Bit::Signal(SignalRole::Reset);
    let rows = [
        ("G360.1", vec![on(reset)], "polygon.ladder.reset-tool"),
        ("G400.1", vec![on(reset)], "polygon.ladder.reset-work"),
        ("G360.2", vec![off(TAKEN), on(TAKEN)], "polygon.ladder.hold-tool"),
        ("G400.2", vec![off(TAKEN), on(TAKEN)], "polygon.ladder.hold-work"),
        ("G360.6", vec![off(TAKEN)], "polygon.ladder.update-tool"),
        ("G400.6", vec![off(TAKEN)], "polygon.ladder.update-work"),
    ];
    for (device, branch, note) in rows {
        book.coil(Bit::Device(device), vec![branch], note);
        book.means(Bit::Device(device), note, PAPER);
    }
    for (angle, variable, note) in
        [(ANGLE[1], TOOL_ANGLE, "polygon.ladder.angle-tool"), (ANGLE[0], WORK_ANGLE, "polygon.ladder.angle-work")]
    {
        book.copy_double(written(variable), angle, Book::always(), note);
    }
    for (speed, ratio, note) in
        [(RPM[1], TOOL_RATIO, "polygon.ladder.speed-tool"), (RPM[0], WORK_RATIO, "polygon.ladder.speed-work")]
    {
        book.compute(Operator::Multiply, [written(SPEED), written(ratio), speed], PlcWidth::DoubleWord, note);
    }
}

/// From the request to the start angles, the run and the stop.
fn sequence(book: &mut Book, settling: f64, stops_at_button: bool) {
    let [index, turn] = [INDEX, TURN].map(Bit::Macro);
    let reset = Bit::Signal(SignalRole::Reset);
    let (settled, at_speed) = (Bit::Timer("angle-settled"), Bit::Timer("speed-settled"));
    let mut over = vec![
        vec![on(TURNING), off(turn)],
        vec![on(TAKEN), off(TURNING), off(index)],
        vec![on(TAKEN), on(reset)],
        // With only one drive the ratio would be lost in the cut.
        vec![on(TAKEN), on(Bit::Signal(SignalRole::Alarm))],
        vec![on(STOPPING), on(TAKEN)],
    ];
    over.extend(stops_at_button.then(|| vec![on(TAKEN), off(Bit::Input(MachineContact::Emergency))]));
    book.coil(STOPPING, over, "polygon.ladder.stop");
    let spent = [STOPPING, SPENT].into_iter().flat_map(|bit| [index, turn].map(|asked| vec![on(bit), on(asked)]));
    book.coil(SPENT, spent.collect(), "polygon.ladder.spent");
    let taken = vec![
        vec![on(index), off(STOPPING), off(SPENT)],
        vec![on(TAKEN), off(STOPPING)],
        vec![on(TAKEN), off(AT_STANDSTILL[0])],
        vec![on(TAKEN), off(AT_STANDSTILL[1])],
    ];
    book.coil(TAKEN, taken, "polygon.ladder.index");
    for (go, note) in [(GO_TO_ANGLE[1], "polygon.ladder.index-tool"), (GO_TO_ANGLE[0], "polygon.ladder.index-work")] {
        book.coil(go, vec![vec![on(TAKEN), off(INDEXED), off(STOPPING)]], note);
    }
    let there = vec![on(TAKEN), off(STOPPING), on(DONE[0]), on(DONE[1])];
    book.timer("angle-settled", settling, vec![there], "polygon.ladder.settle");
    let stays =
        |begins: Bit, bit: Bit| [on(begins), on(bit)].map(|first| vec![first, on(TAKEN), off(STOPPING)]).to_vec();
    book.coil(INDEXED, stays(settled, INDEXED), "polygon.ladder.at-angle");
    let mut runs = stays(INDEXED, TURNING);
    runs[0].push(on(turn));
    book.coil(TURNING, runs, "polygon.ladder.turn");
    for (run, note) in [(RUN[1], "polygon.ladder.run-tool"), (RUN[0], "polygon.ladder.run-work")] {
        book.coil(run, vec![vec![on(TURNING)]], note);
    }
    book.timer("speed-settled", settling, vec![vec![on(TURNING)]], "polygon.ladder.settle");
    book.coil(Bit::Macro(AT_SPEED), vec![vec![on(TURNING), on(at_speed)]], "polygon.ladder.at-speed");
    for (stop, note) in [(STOP[1], "polygon.ladder.stop-tool"), (STOP[0], "polygon.ladder.stop-work")] {
        book.coil(stop, vec![vec![on(STOPPING)]], note);
        book.means(stop, note, PAPER);
    }
}

/// The bits that the program reads.
fn answers(book: &mut Book, has_main_spindle: bool) {
    let [index, turn] = [INDEX, TURN].map(Bit::Macro);
    let mut idle = vec![off(TAKEN), off(index), off(turn)];
    if has_main_spindle {
        // The inverter would turn the work against the servo motor.
        idle.extend([MachineOutput::Forward, MachineOutput::Reverse].map(|run| off(Bit::Output(run))));
        // Without its run command the spindle still slows down, or coasts with the inverter off: the standstill contact
        // decides.
        idle.push(on(Bit::Input(MachineContact::AtStandstill)));
    }
    book.coil(Bit::Macro(AT_ANGLE), vec![vec![on(INDEXED)]], "polygon.ladder.bit");
    book.coil(Bit::Macro(ON), vec![vec![on(TAKEN)]], "polygon.ladder.on");
    book.coil(Bit::Macro(IDLE), vec![idle], "polygon.ladder.idle");
}

/// Meanings of variables and blocks.
fn meanings(book: &mut Book) {
    for (variable, meaning) in [
        (INDEX, "polygon.signal.index"),
        (TURN, "polygon.signal.turn"),
        (AT_ANGLE, "polygon.signal.at-angle"),
        (AT_SPEED, "polygon.signal.at-speed"),
        (ON, "polygon.signal.on"),
        (IDLE, "polygon.signal.idle"),
    ] {
        book.means(Bit::Macro(variable), meaning, OURS);
    }
    for (variable, meaning, cite) in [
        (SPEED, "polygon.plc.speed", PAPER),
        (WORK_RATIO, "polygon.plc.work-ratio", PAPER),
        (TOOL_RATIO, "polygon.plc.tool-ratio", PAPER),
        (WORK_ANGLE, "polygon.plc.work-angle", OURS),
        (TOOL_ANGLE, "polygon.plc.tool-angle", OURS),
    ] {
        book.means_number(written(variable), meaning, cite);
    }
    let both = [
        (GO_TO_ANGLE, ["polygon.ladder.index-work", "polygon.ladder.index-tool"]),
        (RUN, ["polygon.ladder.run-work", "polygon.ladder.run-tool"]),
        (DONE, ["polygon.block.done-work", "polygon.block.done-tool"]),
        (AT_STANDSTILL, ["polygon.block.stands-work", "polygon.block.stands-tool"]),
    ];
    for (bits, meanings) in both {
        bits.into_iter().zip(meanings).for_each(|(bit, meaning)| book.means(bit, meaning, OURS));
    }
    for (words, meanings) in [
        (ANGLE, ["polygon.plc.work-angle", "polygon.plc.tool-angle"]),
        (RPM, ["polygon.ladder.speed-work", "polygon.ladder.speed-tool"]),
    ] {
        words.into_iter().zip(meanings).for_each(|(word, meaning)| book.means_number(word, meaning, OURS));
    }
}

fn written(variable: u32) -> PlcNumber {
    PlcNumber::Signal(SignalRole::MacroOutput(variable))
}

//! The ladder of the ribbon line: the knob (the paper's figure 1), the unwinder, its stops and restart, and the contacts that hold the program.

use super::contacts::{CONTACTS, holding};
use super::derive::FIN_DELAY;
use super::params::Wait;
use super::resolved::RibbonLine;
use super::stops::unwinder;
use crate::controls::interface::{PlcLanguage, SignalRole};
use crate::machines::ladder::book::Book;
use crate::machines::ladder::codes::{BUSY, DirectionSignal, INTERRUPTED, STARTED, SpindleRequirements};
use crate::machines::ladder::{Bit, Ladder, MachineContact, MachineOutput, Operator, PlcNumber, PlcWidth, off, on};

/// The axes wait for the unwinder at the restart.
const RESTART: Bit = Bit::Relay("restart");

/// The ladder of the line.
pub(super) fn ladder(line: &RibbonLine) -> Ladder {
    let mut book = Book::new(line.control, &line.dialect);
    book.emergency();
    book.program_state();
    overrides(&mut book, line);
    let rules = line.dialect.spindle();
    let waits = line.params.wait == Wait::Fin;
    let reports_speed = waits || rules.reached.is_some();
    let holds = holding(line);
    let requirements = SpindleRequirements {
        reaction: &unwinder,
        reports_speed,
        reports_standstill: false,
        holds: &holds,
        locked_by: &[],
        has_gears: false,
        positions: false,
        emergency_holds: false,
        direction: DirectionSignal::Contacts,
    };
    book.spindle(&rules, &requirements);
    holds.into_iter().for_each(|contact| book.cite_input(contact, CONTACTS));
    if waits {
        run_up(&mut book);
    }
    book.answer(if waits { &[BUSY] } else { &[] });
    if !line.feeds_per_revolution() {
        restart(&mut book, line);
    }
    book.finish()
}

/// The knob to the control and to the program, and the fixed feed override.
fn overrides(book: &mut Book, line: &RibbonLine) {
    let p = &line.params;
    let register = PlcNumber::Signal(SignalRole::SpindleOverride);
    let mut knob = PlcNumber::Knob;
    book.override_valid();
    if book.has(SignalRole::SpindleOverrideCode) {
        // A code has steps of 10 %, which the program gets, too.
        let tens = book.override_code(line.lowest_position());
        if line.override_macro_input().is_some() {
            knob = book.override_of_code(tens, line.lowest_position());
        }
    } else {
        let step = p.knob_step.percent();
        if step > 1.0 {
            let (half, steps, percent) =
                (PlcNumber::Data("half"), PlcNumber::Data("steps"), PlcNumber::Data("percent"));
            let step = PlcNumber::Constant(step as i32);
            let middle = PlcNumber::Constant((p.knob_step.percent() / 2.0) as i32);
            book.compute(Operator::Add, [knob, middle, half], PlcWidth::Word, "ribbon.ladder.half");
            book.compute(Operator::Divide, [half, step, steps], PlcWidth::Word, "ribbon.ladder.divide");
            book.compute(Operator::Multiply, [steps, step, percent], PlcWidth::Word, "ribbon.ladder.multiply");
            knob = percent;
        }
        if !p.knob_is_locked() {
            knob = from_the_lowest(book, line, knob);
        }
        if p.knob_is_locked() {
            book.copy(knob, register, vec![vec![off(STARTED)]], "ribbon.ladder.override");
            book.copy(PlcNumber::Constant(100), register, vec![vec![on(STARTED)]], "ribbon.ladder.locked");
        } else {
            book.copy(knob, register, Book::always(), "ribbon.ladder.override");
        }
        // The register of figure 1 has 16 bits, others one byte.
        if line.control.plc == PlcLanguage::Melsec {
            knob = register;
        }
    }
    if book.has(SignalRole::FeedOverride) {
        let feed = PlcNumber::Signal(SignalRole::FeedOverride);
        book.copy(PlcNumber::Constant(100), feed, Book::always(), "ribbon.ladder.feed");
    }
    if book.has(SignalRole::FeedOverrideByRegister) {
        book.coil(Bit::Signal(SignalRole::FeedOverrideByRegister), Book::always(), "ribbon.ladder.feed-register");
    }
    if book.has(SignalRole::FeedOverrideOff) {
        book.coil(Bit::Signal(SignalRole::FeedOverrideOff), Book::always(), "ribbon.ladder.feed");
    }
    if book.has(SignalRole::FeedOverrideValid) {
        book.coil(Bit::Signal(SignalRole::FeedOverrideValid), Book::never(), "ribbon.ladder.feed-invalid");
    }
    let Some(input) = line.override_macro_input() else { return };
    let low = PlcNumber::Signal(SignalRole::MacroInputLow(input));
    if p.reads_final_speed() && book.has(SignalRole::SpindleFinal) {
        book.copy_double(PlcNumber::Signal(SignalRole::SpindleFinal), low, Book::always(), "ribbon.ladder.final");
        return;
    }
    let high = SignalRole::MacroInputHigh(input);
    let note = if book.has(high) { "ribbon.ladder.low" } else { "ribbon.ladder.word" };
    book.copy(knob, low, Book::always(), note);
    if book.has(high) {
        book.copy(PlcNumber::Constant(0), PlcNumber::Signal(high), Book::always(), "ribbon.ladder.high");
    }
}

/// The knob from the lowest position of the line on: a lower one is raised to it, 0 stops the line.
fn from_the_lowest(book: &mut Book, line: &RibbonLine, knob: PlcNumber) -> PlcNumber {
    let [low, zero, raised] = ["knob-low", "knob-zero", "knob-raised"].map(Bit::Relay);
    let limited = PlcNumber::Data("limited");
    let lowest = line.lowest_position() as i32;
    book.below(knob, lowest, low, "ribbon.ladder.knob-low");
    book.below(knob, 1, zero, "ribbon.ladder.knob-zero");
    book.coil(raised, vec![vec![on(low), off(zero)]], "ribbon.ladder.knob-raised");
    book.copy(knob, limited, vec![vec![off(raised)]], "ribbon.ladder.knob-free");
    book.copy(PlcNumber::Constant(lowest), limited, vec![vec![on(raised)]], "ribbon.ladder.knob-lowest");
    limited
}

/// M3 and M4 are done when the inverter reports the speed; it may report speed 0 as reached until it sees the new one.
fn run_up(book: &mut Book) {
    let [m3, m4] = [3, 4].map(|code| book.function(code));
    let (settled, speed) = (Bit::Timer("settled"), Bit::Input(MachineContact::AtSpeed));
    let mut waits = Vec::new();
    // With FIN the timer starts on the code, not on BUSY: BUSY would drop out with its own timer and start it again.
    let mut begun = vec![vec![on(BUSY)]];
    if book.has(SignalRole::Finished) {
        // The codes stay until FIN.
        for code in [m3, m4] {
            waits.extend([vec![on(code), off(settled)], vec![on(code), off(speed)]]);
        }
        begun = vec![vec![on(m3)], vec![on(m4)]];
    } else {
        let reset = book.reset();
        waits.extend([vec![on(m3)], vec![on(m4)]]);
        waits.extend([settled, speed].map(|done| vec![on(BUSY), off(done), off(reset)]));
    }
    book.coil(BUSY, waits, "ribbon.ladder.run-up");
    book.timer("settled", FIN_DELAY, begun, "ribbon.ladder.settle");
}

/// At cycle start after an interruption the unwinder runs up first, and the axes wait for it as they do after M3.
fn restart(book: &mut Book, line: &RibbonLine) {
    let reset = book.reset();
    let (waited, speed) = (Bit::Timer("waited"), Bit::Input(MachineContact::AtSpeed));
    let begins = |run: MachineOutput| vec![on(INTERRUPTED), on(Bit::Output(run)), off(reset)];
    let mut waits = vec![
        begins(MachineOutput::Forward),
        begins(MachineOutput::Reverse),
        vec![on(RESTART), off(waited), off(reset)],
    ];
    let (seconds, note) = match line.params.wait {
        Wait::Dwell => (FIN_DELAY + line.params.dwell, "ribbon.ladder.dwell"),
        Wait::Fin => (FIN_DELAY, "ribbon.ladder.settle"),
    };
    if line.params.wait == Wait::Fin {
        waits.push(vec![on(RESTART), off(speed), off(reset)]);
    }
    book.coil(RESTART, waits, "ribbon.ladder.wait");
    book.timer("waited", seconds, vec![vec![on(RESTART), off(INTERRUPTED)]], note);
    let held = vec![vec![on(RESTART), off(INTERRUPTED)]];
    let free = vec![vec![off(RESTART)], vec![on(INTERRUPTED)]];
    book.hold_axes(held, free, "ribbon.ladder.axes");
}

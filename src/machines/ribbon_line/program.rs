//! The program of the ribbon line: O9100 computes, O9101 runs, O9102 sets the project's values once.
//!
//! Written with the words and codes of the control: G91 or incremental addresses, exact stop or none, #3004 or none.
//! O9100 and O9101 never write the operator's variables (those of O9102), so that products are changed by variables alone.

use super::derive::{SHORTEST, WHOLE};
use super::params::{Endless, OverrideForm, PathMode, Rest, Variant, Wait};
use super::phase;
use super::resolved::RibbonLine;
use super::variables::{
    ACTUAL_SPEED, BLOCK_PITCHES, BLOCK_SIZE, BLOCK_STROKE, COUNT, FEED_LIMIT, FEED_PER_TURN, HEADS, HEADS_COPY, KNOB,
    LAST, LEFT, LENGTH, LENGTH_LEFT, LINE_SPEED, PITCH, PITCH_COPY, PRESS_ROLLER, PRESS_ROLLER_COPY, PRINT_ROLLER,
    PRINT_ROLLER_COPY, PRINT_TRAVEL, PULL, REDUCTION, REDUCTION_COPY, REMAINDER, RIBBON_PER_TURN, RUNNING_SPEED, SPEED,
    SPEED_CLAMP, SPEED_COPY, STROKE, VECTOR_FEED,
};
use crate::controls::Address;
use crate::controls::interface::SignalRole;
use crate::controls::{Code, VarKind};
use crate::machines::machine::MachineVariable;
use crate::machines::writing::{self, OperatorVariable, alarm_block};
use crate::nc::Deck;
use crate::nc::build::{Builder, Condition, Formula, NewWord, f, g, m, real, s, v, word, x};

/// Number of the program that computes.
pub(super) const COMPUTE: u32 = 9100;
/// Number of the program that runs the machine.
pub(super) const RUN: u32 = 9101;
/// Number of the program that sets the project's values.
pub(super) const SETUP: u32 = 9102;

/// The operator's variables.
const ENTRIES: [OperatorVariable; 10] = [
    OperatorVariable::whole(SPEED),
    OperatorVariable::any(REDUCTION),
    OperatorVariable::any(PRESS_ROLLER),
    OperatorVariable::any(PITCH),
    OperatorVariable::whole(HEADS),
    OperatorVariable::any(PRINT_ROLLER),
    OperatorVariable::any(SPEED_CLAMP),
    OperatorVariable::any(FEED_LIMIT),
    OperatorVariable::whole(COUNT),
    OperatorVariable::whole(BLOCK_SIZE),
];

/// Number of the alarm of an F above the limit.
const FEED_ALARM: u32 = 20;
/// Numbers of the alarms about a length: below a pitch, no whole pitches.
const SHORT_ALARM: u32 = 21;
const WHOLE_ALARM: u32 = 22;

/// Whether a product is given by its length, independent of the pitch.
fn is_length(line: &RibbonLine) -> bool {
    line.p.is_length(line.control)
}

/// The operator's variables on this control.
fn entries(line: &RibbonLine) -> Vec<OperatorVariable> {
    let typed = line.handed().is_none().then_some(OperatorVariable::any(line.input()));
    let product = |entry: OperatorVariable| match entry.number {
        COUNT if is_length(line) => OperatorVariable::any(LENGTH),
        _ => entry,
    };
    ENTRIES.into_iter().map(product).chain(typed).collect()
}

/// Variables that the operator reads and sets.
pub(super) fn variables(line: &RibbonLine) -> Vec<MachineVariable> {
    let variable = MachineVariable::new;
    let per_turn = line.in_step();
    let mut all = vec![
        variable(SPEED, "ribbon.spindle-speed", "r/min"),
        variable(REDUCTION, "ribbon.reduction-ratio", ": 1"),
        variable(PRESS_ROLLER, "ribbon.press-roller-diameter", "mm"),
        variable(PITCH, "ribbon.pitch", "mm"),
        variable(HEADS, "ribbon.heads", ""),
        variable(PRINT_ROLLER, "ribbon.print-roller-diameter", "mm"),
        variable(SPEED_CLAMP, "ribbon.speed-clamp", "r/min"),
        variable(FEED_LIMIT, "ribbon.feed-limit", if per_turn { "mm/rev" } else { "mm/min" }),
        if is_length(line) {
            variable(LENGTH, "ribbon.product-length", "mm")
        } else {
            variable(COUNT, "ribbon.pitch-count", "")
        },
        variable(BLOCK_SIZE, "ribbon.pitches-per-block", ""),
        variable(line.input(), "ribbon.variable.input", ""),
        variable(ACTUAL_SPEED, "ribbon.readout.actual-speed", "r/min"),
        variable(LINE_SPEED, "ribbon.readout.line-speed", "mm/min"),
        variable(STROKE, "ribbon.readout.y-stroke", ""),
        variable(VECTOR_FEED, "ribbon.readout.vector-feed", "mm/min"),
    ];
    let ready_made = line.p.variant == Variant::ReadyMade;
    if per_turn || ready_made {
        all.push(variable(FEED_PER_TURN, "ribbon.readout.feed-per-revolution", "mm/rev"));
    }
    if ready_made {
        all.push(variable(RIBBON_PER_TURN, "ribbon.readout.k", "mm/rev"));
    }
    all.extend([
        variable(REMAINDER, "ribbon.variable.remainder", ""),
        variable(LEFT, "ribbon.variable.left", ""),
        variable(BLOCK_PITCHES, "ribbon.variable.block", ""),
    ]);
    all
}

/// Entries that change the motion of a running line, each with the variable of its copy.
const WATCHED: [(u32, u32); 6] = [
    (SPEED, SPEED_COPY),
    (REDUCTION, REDUCTION_COPY),
    (PRESS_ROLLER, PRESS_ROLLER_COPY),
    (PITCH, PITCH_COPY),
    (HEADS, HEADS_COPY),
    (PRINT_ROLLER, PRINT_ROLLER_COPY),
];

/// The programs, one per file.
pub(super) fn deck(line: &RibbonLine) -> Deck {
    let mut b = Builder::new();
    match line.p.variant {
        Variant::ReadyMade => {
            compute(&mut b, line);
            run(&mut b, line);
        }
        Variant::Published => {
            published(&mut b, line);
            run_published(&mut b, line);
        }
        Variant::Precomputed => {
            precompute(&mut b, line);
            run_precomputed(&mut b, line);
        }
    }
    setup(&mut b, line);
    b.finish()
}

fn header(b: &mut Builder, line: &RibbonLine) {
    writing::write_header::<RibbonLine>(b, &line.form, line.control);
}

/// The control's own codes for these functions, without those that it lacks.
fn codes(line: &RibbonLine, wanted: impl IntoIterator<Item = Code>) -> Vec<NewWord> {
    writing::codes(line.control, wanted)
}

/// A word that moves an axis by `by`: with the incremental address, or with the axis address under G91.
fn travel(line: &RibbonLine, axis: usize, by: Formula) -> NewWord {
    let row = line.control.axes.get(axis);
    let own = row.map_or(Address::X, |row| row.letter);
    let incremental = row.and_then(|row| row.incremental).filter(|_| !line.control.can(Code::Incremental));
    word(incremental.unwrap_or(own), by)
}

/// A note about the print roller's axis.
fn about(line: &RibbonLine, what: &str) -> String {
    format!("{} {what}", line.p.print_axis.address())
}

/// Words of the pull axis for a length of ribbon in mm.
fn pull_words(line: &RibbonLine, ribbon: Formula) -> Formula {
    match line.pull_words() {
        1 => ribbon,
        words => ribbon * words,
    }
}

/// The block that pulls and prints. An exact stop that acts in one block alone is written in each.
fn move_block(line: &RibbonLine, pull: Formula) -> Vec<NewWord> {
    let once = line.p.path_mode == PathMode::ExactStop && !line.control.can(Code::ExactStop);
    let mut words = codes(line, once.then_some(Code::ExactStopOnce));
    words.extend([
        g(1),
        travel(line, line.pull(), pull),
        travel(line, line.print(), v(PRINT_TRAVEL)),
        f(v(feed(line))),
    ]);
    words
}

/// Unit of F.
fn feed_unit(line: &RibbonLine) -> Code {
    if line.in_step() { Code::FeedPerRevolution } else { Code::FeedPerMinute }
}

/// A short dwell before the program reads the override knob again.
fn wait_for_knob(b: &mut Builder, line: &RibbonLine) {
    writing::wait(b, line.control, feed_unit(line), real(0.1, 3), "OVERRIDE 0: WAIT");
}

/// Incremental dimensions, unit of F, and how blocks join.
fn modes(line: &RibbonLine) -> Vec<NewWord> {
    let path = if line.p.path_mode == PathMode::ExactStop { Code::ExactStop } else { Code::Cutting };
    codes(line, [Code::Incremental, feed_unit(line), path])
}

/// Turns the feed override off, if the control has a variable for it.
fn override_off(b: &mut Builder, line: &RibbonLine, number: u32) {
    if overrides_can_be_off(line) {
        b.n(number).assign(3004, 2).note("FEED OVERRIDE OFF");
    }
}

/// Whether the program can switch the feed override off.
fn overrides_can_be_off(line: &RibbonLine) -> bool {
    line.control.var(3004).is_some_and(|row| row.kind == VarKind::SuppressOverride)
}

/// Whether the feed override slows down the axes, and not the unwinder: neither the program nor the PLC can fix it at 100 %.
pub(super) fn feed_override_acts(line: &RibbonLine) -> bool {
    let fixed_by_plc = line.dialect.device(line.control, SignalRole::FeedOverrideOff).is_some();
    !overrides_can_be_off(line) && !fixed_by_plc && !feed_override_stops(line)
}

/// Whether the PLC fixes the feed override at 100 %, but for 0 %, which stops the axes and not the unwinder.
pub(super) fn feed_override_stops(line: &RibbonLine) -> bool {
    line.dialect.device(line.control, SignalRole::FeedOverrideValid).is_some()
}

/// Whether the program shifts the coordinates back at each start.
fn presets(line: &RibbonLine) -> bool {
    line.p.endless == Endless::Shift
}

/// Brings a head to the ribbon before the product begins.
fn to_head(b: &mut Builder, line: &RibbonLine, next: u32) {
    phase::to_head(b, line, next, |by| travel(line, line.print(), by));
}

/// Sets the present position to zero, because the coordinates otherwise only grow.
fn preset(b: &mut Builder, line: &RibbonLine, number: u32) {
    if !presets(line) {
        return;
    }
    let zero = || real(0.0, 0);
    let mut words = codes(line, [Code::SetCoordinates]);
    words.extend([x(zero()), word(line.p.print_axis.address(), zero())]);
    b.n(number).words(words);
}

/// π as it is written: 3.141592654, or 3.14.
///
/// The vector feed takes π almost squared: with eight decimals it would come out 2.3e-9 low, with nine it is right to 3e-10. Where the
/// control takes fewer digits, it gets what fits.
fn pi(line: &RibbonLine) -> Formula {
    let decimals = line.dialect.reading.digits.saturating_sub(1).min(9);
    real(line.p.program_pi(), decimals as u8)
}

/// Actual spindle speed, equation (1). `input` holds the PLC's word.
fn actual_speed(line: &RibbonLine, input: u32) -> Formula {
    match line.p.override_form {
        OverrideForm::Percent => v(SPEED) * v(input) / 100,
        OverrideForm::FinalSpeed => v(input),
    }
}

/// Travel of the print roller per pitch: one head further.
fn print_stroke(line: &RibbonLine) -> Formula {
    if line.degrees() { real(360.0, 0) / v(HEADS) } else { pi(line) * v(PRINT_ROLLER) / v(HEADS) }
}

/// Vector feed from the speed of the ribbon, equation (4): the block N30 that the paper leaves out.
fn vector_feed(speed: Formula) -> Formula {
    speed * (v(PITCH) * v(PITCH) + v(STROKE) * v(STROKE)).sqrt() / v(PITCH)
}

/// Least F (mm/min): the control reads a smaller one as F0.
fn least_feed() -> Formula {
    real(0.001, 3)
}

/// The vector feed moves the axes.
fn moves() -> Condition {
    v(VECTOR_FEED).ge(least_feed())
}

/// The vector feed is none: the override is 0.
fn stands() -> Condition {
    v(VECTOR_FEED).lt(least_feed())
}

/// Ribbon per revolution of the unwinder's motor, equation (2).
fn per_turn(line: &RibbonLine) -> Formula {
    pi(line) * v(PRESS_ROLLER) / v(REDUCTION)
}

/// The alarm of an F above the limit.
fn feed_alarm(b: &mut Builder, line: &RibbonLine) {
    let feed = line.control.variable(feed(line));
    let limit = line.control.variable(FEED_LIMIT);
    writing::alarm(b, line.control, FEED_ALARM, &format!("FEED {feed} ABOVE LIMIT {limit}"));
    if writing::has_alarms(line.control) {
        b.words(codes(line, [Code::SubEnd]));
    }
}

/// O9100, ready-made: guards, copies of the watched entries, and the paper's equations; first those that the override does not change.
fn compute(b: &mut Builder, line: &RibbonLine) {
    b.program(COMPUTE, "RIBBON LINE - COMPUTE");
    writing::guards(b, &entries(line));
    // Entries are copied before use, so that an entry changed later differs from its copy and is computed again.
    for (at, (watched, copy)) in (20..).zip(WATCHED) {
        b.n(at).assign(copy, v(watched));
    }
    b.n(30).assign(STROKE, print_stroke(line)).note(&about(line, "PER PITCH"));
    b.n(31).assign(PULL, pull_words(line, v(PITCH) * v(BLOCK_PITCHES))).note(if line.pull_words() == 2 {
        "X PER BLOCK, DIAMETER"
    } else {
        "X PER BLOCK"
    });
    b.n(32).assign(BLOCK_STROKE, v(STROKE) * v(BLOCK_PITCHES)).note(&about(line, "PER BLOCK"));
    b.n(33).assign(RIBBON_PER_TURN, per_turn(line)).note("RIBBON PER REVOLUTION");
    b.n(34).assign(FEED_PER_TURN, vector_feed(v(RIBBON_PER_TURN))).note("FEED PER REVOLUTION");
    speed_and_feed(b, line, 40);
    b.n(46).if_goto(v(feed(line)).gt(v(FEED_LIMIT)), alarm_block(FEED_ALARM));
    b.n(47).words(codes(line, [Code::SubEnd]));
    writing::alarms(b, line.control, &entries(line));
    feed_alarm(b, line);
    // The header is after the program end: people read it, a running line never does.
    header(b, line);
}

/// All that depends on the override, in six blocks from number `n` on; [`FEED_PER_TURN`] and [`RIBBON_PER_TURN`] hold what does not.
fn speed_and_feed(b: &mut Builder, line: &RibbonLine, n: u32) {
    b.n(n).assign(KNOB, v(line.input())).note("OVERRIDE");
    b.n(n + 1).assign(ACTUAL_SPEED, actual_speed(line, KNOB)).note("ACTUAL SPEED R/MIN");
    b.n(n + 2).if_goto(v(ACTUAL_SPEED).le(v(SPEED_CLAMP)), n + 4);
    b.n(n + 3).assign(ACTUAL_SPEED, v(SPEED_CLAMP)).note("CLAMP AS THE CONTROL DOES");
    b.n(n + 4).assign(LINE_SPEED, v(RIBBON_PER_TURN) * v(ACTUAL_SPEED)).note("LINE SPEED MM/MIN");
    b.n(n + 5).assign(VECTOR_FEED, v(FEED_PER_TURN) * v(ACTUAL_SPEED)).note("VECTOR FEED");
}

/// Variable of the F that moves the axes.
fn feed(line: &RibbonLine) -> u32 {
    if line.in_step() { FEED_PER_TURN } else { VECTOR_FEED }
}

/// O9101, ready-made.
fn run(b: &mut Builder, line: &RibbonLine) {
    b.program(RUN, "RIBBON LINE - RUN");
    header(b, line);
    override_off(b, line, 1);
    if !line.in_step() {
        writing::count_seconds(b, line.control);
    }
    if !is_length(line) {
        b.n(2).assign(LEFT, v(COUNT)).note("PITCHES LEFT");
    }
    phase::check(b, line, 3);
    b.n(4).assign(BLOCK_PITCHES, v(BLOCK_SIZE)).note("PITCHES OF A BLOCK");
    b.n(5).call(COMPUTE, None);
    // A start under override 0 has its wait for the unwinder when the override rises (N20 in the running line).
    b.while_do(stands(), 1);
    wait_for_knob(b, line);
    b.call(COMPUTE, None);
    b.end_do(1);
    if is_length(line) {
        pitches_left(b, line, v(LENGTH));
        b.if_goto(v(LEFT).lt(1), alarm_block(SHORT_ALARM));
    }
    let next = if presets(line) { 6 } else { 7 };
    to_head(b, line, next);
    preset(b, line, 6);
    let speed = spindle_word(line);
    b.n(7).assign(RUNNING_SPEED, v(speed)).note("SPEED THAT RUNS");
    start_spindle(b, line, 8, 9);
    b.n(10).words(modes(line));
    b.n(11).while_do(v(LEFT).gt(0), 1);
    b.n(12).assign(BLOCK_PITCHES, v(BLOCK_SIZE));
    b.n(13).if_goto(v(LEFT).ge(v(BLOCK_PITCHES)), 15);
    b.n(14).assign(BLOCK_PITCHES, v(LEFT)).note("LAST BLOCK IS SHORTER");
    if is_length(line) {
        // Computed with the old pitch, of which O9100 has a copy, so that the length stays when the pitch changes.
        b.n(15).assign(LENGTH_LEFT, v(LEFT) * v(PITCH_COPY) + v(LAST)).note("LENGTH LEFT");
        b.call(COMPUTE, None);
        pitches_left(b, line, v(LENGTH_LEFT));
    } else {
        b.n(15).call(COMPUTE, None);
    }
    b.n(16).if_goto(v(speed).eq(v(RUNNING_SPEED)), 19);
    b.n(17).assign(RUNNING_SPEED, v(speed));
    b.n(18).words([s(v(speed))]);
    b.n(19).if_goto(moves(), 30).note("F BELOW IS F0");
    wait_for_override(b, line);
    b.n(30).while_do(v(LEFT).ge(v(BLOCK_PITCHES)), 2);
    // One block watches the knob and three entries, another one the other entries, so that a pass has seven macro blocks. Each block fits a
    // screen, this one without its number.
    let (first, second) = WATCHED.split_at(3);
    let with_knob: Vec<_> = core::iter::once((line.input(), KNOB)).chain(first.iter().copied()).collect();
    if line.p.knob_is_locked() {
        // S changes with the typed override.
        b.if_goto(changed(&with_knob).gt(0), 15);
    } else {
        b.if_goto(changed(&with_knob).le(0), 41);
        b.n(32).if_goto(changed(first).gt(0), 15);
        speed_and_feed(b, line, 33);
        if !line.in_step() {
            b.n(39).if_goto(v(VECTOR_FEED).gt(v(FEED_LIMIT)), 15).note("TOO FAST: ALARM");
        }
        b.n(40).if_goto(stands(), 15).note("OVERRIDE 0");
    }
    b.n(41).if_goto(changed(second).gt(0), 15);
    b.n(42)
        .assign(PRINT_TRAVEL, ((v(REMAINDER) + v(BLOCK_STROKE)) * 1000).round() / 1000)
        .note(&about(line, "OF THIS BLOCK"));
    b.n(43).assign(REMAINDER, v(REMAINDER) + v(BLOCK_STROKE) - v(PRINT_TRAVEL)).note(&about(line, "LEFT OVER"));
    b.n(44).words(move_block(line, v(PULL)));
    b.n(45).assign(LEFT, v(LEFT) - v(BLOCK_PITCHES));
    b.n(46).end_do(2);
    b.n(47).end_do(1);
    last_pitch(b, line);
    end(b, line);
    length_alarms(b, line);
}

/// N20 to N29: at override 0 the line waits, and then for the unwinder as at a start: X would else pull before ribbon is given.
fn wait_for_override(b: &mut Builder, line: &RibbonLine) {
    wait_for_knob(b.n(20), line);
    speed_and_feed(b, line, 21);
    b.n(27).if_goto(stands(), 20);
    start_spindle(b, line, 28, 29);
    b.goto(15);
}

/// Writes the pitches left of a length by the rule for its remainder, and the length of a shorter last pitch.
fn pitches_left(b: &mut Builder, line: &RibbonLine, length: Formula) {
    let pitches = || length.clone() / v(PITCH);
    let whole = match line.p.rest {
        Rest::Shorten => (pitches() + real(WHOLE, 4)).fix(),
        Rest::Round | Rest::Alarm => pitches().round(),
    };
    b.assign(LEFT, whole).note("PITCHES LEFT");
    match line.p.rest {
        Rest::Shorten => b.assign(LAST, length.clone() - v(LEFT) * v(PITCH)).note("LAST PITCH"),
        Rest::Round | Rest::Alarm => b.assign(LAST, 0).note("NO SHORTER PITCH"),
    };
    if line.p.rest == Rest::Alarm {
        b.if_goto((length - v(LEFT) * v(PITCH)).abs().gt(real(0.001, 3)), alarm_block(WHOLE_ALARM));
    }
}

/// The block of the shorter last pitch: both axes in the same ratio as before.
fn last_pitch(b: &mut Builder, line: &RibbonLine) {
    if !is_length(line) || line.p.rest != Rest::Shorten {
        return;
    }
    b.if_goto(v(LAST).le(real(SHORTEST, 4)), 50);
    b.assign(PRINT_TRAVEL, ((v(REMAINDER) + v(STROKE) * v(LAST) / v(PITCH)) * 1000).round() / 1000)
        .note(&about(line, "OF THE LAST PITCH"));
    b.words(move_block(line, pull_words(line, v(LAST))));
}

/// Writes the alarms about the length after the end of the program.
fn length_alarms(b: &mut Builder, line: &RibbonLine) {
    if !is_length(line) {
        return;
    }
    let length = line.control.variable(LENGTH);
    writing::alarm(b, line.control, SHORT_ALARM, &format!("LENGTH {length} IS BELOW A PITCH"));
    if line.p.rest == Rest::Alarm {
        writing::alarm(b, line.control, WHOLE_ALARM, &format!("{length} IS NO WHOLE PITCHES"));
    }
    if writing::has_alarms(line.control) {
        b.words([m(30)]);
    }
}

/// 0 while no watched entry differs from its copy.
fn changed(watched: &[(u32, u32)]) -> Formula {
    let mut sum: Option<Formula> = None;
    for (entry, copy) in watched {
        let difference = (v(*entry) - v(*copy)).abs();
        sum = Some(match sum {
            Some(sum) => sum + difference,
            None => difference,
        });
    }
    sum.unwrap_or(0.into())
}

/// Variable of S: the programmed speed, which the control multiplies by the knob; where the PLC locks the knob, the speed that the typed
/// override leaves.
fn spindle_word(line: &RibbonLine) -> u32 {
    if line.p.knob_is_locked() { ACTUAL_SPEED } else { SPEED }
}

/// S and M3, and the wait until the unwinder runs.
fn start_spindle(b: &mut Builder, line: &RibbonLine, start: u32, wait: u32) {
    b.n(start).words([s(v(spindle_word(line))), m(3)]);
    match line.p.wait {
        Wait::Dwell if line.p.dwell > 0.0 => {
            let (seconds, note) = (real(line.p.dwell, 3), "SPINDLE GETS ITS SPEED");
            writing::wait(b.n(wait), line.control, feed_unit(line), seconds, note);
        }
        Wait::Dwell => {}
        Wait::Fin => {
            b.note("PLC ANSWERS AT SPEED");
        }
    }
}

/// Spindle off, absolute dimensions, program end, and the alarm of a broken-off product. `#3004` is cleared by the reset of M30: written
/// here it would act before the last moves are done.
fn end(b: &mut Builder, line: &RibbonLine) {
    if line.dialect.spindle().volts_stay {
        // Else a key would turn the unwinder at the speed of the program.
        b.n(50).words([m(5), s(0)]).note("NO VOLTAGE FOR THE KEYS");
    } else {
        b.n(50).words([m(5)]);
    }
    phase::end(b, line);
    let absolute = codes(line, [Code::Absolute]);
    if !absolute.is_empty() {
        b.n(51).words(absolute);
    }
    b.n(52).words([m(30)]);
    phase::alarm(b, line);
}

/// O9100 as published: its numbers N5, N10, N20, N30, N100 and N200 with the corrections between them.
fn published(b: &mut Builder, line: &RibbonLine) {
    b.program(COMPUTE, "RIBBON LINE - AS PUBLISHED");
    b.n(5).assign(ACTUAL_SPEED, actual_speed(line, line.input())).note("ACTUAL SPEED R/MIN");
    b.n(6).if_goto(v(ACTUAL_SPEED).le(v(SPEED_CLAMP)), 10);
    b.n(7).assign(ACTUAL_SPEED, v(SPEED_CLAMP)).note("CLAMP AS THE CONTROL DOES");
    b.n(10).assign(LINE_SPEED, per_turn(line) * v(ACTUAL_SPEED)).note("LINE SPEED MM/MIN");
    b.n(20).assign(STROKE, print_stroke(line)).note(&about(line, "PER PITCH"));
    b.n(30).assign(VECTOR_FEED, vector_feed(v(LINE_SPEED))).note("VECTOR FEED");
    b.n(31)
        .assign(PRINT_TRAVEL, ((v(REMAINDER) + v(STROKE)) * 1000).round() / 1000)
        .note(&about(line, "OF THIS PITCH"));
    b.n(40).if_goto(stands(), 210).note("F BELOW IS F0");
    if line.in_step() {
        b.assign(FEED_PER_TURN, vector_feed(per_turn(line))).note("FEED PER REVOLUTION");
    }
    b.n(41).if_goto(v(feed(line)).gt(v(FEED_LIMIT)), alarm_block(FEED_ALARM));
    let speed = spindle_word(line);
    b.n(90).if_goto(v(RUNNING_SPEED).eq(v(speed)), 200);
    start_spindle(b, line, 100, 110);
    b.n(120).assign(RUNNING_SPEED, v(speed)).note("SPEED THAT RUNS");
    let pull = pull_words(line, v(PITCH));
    b.n(200).words(modes(line).into_iter().chain(move_block(line, pull)));
    b.n(201).assign(REMAINDER, v(REMAINDER) + v(STROKE) - v(PRINT_TRAVEL)).note(&about(line, "LEFT OVER"));
    b.n(202).assign(LEFT, v(LEFT) - 1);
    b.n(203).words(codes(line, [Code::SubEnd]));
    wait_for_knob(b.n(210), line);
    b.n(211).assign(RUNNING_SPEED, 0).note("SPINDLE STANDS");
    b.n(212).words(codes(line, [Code::SubEnd]));
    feed_alarm(b, line);
    header(b, line);
}

/// The main program of a listing: the blocks before its passes, the passes (from a block on), the last pitch and the alarms.
fn run_listing(b: &mut Builder, line: &RibbonLine, passes_at: u32, passes: impl FnOnce(&mut Builder)) {
    b.program(RUN, "RIBBON LINE - RUN");
    header(b, line);
    writing::guards(b, &entries(line));
    phase::check(b, line, 19);
    override_off(b, line, 20);
    if !line.in_step() {
        writing::count_seconds(b, line.control);
    }
    b.n(21);
    product(b, line);
    b.n(22).assign(STROKE, print_stroke(line)).note(&about(line, "PER PITCH"));
    b.n(23).assign(RUNNING_SPEED, 0).note("SPINDLE DOES NOT RUN YET");
    to_head(b, line, if presets(line) { 24 } else { passes_at });
    preset(b, line, 24);
    passes(b);
    last_pitch(b, line);
    end(b, line);
    length_alarms(b, line);
    writing::alarms(b, line.control, &entries(line));
    b.words([m(30)]);
}

/// The main program of the published listing: one call of O9100 per pitch.
fn run_published(b: &mut Builder, line: &RibbonLine) {
    run_listing(b, line, 30, |b| {
        b.n(30).while_do(v(LEFT).gt(0), 1);
        b.n(31).call(COMPUTE, None);
        b.n(32).end_do(1);
    });
}

/// Entries that the precomputed listing watches in the running line, each with the variable of its copy; the others act at the next start.
const WATCHED_ONCE: [(u32, u32); 3] = [(SPEED, SPEED_COPY), (PITCH, PITCH_COPY), (HEADS, HEADS_COPY)];

/// O9100 of the listing that calculates before the loop: the same numbers without the motion, and copies of the watched entries.
fn precompute(b: &mut Builder, line: &RibbonLine) {
    b.program(COMPUTE, "RIBBON LINE - AS PUBLISHED, ONCE");
    b.n(1).assign(KNOB, v(line.input())).note("OVERRIDE");
    for (at, (watched, copy)) in (2..).zip(WATCHED_ONCE) {
        b.n(at).assign(copy, v(watched));
    }
    b.n(5).assign(ACTUAL_SPEED, actual_speed(line, KNOB)).note("ACTUAL SPEED R/MIN");
    b.n(6).if_goto(v(ACTUAL_SPEED).le(v(SPEED_CLAMP)), 10);
    b.n(7).assign(ACTUAL_SPEED, v(SPEED_CLAMP)).note("CLAMP AS THE CONTROL DOES");
    b.n(10).assign(LINE_SPEED, per_turn(line) * v(ACTUAL_SPEED)).note("LINE SPEED MM/MIN");
    b.n(20).assign(STROKE, print_stroke(line)).note(&about(line, "PER PITCH"));
    b.n(30).assign(VECTOR_FEED, vector_feed(v(LINE_SPEED))).note("VECTOR FEED");
    b.n(31).assign(PULL, pull_words(line, v(PITCH))).note("PULL PER PITCH");
    if line.in_step() {
        b.n(32).assign(FEED_PER_TURN, vector_feed(per_turn(line))).note("FEED PER TURN");
    }
    b.n(41).if_goto(v(feed(line)).gt(v(FEED_LIMIT)), alarm_block(FEED_ALARM));
    b.n(42).words(codes(line, [Code::SubEnd]));
    feed_alarm(b, line);
    header(b, line);
}

/// The main program of the listing that calculates before the loop: a pass is a look at the knob and the block N200.
fn run_precomputed(b: &mut Builder, line: &RibbonLine) {
    run_listing(b, line, 25, |b| {
        b.n(25).words(modes(line));
        b.n(30).while_do(v(LEFT).gt(0), 1);
        b.n(31);
        if is_length(line) {
            // Computed with the old pitch, of which O9100 has a copy, so that the length stays when the pitch changes.
            b.assign(LENGTH_LEFT, v(LEFT) * v(PITCH_COPY) + v(LAST)).note("LENGTH LEFT");
            b.call(COMPUTE, None);
            pitches_left(b, line, v(LENGTH_LEFT));
        } else {
            b.call(COMPUTE, None);
        }
        b.n(32).if_goto(moves(), 35).note("F BELOW IS F0");
        wait_for_knob(b.n(33), line);
        b.n(34).assign(RUNNING_SPEED, 0).note("SPINDLE STANDS");
        b.goto(31);
        let speed = spindle_word(line);
        b.n(35).if_goto(v(RUNNING_SPEED).eq(v(speed)), 190);
        start_spindle(b, line, 100, 110);
        b.n(120).assign(RUNNING_SPEED, v(speed)).note("SPEED THAT RUNS");
        b.n(190).while_do(v(LEFT).gt(0), 2);
        let watched: Vec<_> = core::iter::once((line.input(), KNOB)).chain(WATCHED_ONCE).collect();
        // Without its number the block fits on a screen.
        b.if_goto(changed(&watched).gt(0), 31);
        b.n(192)
            .assign(PRINT_TRAVEL, ((v(REMAINDER) + v(STROKE)) * 1000).round() / 1000)
            .note(&about(line, "OF THIS PITCH"));
        b.n(193).assign(REMAINDER, v(REMAINDER) + v(STROKE) - v(PRINT_TRAVEL)).note(&about(line, "LEFT OVER"));
        b.n(200).words(move_block(line, v(PULL)));
        b.n(201).assign(LEFT, v(LEFT) - 1);
        b.n(202).end_do(2);
        b.n(203).end_do(1);
    });
}

/// Pitches of the product, from its count or its length, and the alarm of a length below a pitch.
fn product(b: &mut Builder, line: &RibbonLine) {
    if is_length(line) {
        pitches_left(b, line, v(LENGTH));
        b.if_goto(v(LEFT).lt(1), alarm_block(SHORT_ALARM));
        if line.p.variant == Variant::Precomputed {
            b.assign(PITCH_COPY, v(PITCH));
        }
    } else {
        b.assign(LEFT, v(COUNT)).note("PITCHES LEFT");
    }
}

/// O9102: the values of the project, once.
fn setup(b: &mut Builder, line: &RibbonLine) {
    b.program(SETUP, "RIBBON LINE - SET VALUES ONCE");
    header(b, line);
    let p = &line.p;
    let values = [
        (SPEED, p.spindle_speed, 0, "SPINDLE SPEED S"),
        (REDUCTION, p.reduction_ratio, 6, "REDUCTION RATIO"),
        (PRESS_ROLLER, p.press_roller_diameter, 4, "PRESS ROLLER DIAMETER"),
        (PITCH, p.pitch, 3, "PITCH"),
        (HEADS, p.heads, 0, "PRINT HEADS"),
        (PRINT_ROLLER, p.print_roller_diameter, 4, "PRINT ROLLER DIAMETER"),
        (SPEED_CLAMP, p.top_speed(), 3, "SPEED CLAMP"),
        (FEED_LIMIT, line.feed_max(), 3, "FEED LIMIT"),
        if is_length(line) {
            (LENGTH, p.product_length, 3, "LENGTH OF A PRODUCT")
        } else {
            (COUNT, p.count(), 0, "PITCHES OF A PRODUCT")
        },
        (BLOCK_SIZE, p.block_pitches(), 0, "PITCHES PER BLOCK"),
    ];
    for (at, (number, value, decimals, text)) in (1..).zip(values) {
        b.n(at).assign(number, real(value, decimals)).note(text);
    }
    if line.handed().is_none() {
        b.n(11).assign(line.input(), real(p.override_stepped(), 0)).note("OVERRIDE PERCENT");
    }
    b.n(20).words([m(30)]);
}

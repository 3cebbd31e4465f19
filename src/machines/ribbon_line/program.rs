//! The program of the ribbon line: O9100 computes, O9101 runs, O9102 sets the project's values once.
//!
//! O9100 and O9101 never write the operator's variables (those of O9102), so that products are changed by variables alone.

use super::params::{FIELDS, OverrideForm, Params, PathMode, Variant, Wait, YUnit};
use crate::machines::settings;
use crate::nc::Deck;
use crate::nc::build::{Builder, Formula, f, g, m, p as program, real, s, v, x, y};

/// Number of the program that computes.
pub(super) const COMPUTE: u32 = 9100;
/// Number of the program that runs the machine.
pub(super) const RUN: u32 = 9101;
/// Number of the program that sets the project's values.
pub(super) const SETUP: u32 = 9102;

/// The PLC's word: spindle override in percent, or final spindle speed.
pub(super) const INPUT: u32 = 1033;

/// The operator's variables: number and whether only whole numbers make sense.
const ENTRIES: [(u32, bool); 10] = [
    (100, true),
    (101, false),
    (102, false),
    (107, false),
    (109, true),
    (111, false),
    (116, false),
    (119, false),
    (120, true),
    (121, true),
];

/// Variables that the operator reads and sets: number, meaning, unit.
pub(super) const VARIABLES: &[(u32, &str, &str)] = &[
    (100, "ribbon.spindle-speed", "r/min"),
    (101, "ribbon.reduction-ratio", ": 1"),
    (102, "ribbon.press-roller-diameter", "mm"),
    (107, "ribbon.pitch", "mm"),
    (109, "ribbon.heads", ""),
    (111, "ribbon.print-roller-diameter", "mm"),
    (116, "ribbon.speed-clamp", "r/min"),
    (119, "ribbon.feed-limit", "mm/min"),
    (120, "ribbon.pitch-count", ""),
    (121, "ribbon.pitches-per-block", ""),
    (INPUT, "ribbon.variable.input", ""),
    (104, "ribbon.readout.actual-speed", "r/min"),
    (105, "ribbon.readout.line-speed", "mm/min"),
    (110, "ribbon.readout.y-stroke", ""),
    (115, "ribbon.readout.vector-feed", "mm/min"),
    (122, "ribbon.variable.remainder", ""),
    (125, "ribbon.variable.left", ""),
    (128, "ribbon.variable.block", ""),
];

/// Entries that change the motion of a running line, with the variables that remember them; `#130` to `#136`.
const WATCHED: [(u32, u32); 7] = [(INPUT, 130), (100, 131), (101, 132), (102, 133), (107, 134), (109, 135), (111, 136)];

/// Blocks of one pass of the running loop as the control reads them: with words, and over when they are read (macro blocks, calls,
/// returns). Held by a test against a run of the text.
pub(super) fn blocks_of_a_pass(p: &Params) -> (u32, u32) {
    match p.variant {
        Variant::ReadyMade => (1, 7),
        Variant::Published => (1, 15),
    }
}

/// The programs, one per file.
pub(super) fn deck(p: &Params) -> Deck {
    let mut b = Builder::new();
    match p.variant {
        Variant::ReadyMade => {
            compute(&mut b, p);
            run(&mut b, p);
        }
        Variant::Published => {
            published(&mut b, p);
            run_published(&mut b, p);
        }
    }
    setup(&mut b, p);
    b.finish()
}

/// What wrote the program, and the settings it was written from.
fn header(b: &mut Builder, p: &Params) {
    b.comment(concat!("WRITTEN BY MACROLINE ", env!("CARGO_PKG_VERSION")));
    for line in settings::write(super::ID, FIELDS, p) {
        b.comment(&line);
    }
}

/// π as it is written: 3.141592654, or 3.14.
///
/// The vector feed takes π almost squared: with eight decimals it would come out 2.3e-9 low, with nine it is right to 3e-10.
fn pi(p: &Params) -> Formula {
    real(p.program_pi(), 9)
}

/// Actual spindle speed, equation (1). `input` holds the PLC's word.
fn actual_speed(p: &Params, input: u32) -> Formula {
    match p.override_form {
        OverrideForm::Percent => v(100) * v(input) / 100,
        OverrideForm::FinalSpeed => v(input),
    }
}

/// Y per pitch: one head further.
fn y_stroke(p: &Params) -> Formula {
    match p.y_unit {
        YUnit::Millimetres => pi(p) * v(111) / v(109),
        YUnit::Degrees => real(360.0, 0) / v(109),
    }
}

/// Vector feed, equation (4): the block N30 that the paper leaves out.
fn vector_feed() -> Formula {
    v(105) * (v(107) * v(107) + v(110) * v(110)).sqrt() / v(107)
}

/// Every entry above zero, whole where it counts; else on to [`alarms`].
fn guards(b: &mut Builder) {
    for (at, (entry, _)) in (1..).zip(ENTRIES) {
        b.n(at).if_goto(v(entry).le(0), 900 + at);
    }
    for (at, (entry, _)) in (11..).zip(ENTRIES.iter().filter(|(_, whole)| *whole)) {
        b.n(at).if_goto((v(*entry) - v(*entry).round()).abs().gt(real(0.0001, 4)), 900 + at);
    }
}

/// What the operator reads where an entry cannot be.
fn alarms(b: &mut Builder) {
    for (at, (entry, _)) in (1..).zip(ENTRIES) {
        b.n(900 + at).alarm(at, &format!("#{entry} MUST BE ABOVE ZERO"));
    }
    for (at, (entry, _)) in (11..).zip(ENTRIES.iter().filter(|(_, whole)| *whole)) {
        b.n(900 + at).alarm(at, &format!("#{entry} MUST BE A WHOLE NUMBER"));
    }
}

/// The vector feed is more than the control takes.
fn feed_alarm(b: &mut Builder) {
    b.n(920).alarm(20, "FEED #115 ABOVE LIMIT #119");
    b.words([m(99)]);
}

/// O9100, ready-made: guards, copies of what the run watches, and the paper's equations.
fn compute(b: &mut Builder, p: &Params) {
    b.program(COMPUTE, "RIBBON LINE - COMPUTE");
    guards(b);
    // Copied before it is used: what changes from here on differs from its copy and is computed again.
    for (at, (watched, copy)) in (20..).zip(WATCHED) {
        b.n(at).assign(copy, v(watched));
    }
    b.n(30).assign(104, actual_speed(p, 130)).note("ACTUAL SPEED R/MIN");
    b.n(31).if_goto(v(104).le(v(116)), 33);
    b.n(32).assign(104, v(116)).note("CLAMP AS THE CONTROL DOES");
    b.n(33).assign(105, pi(p) * v(102) / v(101) * v(104)).note("LINE SPEED MM/MIN");
    b.n(34).assign(110, y_stroke(p)).note("Y PER PITCH");
    b.n(35).assign(115, vector_feed()).note("VECTOR FEED");
    b.n(36).if_goto(v(115).gt(v(119)), 920);
    b.n(37).assign(129, v(107) * v(128)).note("X PER BLOCK");
    b.n(38).assign(123, v(110) * v(128)).note("Y PER BLOCK");
    b.n(39).words([m(99)]);
    alarms(b);
    feed_alarm(b);
    // Behind the end: read by people, never by a running line.
    header(b, p);
}

/// O9101, ready-made.
fn run(b: &mut Builder, p: &Params) {
    b.program(RUN, "RIBBON LINE - RUN");
    header(b, p);
    b.n(1).assign(3004, 2).note("FEED OVERRIDE OFF");
    b.n(2).assign(125, v(120)).note("PITCHES LEFT");
    b.n(3).assign(122, 0).note("REMAINDER OF Y");
    b.n(4).assign(128, v(121)).note("PITCHES OF A BLOCK");
    b.n(5).words([m(98), program(COMPUTE)]);
    b.n(6).words([g(92), x(real(0.0, 0)), y(real(0.0, 0))]);
    b.n(7).assign(127, v(100)).note("SPEED THAT RUNS");
    start_spindle(b, p, 8, 9);
    b.n(10).words([g(91), g(94), path_mode(p)]);
    b.n(11).while_do(v(125).gt(0), 1);
    b.n(12).assign(128, v(121));
    b.n(13).if_goto(v(125).ge(v(128)), 15);
    b.n(14).assign(128, v(125)).note("LAST BLOCK IS SHORTER");
    b.n(15).words([m(98), program(COMPUTE)]);
    b.n(16).if_goto(v(100).eq(v(127)), 19);
    b.n(17).assign(127, v(100));
    b.n(18).words([s(v(100))]);
    b.n(19).if_goto(v(115).ge(real(0.001, 3)), 30).note("F BELOW IS F0");
    b.n(20).words([g(4), x(real(0.1, 1))]).note("OVERRIDE 0: WAIT");
    b.n(21).goto(15);
    b.n(30).while_do(v(125).ge(v(128)), 2);
    let (first, second) = WATCHED.split_at(3);
    b.n(31).if_goto(changed(first).gt(0), 15);
    b.n(32).if_goto(changed(second).gt(0), 15);
    b.n(33).assign(124, ((v(122) + v(123)) * 1000).round() / 1000).note("Y OF THIS BLOCK");
    b.n(34).assign(122, v(122) + v(123) - v(124)).note("Y LEFT OVER");
    b.n(35).words([g(1), x(v(129)), y(v(124)), f(v(115))]);
    b.n(36).assign(125, v(125) - v(128));
    b.n(37).end_do(2);
    b.n(38).end_do(1);
    end(b);
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

/// S and M3, and the wait until the unwinder runs.
fn start_spindle(b: &mut Builder, p: &Params, start: u32, wait: u32) {
    b.n(start).words([s(v(100)), m(3)]);
    match p.wait {
        Wait::Dwell if p.dwell > 0.0 => {
            b.n(wait).words([g(4), x(real(p.dwell, 3))]).note("SPINDLE GETS ITS SPEED");
        }
        Wait::Dwell => {}
        Wait::Fin => {
            b.note("PLC ANSWERS AT SPEED");
        }
    }
}

fn path_mode(p: &Params) -> crate::nc::build::NewWord {
    g(match p.path_mode {
        PathMode::Continuous => 64,
        PathMode::ExactStop => 61,
    })
}

/// Spindle off, absolute dimensions, program end. `#3004` is cleared by the reset of M30: written here it would act before the last
/// moves are done.
fn end(b: &mut Builder) {
    b.n(50).words([m(5)]);
    b.n(51).words([g(90)]);
    b.n(52).words([m(30)]);
}

/// O9100 as published: its numbers N5, N10, N20, N30, N100 and N200 with the corrections between them.
fn published(b: &mut Builder, p: &Params) {
    b.program(COMPUTE, "RIBBON LINE - AS PUBLISHED");
    b.n(5).assign(104, actual_speed(p, INPUT)).note("ACTUAL SPEED R/MIN");
    b.n(6).if_goto(v(104).le(v(116)), 10);
    b.n(7).assign(104, v(116)).note("CLAMP AS THE CONTROL DOES");
    b.n(10).assign(105, pi(p) * v(102) / v(101) * v(104)).note("LINE SPEED MM/MIN");
    b.n(20).assign(110, y_stroke(p)).note("Y PER PITCH");
    b.n(30).assign(115, vector_feed()).note("VECTOR FEED");
    b.n(31).assign(124, ((v(122) + v(110)) * 1000).round() / 1000).note("Y OF THIS PITCH");
    b.n(40).if_goto(v(115).lt(real(0.001, 3)), 210).note("F BELOW IS F0");
    b.n(41).if_goto(v(115).gt(v(119)), 920);
    b.n(90).if_goto(v(127).eq(v(100)), 200);
    start_spindle(b, p, 100, 110);
    b.n(120).assign(127, v(100)).note("SPEED THAT RUNS");
    b.n(200).words([g(91), g(94), path_mode(p), g(1), x(v(107)), y(v(124)), f(v(115))]);
    b.n(201).assign(122, v(122) + v(110) - v(124)).note("Y LEFT OVER");
    b.n(202).assign(125, v(125) - 1);
    b.n(203).words([m(99)]);
    b.n(210).words([g(4), x(real(0.1, 1))]).note("OVERRIDE 0: WAIT");
    b.n(211).words([m(99)]);
    feed_alarm(b);
    header(b, p);
}

/// The main program of the published listing: one call of O9100 per pitch.
fn run_published(b: &mut Builder, p: &Params) {
    b.program(RUN, "RIBBON LINE - RUN");
    header(b, p);
    guards(b);
    b.n(20).assign(3004, 2).note("FEED OVERRIDE OFF");
    b.n(21).assign(125, v(120)).note("PITCHES LEFT");
    b.n(22).assign(122, 0).note("REMAINDER OF Y");
    b.n(23).assign(127, 0).note("SPINDLE DOES NOT RUN YET");
    b.n(24).words([g(92), x(real(0.0, 0)), y(real(0.0, 0))]);
    b.n(30).while_do(v(125).gt(0), 1);
    b.n(31).words([m(98), program(COMPUTE)]);
    b.n(32).end_do(1);
    end(b);
    alarms(b);
    b.words([m(30)]);
}

/// O9102: the values of the project, once.
fn setup(b: &mut Builder, p: &Params) {
    b.program(SETUP, "RIBBON LINE - SET VALUES ONCE");
    header(b, p);
    let values = [
        (100, p.spindle_speed, 0, "SPINDLE SPEED S"),
        (101, p.reduction_ratio, 6, "REDUCTION RATIO"),
        (102, p.press_roller_diameter, 4, "PRESS ROLLER DIAMETER"),
        (107, p.pitch, 3, "PITCH"),
        (109, p.heads, 0, "PRINT HEADS"),
        (111, p.print_roller_diameter, 4, "PRINT ROLLER DIAMETER"),
        (116, p.top_speed(), 3, "SPEED CLAMP"),
        (119, p.feed_limit, 3, "FEED LIMIT"),
        (120, p.count(), 0, "PITCHES OF A PRODUCT"),
        (121, p.block_pitches(), 0, "PITCHES PER BLOCK"),
    ];
    for (at, (number, value, decimals, text)) in (1..).zip(values) {
        b.n(at).assign(number, real(value, decimals)).note(text);
    }
    b.n(20).words([m(30)]);
}

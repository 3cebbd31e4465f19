//! The program of the cut-to-length feeder: O9301 feeds and waits for the knife, O9302 sets the values of the form once.

use macroline::controls::Code;
use macroline::machines::MachineVariable;
use macroline::machines::program::writing::{self, OperatorVariable};
use macroline::nc::Deck;
use macroline::nc::build::{Builder, f, g, m, real, v, z};

use super::params::Feed;
use super::resolved::CutToLength;

/// Number of the program that feeds.
pub(super) const RUN: u32 = 9301;
/// Number of the program that sets the values of the form.
pub(super) const SETUP: u32 = 9302;

/// Variables that the operator reads and sets.
pub(super) const VARIABLES: [MachineVariable; 5] = [
    MachineVariable::new(100, "toy.length", "mm"),
    MachineVariable::new(101, "toy.speed", "mm/min"),
    MachineVariable::new(102, "toy.pieces", ""),
    MachineVariable::new(103, "toy.variable.left", ""),
    MachineVariable::new(104, "toy.variable.position", "mm"),
];

/// Variables of the operator that the program checks.
const ENTRIES: [OperatorVariable; 3] =
    [OperatorVariable::any(100), OperatorVariable::any(101), OperatorVariable::whole(102)];

/// The programs, one per file.
pub(super) fn deck(feeder: &CutToLength) -> Deck {
    let mut b = Builder::new();
    run(&mut b, feeder);
    setup(&mut b, feeder);
    b.finish()
}

fn run(b: &mut Builder, feeder: &CutToLength) {
    let control = feeder.control;
    b.program(RUN, "CUT TO LENGTH - RUN");
    writing::write_header::<CutToLength>(b, &feeder.params, control);
    writing::guards(b, &ENTRIES);
    b.n(20).words(writing::codes(control, [Code::Absolute, Code::FeedPerMinute]));
    b.n(21).assign(103, v(102)).note("PIECES LEFT");
    b.n(22).assign(104, 0).note("POSITION");
    b.n(30).while_do(v(103).gt(0), 1);
    b.n(31).assign(104, v(104) + v(100));
    match feeder.params.feed {
        Feed::Cutting => b.n(32).words([g(1), z(v(104)), f(v(101))]),
        Feed::Rapid => b.n(32).words([g(0), z(v(104))]),
    };
    b.n(33).words(writing::dwell(control, feeder.params.cut_time)).note("KNIFE");
    b.n(34).assign(103, v(103) - 1);
    b.n(35).end_do(1);
    b.n(40).words([m(30)]);
    writing::alarms(b, control, &ENTRIES);
    if writing::has_alarms(control) {
        b.words([m(30)]);
    }
}

fn setup(b: &mut Builder, feeder: &CutToLength) {
    let p = &feeder.params;
    b.program(SETUP, "CUT TO LENGTH - SET VALUES ONCE");
    writing::write_header::<CutToLength>(b, p, feeder.control);
    b.n(1).assign(100, real(p.length, 3)).note("LENGTH");
    b.n(2).assign(101, real(p.speed, 0)).note("SPEED");
    b.n(3).assign(102, real(p.pieces, 0)).note("PIECES");
    b.n(20).words([m(30)]);
}

//! The program of the turning spindle: O9201 cuts pass by pass, O9202 sets the project's values once.
//!
//! It uses the words and codes of the control: diameters or radii, surface speed or a fixed one, gear stages or none. O9201 never
//! writes the operator's variables, so that parts are changed by variables alone.

use super::params::{Direction, Path};
use super::resolved::{ALONG, CROSS, TurningSpindle};
use crate::controls::spindle::LimitPlace;
use crate::controls::{Address, Code};
use crate::machines::writing::{self, Entry};
use crate::nc::Deck;
use crate::nc::build::{Builder, Formula, NewWord, f, m, real, s, v, word, x, z};

/// Number of the program that cuts.
pub(super) const RUN: u32 = 9201;
/// Number of the program that sets the project's values.
pub(super) const SETUP: u32 = 9202;

/// Stock that remains after the pass: in diameter, on a face along Z.
const LEFT: u32 = 110;
/// Sequence numbers of the blocks that cut; the second on a taper.
pub(super) const CUTS: [u32; 2] = [36, 37];
/// Speed for the largest diameter: kept through the cut, or set after it.
const SPEED: u32 = 109;

/// The operator's variables, all above zero.
fn entries(lathe: &TurningSpindle) -> Vec<Entry> {
    let end = (lathe.p.path == Path::Taper).then_some(104);
    let all = [100, 101, 102].into_iter().chain(end).chain([way(lathe), 106, 107, 108, 111, 112]);
    all.map(|number| (number, false)).collect()
}

/// Variable of the length, or of the allowance of a face.
fn way(lathe: &TurningSpindle) -> u32 {
    if lathe.p.path == Path::Facing { 114 } else { 105 }
}

/// Variables that the operator reads and sets: number, meaning, unit.
pub(super) fn variables(lathe: &TurningSpindle) -> Vec<(u32, &'static str, &'static str)> {
    let face = lathe.p.path == Path::Facing;
    let mut all = vec![
        (100, "turning.cutting-speed", "m/min"),
        (101, "turning.feed", "mm/rev"),
        (102, "turning.stock-diameter", "mm"),
        (103, "turning.finished-diameter", "mm"),
    ];
    if lathe.p.path == Path::Taper {
        all.push((104, "turning.large-diameter", "mm"));
    }
    all.extend([
        (way(lathe), if face { "turning.allowance" } else { "turning.length" }, "mm"),
        (106, "turning.depth", "mm"),
        (107, "turning.upper-limit", "r/min"),
        (108, "turning.clearance", "mm"),
        (111, "turning.start-x", "mm"),
        (112, "turning.start-z", "mm"),
        (LEFT, "turning.variable.left", "mm"),
    ]);
    if lathe.positions() {
        all.push((113, "turning.keyway-angle", "°"));
    }
    all.push((SPEED, "turning.variable.speed", "r/min"));
    all
}

/// The programs, one per file.
pub(super) fn deck(lathe: &TurningSpindle) -> Deck {
    let mut b = Builder::new();
    run(&mut b, lathe);
    setup(&mut b, lathe);
    b.finish()
}

/// A diameter as words of X count it.
fn size(lathe: &TurningSpindle, diameter: Formula) -> Formula {
    if lathe.diameters() { diameter } else { diameter / 2 }
}

/// A word of X for a diameter.
fn cross(lathe: &TurningSpindle, diameter: Formula) -> NewWord {
    x(size(lathe, diameter))
}

fn codes(lathe: &TurningSpindle, wanted: impl IntoIterator<Item = Code>) -> Vec<NewWord> {
    writing::codes(lathe.control, wanted)
}

/// A block: codes, then words.
fn block(lathe: &TurningSpindle, code: Code, words: impl IntoIterator<Item = NewWord>) -> Vec<NewWord> {
    codes(lathe, [code]).into_iter().chain(words).collect()
}

/// Diameter at which the tool is clear of the stock.
fn clear() -> Formula {
    v(102) + v(108) * 2
}

/// O9201.
fn run(b: &mut Builder, lathe: &TurningSpindle) {
    b.program(RUN, "TURNING - RUN");
    writing::write_header::<TurningSpindle>(b, &lathe.form, lathe.control);
    writing::guards(b, &entries(lathe));
    b.n(16).words(writing::opening(lathe.control)).note("WORK ZERO: TURNING CENTRE, FACE");
    if let Some(place) = place(lathe) {
        writing::stays_clear(b.n(17), place, || size(lathe, clear()), 900 + away_alarm(lathe));
    }
    b.n(18).words(writing::tool(lathe.control, lathe.p.tool as u32)).note("TOOL AND ITS OFFSET");
    if let Some(place) = place(lathe) {
        // The offset shifts the coordinates.
        writing::stays_clear(b, place, || size(lathe, clear()), 900 + away_alarm(lathe));
    }
    if lathe.surface() && lathe.control.can(Code::SetCoordinates) {
        b.n(20).words(block(lathe, Code::SetCoordinates, limit(lathe)));
    }
    b.n(21).words(codes(lathe, [Code::Absolute, Code::FeedPerRevolution, Code::Cutting]));
    if let Some(gear) = gear(lathe) {
        b.n(22).words(gear);
    }
    // Away from the work first: a start after a reset may begin anywhere.
    b.n(23).words(block(lathe, Code::Rapid, [cross(lathe, clear())]));
    b.words([z(v(108))]);
    start(b, lathe);
    let face = lathe.p.path == Path::Facing;
    let (whole, step) = match lathe.p.path {
        Path::Facing => (v(way(lathe)), v(106)),
        Path::Turning => (v(102) - v(103), v(106) * 2),
        Path::Taper => (v(102) - v(small(lathe)), v(106) * 2),
    };
    b.n(30).assign(LEFT, whole).note(if face { "LEFT TO CUT, Z" } else { "LEFT TO CUT, DIAMETER" });
    b.n(31).while_do(v(LEFT).gt(0), 1);
    b.n(32).assign(LEFT, v(LEFT) - step);
    b.n(33).if_goto(v(LEFT).ge(0), 35);
    b.n(34).assign(LEFT, 0).note("LAST PASS TAKES LESS");
    pass(b, lathe);
    b.n(44).end_do(1);
    b.n(50).words(block(lathe, Code::Rapid, [cross(lathe, v(111)), z(v(112))]));
    b.n(51).words([m(5)]);
    if lathe.surface() {
        b.n(52).words(block(lathe, Code::SurfaceSpeedOff, [s(v(SPEED))]));
    }
    if lathe.positions() {
        b.n(53).words([word(Address::Spos, v(113))]).note("FOR THE KEYWAY");
        let lock = lathe.p.lock_code as u32;
        if lock > 0 {
            b.words([m(lock)]).note("LOCKS THE SPINDLE");
        }
        b.n(54).words([m(0)]);
    }
    b.n(55).words([m(30)]);
    writing::alarms(b, lathe.control, &entries(lathe));
    if place(lathe).is_some() {
        writing::alarm(b, lathe.control, away_alarm(lathe), "RETRACT THE TOOL BY HAND");
    }
    if writing::has_alarms(lathe.control) {
        b.words([m(30)]);
    }
}

/// Variables of the tool's position in X and Z, where the program can read it and raise an alarm of its own.
fn place(lathe: &TurningSpindle) -> Option<(u32, u32)> {
    writing::places(lathe.control, [CROSS, ALONG])
}

/// Number of the alarm of a tool that is not clear of the work, behind those of the entries.
fn away_alarm(lathe: &TurningSpindle) -> u32 {
    entries(lathe).len() as u32 + 1
}

/// Words of the speed limit S. Where S alone would make the present position work zero, the position that holds already stands beside it.
fn limit(lathe: &TurningSpindle) -> Vec<NewWord> {
    let at = place(lathe).filter(|_| lathe.rules().limit_place == LimitPlace::WorkZero);
    let held = at.into_iter().flat_map(|(across, along)| [x(v(across)), z(v(along))]);
    held.chain([s(v(107))]).collect()
}

/// Variable of the smaller end of the taper.
fn small(lathe: &TurningSpindle) -> u32 {
    if lathe.p.large_diameter < lathe.p.finished_diameter { 104 } else { 103 }
}

/// The code of the gear stage, where there are several.
fn gear(lathe: &TurningSpindle) -> Option<Vec<NewWord>> {
    let stage = lathe.stage();
    let words = codes(lathe, [Code::GearStage(stage)]);
    (lathe.p.stages().nth(1).is_some() && !words.is_empty()).then_some(words)
}

/// The spindle: surface speed, or the speed of the largest diameter.
fn start(b: &mut Builder, lathe: &TurningSpindle) {
    let turn = m(if lathe.p.direction == Direction::Clockwise { 3 } else { 4 });
    // n = 1000 v / (π d) at the stock's diameter, as whole as S is.
    b.n(24).assign(SPEED, (v(100) * 1000 / (real(crate::math::PI, 6) * v(102))).fix());
    b.n(25).if_goto(v(SPEED).le(v(107)), 27);
    b.n(26).assign(SPEED, v(107).fix()).note("AT MOST THE LIMIT");
    let mut words = match lathe.surface() {
        true => block(lathe, Code::SurfaceSpeed, [s(v(100))]),
        false => block(lathe, Code::SurfaceSpeedOff, [s(v(SPEED))]),
    };
    // The speed limit as a word of its own, where no block before sets it.
    words.extend(lathe.limit_word().filter(|_| lathe.surface()).map(|address| word(address, v(107))));
    words.push(turn);
    b.n(27).words(words);
}

/// The blocks of a pass.
fn pass(b: &mut Builder, lathe: &TurningSpindle) {
    let rapid = |words: Vec<NewWord>| block(lathe, Code::Rapid, words);
    let cut = |words: Vec<NewWord>| block(lathe, Code::Linear, words);
    let away = || v(103) + v(LEFT) + v(106);
    match lathe.p.path {
        Path::Facing => {
            b.n(35).words(rapid(vec![z(v(LEFT))]));
            b.n(CUTS[0]).words(cut(vec![cross(lathe, v(103)), f(v(101))]));
            b.n(37).words(rapid(vec![z(v(LEFT) + v(106))]));
            b.n(38).words([cross(lathe, clear())]);
        }
        Path::Turning => {
            b.n(35).words(rapid(vec![cross(lathe, v(103) + v(LEFT))]));
            b.n(CUTS[0]).words(cut(vec![z(-v(105)), f(v(101))]));
            b.n(37).words(rapid(vec![cross(lathe, away())]));
            b.n(38).words([z(v(108))]);
        }
        Path::Taper => {
            b.n(35).words(rapid(vec![cross(lathe, v(103) + v(LEFT))]));
            b.n(CUTS[0]).words(cut(vec![z(real(0.0, 0)), f(v(101))]));
            b.n(CUTS[1]).words([cross(lathe, v(104) + v(LEFT)), z(-v(105))]);
            b.n(38).words(rapid(vec![cross(lathe, clear())]));
            b.n(39).words([z(v(108))]);
        }
    }
}

/// O9202: the values of the project, once.
fn setup(b: &mut Builder, lathe: &TurningSpindle) {
    b.program(SETUP, "TURNING - SET VALUES ONCE");
    writing::write_header::<TurningSpindle>(b, &lathe.form, lathe.control);
    let p = &lathe.p;
    let face = p.path == Path::Facing;
    let values = [
        (100, p.cutting_speed, 2, "CUTTING SPEED M/MIN"),
        (101, p.feed, 3, "FEED MM/REV"),
        (102, p.stock_diameter, 3, "STOCK DIAMETER"),
        (103, p.finished_diameter, 3, if p.path == Path::Taper { "DIAMETER AT THE FACE" } else { "FINISHED DIAMETER" }),
        (104, p.large_diameter, 3, "DIAMETER AT THE END"),
        (way(lathe), if face { p.allowance } else { p.length }, 3, if face { "ALLOWANCE" } else { "LENGTH" }),
        (106, p.depth, 3, "DEPTH OF CUT"),
        (107, p.upper_limit, 0, "SPEED LIMIT"),
        (108, p.clearance, 3, "CLEARANCE"),
        (111, p.start_x, 3, "START X, DIAMETER"),
        (112, p.start_z, 3, "START Z"),
        (113, p.keyway_angle, 3, "ANGLE OF THE KEYWAY"),
    ];
    for (at, (number, value, decimals, text)) in (1..).zip(values) {
        let needed = match number {
            104 => p.path == Path::Taper,
            113 => lathe.positions(),
            _ => true,
        };
        if needed {
            b.n(at).assign(number, real(value, decimals)).note(text);
        }
    }
    b.n(20).words([m(30)]);
}

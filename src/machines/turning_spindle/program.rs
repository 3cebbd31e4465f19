//! The program of the turning spindle: O9201 cuts pass by pass, O9202 sets the project's values once.
//!
//! Written with the words and codes of the control: diameters or radii, surface speed or a fixed one, gear stages or none. O9201 never
//! writes the operator's variables, so that parts are changed by variables alone. It copies them at its start and checks and cuts by the
//! copies: an entry that the operator changes while a part is cut passes the checks of the next start.

use super::derive::TRACE;
use super::params::{Path, SpindleDirection};
use super::resolved::{CodePair, TurningSpindle};
use super::variables::{
    ALLOWANCE, ANGLE, BEGIN_X, BEGIN_Z, BEGUN, CHUCK_LIMIT, CLEARANCE, CUTTING_SPEED, DEPTH, DRIVEN_SPEED, END_X, FEED,
    FINISHED, KEYWAY_DEPTH, KEYWAY_FEED, KEYWAY_INFEED, KEYWAY_LENGTH, KEYWAY_START, KEYWAY_WIDTH, LEFT, LENGTH,
    LOWEST_SPEED, REACH, ROOM, SLOPE, SPEED, SPEED_LIMIT, START_X, START_Z, STOCK, TAPER_END, copy,
};
use crate::controls::spindle::LimitPlace;
use crate::controls::{Address, Code};
use crate::machines::lathe::slides::{ALONG, CROSS};
use crate::machines::machine::MachineVariable;
use crate::machines::program::writing::{self, OperatorVariable, PositionVariables, TurretRoom, alarm_block};
use crate::nc::Deck;
use crate::nc::build::{Builder, Condition, Formula, NewWord, f, indexed, m, real, s, v, word, x, z};

/// Number of the program that cuts.
pub(super) const RUN: u32 = 9201;
/// Number of the program that sets the project's values.
pub(super) const SETUP: u32 = 9202;

/// Sequence number of the first block behind the guards.
const OPENING: u32 = 16;

/// Sequence number of the first block of a pass at feed: the cut, or on a taper the approach to the face.
pub(super) const PASS_BEGIN: u32 = 36;

/// Sequence number of the block that cuts.
pub(super) fn cut_block(path: Path) -> u32 {
    if path == Path::Taper { PASS_BEGIN + 1 } else { PASS_BEGIN }
}

/// The operator's variables, all above zero.
fn entries(lathe: &TurningSpindle) -> Vec<OperatorVariable> {
    let end = (lathe.params.path == Path::Taper).then_some(TAPER_END);
    let part = [CUTTING_SPEED, FEED, STOCK].into_iter().chain(end);
    let all = part.chain([way(lathe), DEPTH, SPEED_LIMIT, CLEARANCE, START_X, START_Z]);
    let highest = speed_limits(lathe)[0].map(|(_, number)| number);
    let keyway =
        lathe.keyway().map(|_| [KEYWAY_DEPTH, KEYWAY_LENGTH, KEYWAY_WIDTH, DRIVEN_SPEED, KEYWAY_FEED, KEYWAY_INFEED]);
    let keyway = keyway.into_iter().flatten();
    let all = all.chain(highest).chain(keyway).chain([ROOM]);
    all.map(|number| OperatorVariable::any(number).copied_to(copy(number))).collect()
}

/// An entry of the operator as the program copied it at its start.
fn entry(number: u32) -> Formula {
    v(copy(number))
}

/// Codes and variables of the spindle limits from the machine's data, where the control has codes for them. They stay in force beyond the
/// program's end, so that a lowest speed of 0 is written too: it replaces that of the part before.
fn speed_limits(lathe: &TurningSpindle) -> [Option<(Code, u32)>; 2] {
    let has = lathe.params.has_speed_limits(lathe.control);
    [(Code::UpperLimits, CHUCK_LIMIT), (Code::LowerLimits, LOWEST_SPEED)].map(|limit| has.then_some(limit))
}

/// Variable of the length of the cut; on a face, of the allowance.
fn way(lathe: &TurningSpindle) -> u32 {
    if lathe.params.path == Path::Facing { ALLOWANCE } else { LENGTH }
}

/// Variables that the operator reads and sets.
pub(super) fn variables(lathe: &TurningSpindle) -> Vec<MachineVariable> {
    let variable = MachineVariable::new;
    let face = lathe.params.path == Path::Facing;
    let mut all = vec![
        variable(CUTTING_SPEED, "turning.cutting-speed", "m/min"),
        variable(FEED, "turning.feed", "mm/rev"),
        variable(STOCK, "turning.stock-diameter", "mm"),
        variable(FINISHED, "turning.finished-diameter", "mm"),
    ];
    if lathe.params.path == Path::Taper {
        all.push(variable(TAPER_END, "turning.large-diameter", "mm"));
    }
    all.extend([
        variable(way(lathe), if face { "turning.allowance" } else { "turning.length" }, "mm"),
        variable(DEPTH, "turning.depth", "mm"),
        variable(SPEED_LIMIT, "turning.upper-limit", "r/min"),
        variable(CLEARANCE, "turning.clearance", "mm"),
        variable(START_X, "turning.start-x", "mm"),
        variable(START_Z, "turning.start-z", "mm"),
        variable(LEFT, "turning.variable.left", "mm"),
    ]);
    if lathe.positions() {
        all.push(variable(ANGLE, "turning.keyway-angle", "°"));
    }
    if lathe.keyway().is_some() {
        all.extend([
            variable(KEYWAY_DEPTH, "turning.keyway-depth", "mm"),
            variable(KEYWAY_LENGTH, "turning.keyway-length", "mm"),
            variable(KEYWAY_START, "turning.keyway-start", "mm"),
            variable(KEYWAY_WIDTH, "turning.keyway-width", "mm"),
            variable(DRIVEN_SPEED, "turning.driven-speed", "r/min"),
            variable(KEYWAY_FEED, "turning.keyway-feed", "mm/min"),
            variable(KEYWAY_INFEED, "turning.keyway-infeed", "mm/min"),
        ]);
    }
    let labels = ["turning.chuck-limit", "turning.lower-limit"];
    let limits = speed_limits(lathe).into_iter().zip(labels);
    all.extend(limits.filter_map(|(limit, label)| limit.map(|(_, number)| variable(number, label, "r/min"))));
    all.push(variable(REACH, "turning.variable.reach", "mm"));
    all.push(variable(ROOM, "lathe.turret-room", "mm"));
    all.push(variable(SPEED, "turning.variable.speed", "r/min"));
    all.push(variable(copy(CUTTING_SPEED), "turning.variable.copies", ""));
    if has_flag(lathe) {
        all.push(variable(BEGUN, "turning.variable.begun", ""));
    }
    all
}

/// The programs, one per file.
pub(super) fn deck(lathe: &TurningSpindle) -> Deck {
    let mut b = Builder::new();
    run(&mut b, lathe);
    setup(&mut b, lathe);
    b.finish()
}

/// A diameter in the unit of X words.
fn size(lathe: &TurningSpindle, diameter: Formula) -> Formula {
    if lathe.x_counts_diameters() { diameter } else { diameter / 2 }
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
    entry(STOCK) + entry(CLEARANCE) * 2
}

/// The smaller of two formulas: `(a + b - |a - b|) / 2`.
fn smaller(a: impl Fn() -> Formula, b: impl Fn() -> Formula) -> Formula {
    (a() + b() - (a() - b()).abs()) / 2
}

/// O9201.
fn run(b: &mut Builder, lathe: &TurningSpindle) {
    b.program(RUN, "TURNING - RUN");
    writing::write_header::<TurningSpindle>(b, &lathe.form, lathe.control);
    if lathe.params.tailstock {
        b.comment("THE TAILSTOCK HOLDS THE WORK");
    }
    b.comment("CHANGED VARIABLES ACT FROM THE NEXT START");
    guards(b, lathe);
    prepare(b, lathe);
    approach(b, lathe);
    // A reset at the angle leaves the spindle locked.
    release_spindle(b, lathe);
    start(b, lathe);
    if has_flag(lathe) {
        b.assign(BEGUN, 1).note("A PART IS BEGUN");
    }
    passes(b, lathe);
    retract(b, lathe);
    if lathe.positions() {
        stop_at_angle(b, lathe);
    }
    end(b, lathe);
    alarms(b, lathe);
}

/// Offsets, tool, speed limits, modal codes and gear: what the control has to know before the first way.
fn prepare(b: &mut Builder, lathe: &TurningSpindle) {
    b.n(OPENING).words(writing::opening(lathe.control)).note("WORK ZERO: TURNING CENTRE, FACE");
    call_tool(b, lathe);
    // Setting data of the control, in force beyond the program's end; each takes a block of its own.
    for (at, (code, number)) in (19..).zip(speed_limits(lathe).into_iter().flatten()) {
        b.n(at).words(block(lathe, code, [s(entry(number))]));
    }
    if lathe.surface() && lathe.control.can(Code::SetCoordinates) {
        b.n(20).words(block(lathe, Code::SetCoordinates, limit(lathe)));
    }
    b.n(21).words(codes(lathe, [Code::Absolute, Code::FeedPerRevolution, Code::Cutting]));
    if let Some(gear) = gear(lathe) {
        b.n(22).words(gear);
    }
}

/// The cut, pass by pass from what is left to cut.
fn passes(b: &mut Builder, lathe: &TurningSpindle) {
    let face = lathe.params.path == Path::Facing;
    let whole = if face { entry(way(lathe)) } else { entry(STOCK) - entry(FINISHED) };
    let step = || if face { entry(DEPTH) } else { entry(DEPTH) * 2 };
    let trace = || real(TRACE, 4);
    if lathe.params.path == Path::Taper {
        b.n(29).assign(SLOPE, 0);
        b.if_goto(entry(FINISHED).eq(entry(TAPER_END)), 30);
        b.assign(SLOPE, entry(LENGTH) / (entry(TAPER_END) - entry(FINISHED))).note("Z PER DIAMETER OF THE TAPER");
    }
    b.n(30).assign(LEFT, whole).note(if face { "LEFT TO CUT, Z" } else { "LEFT TO CUT, DIAMETER" });
    if lathe.params.path == Path::Taper {
        b.if_goto(entry(FINISHED).le(entry(TAPER_END)), 31);
        b.assign(LEFT, entry(STOCK) - entry(TAPER_END)).note("SMALL AT THE END");
    }
    // A tool that is set deeper than the stock would be retracted by as much.
    b.n(31).if_goto(step().le(v(LEFT)), 32);
    b.assign(copy(DEPTH), if face { v(LEFT) } else { v(LEFT) / 2 }).note("ONE PASS");
    b.n(32).while_do(v(LEFT).gt(trace()), 1);
    b.n(33).assign(LEFT, v(LEFT) - step());
    b.if_goto(v(LEFT).gt(trace()), 35);
    b.n(34).assign(LEFT, 0).note("LAST PASS TAKES LESS");
    pass(b, lathe);
    b.n(44).end_do(1);
}

/// The way back to the start, and the stop of the spindle.
fn retract(b: &mut Builder, lathe: &TurningSpindle) {
    if lathe.params.tailstock {
        b.n(50).words(block(lathe, Code::Rapid, [cross(lathe, entry(START_X))]));
        b.words([z(entry(START_Z))]);
    } else {
        b.n(50).words(block(lathe, Code::Rapid, [cross(lathe, entry(START_X)), z(entry(START_Z))]));
    }
    b.n(51).words([m(5)]);
    if lathe.surface() {
        b.n(52).words(block(lathe, Code::SurfaceSpeedOff, [s(v(SPEED))]));
    }
}

/// The stop at the angle of the keyway, with the keyway or with a stop of the program for the operator.
fn stop_at_angle(b: &mut Builder, lathe: &TurningSpindle) {
    b.n(53).words([word(Address::Spos, entry(ANGLE))]).note("FOR THE KEYWAY");
    if let Some(CodePair { on, .. }) = lathe.lock_codes() {
        b.words([m(on)]).note("LOCKS THE SPINDLE");
    }
    match lathe.keyway() {
        Some(_) => keyway(b, lathe),
        None => {
            b.n(54).words([m(0)]).note(no_keyway(lathe));
            release_spindle(b, lathe);
        }
    }
}

/// The end of a whole part.
fn end(b: &mut Builder, lathe: &TurningSpindle) {
    if has_flag(lathe) {
        // The spindle stops only after the tool is back.
        let waits = codes(lathe, [Code::StopReading]);
        if !waits.is_empty() {
            b.words(waits);
        }
        b.assign(BEGUN, 0).note("THE PART IS WHOLE");
    }
    b.n(if lathe.keyway().is_some() { 70 } else { 55 }).words([m(30)]);
}

/// The alarms of entries, of a tool that is not clear of the work, and of values that the operator must not set.
fn alarms(b: &mut Builder, lathe: &TurningSpindle) {
    writing::alarms(b, lathe.control, &entries(lathe));
    // Reset is required first: after an M0, cycle start would move jogged axes back into the work.
    let text = match begun(lathe) {
        Some(flag) => format!("RESET, RETRACT THE TOOL BY HAND, {flag}=0"),
        None => "RETRACT THE TOOL BY HAND".to_owned(),
    };
    writing::alarm(b, lathe.control, away_alarm(lathe), &text);
    let texts = refusals(lathe).into_iter().map(|(_, text)| text).chain(no_room(lathe));
    for (at, text) in (away_alarm(lathe) + 1..).zip(texts) {
        writing::alarm(b, lathe.control, at, &text);
    }
    if writing::has_alarms(lathe.control) {
        b.words([m(30)]);
    }
}

/// The way from the start to the work. A start after a reset may begin anywhere: away from the work first, or along it where in front of it is
/// the tailstock.
fn approach(b: &mut Builder, lathe: &TurningSpindle) {
    let (across, along) = (cross(lathe, clear()), z(entry(CLEARANCE)));
    let [first, then] = if lathe.params.tailstock { [along, across] } else { [across, along] };
    b.n(APPROACH).words(block(lathe, Code::Rapid, [first]));
    b.words([then]);
}

/// Copies the operator's variables, and jumps to the alarms of values that the operator must not set.
fn guards(b: &mut Builder, lathe: &TurningSpindle) {
    writing::guards(b, &entries(lathe));
    let angle = lathe.positions().then_some(ANGLE);
    let keyway = lathe.keyway().map(|_| KEYWAY_START);
    let lowest = speed_limits(lathe)[1].map(|(_, number)| number);
    for number in [FINISHED, REACH].into_iter().chain(angle).chain(keyway).chain(lowest) {
        b.assign(copy(number), v(number));
    }
    for (at, (condition, _)) in (away_alarm(lathe) + 1..).zip(refusals(lathe)) {
        b.if_goto(condition, alarm_block(at));
    }
    start_has_room(b, lathe);
}

/// Jumps to the last alarm, where the program cannot read the tool's position, if the turret has no room to turn at the start of the tool: there it
/// ended the part before.
fn start_has_room(b: &mut Builder, lathe: &TurningSpindle) {
    if !has_flag(lathe) {
        return;
    }
    let alarm = alarm_block(away_alarm(lathe) + 1 + refusals(lathe).len() as u32);
    if lathe.params.tailstock {
        // In front of the work is the tailstock.
        b.if_goto(entry(START_X).lt(beside()), alarm);
    } else {
        b.if_goto(entry(START_X).ge(beside()), OPENING);
        b.if_goto(entry(START_Z).lt(in_front(lathe)), alarm);
    }
}

/// Text of the alarm of a start without room for the turret.
fn no_room(lathe: &TurningSpindle) -> Option<String> {
    let [start_x, start_z, stock, room] = [START_X, START_Z, STOCK, ROOM].map(|at| lathe.control.variable(at));
    let text = if lathe.params.tailstock {
        format!("{start_x} IS LESS THAN {stock}+2*{room}")
    } else {
        format!("{start_x} AND {start_z} LEAVE LESS ROOM THAN {room}")
    };
    has_flag(lathe).then_some(text)
}

/// Least X as a diameter at which the turret turns beside the work.
fn beside() -> Formula {
    entry(STOCK) + entry(ROOM) * 2
}

/// Least Z at which the turret turns in front of the work: the allowance of a face is in front of the finished face.
fn in_front(lathe: &TurningSpindle) -> Formula {
    if lathe.params.path == Path::Facing { entry(ROOM) + entry(ALLOWANCE) } else { entry(ROOM) }
}

/// The tool, only while it is clear of the work and its turret has room to turn.
fn call_tool(b: &mut Builder, lathe: &TurningSpindle) {
    match position(lathe) {
        Some(position) => {
            writing::stays_clear(b.n(17), position, || size(lathe, clear()), alarm_block(away_alarm(lathe)));
            let (beside, in_front) = (size(lathe, beside()), in_front(lathe));
            if lathe.params.tailstock {
                // In front of the work is the tailstock.
                b.if_goto(v(position.across).lt(beside), alarm_block(away_alarm(lathe)));
            } else {
                writing::turret_has_room(
                    b,
                    position,
                    TurretRoom { beside, in_front },
                    18,
                    alarm_block(away_alarm(lathe)),
                );
            }
        }
        None => {
            b.n(17).if_goto(v(BEGUN).gt(0), alarm_block(away_alarm(lathe)));
        }
    }
    b.n(18).words(writing::tool(lathe.control, lathe.params.tool as u32)).note("TOOL AND ITS OFFSET");
    if let Some(position) = position(lathe) {
        // The offset shifts the coordinates.
        writing::stays_clear(b, position, || size(lathe, clear()), alarm_block(away_alarm(lathe)));
    }
}

/// Sequence number of the approach of the turning tool, once in each part.
pub(super) const APPROACH: u32 = 23;

/// Sequence numbers of the approach of the driven tool, and of its way back.
pub(super) const DRIVEN_WAY: [u32; 2] = [58, 64];

/// Sequence numbers of the blocks that cut the keyway: into the work, and along it.
pub(super) const KEYWAY: [u32; 2] = [60, 61];

/// Releases the spindle that the program has locked, if there is a code for it.
fn release_spindle(b: &mut Builder, lathe: &TurningSpindle) {
    if let Some(CodePair { off: Some(release), .. }) = lathe.lock_codes() {
        b.words([m(release)]).note("RELEASES THE SPINDLE");
    }
}

/// Message of the stop at the angle if the program cuts no keyway: the reason.
fn no_keyway(lathe: &TurningSpindle) -> &'static str {
    match lathe.params.driven_tool {
        false => "NO DRIVEN TOOL TO CUT THE KEYWAY",
        true if lathe.params.keyway_diameter().is_none() => "NO KEYWAY ON A TAPER",
        true => "NO DEPTH OF THE KEYWAY IS GIVEN",
    }
}

/// The keyway: the driven tool goes into the work at feed, along it, and back. The spindle is locked at its angle, by a code or by hand.
fn keyway(b: &mut Builder, lathe: &TurningSpindle) {
    let p = &lathe.params;
    let surface = || entry(if p.path == Path::Facing { STOCK } else { FINISHED });
    let clear = || surface() + entry(CLEARANCE) * 2;
    let own = lathe.driven_codes();
    let driven = |code: Option<u32>, sign: u32| code.map_or_else(|| indexed(Address::M, DRIVEN, sign), m);
    if lathe.lock_codes().is_none() {
        b.n(54).words([m(0)]).note("LOCK THE SPINDLE BY HAND");
    }
    b.n(56).words(writing::tool(lathe.control, p.driven_number as u32)).note("DRIVEN TOOL AND ITS OFFSET");
    b.n(57).words([indexed(Address::S, DRIVEN, entry(DRIVEN_SPEED)), driven(own.map(|codes| codes.on), 3)]);
    b.n(DRIVEN_WAY[0]).words(codes(lathe, [Code::FeedPerMinute, Code::Rapid]).into_iter().chain([z(-(entry(
        KEYWAY_START,
    ) + entry(
        KEYWAY_WIDTH,
    ) / 2))]));
    b.n(59).words([cross(lathe, clear())]);
    b.n(KEYWAY[0]).words(block(
        lathe,
        Code::Linear,
        [cross(lathe, surface() - entry(KEYWAY_DEPTH) * 2), f(entry(KEYWAY_INFEED))],
    ));
    b.n(KEYWAY[1])
        .words([z(-(entry(KEYWAY_START) + entry(KEYWAY_LENGTH) - entry(KEYWAY_WIDTH) / 2)), f(entry(KEYWAY_FEED))]);
    b.n(62).words(block(lathe, Code::Rapid, [cross(lathe, clear())]));
    b.n(63).words([cross(lathe, entry(START_X))]);
    b.n(DRIVEN_WAY[1]).words([z(entry(START_Z))]);
    if own.is_none_or(|codes| codes.off.is_some()) {
        b.n(65).words([driven(own.and_then(|codes| codes.off), 5)]);
    }
    match lathe.lock_codes() {
        None => _ = b.n(66).words([m(0)]).note("RELEASE THE SPINDLE BY HAND"),
        Some(CodePair { off: Some(release), .. }) => _ = b.n(66).words([m(release)]).note("RELEASES THE SPINDLE"),
        Some(CodePair { off: None, .. }) => {}
    }
}

/// Number of the spindle that drives the tool.
const DRIVEN: u8 = 2;

/// Variables of the tool's position in X and Z, where the program can read it and raise an alarm of its own.
fn position(lathe: &TurningSpindle) -> Option<PositionVariables> {
    writing::position_variables(lathe.control, [CROSS, ALONG])
}

/// Whether a variable marks a begun part, because the program cannot read the tool's position.
fn has_flag(lathe: &TurningSpindle) -> bool {
    position(lathe).is_none()
}

/// The variable that marks a begun part, as the control writes it.
pub(super) fn begun(lathe: &TurningSpindle) -> Option<String> {
    has_flag(lathe).then(|| lathe.control.variable(BEGUN))
}

/// Number of the alarm of a tool that is not clear of the work, after those of the entries.
fn away_alarm(lathe: &TurningSpindle) -> u32 {
    entries(lathe).len() as u32 + 1
}

/// Conditions under which the program refuses entries above zero, with the texts of their alarms: no core of the work
/// is left, nothing is cut, the cut is longer than the work, the start is in the stock, the keyway does not fit. Their alarm numbers follow that
/// of a tool that is not clear.
fn refusals(lathe: &TurningSpindle) -> Vec<(Condition, String)> {
    let name = |number: u32| lathe.control.variable(number);
    let ends = if lathe.params.path == Path::Taper { &[FINISHED, TAPER_END][..] } else { &[FINISHED] };
    let nothing_to_cut =
        ends.iter().map(|end| (entry(*end).ge(entry(STOCK)), format!("{} IS NOT BELOW {}", name(*end), name(STOCK))));
    let [way_name, reach] = [way(lathe), REACH].map(name);
    let too_long = (entry(way(lathe)).gt(entry(REACH)), format!("{way_name} IS MORE THAN {reach}"));
    let start_in_stock =
        (entry(START_X).le(clear()), format!("{} IS NOT ABOVE {}+2*{}", name(START_X), name(STOCK), name(CLEARANCE)));
    let all = [core_guard(lathe)].into_iter().chain(nothing_to_cut).chain([too_long, start_in_stock]);
    all.chain(keyway_guards(lathe)).collect()
}

/// Conditions under which the program refuses a keyway, with the texts of their alarms: longer than its cylinder,
/// shorter than the tool, or as deep as the centre.
fn keyway_guards(lathe: &TurningSpindle) -> Vec<(Condition, String)> {
    if lathe.keyway().is_none() {
        return Vec::new();
    }
    let is_face = lathe.params.path == Path::Facing;
    let surface = if is_face { STOCK } else { FINISHED };
    let [start, length, width, depth, surface_name, way_name, reach] =
        [KEYWAY_START, KEYWAY_LENGTH, KEYWAY_WIDTH, KEYWAY_DEPTH, surface, way(lathe), REACH]
            .map(|at| lathe.control.variable(at));
    // The allowance of a face is in front of the finished face, where the keyway is measured from.
    let (end, end_name) = if is_face {
        (entry(REACH) - entry(ALLOWANCE), format!("{reach}-{way_name}"))
    } else {
        (entry(way(lathe)), way_name)
    };
    vec![
        ((entry(KEYWAY_START) + entry(KEYWAY_LENGTH)).gt(end), format!("{start}+{length} IS MORE THAN {end_name}")),
        (entry(KEYWAY_LENGTH).lt(entry(KEYWAY_WIDTH)), format!("{length} IS LESS THAN {width}")),
        ((entry(KEYWAY_DEPTH) * 2).ge(entry(surface)), format!("{depth}*2 IS NOT BELOW {surface_name}")),
    ]
}

/// Condition of a finished diameter that leaves nothing of the work, and the text of its alarm. A face ends at the centre or a little behind it,
/// where the edge leaves no pip; farther on, the work would move against the back of the edge. A taper may begin at the centre, unless that of
/// the tailstock is there.
fn core_guard(lathe: &TurningSpindle) -> (Condition, String) {
    let name = lathe.control.variable(FINISHED);
    match lathe.params.path {
        Path::Facing => ((entry(FINISHED) + entry(CLEARANCE) * 2).lt(0), format!("{name} IS FAR BEHIND THE CENTRE")),
        Path::Taper if !lathe.params.tailstock => (entry(FINISHED).lt(0), format!("{name} MUST NOT BE BELOW ZERO")),
        Path::Turning | Path::Taper => (entry(FINISHED).le(0), format!("{name} MUST BE ABOVE ZERO")),
    }
}

/// Words of the speed limit S. On a control where S alone would make the present position work zero, the words of the present position are
/// added.
fn limit(lathe: &TurningSpindle) -> Vec<NewWord> {
    let at = position(lathe).filter(|_| lathe.rules().limit_place == LimitPlace::WorkZero);
    let held = at.into_iter().flat_map(|position| [x(v(position.across)), z(v(position.along))]);
    held.chain([s(entry(SPEED_LIMIT))]).collect()
}

/// The code of the gear stage, if there are several stages.
fn gear(lathe: &TurningSpindle) -> Option<Vec<NewWord>> {
    let stage = lathe.stage();
    let words = codes(lathe, [Code::GearStage(stage)]);
    (lathe.params.has_several_stages() && !words.is_empty()).then_some(words)
}

/// The spindle: surface speed, or the speed of the largest diameter.
fn start(b: &mut Builder, lathe: &TurningSpindle) {
    let turn = m(if lathe.params.direction == SpindleDirection::Clockwise { 3 } else { 4 });
    // n = 1000 v / (π d) at the stock's diameter, cut to a whole number as S is.
    b.n(24).assign(SPEED, (entry(CUTTING_SPEED) * 1000 / (real(crate::math::PI, 6) * entry(STOCK))).fix());
    b.n(25).if_goto(v(SPEED).le(entry(SPEED_LIMIT)), 27);
    b.n(26).assign(SPEED, entry(SPEED_LIMIT).fix()).note("AT MOST THE LIMIT");
    let mut words = if lathe.surface() {
        block(lathe, Code::SurfaceSpeed, [s(entry(CUTTING_SPEED))])
    } else {
        block(lathe, Code::SurfaceSpeedOff, [s(v(SPEED))])
    };
    // The speed limit as a word of its own, where no block before sets it.
    words.extend(lathe.limit_word().filter(|_| lathe.surface()).map(|address| word(address, entry(SPEED_LIMIT))));
    words.push(turn);
    b.n(27).words(words);
    // On a control whose cuts do not wait for the speed, the program dwells: the ramp to the highest speed suffices for
    // every speed and override. A face has its wait in each pass, where the tool is already at its start.
    let ramp =
        lathe.params.spindle.ramp * lathe.derived.stage.top.min(lathe.params.chuck_limit) / lathe.derived.stage.speed;
    let waits_in_passes = lathe.params.path == Path::Facing && lathe.dwell_of_passes().is_some();
    if lathe.rules().reached.is_none() && !waits_in_passes && ramp > 0.0 {
        let seconds = (100.0 * ramp).ceil() / 100.0;
        comes_to_speed(b.n(28), lathe, real(seconds, 3));
    }
}

/// Dwells until the spindle has its speed.
fn comes_to_speed(b: &mut Builder, lathe: &TurningSpindle, seconds: Formula) {
    writing::wait(b, lathe.control, Code::FeedPerRevolution, seconds, "SPINDLE COMES TO ITS SPEED");
}

/// The wait of a pass, at the diameter where its cut begins. The speed is commanded again: some controls change a surface speed in cuts alone,
/// and would begin this one with the highest speed of the one before.
fn wait(b: &mut Builder, lathe: &TurningSpindle) {
    if let Some(per_speed) = lathe.dwell_of_passes() {
        b.words(block(lathe, Code::SurfaceSpeed, [s(entry(CUTTING_SPEED))]));
        comes_to_speed(b, lathe, entry(SPEED_LIMIT) * real((1e6 * per_speed).ceil() / 1e6, 6));
    }
}

/// The blocks of a pass.
fn pass(b: &mut Builder, lathe: &TurningSpindle) {
    let rapid = |words: Vec<NewWord>| block(lathe, Code::Rapid, words);
    let cut = |words: Vec<NewWord>| block(lathe, Code::Linear, words);
    // The tool leaves the shoulder at feed, out to the end of the previous pass, because the edge may have left a wedge
    // there.
    match lathe.params.path {
        Path::Facing => {
            b.n(35);
            wait(b, lathe);
            b.words(rapid(vec![z(v(LEFT))]));
            b.n(PASS_BEGIN).words(cut(vec![cross(lathe, entry(FINISHED)), f(entry(FEED))]));
            b.n(37).words(rapid(vec![z(v(LEFT) + entry(DEPTH))]));
            b.n(38).words([cross(lathe, clear())]);
        }
        Path::Turning => {
            b.n(35).words(rapid(vec![cross(lathe, entry(FINISHED) + v(LEFT))]));
            b.n(PASS_BEGIN).words(cut(vec![z(-entry(LENGTH)), f(entry(FEED))]));
            b.n(37).words([cross(lathe, entry(FINISHED) + v(LEFT) + entry(DEPTH) * 2)]);
            b.n(38).words(rapid(vec![z(entry(CLEARANCE))]));
        }
        Path::Taper => {
            // A pass begins and ends where its line is clear of the stock, not at a diameter far outside of it.
            let at_face = || entry(FINISHED) + v(LEFT);
            let at_end = || entry(TAPER_END) + v(LEFT);
            b.n(35).assign(BEGIN_X, smaller(at_face, clear)).note("PASS BEGINS, DIAMETER");
            b.assign(BEGIN_Z, (at_face() - v(BEGIN_X)) * v(SLOPE)).note("PASS BEGINS, Z");
            b.assign(END_X, smaller(at_end, clear)).note("PASS ENDS, DIAMETER");
            b.words(rapid(vec![cross(lathe, v(BEGIN_X))]));
            b.words([z(v(BEGIN_Z) + entry(CLEARANCE))]);
            wait(b, lathe);
            b.n(PASS_BEGIN).words(cut(vec![z(v(BEGIN_Z)), f(entry(FEED))]));
            let end_z = (at_end() - v(END_X)) * v(SLOPE) - entry(LENGTH);
            b.n(cut_block(Path::Taper)).words([cross(lathe, v(END_X)), z(end_z)]);
            b.n(38).words([cross(lathe, v(END_X) + entry(DEPTH) * 2)]);
            b.n(39).words(rapid(vec![cross(lathe, clear())]));
            b.n(40).words([z(entry(CLEARANCE))]);
        }
    }
}

/// O9202: the values of the project, once.
fn setup(b: &mut Builder, lathe: &TurningSpindle) {
    b.program(SETUP, "TURNING - SET VALUES ONCE");
    writing::write_header::<TurningSpindle>(b, &lathe.form, lathe.control);
    let p = &lathe.params;
    let (is_face, is_taper, has_keyway) = (p.path == Path::Facing, p.path == Path::Taper, lathe.keyway().is_some());
    let [highest, lowest] = speed_limits(lathe).map(|limit| limit.is_some());
    // Variable, value, decimals, comment, and whether this machine has it.
    let values = [
        (CUTTING_SPEED, p.cutting_speed, 2, "CUTTING SPEED M/MIN", true),
        (FEED, p.feed, 3, "FEED MM/REV", true),
        (STOCK, p.stock_diameter, 3, "STOCK DIAMETER", true),
        (FINISHED, p.finished_diameter, 3, if is_taper { "DIAMETER AT THE FACE" } else { "FINISHED DIAMETER" }, true),
        (TAPER_END, p.large_diameter, 3, "DIAMETER AT THE END", is_taper),
        (way(lathe), p.cut_length(), 3, if is_face { "ALLOWANCE" } else { "LENGTH" }, true),
        (DEPTH, lathe.form.depth, 3, "DEPTH OF CUT", true),
        (SPEED_LIMIT, p.upper_limit, 0, "SPEED LIMIT", true),
        (CLEARANCE, p.clearance, 3, "CLEARANCE", true),
        (START_X, p.start_x, 3, "START X, DIAMETER", true),
        (START_Z, p.start_z, 3, "START Z", true),
        (REACH, p.cut_reach(), 3, "LONGEST CUT BEHIND THE FACE", true),
        (ROOM, p.turret_room, 3, "ROOM FOR THE TURRET TO TURN", true),
        (ANGLE, p.keyway_angle, 3, "ANGLE OF THE KEYWAY", lathe.positions()),
        (CHUCK_LIMIT, p.chuck_limit, 0, "HIGHEST SPEED OF THE CHUCK", highest),
        (LOWEST_SPEED, p.lower_limit, 0, "LOWEST SPEED OF THE SPINDLE", lowest),
        (KEYWAY_DEPTH, p.keyway_depth, 3, "DEPTH OF THE KEYWAY", has_keyway),
        (KEYWAY_LENGTH, p.keyway_length, 3, "LENGTH OF THE KEYWAY", has_keyway),
        (KEYWAY_START, p.keyway_start, 3, "KEYWAY BEHIND THE FACE", has_keyway),
        (KEYWAY_WIDTH, p.keyway_width, 3, "DIAMETER OF THE DRIVEN TOOL", has_keyway),
        (DRIVEN_SPEED, p.driven_speed, 0, "SPEED OF THE DRIVEN TOOL", has_keyway),
        (KEYWAY_FEED, p.keyway_feed, 0, "FEED ALONG THE KEYWAY MM/MIN", has_keyway),
        (KEYWAY_INFEED, p.keyway_infeed, 0, "FEED INTO THE WORK MM/MIN", has_keyway),
    ];
    for (at, (number, value, decimals, text, _)) in (1..).zip(values).filter(|(_, (.., has))| *has) {
        b.n(at).assign(number, real(value, decimals)).note(text);
    }
    b.n(if has_keyway { 30 } else { 20 }).words([m(30)]);
}

//! The programs of the polygon lathe: O3000 turns the part, O9120 (G512) starts the two axes, O9121 (G502) stops them.
//!
//! The part program is the paper's, with more passes. Of O9120 and O9121 the paper names the variables that they write;
//! everything else in them, and the bits to and from the PMC, is macroline's own.

use super::path::{PassStep, SlideTarget};
use super::resolved::PolygonLathe;
use super::turned_end_form::TurnedEndPlace;
use crate::controls::Address;
use crate::controls::Code;
use crate::controls::CodeId;
use crate::machines::lathe::slides::{ALONG, CROSS};
use crate::machines::machine::MachineVariable;
use crate::machines::program::writing::{self, PositionVariables, TurretRoom, alarm_block};
use crate::nc::Deck;
use crate::nc::build::{Builder, Formula, NewWord, f, g, m, real, s, v, word, x, z};
use crate::text::catalog::number_text as show;

/// Number of the program that turns the part: the paper's.
pub(super) const PART: u32 = 3000;
/// Programs that the two codes call: start and stop.
pub(super) const MACROS: [u32; 2] = [9120, 9121];

/// Variables that O9120 writes: speed, ratio of the work, ratio of the tool (the paper's).
pub(super) const SPEED: u32 = 1480;
pub(super) const WORK_RATIO: u32 = 1484;
pub(super) const TOOL_RATIO: u32 = 1488;
/// Start angles in 0.001°: work, tool (ours).
pub(super) const WORK_ANGLE: u32 = 1492;
pub(super) const TOOL_ANGLE: u32 = 1496;
/// Bits to the PMC: go to the start angles, turn (ours).
pub(super) const INDEX: u32 = 1100;
pub(super) const TURN: u32 = 1101;
/// Bits from the PMC: at the start angles, both at speed, polygon turning is on, nothing turns and nothing is requested
/// (ours).
pub(super) const AT_ANGLE: u32 = 1000;
pub(super) const AT_SPEED: u32 = 1001;
pub(super) const ON: u32 = 1002;
pub(super) const IDLE: u32 = 1003;

/// Arguments of G512: A, B, D, E, Q.
const A: u32 = 1;
const B: u32 = 2;
const D: u32 = 7;
const E: u32 = 8;
const Q: u32 = 17;
/// Arguments that would be words of another command: C, F, H, M, S, T, U, V, W, X, Y, Z.
const OTHERS: [u32; 12] = [3, 9, 11, 13, 19, 20, 21, 22, 23, 24, 25, 26];
/// Arguments that G512 does not have: I, J, K, R. (L, N, O, P are no arguments.)
const UNKNOWN: [u32; 4] = [4, 5, 6, 18];
/// Variable that receives a position: reading one makes the control wait for standstill.
const STANDSTILL: u32 = 32;

/// Numbers of the alarms of a call of G512: speed, ratios, a word of another command in its block.
const NO_SPEED: u32 = 1;
const NO_WORK_RATIO: u32 = 2;
const NO_TOOL_RATIO: u32 = 3;
const WORK_RATIO_NOT_WHOLE: u32 = 4;
const TOOL_RATIO_NOT_WHOLE: u32 = 5;
const ZERO_RATIO: u32 = 6;
const NOT_ALONE: u32 = 7;
/// Number of the alarm for a start while polygon turning is on.
const ON_ALREADY: u32 = 8;
/// Numbers of the alarms of an axis above its highest speed.
const WORK_TOO_FAST: u32 = 9;
const TOOL_TOO_FAST: u32 = 10;

/// M code that fixes the spindle override at 100 % until M5, for a thread (ours, in the ladder).
pub(super) const OVERRIDE_OFF: u32 = 49;

/// Number of the alarm of a cutter that is not clear of the work.
pub(super) const AWAY: u32 = 11;
/// Number of the alarm of a letter that G512 does not have.
const LETTER: u32 = 12;
/// Alarm of O9120: the speed is not a whole number, and the register of the PMC takes no other.
const SPEED_NOT_WHOLE: u32 = 13;

/// Sequence number of the first block of a pass, from 1.
fn number(pass: u32) -> u32 {
    100 + 10 * pass
}

/// Sequence number of the block that ends the turning of the polygon before this one, from 1.
pub(super) fn change_over(polygon: u32) -> u32 {
    1000 * polygon - 199
}

/// Variables that show the state.
pub(super) const VARIABLES: [MachineVariable; 11] = [
    MachineVariable::new(SPEED, "polygon.speed", "r/min"),
    MachineVariable::new(WORK_RATIO, "polygon.work-ratio", ""),
    MachineVariable::new(TOOL_RATIO, "polygon.tool-ratio", ""),
    MachineVariable::new(WORK_ANGLE, "polygon.work-start", "0.001°"),
    MachineVariable::new(TOOL_ANGLE, "polygon.tool-start", "0.001°"),
    MachineVariable::new(INDEX, "polygon.signal.index", ""),
    MachineVariable::new(TURN, "polygon.signal.turn", ""),
    MachineVariable::new(AT_ANGLE, "polygon.signal.at-angle", ""),
    MachineVariable::new(AT_SPEED, "polygon.signal.at-speed", ""),
    MachineVariable::new(ON, "polygon.signal.on", ""),
    MachineVariable::new(IDLE, "polygon.signal.idle", ""),
];

/// The programs, one per file.
pub(super) fn deck(lathe: &PolygonLathe) -> Deck {
    let mut b = Builder::new();
    part(&mut b, lathe);
    start(&mut b, lathe);
    stop(&mut b, lathe);
    b.finish()
}

/// Numbers of the G codes that call [`MACROS`], as the parameters of the control bind them.
pub(super) fn codes(lathe: &PolygonLathe) -> [Option<u32>; 2] {
    let calls = lathe.dialect.calls();
    MACROS.map(|program| {
        calls.iter().find_map(|call| match call.code {
            CodeId::G(number) if call.program == program => Some(number.integer()),
            _ => None,
        })
    })
}

fn rapid(words: impl IntoIterator<Item = NewWord>) -> Vec<NewWord> {
    [g(0)].into_iter().chain(words).collect()
}

/// Whether the program calls more than one tool.
pub(super) fn changes_tools(lathe: &PolygonLathe) -> bool {
    let ends = lathe.params.turned_ends.iter().filter(|end| end.on);
    let turned = ends.flat_map(|end| {
        let cuts = [(end.tool, end.steps(&lathe.params)), (end.thread_tool, end.thread(&lathe.params))];
        cuts.into_iter().filter(|(_, steps)| !steps.is_empty()).map(|(tool, _)| tool)
    });
    let mut others = lathe.polygons().map(|polygon| polygon.params.tool).chain(turned);
    others.any(|tool| tool != lathe.params.tool)
}

/// A word of X for a distance across flats or a diameter.
fn cross(lathe: &PolygonLathe, size: f64) -> NewWord {
    x(real(lathe.x_of(size), 3))
}

/// The words of a step.
pub(super) fn block(lathe: &PolygonLathe, step: PassStep) -> Vec<NewWord> {
    let word = |to: SlideTarget| match to {
        SlideTarget::Across(size) => cross(lathe, size),
        SlideTarget::Along(place) => z(real(place, 3)),
    };
    match step {
        PassStep::Rapid(to) => vec![g(0), word(to)],
        PassStep::Feed(to, feed) => vec![g(1), word(to), f(real(feed, 3))],
        PassStep::Slope { across, along, feed } => {
            vec![g(1), cross(lathe, across), z(real(along, 3)), f(real(feed, 3))]
        }
        PassStep::Thread { along, pitch } => {
            let cut = writing::codes(lathe.control, [Code::Thread]).into_iter().take(1);
            cut.chain([z(real(along, 3)), f(real(pitch, 3))]).collect()
        }
        PassStep::Dwell(seconds) => writing::dwell(lathe.control, seconds).into(),
    }
}

/// A block of a turned end.
pub(super) struct TurnedEndBlock {
    pub(super) words: Vec<NewWord>,
    /// Comment of the block, or empty.
    note: &'static str,
    /// Whether the turret brings another tool: a check of its clearance follows the block.
    pub(super) changes_tool: bool,
}

impl TurnedEndBlock {
    fn new(words: Vec<NewWord>, note: &'static str) -> TurnedEndBlock {
        TurnedEndBlock { words, note, changes_tool: false }
    }
}

/// Least feed of an F word, mm per revolution; a smaller one would be written as 0.
const LEAST_FEED: f64 = 0.001;

/// A step of a turned end with its feed per revolution of the spindle, instead of per minute at `speed` (r/min).
fn per_revolution(step: PassStep, speed: f64) -> PassStep {
    // Down to the decimals of F: rounded up it may be above the clamp of the slide.
    let per_turn = |feed: f64| ((feed / speed / LEAST_FEED + 1e-6).floor() * LEAST_FEED).max(LEAST_FEED);
    match step {
        PassStep::Feed(to, feed) => PassStep::Feed(to, per_turn(feed)),
        PassStep::Slope { across, along, feed } => PassStep::Slope { across, along, feed: per_turn(feed) },
        other => other,
    }
}

/// Blocks of a turned end, if the part has one at this place: each tool starts from the start point of the slide and
/// returns to it, with the spindle on for both tools. The feed is per revolution: with a feed per minute, a spindle
/// knob at a low position would drive the tool into a bar that hardly turns.
pub(super) fn turned_end(lathe: &PolygonLathe, place: TurnedEndPlace) -> Vec<TurnedEndBlock> {
    let p = &lathe.params;
    let Some(end) = p.turned_ends.get(place as usize).filter(|end| end.on) else { return Vec::new() };
    // The ramp from the speed at 10 V is long enough for every S and override.
    let ramp = || writing::dwell(lathe.control, p.main.ramp).to_vec();
    let plain = |words: Vec<NewWord>| TurnedEndBlock::new(words, "");
    let away = || rapid([cross(lathe, p.start_x), z(real(p.start_z, 3))]);
    let per_turn = lathe.control.can(Code::FeedPerRevolution);
    let in_feed = |step| if per_turn { per_revolution(step, end.speed) } else { step };
    let mut all = Vec::new();
    let cuts = [(end.tool, end.steps(p), "TURNING"), (end.thread_tool, end.thread(p), "THREAD")];
    for (at, (tool, steps, note)) in cuts.into_iter().filter(|(_, steps, _)| !steps.is_empty()).enumerate() {
        let tool = TurnedEndBlock::new(writing::tool(lathe.control, tool as u32), note);
        all.push(TurnedEndBlock { changes_tool: true, ..tool });
        if at == 0 {
            all.push(plain(vec![m(3), s(end.speed as u32)]));
            all.push(TurnedEndBlock::new(ramp(), "SPINDLE COMES TO ITS SPEED"));
            // After the dwell, because a parameter of the control may count a dwell in revolutions under a feed per
            // revolution.
            all.extend(per_turn.then(|| plain(writing::codes(lathe.control, [Code::FeedPerRevolution]))));
        }
        if at > 0 {
            // Without it the knob would act between two threads, and each thread would begin while the spindle returns
            // to S.
            let per_minute = writing::codes(lathe.control, per_turn.then_some(Code::FeedPerMinute));
            let fixed = per_minute.into_iter().chain([m(OVERRIDE_OFF)]).collect();
            all.push(TurnedEndBlock::new(fixed, "SPINDLE OVERRIDE OFF"));
            all.push(TurnedEndBlock::new(ramp(), "SPINDLE COMES TO ITS SPEED"));
            all.extend(per_turn.then(|| plain(writing::codes(lathe.control, [Code::FeedPerRevolution]))));
        }
        all.push(plain(rapid([cross(lathe, p.clear_diameter())])));
        all.push(plain(vec![z(real(p.clearance, 3))]));
        all.extend(steps.into_iter().map(|step| plain(block(lathe, in_feed(step)))));
        all.push(plain(away()));
    }
    let per_minute = writing::codes(lathe.control, per_turn.then_some(Code::FeedPerMinute));
    all.push(plain(per_minute.into_iter().chain([m(5)]).collect()));
    // M5 is answered at once; the work axis takes over, or the next part begins with it.
    all.push(TurnedEndBlock::new(ramp(), "SPINDLE STOPS"));
    all
}

/// Writes the blocks of a turned end, with the checks after each tool change.
fn write_turned_end(b: &mut Builder, lathe: &PolygonLathe, at: TurnedEndPlace, position: Option<PositionVariables>) {
    for block in turned_end(lathe, at) {
        b.words(block.words);
        if !block.note.is_empty() {
            b.note(block.note);
        }
        if let Some(position) = position.filter(|_| block.changes_tool) {
            let clear = lathe.params.clear_diameter();
            writing::stays_clear(b, position, || real(lathe.x_of(clear), 3), alarm_block(AWAY));
        }
    }
}

/// Jumps to an alarm unless the turret has room to turn at the position of the slide; with room beside the work it goes
/// on at block `next`.
pub(super) fn check_turret(b: &mut Builder, lathe: &PolygonLathe, position: PositionVariables, next: u32) {
    let p = &lathe.params;
    let beside = real(lathe.x_of(p.stock_diameter + 2.0 * p.turret_room), 3);
    let in_front = real(p.turret_room, 3);
    writing::turret_has_room(b, position, TurretRoom { beside, in_front }, next, alarm_block(AWAY));
}

/// Writes O3000, which turns the part.
fn part(b: &mut Builder, lathe: &PolygonLathe) {
    let p = &lathe.params;
    let [on, off] = codes(lathe).map(|code| code.unwrap_or(0));
    let mm = |number: f64| real(number, 3);
    let clear = p.clear_diameter();
    b.program(PART, "POLYGON TURNING");
    writing::write_header::<PolygonLathe>(b, &lathe.form, lathe.control);
    let offset = show(-p.tip_radius * lathe.x_per_mm(), 3);
    let across = show(p.across_flats, 3);
    let word_of_x = show(lathe.x_of(p.across_flats), 3);
    b.comment(&format!("X OFFSET OF THE CUTTER IS {offset}, X0 WITH THE TIPS AT THE CENTRE"));
    b.comment(&format!("THEN X{word_of_x} IS {across} MM ACROSS FLATS"));
    let mut cutters = vec![p.tool];
    for PolygonLathe { params: p, derived: d, .. } in &lathe.further {
        if !cutters.contains(&p.tool) {
            cutters.push(p.tool);
            b.comment(&format!("X OFFSET OF T{} IS {}", p.tool as u32, show(d.place.offset, 3)));
        }
    }
    let position = writing::position_variables(lathe.control, [CROSS, ALONG]);
    let away = || real(lathe.x_of(clear), 3);
    b.n(10).words(writing::opening(lathe.control)).note("WORK ZERO: TURNING CENTRE, FACE");
    if let Some(position) = position {
        writing::stays_clear(b.n(11), position, away, alarm_block(AWAY));
        check_turret(b, lathe, position, 12);
    }
    b.n(12).words(writing::codes(lathe.control, [Code::FeedPerMinute]));
    write_turned_end(b, lathe, TurnedEndPlace::Before, position);
    b.n(13).words(writing::tool(lathe.control, p.tool as u32)).note("CUTTER AND ITS OFFSET");
    if let Some(position) = position {
        // The offset shifts the coordinates.
        writing::stays_clear(b, position, away, alarm_block(AWAY));
    }
    // Away from the work first: a start after a reset may begin anywhere.
    b.n(14).words(rapid([cross(lathe, clear)]));
    b.words([z(mm(p.clearance))]);
    let mut present = lathe;
    for (at, polygon) in (0..).zip(lathe.polygons()) {
        let base = 1000 * at;
        if at > 0 {
            b.n(change_over(at)).words([g(off)]).note("POLYGON TURNING OFF");
            change(b, base, (present, polygon), position);
        }
        b.n(base + 20).words(call(on, polygon)).note("POLYGON TURNING ON");
        let passes = polygon.params.passes() as u32;
        for pass in 1..=passes {
            let first = base + number(pass);
            for (at, step) in (first..).zip(polygon.params.steps(f64::from(pass))) {
                b.n(at).words(block(polygon, step));
                if at == first {
                    b.note(if pass == passes { "FINISHING" } else { "ROUGHING" });
                }
            }
        }
        present = polygon;
    }
    let end = 1000 * lathe.further.len() as u32 + 800;
    b.n(end).words(rapid([cross(lathe, p.start_x), z(mm(p.start_z))]));
    b.n(end + 1).words([g(off)]).note("POLYGON TURNING OFF");
    write_turned_end(b, lathe, TurnedEndPlace::After, position);
    b.n(end + 2).words([m(30)]);
    if position.is_some() {
        away_alarm(b, lathe);
    }
}

/// The alarm of a cutter that is not clear of the work, at the end of a program.
pub(super) fn away_alarm(b: &mut Builder, lathe: &PolygonLathe) {
    writing::alarm(b, lathe.control, AWAY, "RETRACT THE CUTTER BY HAND");
    b.words([m(30)]);
}

/// The call that starts polygon turning.
fn call(on: u32, lathe: &PolygonLathe) -> Vec<NewWord> {
    let p = &lathe.params;
    let arguments = [
        (Address::B, real(p.speed, 0)),
        (Address::D, Formula::from(p.work_ratio as i32)),
        (Address::Q, Formula::from(p.tool_ratio as i32)),
        (Address::A, real(p.work_start, 3)),
        (Address::E, real(p.tool_start, 3)),
    ];
    [g(on)].into_iter().chain(arguments.map(|(letter, value)| word(letter, value))).collect()
}

/// From one polygon to the next: the cutter changes at the start point of the slide, and a pass at the end of the bar
/// begins in front of the face.
fn change(b: &mut Builder, base: u32, (from, to): (&PolygonLathe, &PolygonLathe), position: Option<PositionVariables>) {
    let p = &to.params;
    let clear = p.clear_diameter();
    let changes = from.params.tool != p.tool;
    if changes {
        b.n(base + 10).words(rapid([cross(to, p.start_x), z(real(p.start_z, 3))]));
        b.n(base + 13).words(writing::tool(to.control, p.tool as u32)).note("CUTTER AND ITS OFFSET");
        if let Some(position) = position {
            writing::stays_clear(b, position, || real(to.x_of(clear), 3), alarm_block(AWAY));
        }
        b.n(base + 14).words(rapid([cross(to, clear)]));
    }
    if changes || !p.is_behind_face() {
        b.n(base + 15).words(rapid([z(real(p.clearance, 3))]));
    }
}

/// Jumps to an alarm if one of the arguments is given.
fn refuse(b: &mut Builder, arguments: &[u32], target: u32) {
    for argument in arguments {
        b.if_goto(v(*argument).ne(v(0)), target);
    }
}

/// Clears the arguments where the control would keep them for the next call, which may not have them.
fn clear(b: &mut Builder, lathe: &PolygonLathe) {
    let kept = [A, B, D, E, Q].into_iter().filter(|_| lathe.dialect.keeps_locals());
    kept.for_each(|argument| {
        b.assign(argument, v(0));
    });
}

/// Waits for standstill of the slide by reading its position.
fn wait_for_slide(b: &mut Builder) {
    b.assign(STANDSTILL, v(5041)).note("WAITS FOR STANDSTILL");
}

/// Waits for a bit of the PMC.
fn wait_for(b: &mut Builder, bit: u32) {
    b.while_do(v(bit).eq(0), 1);
    b.end_do(1);
}

/// O9120.
fn start(b: &mut Builder, lathe: &PolygonLathe) {
    let p = &lathe.params;
    b.program(MACROS[0], "POLYGON TURNING ON");
    b.comment("RECONSTRUCTED, NOT THE PAPER'S TEXT");
    b.comment("B SPEED, D WORK RATIO, Q TOOL RATIO");
    b.comment("A AND E START ANGLES OF WORK AND TOOL");
    for (at, (argument, alarm)) in (1..).zip([(B, NO_SPEED), (D, NO_WORK_RATIO), (Q, NO_TOOL_RATIO)]) {
        b.n(at).if_goto(v(argument).eq(v(0)), alarm_block(alarm));
    }
    b.n(4).if_goto(v(B).le(0), alarm_block(NO_SPEED));
    b.if_goto(v(B).ne(v(B).fix()), alarm_block(SPEED_NOT_WHOLE));
    for (at, (term, alarm)) in (5..).zip([(D, WORK_RATIO_NOT_WHOLE), (Q, TOOL_RATIO_NOT_WHOLE)]) {
        b.n(at).if_goto(v(term).ne(v(term).fix()), alarm_block(alarm));
    }
    for (at, term) in (7..).zip([D, Q]) {
        b.n(at).if_goto(v(term).eq(0), alarm_block(ZERO_RATIO));
    }
    b.n(9);
    refuse(b, &OTHERS, alarm_block(NOT_ALONE));
    refuse(b, &UNKNOWN, alarm_block(LETTER));
    wait_for_slide(b);
    b.n(10).if_goto(v(ON).eq(1), alarm_block(ON_ALREADY));
    let limits = [(D, p.axes.work.limit, WORK_TOO_FAST), (Q, p.axes.tool.limit, TOOL_TOO_FAST)];
    for (at, (term, limit, alarm)) in (11..).zip(limits) {
        let most = lathe.limit_at_full_feed(limit).floor();
        b.n(at).if_goto((v(B) * v(term)).abs().gt(real(most, 0)), alarm_block(alarm));
    }
    for argument in [A, E] {
        b.if_then(v(argument).eq(v(0)), argument, 0);
    }
    b.n(20).assign(TURN, 0);
    b.assign(INDEX, 0);
    wait_for(b, IDLE);
    b.n(21).assign(SPEED, v(B));
    b.assign(WORK_RATIO, v(D));
    b.assign(TOOL_RATIO, v(Q));
    b.assign(WORK_ANGLE, (v(A) * 1000).round());
    b.assign(TOOL_ANGLE, (v(E) * 1000).round());
    b.n(22).assign(INDEX, 1).note("TO THE START ANGLES");
    wait_for(b, AT_ANGLE);
    b.n(23).assign(TURN, 1).note("BOTH BEGIN AT ONCE");
    wait_for(b, AT_SPEED);
    b.n(24);
    clear(b, lathe);
    b.words([m(99)]);
    let alarms = [
        (NO_SPEED, "B MUST BE ABOVE ZERO"),
        (NO_WORK_RATIO, "D IS MISSING"),
        (NO_TOOL_RATIO, "Q IS MISSING"),
        (WORK_RATIO_NOT_WHOLE, "D MUST BE A WHOLE NUMBER"),
        (TOOL_RATIO_NOT_WHOLE, "Q MUST BE A WHOLE NUMBER"),
        (ZERO_RATIO, "D AND Q MUST NOT BE ZERO"),
        (NOT_ALONE, "ALONE IN ITS BLOCK PLEASE"),
        (ON_ALREADY, "POLYGON TURNING IS ON ALREADY"),
        (WORK_TOO_FAST, "THE WORK WOULD TURN TOO FAST"),
        (TOOL_TOO_FAST, "THE TOOL WOULD TURN TOO FAST"),
        (LETTER, "ONLY B D Q A E PLEASE"),
        (SPEED_NOT_WHOLE, "B MUST BE A WHOLE NUMBER"),
    ];
    for (number, text) in alarms {
        writing::alarm(b, lathe.control, number, text);
    }
    b.words([m(99)]);
}

/// O9121.
fn stop(b: &mut Builder, lathe: &PolygonLathe) {
    b.program(MACROS[1], "POLYGON TURNING OFF");
    b.comment("RECONSTRUCTED, NOT THE PAPER'S TEXT");
    for arguments in [&OTHERS[..], &UNKNOWN, &[A, B, D, E, Q]] {
        refuse(b, arguments, alarm_block(NOT_ALONE));
    }
    wait_for_slide(b);
    b.n(20).assign(TURN, 0);
    b.assign(INDEX, 0);
    wait_for(b, IDLE);
    b.n(21);
    clear(b, lathe);
    b.words([m(99)]);
    writing::alarm(b, lathe.control, NOT_ALONE, "ALONE IN ITS BLOCK PLEASE");
    b.words([m(99)]);
}

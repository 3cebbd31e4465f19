//! Builder functions that the programs of all machines share: header, opening words, checks of the operator's variables, alarms.

use super::header;
use crate::controls::options::SwitchKind;
use crate::controls::{Address, Code, CodeId, Control, VarKind};
use crate::machines::machine::Machine;
use crate::nc::build::{Builder, Formula, NewWord, g, m, real, v, word};

/// Comments with the version of macroline and the settings of the form.
pub fn write_header<M: Machine>(b: &mut Builder, params: &M::Params, control: &Control) {
    b.comment(&header::version_comment(env!("CARGO_PKG_VERSION")));
    for text in header::lines::<M>(params, control) {
        b.comment(&text);
    }
}

/// Words of the control's codes for these functions; a function that the control lacks is left out.
pub fn codes(control: &Control, wanted: impl IntoIterator<Item = Code>) -> Vec<NewWord> {
    let own = |code: Code| {
        let row = control.codes.iter().find(|row| row.code == code)?;
        match row.id {
            CodeId::G(number) => Some(g(number.integer())),
            CodeId::M(number) => Some(m(number)),
            CodeId::Named(place) => Some(word(Address::Name, u32::from(place))),
        }
    };
    wanted.into_iter().filter_map(own).collect()
}

/// The modal states that a program needs, whatever was in force before it: metric words, plane Z-X, no radius
/// compensation, speed in r/min, the first work offset. With them the same coordinates are the same places when the
/// program is started again after a reset.
pub fn opening(control: &Control) -> Vec<NewWord> {
    use Code::{Cancel, Metric, PlaneZx, SurfaceSpeedOff, WorkCoordinates};
    let cancels = control.codes.iter().any(|row| row.code == Cancel && row.id == CodeId::g(40));
    let mut all = codes(control, [Metric, PlaneZx]);
    all.extend(cancels.then(|| g(40)));
    all.extend(codes(control, [SurfaceSpeedOff, WorkCoordinates(1)]));
    all
}

/// Variable of the first axis's work position, followed by those of the other axes; none if the control has no such variables. Reading one
/// waits for standstill.
pub fn work_position(control: &Control) -> Option<u32> {
    control.vars.iter().find(|row| row.kind == VarKind::WorkPosition).map(|row| row.first)
}

/// The tool with its offset: T and D where the offset has an address of its own, T with both numbers on a lathe (T0101), else T alone.
pub fn tool(control: &Control, number: u32) -> Vec<NewWord> {
    if control.syntax.names().is_some() {
        return vec![word(Address::T, number), word(Address::D, 1)];
    }
    let lathe = control.axes.iter().any(|axis| axis.diameter);
    vec![word(Address::T, if lathe { 101 * number } else { number })]
}

/// Variables of a lathe's work positions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PositionVariables {
    /// Of the position across the work, X.
    pub across: u32,
    /// Of the position along the work, Z.
    pub along: u32,
}

/// Least positions of the slide at which the turret has room to turn.
pub struct TurretRoom {
    /// X beside the work.
    pub beside: Formula,
    /// Z in front of the work.
    pub in_front: Formula,
}

/// Jumps to block `target`, an alarm, if the tool is not clear of the work: X below `clear`, or Z negative (past the
/// face).
pub fn stays_clear(b: &mut Builder, position: PositionVariables, clear: impl Fn() -> Formula, target: u32) {
    b.if_goto(v(position.across).lt(clear()), target);
    b.if_goto(v(position.along).lt(0), target);
}

/// Jumps to block `target`, an alarm, unless the turret has room to turn in front of the work. With room beside the
/// work it goes on at block `next`.
pub fn turret_has_room(b: &mut Builder, position: PositionVariables, room: TurretRoom, next: u32, target: u32) {
    b.if_goto(v(position.across).ge(room.beside), next);
    b.if_goto(v(position.along).lt(room.in_front), target);
}

/// Variables of the work positions of the axes across and along the work, where the program can read them and raise an
/// alarm of its own.
pub fn position_variables(control: &Control, [across, along]: [Address; 2]) -> Option<PositionVariables> {
    let first = work_position(control).filter(|_| has_alarms(control))?;
    let of = |letter| control.axis(letter).map(|at| first + at as u32);
    Some(PositionVariables { across: of(across)?, along: of(along)? })
}

/// A dwell in seconds.
pub fn dwell(control: &Control, seconds: f64) -> [NewWord; 2] {
    dwell_of(control, real(seconds, 3))
}

/// A dwell with a note, in seconds under every unit of the feed. Where the control may count a dwell under feed per
/// revolution in revolutions, it is written under feed per minute; `feed` is the unit in force before and after it.
pub fn wait(b: &mut Builder, control: &Control, feed: Code, seconds: Formula, note: &str) {
    let switches = feed == Code::FeedPerRevolution && may_count_turns(control);
    if switches {
        b.words(codes(control, [Code::FeedPerMinute]));
    }
    b.words(dwell_of(control, seconds)).note(note);
    if switches {
        b.words(codes(control, [Code::FeedPerRevolution]));
    }
}

/// Feed per minute from the start of a program, where the control may count a dwell under the unit of its power-on in revolutions.
pub fn count_seconds(b: &mut Builder, control: &Control) {
    if may_count_turns(control) {
        b.words(codes(control, [Code::FeedPerMinute])).note("DWELLS COUNT SECONDS");
    }
}

/// Whether a setting of the control decides if a dwell under feed per revolution counts revolutions.
fn may_count_turns(control: &Control) -> bool {
    control.switches.iter().any(|switch| matches!(switch.kind, SwitchKind::DwellUnit(_)))
}

/// A dwell of a computed number of seconds: with address X if the control has it for a dwell, else with its first
/// address for seconds.
fn dwell_of(control: &Control, seconds: Formula) -> [NewWord; 2] {
    let addresses = control.syntax.dwell_addresses;
    let address = if addresses.contains(Address::X) { Address::X } else { addresses.first().unwrap_or(Address::X) };
    [g(4), word(address, seconds)]
}

/// A variable of the operator that the program checks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OperatorVariable {
    /// Its number.
    pub number: u32,
    /// Only whole numbers are valid.
    pub is_whole: bool,
    /// Variable to which the program copies the entry before it checks it; from then on the program uses the copy.
    pub copy: Option<u32>,
}

impl OperatorVariable {
    /// A variable for which every number above zero is valid.
    pub const fn any(number: u32) -> OperatorVariable {
        OperatorVariable { number, is_whole: false, copy: None }
    }

    /// A variable for which only whole numbers above zero are valid.
    pub const fn whole(number: u32) -> OperatorVariable {
        OperatorVariable { number, is_whole: true, copy: None }
    }

    /// The variable with a copy: the program checks and uses `copy`.
    pub const fn copied_to(self, copy: u32) -> OperatorVariable {
        OperatorVariable { copy: Some(copy), ..self }
    }

    /// The variable that the program checks.
    fn checked(self) -> u32 {
        self.copy.unwrap_or(self.number)
    }
}

/// Sequence number of the block that raises the alarm with this number, in every program.
pub const fn alarm_block(alarm: u32) -> u32 {
    900 + alarm
}

/// Numbers and variables of the alarms of invalid entries: first of entries not above zero, then of entries that are
/// not whole.
fn entry_alarms(entries: &[OperatorVariable]) -> [Vec<(u32, OperatorVariable)>; 2] {
    let whole = entries.iter().filter(|entry| entry.is_whole);
    let above_zero = (1..).zip(entries.iter().copied()).collect();
    let whole = (entries.len() as u32 + 1..).zip(whole.copied()).collect();
    [above_zero, whole]
}

/// Last block number of the [`guards`]: from the next one on programs number blocks of their own.
const LAST_GUARD: u32 = 15;

/// Checks that every entry, or its copy, is above zero, and whole where required; else jumps to [`alarms`]. Each check up to [`LAST_GUARD`]
/// has the number of its alarm, and is preceded by the copy.
pub fn guards(b: &mut Builder, entries: &[OperatorVariable]) {
    let [above_zero, whole] = entry_alarms(entries);
    for (alarm, entry) in above_zero {
        if alarm <= LAST_GUARD {
            b.n(alarm);
        }
        if let Some(copy) = entry.copy {
            b.assign(copy, v(entry.number));
        }
        b.if_goto(v(entry.checked()).le(0), alarm_block(alarm));
    }
    for (alarm, entry) in whole {
        let value = || v(entry.checked());
        if alarm <= LAST_GUARD {
            b.n(alarm);
        }
        b.if_goto((value() - value().round()).abs().gt(real(0.0001, 4)), alarm_block(alarm));
    }
}

/// The alarms of invalid entries, in the program of the [`guards`]: the first of these is block 1, to which a corrected entry leads back.
pub fn alarms(b: &mut Builder, control: &Control, entries: &[OperatorVariable]) {
    let [above_zero, whole] = entry_alarms(entries);
    for (alarm, entry) in above_zero {
        alarm_until_cleared(b, control, alarm, &format!("{} MUST BE ABOVE ZERO", control.variable(entry.number)), 1);
    }
    for (alarm, entry) in whole {
        alarm_until_cleared(
            b,
            control,
            alarm,
            &format!("{} MUST BE A WHOLE NUMBER", control.variable(entry.number)),
            1,
        );
    }
}

/// Whether a program can raise an alarm of its own.
pub fn has_alarms(control: &Control) -> bool {
    control.vars.iter().any(|row| row.kind == VarKind::AlarmMessage)
}

/// Stops the program with a text: as a user alarm, or, on controls without these, as a message and M0, and `then` after cycle start.
fn stop_with_text(b: &mut Builder, control: &Control, number: u32, text: &str, then: impl FnOnce(&mut Builder)) {
    b.n(alarm_block(number));
    if has_alarms(control) {
        b.alarm(number, text);
    } else {
        b.show(text);
        b.words([m(0)]);
        then(b);
    }
}

/// Stops the program with a text until its cause is gone: after the M0, cycle start goes back to the checks from block
/// `checks` on. The checks see values that the operator sets at M0, because nothing is read ahead of M0.
fn alarm_until_cleared(b: &mut Builder, control: &Control, number: u32, text: &str, checks: u32) {
    stop_with_text(b, control, number, text, |b| {
        let waits = codes(control, [Code::StopReading]);
        if !waits.is_empty() {
            b.words(waits);
        }
        b.end_message();
        b.goto(checks);
    });
}

/// Stops the program with a text, after an M0 in a loop until reset.
pub fn alarm(b: &mut Builder, control: &Control, number: u32, text: &str) {
    stop_with_text(b, control, number, text, |b| {
        b.goto(alarm_block(number));
    });
}

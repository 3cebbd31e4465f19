//! The ladder of the turning spindle: override, M3 to M5, gear change, and the answer to M, S and T.

use super::gears::{GearTimes, gear_times, slowing};
use super::params::Output;
use super::resolved::{CodePair, TurningSpindle};
use super::stops::spindle;
use crate::controls::interface::SignalRole;
use crate::machines::ladder::book::Book;
use crate::machines::ladder::codes::{
    BUSY, DirectionSignal, GEAR_LOST, GEAR_RUN, MESHED, SHIFT_OFF, SLOWED, STARTED, SpindleRequirements, TURNS,
};
use crate::machines::ladder::{Bit, Ladder, MachineContact, MachineOutput, PlcNumber, RungContact, off, on};

/// Relays of the stages, decoded from the number that the control requests.
const WANTED: [Bit; 4] =
    [Bit::Relay("wanted-1"), Bit::Relay("wanted-2"), Bit::Relay("wanted-3"), Bit::Relay("wanted-4")];

/// Output that closes the clamp, output that opens it, and contact of the closed clamp.
const CLAMP: Bit = Bit::Output(MachineOutput::SpindleClamp);
const UNCLAMP: Bit = Bit::Output(MachineOutput::SpindleUnclamp);
const CLAMPED: Bit = Bit::Input(MachineContact::SpindleClamped);
/// The clamp is closing or opening.
const CLAMPING: Bit = Bit::Relay("clamping");

/// The ladder of the lathe.
pub(super) fn ladder(lathe: &TurningSpindle) -> Ladder {
    let mut book = Book::new(lathe.control, &lathe.dialect);
    book.emergency();
    book.program_state();
    book.spindle_override();
    if book.has(SignalRole::FeedOverride) {
        let feed = PlcNumber::Signal(SignalRole::FeedOverride);
        book.copy(PlcNumber::FeedKnob, feed, Book::always(), "turning.ladder.feed");
    }
    let rules = lathe.rules();
    let reaction = |at| spindle(lathe, at);
    let reports_speed = rules.reached.is_some();
    let direction =
        if lathe.params.output == Output::Unipolar { DirectionSignal::Contacts } else { DirectionSignal::Sign };
    let locks = lathe.lock_codes();
    let stages = lathe.params.stages().count().min(WANTED.len());
    // Before the run command: the answer to M3 reads the gears in the same scan.
    if lathe.params.has_several_stages() {
        Gears { book: &mut book, stages: stages as u8, times: gear_times(lathe), slowing: slowing(lathe) }.write();
    }
    book.spindle(
        &rules,
        &SpindleRequirements {
            reaction: &reaction,
            reports_speed,
            reports_standstill: false,
            holds: if lathe.params.tailstock { &[MachineContact::WorkHeld] } else { &[] },
            locked_by: if locks.is_some() { &[CLAMP, CLAMPED] } else { &[] },
            has_gears: lathe.params.has_several_stages(),
            positions: lathe.positions(),
            emergency_holds: false,
            direction,
        },
    );
    let clamps = locks.map(|codes| {
        clamp(&mut book, codes);
        CLAMPING
    });
    if let Some(codes) = lathe.driven_codes() {
        driven_tool(&mut book, codes);
    }
    // The program calls its tool at each start, because the turret may be at another one.
    let turret = book.turret();
    let busy: Vec<Bit> = (stages > 1).then_some(BUSY).into_iter().chain(clamps).chain([turret]).collect();
    book.answer(&busy);
    book.finish()
}

/// The clamp holds the spindle from its lock code to its release code, through a reset with the tool in the keyway; until reset where there is
/// no release code. Each waits for the contact. The valve has a coil for each, so that a power failure opens nothing: after it the release code
/// opens the clamp, too.
fn clamp(book: &mut Book, CodePair { on: lock, off: release }: CodePair) {
    let (reset, locks) = (book.reset(), book.function(lock));
    let opens = release.map_or(reset, |code| book.function(code));
    book.coil(CLAMP, vec![vec![on(locks)], vec![on(CLAMP), off(opens)]], "turning.ladder.clamp");
    let mut opening = vec![on(UNCLAMP), on(CLAMPED), off(locks)];
    opening.extend(release.map(|_| off(reset)));
    book.coil(UNCLAMP, vec![vec![on(opens)], opening], "turning.ladder.unclamp");
    let differs = vec![vec![on(CLAMP), off(CLAMPED)], vec![on(UNCLAMP), on(CLAMPED)]];
    book.coil(CLAMPING, differs, "turning.ladder.clamping");
    book.late(CLAMPING, "clamp-late", MachineContact::SpindleClamped);
}

/// A driven tool with codes of its own runs until its stop code, the program's end, reset or emergency stop.
fn driven_tool(book: &mut Book, CodePair { on: start, off: stop }: CodePair) {
    let run = Bit::Output(MachineOutput::DrivenTool);
    let guard = [on(Bit::Input(MachineContact::Emergency)), off(book.reset())];
    let mut stays = vec![on(run), on(STARTED)];
    stays.extend(stop.map(|code| off(book.function(code))));
    let begins = vec![on(book.function(start))];
    let when = [begins, stays].map(|contacts| [contacts, guard.to_vec()].concat());
    book.coil(run, when.to_vec(), "turning.ladder.driven-tool");
}

/// The rungs of a gear change. It ends only with the contact of the commanded stage. A reset breaks it off while the
/// gears are out of mesh: nothing turns, and the control goes on reading. The next request or run command starts the
/// change again.
struct Gears<'a, 'b> {
    book: &'a mut Book<'b>,
    stages: u8,
    times: GearTimes,
    /// Time (s) for the spindle to slow down before a change.
    slowing: f64,
}

impl Gears<'_, '_> {
    fn all(&self) -> impl Iterator<Item = u8> + use<> {
        1..=self.stages
    }

    /// The signal that asks for a stage: its M function, or the number that the control puts out.
    fn wanted(&self, stage: u8) -> Bit {
        if self.book.has(SignalRole::GearChange) {
            WANTED.get(usize::from(stage) - 1).copied().unwrap_or(WANTED[0])
        } else {
            self.book.function(40 + u32::from(stage))
        }
    }

    /// Contacts that are closed while the valves command a stage: the first one while no valve is on.
    fn commanded(&self, stage: u8) -> Vec<RungContact> {
        match stage {
            1 => (2..=self.stages).map(|other| off(valve(other))).collect(),
            _ => vec![on(valve(stage))],
        }
    }

    /// Branches that hold while the valves command another stage.
    fn out_of(&self, stage: u8) -> Vec<Vec<RungContact>> {
        self.commanded(stage)
            .into_iter()
            .map(|contact| vec![RungContact { opens: !contact.opens, ..contact }])
            .collect()
    }

    fn write(&mut self) {
        if self.book.has(SignalRole::GearChange) {
            self.asked();
        }
        let times = self.times;
        let (out, done, slow) =
            (Bit::Timer("old-gear-out"), Bit::Timer("gear-done"), Bit::Input(MachineContact::AtShiftSpeed));
        self.book.timer("old-gear-out", times.before, vec![vec![on(BUSY)]], "turning.ladder.before");
        let slowed = vec![vec![on(BUSY), on(out), on(slow)], vec![on(SLOWED), on(BUSY)]];
        self.book.coil(SLOWED, slowed, "turning.ladder.slowed");
        for stage in 2..=self.stages {
            let mut stays = vec![on(valve(stage))];
            stays.extend(self.all().filter(|other| *other != stage).map(|other| off(self.wanted(other))));
            let when = vec![vec![on(self.wanted(stage)), on(SLOWED)], vec![on(valve(stage)), off(SLOWED)], stays];
            self.book.coil(valve(stage), when, "turning.ladder.valve");
        }
        // The coil of the first stage, for valves that keep their position without power. Only a change switches it: after a power failure the
        // work may still coast, while the inverter reports that it is slow.
        let first = self.commanded(1);
        let [begins, stays] = [SLOWED, valve(1)].map(|bit| [first.clone(), vec![on(bit)]].concat());
        self.book.coil(valve(1), vec![begins, stays], "turning.ladder.valve-1");
        let in_position = |stage| on(Bit::Input(MachineContact::InGear(stage)));
        let meshed = self.all().map(|stage| [self.commanded(stage), vec![in_position(stage)]].concat()).collect();
        self.book.coil(MESHED, meshed, "turning.ladder.meshed");
        self.book.timer("gear-done", times.after, vec![vec![on(BUSY), on(SLOWED), on(MESHED)]], "turning.ladder.after");
        // After the contacts, which it reads in the same scan.
        self.begin(done);
        self.supervise();
        self.report(done);
    }

    /// A change begins with a request for another stage, and with a request or a run command while the commanded stage is not in position.
    fn begin(&mut self, done: Bit) {
        let mut busy = Vec::new();
        for stage in self.all() {
            let wanted = self.wanted(stage);
            busy.extend(self.out_of(stage).into_iter().map(|branch| [vec![on(wanted)], branch].concat()));
            busy.push(vec![on(wanted), off(MESHED)]);
        }
        busy.extend([3, 4].map(|code| vec![on(self.book.function(code)), off(MESHED)]));
        busy.push(vec![on(BUSY), off(done), off(self.book.reset())]);
        busy.push(vec![on(BUSY), off(done), on(SLOWED), on(MESHED)]);
        self.book.coil(BUSY, busy, "turning.ladder.shift");
    }

    /// The alarm of a gear that is not in position, the voltage of the change, and the release of the run command.
    fn supervise(&mut self) {
        let (slow_late, late) = (Bit::Timer("slow-late"), Bit::Timer("gear-late"));
        let lost = TURNS.map(|turns| vec![on(turns), off(BUSY), off(MESHED)]);
        let stays = vec![on(GEAR_LOST), off(self.book.reset())];
        // Unlocking the emergency stop button starts nothing; a fault of the inverter has its own latch.
        let (button, reset) = (Bit::Input(MachineContact::Emergency), self.book.reset());
        let stopped = vec![vec![on(BUSY), off(button)], vec![on(SHIFT_OFF), off(reset)]];
        self.book.coil(SHIFT_OFF, stopped, "turning.ladder.shift-off");
        self.book.coil(GEAR_LOST, lost.into_iter().chain([stays]).collect(), "turning.ladder.lost");
        let (mut alarm, mut shifts) = (vec![vec![on(GEAR_LOST)]], vec![on(BUSY)]);
        if let Some(patience) = self.times.patience {
            // Reset begins the times anew.
            let slows = vec![vec![on(BUSY), off(SLOWED), off(reset)]];
            self.book.timer("slow-late", self.slowing + patience, slows, "turning.ladder.slow-patience");
            let waits = vec![vec![on(BUSY), on(SLOWED), off(MESHED), off(reset)]];
            self.book.timer("gear-late", patience, waits, "turning.ladder.patience");
            alarm.extend([vec![on(slow_late)], vec![on(late)]]);
            shifts.extend([off(slow_late), off(late)]);
        }
        self.book.coil(Bit::Output(MachineOutput::GearAlarm), alarm, "turning.ladder.late");
        self.book.coil(Bit::Signal(SignalRole::ShiftSpeed), vec![shifts.clone()], "turning.ladder.volts");
        self.book.coil(GEAR_RUN, vec![vec![on(MESHED), off(BUSY)], shifts], "turning.ladder.run");
    }

    /// Decodes the number of the requested stage into one relay a stage.
    fn asked(&mut self) {
        for stage in self.all() {
            let mut when = vec![on(Bit::Signal(SignalRole::GearChange))];
            when.extend(
                (0..3).map(|bit| RungContact {
                    bit: Bit::Signal(SignalRole::GearAsked(bit)),
                    opens: stage >> bit & 1 == 0,
                }),
            );
            self.book.coil(self.wanted(stage), vec![when], "turning.ladder.wanted");
        }
    }

    /// Reports the commanded stage to the control, which takes it over with FIN; FIN waits for the contact. A contact
    /// that opens during a cut must not change the reported stage, and with it the voltage for the same speed.
    fn report(&mut self, done: Bit) {
        for less in [1, 0] {
            let role = |bit| if less == 1 { SignalRole::GearIndex(bit) } else { SignalRole::GearNumber(bit) };
            for bit in 0..3 {
                let with_bit = |stage: &u8| (stage - less) >> bit & 1 == 1;
                if !self.book.has(role(bit)) || !self.all().any(|stage| with_bit(&stage)) {
                    continue;
                }
                let when = self.all().filter(with_bit).map(|stage| self.commanded(stage)).collect();
                self.book.coil(Bit::Signal(role(bit)), when, "turning.ladder.stage");
            }
        }
        let changed = Bit::Signal(SignalRole::GearChanged);
        if self.book.has(SignalRole::GearChanged) {
            let stays = vec![on(changed), on(Bit::Signal(SignalRole::GearChange))];
            let begins = vec![on(done), on(Bit::Signal(SignalRole::GearChange))];
            self.book.coil(changed, vec![begins, stays], "turning.ladder.changed");
        }
    }
}

fn valve(stage: u8) -> Bit {
    Bit::Output(MachineOutput::Gear(stage))
}

//! Rungs that every machine with an inverter spindle needs: run command, stops, and the answer to M, S and T.

use super::book::Book;
use super::{
    Bit, Branches, MachineContact, MachineOutput, Operator, PLACES, PlcNumber, PlcWidth, RungContact, off, on,
};
use crate::controls::SpindleRules;
use crate::controls::interface::SignalRole;
use crate::machines::stops::{Interruption, SpindleReaction};

/// A program has started and has not ended.
pub const STARTED: Bit = Bit::Relay("started");
/// A program has started and is not running: hold, M00, alarm.
pub const INTERRUPTED: Bit = Bit::Relay("interrupted");
/// The spindle turns clockwise, or counter-clockwise, by a code or a key; with both off it has no run command.
pub const TURNS: [Bit; 2] = [Bit::Relay("clockwise"), Bit::Relay("counter-clockwise")];
/// The stop key has stopped the spindle of a begun program: cycle start is refused.
pub const STOPPED: Bit = Bit::Relay("stopped");
/// A T function waits for the turret, on a control whose T function is a pulse.
const TOOL_ASKED: Bit = Bit::Relay("tool-asked");
/// The turret has not answered.
const TOOL_WAITS: Bit = Bit::Relay("tool-waits");
/// The inverter has reported a fault: no run command and no program until reset.
const FAULT: Bit = Bit::Relay("inverter-fault");
/// M, S or T has to wait.
pub const BUSY: Bit = Bit::Relay("busy");
/// The spindle has slowed down to the shift speed; stays on until the end of the gear change.
pub const SLOWED: Bit = Bit::Relay("slowed");
/// The commanded gear stage is in position.
pub const MESHED: Bit = Bit::Relay("meshed");
/// The gears allow a run command: in position, or changed at the shift voltage.
pub const GEAR_RUN: Bit = Bit::Relay("gear-run");
/// The commanded stage has left its position while the spindle turned: no program until reset.
pub const GEAR_LOST: Bit = Bit::Relay("gear-lost");
/// An emergency stop has ended the run of a gear change, until reset.
pub const SHIFT_OFF: Bit = Bit::Relay("shift-off");
/// Nothing forbids a run command.
const FREE: Bit = Bit::Relay("spindle-free");
/// Contacts without which the spindle has no run command: the enable of its inverter, and the work that a tailstock holds.
const NEEDED: [MachineContact; 2] = [MachineContact::InverterEnabled, MachineContact::WorkHeld];
/// No contact of the machine forbids a run by the key of each direction.
const KEYS_FREE: [Bit; 2] = [Bit::Relay("forward-key-free"), Bit::Relay("reverse-key-free")];
/// Contacts that open at the end of each direction: unwinding fills the loop and empties the reel, winding back pulls the web tight. The other
/// direction leads back.
const ENDS: [&[MachineContact]; 2] =
    [&[MachineContact::LoopNotFull, MachineContact::ReelNotEmpty], &[MachineContact::WebNotTight]];
/// Keys of the directions.
const KEYS: [MachineContact; 2] = [MachineContact::ForwardKey, MachineContact::ReverseKey];
/// On for one scan after the end of the program.
const ENDED: Bit = Bit::Relay("ended");

/// Time (s) that turret and clamp have to answer before the operator gets a message: several times their own time.
/// Source: engineering choice.
const PATIENCE: f64 = 10.0;

/// Requirements of a machine for its spindle.
#[derive(Clone, Copy)]
pub struct SpindleRequirements<'a> {
    /// Reaction of the spindle to each interruption.
    pub reaction: &'a dyn Fn(Interruption) -> SpindleReaction,
    /// The inverter reports that the speed is reached.
    pub reports_speed: bool,
    /// A contact reports that the spindle stands still: keys start it only then.
    pub reports_standstill: bool,
    /// Contacts that hold the program while they are open, beside the fault contact of the inverter. Without one of [`NEEDED`] the inverter
    /// also loses its run command, and a begun program stops with the alarm: nothing restarts by itself.
    pub holds: &'a [MachineContact],
    /// While this is on, the inverter gets no run command: another drive turns the spindle.
    pub locked_by: &'a [Bit],
    /// The spindle has gear stages: their contacts release run command and keys.
    pub has_gears: bool,
    /// The program turns the spindle to an angle.
    pub positions: bool,
    /// The emergency stop reaches the control delayed: until then its button holds the program.
    pub emergency_holds: bool,
    /// Direction of the inverter.
    pub direction: DirectionSignal,
}

/// How the inverter gets its direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DirectionSignal {
    /// By two run contacts, one for each direction.
    Contacts,
    /// By the sign of the voltage, with one run contact.
    Sign,
}

impl Book<'_> {
    /// Reset as the ladder sees it: the control's signal, or the key that the PLC hands to the control.
    pub fn reset(&self) -> Bit {
        let request = SignalRole::ResetRequest;
        Bit::Signal(if self.has(request) { request } else { SignalRole::Reset })
    }

    /// Emergency stop to the control, and reset if the PLC passes it on.
    pub fn emergency(&mut self) {
        self.emergency_by(MachineContact::Emergency);
    }

    /// The same by this contact: at once, or delayed until the drives stand.
    pub fn emergency_by(&mut self, contact: MachineContact) {
        let reset = self.reset();
        if self.has(SignalRole::ResetRequest) {
            self.coil(reset, vec![vec![on(Bit::Input(MachineContact::ResetKey))]], "plc.rung.reset-key");
        }
        let pressed = Bit::Input(contact);
        self.one_of(
            (SignalRole::EmergencyReleased, vec![vec![on(pressed)]]),
            (SignalRole::EmergencyRequest, vec![vec![off(pressed)]]),
            "plc.rung.emergency",
        );
        // Without it the alarm of the emergency stop outlasts the reset.
        let acknowledge = SignalRole::EmergencyAcknowledge;
        if self.has(acknowledge) {
            let when = vec![vec![on(Bit::Input(MachineContact::ResetKey)), on(pressed)]];
            self.coil(Bit::Signal(acknowledge), when, "plc.rung.emergency-acknowledge");
        }
    }

    /// A control that takes the percentage of the spindle override only with a signal beside it gets that signal always.
    pub fn override_valid(&mut self) {
        for (signal, note) in [
            (SignalRole::SpindleOverrideValid, "plc.rung.override-valid"),
            (SignalRole::SpindleOverrideByRegister, "plc.rung.override-register"),
        ] {
            if self.has(signal) {
                self.coil(Bit::Signal(signal), Book::always(), note);
            }
        }
    }

    /// Relays for a started program and for its interruption.
    pub fn program_state(&mut self) {
        let reset = self.reset();
        let (running, idle) = (Bit::Signal(SignalRole::Running), Bit::Signal(SignalRole::Idle));
        let over = if self.has(SignalRole::Idle) {
            off(idle)
        } else {
            // M30 goes off before "running" does; without this relay "running" would set the latch again.
            let (ending, end) = (Bit::Relay("ending"), Bit::Signal(SignalRole::ProgramEnd));
            self.coil(ending, vec![vec![on(end)], vec![on(ending), on(running)]], "plc.rung.ending");
            off(ending)
        };
        let begun = |first: Bit| vec![on(first), over, off(reset)];
        self.coil(STARTED, vec![begun(running), begun(STARTED)], "plc.rung.started");
        self.coil(INTERRUPTED, vec![vec![on(STARTED), off(running)]], "plc.rung.interrupted");
    }

    /// Writes the first signal if the control has it, else the second.
    fn one_of(&mut self, first: (SignalRole, Branches), second: (SignalRole, Branches), note: &'static str) {
        for (role, when) in [first, second] {
            if self.has(role) {
                self.coil(Bit::Signal(role), when, note);
                return;
            }
        }
    }

    /// The knob of the spindle override to the control.
    pub fn spindle_override(&mut self) {
        if self.has(SignalRole::SpindleOverrideCode) {
            self.override_code(0.0);
        } else {
            let register = PlcNumber::Signal(SignalRole::SpindleOverride);
            self.copy(PlcNumber::Knob, register, Book::always(), "turning.ladder.override");
        }
        self.override_valid();
    }

    /// The knob as the code of its nearest position from `lowest` (%) on, at most the highest; returns the knob in tens of percent.
    pub fn override_code(&mut self, lowest: f64) -> PlcNumber {
        let [half, tens] = ["half", "tens"].map(PlcNumber::Data);
        self.compute(
            Operator::Add,
            [PlcNumber::Knob, PlcNumber::Constant(5), half],
            PlcWidth::Word,
            "plc.rung.override-half",
        );
        self.compute(Operator::Divide, [half, PlcNumber::Constant(10), tens], PlcWidth::Word, "plc.rung.override-tens");
        let rules = self.spindle_rules();
        let code = override_table(&rules, lowest, |at| rules.override_codes.get(at).copied().unwrap_or(0));
        self.convert(tens, PlcNumber::Signal(SignalRole::SpindleOverrideCode), code, "plc.rung.override-code");
        tens
    }

    /// The percentage that belongs to the code of [`override_code`](Book::override_code), from the same tens.
    pub fn override_of_code(&mut self, tens: PlcNumber, lowest: f64) -> PlcNumber {
        let (percent, knob) = (PlcNumber::Data("percent"), self.spindle_rules().knob);
        let table = override_table(&self.spindle_rules(), lowest, |at| (knob.low + knob.step * at as f64) as u8);
        self.convert(tens, percent, table, "plc.rung.override-percent");
        percent
    }

    /// M3, M4, M5 and the keys to the inverter, its fault, and the reactions of the spindle to interruptions.
    pub fn spindle(&mut self, rules: &SpindleRules, requirements: &SpindleRequirements<'_>) {
        let ready = Bit::Input(MachineContact::InverterReady);
        let needed = requirements.holds.iter().filter(|contact| NEEDED.contains(contact)).map(|at| Bit::Input(*at));
        let mut fault = vec![vec![off(ready)]];
        // If the lost contact only held the program, cycle start would move the axes without the spindle.
        fault.extend(needed.clone().map(|contact| vec![off(contact), on(STARTED)]));
        // It stays until reset: a fault that clears itself has already stopped the spindle.
        fault.push(vec![on(FAULT), off(self.reset())]);
        self.coil(FAULT, fault, "plc.rung.inverter-fault");
        self.coil(Bit::Output(MachineOutput::InverterAlarm), vec![vec![on(FAULT)]], "plc.rung.inverter-alarm");
        let mut guard: Vec<RungContact> = vec![on(Bit::Input(MachineContact::Emergency)), on(ready)];
        guard.extend(needed.map(on));
        guard.extend(requirements.locked_by.iter().copied().map(off));
        guard.extend(requirements.has_gears.then_some(on(GEAR_RUN)));
        if (requirements.reaction)(Interruption::Reset) == SpindleReaction::Off {
            guard.push(off(self.reset()));
        }
        if rules.end_stops {
            let was = Bit::Relay("was-started");
            self.coil(ENDED, vec![vec![on(was), off(STARTED)]], "plc.rung.ended");
            self.coil(was, vec![vec![on(STARTED)]], "plc.rung.was-started");
            guard.push(off(ENDED));
        }
        let free = if requirements.has_gears { "plc.rung.spindle-free-gears" } else { "plc.rung.spindle-free" };
        self.coil(FREE, vec![guard], free);
        self.directions(rules, requirements);
        self.run_commands(requirements);
        self.hold_program(ready, requirements);
        if requirements.reports_speed && self.has(SignalRole::SpeedArrived) {
            let still = TURNS.map(off).to_vec();
            let arrived = vec![vec![on(Bit::Input(MachineContact::AtSpeed))], still];
            self.coil(Bit::Signal(SignalRole::SpeedArrived), arrived, "plc.rung.speed-arrived");
        }
        let waits = Interruption::LASTING.iter().any(|at| (requirements.reaction)(*at) == SpindleReaction::Waits);
        let stop = if waits { INTERRUPTED } else { FAULT };
        self.one_of(
            (SignalRole::SpindleEnable, vec![vec![off(stop)]]),
            (SignalRole::SpindleHold, vec![vec![on(stop)]]),
            if waits { "plc.rung.spindle-waits" } else { "plc.rung.spindle-fault" },
        );
    }

    /// The direction by M3, M4, M5 and the keys. Keys start a spindle without a run command, and at standstill where that is reported, while no
    /// program is begun; the stop key leaves the direction of a begun program.
    fn directions(&mut self, rules: &SpindleRules, requirements: &SpindleRequirements<'_>) {
        let [m3, m4, m5] = [3, 4, 5].map(|code| self.function(code));
        let [forward, reverse] = TURNS;
        if rules.stop_between {
            let reversed = vec![vec![on(m3), on(reverse)], vec![on(m4), on(forward)]];
            self.coil(Bit::Output(MachineOutput::ReversalAlarm), reversed, "plc.rung.reversal");
        }
        let stop = on(Bit::Input(MachineContact::StopKey));
        // Without a program no hold acts: the contacts themselves stop a spindle that runs by its key.
        let notes = ["plc.rung.forward-key-free", "plc.rung.reverse-key-free"];
        let mut contacts = [None; 2];
        for (((ends, free), note), contact) in ENDS.into_iter().zip(KEYS_FREE).zip(notes).zip(&mut contacts) {
            let has = requirements.holds.iter().filter(|contact| ends.contains(contact));
            let closed: Vec<RungContact> = has.map(|contact| on(Bit::Input(*contact))).collect();
            if !closed.is_empty() {
                self.coil(free, vec![closed], note);
                *contact = Some(on(free));
            }
        }
        let [forward_key, reverse_key] = KEYS.map(Bit::Input);
        let sides = [
            (forward, m3, forward_key, reverse, m4, reverse_key, "plc.rung.forward"),
            (reverse, m4, reverse_key, forward, m3, forward_key, "plc.rung.reverse"),
        ];
        for ((turns, code, own_key, other, other_code, other_key, note), contacts) in sides.into_iter().zip(contacts) {
            let mut by_code = vec![on(code), on(FREE)];
            let mut keeps = vec![on(turns), on(FREE), off(m5)];
            if rules.stop_between {
                by_code.push(off(other));
            } else {
                keeps.push(off(other_code));
            }
            let mut by_key = vec![on(own_key), on(FREE), off(other_key), stop, off(other), off(STARTED)];
            by_key.extend(requirements.reports_standstill.then_some(on(Bit::Input(MachineContact::AtStandstill))));
            by_key.extend(requirements.has_gears.then_some(on(MESHED)));
            by_key.extend(contacts);
            // A reset after the stop key starts nothing.
            let alone = [keeps.as_slice(), &[stop, off(STOPPED)], contacts.as_slice()].concat();
            keeps.push(on(STARTED));
            self.coil(turns, vec![by_code, by_key, alone, keeps], note);
        }
    }

    /// The direction to the inverter. In a begun program the stop key acts while the program is interrupted, until the key of the direction
    /// starts the spindle again. A position loop needs its run command without M3; it commands both directions, which only the sign gives.
    fn run_commands(&mut self, requirements: &SpindleRequirements<'_>) {
        let stop = off(Bit::Input(MachineContact::StopKey));
        let sides = TURNS.into_iter().zip(KEYS.map(Bit::Input));
        let stopped = sides.flat_map(|(turns, key)| {
            [vec![on(turns), on(INTERRUPTED), stop], vec![on(turns), on(STARTED), on(STOPPED), off(key)]]
        });
        self.coil(STOPPED, stopped.collect(), "plc.rung.stopped");
        let message = Bit::Output(MachineOutput::Message(MachineContact::StopKey));
        self.coil(message, vec![vec![on(STOPPED)]], "plc.rung.stopped-message");
        let runs = TURNS.map(|turns| vec![on(turns), off(STOPPED)]);
        let shift = if requirements.has_gears { Book::shift_runs(requirements.direction) } else { Vec::new() };
        if requirements.direction == DirectionSignal::Sign {
            let loops = requirements.positions && self.has(SignalRole::SpindlePositions);
            let angle = loops.then(|| vec![on(Bit::Signal(SignalRole::SpindlePositions)), on(FREE)]);
            let note = match (loops, requirements.has_gears) {
                (true, true) => "plc.rung.run-position-or-shift",
                (true, false) => "plc.rung.run-or-position",
                (false, true) => "plc.rung.run-or-shift",
                (false, false) => "plc.rung.run",
            };
            self.coil(Bit::Output(MachineOutput::Run), runs.into_iter().chain(angle).chain(shift).collect(), note);
            return;
        }
        let [forward, reverse] = runs;
        let note = if shift.is_empty() { "plc.rung.run-forward" } else { "plc.rung.run-forward-or-shift" };
        self.coil(Bit::Output(MachineOutput::Forward), [forward].into_iter().chain(shift).collect(), note);
        self.coil(Bit::Output(MachineOutput::Reverse), vec![reverse], "plc.rung.run-reverse");
    }

    /// Branches of the run command while gears mesh, also without M3 and M4: at standstill tooth may meet tooth. Only a
    /// spindle that has slowed down gets the command, in a begun program, and only without a run command of the other
    /// direction. After an emergency stop or a fault it stays off until reset. A stop key acts in an interrupted
    /// program, as elsewhere.
    fn shift_runs(direction: DirectionSignal) -> Branches {
        let shift = Bit::Signal(SignalRole::ShiftSpeed);
        let mut guard = vec![on(shift), on(SLOWED), on(FREE), on(STARTED), off(STOPPED), off(FAULT), off(SHIFT_OFF)];
        guard.extend((direction == DirectionSignal::Contacts).then_some(off(TURNS[1])));
        [off(INTERRUPTED), on(Bit::Input(MachineContact::StopKey))]
            .map(|last| guard.iter().copied().chain([last]).collect())
            .into()
    }

    /// Holds the program at the operator's key, while the inverter reports a fault, after one until reset, while the spindle of a begun program
    /// is stopped by its key, after a gear was lost until reset, and while one of the contacts is open, with a text for each contact that stays until the program
    /// runs again or reset is pressed.
    fn hold_program(&mut self, ready: Bit, requirements: &SpindleRequirements<'_>) {
        let contacts = requirements.holds;
        let button = requirements.emergency_holds.then_some(Bit::Input(MachineContact::Emergency));
        let inputs = contacts.iter().copied().map(Bit::Input);
        let key = Bit::Input(MachineContact::HoldKey);
        let all: Vec<Bit> = [key, ready].into_iter().chain(button).chain(inputs).collect();
        let causes: Vec<Bit> =
            [FAULT, STOPPED].into_iter().chain(requirements.has_gears.then_some(GEAR_LOST)).collect();
        let free = all.iter().copied().map(on).chain(causes.iter().copied().map(off)).collect();
        let held = all.iter().map(|contact| vec![off(*contact)]);
        let held = held.chain(causes.iter().map(|cause| vec![on(*cause)]));
        let note = match (requirements.has_gears, contacts.is_empty()) {
            (true, _) => "plc.rung.gears-hold",
            (false, true) => "plc.rung.inverter-hold",
            (false, false) => "plc.rung.contacts-hold",
        };
        let (free, held) = ((SignalRole::HoldReleased, vec![free]), (SignalRole::HoldRequest, held.collect()));
        self.one_of(free, held, note);
        let (running, reset) = (Bit::Signal(SignalRole::Running), self.reset());
        for contact in contacts {
            let message = Bit::Output(MachineOutput::Message(*contact));
            let stays = vec![on(message), off(running), off(reset)];
            self.coil(message, vec![vec![off(Bit::Input(*contact))], stays], "plc.rung.message");
        }
    }

    /// Holds the axes of the program while the condition holds.
    pub fn hold_axes(&mut self, held: Branches, free: Branches, note: &'static str) {
        self.one_of((SignalRole::AxesEnable, free), (SignalRole::AxesStop, held), note);
    }

    /// T to the turret's controller, which reads the number itself: start signal, its answer, both off again. A stale answer starts nothing and
    /// answers nothing. Returns the signal that is on while T waits.
    pub fn turret(&mut self) -> Bit {
        let (start, there) = (Bit::Output(MachineOutput::TurretStart), Bit::Input(MachineContact::TurretInPosition));
        let is_pulse = self.has(SignalRole::TFunction);
        let asked = if is_pulse { TOOL_ASKED } else { Bit::Signal(SignalRole::TStrobe) };
        if is_pulse {
            let reset = self.reset();
            let button = on(Bit::Input(MachineContact::Emergency));
            let waits = [off(start), off(there)].map(|open| vec![on(TOOL_ASKED), open, off(reset), button]);
            let begins = vec![on(Bit::Signal(SignalRole::TFunction))];
            self.coil(TOOL_ASKED, [begins].into_iter().chain(waits).collect(), "plc.rung.tool-asked");
        }
        self.coil(start, vec![vec![on(asked), off(there)], vec![on(asked), on(start)]], "plc.rung.turret-start");
        let waits = [off(start), off(there)].map(|open| vec![on(asked), open]);
        self.coil(TOOL_WAITS, waits.to_vec(), "plc.rung.tool-waits");
        self.late(TOOL_WAITS, "turret-late", MachineContact::TurretInPosition);
        TOOL_WAITS
    }

    /// A message to the operator once the program has waited [`PATIENCE`] for a contact: nothing else shows why it
    /// waits.
    pub fn late(&mut self, waits: Bit, timer: &'static str, contact: MachineContact) {
        self.timer(timer, PATIENCE, vec![vec![on(waits)]], "plc.rung.late");
        let message = Bit::Output(MachineOutput::Message(contact));
        self.coil(message, vec![vec![on(Bit::Timer(timer))]], "plc.rung.late-message");
    }

    /// One coil answers M, S and T: at once, or when none of these signals is on any more. Without FIN the next block waits.
    pub fn answer(&mut self, busy: &[Bit]) {
        if self.has(SignalRole::Finished) {
            let strobes = [SignalRole::MStrobe, SignalRole::SStrobe, SignalRole::TStrobe];
            let branch = |role: SignalRole| {
                let mut contacts = vec![on(Bit::Signal(role))];
                contacts.extend(busy.iter().copied().map(off));
                contacts
            };
            self.coil(Bit::Signal(SignalRole::Finished), strobes.map(branch).to_vec(), "plc.rung.finished");
        } else if !busy.is_empty() {
            let waits = busy.iter().map(|bit| vec![on(*bit)]).collect();
            self.coil(Bit::Signal(SignalRole::ReadInDisable), waits, "plc.rung.read-in");
        }
    }
}

/// A table by tens of percent: the entry of the knob's position that is nearest to each, from `lowest` (%) on.
fn override_table(rules: &SpindleRules, lowest: f64, entry: impl Fn(usize) -> u8) -> [u8; PLACES] {
    let knob = &rules.knob;
    let position = |tens: usize| knob.nearest((10.0 * tens as f64).max(lowest));
    core::array::from_fn(|tens| entry(((position(tens) - knob.low) / knob.step) as usize))
}

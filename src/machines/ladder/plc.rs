//! The simulated PLC: a ladder, connected to the simulated control and to the contacts of the machine.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::codes::{SLOWED, STOPPED, TURNS};
use super::scan::Image;
use super::{Bit, Ladder, MachineContact, MachineOutput, PlcNumber};
use crate::controls::interface::SignalRole;
use crate::controls::{Control, SpindleRules};
use crate::drives::Rotation;
use crate::drives::speed::{self, KnobRange};
use crate::motion::{Plc, PlcAlarm, PlcOrders, PlcSignals, ProgramState, Strobes};

/// Least time (s) from a code to the end of its block: strobe, a few scans, and the width of FIN.
pub const ANSWER: f64 = 0.05;
/// Interval (s) at which contacts that follow the measured speed are read while a rung waits for them.
const LOOK_INTERVAL: f64 = 0.01;
/// Scans in which a ladder settles; further ones wait for the next moment.
const MOST_SCANS: u32 = 24;
/// Contacts that follow the measured speed.
const BY_SPEED: [Bit; 3] = [
    Bit::Input(MachineContact::AtSpeed),
    Bit::Input(MachineContact::AtShiftSpeed),
    Bit::Input(MachineContact::AtStandstill),
];
/// Run commands of the inverter.
const RUNS: [MachineOutput; 3] = [MachineOutput::Forward, MachineOutput::Reverse, MachineOutput::Run];
/// Speed (r/min) up to which the standstill monitor closes its contact.
const STANDSTILL: f64 = 0.5;
/// Contacts that follow the movers of the machine: closed until [switched](LadderPlc::switch).
pub const BY_MOVERS: [MachineContact; 3] =
    [MachineContact::LoopNotFull, MachineContact::WebNotTight, MachineContact::ReelNotEmpty];
/// The speed that the control puts out.
const FINAL: PlcNumber = PlcNumber::Signal(SignalRole::SpindleFinal);

/// The machine that the ladder is wired to.
#[derive(Debug, Clone, Copy)]
pub struct Wiring {
    /// Positions of the spindle override knob.
    pub knob: KnobRange,
    /// Rules of the control's spindle: the codes that it takes for an override.
    pub rules: SpindleRules,
    /// Share of the commanded speed from which the inverter reports the speed as reached.
    pub at_speed: f64,
    /// Time (s) from the valve of a gear stage to its contact.
    pub meshing: f64,
    /// Volts while gears mesh.
    pub shift_volts: f64,
    /// Speed (r/min) in each gear stage up to which the contact "shift speed or slower" is closed.
    pub shift_speeds: [f64; speed::STAGES],
}

impl Wiring {
    /// Speed (r/min) in the engaged stage up to which the gears may shift.
    fn shift_speed(&self, stage: u8) -> f64 {
        self.shift_speeds.get(usize::from(stage.max(1)) - 1).copied().unwrap_or(0.0)
    }
}

/// A named block of the ladder: a function whose instruction is not known.
pub trait NamedBlock: Send + Sync {
    /// Acts at time `t` on the signals of the image that bear its name; returns when it wants to act again at the latest.
    fn act(&mut self, t: f64, image: &mut Image, signals: &PlcSignals, orders: &mut PlcOrders) -> Option<f64>;
    /// A copy with all its state.
    fn boxed(&self) -> Box<dyn NamedBlock>;
}

impl Clone for Box<dyn NamedBlock> {
    fn clone(&self) -> Box<dyn NamedBlock> {
        self.boxed()
    }
}

/// A ladder as the PLC of a run.
#[derive(Clone)]
pub struct LadderPlc {
    ladder: Ladder,
    wiring: Wiring,
    block: Option<Box<dyn NamedBlock>>,
    /// Signals that contacts of rungs name: all others need no state.
    named: Arc<[Bit]>,
    /// Gear stages whose valves rungs drive.
    valves: Arc<[u8]>,
    /// Macro bits that rungs drive, each with its word and its place in it.
    written: Arc<[(u32, u32, u32)]>,
    /// Whether a rung reads the speed that the control puts out.
    reads_speed: bool,
    image: Image,
    /// Whether one more scan of the same signals would change nothing.
    settled: bool,
    /// The last scan, if a ladder without a named block has settled in it.
    last_scan: Option<Box<LastScan>>,
    /// When the next timer of the image closes its contact (s).
    due: Option<f64>,
    /// Whether a rung waits for a contact that follows the measured speed.
    waits_for_speed: bool,
    strobes: Strobes,
    program: ProgramState,
    /// M code of the last scan.
    code: Option<u32>,
    /// T code of the last scan.
    tool: Option<u32>,
    /// The stage whose valve is on, and since when.
    gear: (u8, f64),
}

/// A scan after which nothing changes by itself.
#[derive(Clone)]
struct LastScan {
    signals: PlcSignals,
    orders: PlcOrders,
    /// Time (s) of the next scan if none of them changes.
    again: Option<f64>,
}

impl LadderPlc {
    /// The PLC at power-on.
    pub fn new(ladder: Ladder, wiring: Wiring, control: &Control) -> LadderPlc {
        let place = |coil: &Bit| match *coil {
            Bit::Macro(variable) => {
                let (word, bit) = control.word_of_bit(variable)?;
                Some((variable, word, bit))
            }
            _ => None,
        };
        let written = ladder.coils.iter().filter_map(place).collect();
        let contacts = ladder.rungs.iter().flat_map(|rung| rung.when.iter().flatten());
        let named: BTreeSet<Bit> = contacts.map(|contact| contact.bit).collect();
        let named = named.into_iter().collect();
        let valves =
            (2..=speed::STAGES as u8).filter(|stage| ladder.drives(Bit::Output(MachineOutput::Gear(*stage)))).collect();
        let reads_speed = !ladder.word(FINAL).is_empty();
        let mut image = Image::default();
        BY_MOVERS.into_iter().for_each(|contact| image.set(Bit::Input(contact), true));
        LadderPlc {
            ladder,
            wiring,
            block: None,
            named,
            valves,
            written,
            reads_speed,
            image,
            settled: false,
            last_scan: None,
            due: None,
            waits_for_speed: false,
            strobes: Strobes::default(),
            program: ProgramState::Idle,
            code: None,
            tool: None,
            gear: (1, f64::NEG_INFINITY),
        }
    }

    /// Adds a named block.
    pub fn with_block(self, block: Box<dyn NamedBlock>) -> LadderPlc {
        LadderPlc { block: Some(block), ..self }
    }

    /// Switches a contact that follows the movers; returns whether its state has changed.
    pub fn switch(&mut self, contact: MachineContact, closed: bool) -> bool {
        let bit = Bit::Input(contact);
        let changes = self.image.is_on(bit) != closed;
        if changes {
            self.image.set(bit, closed);
            (self.settled, self.last_scan) = (false, None);
        }
        changes
    }

    /// Reads control, keys and contacts.
    fn read(&mut self, t: f64, signals: &PlcSignals, orders: &PlcOrders) {
        for bit in self.named.iter() {
            if let Some(on) = self.state(*bit, signals, orders) {
                self.image.set(*bit, on);
            }
        }
        let image = &mut self.image;
        image.put(PlcNumber::Signal(SignalRole::MCode), signals.m_strobe.map_or(0.0, f64::from));
        // Read only by ladders that use it: constant surface speed changes it in every scan.
        if self.reads_speed {
            image.put(FINAL, final_speed(signals));
        }
        image.put(PlcNumber::Knob, self.wiring.knob.nearest(signals.knobs.spindle));
        image.put(PlcNumber::FeedKnob, signals.knobs.feed);
        for (&variable, &value) in &signals.macro_outputs {
            image.set(Bit::Macro(variable), value != 0.0);
            image.put(PlcNumber::Signal(SignalRole::MacroOutput(variable)), value);
        }
        self.contacts(t);
        (self.program, self.code, self.tool) = (signals.program_state, signals.m_strobe, signals.t_strobe);
    }

    /// State of a signal that control, keys or contacts of the machine switch.
    fn state(&self, bit: Bit, signals: &PlcSignals, orders: &PlcOrders) -> Option<bool> {
        Some(match bit {
            Bit::Signal(SignalRole::Running) => signals.program_state == ProgramState::Running,
            Bit::Signal(SignalRole::Idle) => signals.program_state == ProgramState::Idle,
            Bit::Signal(SignalRole::ProgramEnd) => {
                signals.program_state == ProgramState::Idle && self.program == ProgramState::Running && !signals.reset
            }
            Bit::Signal(SignalRole::Alarm) => signals.program_state == ProgramState::Alarm,
            Bit::Signal(SignalRole::Reset) => signals.reset,
            // The control resets itself at an emergency stop, without the reset key.
            Bit::Input(MachineContact::ResetKey) => signals.reset && !signals.emergency,
            Bit::Signal(SignalRole::MStrobe) => signals.m_strobe.is_some(),
            Bit::Signal(SignalRole::SStrobe) => signals.s_strobe.is_some(),
            Bit::Signal(SignalRole::TStrobe) => signals.t_strobe.is_some(),
            Bit::Signal(SignalRole::TFunction) => signals.t_strobe.is_some() && self.tool != signals.t_strobe,
            Bit::Signal(SignalRole::MFunction(code)) => signals.m_strobe == Some(code) && self.code != Some(code),
            Bit::Signal(SignalRole::GearChange) => signals.waiting_gear(orders.spindle).is_some(),
            Bit::Signal(SignalRole::GearAsked(at)) => {
                signals.gear_wanted.is_some_and(|stage| u32::from(stage) >> at & 1 == 1)
            }
            Bit::Input(MachineContact::Emergency | MachineContact::EmergencyDelayed) => {
                !(signals.reset && signals.emergency)
            }
            Bit::Input(MachineContact::InverterReady | MachineContact::InverterEnabled) => !signals.inverter_fault,
            Bit::Input(MachineContact::AtSpeed) => {
                let command = signals.spindle_command.abs() * (1.0 + signals.speed_trim);
                signals.spindle_actual.abs() >= self.wiring.at_speed * command
            }
            Bit::Input(MachineContact::AtShiftSpeed) => {
                signals.spindle_actual.abs() <= self.wiring.shift_speed(self.gear.0)
            }
            Bit::Input(MachineContact::AtStandstill) => signals.spindle_actual.abs() <= STANDSTILL,
            Bit::Signal(SignalRole::SpindlePositions) => signals.positions,
            Bit::Input(MachineContact::ForwardKey) => signals.spindle_key == Some(Rotation::Clockwise),
            Bit::Input(MachineContact::ReverseKey) => signals.spindle_key == Some(Rotation::CounterClockwise),
            Bit::Input(MachineContact::StopKey) => signals.spindle_key != Some(Rotation::Stopped),
            Bit::Input(MachineContact::HoldKey) => !signals.hold_key,
            // Assumed: the operator clamps the work before the start of the program.
            Bit::Input(MachineContact::WorkHeld) => true,
            _ => return None,
        })
    }

    /// Contacts of the gear stages, and those of clamp and turret, which follow their outputs at once.
    fn contacts(&mut self, t: f64) {
        let is_on = |stage: &u8| self.image.is_on(Bit::Output(MachineOutput::Gear(*stage)));
        let stage = self.valves.iter().copied().find(is_on).unwrap_or(1);
        let runs = RUNS.into_iter().any(|run| self.image.is_on(Bit::Output(run)));
        // At standstill tooth may meet tooth: gears mesh while the spindle turns.
        let waits = !runs && t < self.gear.1 + self.wiring.meshing;
        if stage != self.gear.0 || waits {
            self.gear = (stage, t);
        }
        for bit in self.named.iter() {
            match bit {
                Bit::Input(MachineContact::InGear(stage)) => {
                    let meshed = *stage == self.gear.0 && t >= self.gear.1 + self.wiring.meshing;
                    self.image.set(*bit, meshed);
                }
                Bit::Input(MachineContact::SpindleClamped) => {
                    let is_on = |coil| self.image.is_on(Bit::Output(coil));
                    let kept = !is_on(MachineOutput::SpindleUnclamp) && self.image.is_on(*bit);
                    let clamped = is_on(MachineOutput::SpindleClamp) || kept;
                    self.image.set(*bit, clamped);
                }
                Bit::Input(MachineContact::TurretInPosition) => {
                    let started = self.image.is_on(Bit::Output(MachineOutput::TurretStart));
                    self.image.set(*bit, started);
                }
                _ => {}
            }
        }
    }

    /// Ends the signals that last for one scan.
    fn end_pulses(&mut self) {
        for bit in self.named.iter() {
            match bit {
                Bit::Signal(
                    SignalRole::ProgramEnd | SignalRole::Reset | SignalRole::TFunction | SignalRole::MFunction(_),
                )
                | Bit::Input(MachineContact::ResetKey | MachineContact::ForwardKey | MachineContact::ReverseKey) => {
                    self.image.set(*bit, false)
                }
                Bit::Input(MachineContact::Emergency | MachineContact::EmergencyDelayed | MachineContact::StopKey) => {
                    self.image.set(*bit, true)
                }
                _ => {}
            }
        }
    }

    /// Hands the coils to control and machine.
    fn write(&mut self, t: f64, signals: &PlcSignals, orders: &mut PlcOrders, alarms: [bool; 2]) {
        let (ladder, image) = (&self.ladder, &self.image);
        let coil = |bit: Bit| ladder.drives(bit).then(|| image.is_on(bit));
        let signal = |role: SignalRole| coil(Bit::Signal(role));
        let output = |output: MachineOutput| coil(Bit::Output(output));
        let runs = RUNS.into_iter().filter_map(output).reduce(|a, b| a || b);
        let spindle = [signal(SignalRole::SpindleEnable), signal(SignalRole::SpindleHold).map(|held| !held), runs];
        orders.spindle.held = spindle.into_iter().flatten().any(|on| !on);
        let turns_to_mesh = image.is_on(SLOWED) && runs == Some(true);
        orders.shift_rotation = if turns_to_mesh { Rotation::Clockwise } else { Rotation::Stopped };
        let directions = TURNS.iter().all(|turns| ladder.drives(*turns));
        orders.run_contacts =
            directions.then(|| match TURNS.map(|turns| image.is_on(turns) && !image.is_on(STOPPED)) {
                [true, false] => Rotation::Clockwise,
                [false, true] => Rotation::CounterClockwise,
                _ => Rotation::Stopped,
            });
        let axes = [signal(SignalRole::AxesEnable), signal(SignalRole::AxesStop).map(|held| !held)];
        orders.axes_held = axes.into_iter().flatten().any(|on| !on);
        orders.program_held =
            signal(SignalRole::HoldReleased) == Some(false) || signal(SignalRole::HoldRequest) == Some(true);
        // An override that is not valid is 100 %, but 0 % stops the axes all the same.
        let invalid = signal(SignalRole::FeedOverrideValid) == Some(false) && signals.knobs.feed > 0.0;
        orders.feed_override_off = invalid || signal(SignalRole::FeedOverrideOff).unwrap_or(false);
        for rung in ladder.rungs.iter() {
            match rung.written() {
                Some(word @ PlcNumber::Signal(SignalRole::SpindleOverride)) => {
                    orders.spindle.percent = image.number(word)
                }
                // The control keeps its override at a code that it does not know.
                Some(word @ PlcNumber::Signal(SignalRole::SpindleOverrideCode)) => {
                    let known = self.wiring.rules.override_of_code(image.number(word));
                    orders.spindle.percent = known.unwrap_or(orders.spindle.percent);
                }
                Some(word @ PlcNumber::Signal(SignalRole::MacroInputLow(variable))) => {
                    orders.macro_inputs.insert(variable, image.number(word));
                }
                _ => {}
            }
        }
        for (_, word, _) in self.written.iter() {
            orders.macro_inputs.insert(*word, 0.0);
        }
        for (variable, word, bit) in self.written.iter() {
            if image.is_on(Bit::Macro(*variable)) {
                *orders.macro_inputs.entry(*word).or_insert(0.0) += f64::from(1_u32 << bit);
            }
        }
        orders.spindle.gear = self.gear.0;
        orders.spindle.shift_volts = signal(SignalRole::ShiftSpeed).filter(|on| *on).map(|_| self.wiring.shift_volts);
        let raised = [
            (MachineOutput::ReversalAlarm, PlcAlarm::SpindleReversal),
            (MachineOutput::GearAlarm, PlcAlarm::GearTimeout),
        ];
        for ((alarm, kind), before) in raised.into_iter().zip(alarms) {
            if image.is_on(Bit::Output(alarm)) && !before {
                orders.alarm = Some(kind);
            }
        }
        // The alarm lasts as long as the fault: reset and cycle start raise it again.
        if image.is_on(Bit::Output(MachineOutput::InverterAlarm)) && signals.program_state != ProgramState::Alarm {
            orders.alarm = Some(PlcAlarm::InverterFault);
        }
        let since = self.strobes.since(t, signals, orders);
        let answered = signal(SignalRole::Finished).unwrap_or(true) && signal(SignalRole::ReadInDisable) != Some(true);
        orders.fin = since.is_some_and(|since| answered && t >= since + ANSWER);
    }

    /// The next moment at which something happens by itself.
    fn again(&mut self, t: f64, signals: &PlcSignals, orders: &mut PlcOrders) -> Option<f64> {
        let since = self.strobes.since(t, signals, orders).map(|since| since + ANSWER).filter(|due| *due > t);
        let meshed = Some(self.gear.1 + self.wiring.meshing).filter(|due| *due > t);
        let look = self.waits_for_speed.then_some(t + LOOK_INTERVAL);
        [since, meshed, look, self.due].into_iter().flatten().reduce(f64::min)
    }

    /// Whether a scan at `t` would change nothing: the signals are those of the last scan, and none of its times is due. Speeds may differ
    /// if the ladder reads the same values.
    fn rests(&mut self, t: f64, signals: &PlcSignals, orders: &PlcOrders) -> bool {
        let Some(last) = &mut self.last_scan else { return false };
        let seen = &mut last.signals;
        (seen.spindle_actual, seen.spindle_command) = (signals.spindle_actual, signals.spindle_command);
        seen.speed_trim = signals.speed_trim;
        last.again.is_none_or(|again| t < again)
            && *seen == *signals
            && last.orders == *orders
            && BY_SPEED.into_iter().all(|contact| {
                self.named.binary_search(&contact).is_err()
                    || self.state(contact, signals, orders) == Some(self.image.is_on(contact))
            })
            && (!self.reads_speed || self.image.number(FINAL) == final_speed(signals))
    }

    /// Notes the times that the present image waits for.
    fn note_waits(&mut self) {
        let arrived = Bit::Signal(SignalRole::SpeedArrived);
        self.due = self.ladder.due(&self.image);
        self.waits_for_speed = BY_SPEED
            .into_iter()
            .any(|contact| !self.image.is_on(contact) && self.ladder.waits_for(&self.image, contact, arrived));
    }
}

/// Commanded speed (r/min) of the control, as the PLC reads it.
fn final_speed(signals: &PlcSignals) -> f64 {
    signals.spindle_command.abs().round()
}

impl Plc for LadderPlc {
    fn scan(&mut self, t: f64, signals: &PlcSignals, orders: &mut PlcOrders) -> Option<f64> {
        if self.rests(t, signals, orders) {
            return self.last_scan.as_ref().and_then(|last| last.again);
        }
        self.image.take_changed();
        self.read(t, signals, orders);
        let changed = self.image.take_changed();
        let alarms =
            [MachineOutput::ReversalAlarm, MachineOutput::GearAlarm].map(|alarm| self.image.is_on(Bit::Output(alarm)));
        let mut wish = None;
        let due = self.due.is_some_and(|due| due <= t);
        if !self.settled || changed || due || self.block.is_some() {
            self.settled = (0..MOST_SCANS).any(|_| {
                self.ladder.scan(t, &mut self.image);
                self.end_pulses();
                self.contacts(t);
                if let Some(block) = &mut self.block {
                    wish = block.act(t, &mut self.image, signals, orders);
                }
                !self.image.take_changed()
            });
            self.note_waits();
        }
        self.write(t, signals, orders, alarms);
        let again = [wish, self.again(t, signals, orders)].into_iter().flatten().reduce(f64::min);
        let rests = self.settled && self.block.is_none();
        self.last_scan = rests.then(|| Box::new(LastScan { signals: signals.clone(), orders: orders.clone(), again }));
        again
    }

    fn watches_inverter(&self) -> bool {
        self.ladder.drives(Bit::Output(MachineOutput::InverterAlarm))
    }

    fn reads_hold_key(&self) -> bool {
        self.named.binary_search(&Bit::Input(MachineContact::HoldKey)).is_ok()
    }

    fn boxed(&self) -> Box<dyn Plc> {
        Box::new(self.clone())
    }
}

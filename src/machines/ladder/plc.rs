//! The simulated PLC: a ladder, connected to the simulated control and to the contacts of the machine.

use super::scan::Image;
use super::{Bit, Ladder, MachineContact, MachineOutput, PlcNumber, RungAction};
use crate::controls::interface::SignalRole;
use crate::controls::{Alarm, Control};
use crate::drives::speed::Steps;
use crate::motion::{Io, Plc, ProgramState, Strobes};

/// Time (s) from a code to the end of its block, at the least: strobe, a few scans, and the width of FIN.
pub const ANSWER: f64 = 0.05;
/// Time (s) between two looks at the inverter's contact while a rung waits for it.
const LOOK: f64 = 0.01;
/// Scans in which a ladder comes to rest; more are left for the next moment.
const SCANS: u32 = 24;
/// Stages that a gear box has at most.
const STAGES: u8 = 8;

/// The machine that the ladder is wired to.
#[derive(Debug, Clone, Copy)]
pub struct Wiring {
    /// Positions of the spindle override knob.
    pub knob: Steps,
    /// Share of the commanded speed from which the inverter reports it.
    pub at_speed: f64,
    /// Time (s) from the valve of a gear stage to its contact.
    pub meshing: f64,
    /// Volts while gears mesh.
    pub shift_volts: f64,
}

/// A named block of the ladder: a function whose instruction is not known.
pub trait NamedBlock: Send + Sync {
    /// Acts at time `t` on the signals of the image that bear its name; returns when it wants to act again at the latest.
    fn act(&mut self, t: f64, image: &mut Image, io: &mut Io) -> Option<f64>;
    /// A copy with all its state.
    fn boxed(&self) -> Box<dyn NamedBlock>;
}

/// A ladder as the PLC of a run.
pub struct LadderPlc {
    ladder: Ladder,
    wiring: Wiring,
    block: Option<Box<dyn NamedBlock>>,
    /// Macro bits that rungs drive, each with its word and its place in it.
    written: Vec<(u32, u32, u32)>,
    /// Whether a rung reads the speed that the control puts out.
    reads_speed: bool,
    image: Image,
    /// Whether one more scan of the same signals would change nothing.
    settled: bool,
    strobes: Strobes,
    program: ProgramState,
    /// M code of the last scan.
    code: Option<u32>,
    /// The stage whose valve is on, and since when.
    gear: (u8, f64),
}

impl LadderPlc {
    /// The PLC at power-on.
    pub fn new(ladder: Ladder, wiring: Wiring, control: &Control) -> LadderPlc {
        let place = |rung: &super::Rung| match rung.action {
            RungAction::Coil(Bit::Macro(variable)) => {
                let (word, bit) = control.word_of_bit(variable)?;
                Some((variable, word, bit))
            }
            _ => None,
        };
        let written = ladder.rungs.iter().filter_map(place).collect();
        let reads_speed = !ladder.word(PlcNumber::Signal(SignalRole::SpindleFinal)).is_empty();
        LadderPlc {
            ladder,
            wiring,
            block: None,
            written,
            reads_speed,
            image: Image::default(),
            settled: false,
            strobes: Strobes::default(),
            program: ProgramState::Idle,
            code: None,
            gear: (1, f64::NEG_INFINITY),
        }
    }

    /// The same with a named block.
    pub fn with_block(self, block: Box<dyn NamedBlock>) -> LadderPlc {
        LadderPlc { block: Some(block), ..self }
    }

    /// Reads control, keys and contacts.
    fn read(&mut self, t: f64, io: &Io) {
        let (image, stops) = (&mut self.image, &io.stops);
        let ended = stops.program == ProgramState::Idle && self.program == ProgramState::Running && !stops.reset;
        let at_speed = io.spindle_actual.abs() >= self.wiring.at_speed * io.spindle_command.abs();
        let fresh = io.m_strobe.filter(|_| io.m_strobe != self.code);
        let signals = [
            (SignalRole::Running, stops.program == ProgramState::Running),
            (SignalRole::Idle, stops.program == ProgramState::Idle),
            (SignalRole::ProgramEnd, ended),
            (SignalRole::Reset, stops.reset),
            (SignalRole::MStrobe, io.m_strobe.is_some()),
            (SignalRole::SStrobe, io.s_strobe.is_some()),
            (SignalRole::TStrobe, io.t_strobe.is_some()),
            (SignalRole::GearChange, io.gear_wanted.is_some_and(|stage| stage != io.gear || io.gear_volts.is_some())),
        ];
        signals.into_iter().for_each(|(role, on)| image.set(Bit::Signal(role), on));
        for code in [3, 4, 5] {
            image.set(Bit::Signal(SignalRole::MFunction(code)), fresh == Some(code));
        }
        for bit in 0..3 {
            let on = io.gear_wanted.is_some_and(|stage| stage >> bit & 1 == 1);
            image.set(Bit::Signal(SignalRole::GearAsked(bit)), on);
        }
        let inputs = [
            (MachineContact::Emergency, !(stops.reset && stops.emergency)),
            (MachineContact::ResetKey, stops.reset),
            (MachineContact::InverterReady, !stops.inverter_fault),
            (MachineContact::AtSpeed, at_speed),
            (MachineContact::ForwardKey, stops.spindle_key == Some(1)),
            (MachineContact::ReverseKey, stops.spindle_key == Some(-1)),
            (MachineContact::StopKey, stops.spindle_key == Some(0)),
        ];
        inputs.into_iter().for_each(|(input, on)| image.set(Bit::Input(input), on));
        image.put(PlcNumber::Signal(SignalRole::MCode), io.m_strobe.map_or(0.0, f64::from));
        // It changes all the time under constant surface speed: only for ladders that read it.
        if self.reads_speed {
            image.put(PlcNumber::Signal(SignalRole::SpindleFinal), io.spindle_command.abs().round());
        }
        image.put(PlcNumber::Knob, self.wiring.knob.nearest(io.spindle_override));
        image.put(PlcNumber::FeedKnob, io.feed_override);
        for (&variable, &value) in &io.outputs {
            image.set(Bit::Macro(variable), value != 0.0);
            image.put(PlcNumber::Signal(SignalRole::MacroOutput(variable)), value);
        }
        self.contacts(t);
        (self.program, self.code) = (stops.program, io.m_strobe);
    }

    /// Contacts of the gear stages.
    fn contacts(&mut self, t: f64) {
        let stage = (2..=STAGES).find(|stage| self.image.is_on(Bit::Output(MachineOutput::Gear(*stage)))).unwrap_or(1);
        if stage != self.gear.0 {
            self.gear = (stage, t);
        }
        for stage in 1..=STAGES {
            let meshed = stage == self.gear.0 && t >= self.gear.1 + self.wiring.meshing;
            self.image.set(Bit::Input(MachineContact::InGear(stage)), meshed);
        }
    }

    /// Signals that last for one scan.
    fn fall(&mut self) {
        let signals = [SignalRole::ProgramEnd, SignalRole::Reset].into_iter();
        for role in signals.chain([3, 4, 5].map(SignalRole::MFunction)) {
            self.image.set(Bit::Signal(role), false);
        }
        for input in
            [MachineContact::ResetKey, MachineContact::ForwardKey, MachineContact::ReverseKey, MachineContact::StopKey]
        {
            self.image.set(Bit::Input(input), false);
        }
        self.image.set(Bit::Input(MachineContact::Emergency), true);
    }

    /// Hands the coils to control and machine.
    fn write(&mut self, t: f64, io: &mut Io, alarms: [bool; 2]) {
        let (ladder, image) = (&self.ladder, &self.image);
        let coil = |bit: Bit| ladder.drives(bit).then(|| image.is_on(bit));
        let signal = |role: SignalRole| coil(Bit::Signal(role));
        let output = |output: MachineOutput| coil(Bit::Output(output));
        let runs =
            [MachineOutput::Forward, MachineOutput::Reverse].into_iter().filter_map(output).reduce(|a, b| a || b);
        let spindle = [signal(SignalRole::SpindleEnable), signal(SignalRole::SpindleHold).map(|held| !held), runs];
        io.stops.spindle = spindle.into_iter().flatten().any(|on| !on);
        let axes = [signal(SignalRole::AxesEnable), signal(SignalRole::AxesStop).map(|held| !held)];
        io.stops.axes = axes.into_iter().flatten().any(|on| !on);
        for rung in ladder.rungs.iter() {
            match rung.written() {
                Some(word @ PlcNumber::Signal(SignalRole::SpindleOverride)) => {
                    io.spindle_override_out = image.number(word)
                }
                // Tens of percent.
                Some(word @ PlcNumber::Signal(SignalRole::SpindleOverrideCode)) => {
                    io.spindle_override_out = 10.0 * image.number(word);
                }
                Some(word @ PlcNumber::Signal(SignalRole::MacroInputLow(variable))) => {
                    io.inputs.insert(variable, image.number(word));
                }
                _ => {}
            }
        }
        for (_, word, _) in &self.written {
            io.inputs.insert(*word, 0.0);
        }
        for (variable, word, bit) in &self.written {
            if image.is_on(Bit::Macro(*variable)) {
                *io.inputs.entry(*word).or_insert(0.0) += f64::from(1_u32 << bit);
            }
        }
        io.gear = self.gear.0;
        io.gear_volts = output(MachineOutput::ShiftVolts).filter(|on| *on).map(|_| self.wiring.shift_volts);
        let raised =
            [(MachineOutput::ReversalAlarm, Alarm::SpindleReversal), (MachineOutput::GearAlarm, Alarm::GearTimeout)];
        for ((alarm, kind), before) in raised.into_iter().zip(alarms) {
            if image.is_on(Bit::Output(alarm)) && !before {
                io.alarm = Some(kind);
            }
        }
        // It stays as long as the fault does: reset and cycle start lead to it again.
        if image.is_on(Bit::Output(MachineOutput::InverterAlarm)) && io.stops.program != ProgramState::Alarm {
            io.alarm = Some(Alarm::InverterFault);
        }
        let since = self.strobes.since(t, io);
        let answered = signal(SignalRole::Finished).unwrap_or(true) && signal(SignalRole::ReadInDisable) != Some(true);
        io.fin = since.is_some_and(|since| answered && t >= since + ANSWER);
    }

    /// The next moment at which something happens by itself.
    fn again(&mut self, t: f64, io: &mut Io) -> Option<f64> {
        let since = self.strobes.since(t, io).map(|since| since + ANSWER).filter(|due| *due > t);
        let meshed = Some(self.gear.1 + self.wiring.meshing).filter(|due| *due > t);
        let (speed, arrived) = (Bit::Input(MachineContact::AtSpeed), Bit::Signal(SignalRole::SpeedArrived));
        let looks = !self.image.is_on(speed) && self.ladder.waits_for(&self.image, speed, arrived);
        let look = looks.then_some(t + LOOK);
        [since, meshed, look, self.ladder.due(&self.image)].into_iter().flatten().reduce(f64::min)
    }
}

impl Plc for LadderPlc {
    fn scan(&mut self, t: f64, io: &mut Io) -> Option<f64> {
        let rest = self.image.clone();
        self.read(t, io);
        let alarms =
            [MachineOutput::ReversalAlarm, MachineOutput::GearAlarm].map(|alarm| self.image.is_on(Bit::Output(alarm)));
        let mut wish = None;
        let due = self.ladder.due(&self.image).is_some_and(|due| due <= t);
        if !self.settled || self.image != rest || due || self.block.is_some() {
            self.settled = (0..SCANS).any(|_| {
                let before = self.image.clone();
                self.ladder.scan(t, &mut self.image);
                self.fall();
                self.contacts(t);
                if let Some(block) = &mut self.block {
                    wish = block.act(t, &mut self.image, io);
                }
                self.image == before
            });
        }
        self.write(t, io, alarms);
        [wish, self.again(t, io)].into_iter().flatten().reduce(f64::min)
    }

    fn watches_inverter(&self) -> bool {
        self.ladder.drives(Bit::Output(MachineOutput::InverterAlarm))
    }

    fn boxed(&self) -> Box<dyn Plc> {
        Box::new(LadderPlc {
            ladder: self.ladder.clone(),
            wiring: self.wiring,
            block: self.block.as_ref().map(|block| block.boxed()),
            written: self.written.clone(),
            reads_speed: self.reads_speed,
            image: self.image.clone(),
            settled: self.settled,
            strobes: self.strobes.clone(),
            program: self.program,
            code: self.code,
            gear: self.gear,
        })
    }
}

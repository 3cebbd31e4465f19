//! Writing a ladder for a control: rungs with typed signals, and the devices that carry them on its PLC.

use std::collections::{BTreeMap, BTreeSet};

use super::{
    Bit, Branches, DECODED, Device, Ladder, MachineContact, MachineOutput, Operator, PLACES, PlcNumber, PlcSide,
    PlcWidth, Rung, RungAction, off, on,
};
use crate::controls::interface::{PlcLanguage, SignalRole};
use crate::controls::{Control, Dialect, SpindleRules, VarKind};
use crate::text::{Citation, Grade};

/// Source of devices that the machine's builder chooses.
const BUILDER: Citation = Citation::new("devices of the ladder: the builder's", Grade::Open);
/// The relay that is always on.
const ALWAYS: Bit = Bit::Relay("always");

/// The last M function with a bit of its own, on controls that have such bits. Source: V25001012.3, SINUMERIK 802S/C start-up, 6.2.
pub const LAST_FUNCTION_BIT: u32 = 99;

/// Signals or numbers with their devices.
type Carried<T> = Vec<(T, Device)>;

/// Source of a signal or a number.
#[derive(Debug, Clone, Copy)]
enum Driver {
    /// A rung of the ladder.
    Ladder,
    /// The machine, the control, its program or a block of its maker.
    Other,
}

impl Driver {
    fn of<T: Ord>(driven: &BTreeSet<T>, carried: &T) -> Driver {
        if driven.contains(carried) { Driver::Ladder } else { Driver::Other }
    }

    /// Writer and reader of a signal that the PLC shares with the side `other`.
    fn sides(self, other: PlcSide) -> (PlcSide, PlcSide) {
        match self {
            Driver::Ladder => (PlcSide::Plc, other),
            Driver::Other => (other, PlcSide::Plc),
        }
    }
}

/// A ladder while it is written.
#[derive(Debug)]
pub struct Book<'a> {
    control: &'a Control,
    dialect: &'a Dialect,
    rungs: Vec<Rung>,
    bit_meanings: BTreeMap<Bit, (&'static str, Citation)>,
    word_meanings: BTreeMap<PlcNumber, (&'static str, Citation)>,
}

impl<'a> Book<'a> {
    /// An empty ladder for a control.
    pub fn new(control: &'a Control, dialect: &'a Dialect) -> Book<'a> {
        Book { control, dialect, rungs: Vec::new(), bit_meanings: BTreeMap::new(), word_meanings: BTreeMap::new() }
    }

    /// Whether the control has a signal.
    pub fn has(&self, role: SignalRole) -> bool {
        self.dialect.device(self.control, role).is_some()
    }

    /// The condition that always holds.
    pub fn always() -> Branches {
        vec![vec![on(ALWAYS)]]
    }

    /// The condition that never holds.
    pub fn never() -> Branches {
        vec![vec![off(ALWAYS)]]
    }

    /// Sets the meaning (catalog id) of a signal on this machine, with its source.
    pub fn means(&mut self, bit: Bit, meaning: &'static str, cite: Citation) {
        self.bit_meanings.insert(bit, (meaning, cite));
    }

    /// Sets the source of an input; its meaning is the same on every machine.
    pub fn cite_input(&mut self, input: MachineContact, cite: Citation) {
        self.means(Bit::Input(input), input_meaning(input), cite);
    }

    /// Sets the meaning (catalog id) of a PLC number on this machine, with its source.
    pub fn means_number(&mut self, word: PlcNumber, meaning: &'static str, cite: Citation) {
        self.word_meanings.insert(word, (meaning, cite));
    }

    fn rung(&mut self, when: Branches, action: RungAction, note: &'static str) {
        self.rungs.push(Rung { when, action, note });
    }

    /// A coil.
    pub fn coil(&mut self, bit: Bit, when: Branches, note: &'static str) {
        self.rung(when, RungAction::Coil(bit), note);
    }

    /// A timer of `seconds`, rounded up to the unit of the PLC's timers.
    pub fn timer(&mut self, name: &'static str, seconds: f64, when: Branches, note: &'static str) {
        let unit = self.control.plc.timer_unit();
        // Whole units stay whole beside the rounding of binary fractions.
        let units = (seconds * 1000.0 / f64::from(unit) - 1e-6).ceil().max(0.0);
        self.rung(when, RungAction::Timer(name, units as u32 * unit), note);
    }

    /// Copies a number while the condition holds.
    pub fn copy(&mut self, from: PlcNumber, to: PlcNumber, when: Branches, note: &'static str) {
        self.rung(when, RungAction::Move { from, to, width: PlcWidth::Word }, note);
    }

    /// Copies a number of two registers.
    pub fn copy_double(&mut self, from: PlcNumber, to: PlcNumber, when: Branches, note: &'static str) {
        self.rung(when, RungAction::Move { from, to, width: PlcWidth::DoubleWord }, note);
    }

    /// Computes a number in every scan.
    pub fn compute(
        &mut self,
        operator: Operator,
        [left, right, to]: [PlcNumber; 3],
        width: PlcWidth,
        note: &'static str,
    ) {
        self.rung(Book::always(), RungAction::Compute { operator, left, right, to, width }, note);
    }

    /// Compares a number with a constant in every scan.
    pub fn below(&mut self, number: PlcNumber, than: i32, coil: Bit, note: &'static str) {
        self.rung(Book::always(), RungAction::Below { number, than, coil }, note);
    }

    /// Copies in every scan the entry of a table at the place of a number.
    pub fn convert(&mut self, from: PlcNumber, to: PlcNumber, table: [u8; PLACES], note: &'static str) {
        self.rung(Book::always(), RungAction::Convert { from, to, table }, note);
    }

    /// Rules of the control's spindle.
    pub fn spindle_rules(&self) -> SpindleRules {
        self.dialect.spindle()
    }

    /// The signal of an M function: the control's own, or the decoded number while the strobe is on.
    pub fn function(&self, code: u32) -> Bit {
        match self.function_bit(code) {
            Some(_) => Bit::Signal(SignalRole::MFunction(code)),
            None => Bit::Decoded(code),
        }
    }

    /// The bit of an M function on a control that has one bit per function: eight functions to a byte, by their
    /// numbers, counted from a function that has a row.
    fn function_bit(&self, code: u32) -> Option<(String, Citation)> {
        let rows = self.control.interface.iter();
        let (known, row) = rows.rev().find_map(|row| match row.role {
            SignalRole::MFunction(known) if known <= code => Some((known, row)),
            _ => None,
        })?;
        let (byte, _) = row.device.split_once('.')?;
        let (letter, byte) = byte.split_at_checked(1)?;
        let byte = byte.parse::<u32>().ok()? + code / DECODED - known / DECODED;
        Some((format!("{letter}{byte}.{}", code % DECODED), row.cite))
    }

    /// The ladder, with the rungs that other rungs depend on before them.
    pub fn finish(mut self) -> Ladder {
        let used: BTreeSet<Bit> = self.rungs.iter().flat_map(Rung::bits).collect();
        let mut first = Vec::new();
        if self.rungs.iter().flat_map(|rung| rung.when.iter().flatten()).any(|contact| contact.bit == ALWAYS) {
            let when = vec![vec![on(ALWAYS)], vec![off(ALWAYS)]];
            first.push(Rung { when, action: RungAction::Coil(ALWAYS), note: "plc.rung.always" });
        }
        let mut decoded = None;
        for bit in &used {
            if let Bit::Decoded(function) = *bit
                && decoded.is_none_or(|first| function >= first + DECODED)
            {
                decoded = Some(function);
                let when = vec![vec![on(Bit::Signal(SignalRole::MStrobe))]];
                first.push(Rung { when, action: RungAction::Decode { first: function }, note: "plc.rung.decode" });
            }
        }
        first.append(&mut self.rungs);
        let rungs = first;
        let coils: BTreeSet<Bit> = rungs.iter().filter_map(Rung::coil).collect();
        let (bits, words) = self.devices(&rungs, &coils);
        let (coils, language) = (coils.into_iter().collect(), self.control.plc);
        Ladder { rungs: rungs.into(), language, coils, bits: bits.into(), words: words.into() }
    }

    fn devices(&self, rungs: &[Rung], coils: &BTreeSet<Bit>) -> (Carried<Bit>, Carried<PlcNumber>) {
        let bits: BTreeSet<Bit> = rungs.iter().flat_map(Rung::bits).collect();
        let written: BTreeSet<PlcNumber> = rungs.iter().filter_map(Rung::written).collect();
        let words: BTreeSet<PlcNumber> = rungs.iter().flat_map(Rung::read).chain(written.iter().copied()).collect();
        let places = Places::new(&bits, &words);
        let bits = bits.iter().map(|bit| {
            let device = self.bit(*bit, Driver::of(coils, bit), &places);
            let (meaning, cite) = self.bit_meanings.get(bit).copied().unwrap_or((device.meaning, device.cite));
            (*bit, Device { meaning, cite, ..device })
        });
        let bits = bits.collect();
        let constant = |word: &&PlcNumber| !matches!(word, PlcNumber::Constant(_));
        let words = words.iter().filter(constant);
        let words = words.map(|word| {
            let device = self.word(*word, Driver::of(&written, word), &places);
            let (meaning, cite) = self.word_meanings.get(word).copied().unwrap_or((device.meaning, device.cite));
            (*word, Device { meaning, cite, ..device })
        });
        let words = words.collect();
        (bits, words)
    }

    fn bit(&self, bit: Bit, by: Driver, places: &Places) -> Device {
        let language = self.control.plc;
        let open = |name: String, sides, meaning| Device {
            name,
            variable: String::new(),
            sides,
            unit: "",
            meaning,
            contact: None,
            cite: BUILDER,
        };
        match bit {
            Bit::Signal(role) => self.signal(role, by),
            Bit::Macro(variable) => {
                let device = open(self.macro_bit(variable), by.sides(PlcSide::Program), "");
                Device { variable: format!("#{variable}"), ..device }
            }
            Bit::Decoded(_) | Bit::Relay(_) | Bit::Timer(_) => {
                open(internal_device(language, bit, places), (PlcSide::Plc, PlcSide::Plc), "")
            }
            Bit::Input(input) => {
                let sides = (PlcSide::Machine, PlcSide::Plc);
                let device = open(input_device(language, input, places), sides, input_meaning(input));
                Device { contact: Some(input.kind()), ..device }
            }
            Bit::Output(output) => {
                let number = places.outputs.get(&output).copied().unwrap_or(0);
                let (name, reader) = if output.is_message() {
                    (message_device(language, number), PlcSide::Control)
                } else {
                    (output_device(language, number), PlcSide::Machine)
                };
                open(name, (PlcSide::Plc, reader), output_meaning(output))
            }
            Bit::Device(name) => open(name.to_owned(), (PlcSide::Plc, PlcSide::Control), ""),
            Bit::Block(name) => open(name.to_owned(), by.sides(PlcSide::Block), ""),
        }
    }

    fn word(&self, word: PlcNumber, by: Driver, places: &Places) -> Device {
        let language = self.control.plc;
        let open = |name: String, sides, unit, meaning| Device {
            name,
            variable: String::new(),
            sides,
            unit,
            meaning,
            contact: None,
            cite: BUILDER,
        };
        match word {
            PlcNumber::Signal(role) => {
                let device = self.signal(role, by);
                Device { unit: self.unit(role), ..device }
            }
            PlcNumber::Knob => open(data_device(language, 0), (PlcSide::Machine, PlcSide::Plc), "%", "plc.signal.knob"),
            PlcNumber::FeedKnob => {
                open(data_device(language, 1), (PlcSide::Machine, PlcSide::Plc), "%", "plc.signal.feed-knob")
            }
            PlcNumber::Data(_) => open(
                data_device(language, places.data.get(&word).copied().unwrap_or(0)),
                (PlcSide::Plc, PlcSide::Plc),
                "",
                "",
            ),
            PlcNumber::Constant(_) => open(String::new(), (PlcSide::Plc, PlcSide::Plc), "", ""),
            PlcNumber::Block(name) => open(name.to_owned(), (PlcSide::Plc, PlcSide::Block), "", ""),
        }
    }

    /// Device of a signal of the control: its row, or the register of a macro variable that has no row.
    fn signal(&self, role: SignalRole, by: Driver) -> Device {
        let variable = match role {
            SignalRole::MacroInputLow(number)
            | SignalRole::MacroInputHigh(number)
            | SignalRole::MacroOutput(number) => Some(number),
            _ => None,
        };
        let other = if variable.is_some() { PlcSide::Program } else { PlcSide::Control };
        let known = match role {
            SignalRole::MFunction(code) => self.function_bit(code),
            _ => self.dialect.device(self.control, role),
        };
        let (name, cite) = match known {
            Some(known) => known,
            None => (variable.map_or_else(String::new, |variable| self.register(variable, by)), BUILDER),
        };
        Device {
            name,
            variable: variable.map_or_else(String::new, |number| format!("#{number}")),
            sides: by.sides(other),
            unit: "",
            meaning: role_meaning(role),
            contact: None,
            cite,
        }
    }

    fn unit(&self, role: SignalRole) -> &'static str {
        let row = self.control.interface.iter().find(|row| row.role == role);
        row.map_or("", |row| if ["word", "4 bytes", "code"].contains(&row.unit) { "" } else { row.unit })
    }

    /// Register of a macro variable by the range that it is in: `G` as the program reads it, `F` as it writes it.
    fn register(&self, variable: u32, by: Driver) -> String {
        let letter = match by {
            Driver::Ladder => 'G',
            Driver::Other => 'F',
        };
        let range = self.control.var(variable).filter(|range| range.kind == VarKind::ExchangeWord);
        let number = range.and_then(|range| {
            let first: u32 = range.device.get(1..)?.parse().ok()?;
            Some(first + variable - range.first)
        });
        number.map_or_else(|| format!("#{variable}"), |number| format!("{letter}{number}"))
    }

    /// Bit of a macro variable in the byte of its word.
    fn macro_bit(&self, variable: u32) -> String {
        let found = self.control.word_of_bit(variable).and_then(|(word, bit)| {
            let device = self.control.var(word)?.device;
            let (letter, number) = device.split_at_checked(1)?;
            Some(format!("{letter}{}.{}", number.parse::<u32>().ok()? + bit / 8, bit % 8))
        });
        found.unwrap_or_else(|| format!("#{variable}"))
    }
}

/// Numbers of the devices that the builder chooses, by the order of the signals.
struct Places {
    relays: BTreeMap<Bit, u32>,
    timers: BTreeMap<Bit, u32>,
    inputs: BTreeMap<MachineContact, u32>,
    outputs: BTreeMap<MachineOutput, u32>,
    data: BTreeMap<PlcNumber, u32>,
    /// First functions of the decoding instructions.
    decoders: Vec<u32>,
}

impl Places {
    fn new(bits: &BTreeSet<Bit>, words: &BTreeSet<PlcNumber>) -> Places {
        let numbered =
            |wanted: fn(&Bit) -> bool| bits.iter().copied().filter(wanted).zip(0..).collect::<BTreeMap<Bit, u32>>();
        let mut decoders: Vec<u32> = Vec::new();
        for bit in bits {
            if let Bit::Decoded(function) = *bit
                && decoders.last().is_none_or(|first| function >= first + DECODED)
            {
                decoders.push(function);
            }
        }
        let inputs = bits.iter().filter_map(|bit| if let Bit::Input(input) = *bit { Some(input) } else { None });
        let outputs = bits.iter().filter_map(|bit| if let Bit::Output(output) = *bit { Some(output) } else { None });
        let (messages, wires): (Vec<_>, Vec<_>) = outputs.partition(|output| output.is_message());
        Places {
            relays: numbered(|bit| matches!(bit, Bit::Relay(_))),
            timers: numbered(|bit| matches!(bit, Bit::Timer(_))),
            inputs: inputs.zip(0..).collect(),
            outputs: wires.into_iter().zip(0..).chain(messages.into_iter().zip(0..)).collect(),
            // Numbered from 2: the knobs have the numbers before.
            data: words.iter().copied().filter(|word| matches!(word, PlcNumber::Data(_))).zip(2..).collect(),
            decoders,
        }
    }
}

/// Address of a bit, eight to a byte, counted from byte `first`.
fn byte_bit(letter: char, first: u32, number: u32) -> String {
    format!("{letter}{}.{}", first + number / 8, number % 8)
}

/// Device of a relay, a timer or a decoded function.
fn internal_device(language: PlcLanguage, bit: Bit, places: &Places) -> String {
    let timer = places.timers.get(&bit).copied().unwrap_or(0);
    let relay = |number: u32| match language {
        PlcLanguage::Pmc | PlcLanguage::Gsk => byte_bit('R', 10, number),
        PlcLanguage::Melsec => format!("M{}", 200 + number),
        PlcLanguage::Step7 => byte_bit('M', 10, number),
    };
    match (bit, language) {
        (Bit::Timer(_), PlcLanguage::Pmc) => byte_bit('R', 30, timer),
        (Bit::Timer(_), PlcLanguage::Gsk) => format!("T{timer}"),
        (Bit::Timer(_), PlcLanguage::Melsec) => format!("T{}", 20 + timer),
        // Timers of 10 ms: T33 to T36, then T97 on.
        (Bit::Timer(_), PlcLanguage::Step7) => format!("T{}", if timer < 4 { 33 + timer } else { 93 + timer }),
        (Bit::Decoded(function), PlcLanguage::Melsec) => format!("M{}", 300 + function),
        (Bit::Decoded(function), _) => {
            let group = places.decoders.iter().rposition(|first| *first <= function).unwrap_or(0);
            let first = places.decoders.get(group).copied().unwrap_or(0);
            format!("R{}.{}", 40 + group, function - first)
        }
        _ => relay(places.relays.get(&bit).copied().unwrap_or(0)),
    }
}

/// Device of an input. Emergency stop has an address of its own where the control reads it, too (FANUC X8.4, GSK X0.5): the delayed contact
/// where there is one.
fn input_device(language: PlcLanguage, input: MachineContact, places: &Places) -> String {
    let number = places.inputs.get(&input).copied().unwrap_or(0);
    let delayed = places.inputs.contains_key(&MachineContact::EmergencyDelayed);
    let of_control = if delayed { MachineContact::EmergencyDelayed } else { MachineContact::Emergency };
    match (language, input) {
        (PlcLanguage::Pmc, _) if input == of_control => "X8.4".to_owned(),
        (PlcLanguage::Gsk, _) if input == of_control => "X0.5".to_owned(),
        (PlcLanguage::Pmc | PlcLanguage::Gsk, _) => byte_bit('X', 3, number),
        (PlcLanguage::Melsec, _) => format!("X{:X}", 0x20 + number),
        (PlcLanguage::Step7, _) => byte_bit('I', 0, number),
    }
}

/// Device of an output.
fn output_device(language: PlcLanguage, number: u32) -> String {
    match language {
        PlcLanguage::Pmc | PlcLanguage::Gsk => byte_bit('Y', 5, number),
        PlcLanguage::Melsec => format!("Y{:X}", 0x20 + number),
        PlcLanguage::Step7 => byte_bit('Q', 0, number),
    }
}

/// Device of a message that the control shows as a text: of an alarm on FANUC and GSK with its number below 2000, on Siemens 700000 plus
/// its place. From memory of the makers' ladders.
fn message_device(language: PlcLanguage, number: u32) -> String {
    match language {
        PlcLanguage::Pmc | PlcLanguage::Gsk => byte_bit('A', 0, number),
        PlcLanguage::Melsec => format!("F{number}"),
        PlcLanguage::Step7 => format!("V1600000{}.{}", number / 8, number % 8),
    }
}

/// Device of a data word.
fn data_device(language: PlcLanguage, number: u32) -> String {
    match language {
        PlcLanguage::Step7 => format!("VW{}", 100 + 4 * number),
        PlcLanguage::Melsec => format!("D{}", 100 + 2 * number),
        PlcLanguage::Pmc | PlcLanguage::Gsk => format!("D{}", 100 + 4 * number),
    }
}

/// Catalog id of the meaning of a control's signal in the ladder.
fn role_meaning(role: SignalRole) -> &'static str {
    match role {
        SignalRole::SpindleOverride => "plc.signal.override",
        SignalRole::SpindleOverrideValid => "plc.signal.override-valid",
        SignalRole::SpindleOverrideByRegister => "plc.signal.override-register",
        SignalRole::SpindleOverrideCode => "plc.signal.override-code",
        SignalRole::FeedOverride => "plc.signal.feed-override",
        SignalRole::FeedOverrideByRegister => "plc.signal.feed-override-register",
        SignalRole::FeedOverrideOff => "plc.signal.feed-override-off",
        SignalRole::FeedOverrideValid => "plc.signal.feed-override-valid",
        SignalRole::MacroInputLow(_) => "plc.signal.macro-input",
        SignalRole::MacroInputHigh(_) => "plc.signal.macro-input-high",
        SignalRole::SpindleFinal => "plc.signal.final",
        SignalRole::MCode => "plc.signal.m-code",
        SignalRole::MFunction(_) => "plc.signal.m-function",
        SignalRole::MStrobe => "plc.signal.m-strobe",
        SignalRole::SStrobe => "plc.signal.s-strobe",
        SignalRole::TStrobe => "plc.signal.t-strobe",
        SignalRole::TFunction => "plc.signal.t-function",
        SignalRole::Running => "plc.signal.running",
        SignalRole::Idle => "plc.signal.idle",
        SignalRole::ProgramEnd => "plc.signal.program-end",
        SignalRole::Alarm => "plc.signal.alarm",
        SignalRole::Reset => "plc.signal.reset",
        SignalRole::Finished => "plc.signal.finished",
        SignalRole::ReadInDisable => "plc.signal.read-in",
        SignalRole::SpindleEnable => "plc.signal.spindle-enable",
        SignalRole::SpindleHold => "plc.signal.spindle-hold",
        SignalRole::AxesEnable => "plc.signal.axes-enable",
        SignalRole::AxesStop => "plc.signal.axes-stop",
        SignalRole::ShiftSpeed => "plc.signal.shift-speed",
        SignalRole::SpindlePositions => "plc.signal.spindle-positions",
        SignalRole::SpeedArrived => "plc.signal.speed-arrived",
        SignalRole::HoldReleased => "plc.signal.hold-released",
        SignalRole::HoldRequest => "plc.signal.hold-request",
        SignalRole::EmergencyReleased => "plc.signal.emergency-released",
        SignalRole::EmergencyRequest => "plc.signal.emergency-request",
        SignalRole::EmergencyAcknowledge => "plc.signal.emergency-acknowledge",
        SignalRole::ResetRequest => "plc.signal.reset-request",
        SignalRole::GearChange => "plc.signal.gear-change",
        SignalRole::GearAsked(_) => "plc.signal.gear-asked",
        SignalRole::GearNumber(0) | SignalRole::GearIndex(0) => "plc.signal.gear-bit-0",
        SignalRole::GearNumber(1) | SignalRole::GearIndex(1) => "plc.signal.gear-bit-1",
        SignalRole::GearNumber(_) | SignalRole::GearIndex(_) => "plc.signal.gear-bit-2",
        SignalRole::GearChanged => "plc.signal.gear-changed",
        SignalRole::MacroOutput(_)
        | SignalRole::SpindleCommand
        | SignalRole::SpindleOutput
        | SignalRole::SpindleActual => "",
    }
}

fn input_meaning(input: MachineContact) -> &'static str {
    match input {
        MachineContact::Emergency => "plc.input.emergency",
        MachineContact::EmergencyDelayed => "plc.input.emergency-delayed",
        MachineContact::ResetKey => "plc.input.reset-key",
        MachineContact::InverterReady => "plc.input.inverter-ready",
        MachineContact::AtSpeed => "plc.input.at-speed",
        MachineContact::ForwardKey => "plc.input.forward-key",
        MachineContact::ReverseKey => "plc.input.reverse-key",
        MachineContact::StopKey => "plc.input.stop-key",
        MachineContact::InGear(1) => "plc.input.in-gear-1",
        MachineContact::InGear(2) => "plc.input.in-gear-2",
        MachineContact::InGear(3) => "plc.input.in-gear-3",
        MachineContact::InGear(_) => "plc.input.in-gear-4",
        MachineContact::AtShiftSpeed => "plc.input.at-shift-speed",
        MachineContact::AtStandstill => "plc.input.at-standstill",
        MachineContact::SpindleClamped => "plc.input.spindle-clamped",
        MachineContact::WorkHeld => "plc.input.work-held",
        MachineContact::InverterEnabled => "plc.input.inverter-enabled",
        MachineContact::LoopNotFull => "plc.input.loop-not-full",
        MachineContact::WebNotTight => "plc.input.web-not-tight",
        MachineContact::ReelNotEmpty => "plc.input.reel-not-empty",
        MachineContact::TurretInPosition => "plc.input.turret-in-position",
        MachineContact::HoldKey => "plc.input.hold-key",
    }
}

fn output_meaning(output: MachineOutput) -> &'static str {
    match output {
        MachineOutput::Forward => "plc.output.forward",
        MachineOutput::Reverse => "plc.output.reverse",
        MachineOutput::Run => "plc.output.run",
        MachineOutput::Gear(1) => "plc.output.gear-1",
        MachineOutput::Gear(2) => "plc.output.gear-2",
        MachineOutput::Gear(3) => "plc.output.gear-3",
        MachineOutput::Gear(_) => "plc.output.gear-4",
        MachineOutput::SpindleClamp => "plc.output.spindle-clamp",
        MachineOutput::SpindleUnclamp => "plc.output.spindle-unclamp",
        MachineOutput::DrivenTool => "plc.output.driven-tool",
        MachineOutput::TurretStart => "plc.output.turret-start",
        MachineOutput::InverterAlarm => "plc.output.inverter-alarm",
        MachineOutput::ReversalAlarm => "plc.output.reversal-alarm",
        MachineOutput::GearAlarm => "plc.output.gear-alarm",
        MachineOutput::Message(MachineContact::LoopNotFull) => "plc.output.loop-full",
        MachineOutput::Message(MachineContact::WebNotTight) => "plc.output.web-tight",
        MachineOutput::Message(MachineContact::ReelNotEmpty) => "plc.output.reel-empty",
        MachineOutput::Message(MachineContact::TurretInPosition) => "plc.output.turret-late",
        MachineOutput::Message(MachineContact::SpindleClamped) => "plc.output.clamp-late",
        MachineOutput::Message(MachineContact::WorkHeld) => "plc.output.work-not-held",
        MachineOutput::Message(MachineContact::StopKey) => "plc.output.stopped",
        MachineOutput::Message(_) => "plc.output.not-ready",
    }
}

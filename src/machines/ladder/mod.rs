//! Ladders of the machine builder as data: the same table of rungs is simulated, drawn and exported as text.
//!
//! A rung is a sum of products of contacts and one action. Latches are coils with a contact of their own, so that each signal has one coil.
//! Signals are typed: [`plc::LadderPlc`] connects them to the simulated control, [`book::Book`] to the devices of the control's PLC.

pub mod book;
pub mod codes;
pub mod plc;
pub mod scan;
pub mod sheet;
pub mod text;

use std::sync::Arc;

use crate::controls::interface::{PlcLanguage, SignalRole};
use crate::text::Citation;

/// A signal that is on or off.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Bit {
    /// Of the interface between PLC and control.
    Signal(SignalRole),
    /// A bit that a macro program reads or writes, by its variable.
    Macro(u32),
    /// M function, decoded from the number while its strobe is on.
    Decoded(u32),
    /// Internal relay by its name in the table.
    Relay(&'static str),
    /// Contact of a timer by its name in the table.
    Timer(&'static str),
    /// Contact of the machine.
    Input(MachineContact),
    /// Output to the machine.
    Output(MachineOutput),
    /// Device of the control that no row of its table has; the machine cites it.
    Device(&'static str),
    /// Signal of a named block, for functions whose instruction is not known.
    Block(&'static str),
}

/// A contact of the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum MachineContact {
    /// Emergency stop, closed while it is not pressed.
    Emergency,
    /// Emergency stop by the delayed contact of its relay: opens when the drives stand.
    EmergencyDelayed,
    /// Reset key, where the PLC reads it.
    ResetKey,
    /// The inverter reports no fault.
    InverterReady,
    /// The inverter reports the commanded speed.
    AtSpeed,
    /// Key "spindle clockwise".
    ForwardKey,
    /// Key "spindle counterclockwise".
    ReverseKey,
    /// Key "spindle stop", closed while it is not pressed.
    StopKey,
    /// A gear stage is in position.
    InGear(u8),
    /// The spindle turns at the shift speed or slower.
    AtShiftSpeed,
    /// The standstill monitor measures that the spindle is at rest, independently of the inverter.
    AtStandstill,
    /// The clamp holds the spindle.
    SpindleClamped,
    /// The quill of the tailstock presses on the work.
    WorkHeld,
    /// The inverter has its supply and its enable, and no fault.
    InverterEnabled,
    /// The loop is shorter than its longest limit.
    LoopNotFull,
    /// The web is not tight to its limit.
    WebNotTight,
    /// The reel is not at its end.
    ReelNotEmpty,
    /// The turret's controller answers its start signal: the commanded tool is in position and locked.
    TurretInPosition,
    /// Key "feed hold", closed while it is not pressed.
    HoldKey,
}

/// Kind of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactKind {
    /// It closes with its event: a broken wire is no event.
    Make,
    /// It opens with its event: a broken wire acts like the event.
    Break,
    /// Another device holds it closed in operation: a broken wire acts like the loss of that device.
    Held,
}

impl MachineContact {
    /// The kind. Contacts that stop or hold the machine break or are held closed, those that start something or report a position make.
    pub fn kind(self) -> ContactKind {
        match self {
            MachineContact::EmergencyDelayed
            | MachineContact::InverterReady
            | MachineContact::InverterEnabled
            | MachineContact::WorkHeld => ContactKind::Held,
            MachineContact::Emergency
            | MachineContact::StopKey
            | MachineContact::HoldKey
            | MachineContact::LoopNotFull
            | MachineContact::WebNotTight
            | MachineContact::ReelNotEmpty => ContactKind::Break,
            MachineContact::ResetKey
            | MachineContact::AtSpeed
            | MachineContact::ForwardKey
            | MachineContact::ReverseKey
            | MachineContact::InGear(_)
            | MachineContact::AtShiftSpeed
            | MachineContact::AtStandstill
            | MachineContact::SpindleClamped
            | MachineContact::TurretInPosition => ContactKind::Make,
        }
    }
}

/// An output to the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum MachineOutput {
    /// Inverter: run clockwise.
    Forward,
    /// Inverter: run counterclockwise.
    Reverse,
    /// Inverter: run in the direction of the voltage's sign.
    Run,
    /// Coil of the valve of a gear stage.
    Gear(u8),
    /// Coil that closes the clamp, which holds the spindle at an angle.
    SpindleClamp,
    /// Coil that opens the clamp; without current in both its valve keeps its position.
    SpindleUnclamp,
    /// Driven tool: run.
    DrivenTool,
    /// Start signal to the turret's controller.
    TurretStart,
    /// Alarm text: the inverter reports a fault.
    InverterAlarm,
    /// Alarm text: M03 and M04 without M05 between them.
    ReversalAlarm,
    /// Alarm text: the gear is not in position in time.
    GearAlarm,
    /// Text for the operator: this contact holds the program, or has held it.
    Message(MachineContact),
}

impl MachineOutput {
    /// Whether it is a message of the PLC that the control shows as a text.
    pub fn is_message(self) -> bool {
        match self {
            MachineOutput::InverterAlarm
            | MachineOutput::ReversalAlarm
            | MachineOutput::GearAlarm
            | MachineOutput::Message(_) => true,
            MachineOutput::Forward
            | MachineOutput::Reverse
            | MachineOutput::Run
            | MachineOutput::Gear(_)
            | MachineOutput::SpindleClamp
            | MachineOutput::SpindleUnclamp
            | MachineOutput::DrivenTool
            | MachineOutput::TurretStart => false,
        }
    }
}

/// A number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum PlcNumber {
    /// Of the interface between PLC and control.
    Signal(SignalRole),
    /// Spindle override knob, %.
    Knob,
    /// Cutting feed override knob, %.
    FeedKnob,
    /// Data register by its name in the table.
    Data(&'static str),
    /// A constant.
    Constant(i32),
    /// Number of a named block.
    Block(&'static str),
}

/// A contact: closes with its signal, or opens with it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RungContact {
    /// The signal.
    pub bit: Bit,
    /// Whether the signal opens the contact (normally closed).
    pub opens: bool,
}

/// A contact that closes with the signal.
pub fn on(bit: Bit) -> RungContact {
    RungContact { bit, opens: false }
}

/// A contact that opens with the signal.
pub fn off(bit: Bit) -> RungContact {
    RungContact { bit, opens: true }
}

/// Contacts in series, and such branches in parallel.
pub type Branches = Vec<Vec<RungContact>>;

/// Arithmetic of whole numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operator {
    /// Sum.
    Add,
    /// Product.
    Multiply,
    /// Quotient without remainder; 0 if the divisor is 0.
    Divide,
}

/// Width of the numbers that an instruction handles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlcWidth {
    /// One register of 16 bits.
    Word,
    /// Two registers of 16 bits.
    DoubleWord,
}

/// Output of a rung.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RungAction {
    /// The signal follows the condition.
    Coil(Bit),
    /// The contact of the timer closes when the condition has lasted for this time in ms.
    Timer(&'static str, u32),
    /// While the condition holds, the number is copied.
    Move {
        /// From.
        from: PlcNumber,
        /// To.
        to: PlcNumber,
        /// Width of the numbers.
        width: PlcWidth,
    },
    /// While the condition holds, the result is computed.
    Compute {
        /// Operator.
        operator: Operator,
        /// Left operand.
        left: PlcNumber,
        /// Right operand.
        right: PlcNumber,
        /// Result.
        to: PlcNumber,
        /// Width of the numbers.
        width: PlcWidth,
    },
    /// While the condition holds, the entry of a table at the index `from` (from 0) is copied; nothing is copied if the
    /// index is beyond the table.
    Convert {
        /// Index in the table.
        from: PlcNumber,
        /// To.
        to: PlcNumber,
        /// Entries.
        table: [u8; PLACES],
    },
    /// The coil is on while the condition holds and the number is smaller than the constant.
    Below {
        /// The number.
        number: PlcNumber,
        /// The constant.
        than: i32,
        /// The coil.
        coil: Bit,
    },
    /// M functions `first` to `first + 7` follow the M code while the condition holds; all are off while it does not.
    Decode {
        /// The first of eight M functions.
        first: u32,
    },
}

/// Number of M functions that one decoding instruction distinguishes.
pub const DECODED: u32 = 8;

/// Number of entries of a table: one for each ten percent that a number of one byte can have, rounded: 0 to 260 %.
pub const PLACES: usize = 27;

/// A rung.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rung {
    /// Branches.
    pub when: Branches,
    /// Output of the rung.
    pub action: RungAction,
    /// Catalog id of its purpose.
    pub note: &'static str,
}

/// Who writes or reads a signal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlcSide {
    /// The PLC.
    Plc,
    /// The control.
    Control,
    /// A macro program.
    Program,
    /// The machine: contacts, valves, inverter, keys.
    Machine,
    /// A named block.
    Block,
}

/// A device that carries a signal or a number.
#[derive(Debug, Clone, PartialEq)]
pub struct Device {
    /// Name in the PLC, for instance `G4.3`.
    pub name: String,
    /// Variable of a macro program, or empty.
    pub variable: String,
    /// Writer and reader.
    pub sides: (PlcSide, PlcSide),
    /// Unit, or empty.
    pub unit: &'static str,
    /// Catalog id of its meaning.
    pub meaning: &'static str,
    /// Kind of the contact that switches it; none for all but inputs from the machine.
    pub contact: Option<ContactKind>,
    /// Source and grade.
    pub cite: Citation,
}

/// A ladder: rungs in the order of the scan, with the devices of the control's PLC.
#[derive(Debug, Clone)]
pub struct Ladder {
    /// Rungs.
    pub rungs: Arc<[Rung]>,
    /// Instruction set.
    pub language: PlcLanguage,
    /// Signals that a rung drives, in order.
    pub coils: Arc<[Bit]>,
    /// Devices of the signals, by signal.
    pub bits: Arc<[(Bit, Device)]>,
    /// Devices of the numbers, by number.
    pub words: Arc<[(PlcNumber, Device)]>,
}

impl Ladder {
    /// Device of a signal; empty if no rung names it.
    pub fn bit(&self, bit: Bit) -> &str {
        let at = self.bits.binary_search_by_key(&bit, |row| row.0).ok();
        at.and_then(|at| self.bits.get(at)).map_or("", |row| &row.1.name)
    }

    /// Device of a number; empty if no rung names it.
    pub fn word(&self, word: PlcNumber) -> &str {
        let at = self.words.binary_search_by_key(&word, |row| row.0).ok();
        at.and_then(|at| self.words.get(at)).map_or("", |row| &row.1.name)
    }

    /// Whether a rung drives this coil.
    pub fn drives(&self, bit: Bit) -> bool {
        self.coils.binary_search(&bit).is_ok()
    }
}

impl Rung {
    /// The coil of the rung.
    pub fn coil(&self) -> Option<Bit> {
        match self.action {
            RungAction::Coil(bit) | RungAction::Below { coil: bit, .. } => Some(bit),
            _ => None,
        }
    }

    /// The number that the rung writes.
    pub fn written(&self) -> Option<PlcNumber> {
        match self.action {
            RungAction::Move { to, .. } | RungAction::Compute { to, .. } | RungAction::Convert { to, .. } => Some(to),
            _ => None,
        }
    }

    /// The numbers that the rung reads.
    pub fn read(&self) -> Vec<PlcNumber> {
        match self.action {
            RungAction::Move { from, .. } | RungAction::Convert { from, .. } => vec![from],
            RungAction::Compute { left, right, .. } => vec![left, right],
            RungAction::Below { number, .. } => vec![number],
            RungAction::Decode { .. } => vec![PlcNumber::Signal(SignalRole::MCode)],
            _ => Vec::new(),
        }
    }

    /// Signals that the rung names, the driven ones last.
    pub fn bits(&self) -> Vec<Bit> {
        let mut all: Vec<Bit> = self.when.iter().flatten().map(|contact| contact.bit).collect();
        match self.action {
            RungAction::Coil(bit) | RungAction::Below { coil: bit, .. } => all.push(bit),
            RungAction::Timer(name, _) => all.push(Bit::Timer(name)),
            _ => {}
        }
        all
    }
}

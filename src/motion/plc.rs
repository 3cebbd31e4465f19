//! The machine builder's PLC: the interface to the control, gear shifting, FIN, and the PLC of the bench.

use std::collections::BTreeMap;

use super::plant::PMC_AXES;
use super::timeline::Timeline;
use crate::drives::speed::Steps;
use crate::text::Message;

/// Part of an input word that is forced. A forced half overrides the forced whole word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum WordPart {
    /// All 32 bits, or the one bit of an input bit.
    Whole,
    /// The lower 16 bits.
    Low,
    /// The upper 16 bits.
    High,
}

impl WordPart {
    /// The input word with this part replaced.
    pub(super) fn put(self, word: f64, value: f64) -> f64 {
        let (old, new) = (word as i32, value as i64 as i32);
        match self {
            WordPart::Whole => value,
            WordPart::Low => f64::from(old & !0xffff | new & 0xffff),
            WordPart::High => f64::from(new << 16 | old & 0xffff),
        }
    }
}

/// The control's own report of automatic running (FANUC: the signals STL, SPL, OP and AL).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ProgramState {
    /// Not started, reset, or at its end.
    #[default]
    Idle,
    /// The program runs.
    Running,
    /// Feed hold: cycle start continues inside the block.
    Held,
    /// Stopped between two blocks by M00, M01, a message or single block: cycle start continues.
    Stopped,
    /// An alarm or emergency stop, until reset.
    Alarm,
}

/// The part of the interface that stops and releases the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Stops {
    /// State of the program.
    pub program: ProgramState,
    /// Reset or emergency stop was pressed; set for one scan.
    pub reset: bool,
    /// Emergency stop was pressed; set for one scan.
    pub emergency: bool,
    /// The spindle inverter reports a fault: its output is off.
    pub inverter_fault: bool,
    /// Spindle key pressed by the operator: 1, -1, or 0 for stop; set for one scan.
    pub spindle_key: Option<i8>,
    /// Key "feed hold" pressed by the operator; set for one scan.
    pub hold_key: bool,
    /// The position loop of the spindle is on: it turns to an angle or holds it.
    pub positions: bool,
    /// Direction of the spindle by the run contacts of the PLC: 1, -1, or 0 for none; `None` for a PLC without such contacts.
    pub turns: Option<i8>,
    /// Direction in which the PLC turns a spindle without M03 and M04 while gears mesh: 1, or 0.
    pub shift_turns: i8,
    /// The PLC holds the spindle at speed 0 (FANUC: `*SSTP` at 0); S and direction stay in force.
    pub spindle: bool,
    /// The PLC holds the axes of the program (FANUC: `*IT` at 0): movements stop or wait until it releases them.
    pub axes: bool,
    /// The PLC holds the program (FANUC: `*SP` at 0): feed hold until cycle start, which is refused as long as it lasts.
    pub hold: bool,
}

/// Overrides from the PLC to the control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlcOverrides {
    /// Spindle override in percent (register method).
    pub spindle: f64,
    /// The cutting feed override is fixed at 100 % (GSK: OVC at 1).
    pub feed_off: bool,
}

/// Alarms that a PLC raises.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlcAlarm {
    /// M03 while the spindle turns by M04, or the other way round, without M05 between them.
    SpindleReversal,
    /// The gear did not engage in time.
    GearTimeout,
    /// The inverter of the spindle reports a fault.
    InverterFault,
}

/// The interface between PLC and control at one moment.
#[derive(Debug, Clone, PartialEq)]
pub struct Io {
    /// Spindle override of the operator's knob in percent.
    pub spindle_override: f64,
    /// Cutting feed override of the operator's knob in percent.
    pub feed_override: f64,
    /// Stops of the program, and stops by the PLC.
    pub stops: Stops,
    /// Macro inputs by variable number, read by the program as `#1033` ….
    pub inputs: BTreeMap<u32, f64>,
    /// Macro outputs by variable number, as written by the program.
    pub outputs: BTreeMap<u32, f64>,
    /// Inputs forced by the operator; they replace the values of the PLC in `inputs`.
    pub forced: BTreeMap<(u32, WordPart), f64>,
    /// M code that waits for FIN.
    pub m_strobe: Option<u32>,
    /// S code that waits for FIN, in r/min.
    pub s_strobe: Option<f64>,
    /// T code that waits for FIN.
    pub t_strobe: Option<u32>,
    /// Gear stage that waits for FIN, from 1.
    pub gear_wanted: Option<u8>,
    /// The PLC's answer: the waiting codes are done.
    pub fin: bool,
    /// Overrides from the PLC to the control.
    pub overrides: PlcOverrides,
    /// Engaged gear stage, from 1, from the PLC to the control.
    pub gear: u8,
    /// Alarm of the PLC: stops the program and clears the codes that wait for FIN.
    pub alarm: Option<PlcAlarm>,
    /// A remark of the PLC for the operator, shown once per run; with a hold of the PLC, once per block.
    pub notice: Option<Message>,
    /// Volts from the PLC to the spindle in place of the speed's, during a gear change.
    pub gear_volts: Option<f64>,
    /// Commanded spindle speed in r/min after override and clamps, signed.
    pub spindle_command: f64,
    /// Actual spindle speed in r/min, signed.
    pub spindle_actual: f64,
    /// Speeds in r/min, signed, of the axes moved by the PLC.
    pub pmc_speed: [f64; PMC_AXES],
    /// Commanded turns of these axes since the start of the run, before acceleration.
    pub pmc_turns: [f64; PMC_AXES],
}

impl Default for Io {
    fn default() -> Io {
        Io {
            spindle_override: 100.0,
            feed_override: 100.0,
            stops: Stops::default(),
            inputs: BTreeMap::new(),
            outputs: BTreeMap::new(),
            forced: BTreeMap::new(),
            m_strobe: None,
            s_strobe: None,
            t_strobe: None,
            gear_wanted: None,
            fin: false,
            overrides: PlcOverrides { spindle: 100.0, feed_off: false },
            gear: 1,
            alarm: None,
            notice: None,
            gear_volts: None,
            spindle_command: 0.0,
            spindle_actual: 0.0,
            pmc_speed: [0.0; PMC_AXES],
            pmc_turns: [0.0; PMC_AXES],
        }
    }
}

impl Io {
    /// Inputs of the spindle speed from the PLC: spindle hold, gear stage, volts during a gear change, and override.
    pub(super) fn spindle_orders(&self) -> (bool, u8, Option<f64>, f64) {
        (self.stops.spindle, self.gear, self.gear_volts, self.overrides.spindle)
    }

    /// Clears all codes that wait for FIN.
    pub(super) fn clear_strobes(&mut self) {
        (self.m_strobe, self.s_strobe, self.t_strobe, self.gear_wanted) = (None, None, None, None);
    }
}

/// The machine builder's PLC program. It is called when one of its inputs has changed, and at the time it requests.
pub trait Plc {
    /// Reads and writes the interface at time `t` (s); returns the time of the latest next call, if any.
    fn scan(&mut self, t: f64, io: &mut Io) -> Option<f64>;
    /// Whether contacts of the machine follow its movers: see [`follow`](Plc::follow).
    fn follows_movers(&self) -> bool {
        false
    }
    /// Switches the contacts that follow the movers at time `t` (s). Called while the program runs and something moves, and at cycle start with
    /// the state of the program before it. Returns whether a contact has changed, and the time (s) to the next reading at the latest.
    fn follow(&mut self, _t: f64, _program: ProgramState, _machine: &Timeline) -> (bool, f64) {
        (false, f64::INFINITY)
    }
    /// Whether the PLC monitors the fault contact of the spindle inverter.
    fn watches_inverter(&self) -> bool {
        false
    }
    /// Whether the key "feed hold" is wired to the PLC, which holds the program by it.
    fn reads_hold_key(&self) -> bool {
        false
    }
    /// A copy with all state, for the planner's checkpoints.
    fn boxed(&self) -> Box<dyn Plc>;
}

/// A gear change: shift voltage, delay, old gear disengaged and new one engaged, wait for its contact, another delay; then the voltage of
/// the commanded speed again.
///
/// Source: `reference/gsk-980tdc.md` section 1.2 (No.067, DT000, ASPn, DT001; A1.0 where the contact does not come).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GearShift {
    /// Analog output (V) while the gear shifts.
    pub volts: f64,
    /// Time (s) until the old gear disengages.
    pub before: f64,
    /// Time (s) until the new gear is in position.
    pub meshing: f64,
    /// Time (s) until the voltage of the commanded speed.
    pub after: f64,
    /// Time limit (s) for the new gear to be in position; `None` without supervision.
    pub patience: Option<f64>,
}

impl GearShift {
    /// Shifts to the stage wanted since `since` (s); returns the time of the next change, `None` when the shift is finished.
    pub fn shift(&self, t: f64, since: f64, io: &mut Io) -> Option<f64> {
        let wanted = io.gear_wanted.filter(|&wanted| wanted != io.gear || io.gear_volts.is_some())?;
        let out = since + self.before;
        if let Some(patience) = self.patience.filter(|&patience| patience < self.meshing) {
            let late = out + patience;
            io.gear_volts = (t < late).then_some(self.volts);
            io.alarm = (t >= late).then_some(PlcAlarm::GearTimeout);
            return Some(if t < out { out } else { late });
        }
        let done = out + self.meshing + self.after;
        io.gear_volts = (t < done).then_some(self.volts);
        if t >= out {
            io.gear = wanted;
        }
        (t < done).then_some(if t < out { out } else { done })
    }
}

/// Start (s) of the wait for FIN of the present codes.
#[derive(Debug, Clone, Default)]
pub struct Strobes(Option<f64>);

impl Strobes {
    /// Start (s) of the wait of the present codes. Without waiting codes it is `None` and switches FIN off.
    pub fn since(&mut self, t: f64, io: &mut Io) -> Option<f64> {
        if io.m_strobe.is_none() && io.s_strobe.is_none() && io.t_strobe.is_none() {
            (self.0, io.fin) = (None, false);
            return None;
        }
        Some(*self.0.get_or_insert(t))
    }
}

/// The test bench's PLC: answers codes after a delay and echoes the spindle override into a macro input.
#[derive(Debug, Clone)]
pub struct BenchPlc {
    /// Seconds until FIN.
    pub fin_delay: f64,
    /// Variable with the spindle override in percent.
    pub override_echo: Option<u32>,
    /// Voltage and times of a gear change.
    pub shift: GearShift,
    /// Positions of the override knob; `None` for a continuous one.
    pub knob: Option<Steps>,
    /// M03 and M04 need M05 between them.
    pub stop_between: bool,
    strobes: Strobes,
    /// Output: M03 (1), M04 (-1) or neither (0).
    turns: i8,
}

impl BenchPlc {
    /// A PLC that answers after `fin_delay` seconds.
    pub fn new(fin_delay: f64, override_echo: Option<u32>) -> BenchPlc {
        BenchPlc {
            fin_delay,
            override_echo,
            shift: GearShift::default(),
            knob: None,
            stop_between: false,
            strobes: Strobes::default(),
            turns: 0,
        }
    }
}

impl Plc for BenchPlc {
    fn scan(&mut self, t: f64, io: &mut Io) -> Option<f64> {
        let percent = self.knob.map_or(io.spindle_override, |knob| knob.nearest(io.spindle_override));
        io.overrides.spindle = percent;
        if let Some(variable) = self.override_echo {
            io.inputs.insert(variable, percent);
        }
        let Some(since) = self.strobes.since(t, io) else {
            io.gear_volts = None;
            self.turns = sense(io.spindle_command);
            return None;
        };
        if self.stop_between && matches!((io.m_strobe, self.turns), (Some(3), -1) | (Some(4), 1)) {
            io.alarm = Some(PlcAlarm::SpindleReversal);
            return None;
        }
        let shifted = self.shift.shift(t, since, io);
        let due = since + self.fin_delay;
        io.fin = t >= due && shifted.is_none();
        (!io.fin).then_some(shifted.unwrap_or(due))
    }

    fn boxed(&self) -> Box<dyn Plc> {
        Box::new(self.clone())
    }
}

/// Limits an override to 0 to 1000 %; NaN becomes 0.
pub(super) fn percent(value: f64) -> f64 {
    if value > 0.0 { value.min(1000.0) } else { 0.0 }
}

/// Sign of a speed or angle: 1, -1, or 0 below 1e-9.
pub(super) fn sense(value: f64) -> i8 {
    i8::from(value > 1e-9) - i8::from(value < -1e-9)
}

//! The machine builder's logic: reads what the control puts out, writes what the control reads, in the order of time.

use crate::drives::speed::Steps;
use crate::order::Map;

/// Which part of an input word is forced. The whole word yields to its halves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// All 32 bits, or the one bit of an input bit.
    Whole,
    /// The lower 16 bits.
    Low,
    /// The upper 16 bits.
    High,
}

impl Part {
    /// The input with this part of it replaced.
    pub(super) fn put(self, word: f64, value: f64) -> f64 {
        let (old, new) = (word as i32, value as i64 as i32);
        match self {
            Part::Whole => value,
            Part::Low => f64::from(old & !0xffff | new & 0xffff),
            Part::High => f64::from(new << 16 | old & 0xffff),
        }
    }
}

/// The interface between PLC and control at one moment.
#[derive(Debug, Clone, PartialEq)]
pub struct Io {
    /// Spindle override of the operator's knob in percent.
    pub spindle_override: f64,
    /// Macro inputs, by variable number: what the program reads as `#1033` ….
    pub inputs: Map<u32, f64>,
    /// Macro outputs, by variable number, as the program wrote them.
    pub outputs: Map<u32, f64>,
    /// Inputs that the operator has forced: `inputs` obeys them whatever the PLC writes.
    pub forced: Map<(u32, Part), f64>,
    /// M code that waits for FIN.
    pub m_strobe: Option<u32>,
    /// S code that waits for FIN, in r/min.
    pub s_strobe: Option<f64>,
    /// T code that waits for FIN.
    pub t_strobe: Option<u32>,
    /// Gear stage that waits for FIN, from 1.
    pub gear_wanted: Option<u8>,
    /// The PLC's answer: the waiting code is done.
    pub fin: bool,
    /// Percent that the PLC gives to the control as spindle override (register method).
    pub spindle_override_out: f64,
    /// Gear stage that is engaged, from 1, as the PLC tells the control.
    pub gear: u8,
    /// Volts that the PLC puts out to the spindle instead of those of the speed, while it shifts gears.
    pub gear_volts: Option<f64>,
    /// Spindle speed in r/min that the control puts out after override and clamps, signed.
    pub spindle_command: f64,
    /// Spindle speed in r/min as it is, signed.
    pub spindle_actual: f64,
}

impl Default for Io {
    fn default() -> Io {
        Io {
            spindle_override: 100.0,
            inputs: Map::new(),
            outputs: Map::new(),
            forced: Map::new(),
            m_strobe: None,
            s_strobe: None,
            t_strobe: None,
            gear_wanted: None,
            fin: false,
            spindle_override_out: 100.0,
            gear: 1,
            gear_volts: None,
            spindle_command: 0.0,
            spindle_actual: 0.0,
        }
    }
}

/// A builder's PLC program. It is called whenever something that it sees has changed, and when it asked to be.
pub trait Plc {
    /// Reads and writes the interface at time `t` (seconds); returns when it wants to be asked again at the latest.
    fn scan(&mut self, t: f64, io: &mut Io) -> Option<f64>;
    /// A copy with all its state, for the planner's checkpoints.
    fn boxed(&self) -> Box<dyn Plc>;
}

/// A builder's gear change: the shift voltage, a delay, the old gear out and the new one in, the wait for its contact, another delay; then
/// the voltage is that of the speed again.
///
/// Source: `reference/gsk-knd-polygon.md` section 1.2 (No.067, DT33, ASPn, DT34).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GearShift {
    /// Volts while it shifts.
    pub volts: f64,
    /// Seconds until the old gear goes out.
    pub before: f64,
    /// Seconds until the new gear is in position.
    pub meshing: f64,
    /// Seconds until the voltage of the speed stands.
    pub after: f64,
}

impl GearShift {
    /// Shifts to the stage that is wanted since `since`; when it is done, and until then the next moment that something happens.
    pub fn shift(&self, t: f64, since: f64, io: &mut Io) -> Option<f64> {
        let wanted = io.gear_wanted.filter(|&wanted| wanted != io.gear || io.gear_volts.is_some())?;
        let out = since + self.before;
        let done = out + self.meshing + self.after;
        io.gear_volts = (t < done).then_some(self.volts);
        if t >= out {
            io.gear = wanted;
        }
        (t < done).then_some(if t < out { out } else { done })
    }
}

/// The bench's PLC: answers codes after a delay and echoes the spindle override into a macro input.
#[derive(Debug, Clone)]
pub struct BenchPlc {
    /// Seconds until FIN.
    pub fin_delay: f64,
    /// Variable that shows the spindle override in percent.
    pub override_echo: Option<u32>,
    /// How it shifts gears.
    pub shift: GearShift,
    /// Positions of the override knob, where it has such.
    pub knob: Option<Steps>,
    waiting_since: Option<f64>,
}

impl BenchPlc {
    /// A PLC that answers after `fin_delay` seconds.
    pub fn new(fin_delay: f64, override_echo: Option<u32>) -> BenchPlc {
        BenchPlc { fin_delay, override_echo, shift: GearShift::default(), knob: None, waiting_since: None }
    }
}

impl Plc for BenchPlc {
    fn scan(&mut self, t: f64, io: &mut Io) -> Option<f64> {
        let percent = self.knob.map_or(io.spindle_override, |knob| knob.nearest(io.spindle_override));
        io.spindle_override_out = percent;
        if let Some(variable) = self.override_echo {
            io.inputs.insert(variable, percent);
        }
        if io.m_strobe.is_none() && io.s_strobe.is_none() && io.t_strobe.is_none() {
            self.waiting_since = None;
            (io.fin, io.gear_volts) = (false, None);
            return None;
        }
        let since = *self.waiting_since.get_or_insert(t);
        let shifted = self.shift.shift(t, since, io);
        let due = since + self.fin_delay;
        io.fin = t >= due && shifted.is_none();
        (!io.fin).then_some(shifted.unwrap_or(due))
    }

    fn boxed(&self) -> Box<dyn Plc> {
        Box::new(self.clone())
    }
}

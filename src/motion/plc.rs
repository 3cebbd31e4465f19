//! The machine builder's PLC: the interface to the control, gear shifting, FIN, and the PLC of the bench.

use std::collections::BTreeMap;

use super::plant::PMC_AXES;
use super::timeline::Timeline;
use crate::controls::bench::BenchShift;
use crate::controls::{Bench, SpindleRules};
use crate::drives::Rotation;
use crate::drives::speed::KnobRange;
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

/// Positions of the operator's override knobs, in percent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OverrideKnobs {
    /// Spindle override.
    pub spindle: f64,
    /// Cutting feed override.
    pub feed: f64,
}

impl Default for OverrideKnobs {
    fn default() -> OverrideKnobs {
        OverrideKnobs { spindle: 100.0, feed: 100.0 }
    }
}

/// Signals of control, operator and machine to the PLC.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PlcSignals {
    /// State of the program.
    pub program_state: ProgramState,
    /// Reset or emergency stop was pressed; set for one scan.
    pub reset: bool,
    /// Emergency stop was pressed; set for one scan.
    pub emergency: bool,
    /// The spindle inverter reports a fault: its output is off.
    pub inverter_fault: bool,
    /// Spindle key pressed by the operator; set for one scan.
    pub spindle_key: Option<Rotation>,
    /// Key "feed hold" pressed by the operator; set for one scan.
    pub hold_key: bool,
    /// The override knobs.
    pub knobs: OverrideKnobs,
    /// M code that waits for FIN.
    pub m_strobe: Option<u32>,
    /// S code that waits for FIN, in r/min.
    pub s_strobe: Option<f64>,
    /// T code that waits for FIN.
    pub t_strobe: Option<u32>,
    /// Gear stage that waits for FIN, from 1.
    pub gear_wanted: Option<u8>,
    /// Macro outputs by variable number, as written by the program.
    pub macro_outputs: BTreeMap<u32, f64>,
    /// Commanded spindle speed in r/min after override and clamps, signed.
    pub spindle_command: f64,
    /// Actual spindle speed in r/min, signed.
    pub spindle_actual: f64,
    /// Trim of the speed by the inverter, as a fraction: its contact "at speed" compares with the trimmed command.
    pub speed_trim: f64,
    /// The position loop of the spindle is on: it turns to an angle or holds it.
    pub positions: bool,
    /// Commanded turns of the axes moved by the PLC since the start of the run, before acceleration.
    pub pmc_turns: [f64; PMC_AXES],
}

impl PlcSignals {
    /// Whether a code waits for FIN.
    pub(super) fn waits(&self) -> bool {
        self.m_strobe.is_some() || self.s_strobe.is_some() || self.t_strobe.is_some()
    }

    /// The gear stage that waits to engage: the wanted one, until it is in and its voltage is over.
    pub fn waiting_gear(&self, spindle: SpindleOrders) -> Option<u8> {
        self.gear_wanted.filter(|wanted| *wanted != spindle.gear || spindle.shift_volts.is_some())
    }

    /// Clears all codes that wait for FIN.
    pub(super) fn clear_strobes(&mut self) {
        (self.m_strobe, self.s_strobe, self.t_strobe, self.gear_wanted) = (None, None, None, None);
    }
}

/// Orders of the PLC on the speed of the spindle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpindleOrders {
    /// The PLC holds the spindle at speed 0 (FANUC: `*SSTP` at 0); S and direction stay in force.
    pub held: bool,
    /// Engaged gear stage, from 1.
    pub gear: u8,
    /// Volts in place of the speed's, during a gear change.
    pub shift_volts: Option<f64>,
    /// Spindle override in percent (register method).
    pub percent: f64,
}

/// Orders of the PLC to the control.
#[derive(Debug, Clone, PartialEq)]
pub struct PlcOrders {
    /// On the speed of the spindle.
    pub spindle: SpindleOrders,
    /// Rotation by the run contacts of the PLC; `None` for a PLC without such contacts.
    pub run_contacts: Option<Rotation>,
    /// Rotation that the PLC gives a spindle without M03 and M04 while gears mesh.
    pub shift_rotation: Rotation,
    /// The PLC holds the axes of the program (FANUC: `*IT` at 0): movements stop or wait until it releases them.
    pub axes_held: bool,
    /// The PLC holds the program (FANUC: `*SP` at 0): feed hold until cycle start, which is refused as long as it lasts.
    pub program_held: bool,
    /// The cutting feed override is fixed at 100 % (GSK: OVC at 1).
    pub feed_override_off: bool,
    /// Macro inputs by variable number, read by the program as `#1033` ….
    pub macro_inputs: BTreeMap<u32, f64>,
    /// The waiting codes are done.
    pub fin: bool,
    /// Alarm of the PLC: stops the program and clears the codes that wait for FIN.
    pub alarm: Option<PlcAlarm>,
    /// A remark of the PLC for the operator, shown once per run; with a hold of the PLC, once per block.
    pub notice: Option<Message>,
    /// Speeds in r/min, signed, of the axes moved by the PLC.
    pub pmc_speed: [f64; PMC_AXES],
    /// Web (mm) unwound and not taken since the start of the run at which the dancer is at its set point.
    pub web_at_set_point: f64,
}

impl Default for PlcOrders {
    /// At power-on: nothing held, the first gear stage, override 100 %.
    fn default() -> PlcOrders {
        PlcOrders {
            spindle: SpindleOrders { held: false, gear: 1, shift_volts: None, percent: 100.0 },
            run_contacts: None,
            shift_rotation: Rotation::Stopped,
            axes_held: false,
            program_held: false,
            feed_override_off: false,
            macro_inputs: BTreeMap::new(),
            fin: false,
            alarm: None,
            notice: None,
            pmc_speed: [0.0; PMC_AXES],
            web_at_set_point: 0.0,
        }
    }
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

/// The machine builder's PLC program. It is called when one of its inputs has changed, and at the time it requests.
pub trait Plc {
    /// Answers the signals at time `t` (s) by orders, which last until it changes them; returns the time of the latest next call, if any.
    fn scan(&mut self, t: f64, signals: &PlcSignals, orders: &mut PlcOrders) -> Option<f64>;
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
/// Source: `docs/reference/gsk-980tdc.md` section 1.2 (No.067, DT000, ASPn, DT001; A1.0 where the contact does not come).
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
    pub fn shift(&self, t: f64, since: f64, signals: &PlcSignals, orders: &mut PlcOrders) -> Option<f64> {
        let wanted = signals.waiting_gear(orders.spindle)?;
        let out = since + self.before;
        if let Some(patience) = self.patience.filter(|&patience| patience < self.meshing) {
            let late = out + patience;
            orders.spindle.shift_volts = (t < late).then_some(self.volts);
            orders.alarm = (t >= late).then_some(PlcAlarm::GearTimeout);
            return Some(if t < out { out } else { late });
        }
        let done = out + self.meshing + self.after;
        orders.spindle.shift_volts = (t < done).then_some(self.volts);
        if t >= out {
            orders.spindle.gear = wanted;
        }
        (t < done).then_some(if t < out { out } else { done })
    }
}

/// Start (s) of the wait for FIN of the present codes.
#[derive(Debug, Clone, Default)]
pub struct Strobes(Option<f64>);

impl Strobes {
    /// Start (s) of the wait of the present codes. Without waiting codes it is `None` and switches FIN off.
    pub fn since(&mut self, t: f64, signals: &PlcSignals, orders: &mut PlcOrders) -> Option<f64> {
        if !signals.waits() {
            (self.0, orders.fin) = (None, false);
            return None;
        }
        Some(*self.0.get_or_insert(t))
    }
}

/// The test bench's PLC: answers codes after a delay and echoes the spindle override into a macro input.
#[derive(Debug, Clone)]
pub struct BenchPlc {
    /// Seconds until FIN.
    fin_delay: f64,
    /// Variable with the spindle override in percent.
    override_echo: Option<u32>,
    /// Voltage and times of a gear change.
    pub shift: GearShift,
    /// Positions of the override knob.
    knob: KnobRange,
    /// M03 and M04 need M05 between them.
    stop_between: bool,
    strobes: Strobes,
    /// Output: rotation commanded last, before the codes that wait.
    rotation: Rotation,
}

impl BenchPlc {
    /// The PLC of a bench, for a control with these spindle rules.
    pub fn new(bench: &Bench, rules: &SpindleRules) -> BenchPlc {
        let BenchShift { volts, before, meshing, after } = bench.shift;
        BenchPlc {
            fin_delay: bench.fin_delay,
            override_echo: bench.override_echo,
            shift: GearShift { volts, before, meshing, after, patience: None },
            knob: rules.knob,
            stop_between: rules.stop_between,
            strobes: Strobes::default(),
            rotation: Rotation::Stopped,
        }
    }
}

impl Plc for BenchPlc {
    fn scan(&mut self, t: f64, signals: &PlcSignals, orders: &mut PlcOrders) -> Option<f64> {
        let percent = self.knob.nearest(signals.knobs.spindle);
        orders.spindle.percent = percent;
        if let Some(variable) = self.override_echo {
            orders.macro_inputs.insert(variable, percent);
        }
        let Some(since) = self.strobes.since(t, signals, orders) else {
            orders.spindle.shift_volts = None;
            self.rotation = Rotation::of(signals.spindle_command);
            return None;
        };
        let reverses = matches!(
            (signals.m_strobe, self.rotation),
            (Some(3), Rotation::CounterClockwise) | (Some(4), Rotation::Clockwise)
        );
        if self.stop_between && reverses {
            orders.alarm = Some(PlcAlarm::SpindleReversal);
            return None;
        }
        let shifted = self.shift.shift(t, since, signals, orders);
        let due = since + self.fin_delay;
        orders.fin = t >= due && shifted.is_none();
        (!orders.fin).then_some(shifted.unwrap_or(due))
    }

    fn boxed(&self) -> Box<dyn Plc> {
        Box::new(self.clone())
    }
}

/// Limits an override to 0 to 1000 %; NaN becomes 0.
pub(super) fn percent(value: f64) -> f64 {
    if value > 0.0 { value.min(1000.0) } else { 0.0 }
}

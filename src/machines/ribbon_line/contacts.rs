//! Contacts that hold the program (inverter ready, loop at its limits, reel at its end): their places, and their states in a run.

use super::reel::wound;
use super::regulator::{regulator, set_point};
use super::resolved::RibbonLine;
use super::tension_switch::TensionSwitch;
use crate::machines::ladder::MachineContact;
use crate::machines::ladder::plc::BY_MOVERS;
use crate::motion::{ProgramState, Timeline};
use crate::msg;
use crate::text::{Citation, Grade, Message};

/// Source of the contacts and of their places.
pub(super) const CONTACTS: Citation = Citation::new("ribbon line facts, 11", Grade::Inferred);

/// The contacts that hold the program, closed in normal operation. A line without a loop has no sensor of the longest
/// loop.
pub(super) fn holding(line: &RibbonLine) -> Vec<MachineContact> {
    let mut all = vec![MachineContact::InverterEnabled];
    all.extend((line.params.loop_capacity > 0.0).then_some(MachineContact::LoopNotFull));
    all.extend([MachineContact::WebNotTight, MachineContact::ReelNotEmpty]);
    all
}

/// Ribbon (mm) that the unwinder still takes off the reel at a hold with the knob at its highest position: `v · t_r / 2`. Source: ribbon
/// line facts, 11.
pub(super) fn left_at_reel_end(line: &RibbonLine) -> f64 {
    let (p, fast) = (&line.params, &line.fast);
    let ramp = p.ramp_to(fast.unwinder.actual);
    fast.feeds.mm_per_second() * ramp / 2.0
}

/// Room (mm) that the loop needs below the sensor of the longest loop: ribbon laid while the program holds, at the
/// worst position of the knob.
pub(super) fn room_below_sensor(line: &RibbonLine) -> f64 {
    line.worst(|d| d.slack.hold).slack.hold.max(0.0)
}

/// The contacts of loop and reel in a run, in the order of [`BY_MOVERS`].
#[derive(Debug, Clone)]
pub(super) struct RibbonContacts {
    /// Ribbon (mm) per turn of the unwinder's motor.
    per_turn: f64,
    /// Index of the axis that pulls.
    pull: usize,
    /// Ribbon (mm) in the loop at which the first contact opens; infinite for a line without a loop.
    pub(super) longest: f64,
    /// Ribbon (mm) in the loop, negative, at which the second opens.
    shortest: f64,
    /// Ribbon (mm) unwound from a reel at which the third opens.
    reel: f64,
    /// Whether a regulator keeps the loop: then the operator takes up a loop at its limits only.
    is_regulated: bool,
    /// Greatest speed (mm/s) at which the loop changes.
    fastest: f64,
    /// Ribbon unwound less ribbon pulled (mm) when the loop was last taken up.
    taken_up: f64,
    /// Ribbon (mm) in the loop that the regulator keeps.
    set_point: f64,
    /// Ribbon unwound (mm) when the present reel was put on.
    put_on: f64,
    closed: [bool; 3],
}

impl RibbonContacts {
    pub(super) fn new(line: &RibbonLine) -> RibbonContacts {
        let p = &line.params;
        let (per_turn, motor) = (p.laid_by_turns(1.0), p.induction());
        let unwinds = per_turn * (p.speed_at_10v * motor.gain().max(1.0 + p.loop_trim()) + motor.slip().abs());
        RibbonContacts {
            per_turn,
            pull: line.pull(),
            longest: if p.loop_capacity > 0.0 { p.loop_capacity } else { f64::INFINITY },
            shortest: -TensionSwitch::new(line).missing,
            reel: (1e3 * wound(p).length() - left_at_reel_end(line)).max(0.0),
            is_regulated: regulator(line).is_some(),
            fastest: (unwinds + p.axes.pull.clamp.max(p.axes.pull.rapid)) / 60.0,
            taken_up: 0.0,
            set_point: set_point(line),
            put_on: 0.0,
            closed: [true; 3],
        }
    }

    /// Ribbon unwound less ribbon pulled (mm) with the dancer at its set point.
    pub(super) fn web_at_set_point(&self) -> f64 {
        self.taken_up + self.set_point
    }

    /// Contacts with their states.
    pub(super) fn states(&self) -> impl Iterator<Item = (MachineContact, bool)> + use<> {
        BY_MOVERS.into_iter().zip(self.closed)
    }

    /// Reads the contacts at `t` (s); returns the time (s) until the next limit may be reached. At a cycle start the
    /// operator is assumed to have acted as in the table of stops: a new product begins with a loop that is taken up, where no regulator
    /// keeps it, and a full reel, and a reel at its end is replaced.
    pub(super) fn read(&mut self, t: f64, program: ProgramState, machine: &Timeline) -> f64 {
        let unwound = self.per_turn * machine.turns(t);
        let laid = unwound - machine.actual(self.pull, t);
        let begins = program == ProgramState::Idle;
        let is_within = |slack: f64| slack > self.shortest && slack < self.longest;
        if begins && !(self.is_regulated && is_within(laid - self.taken_up)) {
            self.taken_up = laid;
        }
        if begins || program != ProgramState::Running && !self.closed[2] {
            self.put_on = unwound;
        }
        let slack = laid - self.taken_up;
        let left = [self.longest - slack, slack - self.shortest, self.reel - (unwound - self.put_on)];
        self.closed = left.map(|left| left > 0.0);
        left.into_iter().fold(f64::INFINITY, f64::min) / self.fastest
    }

    /// The sentence to the operator about an open contact.
    pub(super) fn message(&self, contact: MachineContact) -> Message {
        match contact {
            MachineContact::LoopNotFull => msg!("ribbon.held-loop-full", capacity = (self.longest, 0)),
            MachineContact::WebNotTight => msg!("ribbon.held-web-tight", missing = (-self.shortest, 1)),
            _ => msg!("ribbon.held-reel-empty", length = (self.reel, 0)),
        }
    }
}

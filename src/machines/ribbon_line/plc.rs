//! The builder's PLC of the ribbon line: its ladder, its contacts, and remarks on a knob that acts on unwinder or axes alone.

use super::contacts::RibbonContacts;
use super::derive::AT_SPEED;
use super::ladder::ladder;
use super::program;
use super::resolved::{KNOB_LIMIT, RibbonLine};
use crate::drives::speed::{KnobRange, STAGES};
use crate::machines::ladder::MachineContact;
use crate::machines::ladder::plc::{LadderPlc, Wiring};
use crate::motion::{Plc, PlcOrders, PlcSignals, ProgramState, Timeline};
use crate::msg;

/// The ladder, and the contacts of loop and reel.
#[derive(Clone)]
pub(super) struct RibbonPlc {
    ladder: LadderPlc,
    contacts: RibbonContacts,
    /// A contact that has opened since the last scan.
    opened: Option<MachineContact>,
    /// The typed override (%), if the knob changes the speed of the unwinder alone.
    typed: Option<f64>,
    /// Ribbon (mm) per revolution of the unwinder, and capacity (mm) of the loop, if the feed override changes the
    /// speed of the axes alone.
    filled: Option<(f64, f64)>,
    /// Whether the feed override moves the axes alone at 0 % only.
    stops_alone: bool,
}

impl RibbonPlc {
    pub(super) fn new(line: &RibbonLine) -> RibbonPlc {
        let wiring = Wiring {
            knob: KnobRange { low: 0.0, high: KNOB_LIMIT, step: 1.0 },
            rules: line.dialect.spindle(),
            at_speed: AT_SPEED,
            meshing: 0.0,
            shift_volts: 0.0,
            shift_speeds: [0.0; STAGES],
        };
        RibbonPlc {
            ladder: LadderPlc::new(ladder(line), wiring, line.control),
            contacts: RibbonContacts::new(line),
            opened: None,
            typed: line.params.knob_turns_alone().then(|| line.params.override_stepped()),
            filled: (program::feed_override_acts(line) || program::feed_override_stops(line))
                .then_some((line.derived.feeds.k, line.params.loop_capacity)),
            stops_alone: program::feed_override_stops(line),
        }
    }
}

impl RibbonPlc {
    /// Remarks on a knob that changes the speed of unwinder or axes alone, while the line runs.
    fn remark(&self, signals: &PlcSignals, orders: &mut PlcOrders) {
        let (percent, feed) = (orders.spindle.percent, signals.knobs.feed);
        if let Some(typed) = self.typed.filter(|typed| *typed != percent) {
            orders.notice = Some(msg!("ribbon.knob-left", percent = (percent, 0), programmed = (typed, 0)));
        }
        if let Some((k, capacity)) = self.filled.filter(|_| if self.stops_alone { feed == 0.0 } else { feed != 100.0 })
        {
            // Ribbon laid in mm/s: v · (1 - percent / 100).
            let speed = k * signals.spindle_command.abs() / 60.0;
            let time = capacity / (speed * (1.0 - feed / 100.0).abs());
            orders.notice = Some(msg!(
                "ribbon.feed-knob-left",
                percent = (feed, 0),
                speed = (speed, 0),
                capacity = (capacity, 0),
                time = (time, 1)
            ));
        }
    }
}

impl Plc for RibbonPlc {
    fn scan(&mut self, t: f64, signals: &PlcSignals, orders: &mut PlcOrders) -> Option<f64> {
        let next = self.ladder.scan(t, signals, orders);
        orders.web_at_set_point = self.contacts.web_at_set_point();
        if let Some(contact) = self.opened.take() {
            orders.notice = Some(self.contacts.message(contact));
        } else if signals.program_state == ProgramState::Running && signals.spindle_command != 0.0 {
            self.remark(signals, orders);
        }
        next
    }

    fn watches_inverter(&self) -> bool {
        self.ladder.watches_inverter()
    }

    fn reads_hold_key(&self) -> bool {
        self.ladder.reads_hold_key()
    }

    fn follows_movers(&self) -> bool {
        true
    }

    fn follow(&mut self, t: f64, program: ProgramState, machine: &Timeline) -> (bool, f64) {
        let wait = self.contacts.read(t, program, machine);
        let mut changed = false;
        for (contact, closed) in self.contacts.states() {
            let switched = self.ladder.switch(contact, closed);
            if switched && !closed {
                self.opened = self.opened.or(Some(contact));
            }
            changed |= switched;
        }
        (changed, wait)
    }

    fn boxed(&self) -> Box<dyn Plc> {
        Box::new(self.clone())
    }
}

//! The builder's PLC of the ribbon line: its ladder, and a remark where the knob turns the unwinder alone.

use super::derive::AT_SPEED;
use super::ladder::ladder;
use super::resolved::{GREATEST, RibbonLine};
use crate::controls::interface::SignalRole;
use crate::drives::speed::Steps;
use crate::machines::ladder::plc::{LadderPlc, Wiring};
use crate::motion::{Io, Plc, ProgramState};
use crate::msg;

/// The ladder.
pub(super) struct RibbonPlc {
    ladder: Box<dyn Plc>,
    /// The typed override (%), where the knob turns the unwinder and the axes stay.
    typed: Option<f64>,
}

impl RibbonPlc {
    pub(super) fn new(line: &RibbonLine) -> RibbonPlc {
        let coded = line.dialect.device(line.control, SignalRole::SpindleOverrideCode).is_some();
        let whole = Steps { low: 0.0, high: GREATEST, step: 1.0 };
        let wiring = Wiring {
            knob: if coded { line.dialect.spindle().knob } else { whole },
            at_speed: AT_SPEED,
            meshing: 0.0,
            shift_volts: 0.0,
        };
        RibbonPlc {
            ladder: Box::new(LadderPlc::new(ladder(line), wiring, line.control)),
            typed: line.p.knob_turns_alone().then(|| line.p.override_stepped()),
        }
    }
}

impl Plc for RibbonPlc {
    fn scan(&mut self, t: f64, io: &mut Io) -> Option<f64> {
        let next = self.ladder.scan(t, io);
        let percent = io.spindle_override_out;
        if let Some(typed) = self.typed.filter(|typed| *typed != percent)
            && io.stops.program == ProgramState::Running
            && io.spindle_command != 0.0
        {
            io.notice = Some(msg!("ribbon.knob-left", percent = (percent, 0), programmed = (typed, 0)));
        }
        next
    }

    fn watches_inverter(&self) -> bool {
        self.ladder.watches_inverter()
    }

    fn boxed(&self) -> Box<dyn Plc> {
        Box::new(RibbonPlc { ladder: self.ladder.boxed(), typed: self.typed })
    }
}

//! Codes for the PLC: M, S, T and gear stages are put out and end with FIN.

use super::exec::Exec;
use super::once::Once;
use super::program::RunningProgram;
use super::sim::Sim;
use crate::drives::Rotation;
use crate::drives::speed::stage_for;
use crate::interp::Canon;
use crate::msg;

impl<P: RunningProgram> Sim<'_, P> {
    /// Puts out a code, together with the ready codes of the same block.
    pub(super) fn put_out(&mut self, t: f64, canon: Canon) {
        self.strobe(canon);
        // S, M and T of one block are put out together (docs/reference/mitsubishi-e60.md section 5).
        while self
            .state
            .reader
            .queue
            .front()
            .is_some_and(|next| !next.first && next.ready <= t && self.can_join_strobe(&next.canon))
        {
            if let Some(next) = self.pop() {
                self.strobe(next.canon);
            }
        }
        self.state.plc.orders.fin = false;
        if !self.state.suppressed.fin {
            self.state.exec = Exec::Fin;
        }
        self.scan(t);
    }

    /// Whether a code can be put out beside the waiting ones.
    fn can_join_strobe(&self, canon: &Canon) -> bool {
        match canon {
            Canon::SpindleSpeed { .. } => self.state.plc.signals.s_strobe.is_none(),
            Canon::SpindleDirection { .. } | Canon::Auxiliary { .. } | Canon::Gear { .. } => {
                self.state.plc.signals.m_strobe.is_none()
            }
            Canon::Tool { .. } => self.state.plc.signals.t_strobe.is_none(),
            _ => false,
        }
    }

    fn strobe(&mut self, canon: Canon) {
        match canon {
            Canon::SpindleSpeed { rpm } => {
                let turning = &mut self.state.spindle;
                turning.surface = None;
                turning.speed = rpm.max(0.0);
                turning.commanded = true;
                self.state.plc.signals.s_strobe = Some(rpm);
                if turning.gear_by_s
                    && let Some(stage) = stage_for(self.plant.spindle.stages(), self.state.plc.orders.spindle.gear, rpm)
                    && stage != self.state.plc.orders.spindle.gear
                {
                    self.state.plc.signals.gear_wanted = Some(stage);
                }
            }
            Canon::Gear { stage } => {
                self.state.spindle.gear_by_s = stage == 0;
                self.state.plc.signals.m_strobe = Some(40 + u32::from(stage));
                let count = self.plant.spindle.stage_count;
                if stage > count {
                    self.warn(Once::NoStage, || {
                        msg!("motion.no-stage", stage = u32::from(stage), count = u32::from(count))
                    });
                } else if stage > 0 {
                    self.state.plc.signals.gear_wanted = Some(stage);
                }
            }
            Canon::SpindleDirection { rotation } => {
                self.state.spindle.orienting = None;
                self.state.spindle.rotation = rotation;
                self.state.spindle.locked = false;
                self.state.spindle.commanded = true;
                self.state.plc.signals.m_strobe = Some(match rotation {
                    Rotation::Clockwise => 3,
                    Rotation::CounterClockwise => 4,
                    Rotation::Stopped => 5,
                });
            }
            Canon::Auxiliary { code } => {
                let rules = &self.plant.spindle.rules;
                let turning = &mut self.state.spindle;
                // The M codes of tool change and coolant (M6 to M9) lock nothing.
                turning.locked |= rules.lock.map_or(!matches!(code, 6..=9), |lock| lock == code);
                turning.driven_tool_turns |= rules.driven_tool == Some(code);
                self.state.plc.signals.m_strobe = Some(code);
            }
            Canon::Tool { code } => self.state.plc.signals.t_strobe = Some(code),
            _ => {}
        }
    }
}

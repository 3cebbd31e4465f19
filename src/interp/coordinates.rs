//! Work zeros and limits by program: G50, G92, G52, offsets, G25 and G26.

use super::canon::{AXES, Canon, Target};
use super::context::BlockContext;
use super::state::RunState;
use super::words::BlockWords;
use crate::controls::Code;

impl RunState {
    /// Sets a work zero or a limit of the working area; returns whether the code does so.
    pub(super) fn coordinates(&mut self, cx: &BlockContext, code: Code, values: &BlockWords) -> bool {
        let programmed = (0..AXES).filter(|k| values.mask & 1 << k != 0);
        match code {
            Code::SetCoordinates => self.set_coordinates(cx, values),
            Code::LowerLimits | Code::UpperLimits => {
                programmed.for_each(|k| self.modal.limit_area(code == Code::UpperLimits, k, values.axes[k]));
            }
            Code::Offset | Code::OffsetMore => {
                for k in 0..AXES {
                    let shift = if values.mask & 1 << k != 0 { values.axes[k] } else { 0 };
                    let before = if code == Code::OffsetMore { self.modal.local(k) } else { 0 };
                    self.modal.set_local(k, before.saturating_add(shift));
                }
                self.surface_speed(cx);
            }
            Code::LocalCoordinates => {
                programmed.for_each(|k| self.modal.set_local(k, values.axes[k]));
                self.surface_speed(cx);
            }
            _ => return false,
        }
        true
    }

    /// G50 or G92: absolute words set the work position of the present position, incremental words shift it.
    fn set_coordinates(&mut self, cx: &BlockContext, values: &BlockWords) {
        if values.mask == 0 {
            return;
        }
        let mut to = Target { position: [0; AXES], mask: values.mask };
        for k in (0..AXES).filter(|k| values.mask & 1 << k != 0) {
            let work = self.position[k].saturating_sub(self.modal.zero[k]);
            let was = if values.incremental & 1 << k != 0 { work } else { 0 };
            to.position[k] = was.saturating_add(values.axes[k]);
            self.modal.set_zero(k, self.position[k].saturating_sub(to.position[k]));
        }
        self.queue.push(Canon::Preset { to });
        self.surface_speed(cx);
    }
}

//! The lead of threads and taps, along the path.

use super::canon::{AXES, Target};
use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::feed::no_feed;
use super::state::RunState;
use super::words::BlockWords;
use crate::controls::{Address, Alarm};
use crate::msg;

/// Addresses of an arc's centre and of thread leads by axis.
const CENTRES: [Address; 3] = [Address::I, Address::J, Address::K];

impl RunState {
    /// The lead in force, along the path.
    pub(super) fn lead(&self, cx: &BlockContext, values: &BlockWords, to: Target) -> BlockResult<f64> {
        let Some(lead) = self.modal.lead.filter(|lead| *lead != 0.0) else {
            if cx.control.raises(Alarm::NoLead) {
                return Err(Trap::alarm(Alarm::NoLead, msg!("interp.no-lead")));
            }
            return Err(no_feed(cx, self.modal.lead));
        };
        let (stretch, longest) = self.stretch(cx, to);
        let places = || {
            let axes = cx.control.axes.iter().zip(longest).filter(|row| row.1);
            axes.filter_map(|row| row.0.letter.after(Address::X))
        };
        // On a 45° taper both axes have the longest travel.
        let counting = places().fold(0_u8, |bits, place| bits | 1 << place);
        let own = places().next().unwrap_or(2);
        if values.leads & !counting != 0 && to.position != self.position {
            let address = CENTRES.get(own).unwrap_or(&Address::K).to_string();
            let trap = Trap::alarm(Alarm::LeadAxis, msg!("interp.lead-axis", address));
            return Err(trap.at_word(&CENTRES));
        }
        Ok(lead * stretch)
    }

    /// Ratio of path length to the longest axis travel, to which a lead refers, and the axes with that travel.
    fn stretch(&self, cx: &BlockContext, to: Target) -> (f64, [bool; AXES]) {
        let travel = |k: usize| to.position[k].saturating_sub(self.position[k]) as f64 * cx.shared.rules.moves[k];
        let squares = (0..AXES).map(|k| travel(k) * travel(k));
        let longest = squares.clone().fold(0.0, f64::max);
        let far = core::array::from_fn(|k| travel(k) * travel(k) >= longest);
        (if longest > 0.0 { (squares.sum::<f64>() / longest).sqrt() } else { 1.0 }, far)
    }
}

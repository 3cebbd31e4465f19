//! Program zero return: motion of the axes to the program's reference point, started by the operator.

use super::exec::Exec;
use super::moves::{ActiveMove, Pace};
use super::plant::AxisPlant;
use super::program::RunningProgram;
use super::sim::Sim;
use crate::controls::Address;
use crate::interp::canon::AXES;
use crate::msg;
use crate::text::Diagnostic;

impl<P: RunningProgram> Sim<'_, P> {
    /// Starts the return of all axes in the mode "program zero return". Refused while a program runs, at an alarm, and if the path would go
    /// through the work.
    pub(super) fn return_to_zero(&mut self, t: f64) {
        let ended = match self.state.exec {
            _ if !self.plant.zero_return => {
                return self.out.report(Diagnostic::warning(msg!("motion.no-zero-return")));
            }
            Exec::Finished => true,
            Exec::Ready => false,
            _ if self.state.exec.returning().is_some() => return,
            _ => return self.out.report(Diagnostic::warning(msg!("motion.zero-return-refused"))),
        };
        let Some(goal) = self.state.path.reference else {
            return self.out.report(Diagnostic::warning(msg!("motion.no-reference-point")));
        };
        let mut at = self.state.path.position;
        while let Some(end) = leg(at, goal, &self.plant.axes) {
            if self.enters_work(at, end) {
                return self.out.report(Diagnostic::error(msg!("motion.zero-return-through-work")));
            }
            at = end;
        }
        self.state.path.flow_end = None;
        self.return_on(t, ended);
    }

    /// Continues to the arrival of the next axis; ends at rest when all have arrived.
    pub(super) fn return_on(&mut self, t: f64, ended: bool) {
        let (at, axes) = (self.state.path.position, &self.plant.axes);
        let end = self.state.path.reference.and_then(|goal| leg(at, goal, axes));
        let Some(end) = end else {
            self.state.exec = Exec::after_return(ended);
            self.rest(t);
            return;
        };
        self.state.exec = Exec::Moving(ActiveMove::line(at, end, Pace::Return { ended }, false, axes));
        self.state.path.moving = true;
        self.put_segment(t);
    }

    /// Whether a straight move (mm) passes through the round work, which lies at negative Z. Moves out of the work, away from the centre
    /// and towards the face, are allowed.
    fn enters_work(&self, from: [f64; AXES], to: [f64; AXES]) -> bool {
        let travel = |letter| self.plant.travel_of(letter, &from, &to);
        let (x, z) = (travel(Address::X), travel(Address::Z));
        let (across, behind) = (within(x, (-self.plant.stock, self.plant.stock)), within(z, (f64::NEG_INFINITY, 0.0)));
        let way_out = x.0 * (x.1 - x.0) >= 0.0 && z.1 >= z.0;
        !way_out && across.0.max(behind.0) < across.1.min(behind.1) - 1e-9
    }
}

/// Positions (mm or °) at the arrival of the first axis at the goal, each axis at its own rapid rate; `None` at the goal.
fn leg(at: [f64; AXES], goal: [f64; AXES], axes: &[AxisPlant; AXES]) -> Option<[f64; AXES]> {
    let time = |k: usize| (goal[k] - at[k]).abs() / axes[k].rapid;
    let first = (0..AXES).map(time).filter(|time| *time > 0.0).reduce(f64::min)?;
    let share = |k: usize| if time(k) <= first { 1.0 } else { first / time(k) };
    Some(core::array::from_fn(|k| if share(k) == 1.0 { goal[k] } else { at[k] + share(k) * (goal[k] - at[k]) }))
}

/// Range of fractions of a move in which its coordinate is between two bounds; the first above the second if there is none.
fn within((from, to): (f64, f64), (low, high): (f64, f64)) -> (f64, f64) {
    let way = to - from;
    if way == 0.0 {
        return if low < from && from < high { (0.0, 1.0) } else { (1.0, 0.0) };
    }
    let (one, other) = ((low - from) / way, (high - from) / way);
    (one.min(other).max(0.0), one.max(other).min(1.0))
}

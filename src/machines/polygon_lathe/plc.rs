//! The builder's PMC of the polygon lathe: its ladder, and the named block that turns the axes of work and tool.
//!
//! From the paper: the variables of speed and ratios, and that each axis turns at their product. The rest is
//! macroline's own, as in the ladder: reset and emergency stop end polygon turning (in ratio, or coasting with the
//! drives off), and only a new request starts it again. Feed hold stops the slide alone.

use super::ladder::{ANGLE, AT_STANDSTILL, DONE, GO_TO_ANGLE, RPM, RUN, STOP, ladder};
use super::resolved::PolygonLathe;
use crate::drives::speed::{KnobRange, STAGES};
use crate::machines::ladder::plc::{LadderPlc, NamedBlock, Wiring};
use crate::machines::ladder::scan::Image;
use crate::motion::{PMC_AXES, PlcOrders, PlcSignals};

/// Time step (s) of the speed of a coasting axis.
const STEP: f64 = 0.01;
/// Angles (turns) that differ by no more are equal.
const SAME_ANGLE: f64 = 1e-9;

/// The PLC of the lathe.
pub(super) fn plc(lathe: &PolygonLathe) -> LadderPlc {
    let knob = KnobRange { step: 0.0, ..lathe.dialect.spindle().knob };
    let at_speed = 1.0 - lathe.dialect.spindle().tolerance();
    let rules = lathe.dialect.spindle();
    let wiring = Wiring { knob, rules, at_speed, meshing: 0.0, shift_volts: 0.0, shift_speeds: [0.0; STAGES] };
    LadderPlc::new(ladder(lathe), wiring, lathe.control).with_block(Box::new(Axes::new(lathe)))
}

/// State of both axes.
#[derive(Debug, Clone, Copy, PartialEq)]
enum AxesState {
    /// Both are at rest.
    Rest,
    /// The axes turn to their start angles, each until this time (s).
    Indexing([f64; PMC_AXES]),
    /// Both turn at their speeds.
    Turning,
    /// Both slow down, to rest at this time (s).
    Stopping(f64),
    /// Both coast since this time (s), from these speeds in r/min.
    Coasting(f64, [f64; PMC_AXES]),
}

/// The named block of both axes.
#[derive(Debug, Clone)]
struct Axes {
    state: AxesState,
    /// Settling time of an axis, s.
    settle: f64,
    /// Speed to the start angles in r/min.
    index_speed: f64,
    /// The feed override acts.
    overrides: bool,
    /// Deceleration (r/min per second) of each axis after an emergency stop that switches the drives off.
    coasting_deceleration: Option<[f64; PMC_AXES]>,
}

impl Axes {
    fn new(lathe: &PolygonLathe) -> Axes {
        let p = &lathe.params;
        Axes {
            state: AxesState::Rest,
            settle: p.settling(),
            index_speed: p.index_speed,
            overrides: lathe.overrides(),
            coasting_deceleration: p.coasts(lathe.control).then(|| p.coasting_deceleration()),
        }
    }

    /// Enters the state that the rungs request.
    fn enter(&mut self, t: f64, image: &Image, signals: &PlcSignals, orders: &mut PlcOrders) {
        let asked = |bits: [_; PMC_AXES]| bits.into_iter().any(|bit| image.is_on(bit));
        let coasts = self.coasting_deceleration.is_some() && signals.reset && signals.emergency;
        match self.state {
            AxesState::Coasting(..) => {}
            AxesState::Indexing(_) | AxesState::Turning if coasts => {
                self.state = AxesState::Coasting(t, orders.pmc_speed);
            }
            AxesState::Indexing(_) | AxesState::Turning if asked(STOP) => {
                self.state = AxesState::Stopping(t + self.settle)
            }
            AxesState::Stopping(until) if t >= until => self.state = AxesState::Rest,
            AxesState::Indexing(_) if asked(RUN) => self.state = AxesState::Turning,
            AxesState::Rest if asked(GO_TO_ANGLE) => {
                let travels: [f64; PMC_AXES] =
                    core::array::from_fn(|k| travel(signals.pmc_turns[k], image.number(ANGLE[k]) / 360_000.0));
                let sign = |travel: f64| if travel.abs() > 0.0 { travel.signum() } else { 0.0 };
                orders.pmc_speed = travels.map(|travel| self.index_speed * sign(travel));
                self.state = AxesState::Indexing(travels.map(|travel| t + travel.abs() * 60.0 / self.index_speed));
            }
            _ => {}
        }
    }

    /// Sets the speeds of the state; returns when the next one begins.
    fn turn(&mut self, t: f64, image: &Image, signals: &PlcSignals, orders: &mut PlcOrders) -> Option<f64> {
        match self.state {
            AxesState::Indexing(until) => {
                for (speed, until) in orders.pmc_speed.iter_mut().zip(until) {
                    if t >= until {
                        *speed = 0.0;
                    }
                }
                until.into_iter().filter(|until| *until > t).reduce(f64::min)
            }
            AxesState::Turning => {
                let share = if self.overrides { signals.knobs.feed / 100.0 } else { 1.0 };
                orders.pmc_speed = RPM.map(|speed| image.number(speed) * share);
                None
            }
            AxesState::Coasting(since, from) => {
                let deceleration = self.coasting_deceleration.unwrap_or([f64::INFINITY; PMC_AXES]);
                // In steps, each with the speed at its middle.
                let gone = t + 0.5 * STEP - since;
                orders.pmc_speed =
                    core::array::from_fn(|k| (from[k].abs() - deceleration[k] * gone).max(0.0).copysign(from[k]));
                if orders.pmc_speed == [0.0; PMC_AXES] {
                    self.state = AxesState::Stopping(t + self.settle);
                    return Some(t + self.settle);
                }
                Some(t + STEP)
            }
            AxesState::Rest | AxesState::Stopping(_) => {
                orders.pmc_speed = [0.0; PMC_AXES];
                if let AxesState::Stopping(until) = self.state { Some(until) } else { None }
            }
        }
    }
}

/// Travel of an axis to an angle, in turns: forward, or backward to a negative angle.
fn travel(now: f64, angle: f64) -> f64 {
    let left = angle - now;
    let whole = if angle < 0.0 { (left + SAME_ANGLE).ceil() } else { (left - SAME_ANGLE).floor() };
    // At the angle already.
    if (left - left.round()).abs() <= SAME_ANGLE { left - left.round() } else { left - whole }
}

impl NamedBlock for Axes {
    fn act(&mut self, t: f64, image: &mut Image, signals: &PlcSignals, orders: &mut PlcOrders) -> Option<f64> {
        self.enter(t, image, signals, orders);
        let next = self.turn(t, image, signals, orders);
        for (k, (done, at_standstill)) in DONE.into_iter().zip(AT_STANDSTILL).enumerate() {
            image
                .set(done, matches!(self.state, AxesState::Indexing(until) if until.get(k).is_some_and(|at| t >= *at)));
            image.set(at_standstill, self.state == AxesState::Rest);
        }
        next
    }

    fn boxed(&self) -> Box<dyn NamedBlock> {
        Box::new(self.clone())
    }
}

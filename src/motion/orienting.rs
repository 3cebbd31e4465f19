//! Bringing the spindle to an angle and holding it there.

use super::program::Program;
use super::signals::sense;
use super::spindle::{Ramp, SpindleMode, Told};
use super::state::Sim;
use crate::drives::orient::{Approach, Travel, first_travel, travel, turn};
use crate::msg;
use crate::text::Diagnostic;

/// The way of the spindle to an angle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Orienting {
    /// Where it ends, in turns since the run began; where it has to turn back first, that comes later.
    goal: f64,
    /// Direction.
    way: i8,
    travel: Travel,
    part: Part,
}

/// Parts of the way.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Part {
    /// To standstill: the target lies the other way.
    TurnsBack(f64, Approach),
    ToPeak,
    Steady,
    ToRest,
    Held,
}

impl Orienting {
    /// Whether it is there.
    fn is_held(&self) -> bool {
        self.part == Part::Held
    }
}

impl<P: Program> Sim<'_, P> {
    /// Whether the spindle is on its way to an angle.
    pub(super) fn orients(&self) -> bool {
        self.s.turning.orienting.is_some_and(|orienting| !orienting.is_held())
    }

    /// Begins to bring the spindle to an angle.
    pub(super) fn orient(&mut self, t: f64, target: f64, approach: Approach) {
        let plant = &self.machine.spindle;
        if plant.positioning.is_none() || !plant.encoder {
            let diagnostic = Diagnostic::error(msg!("motion.no-positioning")).alarm(self.machine.no_positioning);
            return self.stop_with(diagnostic);
        }
        self.s.turning.direction = 0;
        self.s.turning.surface = None;
        self.s.turning.locked = false;
        let last = self.out.timeline.ramps.last().copied().unwrap_or_default();
        self.s.turning.synced |= last.turns(plant, t).abs() >= 1.0;
        self.set_off(t, if target.is_finite() { target } else { 0.0 }, approach);
    }

    /// Sets off to an angle, or turns back first.
    fn set_off(&mut self, t: f64, target: f64, approach: Approach) {
        let plant = &self.machine.spindle;
        let Some(positioning) = plant.positioning else { return };
        let last = self.out.timeline.ramps.last().copied().unwrap_or_default();
        let (rpm, turns) = (last.actual(plant, t), last.turns(plant, t));
        let from = turn(turns * 360.0);
        let direction = sense(rpm);
        let degrees = if self.s.turning.synced || approach == Approach::Incremental {
            travel(from, target, approach, direction)
        } else {
            let clockwise = match approach {
                Approach::Clockwise => true,
                Approach::CounterClockwise => false,
                _ if direction != 0 => direction > 0,
                _ => positioning.clockwise,
            };
            first_travel(from, target, clockwise)
        };
        let way = match approach {
            // The present angle is ahead, too.
            _ if degrees == 0.0 => direction,
            _ => sense(degrees),
        };
        let goal = turns + degrees / 360.0;
        let (faster, slower) = (plant.acceleration(last.told.stage), positioning.acceleration);
        if direction != 0 && way != direction {
            let back = match approach {
                Approach::Incremental => Part::TurnsBack(goal * 360.0, approach),
                _ => Part::TurnsBack(target, approach),
            };
            self.s.turning.orienting = Some(Orienting { goal, way: direction, travel: Travel::default(), part: back });
            return self.part(t, rpm, 0.0, faster, rpm.abs() / faster);
        }
        let first = if rpm.abs() > positioning.speed { faster } else { slower };
        let travel = Travel::new(degrees.abs() / 360.0, rpm.abs(), positioning.speed, first, slower);
        let goal = goal + travel.more * f64::from(way);
        self.s.turning.orienting = Some(Orienting { goal, way, travel, part: Part::ToPeak });
        self.part(t, rpm, travel.peak * f64::from(way), first, travel.to_peak);
    }

    /// A part of the way is over.
    pub(super) fn travel_on(&mut self, t: f64) {
        let Some(orienting) = &mut self.s.turning.orienting else { return };
        let (peak, travel) = (orienting.travel.peak * f64::from(orienting.way), orienting.travel);
        let slower = self.machine.spindle.positioning.map_or(f64::INFINITY, |positioning| positioning.acceleration);
        match orienting.part {
            Part::TurnsBack(target, approach) => {
                let incremental = approach == Approach::Incremental;
                let last = self.out.timeline.ramps.last().copied().unwrap_or_default();
                let turns = last.turns(&self.machine.spindle, t);
                self.put(Ramp { t, start: 0.0, target: 0.0, rate: 0.0, turns, ..last });
                self.set_off(t, if incremental { target - turns * 360.0 } else { target }, approach);
            }
            Part::ToPeak => {
                orienting.part = Part::Steady;
                self.part(t, peak, peak, 0.0, travel.steady);
            }
            Part::Steady => {
                orienting.part = Part::ToRest;
                self.part(t, peak, 0.0, slower, travel.to_rest);
            }
            Part::ToRest => {
                orienting.part = Part::Held;
                let goal = orienting.goal;
                self.s.turning.synced = true;
                let last = self.out.timeline.ramps.last().copied().unwrap_or_default();
                let told = Told { sign: 0, stage: last.told.stage, ..Told::default() };
                self.s.io.spindle_command = 0.0;
                let control = SpindleMode::Held;
                self.put(Ramp { t, start: 0.0, target: 0.0, rate: 0.0, turns: goal, told, control, ..last });
            }
            Part::Held => {}
        }
    }

    /// Puts a part of the way, signed speeds, that takes some seconds; one that takes none is over at once.
    fn part(&mut self, t: f64, start: f64, target: f64, rate: f64, seconds: f64) {
        let last = self.out.timeline.ramps.last().copied().unwrap_or_default();
        let turns = last.turns(&self.machine.spindle, t);
        let sign = sense(start + target);
        let stage = last.told.stage;
        let told = Told { from: start.abs(), to: target.abs(), span: seconds, sign, stage, ..Told::default() };
        self.s.io.spindle_command = target;
        self.put(Ramp { t, start, target, rate, turns, told, control: SpindleMode::Position, ..last });
        if t + seconds > t {
            self.s.turning.reached_at = t + seconds;
        } else {
            self.s.turning.reached_at = f64::INFINITY;
            self.travel_on(t);
        }
    }
}

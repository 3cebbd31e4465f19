//! Spindle positioning: travel to an angle, and holding there.

use super::program::RunningProgram;
use super::sim::Sim;
use super::spindle::{InverterRamp, SpeedCommand, SpindleMode};
use super::spindle_control::{Orienting, TravelPart};
use crate::drives::Rotation;
use crate::drives::orient::{Approach, Travel, first_travel, travel, turn};
use crate::msg;
use crate::text::Diagnostic;

impl<P: RunningProgram> Sim<'_, P> {
    /// Whether the spindle is on its way to an angle.
    pub(super) fn orients(&self) -> bool {
        self.state.spindle.orienting.is_some_and(|orienting| !orienting.is_held())
    }

    /// Starts the travel of the spindle to an angle.
    pub(super) fn orient(&mut self, t: f64, target: f64, approach: Approach) {
        let plant = &self.plant.spindle;
        if plant.positioning.is_none() || !plant.encoder {
            let diagnostic = Diagnostic::error(msg!("motion.no-positioning")).alarm(self.plant.no_positioning);
            return self.stop_with(diagnostic);
        }
        self.state.spindle.rotation = Rotation::Stopped;
        self.state.spindle.surface = None;
        self.state.spindle.locked = false;
        let last = self.out.timeline.ramps.last().copied().unwrap_or_default();
        self.state.spindle.synced |= last.turns(plant, t).abs() >= 1.0;
        self.set_off(t, if target.is_finite() { target } else { 0.0 }, approach);
    }

    /// Starts towards the angle, or turns back first.
    fn set_off(&mut self, t: f64, target: f64, approach: Approach) {
        let plant = &self.plant.spindle;
        let Some(positioning) = plant.positioning else { return };
        let last = self.out.timeline.ramps.last().copied().unwrap_or_default();
        let (rpm, turns) = (last.actual(plant, t), last.turns(plant, t));
        let from = turn(turns * 360.0);
        let present = Rotation::of(rpm);
        let degrees = if self.state.spindle.synced || approach == Approach::Incremental {
            travel(from, target, approach, present)
        } else {
            let clockwise = match approach {
                Approach::Clockwise => true,
                Approach::CounterClockwise => false,
                _ if present != Rotation::Stopped => present == Rotation::Clockwise,
                _ => positioning.clockwise,
            };
            first_travel(from, target, clockwise)
        };
        // An absolute angle equal to the present one lies ahead, too.
        let rotation = if degrees == 0.0 { present } else { Rotation::of(degrees) };
        let goal = turns + degrees / 360.0;
        let (faster, slower) = (plant.acceleration(last.command.stage), positioning.acceleration);
        if present != Rotation::Stopped && rotation != present {
            let back = match approach {
                Approach::Incremental => TravelPart::TurnsBack(goal * 360.0, approach),
                _ => TravelPart::TurnsBack(target, approach),
            };
            self.state.spindle.orienting =
                Some(Orienting { goal, rotation: present, travel: Travel::default(), part: back });
            return self.put_travel_part(t, rpm, 0.0, faster, rpm.abs() / faster);
        }
        let first = if rpm.abs() > positioning.speed { faster } else { slower };
        let travel = Travel::new(degrees.abs() / 360.0, rpm.abs(), positioning.speed, first, slower);
        let goal = goal + travel.more * rotation.sign();
        self.state.spindle.orienting = Some(Orienting { goal, rotation, travel, part: TravelPart::ToPeak });
        self.put_travel_part(t, rpm, travel.peak * rotation.sign(), first, travel.to_peak);
    }

    /// Ends a part of the travel to an angle and starts the next.
    pub(super) fn travel_on(&mut self, t: f64) {
        let Some(orienting) = &mut self.state.spindle.orienting else { return };
        let (peak, travel) = (orienting.travel.peak * orienting.rotation.sign(), orienting.travel);
        let slower = self.plant.spindle.positioning.map_or(f64::INFINITY, |positioning| positioning.acceleration);
        match orienting.part {
            TravelPart::TurnsBack(target, approach) => {
                let incremental = approach == Approach::Incremental;
                let last = self.out.timeline.ramps.last().copied().unwrap_or_default();
                let turns = last.turns(&self.plant.spindle, t);
                self.put(InverterRamp { t, start: 0.0, target: 0.0, rate: 0.0, turns, ..last });
                self.set_off(t, if incremental { target - turns * 360.0 } else { target }, approach);
            }
            TravelPart::ToPeak => {
                orienting.part = TravelPart::Steady;
                self.put_travel_part(t, peak, peak, 0.0, travel.steady);
            }
            TravelPart::Steady => {
                orienting.part = TravelPart::ToRest;
                self.put_travel_part(t, peak, 0.0, slower, travel.to_rest);
            }
            TravelPart::ToRest => {
                orienting.part = TravelPart::Held;
                let goal = orienting.goal;
                self.state.spindle.synced = true;
                let last = self.out.timeline.ramps.last().copied().unwrap_or_default();
                let command = SpeedCommand { stage: last.command.stage, ..SpeedCommand::default() };
                self.state.plc.signals.spindle_command = 0.0;
                let control = SpindleMode::Held;
                self.put(InverterRamp { t, start: 0.0, target: 0.0, rate: 0.0, turns: goal, command, control, ..last });
            }
            TravelPart::Held => {}
        }
    }

    /// Records a part of the travel with signed speeds (r/min) and its duration (s); a part without duration ends at once.
    fn put_travel_part(&mut self, t: f64, start: f64, target: f64, rate: f64, seconds: f64) {
        let last = self.out.timeline.ramps.last().copied().unwrap_or_default();
        let turns = last.turns(&self.plant.spindle, t);
        let rotation = Rotation::of(start + target);
        let stage = last.command.stage;
        let command = SpeedCommand {
            from: start.abs(),
            to: target.abs(),
            span: seconds,
            rotation,
            stage,
            ..SpeedCommand::default()
        };
        self.state.plc.signals.spindle_command = target;
        self.put(InverterRamp { t, start, target, rate, turns, command, control: SpindleMode::Position, ..last });
        if t + seconds > t {
            self.state.spindle.reached_at = t + seconds;
        } else {
            self.state.spindle.reached_at = f64::INFINITY;
            self.travel_on(t);
        }
    }
}

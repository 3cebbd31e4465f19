//! Mechanics of the ribbon line's drives: the loads at the shafts of their motors, and the demand of start, run and stop of a product.

use super::axes::PerAxis;
use super::derive::Derived;
use super::params::{AxisParams, Params, PathMode, ServoParams};
use super::reel;
use crate::drives::block;
use crate::drives::duty::{counted_pause, with_pause};
use crate::drives::inertia::{self, CM2, Cylinder, STEEL};
use crate::drives::load::{self, Load, Move, effective};
use crate::drives::servo::{Acceptance, FittedMotor, MotorDemand, Servo, Shares};
use crate::drives::web::Nip;
use crate::math::RPM;

/// Share (%) of the nip's holding force that may be used: a safety of 2 against slip. Source: sizing facts 2.2, from memory.
pub(super) const GRIP: f64 = 50.0;

/// A servo axis with its motor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ServoAxis {
    /// Load at the motor's shaft, without the rotor.
    pub load: Load,
    pub fitted: FittedMotor,
    /// Load at the output of the gear.
    pub output: Load,
    /// Seconds of a ramp.
    pub ramp: f64,
    /// Torque at standstill, Nm.
    pub hold: f64,
    /// Torque of the ramp besides the steady one, Nm.
    pub rise: f64,
    /// Torque at steady speed with the ribbon at its tautest, at the motor and at the output of the gear, Nm.
    pub taut: f64,
    pub output_taut: f64,
    /// Mean speed of the motor over a cycle with its pause, r/min.
    pub mean_speed: f64,
    pub demand: MotorDemand,
}

/// The drives of the line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mechanics {
    pub axes: PerAxis<ServoAxis>,
    /// Greatest tension of the ribbon before X over the range of the knob, N.
    pub tautest: f64,
    /// Greatest used share of the nip's holding force, and the share that the tautest ribbon uses.
    pub nip_use: f64,
    pub taut_nip_use: f64,
    /// Tension (N) that the ribbon before X may have: half its tensile strength, or the tension that the nip holds with
    /// its safety, `T2 + GRIP · μ · N`, if that is less; and the tension at which the ribbon tears or slips. Source:
    /// ribbon line facts, 11.
    pub allowed_tension: f64,
    pub slip_or_break_tension: f64,
    /// Steady torque at the press roller, Nm.
    pub unwound: f64,
    /// Steady torque of the unwinder's motor, Nm.
    pub unwinder: f64,
    /// Its torque over the inverter's ramp, Nm.
    pub unwinder_ramp: f64,
    /// Its braking torque over the same ramp in a stop, Nm; 0 where web and friction stop it sooner.
    pub unwinder_braking: f64,
}

/// The shaft of a roller behind the gear of its motor, with torques at the roller.
struct RollerShaft {
    /// Moment of inertia of all parts that turn with the roller, and of the ribbon, kg m².
    turning: f64,
    /// Torque at steady speed, Nm.
    torque: f64,
    /// Torque with the ribbon at its tautest, Nm.
    taut: f64,
    /// Torque at standstill, Nm.
    hold: f64,
    /// Speed of the motor, r/min.
    rpm: f64,
}

impl ServoAxis {
    fn new(shaft: &RollerShaft, axis: &AxisParams, p: &Params, d: &Derived) -> ServoAxis {
        let motor = servo(&axis.motor);
        let (ratio, efficiency) = (axis.gear, axis.efficiency / 100.0);
        let load = Load {
            inertia: inertia::through_gear(shaft.turning, ratio) + axis.gear_inertia * CM2,
            torque: load::through_gear(shaft.torque, ratio, efficiency),
            efficiency,
        };
        let ramp = block::ramp(axis.time_constant / 1e3, axis.position_gain);
        let speed = shaft.rpm * RPM;
        let rise = load.accelerating(motor.rotor, speed, ramp);
        let hold = shaft.hold / ratio;
        let output = Load { inertia: shaft.turning, torque: shaft.torque, efficiency: 1.0 };
        let repeated = motion(p, d, (speed, ramp), hold);
        let mean_speed = repeated.map_or(0.0, |of| mean_speed(&of, d.product.time, p.pause));
        let phases = repeated.map(|of| load.phases(motor.rotor, of));
        let effective = phases.as_ref().map_or(load.torque, |phases| effective(phases));
        let effective = with_pause(effective, d.product.time, p.pause, hold);
        // An overhauling load needs more torque in the stop or at standstill than in the start.
        let others = phases.iter().flatten().map(|phase| phase.torque.abs());
        let taut = load::through_gear(shaft.taut, ratio, efficiency);
        let peak = others.fold((load.torque + rise).abs().max(taut.abs()), f64::max);
        let demand = MotorDemand { peak, effective, speed: shaft.rpm };
        let limits = Acceptance::of_form(axis.motor.inertia_limit, axis.motor.effective_limit);
        let limits = limits.at_starts(starts(p, d)).derated(p.site().share());
        ServoAxis {
            load,
            output,
            fitted: FittedMotor { motor, limits },
            ramp,
            hold,
            rise,
            taut,
            output_taut: shaft.taut,
            mean_speed,
            demand,
        }
    }

    /// Demand of the run as shares of the motor's ratings.
    pub(super) fn shares(&self) -> Shares {
        self.fitted.motor.shares(&self.load, &self.demand)
    }

    /// Greatest torque (Nm) of a ramp between rest and `rpm` of the motor, up with `T_L + (J_L / η + J_M) · ω / t` or down with
    /// `|T_L - (J_L · η + J_M) · ω / t|`. Source: sizing facts 2.2.
    pub(super) fn ramp_torque(&self, rpm: f64) -> f64 {
        let (rise, fall) = self.ramp_torques(rpm);
        (self.load.torque + rise).abs().max((self.load.torque - fall).abs())
    }

    /// Torques (Nm) of such a ramp, up and down, besides the steady one.
    fn ramp_torques(&self, rpm: f64) -> (f64, f64) {
        let (rotor, speed) = (self.fitted.motor.rotor, rpm * RPM);
        (self.load.accelerating(rotor, speed, self.ramp), self.load.braking(rotor, speed, self.ramp))
    }

    /// Greatest share of `rpm` whose ramp takes a torque that the limits allow at that speed; 0 or less if the steady torque alone takes
    /// more.
    pub(super) fn allowed_share(&self, rpm: f64) -> f64 {
        let (steady, (rise, fall)) = (self.load.torque, self.ramp_torques(rpm));
        let within = |torque: f64| ((torque - steady) / rise).min((torque + steady) / fall);
        let (there, below_rated) = (self.fitted.short_time_limit(rpm), self.fitted.short_time_limit(0.0));
        within(there).max(within(below_rated).min(self.fitted.motor.rated_speed / rpm))
    }

    /// Shortest ramp (s), up and down, with the torque that the limits allow; infinite if standstill alone needs more.
    pub(super) fn shortest_ramp(&self) -> f64 {
        let torque = self.fitted.short_time_limit(self.demand.speed);
        let speed = self.demand.speed * RPM;
        let left = torque + self.load.torque;
        if left <= 0.0 || self.hold.abs() > torque {
            return f64::INFINITY;
        }
        let fall = self.load.braking(self.fitted.motor.rotor, speed, 1.0) / left;
        self.load.shortest_ramp(self.fitted.motor.rotor, speed, torque).max(fall)
    }

    /// Whether the torque at the teeth of its gear changes its sign while dots are printed: without a steady torque, and at exact stop
    /// where the load is braked with more than that. The rotor is in front of the teeth.
    pub(super) fn reverses(&self, path_mode: PathMode) -> bool {
        let (load, speed) = (&self.load, self.demand.speed * RPM);
        let driven = load.torque + load.accelerating(0.0, speed, self.ramp);
        let braked = load.torque - load.braking(0.0, speed, self.ramp);
        match path_mode {
            PathMode::Continuous => load.torque == 0.0,
            PathMode::ExactStop => driven * braked <= 0.0,
        }
    }

    /// Energy in J that a stop gives back, from its speed or from the highest one of its motor.
    pub(super) fn stop_energy(&self) -> f64 {
        let speed = self.demand.speed.min(self.fitted.motor.top_speed) * RPM;
        self.load.stop_energy(self.fitted.motor.rotor, speed, self.ramp).max(0.0)
    }
}

/// Starts of the axes per minute; each block with exact stop is a start.
fn starts(p: &Params, d: &Derived) -> f64 {
    match p.path_mode {
        PathMode::ExactStop if d.timing.exact_stop > 0.0 => 60.0 / d.timing.exact_stop,
        _ => 0.0,
    }
}

/// The move that an axis repeats: a block with exact stop, or a whole product; none at standstill. A ramp that is longer than its block
/// does not reach the speed (sizing facts, section 4).
fn motion(p: &Params, d: &Derived, (speed, ramp): (f64, f64), hold: f64) -> Option<Move> {
    let (run, cycle) = match p.path_mode {
        PathMode::ExactStop => (d.timing.block, d.timing.exact_stop),
        PathMode::Continuous => (p.count() * d.timing.pitch / d.timing.kept, d.product.time),
    };
    let reached = (run / ramp).min(1.0);
    let found = Move {
        speed: speed * reached,
        ramp: run.min(ramp),
        seconds_at_speed: (run - ramp).abs(),
        pause: (cycle - run - ramp).max(0.0),
        hold,
    };
    found.cycle().is_finite().then_some(found)
}

/// Mean speed (r/min) of a repeated move over a run (s) and the pause (s) after it.
fn mean_speed(of: &Move, run: f64, pause: f64) -> f64 {
    let running = of.speed * (of.ramp + of.seconds_at_speed) / of.cycle() / RPM;
    running * run / (run + counted_pause(run, pause))
}

/// Steady torque (Nm) at the press roller with a brake of the reel in N. Source: sizing facts D1.
fn unwound(p: &Params, brake: f64) -> f64 {
    brake * p.press_roller_diameter / 2e3 + p.unwinding.friction
}

/// Steady torque (Nm) at the unwinder's motor with a brake of the reel in N.
pub(super) fn unwinder_torque(p: &Params, brake: f64) -> f64 {
    load::through_gear(unwound(p, brake), p.reduction_ratio, p.unwinding.efficiency / 100.0)
}

/// Load of the unwinder's motor: its own rotor, and the reel at the diameter with the greatest mass at the web, full or at the core. The
/// gear's losses count as if the motor drove the reel: a stop driven by the reel is shorter.
pub(super) fn unwinder_load(p: &Params, torque: f64) -> Load {
    let reel = reel::wound(p);
    let at_roller = inertia::at_radius(reel.mass_at_web(reel.worst()), p.press_roller_diameter / 2e3);
    let at_shaft = inertia::through_gear(at_roller, p.reduction_ratio) / (p.unwinding.efficiency / 100.0);
    Load { inertia: p.unwinding.inertia * CM2 + at_shaft, torque, efficiency: 1.0 }
}

/// A hollow roller in mm as a cylinder of steel; a wall that is thicker than the radius fills it.
fn roller(diameter: f64, wall: f64, length: f64) -> Cylinder {
    let metres = |mm: f64| mm / 1e3;
    Cylinder {
        outer: metres(diameter),
        inner: metres((diameter - 2.0 * wall).max(0.0)),
        length: metres(length),
        density: STEEL,
    }
}

/// The motor of the form.
fn servo(of: &ServoParams) -> Servo {
    Servo {
        rated: of.rated,
        stall: of.stall,
        peak: of.peak,
        rated_speed: of.rated_speed,
        top_speed: of.top_speed,
        rotor: of.rotor * CM2,
    }
}

/// The shaft of the pull roller, with the pinch roller and the ribbon (kg) between the rollers; with the greatest tension (N) of the ribbon
/// before X.
fn pull_shaft(p: &Params, d: &Derived, web_mass: f64, tautest: f64) -> RollerShaft {
    let (web, axis, pinch) = (&p.web, &p.axes.pull, &p.pinch);
    let radius = p.x_roller_diameter / 2e3;
    let pinch_inertia = inertia::solid(pinch.mass, pinch.diameter / 1e3);
    RollerShaft {
        turning: roller(p.x_roller_diameter, axis.wall, axis.length).inertia()
            + inertia::across_web(pinch_inertia, pinch.diameter, p.x_roller_diameter)
            + inertia::at_radius(web_mass, radius),
        torque: (web.tension_before - web.tension_behind) * radius + axis.friction,
        taut: (tautest - web.tension_behind) * radius + axis.friction,
        hold: (web.tension_before - web.tension_behind) * radius,
        rpm: d.feeds.motor_speeds.pull,
    }
}

/// The shaft of the print roller with its heads.
fn print_shaft(p: &Params, d: &Derived) -> RollerShaft {
    let (axis, head) = (&p.axes.print, &p.head);
    let radius = p.print_roller_diameter / 2e3;
    let torque = head.force * radius + axis.friction;
    RollerShaft {
        turning: roller(p.print_roller_diameter, axis.wall, axis.length).inertia()
            + p.heads * inertia::at_radius(head.mass, radius),
        torque,
        taut: torque,
        hold: 0.0,
        rpm: d.feeds.motor_speeds.print,
    }
}

impl Mechanics {
    /// The drives with the line at the speed of its results, and with the greatest tension (N) of the ribbon before X.
    pub(super) fn new(p: &Params, d: &Derived, tautest: f64) -> Mechanics {
        let web = &p.web;
        let web_mass = p.ribbon_area() * web.span * 1e-9 * web.density;
        let nip = Nip { friction: p.pinch.friction, force: p.pinch.force };
        let slip = web.tension_behind + nip.friction * nip.force;
        // The motor holds no more than the nip passes on.
        let passed_on = tautest.min(slip.max(web.tension_before));
        let axes = PerAxis {
            pull: ServoAxis::new(&pull_shaft(p, d, web_mass, passed_on), &p.axes.pull, p, d),
            print: ServoAxis::new(&print_shaft(p, d), &p.axes.print, p, d),
        };
        let acceleration = d.feeds.line_speed / 60e3 / axes.pull.ramp;
        let tension = web.tension_before - web.tension_behind;
        let unwinder = unwinder_torque(p, p.unwinding.brake);
        // The load includes the gear's losses in its inertia, so run-up and stop need the same torque.
        let unwinder_rise = unwinder_load(p, unwinder).accelerating(0.0, p.speed_at_10v * RPM, p.inverter_ramp);
        let running = nip.used_share(tension, web_mass * acceleration);
        let taut_nip_use = nip.used_share(tautest - web.tension_behind, 0.0);
        Mechanics {
            axes,
            tautest,
            nip_use: running.max(taut_nip_use),
            taut_nip_use,
            allowed_tension: d.tension.allowed.min(web.tension_behind + GRIP / 100.0 * nip.friction * nip.force),
            slip_or_break_tension: d.tension.breaking.min(slip),
            unwound: unwound(p, p.unwinding.brake),
            unwinder,
            unwinder_ramp: unwinder + unwinder_rise,
            unwinder_braking: (unwinder_rise - unwinder).max(0.0),
        }
    }
}

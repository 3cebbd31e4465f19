//! Sizing against an independent calculation: the scalars, cams and motors of `sizing/oracle.json`.
//!
//! Another program wrote them from the formulas and inputs of `docs/reference/sizing.md`.

mod by_hand;
mod cams;
mod chance;
mod choice;
mod derating;
mod dots;
mod energy;
mod envelope;
mod gears;
mod growth;
mod inverters;
mod rated_torque;
mod reel;
mod resistors;
mod sections;
mod slides;
mod taut;
mod timeline;
mod tornado;
mod trials;
mod unwinder;
mod wiring;

use std::collections::BTreeMap;

use macroline::drives::block::AxisBlock;
use macroline::drives::cam::{Coefficients, Correction, Law};
use macroline::drives::induction::Induction;
use macroline::drives::inertia::{self, Cylinder, STEEL};
use macroline::drives::load::{self, Load, Move, Phase, Regeneration, effective};
use macroline::drives::servo::{Acceptance, MotorDemand, Servo, ServoRefusal};
use macroline::drives::web::{self, Nip};
use macroline::machines::form;
use macroline::math::{self, PI};
use macroline::project::Project;
use serde_json::Value;

/// Relative difference that two calculations in double precision may have.
const SAME: f64 = 1e-9;

fn oracle() -> Value {
    serde_json::from_str(include_str!("sizing/oracle.json")).unwrap()
}

fn same(name: &str, own: f64, other: f64, within: f64) {
    let difference = (own - other).abs();
    assert!(difference <= within * other.abs().max(1e-12), "{name}: {own} here, {other} there");
}

/// The ribbon line with these entries of its form, and with the brake before the pull rollers that the facts assume: 15 N.
fn line(entries: &[(&str, f64)]) -> Project {
    let mut project = Project::named("ribbon-line", None, None).unwrap();
    for (id, number) in [("tension-before", 15.0)].iter().chain(entries) {
        assert!(project.machine.fields().iter().any(|field| field.id == *id), "{id}");
        project.values.insert((*id).to_owned(), form::Value::Number(*number));
    }
    project
}

// The inputs of the paper, and the mechanics that the facts assume for it. SI units.
const SPEED: f64 = 1200.0;
const UNWINDER_GEAR: f64 = 25.0;
const UNWINDER: f64 = 0.1;
const PITCH: f64 = 0.008;
const HEADS: f64 = 6.0;
const PRINT_ROLLER: f64 = 0.12;
const AT_10_V: f64 = 1480.0;
const CONTACT: f64 = 0.002;
const TAU: f64 = 0.1;
const GAIN: f64 = 33.0;
const WEB: (f64, f64) = (0.02, 0.0005);
const SPAN: f64 = 2.0;
const RAMP: f64 = 2.0;

/// Speed of the web, m/s.
fn web_speed() -> f64 {
    PI * UNWINDER / UNWINDER_GEAR * SPEED / 60.0
}

/// Seconds of a pitch.
fn pitch_time() -> f64 {
    PITCH / web_speed()
}

fn arc() -> f64 {
    PI * PRINT_ROLLER / HEADS
}

/// An axis of the line: its load, gear, and speed of its motor in r/min.
struct Axis {
    load: Load,
    rpm: f64,
}

impl Axis {
    fn speed(&self) -> f64 {
        self.rpm * 2.0 * PI / 60.0
    }

    /// A move per pitch, with ramps of 30 ms and a pause of 40 ms.
    fn step_by_step(&self) -> Move {
        Move { speed: self.speed(), ramp: 0.03, seconds_at_speed: pitch_time() - 0.03, pause: 0.04, hold: 0.0 }
    }

    fn peak(&self, motor: &Servo) -> f64 {
        self.load.torque + self.load.accelerating(motor.rotor, self.speed(), TAU)
    }
}

const PULL_ROLLER: Cylinder = Cylinder { outer: 0.1, inner: 0.08, length: 0.2, density: STEEL };
const GEAR: f64 = 0.6e-4;

fn pinch() -> f64 {
    inertia::across_web(inertia::solid(3.0, 0.08), 0.08, PULL_ROLLER.outer)
}

fn web_mass() -> f64 {
    WEB.0 * WEB.1 * SPAN * 1300.0
}

fn pull() -> Axis {
    let turning = PULL_ROLLER.inertia() + pinch() + inertia::at_radius(web_mass(), PULL_ROLLER.outer / 2.0);
    let torque = load::through_gear(15.0 * PULL_ROLLER.outer / 2.0 + 0.3, 10.0, 0.95);
    Axis {
        load: Load { inertia: inertia::through_gear(turning, 10.0) + GEAR, torque, efficiency: 0.95 },
        rpm: web_speed() / (PI * PULL_ROLLER.outer) * 60.0 * 10.0,
    }
}

fn print_roller(outer: f64) -> Cylinder {
    Cylinder { outer, inner: outer - 0.02, length: 0.15, density: STEEL }
}

/// The print roller with heads of 0.9 kg together.
fn print_inertia(outer: f64) -> f64 {
    print_roller(outer).inertia() + inertia::at_radius(0.9, outer / 2.0)
}

fn print() -> Axis {
    let torque = load::through_gear(0.4 + 5.0 * PRINT_ROLLER / 2.0, 5.0, 0.95);
    Axis {
        load: Load {
            inertia: inertia::through_gear(print_inertia(PRINT_ROLLER), 5.0) + GEAR,
            torque,
            efficiency: 0.95,
        },
        rpm: arc() / pitch_time() / (PI * PRINT_ROLLER) * 60.0 * 5.0,
    }
}

/// The motors of the facts that are judged.
pub(super) const MOTORS: [&str; 9] =
    ["HG-KN23J", "HG-KN43J", "HG-KN73J", "HC52", "HC53", "HC102", "HC103", "HC103R", "HC153R"];

/// Motors of the facts, section 5.
pub(super) fn motor(name: &str) -> Servo {
    let [rated, stall, peak, rated_speed, top_speed, rotor] = match name {
        "HG-KN23J" => [0.64, 0.64, 1.9, 3000.0, 5000.0, 0.225],
        "HG-KN43J" => [1.3, 1.3, 3.8, 3000.0, 5000.0, 0.375],
        "HG-KN73J" => [2.4, 2.4, 7.2, 3000.0, 5000.0, 1.28],
        "HC52" => [2.39, 2.94, 11.8, 2000.0, 2000.0, 6.6],
        "HC53" => [1.59, 2.94, 8.82, 3000.0, 3000.0, 6.6],
        "HC102" => [4.78, 5.88, 21.6, 2000.0, 2000.0, 13.7],
        "HC103" => [3.18, 5.88, 16.7, 3000.0, 3000.0, 13.7],
        "HC103R" => [3.18, 3.18, 7.95, 3000.0, 3000.0, 1.5],
        "HC153R" => [4.77, 4.77, 11.9, 3000.0, 3000.0, 1.9],
        other => panic!("no ratings of {other}"),
    };
    Servo { rated, stall, peak, rated_speed, top_speed, rotor: rotor * 1e-4 }
}

pub(super) fn inertia_limit(name: &str) -> f64 {
    if name.starts_with("HC") { 5.0 } else { 15.0 }
}

fn unwinder(load: f64) -> Induction {
    Induction { full_command: AT_10_V, no_load: 1500.0, rated: 1430.0, load }
}

/// A block of one pitch alone.
fn block(time_constant: f64) -> AxisBlock {
    AxisBlock { interpolation: pitch_time(), speed: web_speed() * 1e3, time_constant, position_gain: GAIN }
}

/// The cam of a print roller with `heads` heads.
fn cam(outer: f64, heads: f64) -> Correction {
    Correction { pitch: PITCH, contact: CONTACT, arc: PI * outer / heads, speed: web_speed() }
}

/// Torque at the shaft of the print motor per m/s² of the roller's surface.
fn surface(outer: f64) -> f64 {
    let load = Load { inertia: inertia::through_gear(print_inertia(outer), 5.0) + GEAR, ..print().load };
    load.accelerating(motor("HC53").rotor, 5.0 / (outer / 2.0), 1.0)
}

fn kinematics() -> Vec<(&'static str, f64)> {
    let v = web_speed();
    vec![
        ("A1", v * 1e3),
        ("A2", v * 6e4),
        ("A3", arc() * 1e3),
        ("A4", v * math::hypot(PITCH, arc()) / PITCH * 6e4),
        ("A5", pitch_time() * 1e3),
        ("A6", 1.0 / pitch_time()),
        ("A7", arc() / pitch_time() * 1e3),
        ("A8", print().rpm / 5.0),
        ("A9", pull().rpm),
        ("A10", print().rpm),
        ("A11", 10.0 * SPEED / AT_10_V),
    ]
}

fn pulling() -> Vec<(&'static str, f64)> {
    let (axis, motor) = (pull(), motor("HG-KN43J"));
    let (load, peak) = (axis.load, axis.peak(&motor));
    let phases = load.phases(motor.rotor, axis.step_by_step());
    vec![
        ("B1", PULL_ROLLER.mass()),
        ("B2", PULL_ROLLER.inertia()),
        ("B3", pinch()),
        ("B4", web_mass()),
        ("B5", load.inertia * 1e4),
        ("B6", load.inertia / motor.rotor),
        ("B7", load.torque),
        ("B8", load.accelerating(motor.rotor, axis.speed(), TAU)),
        ("B9", peak),
        ("B10", 100.0 * peak / motor.peak),
        ("B11", 1e3 * load.shortest_ramp(motor.rotor, axis.speed(), 0.8 * motor.peak)),
        ("B12", 1e3 * axis.step_by_step().cycle()),
        ("B13", 60.0 / axis.step_by_step().cycle()),
        ("B14", phases[0].torque),
        ("B15", phases[2].torque),
        ("B16", effective(&phases)),
        ("B17", 100.0 * effective(&phases) / motor.rated),
        ("B18", 100.0 * load.torque / motor.rated),
        ("B19", 1.0 / Nip { friction: 0.4, force: 100.0 }.used_share(15.0, web_mass() * (web_speed() / TAU))),
    ]
}

fn printing() -> Vec<(&'static str, f64)> {
    let (axis, motor) = (print(), motor("HC53"));
    let (load, peak) = (axis.load, axis.peak(&motor));
    let phases = load.phases(motor.rotor, axis.step_by_step());
    let returned = load::returned(phases[2], axis.speed());
    let resistor = Regeneration { efficiency: 0.8, capacitor: 18.0 }.to_resistor(returned);
    vec![
        ("C1", print_roller(PRINT_ROLLER).mass()),
        ("C2", print_roller(PRINT_ROLLER).inertia()),
        ("C3", HEADS * inertia::at_radius(0.15, PRINT_ROLLER / 2.0)),
        ("C4", load.inertia * 1e4),
        ("C5", load.inertia / motor.rotor),
        ("C6", load.torque),
        ("C7", load.accelerating(motor.rotor, axis.speed(), TAU)),
        ("C8", peak),
        ("C9", 100.0 * peak / motor.peak),
        ("C10", 1e3 * load.shortest_ramp(motor.rotor, axis.speed(), 0.8 * motor.peak)),
        ("C11", phases[0].torque),
        ("C12", 100.0 * phases[0].torque / motor.peak),
        ("C13", effective(&phases)),
        ("C14", 100.0 * effective(&phases) / motor.stall),
        ("C15", load.stop_energy(motor.rotor, axis.speed(), TAU)),
        ("C16", 0.5 * (load.inertia + motor.rotor) * axis.speed() * axis.speed()),
        ("C17", returned),
        ("C18", resistor),
        ("C19", resistor / axis.step_by_step().cycle()),
        ("C20", inertia::best_ratio(print_inertia(PRINT_ROLLER), motor.rotor + GEAR)),
    ]
}

fn unwinding() -> Vec<(&'static str, f64)> {
    let (v, area) = (web_speed(), WEB.0 * WEB.1 * 1e6);
    let torque = load::through_gear(20.0 * UNWINDER / 2.0 + 1.0, UNWINDER_GEAR, 0.7);
    let (light, full) = (unwinder(torque / 5.0), unwinder(1.0));
    let step = AT_10_V / 4095.0;
    let half = 0.5 * step / SPEED;
    vec![
        ("D1", torque),
        ("D2", 50.0 * SPEED / AT_10_V),
        ("D3", light.gain() * SPEED),
        ("D4", light.slip()),
        ("D5", light.speed(SPEED)),
        ("D6", 100.0 * light.error(SPEED)),
        ("D7", v * light.error(SPEED) * 6e4),
        ("D8", 100.0 * full.error(SPEED)),
        ("D9", v * full.error(SPEED) * 6e4),
        ("D10", 100.0 * full.slip() / SPEED),
        ("D11", web::draw_tension(20.0, area, 0.01)),
        ("D12", web::draw_tension(3000.0, area, 0.01)),
        ("D13", SPAN / v),
        ("D14", step),
        ("D15", 100.0 * half),
        ("D16", half * v * 6e4),
        ("D17", 1500.0 * 0.05 / 50.0),
        ("D18", 1500.0 * 0.05 / 50.0 / SPEED * v * 6e4),
        ("D19", 0.01 * v * 1e3),
        ("D20", 100.0 * AT_10_V / SPEED),
        ("D21", (1.0 - 314.0 / 100.0 / PI) * v * 6e4),
        ("D22", 100.0 * WEB.1 / UNWINDER),
        ("D23", web::slack_after_start(v * 1e3, RAMP, TAU, RAMP)),
        ("D24", web::slack_after_start(v * 1e3, RAMP, TAU, 0.0)),
        ("D25", web::slack_after_stop(v * 1e3, RAMP, TAU, 0.0)),
        ("D26", 0.5 / (v * light.error(SPEED))),
        ("D27", 0.5 / (v * full.error(SPEED)).abs()),
    ]
}

fn dots() -> Vec<(&'static str, f64)> {
    let (motor, load, law) = (motor("HC53"), print().load, Law::Polynomial345.coefficients());
    let forty = cam(PRINT_ROLLER, 40.0);
    let most = 0.8 * motor.stall;
    let warms = (most * most - load.torque * load.torque).sqrt();
    let moving = surface(PRINT_ROLLER) * forty.effective_acceleration(law);
    vec![
        ("E1", arc() / PITCH),
        ("E2", HEADS * PITCH / PI * 1e3),
        ("E3", PI * PRINT_ROLLER / PITCH),
        ("E4", 47.0 * PITCH / PI * 1e3),
        ("E5", 48.0 * PITCH / PI * 1e3),
        ("E6", forty.longest_lag(law) * 1e3),
        ("E7", forty.speed_at(law, (0.8 * motor.peak - load.torque) / surface(PRINT_ROLLER)) * 1e3),
        ("E8", web_speed() * (warms / moving).sqrt() * 1e3),
        ("E9", web::mark_length(3.0, arc() / PITCH, CONTACT * 1e3)),
        ("E10", contact_length(60.0, 0.02)),
        ("E11", 100.0 * 0.05 / 2.0),
    ]
}

/// Contact length of a roller of radius `radius`, pressed `depth` into a flat counter surface: `2 √(2 R δ)`, in their unit.
fn contact_length(radius: f64, depth: f64) -> f64 {
    2.0 * (2.0 * radius * depth).sqrt()
}

/// Seconds after the end of the interpolation until a block after an exponential filter is within `width` millimetres of its end:
/// `τ ln(F τ (1 - e^(-T / τ)) / w)`.
fn exponential_tail(block: &AxisBlock, width: f64) -> f64 {
    let tau = block.time_constant;
    let rest = block.speed * tau * (1.0 - math::exp(-block.interpolation / tau));
    tau * math::ln(rest / width).max(0.0)
}

/// Seconds and highest speed of a move of `length` from rest to rest at a constant acceleration, `speed` at most: `L / F + F / a`, or `2 √(L / a)`
/// where the speed is not reached.
fn accelerated(length: f64, speed: f64, acceleration: f64) -> (f64, f64) {
    if length >= speed * speed / acceleration {
        (length / speed + speed / acceleration, speed)
    } else {
        (2.0 * (length / acceleration).sqrt(), (length * acceleration).sqrt())
    }
}

fn blocks() -> Vec<(&'static str, f64)> {
    let (slow, quick, v) = (block(TAU), block(0.03), web_speed() * 1e3);
    let needed = 0.0071 + 4.0 * 0.003;
    vec![
        ("F1", slow.duration() * 1e3),
        ("F2", slow.peak_speed()),
        ("F3", slow.lag_at_end()),
        ("F4", slow.settling(0.02) * 1e3),
        ("F5", slow.exact_stop(0.02) * 1e3),
        ("F6", 100.0 * pitch_time() / slow.exact_stop(0.02)),
        ("F7", quick.exact_stop(0.02) * 1e3),
        ("F8", 100.0 * pitch_time() / quick.exact_stop(0.02)),
        ("F9", exponential_tail(&quick, 0.02) * 1e3),
        ("F10", accelerated(8.0, v, 5e3).0 * 1e3),
        ("F11", accelerated(8.0, v, 5e3).1),
        ("F12", needed * 1e3),
        ("F13", PITCH / needed * 1e3),
        ("F14", 4.0 * PITCH / needed * 1e3),
        ("F15", v / GAIN),
    ]
}

fn polygon() -> Vec<(&'static str, f64)> {
    let (base, work, tool, inserts) = (200.0, 1.0, 2.0, 2.0);
    let (slow, quick) = (base * work, base * tool);
    let speed = quick * 2.0 * PI / 60.0;
    let disc = Load { inertia: 0.02, torque: 0.0, efficiency: 1.0 };
    vec![
        ("P1", slow),
        ("P2", quick),
        ("P3", inserts * tool / work),
        ("P4", inserts * tool / work * slow / 60.0),
        ("P5", quick * 6.0 / GAIN),
        ("P6", slow * 6.0 / GAIN),
        ("P7", quick * 6.0 / GAIN * 0.01 / (tool / work)),
        ("P8", disc.accelerating(0.0, speed, 0.5)),
        ("P9", 0.5 * disc.inertia * speed * speed),
    ]
}

fn resolution() -> Vec<(&'static str, f64)> {
    let per_pulse = |pulses: f64| PI * PULL_ROLLER.outer / 10.0 / pulses * 1e6;
    vec![
        ("G_17-bit", per_pulse(131_072.0)),
        ("G_100000", per_pulse(1e5)),
        ("G_8192", per_pulse(8192.0)),
        ("G1", (62.832 - arc() * 1e3) * HEADS * 1e3),
        ("G2", (3.0f64 / 60.0).to_radians() * PULL_ROLLER.outer / 2.0 * 1e6),
        ("G3", 0.01 / 100.0 * 100e3),
    ]
}

#[test]
fn scalars_are_those_of_the_oracle() {
    let own = [kinematics(), pulling(), printing(), unwinding(), dots(), blocks(), polygon(), resolution()];
    let own: BTreeMap<&str, f64> = own.into_iter().flatten().collect();
    let oracle = oracle();
    let scalars = oracle["scalars"].as_object().unwrap();
    assert_eq!(scalars.len(), 118);
    let missing: Vec<&String> = scalars.keys().filter(|id| !own.contains_key(id.as_str())).collect();
    assert!(missing.is_empty(), "not computed here: {missing:?}");
    for (id, scalar) in scalars {
        // A difference of two nearly equal lengths keeps the fewer digits of both.
        let within = if id == "G1" { 1e-7 } else { SAME };
        same(id, own[id.as_str()], scalar["value"].as_f64().unwrap(), within);
    }
}

#[test]
fn cams_are_those_of_the_oracle() {
    let oracle = oracle();
    let cases = oracle["cam"].as_array().unwrap();
    assert_eq!(cases.len(), 6);
    for case in cases {
        let number = |key: &str| case[key].as_f64().unwrap();
        let law = match case["law"].as_str().unwrap() {
            "3-4-5 polynomial" => Law::Polynomial345,
            "modified sine" => Law::ModifiedSine,
            other => panic!("no law {other}"),
        };
        let (outer, tag) = (number("D_mm") / 1e3, case["tag"].as_str().unwrap());
        let (cam, of): (Correction, Coefficients) = (cam(outer, number("N")), law.coefficients());
        let ratio = cam.arc / cam.pitch;
        let torque = print().load.torque;
        let moving = surface(outer) * cam.effective_acceleration(of);
        for (key, own) in [
            ("arc_mm", cam.arc * 1e3),
            ("ratio", ratio),
            ("smear_head_mm", web::smear(ratio, CONTACT) * 1e3),
            ("smear_web_mm", (ratio - 1.0).abs() * CONTACT * 1e3),
            ("h_mm", cam.travel() * 1e3),
            ("Tc_ms", cam.seconds() * 1e3),
            ("vpk_mm_s", cam.peak_speed(of) * 1e3),
            ("apk_m_s2", cam.peak_acceleration(of)),
            ("alpha_roller", cam.peak_acceleration(of) / (outer / 2.0)),
            ("Tpk", surface(outer) * cam.peak_acceleration(of) + torque),
            ("Trms", math::hypot(moving, torque)),
        ] {
            // The oracle sums the square of the modified sine in 4000 steps, whose error is the square of a step.
            let summed = key == "Trms" && law == Law::ModifiedSine;
            same(&format!("{tag}, {key}"), own, number(key), if summed { 1e-6 } else { SAME });
        }
    }
}

#[test]
fn motors_are_judged_as_by_the_oracle() {
    let oracle = oracle();
    let cases = oracle["motors"].as_array().unwrap();
    assert_eq!(cases.len(), 18);
    for case in cases {
        let (name, number) = (case["motor"].as_str().unwrap(), |key: &str| case[key].as_f64().unwrap());
        let (motor, axis) = (motor(name), if case["axis"] == "X" { pull() } else { print() });
        let (peak, steady) = (axis.peak(&motor), axis.load.torque);
        let phases: [Phase; 4] = axis.load.phases(motor.rotor, axis.step_by_step());
        let through = motor.shares(&axis.load, &MotorDemand { peak, effective: steady, speed: axis.rpm });
        let stepping = MotorDemand { peak: phases[0].torque, effective: effective(&phases), speed: axis.rpm };
        let stepping = motor.shares(&axis.load, &stepping);
        for (key, own) in [
            ("ratio", through.inertia_ratio),
            ("pk", peak),
            ("pkp", through.peak),
            ("rmsc", through.effective),
            ("sspk", stepping.peak),
            ("ssrms", stepping.effective),
            ("n", through.speed),
        ] {
            same(&format!("{name}, {key}"), own, number(key), SAME);
        }
        let limits = Acceptance::mitsubishi(inertia_limit(name));
        assert_eq!(through.fails(&limits).is_none(), case["cont"].as_bool().unwrap(), "{name}, through");
        // Above 100 cycles a minute the rotor may not be so light.
        let often = Acceptance { inertia_ratio: limits.inertia_ratio.min(3.0), ..limits };
        assert_eq!(stepping.fails(&often).is_none(), case["inc"].as_bool().unwrap(), "{name}, step by step");
    }
}

#[test]
fn first_reason_is_the_speed_then_torque_then_inertia() {
    let (axis, motor) = (print(), motor("HC52"));
    let limits = Acceptance::mitsubishi(5.0);
    let fails =
        |peak, effective, speed| motor.shares(&axis.load, &MotorDemand { peak, effective, speed }).fails(&limits);
    assert_eq!(fails(1.0, 1.0, 2000.0), None);
    assert_eq!(fails(100.0, 100.0, 2000.1), Some(ServoRefusal::Speed));
    assert_eq!(fails(9.5, 100.0, 2000.0), Some(ServoRefusal::Peak));
    assert_eq!(fails(1.0, 2.4, 2000.0), Some(ServoRefusal::Effective));
    assert_eq!(fails(f64::NAN, 1.0, 2000.0), Some(ServoRefusal::Peak));
    let light = Servo { rotor: 1e-4, ..motor };
    let light = light.shares(&axis.load, &MotorDemand { peak: 1.0, effective: 1.0, speed: 100.0 });
    assert_eq!(light.fails(&limits), Some(ServoRefusal::Inertia));
}

/// Effective torque and returned energy of a move agree with the sum over its course.
#[test]
fn closed_forms_agree_with_the_sum_over_a_move() {
    let (axis, motor) = (print(), motor("HC53"));
    let of = Move { speed: axis.speed(), ramp: 0.07, seconds_at_speed: 0.31, pause: 0.12, hold: 0.0 };
    let phases = axis.load.phases(motor.rotor, of);
    let steps = 200_000;
    let dt = of.cycle() / f64::from(steps);
    let (mut square, mut back) = (0.0, 0.0);
    for step in 0..steps {
        let t = (f64::from(step) + 0.5) * dt;
        let (torque, speed) = if t < of.ramp {
            (phases[0].torque, of.speed * t / of.ramp)
        } else if t < of.ramp + of.seconds_at_speed {
            (axis.load.torque, of.speed)
        } else if t < 2.0 * of.ramp + of.seconds_at_speed {
            (phases[2].torque, of.speed * (2.0 * of.ramp + of.seconds_at_speed - t) / of.ramp)
        } else {
            (0.0, 0.0)
        };
        square += torque * torque * dt;
        back += (-torque).max(0.0) * speed * dt;
    }
    same("effective", effective(&phases), (square / of.cycle()).sqrt(), 1e-4);
    same("returned", load::returned(phases[2], of.speed), back, 1e-4);
}

/// The scalars of the oracle that are results of the paper's example, with exact π, because the oracle has no other π. Exact stops and
/// block times (F6, F12) are left out: they assume X alone and four macro blocks, where the line has two axes and a program of its own.
const READOUTS: [(&str, &str, f64); 36] = [
    ("A2", "line-speed", 1.0),
    ("A3", "y-stroke", 1.0),
    ("A4", "vector-feed", 1.0),
    ("A5", "block-time", 1.0),
    ("A6", "dots-per-second", 1.0),
    ("A7", "surface-speed", 1.0 / 60.0),
    ("A8", "print-roller-speed", 1.0),
    ("A9", "x-motor-speed", 1.0),
    ("A10", "y-motor-speed", 1.0),
    ("A11", "volts-command", 1.0),
    ("B5", "x-load-inertia", 1.0),
    ("B6", "x-inertia-ratio", 1.0),
    ("B7", "x-load-torque", 1.0),
    ("B8", "x-ramp-torque", 1.0),
    ("B9", "x-peak-torque", 1.0),
    ("B11", "x-shortest-ramp", 1.0),
    ("C4", "y-load-inertia", 1.0),
    ("C5", "y-inertia-ratio", 1.0),
    ("C6", "y-load-torque", 1.0),
    ("C7", "y-ramp-torque", 1.0),
    ("C8", "y-peak-torque", 1.0),
    ("C10", "y-shortest-ramp", 1.0),
    ("C15", "y-stop-energy", 1.0),
    ("C20", "y-best-gear", 1.0),
    ("D1", "unwinder-torque", 1.0),
    ("D2", "frequency", 1.0),
    ("D14", "analog-step", 1.0),
    ("D19", "override-step", 1.0),
    ("D20", "override-limit", 1.0),
    ("D22", "thickness-error", 1.0),
    ("E1", "surface-ratio", 1.0),
    ("E2", "matching-diameter", 1.0),
    ("E3", "matching-heads", 1.0),
    ("E9", "dot-length", 1.0),
    ("G_100000", "x-resolution", 1.0),
    ("D8", "speed-error-rated", 1.0),
];

#[test]
fn results_of_the_papers_example_are_those_of_the_oracle() {
    let mut project = Project::named("ribbon-line", Some("mitsubishi-e60"), Some("paper")).unwrap();
    project.values.insert("pi".to_owned(), form::Value::Text("exact".to_owned()));
    let design = project.design();
    let oracle = oracle();
    let mut other = Vec::new();
    for (id, readout, scale) in READOUTS {
        let own = design.readouts.iter().find(|row| row.id == readout).unwrap().value * scale;
        let expected = oracle["scalars"][id]["value"].as_f64().unwrap();
        if (own - expected).abs() > SAME * expected.abs() {
            other.push(format!("{id} {readout}: {own}, expected {expected}"));
        }
    }
    assert!(other.is_empty(), "{other:#?}");
}

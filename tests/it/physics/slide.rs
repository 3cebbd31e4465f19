//! A slide on a ball screw against mechanics: the worked example of the facts, and the energy of a weight.

use macroline::drives::inertia::{CM2, Cylinder, STEEL};
use macroline::drives::shaft_motion::{Motion, SpeedSegment};
use macroline::drives::slide::Slide;
use macroline::math::{self, RPM};
use proptest::prelude::*;

use crate::queries::near_share;

/// Standard acceleration of gravity, m/s².
const GRAVITY: f64 = 9.80665;

/// The slide of sizing facts 2.13.
fn slide() -> Slide {
    Slide {
        mass: 250.0,
        friction: 250.0,
        inclination: 0.0,
        screw: Cylinder { outer: 0.04, inner: 0.0, length: 1.0, density: STEEL },
        lead: 0.005,
        gear: 1.0,
        efficiency: 0.9,
    }
}

#[test]
fn slide_has_the_figures_of_the_worked_example() {
    let (slide, rotor) = (slide(), 11.6 * CM2);
    let load = slide.load();
    near_share(load.inertia / CM2, 21.312, 1e-4);
    near_share(load.torque, 0.221_05, 1e-4);
    near_share(slide.motor_speed(10.0), 2000.0, 1e-12);
    near_share(load.accelerating(rotor, 2000.0 * RPM, 0.1), 7.389, 1e-4);
}

#[test]
fn belt_reduces_inertia_by_its_square_and_torque_by_its_ratio() {
    let (direct, belt) = (slide(), Slide { gear: 2.0, ..slide() });
    near_share(belt.load().inertia, direct.load().inertia / 4.0, 1e-12);
    near_share(belt.load().torque, direct.load().torque / 2.0, 1e-12);
    near_share(belt.motor_speed(10.0), 4000.0, 1e-12);
}

/// Up and down again over the same turns, with a rest between.
fn up_and_down(speed: f64, ramp: f64) -> [SpeedSegment; 5] {
    let segment = |t: f64, seconds: f64, from: f64, to: f64| SpeedSegment { t, seconds, from, to };
    [
        segment(0.0, ramp, 0.0, speed),
        segment(ramp, ramp, speed, 0.0),
        segment(2.0 * ramp, 1.0, 0.0, 0.0),
        segment(2.0 * ramp + 1.0, ramp, 0.0, -speed),
        segment(3.0 * ramp + 1.0, ramp, -speed, 0.0),
    ]
}

proptest! {
    #[test]
    fn lifted_weight_comes_back_but_for_friction(degrees in 0.0_f64..90.0, speed in 10.0_f64..300.0, ramp in 0.05_f64..1.0) {
        let slide = Slide { inclination: degrees.to_radians(), efficiency: 1.0, ..slide() };
        let motion = |segments: &[SpeedSegment]| Motion::new(segments.to_vec(), slide.load(), 0.0).with_weight(slide.weight());
        let segments = up_and_down(speed, ramp);
        let way = speed * ramp * slide.lead / (2.0 * std::f64::consts::PI);
        let energy = |segments: &[SpeedSegment]| { let work = motion(segments).motor_load(0.0); work.given - work.returned };
        let lifted = slide.mass * GRAVITY * math::sin(degrees.to_radians()) * way;
        let up = energy(&segments[..2]);
        prop_assert!((up - lifted - slide.friction * way).abs() < 1e-9 * (1.0 + up), "{up}, {lifted}");
        let both = energy(&segments);
        prop_assert!((both - 2.0 * slide.friction * way).abs() < 1e-9 * (1.0 + up), "{both}");
        // The motor holds the weight at rest.
        prop_assert!((motion(&segments[2..3]).motor_load(0.0).peak.torque - slide.weight()).abs() < 1e-12);
    }
}

#[test]
fn screw_with_losses_takes_more_up_and_gives_less_down() {
    let slide = Slide { inclination: std::f64::consts::FRAC_PI_4, friction: 0.0, ..slide() };
    let motion = Motion::new([], slide.load(), 0.0).with_weight(slide.weight());
    let steady = |speed: f64| motion.torque(&SpeedSegment { t: 0.0, seconds: 1.0, from: speed, to: speed }, 0.0);
    near_share(
        slide.weight(),
        250.0 * GRAVITY * std::f64::consts::FRAC_1_SQRT_2 * 0.005 / (2.0 * std::f64::consts::PI),
        1e-12,
    );
    near_share(steady(100.0), slide.weight() / 0.9, 1e-12);
    near_share(steady(-100.0), slide.weight() * 0.9, 1e-12);
}

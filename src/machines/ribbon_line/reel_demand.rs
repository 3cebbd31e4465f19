//! The supply reel in operation: time and products of a full reel, pull at a start, brake at a stop.

use super::contacts::left_at_reel_end;
use super::derive::greatest;
use super::mechanics::{unwinder_load, unwinder_torque};
use super::params::Params;
use super::reel::{ramp_acceleration, wound};
use super::resolved::RibbonLine;

/// Deceleration in m/s², without sign, of the ribbon at an unwinder without current, with a brake of the reel in N: the torque that brakes
/// its motor over the inertia of all rotating parts, the same at every speed. Source: sizing facts 2.2.
pub(super) fn coasting_acceleration(p: &Params, brake: f64) -> f64 {
    let torque = unwinder_torque(p, brake) + p.unwinding.motor_brake;
    torque / unwinder_load(p, 0.0).inertia / p.reduction_ratio * p.press_roller_diameter / 2e3
}

/// Time (s) in which the line uses up the ribbon of a reel; 0 for a reel without ribbon, at any speed.
pub(super) fn time(line: &RibbonLine) -> f64 {
    let length = wound(&line.params).length();
    if length > 0.0 { 60e3 * length / line.line_speed() } else { 0.0 }
}

/// Ribbon (mm) in the loop at the end of a product when M5 stops the unwinder, at the worst position of the knob:
/// `max(start + run + v · (τ_r - τ / 2) - v / K, 0)`, the stop without `v · t_r / 2`, the ribbon of the inverter's ramp that the sensor leaves
/// on the reel. Source: ribbon line facts, 7 and 11.
fn left_in_loop(line: &RibbonLine) -> f64 {
    let p = &line.params;
    greatest(line.over_knob(), |d| {
        let ramp = p.ramp_to(d.unwinder.actual);
        d.slack.start + d.slack.run + d.slack.stop - d.feeds.mm_per_second() * ramp / 2.0
    })
}

/// Ribbon (mm) of a full reel beside its products: the loop of the last one, and the ribbon that the sensor leaves for the stop. The loops of
/// the products before are taken up onto the reel. Source: ribbon line facts, 11.
fn beside_products(line: &RibbonLine) -> f64 {
    left_in_loop(line) + left_at_reel_end(line)
}

/// Ribbon (mm) of a reel that suffices for a product.
pub(super) fn needed(line: &RibbonLine) -> f64 {
    line.derived.product.length + beside_products(line)
}

/// Products that a reel makes until its sensor holds the program.
fn products_of_ribbon(line: &RibbonLine) -> f64 {
    (1e3 * wound(&line.params).length() - beside_products(line)).max(0.0) / line.derived.product.length
}

/// Whole products that a reel makes until its sensor holds the program.
pub(super) fn products(line: &RibbonLine) -> f64 {
    products_of_ribbon(line).floor()
}

/// Time (s) of reel changes per product: time of one change over the number of whole products of a reel, or over the
/// fraction of one product if a reel has less; 0 for a reel without ribbon.
pub(super) fn change_time(line: &RibbonLine) -> f64 {
    let products = products_of_ribbon(line);
    let change = line.params.unwinding.reel_change;
    if products > 0.0 { change / if products >= 1.0 { products.floor() } else { products } } else { 0.0 }
}

/// Products per hour at the line speed: `3600 / (time of a product + pause + time of reel changes)`.
pub(super) fn products_per_hour(line: &RibbonLine) -> f64 {
    3600.0 / (line.derived.product.time + line.params.pause + change_time(line))
}

/// Pull (N) of the reel over the inverter's ramp, at the diameter with the greatest mass at the web.
pub(super) fn ramp_pull(p: &Params) -> f64 {
    let reel = wound(p);
    reel.pull(reel.worst(), ramp_acceleration(p))
}

/// Pull (N) of the reel while the unwinder coasts without current: the deceleration is the same from every speed.
pub(super) fn coasting_pull(line: &RibbonLine) -> f64 {
    let reel = wound(&line.params);
    reel.pull(reel.worst(), coasting_acceleration(&line.params, line.params.unwinding.brake))
}

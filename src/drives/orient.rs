//! Positioning a spindle: direction of travel to an angle, and the speed profile.

use super::rotation::Rotation;

/// Direction of approach to a spindle angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Approach {
    /// A turning spindle keeps its direction; from standstill it takes the shortest way (`SPOS=`, `DC`).
    Direct,
    /// Clockwise, the direction of M3 (`ACP`).
    Clockwise,
    /// Counter-clockwise (`ACN`).
    CounterClockwise,
    /// By a signed angle from the present position; the sign is the direction (`IC`).
    Incremental,
}

/// Degrees from the angle `from` to the target, positive in the direction of M3, less than a whole turn (except for
/// [`Approach::Incremental`]). Half a turn from standstill goes clockwise.
///
/// Source: `docs/reference/sinumerik-802d.md` section 3.6.
pub fn travel(from: f64, target: f64, approach: Approach, rotation: Rotation) -> f64 {
    if approach == Approach::Incremental {
        return target;
    }
    let clockwise = turn(target - from);
    let counter = if clockwise > 0.0 { clockwise - 360.0 } else { 0.0 };
    let way = match approach {
        Approach::Clockwise => Rotation::Clockwise,
        Approach::CounterClockwise => Rotation::CounterClockwise,
        _ => rotation,
    };
    match way {
        Rotation::Clockwise => clockwise,
        Rotation::CounterClockwise => counter,
        Rotation::Stopped if clockwise <= 180.0 => clockwise,
        Rotation::Stopped => counter,
    }
}

/// Reduces an angle to the range 0 to 360 degrees.
pub fn turn(degrees: f64) -> f64 {
    let rest = degrees % 360.0;
    if rest < 0.0 { rest + 360.0 } else { rest + 0.0 }
}

/// A travel that ends at rest: linear change of speed to `peak`, constant speed, linear change to 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Travel {
    /// Speed in r/min, never negative.
    pub peak: f64,
    /// Whole turns added to the travel, for enough deceleration distance.
    pub more: f64,
    /// Seconds from the present speed to `peak`.
    pub to_peak: f64,
    /// Seconds at `peak`.
    pub steady: f64,
    /// Seconds from `peak` to 0.
    pub to_rest: f64,
}

impl Travel {
    /// Travel over `turns` from the speed `rpm` (in the direction of travel, not negative) with at most `top`. `faster` and `slower` are
    /// the accelerations in r/min per second to `peak` and from there. From standstill the travel is exactly `turns`; otherwise whole turns
    /// are added if it is too short for deceleration.
    pub fn new(turns: f64, rpm: f64, top: f64, faster: f64, slower: f64) -> Travel {
        // Turns of a linear change of speed: v t / 2.
        let change = |from: f64, to: f64, rate: f64| (from + to) * 0.5 / 60.0 * ((to - from).abs() / rate);
        let least = change(rpm, top, faster) + change(top, 0.0, slower);
        if rpm <= 0.0 && turns < least {
            // turns = peak² / 120 · (1 / faster + 1 / slower)
            let peak = (120.0 * turns / (1.0 / faster + 1.0 / slower)).sqrt();
            return Travel { peak, more: 0.0, to_peak: peak / faster, steady: 0.0, to_rest: peak / slower };
        }
        let more = (least - turns).max(0.0).ceil();
        let steady = ((turns + more - least) * 60.0 / top).max(0.0);
        Travel { peak: top, more, to_peak: (top - rpm).abs() / faster, steady, to_rest: top / slower }
    }
}

/// Data of spindle positioning.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Positioning {
    /// Speed of the positioning motion in r/min (MD35300).
    pub speed: f64,
    /// Acceleration in position control in r/min per second (MD35210).
    pub acceleration: f64,
    /// Direction of the first motion after power-on, in search of the zero mark (MD35350): clockwise.
    pub clockwise: bool,
}

/// Degrees of the first positioning after power-on: in one direction past the zero mark, and on to the target.
pub fn first_travel(from: f64, target: f64, clockwise: bool) -> f64 {
    let sign = if clockwise { 1.0 } else { -1.0 };
    let mark = turn(-sign * from);
    sign * (if mark > 0.0 { mark } else { 360.0 } + turn(sign * target))
}

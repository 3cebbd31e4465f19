//! Positioning a spindle: direction of travel to an angle, and the speed profile.

/// How a spindle comes to an angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Approach {
    /// Turning it keeps its direction, from standstill it takes the shortest way (`SPOS=`, `DC`).
    Direct,
    /// Clockwise, the sense of M3 (`ACP`).
    Clockwise,
    /// Counter-clockwise (`ACN`).
    CounterClockwise,
    /// By an angle from where it is, whose sign is the direction (`IC`).
    Incremental,
}

/// Degrees from the angle `from` to the target, positive in the sense of M3, by less than a whole turn (but for
/// [`Approach::Incremental`]). `sense` is the sign of the speed, 0 at standstill. Half a turn from standstill goes clockwise.
///
/// Source: `reference/sinumerik-802d.md` section 3.6.
pub fn travel(from: f64, target: f64, approach: Approach, sense: i8) -> f64 {
    if approach == Approach::Incremental {
        return target;
    }
    let clockwise = turn(target - from);
    let counter = if clockwise > 0.0 { clockwise - 360.0 } else { 0.0 };
    let way = match approach {
        Approach::Clockwise => 1,
        Approach::CounterClockwise => -1,
        _ => sense,
    };
    match way {
        1 => clockwise,
        -1 => counter,
        _ if clockwise <= 180.0 => clockwise,
        _ => counter,
    }
}

/// An angle within 0 to 360 degrees.
pub fn turn(degrees: f64) -> f64 {
    let rest = degrees % 360.0;
    if rest < 0.0 { rest + 360.0 } else { rest + 0.0 }
}

/// A travel that ends at rest: the speed goes straight to `peak`, stays, and goes straight to 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Travel {
    /// Speed in r/min, never negative.
    pub peak: f64,
    /// Whole turns that are added to the way, to leave room for the slowing down.
    pub more: f64,
    /// Seconds from the present speed to `peak`.
    pub to_peak: f64,
    /// Seconds at `peak`.
    pub steady: f64,
    /// Seconds from `peak` to 0.
    pub to_rest: f64,
}

impl Travel {
    /// Over `turns` from the speed `rpm` (along the way, not negative) with at most `top`; `faster` and `slower` are the accelerations in
    /// r/min per second to `peak`, and from there. From standstill the way is as long as told; else whole turns are added where it is
    /// too short to slow down.
    pub fn new(turns: f64, rpm: f64, top: f64, faster: f64, slower: f64) -> Travel {
        // v t / 2 of a straight change of speed, in turns.
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

/// What a spindle needs to be positioned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Positioning {
    /// Speed of the positioning motion in r/min (MD35300).
    pub speed: f64,
    /// Acceleration in position control in r/min per second (MD35210).
    pub acceleration: f64,
    /// Which way the first motion after power-on turns to find the zero mark (MD35350): clockwise.
    pub clockwise: bool,
}

/// Degrees of the first positioning after power-on: in one direction over the zero mark, and on to the target.
pub fn first_travel(from: f64, target: f64, clockwise: bool) -> f64 {
    let sense = if clockwise { 1.0 } else { -1.0 };
    let mark = turn(-sense * from);
    sense * (if mark > 0.0 { mark } else { 360.0 } + turn(sense * target))
}

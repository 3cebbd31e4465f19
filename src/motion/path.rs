//! The commanded path before acceleration, and the filtered positions by acceleration and servo lag in closed form.
//!
//! The path `U(t)` is a list of segments of constant feed. Acceleration "linear by time constant" is a moving average over the time
//! constant `τ` of each axis after the interpolator (`docs/reference/sizing.md` section 4):
//!
//! ```text
//! P(t) = 1/τ ∫ U(t-s) ds = U(t) - ∫ u(t-s) (1 - s/τ) ds        s from 0 to τ, u = dU/dt
//! v(t) = (U(t) - U(t-τ)) / τ          a(t) = (u(t) - u(t-τ)) / τ
//! ```
//!
//! The axis follows with the position gain `K` as `dy/dt = K (P - y)`. `H` is the fraction of a step that has not yet arrived:
//!
//! ```text
//! y(t) = U(t) - ∫ u(t-s) H(s) ds      H(s) = 1 - s/τ + (1 - exp(-K s)) / (K τ)      s < τ
//!                                     H(s) = (1 - exp(-K τ)) / (K τ) · exp(-K (s - τ))   s ≥ τ
//! ```
//!
//! Each of these is a sum over the segments of a time window, so an axis at rest is exactly at its commanded position. The last integral is
//! cut off at the age `τ + TAIL / K`, which neglects exp(-TAIL) = 2e-9 of the earlier motion.

use super::plant::AxisPlant;
use super::snapshot::AxisState;
use super::time_series::{TimeSeries, Timed};
use crate::interp::canon::AXES;
use crate::math;

/// Age of a movement, in units of `1 / K`, after which it counts as arrived.
const TAIL: f64 = 20.0;

/// A part of the path with constant feed, from `t` until the next segment.
#[derive(Debug, Clone, Copy)]
pub(super) struct Segment {
    /// Seconds.
    pub(super) t: f64,
    /// Position at `t` in mm or °.
    pub(super) from: [f64; AXES],
    /// Speed in mm/s or °/s; on an arc without the circular part.
    pub(super) velocity: [f64; AXES],
    /// Number (from 1) of the [`Circle`] to add; 0 on a straight line.
    pub(super) circle: u32,
}

/// The circular part of a segment: `radius (cos, sin)(phase + omega dt)` in the plane, minus its value at the start.
#[derive(Debug, Clone, Copy)]
pub(super) struct Circle {
    /// Seconds.
    pub(super) t: f64,
    /// The two axes.
    pub(super) plane: (u8, u8),
    /// Radius in mm.
    pub(super) radius: f64,
    /// Angle at the start in radians.
    pub(super) phase: f64,
    /// Angular speed in rad/s, counter-clockwise positive.
    pub(super) omega: f64,
}

impl Timed for Segment {
    fn t(&self) -> f64 {
        self.t
    }
}

impl Timed for Circle {
    fn t(&self) -> f64 {
        self.t
    }
}

/// One axis of one segment: `u(dt) = constant + swing sin(phase + omega dt)`.
#[derive(Clone, Copy)]
struct Run {
    from: f64,
    constant: f64,
    swing: f64,
    phase: f64,
    omega: f64,
}

impl Run {
    fn speed(&self, dt: f64) -> f64 {
        if self.swing == 0.0 {
            self.constant
        } else {
            self.constant + self.swing * math::sin(self.phase + self.omega * dt)
        }
    }

    fn position(&self, dt: f64) -> f64 {
        let line = self.from + self.constant * dt;
        if self.swing == 0.0 {
            return line;
        }
        line - self.swing / self.omega * (math::cos(self.phase + self.omega * dt) - math::cos(self.phase))
    }
}

/// A weight of past speeds over their age `s`: `level + slope s + decay exp(-gain (s - shift))`.
#[derive(Clone, Copy)]
struct Weight {
    level: f64,
    slope: f64,
    decay: f64,
    gain: f64,
    shift: f64,
}

impl Weight {
    /// `∫ u(t-s) weight(s) ds` for `s` from `young` to `old`, where the segment began `age` seconds before `t`.
    fn integral(&self, run: &Run, age: f64, young: f64, old: f64) -> f64 {
        let span = old - young;
        let mut constant = run.constant;
        let mut total = 0.0;
        if run.swing != 0.0 {
            if (run.omega * span).abs() < 1e-3 {
                // An arc this short equals its chord; the closed form would divide by its tiny angle.
                constant = (run.position(age - young) - run.position(age - old)) / span;
            } else {
                total = run.swing * (self.swung(run, age, old) - self.swung(run, age, young));
            }
        }
        if constant != 0.0 {
            let mut weight = self.level * span + self.slope * 0.5 * (old * old - young * young);
            if self.decay != 0.0 {
                weight += self.decay / self.gain * (self.fade(young) - self.fade(old));
            }
            total += constant * weight;
        }
        total
    }

    fn fade(&self, s: f64) -> f64 {
        math::exp(-self.gain * (s - self.shift))
    }

    /// Antiderivative over `s` of `sin(phase + omega (age - s)) weight(s)`.
    fn swung(&self, run: &Run, age: f64, s: f64) -> f64 {
        let w = run.omega;
        let (sin, cos) = math::sin_cos(run.phase + w * (age - s));
        let mut sum = self.level * cos / w + self.slope * (s * cos + sin / w) / w;
        if self.decay != 0.0 {
            sum += self.decay * self.fade(s) * (w * cos - self.gain * sin) / (self.gain * self.gain + w * w);
        }
        sum
    }
}

/// The commanded path.
#[derive(Debug, Clone, Default)]
pub(super) struct Path {
    pub(super) segments: TimeSeries<Segment>,
    pub(super) circles: TimeSeries<Circle>,
}

impl Path {
    /// State of one axis at time `t`.
    pub(super) fn axis(&self, k: usize, plant: &AxisPlant, t: f64) -> AxisState {
        let segments = self.segments.until(t);
        let Some(now) = segments.last() else { return AxisState::default() };
        let run = self.run(now, k);
        let dt = t - now.t;
        let (place, speed) = (run.position(dt), run.speed(dt));
        let (tau, gain) = (plant.time_constant, plant.position_gain);
        let mut state = AxisState { position: place, actual: place, feed: speed * 60.0, acceleration: 0.0 };
        if tau > 0.0 {
            let flat = Weight { level: 1.0 / tau, slope: 0.0, decay: 0.0, gain: 0.0, shift: 0.0 };
            let late = Weight { level: 1.0, slope: -1.0 / tau, ..flat };
            let (mut moved, mut missing) = (0.0, 0.0);
            self.window(segments, k, t, 0.0, tau, |run, age, young, old| {
                moved += flat.integral(run, age, young, old);
                missing += late.integral(run, age, young, old);
            });
            state.feed = moved * 60.0;
            state.position = place - missing;
            state.acceleration = (speed - self.speed(segments, k, t - tau)) / tau;
        }
        state.actual = place - self.missing(segments, k, t, tau, gain);
        state
    }

    /// Actual position of one axis at time `t`; see [`axis`](Path::axis).
    pub(super) fn actual(&self, k: usize, plant: &AxisPlant, t: f64) -> f64 {
        let segments = self.segments.until(t);
        let Some(now) = segments.last() else { return 0.0 };
        let place = self.run(now, k).position(t - now.t);
        place - self.missing(segments, k, t, plant.time_constant, plant.position_gain)
    }

    /// Commanded speed of one axis in mm/s or °/s after an acceleration filter over `tau` seconds: the mean speed of that time.
    pub(super) fn mean_speed(&self, k: usize, t: f64, tau: f64) -> f64 {
        let segments = self.segments.until(t);
        if tau <= 0.0 {
            return self.speed(segments, k, t);
        }
        let flat = Weight { level: 1.0 / tau, slope: 0.0, decay: 0.0, gain: 0.0, shift: 0.0 };
        let mut mean = 0.0;
        self.window(segments, k, t, 0.0, tau, |run, age, young, old| mean += flat.integral(run, age, young, old));
        mean
    }

    /// Commanded position of one axis after acceleration at `t`, which may be later than the last segment; see [`axis`](Path::axis).
    pub(super) fn commanded(&self, k: usize, plant: &AxisPlant, t: f64) -> f64 {
        let segments = self.segments.until(t);
        let Some(now) = segments.last() else { return 0.0 };
        let mut place = self.run(now, k).position(t - now.t);
        let tau = plant.time_constant;
        if tau > 0.0 {
            let late = Weight { level: 1.0, slope: -1.0 / tau, decay: 0.0, gain: 0.0, shift: 0.0 };
            self.window(segments, k, t, 0.0, tau, |run, age, young, old| place -= late.integral(run, age, young, old));
        }
        place
    }

    /// Lag of the axis behind the unfiltered path: `∫ u(t-s) H(s) ds`.
    fn missing(&self, segments: &[Segment], k: usize, t: f64, tau: f64, gain: f64) -> f64 {
        let mut missing = 0.0;
        let mut tail = 1.0;
        if tau > 0.0 {
            let share = if gain > 0.0 { 1.0 / (gain * tau) } else { 0.0 };
            let near = Weight { level: 1.0 + share, slope: -1.0 / tau, decay: -share, gain, shift: 0.0 };
            self.window(segments, k, t, 0.0, tau, |run, age, young, old| {
                missing += near.integral(run, age, young, old);
            });
            tail = share * (1.0 - math::exp(-gain * tau));
        }
        if gain > 0.0 {
            let far = Weight { level: 0.0, slope: 0.0, decay: tail, gain, shift: tau };
            self.window(segments, k, t, tau, tau + TAIL / gain, |run, age, young, old| {
                missing += far.integral(run, age, young, old);
            });
        }
        missing
    }

    /// Calls `part(run, age, young, old)` for the part of each segment with an age at `t` between `young` and `old`.
    fn window(
        &self,
        segments: &[Segment],
        k: usize,
        t: f64,
        young: f64,
        old: f64,
        mut part: impl FnMut(&Run, f64, f64, f64),
    ) {
        let mut end = 0.0;
        for segment in segments.iter().rev() {
            let age = t - segment.t;
            let (from, to) = (young.max(end), old.min(age));
            if from < to {
                let run = self.run(segment, k);
                if run.constant != 0.0 || run.swing != 0.0 {
                    part(&run, age, from, to);
                }
            }
            if age >= old {
                break;
            }
            end = age;
        }
    }

    /// Speed of the unfiltered path at `t`; 0 before its start.
    fn speed(&self, segments: &[Segment], k: usize, t: f64) -> f64 {
        let before = segments.partition_point(|segment| segment.t <= t);
        segments[..before].last().map_or(0.0, |segment| self.run(segment, k).speed(t - segment.t))
    }

    fn run(&self, segment: &Segment, k: usize) -> Run {
        let mut run = Run { from: segment.from[k], constant: segment.velocity[k], swing: 0.0, phase: 0.0, omega: 0.0 };
        let circle = (segment.circle as usize).checked_sub(1).and_then(|number| self.circles.from(number).first());
        if let Some(circle) = circle {
            let speed = circle.radius * circle.omega;
            if circle.plane.0 as usize == k {
                run = Run { swing: -speed, phase: circle.phase, omega: circle.omega, ..run };
            } else if circle.plane.1 as usize == k {
                run = Run { swing: speed, phase: circle.phase + 0.5 * math::PI, omega: circle.omega, ..run };
            }
        }
        run
    }

    /// Time (s) for which the path still acts on an axis.
    pub(super) fn memory(plant: &AxisPlant) -> f64 {
        plant.time_constant + if plant.position_gain > 0.0 { TAIL / plant.position_gain } else { 0.0 }
    }
}

//! Turned ends of the bar, before and after the polygons: to a diameter from the face, with a chamfer and a thread, by the main spindle.

use super::params::Params;
use super::path::{NO_RAPIDS, PassStep, SlideTarget, time};
use super::turned_end_form::{TurnedEnd, TurnedEndPlace};
use crate::drives::speed::surface_speed;
use crate::math;

/// Depth of the flanks of a metric thread over its pitch, `17 √3 / 48`.
const FLANKS: f64 = 0.613_435;

/// Allowed deviation of the pitch at the beginning of a thread, as a share of the pitch.
const PITCH_ERROR: f64 = 0.01;

/// Least distance, in pitches, between a thread and the shoulder behind it. Source: polygon turning facts 3.10.
const RUN_OUT: f64 = 2.0;

/// Greatest number of cuts of a turned end, and of its thread.
const MOST: f64 = 100.0;

impl TurnedEnd {
    /// Diameter (mm) of the stock of the end: that of the end turned before it, if it lies on that one, else that of
    /// the bar.
    pub(super) fn blank(&self, p: &Params) -> f64 {
        let [before, _] = &*p.turned_ends;
        let lies_on_it = before.on
            && self.place == TurnedEndPlace::After
            && self.length <= before.length
            && self.diameter <= before.diameter;
        if lies_on_it { before.diameter.min(p.stock_diameter) } else { p.stock_diameter }
    }

    /// Diameter (mm) that the part reaches: on a thinner end turned before it the tool cuts nothing.
    pub(super) fn reached(&self, p: &Params) -> f64 {
        let [before, _] = &*p.turned_ends;
        let lies_on_it = self.place == TurnedEndPlace::After && before.on && self.length <= before.length;
        if lies_on_it { self.diameter.min(before.diameter) } else { self.diameter }
    }

    /// Greatest cutting speed, m/min: `π d n / 1000` with the diameter of its stock.
    pub(super) fn cutting_speed(&self, p: &Params) -> f64 {
        surface_speed(self.speed, self.blank(p))
    }

    /// Number of cuts; the last one is to size.
    pub(super) fn cuts(&self, stock: f64) -> f64 {
        math::whole_up(0.5 * (stock - self.diameter) / self.depth).max(1.0)
    }

    /// Number of cuts of the thread, each taking the same area: `(h / first)²`, rounded up, with the depth h of the flanks.
    fn thread_cuts(&self) -> f64 {
        let ratio = FLANKS * self.pitch / self.thread_infeed;
        math::whole_up(ratio * ratio).max(1.0)
    }

    /// Diameter at the root of the thread, or the turned one: `d - 2 h`.
    pub(super) fn least_diameter(&self) -> f64 {
        self.diameter - 2.0 * FLANKS * self.pitch
    }

    /// Whether there are too many cuts.
    pub(super) fn is_endless(&self, stock: f64) -> bool {
        self.cuts(stock) > MOST || self.pitch > 0.0 && self.thread_cuts() > MOST
    }

    /// Steps of turning: cuts at increasing depth, the last one with the chamfer. Each cut leaves the stock at feed and
    /// returns in front of the face.
    pub(super) fn steps(&self, p: &Params) -> Vec<PassStep> {
        let (feed, end) = (self.feed * self.speed, SlideTarget::Along(-self.length));
        let back = [
            PassStep::Feed(SlideTarget::Across(p.clear_diameter()), p.clamped_retract_feed()),
            PassStep::Rapid(SlideTarget::Along(p.clearance)),
        ];
        let stock = self.blank(p);
        let cuts = self.cuts(stock).min(MOST) as u32;
        let mut all = Vec::new();
        for cut in 1..=cuts {
            let last = cut == cuts;
            let size = if last { self.diameter } else { stock - 2.0 * f64::from(cut) * self.depth };
            if last && self.chamfer > 0.0 {
                all.push(PassStep::Rapid(SlideTarget::Across(size - 2.0 * self.chamfer)));
                all.push(PassStep::Feed(SlideTarget::Along(0.0), feed));
                all.push(PassStep::Slope { across: size, along: -self.chamfer, feed });
            } else {
                all.push(PassStep::Rapid(SlideTarget::Across(size)));
            }
            all.push(PassStep::Feed(end, feed));
            all.extend(back);
        }
        all
    }

    /// Steps of thread cutting; each cut begins in front of the face.
    pub(super) fn thread(&self, p: &Params) -> Vec<PassStep> {
        let depth = FLANKS * self.pitch;
        let cuts = self.thread_cuts().min(MOST) as u32;
        let one = |cut: u32| {
            let down = depth * (f64::from(cut) / f64::from(cuts)).sqrt();
            [
                PassStep::Rapid(SlideTarget::Across(self.diameter - 2.0 * down)),
                PassStep::Thread { along: -self.thread_length, pitch: self.pitch },
                PassStep::Feed(SlideTarget::Across(p.clear_diameter()), p.clamped_retract_feed()),
                PassStep::Rapid(SlideTarget::Along(p.clearance)),
            ]
        };
        if self.pitch > 0.0 { (1..=cuts).flat_map(one).collect() } else { Vec::new() }
    }

    /// Run-in (mm) in front of the thread: the distance in which the slide comes from rest to within the share a of its
    /// speed V = S P / 60 [mm/s], after linear acceleration over τ [s] and a position loop of gain K [1/s]:
    /// `t = τ + ln((1 - e^(-Kτ)) / (Kτ a)) / K`, `δ = V (t - τ/2 - (1 - a) / K)`. If the ramp is so long that the lag
    /// falls below a on it: `t = τ (1 - a) + 1/K`, `δ = V (t²/2 - t/K + 1/K²) / τ`. Source: polygon turning facts 3.10.
    pub(super) fn run_in(&self, p: &Params) -> f64 {
        let (ramp, gain, speed) =
            (p.slides.time_constant / 1000.0, p.slides.position_gain, self.speed * self.pitch / 60.0);
        // Share of the speed that is missing at the end of the ramp.
        let missing = if ramp > 0.0 { -math::expm1(-gain * ramp) / (gain * ramp) } else { 1.0 };
        if missing > PITCH_ERROR {
            let time = ramp + math::ln(missing / PITCH_ERROR) / gain;
            speed * (time - 0.5 * ramp - (1.0 - PITCH_ERROR) / gain)
        } else {
            let time = ramp * (1.0 - PITCH_ERROR) + 1.0 / gain;
            speed * (0.5 * time * time - time / gain + 1.0 / (gain * gain)) / ramp
        }
    }

    /// Room (mm) that the thread needs in front of the shoulder: the run-out, in which the tool leaves the thread, and at least the lag of the
    /// slide, `max(2 P, V (τ/2 + 1/K))` with V = S P / 60 [mm/s]. Source: polygon turning facts 3.10.
    pub(super) fn run_out(&self, p: &Params) -> f64 {
        let lag = 0.5 * p.slides.time_constant / 1000.0 + 1.0 / p.slides.position_gain;
        (RUN_OUT * self.pitch).max(self.speed * self.pitch / 60.0 * lag)
    }

    /// Whether it has a thread.
    pub(super) fn threads(&self) -> bool {
        self.on && self.pitch > 0.0
    }

    /// Time at feed, s.
    pub(super) fn time(&self, p: &Params) -> f64 {
        let begin = (p.clear_diameter(), p.clearance);
        let of = |steps: Vec<PassStep>| time(begin, steps.into_iter(), self.speed, NO_RAPIDS);
        of(self.steps(p)) + of(self.thread(p))
    }
}

impl Params {
    /// Greatest cutting speed of the turned ends, m/min; 0 without one.
    pub(super) fn fastest_end_cut(&self) -> f64 {
        self.turned_ends.iter().filter(|end| end.on).map(|end| end.cutting_speed(self)).fold(0.0, f64::max)
    }
}

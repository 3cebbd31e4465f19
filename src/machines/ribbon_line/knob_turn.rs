//! One turn of the override knob: the unwinder follows it at once, and the queued blocks keep their feed. Ribbon laid and ribbon missing.

use super::derive::Derived;
use super::params::Params;

/// The range in which a knob is turned.
pub(super) struct KnobTurn<'a> {
    params: &'a Params,
    /// Whether the knob has a position 0, at which the unwinder stops.
    has_zero: bool,
    /// Results at the lowest and at the highest position.
    slow: &'a Derived,
    fast: &'a Derived,
}

impl<'a> KnobTurn<'a> {
    pub(super) fn new(params: &'a Params, has_zero: bool, slow: &'a Derived, fast: &'a Derived) -> KnobTurn<'a> {
        KnobTurn { params, has_zero, slow, fast }
    }

    /// Whether one turn of the knob lays ribbon.
    pub(super) fn acts(&self) -> bool {
        let p = self.params;
        !p.feeds_per_revolution() && !p.knob_is_locked() && !p.knob_turns_alone() && self.slow.unwinder.actual > 0.0
    }

    /// Ribbon (mm) of the running block and of those that the control has read ahead, at most a product: they keep the F of the old position of
    /// the knob. Source: ribbon line facts, 5.
    pub(super) fn queued(&self) -> f64 {
        (self.queued_per_pitch() * self.params.block_pitches()).min(self.slow.product.length)
    }

    /// Ribbon (mm) of the running block and of those read ahead, per pitch of a block.
    pub(super) fn queued_per_pitch(&self) -> f64 {
        (self.params.preread + 1.0) * self.params.pitch
    }

    /// Least ribbon (mm) that keeps the F of the old position: the running block is almost done.
    pub(super) fn least_queued(&self) -> f64 {
        self.params.preread * self.params.pitch * self.params.block_pitches()
    }

    /// Speed of the unwinder with the knob at its highest position over that at its lowest: `k_high / k_low`.
    fn ratio(&self) -> f64 {
        self.fast.unwinder.actual / self.slow.unwinder.actual
    }

    /// Ribbon (mm) that one turn of the knob from its lowest position to its highest lays more than X pulls: `q · (k_high / k_low - 1)`.
    /// Source: ribbon line facts, 5.
    pub(super) fn laid(&self) -> f64 {
        self.queued() * (self.ratio() - 1.0)
    }

    /// Ribbon (mm) that one turn of the knob from its highest position to its lowest pulls more than is laid: `q · (1 - k_low / k_high)`.
    /// Source: ribbon line facts, 5.
    pub(super) fn missing_at_lowest(&self) -> f64 {
        self.queued() * (1.0 - 1.0 / self.ratio())
    }

    /// Ribbon (mm) that a turn to 0, where the knob has it, pulls more than is laid: the unwinder stops over its ramp `t_r` while X carries out the queue at the speed `v`,
    /// `q - v · t_r / 2`, or `q² / (2 · v · t_r)` where the queue is shorter than the ramp, and makes up its lag, `v · (τ / 2 + 1 / K)`. Most from
    /// the lowest position. Source: ribbon line facts, 5.
    pub(super) fn missing_at_zero(&self) -> f64 {
        if !self.has_zero {
            return 0.0;
        }
        let (p, queued) = (self.params, self.queued());
        let ramp = p.ramp_to(self.slow.unwinder.actual);
        let speed = self.slow.feeds.mm_per_second();
        let (stop, lag) = (speed * ramp, speed * p.x_stop_time());
        lag + if queued < stop { queued * queued / (2.0 * stop) } else { queued - stop / 2.0 }
    }

    /// Positions (%) from which the knob is turned up: the lowest, and each of its steps below the highest.
    pub(super) fn positions_below_highest(&self) -> impl Iterator<Item = f64> + use<> {
        let [low, high] = [self.slow, self.fast].map(|d| d.unwinder.effective_override);
        let step = self.params.knob_step.percent();
        let first = (low / step).floor() + 1.0;
        let count = (high / step - first).ceil().max(0.0) as u32;
        [low].into_iter().chain((0..count).map(move |at| (first + f64::from(at)) * step))
    }

    /// Ribbon (mm) that one turn of the knob from a position (%) to its highest pulls more than is laid, where the queue ends before the
    /// unwinder is on speed: `(v2 - v1) · (t_r / 2 - q / v1 - τ / 2 - 1 / K)`, with the inverter's ramp `t_r` from v1 to v2 and the least queue q; 0
    /// where the product ends with the queue, and where feeds wait for the speed. Source: ribbon line facts, 5.
    pub(super) fn missing_at_highest(&self, from: f64) -> f64 {
        let p = self.params;
        if p.speed_tolerance.is_some() || self.queued() >= self.slow.product.length {
            return 0.0;
        }
        let v2 = self.fast.feeds.mm_per_second();
        let share = from / self.fast.unwinder.effective_override;
        let v1 = share * v2;
        let ramp = p.ramp_to((1.0 - share) * self.fast.unwinder.actual);
        ((v2 - v1) * (ramp / 2.0 - self.least_queued() / v1 - p.x_stop_time())).max(0.0)
    }

    /// Most ribbon (mm) that one turn pulls more than is laid.
    pub(super) fn missing(&self) -> f64 {
        let up = self.positions_below_highest().map(|from| self.missing_at_highest(from));
        up.fold(self.missing_at_lowest().max(self.missing_at_zero()), f64::max)
    }
}

//! The lathe on a control: what of the form it can do there, and what its words count.

use super::derive::Derived;
use super::params::{self, Gear, Output, Params, SpeedMode};
use crate::controls::syntax::long;
use crate::controls::{Control, Dialect, SpindleRules};
use crate::drives::Stage;
use crate::machines::ControlContext;
use crate::motion::Snapshot;

/// The axis that is square to the spindle, and the one along it.
pub(super) const CROSS: u8 = b'X';
pub(super) const ALONG: u8 = b'Z';

/// The form on a control.
pub(super) struct Resolved<'a> {
    /// The form as it was filled in.
    pub(super) form: &'a Params,
    /// The form, with what the control has in place of what it lacks.
    pub(super) p: Params,
    pub(super) control: &'a Control,
    pub(super) dialect: Dialect,
}

impl<'a> Resolved<'a> {
    pub(super) fn new(form: &'a Params, on: ControlContext<'a>) -> Resolved<'a> {
        let (control, dialect) = (on.control, on.dialect());
        let mut p = form.clone();
        if !form.holds_surface_speed(control) {
            (p.speed_mode, p.lower_limit) = (SpeedMode::Fixed, 0.0);
        }
        if !form.has_gears(control) {
            (p.stage_2, p.stage_3, p.stage_4) = (0.0, 0.0, 0.0);
            p.gear = Gear::First;
        }
        if !form.has_signed_output(control) {
            p.output = Output::Unipolar;
        }
        // As the knob can stand, and as S can be read.
        p.override_percent = dialect.spindle().knob.nearest(p.override_percent);
        if control.syntax.integer_addresses.contains(&b'S') {
            let truncates = !dialect.numbers.round_speed;
            p.cutting_speed = if truncates { p.cutting_speed.floor() } else { p.cutting_speed.round() };
        }
        Resolved { form, p, control, dialect }
    }

    /// Index of the axis that is square to the spindle.
    pub(super) fn cross(&self) -> usize {
        self.control.axis(CROSS).unwrap_or(0)
    }

    /// Index of the axis along the spindle.
    pub(super) fn along(&self) -> usize {
        self.control.axis(ALONG).unwrap_or(0)
    }

    /// Words of X count diameters; else radii.
    pub(super) fn diameters(&self) -> bool {
        self.dialect.counts_diameters(self.cross())
    }

    /// The spindle holds the surface speed.
    pub(super) fn surface(&self) -> bool {
        self.p.speed_mode == SpeedMode::Surface
    }

    /// The address of the limit under constant surface speed, where that has a word of its own.
    pub(super) fn limit_word(&self) -> Option<u8> {
        params::has_address(self.control, long::LIMS).then_some(long::LIMS)
    }

    /// The spindle is brought to an angle behind the cut.
    pub(super) fn positions(&self) -> bool {
        self.p.keyway && self.form.can_position(self.control)
    }

    /// What the control does with the spindle, as its open points are set.
    pub(super) fn rules(&self) -> SpindleRules {
        self.dialect.spindle()
    }

    /// What follows from the form.
    pub(super) fn derived(&self) -> Derived {
        let bench = &self.control.bench;
        Derived::new(&self.p, bench.volts_full, bench.output_bits, &self.rules())
    }

    /// Number of the gear stage that the program engages.
    pub(super) fn stage(&self) -> u8 {
        self.derived().stage
    }

    /// Distance of the tool from the turning centre in mm, and from the finished face.
    pub(super) fn tool(&self, now: &Snapshot) -> (f64, f64) {
        let at = |axis: usize| now.axes.get(axis).map_or(0.0, |axis| axis.actual);
        (at(self.cross()), at(self.along()))
    }

    /// The diameter at which the tool stands.
    pub(super) fn diameter(&self, now: &Snapshot) -> f64 {
        2.0 * self.tool(now).0
    }

    /// The gear stages that are fitted.
    pub(super) fn stages(&self) -> Vec<Stage> {
        let low = if self.rules().low_always { self.p.lower_limit } else { 0.0 };
        self.p.stages().map(|speed| Stage { range: (low, f64::INFINITY), ..Stage::new(speed) }).collect()
    }
}

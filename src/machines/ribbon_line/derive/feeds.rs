//! Speed of the ribbon, feeds of both axes and travels of their blocks, by equations (2) to (4) of the paper.

use super::unwinder::UnwinderSpeed;
use crate::machines::ribbon_line::axes::PerAxis;
use crate::machines::ribbon_line::params::{FeedForm, Params, PiForm, YUnit};
use crate::math::{self, PI};

/// π as the paper writes it: 3.14.
const PUBLISHED_PI: f64 = 314.0 / 100.0;

/// Speeds of the ribbon and of both axes. mm/min, or °/min for a print roller in degrees; motors and roller in r/min.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::ribbon_line) struct LineFeeds {
    /// Ribbon per revolution of the unwinder's motor, mm.
    pub k: f64,
    /// Programmed speed of the ribbon and of X.
    pub line_speed: f64,
    /// Travel of the print roller per pitch, mm or °.
    pub y_stroke: f64,
    /// F of a block that moves both axes.
    pub vector_feed: f64,
    /// The same per revolution of the unwinder's motor.
    pub per_revolution: f64,
    pub y_feed: f64,
    pub motor_speeds: PerAxis<f64>,
    pub print_roller_speed: f64,
    /// Speed of the ribbon in manual operation.
    pub manual_line_speed: f64,
    /// Change of the ribbon's speed by one step of the knob, mm/s.
    pub override_step: f64,
}

impl LineFeeds {
    /// Speed of the ribbon, mm/s.
    pub(in crate::machines::ribbon_line) fn mm_per_second(&self) -> f64 {
        self.line_speed / 60.0
    }

    /// Feed of each axis.
    pub(in crate::machines::ribbon_line) fn of_axes(&self) -> PerAxis<f64> {
        PerAxis { pull: self.line_speed, print: self.y_feed }
    }

    pub(super) fn new(p: &Params, unwinder: &UnwinderSpeed) -> LineFeeds {
        let k = ribbon_per_revolution(p);
        let line_speed = k * unwinder.actual;
        let y_stroke = p.y_stroke();
        let followed = p.followed(unwinder.error);
        let print_roller_speed = line_speed * p.printed_arc() / p.pitch / (PI * p.print_roller_diameter) * followed;
        LineFeeds {
            k,
            line_speed,
            y_stroke,
            vector_feed: vector_feed(line_speed, p.pitch, y_stroke),
            per_revolution: vector_feed(k, p.pitch, y_stroke),
            y_feed: line_speed * y_stroke / p.pitch,
            motor_speeds: PerAxis {
                pull: line_speed / (PI * p.x_roller_diameter) * p.axes.pull.gear * followed,
                print: print_roller_speed * p.axes.print.gear,
            },
            print_roller_speed,
            manual_line_speed: k * p.manual_speed.min(unwinder.greatest),
            override_step: line_speed / 60.0 * p.knob_step.percent() / 100.0,
        }
    }
}

impl Params {
    /// π of the program.
    pub(in crate::machines::ribbon_line) fn program_pi(&self) -> f64 {
        match self.pi {
            PiForm::Exact => PI,
            PiForm::Short => PUBLISHED_PI,
        }
    }

    /// Travel of the print roller per pitch, which is one head, in mm or °.
    pub(super) fn y_stroke(&self) -> f64 {
        match self.y_unit {
            YUnit::Millimetres => self.program_pi() * self.print_roller_diameter / self.heads,
            YUnit::Degrees => 360.0 / self.heads,
        }
    }

    /// F per revolution of the unwinder.
    pub(in crate::machines::ribbon_line) fn feeds_per_revolution(&self) -> bool {
        self.feed_form == FeedForm::PerRevolution
    }

    /// Travel of the print roller's surface per pitch, mm. An axis in degrees has the true circumference; one in mm has
    /// that of the program's π.
    pub(super) fn printed_arc(&self) -> f64 {
        match self.y_unit {
            YUnit::Millimetres => self.y_stroke(),
            YUnit::Degrees => self.head_spacing(),
        }
    }

    /// Ribbon unwound (mm) after turns n of the unwinder's motor, in the scale of the pull roller: `n · π · D / i · (1 + t / D - t / Dx)`, the
    /// thickness t counting where the diameters are entered without it.
    pub(in crate::machines::ribbon_line) fn laid_by_turns(&self, turns: f64) -> f64 {
        k(PI, self.press_roller_diameter, self.reduction_ratio) * turns * (1.0 + self.laid_by_thickness())
    }

    /// Driven speed of the axes over the programmed one. `error`: relative error of the unwinder's speed, which a feed
    /// per revolution follows.
    pub(in crate::machines::ribbon_line) fn followed(&self, error: f64) -> f64 {
        if self.feeds_per_revolution() && error > -1.0 { 1.0 + error } else { 1.0 }
    }
}

/// Ribbon (mm) per revolution of the unwinder's motor with the π of the program.
pub(super) fn ribbon_per_revolution(p: &Params) -> f64 {
    k(p.program_pi(), p.press_roller_diameter, p.reduction_ratio)
}

/// mm of ribbon per revolution of the unwinder motor: `K = π · D / i`, equation (2).
pub(super) fn k(pi: f64, diameter: f64, reduction: f64) -> f64 {
    pi * diameter / reduction
}

/// F of a block that moves X by `a` and Y by `b` so that X runs at `x_speed`: `F = Fx · √(a² + b²) / a`, equation (4). It holds for
/// millimetres and degrees mixed as well, because the control works with the numbers. Source: ribbon line facts, 1.
pub(super) fn vector_feed(x_speed: f64, a: f64, b: f64) -> f64 {
    x_speed * math::hypot(a, b) / a
}

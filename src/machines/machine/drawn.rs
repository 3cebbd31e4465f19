//! The drawing of a prepared machine: at rest, at a moment of a run, and its charts over a time.

use super::samples::Samples;
use crate::math;
use crate::motion::Snapshot;
use crate::text::Message;
use crate::view::{Chart, ChartAxis, DrawnPart, Pose, Scene};

/// The viewing conditions of a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Machine time (s) between two frames: parts that turn far in it blur.
    pub step: f64,
    /// Whether the drawing's own option is on; see [`Scene::drawing_option`].
    pub drawing_option: bool,
}

impl Frame {
    /// Visibility (0 to 1) of a part that turns `step` degrees per frame: 1 up to `limit` (degrees per frame), falling
    /// linearly to 0 at `1.5 · limit`.
    pub fn seen(step: f64, limit: f64) -> f64 {
        math::clamp((1.5 * limit - step) / (0.5 * limit), 0.0, 1.0)
    }
}

/// Drawing of a machine, with the charts and texts beside it. All functions are total.
pub trait DrawnMachine {
    /// The parts list, with the places of the parts in the drawing.
    fn parts(&self) -> Vec<DrawnPart>;
    /// The drawing at rest.
    fn scene(&self) -> Scene;
    /// The drawing at a moment.
    fn pose(&self, run: &dyn Samples, now: &Snapshot, frame: Frame) -> Pose;
    /// Speed (r/min) of the spindle on the position page of the control, signed.
    fn spindle_speed(&self, now: &Snapshot) -> f64 {
        now.spindle.actual
    }
    /// Catalog id of the name of the first contact with the work, `first dot`; none before that contact.
    fn contact(&self, _run: &dyn Samples, _now: &Snapshot) -> Option<&'static str> {
        None
    }
    /// Present operation on the work, for instance `Cutting, pass 2 / 4`; none between operations.
    fn activity(&self, _run: &dyn Samples, _now: &Snapshot) -> Option<Message> {
        None
    }
    /// Times (s) up to `until` at which the tool begins its passes over the work.
    fn pass_starts(&self, _run: &dyn Samples, _until: f64) -> Vec<f64> {
        Vec::new()
    }
    /// The place of a moment on the x axis of a chart that is not over time: the diameter at the tool, the speed of the spindle; none
    /// where the run has no such quantity.
    fn place_on(&self, _axis: ChartAxis, _now: &Snapshot) -> Option<f64> {
        None
    }
    /// Charts from `from` to `to` seconds with `points` points each.
    fn charts(&self, run: &dyn Samples, from: f64, to: f64, points: usize) -> Vec<Chart>;
}

//! The lathe on a control: what the form comes to, as geometry and as the words that start it.

use super::derive::Derived;
use super::params::{Params, Shape};
use crate::controls::{Control, Dialect};
use crate::drives::polygon::Ratio;
use crate::machines::ControlContext;
use crate::motion::Snapshot;

/// The slide across the work, and the one along it.
pub(super) const CROSS: u8 = b'X';
pub(super) const ALONG: u8 = b'Z';

/// Which axis of the PLC turns the work, and which the tool.
pub(super) const WORK: usize = 0;
pub(super) const TOOL: usize = 1;

/// The form on a control.
pub(super) struct Resolved<'a> {
    /// The form as it was filled in.
    pub(super) form: &'a Params,
    /// The form, with what the shape says of inserts and ratio.
    pub(super) p: Params,
    pub(super) control: &'a Control,
    pub(super) dialect: Dialect,
    /// Across flats of every pass.
    pub(super) sizes: Vec<f64>,
}

impl<'a> Resolved<'a> {
    pub(super) fn new(form: &'a Params, on: ControlContext<'a>) -> Resolved<'a> {
        let (control, dialect) = (on.control, on.dialect());
        let mut p = form.clone();
        let shape = match p.shape {
            Shape::Own => None,
            Shape::Knob => Some((2.0, 1.0, 1.0, 2.0)),
            Shape::Triangle => Some((3.0, 2.0, 2.0, 3.0)),
            Shape::Square => Some((4.0, 2.0, 1.0, 2.0)),
            Shape::Hexagon => Some((6.0, 3.0, 1.0, 2.0)),
        };
        if let Some(shape) = shape {
            (p.sides, p.inserts, p.work_ratio, p.tool_ratio) = shape;
        }
        let sizes = (1..=p.passes() as u32).map(|pass| p.size(f64::from(pass))).collect();
        Resolved { form, p, control, dialect, sizes }
    }

    /// What follows from the form.
    pub(super) fn derived(&self) -> Derived {
        Derived::new(&self.p, &self.sizes, self.words())
    }

    /// Index of the slide across the work.
    pub(super) fn cross(&self) -> usize {
        self.control.axis(CROSS).unwrap_or(0)
    }

    /// Index of the slide along the work.
    pub(super) fn along(&self) -> usize {
        self.control.axis(ALONG).unwrap_or(0)
    }

    /// What words of X count for each millimetre that the slide moves.
    pub(super) fn words(&self) -> f64 {
        if self.dialect.counts_diameters(self.cross()) { 2.0 } else { 1.0 }
    }

    /// Whether the feed override acts on the axes of the PMC.
    pub(super) fn overrides(&self) -> bool {
        self.dialect.pmc_override
    }

    /// Across flats that the slide is set to, and where it stands along the work, in mm.
    pub(super) fn slide(&self, now: &Snapshot) -> (f64, f64) {
        let at = |axis: usize| now.axes.get(axis).map_or(0.0, |axis| axis.actual);
        (2.0 * at(self.cross()), at(self.along()))
    }

    /// By how much the tool is ahead of where ratio and start angles want it beside the work, in degrees, half a turn at most.
    pub(super) fn phase(&self, now: &Snapshot) -> f64 {
        let k = self.p.ratio().map_or(0.0, Ratio::value);
        let (work, tool) = (now.pmc[WORK].actual - self.p.work_start, now.pmc[TOOL].actual - self.p.tool_start);
        let off = (tool - k * work) / 360.0;
        360.0 * (off - off.round())
    }
}
